"""Independent uniform points from Philox4x32-10: slower than pcg4d, with published test vectors and no shared streams."""

import warp as wp

from warpsample.maths.numerics import high_word, low_word
from warpsample.sequences.hashing import ONE_WORD, ZERO_WORD, point_of_two, two_points
from warpsample.sequences.record import Sequence

_MULTIPLIER_0 = wp.constant(wp.uint32(0xD2511F53))
_MULTIPLIER_1 = wp.constant(wp.uint32(0xCD9E8D57))
_WEYL_0 = wp.constant(wp.uint32(0x9E3779B9))
_WEYL_1 = wp.constant(wp.uint32(0xBB67AE85))


@wp.func
def philox4x32_10(counter: wp.vec4ui, key_0: wp.uint32, key_1: wp.uint32) -> wp.vec4ui:
    """Four random words: a keyed bijection of the 128-bit counter.

    Salmon2011, section 4.4; test vectors in Random123.
    """
    x0 = counter[0]
    x1 = counter[1]
    x2 = counter[2]
    x3 = counter[3]
    for _ in range(10):
        product_0 = wp.uint64(_MULTIPLIER_0) * wp.uint64(x0)
        product_1 = wp.uint64(_MULTIPLIER_1) * wp.uint64(x2)
        x0 = high_word(product_1) ^ x1 ^ key_0
        x1 = low_word(product_1)
        x2 = high_word(product_0) ^ x3 ^ key_1
        x3 = low_word(product_0)
        key_0 = key_0 + _WEYL_0
        key_1 = key_1 + _WEYL_1
    return wp.vec4ui(x0, x1, x2, x3)


@wp.func
def _words(seed: wp.uint64, point: wp.uint64, half: wp.uint32) -> wp.vec4ui:
    counter = wp.vec4ui(half, low_word(point), high_word(point), ZERO_WORD)
    return philox4x32_10(counter, low_word(seed), high_word(seed))


@wp.func
def philox(seed: wp.uint64, point: wp.uint64, sample: wp.uint32, count: wp.uint32) -> wp.vec2:
    """An independent point of the square: two of the four words of counter (sample / 2, point, 0) under the seed as key.

    Different arguments never share random words.
    """
    return point_of_two(_words(seed, point, sample >> ONE_WORD), sample)


@wp.func
def philox_pair(seed: wp.uint64, point: wp.uint64, half: wp.uint32, count: wp.uint32) -> wp.vec4:
    """The points of samples 2 half and 2 half + 1, at the cost of one."""
    return two_points(_words(seed, point, half))


RECORD = Sequence(
    name="philox",
    sample=philox,
    progressive=True,
    colour="#9c927a",
    marker="x",
    random=True,
    summary="independent points from Philox4x32-10, the strictest generator",
    pair=philox_pair,
    rate=0.5,
    edge=1.0,
    source="Salmon2011, section 4.4",
)
