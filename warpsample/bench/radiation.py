"""`bench radiation`: cost of sky matrices and sun positions beside Radiance and Mitsuba, and of a year's irradiation."""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import partial
from importlib.metadata import version
from typing import Annotated, Any

import numpy as np
import typer

from warpsample.bench.record import Benchmark, Picture, Repeats, RowsByPart, Scenes, Track
from warpsample.bench.rows import Spread, ToolRow, column, format_digits, optional_column
from warpsample.bench.running.child import ChildJob
from warpsample.bench.running.machine import measure_peak_megabytes
from warpsample.bench.running.timing import build_stopwatch
from warpsample.bench.running.turns import keep_last_result, run_tools
from warpsample.bench.scenes import compute_year_of_suns, sample_clear_points
from warpsample.bench.tables import TableView, select_all_workers
from warpsample.bench.tools.sky import OURS, SKY_TOOLS, VIEW
from warpsample.bench.tools.sun import SUN_TOOLS, TRACE
from warpsample.host.engine import check_workers
from warpsample.mesh.mesh import Mesh
from warpsample.mesh.surface import SurfacePoints
from warpsample.radiation.sky.sky_matrix import sky_matrix
from warpsample.radiation.weather.irradiation import irradiation
from warpsample.tracing.trace import trace

DEFAULT_SCENES = ("city", "bunny", "hills")
RAYS = 1024  # of each point, for the sky
MOST_ERROR_RATIO = 1.5  # mean square error over the runs' own variance; about 1 where a tool is right

_REFERENCE_RAYS, _REFERENCE_SEED = 1 << 16, 1 << 40  # far from those of the estimates
_MOST_DIFFERENT = 0.002  # of all pairs: suns behind an edge, as seen from where each tool starts its rays
_WEATHER = "athens"
_FEW = 16  # points whose year tells what a year costs whatever the points
_FEWEST, _FIXED_RUNS, _RUNS, _FEWER = 2, 3, 2, 4


@dataclass(frozen=True)
class SkyTime(ToolRow):
    """Time and error of one tool's matrix of 145 sky patches on one scene, with 1,024 rays per point."""

    scene: str = column("scene")
    workers: int = column("threads")
    microseconds: Spread | None = optional_column("µs per point")
    views: Spread | None = optional_column("/ sky_view_factor", "times as long, with as many rays, in the same round")
    rmse: float | None = optional_column("RMSE", "over points and patches", show=".1e")
    rate: float | None = optional_column("rate", "the power of the rays by which it falls, from a quarter of them on")
    times_ours: Spread | None = optional_column(
        "times ours", "as long as ours to the RMSE of ours, extrapolated by its own rate"
    )
    apart: float | None = optional_column(
        "error² / spread²", "square error of the mean of two runs over their own variance, about 1"
    )
    agrees: bool | None = optional_column("agrees", "whether that is below 1.5")


@dataclass(frozen=True)
class SunTime(ToolRow):
    """Time of one tool for the suns of a year, whether in front of or behind the points."""

    scene: str = column("scene")
    workers: int = column("threads")
    pairs: int = column("pairs", "points times suns, averted ones included")
    million_pairs: Spread | None = optional_column("million pairs a second")
    traces: Spread | None = optional_column("/ ws.trace", "times as long as it takes for all pairs, in the same round")
    different: float | None = optional_column("differ", "share of the pairs where `ws.trace` differs", show=".1e")
    agrees: bool | None = optional_column("agrees", "whether that is below 0.002; ours must have none")


@dataclass(frozen=True)
class YearTime(ToolRow):
    """Time of a year's irradiation of a scene, with the sun of each hour and 2,305 patches, in a separate process."""

    scene: str = column("scene")
    workers: int = column("threads")
    points: int = column("points")
    took: float | None = optional_column("s", show=format_digits)
    fewer_seconds: float | None = optional_column("s of 16 points", "of another run in the same process", show=format_digits)
    peak_megabytes: float | None = optional_column("peak memory, MB", "Python and mesh included", show=".0f")


def build_sky(tool: str, scene: str, points: int, *, rays: int, workers: int, reference: np.ndarray) -> ChildJob:
    """Build a tool's sky matrix of Tregenza's patches; the report compares the matrix with the reference."""
    make = SKY_TOOLS[tool].make
    mesh, at = sample_clear_points(scene, points)
    run = make(mesh, at, workers)
    fixed = build_stopwatch(lambda: run(_FEWEST, 1))

    def report() -> dict[str, Any]:
        if tool == VIEW:
            return {}
        judged = make(mesh, at, workers)  # anew: how many runs were timed, and so their seeds, is a matter of time
        mse, variance, apart = compute_errors(judged(rays, _RUNS), reference)
        fewer, _, _ = compute_errors(judged(rays // _FEWER, _RUNS), reference)
        return {
            "rmse": float(np.sqrt(mse)),
            "rate": float(0.5 * np.log(fewer / mse) / np.log(_FEWER)),
            "apart": float(apart / variance),
            "fixed": float(np.median([fixed() for _ in range(_FIXED_RUNS)])),
        }

    return ChildJob(lambda: run(rays, 1), report, lambda: run(_FEWEST, 1))


def compute_errors(found: np.ndarray, right: np.ndarray) -> tuple[float, float, float]:
    """Return (mean square error of a run, variance of the mean of the runs, mean square error of that mean)."""
    found = found.astype(np.float64)
    mean = found.mean(axis=0)
    variance = np.mean(found.var(axis=0, ddof=1)) / len(found)
    return float(np.mean((found - right) ** 2)), float(variance), float(np.mean((mean - right) ** 2))


def build_sun(tool: str, scene: str, points: int, *, workers: int, reference: np.ndarray) -> ChildJob:
    """Build a tool's test of a year's suns; the report compares the result with the reference (P, T) bool."""
    work, lit = keep_last_result(SUN_TOOLS[tool].make(*sample_clear_points(scene, points), compute_year_of_suns(), workers))
    return ChildJob(work, lambda: {"different": float(np.mean(lit() != reference))})


def build_year(tool: str, scene: str, points: int, workers: int) -> ChildJob:
    """Build a year of `irradiation` under 2,305 patches; `tool` is the weather.

    The report has the peak memory and the seconds for 16 points.
    """
    mesh, at = sample_clear_points(scene, points)
    year = partial(irradiation, mesh, weather=tool, patches="reinhart4", workers=workers)
    few = build_stopwatch(lambda: year(at.take(slice(_FEW))))()
    return ChildJob(lambda: year(at), lambda: {"fewer_seconds": few, "peak_megabytes": measure_peak_megabytes()})


def compute_sky_reference(mesh: Mesh, points: SurfacePoints, workers: int) -> np.ndarray:
    """Compute the reference (P, 145) float64 by `sky_matrix` with 65,536 rays in place of 1,024, and another seed."""
    found = sky_matrix(mesh, points, _REFERENCE_RAYS, seed=_REFERENCE_SEED, workers=workers)
    return found.value.astype(np.float64)


def measure(
    track: Track,
    *,
    scene: Scenes = None,
    points: Annotated[int, typer.Option(help="Points on each scene.", min=16)] = 256,
    year_points: Annotated[int, typer.Option(help="Points whose year is computed.", min=64)] = 4096,
    repeats: Repeats = 3,
) -> RowsByPart:
    """Measure one scene after the other; the hills have no suns, and the first scene has a year."""
    names = scene or list(DEFAULT_SCENES)
    found: RowsByPart = {"sky": [], "sun": []}
    threads = sorted({1, check_workers(None)})
    for name in track(names, len(names)):
        for workers in threads:
            found["sky"].extend(compare_skies(name, points, workers, repeats, list(SKY_TOOLS)))
            if name != "hills":
                found["sun"].extend(compare_suns(name, points, workers, repeats, list(SUN_TOOLS)))
    return found | {"year": measure_year(names[0], year_points, threads[-1])}


def compare_skies(scene: str, points: int, workers: int, repeats: int, tools: Sequence[str]) -> list[SkyTime]:
    """Compare the tools' sky matrices, with alternating runs."""
    right = compute_sky_reference(*sample_clear_points(scene, points), workers)
    turns = run_tools(build_sky, tools, repeats, scene=scene, workers=workers, points=points, rays=RAYS, reference=right)

    def figures(tool: str) -> dict[str, Any]:
        seconds, told = turns.seconds[tool], turns.reports[tool]
        each, views = Spread.of([1e6 * t / points for t in seconds]), Spread.of_ratios(seconds, turns.seconds[VIEW])
        row = {"version": version(SKY_TOOLS[tool].library), "microseconds": each, "views": views}
        if tool == VIEW:
            return row
        times = compare_at_equal_error(seconds, told, turns.seconds[OURS], turns.reports[OURS])
        judged = {name: told[name] for name in ("rmse", "rate", "apart")}
        return {**row, **judged, "times_ours": times, "agrees": told["apart"] <= MOST_ERROR_RATIO}

    return turns.rows(SkyTime, figures, scene=scene, workers=workers)


def compare_at_equal_error(
    seconds: list[float], told: dict[str, float], ours: list[float], ours_told: dict[str, float]
) -> Spread:
    """Compute the ratio of a tool's time to warpsample's time, both to the RMSE of warpsample.

    The rays are extrapolated by the tool's own rate; the fixed time of a run is not.
    """
    more = float(np.float_power(told["rmse"] / ours_told["rmse"], 1.0 / told["rate"]))
    due = [min(told["fixed"], t) + more * max(0.0, t - told["fixed"]) for t in seconds]
    return Spread.of_ratios(due, ours)


def compare_suns(scene: str, points: int, workers: int, repeats: int, tools: Sequence[str]) -> list[SunTime]:
    """Compare the tools on a year of suns, with alternating runs."""
    mesh, at = sample_clear_points(scene, points)
    suns = compute_year_of_suns()
    directions = np.array(np.broadcast_to(suns, (points, *suns.shape)))
    lit = (trace(mesh, at, directions, any_hit=True).face < 0) & (at.normal @ suns.T > 0.0)
    turns = run_tools(build_sun, tools, repeats, scene=scene, points=points, workers=workers, reference=lit)

    def figures(tool: str) -> dict[str, Any]:
        seconds, told = turns.seconds[tool], turns.reports[tool]
        library = SUN_TOOLS[tool].library
        most = 0.0 if library == "warpsample" else _MOST_DIFFERENT
        pairs, traces = Spread.of([lit.size / t / 1e6 for t in seconds]), Spread.of_ratios(seconds, turns.seconds[TRACE])
        judged = {"different": told["different"], "agrees": told["different"] <= most}
        return {"version": version(library), "million_pairs": pairs, "traces": traces, **judged}

    return turns.rows(SunTime, figures, scene=scene, workers=workers, pairs=lit.size)


def measure_year(scene: str, points: int, workers: int) -> list[YearTime]:
    """Measure the year of 16 points and then of all points, in one process."""
    turns = run_tools(build_year, [_WEATHER], 0, scene=scene, points=points, workers=workers)
    case = {"scene": scene, "workers": workers, "points": points}
    return turns.rows(YearTime, lambda weather: {"took": turns.seconds[weather][0], **turns.reports[weather]}, **case)


_BY_SCENE = {"lines": "tool", "split": "scene workers", "page_rows": select_all_workers}

RECORD = Benchmark(
    name="radiation",
    summary="Sky matrices and sun positions: ours, Radiance's rcontrib and Mitsuba; and a year's irradiation.",
    measure=measure,
    parts={"sky": SkyTime, "sun": SunTime, "year": YearTime},
    views=[
        TableView(
            "sky", f"Sky matrix, {RAYS:,} rays a point", cells="microseconds views rmse times_ours apart", **_BY_SCENE
        ),
        TableView("sun", "Suns of a year", cells="million_pairs traces different", **_BY_SCENE),
        TableView("year", "A year's irradiation", "scene workers points", "took fewer_seconds peak_megabytes"),
    ],
    pictures=[Picture("radiation", "sky", "microseconds", y="rmse", panels="scene", where=select_all_workers, log="xy")],
)
