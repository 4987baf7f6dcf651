"""Tests of a ray against the sixteen boxes of a node and the sixteen triangles of a leaf: the two hot loops."""

import warp as wp

from warpsample.maths.numerics import fma, greater, lesser, negative
from warpsample.tracing.wide.lanes import lanes_with
from warpsample.tracing.wide.layout import WIDTH
from warpsample.tracing.wide.prepare import Ray

_ROW = wp.constant(wp.uint64(WIDTH * 4))
_UPPER = wp.constant(wp.uint64(3 * WIDTH * 4))
_LEAF_FLOATS = 9 * WIDTH
_SECOND = wp.constant(wp.int32(3 * WIDTH))
_THIRD = wp.constant(wp.int32(6 * WIDTH))
_NO_HIT = wp.constant(wp.int32(0x7F800000))  # bits of infinity; positive floats and their bits have one order
_CHILD = wp.constant(wp.int32(WIDTH - 1))
_LEAST = wp.constant(wp.float32(384 * 2.0**-24 / 6**2))
_LEAST_EDGE = wp.constant(wp.float32(2.0**-19))
_FURTHEST = wp.constant(wp.float32(64.0))  # above any distance between an origin and the mesh; infinity times 0 would be NaN
_SIGN = wp.constant(wp.int32(-(2**31)))
_MAYBE = _SIGN  # bit 31, which the compiler tests in one instruction
_SURELY = wp.constant(wp.int32(2**30))


@wp.func
def entry_distance(node: wp.uint64, ray: Ray, k: wp.int32) -> wp.float32:
    """Return the distance at which a ray enters the box of a node's k-th child, at least 0."""
    x = wp.array(ptr=node + ray.near_x, shape=(WIDTH,), dtype=wp.float32)
    y = wp.array(ptr=node + _ROW + ray.near_y, shape=(WIDTH,), dtype=wp.float32)
    z = wp.array(ptr=node + _ROW + _ROW + ray.near_z, shape=(WIDTH,), dtype=wp.float32)
    enter_x = fma(x[k], ray.inverse_x, ray.shift_x)
    enter_y = fma(y[k], ray.inverse_y, ray.shift_y)
    enter_z = fma(z[k], ray.inverse_z, ray.shift_z)
    return greater(greater(enter_x, enter_y), greater(enter_z, 0.0))


@wp.func
def exit_distance(node: wp.uint64, ray: Ray, reach: wp.float32, k: wp.int32) -> wp.float32:
    """Return the distance at which a ray leaves the box of a node's k-th child, at most `reach`.

    The ray hits the box if this is not below `entry_distance`.
    """
    x = wp.array(ptr=node + _UPPER - ray.near_x, shape=(WIDTH,), dtype=wp.float32)
    y = wp.array(ptr=node + _UPPER + _ROW - ray.near_y, shape=(WIDTH,), dtype=wp.float32)
    z = wp.array(ptr=node + _UPPER + _ROW + _ROW - ray.near_z, shape=(WIDTH,), dtype=wp.float32)
    leave_x = fma(x[k], ray.inverse_x, ray.shift_x)
    leave_y = fma(y[k], ray.inverse_y, ray.shift_y)
    leave_z = fma(z[k], ray.inverse_z, ray.shift_z)
    return lesser(lesser(leave_x, leave_y), lesser(leave_z, reach))


@wp.func
def boxes_hit(node: wp.uint64, ray: Ray, reach: wp.float32, flip: wp.int32):
    """Return a mask of a node's children whose boxes a ray hits within `reach`, and the nearest child hit.

    With flip = -1 the number is that of the farthest child. The boxes are padded by more than all rounding errors here
    (`boxes.PADDING`).
    """
    hit = wp.zeros(shape=(WIDTH,), dtype=wp.int32)
    best = wp.int32(_NO_HIT)
    k = wp.int32(0)
    while k < WIDTH:
        enter = entry_distance(node, ray, k)
        met = enter <= exit_distance(node, ray, reach, k)
        # The last bits of the distance hold the child's number, so that one minimum finds both.
        key = ((wp.cast(enter, wp.int32) & (~_CHILD)) | k) ^ flip
        best = wp.min(best, wp.where(met, key, _NO_HIT))
        hit[k] = wp.where(met, -1, 0)
        k += 1
    return lanes_with(hit.ptr, 31), (best ^ flip) & _CHILD


@wp.func
def _flip_sign(x: wp.float32, sign: wp.int32) -> wp.float32:
    """Return x with its sign flipped where the sign bit of `sign` is set."""
    return wp.cast(wp.cast(x, wp.int32) ^ sign, wp.float32)


@wp.func
def triangles_near(leaf: wp.uint64, ray: Ray, reach: wp.float32, edge: wp.float32) -> wp.int32:
    """Return a mask of a leaf's triangles: bits 0 to 15 for possible hits within `reach`, bits 16 to 31 for certain hits.

    The test uses the edge functions of the triangles sheared onto the ray (Woop2013), in float32. A triangle is a certain
    miss or a certain hit where an edge function exceeds its own rounding error. `is_between_edges` and `plane_distance`
    decide the remaining triangles. `edge` is the longest extent of the leaf's triangles along an axis.
    """
    # Distances here are measured along the ray's longest axis: 3^-0.5 to 1 times the distance along the ray. Let u = 2^-24,
    # e = edge, and r = distance of a corner + 2 e. A sheared corner is rounded by 4 u r. If the ray hits the triangle, the
    # sheared corners are within 2 e. So an edge function is rounded by 48 u r e, the sum of edge functions weighted by
    # distances by 181 u r e r, and reach times their sum by 172 u r e r. The margin is 384 u r e r. It is compared with the
    # edge functions times 6 r, so that one minimum covers the edges and the distances. A triangle counts as a certain hit
    # only if a corner is within 8^0.5 e: farther away the edge functions are rounding alone. All its corners are then within
    # 4.9 e, where rounding is up to twice as large. A triangle smaller than 16 u r is lost in the rounding of its corners
    # and counts as 16 u r large. No corner is farther than 1 from 0.
    edge = greater(edge, _LEAST_EDGE * (1.0 + wp.abs(ray.origin_along)))
    reach_along = lesser(reach, _FURTHEST) * wp.abs(ray.share_along)
    backwards = (wp.cast(ray.share_along, wp.int32) ^ _SIGN) & _SIGN
    twelve_e = 12.0 * edge
    eight_e_e = 8.0 * edge * edge
    least = _LEAST * edge
    first = wp.array(ptr=leaf + ray.first, shape=(_LEAF_FLOATS,), dtype=wp.float32)
    second = wp.array(ptr=leaf + ray.second, shape=(_LEAF_FLOATS,), dtype=wp.float32)
    along = wp.array(ptr=leaf + ray.along, shape=(_LEAF_FLOATS,), dtype=wp.float32)
    met = wp.zeros(shape=(WIDTH,), dtype=wp.int32)
    k = wp.int32(0)
    while k < WIDTH:
        # Origin minus corner: a register minus a row in memory is one instruction, the reverse is two.
        az = ray.origin_along - along[k]
        bz = ray.origin_along - along[_SECOND + k]
        cz = ray.origin_along - along[_THIRD + k]
        ax = fma(ray.shear_first, az, ray.origin_first - first[k])
        bx = fma(ray.shear_first, bz, ray.origin_first - first[_SECOND + k])
        cx = fma(ray.shear_first, cz, ray.origin_first - first[_THIRD + k])
        ay = fma(ray.shear_second, az, ray.origin_second - second[k])
        by = fma(ray.shear_second, bz, ray.origin_second - second[_SECOND + k])
        cy = fma(ray.shear_second, cz, ray.origin_second - second[_THIRD + k])
        u = fma(cx, by, negative(cy * bx))
        v = fma(ax, cy, negative(ay * cx))
        w = fma(bx, ay, negative(by * ax))
        sum = u + v + w
        inside = greater(lesser(lesser(u, v), w), negative(greater(greater(u, v), w)))  # depth inside; below 0 outside
        weighted = fma(u, az, fma(v, bz, w * cz))
        t = _flip_sign(weighted, (wp.cast(sum, wp.int32) & _SIGN) ^ backwards)
        before = lesser(t, fma(reach_along, wp.abs(sum), negative(t)))  # margin ahead of the origin and before reach
        six_r = fma(6.0, wp.abs(az), twelve_e)
        margin = (least * six_r) * six_r
        within = lesser(six_r * inside, before)
        sure = wp.where(within > margin + margin, _SURELY, 0) & wp.where(fma(ax, ax, ay * ay) <= eight_e_e, _SURELY, 0)
        met[k] = wp.where(within >= negative(margin), _MAYBE, 0) | sure
        k += 1
    return lanes_with(met.ptr, 31) | (lanes_with(met.ptr, 30) << WIDTH)
