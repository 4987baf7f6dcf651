"""What a benchmark says of itself; the command line, the README and the result files follow from it."""

from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Annotated, Any

import typer

from warpsample.bench.report import Table

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from warpsample.bench.result import Result

SEED = 0
"""Of every benchmark's points, rays and directions."""

Repeats = Annotated[int, typer.Option(help="Timed runs of each case, each after untimed ones.", min=1)]
Track = Callable[[Iterable[Any], int], Iterator[Any]]
"""Passes on items, of which there are so many, and may show how far it has come."""


@dataclass(frozen=True)
class Benchmark:
    """One benchmark.

    Attributes:
        name: of its command and its result files.
        title: of its section in the README.
        summary: one sentence for the command's help.
        settings: a frozen dataclass; its fields, typed as typer takes them, are the command's options.
        found: a frozen dataclass of lists of rows, each row a frozen dataclass of numbers, texts and `Spread`s.
        measure: (settings, track) -> found.
        tables: everything that the command prints, as tables and paragraphs.
        readme: what the README shows of it.
        figures: (found, caption) -> pictures by name.
        pictures: of these, what the README shows: name -> what it says of it.
        wrong: whether something that was found is wrong; then the command ends with status 1.
    """

    name: str
    title: str
    summary: str
    settings: type
    found: type
    measure: Callable[[Any, Track], Any]
    tables: Callable[["Result"], list[Table | str]]
    readme: Callable[["Result"], list[Table | str]]
    figures: Callable[[Any, str], dict[str, "Figure"]]
    pictures: dict[str, str] = field(default_factory=dict)
    wrong: Callable[[Any], bool] = lambda _: False
