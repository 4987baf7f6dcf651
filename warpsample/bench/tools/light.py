"""Functions of each tool that compute irradiance / pi under uniform light from all directions, including via faces."""

from collections.abc import Callable
from itertools import count as count_from
from typing import Any

import numpy as np

from warpsample.bench.running.turns import Tool
from warpsample.bench.tools.mitsuba import build_mitsuba_scene, build_mitsuba_shape
from warpsample.bench.tools.sky import Radiance, repeat_runs
from warpsample.mesh.mesh import Mesh
from warpsample.mesh.surface import SurfacePoints
from warpsample.radiation.sky.irradiance import irradiance

LightTool = Callable[[int, int], np.ndarray]

_EVEN = np.ones((2, 4))
_LANES = 1 << 22  # rays of one launch of Mitsuba's kernel
_OPTIONS = "-h -I+ -ab 8 -aa 0 -as 0 -ad {} -lr 64 -lw 1e-6 -u+ -fdf"


def _ours(mesh: Mesh, points: SurfacePoints, workers: int) -> LightTool:
    seeds = count_from()
    return repeat_runs(lambda count: irradiance(mesh, points, _EVEN, count, seed=next(seeds), workers=workers).value / np.pi)


def list_kinds(mesh: Mesh) -> tuple[np.ndarray, np.ndarray]:
    """Return the distinct pairs of reflectance and transmittance in a mesh, (K, 2), and each face's pair, (F,)."""
    nothing = np.zeros(len(mesh.faces))
    shares = [nothing if share is None else share for share in (mesh.reflectance, mesh.transmittance)]
    kinds, kind = np.unique(np.stack(shares, axis=1).round(6), axis=0, return_inverse=True)
    return kinds, kind.ravel()


def _mitsuba(mesh: Mesh, points: SurfacePoints, workers: int) -> LightTool:
    """Build Mitsuba's function to time, which traces cosine-weighted rays with the integrator `volpath`.

    A mesh without transmission has no masks, so `path` replaces `volpath`.
    """
    setup = build_mitsuba_scene(mesh, points, workers)
    dr, mi = setup.dr, setup.mi
    scene: dict[str, Any] = {"type": "scene", "light": {"type": "constant", "radiance": 1.0}}
    for i, (faces, (rho, tau)) in enumerate(_split_by_kind(mesh)):
        diffuse = {"type": "diffuse", "reflectance": {"type": "rgb", "value": float(rho / (1.0 - tau))}}
        surface = {"type": "mask", "opacity": float(1.0 - tau), "inner": {"type": "twosided", "inner": diffuse}}
        scene[f"part{i}"] = build_mitsuba_shape(mi, mesh, faces, surface if tau > 0.0 else surface["inner"])
    loaded = mi.load_dict(scene)
    integrator = mi.load_dict({"type": "volpath" if mesh.transmits else "path", "max_depth": -1, "rr_depth": 8})
    seeds = count_from()

    def add(count: int, total: Any) -> None:
        sampler = mi.load_dict({"type": "independent"})
        sampler.seed(next(seeds), len(points) * count)
        point = dr.arange(mi.UInt32, len(points) * count) // dr.opaque(mi.UInt32, count)
        origin, normal = dr.gather(mi.Point3f, setup.origins, point), dr.gather(mi.Normal3f, setup.normals, point)
        way = mi.Frame3f(normal).to_world(mi.warp.square_to_cosine_hemisphere(sampler.next_2d()))
        light, _, _ = integrator.sample(loaded, sampler, mi.RayDifferential3f(mi.Ray3f(origin, way)))
        dr.scatter_reduce(dr.ReduceOp.Add, total, light.x, point)
        dr.eval(total)

    def run(count: int) -> np.ndarray:
        total, most = dr.zeros(mi.Float, len(points)), max(1, _LANES // len(points))
        for start in range(0, count, most):
            add(min(most, count - start), total)
        return np.asarray(total) / count

    return repeat_runs(run)


def _split_by_kind(mesh: Mesh) -> list[tuple[np.ndarray, np.ndarray]]:
    """Return (faces, reflectance, transmittance) for each distinct pair of reflectance and transmittance."""
    kinds, kind = list_kinds(mesh)
    return [(mesh.faces[kind == k], kinds[k]) for k in range(len(kinds))]


class _Rtrace(Radiance):
    """Irradiance computed by Radiance's `rtrace` without its cache, with eight orders of reflection."""

    program = "rtrace"
    light = "void glow sky 0 0 4 1 1 1 0\nsky source all 0 0 4 0 0 1 360\n"

    def define_materials(self, mesh: Mesh) -> tuple[str, np.ndarray]:
        """Define Radiance materials: plastic for faces that reflect, `trans` for faces that transmit straight through."""
        kinds, kind = list_kinds(mesh)
        if (kinds.min(axis=1) > 0.0).any():
            raise ValueError("mesh: got faces that reflect and transmit, want faces that do one of the two")
        lines = [
            f"void trans m{k} 0 0 7 {tau} {tau} {tau} 0 0 1 1"
            if tau > 0.0
            else f"void plastic m{k} 0 0 5 {rho} {rho} {rho} 0 0"
            for k, (rho, tau) in enumerate(kinds)
        ]
        return "\n".join(lines), kind

    def __call__(self, count: int, runs: int) -> np.ndarray:
        """Compute the irradiance of all runs in one process of `rtrace`."""
        return self.run_program(_OPTIONS.format(count), runs)[..., 0, 1]


OURS = "warpsample"
LIGHT_TOOLS = {
    OURS: Tool("warpsample", _ours),
    "Mitsuba": Tool("mitsuba", _mitsuba),
    "Radiance rtrace -ab 8": Tool("pyradiance", _Rtrace),
}
"""Tools by name, with `make(mesh, points, threads)`."""
