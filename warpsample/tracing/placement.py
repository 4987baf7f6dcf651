"""Kernel argument that describes the origins of rays, and functions that offset the origins off the surface."""

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
"""Largest coordinate of an origin that is used directly.

Rays from origins farther from 0 on any axis first advance towards the mesh in float64, so that float32 resolves the mesh.
"""

MOST_DISTANCE = float(np.finfo(np.float32).max)
"""Largest distance of a hit, in the user's units: the largest finite float32."""

OFFSET = 2.0**-19
"""Distance by which points are moved off their face, relative to the mesh's extent along the normal: 32 roundings."""

_OFFSET = wp.constant(wp.float32(OFFSET))
_FURTHEST = wp.constant(wp.float64(FURTHEST))
_ENTRY = wp.constant(wp.float64(1.25))
_LEAST_STEP = wp.constant(wp.float64(1e-150))


@wp.struct
class Placement:
    """Kernel argument that describes `points` ray origins: scalars, and addresses of arrays.

    A point x of the user is (x - centre) * scale in the scene's coordinates, where the mesh is within 1 of 0 on each axis. A
    distance t in the scene is t * unit for the user. Addresses of optional arrays are 0 where the array is missing.

    Attributes:
        points: number P of origins.
        double_origins: 1 for float64 origins, 0 for float32.
        origins: address of (P, 3) origins in the user's coordinates.
        normals: optional address of (P, 3) float32, unit normals of the faces that the origins are on.
        starts: optional address of (P, sides, 3) float32, starts of rays to each side of the face in the scene's
            coordinates. Without it, rays start at the origin moved by `origin_offset`.
        order: optional address of (P,) int64, the order in which points are visited.
        ids: optional address of (P,) uint64, global ids of the points, the same in all calls.
        centre: centre of the scene in the user's coordinates.
        scale: factor from the user's units to the scene's.
        unit: factor from the scene's units to the user's.
        reach: largest distance of a hit, in the scene's coordinates.
        extent: distance that the mesh reaches from 0 on each axis, in the scene's coordinates.
        coarseness: spacing of stored positions, in the scene's coordinates.
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


def resolutions_at(scene: Scene, reach: np.ndarray) -> np.ndarray:
    """Return the lengths that rays resolve at distances `reach` from the centre along an axis, in units of the mesh."""
    return OFFSET * np.maximum(reach, scene.spread.max() / scene.scale)


def make_placement(scene: Scene, origins: Triples, reach: float) -> PlacementArgs:
    """Build the kernel argument that describes ray origins that are not on a surface.

    The caller must keep the array of origins. `reach` is in the user's units.
    """
    return PlacementArgs(
        points=prod(origins.shape),
        double_origins=origins.double,
        origins=address_of(origins.owner),
        centre=wp.vec3d(*scene.centre),  # not a tuple: Warp would report an interrupt as a RuntimeError
        scale=scene.scale,
        unit=1.0 / scene.scale,
        reach=reach * scene.scale,
        extent=wp.vec3(*scene.extent),
        coarseness=coarseness_of(scene, origins.double),
    )


@wp.func
def in_double(v: Any) -> wp.vec3d:
    """Convert a Warp vector of three numbers to float64."""
    return wp.vec3d(wp.float64(v[0]), wp.float64(v[1]), wp.float64(v[2]))


@wp.func
def vector_in_double(address: wp.uint64, double: wp.int32, i: wp.int64) -> wp.vec3d:
    """Return the i-th vector of an array as float64.

    The array is float64 if `double` is not 0, else float32.
    """
    if double != 0:
        return vec3d_at(address, i)
    return in_double(vec3_at(address, i))


@wp.func
def unit_in_double(d: wp.vec3d, double: wp.int32) -> wp.vec3d:
    """Return the unit vector of d in float64; NaN where d is zero or not finite."""
    if double != 0:  # squares of float64 components may over- or underflow
        d = d / wp.max(wp.max(wp.abs(d[0]), wp.abs(d[1])), wp.abs(d[2]))
    return (ONE / wp.sqrt(wp.dot(d, d))) * d


@wp.func
def point_of(placement: Placement, i: wp.int64) -> wp.int64:
    """Return the index of the point that a kernel processes as the i-th."""
    if placement.order == wp.uint64(0):
        return i
    return long_at(placement.order, i)


@wp.func
def id_of(placement: Placement, first: wp.uint64, point: wp.int64) -> wp.uint64:
    """Return the global id of a point: from the user's ids if there are any, else `first` plus the point's index."""
    if placement.ids == wp.uint64(0):
        return first + wp.uint64(point)
    return address_at(placement.ids, point)


@wp.func
def local_origin(placement: Placement, point: wp.int64) -> wp.vec3d:
    """Return the ray origin of a point in float64, in normalised coordinates: the mesh lies in the cube from -1 to 1.

    The centre is subtracted before rounding to float32, so that large coordinates keep their digits.
    """
    return (vector_in_double(placement.origins, placement.double_origins, point) - placement.centre) * placement.scale


@wp.func
def extent_along(extent: wp.vec3, n: wp.vec3) -> wp.float32:
    """Return the largest dot product of n with a point in a box about 0 with the given half extents.

    Rounding along the normal is 2^-24 of this bound.
    """
    return wp.abs(n[0]) * extent[0] + wp.abs(n[1]) * extent[1] + wp.abs(n[2]) * extent[2]


@wp.func
def reach_along(placement: Placement, n: wp.vec3, o: wp.vec3) -> wp.float32:
    """Return an upper bound of the dot product of n with all points of the mesh and with the point o."""
    return extent_along(wp.max(placement.extent, wp.abs(o)), n)


@wp.func
def offset_within(extent: wp.vec3, coarseness: wp.float32, n: wp.vec3) -> wp.float32:
    """Return how far to move a ray's origin off a face with normal n, so that the ray does not hit the face itself.

    It is 32 roundings of the extent along n, plus the coarseness.
    """
    return _OFFSET * extent_along(extent, n) + coarseness


@wp.func
def origin_offset(placement: Placement, n: wp.vec3) -> wp.float32:
    """Return how far the origins of a call's rays are moved off a face with normal n."""
    return offset_within(placement.extent, placement.coarseness, n)


@wp.func
def is_far_off(o: wp.vec3d) -> wp.bool:
    """Return whether an origin is so far from the mesh that its rays must first advance towards the mesh in float64."""
    return wp.max(wp.max(wp.abs(o[0]), wp.abs(o[1])), wp.abs(o[2])) > _FURTHEST


@wp.func
def distance_to_scene(o: wp.vec3d, d: wp.vec3d) -> wp.float64:
    """Return the distance along a ray to a cube around the mesh; -1 if the ray misses the cube.

    It is -1, too, where the origin is so far away that float64 cannot resolve the cube.
    """
    enter = ZERO
    leave = wp.float64(wp.INF)
    for axis in range(3):
        inverse = ONE / wp.where(wp.abs(d[axis]) > _LEAST_STEP, d[axis], wp.copysign(_LEAST_STEP, d[axis]))
        middle = -o[axis] * inverse
        half = wp.abs(_ENTRY * inverse)
        enter = wp.max(enter, middle - half)
        leave = wp.min(leave, middle + half)
    return wp.where(enter < leave and not is_far_off(o + enter * d), enter, -ONE)
