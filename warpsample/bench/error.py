"""Error against run time: means of known integrals by every sequence, many times over."""

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from math import log, sqrt
from typing import Any

import numpy as np

from warpsample import sequences
from warpsample.bench.integrands import INTEGRANDS, Integrand
from warpsample.bench.timing import Spread, interleave, stopwatch
from warpsample.directions.means import direction_means
from warpsample.distributions.cosine_hemisphere import CosineHemisphere
from warpsample.host.arrays import cpu
from warpsample.host.engine import check_workers, run

COUNTS = tuple(4**k for k in range(1, 9))
_LEAST_WORK = (
    1 << 21
)  # directions of one timed run, so that small counts have more randomisations instead of a launch's cost
FLOOR = 3e-7
"""Of RMSE: what float32 leaves. The slope is fitted above it, and the efficiency takes what is below for it."""
COMPARED_AT = 1024
"""N of the efficiency."""


@dataclass(frozen=True)
class Point:
    """One sequence at one count.

    Attributes:
        count: N, samples of an estimate.
        randomisations: estimates.
        rmse: root mean square of estimate minus mean.
        microseconds: wall time of one estimate, sampling, evaluation and sum.
        seconds: of each repeat, all randomisations together.
    """

    count: int
    randomisations: int
    rmse: float
    microseconds: Spread
    seconds: list[float]


@dataclass(frozen=True)
class Curve:
    """One sequence on one integrand.

    Attributes:
        integrand: its name.
        kind: "smooth", "discontinuous" or "peaked".
        mean: exact.
        sequence: its name.
        slope: of log RMSE over log N, fitted from N = 16 to where float32 ends it; None if fewer than two points are above.
        points: by N.
        efficiency: 1 / (variance x time) over that of `independent`, at N = 1024 or the greatest below.
    """

    integrand: str
    kind: str
    mean: float
    sequence: str
    slope: float | None
    points: list[Point]
    efficiency: float

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
        if self.slope is None or self.slope >= 0.0 or last.rmse <= FLOOR:
            return None
        return last.microseconds.median * float(np.float_power(rmse / last.rmse, 1.0 / self.slope)), True


def groups(randomisations: int, repeats: int, largest: int) -> list[Callable[[], list[Curve]]]:
    """For each integrand, what measures its curves.

    Args:
        randomisations: at least this many estimates at each count.
        repeats: timed runs.
        largest: the greatest count.
    """
    return [partial(_measure, integrand, randomisations, repeats, largest) for integrand in INTEGRANDS]


def estimates(
    integrand: Integrand, sequence: str, count: int, randomisations: int, seed: int = 0, workers: int | None = None
) -> np.ndarray:
    """(randomisations,) float64: means over `count` directions, each with its own randomisation of the sequence."""
    out = np.empty(randomisations)
    _means(integrand, sequence, count, out, seed, workers)()
    return out


def _means(
    integrand: Integrand, sequence: str, count: int, out: np.ndarray, seed: int, workers: int | None = None
) -> Callable[[], Any]:
    lobe = CosineHemisphere()
    kernel = direction_means(sequences.get(sequence), lobe.about(), integrand.function)
    inputs = [seed, 0, count, out.__array_interface__["data"][0], lobe.kernel_parameters().__ctype__()]
    return partial(run, kernel, len(out), inputs, cpu(), check_workers(workers), len(out) * count)


def _measure(integrand: Integrand, randomisations: int, repeats: int, largest: int) -> list[Curve]:
    names = sequences.names()
    points: dict[str, list[Point]] = {name: [] for name in names}
    for count in (n for n in COUNTS if n <= largest):
        out = np.empty(max(randomisations, _LEAST_WORK // count))
        cases = [stopwatch(_means(integrand, name, count, out, seed=0)) for name in names]
        times, _ = interleave(cases, repeats)
        for name, seconds in zip(names, times, strict=True):
            errors = estimates(integrand, name, count, len(out)) - integrand.mean
            rmse = sqrt(float(np.mean(errors**2)))
            each = Spread.of([1e6 * t / len(out) for t in seconds])
            points[name].append(Point(count, len(out), rmse, each, seconds))
    plain = _efficiency(points["independent"])
    return [
        Curve(
            integrand=integrand.name,
            kind=integrand.kind,
            mean=integrand.mean,
            sequence=name,
            slope=slope(points[name]),
            points=points[name],
            efficiency=_efficiency(points[name]) / plain,
        )
        for name in names
    ]


def _efficiency(points: list[Point]) -> float:
    p = [p for p in points if p.count <= COMPARED_AT][-1]
    return 1.0 / (max(p.rmse, FLOOR) ** 2 * p.microseconds.median)


def slope(points: list[Point]) -> float | None:
    """Least squares in log-log, above the floor of float32."""
    kept = [(log(p.count), log(p.rmse)) for p in points if p.count >= 16 and p.rmse > FLOOR]
    return float(np.polyfit(*np.array(kept).T, 1)[0]) if len(kept) > 1 else None
