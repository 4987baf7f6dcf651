"""Independent uniform points from Philox4x32-10: slower than pcg4d, with published test vectors and no shared streams."""

import warp as wp

from warpsample.maths.numerics import high_word, low_word
from warpsample.sequences.hashing import ONE_WORD, ZERO_WORD, philox4x32_10, point_of_two, two_points
from warpsample.sequences.record import Sequence


@wp.func
def _run(seed: wp.uint64, high: wp.uint32) -> wp.vec4ui:
    """The words as they are: Philox mixes all bits of its counter and its key."""
    return wp.vec4ui(ZERO_WORD, high, low_word(seed), high_word(seed))


def _run_words(seed: int, high: int) -> tuple[int, int, int, int]:
    return 0, high, seed % 2**32, seed >> 32


@wp.func
def _key(run: wp.vec4ui, low: wp.uint32) -> wp.vec4ui:
    return wp.vec4ui(low, run[1], run[2], run[3])


@wp.func
def _words(key: wp.vec4ui, half: wp.uint32) -> wp.vec4ui:
    return philox4x32_10(wp.vec4ui(half, key[0], key[1], ZERO_WORD), key[2], key[3])


@wp.func
def philox_sample(key: wp.vec4ui, sample: wp.uint32, count: wp.uint32) -> wp.vec2:
    """Two of the four words of counter (sample / 2, point, 0) under the seed as key."""
    return point_of_two(_words(key, sample >> ONE_WORD), sample)


@wp.func
def philox_pair(key: wp.vec4ui, half: wp.uint32, count: wp.uint32) -> wp.vec4:
    """The points of samples 2 half and 2 half + 1, at the cost of one."""
    return two_points(_words(key, half))


@wp.func
def philox(seed: wp.uint64, point: wp.uint64, sample: wp.uint32, count: wp.uint32) -> wp.vec2:
    """An independent point of the square; different arguments never share random words."""
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
