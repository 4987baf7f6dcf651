"""`bench error`: error of the means of known integrals compared with run time, for every sequence."""

from dataclasses import dataclass
from itertools import pairwise
from math import log, sqrt
from typing import Annotated

import numpy as np
import typer

from warpsample import sequences
from warpsample.bench.record import Benchmark, Picture, Repeats, RowsByPart, Track
from warpsample.bench.reporting.tables import TableView, group_rows
from warpsample.bench.rows import Spread, Timed, column, format_digits
from warpsample.bench.running.timing import time_interleaved
from warpsample.bench.tools.integrands import INTEGRANDS, KnownIntegral, build_estimator, compute_estimates

COUNTS = tuple(4**k for k in range(1, 9))
FLOOR = 3e-7  # smallest RMSE in float32; the slope is fitted above this RMSE
_LEAST_WORK = (
    1 << 21
)  # minimum directions of a timed run: small counts need more randomisations to hide the cost of a launch


@dataclass(frozen=True)
class ErrorPoint(Timed):
    """Row of `bench error`: error and run time of one sequence on one integrand with one number of samples."""

    integrand: str = column("integrand")
    sequence: str = column("sequence")
    count: int = column("N")
    randomisations: int = column("randomisations")
    rmse: float = column("RMSE", show=".1e")
    microseconds: Spread = column("run time of one estimate, all workers, sampling included [µs]")


_INTEGRANDS = {i.name: f"{i.name} ({i.kind}), mean {i.mean:.6f}" for i in INTEGRANDS}


@dataclass(frozen=True)
class TimeToTarget:
    """Row of `bench error`: time that one sequence takes to reach a target RMSE on one integrand."""

    integrand: str = column("integrand", show=_INTEGRANDS.get)
    sequence: str = column("sequence")
    rmse: float = column("RMSE", show="to an RMSE of {:g}".format)
    time: str = column(
        "µs",
        "~ marks a time extrapolated by the slope of the curve, beyond the measured N; < marks the time of the smallest N",
    )


def fit_slope(points: list[ErrorPoint]) -> float | None:
    """Fit the convergence rate of a sequence: the slope of log RMSE over log N for N >= 16.

    Return None with fewer than two points above the floor.
    """
    logarithms = [(log(p.count), log(p.rmse)) for p in points if p.count >= 16 and p.rmse > FLOOR]
    return float(np.polyfit(*np.array(logarithms).T, 1)[0]) if len(logarithms) > 1 else None


def estimate_time(points: list[ErrorPoint], rmse: float) -> tuple[float, bool] | None:
    """Return the time to reach an RMSE: (microseconds, True if extrapolated beyond the measured sample counts).

    Return None if the RMSE is out of reach. Between two counts, interpolate linearly in logarithms. Beyond the last count,
    extrapolate by the fitted slope. Below the first count, return the time of the first count.
    """
    for a, b in pairwise(points):
        if a.rmse >= rmse >= b.rmse:
            share = log(a.rmse / rmse) / log(a.rmse / b.rmse) if a.rmse > b.rmse else 0.0
            times = a.microseconds.median, b.microseconds.median
            return times[0] * float(np.float_power(times[1] / times[0], share)), False
    first, last = points[0], points[-1]
    if rmse > first.rmse:
        return first.microseconds.median, True
    slope = fit_slope(points)
    if slope is None or slope >= 0.0 or last.rmse <= FLOOR:
        return None
    return last.microseconds.median * float(np.float_power(rmse / last.rmse, 1.0 / slope)), True


def list_times(points: list[ErrorPoint], rmse: float) -> list[TimeToTarget]:
    """Return the rows with the time of each sequence to reach an RMSE on each integrand."""
    rows = []
    for case, group in group_rows(points, "integrand sequence").items():
        time = estimate_time(group, rmse)
        sign = "" if time and not time[1] else "<" if rmse > group[0].rmse else "~"
        rows.append(TimeToTarget(*case, rmse, f"{sign}{format_digits(time[0])}" if time else "never"))
    return rows


def measure(
    track: Track,
    *,
    rmse: Annotated[
        float, typer.Option(help="Target RMSE of the table of times, for example 0.001.", min=1e-6, max=1.0)
    ] = 1e-3,
    randomisations: Annotated[int, typer.Option(help="Minimum number of estimates of each mean.", min=64)] = 256,
    largest: Annotated[int, typer.Option(help="Maximum number of samples of an estimate.", min=16)] = 65_536,
    repeats: Repeats = 7,
) -> RowsByPart:
    """Measure the errors and times of all sequences, one integrand after the other; the sequences alternate."""
    cases = [_measure_integrand(i, randomisations, largest, repeats) for i in track(INTEGRANDS, len(INTEGRANDS))]
    points = [point for points in cases for point in points]
    return {"points": points, "times": list_times(points, rmse)}


def _measure_integrand(integrand: KnownIntegral, randomisations: int, largest: int, repeats: int) -> list[ErrorPoint]:
    points = []
    for count in (n for n in COUNTS if n <= largest):
        out = np.empty(max(randomisations, _LEAST_WORK // count))
        works = {name: build_estimator(integrand, name, count, out) for name in sequences.names()}
        for name, seconds in time_interleaved(works, repeats).items():
            errors = compute_estimates(integrand, name, count, len(out)) - integrand.mean
            rmse = sqrt(float(np.mean(errors**2)))
            each = Spread.of([1e6 * t / len(out) for t in seconds])
            points.append(ErrorPoint(integrand.name, name, count, len(out), rmse, each, seconds=seconds))
    return points


RECORD = Benchmark(
    name="error",
    summary="Measure the root mean square error against run time of every sequence, on seven integrands of known mean.",
    measure=measure,
    parts={"points": ErrorPoint, "times": TimeToTarget},
    views=[TableView("times", "µs of one estimate", "integrand", "time", across="sequence", split="rmse")],
    pictures=[Picture("error", "points", "microseconds", y="rmse", panels="integrand", series="sequence", log="xy")],
)
