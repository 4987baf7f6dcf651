"""`bench peers`: the same task by other tools, side by side: a process each, taking turns.

They are asked for 64 directions of the cosine lobe about each normal, float32 (x, y, z); or for points on a mesh, uniform by
area.
"""

from collections.abc import Callable, Iterable
from dataclasses import dataclass
from importlib.metadata import version
from math import sqrt
from typing import Annotated, Any

import numpy as np
import typer

from warpsample.bench.integrands import INTEGRANDS, KnownIntegral, estimates, evaluate
from warpsample.bench.pictures import Picture
from warpsample.bench.record import SEED, Benchmark, Found, Repeats, Track
from warpsample.bench.rows import Spread, Timed, column, digits, maybe
from warpsample.bench.running.child import ChildJob
from warpsample.bench.running.timing import interleave, stopwatch
from warpsample.bench.running.turns import Tool, take_turns
from warpsample.bench.tables import TableView
from warpsample.bench.tools.directions import DIRECTIONS, SURFACE
from warpsample.directions.sample import sample_directions
from warpsample.host.engine import check_workers
from warpsample.proof import twins

SAMPLES = 64
_JUDGED = 1 << 20  # directions or points whose means are taken
_BY_CHANCE = 4.5  # standard errors; with 13 peers and 7 means by chance once in 1,600 runs
_TARGETS = {"sky gradient": 1e-3, "half-space": 3e-3}
_TITLES = {"directions": "directions of the cosine lobe, 64 at each normal", "surface": "points on a mesh of 81,920 faces"}


@dataclass(frozen=True)
class PeerSpeed(Timed):
    """One tool at one task."""

    task: str = column("task", show=_TITLES.get)
    peer: str = column("tool", "fill is NumPy's `out.fill(0)`, the ceiling")
    library: str = column("version")
    threads: int = column("threads")
    million_per_second: Spread | None = maybe("million a second")
    ours: Spread | None = maybe("ours / it", "the speed of independent directions by warpsample over its")
    worst_deviation: float | None = maybe(
        "off by", "the worst of the means of seven integrals, on the mesh of three, in standard errors from the exact value",
        show=lambda x: f"{x:.1f}{'' if x <= _BY_CHANCE else ' WRONG'}")  # fmt: skip
    agrees: bool | None = maybe("agrees")
    failure: str | None = maybe("why it did not run")

    @property
    def tool(self) -> str:
        """The tool's name."""
        return self.peer


@dataclass(frozen=True)
class ToError:
    """Time to an RMSE at one point, sampling alone: ours by default settings, the others by independent samples."""

    integrand: str = column("integrand")
    rmse: float = column("RMSE", show="g")
    samples: int = column("N", "samples that the default needs: the least power of two that is good enough")
    independent_samples: float = column("its N", "independent samples that it needs", show=",.0f")
    microseconds: Spread = column("µs", "ours", show=digits)
    peer: str = column("fastest other")
    peer_microseconds: float = column("its µs", show=digits)
    ratio: float = column("times ours", show=",.0f")


@dataclass(frozen=True)
class PeerTask:
    """What the tools compete at.

    Attributes:
        tools: by name.
        ours: whose speed the others' are compared with.
        build: (tool, points, workers) -> its job.
        count: directions or points for each of `points`.
        exact: the means that each must have, by name.
        rounding: how far a mean may be off by construction.
    """

    tools: dict[str, Tool]
    ours: str
    build: Callable[..., ChildJob]
    count: int
    exact: dict[str, float]
    rounding: float


def build_directions(tool: str, points: int, workers: int) -> ChildJob:
    """The job of one tool; its report has "library" and "means", {integrand: [mean, its standard error]}."""
    normals = np.random.default_rng(SEED).normal(size=(points, 3))
    normals = (normals / np.linalg.norm(normals, axis=1, keepdims=True)).astype(np.float32)
    work, result = DIRECTIONS[tool].make(normals, SAMPLES, workers)
    frames = twins.frames(normals[: max(1, _JUDGED // SAMPLES)].astype(np.float64))

    def report() -> dict[str, Any]:
        d = np.asarray(result()).reshape(points, SAMPLES, 3)[: len(frames)]
        local = np.einsum("nij,nsi->nsj", frames, d).reshape(-1, 3).astype(np.float32)
        return _report(DIRECTIONS[tool], {i.name: evaluate(i, local).astype(np.float64) for i in INTEGRANDS})

    return ChildJob(work, report)


def build_surface(tool: str, points: int, workers: int) -> ChildJob:
    """Points on a sphere of 81,920 faces; the report's means are of x, x^2 and z^2."""
    import trimesh

    work, result = SURFACE[tool].make(trimesh.creation.icosphere(subdivisions=6), points, workers)

    def report() -> dict[str, Any]:
        p = np.asarray(result(), np.float64)[:_JUDGED]
        return _report(SURFACE[tool], {"x": p[:, 0], "x^2": p[:, 0] ** 2, "z^2": p[:, 2] ** 2})

    return ChildJob(work, report)


def _report(tool: Tool, values: dict[str, np.ndarray]) -> dict[str, Any]:
    means = {name: [float(v.mean()), float(v.std() / np.sqrt(len(v)))] for name, v in values.items()}
    return {"library": f"{tool.library} {version(tool.library)}", "means": means}


TASKS = {
    "directions": PeerTask(
        DIRECTIONS, "warpsample independent", build_directions, SAMPLES, {i.name: i.mean for i in INTEGRANDS}, 1e-9
    ),
    # The faceted sphere lies within 1e-4 of the round one, so its means do.
    "surface": PeerTask(
        SURFACE, "warpsample surface", build_surface, 1, {"x": 0.0, "x^2": 1.0 / 3.0, "z^2": 1.0 / 3.0}, 1e-4
    ),
}


def measure(
    track: Track,
    *,
    points: Annotated[
        int, typer.Option(help="Normals, with 64 directions each; 16 times as many on a mesh.", min=1)
    ] = 65_536,
    repeats: Repeats = 15,
) -> Found:
    """Both tasks, and the times to an error by the fastest tool."""
    sizes = {"directions": points, "surface": 16 * points}
    rows = [row for task in track(sizes, len(sizes)) for row in compare(task, sizes[task], repeats)]
    return {"rows": rows, "time_to_error": time_to_error(rows, repeats)}


def compare(task: str, points: int, repeats: int, chosen: Iterable[str] | None = None) -> list[PeerSpeed]:
    """All tools at one task, or those chosen, interleaved; of directions there are SAMPLES at each point."""
    workers = check_workers(None)
    tools = [tool for tool in TASKS[task].tools if chosen is None or tool in chosen]
    turns = take_turns(TASKS[task].build, tools, repeats, points=points, workers=workers)
    return [
        PeerSpeed(task, tool, "", 0, failure=turns.failures[tool])
        if tool in turns.failures
        else judge(task, tool, points, workers=workers, seconds=turns.seconds, report=turns.told[tool])
        for tool in tools
    ]


def judge(
    task: str, tool: str, points: int, *, workers: int, seconds: dict[str, list[float]], report: dict[str, Any]
) -> PeerSpeed:
    """What a tool's seconds, beside ours, and its report of means come to."""
    about = TASKS[task]
    deviations = [
        abs(mean - about.exact[name]) / (error + about.rounding) for name, (mean, error) in report["means"].items()
    ]
    worst = float(np.max(deviations)) if tool != "fill" else None  # which NaN is, unlike with Python's max
    return PeerSpeed(
        task,
        tool,
        report["library"],
        workers if about.tools[tool].threaded else 1,
        Spread.of([points * about.count / t / 1e6 for t in seconds[tool]]),
        Spread.of_ratios(seconds[tool], seconds[about.ours]) if about.ours in seconds else None,
        worst,
        None if worst is None else worst <= _BY_CHANCE,
        seconds=seconds[tool],
    )


def time_to_error(rows: list[PeerSpeed], repeats: int, randomisations: int = 1024, largest: int = 1 << 22) -> list[ToError]:
    """Ours against the fastest of the other tools, those of the directions; `largest`: directions in memory at a time."""
    others = {row.peer: row.million_per_second.median for row in rows
              if row.task == "directions" and row.million_per_second and row.agrees
              and not row.peer.startswith("warpsample")}  # fmt: skip
    if not others:
        return []
    fastest = max(others.items(), key=lambda item: item[1])
    targets = [i for i in INTEGRANDS if i.name in _TARGETS]
    return [_to_error(i, fastest, repeats=repeats, randomisations=randomisations, largest=largest) for i in targets]


def _to_error(
    integrand: KnownIntegral, fastest: tuple[str, float], *, repeats: int, randomisations: int, largest: int
) -> ToError:
    rmse = _TARGETS[integrand.name]
    samples = next(n for n in (2**k for k in range(2, 25)) if _rmse(integrand, "sobol", n, randomisations) <= rmse)
    variance = _rmse(integrand, "independent", 64, randomisations) ** 2 * 64
    independent = variance / rmse**2
    points = max(1, largest // samples)
    normals = np.random.default_rng(SEED).normal(size=(points, 3)).astype(np.float32)
    out = np.empty((points, samples, 3), np.float32)
    (seconds,), _ = interleave([stopwatch(lambda: sample_directions(normals, samples, out=out))], repeats)
    ours = Spread.of([1e6 * t / points for t in seconds])
    peer, speed = fastest
    return ToError(
        integrand.name, rmse, samples, independent, ours, peer, independent / speed, independent / speed / ours.median
    )


def _rmse(integrand: KnownIntegral, sequence: str, count: int, randomisations: int) -> float:
    return sqrt(float(np.mean((estimates(integrand, sequence, count, randomisations) - integrand.mean) ** 2)))


RECORD = Benchmark(
    name="peers",
    summary="The same task by warpsample, NumPy, SciPy, Numba, PyTorch, Warp's built-ins, Mitsuba, trimesh and Open3D.",
    measure=measure,
    parts={"rows": PeerSpeed, "time_to_error": ToError},
    views=[
        TableView(
            "rows", "Million a second", "peer", "library threads million_per_second ours worst_deviation", split="task"
        ),
        TableView(
            "time_to_error",
            "Time to an RMSE at a point, sampling alone: ours by default (sobol), theirs independent",
            "integrand rmse",
            "samples microseconds peer independent_samples peer_microseconds ratio",
        ),
    ],
    pictures=[Picture("peers", "rows", "million_per_second", series="peer threads", down="task", told="ours")],
)
