"""Shafts: pyramids of directions from one point, tested for geometry inside.

A shaft without triangles needs no ray. A box or a triangle is outside a shaft if all its corners are outside one of the
shaft's planes. A triangle is also outside if all directions of the shaft move away from its plane. The tests are
conservative: rays may still miss a box or a triangle that is not found to be outside, but never hit one that is.

A shaft is five rows of sixteen float32. The first three hold x, y, z of the inward normals of its planes, then of the unit
directions of its corners. The fourth holds the planes' limits for boxes. The fifth holds the origin, and the tolerance below
the horizon. The first plane is the horizon.
"""

import numpy as np
import warp as wp

from warpsample.maths.frames import frame_about, to_world
from warpsample.maths.memory import float_at, vec3_at
from warpsample.maths.numerics import fma, greater, lesser
from warpsample.tracing.sight.frontier import limit_of_boxes
from warpsample.tracing.sight.point import SHAFT_FLOATS, ShadingPoint
from warpsample.tracing.wide.layout import WIDTH, corner, size_of

PLANES, CORNERS = 5, 4
"""Numbers of planes and corners of a shaft."""

VECTORS_BYTES: wp.uint64 = wp.constant(wp.uint64(4 * 3 * WIDTH))
"""Bytes of a shaft's vectors (see `shaft_vectors`): the part of a shaft that does not depend on the point."""

_VECTORS_FLOATS = 3 * WIDTH
_ROW = wp.constant(wp.uint64(4 * WIDTH))
_UPPER = wp.constant(wp.uint64(3 * 4 * WIDTH))
_ORIGIN = 4 * WIDTH
_LOW = 4 * WIDTH + 3
_MARGIN = wp.constant(wp.float32(2.0**-19))
"""Margin of the tests, relative to the distance of the corner.

A direction is rounded by 2^-20.4 (stratum of its variates, sine and frame), a plane of a shaft by 2^-22, and a corner in the
test of a ray by 2^-22.
"""


def shaft_vectors(normals: np.ndarray, corners: np.ndarray) -> np.ndarray:
    """Return the vectors that describe shafts (pyramids of directions), (..., 3, 16) float32.

    The rows are those for `aim_about` or `aim_at`.

    Args:
        normals: (..., 4, 3), inward unit normals of the four sides. The fifth plane is the point's horizon.
        corners: (..., 4, 3), unit directions of the corners, between which all directions of the shaft lie.
    """
    vectors = np.zeros((*normals.shape[:-2], WIDTH, 3))
    vectors[..., 1:PLANES, :] = normals
    vectors[..., PLANES : PLANES + CORNERS, :] = corners
    return np.ascontiguousarray(np.swapaxes(vectors, -1, -2), np.float32)


@wp.func
def corner_of(vectors: wp.uint64, i: wp.int32) -> wp.vec3:
    """Return the unit direction of the i-th corner of a shaft (pyramid of directions)."""
    k = PLANES + i
    return wp.vec3(float_at(vectors, k), float_at(vectors, WIDTH + k), float_at(vectors, 2 * WIDTH + k))


@wp.func
def _complete_shaft(point: ShadingPoint):
    """Complete a shaft (pyramid of directions): set the origin, the limits of the side planes, and the horizon plane."""
    rows = wp.array(ptr=point.shaft, shape=(SHAFT_FLOATS,), dtype=wp.float32)
    o = point.o
    n = point.n
    k = wp.int32(0)
    while k < WIDTH:
        # Directions are rounded by 2^-20.4, at 7 from the point by 2^-17.6; boxes are padded by 2^-17 along each axis.
        rows[3 * WIDTH + k] = wp.dot(wp.vec3(rows[k], rows[WIDTH + k], rows[2 * WIDTH + k]), o)
        k += 1
    # The horizon's limit compensates the padding of boxes, so that boxes are tested as closely as the triangles inside.
    rows[3 * WIDTH] = limit_of_boxes(wp.dot(n, o) - point.low, n)
    for axis in range(3):
        rows[axis * WIDTH] = n[axis]
        rows[_ORIGIN + axis] = o[axis]
    rows[_LOW] = point.low


@wp.func
def aim_about(vectors: wp.uint64, point: ShadingPoint):
    """Compute a pyramid of directions from a point, given by side normals and corners relative to the point's normal."""
    given = wp.array(ptr=vectors, shape=(_VECTORS_FLOATS,), dtype=wp.float32)
    rows = wp.array(ptr=point.shaft, shape=(SHAFT_FLOATS,), dtype=wp.float32)
    frame = frame_about(point.n)
    k = wp.int32(0)
    while k < WIDTH:
        v = to_world(frame, wp.vec3(given[k], given[WIDTH + k], given[2 * WIDTH + k]))
        rows[k] = v[0]
        rows[WIDTH + k] = v[1]
        rows[2 * WIDTH + k] = v[2]
        k += 1
    _complete_shaft(point)


@wp.func
def aim_at(vectors: wp.uint64, point: ShadingPoint):
    """Compute a pyramid of directions from a point, given by side normals and corners in mesh coordinates."""
    given = wp.array(ptr=vectors, shape=(_VECTORS_FLOATS,), dtype=wp.float32)
    rows = wp.array(ptr=point.shaft, shape=(SHAFT_FLOATS,), dtype=wp.float32)
    k = wp.int32(0)
    while k < _VECTORS_FLOATS:
        rows[k] = given[k]
        k += 1
    _complete_shaft(point)


@wp.struct
class Plane:
    """Side plane of a shaft (pyramid of directions).

    Attributes:
        nx, ny, nz: inward normal; a point (x, y, z) is inside if x nx + y ny + z nz is at least `limit`.
        limit: limit for the corners of boxes.
        x_row, y_row, z_row: byte offsets in a node of the box coordinates that lie farthest inwards.
    """

    nx: wp.float32
    ny: wp.float32
    nz: wp.float32
    limit: wp.float32
    x_row: wp.uint64
    y_row: wp.uint64
    z_row: wp.uint64


@wp.func
def _plane(shaft: wp.uint64, i: wp.int32) -> Plane:
    """Return the i-th side plane of a shaft (pyramid of directions)."""
    rows = wp.array(ptr=shaft, shape=(SHAFT_FLOATS,), dtype=wp.float32)
    plane = Plane()
    plane.nx = rows[i]
    plane.ny = rows[WIDTH + i]
    plane.nz = rows[2 * WIDTH + i]
    plane.limit = rows[3 * WIDTH + i]
    plane.x_row = wp.where(plane.nx > 0.0, _UPPER, wp.uint64(0))
    plane.y_row = wp.where(plane.ny > 0.0, _UPPER, wp.uint64(0)) + _ROW
    plane.z_row = wp.where(plane.nz > 0.0, _UPPER, wp.uint64(0)) + _ROW + _ROW
    return plane


@wp.func
def _is_box_inside(node: wp.uint64, plane: Plane, k: wp.int32) -> wp.int32:
    """Return 1 if a tree node's child has a box that is at least partly inside a shaft's side plane, else 0."""
    x = wp.array(ptr=node + plane.x_row, shape=(WIDTH,), dtype=wp.float32)
    y = wp.array(ptr=node + plane.y_row, shape=(WIDTH,), dtype=wp.float32)
    z = wp.array(ptr=node + plane.z_row, shape=(WIDTH,), dtype=wp.float32)
    return wp.where(fma(x[k], plane.nx, fma(y[k], plane.ny, z[k] * plane.nz)) >= plane.limit, 1, 0)


@wp.func
def _is_triangle_inside(a: wp.vec3, b: wp.vec3, c: wp.vec3, plane: Plane, margin: wp.float32) -> wp.int32:
    """Return 1 if a triangle with corners a, b and c is at least partly inside a shaft's side plane, else 0.

    Corners are relative to the shaft's origin.
    """
    n = wp.vec3(plane.nx, plane.ny, plane.nz)
    return wp.where(greater(greater(wp.dot(a, n), wp.dot(b, n)), wp.dot(c, n)) >= -margin, 1, 0)


@wp.func
def _is_facing(a: wp.vec3, b: wp.vec3, c: wp.vec3, shaft: wp.uint64) -> wp.int32:
    """Return 0 where all directions of a shaft move away from the plane of a triangle, else 1.

    The corners a, b and c are relative to the origin.
    """
    e = b - a
    f = c - a
    n = wp.cross(e, f)
    height = -wp.dot(n, a)
    p = wp.dot(n, corner_of(shaft, 0))
    q = wp.dot(n, corner_of(shaft, 1))
    r = wp.dot(n, corner_of(shaft, 2))
    s = wp.dot(n, corner_of(shaft, 3))
    least = lesser(lesser(p, q), lesser(r, s))
    most = greater(greater(p, q), greater(r, s))
    margin = _MARGIN * size_of(e) * size_of(f)
    height_margin = margin * size_of(a)
    from_above = wp.where(height > -height_margin, 1, 0) & wp.where(least < margin, 1, 0)
    from_below = wp.where(height < height_margin, 1, 0) & wp.where(most > -margin, 1, 0)
    return from_above | from_below


@wp.func
def boxes_in(node: wp.uint64, shaft: wp.uint64) -> wp.int32:
    """Return a mask of a tree node's children whose boxes rays of a shaft (pyramid of directions) may hit."""
    p = _plane(shaft, 0)
    q = _plane(shaft, 1)
    r = _plane(shaft, 2)
    s = _plane(shaft, 3)
    t = _plane(shaft, 4)
    mask = wp.int32(0)
    k = wp.int32(0)
    while k < WIDTH:
        inside = (
            _is_box_inside(node, p, k) & _is_box_inside(node, q, k) & _is_box_inside(node, r, k) & _is_box_inside(node, s, k)
        )
        mask = mask | ((inside & _is_box_inside(node, t, k)) << k)
        k += 1
    return mask


@wp.func
def triangles_in(leaf: wp.uint64, shaft: wp.uint64) -> wp.int32:
    """Return a mask of a tree leaf's triangles that rays of a shaft (pyramid of directions) may hit."""
    o = vec3_at(shaft + wp.uint64(4 * _ORIGIN), 0)
    low = float_at(shaft, _LOW)
    p = _plane(shaft, 0)
    q = _plane(shaft, 1)
    r = _plane(shaft, 2)
    s = _plane(shaft, 3)
    t = _plane(shaft, 4)
    mask = wp.int32(0)
    k = wp.int32(0)
    while k < WIDTH:
        a = corner(leaf, 0, k, o)
        b = corner(leaf, 3, k, o)
        c = corner(leaf, 6, k, o)
        margin = _MARGIN * greater(greater(size_of(a), size_of(b)), size_of(c))
        inside = (
            _is_triangle_inside(a, b, c, p, low)
            & _is_triangle_inside(a, b, c, q, margin)
            & _is_triangle_inside(a, b, c, r, margin)
        )
        inside = inside & _is_triangle_inside(a, b, c, s, margin) & _is_triangle_inside(a, b, c, t, margin)
        mask = mask | ((inside & _is_facing(a, b, c, shaft)) << k)
        k += 1
    return mask
