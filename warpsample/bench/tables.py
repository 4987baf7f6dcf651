"""Tables of what was found: on a terminal, or in Markdown for the README."""

import re
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, replace
from textwrap import fill
from typing import TYPE_CHECKING, Any

from warpsample.bench.rows import Show, columns, shown

if TYPE_CHECKING:
    from rich.console import Console

SPREADS = "Figures are medians; in brackets the range of the middle half of the repeats."


@dataclass(frozen=True)
class Cell:
    """A column of a view.

    Attributes:
        of: the field.
        heading: by default the field's.
        show: by default the field's.
        where: values of other fields of the row whose field is shown.
    """

    of: str
    heading: str | None = None
    show: Show = None
    where: tuple[tuple[str, Any], ...] = ()

    def text(self, rows: list[Any]) -> str:
        """What a line shows; nothing where it has no such row."""
        chosen = [row for row in rows if all(getattr(row, name) == value for name, value in self.where)]
        return shown(chosen[0], self.of, self.show) if chosen else ""


def _ran(row: Any) -> bool:
    return not getattr(row, "failure", None)


@dataclass(frozen=True)
class TableView:
    """How the rows of a part become tables. Several fields are named in one text, with blanks between.

    Attributes:
        part: its name.
        title: above each table.
        lines: fields; there is a line for each of their values.
        cells: what a line shows: fields, or cells.
        across: fields; the cells stand side by side for each of their values.
        split: fields; there is a table for each of their values.
        where: which rows are shown; by default those of tools that ran.
        brief: which of these the README shows, of all; None for no table there.
    """

    part: str
    title: str
    lines: str
    cells: str | Sequence[Cell]
    across: str = ""
    split: str = ""
    where: Callable[[Any], Any] = _ran
    brief: Callable[[list[Any]], list[Any]] | None = list


@dataclass(frozen=True)
class Table:
    """Texts under headings; the first columns name a line."""

    title: str
    headings: list[str]
    cells: list[list[str]]
    names: int


def tables(view: TableView, rows: Iterable[Any]) -> list[Table]:
    """The tables of a view."""
    return [_table(view, key, group) for key, group in grouped(filter(view.where, rows), view.split).items()]


def grouped(rows: Iterable[Any], names: str) -> dict[tuple[Any, ...], list[Any]]:
    """Rows by the values of the fields named, in the order in which they come."""
    groups: dict[tuple[Any, ...], list[Any]] = {}
    for row in rows:
        groups.setdefault(tuple(getattr(row, name) for name in names.split()), []).append(row)
    return groups


def all_workers(rows: list[Any]) -> list[Any]:
    """Those rows that as many workers as there are have worked for."""
    most = max((row.workers for row in rows), default=0)
    return [row for row in rows if row.workers == most]


def notes(view: TableView, rows: list[Any]) -> list[str]:
    """What the columns of a view are, where their headings do not tell."""
    known = columns(type(rows[0])) if rows else {}
    names = dict.fromkeys([*view.lines.split(), *(cell.of for cell in _cells(view))])
    told = [(known[name].metadata["heading"], known[name].metadata["note"]) for name in names if name in known]
    return [f"{heading}: {note}." for heading, note in told if note]


def about_tools(parts: Iterable[list[Any]]) -> list[str]:
    """The versions of the tools, and a line for each that did not run."""
    rows = [row for part in parts for row in part]
    known = {row.tool: row.version for row in rows if getattr(row, "version", None)}
    of_name: dict[str, set[str]] = {}
    for tool, version in known.items():
        of_name.setdefault(_name(tool), set()).add(version)
    shown = ((_name(tool) if len(of_name[_name(tool)]) == 1 else tool, version) for tool, version in known.items())
    versions = dict.fromkeys(f"{tool} {version}" for tool, version in shown)
    missing = dict.fromkeys(f"{row.tool} did not run here: {row.failure}." for row in rows if getattr(row, "failure", None))
    return [*([f"Versions: {', '.join(versions)}."] if versions else []), *missing]


def _name(tool: str) -> str:
    """A tool without its settings, as in "Blender, 64 rays"."""
    return tool.partition(",")[0]


def show(console: "Console", parts: Iterable[Table | str]) -> None:
    """Prints tables and paragraphs."""
    for part in parts:
        if isinstance(part, str):
            console.print(part, markup=False, highlight=False)
        else:
            console.print(_drawn(part))


def markdown(parts: Iterable[Table | str]) -> str:
    """Tables and paragraphs for a README, a blank line between any two, in lines of at most 125 characters."""
    return "\n\n".join(_wrapped(part) if isinstance(part, str) else _markdown_table(part) for part in parts)


def _table(view: TableView, key: tuple[Any, ...], rows: list[Any]) -> Table:
    titles = [view.title, ", ".join(named(rows[0], name) for name in view.split.split())]
    names, cells = view.lines.split(), _spread_out(view, rows)
    headings = [*(_heading(rows, name) for name in names), *(cell.heading or "" for cell in cells)]
    texts = [
        [*(shown(mine[0], name) for name in names), *(cell.text(mine) for cell in cells)]
        for mine in grouped(rows, view.lines).values()
    ]
    return Table(": ".join(filter(None, titles)), headings, texts, len(names))


def _cells(view: TableView) -> list[Cell]:
    return [Cell(name) for name in view.cells.split()] if isinstance(view.cells, str) else list(view.cells)


def _spread_out(view: TableView, rows: list[Any]) -> list[Cell]:
    """The cells with their headings, for each value of what stands across."""
    cells = [cell if cell.heading else replace(cell, heading=_heading(rows, cell.of)) for cell in _cells(view)]
    if not view.across:
        return cells
    names, spread_out = view.across.split(), []
    for values, mine in grouped(rows, view.across).items():
        told = " ".join(filter(None, (named(mine[0], name) for name in names)))
        for cell in cells:
            heading = ", ".join([told, *([cell.heading or ""] if len(cells) > 1 else [])])
            spread_out.append(replace(cell, heading=heading, where=(*cell.where, *zip(names, values, strict=True))))
    return spread_out


def _heading(rows: list[Any], name: str) -> str:
    return columns(type(rows[0]))[name].metadata["heading"]


def named(row: Any, name: str) -> str:
    """A value with the name of its column, if it does not speak for itself."""
    value = shown(row, name)
    speaks = isinstance(getattr(row, name), str) or columns(type(row))[name].metadata["show"]
    return value if speaks else f"{columns(type(row))[name].metadata['heading']} {value}"


def _wrapped(paragraph: str) -> str:
    """A paragraph in lines, whose commands stay whole."""
    whole = re.sub("`[^`]*`", lambda command: command[0].replace(" ", "\0"), paragraph)
    return fill(whole, 125, break_long_words=False, break_on_hyphens=False).replace("\0", " ")


def _markdown_table(table: Table) -> str:
    lines = [table.headings, ["---"] * len(table.headings), *table.cells]
    return "\n".join([f"**{table.title}**", "", *(f"| {' | '.join(cells)} |" for cells in lines)])


def _drawn(table: Table) -> object:
    from rich.box import SIMPLE
    from rich.table import Table as RichTable

    drawn = RichTable(title=table.title, box=SIMPLE, padding=(0, 1, 0, 0), title_justify="left")
    for i, heading in enumerate(table.headings):
        drawn.add_column(heading, justify="left" if i < table.names else "right", overflow="fold")
    for row in table.cells:
        drawn.add_row(*row)
    return drawn
