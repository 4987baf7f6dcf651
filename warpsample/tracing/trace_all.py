"""The call `trace_all`: every face that a ray crosses."""

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
    """Every hit of R rays, one ray after the other; NumPy or Warp arrays, as the rays were.

    Attributes:
        first: (R + 1,) int64: the hits of the i-th ray, in C order of the directions, are those from first[i] up to, and
            without, first[i + 1].
        distance: float32, one for each hit, in units of the mesh's coordinates, rising along each ray.
        face: int32, the number of the face; rising where distances of a ray are equal.
        invalid: how many rays have a zero direction, or an origin or a direction that is not finite; they have no hits.
    """

    first: Array
    distance: Floats
    face: Array
    invalid: int


def trace_all(
    mesh: Any, origins: Any, directions: Any, *, max_distance: float | None = None, workers: int | None = None
) -> AllHits:
    """Every face that rays cross, from either side, however many there are.

    No ray stops and starts again, so none misses what is near to another hit, or finds it twice. A ray at an edge or a
    corner that faces share crosses one of them, as a ray just beside it does, whether they share vertices or have some of
    their own there; where the surface turns back, seen along the ray, it crosses two or none. So out of a closed mesh the
    number is odd, and through it even. Faces that coincide are all met. Each ray is followed twice, to count and to write;
    how many threads there are changes no bit. A transmittance of the mesh plays no part.

    Args:
        mesh: a Mesh or whatever `as_mesh` takes.
        origins: as of `trace`, in the CPU's memory: (P, 3), or (3,), or SurfacePoints, which are moved off their face.
        directions: (P, 3) or (P, n, 3), of any length but 0. A ray is invalid if its direction is zero, or if its
            direction or origin is infinite or NaN: it has no hits, and `invalid` of the result counts it.
        max_distance: meets only what is nearer, in units of the coordinates.
        workers: threads, all cores by default.

    Returns:
        the hits of each ray, sorted by distance and face.

    Raises:
        TypeError, ValueError: an argument that cannot be used; names it, what it got and what it wants.
        MemoryError: more than is free; the hits are counted first.

    Example:
        >>> mesh = ws.load_mesh("courtyard")
        >>> found = ws.trace_all(mesh, np.array([36.0, 1.0, 3.0]), np.array([[0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]))
        >>> print(np.diff(found.first), found.distance[: found.first[1]])
        [4 0] [14. 26. 44. 56.]
    """
    given = GivenRays.of(as_mesh(mesh), origins, directions)
    owner, rays = given.way.owner, given.count
    if not given.way.device.is_cpu:
        where = given.way.device
        raise ValueError(
            f"directions: got an array on {where}, want one in the CPU's memory: no other tracer finds all hits"
        )
    reach = inf if max_distance is None else check_number(max_distance, "max_distance", 0.0, inf)
    options = RayOptions.of(rays).by(tracer="wide", workers=workers)
    check_memory(16 * rays, f"the numbers of hits of {rays:,} rays", "trace them in parts")
    found = _hits(given, options, reach)
    if not isinstance(owner, wp.array):
        return found
    first, distance, face = (wp.array(array, device="cpu") for array in (found.first, found.distance, found.face))
    return AllHits(first, distance, face, found.invalid)


def _hits(given: GivenRays, options: RayOptions, reach: float) -> AllHits:
    """Every hit of the rays, in NumPy's arrays."""
    if given.count == 0:
        return AllHits(np.zeros(1, np.int64), np.zeros(0, np.float32), np.zeros(0, np.int32), 0)
    rays, workers = given.count, options.workers
    accelerator = scene_of(given.mesh, through=True).tree(workers).accelerator()
    asked = given.placed(options, reach)
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
