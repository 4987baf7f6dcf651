"""Independent uniform points from the hash PCG4D: the fastest sequence, with the Monte Carlo error 1/sqrt(n)."""

import warp as wp

from warpsample.maths.numerics import high_word, low_word
from warpsample.sequences.hashing import (
    ONE_WORD,
    pcg4d,
    point_from_words,
    points_from_words,
    premixed_key,
    run_key,
    swap_halves,
)
from warpsample.sequences.record import Sequence

_HALF_WORD = wp.constant(wp.uint32(16))
_MURMUR = wp.constant(wp.uint32(0x85EBCA6B))
_MURMUR_SHIFT = wp.constant(wp.uint32(13))


@wp.func
def _words(key: wp.vec4ui, half: wp.uint32) -> wp.vec4ui:
    """Hash a key and `half` to the four random words from which samples 2 * half and 2 * half + 1 are made."""
    # The first half of the finaliser of Appleby2016. Apart from one shift, pcg4d carries bits only to higher bits. Without
    # the finaliser, a bit of the sample number could cancel a bit of the point's word.
    half = (half ^ (half >> _HALF_WORD)) * _MURMUR
    half = half ^ (half >> _MURMUR_SHIFT)
    return pcg4d(key[1] ^ half, key[0], key[2], key[3] + swap_halves(half))


@wp.func
def independent_sample(key: wp.vec4ui, sample: wp.uint32, count: wp.uint32) -> wp.vec2:
    """Return sample number `sample` of a surface point's independent uniform points of the unit square, from its key.

    One PCG4D hash serves samples 2k and 2k + 1.
    """
    return point_from_words(_words(key, sample >> ONE_WORD), sample)


@wp.func
def independent_pair(key: wp.vec4ui, half: wp.uint32, count: wp.uint32) -> wp.vec4:
    """Return two independent uniform points, (x0, y0, x1, y1): samples 2 * half and 2 * half + 1, with a single hash."""
    return points_from_words(_words(key, half))


@wp.func
def independent(seed: wp.uint64, point: wp.uint64, sample: wp.uint32, count: wp.uint32) -> wp.vec2:
    """Return an independent uniform point of the unit square, from the hash PCG4D.

    Under one seed, surface points whose ids have the same upper half never get the same four random words, since all steps
    of the hash are bijections. Any other two points get the same words with probability 2^-128.
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
