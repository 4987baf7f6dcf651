"""Functions of each tool that sample directions towards a picture, and compute irradiance from a picture."""

from collections.abc import Callable
from functools import partial
from itertools import count as count_from
from math import pi
from typing import Any

import numpy as np

from warpsample.bench.record import SEED
from warpsample.bench.running.turns import Tool, keep_last_result
from warpsample.bench.tools.directions import Built
from warpsample.bench.tools.mitsuba import build_mitsuba_scene
from warpsample.directions.sample import sample_directions
from warpsample.distributions.lights.environment_map import EnvironmentMap
from warpsample.mesh.mesh import Mesh
from warpsample.mesh.surface import SurfacePoints
from warpsample.radiation.sky.irradiance import irradiance

_SUN = 1e5
"""Radiance of the sun over that of the sky."""
_TO_WORLD = [[0.0, 0.0, -1.0, 0.0], [-1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 0.0, 1.0]]
"""Rotation that places a mirrored picture of Mitsuba, whose axis is +y, as `irradiance` places the picture."""


def build_picture(height: int, degrees: float) -> np.ndarray:
    """Build a picture (height, 2 height) float32: an even sky of 1, with a sun 50 degrees above the horizon.

    Args:
        height: rows of the picture.
        degrees: angle between the centre of the sun and its edge; a sun smaller than a pixel covers one pixel.
    """
    latitude = pi * (np.arange(height) + 0.5) / height
    longitude = pi * (np.arange(2 * height) + 0.5) / height
    sun = np.radians(40.0), longitude[height // 2]
    cosine = np.cos(latitude)[:, None] * np.cos(sun[0]) + np.sin(latitude)[:, None] * np.sin(sun[0]) * np.cos(
        longitude - sun[1]
    )
    lit = cosine >= min(np.cos(np.radians(degrees)), cosine.max())
    return np.where(lit, _SUN, 1.0).astype(np.float32)


def _draw(picture: np.ndarray, points: int, count: int, workers: int) -> Built:
    normals, lobe = np.tile(np.float32([0.0, 0.0, 1.0]), (points, 1)), EnvironmentMap(picture)
    out = np.empty((points, count, 3), np.float32)
    draw = partial(sample_directions, normals, count, distribution=lobe, sequence="independent", pdf=True)
    work, result = keep_last_result(partial(draw, out=out, workers=workers))
    return work, lambda: np.ravel(result().pdf)


def _load_environment(mi: Any, picture: np.ndarray) -> dict[str, Any]:
    """Return the description of Mitsuba's light that equals a picture."""
    pixels = np.repeat(picture[:, ::-1, None], 3, axis=2)
    return {"type": "envmap", "bitmap": mi.Bitmap(pixels), "to_world": mi.ScalarTransform4f(_TO_WORLD)}


def _draw_mitsuba(picture: np.ndarray, points: int, count: int, workers: int) -> Built:
    import drjit as dr
    import mitsuba as mi

    mi.set_variant("llvm_ad_rgb")
    dr.set_thread_count(workers)
    scene = mi.load_dict({"type": "scene", "ball": {"type": "sphere"}, "light": _load_environment(mi, picture)})
    light, size, seeds = scene.environment(), points * count, count_from()

    def run() -> Any:
        rng = mi.PCG32(size, initstate=dr.opaque(mi.UInt64, next(seeds)))
        drawn, _ = light.sample_direction(
            dr.zeros(mi.SurfaceInteraction3f, size), mi.Point2f(rng.next_float32(), rng.next_float32())
        )
        dr.eval(drawn.d, drawn.pdf)
        dr.sync_thread()
        return drawn.pdf

    work, result = keep_last_result(run)
    return work, lambda: np.asarray(result())


LightTool = Callable[[int, int], np.ndarray]
"""Function (rays per point, seed) that returns the irradiance of each point."""


def _ours(sampling: str, picture: np.ndarray, mesh: Mesh, points: SurfacePoints, workers: int) -> LightTool:
    return lambda count, seed: irradiance(mesh, points, picture, count, sampling=sampling, seed=seed, workers=workers).value


def _mitsuba(both: bool, picture: np.ndarray, mesh: Mesh, points: SurfacePoints, workers: int) -> LightTool:
    """Build Mitsuba's irradiance by rays towards the picture; with `both` half of the rays are from the cosine lobe."""
    setup = build_mitsuba_scene(mesh, points, workers)
    dr, mi = setup.dr, setup.mi
    light_scene = mi.load_dict({"type": "scene", "ball": {"type": "sphere"}, "light": _load_environment(mi, picture)})
    light, lanes = light_scene.environment(), len(points)

    def weigh(ray: Any, normal: Any, radiance: Any, density: Any) -> Any:
        """Return cosine times radiance over the density, 0 for a blocked ray."""
        cosine = dr.dot(ray.d, normal)
        seen = (cosine > 0.0) & (density > 0.0)
        seen &= ~setup.scene.ray_test(ray, seen)
        return dr.select(seen, cosine * radiance / density, 0.0)

    def run(count: int, seed: int) -> np.ndarray:
        draws = count // 2 if both else count
        point = dr.arange(mi.UInt32, lanes * draws) // dr.opaque(mi.UInt32, draws)
        rng = setup.build_random(lanes * draws, seed)
        origin, normal = dr.gather(mi.Point3f, setup.origins, point), dr.gather(mi.Normal3f, setup.normals, point)
        at = dr.zeros(mi.SurfaceInteraction3f, lanes * draws)
        at.p = origin
        drawn, spectrum = light.sample_direction(at, mi.Point2f(rng.next_float32(), rng.next_float32()))
        cosine_density = dr.maximum(dr.dot(drawn.d, normal), 0.0) * (1.0 / pi)
        density = drawn.pdf + cosine_density if both else drawn.pdf
        total = weigh(mi.Ray3f(origin, drawn.d), normal, spectrum.x * drawn.pdf, density)
        if both:
            ray = setup.sample_cosine_ray(rng, origin, normal)
            at.wi = -ray.d
            drawn.d = ray.d
            cosine_density = dr.maximum(dr.dot(ray.d, normal), 0.0) * (1.0 / pi)
            total += weigh(ray, normal, light.eval(at).x, cosine_density + light.pdf_direction(at, drawn))
        sums = dr.zeros(mi.Float, lanes)
        dr.scatter_reduce(dr.ReduceOp.Add, sums, total, point)
        dr.eval(sums)
        return np.asarray(sums) / draws

    return run


DRAWS = {"warpsample": Tool("warpsample", _draw), "Mitsuba": Tool("mitsuba", _draw_mitsuba)}
"""Tools that draw directions, by name; `make(picture, points, count, threads)` returns (work, densities)."""

BOTH, COSINE = "warpsample, both", "warpsample, cosine"
LIGHTS = {
    BOTH: Tool("warpsample", partial(_ours, "both")),
    "warpsample, picture": Tool("warpsample", partial(_ours, "picture")),
    COSINE: Tool("warpsample", partial(_ours, "cosine")),
    "Mitsuba, picture": Tool("mitsuba", partial(_mitsuba, False)),
    "Mitsuba, both": Tool("mitsuba", partial(_mitsuba, True)),
}
"""Tools that compute irradiance, by name; `make(picture, mesh, points, threads)` returns a LightTool."""
SEEDS = (SEED + 1, SEED + 2)
"""Seeds of the errors; the reference has another one."""
