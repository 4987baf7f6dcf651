"""Sky view, sunlight and irradiation of cities and terrain, from rasters of heights and CityJSON files."""

from warpsample.city import rasters

__all__ = ["rasters"]
