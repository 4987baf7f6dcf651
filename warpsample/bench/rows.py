"""Rows that benchmarks find: a field declares its column once, for the terminal, the README and the pictures."""

from collections.abc import Callable, Sequence
from dataclasses import MISSING, Field, dataclass, field
from functools import partial
from statistics import median, quantiles
from typing import Any


@dataclass(frozen=True)
class Spread:
    """The median of repeated figures, and between which values the middle half of them lies."""

    median: float
    low: float
    high: float

    @classmethod
    def of(cls, figures: Sequence[float]) -> "Spread":
        """The spread of at least one figure."""
        low, _, high = quantiles(figures, method="inclusive") if len(figures) > 1 else [figures[0]] * 3
        return cls(median(figures), low, high)

    @classmethod
    def of_ratios(cls, numerators: Sequence[float], denominators: Sequence[float]) -> "Spread":
        """The spread of the ratios within each round."""
        return cls.of([a / b for a, b in zip(numerators, denominators, strict=True)])


@dataclass(frozen=True)
class Timed:
    """What was found of one case, over and over: a base of rows. Rows are frozen dataclasses whose fields are columns.

    Attributes:
        seconds: of each repeat; none where they were not kept.
    """

    seconds: list[float] = field(default_factory=list, kw_only=True)


Show = str | Callable[[Any], str] | None


def column(heading: str, note: str = "", *, show: Show = None, default: Any = MISSING, kw_only: bool = False) -> Any:
    """A field of a row that says how it is shown.

    Args:
        heading: of its column, with the unit.
        note: what it is, where the heading does not tell; printed below a table.
        show: a format or a function for its values; for a `Spread` that of the median alone. By default `text` chooses.
        default: its value where a row is made without.
        kw_only: whether it is named where a row is made.
    """
    return field(default=default, kw_only=kw_only, metadata={"heading": heading, "note": note, "show": show})


maybe = partial(column, default=None)
"""A column that may have no value."""


@dataclass(frozen=True)
class ToolRow(Timed):
    """What was found of one tool: a base of rows whose other columns may have no value."""

    tool: str = column("tool", kw_only=True)
    version: str | None = maybe("version", kw_only=True)
    failure: str | None = maybe("why it did not run", kw_only=True)


def columns(kind: type) -> dict[str, Field[Any]]:
    """The columns of a class of rows, by name."""
    return {name: each for name, each in kind.__dataclass_fields__.items() if each.metadata}


def shown(row: Any, name: str, show: Show = None) -> str:
    """The text of a row's value; `show` in place of the column's own."""
    return text(getattr(row, name), show or columns(type(row))[name].metadata["show"])


def text(value: Any, show: Show = None) -> str:
    """A value as tables show it; a dash where there is none."""
    if value is None:
        return "–"
    if show is not None:
        one = value.median if isinstance(value, Spread) else value
        return show(one) if callable(show) else format(one, show)
    if isinstance(value, Spread):
        return f"{figure(value.median)} ({figure(value.low)}–{figure(value.high)})"
    if isinstance(value, bool):
        return "yes" if value else "no"
    return figure(value) if isinstance(value, float) else f"{value:,}" if isinstance(value, int) else str(value)


def figure(x: float) -> str:
    """Three digits, and no more than two places."""
    return f"{x:,.{0 if x >= 100 else 1 if x >= 10 else 2}f}"


def digits(x: float) -> str:
    """Three digits, however small; thousands in groups."""
    return f"{x:,.0f}" if x >= 100 else f"{x:.3g}"
