"""Sky matrices and suns by each tool, in turns; and a year of ours."""

import tempfile
from collections.abc import Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Annotated

import numpy as np
import typer

from warpsample.bench.radiation.jobs import FEW, build_sky, build_sun, build_year
from warpsample.bench.radiation.scene import points_of, sky_reference, year_of_suns
from warpsample.bench.radiation.sky_tools import OURS, SKY_TOOLS, VIEW
from warpsample.bench.radiation.sun_tools import SUN_TOOLS, TRACE
from warpsample.bench.record import Repeats, Track
from warpsample.bench.scenes import check_scenes
from warpsample.bench.timing import Spread
from warpsample.bench.turns import take_turns
from warpsample.host.engine import check_workers
from warpsample.tracing.trace import trace

DEFAULT_SCENES = ("city", "bunny", "hills")
RAYS = 1024
"""Of each point, for the sky."""

_MOST_APART = 1.5  # mean square error over the runs' own variance; about 1 where the tool is right
_MOST_DIFFERENT = 0.002  # of all pairs: suns behind an edge, as seen from where each tool starts its rays
_WEATHER = "athens"
_MANY = 100_000


@dataclass(frozen=True)
class Settings:
    """Of the command."""

    scene: Annotated[list[str] | None, typer.Option(help="Only this one; may be repeated.", show_default=False)] = None
    points: Annotated[int, typer.Option(help="Points on each scene.", min=16)] = 256
    year_points: Annotated[int, typer.Option(help="Points whose year is computed.", min=64)] = 4096
    repeats: Repeats = 3

    def __post_init__(self) -> None:
        """Refuses unknown scenes."""
        check_scenes(self.scene)


@dataclass(frozen=True)
class Sky:
    """One tool's sky matrix on one scene, 1,024 rays a point.

    Attributes:
        scene: its name.
        workers: threads.
        tool: its name.
        failure: why there is nothing, then the rest is None.
        version: of its library.
        microseconds: per point.
        views: how many times as long as `sky_view_factor` with as many rays, in the same round.
        rmse: over points and patches; None for `sky_view_factor`, which has none.
        rate: the power of the rays by which it falls, from a quarter of them on.
        times_ours: as long as ours to the RMSE of ours, extrapolated: what its rays take, times as many more of them.
        apart: mean square error of the mean of two runs over their own variance, about 1.
        agrees: whether that is below 1.5.
        seconds: of each repeat; none where they were not kept.
    """

    scene: str
    workers: int
    tool: str
    failure: str | None = None
    version: str | None = None
    microseconds: Spread | None = None
    views: Spread | None = None
    rmse: float | None = None
    rate: float | None = None
    times_ours: Spread | None = None
    apart: float | None = None
    agrees: bool | None = None
    seconds: list[float] = field(default_factory=list)


@dataclass(frozen=True)
class Sun:
    """One tool and the suns of a year.

    Attributes:
        scene: its name.
        workers: threads.
        tool: its name.
        pairs: points times suns.
        failure: why there is nothing, then the rest is None.
        version: of its library.
        million_pairs: a second.
        traces: how many times as long as `ws.trace` takes for all pairs, in the same round.
        different: share of the pairs in which it differs from `ws.trace`.
        agrees: whether that is below 0.002; ours must have none.
        seconds: of each repeat; none where they were not kept.
    """

    scene: str
    workers: int
    tool: str
    pairs: int
    failure: str | None = None
    version: str | None = None
    million_pairs: Spread | None = None
    traces: Spread | None = None
    different: float | None = None
    agrees: bool | None = None
    seconds: list[float] = field(default_factory=list)


@dataclass(frozen=True)
class Year:
    """A year's irradiation of a scene, ours, in a process of its own.

    Attributes:
        scene: its name.
        workers: threads.
        points: on it.
        fewer: points of another run in the same process.
        failure: why there is nothing, then the rest is None.
        seconds: of all points.
        fewer_seconds: of the fewer.
        peak_megabytes: greatest resident memory of the process, everything included; None where unknown.
    """

    scene: str
    workers: int
    points: int
    fewer: int
    failure: str | None = None
    seconds: float | None = None
    fewer_seconds: float | None = None
    peak_megabytes: float | None = None

    def extrapolated(self, points: int = _MANY) -> float | None:
        """Seconds of so many points, on the line through both; None if there is nothing."""
        if self.seconds is None or self.fewer_seconds is None:
            return None
        each = (self.seconds - self.fewer_seconds) / (self.points - self.fewer)
        return self.seconds + each * (points - self.points)


@dataclass(frozen=True)
class Found:
    """Of sky, sun and year."""

    sky: list[Sky]
    sun: list[Sun]
    year: list[Year]


def measure(settings: Settings, track: Track) -> Found:
    """Scene by scene; suns but for the hills, the year of the first."""
    names = settings.scene or list(DEFAULT_SCENES)
    found = Found([], [], [])
    threads = sorted({1, check_workers(None)})
    for scene in track(names, len(names)):
        for workers in threads:
            found.sky.extend(compare_skies(scene, settings.points, workers, settings.repeats))
            if scene != "hills":
                found.sun.extend(compare_suns(scene, settings.points, workers, settings.repeats))
    found.year.append(measure_year(names[0], settings.year_points, threads[-1]))
    return found


def compare_skies(scene: str, points: int, workers: int, repeats: int, tools: Sequence[str] = tuple(SKY_TOOLS)) -> list[Sky]:
    """The tools' sky matrices, taking turns."""
    right = sky_reference(*points_of(scene, points), workers)
    with tempfile.TemporaryDirectory() as folder:
        reference = Path(folder) / "reference.npy"
        np.save(reference, right, allow_pickle=False)
        same = {"scene": scene, "points": points, "workers": workers, "rays": RAYS, "reference": str(reference)}
        turns = take_turns(build_sky, tools, repeats, **same)
    rows = [Sky(scene, workers, tool, failure) for tool, failure in turns.failures.items()]
    for tool, seconds in turns.seconds.items():
        told = turns.told[tool]
        rows.append(
            Sky(
                scene,
                workers,
                tool,
                version=told["version"],
                microseconds=Spread.of([1e6 * t / points for t in seconds]),
                views=Spread.of_ratios(seconds, turns.seconds[VIEW]),
                rmse=told.get("rmse"),
                rate=told.get("rate"),
                times_ours=None if tool == VIEW else at_equal_error(seconds, told, turns.seconds[OURS], turns.told[OURS]),
                apart=told.get("apart"),
                agrees=None if tool == VIEW else bool(told["apart"] <= _MOST_APART),
                seconds=seconds,
            )
        )
    return rows


def at_equal_error(seconds: list[float], told: dict[str, float], ours: list[float], ours_told: dict[str, float]) -> Spread:
    """How many times as long as ours a tool takes to the RMSE of ours."""
    more = float(np.float_power(told["rmse"] / ours_told["rmse"], 1.0 / told["rate"]))
    due = [min(told["fixed"], t) + more * max(0.0, t - told["fixed"]) for t in seconds]
    return Spread.of_ratios(due, ours)


def compare_suns(scene: str, points: int, workers: int, repeats: int, tools: Sequence[str] = tuple(SUN_TOOLS)) -> list[Sun]:
    """The tools and a year of suns, taking turns."""
    mesh, at = points_of(scene, points)
    suns = year_of_suns()
    directions = np.array(np.broadcast_to(suns, (points, *suns.shape)))
    lit = (trace(mesh, at, directions, any_hit=True).face < 0) & (at.normal @ suns.T > 0.0)
    pairs = lit.size
    with tempfile.TemporaryDirectory() as folder:
        reference = Path(folder) / "reference.npy"
        np.save(reference, np.packbits(lit, axis=1), allow_pickle=False)
        turns = take_turns(build_sun, tools, repeats, scene=scene, points=points, workers=workers, reference=str(reference))
    rows = [Sun(scene, workers, tool, pairs, failure) for tool, failure in turns.failures.items()]
    for tool, seconds in turns.seconds.items():
        different = turns.told[tool]["different"]
        rows.append(
            Sun(
                scene,
                workers,
                tool,
                pairs,
                version=turns.told[tool]["version"],
                million_pairs=Spread.of([pairs / t / 1e6 for t in seconds]),
                traces=Spread.of_ratios(seconds, turns.seconds[TRACE]),
                different=different,
                agrees=different <= (0.0 if SUN_TOOLS[tool][0] == "warpsample" else _MOST_DIFFERENT),
                seconds=seconds,
            )
        )
    return rows


def measure_year(scene: str, points: int, workers: int) -> Year:
    """Of 16 points and then of all, in one process."""
    run = take_turns(build_year, [_WEATHER], 0, scene=scene, points=points, workers=workers)
    if run.failures:
        return Year(scene, workers, points, FEW, run.failures[_WEATHER])
    told = run.told[_WEATHER]
    return Year(scene, workers, points, FEW, None, told["seconds"], told["few_seconds"], told["peak_megabytes"])
