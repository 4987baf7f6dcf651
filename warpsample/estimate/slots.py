"""Compile-time parameters of the estimate kernel. Each combination of parameters is compiled once."""

from dataclasses import dataclass
from typing import Any

import warp as wp

from warpsample.distributions.by_point.tables import Layout
from warpsample.sequences.record import Sequence


@dataclass(frozen=True)
class Slots:
    """Compile-time parameters of the estimate kernel: the Warp functions to call, and switches for optional features.

    Attributes:
        sequence: Sequence of the rays' random numbers.
        about: Warp function (unit normal, u, Parameters) -> (direction, pdf), with `tangents` of a frame in place of the
            normal. Strata of the unit square become strata of directions.
        redraw: Warp function that replaces `about` where the pdf of `about` is below `redraw_below`, or None.
        redraw_below: Pdf below which `redraw` is called, in 1/sr.
        upward: Whether all directions have a cosine to the normal of at least 2^-12, as in the cosine lobe. The geometry
            below a point's horizon is then skipped.
        weigh: Warp function (direction, Lobe, data) -> weight of an unoccluded ray, a vec3. Rays of weight 0 are not cast.
        struct: Type of the data, a wp.struct.
        constant: Whether the weight is (1, 0, 0) in all directions.
        counts: Whether each ray adds exactly 0 or 1.
        channels: Number of components of the weight that are stored, 1 or 3.
        prepare: Warp function (chunk, rays) that stores the values derived from each ray that the query needs, or None.
        query: Warp function (Accelerator, ray, reach, scratch) -> (distance, face, nodes, leaves), or None without a mesh.
        any_hit: Whether any hit stops the ray. Otherwise a hit at fraction t of the reach leaves 1 - (1 - t)^falloff of the
            weight.
        wide: Whether the query traverses the wide tree, which can also be searched for work to skip.
        glass: Whether the mesh has partly transmitting faces, which are kept in a tree of their own.
        sparse: Whether rays of weight 0 count neither as occluded nor as unoccluded in confidence intervals.
        layout: Parameters of the distribution that are by point.
        tangents: Whether the points have tangents.
        reads_pdf: Whether the integrand reads the density of a direction, `Lobe.pdf`.
        binary: Whether the weight is (1, 0, 0) or 0 in each direction.
    """

    sequence: Sequence
    about: wp.Function
    redraw: wp.Function | None
    redraw_below: float
    upward: bool
    weigh: wp.Function
    struct: Any
    constant: bool
    counts: bool
    channels: int
    prepare: wp.Function
    query: wp.Function
    any_hit: bool
    wide: bool
    glass: bool = False
    sparse: bool = False
    layout: Layout = ()
    tangents: bool = False
    reads_pdf: bool = False
    binary: bool = False
