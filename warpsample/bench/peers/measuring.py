"""The same task by other tools, side by side: a process each, taking turns."""

from collections.abc import Iterable
from contextlib import ExitStack
from dataclasses import dataclass, field
from math import sqrt
from typing import Annotated, Any

import numpy as np
import typer

from warpsample.bench.child import Child, Failure
from warpsample.bench.integrands import INTEGRANDS, Integrand, estimates
from warpsample.bench.peers.jobs import TASKS
from warpsample.bench.record import SEED, Repeats, Track
from warpsample.bench.timing import Spread, interleave, stopwatch
from warpsample.directions.sample import sample_directions
from warpsample.host.engine import check_workers

_BY_CHANCE = 4.5  # standard errors; with 13 peers and 7 means by chance once in 1,600 runs
_TARGETS = {"sky gradient": 1e-3, "half-space": 3e-3}


@dataclass(frozen=True)
class Settings:
    """Of the command."""

    points: Annotated[int, typer.Option(help="Normals, with 64 directions each; 16 times as many on a mesh.", min=1)] = (
        65_536
    )
    repeats: Repeats = 15


@dataclass(frozen=True)
class Speed:
    """One tool at one task.

    Attributes:
        task: "directions" (cosine lobe, 64 at each point) or "surface" (points on a sphere of 81,920 faces).
        peer: its name; "fill" is NumPy's `out.fill(0)`, the ceiling.
        library: with its version, "" if it did not run.
        threads: that it used.
        million_per_second: directions or points.
        ours: our speed over its, in the same round; None if it did not run.
        worst_deviation: of its means from the exact ones, in standard errors of independent samples.
        agrees: whether that is below 4.5.
        failure: why it did not run, and what to install.
        seconds: of each repeat; none where they were not kept.
    """

    task: str
    peer: str
    library: str
    threads: int
    million_per_second: Spread | None
    ours: Spread | None
    worst_deviation: float | None
    agrees: bool | None
    failure: str | None
    seconds: list[float] = field(default_factory=list)


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


@dataclass(frozen=True)
class Found:
    """Of every tool, and of the times to an error."""

    rows: list[Speed]
    time_to_error: list[ToError]


def measure(settings: Settings, track: Track) -> Found:
    """Both tasks, and the times to an error by the fastest tool."""
    sizes = {"directions": settings.points, "surface": 16 * settings.points}
    rows = [row for task in track(sizes, len(sizes)) for row in compare(task, sizes[task], settings.repeats)]
    return Found(rows, time_to_error(rows, settings.repeats))


def compare(task: str, points: int, repeats: int, chosen: Iterable[str] | None = None) -> list[Speed]:
    """All peers at one task, interleaved.

    Args:
        task: of TASKS.
        points: of the task; for directions there are SAMPLES at each.
        repeats: timed runs.
        chosen: names; by default all.
    """
    workers = check_workers(None)
    build = TASKS[task].build
    peers = [name for name in TASKS[task].peers if chosen is None or name in chosen]
    with ExitStack() as stack:
        children = {peer: stack.enter_context(Child(build, peer=peer, points=points, workers=workers)) for peer in peers}
        failures = {peer: child.wait_until_built() for peer, child in children.items()}
        running = {peer: child for peer, child in children.items() if failures[peer] is None}
        times, _ = interleave([child.run for child in running.values()], repeats)
        seconds = dict(zip(running, times, strict=True))
        reports = {peer: child.report() for peer, child in running.items()}
    return [
        Speed(task, peer, "", 0, None, None, None, None, _remedy(TASKS[task].peers[peer].library, failure), [])
        if failure
        else judge(task, peer, points, workers, seconds, reports[peer])
        for peer, failure in failures.items()
    ]


def judge(task: str, peer: str, points: int, workers: int, seconds: dict[str, list[float]], report: dict[str, Any]) -> Speed:
    """What a peer's times and means come to.

    Args:
        task: of TASKS.
        peer: its name.
        points: of the task.
        workers: threads, of a tool that uses them.
        seconds: of each repeat, of it and of ours.
        report: of its job.
    """
    ours, rounding = TASKS[task].ours, TASKS[task].rounding
    deviations = [
        abs(mean - TASKS[task].exact[name]) / (error + rounding) for name, (mean, error) in report["means"].items()
    ]
    worst = float(np.max(deviations))  # which NaN is, unlike with Python's max
    samples = peer != "fill"
    return Speed(
        task=task,
        peer=peer,
        library=report["library"],
        threads=workers if TASKS[task].peers[peer].threaded else 1,
        million_per_second=Spread.of([points * TASKS[task].each / t / 1e6 for t in seconds[peer]]),
        ours=Spread.of_ratios(seconds[peer], seconds[ours]) if ours in seconds else None,
        worst_deviation=worst if samples else None,
        agrees=worst <= _BY_CHANCE if samples else None,
        failure=None,
        seconds=seconds[peer],
    )


def _remedy(library: str, failure: Failure) -> str:
    if failure.missing:
        return f"not installed: pip install {library}"
    return f"{library} does not work here: {failure.reason}"


def time_to_error(rows: list[Speed], repeats: int, randomisations: int = 1024, largest: int = 1 << 22) -> list[ToError]:
    """Ours against the fastest of the peers in `rows`, those of the directions.

    Args:
        rows: as `compare` gives them.
        repeats: timed runs.
        randomisations: estimates from which an RMSE is computed.
        largest: directions in memory at a time.
    """
    others = [row for row in rows if row.task == "directions" and row.million_per_second and row.agrees]
    others = [row for row in others if not row.peer.startswith("warpsample")]
    if not others:
        return []
    fastest = max(others, key=lambda row: row.million_per_second.median if row.million_per_second else 0.0)
    return [
        _to_error(i, _TARGETS[i.name], fastest, repeats, randomisations, largest) for i in INTEGRANDS if i.name in _TARGETS
    ]


def _to_error(integrand: Integrand, rmse: float, fastest: Speed, repeats: int, randomisations: int, largest: int) -> ToError:
    samples = next(n for n in (2**k for k in range(2, 25)) if _rmse(integrand, "sobol", n, randomisations) <= rmse)
    variance = _rmse(integrand, "independent", 64, randomisations) ** 2 * 64
    independent = variance / rmse**2
    points = max(1, largest // samples)
    normals = np.random.default_rng(SEED).normal(size=(points, 3)).astype(np.float32)
    out = np.empty((points, samples, 3), np.float32)
    (seconds,), _ = interleave([stopwatch(lambda: sample_directions(normals, samples, out=out))], repeats)
    ours = Spread.of([1e6 * t / points for t in seconds])
    theirs = independent / fastest.million_per_second.median if fastest.million_per_second else 0.0
    return ToError(integrand.name, rmse, samples, independent, ours, fastest.peer, theirs, theirs / ours.median)


def _rmse(integrand: Integrand, sequence: str, count: int, randomisations: int) -> float:
    return sqrt(float(np.mean((estimates(integrand, sequence, count, randomisations) - integrand.mean) ** 2)))
