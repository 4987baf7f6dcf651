"""The arguments of an estimate's kernel: the lobes of all points, cut into strata, and where their numbers go."""

import warp as wp

from warpsample.distributions.parameters import Parameters
from warpsample.estimate.integrand import Lobe
from warpsample.host.locks import once
from warpsample.tracing.placement import Placement, id_of
from warpsample.tracing.queries import Accelerator, Glass
from warpsample.tracing.sight.point import ShadingPoint
from warpsample.tracing.sight.search import EMPTY, in_local_leaf, search_shaft
from warpsample.tracing.sight.shafts import VECTORS_BYTES, aim_about

NONFINITE_VALUE = 5
"""The status of a point whose integrand is not finite; `sight.point` and `directions.samples` have the others."""


BLOCKERS, GLASS = 1, 2
"""What may be in a part of the lobe, as bits: faces that stop all light, and such that let some through."""


@wp.struct
class Lobes:
    """Scalars and addresses of the lobes of all points, their strata, and where their numbers go.

    placement: of the points; its normals are those of their faces, along which they are moved off.
    first_row: of these points in the whole call; first_point is the global id of the first of them.
    visits, rows: points that are visited, in all and by a task.
    normals, active: (P, 3) float32, (P,) uint8 or 0: the lobes' axes, and which points count.
    samples_per_stratum, bands, sectors, shafts: as `Strata` has them; shafts 0 tests none.
    skip: whether the tree is searched for what cannot be met.
    edge: what is expected at most of an edge through a stratum, see `edge_variance`. parameters: of the distribution.
    value, error, spread, degrees: (P, channels) float32.
    glass: the faces that let some light through, if there are any.
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
    samples_per_stratum: wp.int32
    bands: wp.int32
    sectors: wp.int32
    shafts: wp.uint64
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
    glass: Glass


LobesArgs = type(Lobes().__ctype__())


@wp.func
def lobe_of(lobes: Lobes, point: ShadingPoint) -> Lobe:
    """A point's lobe, as integrands are told of it."""
    lobe = Lobe()
    lobe.normal = point.n
    lobe.row = lobes.first_row + wp.int32(point.index)
    lobe.point = id_of(lobes.placement, lobes.first_point, point.index)
    return lobe


@once
def finder_of(glass: bool) -> wp.Function:
    """A function that looks for what is in a shaft about a part of the lobe."""

    @wp.func
    def find(lobes: Lobes, tree: Accelerator, point: ShadingPoint, i: wp.int32, local: wp.int32):
        """(what a ray of the i-th shaft may meet, which of the triangles of the local leaf)."""
        aim_about(lobes.shafts + wp.uint64(i) * VECTORS_BYTES, point)
        found = search_shaft(tree, point, local)
        may_meet = wp.where(found.state == EMPTY, 0, BLOCKERS)
        if wp.static(glass):
            may_meet = may_meet | wp.where(search_shaft(lobes.glass.tree, point, 0).state == EMPTY, 0, GLASS)
        return may_meet, in_local_leaf(found, point)

    return find
