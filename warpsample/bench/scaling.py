"""`bench scaling`: cost per direction and peak memory against points, samples and workers, a process to each case."""

from contextlib import ExitStack
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Annotated

import numpy as np
import typer

from warpsample.bench.child import Child, Job
from warpsample.bench.machine import peak_megabytes
from warpsample.bench.pictures import OURS, THEIRS
from warpsample.bench.record import SEED, Benchmark, Repeats, Track
from warpsample.bench.report import SPREAD, Table, digits, spread
from warpsample.bench.result import Result
from warpsample.bench.timing import Spread, interleave
from warpsample.directions.sample import sample_directions
from warpsample.host.engine import check_workers

if TYPE_CHECKING:
    from matplotlib.figure import Figure

PART = 1 << 20
"""Directions in memory at a time: 12 MB."""
_SAMPLES = 16
_TOTAL = 1 << 22


@dataclass(frozen=True)
class Settings:
    """Of the command."""

    largest: Annotated[int, typer.Option(help="Greatest number of points.", min=1000)] = 100_000_000
    repeats: Repeats = 5


@dataclass(frozen=True)
class Cost:
    """One case: Sobol', the cosine lobe.

    Attributes:
        axis: what varies: "points", "samples" or "workers".
        points: P.
        samples: of each point.
        workers: threads.
        nanoseconds: per direction.
        peak_megabytes: greatest resident memory of the process, Python, Warp and NumPy included; None where unknown.
        seconds: of each repeat; none where they were not kept.
    """

    axis: str
    points: int
    samples: int
    workers: int
    nanoseconds: Spread
    peak_megabytes: float | None
    seconds: list[float] = field(default_factory=list)


@dataclass(frozen=True)
class Found:
    """Of every case."""

    rows: list[Cost]


def cases(largest: int) -> list[tuple[str, int, int, int]]:
    """(axis, points, samples, workers): points from 1,000 to `largest`, samples from 1 to 4096, workers from 1 to all."""
    everyone = check_workers(None)
    workers = sorted({min(2**k, everyone) for k in range(everyone.bit_length() + 1)})
    return [
        *(("points", 10**k, _SAMPLES, everyone) for k in range(3, 10) if 10**k <= largest),
        *(("samples", max(1, min(_TOTAL, largest) // 4**k), 4**k, everyone) for k in range(7)),
        *(("workers", max(1, min(_TOTAL, largest) // 64), 64, w) for w in workers),
    ]


def measure(settings: Settings, track: Track) -> Found:
    """All cases, interleaved: a process each, alive to the end."""
    chosen = cases(settings.largest)
    with ExitStack() as stack:
        children = [
            stack.enter_context(Child(build_stream, points=points, samples=samples, workers=workers))
            for _, points, samples, workers in chosen
        ]
        for child in children:  # so that none is disturbed by another that starts
            child.wait_until_built()
        runs = [child.run for child in children]
        times = list(zip(*(interleave(runs, 1)[0] for _ in track(range(settings.repeats), settings.repeats)), strict=True))
        memory = [child.report()["peak_megabytes"] for child in children]
    rows = []
    for (axis, points, samples, workers), rounds, peak in zip(chosen, times, memory, strict=True):
        seconds = [t for (t,) in rounds]
        each = Spread.of([1e9 * t / (points * samples) for t in seconds])
        rows.append(Cost(axis, points, samples, workers, each, peak, seconds))
    return Found(rows)


def build_stream(points: int, samples: int, workers: int, part: int = PART) -> Job:
    """All directions of `points` points, part by part into one array, about normals that repeat every 65,536."""
    part = min(points, max(1, part // samples))
    normals = np.random.default_rng(SEED).normal(size=(65_536, 3)).astype(np.float32)
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


def tables(result: Result) -> list[Table | str]:
    """A table for each axis."""
    parts: list[Table | str] = [f"Streamed directions of the default, a process to each case: {SPREAD}."]
    for axis in dict.fromkeys(row.axis for row in result.found.rows):
        cells = [
            [f"{row.points:,}", f"{row.samples:,}", str(row.workers), spread(row.nanoseconds), _memory(row)]
            for row in result.found.rows
            if row.axis == axis
        ]
        headings = ["points", "samples", "workers", "ns per direction", "peak memory, MB"]
        parts.append(Table(f"By {axis}", headings, cells))
    return parts


def readme(result: Result) -> list[Table | str]:
    """Time and memory by points, and the rest in words."""
    by_axis = {axis: [row for row in result.found.rows if row.axis == axis] for axis in ("points", "samples", "workers")}
    points = by_axis["points"]
    costs = ", ".join(f"{digits(row.nanoseconds.median)} at {row.samples:,}" for row in by_axis["samples"][::2])
    alone, together = by_axis["workers"][0], by_axis["workers"][-1]
    gain = alone.nanoseconds.median / together.nanoseconds.median
    return [
        (
            f"Sobol' directions of the cosine lobe, streamed in parts, {points[0].samples} samples a point, "
            f"{points[0].workers} workers; memory is that of the whole process, Python and Warp included:"
        ),
        Table(
            "",
            ["points", *(f"{row.points:,}" for row in points)],
            [
                ["ns per direction", *(spread(row.nanoseconds) for row in points)],
                ["peak memory, MB", *(_memory(row) for row in points)],
            ],
        ),
        (
            f"Nanoseconds per direction by samples of a point: {costs}. {together.workers} workers are {gain:.1f} times as "
            "fast as one."
        ),
    ]


def draw(found: Found, caption: str) -> dict[str, "Figure"]:
    """Cost per direction and peak memory against points, samples and workers."""
    from matplotlib.figure import Figure  # noqa: PLC0415

    figure = Figure(figsize=(12.0, 5.5), layout="constrained")
    names = list(dict.fromkeys(row.axis for row in found.rows))
    grid = figure.subplots(2, len(names), sharex="col", squeeze=False)
    for axis, (above, below) in zip(names, grid.T, strict=True):
        mine = [row for row in found.rows if row.axis == axis]
        x = [getattr(row, axis) for row in mine]
        above.vlines(x, [row.nanoseconds.low for row in mine], [row.nanoseconds.high for row in mine], color=OURS)
        above.plot(x, [row.nanoseconds.median for row in mine], "o-", color=OURS, linewidth=0.8)
        below.plot(x, [row.peak_megabytes or 0.0 for row in mine], "o-", color=THEIRS, linewidth=0.8)
        above.set_title(f"by {axis}", fontsize=11)
        below.set_xlabel(axis)
        for axes in (above, below):
            axes.set_xscale("log", base=2 if x[-1] < 1000 else 10)
            axes.set_ylim(0.0, 1.1 * axes.get_ylim()[1])
            axes.grid(alpha=0.3)
    grid[0][0].set_ylabel("time per direction [ns]")
    grid[1][0].set_ylabel("peak memory [MB]")
    figure.supxlabel(caption, fontsize=10)
    return {"scaling": figure}


def _memory(row: Cost) -> str:
    return "–" if row.peak_megabytes is None else f"{row.peak_megabytes:.0f}"


RECORD = Benchmark(
    name="scaling",
    title="Size",
    summary="Cost per direction and peak memory against points, samples and workers, streamed.",
    settings=Settings,
    found=Found,
    measure=measure,
    tables=tables,
    readme=readme,
    figures=draw,
)
