"""The public call `trace_all`, which finds every face that each ray crosses."""

from dataclasses import dataclass
from math import inf
from typing import Any

import numpy as np
import warp as wp

from warpsample.host.arguments import check_number
from warpsample.host.arrays import Array, Floats, cpu
from warpsample.host.engine import check_memory
from warpsample.host.summary import Summary
from warpsample.mesh.mesh import as_mesh
from warpsample.tracing.every_hit import counting_kernel, writing_kernel
from warpsample.tracing.given_rays import GivenRays
from warpsample.tracing.options import RayOptions
from warpsample.tracing.rays import launch_rays
from warpsample.tracing.scene import scene_of


@dataclass(frozen=True, eq=False, repr=False)
class AllHits(Summary):
    """Distances and faces of all hits of R rays, one ray after the other, as NumPy or Warp arrays like the rays.

    Attributes:
        first: (R + 1,) int64, index of each ray's first hit. Ray i, in C order of the directions, has the hits first[i] to
            first[i + 1] - 1.
        distance: float32, distance of each hit in mesh units, ascending along each ray.
        face: int32, face number of each hit; ascending where distances of a ray are equal.
        invalid: number of rays without hits because of a zero direction, or an origin or a direction that is not finite.
    """

    first: Array
    distance: Floats
    face: Array
    invalid: int


def trace_all(
    mesh: Any, origins: Any, directions: Any, *, max_distance: float | None = None, workers: int | None = None
) -> AllHits:
    """Find every face that each ray crosses, from either side.

    No ray stops and starts again, so none misses a hit near another one or finds it twice. A ray at an edge or a corner
    crosses one of its faces, as a ray just beside it does; where the surface turns back along the ray, two or none. So rays
    out of a closed mesh cross an odd number of faces, and rays through it an even one. Faces that coincide are all crossed.
    The number of threads changes no bit. A transmittance of the mesh has no effect.

    Args:
        mesh: Mesh or anything that `as_mesh` accepts.
        origins: As for `trace`, in the CPU's memory: (P, 3), (3,) or SurfacePoints, which start off their face.
        directions: (P, 3) or (P, n, 3), of any length but 0. A ray is invalid if its direction is zero, or if its
            direction or origin is infinite or NaN: it has no hits, and `invalid` of the result counts it.
        max_distance: Distance from which on hits are ignored, a float in mesh units. Default: None, no limit.
        workers: Number of CPU threads, an integer. Default: None, the value of WARPSAMPLE_WORKERS or all cores.

    Returns:
        the hits of each ray, sorted by distance and face.

    Raises:
        TypeError, ValueError: an argument of a wrong type or value; the message names it.
        MemoryError: the hits, which are counted first, do not fit into free memory.

    Example:
        >>> mesh = ws.load_mesh("courtyard")
        >>> found = ws.trace_all(mesh, np.array([36.0, 1.0, 3.0]), np.array([[0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]))
        >>> print(np.diff(found.first), found.distance[: found.first[1]])
        [4 0] [14. 26. 44. 56.]
    """
    given = GivenRays.of(as_mesh(mesh), origins, directions)
    owner, rays = given.directions.owner, given.count
    if not given.directions.device.is_cpu:
        where = given.directions.device
        raise ValueError(
            f"directions: got an array on {where}, want an array in CPU memory, because only the tracer of the CPU "
            "finds all hits"
        )
    reach = inf if max_distance is None else check_number(max_distance, "max_distance", 0.0, inf)
    options = RayOptions.of(rays, tracer="wide", workers=workers)
    check_memory(16 * rays, f"the numbers of hits of {rays:,} rays", "trace them in parts")
    found = _trace_all_hits(given, options, reach)
    if not isinstance(owner, wp.array):
        return found
    first, distance, face = (wp.array(array, device="cpu") for array in (found.first, found.distance, found.face))
    return AllHits(first, distance, face, found.invalid)


def _trace_all_hits(given: GivenRays, options: RayOptions, reach: float) -> AllHits:
    """Trace the rays of a caller and return all their hits as NumPy arrays."""
    if given.count == 0:
        return AllHits(np.zeros(1, np.int64), np.zeros(0, np.float32), np.zeros(0, np.int32), 0)
    rays, workers = given.count, options.workers
    accelerator = scene_of(given.mesh, through=True).tree(workers).accelerator()
    asked = given.place(options, reach)
    counts, first = np.empty(rays, np.int32), np.zeros(rays + 1, np.int64)
    asked.face = counts.ctypes.data
    launch_rays(counting_kernel(), accelerator, asked, cpu(), workers)
    np.cumsum(np.maximum(counts, 0), out=first[1:])
    total = int(first[-1])
    check_memory(8 * total, f"the {total:,} hits of {rays:,} rays", "trace them in parts")
    distance, face = np.empty(total, np.float32), np.empty(total, np.int32)
    asked.first, asked.distance, asked.face = (array.ctypes.data for array in (first, distance, face))
    launch_rays(writing_kernel(), accelerator, asked, cpu(), workers)
    return AllHits(first, distance, face, int(np.count_nonzero(counts < 0)))
