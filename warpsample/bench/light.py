"""`bench light`: light reflected or transmitted by faces, by warpsample, Mitsuba and Radiance, to the same error."""

from collections.abc import Sequence
from dataclasses import dataclass
from importlib.metadata import version
from typing import Annotated, Any

import numpy as np
import typer

from warpsample.bench.radiation import compare_at_equal_error, compute_errors
from warpsample.bench.record import SEED, Benchmark, Picture, Repeats, RowsByPart, Track
from warpsample.bench.rows import Spread, ToolRow, column, optional_column
from warpsample.bench.running.child import ChildJob
from warpsample.bench.running.timing import build_stopwatch
from warpsample.bench.running.turns import run_tools
from warpsample.bench.tables import TableView
from warpsample.bench.tools.blocks import build_mesh
from warpsample.bench.tools.light import LIGHT_TOOLS, OURS
from warpsample.host.engine import check_workers
from warpsample.mesh.mesh import Mesh, as_mesh
from warpsample.mesh.points.sampling import sample_surface
from warpsample.mesh.surface import SurfacePoints

TASKS = {"reflection": {"reflectance": 0.4}, "transmission": {"transmittance": 0.3}}
"""By name; of the second a third of the faces let light through."""

_REFERENCE_RAYS = 1 << 14
_FEWEST, _RUNS, _FEWER = 8, 4, 4
_MOST_RMSE = 0.01  # RMSE of the mean of the runs: a factor pi, or one order too few, is 0.05 and more


@dataclass(frozen=True)
class LightTime(ToolRow):
    """Time and error of one tool for light reflected or transmitted by the faces of a city."""

    task: str = column("light by")
    faces: int = column("faces")
    points: int = column("points")
    workers: int = column("threads")
    took: Spread | None = optional_column("s")
    rmse: float | None = optional_column("RMSE", "of irradiance over pi", show=".1e")
    rate: float | None = optional_column("rate", "the power of the rays by which it falls, from a quarter of them on")
    times_ours: Spread | None = optional_column(
        "times ours", "as long as ours to the RMSE of ours, extrapolated by its own rate"
    )
    apart: float | None = optional_column(
        "error\u00b2 / spread\u00b2", "square error of the mean of four runs over their own variance, about 1"
    )
    agrees: bool | None = optional_column("agrees", "whether the mean of four runs has an RMSE below 0.01")


def build_lit_city(task: str, side: int, points: int) -> tuple[Mesh, SurfacePoints]:
    """Build a city of side x side blocks for a task, and points on it: uniform by area, in the order of the faces."""
    mesh = build_mesh(f"city {side}")
    ((name, share),) = TASKS[task].items()
    chosen = np.random.default_rng(SEED).random(len(mesh.faces) // 2).repeat(2) < (
        1.0 if name == "reflectance" else 1.0 / 3.0
    )
    found = sample_surface(mesh, points, seed=SEED)
    return as_mesh(mesh, **{name: share * chosen}), found.take(np.argsort(found.face, kind="stable"))


def build_light(tool: str, task: str, side: int, *, points: int, rays: int, workers: int, reference: np.ndarray) -> ChildJob:
    """Build a tool's irradiance of a city; the report compares the irradiance with the reference."""
    scene, make = build_lit_city(task, side, points), LIGHT_TOOLS[tool].make
    run = make(*scene, workers)
    fixed = build_stopwatch(lambda: run(_FEWEST, 1))

    def report() -> dict[str, Any]:
        judged = make(*scene, workers)  # anew: how many runs were timed, and so their seeds, is a matter of time
        mse, variance, apart = compute_errors(judged(rays, _RUNS), reference)
        fewer, _, _ = compute_errors(judged(rays // _FEWER, _RUNS), reference)
        rate = float(0.5 * np.log(fewer / mse) / np.log(_FEWER))
        return {"rmse": mse**0.5, "rate": rate, "apart": apart / variance, "off": apart**0.5, "fixed": float(fixed())}

    return ChildJob(lambda: run(rays, 1), report, lambda: run(_FEWEST, 1))


def measure(
    track: Track,
    *,
    side: Annotated[int, typer.Option(help="Blocks along a side of the city; 8 are 4,500 faces.", min=1)] = 8,
    points: Annotated[int, typer.Option(help="Points on it.", min=16)] = 1024,
    rays: Annotated[int, typer.Option(help="Rays of each point.", min=64)] = 1024,
    repeats: Repeats = 3,
) -> RowsByPart:
    """Measure both tasks with all threads."""
    tools, workers = list(LIGHT_TOOLS), check_workers(None)
    given = {"side": side, "points": points, "rays": rays, "workers": workers}
    return {"rows": [row for task in track(TASKS, len(TASKS)) for row in compare(task, tools, repeats, **given)]}


def compare(task: str, tools: Sequence[str], repeats: int, **given: int) -> list[LightTime]:
    """Compare tools at one task with alternating runs; the reference is warpsample with 16,384 rays and four runs."""
    mesh, at = build_lit_city(task, given["side"], given["points"])
    right = LIGHT_TOOLS[OURS].make(mesh, at, given["workers"])(_REFERENCE_RAYS, _RUNS).mean(axis=0, dtype=float)
    turns = run_tools(build_light, tools, repeats, task=task, reference=right, **given)

    def figures(tool: str) -> dict[str, Any]:
        seconds, told = turns.seconds[tool], turns.reports[tool]
        times = compare_at_equal_error(seconds, told, turns.seconds[OURS], turns.reports[OURS])
        judged = {name: told[name] for name in ("rmse", "rate", "apart")}
        library = version(LIGHT_TOOLS[tool].library)
        return {
            "version": library,
            "took": Spread.of(seconds),
            **judged,
            "times_ours": times,
            "agrees": told["off"] <= _MOST_RMSE,
        }

    case = {"task": task, "faces": len(mesh.faces), "points": given["points"], "workers": given["workers"]}
    return turns.rows(LightTime, figures, **case)


_CELLS = "took rmse rate times_ours apart"

RECORD = Benchmark(
    name="light",
    summary="Light that faces send back or let through: ours, Mitsuba and Radiance's rtrace.",
    measure=measure,
    parts={"rows": LightTime},
    views=[TableView("rows", "Irradiance of a city", "tool", _CELLS, split="task faces points")],
    pictures=[Picture("light", "rows", "took", y="rmse", panels="task", log="xy")],
)
