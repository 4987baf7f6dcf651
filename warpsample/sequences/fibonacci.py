"""The Fibonacci lattice: evenly spaced in u[0], golden-ratio rotated in u[1]; the best here for visibility."""

import warp as wp

from warpsample.numerics import uniform_from_bits, uniform_from_double, weyl
from warpsample.sequences.hashing import point_key
from warpsample.sequences.record import Sequence

GOLDEN_STEP = wp.constant(wp.uint64(0x9E3779B97F4A7C15))
"""2^64 / phi: the turn from one point to the next."""

_WORD_STEP = wp.constant(wp.float64(2.0**-32))


@wp.func
def fibonacci(seed: wp.uint64, point: wp.uint64, sample: wp.uint32, count: wp.uint32) -> wp.vec2:
    """((sample + shift) / count, sample / phi + rotation mod 1), shift and rotation random at every surface point.

    The shift 1/2 of Keinert's sets (Shirley's blog, 2014) is this one's mean; a random one makes every count unbiased.
    The phase i / phi is the top of an integer product, within 2^-32 for any i: float32 has lost it at 10^7.
    """
    key = point_key(seed, point)
    shift = wp.float64(key[0]) * _WORD_STEP
    return wp.vec2(
        uniform_from_double((wp.float64(wp.int32(sample)) + shift) * (wp.float64(1.0) / wp.float64(count))),
        uniform_from_bits(weyl(sample, GOLDEN_STEP) + key[1]),
    )


RECORD = Sequence(
    name="fibonacci",
    sample=fibonacci,
    progressive=False,
    summary="Fibonacci lattice with a random shift and rotation, the best for visibility",
    source="Marques et al. 2013, Spherical Fibonacci Point Sets; Keinert in Shirley 2014",
)
