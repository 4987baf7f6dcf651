"""Hash functions that turn a seed, a point id and a stream number into random 32-bit words.

A key is four random words for one surface point. One block of Philox mixes the seed with the upper 32 bits of the point's
id; the result is the same for all, or nearly all, points of a call. A finaliser mixes the lower 32 bits of the id, and pcg4d
mixes both results. So each bit of the seed and of the id changes about half of the bits of the key, at the cost of one hash
for each point and none for each sample. The varying word enters several arguments of pcg4d: if only one argument varies, the
lowest bits of the output are uneven, and badly so where a constant argument is divisible by a high power of 2.
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
# Fourth word of Philox's counter: 0 in the sequence `philox`, 1 for points on surfaces, 2 for keys, so that no two overlap.
_KEYS = wp.constant(wp.uint32(2))
_WORD = 2**32 - 1
ZERO_WORD: wp.uint32 = wp.constant(wp.uint32(0))
ONE_WORD: wp.uint32 = wp.constant(wp.uint32(1))


def seed_for(purpose: str, seed: int) -> int:
    """Derive a 64-bit seed for additional random numbers of a call, for example the rays of a trial run.

    The derived seed is a cryptographic hash of the purpose and the call's seed. No seed that a user is likely to choose
    gives the same numbers.
    """
    return int.from_bytes(blake2b(f"{purpose} {seed}".encode(), digest_size=8).digest(), "little")


@wp.func
def philox4x32_10(counter: wp.vec4ui, key_0: wp.uint32, key_1: wp.uint32) -> wp.vec4ui:
    """Return four random words by Philox4x32-10, a bijection of the 128-bit counter for each key.

    Salmon2011, section 4.4; the library Random123 has test vectors.
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
    """Return four random words by PCG4D, a bijection of 128 bits: different arguments never give the same four words.

    Jarzynski2020, listing 13. Arguments that differ in high bits alone, or in one word alone, give dependent results.
    Callers must mix the varying word first and pass the mixed word in at least two of the arguments.
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
def finalise(word: wp.uint32) -> wp.uint32:
    """Mix a 32-bit word with the finaliser of Appleby2016, so that each input bit changes about half of the output bits.

    The finaliser is a bijection.
    """
    word = (word ^ (word >> _SHIFT)) * _MURMUR_1
    word = (word ^ (word >> _MURMUR_SHIFT)) * _MURMUR_2
    return word ^ (word >> _SHIFT)


@wp.func
def run_key(seed: wp.uint64, high: wp.uint32) -> wp.vec4ui:
    """Return four random words from the seed and the upper 32 bits of a point id."""
    return philox4x32_10(wp.vec4ui(high, ZERO_WORD, ZERO_WORD, _KEYS), low_word(seed), high_word(seed))


@lru_cache(maxsize=1024)
def run_words(seed: int, high: int) -> tuple[int, int, int, int]:
    """Return the four random words of `run_key`, computed in Python instead of in a kernel.

    This saves kernels for directions a tenth of their time.
    """
    x = [high, 0, 0, 2]
    key = [seed & _WORD, seed >> 32]
    for _ in range(10):
        product_0, product_1 = 0xD2511F53 * x[0], 0xCD9E8D57 * x[2]
        x = [(product_1 >> 32) ^ x[1] ^ key[0], product_1 & _WORD, (product_0 >> 32) ^ x[3] ^ key[1], product_0 & _WORD]
        key = [(key[0] + 0x9E3779B9) & _WORD, (key[1] + 0xBB67AE85) & _WORD]
    return x[0], x[1], x[2], x[3]


@wp.func
def swap_halves(word: wp.uint32) -> wp.uint32:
    """Swap the upper and lower 16 bits of a 32-bit word."""
    return (word << _SHIFT) | (word >> _SHIFT)


@wp.func
def premixed_key(run: wp.vec4ui, low: wp.uint32) -> wp.vec4ui:
    """Return a cheap random key of a surface point: four words that must be hashed again for each sample.

    Word 0 differs between any two ids with the same upper half.
    """
    word = finalise(low ^ run[0])
    return wp.vec4ui(word, run[1] + swap_halves(word), run[2] + word, run[3])


@wp.func
def mixed_key(run: wp.vec4ui, low: wp.uint32) -> wp.vec4ui:
    """Return the random key of a surface point: four words with which a sequence scrambles or shifts its samples."""
    key = premixed_key(run, low)
    return pcg4d(key[0], key[1], key[2], key[3])


@wp.func
def point_key(seed: wp.uint64, point: wp.uint64) -> wp.vec4ui:
    """Return the key of a surface point, four random words, from the seed and the point's 64-bit id."""
    return mixed_key(run_key(seed, high_word(point)), low_word(point))


@wp.func
def stream_key(key: wp.vec4ui, stream: wp.uint32) -> wp.vec4ui:
    """Return the random key of an independent stream of random numbers, number `stream`, of a surface point.

    Keys of different streams are independent.
    """
    return mixed_key(key, stream)


@wp.func
def select_key(first: wp.vec4ui, second: wp.vec4ui, which: wp.int32) -> wp.vec4ui:
    """Return the first key if `which` is 0, the second key if `which` is 1.

    Bit masks are used because a select would prevent vectorisation.
    """
    mask = ZERO_WORD - wp.uint32(which)
    return wp.vec4ui(
        first[0] ^ ((first[0] ^ second[0]) & mask),
        first[1] ^ ((first[1] ^ second[1]) & mask),
        first[2] ^ ((first[2] ^ second[2]) & mask),
        first[3] ^ ((first[3] ^ second[3]) & mask),
    )


@wp.func
def points_from_words(words: wp.vec4ui) -> wp.vec4:
    """Convert four random words to two points (x0, y0, x1, y1) of the unit square."""
    return wp.vec4(
        uniform_from_bits(words[0]), uniform_from_bits(words[1]), uniform_from_bits(words[2]), uniform_from_bits(words[3])
    )


@wp.func
def point_from_words(words: wp.vec4ui, sample: wp.uint32) -> wp.vec2:
    """Convert two of four random words to a point of the unit square: words 0 and 1 for an even sample, else 2 and 3.

    Masks are used because a select would prevent vectorisation.
    """
    odd = ZERO_WORD - (sample & ONE_WORD)
    return wp.vec2(
        uniform_from_bits(words[0] ^ ((words[0] ^ words[2]) & odd)),
        uniform_from_bits(words[1] ^ ((words[1] ^ words[3]) & odd)),
    )
