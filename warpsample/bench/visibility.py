"""`bench visibility`: time of ambient occlusion to an RMSE, with and without skipping, and by other tools."""

from collections.abc import Sequence
from dataclasses import dataclass
from importlib.metadata import version
from typing import Annotated, Any

import numpy as np
import typer

from warpsample import sequences
from warpsample.bench.record import Benchmark, Picture, Repeats, RowsByPart, Scenes, Track
from warpsample.bench.reporting.tables import Cell, TableView
from warpsample.bench.rows import Spread, ToolRow, column, format_digits, optional_column
from warpsample.bench.running.child import ChildJob
from warpsample.bench.running.machine import measure_peak_megabytes
from warpsample.bench.running.turns import keep_last_result, run_tools
from warpsample.bench.scenes import sample_scene
from warpsample.bench.tools.occlusion import ESTIMATORS, Estimator, Occlusion
from warpsample.estimate.result import Estimate
from warpsample.estimate.visibility import ambient_occlusion
from warpsample.host.engine import check_workers
from warpsample.mesh.mesh import Mesh
from warpsample.mesh.surface import SurfacePoints

TARGETS = (0.01, 0.003)
"""Target RMSE of all tools."""
TOOLS = tuple(ESTIMATORS)
DEFAULT_SCENES = ("bunny", "city", "hills")
MANY = 256
"""Factor from `points` to the number of points in the memory run, and rays per point of that run."""
_REFERENCE_SEED = 1 << 40  # far from the seeds of the estimates
_TRIAL, _TRIALS = 64, 2  # rays of the first trial; number of trials


@dataclass(frozen=True)
class TimeToError(ToolRow):
    """Row of `bench visibility`: time of one tool on one scene to reach an RMSE over all points.

    The time excludes building the mesh's tree.
    """

    scene: str = column("scene")
    target: float = column("RMSE", show="to {:g}".format)
    workers: int = column("workers")
    points: int = column("points")
    rays: int | None = optional_column("rays", "rays per point")
    cast: float | None = optional_column("cast", "mean number of rays per point that were traced, not skipped", show=",.0f")
    rmse: float | None = optional_column("RMSE", "RMSE of the timed run", show=".4f")
    microseconds: Spread | None = optional_column(
        "µs per point", "time to the target RMSE, extrapolated from the RMSE of the timed run by the tool's own rate"
    )
    times_ours: Spread | None = optional_column(
        "time / warpsample", "time to the target RMSE over that of warpsample in the same round"
    )


@dataclass(frozen=True)
class Many(ToolRow):
    """Row of `bench visibility`: run of ambient occlusion with many points, in a separate process."""

    scene: str = column("scene")
    points: int = column("points")
    rays: int = column("rays")
    workers: int = column("workers")
    peak_megabytes: float | None = optional_column(
        "peak memory, MB", "peak memory of the process, with Python, Warp, mesh and points", show=",.0f"
    )
    took: float | None = optional_column("seconds", show=format_digits)


def build_estimate(tool: str, scene: str, points: int, *, workers: int, target: float, reference: np.ndarray) -> ChildJob:
    """Prepare one tool to compute ambient occlusion to a target RMSE, and return the work to time.

    The RMSE is that over all points. Two trials find the number of rays.
    """
    library, make, _ = ESTIMATORS[tool]
    run: Estimator = make(*sample_scene(scene, points), workers)
    rate = sequences.get("fibonacci" if library.startswith("warp") else "independent").rate

    def more_rays(error: float) -> float:
        return float(np.float_power(error / target, 1.0 / rate))

    count = _TRIAL
    for _ in range(_TRIALS):
        count = max(2, round(count * more_rays(_compute_rmse(run(count), reference))))
    work, values = keep_last_result(lambda: run(count))

    def report() -> dict[str, Any]:
        cast = float(run.last.rays.mean()) if isinstance(run, Occlusion) and run.last else float(count)
        error = _compute_rmse(values(), reference)
        facts = {"version": version(library), "rays": count, "cast": cast, "rmse": error}
        return {"row": facts, "to_target": more_rays(error)}

    return ChildJob(work, report)


def _compute_rmse(values: np.ndarray, right: np.ndarray) -> float:
    return float(np.sqrt(np.mean((values - right) ** 2)))


def build_many_points(tool: str, scene: str, points: int, rays: int, workers: int) -> ChildJob:
    """Prepare the ambient occlusion of many points by warpsample, and return the work to time.

    The job reports the peak memory of its process.
    """
    mesh, at = sample_scene(scene, points)
    ESTIMATORS[tool].make(mesh, at.take(slice(64)), workers)(rays)  # load kernels
    run = ESTIMATORS[tool].make(mesh, at, workers)
    return ChildJob(lambda: run(rays), lambda: {"peak_megabytes": measure_peak_megabytes()})


def measure(
    track: Track,
    *,
    scene: Scenes = None,
    points: Annotated[int, typer.Option(help="Number of points on each scene, placed uniformly by area.", min=16)] = 4096,
    repeats: Repeats = 3,
) -> RowsByPart:
    """Measure ambient occlusion on one scene after the other, then many points on the first scene; return the rows."""
    names = scene or list(DEFAULT_SCENES)
    rows: RowsByPart = {"rows": [], "many": []}
    for name in track(names, len(names)):
        rows["rows"] += measure_scene(name, points, repeats)
    rows["many"] += measure_many(names[0], MANY * points, MANY)
    return rows


def measure_scene(
    scene: str, points: int, repeats: int, targets: Sequence[float] = TARGETS, tools: Sequence[str] = TOOLS
) -> list[TimeToError]:
    """Measure the ambient occlusion of a scene with all tools, for each of the target errors."""
    workers = check_workers(None)
    right = compute_reference(*sample_scene(scene, points), workers).value
    case = {"scene": scene, "workers": workers, "points": points}
    return [row for target in targets for row in compare(tools, repeats, right, **case, target=target)]


def compute_reference(mesh: Mesh, at: SurfacePoints, workers: int, rays: int = 1 << 16) -> Estimate:
    """Compute reference ambient occlusion by `ambient_occlusion` with Fibonacci points and the package's tracer."""
    return ambient_occlusion(mesh, at, rays, seed=_REFERENCE_SEED, workers=workers)


def compare(tools: Sequence[str], repeats: int, reference: np.ndarray, **case: Any) -> list[TimeToError]:
    """Measure the ambient occlusion of one case with several tools, with alternating runs.

    The case has the fields that are known before the runs.
    """
    turns = run_tools(build_estimate, tools, repeats, reference=reference, **case)
    equal_times = {tool: [t * facts["to_target"] for t in turns.seconds[tool]] for tool, facts in turns.reports.items()}

    def figures(tool: str) -> dict[str, Any]:
        each = Spread.of([1e6 * t / case["points"] for t in equal_times[tool]])
        times = Spread.of_ratios(equal_times[tool], equal_times["warpsample"])
        return {**turns.reports[tool]["row"], "microseconds": each, "times_ours": times}

    return turns.rows(TimeToError, figures, **case)


def measure_many(scene: str, points: int, rays: int) -> list[Many]:
    """Measure time and memory of ambient occlusion of many points, with the default options."""
    same = {"scene": scene, "points": points, "rays": rays, "workers": check_workers(None)}
    turns = run_tools(build_many_points, ["warpsample"], 0, **same)
    return turns.rows(Many, lambda tool: {"took": turns.seconds[tool][0], **turns.reports[tool]}, **same)


_TIME, _RATIO = Cell("microseconds", show=format_digits), Cell("times_ours", show=".1f")
_SPLIT = "scene target points"

RECORD = Benchmark(
    name="visibility",
    summary="Compare the time of ambient occlusion at equal error: warpsample, Mitsuba and embreex.",
    measure=measure,
    parts={"rows": TimeToError, "many": Many},
    views=[
        TableView("rows", "Time to an RMSE", "tool", "rays cast rmse microseconds times_ours", split=_SPLIT, page_rows=None),
        TableView("rows", "Microseconds per point to an RMSE", "tool", [_TIME], across="scene target"),
        TableView("rows", "Time as a multiple of warpsample's", "tool", [_RATIO], across="scene target"),
        TableView("many", "Many points", "scene points rays workers", "took peak_megabytes"),
    ],
    pictures=[Picture("visibility", "rows", "microseconds", y="tool", series="target", panels="scene", log="x")],
)
