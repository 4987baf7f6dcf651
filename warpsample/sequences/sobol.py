"""Owen-scrambled Sobol' sequence: a (0, m, 2)-net at every power of two, with a new scramble at every surface point."""

import warp as wp

from warpsample.maths.numerics import EVEN_BITS, EVEN_BYTES, EVEN_NIBBLES, EVEN_PAIRS, reverse_bits, uniform_from_bits
from warpsample.sequences.hashing import ONE_WORD, point_key
from warpsample.sequences.record import Sequence

_HASH_1 = wp.constant(wp.uint32(0x3D20ADEA))
_HASH_2 = wp.constant(wp.uint32(0x05526C56))
_HASH_3 = wp.constant(wp.uint32(0x53A22864))


@wp.func
def laine_karras(x: wp.uint32, key: wp.uint32) -> wp.uint32:
    """Scramble a bit-reversed coordinate x by Owen's nested uniform scrambling.

    A hash of all lower bits decides whether a bit flips.

    The hash is that of Vegdahl2021, which improves on Laine2011.
    """
    x = x ^ (x * _HASH_1)
    x = x + key
    x = x * ((key >> wp.uint32(16)) | wp.uint32(1))
    x = x ^ (x * _HASH_2)
    return x ^ (x * _HASH_3)


@wp.func
def sobol_second(index: wp.uint32) -> wp.uint32:
    """Return the second coordinate, bit-reversed, of the Sobol' point with an index.

    The bits are multiplied by Pascal's triangle modulo 2, in five steps.
    """
    x = index
    x = x ^ ((x >> wp.uint32(1)) & EVEN_BITS)
    x = x ^ ((x >> wp.uint32(2)) & EVEN_PAIRS)
    x = x ^ ((x >> wp.uint32(4)) & EVEN_NIBBLES)
    x = x ^ ((x >> wp.uint32(8)) & EVEN_BYTES)
    return x ^ (x >> wp.uint32(16))


@wp.func
def _scramble(index: wp.uint32, second: wp.uint32, key: wp.vec4ui) -> wp.vec2:
    """Scramble a Sobol' point, given by bit-reversed coordinates, with the key; return the point of the unit square."""
    x = laine_karras(index, key[1])
    y = laine_karras(second, key[2])
    return wp.vec2(uniform_from_bits(reverse_bits(x)), uniform_from_bits(reverse_bits(y)))


@wp.func
def sobol_sample(key: wp.vec4ui, sample: wp.uint32, count: wp.uint32) -> wp.vec2:
    """Return point number `sample` of the Sobol' sequence, shuffled and scrambled with the key of the surface point.

    The index itself is the bit-reversed first coordinate, the input that the scramble needs. The shuffle makes samples of
    equal number independent between two seeds.
    """
    index = reverse_bits(laine_karras(reverse_bits(sample), key[0]))
    return _scramble(index, sobol_second(index), key)


@wp.func
def sobol_pair(key: wp.vec4ui, half: wp.uint32, count: wp.uint32) -> wp.vec4:
    """Return two scrambled Sobol' points, (x0, y0, x1, y1): samples 2 * half and 2 * half + 1, with a single shuffle.

    The two bit-reversed indices differ only in the top bit, on which no other bit of the scramble depends. So the two
    shuffled indices differ only in the last bit, and so do the two second coordinates.
    """
    index = reverse_bits(laine_karras(reverse_bits(half + half), key[0]))
    second = sobol_second(index)
    p = _scramble(index, second, key)
    q = _scramble(index ^ ONE_WORD, second ^ ONE_WORD, key)
    return wp.vec4(p[0], p[1], q[0], q[1])


@wp.func
def sobol(seed: wp.uint64, point: wp.uint64, sample: wp.uint32, count: wp.uint32) -> wp.vec2:
    """Return point number `sample` of the Sobol' sequence, shuffled and Owen-scrambled at random at each surface point."""
    return sobol_sample(point_key(seed, point), sample, count)


RECORD = Sequence(
    name="sobol",
    sample=sobol_sample,
    progressive=True,
    nets=True,
    colour="#2f6690",
    marker="o",
    summary="Owen-scrambled Sobol', the best for smooth integrands",
    pair=sobol_pair,
    source="Burley2020; the hash: Vegdahl2021",
)
