"""Beams: pyramids of directions from one point, against the same tree. One that meets nothing needs no ray.

A box or a triangle is outside of a beam if all its corners are outside of one of the beam's planes; a triangle also if the
whole beam moves away from its plane. What is neither may still be missed by all rays: these tests err to that side only.
"""

import warp as wp

from warpsample.maths.numerics import fma, greater, lesser, lowest_bit
from warpsample.tracing.wide.corners import corner, size_of
from warpsample.tracing.wide.layout import (
    BEAM_FLOATS,
    LEAF_BYTES,
    NODE_BYTES,
    PLANES,
    WIDTH,
    Accelerator,
    leaf_at,
    link_in,
    node_at,
)
from warpsample.tracing.wide.query import WAITING, put_aside

_ROW = wp.constant(wp.uint64(4 * WIDTH))
_UPPER = wp.constant(wp.uint64(3 * 4 * WIDTH))
_LEAF_FLOATS = LEAF_BYTES // 4
_ORIGIN_AT = wp.constant(wp.int32(4 * WIDTH))
_LOW_AT = wp.constant(wp.int32(4 * WIDTH + 3))
_MARGIN = wp.constant(wp.float32(2.0**-19))
"""Times the distance of what is compared: a direction is rounded by 2^-20.4 (its variates' cell, sine and frame), a beam's
plane by 2^-22, and a corner in the test of a ray by 2^-22."""


@wp.struct
class Plane:
    """A side of a beam: inside is where x nx + y ny + z nz is at least the limit; and the rows that lie farthest inwards."""

    nx: wp.float32
    ny: wp.float32
    nz: wp.float32
    limit: wp.float32
    x_row: wp.uint64
    y_row: wp.uint64
    z_row: wp.uint64


@wp.func
def _side(beam: wp.uint64, i: wp.int32) -> Plane:
    """The i-th plane."""
    rows = wp.array(ptr=beam, shape=(BEAM_FLOATS,), dtype=wp.float32)
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
def _box_inside(node: wp.uint64, plane: Plane, k: wp.int32) -> wp.int32:
    """1 where some corner of the k-th box is inside of the plane."""
    x = wp.array(ptr=node + plane.x_row, shape=(WIDTH,), dtype=wp.float32)
    y = wp.array(ptr=node + plane.y_row, shape=(WIDTH,), dtype=wp.float32)
    z = wp.array(ptr=node + plane.z_row, shape=(WIDTH,), dtype=wp.float32)
    return wp.where(fma(x[k], plane.nx, fma(y[k], plane.ny, z[k] * plane.nz)) >= plane.limit, 1, 0)


@wp.func
def _inside(a: wp.vec3, b: wp.vec3, c: wp.vec3, plane: Plane, margin: wp.float32) -> wp.int32:
    """1 where some corner, seen from the origin, is inside of the plane."""
    n = wp.vec3(plane.nx, plane.ny, plane.nz)
    return wp.where(greater(greater(wp.dot(a, n), wp.dot(b, n)), wp.dot(c, n)) >= -margin, 1, 0)


@wp.func
def _along_corner(beam: wp.uint64, n: wp.vec3, i: wp.int32) -> wp.float32:
    """How far a vector goes along the i-th of a beam's vectors."""
    rows = wp.array(ptr=beam, shape=(BEAM_FLOATS,), dtype=wp.float32)
    return wp.dot(n, wp.vec3(rows[i], rows[WIDTH + i], rows[2 * WIDTH + i]))


@wp.func
def _faced(a: wp.vec3, b: wp.vec3, c: wp.vec3, beam: wp.uint64) -> wp.int32:
    """0 where all of the beam moves away from the plane of a triangle, its corners seen from the origin."""
    e = b - a
    f = c - a
    n = wp.cross(e, f)
    height = -wp.dot(n, a)
    p = _along_corner(beam, n, PLANES)
    q = _along_corner(beam, n, PLANES + 1)
    r = _along_corner(beam, n, PLANES + 2)
    s = _along_corner(beam, n, PLANES + 3)
    least = lesser(lesser(p, q), lesser(r, s))
    most = greater(greater(p, q), greater(r, s))
    margin = _MARGIN * size_of(e) * size_of(f)
    height_margin = margin * size_of(a)
    from_above = wp.where(height > -height_margin, 1, 0) & wp.where(least < margin, 1, 0)
    from_below = wp.where(height < height_margin, 1, 0) & wp.where(most > -margin, 1, 0)
    return from_above | from_below


@wp.func
def boxes_in(node: wp.uint64, beam: wp.uint64) -> wp.int32:
    """Mask of the children whose boxes a ray of the beam may meet."""
    p = _side(beam, 0)
    q = _side(beam, 1)
    r = _side(beam, 2)
    s = _side(beam, 3)
    t = _side(beam, 4)
    mask = wp.int32(0)
    k = wp.int32(0)
    while k < WIDTH:
        inside = _box_inside(node, p, k) & _box_inside(node, q, k) & _box_inside(node, r, k) & _box_inside(node, s, k)
        mask = mask | ((inside & _box_inside(node, t, k)) << k)
        k += 1
    return mask


@wp.func
def triangles_in(leaf: wp.uint64, beam: wp.uint64) -> wp.int32:
    """Mask of the triangles that a ray of the beam may meet."""
    aim = wp.array(ptr=beam, shape=(BEAM_FLOATS,), dtype=wp.float32)
    o = wp.vec3(aim[_ORIGIN_AT], aim[_ORIGIN_AT + 1], aim[_ORIGIN_AT + 2])
    low = aim[_LOW_AT]
    p = _side(beam, 0)
    q = _side(beam, 1)
    r = _side(beam, 2)
    s = _side(beam, 3)
    t = _side(beam, 4)
    mask = wp.int32(0)
    k = wp.int32(0)
    while k < WIDTH:
        a = corner(leaf, 0, k, o)
        b = corner(leaf, 3, k, o)
        c = corner(leaf, 6, k, o)
        margin = _MARGIN * greater(greater(size_of(a), size_of(b)), size_of(c))
        inside = _inside(a, b, c, p, low) & _inside(a, b, c, q, margin) & _inside(a, b, c, r, margin)
        inside = inside & _inside(a, b, c, s, margin) & _inside(a, b, c, t, margin)
        mask = mask | ((inside & _faced(a, b, c, beam)) << k)
        k += 1
    return mask


@wp.func
def meets(accelerator: Accelerator, beam: wp.uint64, visits: wp.int32, scratch: wp.uint64) -> wp.int32:
    """0 if no ray of the beam meets anything; 1 if one may, or if so many visits do not tell.

    Args:
        accelerator: at least one node to start from.
        beam: address of BEAM_FLOATS floats.
        visits: nodes and leaves that are looked into.
        scratch: address of SCRATCH words.
    """
    met = wp.int32(0)
    top = scratch
    for other in range(1, accelerator.starts):
        top = put_aside(top, accelerator.start + wp.uint64(other) * wp.uint64(NODE_BYTES), -1, 0.0)
    node = accelerator.start
    mask = wp.int32(-1)  # not found yet
    searching = wp.int32(1)
    while searching != 0:
        if mask == -1:
            mask = boxes_in(node, beam)
        elif mask != 0:
            child = lowest_bit(mask)
            mask = mask & (mask - 1)
            place = link_in(node, child)
            if place < 0:
                met = triangles_in(leaf_at(accelerator, ~place), beam)
            else:
                if mask != 0:
                    top = put_aside(top, node, mask, 0.0)
                node = node_at(accelerator, place)
                mask = -1
            visits -= 1
            if met != 0 or visits == 0:
                met = 1
                searching = 0
        elif top != scratch:
            top -= WAITING
            address = wp.array(ptr=top, shape=(1,), dtype=wp.uint64)
            waiting = wp.array(ptr=top, shape=(4,), dtype=wp.int32)
            node = address[0]
            mask = waiting[2]
        else:
            searching = 0
    return met
