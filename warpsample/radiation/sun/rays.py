"""The rays of a point towards a group of suns, or towards the points of a sun's disc; and whether one is blocked."""

import warp as wp

from warpsample.distributions.uniform_cone import square_to_uniform_cone
from warpsample.estimate.skipping.frontier import NEAR, NEAR_EDGE
from warpsample.host.locks import once
from warpsample.maths.frames import frame_about, to_world
from warpsample.maths.memory import float_at, int_at, vec3_at, vec3i_at
from warpsample.maths.numerics import ZERO, greater
from warpsample.radiation.sun.view import (
    CAST,
    KNOWN,
    KNOWN_FLOATS,
    NEXT,
    REMEMBERED,
    WORDS,
    Suns,
    View,
    add,
    known_triangles,
    word,
)
from warpsample.sequences.fibonacci import fibonacci_sample
from warpsample.sequences.hashing import stream_key
from warpsample.tracing.placement import far_off, unit_in_double, vector_in_double, way_to_scene
from warpsample.tracing.wide.layout import (
    CHUNK,
    CHUNK_FLOATS,
    DIRECTION,
    LEAF_BYTES,
    ORIGIN,
    REACH,
    WIDTH,
    Accelerator,
    face_in,
)
from warpsample.tracing.wide.prepare import prepare_wide, ray_in
from warpsample.tracing.wide.query import any_of, wide_walk

DISC_RAYS = WIDTH
"""Of a disc that is neither proven lit nor dark: its share has an error of 0.037 (RMS) where a straight edge cuts it."""

LEAST_COSINE = wp.constant(wp.float64(2.0**-12))
"""Of a ray to which what is below the horizon does not matter: the same as of the rays of an estimate."""

GROUP_BYTES = wp.constant(wp.uint64(3 * 4 * WIDTH))
"""Of a group's directions, and of a beam."""

_COLUMN_BYTES = wp.constant(wp.uint64(4 * WIDTH))
_GROUP_FLOATS = 3 * WIDTH
_EDGE = LEAF_BYTES // 4


@wp.func
def column_of(suns: Suns, group: wp.int32, k: wp.int32) -> wp.int32:
    """The caller's row of the k-th sun of a group."""
    return int_at(suns.columns + wp.uint64(group) * _COLUMN_BYTES, k)


@wp.func
def sun_of(suns: Suns, group: wp.int32, k: wp.int32) -> wp.vec3:
    """The direction towards the k-th sun of a group; zero if it has fewer."""
    rows = wp.array(ptr=suns.groups + wp.uint64(group) * GROUP_BYTES, shape=(_GROUP_FLOATS,), dtype=wp.float32)
    return wp.vec3(rows[k], rows[WIDTH + k], rows[2 * WIDTH + k])


@wp.func
def start_all(view: View):
    """Lets all rays of the chunk start from the point."""
    rays = wp.array(ptr=view.chunk, shape=(CHUNK_FLOATS,), dtype=wp.float32)
    k = wp.int32(0)
    while k < CHUNK:
        rays[ORIGIN + k] = view.o[0]
        rays[ORIGIN + CHUNK + k] = view.o[1]
        rays[ORIGIN + 2 * CHUNK + k] = view.o[2]
        rays[REACH + k] = view.reach
        k += 1


@wp.func
def way_of(view: View, k: wp.int32) -> wp.vec3:
    """The direction of the chunk's k-th ray."""
    rays = wp.array(ptr=view.chunk, shape=(CHUNK_FLOATS,), dtype=wp.float32)
    return wp.vec3(rays[DIRECTION + k], rays[DIRECTION + CHUNK + k], rays[DIRECTION + 2 * CHUNK + k])


@wp.func
def _aim(view: View, k: wp.int32, d: wp.vec3):
    """Sets the direction of the chunk's k-th ray."""
    rays = wp.array(ptr=view.chunk, shape=(CHUNK_FLOATS,), dtype=wp.float32)
    for axis in range(3):
        rays[DIRECTION + axis * CHUNK + k] = d[axis]


@wp.func
def _bring_near(suns: Suns, view: View, k: wp.int32, unit: wp.vec3d):
    """Lets the k-th ray of a point that is far off start near the mesh; without reach if it passes it. As `trace` does."""
    rays = wp.array(ptr=view.chunk, shape=(CHUNK_FLOATS,), dtype=wp.float32)
    ahead = way_to_scene(view.place, unit)
    o = wp.vec3(view.place + ahead * unit)
    for axis in range(3):
        rays[ORIGIN + axis * CHUNK + k] = o[axis]
    rays[REACH + k] = wp.where(ahead < ZERO, -1.0, wp.float32(suns.placement.reach - ahead))


@wp.func
def aim_at_group(suns: Suns, view: View, group: wp.int32):
    """Makes the rays towards the suns of a group."""
    k = wp.int32(0)
    while k < WIDTH:  # a range of 16 would be unrolled, and take seconds to compile
        _aim(view, k, sun_of(suns, group, k))
        if far_off(view.place):
            given = vector_in_double(suns.directions, suns.double_directions, wp.int64(column_of(suns, group, k)))
            _bring_near(suns, view, k, unit_in_double(given, suns.double_directions))
        k += 1
    prepare_wide(view.chunk, WIDTH)


@wp.func
def aim_at_disc(suns: Suns, view: View, column: wp.int32, sun: wp.vec3):
    """Makes the rays towards points of a sun's disc, evenly spread over its solid angle."""
    frame = frame_about(sun)
    key = stream_key(view.key, wp.uint32(column))
    k = wp.int32(0)
    while k < DISC_RAYS:
        u = fibonacci_sample(key, wp.uint32(k), wp.uint32(DISC_RAYS))
        d = to_world(frame, square_to_uniform_cone(u, suns.one_minus_cos))
        _aim(view, k, d)
        if far_off(view.place):
            _bring_near(suns, view, k, unit_in_double(wp.vec3d(wp.float64(d[0]), wp.float64(d[1]), wp.float64(d[2])), 0))
        k += 1
    prepare_wide(view.chunk, DISC_RAYS)


@wp.func
def _remember(suns: Suns, view: View, face: wp.int32):
    """Keeps a triangle that blocked a ray, in the place of the oldest."""
    leaf = wp.array(ptr=view.known, shape=(KNOWN_FLOATS,), dtype=wp.float32)
    corners = vec3i_at(suns.faces, face)
    lane = word(view, NEXT)
    low = wp.vec3(wp.INF)
    high = wp.vec3(-wp.INF)
    for i in range(3):
        v = vec3_at(suns.vertices, corners[i])
        low = wp.min(low, v)
        high = wp.max(high, v)
        for axis in range(3):
            leaf[(3 * i + axis) * WIDTH + lane] = v[axis]
    leaf[_EDGE] = greater(leaf[_EDGE], wp.max(high - low))
    words = wp.array(ptr=view.words, shape=(WORDS,), dtype=wp.int32)
    words[NEXT] = (lane + 1) % WIDTH
    words[KNOWN] = wp.min(words[KNOWN] + 1, WIDTH)


@once
def blocked_by() -> wp.Function:
    """A function that traces a ray of a prepared chunk."""
    walk = wide_walk(True, several=True)

    @wp.func
    def blocked(suns: Suns, whole: Accelerator, seen: Accelerator, view: View, k: wp.int32, cosine: wp.float64) -> wp.bool:
        """Whether the k-th ray, of that cosine to the normal, meets anything; known triangles are tried first."""
        column = view.chunk + wp.uint64(4 * k)
        reach = float_at(column, REACH)
        if not (reach > 0.0):
            return False
        ray = ray_in(column)
        known = known_triangles(view)
        if known != 0:
            edge = float_at(view.known, _EDGE)
            if any_of(view.known, known, ray, reach, edge) >= 0:
                add(view, REMEMBERED, 1)
                return True
        add(view, CAST, 1)
        face = wp.int32(-1)
        if cosine < LEAST_COSINE:
            seen = whole
        elif view.near != 0:
            edge = float_at(view.room + NEAR_EDGE, 0)
            lane = any_of(view.room + NEAR, view.near, ray, reach, edge)
            if lane >= 0:
                face = face_in(view.room + NEAR, lane)
        if face < 0 and seen.starts > 0:
            _distance, face, _nodes, _leaves = walk(seen, ray, reach, view.scratch)
        if face >= 0 and view.skips:
            _remember(suns, view, face)
        return face >= 0

    return blocked
