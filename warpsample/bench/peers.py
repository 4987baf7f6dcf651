"""`bench peers`: the same task by other tools, side by side: a process each, taking turns.

They are asked for 64 directions of the cosine lobe about each normal, float32 (x, y, z); or for points on a mesh, uniform by
area.
"""

from collections.abc import Iterable
from dataclasses import dataclass
from importlib.metadata import version
from typing import Annotated, Any

import numpy as np
import typer

from warpsample.bench.integrands import INTEGRANDS, evaluate
from warpsample.bench.record import SEED, Benchmark, Found, Picture, Repeats, TableView, Track
from warpsample.bench.rows import Spread, ToolRow, column, maybe
from warpsample.bench.running.child import ChildJob
from warpsample.bench.running.turns import Tool, take_turns
from warpsample.bench.tools.directions import DIRECTIONS, SURFACE
from warpsample.host.engine import check_workers
from warpsample.proof import twins

SAMPLES = 64
_JUDGED = 1 << 20  # directions or points whose means are taken
_BY_CHANCE = 4.5  # standard errors; with 13 peers and 7 means by chance once in 1,600 runs
_TITLES = {"directions": "directions of the cosine lobe, 64 at each normal", "surface": "points on a mesh of 81,920 faces"}


@dataclass(frozen=True)
class PeerSpeed(ToolRow):
    """One tool at one task."""

    task: str = column("task", show=_TITLES.get)
    library: str = maybe("version")
    threads: int = maybe("threads")
    million_per_second: Spread | None = maybe("million a second")
    ours: Spread | None = maybe("ours / it", "the speed of independent directions by warpsample over its")
    worst_deviation: float | None = maybe(
        "off by", "the worst of the means of seven integrals, on the mesh of three, in standard errors from the exact value",
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
        worst = worst_deviation([(evaluate(i, local), i.mean) for i in INTEGRANDS], 1e-9)
        return {"size": points * SAMPLES, "row": _row(DIRECTIONS[tool], workers, worst)}

    return ChildJob(work, report)


def build_surface(tool: str, points: int, workers: int) -> ChildJob:
    """Points by one tool on a sphere of 81,920 faces, whose means of x, x^2 and z^2 are judged."""
    import trimesh

    work, result = SURFACE[tool].make(trimesh.creation.icosphere(subdivisions=6), points, workers)

    def report() -> dict[str, Any]:
        x, _, z = np.asarray(result(), np.float64)[:_JUDGED].T
        # The faceted sphere lies within 1e-4 of the round one, so its means do.
        worst = worst_deviation([(x, 0.0), (x**2, 1.0 / 3.0), (z**2, 1.0 / 3.0)], 1e-4)
        return {"size": points, "row": _row(SURFACE[tool], workers, worst)}

    return ChildJob(work, report)


def worst_deviation(judged: Iterable[tuple[np.ndarray, float]], rounding: float) -> float:
    """The worst of some means, in standard errors and what they may be off by construction: (values, exact mean) of each."""
    means = [(v.mean(dtype=np.float64), exact, v.std(dtype=np.float64) / np.sqrt(len(v))) for v, exact in judged]
    return float(np.max([abs(mean - exact) / (error + rounding) for mean, exact, error in means]))  # NaN if there is one


def _row(tool: Tool, workers: int, worst: float) -> dict[str, Any]:
    return {
        "library": f"{tool.library} {version(tool.library)}",
        "threads": workers if tool.threaded else 1,
        "worst_deviation": worst,
        "agrees": worst <= _BY_CHANCE,
    }


TASKS = {"directions": (build_directions, DIRECTIONS), "surface": (build_surface, SURFACE)}
"""What builds a job, and the tools, ours first, with which the others are compared."""


def measure(
    track: Track,
    *,
    points: Annotated[
        int, typer.Option(help="Normals, with 64 directions each; 16 times as many on a mesh.", min=1)
    ] = 65_536,
    repeats: Repeats = 15,
) -> Found:
    """All tools at both tasks."""
    sizes = {"directions": points, "surface": 16 * points}
    return {"rows": [row for task in track(sizes, len(sizes)) for row in compare(task, sizes[task], repeats)]}


def compare(task: str, points: int, repeats: int, tools: Iterable[str] | None = None) -> list[PeerSpeed]:
    """All tools at one task, or those chosen, taking turns."""
    build, known = TASKS[task]
    turns = take_turns(build, known if tools is None else tools, repeats, points=points, workers=check_workers(None))

    def figures(tool: str) -> dict[str, Any]:
        seconds, told = turns.seconds[tool], turns.told[tool]
        speed = Spread.of([told["size"] / t / 1e6 for t in seconds])
        return {
            "million_per_second": speed,
            "ours": Spread.of_ratios(seconds, turns.seconds[next(iter(known))]),
            **told["row"],
        }

    return turns.rows(PeerSpeed, figures, task=task)


_CELLS = "library threads million_per_second ours worst_deviation"

RECORD = Benchmark(
    name="peers",
    summary="The same task by warpsample, NumPy, Warp's built-ins, Mitsuba, trimesh and Open3D.",
    measure=measure,
    parts={"rows": PeerSpeed},
    views=[
        TableView(
            "rows", "Million a second", "tool", "library threads million_per_second ours worst_deviation", split="task"
        ),
    ],
    pictures=[Picture("peers", "rows", "million_per_second", y="tool", series="", panels="task", log="x")],
)
