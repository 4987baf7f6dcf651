"""Cities and terrain as people have them: rasters of heights."""

from warpsample.city import rasters

__all__ = ["rasters"]
