"""Fibonacci lattice: u[0] is evenly spaced, u[1] advances by the golden ratio; the best sequence here for visibility."""

import warp as wp

from warpsample.maths.numerics import high_word, uniform_from_bits, weyl
from warpsample.sequences.hashing import point_key
from warpsample.sequences.record import Sequence

GOLDEN_STEP: wp.uint64 = wp.constant(wp.uint64(0x9E3779B97F4A7C15))
"""Step of u[1] from one point to the next, 1 / phi for the golden ratio phi, as a multiple of 2^-64."""

_BELOW_2_64 = wp.constant(wp.float64(2.0**64 * (1.0 - 2.0**-53)))


@wp.func
def fibonacci_sample(key: wp.vec4ui, sample: wp.uint32, count: wp.uint32) -> wp.vec2:
    """Return point number `sample` of a Fibonacci lattice of `count` points, randomly shifted and rotated by the key.

    The point is ((sample + shift) / count, sample / phi + rotation mod 1). Keinert2014 uses the constant shift 1/2, the mean
    of the random shift; a random shift makes the estimate unbiased for every count. The phase sample / phi is the top of an
    integer product, exact to 2^-32 for any sample; float32 would lose the phase at 10^7.
    """
    # The step is rounded down so that sample + shift stays below count; it is within 2^-31 of the quotient.
    step = wp.uint64(_BELOW_2_64 / wp.float64(count))
    shift = high_word(wp.uint64(key[0]) * wp.uint64(high_word(step)))
    return wp.vec2(uniform_from_bits(weyl(sample, step) + shift), uniform_from_bits(weyl(sample, GOLDEN_STEP) + key[1]))


@wp.func
def fibonacci(seed: wp.uint64, point: wp.uint64, sample: wp.uint32, count: wp.uint32) -> wp.vec2:
    """Return point number `sample` of a Fibonacci lattice of `count` points in the unit square.

    The lattice has a random shift and rotation at each surface point.
    """
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
