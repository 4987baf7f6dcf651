"""Where points are in the scene's coordinates, and from where their rays start: shared by `trace` and the estimates."""

from math import prod
from typing import Any

import numpy as np
import warp as wp

from warpsample.host.neighbours import address_of
from warpsample.maths.memory import address_at, long_at, vec3_at, vec3d_at
from warpsample.maths.numerics import ONE, ZERO
from warpsample.tracing.scene import Scene, coarseness_of
from warpsample.tracing.triples import Triples

FURTHEST = 6.0
"""From 0 on an axis; origins beyond come nearer first, in float64, so that float32 resolves the mesh."""

MOST_DISTANCE = float(np.finfo(np.float32).max)
"""What is farther is not met: its distance would not be finite."""

OFFSET = 2.0**-19
"""How far points are moved off their face along its normal, of how far the mesh reaches along it: 32 roundings."""

_OFFSET = wp.constant(wp.float32(OFFSET))
_FURTHEST = wp.constant(wp.float64(FURTHEST))
_ENTRY = wp.constant(wp.float64(1.25))
_LEAST_STEP = wp.constant(wp.float64(1e-150))


@wp.struct
class Placement:
    """Scalars and addresses of `points` origins, float32, or float64 if `double_origins`.

    A point x of the user's is (x - centre) * scale inside, where the mesh is within 1 of 0 on each axis, and its extent; a
    distance t inside is t * unit, and reach is inside, too. coarseness: how far apart stored positions are, inside.
    Optional, else 0: normals (P, 3) float32, unit, of the faces that origins are on; starts (P, sides, 3) float32, where
    rays to these sides start, inside, else they are moved by `offset`; order (P,) int64, in which points are visited; ids
    (P,) uint64, of the points in all calls.
    """

    points: wp.int64
    double_origins: wp.int32
    origins: wp.uint64
    normals: wp.uint64
    starts: wp.uint64
    order: wp.uint64
    ids: wp.uint64
    centre: wp.vec3d
    scale: wp.float64
    unit: wp.float64
    reach: wp.float64
    extent: wp.vec3
    coarseness: wp.float32


PlacementArgs: Any = type(Placement().__ctype__())


def placed(scene: Scene, origins: Triples, reach: float) -> PlacementArgs:
    """The placement of origins, without normals, starts and order; reach in the user's units. The caller keeps the array."""
    return PlacementArgs(
        points=prod(origins.shape),
        double_origins=origins.double,
        origins=address_of(origins.owner),
        centre=wp.vec3d(*scene.centre),  # not a tuple: Warp would tell an interrupt as a RuntimeError
        scale=scene.scale,
        unit=1.0 / scene.scale,
        reach=reach * scene.scale,
        extent=wp.vec3(*scene.extent),
        coarseness=coarseness_of(scene, origins.double),
    )


@wp.func
def in_double(v: Any) -> wp.vec3d:
    """A vector in float64."""
    return wp.vec3d(wp.float64(v[0]), wp.float64(v[1]), wp.float64(v[2]))


@wp.func
def vector_in_double(address: wp.uint64, double: wp.int32, i: wp.int64) -> wp.vec3d:
    """The i-th vector of an array of float32, or of float64 if `double` says so."""
    if double != 0:
        return vec3d_at(address, i)
    return in_double(vec3_at(address, i))


@wp.func
def unit_in_double(d: wp.vec3d, double: wp.int32) -> wp.vec3d:
    """d / abs(d); NaN where d is zero or not finite."""
    if double != 0:  # whose squares may over- or underflow
        d = d / wp.max(wp.max(wp.abs(d[0]), wp.abs(d[1])), wp.abs(d[2]))
    return (ONE / wp.sqrt(wp.dot(d, d))) * d


@wp.func
def point_of(placement: Placement, i: wp.int64) -> wp.int64:
    """The point that is the i-th to be visited."""
    if placement.order == wp.uint64(0):
        return i
    return long_at(placement.order, i)


@wp.func
def id_of(placement: Placement, first: wp.uint64, point: wp.int64) -> wp.uint64:
    """The global id of a point: its own, or counted from that of the first."""
    if placement.ids == wp.uint64(0):
        return first + wp.uint64(point)
    return address_at(placement.ids, point)


@wp.func
def local_origin(placement: Placement, point: wp.int64) -> wp.vec3d:
    """In the scene's coordinates: what large ones have in common goes in float64, before they are rounded."""
    return (vector_in_double(placement.origins, placement.double_origins, point) - placement.centre) * placement.scale


@wp.func
def extent_along(extent: wp.vec3, n: wp.vec3) -> wp.float32:
    """How far what has that extent reaches along a normal, at most: what is rounded along it is rounded by 2^-24 of this."""
    return wp.abs(n[0]) * extent[0] + wp.abs(n[1]) * extent[1] + wp.abs(n[2]) * extent[2]


@wp.func
def reach_along(placement: Placement, n: wp.vec3, o: wp.vec3) -> wp.float32:
    """How far the mesh and a point that may be outside of it reach along a normal, at most."""
    return extent_along(wp.max(placement.extent, wp.abs(o)), n)


@wp.func
def offset_within(extent: wp.vec3, coarseness: wp.float32, n: wp.vec3) -> wp.float32:
    """The offset of a point with that normal in that extent: 32 roundings, and more where it is stored coarsely."""
    return _OFFSET * extent_along(extent, n) + coarseness


@wp.func
def origin_offset(placement: Placement, n: wp.vec3) -> wp.float32:
    """How far points of a face with that normal are moved off it."""
    return offset_within(placement.extent, placement.coarseness, n)


@wp.func
def far_off(o: wp.vec3d) -> wp.bool:
    """Whether an origin is so far from the mesh that its rays are to be brought near."""
    return wp.max(wp.max(wp.abs(o[0]), wp.abs(o[1])), wp.abs(o[2])) > _FURTHEST


@wp.func
def way_to_scene(o: wp.vec3d, d: wp.vec3d) -> wp.float64:
    """How far a ray that starts outside is from a cube around the scene; negative where it misses that.

    Or comes from so far away that float64 does not tell.
    """
    enter = ZERO
    leave = wp.float64(wp.INF)
    for axis in range(3):
        inverse = ONE / wp.where(wp.abs(d[axis]) > _LEAST_STEP, d[axis], wp.copysign(_LEAST_STEP, d[axis]))
        middle = -o[axis] * inverse
        half = wp.abs(_ENTRY * inverse)
        enter = wp.max(enter, middle - half)
        leave = wp.min(leave, middle + half)
    return wp.where(enter < leave and not far_off(o + enter * d), enter, -ONE)
