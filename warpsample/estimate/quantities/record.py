"""The record of a quantity: all that commands, files, stores, the accessor and the tables of READMEs know of it."""

import inspect
import re
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, fields, replace
from typing import Any

import numpy as np

from warpsample.estimate.result import Estimate
from warpsample.mesh.surface import SurfacePoints

ARGUMENTS = {"samples": "count", "environment": "radiance"}
"""What options of the command line are called in calls, where the names differ."""

OPTIONS = {argument: option for option, argument in ARGUMENTS.items()}
"""The other way round."""

_LAST = ("rays", "status")  # of the columns
_OF_INTERVALS = ("spread", "degrees_of_freedom")  # in no column: what `interval` is made of

_NO_UNITS = ("", "mesh units")
"""Of shares, and of what the mesh knows."""

_UNTOLD = ("active", "first_point", "progress", "workers")
"""Arguments by which no bit changes, or that the command line has not."""

Numbers = Callable[[SurfacePoints, int], Any]
"""(points, global id of the first of them) -> their numbers."""


@dataclass(frozen=True)
class Quantity:
    """A number, or several, at each point of a mesh.

    Attributes:
        name: what the command line calls it.
        call: (mesh, points, ...) -> a dataclass with arrays. The names of its other parameters are the options that apply,
            and their defaults are those of the command line.
        title: in words, as reports and progress bars name it.
        value: what a value says, as the tables of READMEs have it.
        result: the dataclass that the call returns.
        shared: its fields that have no row for each point.
        unit: of a value, if it is no share.
        files: what the command line must be told by an option that names a file, by the name of the option.
        prepare: (mesh, number of all points, **arguments of the call but points and first_point) -> Numbers, for what is
            read or computed once for all parts of the points; by default nothing is.
        in_stores: whether Dask and Zarr stores compute it in chunks, and the accessor on meshes.
        is_matrix: whether the values of a point are too many for columns.
        channels: a letter for each component of a value that has three.
        black: the value that is black where a file has colours.
        white: the value that is white there; the largest value, if that is larger.
        example: further arguments that an example of the call takes, as Python writes them.
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
    is_matrix: bool = False
    channels: str = "rgb"
    black: float = 0.0
    white: float = 1.0
    example: str = ""

    @property
    def parameters(self) -> dict[str, Any]:
        """The parameters of the call after the mesh and the points, and their defaults."""
        _mesh, _points, *others = inspect.signature(self.call).parameters.values()
        return {parameter.name: parameter.default for parameter in others}

    @property
    def arrays(self) -> list[str]:
        """The fields of each result that have a row for each point."""
        return [item.name for item in fields(self.result) if item.name not in self.shared and item.default is not None]

    @property
    def sometimes(self) -> list[str]:
        """The other fields with a row for each point, which not each result has."""
        return [item.name for item in fields(self.result) if item.name not in self.shared and item.default is None]

    def arrays_of(self, found: Any) -> dict[str, np.ndarray]:
        """The arrays of a result that have a row for each point, also those that not every one has, by name."""
        return {name: array for name in (*self.arrays, *self.sometimes) if (array := getattr(found, name)) is not None}

    def takes(self, option: str) -> bool:
        """Whether an option of the command line applies."""
        return ARGUMENTS.get(option, option) in self.parameters

    def default(self, option: str) -> Any:
        """What an option of the command line is if it is not given; None if it must be, or if there is no such thing."""
        default = self.parameters.get(ARGUMENTS.get(option, option))
        return None if default is inspect.Parameter.empty else default

    def arguments(self, options: Mapping[str, Any]) -> dict[str, Any]:
        """The arguments of the call that options of the command line stand for."""
        return {ARGUMENTS.get(name, name): value for name, value in options.items()}

    def told(self, options: Mapping[str, Any]) -> dict[str, Any]:
        """All options that a file tells of its run, by their names on the command line: those given, and the defaults."""
        names = [OPTIONS.get(name, name) for name in self.parameters if name not in _UNTOLD]
        return {name: options.get(name, self.default(name)) for name in names}

    def numbers(self, mesh: Any, total: int, options: Mapping[str, Any]) -> Numbers:
        """How parts of the points get their numbers.

        Args:
            mesh: what the points are on.
            total: how many points all parts have.
            options: of the command line, by their names.
        """
        given = self.arguments(options)
        if self.prepare is not None:
            defaults = {name: value for name, value in self.parameters.items() if name != "first_point"}
            return self.prepare(mesh, total, **(defaults | given))
        return lambda points, first: self.call(mesh, points, first_point=first, **given)

    def joined(self, parts: Sequence[Any]) -> Any:
        """One result of several: the rows of the arrays, the sums of what was skipped; what is shared is the first's."""
        first = parts[0]
        names = self.arrays_of(first)
        joined = {name: np.concatenate([getattr(part, name) for part in parts]) for name in names}
        if "skipped" in self.shared:
            names = [item.name for item in fields(first.skipped)]
            sums = {name: sum(getattr(part.skipped, name) for part in parts) for name in names}
            joined["skipped"] = replace(first.skipped, **sums)
        return replace(first, **joined)

    def columns(self, found: Any) -> dict[str, np.ndarray]:
        """The numbers of each point in columns, by name; those of three components in three."""
        columns, arrays = {}, self.arrays_of(found)
        for name in (*(name for name in arrays if name not in _OF_INTERVALS + _LAST), *_LAST):
            array = arrays[name]
            split = zip(self.channels, array.T, strict=True) if array.ndim == 2 else ()
            columns.update({f"{name}_{letter}": column for letter, column in split} or {name: array})
        return columns

    def header(self, column: str) -> str:
        """What a column is called in a table: by the quantity and its unit, as "irradiation_kwh_m2" and its "_error"."""
        unit = "" if self.unit in _NO_UNITS else f"_{self.unit.lower().replace('/', '_')}"
        known = re.fullmatch("(value|standard_error)(_[a-z])?", column)
        if known:
            return f"{self.call.__name__}{known[2] or ''}{unit}{'_error' if known[1] == 'standard_error' else ''}"
        return column if column in _LAST else f"{column}{unit}"

    def colours(self, found: Any) -> np.ndarray:
        """(P, 4) uint8, from black to white; three components are red, green and blue."""
        value = found.value if found.value.ndim == 2 else np.repeat(found.value[:, None], 3, axis=1)
        white = max(self.white, float(value.max(initial=self.black)))
        grey = np.clip((value - self.black) / ((white - self.black) or 1.0), 0.0, 1.0)
        return np.column_stack([np.round(255.0 * grey), np.full(len(grey), 255.0)]).astype(np.uint8)
