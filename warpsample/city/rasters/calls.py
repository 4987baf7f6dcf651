"""Sky and sun in the cells of a raster: what the calls of `warpsample` say at their middles, laid out as the raster is."""

from collections.abc import Mapping
from importlib.metadata import version
from numbers import Real
from os import PathLike, fspath
from typing import Any

import numpy as np
import xarray as xr

from warpsample.city.rasters.canopy import TRUNK
from warpsample.city.rasters.leaves import TRANSMITTANCE
from warpsample.city.rasters.raster_surface import on_map, surface
from warpsample.city.rasters.tiles import RasterRun
from warpsample.estimate.quantities.record import Quantity
from warpsample.estimate.quantities.sky_view_factor import RECORD as SKY
from warpsample.estimate.quantities.visible_sky import RECORD as VISIBLE_SKY
from warpsample.host.options import explained_by
from warpsample.radiation.quantities.irradiation import RECORD as IRRADIATION
from warpsample.radiation.quantities.sun_hours import RECORD as SUN_HOURS

_SET_HERE = ("up", "north", "first_point", "active", "series")
"""Options of the calls that the raster decides, or whose results are no raster."""

_UNTOLD = ("first_point", "active", "series", "workers", "progress")
"""Options by which no number changes, or that a raster has not."""

TREES_AND_TILES: dict[str, Any] = {
    "canopy": None,
    "trunk": TRUNK,
    "relative": True,
    "transmittance": TRANSMITTANCE,
    "tile": None,
    "margin": None,
    "far": None,
}
"""Options that all calls have besides those of the quantity, and their defaults."""

QUANTITIES = ("ao", "sky", "visible-sky", "irradiation", "sun-hours")
"""By the names of their records."""

_NORMAL = {"horizontal": "upwards", "surface": "the normal of the cell's surface"}
_COSINE = (
    "cosine-weighted share of the sky that is seen from the middle of each cell: 1/pi times the integral of max(n.w, 0) "
    "over the directions w above the horizon along which nothing is met, n {normal}"
)
_DEFINITIONS = {
    ("sky", "horizontal"): _COSINE + "; with a horizon h to each azimuth the mean of cos(h)^2",
    ("sky", "surface"): _COSINE,
    ("visible-sky", "horizontal"): (
        "share of the sky's solid angle that is seen from the middle of each cell: 1/(2 pi) times the integral of 1 over "
        "the directions above the horizon along which nothing is met; with a horizon h to each azimuth 1 - mean of sin(h)"
    ),
}
_OF_THE_REST = {
    "ao": (
        "cosine-weighted share of the directions about the middle of each cell along which nothing is met: 1/pi times the "
        "integral of max(n.w, 0) over them, n {normal}"
    ),
    "irradiation": (
        "sum over the hours of the period of what sun, sky and the ground beyond the raster bring to the middle of each "
        "cell, for each m2 of a receiver whose normal is {normal}; neighbours reflect nothing"
    ),
    "sun-hours": (
        "hours of the period in whose middle the sun's centre is above the horizon, in front of a receiver whose normal is "
        "{normal}, and not hidden from the middle of the cell"
    ),
}


@explained_by(surface)
def sky_view_factor(
    source: Any, count: int = 256, *, model: str = "joined", receiver: str = "horizontal", **options: Any
) -> xr.Dataset:
    """The cosine-weighted share of the sky that each cell sees, as `warpsample.sky_view_factor` has it.

    Times the diffuse irradiance of open ground it is that of the cell, under an even sky. It is the SVF of SOLWEIG and UMEP.
    Rays look for the horizon to each azimuth, unless there are crowns, or an option that is about rays all over the sky.

    Args:
        source, model: see `surface`.
        count: rays of each cell.
        receiver: "horizontal", or "surface": tilted as the cell is.
        **options: by name, `canopy`, `trunk` and `relative` as `surface` takes them; `transmittance`, the share of light
            that passes crowns, 0.03, however many; or where there is a date 12 shares, for each month, or 365, for days.
            `tile`: cells along the sides of tiles that are computed one by one, for rasters past memory, each with a
            `margin` of 256 cells around it as they are. What is beyond that is pooled, and `far_error` is how much farther
            off than by the standard error a value may be for it; but for rays that get below the surface through a hole.
            `far`: another raster of the same map, as `source`, of the terrain beyond the edges; with it or with tiles the
            Earth is round beyond the margin.
            And those of `warpsample.sky_view_factor`, as max_distance, seed, workers, progress; of rays all over the sky
            tolerance, sequence, tracer, device.

    Returns:
        `value`, `standard_error` and `half_width` (y, x), NaN where there is no height; with tiles `far_error`; and what
        makes them again as attributes. value -+ half_width is a 95 % confidence interval; `interval` gives those of other
        levels. By horizons the standard error is that of the value, and the interval 2.26 of them.

    Raises:
        TypeError, ValueError, FileNotFoundError: an argument that cannot be used; names it, what it got and what it wants.
        MemoryError: more than is free.

    Example:
        >>> from affine import Affine
        >>> street = np.zeros((60, 60)); street[:, :20] = street[:, 40:] = 20.0
        >>> found = ws.rasters.sky_view_factor((street, Affine(1, 0, 0, 0, -1, 0), None), 1024)
        >>> print(found.value.shape, f"{found.value[30, 30]:.1f}")
        (60, 60) 0.5
    """
    return _laid(SKY, source, {"count": count, **options}, model=model, receiver=receiver)


@explained_by(surface, sky_view_factor)
def visible_sky(source: Any, count: int = 256, *, model: str = "joined", **options: Any) -> xr.Dataset:
    """The share of the sky's solid angle that each cell sees, as `warpsample.visible_sky` has it.

    It is the sky view factor of RVT, xarray-spatial, GRASS r.skyview and WhiteboxTools, whichever way a receiver is tilted.

    Args:
        source, model: see `surface`.
        count: rays of each cell.
        **options: as of `sky_view_factor`.

    Returns:
        as `sky_view_factor`.

    Raises:
        TypeError, ValueError, FileNotFoundError: an argument that cannot be used; names it, what it got and what it wants.
        MemoryError: more than is free.

    Example:
        >>> from affine import Affine
        >>> step = np.zeros((40, 40)); step[:, 20:] = 20.0
        >>> found = ws.rasters.visible_sky((step, Affine(1, 0, 0, 0, -1, 0), None))
        >>> print(f"{found.value[20, 19]:.1f}, {found.value[20, 30]:.1f}")
        0.5, 1.0
    """
    return _laid(VISIBLE_SKY, source, {"count": count, **options}, model=model, receiver="horizontal")


@explained_by(surface, sky_view_factor)
def irradiation(
    source: Any, weather: Any, *, model: str = "joined", receiver: str = "surface", **options: Any
) -> xr.Dataset:
    """What a year's sun and sky bring to each cell in kWh/m², as `warpsample.irradiation` has it.

    The sun stands by true north, which is not the raster's: the meridian at its middle tells.

    Args:
        source, model: see `surface`.
        weather: an EPW file of 8,760 hours; "athens", where no file is called that, is an example.
        receiver: "surface": for each m² of the cell as it is tilted, of which it has its plan area over the cosine of its
            slope; or "horizontal".
        **options: of trees and tiles, as of `sky_view_factor`; and those of `warpsample.irradiation`, as period,
            ground_albedo, patches, count, seed, workers, progress.

    Returns:
        as `sky_view_factor`, in kWh/m².

    Raises:
        TypeError, ValueError, FileNotFoundError: an argument that cannot be used; names it, what it got and what it wants.
        ModuleNotFoundError: pvlib or pyradiance is missing; says how to install them.
        MemoryError: more than is free.

    Example:
        >>> from affine import Affine
        >>> flat = (np.zeros((4, 4)), Affine(10, 0, 0, 0, -10, 0), None)
        >>> june = ws.rasters.irradiation(flat, "athens", period=("06-01", "06-30"), patches="tregenza")
        >>> print(f"{june.value.mean():.0f} {june.value.units}")
        270 kWh m-2
    """
    return _laid(IRRADIATION, source, {"weather": weather, **options}, model=model, receiver=receiver)


@explained_by(surface, sky_view_factor, irradiation)
def sun_hours(source: Any, weather: Any, *, model: str = "joined", receiver: str = "surface", **options: Any) -> xr.Dataset:
    """In how many hours of a year or a period each cell sees the sun.

    Args:
        source, model: see `surface`.
        weather: see `irradiation`.
        receiver: "surface": a cell does not see the sun behind its own plane; or "horizontal".
        **options: of trees and tiles, as of `sky_view_factor`; and period, seed and workers, as of `warpsample.irradiation`.

    Returns:
        as `sky_view_factor`, in hours; the standard error and the half width are 0: nothing is drawn at random.

    Raises:
        TypeError, ValueError, FileNotFoundError: an argument that cannot be used; names it, what it got and what it wants.
        ModuleNotFoundError: pvlib is missing; says how to install it.
        MemoryError: more than is free.

    Example:
        >>> from affine import Affine
        >>> flat = (np.zeros((4, 4)), Affine(10, 0, 0, 0, -10, 0), None)
        >>> print(float(ws.rasters.sun_hours(flat, "athens", period=("06-21", "06-21")).value.mean()))
        15.0
    """
    return _laid(SUN_HOURS, source, {"weather": weather, **options}, model=model, receiver=receiver)


def _laid(quantity: Quantity, source: Any, options: dict[str, Any], *, model: str, receiver: str) -> xr.Dataset:
    """A quantity in the cells of a raster."""
    run, about = run_of(quantity, source, options, model=model, receiver=receiver)
    laid = {name: np.full(run.reader.shape, np.nan, np.float32) for name in run.names}
    for span in run.spans():
        for name, values in run.numbers(span).items():
            laid[name][span] = values
    outline = run.reader.outline
    arrays = {name: on_map(outline, values).assign_attrs(attributes_of(name, quantity)) for name, values in laid.items()}
    return xr.Dataset(arrays, attrs=about | {"cells_without_height": int(np.isnan(laid["value"]).sum())})


def run_of(
    quantity: Quantity, source: Any, options: dict[str, Any], *, model: str, receiver: str
) -> tuple[RasterRun, dict[str, Any]]:
    """The checked run of a call, and all that it is told, as numbers and texts.

    Raises:
        TypeError, ValueError, FileNotFoundError: an argument that cannot be used; names it, what it got and what it wants.
    """
    how = {name: options.get(name, default) for name, default in TREES_AND_TILES.items()}
    own = {name: value for name, value in options.items() if name not in how}
    _check(quantity, own)
    run = RasterRun.of(source, quantity, own, model=model, receiver=receiver, **how)
    own = {name: run.options.get(name, default) for name, default in quantity.parameters.items() if name not in _UNTOLD}
    rasters = {name: _name_of(how[name]) for name in ("canopy", "trunk", "far")}
    told = {"model": model, "receiver": receiver, **how, **rasters, "margin": run.margin if run.tile else None}
    told["method"] = "horizons" if run.by_horizons else "rays"
    told = {name: value for name, value in told.items() if value is not None}
    return run, _attributes(quantity, source, told | own)


def attributes_of(name: str, quantity: Quantity) -> dict[str, str]:
    """The unit and the title of one of the arrays of a run."""
    said = {
        "standard_error": "standard error of the ",
        "half_width": "half width of the 95 % confidence interval of the ",
        "far_error": "error by pooled terrain far off of the ",
    }
    return {"units": quantity.unit.replace("/m2", " m-2") or "1", "long_name": said.get(name, "") + quantity.title}


def _check(quantity: Quantity, options: Mapping[str, Any]) -> None:
    """Refuses options that the call has not, or that the raster decides."""
    known = [name for name in (*quantity.parameters, *TREES_AND_TILES) if name not in _SET_HERE]
    for name in options:
        if name not in known:
            raise TypeError(f"{name}: got it for {quantity.title} of a raster, want one of {', '.join(known)}")


def _attributes(quantity: Quantity, source: Any, told: Mapping[str, Any]) -> dict[str, Any]:
    """What a file says of its numbers: numbers and texts, as all formats hold them."""
    definition = _DEFINITIONS.get((quantity.name, told["receiver"])) or _OF_THE_REST[quantity.name]
    return {
        "quantity": quantity.name,
        "definition": definition.format(normal=_NORMAL[told["receiver"]]),
        "unit": quantity.unit or "1",
        "source": _name_of(source),
        "warpsample": version("warpsample"),
        **{name: _plain(value) for name, value in told.items()},
    }


def _name_of(source: Any) -> Any:
    """A raster by its path, or by what it is; what is no raster as it is."""
    if source is None or isinstance(source, Real):
        return source
    return fspath(source) if isinstance(source, str | PathLike) else f"an array, {type(source).__name__}"


def _plain(value: Any) -> int | float | str:
    """A value as NetCDF, Zarr and GeoTIFF keep it: several in a text, with spaces between."""
    if isinstance(value, tuple | list | np.ndarray):
        return " ".join(str(item) for item in value)
    return value if isinstance(value, int | float) and not isinstance(value, bool) else str(value)
