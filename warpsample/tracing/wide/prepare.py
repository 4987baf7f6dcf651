"""Preparation of rays for tests against boxes and triangles: inverse directions and other derived values."""

import warp as wp

from warpsample.maths.memory import int_at
from warpsample.maths.numerics import greater
from warpsample.tracing.queries import CHUNK, CHUNK_FLOATS, DIRECTION, ORIGIN, PREPARED, vector_in
from warpsample.tracing.wide.layout import WIDTH

_INVERSE, _SHIFT, _NEAR, _ORIGIN, _SHEAR, _AXES = (PREPARED + row * CHUNK for row in range(0, 18, 3))

RAY_WORKSPACE = 2 * WIDTH + 1
"""Number of float32 that a single ray without a chunk needs as workspace."""

_DIRECTION_BYTES = wp.constant(wp.uint64(4 * DIRECTION))
_ROWS_OF_LEAF = wp.constant(wp.uint64(CHUNK // WIDTH))
_Y, _Z, _UPPER = (wp.constant(wp.int32(4 * WIDTH * rows)) for rows in (1, 2, 3))
_SLOWEST = wp.constant(wp.float32(2.0**-60))


@wp.struct
class Ray:
    """Prepared ray, as the tests against boxes and triangles read it.

    See `prepare_ray` for the values. direction: address of the unit direction's x. rows_of_leaf: distance in memory from x
    to y, and from y to z, in rows of a leaf.
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
class PreparedRay:
    """Values that `prepare_ray` derives from a ray, for example its inverse direction."""

    inverse: wp.vec3
    shift: wp.vec3
    near: wp.vec3i
    origin: wp.vec3
    shear: wp.vec3
    axes: wp.vec3i


@wp.func
def _nonzero(d: wp.float32) -> wp.float32:
    """Return a direction's component d with an absolute value of at least 2^-60, so that its inverse is finite."""
    return wp.where(wp.abs(d) > _SLOWEST, d, wp.copysign(_SLOWEST, d))


@wp.func
def prepare_ray(o: wp.vec3, d: wp.vec3) -> PreparedRay:
    """Compute the derived values of a ray from o along the unit vector d that box and triangle tests need.

    - inverse, shift: the ray hits the plane at x at distance x * inverse + shift.
    - near: byte offset, for each axis, from the row of lower planes to the row of the planes that the ray hits first.
    - axes: byte offsets in a leaf of the rows of three axes: first, second and along. "along" is the longest component of
      the direction. The first and second axes are sheared along it until the ray is parallel to that axis (Woop2013).
    - origin: coordinates of o on these three axes.
    - shear: the two shears, and the direction's component along the third axis.
    """
    x = _nonzero(d[0])
    y = _nonzero(d[1])
    z = _nonzero(d[2])
    inverse_x = 1.0 / x
    inverse_y = 1.0 / y
    inverse_z = 1.0 / z
    to_y = wp.abs(y) > wp.abs(x)
    to_z = wp.abs(z) > greater(wp.abs(x), wp.abs(y))
    scale = wp.where(to_z, inverse_z, wp.where(to_y, inverse_y, inverse_x))
    p = PreparedRay()
    p.inverse = wp.vec3(inverse_x, inverse_y, inverse_z)
    p.shift = wp.vec3(-o[0] * inverse_x, -o[1] * inverse_y, -o[2] * inverse_z)
    p.near = wp.vec3i(wp.where(x < 0.0, _UPPER, 0), wp.where(y < 0.0, _UPPER, 0), wp.where(z < 0.0, _UPPER, 0))
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
    p.axes = wp.vec3i(
        wp.where(to_z, 0, wp.where(to_y, _Z, _Y)),
        wp.where(to_z, _Y, wp.where(to_y, 0, _Z)),
        wp.where(to_z, _Z, wp.where(to_y, _Y, 0)),
    )
    return p


@wp.func
def prepare_wide(chunk: wp.uint64, length: wp.int32):
    """Compute the derived values of `length` rays in a buffer of rays, in one vectorised loop."""
    rays = wp.array(ptr=chunk, shape=(CHUNK_FLOATS,), dtype=wp.float32)
    offsets = wp.array(ptr=chunk, shape=(CHUNK_FLOATS,), dtype=wp.int32)
    k = wp.int32(0)
    while k < length:
        o = wp.vec3(rays[ORIGIN + k], rays[ORIGIN + CHUNK + k], rays[ORIGIN + 2 * CHUNK + k])
        d = wp.vec3(rays[DIRECTION + k], rays[DIRECTION + CHUNK + k], rays[DIRECTION + 2 * CHUNK + k])
        p = prepare_ray(o, d)
        rays[_INVERSE + k] = p.inverse[0]
        rays[_INVERSE + CHUNK + k] = p.inverse[1]
        rays[_INVERSE + 2 * CHUNK + k] = p.inverse[2]
        rays[_SHIFT + k] = p.shift[0]
        rays[_SHIFT + CHUNK + k] = p.shift[1]
        rays[_SHIFT + 2 * CHUNK + k] = p.shift[2]
        offsets[_NEAR + k] = p.near[0]
        offsets[_NEAR + CHUNK + k] = p.near[1]
        offsets[_NEAR + 2 * CHUNK + k] = p.near[2]
        rays[_ORIGIN + k] = p.origin[0]
        rays[_ORIGIN + CHUNK + k] = p.origin[1]
        rays[_ORIGIN + 2 * CHUNK + k] = p.origin[2]
        rays[_SHEAR + k] = p.shear[0]
        rays[_SHEAR + CHUNK + k] = p.shear[1]
        rays[_SHEAR + 2 * CHUNK + k] = p.shear[2]
        offsets[_AXES + k] = p.axes[0]
        offsets[_AXES + CHUNK + k] = p.axes[1]
        offsets[_AXES + 2 * CHUNK + k] = p.axes[2]
        k += 1


@wp.func
def _ray(p: PreparedRay, direction: wp.uint64, rows_of_leaf: wp.uint64) -> Ray:
    """Build a `Ray` from the derived values of a prepared ray."""
    ray = Ray()
    ray.inverse_x = p.inverse[0]
    ray.inverse_y = p.inverse[1]
    ray.inverse_z = p.inverse[2]
    ray.shift_x = p.shift[0]
    ray.shift_y = p.shift[1]
    ray.shift_z = p.shift[2]
    ray.near_x = wp.uint64(p.near[0])
    ray.near_y = wp.uint64(p.near[1])
    ray.near_z = wp.uint64(p.near[2])
    ray.origin_first = p.origin[0]
    ray.origin_second = p.origin[1]
    ray.origin_along = p.origin[2]
    ray.shear_first = p.shear[0]
    ray.shear_second = p.shear[1]
    ray.share_along = p.shear[2]
    ray.first = wp.uint64(p.axes[0])
    ray.second = wp.uint64(p.axes[1])
    ray.along = wp.uint64(p.axes[2])
    ray.direction = direction
    ray.rows_of_leaf = rows_of_leaf
    return ray


@wp.func
def ray_in(column: wp.uint64) -> Ray:
    """Return the `Ray` stored at an address in a buffer of prepared rays."""
    p = PreparedRay()
    p.inverse = vector_in(column, _INVERSE)
    p.shift = vector_in(column, _SHIFT)
    p.near = wp.vec3i(int_at(column, _NEAR), int_at(column, _NEAR + CHUNK), int_at(column, _NEAR + 2 * CHUNK))
    p.origin = vector_in(column, _ORIGIN)
    p.shear = vector_in(column, _SHEAR)
    p.axes = wp.vec3i(int_at(column, _AXES), int_at(column, _AXES + CHUNK), int_at(column, _AXES + 2 * CHUNK))
    return _ray(p, column + _DIRECTION_BYTES, _ROWS_OF_LEAF)


@wp.func
def ray_of(o: wp.vec3, d: wp.vec3, workspace: wp.array[wp.float32]) -> Ray:
    """Prepare one ray from o along the unit vector d for tracing.

    The direction is stored in `workspace`, of RAY_WORKSPACE float32.
    """
    workspace[0] = d[0]
    workspace[WIDTH] = d[1]
    workspace[2 * WIDTH] = d[2]
    return _ray(prepare_ray(o, d), workspace.ptr, wp.uint64(1))
