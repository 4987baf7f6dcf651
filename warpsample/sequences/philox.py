"""Independent uniform points from Philox4x32-10, a slower generator than PCG4D, with published test vectors."""

import warp as wp

from warpsample.maths.numerics import high_word, low_word
from warpsample.sequences.hashing import ONE_WORD, ZERO_WORD, philox4x32_10, point_from_words, points_from_words
from warpsample.sequences.record import Sequence


@wp.func
def _run(seed: wp.uint64, high: wp.uint32) -> wp.vec4ui:
    """Return four words with the seed and the upper 32 bits of a point id, unchanged, for Philox to mix later."""
    return wp.vec4ui(ZERO_WORD, high, low_word(seed), high_word(seed))


def _run_words(seed: int, high: int) -> tuple[int, int, int, int]:
    """Return the words of `_run`, computed in Python instead of in a kernel."""
    return 0, high, seed % 2**32, seed >> 32


@wp.func
def _key(run: wp.vec4ui, low: wp.uint32) -> wp.vec4ui:
    """Return the key of a surface point: the two halves of the point's id, then the two halves of the seed."""
    return wp.vec4ui(low, run[1], run[2], run[3])


@wp.func
def _words(key: wp.vec4ui, half: wp.uint32) -> wp.vec4ui:
    """Return the four random words from which samples 2 * half and 2 * half + 1 are made, by one block of Philox."""
    return philox4x32_10(wp.vec4ui(half, key[0], key[1], ZERO_WORD), key[2], key[3])


@wp.func
def philox_sample(key: wp.vec4ui, sample: wp.uint32, count: wp.uint32) -> wp.vec2:
    """Return sample number `sample` of a surface point's independent points of the unit square, by Philox4x32-10.

    The point is made from two of the four words of the counter (sample / 2, id, 0).
    """
    return point_from_words(_words(key, sample >> ONE_WORD), sample)


@wp.func
def philox_pair(key: wp.vec4ui, half: wp.uint32, count: wp.uint32) -> wp.vec4:
    """Return two independent points, (x0, y0, x1, y1): samples 2 * half and 2 * half + 1, by one block of Philox."""
    return points_from_words(_words(key, half))


@wp.func
def philox(seed: wp.uint64, point: wp.uint64, sample: wp.uint32, count: wp.uint32) -> wp.vec2:
    """Return an independent uniform point of the unit square, from Philox4x32-10.

    Different points and samples under one seed never share random words.
    """
    return philox_sample(_key(_run(seed, high_word(point)), low_word(point)), sample, count)


RECORD = Sequence(
    name="philox",
    run=_run,
    run_words=_run_words,
    key=_key,
    sample=philox_sample,
    progressive=True,
    unseen=1.55,
    colour="#9c927a",
    marker="x",
    random=True,
    summary="independent points from Philox4x32-10, the strictest generator",
    pair=philox_pair,
    rate=0.5,
    edge=1.0,
    source="Salmon2011, section 4.4",
)
