"""Functions of each compared tool that sample cosine-weighted directions about normals."""

from collections.abc import Callable
from functools import partial
from itertools import count as count_from
from typing import Any

import numpy as np
import warp as wp

from warpsample.bench.record import SEED
from warpsample.bench.running.turns import Tool, keep_last_result
from warpsample.directions.sample import sample_directions
from warpsample.host.kernel_cache import load
from warpsample.maths.frames import frame_about, to_world
from warpsample.proof import twins

Built = tuple[Callable[[], object], Callable[[], Any]]
"""(work, result): a function to time, and a function that returns the result of its last run."""

_TAU = np.float32(2.0 * np.pi)


def _warpsample(normals: np.ndarray, count: int, workers: int) -> Built:
    out = np.empty((len(normals), count, 3), np.float32)
    return partial(sample_directions, normals, count, sequence="independent", out=out, workers=workers), lambda: out


def _map_polar(u: np.ndarray, r: np.ndarray, turns: np.ndarray) -> np.ndarray:
    azimuth = _TAU * turns
    return np.stack([r * np.cos(azimuth), r * np.sin(azimuth), np.sqrt(np.float32(1.0) - u)], axis=-1)


def _compute_frames(n: np.ndarray) -> np.ndarray:
    """Compute frames (P, 3, 3) float32 with the rows tangent, bitangent and normal."""
    return twins.frames(n).transpose(0, 2, 1)


def _numpy(normals: np.ndarray, count: int, workers: int) -> Built:
    """Build the NumPy function to time, which samples cosine-weighted directions about normals by Malley's method.

    A sphere by `standard_normal` plus the normal takes 2.6 times as long.
    """
    rng = np.random.default_rng(SEED)

    def run() -> np.ndarray:
        u = rng.random((2, len(normals), count), dtype=np.float32)
        return _map_polar(u[0], np.sqrt(u[0]), u[1]) @ _compute_frames(normals)

    return keep_last_result(run)


@wp.kernel(enable_backward=False)
def _builtins(normals: wp.array[wp.vec3], samples: wp.int32, seed: wp.int32, out: wp.array[wp.vec3]):
    """Sample cosine-weighted directions with Warp's built-in random generator and Malley's method.

    The sphere sampler plus the normal takes twice as long.
    """
    i = wp.tid()
    state = wp.rand_init(seed, i)
    u = wp.randf(state)
    azimuth = 6.2831855 * wp.randf(state)
    r = wp.sqrt(u)
    out[i] = to_world(frame_about(normals[i / samples]), wp.vec3(r * wp.cos(azimuth), r * wp.sin(azimuth), wp.sqrt(1.0 - u)))


def _warp(normals: np.ndarray, count: int, workers: int) -> Built:
    load(_builtins, "cpu")
    normals_on_device = wp.array(normals, dtype=wp.vec3, device="cpu")
    out = wp.empty(len(normals) * count, dtype=wp.vec3, device="cpu")
    seeds = count_from()

    def run() -> None:
        wp.launch(_builtins, dim=len(out), inputs=[normals_on_device, count, next(seeds)], outputs=[out], device="cpu")

    return run, out.numpy


def _mitsuba(interleaved: bool, normals: np.ndarray, count: int, workers: int) -> Built:
    import drjit as dr
    import mitsuba as mi

    mi.set_variant("llvm_ad_rgb")
    dr.set_thread_count(workers)
    size = len(normals) * count
    normals_on_device = mi.Normal3f(np.ascontiguousarray(normals.T))
    seeds = count_from()

    def run() -> Any:
        n = dr.gather(mi.Normal3f, normals_on_device, dr.arange(mi.UInt32, size) // count)
        rng = mi.PCG32(size, initstate=dr.opaque(mi.UInt64, next(seeds)))
        u = mi.Point2f(rng.next_float32(), rng.next_float32())
        d = mi.Frame3f(n).to_world(mi.warp.square_to_cosine_hemisphere(u))
        d = dr.ravel(d) if interleaved else d
        dr.eval(d)
        dr.sync_thread()
        return d

    work, result = keep_last_result(run)
    return work, lambda: np.asarray(result()) if interleaved else np.asarray(result()).T


DIRECTIONS = {
    "warpsample independent": Tool("warpsample", _warpsample),
    "Mitsuba, three planes": Tool("mitsuba", partial(_mitsuba, False)),
    "Mitsuba, interleaved": Tool("mitsuba", partial(_mitsuba, True)),
    "Warp built-ins": Tool("warp-lang", _warp, threaded=False),
    "NumPy": Tool("numpy", _numpy, threaded=False),
}
"""Tools by name; `make(normals, count, threads)` returns (work, result)."""
