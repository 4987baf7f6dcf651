"""`bench radiation`: cost of sky matrices, sun positions and a year's irradiation, with Radiance and Mitsuba."""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import partial
from importlib.metadata import version
from typing import Annotated, Any

import numpy as np
import typer

from warpsample.bench.record import Benchmark, Picture, Repeats, RowsByPart, Scenes, Track
from warpsample.bench.reporting.tables import TableView, select_all_workers
from warpsample.bench.rows import Spread, ToolRow, column, format_digits, optional_column
from warpsample.bench.running.child import ChildJob
from warpsample.bench.running.machine import measure_peak_megabytes
from warpsample.bench.running.timing import build_stopwatch
from warpsample.bench.running.turns import keep_last_result, run_tools
from warpsample.bench.scenes import compute_year_of_suns, sample_clear_points
from warpsample.bench.tools.sky import OURS, SKY_TOOLS, VIEW
from warpsample.bench.tools.sun import SUN_TOOLS, TRACE
from warpsample.host.engine import check_workers
from warpsample.mesh.mesh import Mesh
from warpsample.mesh.surface import SurfacePoints
from warpsample.radiation.sky.sky_matrix import sky_matrix
from warpsample.radiation.weather.irradiation import irradiation
from warpsample.tracing.trace import trace

DEFAULT_SCENES = ("city", "bunny", "hills")
RAYS = 1024  # rays per point of a sky matrix
MOST_ERROR_RATIO = 1.5  # mean square error over the variance of the runs; about 1 for a correct tool

_REFERENCE_RAYS, _REFERENCE_SEED = 1 << 16, 1 << 40  # far from the seeds of the estimates
_MOST_DIFFERENT = 0.002  # of all pairs: ray origins differ between tools, so suns near an edge can differ
_WEATHER = "athens"
_FEW = 16  # points of the run that shows the fixed cost of a year
_FEWEST, _FIXED_RUNS, _RUNS, _FEWER = 2, 3, 2, 4


@dataclass(frozen=True)
class SkyTime(ToolRow):
    """Row of `bench radiation`: time and error of one tool that computes each point's visible share of 145 sky patches.

    Each point casts 1,024 rays.
    """

    scene: str = column("scene")
    workers: int = column("threads")
    microseconds: Spread | None = optional_column("µs per point")
    views: Spread | None = optional_column(
        "time / sky_view_factor", "time divided by that of `sky_view_factor` with the same number of rays, in the same round"
    )
    rmse: float | None = optional_column(
        "RMSE", "root mean square error of the visible shares, over points and patches", show=".1e"
    )
    rate: float | None = optional_column(
        "convergence rate", "r if the RMSE falls as (number of rays)^-r, measured with all rays and with a quarter of them"
    )
    times_ours: Spread | None = optional_column(
        "time / warpsample", "time to warpsample's RMSE, by the tool's own convergence rate, divided by warpsample's time"
    )
    apart: float | None = optional_column(
        "error² / variance", "mean square error of the mean of two runs, divided by its variance; about 1 without bias"
    )
    agrees: bool | None = optional_column("agrees", f"yes if error² / variance is at most {MOST_ERROR_RATIO:g}")


@dataclass(frozen=True)
class SunTime(ToolRow):
    """Row of `bench radiation`: time of one tool to test a year of sun positions from all points of one scene.

    Suns behind the points count, too.
    """

    scene: str = column("scene")
    workers: int = column("threads")
    pairs: int = column("pairs", "points times sun positions, also positions behind the points")
    million_pairs: Spread | None = optional_column("million pairs per second", "pairs of a point and a sun position")
    traces: Spread | None = optional_column(
        "time / ws.trace", "time divided by that of `ws.trace` for all pairs, in the same round"
    )
    different: float | None = optional_column(
        "pairs that differ", "fraction of the pairs for which the tool and `ws.trace` differ", show=".1e"
    )
    agrees: bool | None = optional_column(
        "agrees", f"yes if at most {_MOST_DIFFERENT:g} of the pairs differ; none for warpsample"
    )


@dataclass(frozen=True)
class YearTime(ToolRow):
    """Row of `bench radiation`: time of a year's irradiation of a scene, in a separate process.

    The computation uses the sun of each hour and 2,305 sky patches.
    """

    scene: str = column("scene")
    workers: int = column("threads")
    points: int = column("points")
    took: float | None = optional_column("seconds", "time of one run for all points", show=format_digits)
    fewer_seconds: float | None = optional_column(
        "seconds for 16 points", "an earlier run in the same process, which shows the fixed cost", show=format_digits
    )
    peak_megabytes: float | None = optional_column(
        "peak memory, MB", "peak memory of the process, with Python and mesh", show=".0f"
    )


def build_sky(tool: str, scene: str, points: int, *, rays: int, workers: int, reference: np.ndarray) -> ChildJob:
    """Prepare one tool to compute the sky matrix of Tregenza's 145 patches, and return the work to time.

    The job's report compares the matrix with the reference.
    """
    make = SKY_TOOLS[tool].make
    mesh, at = sample_clear_points(scene, points)
    run = make(mesh, at, workers)
    fixed = build_stopwatch(lambda: run(_FEWEST, 1))

    def report() -> dict[str, Any]:
        if tool == VIEW:
            return {}
        tool_again = make(mesh, at, workers)  # a new tool: the number of timed runs, and so the next seed, depends on speed
        mse, variance, apart = compute_errors(tool_again(rays, _RUNS), reference)
        fewer, _, _ = compute_errors(tool_again(rays // _FEWER, _RUNS), reference)
        return {
            "rmse": float(np.sqrt(mse)),
            "rate": float(0.5 * np.log(fewer / mse) / np.log(_FEWER)),
            "apart": float(apart / variance),
            "fixed": float(np.median([fixed() for _ in range(_FIXED_RUNS)])),
        }

    return ChildJob(lambda: run(rays, 1), report, lambda: run(_FEWEST, 1))


def compute_errors(runs: np.ndarray, right: np.ndarray) -> tuple[float, float, float]:
    """Return the mean square errors of one run and of the mean of all runs, and the variance of that mean.

    The order is (mean square error of a run, variance of the mean, mean square error of the mean).
    """
    runs = runs.astype(np.float64)
    mean = runs.mean(axis=0)
    variance = np.mean(runs.var(axis=0, ddof=1)) / len(runs)
    return float(np.mean((runs - right) ** 2)), float(variance), float(np.mean((mean - right) ** 2))


def build_sun(tool: str, scene: str, points: int, *, workers: int, reference: np.ndarray) -> ChildJob:
    """Prepare one tool to test which sun positions of a year the points see, and return the work to time.

    The job's report compares the result with the reference (P, T) bool.
    """
    work, lit = keep_last_result(SUN_TOOLS[tool].make(*sample_clear_points(scene, points), compute_year_of_suns(), workers))
    return ChildJob(work, lambda: {"different": float(np.mean(lit() != reference))})


def build_year(tool: str, scene: str, points: int, workers: int) -> ChildJob:
    """Prepare the computation of a year's irradiation under 2,305 sky patches, and return the work to time.

    The argument `tool` is the weather. The report has the peak memory and the seconds for 16 points.
    """
    mesh, at = sample_clear_points(scene, points)
    year = partial(irradiation, mesh, weather=tool, patches="reinhart4", workers=workers)
    few = build_stopwatch(lambda: year(at.take(slice(_FEW))))()
    return ChildJob(lambda: year(at), lambda: {"fewer_seconds": few, "peak_megabytes": measure_peak_megabytes()})


def compute_sky_reference(mesh: Mesh, points: SurfacePoints, workers: int) -> np.ndarray:
    """Compute the reference sky matrix (P, 145) float64 by `sky_matrix` with 65,536 rays per point.

    The tools use 1,024 rays per point and another seed.
    """
    matrix = sky_matrix(mesh, points, _REFERENCE_RAYS, seed=_REFERENCE_SEED, workers=workers)
    return matrix.value.astype(np.float64)


def measure(
    track: Track,
    *,
    scene: Scenes = None,
    points: Annotated[int, typer.Option(help="Number of points on each scene, placed uniformly by area.", min=16)] = 256,
    year_points: Annotated[int, typer.Option(help="Number of points of the year's irradiation.", min=64)] = 4096,
    repeats: Repeats = 3,
) -> RowsByPart:
    """Measure sky matrices, sun positions and a year's irradiation on each scene; return the rows.

    The hills have no suns, and only the first scene has a year.
    """
    names = scene or list(DEFAULT_SCENES)
    rows: RowsByPart = {"sky": [], "sun": []}
    threads = sorted({1, check_workers(None)})
    for name in track(names, len(names)):
        for workers in threads:
            rows["sky"].extend(compare_skies(name, points, workers, repeats, list(SKY_TOOLS)))
            if name != "hills":
                rows["sun"].extend(compare_suns(name, points, workers, repeats, list(SUN_TOOLS)))
    return rows | {"year": measure_year(names[0], year_points, threads[-1])}


def compare_skies(scene: str, points: int, workers: int, repeats: int, tools: Sequence[str]) -> list[SkyTime]:
    """Measure the sky matrices of several tools on one scene, with alternating runs."""
    right = compute_sky_reference(*sample_clear_points(scene, points), workers)
    turns = run_tools(build_sky, tools, repeats, scene=scene, workers=workers, points=points, rays=RAYS, reference=right)

    def figures(tool: str) -> dict[str, Any]:
        seconds, facts = turns.seconds[tool], turns.reports[tool]
        each, views = Spread.of([1e6 * t / points for t in seconds]), Spread.of_ratios(seconds, turns.seconds[VIEW])
        row = {"version": version(SKY_TOOLS[tool].library), "microseconds": each, "views": views}
        if tool == VIEW:
            return row
        times = compare_at_equal_error(seconds, facts, turns.seconds[OURS], turns.reports[OURS])
        fields = {name: facts[name] for name in ("rmse", "rate", "apart")}
        return {**row, **fields, "times_ours": times, "agrees": facts["apart"] <= MOST_ERROR_RATIO}

    return turns.rows(SkyTime, figures, scene=scene, workers=workers)


def compare_at_equal_error(
    seconds: list[float], facts: dict[str, float], ours: list[float], our_facts: dict[str, float]
) -> Spread:
    """Compute the ratio of a tool's time to warpsample's time, both scaled to the RMSE of warpsample.

    The rays are extrapolated by the tool's own rate; the fixed time of a run is not.
    """
    more = float(np.float_power(facts["rmse"] / our_facts["rmse"], 1.0 / facts["rate"]))
    equal_times = [min(facts["fixed"], t) + more * max(0.0, t - facts["fixed"]) for t in seconds]
    return Spread.of_ratios(equal_times, ours)


def compare_suns(scene: str, points: int, workers: int, repeats: int, tools: Sequence[str]) -> list[SunTime]:
    """Measure several tools that test a year of sun positions on one scene, with alternating runs."""
    mesh, at = sample_clear_points(scene, points)
    suns = compute_year_of_suns()
    directions = np.array(np.broadcast_to(suns, (points, *suns.shape)))
    lit = (trace(mesh, at, directions, any_hit=True).face < 0) & (at.normal @ suns.T > 0.0)
    turns = run_tools(build_sun, tools, repeats, scene=scene, points=points, workers=workers, reference=lit)

    def figures(tool: str) -> dict[str, Any]:
        seconds, facts = turns.seconds[tool], turns.reports[tool]
        library = SUN_TOOLS[tool].library
        most = 0.0 if library == "warpsample" else _MOST_DIFFERENT
        pairs, traces = Spread.of([lit.size / t / 1e6 for t in seconds]), Spread.of_ratios(seconds, turns.seconds[TRACE])
        fields = {"different": facts["different"], "agrees": facts["different"] <= most}
        return {"version": version(library), "million_pairs": pairs, "traces": traces, **fields}

    return turns.rows(SunTime, figures, scene=scene, workers=workers, pairs=lit.size)


def measure_year(scene: str, points: int, workers: int) -> list[YearTime]:
    """Measure a year's irradiation of 16 points and then of all points, in one process."""
    turns = run_tools(build_year, [_WEATHER], 0, scene=scene, points=points, workers=workers)
    case = {"scene": scene, "workers": workers, "points": points}
    return turns.rows(YearTime, lambda weather: {"took": turns.seconds[weather][0], **turns.reports[weather]}, **case)


def _select_for_page(rows: list[Any]) -> list[Any]:
    return [row for row in select_all_workers(rows) if row.scene == "city"]


_BY_SCENE = {"lines": "tool", "split": "scene workers", "page_rows": _select_for_page}

RECORD = Benchmark(
    name="radiation",
    summary="Compare sky matrices and sun positions by warpsample, Radiance's rcontrib and Mitsuba.",
    measure=measure,
    parts={"sky": SkyTime, "sun": SunTime, "year": YearTime},
    views=[
        TableView(
            "sky",
            f"Sky matrix, {RAYS:,} rays per point",
            cells="microseconds views rmse times_ours apart",
            **_BY_SCENE,
        ),
        TableView("sun", "Visibility of a year's sun positions", cells="million_pairs traces different", **_BY_SCENE),
        TableView("year", "A year's irradiation", "scene workers points", "took fewer_seconds peak_megabytes"),
    ],
    pictures=[Picture("radiation", "sky", "microseconds", y="rmse", panels="scene", where=select_all_workers, log="xy")],
)
