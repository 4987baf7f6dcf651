"""Prepares rays for the loops over nodes and leaves: rows of a chunk, filled for all of its rays at once."""

import warp as wp

from warpsample.maths.numerics import greater
from warpsample.tracing.queries import CHUNK, CHUNK_FLOATS, DIRECTION, ORIGIN, PREPARED
from warpsample.tracing.wide.layout import WIDTH

_INVERSE, _SHIFT, _NEAR, _ORIGIN, _SHEAR, _AXES = (PREPARED + row * CHUNK for row in range(0, 18, 3))

RAY_WORKSPACE = 2 * WIDTH + 1
"""float32 numbers that a ray without a chunk needs."""

_DIRECTION_BYTES = wp.constant(wp.uint64(4 * DIRECTION))
_ROWS_OF_LEAF = wp.constant(wp.uint64(CHUNK // WIDTH))
_ROW_BYTES = wp.constant(wp.int32(WIDTH * 4))
_SLOWEST = wp.constant(wp.float32(2.0**-60))


@wp.struct
class Ray:
    """What the loops over a node's and a leaf's rows need of a ray: a column of `prepare_wide`'s rows.

    direction: the address of its unit direction's x; rows_of_leaf: how far from there y is, and z from y, in rows of a leaf.
    """

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
    direction: wp.uint64
    rows_of_leaf: wp.uint64


@wp.struct
class Prepared:
    """The numbers of a `Ray` as float32 and numbers of rows, as rays are prepared side by side."""

    inverse: wp.vec3
    shift: wp.vec3
    near_x: wp.int32
    near_y: wp.int32
    near_z: wp.int32
    origin: wp.vec3
    shear: wp.vec3
    first: wp.int32
    second: wp.int32
    along: wp.int32


@wp.func
def _not_still(d: wp.float32) -> wp.float32:
    """d, or a step so small along that axis that it cannot be seen, whose inverse is finite."""
    return wp.where(wp.abs(d) > _SLOWEST, d, wp.copysign(_SLOWEST, d))


@wp.func
def _bytes(rows: wp.int32) -> wp.float32:
    """An offset by that many rows, as float32 of the same bits."""
    return wp.cast(rows * _ROW_BYTES, wp.float32)


@wp.func
def prepared(o: wp.vec3, d: wp.vec3) -> Prepared:
    """A ray from o along the unit vector d.

    A plane at x is met at x * inverse + shift. near: rows from an axis' lower row to that of the planes met first. along,
    first, second: the row of the direction's longest axis and those of the other two, which are sheared along it until the
    ray is that axis (Woop2013); origin: the origin's coordinates on first, second, along.
    """
    x = _not_still(d[0])
    y = _not_still(d[1])
    z = _not_still(d[2])
    inverse_x = 1.0 / x
    inverse_y = 1.0 / y
    inverse_z = 1.0 / z
    to_y = wp.abs(y) > wp.abs(x)
    to_z = wp.abs(z) > greater(wp.abs(x), wp.abs(y))
    scale = wp.where(to_z, inverse_z, wp.where(to_y, inverse_y, inverse_x))
    p = Prepared()
    p.inverse = wp.vec3(inverse_x, inverse_y, inverse_z)
    p.shift = wp.vec3(-o[0] * inverse_x, -o[1] * inverse_y, -o[2] * inverse_z)
    p.near_x = wp.where(x < 0.0, 3, 0)
    p.near_y = wp.where(y < 0.0, 3, 0)
    p.near_z = wp.where(z < 0.0, 3, 0)
    p.origin = wp.vec3(
        wp.where(to_z, o[0], wp.where(to_y, o[2], o[1])),
        wp.where(to_z, o[1], wp.where(to_y, o[0], o[2])),
        wp.where(to_z, o[2], wp.where(to_y, o[1], o[0])),
    )
    p.shear = wp.vec3(
        -wp.where(to_z, x, wp.where(to_y, z, y)) * scale,
        -wp.where(to_z, y, wp.where(to_y, x, z)) * scale,
        wp.where(to_z, z, wp.where(to_y, y, x)),
    )
    p.first = wp.where(to_z, 0, wp.where(to_y, 2, 1))
    p.second = wp.where(to_z, 1, wp.where(to_y, 0, 2))
    p.along = wp.where(to_z, 2, wp.where(to_y, 1, 0))
    return p


@wp.func
def prepare_wide(chunk: wp.uint64, length: wp.int32):
    """Fills the other rows of a chunk's first rays, all at once."""
    rays = wp.array(ptr=chunk, shape=(CHUNK_FLOATS,), dtype=wp.float32)
    k = wp.int32(0)
    while k < length:
        o = wp.vec3(rays[ORIGIN + k], rays[ORIGIN + CHUNK + k], rays[ORIGIN + 2 * CHUNK + k])
        d = wp.vec3(rays[DIRECTION + k], rays[DIRECTION + CHUNK + k], rays[DIRECTION + 2 * CHUNK + k])
        p = prepared(o, d)
        rays[_INVERSE + k] = p.inverse[0]
        rays[_INVERSE + CHUNK + k] = p.inverse[1]
        rays[_INVERSE + 2 * CHUNK + k] = p.inverse[2]
        rays[_SHIFT + k] = p.shift[0]
        rays[_SHIFT + CHUNK + k] = p.shift[1]
        rays[_SHIFT + 2 * CHUNK + k] = p.shift[2]
        rays[_NEAR + k] = _bytes(p.near_x)
        rays[_NEAR + CHUNK + k] = _bytes(p.near_y)
        rays[_NEAR + 2 * CHUNK + k] = _bytes(p.near_z)
        rays[_ORIGIN + k] = p.origin[0]
        rays[_ORIGIN + CHUNK + k] = p.origin[1]
        rays[_ORIGIN + 2 * CHUNK + k] = p.origin[2]
        rays[_SHEAR + k] = p.shear[0]
        rays[_SHEAR + CHUNK + k] = p.shear[1]
        rays[_SHEAR + 2 * CHUNK + k] = p.shear[2]
        rays[_AXES + k] = _bytes(p.first)
        rays[_AXES + CHUNK + k] = _bytes(p.second)
        rays[_AXES + 2 * CHUNK + k] = _bytes(p.along)
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
    ray.direction = column + _DIRECTION_BYTES
    ray.rows_of_leaf = _ROWS_OF_LEAF
    return ray


@wp.func
def _rows(rows: wp.int32) -> wp.uint64:
    return wp.uint64(rows * _ROW_BYTES)


@wp.func
def ray_of(o: wp.vec3, d: wp.vec3, workspace: wp.array[wp.float32]) -> Ray:
    """One ray, without a chunk: the same numbers. Its direction is kept in `workspace`, of RAY_WORKSPACE."""
    workspace[0] = d[0]
    workspace[WIDTH] = d[1]
    workspace[2 * WIDTH] = d[2]
    p = prepared(o, d)
    ray = Ray()
    ray.inverse_x = p.inverse[0]
    ray.inverse_y = p.inverse[1]
    ray.inverse_z = p.inverse[2]
    ray.shift_x = p.shift[0]
    ray.shift_y = p.shift[1]
    ray.shift_z = p.shift[2]
    ray.near_x = _rows(p.near_x)
    ray.near_y = _rows(p.near_y)
    ray.near_z = _rows(p.near_z)
    ray.origin_first = p.origin[0]
    ray.origin_second = p.origin[1]
    ray.origin_along = p.origin[2]
    ray.shear_first = p.shear[0]
    ray.shear_second = p.shear[1]
    ray.share_along = p.shear[2]
    ray.first = _rows(p.first)
    ray.second = _rows(p.second)
    ray.along = _rows(p.along)
    ray.direction = workspace.ptr
    ray.rows_of_leaf = wp.uint64(1)
    return ray
