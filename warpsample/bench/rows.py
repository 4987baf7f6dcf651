"""Rows of benchmark tables; each field declares its column once, for the terminal, the page and the pictures."""

from collections.abc import Callable, Sequence
from dataclasses import MISSING, Field, dataclass, field
from functools import partial
from statistics import median, quantiles
from typing import Any


@dataclass(frozen=True)
class Spread:
    """Median and quartiles of repeated measurements.

    Attributes:
        median: 50th percentile.
        low: 25th percentile.
        high: 75th percentile.
    """

    median: float
    low: float
    high: float

    @classmethod
    def of(cls, figures: Sequence[float]) -> "Spread":
        """Compute the median and quartiles of one or more numbers."""
        low, _, high = quantiles(figures, method="inclusive") if len(figures) > 1 else [figures[0]] * 3
        return cls(median(figures), low, high)

    @classmethod
    def of_ratios(cls, numerators: Sequence[float], denominators: Sequence[float]) -> "Spread":
        """Compute the median and quartiles of the ratios of paired numbers, for example the times of each round."""
        return cls.of([a / b for a, b in zip(numerators, denominators, strict=True)])


@dataclass(frozen=True)
class Timed:
    """Base class of benchmark rows, which are frozen dataclasses with columns as fields.

    Attributes:
        seconds: run time of each repeat; empty in rows from a file in `results/`.
    """

    seconds: list[float] = field(default_factory=list, kw_only=True)


Show = str | Callable[[Any], str] | None


def column(heading: str, note: str = "", *, show: Show = None, default: Any = MISSING, kw_only: bool = False) -> Any:
    """Declare a dataclass field of a benchmark row as a table column.

    Args:
        heading: heading of the column, with the unit.
        note: explanation of the heading; printed below the command's tables.
        show: format or function for the values; of a `Spread` only the median is shown. Default: `format_value` chooses.
        default: default value of the field.
        kw_only: True for a field that is passed by keyword.
    """
    return field(default=default, kw_only=kw_only, metadata={"heading": heading, "note": note, "show": show})


optional_column = partial(column, default=None)
"""Declare a field that can be None as a column."""


@dataclass(frozen=True)
class ToolRow(Timed):
    """Base class of benchmark rows that describe the result of one tool.

    The columns of results are None for a tool that did not run.
    """

    tool: str = column("tool", kw_only=True)
    version: str | None = optional_column("version", kw_only=True)
    failure: str | None = optional_column("why it did not run", kw_only=True)


def get_columns(kind: type) -> dict[str, Field[Any]]:
    """Return the table columns of a class of benchmark rows, keyed by field name."""
    return {name: each for name, each in kind.__dataclass_fields__.items() if each.metadata}


def format_field(row: Any, name: str, show: Show = None) -> str:
    """Return a field of a benchmark row as text; `show` replaces the column's own format."""
    return format_value(getattr(row, name), show or get_columns(type(row))[name].metadata["show"])


def format_value(value: Any, show: Show = None) -> str:
    """Return a value of a benchmark table as text; a dash for None."""
    if value is None:
        return "–"
    if show is not None:
        one = value.median if isinstance(value, Spread) else value
        return show(one) if callable(show) else format(one, show)
    if isinstance(value, Spread):
        return f"{format_figure(value.median)} ({format_figure(value.low)}–{format_figure(value.high)})"
    if isinstance(value, bool):
        return "yes" if value else "no"
    return format_figure(value) if isinstance(value, float) else f"{value:,}" if isinstance(value, int) else str(value)


def format_figure(x: float) -> str:
    """Return a number with three digits and at most two decimal places; two digits of numbers that would round to 0."""
    if 0.0 < x < 0.005:
        return f"{x:.2g}"
    return f"{x:,.{0 if x >= 100 else 1 if x >= 10 else 2}f}"


def format_digits(x: float) -> str:
    """Return a number with three significant digits and thousands separators."""
    return f"{x:,.0f}" if x >= 100 else f"{x:.3g}"
