"""The jobs of the processes: each tool's estimate to an RMSE, and ours of many points."""

from importlib.metadata import version
from typing import Any

import numpy as np

from warpsample import sequences
from warpsample.bench.child import Job
from warpsample.bench.machine import peak_megabytes
from warpsample.bench.visibility.reference import points_of
from warpsample.bench.visibility.tools import ESTIMATORS, Ours
from warpsample.mesh.surface import SurfacePoints

_TRIAL = 64
_TRIALS = 2


def build_estimate(
    tool: str, scene: str, points: int, workers: int, target: float, reference: str, open_points: bool
) -> Job:
    """A tool's estimate by as many rays as take it to an RMSE; it looks for that number first.

    Args:
        tool: of ESTIMATORS.
        scene: of SCENES.
        points: on it.
        workers: threads.
        target: the RMSE over all points.
        reference: an .npy file of the right values.
        open_points: whether, once the number is known, the points that the reference calls open are estimated, repeated.
    """
    library, make = ESTIMATORS[tool]
    mesh, at = points_of(scene, points)
    right = np.load(reference, allow_pickle=False)
    run = make(mesh, at, workers)
    rate = sequences.get("fibonacci" if library.startswith("warp") else "independent").rate
    count = _TRIAL
    for _ in range(_TRIALS):
        error = float(np.sqrt(np.mean((run(count) - right) ** 2)))
        count = max(2, round(count * float(np.float_power(error / target, 1.0 / rate))))
    if open_points:
        chosen = np.resize(np.flatnonzero(right == 1.0), points)  # as many, so that what a call costs weighs the same
        at = SurfacePoints(at.position[chosen], at.normal[chosen], at.face[chosen])
        run, right = make(mesh, at, workers), right[chosen]
    values: list[np.ndarray] = []

    def work() -> None:
        values[:] = [run(count)]

    def report() -> dict[str, Any]:
        cast = float(run.last.rays.mean()) if isinstance(run, Ours) and run.last else float(count)
        error = float(np.sqrt(np.mean((values[0] - right) ** 2)))
        told = {"version": version(library), "count": count, "cast": cast, "rmse": error, "points": len(right)}
        return {**told, "to_target": 1.0 if open_points else float(np.float_power(error / target, 1.0 / rate))}

    return Job(work, report)


def build_many_points(scene: str, points: int, rays: int, workers: int) -> Job:
    """Our estimate by its defaults, and the memory of all its process: Python, mesh and points included."""
    mesh, at = points_of(scene, points)
    few = SurfacePoints(at.position[:64], at.normal[:64])
    run, warm = Ours(mesh, at, workers), Ours(mesh, few, workers)
    return Job(lambda: run(rays), lambda: {"peak_megabytes": peak_megabytes()}, lambda: warm(rays))
