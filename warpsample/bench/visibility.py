"""How long ambient occlusion takes to an RMSE: ours, with and without skipping, and other tools, all cores each."""

import tempfile
from collections.abc import Iterator
from contextlib import ExitStack
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from warpsample.bench.child import Child
from warpsample.bench.timing import Spread, interleave
from warpsample.bench.visibility_jobs import TOOLS, points_of
from warpsample.estimate.visibility import ambient_occlusion
from warpsample.host.engine import check_workers

OURS = ["warpsample", "warpsample, skip=False"]
TARGETS = {0.01: list(TOOLS), 0.003: [*OURS, "Mitsuba", "embreex"]}
"""RMSE, and who is to reach it: the fastest two peers where they take 8,000 rays a point."""

SCENES = ("bunny", "city", "hills")

_REFERENCE_RAYS = 1 << 16  # their RMSE is 1.5e-4
_REFERENCE_SEED = 1 << 40


@dataclass(frozen=True)
class Row:
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
        seconds: of each repeat, to the RMSE reached.
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
    seconds: list[float] | None = None


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


def measure_many(scene: str, points: int, rays: int) -> Many:
    """Time and memory of many points."""
    workers = check_workers(None)
    same = {"scene": scene, "points": points, "rays": rays, "workers": workers}
    with Child("warpsample.bench.visibility_jobs:build_many", **same) as child:
        seconds = child.run()
        return Many(**same, peak_megabytes=child.report()["peak_megabytes"], seconds=seconds)


def measure(scenes: list[str], points: int, repeats: int) -> Iterator[list[Row]]:
    """The rows of one scene after the other.

    Args:
        scenes: names of `scenes.SCENES`.
        points: on each.
        repeats: timed runs.
    """
    workers = check_workers(None)
    for scene in scenes:
        mesh, at = points_of(scene, points)
        right = ambient_occlusion(mesh, at, _REFERENCE_RAYS, seed=_REFERENCE_SEED, workers=workers).value
        with tempfile.TemporaryDirectory() as folder:
            reference = Path(folder) / "reference.npy"
            np.save(reference, right)
            rows = []
            for target, tools in TARGETS.items():
                rows += _compare(scene, points, workers, target, reference, repeats, tools, open_points=False)
            if (right == 1.0).any():
                rows += _compare(scene, points, workers, min(TARGETS), reference, repeats, OURS, open_points=True)
            yield rows


def _compare(
    scene: str,
    points: int,
    workers: int,
    target: float,
    reference: Path,
    repeats: int,
    tools: list[str],
    open_points: bool,
) -> list[Row]:
    same = {"scene": scene, "target": target, "open_points": open_points, "workers": workers}
    arguments = {"points": points, "reference": str(reference), **same}
    with ExitStack() as stack:
        # One after the other: each looks for its number of rays, and that is to be undisturbed.
        children: dict[str, Child] = {}
        for tool in tools:
            children[tool] = stack.enter_context(Child("warpsample.bench.visibility_jobs:build", tool=tool, **arguments))
            _ = children[tool].failure
        able = {tool: child for tool, child in children.items() if child.failure is None}
        times, _ = interleave([child.run for child in able.values()], repeats)
        told = {tool: child.report() for tool, child in able.items()}
    seconds = dict(zip(able, times, strict=True))
    due = {tool: [t * told[tool]["to_target"] for t in seconds[tool]] for tool in able}
    rows = [Row(tool=tool, failure=child.failure, **same) for tool, child in children.items() if tool not in able]
    for tool, found in told.items():
        rows.append(
            Row(
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
