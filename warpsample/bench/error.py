"""`bench error`: the error of means of known integrals against run time, by every sequence, many times over."""

from collections.abc import Callable
from dataclasses import dataclass
from math import log, sqrt
from typing import Annotated, Any

import numpy as np
import typer

from warpsample import sequences
from warpsample.bench.integrands import INTEGRANDS, KnownIntegral, estimates, estimator
from warpsample.bench.pictures import Picture
from warpsample.bench.record import Benchmark, Found, Repeats, Track
from warpsample.bench.rows import Spread, Timed, column, digits
from warpsample.bench.running.timing import timed
from warpsample.bench.tables import Cell, TableView, grouped

COUNTS = tuple(4**k for k in range(1, 9))
FLOOR = 3e-7
"""The least RMSE that float32 leaves. The slope is fitted above it, and the efficiency takes what is below for it."""
COMPARED_AT = 1024
"""N of the efficiency."""
_LEAST_WORK = 1 << 21  # directions of a timed run: small counts take more randomisations, or a launch's cost would be all


@dataclass(frozen=True)
class ErrorPoint(Timed):
    """One sequence on one integrand, with one number of samples."""

    integrand: str = column("integrand")
    sequence: str = column("sequence")
    count: int = column("N")
    randomisations: int = column("randomisations")
    rmse: float = column("RMSE", show=".1e")
    microseconds: Spread = column("wall time of one estimate, all workers, sampling included [µs]")


_INTEGRANDS = {i.name: f"{i.name} ({i.kind}), mean {i.mean:.6f}" for i in INTEGRANDS}


@dataclass(frozen=True)
class Curve:
    """What the points of one sequence on one integrand say together, by N."""

    integrand: str = column("integrand", show=_INTEGRANDS.get)
    sequence: str = column("sequence")
    points: list[ErrorPoint] = column("points")
    target: float = column("RMSE")
    plain: float = column("efficiency of independent points")

    @property
    def slope(self) -> float | None:
        """The slope of log RMSE over log N from N = 16 on; None if fewer than two points are above the floor."""
        kept = [(log(p.count), log(p.rmse)) for p in self.points if p.count >= 16 and p.rmse > FLOOR]
        return float(np.polyfit(*np.array(kept).T, 1)[0]) if len(kept) > 1 else None

    @property
    def efficiency(self) -> float:
        """1 / (variance x time), at N = 1024 or the greatest below."""
        p = [p for p in self.points if p.count <= COMPARED_AT][-1]
        return 1.0 / (max(p.rmse, FLOOR) ** 2 * p.microseconds.median)

    def reaching(self, rmse: float) -> tuple[float, bool] | None:
        """(microseconds to that RMSE, whether that is beyond the counts measured); None where it never gets there.

        By a line through the two counts around it in log-log; beyond the last with the fitted slope, before the first
        the time of the first.
        """
        for a, b in zip(self.points, self.points[1:], strict=False):
            if a.rmse >= rmse >= b.rmse:
                share = log(a.rmse / rmse) / log(a.rmse / b.rmse) if a.rmse > b.rmse else 0.0
                times = a.microseconds.median, b.microseconds.median
                return times[0] * float(np.float_power(times[1] / times[0], share)), False
        first, last = self.points[0], self.points[-1]
        if rmse > first.rmse:
            return first.microseconds.median, True
        slope = self.slope
        if slope is None or slope >= 0.0 or last.rmse <= FLOOR:
            return None
        return last.microseconds.median * float(np.float_power(rmse / last.rmse, 1.0 / slope)), True

    @property
    def time(self) -> str:
        """The time to the target in words: after a ~ by the slope, beyond the N measured; after a < by the least N."""
        if (reached := self.reaching(self.target)) is None:
            return "never"
        sign = "" if not reached[1] else "<" if self.target > self.points[0].rmse else "~"
        return f"{sign}{digits(reached[0])}"


def curves(points: list[ErrorPoint], rmse: float) -> list[Curve]:
    """A curve for each sequence on each integrand.

    Args:
        points: as they were measured.
        rmse: the RMSE that times are stated to.
    """
    by_case = {key: Curve(*key, mine, rmse, 1.0) for key, mine in grouped(points, "integrand sequence").items()}
    plain = {name: curve.efficiency for (name, sequence), curve in by_case.items() if sequence == "independent"}
    return [Curve(*key, curve.points, rmse, plain.get(key[0], 1.0)) for key, curve in by_case.items()]


def measure(
    track: Track,
    *,
    rmse: Annotated[float, typer.Option(help="The RMSE to state the time to.", min=1e-6, max=1.0)] = 1e-3,
    randomisations: Annotated[int, typer.Option(help="Estimates of each mean, at least.", min=64)] = 256,
    largest: Annotated[int, typer.Option(help="Greatest number of samples of an estimate.", min=16)] = 65_536,
    repeats: Repeats = 7,
) -> Found:
    """KnownIntegral by integrand; the sequences take turns."""
    cases = [_points(i, randomisations, largest, repeats) for i in track(INTEGRANDS, len(INTEGRANDS))]
    return {"points": [point for points in cases for point in points]}


def _points(integrand: KnownIntegral, randomisations: int, largest: int, repeats: int) -> list[ErrorPoint]:
    points = []
    for count in (n for n in COUNTS if n <= largest):
        out = np.empty(max(randomisations, _LEAST_WORK // count))
        works = {name: estimator(integrand, name, count, out) for name in sequences.names()}
        for name, seconds in timed(works, repeats).items():
            errors = estimates(integrand, name, count, len(out)) - integrand.mean
            rmse = sqrt(float(np.mean(errors**2)))
            each = Spread.of([1e6 * t / len(out) for t in seconds])
            points.append(ErrorPoint(integrand.name, name, count, len(out), rmse, each, seconds=seconds))
    return points


def _first(show: Callable[[Curve], str]) -> Callable[[list[Curve]], str]:
    return lambda rows: show(rows[0])


def _cells(rows: list[Curve]) -> list[Cell]:
    """RMSEs by every second N, and what the curve says."""
    points = rows[0].points
    return [
        *(Cell(_first(lambda c, i=i: f"{c.points[i].rmse:.1e}"), f"N = {points[i].count:,}")
          for i in range(1, len(points), 2)),
        Cell(_first(lambda c: "–" if c.slope is None else f"{c.slope:.2f}"), "slope"),
        Cell(_first(lambda c: digits(c.points[-1].microseconds.median)), f"µs at {points[-1].count:,}"),
        Cell(_first(lambda c: c.time), f"µs to {rows[0].target:g}"),
        Cell(_first(lambda c: digits(c.efficiency / c.plain)), "efficiency"),
    ]  # fmt: skip


def _in_short(rows: list[Curve]) -> list[Cell]:
    """The time to the target by each sequence, and the fastest."""
    names = list(dict.fromkeys(row.sequence for row in rows))
    return [
        *(Cell(lambda mine, name=name: next(c.time for c in mine if c.sequence == name), name) for name in names),
        Cell(_fastest, "fastest"),
    ]


def _fastest(rows: list[Any]) -> str:
    times = {row.sequence: reached[0] for row in rows if (reached := row.reaching(row.target))}
    return min(times, key=times.__getitem__) if times else "–"


RECORD = Benchmark(
    name="error",
    summary="RMSE against run time: every sequence on seven integrands of known mean, from 4 samples on.",
    measure=measure,
    parts={"points": ErrorPoint},
    derived=lambda found, settings: {"curves": curves(found["points"], settings["rmse"])},
    views=[
        TableView("curves", "RMSE of means over the cosine lobe", "sequence", _cells, split="integrand", brief=None),
        TableView("curves", "In short: µs of one estimate to the RMSE asked for", "integrand", _in_short),
    ],
    notes=[
        f"slope: of log RMSE over log N from 16 on, above float32's floor of {FLOOR:g}. ~: by that slope, beyond those.",
        f"<: reached by the least N. efficiency: 1/(variance x time) at N = {COMPARED_AT:,} over that of independent.",
    ],
    pictures=[
        Picture("error", "points", "microseconds", y="rmse", panels="integrand", series="sequence", log="xy"),
    ],
)
