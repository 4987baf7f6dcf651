"""Prepares rays for the loops over nodes and leaves: rows of a chunk, filled for all of its rays at once."""

import warp as wp

from warpsample.maths.numerics import greater
from warpsample.tracing.wide.layout import CHUNK, CHUNK_FLOATS, DIRECTION, ORIGIN, PREPARED, WIDTH

_INVERSE, _SHIFT, _NEAR, _ORIGIN, _SHEAR, _AXES = (PREPARED + row * CHUNK for row in range(0, 18, 3))

_ROW_BYTES = wp.constant(wp.int32(WIDTH * 4))
_SLOWEST = wp.constant(wp.float32(2.0**-60))


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
    sheared along it until the ray is that axis (Woop2013), and the origin's coordinates on these.
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
