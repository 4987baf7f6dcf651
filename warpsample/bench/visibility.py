"""`bench visibility`: how long ambient occlusion takes to an RMSE: ours, with and without skipping, and other tools."""

from collections.abc import Sequence
from contextlib import suppress
from dataclasses import dataclass
from importlib.metadata import version
from typing import Annotated, Any

import numpy as np
import typer

from warpsample import sequences
from warpsample.bench.pictures import Picture
from warpsample.bench.record import Benchmark, Found, Repeats, Scenes, Track
from warpsample.bench.rows import Spread, Timed, column, digits, maybe
from warpsample.bench.running.child import Child, ChildJob
from warpsample.bench.running.machine import peak_megabytes
from warpsample.bench.running.turns import keeping_last, take_turns
from warpsample.bench.scenes import points_of, some_of
from warpsample.bench.tables import Cell, TableView
from warpsample.bench.tools.occlusion import ESTIMATORS, Estimator, Occlusion
from warpsample.bench.tools.reference import Confirmation, confirm, reference_of
from warpsample.host.engine import check_workers

OURS = ["warpsample", "warpsample, skip=False"]
TARGETS = {0.01: list(ESTIMATORS), 0.003: [*OURS, "Mitsuba", "embreex"]}
"""RMSE, and who is to reach it: the fastest two peers where they take 8,000 rays a point."""

DEFAULT_SCENES = ("bunny", "city", "hills")
MANY = 256
"""How many times as many points, by as many rays each, are estimated for their memory."""
_TRIAL, _TRIALS = 64, 2  # rays of the first trial; trials until the number of rays is known


@dataclass(frozen=True)
class TimeToError(Timed):
    """One tool on one scene, all its rays and everything before them, to an RMSE over all points."""

    scene: str = column("scene")
    target: float = column("RMSE", show="to {:g}".format)
    tool: str = column("tool")
    open_points: bool = column("points", show=lambda sky: "only points that see nothing but sky" if sky else "all points")
    workers: int = column("workers")
    failure: str | None = maybe("why it did not run")
    version: str | None = maybe("version")
    points: int | None = maybe("points")
    rays: int | None = maybe("rays", "of a point")
    cast: float | None = maybe("cast", "of these, cast on average", show=",.0f")
    rmse: float | None = maybe("RMSE", "the one reached", show=".4f")
    microseconds: Spread | None = maybe("µs", "of a point to the RMSE asked for, by its own rate from the one reached")
    times_ours: Spread | None = maybe("times ours", "as long as warpsample takes to it, within each round")


@dataclass(frozen=True)
class Many:
    """Our estimate of many points, in a process of its own."""

    scene: str = column("scene")
    points: int = column("points")
    rays: int = column("rays")
    workers: int = column("workers")
    peak_megabytes: float | None = column(
        "peak memory, MB", "of the process, Python, Warp, mesh and points included", show=",.0f"
    )
    seconds: float = column("s", show=digits)


def build_estimate(
    tool: str, scene: str, points: int, *, workers: int, target: float, reference: np.ndarray, open_points: bool
) -> ChildJob:
    """A tool's estimate by as many rays as take it to an RMSE over all points; it looks for that number first.

    For `open_points`, once the number is known, the points that `reference` calls open are estimated, repeated.
    """
    library, make, _ = ESTIMATORS[tool]
    mesh, at = points_of(scene, points)
    right = reference
    run: Estimator = make(mesh, at, workers)
    rate = sequences.get("fibonacci" if library.startswith("warp") else "independent").rate

    def more_rays(error: float) -> float:
        return float(np.float_power(error / target, 1.0 / rate))

    count = _TRIAL
    for _ in range(_TRIALS):
        count = max(2, round(count * more_rays(_rmse(run(count), right))))
    if open_points:
        chosen = np.resize(np.flatnonzero(right == 1.0), points)  # as many, so that what a call costs weighs the same
        run, right = make(mesh, some_of(at, chosen), workers), right[chosen]
    work, values = keeping_last(lambda: run(count))

    def report() -> dict[str, Any]:
        cast = float(run.last.rays.mean()) if isinstance(run, Occlusion) and run.last else float(count)
        error = _rmse(values(), right)
        told = {"version": version(library), "rays": count, "cast": cast, "rmse": error, "points": len(right)}
        return {"row": told, "to_target": 1.0 if open_points else more_rays(error)}

    return ChildJob(work, report)


def _rmse(found: np.ndarray, right: np.ndarray) -> float:
    return float(np.sqrt(np.mean((found - right) ** 2)))


def build_many_points(scene: str, points: int, rays: int, workers: int) -> ChildJob:
    """Our estimate by its defaults, and the memory of all its process: Python, mesh and points included."""
    mesh, at = points_of(scene, points)
    run, warm = Occlusion(mesh, at, workers), Occlusion(mesh, some_of(at, slice(64)), workers)
    return ChildJob(lambda: run(rays), lambda: {"peak_megabytes": peak_megabytes()}, lambda: warm(rays))


def measure(
    track: Track,
    *,
    scene: Scenes = None,
    points: Annotated[int, typer.Option(help="Points on each scene.", min=16)] = 4096,
    repeats: Repeats = 3,
) -> Found:
    """Scene by scene, then many points on the first."""
    names = scene or list(DEFAULT_SCENES)
    found: Found = {"rows": [], "many": [], "confirmed": []}
    for name in track(names, len(names)):
        measure_scene(name, points, repeats, found)
    found["many"].append(measure_many(names[0], MANY * points, MANY))
    return found


def measure_scene(
    scene: str,
    points: int,
    repeats: int,
    found: Found,
    *,
    targets: dict[float, list[str]] = TARGETS,
    ours: Sequence[str] = OURS,
) -> None:
    """Adds what is found on a scene, by the tools of each target; and by `ours` on points that see nothing but sky."""
    workers = check_workers(None)
    mesh, at = points_of(scene, points)
    right = reference_of(mesh, at, workers)
    with suppress(ModuleNotFoundError):  # the tools' lines say that embreex is missing
        found["confirmed"].append(confirm(scene, mesh, at, right, workers=workers))
    same = {"scene": scene, "points": points, "workers": workers, "reference": right.values}
    for target, tools in targets.items():
        found["rows"].extend(compare(tools, repeats, **same, target=target, open_points=False))
    if (right.values == 1.0).any():
        found["rows"].extend(compare(ours, repeats, **same, target=min(targets), open_points=True))


def compare(tools: Sequence[str], repeats: int, **arguments: Any) -> list[TimeToError]:
    """Tools on one scene, ours first, taking turns; the arguments are those of `build_estimate` but for the tool."""
    turns = take_turns(build_estimate, tools, repeats, **arguments)
    due = {tool: [t * told["to_target"] for t in turns.seconds[tool]] for tool, told in turns.told.items()}

    def figures(tool: str) -> dict[str, Any]:
        row = turns.told[tool]["row"]
        each = Spread.of([1e6 * t / row["points"] for t in due[tool]])
        return {**row, "microseconds": each, "times_ours": Spread.of_ratios(due[tool], due["warpsample"])}

    same = {name: arguments[name] for name in ("scene", "target", "open_points", "workers")}
    return turns.rows(TimeToError, figures, **same)


def measure_many(scene: str, points: int, rays: int) -> Many:
    """Time and memory of many points."""
    same = {"scene": scene, "points": points, "rays": rays, "workers": check_workers(None)}
    with Child(build_many_points, **same) as child:
        seconds = child.run()
        return Many(**same, peak_megabytes=child.report()["peak_megabytes"], seconds=seconds)


def _all_points(rows: list[TimeToError]) -> list[TimeToError]:
    return [row for row in rows if _of_all(row)]


def _of_all(row: TimeToError) -> bool:
    return bool(row.microseconds) and not row.open_points


def _of_open(row: TimeToError) -> bool:
    return bool(row.microseconds) and row.open_points


_TIME, _RATIO = Cell("microseconds", show=digits), Cell("times_ours", show=".1f")
_CONFIRMED = "points reference_rays embree_rays mean_difference mean_error rms worst agrees"
_SPLIT = "scene target open_points points"

RECORD = Benchmark(
    name="visibility",
    summary="Time to an RMSE of ambient occlusion: ours, with and without skipping, Mitsuba, embreex, trimesh and Open3D.",
    measure=measure,
    parts={"rows": TimeToError, "many": Many, "confirmed": Confirmation},
    views=[
        TableView("rows", "To an RMSE", "tool", "rays cast rmse microseconds times_ours", split=_SPLIT, brief=None),
        TableView("rows", "Microseconds of a point to an RMSE", "tool", [_TIME], across="scene target", where=_of_all),
        TableView("rows", "The same as a multiple of ours", "tool", [_RATIO], across="scene target", where=_of_all),
        TableView("rows", "Points that see nothing but sky", "tool", [_TIME, _RATIO], across="scene", where=_of_open),
        TableView("many", "Many points", "scene points rays workers", "seconds peak_megabytes"),
        TableView("confirmed", "The reference against Embree", "scene", _CONFIRMED),
    ],
    pictures=[
        Picture("visibility", "rows", "microseconds", panels="scene", down="target", told="times_ours", where=_all_points),
    ],
)
