"""What was measured, as tables and paragraphs: on a terminal, or in Markdown for the README."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from textwrap import fill
from typing import TYPE_CHECKING

from warpsample.bench.timing import Spread

if TYPE_CHECKING:
    from rich.console import Console

SPREAD = "medians; in brackets the range of the middle half of the repeats"


@dataclass(frozen=True)
class Table:
    """Cells under headings.

    Attributes:
        title: above it; the README leaves it out.
        headings: of the columns.
        cells: row by row.
    """

    title: str
    headings: Sequence[str]
    cells: Sequence[Sequence[str]]


def show(console: "Console", parts: Iterable[Table | str]) -> None:
    """Prints tables and paragraphs."""
    for part in parts:
        if isinstance(part, str):
            console.print(part, markup=False, highlight=False)
        else:
            console.print(_drawn(part))


def markdown(parts: Iterable[Table | str]) -> str:
    """The same for a README, a blank line between any two, in lines of at most 125 characters."""
    return "\n\n".join(_wrapped(part) if isinstance(part, str) else _markdown_table(part) for part in parts)


def figure(x: float | None) -> str:
    """Three digits, and no more than two places; a dash for None."""
    return "–" if x is None else f"{x:,.{0 if x >= 100 else 1 if x >= 10 else 2}f}"


def digits(x: float) -> str:
    """Three digits, however small; thousands in groups."""
    return f"{x:,.0f}" if x >= 100 else f"{x:.3g}"


def spread(found: Spread | None) -> str:
    """The median, and in brackets the middle half."""
    return "–" if found is None else f"{figure(found.median)} ({figure(found.low)}–{figure(found.high)})"


def _wrapped(paragraph: str) -> str:
    return fill(paragraph, 125, break_long_words=False, break_on_hyphens=False)


def _markdown_table(table: Table) -> str:
    lines = [table.headings, ["---"] * len(table.headings), *table.cells]
    return "\n".join(f"| {' | '.join(cells)} |" for cells in lines)


def _drawn(table: Table) -> object:
    from rich.box import SIMPLE  # noqa: PLC0415
    from rich.table import Table as RichTable  # noqa: PLC0415

    drawn = RichTable(title=table.title, box=SIMPLE, padding=(0, 1, 0, 0), title_justify="left")
    for i, text in enumerate(table.headings):
        drawn.add_column(text, justify="left" if i == 0 else "right", overflow="fold")
    for row in table.cells:
        drawn.add_row(*row)
    return drawn
