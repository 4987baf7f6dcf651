"""What a tool must offer to be measured beside the others."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

Built = tuple[Callable[[], object], Callable[[], Any]]
"""Work, and what gives the result of the last run."""


@dataclass(frozen=True)
class Peer:
    """A tool at a task.

    Attributes:
        library: the package to install for it.
        build: (what to sample on, how many, ..., threads) -> its work and result.
        threaded: whether it uses more than one thread.
    """

    library: str
    build: Callable[..., Built]
    threaded: bool = True


def keeping_last(run: Callable[[], Any]) -> Built:
    """Work that keeps its last result."""
    last: list[Any] = []

    def work() -> None:
        last[:] = [run()]

    return work, lambda: last[0]
