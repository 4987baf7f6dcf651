"""How a seed, a point and a stream become random words: a key once for each point, and pcg4d from there on.

All 64 bits of the seed, and the upper 32 of the point's id, pass a block of Philox, which is the same for all points of a
call, or nearly so. The lower 32 bits of the id pass a finaliser, and all of it together pcg4d. So each bit of either
changes about half of the bits of a key, while a point costs one hash and a sample none. What varies goes into several of
pcg4d's words: with one alone the lowest bits of its answers are uneven, and badly where a constant word is even many times.
"""

from functools import lru_cache
from hashlib import blake2b

import warp as wp

from warpsample.maths.numerics import high_word, low_word, uniform_from_bits

_MULTIPLIER = wp.constant(wp.uint32(1664525))
_INCREMENT = wp.constant(wp.uint32(1013904223))
_SHIFT = wp.constant(wp.uint32(16))
_MURMUR_1 = wp.constant(wp.uint32(0x85EBCA6B))
_MURMUR_2 = wp.constant(wp.uint32(0xC2B2AE35))
_MURMUR_SHIFT = wp.constant(wp.uint32(13))
_PHILOX_0 = wp.constant(wp.uint32(0xD2511F53))
_PHILOX_1 = wp.constant(wp.uint32(0xCD9E8D57))
_WEYL_0 = wp.constant(wp.uint32(0x9E3779B9))
_WEYL_1 = wp.constant(wp.uint32(0xBB67AE85))
_KEYS = wp.constant(wp.uint32(2))  # the fourth word of Philox's counter; directions use 0, points of a surface 1
_WORD = 2**32 - 1
ZERO_WORD: wp.uint32 = wp.constant(wp.uint32(0))
ONE_WORD: wp.uint32 = wp.constant(wp.uint32(1))


def seed_for(purpose: str, seed: int) -> int:
    """A seed of 64 bits for random numbers that a call takes besides its own, such as those of a trial.

    It is a cryptographic hash of both: no seed that a user is likely to choose gives the same numbers.
    """
    return int.from_bytes(blake2b(f"{purpose} {seed}".encode(), digest_size=8).digest(), "little")


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
        product_0 = wp.uint64(_PHILOX_0) * wp.uint64(x0)
        product_1 = wp.uint64(_PHILOX_1) * wp.uint64(x2)
        x0 = high_word(product_1) ^ x1 ^ key_0
        x1 = low_word(product_1)
        x2 = high_word(product_0) ^ x3 ^ key_1
        x3 = low_word(product_0)
        key_0 = key_0 + _WEYL_0
        key_1 = key_1 + _WEYL_1
    return wp.vec4ui(x0, x1, x2, x3)


@wp.func
def pcg4d(x: wp.uint32, y: wp.uint32, z: wp.uint32, w: wp.uint32) -> wp.vec4ui:
    """Four random words: a bijection of 128 bits, so different arguments never give the same four words.

    Jarzynski2020, listing 13. What differs in high bits alone, or in one word, gives dependent words, so only mixed words
    may come here, in two places or more.
    """
    x = x * _MULTIPLIER + _INCREMENT
    y = y * _MULTIPLIER + _INCREMENT
    z = z * _MULTIPLIER + _INCREMENT
    w = w * _MULTIPLIER + _INCREMENT
    x += y * w
    y += z * x
    z += x * y
    w += y * z
    x = x ^ (x >> _SHIFT)
    y = y ^ (y >> _SHIFT)
    z = z ^ (z >> _SHIFT)
    w = w ^ (w >> _SHIFT)
    x += y * w
    y += z * x
    z += x * y
    w += y * z
    return wp.vec4ui(x, y, z, w)


@wp.func
def finalised(word: wp.uint32) -> wp.uint32:
    """A bijection of 32 bits in which each bit changes about half of the others: the finaliser of Appleby2016."""
    word = (word ^ (word >> _SHIFT)) * _MURMUR_1
    word = (word ^ (word >> _MURMUR_SHIFT)) * _MURMUR_2
    return word ^ (word >> _SHIFT)


@wp.func
def run_key(seed: wp.uint64, high: wp.uint32) -> wp.vec4ui:
    """Four random words for all points whose ids have the same upper half: kernels compute them once."""
    return philox4x32_10(wp.vec4ui(high, ZERO_WORD, ZERO_WORD, _KEYS), low_word(seed), high_word(seed))


@lru_cache(maxsize=1024)
def run_words(seed: int, high: int) -> tuple[int, int, int, int]:
    """The words of `run_key`, on the host: kernels for directions would spend a tenth of their time on it."""
    x = [high, 0, 0, 2]
    key = [seed & _WORD, seed >> 32]
    for _ in range(10):
        product_0, product_1 = 0xD2511F53 * x[0], 0xCD9E8D57 * x[2]
        x = [(product_1 >> 32) ^ x[1] ^ key[0], product_1 & _WORD, (product_0 >> 32) ^ x[3] ^ key[1], product_0 & _WORD]
        key = [(key[0] + 0x9E3779B9) & _WORD, (key[1] + 0xBB67AE85) & _WORD]
    return x[0], x[1], x[2], x[3]


@wp.func
def halves_swapped(word: wp.uint32) -> wp.uint32:
    """A word turned by half of its bits."""
    return (word << _SHIFT) | (word >> _SHIFT)


@wp.func
def premixed_key(run: wp.vec4ui, low: wp.uint32) -> wp.vec4ui:
    """Four words for one point; the first is another one for each lower half of an id."""
    word = finalised(low ^ run[0])
    return wp.vec4ui(word, run[1] + halves_swapped(word), run[2] + word, run[3])


@wp.func
def mixed_key(run: wp.vec4ui, low: wp.uint32) -> wp.vec4ui:
    """Four random words for one point, by which a sequence scrambles or shifts its points."""
    key = premixed_key(run, low)
    return pcg4d(key[0], key[1], key[2], key[3])


@wp.func
def point_key(seed: wp.uint64, point: wp.uint64) -> wp.vec4ui:
    """The `mixed_key` of a point."""
    return mixed_key(run_key(seed, high_word(point)), low_word(point))


@wp.func
def stream_key(key: wp.vec4ui, stream: wp.uint32) -> wp.vec4ui:
    """The key of one of a point's streams, from its `point_key`: those of different streams are independent."""
    return mixed_key(key, stream)


@wp.func
def one_of(first: wp.vec4ui, second: wp.vec4ui, which: wp.int32) -> wp.vec4ui:
    """The first of two keys if `which` is 0, the second if it is 1. By masks: a select would prevent vectorisation."""
    mask = ZERO_WORD - wp.uint32(which)
    return wp.vec4ui(
        first[0] ^ ((first[0] ^ second[0]) & mask),
        first[1] ^ ((first[1] ^ second[1]) & mask),
        first[2] ^ ((first[2] ^ second[2]) & mask),
        first[3] ^ ((first[3] ^ second[3]) & mask),
    )


@wp.func
def two_points(words: wp.vec4ui) -> wp.vec4:
    """Two points of the square from four random words."""
    return wp.vec4(
        uniform_from_bits(words[0]), uniform_from_bits(words[1]), uniform_from_bits(words[2]), uniform_from_bits(words[3])
    )


@wp.func
def point_of_two(words: wp.vec4ui, sample: wp.uint32) -> wp.vec2:
    """The first of `two_points` for an even sample, else the second. By masks: a select would prevent vectorisation."""
    odd = ZERO_WORD - (sample & ONE_WORD)
    return wp.vec2(
        uniform_from_bits(words[0] ^ ((words[0] ^ words[2]) & odd)),
        uniform_from_bits(words[1] ^ ((words[1] ^ words[3]) & odd)),
    )
