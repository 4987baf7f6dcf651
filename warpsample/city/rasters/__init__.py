"""Sky view, irradiation and sun hours for rasters of heights, such as surface models of cities and terrain.

`from warpsample import rasters`, then `rasters.sky_view_factor("dsm.tif", 256)` returns an xarray.Dataset with error bars.
"""

from importlib import import_module
from typing import Any

from warpsample.host.extras import missing

TYPE_CHECKING = False
if TYPE_CHECKING:
    from warpsample.city.rasters.calls import irradiation, sky_view_factor, sun_hours, visible_sky
    from warpsample.city.rasters.intervals import interval
    from warpsample.city.rasters.raster_surface import RasterSurface, surface

__all__ = ["RasterSurface", "interval", "irradiation", "sky_view_factor", "sun_hours", "surface", "visible_sky"]

_HOMES = dict.fromkeys(("RasterSurface", "surface"), "raster_surface")
_HOMES |= dict.fromkeys(("irradiation", "sky_view_factor", "sun_hours", "visible_sky"), "calls")
_HOMES["interval"] = "intervals"


def __getattr__(name: str) -> Any:
    """Import a call on first use, together with xarray and rasterio.

    Raises:
        AttributeError: The module has no such call.
        ModuleNotFoundError: A library is not installed; the message names the extra to install.
    """
    if name not in _HOMES:
        raise AttributeError(f"module 'warpsample.city.rasters' has no attribute {name!r}")
    try:
        home = import_module(f"warpsample.city.rasters.{_HOMES[name]}")
    except ModuleNotFoundError as error:
        library = str(error.name).partition(".")[0]
        raise missing(f"warpsample.rasters needs {library}", library, "city") from error
    globals()[name] = value = getattr(home, name)
    return value


def __dir__() -> list[str]:
    """Return the names of the calls, imported or not."""
    return sorted({*globals(), *__all__})
