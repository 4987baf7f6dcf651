"""Cost per direction and peak memory against points, samples and workers; points are streamed, a process to each case."""

from collections.abc import Iterator
from contextlib import ExitStack
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from warpsample.bench.child import Child, Job
from warpsample.bench.timing import Spread, interleave
from warpsample.directions.sample import sample_directions
from warpsample.host.engine import check_workers

_PART = 1 << 20  # directions in memory at a time: 12 MB
_SAMPLES = 16
_TOTAL = 1 << 22


@dataclass(frozen=True)
class Row:
    """One case: Sobol', the cosine lobe.

    Attributes:
        axis: what varies: "points", "samples" or "workers".
        points: P.
        samples: of each point.
        workers: threads.
        nanoseconds: per direction.
        peak_megabytes: greatest resident memory of the process, Python, Warp and NumPy included; None where unknown.
        seconds: of each repeat.
    """

    axis: str
    points: int
    samples: int
    workers: int
    nanoseconds: Spread
    peak_megabytes: float | None
    seconds: list[float]


def cases(largest: int) -> list[tuple[str, int, int, int]]:
    """(axis, points, samples, workers): points from 1,000 to `largest`, samples from 1 to 4096, workers from 1 to all."""
    everyone = check_workers(None)
    workers = sorted({min(2**k, everyone) for k in range(everyone.bit_length() + 1)})
    return [
        *(("points", 10**k, _SAMPLES, everyone) for k in range(3, 10) if 10**k <= largest),
        *(("samples", max(1, min(_TOTAL, largest) // 4**k), 4**k, everyone) for k in range(7)),
        *(("workers", max(1, min(_TOTAL, largest) // 64), 64, w) for w in workers),
    ]


def measure(largest: int, repeats: int) -> Iterator[Row]:
    """All cases, interleaved: a process each, alive to the end.

    Args:
        largest: points.
        repeats: timed runs of each.
    """
    chosen = cases(largest)
    with ExitStack() as stack:
        children = [
            stack.enter_context(Child("warpsample.bench.scaling:stream", points=p, samples=s, workers=w))
            for _, p, s, w in chosen
        ]
        times, _ = interleave([child.run for child in children], repeats)
        for (axis, points, samples, workers), child, seconds in zip(chosen, children, times, strict=True):
            each = Spread.of([1e9 * t / (points * samples) for t in seconds])
            yield Row(axis, points, samples, workers, each, child.report()["peak_megabytes"], seconds)


def stream(points: int, samples: int, workers: int) -> Job:
    """All directions of `points` points, part by part into one array, about normals that repeat every 65,536."""
    part = min(points, max(1, _PART // samples))
    normals = np.random.default_rng(0).normal(size=(65_536, 3)).astype(np.float32)
    normals = np.resize(normals, (part, 3)) if part > len(normals) else normals[:part]
    out = np.empty((part, samples, 3), np.float32)

    def sample(end: int) -> None:
        for start in range(0, end, part):
            size = min(part, end - start)
            sample_directions(normals[:size], samples, first_point=start, out=out[:size], workers=workers)

    return Job(
        work=lambda: sample(points),
        warm=lambda: sample(min(points, 4 * part)),
        report=lambda: {"peak_megabytes": peak_megabytes()},
    )


def peak_megabytes() -> float | None:
    """The greatest resident memory of this process so far; None on a system that does not say."""
    status = Path("/proc/self/status")
    if status.is_file():  # getrusage counts what the parent held when it started this process, too
        return next(float(line.split()[1]) * 1024 / 1e6 for line in status.read_text().splitlines() if "VmHWM" in line)
    try:
        import resource  # noqa: PLC0415  (not on Windows)
    except ModuleNotFoundError:
        return None
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1e6  # bytes on macOS
