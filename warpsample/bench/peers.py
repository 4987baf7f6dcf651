"""`bench peers`: 64 directions of the cosine lobe about each normal by other tools, a process each, taking turns."""

from collections.abc import Iterable
from dataclasses import dataclass
from importlib.metadata import version
from typing import Annotated, Any

import numpy as np
import typer

from warpsample.bench.record import SEED, Benchmark, Found, Picture, Repeats, TableView, Track
from warpsample.bench.rows import Spread, ToolRow, maybe
from warpsample.bench.running.child import ChildJob
from warpsample.bench.running.turns import Tool, take_turns
from warpsample.bench.tools.directions import DIRECTIONS
from warpsample.bench.tools.integrands import INTEGRANDS, evaluate
from warpsample.host.engine import check_workers
from warpsample.proof import twins

SAMPLES = 64
_JUDGED = 1 << 20  # directions whose means are taken
_ROUNDING = 1e-9  # of an exact mean
_BY_CHANCE = 4.5  # standard errors; with 13 peers and 7 means by chance once in 1,600 runs


@dataclass(frozen=True)
class PeerSpeed(ToolRow):
    """One tool's speed and its means."""

    library: str = maybe("version")
    threads: int = maybe("threads")
    million_per_second: Spread | None = maybe("million a second")
    ours: Spread | None = maybe("ours / it", "the speed of independent directions by warpsample over its")
    worst_deviation: float | None = maybe(
        "off by", "the worst of the means of seven integrals, in standard errors from the exact value",
        show=lambda x: f"{x:.1f}{'' if x <= _BY_CHANCE else ' WRONG'}")  # fmt: skip
    agrees: bool | None = maybe("agrees")


def build_directions(tool: str, points: int, workers: int) -> ChildJob:
    """Directions by one tool, whose means of all integrands are judged."""
    normals = np.random.default_rng(SEED).normal(size=(points, 3))
    normals = (normals / np.linalg.norm(normals, axis=1, keepdims=True)).astype(np.float32)
    work, result = DIRECTIONS[tool].make(normals, SAMPLES, workers)
    frames = twins.frames(normals[: max(1, _JUDGED // SAMPLES)].astype(np.float64))

    def report() -> dict[str, Any]:
        d = np.asarray(result()).reshape(points, SAMPLES, 3)[: len(frames)]
        local = np.einsum("nij,nsi->nsj", frames, d).reshape(-1, 3).astype(np.float32)
        return judged(DIRECTIONS[tool], workers, worst_deviation([(evaluate(i, local), i.mean) for i in INTEGRANDS]))

    return ChildJob(work, report)


def worst_deviation(means: Iterable[tuple[np.ndarray, float]]) -> float:
    """The worst of some means, in standard errors, of (values, exact mean) of each; NaN if one is."""
    errors = [
        (v.mean(dtype=np.float64) - exact, v.std(dtype=np.float64) / np.sqrt(len(v)) + _ROUNDING) for v, exact in means
    ]
    return float(np.max([abs(off) / error for off, error in errors]))


def judged(tool: Tool, workers: int, worst: float) -> dict[str, Any]:
    """What a row says of a tool whose worst mean is off by so many standard errors."""
    return {
        "library": f"{tool.library} {version(tool.library)}",
        "threads": workers if tool.threaded else 1,
        "worst_deviation": worst,
        "agrees": worst <= _BY_CHANCE,
    }


def measure(
    track: Track,
    *,
    points: Annotated[int, typer.Option(help="Normals, with 64 directions each.", min=1)] = 65_536,
    repeats: Repeats = 15,
) -> Found:
    """Compares all tools, in turns."""
    return {"rows": compare(list(track(DIRECTIONS, len(DIRECTIONS))), points, repeats)}


def compare(tools: Iterable[str], points: int, repeats: int) -> list[PeerSpeed]:
    """Some tools, ours first, taking turns."""
    turns = take_turns(build_directions, tools, repeats, points=points, workers=check_workers(None))
    ours = next(iter(turns.seconds.values()))

    def figures(tool: str) -> dict[str, Any]:
        seconds = turns.seconds[tool]
        speed = Spread.of([points * SAMPLES / t / 1e6 for t in seconds])
        return {"million_per_second": speed, "ours": Spread.of_ratios(seconds, ours), **turns.told[tool]}

    return turns.rows(PeerSpeed, figures)


_CELLS = "library threads million_per_second ours worst_deviation"

RECORD = Benchmark(
    name="peers",
    summary="Directions of the cosine lobe by warpsample, NumPy, Warp's built-ins and Mitsuba.",
    measure=measure,
    parts={"rows": PeerSpeed},
    views=[TableView("rows", "Directions of the cosine lobe, 64 at each normal", "tool", _CELLS)],
    pictures=[Picture("peers", "rows", "million_per_second", y="tool", series="", log="x")],
)
