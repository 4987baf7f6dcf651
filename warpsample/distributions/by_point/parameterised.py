"""Parameters of a distribution: constants, or arrays with one row for each point."""

from dataclasses import fields
from typing import Any, ClassVar, TypeAlias

import numpy as np
from typing_extensions import Self

from warpsample.distributions.by_point.rows import as_rows, copy_rows, is_array
from warpsample.distributions.by_point.tables import (
    Layout,
    count_numbers,
    layout_of,
    lend_tables,
    tables_in,
    without_tables,
)
from warpsample.distributions.parameters import SIZES, pack_parameters, parameter_types
from warpsample.host.arguments import check_number, quote
from warpsample.host.device_memory import Loan
from warpsample.host.shared_values import digest_of

Range: TypeAlias = tuple[float, float] | None

_DIMENSIONS = {1: 0, 3: 1, 9: 2}
"""Number of dimensions of a constant, by its number of float32 numbers."""


class Parameterised:
    """Base of the frozen dataclasses whose fields are parameters of a distribution; see `Distribution`.

    A field may hold another distribution, a nested lobe. Kernels take the parameters of nested lobes before those of
    `parameters`, and the names of the nested parameters by point have the name of the field first: "lobe.alpha".
    """

    parameters: ClassVar[tuple[str, ...]] = ()
    bounds: ClassVar[Range] = None
    maps: ClassVar[Any]

    def __init_subclass__(cls, **options: Any) -> None:
        """Keep the methods `__eq__`, `__hash__` and `__repr__` of this class in subclasses that are dataclasses."""
        super().__init_subclass__(**options)
        for name in ("__eq__", "__hash__", "__repr__"):
            if name not in cls.__dict__:
                setattr(cls, name, getattr(cls, name))

    def __post_init__(self) -> None:
        """Check the parameters: constants must be within their bounds; arrays with a row per point are copied."""
        for i, name in enumerate(self.parameters):
            value = getattr(self, name)
            rows = as_rows(value, name, self._dimensions(i)) if is_array(value) else None
            if rows is not None:
                object.__setattr__(self, name, self._copy_rows(name, rows))
            elif isinstance(value, np.ndarray) and value.ndim:  # a constant vector: arrays in fields are by point
                object.__setattr__(self, name, tuple(value.tolist()))
            elif self.bounds is not None and (i == 0 or self._dimensions(i) == 0):
                object.__setattr__(self, name, check_number(value, name, *self.bounds))
        self._check_lengths()

    def _dimensions(self, i: int) -> int:
        """Return the number of dimensions of the i-th parameter: 0 for a number, 1 for a vector, 2 for a matrix."""
        return _DIMENSIONS[SIZES[parameter_types(self.maps.sample)[i]]]

    def _copy_rows(self, name: str, rows: np.ndarray) -> np.ndarray:  # noqa: ARG002  (subclasses use the name)
        """Return a read-only float32 copy of a parameter with a row per point; rows out of range become NaN."""
        bounded = self.bounds is not None and rows.ndim == 1
        return copy_rows(rows, *self.bounds) if bounded and self.bounds else copy_rows(rows)

    def _check_lengths(self) -> None:
        """Raise ValueError if two parameters that are arrays have different numbers of rows."""
        tables = {name: table for name, table in self.by_point.items() if table.ndim}
        for name, table in tables.items():
            first = next(iter(tables))
            if len(table) != len(tables[first]):
                raise ValueError(f"{name}: got {len(table):,} rows, want {len(tables[first]):,}, as {first} has")

    def __eq__(self, other: object) -> bool:
        """Return whether two distributions have the same class and the same parameters, NaN included."""
        if other.__class__ is not self.__class__:
            return NotImplemented
        return self._content() == other._content()  # type: ignore[attr-defined]

    def __hash__(self) -> int:
        """Return a hash of the class' parameters; arrays with equal numbers have equal hashes."""
        return hash(self._content())

    def __repr__(self) -> str:
        """Return the class name and the parameters as text; of arrays, only the shape."""
        shown = ((item.name, getattr(self, item.name)) for item in fields(self) if item.repr)
        texts = (f"{name}={f'array{v.shape}' if isinstance(v, np.ndarray) else repr(v)}" for name, v in shown)
        return f"{type(self).__qualname__}({', '.join(texts)})"

    def __dask_tokenize__(self) -> tuple[Any, ...]:
        """Return the values that Dask hashes into the names of tasks."""
        return type(self).__module__, type(self).__qualname__, *self._content()

    def _content(self) -> tuple[Any, ...]:
        """Return the parameters as hashable values, with a hash in place of each array, and tuples for nested lobes."""
        values = (getattr(self, item.name) for item in fields(self) if item.compare)
        return tuple(_identify(value) for value in values)

    @property
    def nested(self) -> dict[str, "Parameterised"]:
        """Nested lobes, by the name of the field that holds the lobe; empty for most distributions."""
        return {item.name: v for item in fields(self) if isinstance(v := getattr(self, item.name), Parameterised)}

    @property
    def by_point(self) -> dict[str, np.ndarray]:
        """Parameters with one row for each point, by name: (P,) or (P, 3) float32; empty if all are constants."""
        inner = {f"{at}.{name}": table for at, lobe in self.nested.items() for name, table in lobe.by_point.items()}
        return inner | {item.name: v for item in fields(self) if isinstance(v := getattr(self, item.name), np.ndarray)}

    def take(self, rows: Any) -> Self:
        """Return the distribution for a selection of the points: parameters with a row per point keep the given rows.

        Args:
            rows: a slice, (N,) integers, or a (P,) bool mask.

        Returns:
            an instance of the same class; this instance if all parameters are constants.

        Raises:
            IndexError: a row that the parameters do not have, a mask of another length, or a number alone.

        Example:
            >>> lobe = ws.GGX(alpha=np.linspace(0.1, 0.5, 5))
            >>> print(lobe.take(slice(1, 3)).alpha.round(2))
            [0.2 0.3]
        """
        tables = {name: table[rows] for name, table in self.by_point.items()}
        if any(table.ndim != self.by_point[name].ndim for name, table in tables.items()):
            raise IndexError(f"rows: got {quote(rows)}, want a slice, (N,) integers or a (P,) bool mask")
        return self.with_tables(tables)

    def with_tables(self, tables: dict[str, np.ndarray]) -> Self:
        """Return a copy with other arrays for the parameters that have a row per point; the arrays are not checked."""
        if not tables:
            return self
        lobes = {}
        for at, lobe in self.nested.items():
            inner = {name.removeprefix(f"{at}."): t for name, t in tables.items() if name.startswith(f"{at}.")}
            lobes[at] = lobe.with_tables(inner)
        copy = self._with_nested(lobes)
        for name, table in tables.items():
            if "." not in name:
                object.__setattr__(copy, name, np.ascontiguousarray(table, np.float32))
        return copy

    def _with_nested(self, lobes: dict[str, "Parameterised"]) -> Self:
        """Return a copy with other nested lobes, given by the names of `nested`; nothing is checked."""
        copy = object.__new__(type(self))
        copy.__dict__.update(self.__dict__ | lobes)
        return copy

    def kernel_values(self, loan: Loan | None = None) -> tuple[Any, ...]:
        """Return the values of all parameters in the order of the kernels' arguments.

        Args:
            loan: memory on the kernels' device, for distributions with a table. Default: None, the CPU.
        """
        inner = (value for lobe in self.nested.values() for value in lobe.kernel_values(loan))
        return (*inner, *(getattr(self, name) for name in self.parameters))

    @property
    def size(self) -> int:
        """Number of float32 values in the struct `Parameters`, including the parameters of nested lobes."""
        return count_numbers(self.kernel_values())

    @property
    def layout(self) -> Layout:
        """Positions of the parameters with a row per point among the numbers that kernels take; empty without any."""
        return layout_of(self.kernel_values()) if self.by_point else ()

    def kernel_parameters(self, loan: Loan | None = None) -> Any:
        """Return the parameters as a kernel argument; numbers of parameters with a row per point are 0 there.

        Args:
            loan: memory on the kernels' device, for distributions with a table. Default: None, the CPU.

        Returns:
            a `Parameters` struct of float32; new values do not recompile a kernel.

        Example:
            >>> print(ws.GGX(alpha=0.5).kernel_parameters().scalar)
            0.5
        """
        values = self.kernel_values(loan)
        return pack_parameters(without_tables(values) if self.by_point else values)

    def lend_tables(self, loan: Loan, rows: slice = slice(None)) -> int:
        """Copy the parameters with a row per point to the device if necessary; return the address of their addresses."""
        return lend_tables(loan, tables_in(self.kernel_values()), rows) if self.by_point else 0

    def check_points(self, points: int, argument: str = "distribution") -> None:
        """Raise ValueError unless parameters by point have one row for each of `points` points."""
        for name, table in self.by_point.items():
            if len(table) != points:
                raise ValueError(f"{argument}: got {name} with {len(table):,} rows, want {points:,}, one for each point")


def _identify(value: Any) -> Any:
    """Return a hashable value that identifies a parameter: of arrays a hash, of nested lobes what Dask hashes."""
    if isinstance(value, Parameterised):
        return value.__dask_tokenize__()
    return digest_of(value) if isinstance(value, np.ndarray) else value
