"""The arguments of an estimate's kernel, and one point with its rays as the kernel sees it."""

import warp as wp

from warpsample.distributions.parameters import Parameters
from warpsample.estimate.integrand import Lobe
from warpsample.estimate.skipping.beams import meets, triangles_in
from warpsample.estimate.skipping.frontier import NEAR
from warpsample.maths.frames import frame_about, to_world
from warpsample.tracing.placement import Placement, way_to_scene
from warpsample.tracing.wide.boxes import PADDING
from warpsample.tracing.wide.layout import BEAM_FLOATS, CHUNK, CHUNK_FLOATS, DIRECTION, ORIGIN, REACH, WIDTH, Accelerator

NONFINITE_POSITION, NONFINITE_VALUE = 4, 5
"""The status of a point that is nowhere, and of one whose integrand is not finite; `directions.samples` has the others."""

_PADDING = wp.constant(wp.float32(PADDING))
_VISITS = wp.constant(wp.int32(32))  # nodes and leaves that a beam may look into: as long as five rays take
_BEAM = wp.constant(wp.uint64(12 * WIDTH))
_BEAM_LOCAL = 3 * WIDTH


@wp.struct
class Lobes:
    """Scalars and addresses of the lobes of all points, their cells, and where their numbers go.

    placement: of the points; its normals are those of their faces, along which they are moved off.
    first_row: of these points in the whole call; first_point is the global id of the first of them.
    visits, rows: points that are visited, in all and by a task.
    normals, active: (P, 3) float32, (P,) uint8 or 0: the lobes' axes, and which points count.
    each, bands, sectors, beams: as `Cells` has them; beams 0 tests none.
    skip: whether the tree is searched for what cannot be met.
    edge: what is expected at most of an edge through a cell, see `edge_variance`. parameters: of the distribution.
    value, error, spread, degrees: (P, channels) float32.
    cast, empty, status: (P,) int32, int32, uint8: rays cast, rays in parts of the lobe that meet nothing, why not.
    """

    placement: Placement
    seed: wp.uint64
    first_point: wp.uint64
    first_row: wp.int32
    visits: wp.int64
    rows: wp.int32
    normals: wp.uint64
    active: wp.uint64
    each: wp.int32
    bands: wp.int32
    sectors: wp.int32
    beams: wp.uint64
    skip: wp.int32
    falloff: wp.float32
    edge: wp.float32
    parameters: Parameters
    value: wp.uint64
    error: wp.uint64
    spread: wp.uint64
    degrees: wp.uint64
    cast: wp.uint64
    empty: wp.uint64
    status: wp.uint64


LobesArgs = type(Lobes().__ctype__())


@wp.struct
class Spot:
    """A point and its rays.

    The key of its random numbers, unit normal, origin as it is and as rays have it, what is lower is below the horizon,
    reach, and memory to work in.
    """

    lobe: Lobe
    key: wp.vec4ui
    n: wp.vec3
    place: wp.vec3d
    o: wp.vec3
    low: wp.float32
    reach: wp.float32
    chunk: wp.uint64
    square: wp.uint64
    room: wp.uint64
    beam: wp.uint64
    scratch: wp.uint64


@wp.func
def aim(local: wp.uint64, n: wp.vec3, o: wp.vec3, low: wp.float32, beam: wp.uint64):
    """Turns a beam of `Cells` about a normal and starts it from an origin."""
    frame = frame_about(n)
    vectors = wp.array(ptr=local, shape=(_BEAM_LOCAL,), dtype=wp.float32)
    aim = wp.array(ptr=beam, shape=(BEAM_FLOATS,), dtype=wp.float32)
    k = wp.int32(0)
    while k < WIDTH:
        v = to_world(frame, wp.vec3(vectors[k], vectors[WIDTH + k], vectors[2 * WIDTH + k]))
        aim[k] = v[0]
        aim[WIDTH + k] = v[1]
        aim[2 * WIDTH + k] = v[2]
        # Directions are rounded by 2^-20.4, at 7 from the point by 2^-17.6; boxes are padded by 2^-17 along each axis.
        aim[3 * WIDTH + k] = wp.dot(v, o)
        k += 1
    # The horizon, exactly; boxes are padded, what is in them is not.
    aim[3 * WIDTH] = wp.dot(n, o) - low + _PADDING * (wp.abs(n[0]) + wp.abs(n[1]) + wp.abs(n[2]))
    for axis in range(3):
        aim[axis * WIDTH] = n[axis]
        aim[4 * WIDTH + axis] = o[axis]
    aim[4 * WIDTH + 3] = low


@wp.func
def start_beam(vectors: wp.uint64, n: wp.vec3, o: wp.vec3, low: wp.float32, beam: wp.uint64):
    """Starts a beam of world directions from o; its first plane is the horizon of n, as in `aim`."""
    given = wp.array(ptr=vectors, shape=(_BEAM_LOCAL,), dtype=wp.float32)
    aim = wp.array(ptr=beam, shape=(BEAM_FLOATS,), dtype=wp.float32)
    k = wp.int32(0)
    while k < WIDTH:
        x = given[k]
        y = given[WIDTH + k]
        z = given[2 * WIDTH + k]
        aim[k] = x
        aim[WIDTH + k] = y
        aim[2 * WIDTH + k] = z
        aim[3 * WIDTH + k] = x * o[0] + y * o[1] + z * o[2]
        k += 1
    aim[3 * WIDTH] = wp.dot(n, o) - low + _PADDING * (wp.abs(n[0]) + wp.abs(n[1]) + wp.abs(n[2]))
    for axis in range(3):
        aim[axis * WIDTH] = n[axis]
        aim[4 * WIDTH + axis] = o[axis]
    aim[4 * WIDTH + 3] = low


@wp.func
def start(chunk: wp.uint64, o: wp.vec3, reach: wp.float32):
    """Lets all rays of a chunk start from o."""
    rays = wp.array(ptr=chunk, shape=(CHUNK_FLOATS,), dtype=wp.float32)
    k = wp.int32(0)
    while k < CHUNK:
        rays[ORIGIN + k] = o[0]
        rays[ORIGIN + CHUNK + k] = o[1]
        rays[ORIGIN + 2 * CHUNK + k] = o[2]
        rays[REACH + k] = reach
        k += 1


@wp.func
def bring_near(spot: Spot, column: wp.uint64):
    """Lets a ray of a point that is far off start near the mesh; without reach if it passes it."""
    ray = wp.array(ptr=column, shape=(CHUNK_FLOATS,), dtype=wp.float32)
    d = wp.vec3d(wp.float64(ray[DIRECTION]), wp.float64(ray[DIRECTION + CHUNK]), wp.float64(ray[DIRECTION + 2 * CHUNK]))
    ahead = way_to_scene(spot.place, d)
    o = wp.vec3(spot.place + ahead * d)
    for axis in range(3):
        ray[ORIGIN + axis * CHUNK] = o[axis]
    ray[REACH] = wp.where(ahead < wp.float64(0.0), -1.0, wp.float32(wp.float64(spot.reach) - ahead))


@wp.func
def found_in(lobes: Lobes, accelerator: Accelerator, spot: Spot, cell: wp.int32, near: wp.int32):
    """(whether a ray of a sector or cell may meet something, which of the triangles around the point)."""
    aim(lobes.beams + wp.uint64(cell) * _BEAM, spot.n, spot.o, spot.low, spot.beam)
    if near != 0:
        near = triangles_in(spot.room + NEAR, spot.beam) & near
    found = wp.where(near != 0, 1, 0)
    if found == 0 and accelerator.starts > 0:
        found = meets(accelerator, spot.beam, _VISITS, spot.scratch)
    return found, near
