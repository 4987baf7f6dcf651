"""Independent uniform points by hashing: the fastest, with the 1/sqrt(n) error of Monte Carlo."""

import warp as wp

from warpsample.maths.numerics import high_word, low_word
from warpsample.sequences.hashing import ONE_WORD, pcg4d, point_of_two, two_points
from warpsample.sequences.record import Sequence

_POINT_STEP = wp.constant(wp.uint32(0x9E3779B9))
_POINT_MASK = wp.constant(wp.uint32(0x85EBCA6B))


@wp.func
def _words(seed: wp.uint64, point: wp.uint64, half: wp.uint32) -> wp.vec4ui:
    far = high_word(point)
    return pcg4d(half, low_word(point), low_word(seed) + far * _POINT_STEP, high_word(seed) ^ (far * _POINT_MASK))


@wp.func
def independent(seed: wp.uint64, point: wp.uint64, sample: wp.uint32, count: wp.uint32) -> wp.vec2:
    """An independent point of the square: two of the four words of pcg4d of (sample / 2, point, seed).

    pcg4d takes 128 bits and the arguments have 159, so the high word of `point` goes into both seed words. Below 2^32
    points no two arguments share a stream; above, two do only if both words are equal (probability 2^-64).
    """
    return point_of_two(_words(seed, point, sample >> ONE_WORD), sample)


@wp.func
def independent_pair(seed: wp.uint64, point: wp.uint64, half: wp.uint32, count: wp.uint32) -> wp.vec4:
    """The points of samples 2 half and 2 half + 1, at the cost of one."""
    return two_points(_words(seed, point, half))


RECORD = Sequence(
    name="independent",
    sample=independent,
    progressive=True,
    colour="#555555",
    marker="v",
    random=True,
    summary="independent points from pcg4d, the fastest",
    pair=independent_pair,
    rate=0.5,
    edge=1.0,
    source="Jarzynski2020, listing 13",
)
