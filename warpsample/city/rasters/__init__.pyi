"""Types of the calls, which `__init__.py` imports at their first use."""

from warpsample.city.rasters.calls import (
    irradiation as irradiation,
    sky_view_factor as sky_view_factor,
    sun_hours as sun_hours,
    visible_sky as visible_sky,
)
from warpsample.city.rasters.raster_surface import RasterSurface as RasterSurface, surface as surface
