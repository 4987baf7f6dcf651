"""Kernels that find all faces that rays cross: one counts the hits of each ray, the other writes the hits in order."""

import warp as wp

from warpsample.host.locks import once
from warpsample.maths.memory import float_at, int_at, long_at, set_float, set_int
from warpsample.maths.numerics import lowest_bit
from warpsample.tracing.queries import REACH, Accelerator
from warpsample.tracing.rays import Rays, ray_kernel, user_distance
from warpsample.tracing.wide.layout import face_in
from warpsample.tracing.wide.prepare import Ray, prepare_wide, ray_in
from warpsample.tracing.wide.through import crossed_triangles, through_walk
from warpsample.tracing.wide.triangle import plane_distance

INVALID: wp.int32 = wp.constant(wp.int32(-1))
"""Number of hits written for an invalid ray."""


@wp.struct
class HitList:
    """Growing list of one ray's hits: addresses of distances and faces, and the number of hits so far.

    Distances are in the scene's coordinates.
    """

    distance: wp.uint64
    face: wp.uint64
    count: wp.int32


@wp.func
def _count_crossings(leaf: wp.uint64, ray: Ray, reach: wp.float32, edge: wp.float32, found: wp.int32):
    """Return `found` plus the number of triangles in a tree leaf that a ray crosses."""
    return found + wp.bit_count(crossed_triangles(leaf, ray, reach, edge))


@wp.func
def _write_crossings(leaf: wp.uint64, ray: Ray, reach: wp.float32, edge: wp.float32, found: HitList):
    """Append the hits of a ray on the triangles of a tree leaf to the ray's list of hits."""
    mask = crossed_triangles(leaf, ray, reach, edge)
    while mask != 0:
        k = lowest_bit(mask)
        mask = mask & (mask - 1)
        set_float(found.distance, found.count, plane_distance(leaf, k, ray))
        set_int(found.face, found.count, face_in(leaf, k))
        found.count += 1
    return found


_walk_to_count = through_walk(_count_crossings, wp.int32)
_walk_to_write = through_walk(_write_crossings, HitList)


@wp.func
def _is_after(hits: HitList, i: wp.int32, distance: wp.float32, face: wp.int32) -> wp.bool:
    """Return whether the i-th hit of a list sorts behind a hit at the given distance on the given face."""
    other = float_at(hits.distance, i)
    return other > distance or (other == distance and int_at(hits.face, i) > face)


@wp.func
def _sort_hits(hits: HitList):
    """Sort a list of hits in place by distance, and at equal distance by face, with Shell's sort."""
    gap = wp.int32(1)
    while gap < hits.count / 3:
        gap = 3 * gap + 1
    while gap > 0:
        for i in range(gap, hits.count):
            distance = float_at(hits.distance, i)
            face = int_at(hits.face, i)
            j = i
            while j >= gap and _is_after(hits, wp.max(j - gap, 0), distance, face):
                set_float(hits.distance, j, float_at(hits.distance, j - gap))
                set_int(hits.face, j, int_at(hits.face, j - gap))
                j -= gap
            set_float(hits.distance, j, distance)
            set_int(hits.face, j, face)
        gap = gap / 3


@wp.func
def _count_hits(rays: Rays, accelerator: Accelerator, column: wp.uint64, ray: wp.int64, scratch: wp.uint64):
    """Write the number of faces that a prepared ray crosses to its place in `rays.face`."""
    count = INVALID
    reach = float_at(column, REACH)
    if reach > 0.0:
        count = _walk_to_count(accelerator, ray_in(column), reach, 0, scratch)
    elif reach <= 0.0:
        count = 0
    set_int(rays.face, ray, count)


@wp.func
def _write_hits(rays: Rays, accelerator: Accelerator, column: wp.uint64, ray: wp.int64, scratch: wp.uint64):
    """Write the sorted distances and faces of all hits of a prepared ray."""
    reach = float_at(column, REACH)
    if reach > 0.0:
        first = wp.uint64(long_at(rays.first, ray)) * wp.uint64(4)
        hits = HitList()
        hits.distance = rays.distance + first
        hits.face = rays.face + first
        hits = _walk_to_write(accelerator, ray_in(column), reach, hits, scratch)
        for i in range(hits.count):  # in the user's units, so that distances equal to the user are ordered by face
            set_float(hits.distance, i, user_distance(rays, column, float_at(hits.distance, i)))
        _sort_hits(hits)


@once
def counting_kernel() -> wp.Kernel:
    """Build a kernel that writes the number of faces that each ray crosses to `face`; INVALID for an invalid ray."""
    return ray_kernel(prepare_wide, _count_hits)


@once
def writing_kernel() -> wp.Kernel:
    """Build a kernel that writes all hits of each ray from index `first` on, sorted by distance and face."""
    return ray_kernel(prepare_wide, _write_hits)
