"""Progress bar and final report of a command that computes its points or tiles part by part.

Points, texels, tiles of rasters and chunks of stores use the same record.
"""

import warnings
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from operator import add
from time import perf_counter
from typing import Any

import numpy as np

from warpsample.estimate.quantities.record import Quantity
from warpsample.host.progress import run_display

SUMMARY = np.dtype(
    [(name, np.int64) for name in ("points", "rays", "known")]
    + [(name, np.float64) for name in ("squared_error", "sum", "low", "high")]
    + [("missed", "U200")]
)
"""Summary of a part: numbers of points, of rays and of points with a value; over these points the sum of the squared
standard errors, the sum, the lowest and the highest value; and the warning of a missed tolerance, or ""."""

EMPTY = np.array((0, 0, 0, 0.0, 0.0, np.inf, -np.inf, ""), SUMMARY)[()]
"""Summary of no points, to which others are added."""


def summarize(
    value: np.ndarray, error: np.ndarray, rays: int, known: np.ndarray | None = None, *, vectors: bool = False
) -> np.void:
    """Return the number, sums and range of some computed values, as a NumPy record of dtype SUMMARY.

    Args:
        value: (P,) or (P, C) values. Components, such as colours, are summarized by their mean.
        error: Standard errors of the same shape.
        rays: Number of rays of the part.
        known: (P,) bool, points with a value. Default: None, points whose value is finite.
        vectors: Whether values are vectors, which are summarized by their length.
    """
    rows = np.asarray(value, np.float64).reshape(len(value), -1)
    number = np.linalg.norm(rows, axis=1) if vectors else rows.mean(axis=1)
    good = np.isfinite(number) if known is None else known
    squares = np.square(np.asarray(error, np.float64)).reshape(len(error), -1).mean(axis=1)[good]
    number = number[good]
    ends = number.min(initial=np.inf), number.max(initial=-np.inf)
    return np.array((len(value), rays, len(number), squares.sum(), number.sum(), *ends, ""), SUMMARY)[()]


def summarize_result(found: Any, vectors: bool = False) -> np.void:
    """Return the number, sums and range of a result's values, as a NumPy record of dtype SUMMARY; see `summarize`."""
    rays = int(found.rays.sum(dtype=np.int64))
    return summarize(found.value, found.standard_error, rays, found.status == 0, vectors=vectors)


@dataclass(eq=False)
class RunRecord:
    """Progress bar and running totals of a command that computes its points or tiles part by part.

    Attributes:
        title: Name of the quantity.
        unit: Unit of the values, or "".
        total: Number of things to compute.
        things: Name of the things that the bar and the messages count, such as "points" or "tiles".
        vectors: Whether values are vectors, which are summarized by their length.
        done: Number of things that are complete.
        there: Number of things that were complete before this run.
        sums: Sums over the parts, of dtype SUMMARY.
    """

    title: str
    unit: str = ""
    total: int = 0
    things: str = "points"
    vectors: bool = False
    done: int = 0
    there: int = 0
    sums: np.void = field(default_factory=EMPTY.copy)
    _start: float = field(default_factory=perf_counter)
    _first: float = field(default_factory=perf_counter)
    _computing: float = 0.0
    _bar: Any = None

    @classmethod
    def of(cls, quantity: Quantity, things: str = "points") -> "RunRecord":
        """Build the record of a command that computes a quantity; `things` are "points" or "tiles"."""
        return cls(quantity.title, quantity.unit, things=things, vectors=quantity.is_vector)

    @contextmanager
    def show(self, step: str) -> Iterator["RunRecord"]:
        """Show a bar on stderr within a `with` statement, if stderr is a terminal; `step` names the first step."""
        from rich.console import Console
        from rich.progress import BarColumn, Progress, TextColumn, TimeRemainingColumn

        console = Console(stderr=True)
        columns = TextColumn("{task.description}"), BarColumn(), TimeRemainingColumn(), TextColumn("{task.fields[state]}")
        bar = Progress(*columns, console=console, disable=not console.is_terminal, transient=True)
        bar.add_task(step, total=None, state="")
        self._bar = bar
        with run_display(bar):
            yield self

    @contextmanager
    def count(self, total: int, left: str) -> Iterator[None]:
        """Measure the time of the computation within a `with` statement; an interrupt reports how much is done.

        Args:
            total: Number of things to compute.
            left: Clause on the files that an interrupted run leaves.
        """
        self.total, self._first = total, perf_counter()
        self._update()
        try:
            yield
        except KeyboardInterrupt as interrupt:  # the same exception is raised again: it may represent another signal
            interrupt.args = (f"interrupted after {self.done:,} of {total:,} {self.things}; {left}",)
            raise
        finally:
            self._computing += perf_counter() - self._first

    def skip(self, there: int) -> None:
        """Count tiles or points that an earlier, interrupted command completed as done in the progress bar."""
        self.there, self._first = there, perf_counter()
        self.advance(there)

    def advance(self, count: int) -> None:
        """Count further points or tiles as complete, and move the progress bar."""
        self.done += count
        self._update()

    def add(self, part: np.void, count: int | None = None) -> None:
        """Add the counts and sums of a computed part to the totals, and advance the progress bar.

        The bar advances by `count` points or tiles, by default by the number of points in the part. The first part that
        misses the tolerance is reported by a warning: parts may come from several processes.
        """
        if part["missed"] and not self.sums["missed"]:
            warnings.warn(str(part["missed"]), stacklevel=5)
        for name in SUMMARY.names or ():
            join = {"low": min, "high": max, "missed": max}.get(name, add)
            self.sums[name] = join(self.sums[name], part[name])
        self.advance(int(part["points"]) if count is None else count)

    def _update(self) -> None:
        """Show the number of complete things, the speed and the standard error in the bar."""
        if self._bar is not None:
            task = self._bar.task_ids[0]
            speed = f"{self._speed(perf_counter() - self._first):.1f} million rays/s, " if self.sums["rays"] else ""
            state = f"{speed}standard error {self.error:.2g}" if self.sums["known"] else ""
            title = f"{self.title}, {self.things}"
            self._bar.update(task, description=title, total=self.total, completed=min(self.done, self.total), state=state)

    @property
    def error(self) -> float:
        """Root mean square of the standard errors of all points with a value."""
        return float(np.sqrt(self.sums["squared_error"] / max(1, int(self.sums["known"]))))

    def _speed(self, seconds: float) -> float:
        """Return the speed in million rays per second."""
        return float(self.sums["rays"]) / max(seconds, 1e-9) / 1e6

    def describe(self, values_of: str = "") -> list[str]:
        """Return the report of a finished run: mean, range, standard error, rays and time, in lines.

        Sums cover this run alone. So a resumed run reports the mean of the other points or tiles. `values_of` is put before
        the mean to tell which values it covers.
        """
        lines = [f"{self.there:,} of the {self.total:,} {self.things} were complete before"] if self.there else []
        rays, known = int(self.sums["rays"]), int(self.sums["known"])
        if known:
            error = f"; standard error {self.error:.2g}, root mean square over the points" if self.error or rays else ""
            others = f"for the other {self.things}: " if self.there else values_of
            lines += [f"{others}{self._values(known)}{error}"]
        took = f"took {perf_counter() - self._start:.2f} s, with reading, compiling and writing"
        if rays:
            speed = self._speed(self._computing)
            lines += [f"{rays:,} rays cast in {self._computing:.2f} s, {speed:.1f} million a second"]
        return [*lines, took]

    def _values(self, known: int) -> str:
        """Return the mean and the range of all computed values as text."""
        unit = f" {self.unit}" if self.unit else ""
        mean, low, high = float(self.sums["sum"]) / known, float(self.sums["low"]), float(self.sums["high"])
        return f"mean {mean:.4f}{unit}, from {low:.4g} to {high:.4g}"
