"""Kernel argument of estimates: normals and strata of the rays of all points, and addresses of the result arrays."""

import warp as wp

from warpsample.distributions.parameters import Parameters
from warpsample.estimate.integrand import Lobe
from warpsample.host.locks import once
from warpsample.maths.frames import frame_along
from warpsample.maths.memory import vec4_at
from warpsample.tracing.placement import Placement, id_of
from warpsample.tracing.queries import Accelerator, Glass
from warpsample.tracing.sight.point import ShadingPoint
from warpsample.tracing.sight.search import EMPTY, in_local_leaf, search_shaft
from warpsample.tracing.sight.shafts import VECTORS_BYTES, aim_about

NONFINITE_VALUE = 5
"""Status of a point whose integrand is not finite. `sight.point` and `directions.samples` define the other statuses."""


BLOCKERS, GLASS = 1, 2
"""Bits for the kinds of faces that rays of a part of the lobe may hit: opaque faces, partly transmitting faces."""


@wp.struct
class Lobes:
    """Kernel argument of an estimate at P points: numbers, and addresses of input and output arrays.

    placement: Positions and face normals of the points. Ray origins are moved off the face along the face normal.
    seed: Random seed of the rays.
    first_point: Global id of row 0 of these P points.
    first_row: Row of these points' row 0 in the whole call.
    visits, rows: Number of points to compute in all, and per task.
    normals: Axes of the lobes, (P, 3) float32.
    active: Mask of the points to compute, (P,) uint8, or address 0 for all points.
    samples_per_stratum, bands, sectors: Numbers that define the strata, see `Strata`.
    shafts: Shafts about the strata, see `Strata`, or address 0 to test no shaft.
    skip: Whether the tree is searched for strata and nodes without faces to hit.
    falloff: Exponent of the falloff, 0 without one.
    edge: Largest variance expected from an edge through a stratum, in rays squared; the limit of `edge_variance`.
    parameters: Parameters of the distribution.
    tables: Address of the addresses of the parameters by point, see `distributions.by_point.tables`, or 0.
    tangents: Tangents of the points, (P, 4) float32, or 0.
    value, error, spread, degrees: Results, (P, channels) float32.
    cast: Number of rays cast, (P,) int32.
    empty: Number of rays in strata that are proven empty, (P,) int32.
    status: Status of the points, (P,) uint8.
    glass: Tree of the partly transmitting faces, if the mesh has any.
    """

    placement: Placement
    seed: wp.uint64
    first_point: wp.uint64
    first_row: wp.int32
    visits: wp.int64
    rows: wp.int32
    normals: wp.uint64
    active: wp.uint64
    samples_per_stratum: wp.int32
    bands: wp.int32
    sectors: wp.int32
    shafts: wp.uint64
    skip: wp.int32
    falloff: wp.float32
    edge: wp.float32
    parameters: Parameters
    tables: wp.uint64
    tangents: wp.uint64
    value: wp.uint64
    error: wp.uint64
    spread: wp.uint64
    degrees: wp.uint64
    cast: wp.uint64
    empty: wp.uint64
    status: wp.uint64
    glass: Glass


LobesArgs = type(Lobes().__ctype__())


@wp.func
def lobe_of(lobes: Lobes, point: ShadingPoint) -> Lobe:
    """Return the second argument of a user's integrand: the point's unit normal, row and global id."""
    lobe = Lobe()
    lobe.normal = point.n
    lobe.row = lobes.first_row + wp.int32(point.index)
    lobe.point = id_of(lobes.placement, lobes.first_point, point.index)
    return lobe


@once
def orienter_of(tangents: bool) -> wp.Function:
    """Build the Warp function that returns a point's normal or, with `tangents`, the frame along the point's tangent."""
    if not tangents:

        @wp.func
        def orient(lobes: Lobes, point: ShadingPoint):
            """Return (unit normal, 1); 1 means that rays of the point can be sampled."""
            return point.n, wp.int32(1)

    else:

        @wp.func
        def orient(lobes: Lobes, point: ShadingPoint):
            """Return (frame along the tangent, 1), or (arbitrary frame about the normal, 0) if the tangent is invalid."""
            frame, usable = frame_along(point.n, vec4_at(lobes.tangents, point.index))
            return frame, usable

    return orient


@once
def finder_of(glass: bool) -> wp.Function:
    """Build the Warp function that searches the mesh for faces in one stratum of a point's directions."""

    @wp.func
    def find(lobes: Lobes, tree: Accelerator, point: ShadingPoint, i: wp.int32, local: wp.int32):
        """Return bits for the kinds of faces that rays of the i-th stratum may hit, and a mask of nearby triangles."""
        aim_about(lobes.shafts + wp.uint64(i) * VECTORS_BYTES, point)
        found = search_shaft(tree, point, local)
        may_meet = wp.where(found.state == EMPTY, 0, BLOCKERS)
        if wp.static(glass):
            may_meet = may_meet | wp.where(search_shaft(lobes.glass.tree, point, 0).state == EMPTY, 0, GLASS)
        return may_meet, in_local_leaf(found, point)

    return find
