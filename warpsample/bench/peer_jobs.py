"""The same job by other tools, each as its own documentation would write it, and by this one.

`count` directions of the cosine lobe about each of `points` normals, float32 (x, y, z), or points on a mesh, uniform by
area. Each runs in a process of its own (`warpsample.bench.child`); the libraries are imported there.
"""

# ruff: noqa: PLC0415

from collections.abc import Callable, Iterator
from functools import partial
from importlib.metadata import version
from itertools import count as count_from
from typing import Any

import numpy as np
import warp as wp

from warpsample.bench.child import Job
from warpsample.bench.integrands import INTEGRANDS, evaluate
from warpsample.directions.sample import sample_directions
from warpsample.host.kernel_cache import load
from warpsample.maths.frames import frame_about, to_world
from warpsample.mesh.mesh import as_mesh
from warpsample.mesh.surface import sample_surface
from warpsample.proof import twins

_JUDGED = 1 << 20  # directions or points that the report's means take
_TAU = np.float32(2.0 * np.pi)


def directions(peer: str, points: int, count: int, workers: int) -> Job:
    """The job of one peer; its report has "library" and "means", {integrand: [mean, its standard error]}."""
    normals = np.random.default_rng(0).normal(size=(points, 3))
    normals = (normals / np.linalg.norm(normals, axis=1, keepdims=True)).astype(np.float32)
    library, build = _DIRECTIONS[peer]
    work, result = build(normals, count, workers)
    frames = twins.frames(normals[: max(1, _JUDGED // count)].astype(np.float64))

    def report() -> dict[str, Any]:
        d = np.asarray(result()).reshape(points, count, 3)[: len(frames)]
        local = np.einsum("nij,nsi->nsj", frames, d).reshape(-1, 3).astype(np.float32)
        values = {i.name: evaluate(i, local).astype(np.float64) for i in INTEGRANDS}
        return {"library": f"{library} {version(library)}", "means": {name: _mean(v) for name, v in values.items()}}

    return Job(work, report)


def surface(peer: str, points: int, workers: int) -> Job:
    """Points on a sphere of 81,920 faces; the report's means are of x, x^2 and z^2."""
    import trimesh

    library, build = _SURFACE[peer]
    work, result = build(trimesh.creation.icosphere(subdivisions=6), points, workers)

    def report() -> dict[str, Any]:
        p = np.asarray(result(), np.float64)[:_JUDGED]
        values = {"x": p[:, 0], "x^2": p[:, 0] ** 2, "z^2": p[:, 2] ** 2}
        return {"library": f"{library} {version(library)}", "means": {name: _mean(v) for name, v in values.items()}}

    return Job(work, report)


Built = tuple[Callable[[], object], Callable[[], Any]]


def _mean(values: np.ndarray) -> list[float]:
    return [float(values.mean()), float(values.std() / np.sqrt(len(values)))]


def _kept(run: Callable[[], Any]) -> Built:
    """Work that keeps its last result."""
    last: list[Any] = []

    def work() -> None:
        last[:] = [run()]

    return work, lambda: last[0]


def _warpsample(sequence: str, normals: np.ndarray, count: int, workers: int) -> Built:
    out = np.empty((len(normals), count, 3), np.float32)
    return partial(sample_directions, normals, count, sequence=sequence, out=out, workers=workers), lambda: out


def _fill(normals: np.ndarray, count: int, workers: int) -> Built:
    out = np.empty((len(normals), count, 3), np.float32)
    return partial(out.fill, 0.0), lambda: out


def _polar(u: np.ndarray, r: np.ndarray, turns: np.ndarray) -> np.ndarray:
    azimuth = _TAU * turns
    return np.stack([r * np.cos(azimuth), r * np.sin(azimuth), np.sqrt(np.float32(1.0) - u)], axis=-1)


def _frames(n: np.ndarray) -> np.ndarray:
    """(P, 3, 3) float32, rows tangent, bitangent, normal."""
    return twins.frames(n).transpose(0, 2, 1)


def _numpy(normals: np.ndarray, count: int, workers: int) -> Built:
    """Malley's method and a frame. The sphere + normal by `standard_normal` takes 2.6 times as long."""
    rng = np.random.default_rng(0)

    def run() -> np.ndarray:
        u = rng.random((2, len(normals), count), dtype=np.float32)
        return _polar(u[0], np.sqrt(u[0]), u[1]) @ _frames(normals)

    return _kept(run)


def _scipy(normals: np.ndarray, count: int, workers: int) -> Built:
    """One scrambled Sobol' sequence over all points: SciPy has no scramble for each."""
    from scipy.stats import qmc

    seeds = count_from()

    def run() -> np.ndarray:
        u = qmc.Sobol(2, scramble=True, seed=next(seeds)).random(len(normals) * count)
        u = u.astype(np.float32).clip(0.0, 1.0 - 2.0**-24).reshape(len(normals), count, 2)
        return _polar(u[..., 0], np.sqrt(u[..., 0]), u[..., 1]) @ _frames(normals)

    return _kept(run)


@wp.kernel(enable_backward=False)
def _builtins(normals: wp.array[wp.vec3], samples: wp.int32, seed: wp.int32, out: wp.array[wp.vec3]):
    """What a Warp user writes today: the sphere sampler plus the normal, a sample per task."""
    i = wp.tid()
    state = wp.rand_init(seed, i)
    out[i] = wp.normalize(normals[i / samples] + wp.sample_unit_sphere_surface(state))


@wp.kernel(enable_backward=False)
def _builtins_polar(normals: wp.array[wp.vec3], samples: wp.int32, seed: wp.int32, out: wp.array[wp.vec3]):
    """Malley's method with Warp's generator, sine and cosine."""
    i = wp.tid()
    state = wp.rand_init(seed, i)
    u = wp.randf(state)
    azimuth = 6.2831855 * wp.randf(state)
    r = wp.sqrt(u)
    out[i] = to_world(frame_about(normals[i / samples]), wp.vec3(r * wp.cos(azimuth), r * wp.sin(azimuth), wp.sqrt(1.0 - u)))


def _warp(kernel: wp.Kernel, normals: np.ndarray, count: int, workers: int) -> Built:
    load(kernel, "cpu")
    given = wp.array(normals, dtype=wp.vec3, device="cpu")
    out = wp.empty(len(normals) * count, dtype=wp.vec3, device="cpu")
    seeds = count_from()

    def run() -> None:
        wp.launch(kernel, dim=len(out), inputs=[given, count, next(seeds)], outputs=[out], device="cpu")

    return run, out.numpy


def _numba(normals: np.ndarray, count: int, workers: int) -> Built:
    from math import cos, sin, sqrt

    import numba

    numba.set_num_threads(min(workers, numba.config.NUMBA_NUM_THREADS))

    @numba.njit(parallel=True, fastmath=True)
    def fill(normals: Any, out: Any) -> None:
        one, two_pi = np.float32(1.0), np.float32(2.0 * np.pi)
        for p in numba.prange(len(normals)):
            x, y, z = normals[p]
            sign = one if z >= np.float32(0.0) else -one
            a = -one / (sign + z)
            b = x * y * a
            for j in range(out.shape[1]):
                u = np.float32(np.random.random())  # noqa: NPY002  (the generator that compiled code has)
                azimuth = two_pi * np.float32(np.random.random())  # noqa: NPY002
                r = sqrt(u)
                wx, wy, wz = r * cos(azimuth), r * sin(azimuth), sqrt(one - u)
                out[p, j, 0] = (one + sign * x * x * a) * wx + b * wy + x * wz
                out[p, j, 1] = sign * b * wx + (sign + y * y * a) * wy + y * wz
                out[p, j, 2] = -sign * x * wx - y * wy + z * wz

    out = np.empty((len(normals), count, 3), np.float32)
    return partial(fill, normals, out), lambda: out


def _torch(normals: np.ndarray, count: int, workers: int) -> Built:
    import torch
    from torch.nn.functional import normalize

    torch.set_num_threads(workers)
    given = torch.from_numpy(normals)[:, None]
    return _kept(lambda: normalize(given + normalize(torch.randn(len(normals), count, 3), dim=-1), dim=-1))


def _mitsuba(interleaved: bool, normals: np.ndarray, count: int, workers: int) -> Built:
    import drjit as dr
    import mitsuba as mi

    mi.set_variant("llvm_ad_rgb")
    dr.set_thread_count(workers)
    size = len(normals) * count
    given = mi.Normal3f(np.ascontiguousarray(normals.T))
    seeds = count_from()

    def run() -> Any:
        n = dr.gather(mi.Normal3f, given, dr.arange(mi.UInt32, size) // count)
        rng = mi.PCG32(size, initstate=dr.opaque(mi.UInt64, next(seeds)))
        u = mi.Point2f(rng.next_float32(), rng.next_float32())
        d = mi.Frame3f(n).to_world(mi.warp.square_to_cosine_hemisphere(u))
        d = dr.ravel(d) if interleaved else d
        dr.eval(d)
        dr.sync_thread()
        return d

    work, result = _kept(run)
    return work, lambda: np.asarray(result()) if interleaved else np.asarray(result()).T


def _surface_here(mesh: Any, points: int, workers: int) -> Built:
    ours, seeds = as_mesh(mesh), count_from()
    work, result = _kept(lambda: sample_surface(ours, points, seed=next(seeds), workers=workers))
    return work, lambda: result().position


def _surface_trimesh(mesh: Any, points: int, workers: int) -> Built:
    import trimesh

    return _kept(lambda: trimesh.sample.sample_surface(mesh, points)[0])


def _surface_open3d(mesh: Any, points: int, workers: int) -> Built:
    import open3d

    theirs = open3d.geometry.TriangleMesh(
        open3d.utility.Vector3dVector(mesh.vertices), open3d.utility.Vector3iVector(mesh.faces)
    )
    work, result = _kept(lambda: theirs.sample_points_uniformly(points))
    return work, lambda: result().points


_DIRECTIONS: dict[str, tuple[str, Callable[[np.ndarray, int, int], Built]]] = {
    "warpsample independent": ("warpsample", partial(_warpsample, "independent")),
    "warpsample philox": ("warpsample", partial(_warpsample, "philox")),
    "warpsample sobol": ("warpsample", partial(_warpsample, "sobol")),
    "warpsample fibonacci": ("warpsample", partial(_warpsample, "fibonacci")),
    "Mitsuba, three planes": ("mitsuba", partial(_mitsuba, False)),
    "Mitsuba, interleaved": ("mitsuba", partial(_mitsuba, True)),
    "Numba": ("numba", _numba),
    "PyTorch": ("torch", _torch),
    "Warp built-ins, polar": ("warp-lang", partial(_warp, _builtins_polar)),
    "Warp built-ins, sphere": ("warp-lang", partial(_warp, _builtins)),
    "NumPy": ("numpy", _numpy),
    "SciPy Sobol'": ("scipy", _scipy),
    "fill": ("numpy", _fill),
}
_SURFACE: dict[str, tuple[str, Callable[[Any, int, int], Built]]] = {
    "warpsample surface": ("warpsample", _surface_here),
    "trimesh surface": ("trimesh", _surface_trimesh),
    "Open3D surface": ("open3d", _surface_open3d),
}
SINGLE_THREADED = {name for name in _DIRECTIONS if name.startswith(("Warp ", "NumPy", "SciPy", "fill"))} | {
    "trimesh surface",
    "Open3D surface",
}
"""Those that offer one thread only."""


def names(job: str) -> Iterator[str]:
    """Of the peers for "directions" or "surface"."""
    yield from _DIRECTIONS if job == "directions" else _SURFACE


def library_of(peer: str) -> str:
    """The package to install for it."""
    return (_DIRECTIONS | _SURFACE)[peer][0]
