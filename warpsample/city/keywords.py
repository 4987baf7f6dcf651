"""Types and descriptions of the options that the functions of `warpsample.rasters` share."""

from collections.abc import Sequence
from typing import Any, TypedDict

from warpsample.host.options import CastKeywords, EstimateKeywords, SeedKeywords


class TerrainKeywords(TypedDict, total=False):
    """Options of trees, tiles and distant terrain."""

    canopy: Any
    """Raster of the heights of tree crowns, as `source`, on the same cells; 0 is no tree. Default: None, no trees."""
    trunk: Any
    """Underside of the crowns, a share of their height from 0 to 1, or another raster. Default: 0.25."""
    relative: bool
    """Whether `canopy` and `trunk` are heights above the ground; False for elevations. Default: True."""
    transmittance: Any
    """Share of light that crowns transmit; with dates 12 shares for months or 365 for days. Default: 0.03."""
    tile: int | None
    """Number of cells along each side of a tile, for rasters that exceed memory. Default: None, a single tile."""
    margin: int | None
    """Number of full-resolution cells around a tile; cells outside are pooled, see `far_error`. Default: None, 256."""
    far: Any
    """Raster of the terrain around `source`, as `source`. Default: None, no terrain around it."""


class SunHoursKeywords(TerrainKeywords, SeedKeywords, total=False):
    """Options of `rasters.sun_hours`."""

    period: Sequence[str] | None
    """First and last day, both included, as ("06-01", "08-31"), as for `warpsample.irradiation`. Default: None, the year."""


class IrradiationKeywords(SunHoursKeywords, CastKeywords, total=False):
    """Options of `rasters.irradiation`."""

    ground_albedo: float
    """Albedo of the ground around the raster, a float from 0 to 1. Default: 0.2."""
    patches: str
    """Patches of the sky, "tregenza" (145), "reinhart2" (577) or "reinhart4" (2,305). Default: "reinhart2"."""
    count: int
    """Number of rays per cell to the sky, and the same number to the ground, 2 to 2^24. Default: 1024."""


class SkyKeywords(TerrainKeywords, EstimateKeywords, total=False):
    """Options of `rasters.sky_view_factor` and `rasters.visible_sky`."""

    max_distance: float | None
    """Distance from which on hits are ignored, a float in map units. Default: None, no limit."""
