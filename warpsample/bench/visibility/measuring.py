"""How long ambient occlusion takes to an RMSE: ours, with and without skipping, and other tools, all cores each."""

import tempfile
from collections.abc import Sequence
from contextlib import ExitStack, suppress
from dataclasses import dataclass, field
from pathlib import Path
from typing import Annotated, Any

import numpy as np
import typer

from warpsample.bench.child import Child
from warpsample.bench.record import Repeats, Track
from warpsample.bench.scenes import check_scenes
from warpsample.bench.timing import Spread, interleave
from warpsample.bench.visibility.jobs import build_estimate, build_many_points
from warpsample.bench.visibility.reference import Confirmation, confirm, points_of, reference_of
from warpsample.bench.visibility.tools import ESTIMATORS
from warpsample.host.engine import check_workers

OURS = ["warpsample", "warpsample, skip=False"]
TARGETS = {0.01: list(ESTIMATORS), 0.003: [*OURS, "Mitsuba", "embreex"]}
"""RMSE, and who is to reach it: the fastest two peers where they take 8,000 rays a point."""

DEFAULT_SCENES = ("bunny", "city", "hills")
MANY = 256
"""How many times as many points, by as many rays each, are estimated for their memory."""


@dataclass(frozen=True)
class Settings:
    """Of the command."""

    scene: Annotated[list[str] | None, typer.Option(help="Only this one; may be repeated.", show_default=False)] = None
    points: Annotated[int, typer.Option(help="Points on each scene.", min=16)] = 4096
    repeats: Repeats = 3

    def __post_init__(self) -> None:
        """Refuses unknown scenes."""
        check_scenes(self.scene)


@dataclass(frozen=True)
class TimeToError:
    """One tool on one scene.

    Attributes:
        scene: its name.
        target: the RMSE asked for.
        tool: its name.
        version: of its library.
        workers: threads.
        points: estimated.
        open_points: whether these are those that see nothing but sky, repeated, or all.
        rays: of each point.
        cast: of these, cast, on average.
        rmse: reached.
        microseconds: per point, to the RMSE asked for: by the tool's own rate, from the one reached.
        times_ours: as long as ours takes to it.
        seconds: of each repeat, to the RMSE reached; none where they were not kept.
        failure: why there is nothing, then the figures are None.
    """

    scene: str
    target: float
    tool: str
    open_points: bool
    workers: int
    failure: str | None = None
    version: str | None = None
    points: int | None = None
    rays: int | None = None
    cast: float | None = None
    rmse: float | None = None
    microseconds: Spread | None = None
    times_ours: Spread | None = None
    seconds: list[float] = field(default_factory=list)


@dataclass(frozen=True)
class Many:
    """Our estimate of many points, in a process of its own.

    Attributes:
        scene: its name.
        points: on it.
        rays: of each.
        workers: threads.
        peak_megabytes: greatest resident memory of the process, Python, Warp, mesh and points included; None where unknown.
        seconds: of one run.
    """

    scene: str
    points: int
    rays: int
    workers: int
    peak_megabytes: float | None
    seconds: float


@dataclass(frozen=True)
class Found:
    """Of every scene and tool; of many points; and of the reference, where embreex is installed."""

    rows: list[TimeToError]
    many: list[Many]
    confirmed: list[Confirmation]


def measure_many(scene: str, points: int, rays: int) -> Many:
    """Time and memory of many points."""
    workers = check_workers(None)
    same = {"scene": scene, "points": points, "rays": rays, "workers": workers}
    with Child(build_many_points, **same) as child:
        seconds = child.run()
        return Many(**same, peak_megabytes=child.report()["peak_megabytes"], seconds=seconds)


def measure(settings: Settings, track: Track) -> Found:
    """Scene by scene, then many points on the first."""
    names = settings.scene or list(DEFAULT_SCENES)
    found = Found([], [], [])
    for scene in track(names, len(names)):
        measure_scene(scene, settings, found)
    found.many.append(measure_many(names[0], MANY * settings.points, MANY))
    return found


def measure_scene(
    scene: str, settings: Settings, found: Found, targets: dict[float, list[str]] = TARGETS, ours: Sequence[str] = OURS
) -> None:
    """Adds what is found on a scene.

    Args:
        scene: its name.
        settings: points and repeats.
        found: to be added to.
        targets: tools by the RMSE that they are to reach.
        ours: tools for the points that see nothing but sky.
    """
    workers = check_workers(None)
    mesh, at = points_of(scene, settings.points)
    right = reference_of(mesh, at, workers)
    with suppress(ModuleNotFoundError):  # the tools' lines say that embreex is missing
        found.confirmed.append(confirm(scene, mesh, at, right, workers))
    with tempfile.TemporaryDirectory() as folder:
        reference = Path(folder) / "reference.npy"
        np.save(reference, right.values, allow_pickle=False)
        same = {"scene": scene, "points": settings.points, "workers": workers, "reference": str(reference)}
        for target, tools in targets.items():
            found.rows.extend(compare(tools, settings.repeats, **same, target=target, open_points=False))
        if (right.values == 1.0).any():
            found.rows.extend(compare(ours, settings.repeats, **same, target=min(targets), open_points=True))


def compare(tools: Sequence[str], repeats: int, **arguments: Any) -> list[TimeToError]:
    """Tools on one scene, taking turns.

    Args:
        tools: names, ours first.
        repeats: timed runs.
        **arguments: of `build_estimate`, but for the tool.
    """
    with ExitStack() as stack:
        children: dict[str, Child] = {}
        for tool in tools:  # one after the other: each looks for its number of rays, and that is to be undisturbed
            children[tool] = stack.enter_context(Child(build_estimate, tool=tool, **arguments))
            children[tool].wait_until_built()
        failures = {tool: child.wait_until_built() for tool, child in children.items()}
        able = {tool: child for tool, child in children.items() if failures[tool] is None}
        times, _ = interleave([child.run for child in able.values()], repeats)
        told = {tool: child.report() for tool, child in able.items()}
    seconds = dict(zip(able, times, strict=True))
    due = {tool: [t * told[tool]["to_target"] for t in seconds[tool]] for tool in able}
    same = {name: arguments[name] for name in ("scene", "target", "open_points", "workers")}
    rows = [TimeToError(tool=tool, failure=failure.reason, **same) for tool, failure in failures.items() if failure]
    for tool, found in told.items():
        rows.append(
            TimeToError(
                tool=tool,
                version=found["version"],
                points=found["points"],
                rays=found["count"],
                cast=found["cast"],
                rmse=found["rmse"],
                microseconds=Spread.of([1e6 * t / found["points"] for t in due[tool]]),
                times_ours=Spread.of_ratios(due[tool], due["warpsample"]),
                seconds=seconds[tool],
                **same,
            )
        )
    return rows
