"""`bench view-factors`: time, error and memory of all view factors of a mesh, for each tool."""

from collections.abc import Sequence
from dataclasses import dataclass
from importlib.metadata import version
from typing import Annotated, Any

import numpy as np
import typer

from warpsample.bench.record import Benchmark, Picture, Repeats, RowsByPart, Track
from warpsample.bench.reporting.tables import TableView, select_all_workers
from warpsample.bench.rows import Spread, ToolRow, column, format_digits, optional_column
from warpsample.bench.running.child import ChildJob
from warpsample.bench.running.machine import measure_peak_megabytes
from warpsample.bench.running.turns import run_tools
from warpsample.bench.tools.blocks import build_mesh
from warpsample.bench.tools.view_factors import EMBREE, FACTOR_TOOLS, OURS, PAIRS, TRACE, build_trace_alone
from warpsample.host.engine import check_workers
from warpsample.mesh.mesh import Mesh
from warpsample.radiation.exchange.view_factors import view_factors

SMALL_SCENES = ("boxes 6", "city 4")
"""540 and 1,128 faces."""

_REFERENCE_RAYS, _REFERENCE_SEED = 1 << 17, 1 << 40
_JUDGED = 256  # faces whose rows are compared with the reference
_QUARTER, _ANOTHER_SEED = 4, 1 << 30
_MOST_ERROR_RATIO = 1.3  # mean square error over the expected one
_MOST_RELATIVE = 0.25  # RMSE over the root mean square of the factors, for one ray per pair
_FEWER = 16  # divisor of embreex's rays: all rays would take half a minute on the large city


@dataclass(frozen=True)
class FactorTime(ToolRow):
    """Row of `bench view-factors`: time and error of one tool on one mesh."""

    scene: str = column("scene")
    faces: int = column("faces")
    workers: int = column("threads")
    rays: int | None = optional_column("rays", "rays per face")
    took: Spread | None = optional_column(
        "seconds", "time of one run; the tracing alone is timed on some faces and scaled to all faces"
    )
    traces: Spread | None = optional_column(
        "time / trace", "time over that of `ws.trace` alone with the same number of rays", show=".2f"
    )
    rmse: float | None = optional_column("RMSE", "RMSE over the entries of 256 rows, with zeros", show=".1e")
    rate: float | None = optional_column("rate", "exponent of the ray count in warpsample's RMSE")
    times_ours: Spread | None = optional_column(
        "time / warpsample",
        "time over warpsample's at the same RMSE, extrapolated by each tool's rate; by warpsample's rate for pyViewFactor",
        show=format_digits,
    )
    due: float | None = optional_column(
        "error² / expected", "mean square error over that of the error bars, or over the variance of independent rays"
    )
    relative: float | None = optional_column("relative", "RMSE over the root mean square of the factors")
    agrees: bool | None = optional_column(
        "agrees", "True if error² / expected is at most 1.3, or relative at most 0.25 for pyViewFactor"
    )
    peak_megabytes: float | None = optional_column("peak MB", "peak memory of the process", show=".0f")


def choose_judged_faces(mesh: Mesh) -> np.ndarray:
    """Return the faces whose view factors are compared with the reference, spread evenly over all faces."""
    return np.unique(np.linspace(0, len(mesh.faces) - 1, _JUDGED).astype(int))


def compute_reference_rows(mesh: Mesh, workers: int, rays: int = _REFERENCE_RAYS, seed: int = _REFERENCE_SEED) -> np.ndarray:
    """Compute reference rows (R, F) float64 of the view-factor matrix by `view_factors`.

    They use many more rays and another seed.
    """
    faces = choose_judged_faces(mesh)
    active = np.zeros(len(mesh.faces), bool)
    active[faces] = True
    return view_factors(mesh, rays, active=active, seed=seed, workers=workers).matrix[faces].toarray()


def build_factors(tool: str, scene: str, *, rays: int, workers: int, reference: np.ndarray) -> ChildJob:
    """Prepare one tool to compute all view factors of a mesh, and return the work to time.

    A further "tool" only traces the rays from the judged faces.
    """
    mesh = build_mesh(scene)
    faces = choose_judged_faces(mesh)
    if tool == TRACE:
        alone = build_trace_alone(mesh, workers, faces, rays)
        alone()
        row = {"version": version("warpsample"), "rays": rays}
        return ChildJob(alone, lambda: {"row": row, "scale": len(mesh.faces) / len(faces)})
    library, make, _ = FACTOR_TOOLS[tool]
    few = make(build_mesh("boxes 1"), workers)
    few.run(16)  # load kernels and compilers
    used = make(mesh, workers)
    count = rays // _FEWER if tool == EMBREE else rays

    def report() -> dict[str, Any]:
        peak = measure_peak_megabytes()
        mse = float(np.mean((used.rows(faces) - reference) ** 2))
        due = used.due(reference, faces, count)
        row = {
            "version": version(library),
            "rays": None if tool == PAIRS else count,
            "rmse": mse**0.5,
            "relative": (mse / float(np.mean(reference**2))) ** 0.5,
            "due": None if due is None else mse / due,
            "rate": _compute_rate(mesh, reference, rays, mse, workers) if tool == OURS else None,
            "peak_megabytes": peak,
        }
        return {"row": row, "scale": 1.0}

    return ChildJob(lambda: used.run(count), report, lambda: few.run(16))


def _compute_rate(mesh: Mesh, right: np.ndarray, rays: int, mse: float, workers: int) -> float:
    """Return the convergence rate of warpsample: the exponent of the ray count in its RMSE.

    It is measured with a quarter of the rays.
    """
    fewer = np.mean((compute_reference_rows(mesh, workers, max(4, rays // _QUARTER), seed=_ANOTHER_SEED) - right) ** 2)
    return float(0.5 * np.log(fewer / mse) / np.log(_QUARTER))


def measure(
    track: Track,
    *,
    side: Annotated[
        int, typer.Option(help="Number of blocks along a side of the large city. 18 blocks make 22,344 faces.", min=1)
    ] = 18,
    rays: Annotated[int, typer.Option(help="Number of rays per face.", min=64)] = 4096,
    repeats: Repeats = 3,
) -> RowsByPart:
    """Measure the view factors of the small city, the boxes and the large city; return the rows.

    The small city runs with one thread and with all, the boxes with all, and the large city once with all.
    """
    most = check_workers(None)
    tools = [*FACTOR_TOOLS, TRACE]
    boxes, city = SMALL_SCENES
    cases = [(boxes, most, tools, repeats), *((city, workers, tools, repeats) for workers in sorted({1, most}))]
    cases.append((f"city {side}", most, [tool for tool in tools if tool != PAIRS], 0))
    return {"rows": [row for case in track(cases, len(cases)) for row in compare(*case, rays)]}


def compare(scene: str, workers: int, tools: Sequence[str], repeats: int, rays: int) -> list[FactorTime]:
    """Measure the view factors of one mesh with several tools, with alternating runs.

    Warpsample and the tracing alone must be among the tools.
    """
    mesh = build_mesh(scene)
    arguments = {"scene": scene, "workers": workers, "rays": rays, "reference": compute_reference_rows(mesh, workers)}
    turns = run_tools(build_factors, tools, repeats, **arguments)
    seconds = {tool: [t * facts["scale"] for t in turns.seconds[tool]] for tool, facts in turns.reports.items()}

    def figures(tool: str) -> dict[str, Any]:
        row, times = turns.reports[tool]["row"], seconds[tool]
        ray_ratio = (row["rays"] or rays) / rays
        traces = Spread.of_ratios(times, [ray_ratio * t for t in seconds[TRACE]])
        row = {**row, "took": Spread.of(times), "traces": traces, "seconds": times}
        return row if tool == TRACE else row | judge(tool, row, turns.reports[OURS]["row"], times, seconds[OURS])

    return turns.rows(FactorTime, figures, scene=scene, faces=len(mesh.faces), workers=workers)


def judge(
    tool: str, row: dict[str, Any], ours: dict[str, Any], times: list[float], our_times: list[float]
) -> dict[str, Any]:
    """Return the fields of a row that compare errors, from the tool's row and seconds and from warpsample's."""
    more = row["rmse"] / ours["rmse"]
    # Independent rays scale by their own rate; every other tool is compared with warpsample at the same error.
    factor = more**2 if tool == EMBREE else float(np.float_power(more, 1.0 / ours["rate"]))
    return {
        "times_ours": Spread.of_ratios([factor * t for t in times], our_times),
        "agrees": row["relative"] <= _MOST_RELATIVE if row["due"] is None else row["due"] <= _MOST_ERROR_RATIO,
    }


_CELLS = "rays took traces rmse times_ours due peak_megabytes"

RECORD = Benchmark(
    name="view-factors",
    summary="Compare the view factors of a mesh by warpsample, pyViewFactor, and NumPy with embreex.",
    measure=measure,
    parts={"rows": FactorTime},
    views=[
        TableView("rows", "View factors", "tool", _CELLS, split="scene faces workers", page_rows=select_all_workers),
    ],
    pictures=[Picture("view_factors", "rows", "took", y="rmse", panels="scene faces", where=select_all_workers, log="xy")],
)
