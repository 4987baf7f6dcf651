"""Datasets of rasters: a quantity is computed in all cells, tile by tile, and described by attributes."""

from collections.abc import Mapping
from importlib.metadata import version
from numbers import Real
from os import PathLike, fspath
from typing import Any

import numpy as np
import xarray as xr

from warpsample.city.rasters.canopy import TRUNK, Canopy, as_on_map, check_for_crowns, rename_argument
from warpsample.city.rasters.leaves import TRANSMITTANCE, check_dates, check_transmittance
from warpsample.city.rasters.raster_surface import MODELS, RECEIVERS, on_map
from warpsample.city.rasters.sources.reading import ground_of, reader_of
from warpsample.city.rasters.tiles import RasterRun
from warpsample.estimate.quantities.record import Quantity
from warpsample.host.arguments import check_choice, check_integer, quote

_SET_HERE = ("up", "north", "first_point", "active", "series", "refine")
"""Options of the underlying calls that the raster determines, whose results are not rasters, or for reflected light."""

_NOT_STORED = ("first_point", "active", "series", "refine", "workers", "progress")
"""Options that are not stored as attributes, because they change no number or do not apply to rasters."""

TREES_AND_TILES: dict[str, Any] = {
    "canopy": None,
    "trunk": TRUNK,
    "relative": True,
    "transmittance": TRANSMITTANCE,
    "tile": None,
    "margin": None,
    "far": None,
}
"""Options common to all calls, with defaults; each call also has the options of its quantity."""

MARGIN = 256
"""Default number of full-resolution cells around a tile."""

_WIDEST_MARGIN = 1 << 16  # cells; memory grows with the square of the margin

_NORMAL = {"horizontal": "up", "surface": "the normal of the cell's surface"}


def compute_dataset(quantity: Quantity, source: Any, options: dict[str, Any], *, model: str, receiver: str) -> xr.Dataset:
    """Compute a quantity in all cells of a raster, tile by tile, and return the Dataset."""
    run, about = run_of(quantity, source, options, model=model, receiver=receiver)
    run.reader.check_heights(run.model)
    cells = {name: np.full(run.reader.shape, np.nan, np.float32) for name in run.names}
    for span in run.spans():
        for name, values in run.numbers(span).items():
            cells[name][span] = values
    outline = run.reader.outline
    arrays = {name: on_map(outline, values).assign_attrs(attributes_of(name, quantity)) for name, values in cells.items()}
    return xr.Dataset(arrays, attrs=about | {"cells_without_height": int(np.isnan(cells["value"]).sum())})


def run_of(
    quantity: Quantity, source: Any, options: dict[str, Any], *, model: str, receiver: str
) -> tuple[RasterRun, dict[str, Any]]:
    """Check the arguments of a call of `warpsample.rasters`; return (computation to run, attributes of the Dataset).

    Raises:
        TypeError, ValueError, FileNotFoundError: An argument that cannot be used; the message names the argument.
    """
    how = {name: options.get(name, default) for name, default in TREES_AND_TILES.items()}
    own = {name: value for name, value in options.items() if name not in how}
    _check_options(quantity, own)
    run = build_run(source, quantity, own, model=model, receiver=receiver, **how)
    own = {name: run.options.get(name, default) for name, default in quantity.parameters.items() if name not in _NOT_STORED}
    rasters = {name: _describe_source(how[name]) for name in ("canopy", "trunk", "far")}
    attributes = {"model": model, "receiver": receiver, **how, **rasters, "margin": run.margin if run.tile else None}
    attributes["method"] = "horizons" if run.by_horizons else "rays"
    attributes = {name: value for name, value in attributes.items() if value is not None}
    return run, _attributes(quantity, source, attributes | own)


def build_run(
    source: Any,
    quantity: Quantity,
    options: dict[str, Any],
    *,
    model: Any,
    receiver: Any,
    canopy: Any,
    trunk: Any,
    relative: Any,
    transmittance: Any,
    tile: Any,
    margin: Any,
    far: Any,
) -> RasterRun:
    """Check the arguments of a call on raster, surface, trees and tiles, and build the computation.

    Raises:
        TypeError, ValueError, FileNotFoundError: An argument that cannot be used; the message names the argument.
    """
    check_choice(model, "model", MODELS)
    check_choice(receiver, "receiver", RECEIVERS)
    if receiver not in quantity.on_rasters:
        wanted = " or ".join(map(repr, quantity.on_rasters))
        raise ValueError(f"receiver: got {receiver!r} for the {quantity.title}, want {wanted}")
    shares = check_transmittance(transmittance)
    check_dates(quantity, shares)
    if margin is not None and tile is None:
        raise ValueError(
            f"margin: got {quote(margin)} without tile, want tile, the number of cells along each side of a tile, too"
        )
    tile = None if tile is None else check_integer(tile, "tile", 1, 2**31 - 1)
    margin = MARGIN if margin is None else check_integer(margin, "margin", 1, _WIDEST_MARGIN)
    reader, other = ground_of(source), None
    if far is not None:
        with rename_argument("far"):
            other = reader_of(far)
        other = as_on_map(reader, other, "far")
    trees = Canopy.of(reader, canopy, trunk, relative)
    if trees is None:
        check_for_crowns("transmittance", transmittance, TRANSMITTANCE)
    if "north" in quantity.parameters:
        options = {**options, "north": reader.outline.north}
    return RasterRun(reader, quantity, options, model, receiver, trees, shares, tile, margin, other)


def attributes_of(name: str, quantity: Quantity) -> dict[str, str]:
    """Return the attributes `units` and `long_name` of one array of a result, for example "standard_error"."""
    said = {
        "standard_error": "standard error of the ",
        "half_width": "half width of the 95 % confidence interval of the ",
        "far_error": "error due to pooled distant terrain of the ",
    }
    return {"units": quantity.unit.replace("/m2", " m-2") or "1", "long_name": said.get(name, "") + quantity.title}


def _check_options(quantity: Quantity, options: Mapping[str, Any]) -> None:
    """Raise a TypeError for an option that a call of `warpsample.rasters` does not accept.

    Options that the raster determines, such as points, are not accepted either.
    """
    known = [name for name in (*quantity.parameters, *TREES_AND_TILES) if name not in _SET_HERE]
    for name in options:
        if name not in known:
            raise TypeError(
                f"{name}: got an argument that {quantity.title} of a raster does not take, want one of {', '.join(known)}"
            )


def _attributes(quantity: Quantity, source: Any, attributes: Mapping[str, Any]) -> dict[str, Any]:
    """Return the attributes of a result's Dataset: definition, unit, source, version and options.

    All values are numbers or strings.
    """
    return {
        "quantity": quantity.name,
        "definition": quantity.on_rasters[attributes["receiver"]].format(normal=_NORMAL[attributes["receiver"]]),
        "unit": quantity.unit or "1",
        "source": _describe_source(source),
        "warpsample": version("warpsample"),
        **{name: _convert_attribute(value) for name, value in attributes.items()},
    }


def _describe_source(source: Any) -> Any:
    """Describe an input raster by its path or, for an array, by its type; return numbers and None unchanged."""
    if source is None or isinstance(source, Real):
        return source
    return fspath(source) if isinstance(source, str | PathLike) else f"an array, {type(source).__name__}"


def _convert_attribute(value: Any) -> int | float | str:
    """Convert a value to a type that NetCDF, Zarr and GeoTIFF can store; sequences become a string with spaces."""
    if isinstance(value, tuple | list | np.ndarray):
        return " ".join(str(item) for item in value)
    return value if isinstance(value, int | float) and not isinstance(value, bool) else str(value)
