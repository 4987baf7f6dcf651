"""A ray against the sixteen boxes of a node and the sixteen triangles of a leaf: the two hot loops, and what they need."""

import warp as wp

from warpsample.numerics import fma
from warpsample.tracing.layout import CHUNK, CHUNK_FLOATS, DIRECTION, ORIGIN, PREPARED, WIDTH

_INVERSE, _SHIFT, _NEAR, _ORIGIN, _SHEAR, _AXES = (PREPARED + row * CHUNK for row in range(0, 18, 3))

_ROW = wp.constant(wp.uint64(WIDTH * 4))
_ROW_BYTES = wp.constant(wp.int32(WIDTH * 4))
_UPPER = wp.constant(wp.uint64(3 * WIDTH * 4))
_LEAF_FLOATS = 9 * WIDTH
_SECOND = wp.constant(wp.int32(3 * WIDTH))
_THIRD = wp.constant(wp.int32(6 * WIDTH))
_NO_HIT = wp.constant(wp.int32(0x7F800000))  # the bits of infinity: bits of floats above 0 are ordered as they are
_CHILD = wp.constant(wp.int32(WIDTH - 1))
_SLOWEST = wp.constant(wp.float32(2.0**-60))
_ASIDE = wp.constant(wp.float32(2.0**-18))
_FURTHEST = wp.constant(wp.float32(64.0))  # farther than anything is from any origin; infinity times 0 would be NaN
_SIGN = wp.constant(wp.int32(-(2**31)))
_SURE = wp.constant(wp.int32(2**WIDTH))
_ZERO = wp.constant(wp.float64(0.0))


@wp.struct
class Ray:
    """What the loops over a node's and a leaf's rows need of a ray: a column of `prepare_wide`'s rows."""

    inverse_x: wp.float32
    inverse_y: wp.float32
    inverse_z: wp.float32
    shift_x: wp.float32
    shift_y: wp.float32
    shift_z: wp.float32
    near_x: wp.uint64
    near_y: wp.uint64
    near_z: wp.uint64
    origin_first: wp.float32
    origin_second: wp.float32
    origin_along: wp.float32
    shear_first: wp.float32
    shear_second: wp.float32
    share_along: wp.float32
    first: wp.uint64
    second: wp.uint64
    along: wp.uint64


@wp.func
def lesser(a: wp.float32, b: wp.float32) -> wp.float32:
    """The minimum, in one instruction: `wp.min` also asks for NaN, and none reaches this."""
    return wp.where(a < b, a, b)


@wp.func
def greater(a: wp.float32, b: wp.float32) -> wp.float32:
    """The maximum, likewise."""
    return wp.where(a > b, a, b)


@wp.func
def negative(x: wp.float32) -> wp.float32:
    """-x as a change of sign, which fuses with what follows: Warp's own minus subtracts from 0."""
    return wp.float32(-1.0) * x


@wp.func
def lowest_bit(mask: wp.int32) -> wp.int32:
    """The number of the lowest bit that is set, in a mask that is not 0."""
    return wp.bit_count((mask & (-mask)) - 1)


@wp.func
def _not_still(d: wp.float32) -> wp.float32:
    """d, or a step so small along that axis that it cannot be seen, whose inverse is finite."""
    return wp.where(wp.abs(d) > _SLOWEST, d, wp.copysign(_SLOWEST, d))


@wp.func
def _bytes(rows: wp.int32) -> wp.float32:
    """An offset by that many rows, as float32 of the same bits."""
    return wp.cast(rows * _ROW_BYTES, wp.float32)


@wp.func
def prepare_wide(chunk: wp.uint64, length: wp.int32):
    """Fills the other rows of a chunk's first rays, all at once.

    A plane at x is met at x * inverse + shift. near: byte offset from an axis' lower row to that of the planes met first.
    along, first, second: byte offset to the row of the direction's longest axis and to those of the other two, which are
    sheared along it until the ray is that axis (Woop, Benthin, Wald 2013), and the origin's coordinates on these.
    """
    rays = wp.array(ptr=chunk, shape=(CHUNK_FLOATS,), dtype=wp.float32)
    k = wp.int32(0)
    while k < length:
        x = _not_still(rays[DIRECTION + k])
        y = _not_still(rays[DIRECTION + CHUNK + k])
        z = _not_still(rays[DIRECTION + 2 * CHUNK + k])
        inverse_x = 1.0 / x
        inverse_y = 1.0 / y
        inverse_z = 1.0 / z
        ox = rays[ORIGIN + k]
        oy = rays[ORIGIN + CHUNK + k]
        oz = rays[ORIGIN + 2 * CHUNK + k]
        rays[_INVERSE + k] = inverse_x
        rays[_INVERSE + CHUNK + k] = inverse_y
        rays[_INVERSE + 2 * CHUNK + k] = inverse_z
        rays[_SHIFT + k] = -ox * inverse_x
        rays[_SHIFT + CHUNK + k] = -oy * inverse_y
        rays[_SHIFT + 2 * CHUNK + k] = -oz * inverse_z
        rays[_NEAR + k] = _bytes(wp.where(x < 0.0, 3, 0))
        rays[_NEAR + CHUNK + k] = _bytes(wp.where(y < 0.0, 3, 0))
        rays[_NEAR + 2 * CHUNK + k] = _bytes(wp.where(z < 0.0, 3, 0))
        to_y = wp.abs(y) > wp.abs(x)
        to_z = wp.abs(z) > greater(wp.abs(x), wp.abs(y))
        scale = wp.where(to_z, inverse_z, wp.where(to_y, inverse_y, inverse_x))
        rays[_ORIGIN + k] = wp.where(to_z, ox, wp.where(to_y, oz, oy))
        rays[_ORIGIN + CHUNK + k] = wp.where(to_z, oy, wp.where(to_y, ox, oz))
        rays[_ORIGIN + 2 * CHUNK + k] = wp.where(to_z, oz, wp.where(to_y, oy, ox))
        rays[_SHEAR + k] = -wp.where(to_z, x, wp.where(to_y, z, y)) * scale
        rays[_SHEAR + CHUNK + k] = -wp.where(to_z, y, wp.where(to_y, x, z)) * scale
        rays[_SHEAR + 2 * CHUNK + k] = wp.where(to_z, z, wp.where(to_y, y, x))
        rays[_AXES + k] = _bytes(wp.where(to_z, 0, wp.where(to_y, 2, 1)))
        rays[_AXES + CHUNK + k] = _bytes(wp.where(to_z, 1, wp.where(to_y, 0, 2)))
        rays[_AXES + 2 * CHUNK + k] = _bytes(wp.where(to_z, 2, wp.where(to_y, 1, 0)))
        k += 1


@wp.func
def _offset(bits: wp.float32) -> wp.uint64:
    return wp.uint64(wp.cast(bits, wp.int32))


@wp.func
def ray_in(column: wp.uint64) -> Ray:
    """The ray whose column begins at that address."""
    rows = wp.array(ptr=column, shape=(CHUNK_FLOATS,), dtype=wp.float32)
    ray = Ray()
    ray.inverse_x = rows[_INVERSE]
    ray.inverse_y = rows[_INVERSE + CHUNK]
    ray.inverse_z = rows[_INVERSE + 2 * CHUNK]
    ray.shift_x = rows[_SHIFT]
    ray.shift_y = rows[_SHIFT + CHUNK]
    ray.shift_z = rows[_SHIFT + 2 * CHUNK]
    ray.near_x = _offset(rows[_NEAR])
    ray.near_y = _offset(rows[_NEAR + CHUNK])
    ray.near_z = _offset(rows[_NEAR + 2 * CHUNK])
    ray.origin_first = rows[_ORIGIN]
    ray.origin_second = rows[_ORIGIN + CHUNK]
    ray.origin_along = rows[_ORIGIN + 2 * CHUNK]
    ray.shear_first = rows[_SHEAR]
    ray.shear_second = rows[_SHEAR + CHUNK]
    ray.share_along = rows[_SHEAR + 2 * CHUNK]
    ray.first = _offset(rows[_AXES])
    ray.second = _offset(rows[_AXES + CHUNK])
    ray.along = _offset(rows[_AXES + 2 * CHUNK])
    return ray


@wp.func
def boxes_met(node: wp.uint64, ray: Ray, reach: wp.float32, flip: wp.int32):
    """(mask of the children whose boxes the ray meets within reach, the nearest of them; the farthest with flip = -1).

    The boxes are larger than what is in them by more than all rounding here (`boxes.PADDING`).
    """
    near_x = wp.array(ptr=node + ray.near_x, shape=(WIDTH,), dtype=wp.float32)
    near_y = wp.array(ptr=node + _ROW + ray.near_y, shape=(WIDTH,), dtype=wp.float32)
    near_z = wp.array(ptr=node + _ROW + _ROW + ray.near_z, shape=(WIDTH,), dtype=wp.float32)
    far_x = wp.array(ptr=node + _UPPER - ray.near_x, shape=(WIDTH,), dtype=wp.float32)
    far_y = wp.array(ptr=node + _UPPER + _ROW - ray.near_y, shape=(WIDTH,), dtype=wp.float32)
    far_z = wp.array(ptr=node + _UPPER + _ROW + _ROW - ray.near_z, shape=(WIDTH,), dtype=wp.float32)
    mask = wp.int32(0)
    best = wp.int32(_NO_HIT)
    k = wp.int32(0)
    while k < WIDTH:
        enter_x = fma(near_x[k], ray.inverse_x, ray.shift_x)
        enter_y = fma(near_y[k], ray.inverse_y, ray.shift_y)
        enter_z = fma(near_z[k], ray.inverse_z, ray.shift_z)
        leave_x = fma(far_x[k], ray.inverse_x, ray.shift_x)
        leave_y = fma(far_y[k], ray.inverse_y, ray.shift_y)
        leave_z = fma(far_z[k], ray.inverse_z, ray.shift_z)
        enter = greater(greater(enter_x, enter_y), greater(enter_z, 0.0))
        leave = lesser(lesser(leave_x, leave_y), lesser(leave_z, reach))
        met = enter <= leave
        # The child's number in the last bits of its distance: one minimum tells both.
        key = ((wp.cast(enter, wp.int32) & (~_CHILD)) | k) ^ flip
        best = wp.min(best, wp.where(met, key, _NO_HIT))
        mask = mask | wp.where(met, 1 << k, 0)
        k += 1
    return mask, (best ^ flip) & _CHILD


@wp.func
def _flipped(x: wp.float32, sign: wp.int32) -> wp.float32:
    """x or -x, by a sign bit."""
    return wp.cast(wp.cast(x, wp.int32) ^ sign, wp.float32)


@wp.func
def triangles_near(leaf: wp.uint64, ray: Ray, reach: wp.float32, edge: wp.float32) -> wp.int32:
    """Mask of the leaf's triangles that the ray may meet within reach, and from bit 16 on of those that it meets for sure.

    Edge functions of the triangles sheared onto the ray (Woop, Benthin, Wald 2013, "Watertight Ray/Triangle Intersection"),
    in float32, by more than whose rounding a triangle must be missed, or met for sure. `triangle_distance` tells of others.

    Args:
        leaf: its address.
        ray: prepared.
        reach: of the ray.
        edge: the longest side, seen along an axis, of what is in the leaf.
    """
    # Distances are those along the ray's longest axis, a share of 3^-0.5 to 1. With u = 2^-24, e = edge and r as far as a
    # corner and 2 e: a sheared corner is rounded by 4 u r, and that of a triangle that is met is within 2 e. So an edge
    # function is rounded by 48 u r e, their sum weighted by the distances by 181 u r e r, and reach times their sum by 172.
    # The margins are 64, 192 and 384.
    reach_along = lesser(reach, _FURTHEST) * wp.abs(ray.share_along)
    backwards = (wp.cast(ray.share_along, wp.int32) ^ _SIGN) & _SIGN
    aside_by = _ASIDE * edge
    behind_by = 3.0 * _ASIDE * edge
    first = wp.array(ptr=leaf + ray.first, shape=(_LEAF_FLOATS,), dtype=wp.float32)
    second = wp.array(ptr=leaf + ray.second, shape=(_LEAF_FLOATS,), dtype=wp.float32)
    along = wp.array(ptr=leaf + ray.along, shape=(_LEAF_FLOATS,), dtype=wp.float32)
    masks = wp.int32(0)
    k = wp.int32(0)
    while k < WIDTH:
        # From the corners to the origin: a register less its row is one instruction, the row less a register two.
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
        inside = greater(lesser(lesser(u, v), w), negative(greater(greater(u, v), w)))  # by how much, if it is
        weighted = fma(u, az, fma(v, bz, w * cz))
        t = _flipped(weighted, (wp.cast(sum, wp.int32) & _SIGN) ^ backwards)
        size = wp.abs(sum)
        r = fma(2.0, edge, wp.abs(az))
        aside = aside_by * r
        behind = (behind_by * r) * r
        beyond = behind + behind
        near = wp.where(inside >= negative(aside), 1, 0) & wp.where(t > negative(behind), 1, 0)
        near = near & wp.where(t < fma(reach_along, size, beyond), 1, 0)
        surely = wp.where(inside > aside, 1, 0) & wp.where(t > behind, 1, 0)
        surely = surely & wp.where(t < fma(reach_along, size, negative(beyond)), 1, 0)
        masks = masks | wp.where(near != 0, 1 << k, 0) | wp.where(surely != 0, _SURE << k, 0)
        k += 1
    return masks


@wp.func
def _inside(ax: wp.float64, ay: wp.float64, bx: wp.float64, by: wp.float64, cx: wp.float64, cy: wp.float64) -> wp.bool:
    """Whether 0 is in a triangle of the plane or on its edge."""
    u = cx * by - cy * bx
    v = ax * cy - ay * cx
    w = bx * ay - by * ax
    return (u >= _ZERO and v >= _ZERO and w >= _ZERO) or (u <= _ZERO and v <= _ZERO and w <= _ZERO)


@wp.func
def triangle_distance(
    leaf: wp.uint64, k: wp.int32, sure: wp.int32, ray: Ray, column: wp.uint64, reach: wp.float32
) -> wp.float32:
    """From a ray's origin to a triangle of a leaf; -1 where the ray does not meet it within reach.

    A function of the float32 ray and triangle alone, whichever leaf it is in: what is tested before may only spare it, as
    `sure` does, which is not 0 if the ray is known to meet it. As `triangles_near`, in float64, where the differences of
    coordinates are exact: on which side of an edge a ray passes is told by the ray and the edge, not by how far away the
    edge ends. Rounding is monotonic: the sign of a difference of two rounded products is that of their difference, or 0. The
    two triangles at an edge compute it from the same numbers, and 0 counts as inside of both: a ray at an edge meets at
    least one.
    """
    first = wp.array(ptr=leaf + ray.first, shape=(_LEAF_FLOATS,), dtype=wp.float32)
    second = wp.array(ptr=leaf + ray.second, shape=(_LEAF_FLOATS,), dtype=wp.float32)
    along = wp.array(ptr=leaf + ray.along, shape=(_LEAF_FLOATS,), dtype=wp.float32)
    lane = wp.array(ptr=column, shape=(CHUNK_FLOATS,), dtype=wp.float32)
    d_first = wp.float64(lane[DIRECTION + wp.int32(ray.first / _ROW) * CHUNK])
    d_second = wp.float64(lane[DIRECTION + wp.int32(ray.second / _ROW) * CHUNK])
    d_along = wp.float64(lane[DIRECTION + wp.int32(ray.along / _ROW) * CHUNK])
    ox = wp.float64(ray.origin_first)
    oy = wp.float64(ray.origin_second)
    oz = wp.float64(ray.origin_along)
    ax = wp.float64(first[k])
    ay = wp.float64(second[k])
    az = wp.float64(along[k])
    bx = wp.float64(first[_SECOND + k])
    by = wp.float64(second[_SECOND + k])
    bz = wp.float64(along[_SECOND + k])
    cx = wp.float64(first[_THIRD + k])
    cy = wp.float64(second[_THIRD + k])
    cz = wp.float64(along[_THIRD + k])
    nx = (by - ay) * (cz - az) - (bz - az) * (cy - ay)
    ny = (bz - az) * (cx - ax) - (bx - ax) * (cz - az)
    nz = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax)
    height = nx * (ax - ox) + ny * (ay - oy) + nz * (az - oz)
    slope = nx * d_first + ny * d_second + nz * d_along  # 0 where the triangle is seen from its edge
    met = wp.float32(-1.0)
    inside = sure != 0
    if not inside and height * slope > _ZERO:
        inside = _inside(
            (ax - ox) * d_along - (az - oz) * d_first,
            (ay - oy) * d_along - (az - oz) * d_second,
            (bx - ox) * d_along - (bz - oz) * d_first,
            (by - oy) * d_along - (bz - oz) * d_second,
            (cx - ox) * d_along - (cz - oz) * d_first,
            (cy - oy) * d_along - (cz - oz) * d_second,
        )
    if inside and height * slope > _ZERO:
        distance = wp.float32(height / slope)
        if distance > 0.0 and distance < reach:
            met = distance
    return met
