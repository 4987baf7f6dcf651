"""Rays from a point to a group of suns or to positions on a sun's disc, and the test whether a ray is blocked."""

import warp as wp

from warpsample.distributions.uniform_cone import square_to_uniform_cone
from warpsample.maths.frames import frame_about, to_world
from warpsample.maths.memory import float_at, int_at, set_int, vec3_at, vec3i_at
from warpsample.radiation.sun.suns import GROUP
from warpsample.radiation.sun.view import CAST, KNOWN, NEXT, REMEMBERED, Suns, View, add, blocker_mask, word
from warpsample.sequences.fibonacci import fibonacci_sample
from warpsample.sequences.hashing import stream_key
from warpsample.tracing.placement import in_double, is_far_off, unit_in_double, vector_in_double
from warpsample.tracing.queries import REACH, Accelerator, column_of, direction_of, set_direction
from warpsample.tracing.sight.leaves import TRIANGLES, any_in_leaf, store_triangle
from warpsample.tracing.sight.point import move_ray_near
from warpsample.tracing.sight.rays import first_hit, prepare_rays

DISC_RAYS = 16
"""Number of rays to a disc that is neither proven lit nor dark; the error of a share is 0.037 (RMS) at a straight edge."""

LEAST_COSINE: wp.float64 = wp.constant(wp.float64(2.0**-12))
"""Cosine below which rays must be traced against the whole mesh, including geometry below the horizon."""

GROUP_BYTES: wp.uint64 = wp.constant(wp.uint64(3 * 4 * GROUP))
"""Size in bytes of a group's directions, and of a shaft's vectors."""

_GROUP_FLOATS = 3 * GROUP
_hit = first_hit(True)
_prepare = prepare_rays()


@wp.func
def sun_number(suns: Suns, group: wp.int32, k: wp.int32) -> wp.int32:
    """Return the row of the k-th sun of a group in the caller's array of directions."""
    return int_at(suns.columns, GROUP * group + k)


@wp.func
def sun_of(suns: Suns, group: wp.int32, k: wp.int32) -> wp.vec3:
    """Return the unit direction towards the k-th sun of a group; the zero vector if the group has fewer suns."""
    rows = wp.array(ptr=suns.groups + wp.uint64(group) * GROUP_BYTES, shape=(_GROUP_FLOATS,), dtype=wp.float32)
    return wp.vec3(rows[k], rows[GROUP + k], rows[2 * GROUP + k])


@wp.func
def aim_at_group(suns: Suns, seen: Accelerator, view: View, group: wp.int32):
    """Prepare rays from a point towards all suns of a group."""
    k = wp.int32(0)
    while k < GROUP:  # a range of 16 would be unrolled, and take seconds to compile
        set_direction(view.point.chunk, k, sun_of(suns, group, k))
        if is_far_off(view.point.position):
            given = vector_in_double(suns.directions, suns.double_directions, wp.int64(sun_number(suns, group, k)))
            move_ray_near(view.point, k, unit_in_double(given, suns.double_directions))
        k += 1
    _prepare(seen, view.point, view.local, GROUP)


@wp.func
def aim_at_disc(suns: Suns, seen: Accelerator, view: View, column: wp.int32, sun: wp.vec3):
    """Prepare rays from a point towards positions on a sun's disc, uniform in solid angle."""
    frame = frame_about(sun)
    key = stream_key(view.point.key, wp.uint32(column))
    chunk = view.point.chunk
    k = wp.int32(0)
    while k < DISC_RAYS:
        u = fibonacci_sample(key, wp.uint32(k), wp.uint32(DISC_RAYS))
        set_direction(chunk, k, to_world(frame, square_to_uniform_cone(u, suns.one_minus_cos)))
        k += 1
    if is_far_off(view.point.position):
        for i in range(DISC_RAYS):
            move_ray_near(view.point, i, unit_in_double(in_double(direction_of(chunk, i)), 0))
    _prepare(seen, view.point, view.local, DISC_RAYS)


@wp.func
def _remember(suns: Suns, view: View, face: wp.int32):
    """Store a triangle that blocked a ray in the point's list of blockers, which the next rays test first."""
    corners = vec3i_at(suns.faces, face)
    lane = word(view, NEXT)
    a = vec3_at(suns.vertices, corners[0])
    b = vec3_at(suns.vertices, corners[1])
    store_triangle(view.blockers, lane, a, b, vec3_at(suns.vertices, corners[2]))
    set_int(view.words, NEXT, (lane + 1) % TRIANGLES)
    set_int(view.words, KNOWN, wp.min(word(view, KNOWN) + 1, TRIANGLES))


@wp.func
def is_blocked(suns: Suns, whole: Accelerator, seen: Accelerator, view: View, k: wp.int32, cosine: wp.float64) -> wp.bool:
    """Return whether the k-th prepared ray to a sun hits anything; `cosine` is between the ray and the normal.

    The point's remembered triangles are tested first.
    """
    column = column_of(view.point.chunk, k)
    reach = float_at(column, REACH)
    if not (reach > 0.0):
        return False
    known = blocker_mask(view)
    if known != 0 and any_in_leaf(view.blockers, known, column, reach) >= 0:
        add(view, REMEMBERED, 1)
        return True
    add(view, CAST, 1)
    local = view.local
    if cosine < LEAST_COSINE:
        seen = whole
        local = 0
    _distance, face = _hit(seen, view.point, local, k)
    if face >= 0 and view.skips:
        _remember(suns, view, face)
    return face >= 0
