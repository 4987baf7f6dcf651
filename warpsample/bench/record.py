"""What a benchmark says of itself; the command line, the result files, the tables and the pictures follow from it."""

import inspect
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Annotated, Any

import typer

from warpsample.bench import pictures, tables
from warpsample.bench.pictures import Picture
from warpsample.bench.rows import text
from warpsample.bench.running.machine import Machine
from warpsample.bench.tables import Table, TableView

if TYPE_CHECKING:
    from matplotlib.figure import Figure

SEED = 0
"""The seed of every benchmark's points, rays and directions."""

Repeats = Annotated[int, typer.Option(help="Timed runs of each case, each after untimed ones.", min=1)]
Scenes = Annotated[list[str] | None, typer.Option(help="Only this one; may be repeated.", show_default=False)]
Track = Callable[[Iterable[Any], int], Iterator[Any]]
"""Passes on items, of which there are so many, and may show how far it has come."""

Found = dict[str, list[Any]]
"""What was found: rows by the name of their part."""


@dataclass(frozen=True)
class Result:
    """One run of a benchmark.

    Attributes:
        machine: where.
        settings: the values of the command's options.
        found: rows by part.
    """

    machine: Machine
    settings: dict[str, Any]
    found: Found


@dataclass(frozen=True)
class Benchmark:
    """What is measured, and how it is shown.

    Attributes:
        name: of its command and its result files.
        summary: one sentence for the command's help.
        measure: (track, **settings) -> found; its keyword-only parameters, typed as typer takes them, are the options.
        parts: the class of the rows of each part that is measured and kept.
        views: the tables.
        pictures: what is drawn.
    """

    name: str
    summary: str
    measure: Callable[..., Found]
    parts: dict[str, type]
    views: Sequence[TableView]
    pictures: Sequence[Picture]

    def wrong(self, found: Found) -> bool:
        """Whether a tool does not agree with what is right; then the command ends with status 1."""
        return any(getattr(row, "agrees", None) is False for rows in found.values() for row in rows)

    @property
    def options(self) -> dict[str, inspect.Parameter]:
        """The settings that can be chosen, with their defaults."""
        parameters = inspect.signature(self.measure).parameters
        return {name: each for name, each in parameters.items() if each.kind is inspect.Parameter.KEYWORD_ONLY}

    def settings(self, **chosen: Any) -> dict[str, Any]:
        """All settings: those chosen, and the others by default."""
        return {name: option.default for name, option in self.options.items()} | chosen

    def report(self, result: Result) -> list[Table | str]:
        """What the command prints: all tables, what their columns are, and which tools did not run."""
        lines = [self.provenance(result), tables.SPREADS]
        for view in self.views:
            rows = [row for row in result.found[view.part] if view.where(row)]
            lines += [*tables.tables(view, rows), *tables.notes(view, rows)]
        lines += tables.about_tools(result.found.values())
        return [line for i, line in enumerate(lines) if line not in lines[:i]]

    def brief(self, result: Result) -> list[Table | str]:
        """What the README shows: some tables, which tools did not run, and where all this was measured."""
        shown = [
            table for view in self.views if view.brief
            for table in tables.tables(view, view.brief([row for row in result.found[view.part] if view.where(row)]))
        ]  # fmt: skip
        return [*shown, " ".join([*tables.about_tools(result.found.values()), f"({self.provenance(result)})"])]

    def figures(self, result: Result, names: Sequence[str] | None = None) -> dict[str, "Figure"]:
        """The pictures by name, all of them or those that are named."""
        chosen = [picture for picture in self.pictures if names is None or picture.name in names]
        return {each.name: pictures.draw(each, result.found[each.part], str(result.machine)) for each in chosen}

    def provenance(self, result: Result) -> str:
        """The command, its settings and the machine, in a line."""
        shown = {name: text(value, "g" if isinstance(value, float) else None) for name, value in result.settings.items()}
        chosen = [f"{name} {shown[name]}" for name, value in result.settings.items() if value is not None]
        return f"`warpsample bench {self.name}`: {', '.join(chosen)}, seed {SEED}; {result.machine}"
