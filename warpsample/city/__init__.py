"""Cities and terrain as people have them: rasters of heights and CityJSON."""

from warpsample.city import rasters

__all__ = ["rasters"]
