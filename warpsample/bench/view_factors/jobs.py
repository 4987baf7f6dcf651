"""The jobs of the processes: all view factors of a scene by a tool, or the tracing of as many rays."""

from importlib.metadata import version
from time import perf_counter
from typing import Any

import numpy as np

from warpsample.bench.child import Job
from warpsample.bench.machine import peak_megabytes
from warpsample.bench.timing import stopwatch
from warpsample.bench.view_factors.scenes import scene_of
from warpsample.bench.view_factors.tools import OURS, TOOLS, TRACE, Embree, Ours, Trace
from warpsample.mesh.mesh import Mesh
from warpsample.radiation.exchange.view_factors import view_factors

REFERENCE_RAYS = 1 << 17
_REFERENCE_SEED = 1 << 40
_JUDGED = 256
_FEWER, _ANOTHER_SEED = 4, 1 << 30


def judged_faces(mesh: Mesh) -> np.ndarray:
    """Those whose rows are held against the reference, spread over all."""
    return np.unique(np.linspace(0, len(mesh.faces) - 1, _JUDGED).astype(int))


def reference_rows(mesh: Mesh, workers: int, rays: int = REFERENCE_RAYS, seed: int = _REFERENCE_SEED) -> np.ndarray:
    """(R, F) float64: the judged rows, by `view_factors` with many more rays and another seed."""
    faces = judged_faces(mesh)
    active = np.zeros(len(mesh.faces), bool)
    active[faces] = True
    return view_factors(mesh, rays, active=active, seed=seed, workers=workers).matrix[faces].toarray()


def build_factors(tool: str, scene: str, rays: int, fewer: int, workers: int, reference: str) -> Job:
    """All view factors of a scene.

    Args:
        tool: of TOOLS, or the tracing alone.
        scene: as `scene_of` takes it.
        rays: of each face.
        fewer: of each face, for embreex.
        workers: threads.
        reference: an .npy file of the judged rows.
    """
    mesh = scene_of(scene)
    faces = judged_faces(mesh)
    if tool == TRACE:
        alone = Trace(mesh, workers, faces, rays)
        alone.run(rays)
        first = stopwatch(lambda: alone.run(rays))()
        told = {"version": version("warpsample"), "rays": rays, "scale": len(mesh.faces) / len(faces), "first": first}
        return Job(lambda: alone.run(rays), lambda: told)
    library, make = TOOLS[tool]
    few = make(scene_of("boxes 1"), workers)
    few.run(16)  # kernels and compilers are loaded before memory is looked at
    used, independent = make(mesh, workers), tool == "embreex"
    count = fewer if independent else rays
    before = peak_megabytes()
    taken: list[float] = []

    def work() -> None:
        start = perf_counter()
        used.run(count)
        taken.append(perf_counter() - start)

    def report() -> dict[str, Any]:
        right = np.load(reference, allow_pickle=False)
        found = used.rows(faces)
        mse = float(np.mean((found - right) ** 2))
        peak = peak_megabytes()
        return {
            "version": version(library),
            "rmse": mse**0.5,
            "relative": (mse / float(np.mean(right**2))) ** 0.5,
            "due": _due(used, right, faces, count),
            "independent": independent,
            "rays": count,
            "rate": _rate(mesh, right, rays, mse, workers) if tool == OURS else None,
            "entries": used.entries(),
            "peak_megabytes": peak,
            "above": None if peak is None or before is None else peak - before,
            "scale": 1.0,
            "first": taken[0],
        }

    return Job(work, report, lambda: few.run(16))


def _due(used: Any, right: np.ndarray, faces: np.ndarray, rays: int) -> float | None:
    """The mean square error that is due: by our error bars, or that of independent rays; None without chance."""
    if isinstance(used, Ours):
        return used.told(faces)
    return float(np.mean(right * (1.0 - right))) / rays if isinstance(used, Embree) else None


def _rate(mesh: Mesh, right: np.ndarray, rays: int, mse: float, workers: int) -> float:
    """The power of the rays by which our RMSE falls, from a quarter of them on."""
    fewer = np.mean((reference_rows(mesh, workers, max(4, rays // _FEWER), seed=_ANOTHER_SEED) - right) ** 2)
    return float(0.5 * np.log(fewer / mse) / np.log(_FEWER))
