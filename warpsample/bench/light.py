"""`bench light`: time of warpsample, Mitsuba and Radiance to compute reflected or transmitted light to the same error."""

from collections.abc import Sequence
from dataclasses import dataclass
from importlib.metadata import version
from typing import Annotated, Any

import numpy as np
import typer

from warpsample.bench.radiation import compare_at_equal_error, compute_errors
from warpsample.bench.record import SEED, Benchmark, Picture, Repeats, RowsByPart, Track
from warpsample.bench.reporting.tables import TableView
from warpsample.bench.rows import Spread, ToolRow, column, optional_column
from warpsample.bench.running.child import ChildJob
from warpsample.bench.running.timing import build_stopwatch
from warpsample.bench.running.turns import run_tools
from warpsample.bench.tools.blocks import build_mesh
from warpsample.bench.tools.light import LIGHT_TOOLS, OURS
from warpsample.host.engine import check_workers
from warpsample.mesh.mesh import Mesh, as_mesh
from warpsample.mesh.points.sampling import sample_surface
from warpsample.mesh.surface import SurfacePoints

TASKS = {"reflection": {"reflectance": 0.4}, "transmission": {"transmittance": 0.3}}
"""Optical properties by task; all faces reflect, but only a third of the faces transmit."""

_REFERENCE_RAYS = 1 << 14
_FEWEST, _RUNS, _FEWER = 8, 4, 4
_MOST_RMSE = 0.01  # RMSE of the mean of the runs; a wrong factor pi or one order of reflection too few gives 0.05 or more


@dataclass(frozen=True)
class LightTime(ToolRow):
    """Row of `bench light`: time and error of one tool for light that the faces of a city reflect or transmit."""

    task: str = column("task")
    faces: int = column("faces")
    points: int = column("points")
    workers: int = column("threads")
    took: Spread | None = optional_column("seconds", "time of one run for all points")
    rmse: float | None = optional_column(
        "RMSE", "root mean square error over the points, of the irradiance divided by pi", show=".1e"
    )
    rate: float | None = optional_column(
        "convergence rate", "r if the RMSE falls as (number of rays)^-r, measured with all rays and with a quarter of them"
    )
    times_ours: Spread | None = optional_column(
        "time / warpsample", "time to warpsample's RMSE, by the tool's own convergence rate, divided by warpsample's time"
    )
    apart: float | None = optional_column(
        "error\u00b2 / variance", "mean square error of the mean of four runs, divided by its variance; about 1 without bias"
    )
    agrees: bool | None = optional_column("agrees", f"yes if the mean of four runs has an RMSE of at most {_MOST_RMSE:g}")


def build_lit_city(task: str, side: int, points: int) -> tuple[Mesh, SurfacePoints]:
    """Build a city whose faces reflect or transmit, as a task requires, and points on the city.

    The city has side x side blocks. The points are uniform by area, in the order of the faces.
    """
    mesh = build_mesh(f"city {side}")
    ((name, share),) = TASKS[task].items()
    chosen = np.random.default_rng(SEED).random(len(mesh.faces) // 2).repeat(2) < (
        1.0 if name == "reflectance" else 1.0 / 3.0
    )
    samples = sample_surface(mesh, points, seed=SEED)
    return as_mesh(mesh, **{name: share * chosen}), samples.take(np.argsort(samples.face, kind="stable"))


def build_light(tool: str, task: str, side: int, *, points: int, rays: int, workers: int, reference: np.ndarray) -> ChildJob:
    """Prepare one tool to compute the irradiance at points of a city, and return the work to time.

    The job's report compares the irradiance with the reference.
    """
    scene, make = build_lit_city(task, side, points), LIGHT_TOOLS[tool].make
    run = make(*scene, workers)
    fixed = build_stopwatch(lambda: run(_FEWEST, 1))

    def report() -> dict[str, Any]:
        tool_again = make(*scene, workers)  # a new tool: the number of timed runs, and so the next seed, depends on speed
        mse, variance, apart = compute_errors(tool_again(rays, _RUNS), reference)
        fewer, _, _ = compute_errors(tool_again(rays // _FEWER, _RUNS), reference)
        rate = float(0.5 * np.log(fewer / mse) / np.log(_FEWER))
        return {"rmse": mse**0.5, "rate": rate, "apart": apart / variance, "off": apart**0.5, "fixed": float(fixed())}

    return ChildJob(lambda: run(rays, 1), report, lambda: run(_FEWEST, 1))


def measure(
    track: Track,
    *,
    side: Annotated[
        int, typer.Option(help="Number of blocks along a side of the city. 8 blocks make 4,600 faces.", min=1)
    ] = 8,
    points: Annotated[int, typer.Option(help="Number of points on the city, placed uniformly by area.", min=16)] = 1024,
    rays: Annotated[int, typer.Option(help="Number of rays per point.", min=64)] = 1024,
    repeats: Repeats = 3,
) -> RowsByPart:
    """Measure the tasks of reflected and transmitted light with all threads; return the rows."""
    tools, workers = list(LIGHT_TOOLS), check_workers(None)
    case_sizes = {"side": side, "points": points, "rays": rays, "workers": workers}
    return {"rows": [row for task in track(TASKS, len(TASKS)) for row in compare(task, tools, repeats, **case_sizes)]}


def compare(task: str, tools: Sequence[str], repeats: int, **case_sizes: int) -> list[LightTime]:
    """Measure several tools at one task (reflected or transmitted light), with alternating runs.

    The reference is warpsample with 16,384 rays and four runs.
    """
    mesh, at = build_lit_city(task, case_sizes["side"], case_sizes["points"])
    right = LIGHT_TOOLS[OURS].make(mesh, at, case_sizes["workers"])(_REFERENCE_RAYS, _RUNS).mean(axis=0, dtype=float)
    turns = run_tools(build_light, tools, repeats, task=task, reference=right, **case_sizes)

    def figures(tool: str) -> dict[str, Any]:
        seconds, facts = turns.seconds[tool], turns.reports[tool]
        times = compare_at_equal_error(seconds, facts, turns.seconds[OURS], turns.reports[OURS])
        fields = {name: facts[name] for name in ("rmse", "rate", "apart")}
        library = version(LIGHT_TOOLS[tool].library)
        return {
            "version": library,
            "took": Spread.of(seconds),
            **fields,
            "times_ours": times,
            "agrees": facts["off"] <= _MOST_RMSE,
        }

    case = {"task": task, "faces": len(mesh.faces), "points": case_sizes["points"], "workers": case_sizes["workers"]}
    return turns.rows(LightTime, figures, **case)


_CELLS = "took rmse rate times_ours apart"

RECORD = Benchmark(
    name="light",
    summary="Compare light reflected or transmitted by faces: warpsample, Mitsuba and Radiance's rtrace.",
    measure=measure,
    parts={"rows": LightTime},
    views=[TableView("rows", "Irradiance of a city", "tool", _CELLS, split="task faces points")],
    pictures=[Picture("light", "rows", "took", y="rmse", panels="task", log="xy")],
)
