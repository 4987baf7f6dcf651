"""Error against run time: means of known integrals by every sequence, many times over."""

from dataclasses import dataclass, field
from math import log, sqrt
from typing import Annotated

import numpy as np
import typer

from warpsample import sequences
from warpsample.bench.integrands import INTEGRANDS, Integrand, estimates, estimator
from warpsample.bench.record import Repeats, Track
from warpsample.bench.timing import Spread, interleave, stopwatch

COUNTS = tuple(4**k for k in range(1, 9))
FLOOR = 3e-7
"""Of RMSE: what float32 leaves. The slope is fitted above it, and the efficiency takes what is below for it."""
COMPARED_AT = 1024
"""N of the efficiency."""
_LEAST_WORK = 1 << 21  # directions of a timed run: small counts take more randomisations, or a launch's cost would be all


@dataclass(frozen=True)
class Settings:
    """Of the command."""

    rmse: Annotated[float, typer.Option(help="The RMSE to state the time to.", min=1e-6, max=1.0)] = 1e-3
    randomisations: Annotated[int, typer.Option(help="Estimates of each mean, at least.", min=64)] = 256
    largest: Annotated[int, typer.Option(help="Greatest number of samples of an estimate.", min=16)] = 65_536
    repeats: Repeats = 7


@dataclass(frozen=True)
class Point:
    """One sequence on one integrand, with one number of samples.

    Attributes:
        integrand: its name.
        sequence: its name.
        count: N, samples of an estimate.
        randomisations: estimates.
        rmse: root mean square of estimate minus mean.
        microseconds: wall time of one estimate: sampling, evaluation and sum.
        seconds: of each repeat, all randomisations together; none where they were not kept.
    """

    integrand: str
    sequence: str
    count: int
    randomisations: int
    rmse: float
    microseconds: Spread
    seconds: list[float] = field(default_factory=list)


@dataclass(frozen=True)
class Found:
    """Of every integrand, sequence and count."""

    points: list[Point]


@dataclass(frozen=True)
class Curve:
    """What the points of one sequence on one integrand say together, by N."""

    points: list[Point]

    @property
    def slope(self) -> float | None:
        """Of log RMSE over log N from N = 16 on, by least squares; None if fewer than two points are above the floor."""
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


def curves(points: list[Point]) -> dict[tuple[str, str], Curve]:
    """By (integrand, sequence)."""
    found: dict[tuple[str, str], list[Point]] = {}
    for point in points:
        found.setdefault((point.integrand, point.sequence), []).append(point)
    return {key: Curve(points) for key, points in found.items()}


def measure(settings: Settings, track: Track) -> Found:
    """Integrand by integrand; the sequences take turns."""
    return Found([point for i in track(INTEGRANDS, len(INTEGRANDS)) for point in _points(i, settings)])


def _points(integrand: Integrand, settings: Settings) -> list[Point]:
    points = []
    for count in (n for n in COUNTS if n <= settings.largest):
        out = np.empty(max(settings.randomisations, _LEAST_WORK // count))
        cases = [stopwatch(estimator(integrand, name, count, out)) for name in sequences.names()]
        times, _ = interleave(cases, settings.repeats)
        for name, seconds in zip(sequences.names(), times, strict=True):
            errors = estimates(integrand, name, count, len(out)) - integrand.mean
            rmse = sqrt(float(np.mean(errors**2)))
            each = Spread.of([1e6 * t / len(out) for t in seconds])
            points.append(Point(integrand.name, name, count, len(out), rmse, each, seconds))
    return points
