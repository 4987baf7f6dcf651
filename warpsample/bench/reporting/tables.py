"""Tables of benchmark results, for a terminal or as Markdown."""

import re
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, replace
from textwrap import fill
from typing import TYPE_CHECKING, Any

from warpsample.bench.rows import Show, format_field, get_columns

if TYPE_CHECKING:
    from rich.console import Console

SPREAD_NOTE = "Figures are medians. Brackets: 25th to 75th percentile of the repeats."


@dataclass(frozen=True)
class Cell:
    """Column of a benchmark table: the field that it shows, and the rows that it takes the field from.

    Attributes:
        field: field of the row.
        heading: heading of the column; default: the heading of the field.
        show: format of the value; default: the format of the field.
        where: (field, value) pairs that select the row to show.
    """

    field: str
    heading: str | None = None
    show: Show = None
    where: tuple[tuple[str, Any], ...] = ()

    def format_line(self, rows: list[Any]) -> str:
        """Return the text of this column for one line of the table; empty if no row matches `where`."""
        chosen = [row for row in rows if all(getattr(row, name) == value for name, value in self.where)]
        return format_field(chosen[0], self.field, self.show) if chosen else ""


def _did_run(row: Any) -> bool:
    return not getattr(row, "failure", None)


@dataclass(frozen=True)
class TableView:
    """Layout of a benchmark's tables: columns, order of the lines, and division into several tables.

    Several fields are one text, separated by blanks.

    Attributes:
        part: name of the part.
        title: title of each table.
        lines: fields; each combination of their values is a line.
        cells: fields or cells of a line.
        across: fields; the cells repeat side by side for each combination of their values.
        split: fields; each combination of their values is a table.
        where: predicate of the rows to show; default: rows of tools that ran.
        page_rows: function that selects rows for the page; None leaves the view out of the page.
    """

    part: str
    title: str
    lines: str
    cells: str | Sequence[Cell]
    across: str = ""
    split: str = ""
    where: Callable[[Any], Any] = _did_run
    page_rows: Callable[[list[Any]], list[Any]] | None = list


@dataclass(frozen=True)
class Table:
    """Formatted texts under column headings; the first `names` columns identify a line."""

    title: str
    headings: list[str]
    cells: list[list[str]]
    names: int


def build_tables(view: TableView, rows: Iterable[Any]) -> list[Table]:
    """Build the tables of a view from benchmark rows."""
    return [_build_table(view, key, group) for key, group in group_rows(filter(view.where, rows), view.split).items()]


def group_rows(rows: Iterable[Any], names: str) -> dict[tuple[Any, ...], list[Any]]:
    """Group benchmark rows by the values of the named fields, in order of first appearance."""
    groups: dict[tuple[Any, ...], list[Any]] = {}
    for row in rows:
        groups.setdefault(tuple(getattr(row, name) for name in names.split()), []).append(row)
    return groups


def select_all_workers(rows: list[Any]) -> list[Any]:
    """Return the benchmark rows with the highest number of workers."""
    most = max((row.workers for row in rows), default=0)
    return [row for row in rows if row.workers == most]


def list_notes(view: TableView, rows: list[Any]) -> list[str]:
    """Return one sentence for each column of a table view that has an explanatory note."""
    columns = get_columns(type(rows[0])) if rows else {}
    names = dict.fromkeys([*view.lines.split(), *(cell.field for cell in _list_cells(view))])
    described = [(columns[name].metadata["heading"], columns[name].metadata["note"]) for name in names if name in columns]
    return [f"{heading}: {note}." for heading, note in described if note]


def describe_tools(parts: Iterable[list[Any]]) -> list[str]:
    """Return a line with the versions of the tools, then a line for each tool that did not run."""
    rows = [row for part in parts for row in part]
    version_of = {row.tool: row.version for row in rows if getattr(row, "version", None)}
    versions_of: dict[str, set[str]] = {}
    for tool, version in version_of.items():
        versions_of.setdefault(_drop_settings(tool), set()).add(version)
    shown = (
        (_drop_settings(tool) if len(versions_of[_drop_settings(tool)]) == 1 else tool, version)
        for tool, version in version_of.items()
    )
    versions = dict.fromkeys(f"{tool} {version}" for tool, version in shown)
    missing = dict.fromkeys(f"{row.tool} did not run here: {row.failure}." for row in rows if getattr(row, "failure", None))
    return [*([f"Versions: {', '.join(versions)}."] if versions else []), *missing]


def _drop_settings(tool: str) -> str:
    """Return the name of a tool without its settings: "Blender" for "Blender, 64 rays"."""
    return tool.partition(",")[0]


def print_parts(console: "Console", parts: Iterable[Table | str]) -> None:
    """Print tables and paragraphs of text on a rich Console."""
    for part in parts:
        if isinstance(part, str):
            console.print(part, markup=False, highlight=False)
        else:
            console.print(_build_rich_table(part))


def format_markdown(parts: Iterable[Table | str]) -> str:
    """Return tables and paragraphs as Markdown, with lines of at most 125 characters outside tables."""
    return "\n\n".join(_wrap(part) if isinstance(part, str) else _format_markdown_table(part) for part in parts)


def _build_table(view: TableView, key: tuple[Any, ...], rows: list[Any]) -> Table:
    titles = [view.title, ", ".join(format_named(rows[0], name) for name in view.split.split())]
    names, cells = view.lines.split(), _repeat_across(view, rows)
    headings = [*(_get_heading(rows, name) for name in names), *(cell.heading or "" for cell in cells)]
    texts = [
        [*(format_field(group[0], name) for name in names), *(cell.format_line(group) for cell in cells)]
        for group in group_rows(rows, view.lines).values()
    ]
    return Table(": ".join(filter(None, titles)), headings, texts, len(names))


def _list_cells(view: TableView) -> list[Cell]:
    return [Cell(name) for name in view.cells.split()] if isinstance(view.cells, str) else list(view.cells)


def _repeat_across(view: TableView, rows: list[Any]) -> list[Cell]:
    """Return the columns of a table, repeated for each combination of values of the `across` fields."""
    cells = [cell if cell.heading else replace(cell, heading=_get_heading(rows, cell.field)) for cell in _list_cells(view)]
    if not view.across:
        return cells
    names, spread_out = view.across.split(), []
    for values, group in group_rows(rows, view.across).items():
        label = " ".join(filter(None, (format_named(group[0], name) for name in names)))
        for cell in cells:
            heading = ", ".join([label, *([cell.heading or ""] if len(cells) > 1 else [])])
            spread_out.append(replace(cell, heading=heading, where=(*cell.where, *zip(names, values, strict=True))))
    return spread_out


def _get_heading(rows: list[Any], name: str) -> str:
    return get_columns(type(rows[0]))[name].metadata["heading"]


def format_named(row: Any, name: str) -> str:
    """Return a field of a row as text, preceded by its column heading if the value is a bare number."""
    value = format_field(row, name)
    is_clear = isinstance(getattr(row, name), str) or get_columns(type(row))[name].metadata["show"]
    return value if is_clear else f"{get_columns(type(row))[name].metadata['heading']} {value}"


def _wrap(paragraph: str) -> str:
    """Break a paragraph into lines; text in backticks stays on one line."""
    whole = re.sub("`[^`]*`", lambda command: command[0].replace(" ", "\0"), paragraph)
    return fill(whole, 125, break_long_words=False, break_on_hyphens=False).replace("\0", " ")


def _format_markdown_table(table: Table) -> str:
    lines = [table.headings, ["---"] * len(table.headings), *table.cells]
    return "\n".join([f"**{table.title}**", "", *(f"| {' | '.join(cells)} |" for cells in lines)])


def _build_rich_table(table: Table) -> object:
    from rich.box import SIMPLE
    from rich.table import Table as RichTable

    rich_table = RichTable(title=table.title, box=SIMPLE, padding=(0, 1, 0, 0), title_justify="left")
    for i, heading in enumerate(table.headings):
        rich_table.add_column(heading, justify="left" if i < table.names else "right", overflow="fold")
    for row in table.cells:
        rich_table.add_row(*row)
    return rich_table
