"""`bench scaling`: time per direction and peak memory for different numbers of points, samples and workers."""

from dataclasses import dataclass
from typing import Annotated

import numpy as np
import typer

from warpsample.bench.record import SEED, Benchmark, Picture, Repeats, RowsByPart, TableView, Track
from warpsample.bench.rows import Spread, Timed, column
from warpsample.bench.running.child import ChildJob
from warpsample.bench.running.machine import measure_peak_megabytes
from warpsample.bench.running.turns import run_tools
from warpsample.directions.sample import sample_directions
from warpsample.host.engine import check_workers

PART = 1 << 20  # directions in memory at a time: 12 MB
_SAMPLES = 16
_TOTAL = 1 << 22


@dataclass(frozen=True)
class ScaledCost(Timed):
    """Row of `bench scaling`: time and memory to sample cosine-weighted directions in one case.

    The directions are computed in parts.
    """

    axis: str = column("varied")
    points: int = column("points")
    samples: int = column("samples", "samples per point")
    workers: int = column("workers")
    nanoseconds: Spread = column("ns per direction")
    peak_megabytes: float | None = column(
        "peak memory, MB", "peak memory of the process, with Python, Warp and NumPy", show=".0f"
    )


def list_cases(largest: int) -> list[tuple[str, int, int, int]]:
    """Return the cases to measure as tuples (axis, points, samples, workers); `axis` names the varied number.

    The points vary from 1,000 to `largest`, the samples from 1 to 4,096, and the workers from 1 to all.
    """
    everyone = check_workers(None)
    workers = sorted({min(2**k, everyone) for k in range(everyone.bit_length() + 1)})
    return [
        *(("points", 10**k, _SAMPLES, everyone) for k in range(3, 10) if 10**k <= largest),
        *(("samples", max(1, min(_TOTAL, largest) // 4**k), 4**k, everyone) for k in range(7)),
        *(("workers", max(1, min(_TOTAL, largest) // 64), 64, w) for w in workers),
    ]


def measure(
    track: Track,
    *,
    largest: Annotated[int, typer.Option(help="Maximum number of points.", min=1000)] = 100_000_000,
    repeats: Repeats = 5,
) -> RowsByPart:
    """Measure the computation of directions in all cases alternately, with one process for each case."""
    chosen = list_cases(largest)
    turns = run_tools(build_stream, track(chosen, len(chosen)), repeats)
    rows = []
    for case, times in turns.require_all().items():
        each = Spread.of([1e9 * t / (case[1] * case[2]) for t in times])
        rows.append(ScaledCost(*case, each, turns.reports[case]["peak_megabytes"], seconds=times))
    return {"rows": rows}


def build_stream(tool: tuple[str, int, int, int], part: int = PART) -> ChildJob:
    """Prepare the sampling of all directions of a case, part by part into one array, and return the work to time.

    The normals repeat every 65,536 points.
    """
    _, points, samples, workers = tool
    part = min(points, max(1, part // samples))
    normals = np.random.default_rng(SEED).normal(size=(65_536, 3)).astype(np.float32)
    normals = np.resize(normals, (part, 3)) if part > len(normals) else normals[:part]
    out = np.empty((part, samples, 3), np.float32)

    def sample(end: int) -> None:
        for start in range(0, end, part):
            size = min(part, end - start)
            sample_directions(normals[:size], samples, first_point=start, out=out[:size], workers=workers)

    return ChildJob(
        work=lambda: sample(points),
        warm=lambda: sample(min(points, 4 * part)),
        report=lambda: {"peak_megabytes": measure_peak_megabytes()},
    )


def _get_varied(row: ScaledCost) -> int:
    return getattr(row, row.axis)


def _select_for_page(rows: list[ScaledCost]) -> list[ScaledCost]:
    chosen = {"points": (1000, 100_000, 100_000_000), "samples": (1, 64, 4096)}
    return [row for row in rows if row.axis == "workers" or _get_varied(row) in chosen[row.axis]]


RECORD = Benchmark(
    name="scaling",
    summary="Measure the cost per direction and the peak memory against points, samples and threads.",
    measure=measure,
    parts={"rows": ScaledCost},
    views=[
        TableView(
            "rows",
            "Cost against size",
            "axis points samples workers",
            "nanoseconds peak_megabytes",
            page_rows=_select_for_page,
        )
    ],
    pictures=[Picture("scaling", "rows", _get_varied, y="nanoseconds peak_megabytes", series="", panels="axis", log="x")],
)
