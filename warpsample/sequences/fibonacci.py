"""The Fibonacci lattice: evenly spaced in u[0], rotated by the golden ratio in u[1]; the best here for visibility."""

import warp as wp

from warpsample.maths.numerics import high_word, uniform_from_bits, weyl
from warpsample.sequences.hashing import point_key
from warpsample.sequences.record import Sequence

GOLDEN_STEP: wp.uint64 = wp.constant(wp.uint64(0x9E3779B97F4A7C15))
"""2^64 / phi: the turn from one point to the next."""

_BELOW_2_64 = wp.constant(wp.float64(2.0**64 * (1.0 - 2.0**-53)))


@wp.func
def fibonacci_sample(key: wp.vec4ui, sample: wp.uint32, count: wp.uint32) -> wp.vec2:
    """((sample + shift) / count, sample / phi + rotation mod 1), shift and rotation random at every surface point.

    The shift 1/2 of Keinert2014 is the mean of this one; a random one makes every count unbiased.
    The phase i / phi is the top of an integer product, exact to 2^-32 for any i; in float32 it would be lost at 10^7.
    """
    # Rounded down, so that sample + shift stays below count; within 2^-31 of the quotient.
    step = wp.uint64(_BELOW_2_64 / wp.float64(count))
    shift = high_word(wp.uint64(key[0]) * wp.uint64(high_word(step)))
    return wp.vec2(uniform_from_bits(weyl(sample, step) + shift), uniform_from_bits(weyl(sample, GOLDEN_STEP) + key[1]))


@wp.func
def fibonacci(seed: wp.uint64, point: wp.uint64, sample: wp.uint32, count: wp.uint32) -> wp.vec2:
    """The sample-th of count points of the lattice, shifted and rotated at random at each surface point."""
    return fibonacci_sample(point_key(seed, point), sample, count)


RECORD = Sequence(
    name="fibonacci",
    sample=fibonacci_sample,
    progressive=False,
    wraps=True,
    colour="#d1495b",
    marker="s",
    cells_off=1,
    summary="Fibonacci lattice with a random shift and rotation, the best for visibility",
    source="Marques2013; Keinert2014",
)
