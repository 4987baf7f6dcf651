"""Independent uniform points by hashing: the fastest, with the 1/sqrt(n) error of Monte Carlo."""

import warp as wp

from warpsample.maths.numerics import high_word, low_word
from warpsample.sequences.hashing import ONE_WORD, halves_swapped, pcg4d, point_of_two, premixed_key, run_key, two_points
from warpsample.sequences.record import Sequence

_HALF_A_WORD = wp.constant(wp.uint32(16))
_MURMUR = wp.constant(wp.uint32(0x85EBCA6B))
_MURMUR_SHIFT = wp.constant(wp.uint32(13))


@wp.func
def _words(key: wp.vec4ui, half: wp.uint32) -> wp.vec4ui:
    # Half of the finaliser of Appleby2016: pcg4d carries bits to higher ones only, but for one shift, so that a bit of the
    # number could undo one of the point's word.
    half = (half ^ (half >> _HALF_A_WORD)) * _MURMUR
    half = half ^ (half >> _MURMUR_SHIFT)
    return pcg4d(key[1] ^ half, key[0], key[2], key[3] + halves_swapped(half))


@wp.func
def independent_sample(key: wp.vec4ui, sample: wp.uint32, count: wp.uint32) -> wp.vec2:
    """Two of the four words of pcg4d of a point's key and sample / 2."""
    return point_of_two(_words(key, sample >> ONE_WORD), sample)


@wp.func
def independent_pair(key: wp.vec4ui, half: wp.uint32, count: wp.uint32) -> wp.vec4:
    """The points of samples 2 half and 2 half + 1, at the cost of one."""
    return two_points(_words(key, half))


@wp.func
def independent(seed: wp.uint64, point: wp.uint64, sample: wp.uint32, count: wp.uint32) -> wp.vec2:
    """An independent point of the square.

    pcg4d and what mixes its arguments are bijections, so of 2^32 points with one seed and the same upper half of their ids
    no two share random words; of others, two do by chance only (probability 2^-128).
    """
    return independent_sample(premixed_key(run_key(seed, high_word(point)), low_word(point)), sample, count)


RECORD = Sequence(
    name="independent",
    key=premixed_key,
    sample=independent_sample,
    progressive=True,
    unseen=1.55,
    colour="#555555",
    marker="v",
    random=True,
    summary="independent points from pcg4d, the fastest",
    pair=independent_pair,
    rate=0.5,
    edge=1.0,
    source="Jarzynski2020, listing 13",
)
