"""pcg4d: four random words from four words, the hash behind the sequences here."""

import warp as wp

from warpsample.maths.numerics import high_word, low_word, uniform_from_bits

_MULTIPLIER = wp.constant(wp.uint32(1664525))
_INCREMENT = wp.constant(wp.uint32(1013904223))
_SHIFT = wp.constant(wp.uint32(16))
ZERO_WORD = wp.constant(wp.uint32(0))
ONE_WORD = wp.constant(wp.uint32(1))


@wp.func
def pcg4d(x: wp.uint32, y: wp.uint32, z: wp.uint32, w: wp.uint32) -> wp.vec4ui:
    """Four random words: a bijection of 128 bits, so different arguments never give the same four words.

    Jarzynski2020, listing 13.
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
def point_key(seed: wp.uint64, point: wp.uint64) -> wp.vec4ui:
    """Four random words for one point of one run, by which a sequence scrambles or shifts its points."""
    return pcg4d(low_word(point), high_word(point), low_word(seed), high_word(seed))


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
