"""The parts that a kernel of an estimate is made of; each combination is compiled once."""

from dataclasses import dataclass
from typing import Any

import warp as wp

from warpsample.sequences.record import Sequence


@dataclass(frozen=True)
class Slots:
    """The parts that fit into the kernel.

    Attributes:
        sequence: of the rays.
        about: (unit normal, u, Parameters) -> (direction, pdf): its strata are those of the square.
        redraw: what replaces `about` where its pdf is below `redraw_below`, or None.
        redraw_below: that pdf.
        upward: whether all directions have a cosine to the normal of at least 2^-12, as those of the cosine lobe do: then
            what is below a point's horizon need not be looked at.
        weigh: (direction, Lobe, data) -> vec3 that a ray adds which meets nothing; one of weight 0 is not cast.
        struct: the type of the data.
        constant: whether that is (1, 0, 0) in all directions.
        counts: whether each ray adds 1 or 0, and nothing between.
        channels: 1 or 3, how many of the vec3 are kept.
        prepare: (chunk, rays): adds what the query needs.
        query: (Accelerator, ray, reach, scratch) -> (distance, face, nodes, leaves).
        any_hit: whether some face is enough; else what is met at t of reach leaves 1 - (1 - t)^falloff of the weight.
        wide: whether the query is that of the wide tree, which can be searched for what to skip.
        glass: whether there are faces besides, that let some light through; then any hit will do.
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
