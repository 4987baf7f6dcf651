"""Declaration of a benchmark, from which its command line, result files, tables and pictures follow."""

import inspect
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Annotated, Any

import typer

from warpsample.bench.reporting import pictures, tables
from warpsample.bench.reporting.pictures import Picture
from warpsample.bench.reporting.tables import Table, TableView
from warpsample.bench.rows import format_value
from warpsample.bench.running.machine import Machine

if TYPE_CHECKING:
    from matplotlib.figure import Figure

SEED = 0
"""Seed of the points, rays and directions of every benchmark."""

Repeats = Annotated[int, typer.Option(help="Number of timed runs of each case. Untimed runs come first.", min=1)]
Scenes = Annotated[
    list[str] | None,
    typer.Option(
        help="Name of a scene to measure, for example bunny; may be repeated. Default: all scenes.", show_default=False
    ),
]
Track = Callable[[Iterable[Any], int], Iterator[Any]]
"""Function (items, count) that yields the items and can show progress."""

RowsByPart = dict[str, list[Any]]
"""Measured rows, keyed by the name of their part."""


@dataclass(frozen=True)
class Result:
    """Result of running one benchmark: machine, settings and rows.

    Attributes:
        machine: machine and versions of the run.
        settings: values of the command's options.
        rows: measured rows, keyed by part.
    """

    machine: Machine
    settings: dict[str, Any]
    rows: RowsByPart


@dataclass(frozen=True)
class Benchmark:
    """Declaration of a benchmark: the function that measures, its options, rows, tables and pictures.

    Attributes:
        name: name of the command and of the result files.
        summary: one sentence for the command's help.
        measure: function (track, **settings) -> rows by part; its keyword-only parameters, annotated for typer, are the
            options.
        parts: class of the rows of each part.
        views: tables of the command and of the page.
        pictures: pictures of the rows.
    """

    name: str
    summary: str
    measure: Callable[..., RowsByPart]
    parts: dict[str, type]
    views: Sequence[TableView]
    pictures: Sequence[Picture]

    def has_disagreement(self, rows: RowsByPart) -> bool:
        """Return True if a tool's result disagrees with the reference; the command then exits with status 1."""
        return any(getattr(row, "agrees", None) is False for rows in rows.values() for row in rows)

    @property
    def options(self) -> dict[str, inspect.Parameter]:
        """Options of the benchmark's command, with their defaults."""
        parameters = inspect.signature(self.measure).parameters
        return {name: each for name, each in parameters.items() if each.kind is inspect.Parameter.KEYWORD_ONLY}

    def settings(self, **chosen: Any) -> dict[str, Any]:
        """Return the value of every option of the benchmark: from `chosen`, otherwise the default."""
        return {name: option.default for name, option in self.options.items()} | chosen

    def report(self, result: Result) -> list[Table | str]:
        """Return the output of the benchmark's command: all tables, column notes, and tools that did not run."""
        lines = [self.provenance(result), tables.SPREAD_NOTE]
        for view in self.views:
            rows = [row for row in result.rows[view.part] if view.where(row)]
            lines += [*tables.build_tables(view, rows), *tables.list_notes(view, rows)]
        lines += tables.describe_tools(result.rows.values())
        return [line for i, line in enumerate(lines) if line not in lines[:i]]

    def build_page(self, result: Result) -> list[Table | str]:
        """Return the benchmark's part of a page: tables, then versions, missing tools, command and machine."""
        shown = [
            table for view in self.views if view.page_rows
            for table in tables.build_tables(view, view.page_rows(list(filter(view.where, result.rows[view.part]))))
        ]  # fmt: skip
        return [*shown, " ".join([*tables.describe_tools(result.rows.values()), f"({self.provenance(result)})"])]

    def figures(self, result: Result, names: Sequence[str] | None = None) -> dict[str, "Figure"]:
        """Return the benchmark's pictures as figures by name: all figures, or only `names`."""
        chosen = [picture for picture in self.pictures if names is None or picture.name in names]
        return {each.name: pictures.draw_figure(each, result.rows[each.part], str(result.machine)) for each in chosen}

    def provenance(self, result: Result) -> str:
        """Return one line with the command that produced a result, its settings and the machine."""
        shown = {
            name: format_value(value, "g" if isinstance(value, float) else None) for name, value in result.settings.items()
        }
        chosen = [f"{name} {shown[name]}" for name, value in result.settings.items() if value is not None]
        return f"`warpsample bench {self.name}`: {', '.join(chosen)}, seed {SEED}; {result.machine}"
