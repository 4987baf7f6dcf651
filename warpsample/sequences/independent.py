"""Independent uniform points by hashing: the cheapest, with the plain 1/sqrt(n) error of Monte Carlo."""

import warp as wp

from warpsample.numerics import high_word, low_word, uniform_from_bits
from warpsample.sequences.hashing import pcg4d
from warpsample.sequences.record import Sequence

_POINT_STEP = wp.constant(wp.uint32(0x9E3779B9))
_POINT_MASK = wp.constant(wp.uint32(0x85EBCA6B))


@wp.func
def independent(seed: wp.uint64, point: wp.uint64, sample: wp.uint32, count: wp.uint32) -> wp.vec2:
    """An independent point of the square: two words of pcg4d of the four (sample, point, seed).

    pcg4d takes 128 bits and the arguments have 160, so the high word of `point` goes into both seed words. Below 2^32
    points no two arguments share a stream; above, two seeds could only by both words meeting (chance 2^-64).
    """
    far = high_word(point)
    bits = pcg4d(sample, low_word(point), low_word(seed) + far * _POINT_STEP, high_word(seed) ^ (far * _POINT_MASK))
    return wp.vec2(uniform_from_bits(bits[0]), uniform_from_bits(bits[1]))


RECORD = Sequence(
    name="independent",
    sample=independent,
    progressive=True,
    summary="independent points from pcg4d, the fastest",
    source="Jarzynski and Olano 2020, listing 13",
)
