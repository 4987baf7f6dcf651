"""Description of a quantity: its name, Python function, unit and options, from which commands and files follow."""

import inspect
import re
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, fields, replace
from typing import Any

import numpy as np

from warpsample.estimate.result import Estimate
from warpsample.mesh.surface import SurfacePoints

ARGUMENTS = {"samples": "count", "environment": "radiance"}
"""Argument names of command-line options, where the two names differ."""

OPTIONS = {argument: option for option, argument in ARGUMENTS.items()}
"""Command-line options of argument names, the inverse of `ARGUMENTS`."""

_LAST = ("rays", "status")  # last columns of a table
_OF_INTERVALS = ("spread", "degrees_of_freedom")  # fields for `interval`, without a column

OF_MEANS = ("reflected_runs", "unseen_error")
"""Fields of some results for the errors of means over points, which no file holds."""

_NO_UNITS = ("", "mesh units")
"""Units that column names leave out: no unit, and the unit of the mesh."""

_NOT_RECORDED = ("active", "first_point", "progress", "workers")
"""Arguments that files do not record, because they change no value or are not options of the command line."""

Numbers = Callable[[SurfacePoints, int], Any]
"""Function (points, global id of the first point) -> result of these points."""


@dataclass(frozen=True)
class Quantity:
    """Description of a quantity that commands compute at each point of a mesh, for example ambient occlusion.

    Attributes:
        name: Name on the command line.
        call: Function (mesh, points, ...) -> dataclass with arrays. The names of the further parameters are the options of
            the quantity on the command line, with the same defaults.
        title: Name in reports and progress bars.
        value: Description of a value in the tables of READMEs.
        result: Type that the call returns, a dataclass.
        shared: Names of the result's fields without a row for each point.
        unit: Unit of a value; empty for shares.
        files: Descriptions of the files that the command line requires, keyed by the name of the option.
        prepare: Function (mesh, number of all points, **arguments of the call except points and first_point) -> Numbers,
            which reads or computes data once for all parts of the points. Default: None, the call is used directly.
        in_stores: Whether Dask, Zarr stores and the accessor on meshes offer the quantity.
        on_rasters: Definitions of the value in the cells of a raster, keyed by receiver, the default receiver first. The
            text may contain {normal}. Empty: rasters do not offer the quantity.
        is_matrix: Whether a point has too many values for columns of a table.
        channels: One letter per component of a value with three components.
        black: Value shown as black in files with colours.
        white: Value shown as white in files with colours; the largest value of the result, if that is larger.
        example: Further arguments of an example call, as Python code.
    """

    name: str
    call: Callable[..., Any]
    title: str
    value: str
    result: type = Estimate
    shared: tuple[str, ...] = ("skipped",)
    unit: str = ""
    files: Mapping[str, str] = field(default_factory=dict)
    prepare: Callable[..., Numbers] | None = None
    in_stores: bool = True
    on_rasters: Mapping[str, str] = field(default_factory=dict)
    is_matrix: bool = False
    channels: str = "rgb"
    black: float = 0.0
    white: float = 1.0
    example: str = ""

    @property
    def is_vector(self) -> bool:
        """True if a value is a vector in space; other values with three components are colours."""
        return self.channels == "xyz"

    @property
    def parameters(self) -> dict[str, Any]:
        """Default values of the parameters of the quantity's Python function, without mesh and points, keyed by name."""
        _mesh, _points, *others = inspect.signature(self.call).parameters.values()
        return {parameter.name: parameter.default for parameter in others}

    @property
    def arrays(self) -> list[str]:
        """Names of the result arrays, with one row per point, that every result of the quantity has."""
        return [item.name for item in fields(self.result) if item.name not in self.shared and item.default is not None]

    @property
    def sometimes(self) -> list[str]:
        """Names of the result arrays with one row per point that are None in some results, for files."""
        left_out = (*self.shared, *OF_MEANS)
        return [item.name for item in fields(self.result) if item.name not in left_out and item.default is None]

    def arrays_of(self, found: Any) -> dict[str, np.ndarray]:
        """Return all arrays of a result with a row for each point, keyed by field name."""
        return {name: array for name in (*self.arrays, *self.sometimes) if (array := getattr(found, name)) is not None}

    def takes(self, option: str) -> bool:
        """Return whether the quantity accepts the named command-line option."""
        return ARGUMENTS.get(option, option) in self.parameters

    def default(self, option: str) -> Any:
        """Return the default of a command-line option; None if the option is required or unknown."""
        default = self.parameters.get(ARGUMENTS.get(option, option))
        return None if default is inspect.Parameter.empty else default

    def arguments(self, options: Mapping[str, Any]) -> dict[str, Any]:
        """Convert command-line options to arguments of the quantity's Python function, keyed by argument name."""
        return {ARGUMENTS.get(name, name): value for name, value in options.items()}

    def recorded_options(self, options: Mapping[str, Any]) -> dict[str, Any]:
        """Return the options to record in an output file: the given options, and defaults for the rest."""
        names = [OPTIONS.get(name, name) for name in self.parameters if name not in _NOT_RECORDED]
        return {name: options.get(name, self.default(name)) for name in names}

    def numbers(self, mesh: Any, total: int, options: Mapping[str, Any]) -> Numbers:
        """Build the Python function that computes the quantity for a part of a mesh's points.

        Args:
            mesh: Mesh of the points.
            total: Number of points of all parts.
            options: Options, keyed by command-line name.
        """
        given = self.arguments(options)
        if self.prepare is not None:
            defaults = {name: value for name, value in self.parameters.items() if name != "first_point"}
            return self.prepare(mesh, total, **(defaults | given))
        return lambda points, first: self.call(mesh, points, first_point=first, **given)

    def joined(self, parts: Sequence[Any]) -> Any:
        """Concatenate the results of parts of the points into one result.

        Statistics of skipped work are added. All further shared fields are those of the first part.
        """
        first = parts[0]
        names = [*self.arrays_of(first), *(name for name in OF_MEANS if getattr(first, name, None) is not None)]
        joined = {name: np.concatenate([getattr(part, name) for part in parts]) for name in names}
        if "skipped" in self.shared:
            names = [item.name for item in fields(first.skipped)]
            sums = {name: sum(getattr(part.skipped, name) for part in parts) for name in names}
            joined["skipped"] = replace(first.skipped, **sums)
        return replace(first, **joined)

    def columns(self, found: Any) -> dict[str, np.ndarray]:
        """Return the arrays of a result as (P,) columns, keyed by column name; an array (P, 3) becomes three columns."""
        columns, arrays = {}, self.arrays_of(found)
        for name in (*(name for name in arrays if name not in _OF_INTERVALS + _LAST), *_LAST):
            array = arrays[name]
            split = zip(self.channels, array.T, strict=True) if array.ndim == 2 else ()
            columns.update({f"{name}_{letter}": column for letter, column in split} or {name: array})
        return columns

    def header(self, column: str) -> str:
        """Return the header of a result column with the quantity's unit, for example "irradiation_kwh_m2_error"."""
        unit = "" if self.unit in _NO_UNITS else f"_{self.unit.lower().replace('/', '_')}"
        known = re.fullmatch("(value|standard_error)(_[a-z])?", column)
        if known:
            return f"{self.call.__name__}{known[2] or ''}{unit}{'_error' if known[1] == 'standard_error' else ''}"
        return column if column in _LAST else f"{column}{unit}"

    def colours(self, found: Any) -> np.ndarray:
        """Return opaque RGBA colours (P, 4) uint8 of a result: grey levels, or red, green and blue for three components."""
        value = found.value if found.value.ndim == 2 else np.repeat(found.value[:, None], 3, axis=1)
        white = max(self.white, float(value.max(initial=self.black)))
        grey = np.clip((value - self.black) / ((white - self.black) or 1.0), 0.0, 1.0)
        return np.column_stack([np.round(255.0 * grey), np.full(len(grey), 255.0)]).astype(np.uint8)
