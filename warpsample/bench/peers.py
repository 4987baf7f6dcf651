"""The same job by other tools, side by side: a process each, taking turns."""

from contextlib import ExitStack
from dataclasses import dataclass
from math import sqrt
from typing import Any

import numpy as np

from warpsample.bench import error, peer_jobs
from warpsample.bench.child import Child
from warpsample.bench.integrands import INTEGRANDS, Integrand
from warpsample.bench.timing import Spread, interleave, stopwatch
from warpsample.directions.sample import sample_directions
from warpsample.host.engine import check_workers

SAMPLES = 64
JOBS = ("directions", "surface")
OURS = {"directions": "warpsample independent", "surface": "warpsample surface"}
"""What the others' ratios are taken over."""
_BY_CHANCE = 4.5  # standard errors; with 13 peers and 7 means by chance once in 1,600 runs
_TARGETS = {"sky gradient": 1e-3, "half-space": 3e-3}
_RANDOMISATIONS = 1024
_MOST = 1 << 22  # directions in memory at a time


@dataclass(frozen=True)
class Row:
    """One tool at one job.

    Attributes:
        job: "directions" (cosine lobe, 64 at each point) or "surface" (points on a sphere of 81,920 faces).
        peer: its name; "fill" is NumPy's `out.fill(0)`, the ceiling.
        library: with its version, "" if it did not run.
        threads: that it used.
        million_per_second: directions or points.
        ours: our speed, `OURS`, over its, in the same round; None if it did not run.
        worst_deviation: of its means from the exact ones, in standard errors of independent samples.
        agrees: whether that is below 4.5.
        failure: why it did not run, and what to install.
        seconds: of each repeat.
    """

    job: str
    peer: str
    library: str
    threads: int
    million_per_second: Spread | None
    ours: Spread | None
    worst_deviation: float | None
    agrees: bool | None
    failure: str | None
    seconds: list[float]


@dataclass(frozen=True)
class ToError:
    """Time to an RMSE at one point: ours by default settings, the others by independent samples.

    Attributes:
        integrand: its name.
        rmse: asked for.
        samples: that the default needs: the least power of two that is good enough.
        independent_samples: variance / rmse^2.
        microseconds: ours, of `sample_directions(normals, samples)`, sampling alone.
        peer: the fastest other that ran.
        peer_microseconds: its time for the independent samples, sampling alone.
        ratio: the peer's time over ours.
    """

    integrand: str
    rmse: float
    samples: int
    independent_samples: float
    microseconds: Spread
    peer: str
    peer_microseconds: float
    ratio: float


def measure(job: str, points: int, repeats: int, chosen: list[str] | None = None) -> list[Row]:
    """All peers of one job, interleaved, in the order of `peer_jobs.names`.

    Args:
        job: of JOBS.
        points: of the job; a direction job has SAMPLES at each.
        repeats: timed runs.
        chosen: names; by default all.
    """
    workers = check_workers(None)
    size = {"points": points, "count": SAMPLES} if job == "directions" else {"points": points}
    peers = [name for name in peer_jobs.names(job) if chosen is None or name in chosen]
    with ExitStack() as stack:
        children = {
            peer: stack.enter_context(Child(f"{peer_jobs.__name__}:{job}", peer=peer, workers=workers, **size))
            for peer in peers
        }
        running = {peer: child for peer, child in children.items() if child.failure is None}
        times, _ = interleave([child.run for child in running.values()], repeats)
        seconds = dict(zip(running, times, strict=True))
        reports = {peer: child.report() for peer, child in running.items()}
    work = points * SAMPLES if job == "directions" else points
    return [
        _row(job, peer, work, workers, seconds, reports[peer])
        if peer in running
        else Row(job, peer, "", 0, None, None, None, None, _remedy(peer, children[peer]), [])
        for peer in peers
    ]


def _row(job: str, peer: str, work: int, workers: int, seconds: dict[str, list[float]], report: dict[str, Any]) -> Row:
    exact = {i.name: i.mean for i in INTEGRANDS} | {"x": 0.0, "x^2": 1.0 / 3.0, "z^2": 1.0 / 3.0}
    # The faceted sphere lies within 1e-4 of the round one, so its means do.
    rounding = 1e-4 if job == "surface" else 1e-9
    deviations = [abs(mean - exact[name]) / (error_ + rounding) for name, (mean, error_) in report["means"].items()]
    worst = float(np.max(deviations))  # which NaN is, unlike with Python's max
    samples = peer != "fill"
    return Row(
        job=job,
        peer=peer,
        library=report["library"],
        threads=1 if peer in peer_jobs.SINGLE_THREADED else workers,
        million_per_second=Spread.of([work / t / 1e6 for t in seconds[peer]]),
        ours=Spread.of_ratios(seconds[peer], seconds[OURS[job]]) if OURS[job] in seconds else None,
        worst_deviation=worst if samples else None,
        agrees=worst <= _BY_CHANCE if samples else None,
        failure=None,
        seconds=seconds[peer],
    )


def _remedy(peer: str, child: Child) -> str:
    library = peer_jobs.library_of(peer)
    if child.missing:
        return f"not installed: pip install {library}"
    return f"{library} does not work here: {child.failure}"


def time_to_error(rows: list[Row], repeats: int) -> list[ToError]:
    """Ours against the fastest of the peers in `rows`, those of the direction job."""
    others = [row for row in rows if row.job == "directions" and row.million_per_second and row.agrees]
    others = [row for row in others if not row.peer.startswith("warpsample")]
    if not others:
        return []
    fastest = max(others, key=lambda row: row.million_per_second.median if row.million_per_second else 0.0)
    return [_to_error(i, _TARGETS[i.name], fastest, repeats) for i in INTEGRANDS if i.name in _TARGETS]


def _to_error(integrand: Integrand, rmse: float, fastest: Row, repeats: int) -> ToError:
    samples = next(n for n in (2**k for k in range(2, 25)) if _rmse(integrand, "sobol", n) <= rmse)
    variance = _rmse(integrand, "independent", 64) ** 2 * 64
    independent = variance / rmse**2
    points = max(1, _MOST // samples)
    normals = np.random.default_rng(0).normal(size=(points, 3)).astype(np.float32)
    out = np.empty((points, samples, 3), np.float32)
    (seconds,), _ = interleave([stopwatch(lambda: sample_directions(normals, samples, out=out))], repeats)
    ours = Spread.of([1e6 * t / points for t in seconds])
    theirs = independent / fastest.million_per_second.median if fastest.million_per_second else 0.0
    return ToError(integrand.name, rmse, samples, independent, ours, fastest.peer, theirs, theirs / ours.median)


def _rmse(integrand: Integrand, sequence: str, count: int) -> float:
    return sqrt(float(np.mean((error.estimates(integrand, sequence, count, _RANDOMISATIONS) - integrand.mean) ** 2)))
