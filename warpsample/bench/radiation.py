"""`bench radiation`: what sky and sun cost, beside Radiance and Mitsuba; and a year of ours."""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import partial
from importlib.metadata import version
from typing import Annotated, Any

import numpy as np
import typer

from warpsample.bench.record import Benchmark, Found, Picture, Repeats, Scenes, Track
from warpsample.bench.rows import Spread, ToolRow, column, digits, maybe
from warpsample.bench.running.child import ChildJob
from warpsample.bench.running.machine import peak_megabytes
from warpsample.bench.running.timing import stopwatch
from warpsample.bench.running.turns import keeping_last, take_turns
from warpsample.bench.scenes import clear_points_of, year_of_suns
from warpsample.bench.tables import TableView, all_workers
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
MOST_APART = 1.5  # mean square error over the runs' own variance; about 1 where a tool is right

_REFERENCE_RAYS, _REFERENCE_SEED = 1 << 16, 1 << 40  # far from those of the estimates
_MOST_DIFFERENT = 0.002  # of all pairs: suns behind an edge, as seen from where each tool starts its rays
_WEATHER = "athens"
_FEW = 16  # points whose year tells what a year costs whatever the points
_FEWEST, _FIXED_RUNS, _RUNS, _FEWER = 2, 3, 2, 4


@dataclass(frozen=True)
class SkyTime(ToolRow):
    """One tool's matrix of 145 sky patches on one scene, 1,024 rays a point."""

    scene: str = column("scene")
    workers: int = column("threads")
    microseconds: Spread | None = maybe("µs per point")
    views: Spread | None = maybe("/ sky_view_factor", "times as long, with as many rays, in the same round")
    rmse: float | None = maybe("RMSE", "over points and patches", show=".1e")
    rate: float | None = maybe("rate", "the power of the rays by which it falls, from a quarter of them on")
    times_ours: Spread | None = maybe("times ours", "as long as ours to the RMSE of ours, extrapolated by its own rate")
    apart: float | None = maybe("error² / spread²", "square error of the mean of two runs over their own variance, about 1")
    agrees: bool | None = maybe("agrees", "whether that is below 1.5")


@dataclass(frozen=True)
class SunTime(ToolRow):
    """One tool and the suns of a year, which are in front of or behind all points."""

    scene: str = column("scene")
    workers: int = column("threads")
    pairs: int = column("pairs", "points times suns, averted ones included")
    million_pairs: Spread | None = maybe("million pairs a second")
    traces: Spread | None = maybe("/ ws.trace", "times as long as it takes for all pairs, in the same round")
    different: float | None = maybe("differ", "share of the pairs where `ws.trace` differs", show=".1e")
    agrees: bool | None = maybe("agrees", "whether that is below 0.002; ours must have none")


@dataclass(frozen=True)
class YearTime(ToolRow):
    """A year's irradiation of a scene, ours, by the sun of each hour and 2,305 patches, in a process of its own."""

    scene: str = column("scene")
    workers: int = column("threads")
    points: int = column("points")
    took: float | None = maybe("s", show=digits)
    fewer_seconds: float | None = maybe("s of 16 points", "of another run in the same process", show=digits)
    peak_megabytes: float | None = maybe("peak memory, MB", "Python and mesh included", show=".0f")


def build_sky(tool: str, scene: str, points: int, *, rays: int, workers: int, reference: np.ndarray) -> ChildJob:
    """A tool's sky matrix of Tregenza's patches, held against the right values."""
    make = SKY_TOOLS[tool].make
    mesh, at = clear_points_of(scene, points)
    run = make(mesh, at, workers)
    fixed = stopwatch(lambda: run(_FEWEST, 1))

    def report() -> dict[str, Any]:
        if tool == VIEW:
            return {}
        judged = make(mesh, at, workers)  # anew: how many runs were timed, and so their seeds, is a matter of time
        mse, variance, apart = errors(judged(rays, _RUNS), reference)
        fewer, _, _ = errors(judged(rays // _FEWER, _RUNS), reference)
        return {
            "rmse": float(np.sqrt(mse)),
            "rate": float(0.5 * np.log(fewer / mse) / np.log(_FEWER)),
            "apart": float(apart / variance),
            "fixed": float(np.median([fixed() for _ in range(_FIXED_RUNS)])),
        }

    return ChildJob(lambda: run(rays, 1), report, lambda: run(_FEWEST, 1))


def errors(found: np.ndarray, right: np.ndarray) -> tuple[float, float, float]:
    """(mean square error of a run, variance of the runs' mean by their differences, its mean square error)."""
    found = found.astype(np.float64)
    mean = found.mean(axis=0)
    variance = np.mean(found.var(axis=0, ddof=1)) / len(found)
    return float(np.mean((found - right) ** 2)), float(variance), float(np.mean((mean - right) ** 2))


def build_sun(tool: str, scene: str, points: int, *, workers: int, reference: np.ndarray) -> ChildJob:
    """Which suns of a year points see, held against what is lit, (P, T) bool."""
    work, lit = keeping_last(SUN_TOOLS[tool].make(*clear_points_of(scene, points), year_of_suns(), workers))
    return ChildJob(work, lambda: {"different": float(np.mean(lit() != reference))})


def build_year(tool: str, scene: str, points: int, workers: int) -> ChildJob:
    """A year of `irradiation` under 2,305 patches, by the weather `tool`: seconds, also of few points, and memory."""
    mesh, at = clear_points_of(scene, points)
    year = partial(irradiation, mesh, weather=tool, patches="reinhart4", workers=workers)
    few = stopwatch(lambda: year(at.take(slice(_FEW))))()
    return ChildJob(lambda: year(at), lambda: {"fewer_seconds": few, "peak_megabytes": peak_megabytes()})


def sky_reference(mesh: Mesh, points: SurfacePoints, workers: int) -> np.ndarray:
    """The right values (P, 145) float64: by `sky_matrix` with 65,536 rays in place of 1,024, of another seed."""
    found = sky_matrix(mesh, points, _REFERENCE_RAYS, seed=_REFERENCE_SEED, workers=workers)
    return found.value.astype(np.float64)


def measure(
    track: Track,
    *,
    scene: Scenes = None,
    points: Annotated[int, typer.Option(help="Points on each scene.", min=16)] = 256,
    year_points: Annotated[int, typer.Option(help="Points whose year is computed.", min=64)] = 4096,
    repeats: Repeats = 3,
) -> Found:
    """Scene by scene; suns but for the hills, the year of the first."""
    names = scene or list(DEFAULT_SCENES)
    found: Found = {"sky": [], "sun": []}
    threads = sorted({1, check_workers(None)})
    for name in track(names, len(names)):
        for workers in threads:
            found["sky"].extend(compare_skies(name, points, workers, repeats, list(SKY_TOOLS)))
            if name != "hills":
                found["sun"].extend(compare_suns(name, points, workers, repeats, list(SUN_TOOLS)))
    return found | {"year": measure_year(names[0], year_points, threads[-1])}


def compare_skies(scene: str, points: int, workers: int, repeats: int, tools: Sequence[str]) -> list[SkyTime]:
    """The tools' sky matrices, taking turns."""
    right = sky_reference(*clear_points_of(scene, points), workers)
    turns = take_turns(build_sky, tools, repeats, scene=scene, workers=workers, points=points, rays=RAYS, reference=right)

    def figures(tool: str) -> dict[str, Any]:
        seconds, told = turns.seconds[tool], turns.told[tool]
        each, views = Spread.of([1e6 * t / points for t in seconds]), Spread.of_ratios(seconds, turns.seconds[VIEW])
        row = {"version": version(SKY_TOOLS[tool].library), "microseconds": each, "views": views}
        if tool == VIEW:
            return row
        times = at_equal_error(seconds, told, turns.seconds[OURS], turns.told[OURS])
        judged = {name: told[name] for name in ("rmse", "rate", "apart")}
        return {**row, **judged, "times_ours": times, "agrees": told["apart"] <= MOST_APART}

    return turns.rows(SkyTime, figures, scene=scene, workers=workers)


def at_equal_error(seconds: list[float], told: dict[str, float], ours: list[float], ours_told: dict[str, float]) -> Spread:
    """How many times as long as ours a tool takes to the RMSE of ours."""
    more = float(np.float_power(told["rmse"] / ours_told["rmse"], 1.0 / told["rate"]))
    due = [min(told["fixed"], t) + more * max(0.0, t - told["fixed"]) for t in seconds]
    return Spread.of_ratios(due, ours)


def compare_suns(scene: str, points: int, workers: int, repeats: int, tools: Sequence[str]) -> list[SunTime]:
    """The tools and a year of suns, taking turns."""
    mesh, at = clear_points_of(scene, points)
    suns = year_of_suns()
    directions = np.array(np.broadcast_to(suns, (points, *suns.shape)))
    lit = (trace(mesh, at, directions, any_hit=True).face < 0) & (at.normal @ suns.T > 0.0)
    turns = take_turns(build_sun, tools, repeats, scene=scene, points=points, workers=workers, reference=lit)

    def figures(tool: str) -> dict[str, Any]:
        seconds, told = turns.seconds[tool], turns.told[tool]
        library = SUN_TOOLS[tool].library
        most = 0.0 if library == "warpsample" else _MOST_DIFFERENT
        pairs, traces = Spread.of([lit.size / t / 1e6 for t in seconds]), Spread.of_ratios(seconds, turns.seconds[TRACE])
        judged = {"different": told["different"], "agrees": told["different"] <= most}
        return {"version": version(library), "million_pairs": pairs, "traces": traces, **judged}

    return turns.rows(SunTime, figures, scene=scene, workers=workers, pairs=lit.size)


def measure_year(scene: str, points: int, workers: int) -> list[YearTime]:
    """The year of 16 points and then of all, in one process."""
    turns = take_turns(build_year, [_WEATHER], 0, scene=scene, points=points, workers=workers)
    case = {"scene": scene, "workers": workers, "points": points}
    return turns.rows(YearTime, lambda weather: {"took": turns.seconds[weather][0], **turns.told[weather]}, **case)


_BY_SCENE = {"lines": "tool", "split": "scene workers", "brief": all_workers}

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
    pictures=[Picture("radiation", "sky", "microseconds", y="rmse", panels="scene", where=all_workers, log="xy")],
)
