"""`bench peers`: time of other tools to sample 64 cosine-weighted directions at each normal, one process per tool."""

from collections.abc import Iterable
from dataclasses import dataclass
from importlib.metadata import version
from typing import Annotated, Any

import numpy as np
import typer

from warpsample.bench.record import SEED, Benchmark, Picture, Repeats, RowsByPart, TableView, Track
from warpsample.bench.rows import Spread, ToolRow, optional_column
from warpsample.bench.running.child import ChildJob
from warpsample.bench.running.turns import Tool, run_tools
from warpsample.bench.tools.directions import DIRECTIONS
from warpsample.bench.tools.integrands import INTEGRANDS, evaluate
from warpsample.host.engine import check_workers
from warpsample.proof import twins

SAMPLES = 64
_JUDGED = 1 << 20  # directions of the means
_ROUNDING = 1e-9  # absolute rounding error of an exact mean
_MOST_DEVIATION = 4.5  # standard errors; 13 tools with 7 means each exceed this by chance once in 1,600 runs


@dataclass(frozen=True)
class PeerSpeed(ToolRow):
    """Row of `bench peers`: directions per second of one tool, and the deviation of its means."""

    library: str = optional_column("version")
    threads: int = optional_column("threads")
    million_per_second: Spread | None = optional_column("million per second")
    ours: Spread | None = optional_column(
        "warpsample / tool", "speed of independent directions by warpsample over that of the tool, in the same round"
    )
    worst_deviation: float | None = optional_column(
        "worst deviation", "largest deviation of the means of seven integrals from the exact values, in standard errors",
        show=lambda x: f"{x:.1f}{'' if x <= _MOST_DEVIATION else ' WRONG'}")  # fmt: skip
    agrees: bool | None = optional_column("agrees")


def build_directions(tool: str, points: int, workers: int) -> ChildJob:
    """Prepare one tool to sample directions, and return the work to time.

    The job's report judges the means of all integrands.
    """
    normals = np.random.default_rng(SEED).normal(size=(points, 3))
    normals = (normals / np.linalg.norm(normals, axis=1, keepdims=True)).astype(np.float32)
    work, result = DIRECTIONS[tool].make(normals, SAMPLES, workers)
    frames = twins.frames(normals[: max(1, _JUDGED // SAMPLES)].astype(np.float64))

    def report() -> dict[str, Any]:
        d = np.asarray(result()).reshape(points, SAMPLES, 3)[: len(frames)]
        local = np.einsum("nij,nsi->nsj", frames, d).reshape(-1, 3).astype(np.float32)
        return judge(DIRECTIONS[tool], workers, find_worst_deviation([(evaluate(i, local), i.mean) for i in INTEGRANDS]))

    return ChildJob(work, report)


def find_worst_deviation(means: Iterable[tuple[np.ndarray, float]]) -> float:
    """Return the largest deviation of estimates from their exact mean, in standard errors.

    Each pair holds (estimates, exact mean). The result is NaN if an estimate is NaN.
    """
    errors = [
        (v.mean(dtype=np.float64) - exact, v.std(dtype=np.float64) / np.sqrt(len(v)) + _ROUNDING) for v, exact in means
    ]
    return float(np.max([abs(off) / error for off, error in errors]))


def judge(tool: Tool, workers: int, worst: float) -> dict[str, Any]:
    """Return the fields of a row: version, threads, worst deviation in standard errors, and whether the tool agrees."""
    return {
        "library": f"{tool.library} {version(tool.library)}",
        "threads": workers if tool.threaded else 1,
        "worst_deviation": worst,
        "agrees": worst <= _MOST_DEVIATION,
    }


def measure(
    track: Track,
    *,
    points: Annotated[int, typer.Option(help="Number of normals, with 64 directions each.", min=1)] = 65_536,
    repeats: Repeats = 15,
) -> RowsByPart:
    """Measure the sampling speed of all tools, with alternating runs; return the rows."""
    return {"rows": compare(list(track(DIRECTIONS, len(DIRECTIONS))), points, repeats)}


def compare(tools: Iterable[str], points: int, repeats: int) -> list[PeerSpeed]:
    """Measure the sampling speed of the given tools with alternating runs; the first tool is the baseline."""
    turns = run_tools(build_directions, tools, repeats, points=points, workers=check_workers(None))
    baseline = next(iter(turns.seconds.values()))

    def figures(tool: str) -> dict[str, Any]:
        seconds = turns.seconds[tool]
        speed = Spread.of([points * SAMPLES / t / 1e6 for t in seconds])
        return {"million_per_second": speed, "ours": Spread.of_ratios(seconds, baseline), **turns.reports[tool]}

    return turns.rows(PeerSpeed, figures)


_CELLS = "library threads million_per_second ours worst_deviation"

RECORD = Benchmark(
    name="peers",
    summary="Compare directions of the cosine lobe by warpsample, NumPy, Warp's built-ins and Mitsuba.",
    measure=measure,
    parts={"rows": PeerSpeed},
    views=[TableView("rows", "Directions of the cosine lobe, 64 at each normal", "tool", _CELLS)],
    pictures=[Picture("peers", "rows", "million_per_second", y="tool", series="", log="x")],
)
