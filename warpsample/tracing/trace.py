"""The public call `trace`, which finds the first face that each ray hits.

It checks arguments, chooses the tracer, and returns the kind of arrays that it received.
"""

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property
from math import inf
from typing import Any

import numpy as np
import warp as wp

from warpsample.host.arguments import check_flag, check_number
from warpsample.host.arrays import Array, Floats
from warpsample.host.device_memory import Memory
from warpsample.host.engine import check_memory
from warpsample.host.neighbours import address_of
from warpsample.host.progress import bar
from warpsample.host.summary import Summary
from warpsample.mesh.mesh import as_mesh
from warpsample.tracing.given_rays import GivenRays
from warpsample.tracing.options import RayOptions
from warpsample.tracing.rays import RaysArgs, trace_rays
from warpsample.tracing.scene import scene_of

_BYTES_OF_POINT = 24 + 12 + 24  # on a device: origin, face's normal, starts on both sides
_BYTES_OF_RAY = 24 + 4 + 4  # on a device: direction, distance, face


@dataclass(frozen=True, eq=False, repr=False)
class Hits(Summary):
    """Distance and face of the first hit of each ray, as NumPy or Warp arrays like the rays.

    Attributes:
        distance: float32, distance of each ray to the nearest face, or with any_hit to some face, in mesh units; inf without
            a hit, NaN for an invalid ray (see `invalid`).
        face: int32, number of that face; -1 without a hit.
        tracer: name of the tracer, "wide" or "warp".
        transmitted: float32, fraction of light (0 to 1) that reaches that face, the first opaque one: the product of the
            transmittances of the translucent faces before it. Each face counts once, also at a shared edge. With any_hit it
            is 0 where there is a hit. NaN for an invalid ray. None if all faces of the mesh are opaque.
    """

    distance: Floats
    face: Array
    tracer: str
    transmitted: Floats | None = None

    @cached_property
    def invalid(self) -> int:
        """Number of rays with a zero direction, or with an origin or a direction that is not finite."""
        distance = self.distance.numpy() if isinstance(self.distance, wp.array) else self.distance
        return int(np.count_nonzero(np.isnan(distance)))


def trace(
    mesh: Any,
    origins: Any,
    directions: Any,
    *,
    max_distance: float | None = None,
    any_hit: bool = False,
    tracer: str = "auto",
    device: Any = None,
    workers: int | None = None,
    progress: bool = False,
) -> Hits:
    """Find the first face that each ray hits, from either side; faces with a transmittance dim the ray.

    A ray on an edge hits at least one of the faces there. Other rays and the number of threads change no bit. A Mesh keeps
    the tree that its first call builds. The first call compiles for about 6 s; compiled kernels are cached on disk.

    Args:
        mesh: Mesh or anything that `as_mesh` accepts.
        origins: (P, 3) float32 or float64 in mesh coordinates, (3,) for all rays, or SurfacePoints, which start two
            millionths of the mesh's extent off their face, to the side of each direction, or straight up or down where the
            points are `raised`. A ray does not hit a face at distance 0, but rounding may bring it in front. A ray from 10^9
            times the mesh's size or farther hits nothing.
        directions: (P, 3), one per origin, or (P, n, 3), n per origin, of any length but 0. A ray is invalid with a zero,
            infinite or NaN direction, or an infinite or NaN origin: its distance is NaN, and `invalid` of the result
            counts it. Arrays of other libraries count as NumPy arrays in the CPU's memory and as wp.arrays on a CUDA
            device.
        max_distance: Distance from which on hits are ignored, a float in mesh units, compared in float32 from where a ray
            that starts far away comes near the mesh. Default: None, 3e38, the limit of float32.
        any_hit: Whether to find any face in place of the nearest, up to twice as fast. Default: False.
        tracer: Tracer, "wide", "warp" (`wp.Mesh`, skips no rays) or "auto": wide on the CPU, warp on CUDA. Default: "auto".
        device: Warp device, such as "cuda:0", which takes NumPy arrays in parts. Default: None, that of the rays.
        workers: Number of CPU threads, an integer. Default: None, the value of WARPSAMPLE_WORKERS or all cores.
        progress: Whether to show a progress bar on a terminal or in a notebook. Default: False.

    Returns:
        distance, at least 0, inf without a hit and NaN for an invalid ray, and face, -1 for both, with the directions' shape
        without the last axis. With a transmittance they are of opaque faces, and there is `transmitted`.

    Raises:
        TypeError, ValueError: an argument of a wrong type or value; the message names it.
        MemoryError: the hits do not fit into free memory.

    Example:
        >>> mesh = ws.load_mesh("courtyard")
        >>> hits = ws.trace(mesh, np.array([36.0, 36.0, 100.0]), np.array([[0.0, 0.0, -1.0], [0.0, 0.0, 1.0]]))
        >>> print(hits.distance, hits.face >= 0)  # down into the yard, up into the sky
        [100.  inf] [ True False]
    """
    mesh, any_hit = as_mesh(mesh), check_flag(any_hit, "any_hit")
    given = GivenRays.of(mesh, origins, directions)
    way, rays = given.directions, given.count
    reach = inf if max_distance is None else check_number(max_distance, "max_distance", 0.0, inf)
    how = {"device": device, "workers": workers, "progress": progress, "given": way.owner, "argument": "directions"}
    options = RayOptions.of(rays, tracer=tracer, **how)
    if way.device.is_cpu:
        check_memory(8 * rays, f"the hits of {rays:,} rays", "trace them in parts")
    if mesh.transmits:
        options.check_through_glass()
    transmitted = way.empty(np.float32) if mesh.transmits else None
    hits = Hits(way.empty(np.float32), way.empty(np.int32), options.tracer.name, transmitted)
    if rays == 0:
        return hits
    with bar(options.progress, "tracing rays"):
        scene = scene_of(mesh, through=True)
        asked, memory = given.place(options, reach, hits), options.memory
        asked.transmitted = address_of(hits.transmitted) if mesh.transmits else 0
        for part in [asked] if memory.in_place else _iterate_parts(memory, asked, given, hits):
            trace_rays(scene, part, tracer=options.tracer, any_hit=any_hit, device=memory.device, workers=options.workers)
    return hits


def _iterate_parts(memory: Memory, asked: RaysArgs, given: GivenRays, hits: Hits) -> Iterator[RaysArgs]:
    """Copy rays from NumPy arrays to the device, and yield a kernel argument for each part that fits into memory.

    A part stays on the device until the next one is requested.
    """
    for points, rays in _iterate_blocks(memory, asked.placement.points, asked.count):
        with memory.loan() as loan:
            part = RaysArgs.from_buffer_copy(asked)
            if given.points is None:
                part.placement.points = points.stop - points.start
                part.placement.origins = loan.lend(given.origins.owner.reshape(-1, 3), points)
            else:
                given.points.lend(part.placement, loan, points)
            part.count = (rays.stop - rays.start) // part.placement.points
            part.directions = loan.lend(given.directions.owner.reshape(-1, 3), rays)
            part.distance = loan.output(hits.distance.reshape(-1), rays)
            part.face = loan.output(hits.face.reshape(-1), rays)
            yield part


def _iterate_blocks(memory: Memory, points: int, count: int) -> Iterator[tuple[slice, slice]]:
    """Yield slices of points and of rays that fit into device memory."""
    size = _BYTES_OF_POINT + _BYTES_OF_RAY * count
    if memory.fits(size):
        yield from ((rows, slice(rows.start * count, rows.stop * count)) for rows in memory.parts(points, size))
        return
    for point in range(points):
        for rays in memory.parts(count, _BYTES_OF_RAY, _BYTES_OF_POINT):
            yield slice(point, point + 1), slice(point * count + rays.start, point * count + rays.stop)
