"""The jobs of the processes: a sky matrix, a year of suns, a year's irradiation."""

from importlib.metadata import version
from time import perf_counter
from typing import Any

import numpy as np

from warpsample.bench.child import Job
from warpsample.bench.machine import peak_megabytes
from warpsample.bench.radiation.scene import points_of, year_of_suns
from warpsample.bench.radiation.sky_tools import SKY_TOOLS, VIEW
from warpsample.bench.radiation.sun_tools import SUN_TOOLS
from warpsample.bench.timing import stopwatch
from warpsample.mesh.surface import SurfacePoints
from warpsample.radiation.weather.irradiation import irradiation

FEW = 16
"""Points whose year tells what a year costs whatever the points."""

_FEWEST, _FIXED_RUNS, _RUNS, _FEWER = 2, 3, 2, 4


def build_sky(tool: str, scene: str, points: int, rays: int, workers: int, reference: str) -> Job:
    """A tool's sky matrix of Tregenza's patches.

    Args:
        tool: of SKY_TOOLS.
        scene: of SCENES.
        points: on it.
        rays: of each point.
        workers: threads.
        reference: an .npy file of the right values.
    """
    library, make = SKY_TOOLS[tool]
    run = make(*points_of(scene, points), workers)
    fixed = stopwatch(lambda: run(_FEWEST, 1))

    def report() -> dict[str, Any]:
        told = {"version": version(library)}
        if tool == VIEW:
            return told
        right = np.load(reference, allow_pickle=False)
        mse, variance, apart = errors(run(rays, _RUNS), right)
        fewer, _, _ = errors(run(rays // _FEWER, _RUNS), right)
        return {
            **told,
            "rmse": float(np.sqrt(mse)),
            "rate": float(0.5 * np.log(fewer / mse) / np.log(_FEWER)),
            "apart": float(apart / variance),
            "fixed": float(np.median([fixed() for _ in range(_FIXED_RUNS)])),
        }

    return Job(lambda: run(rays, 1), report, lambda: run(_FEWEST, 1))


def errors(found: np.ndarray, right: np.ndarray) -> tuple[float, float, float]:
    """(mean square error of a run, variance of the runs' mean by their differences, its mean square error)."""
    found = found.astype(np.float64)
    mean = found.mean(axis=0)
    variance = np.mean(found.var(axis=0, ddof=1)) / len(found)
    return float(np.mean((found - right) ** 2)), float(variance), float(np.mean((mean - right) ** 2))


def build_sun(tool: str, scene: str, points: int, workers: int, reference: str) -> Job:
    """Which suns of a year points see.

    Args:
        tool: of SUN_TOOLS.
        scene: of SCENES.
        points: on it.
        workers: threads.
        reference: an .npy file of what is lit, eight pairs in a byte.
    """
    library, make = SUN_TOOLS[tool]
    suns = year_of_suns()
    run = make(*points_of(scene, points), suns, workers)
    lit: list[np.ndarray] = []

    def work() -> None:
        lit[:] = [run()]

    def report() -> dict[str, Any]:
        right = np.unpackbits(np.load(reference, allow_pickle=False), axis=1, count=len(suns)).view(bool)
        return {"version": version(library), "different": float(np.mean(lit[0] != right)), "lit": float(right.mean())}

    return Job(work, report)


def build_year(tool: str, scene: str, points: int, workers: int) -> Job:
    """A year of `irradiation` under 2,305 patches: its report has seconds, also of few points, and memory.

    Args:
        tool: "athens", the weather.
        scene: of SCENES.
        points: on it.
        workers: threads.
    """
    mesh, at = points_of(scene, points)
    few = SurfacePoints(at.position[:FEW], at.normal[:FEW], at.face[:FEW])
    given: dict[str, Any] = {"weather": tool, "patches": "reinhart4", "workers": workers}
    irradiation(mesh, few, **given)  # loads kernels and libraries
    fixed = stopwatch(lambda: irradiation(mesh, few, **given))()
    seconds: list[float] = []

    def work() -> None:
        start = perf_counter()
        irradiation(mesh, at, **given)
        seconds[:] = [perf_counter() - start]

    return Job(work, lambda: {"seconds": seconds[0], "few_seconds": fixed, "peak_megabytes": peak_megabytes()})
