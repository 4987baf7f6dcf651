"""Functions of each tool that compute sky matrices (runs, P, 145) from rays per point and runs."""

import os
import shutil
import subprocess
import tempfile
import weakref
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from functools import partial
from itertools import count as count_from
from pathlib import Path
from typing import Any

import numpy as np

from warpsample.bench.running.turns import Tool
from warpsample.bench.tools.mitsuba import build_mitsuba_scene
from warpsample.bench.tools.numpy_rays import measure_size
from warpsample.estimate.visibility import sky_view_factor
from warpsample.mesh.mesh import Mesh
from warpsample.mesh.surface import SurfacePoints
from warpsample.radiation.sky.patches import sky_patches
from warpsample.radiation.sky.sky_matrix import sky_matrix

SkyTool = Callable[[int, int], np.ndarray]

_RAYS_AT_A_TIME = 1 << 24  # of one launch of Mitsuba's kernel
_OPTIONS = "-h -V+ -I+ -ab 1 -ad {} -lw 1e-8 -n 1 -fdf -e MF:1 -f reinhart.cal -b rbin -bn Nrbins -m sky"
_SKY = "void glow sky 0 0 4 1 1 1 0\nsky source dome 0 0 4 0 0 1 180\n"
_PATCHES = sky_patches()
_FIRST = np.flatnonzero(np.diff(_PATCHES.rows, prepend=-1)).astype(np.int32)  # first patch of each row
_IN_ROW = np.diff(_FIRST, append=len(_PATCHES)).astype(np.int32)
_STEP = np.radians(_PATCHES.altitudes[0, 1])


def repeat_runs(run: Callable[[int], np.ndarray]) -> SkyTool:
    """Build a function that computes several runs from a function that computes one run."""
    return lambda count, runs: np.stack([run(count) for _ in range(runs)])


def _ours(call: Callable[..., Any], mesh: Mesh, points: SurfacePoints, workers: int) -> SkyTool:
    seeds = count_from()
    return repeat_runs(lambda count: call(mesh, points, count, seed=next(seeds), workers=workers).value)


def _mitsuba(mesh: Mesh, points: SurfacePoints, workers: int) -> SkyTool:
    """Build Mitsuba's sky matrix: one kernel traces independent cosine directions and counts free ones by patch."""
    setup = build_mitsuba_scene(mesh, points, workers)
    dr, mi = setup.dr, setup.mi
    first, in_row = mi.UInt32(_FIRST.astype(np.uint32)), mi.UInt32(_IN_ROW.astype(np.uint32))
    seeds, size = count_from(), len(points) * len(_PATCHES)

    def add(count: int, counts: Any) -> None:
        lane = dr.arange(mi.UInt32, len(points) * count)
        point = lane // dr.opaque(mi.UInt32, count)
        rng = setup.build_random(len(points) * count, next(seeds))
        origin, normal = dr.gather(mi.Point3f, setup.origins, point), dr.gather(mi.Normal3f, setup.normals, point)
        ray = setup.sample_cosine_ray(rng, origin, normal)
        d, up = ray.d, ray.d.z > 0.0
        free = up & ~setup.scene.ray_test(ray, up)
        row = mi.UInt32(dr.asin(dr.clip(d.z, 0.0, 1.0)) * (1.0 / _STEP))
        columns = dr.gather(mi.UInt32, in_row, row)  # not masked, so that no lane divides by 0
        turns = dr.atan2(d.x, d.y) * (0.5 / np.pi)
        column = mi.UInt32(dr.round((turns + 1.0) * mi.Float(columns))) % columns
        entry = point * len(_PATCHES) + dr.gather(mi.UInt32, first, row) + column
        dr.scatter_reduce(dr.ReduceOp.Add, counts, mi.UInt32(1), entry, free)
        dr.eval(counts)

    def run(count: int) -> np.ndarray:
        counts, most = dr.zeros(mi.UInt32, size), max(1, _RAYS_AT_A_TIME // len(points))
        for start in range(0, count, most):
            add(min(most, count - start), counts)
        return np.asarray(counts).reshape(len(points), -1) / count

    return repeat_runs(run)


class Radiance:
    """Interface to a program of Radiance, with one process for each thread and its share of the points.

    Several processes of one call use the same random numbers.

    Attributes:
        program: name of the program.
        light: light around the mesh, in Radiance's scene format.
    """

    program = "rcontrib"
    light = _SKY

    def __init__(self, mesh: Mesh, points: SurfacePoints, workers: int) -> None:
        """Write the Radiance scene, scaled to a size of 100 because Radiance lifts sensors by 1e-4."""
        import pyradiance

        self._home = Path(pyradiance.__file__).parent
        folder = tempfile.mkdtemp()
        weakref.finalize(self, shutil.rmtree, folder)
        self._octree = Path(folder) / "scene.oct"
        self._environment = {**os.environ, "RAYPATH": str(self._home / "lib")}
        scale = 100.0 / measure_size(mesh)
        scene = self._octree.with_suffix(".rad")
        scene.write_text(
            _format_polygons(scale * mesh.vertices, mesh.faces, *self.define_materials(mesh)) + self.light, encoding="utf-8"
        )
        self._octree.write_bytes(self._run([self._home / "bin" / "oconv", scene]))
        sensors = np.hstack([scale * points.position, points.normal]).astype(np.float64)
        self._parts = np.array_split(sensors, workers)

    def define_materials(self, mesh: Mesh) -> tuple[str, np.ndarray]:
        """Return the definitions of Radiance materials m0, m1, ... and each face's material number (F,).

        The default is one black plastic.
        """
        return "void plastic m0 0 0 5 0 0 0 0 0", np.zeros(len(mesh.faces), int)

    def run_program(self, options: str, runs: int) -> np.ndarray:
        """Run the Radiance program on all points and return (runs, P, values, 3), divided by pi.

        One process computes all runs with consecutive random numbers.
        """
        command = [self._home / "bin" / self.program, *options.split(), self._octree]

        def part(sensors: np.ndarray) -> np.ndarray:
            output = self._run(command, np.tile(sensors, (runs, 1)).tobytes())
            return np.frombuffer(output, np.float32).reshape(runs, len(sensors), -1, 3) / np.float32(np.pi)

        with ThreadPoolExecutor(len(self._parts)) as pool:
            return np.concatenate(list(pool.map(part, self._parts)), axis=1)

    def _run(self, command: list[Any], data: bytes = b"") -> bytes:
        return subprocess.run(command, input=data, capture_output=True, check=True, env=self._environment).stdout


class _Rcontrib(Radiance):
    """Sky matrix computed by Radiance's `rcontrib`: the contributions of the sky patches."""

    def __call__(self, count: int, runs: int) -> np.ndarray:
        """Compute the sky matrices of all runs in one process of `rcontrib`."""
        return self.run_program(_OPTIONS.format(count), runs)[:, :, 1:, 1]


def _format_polygons(vertices: np.ndarray, faces: np.ndarray, materials: str, material: np.ndarray) -> str:
    """Return the faces of a mesh and their materials in Radiance's scene format."""
    lines = [materials]
    for i, corners in enumerate(vertices[faces].reshape(-1, 9)):
        lines.append(f"m{material[i]} polygon f{i} 0 0 9 " + " ".join(f"{x:.9g}" for x in corners))
    return "\n".join(lines) + "\n"


OURS, VIEW = "warpsample", "sky_view_factor"
SKY_TOOLS = {
    OURS: Tool("warpsample", partial(_ours, sky_matrix)),
    VIEW: Tool("warpsample", partial(_ours, sky_view_factor)),
    "Radiance rcontrib": Tool("pyradiance", _Rcontrib),
    "Mitsuba": Tool("mitsuba", _mitsuba),
}
"""Tools by name, with `make(mesh, points, threads)`."""
