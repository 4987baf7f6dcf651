"""Second implementations of the sequences in exact integers and fractions, and recorded hashes of their values."""

from collections.abc import Sequence
from fractions import Fraction
from math import isqrt

_MASK = 2**32 - 1
_CELLS = 2**24


Key = tuple[int, int, int, int]


def expected(name: str, *, seed: int, point: int, sample: int, count: int, stream: int | None = None) -> tuple[int, int]:
    """Compute the exact coordinates of one sample of a sequence, as two integers in units of 2^-24.

    The sample belongs to a surface point, or to one of the point's random streams.
    """
    twin, own_key, _ = _TWINS[name]
    return twin(own_key(seed, point) if stream is None else _stream_key(seed, point, stream), sample, count)


def frozen_digest(name: str) -> str:
    """Return the recorded hash of a sequence's values, to compare with `streams.digest`."""
    return _TWINS[name][2]


def names() -> set[str]:
    """Return the names of the sequences that have a second implementation."""
    return set(_TWINS)


def pcg4d(x: int, y: int, z: int, w: int) -> Key:
    """Hash four 32-bit words with PCG4D (Jarzynski2020, listing 13)."""
    v = [(a * 1664525 + 1013904223) & _MASK for a in (x, y, z, w)]
    for turn in range(2):
        for k, (i, j) in enumerate([(1, 3), (2, 0), (0, 1), (1, 2)]):
            v[k] = (v[k] + v[i] * v[j]) & _MASK
        if turn == 0:
            v = [a ^ (a >> 16) for a in v]
    return v[0], v[1], v[2], v[3]


def philox4x32_10(counter: Sequence[int], key: Sequence[int]) -> list[int]:
    """Return four random words of the generator Philox4x32-10 (Salmon2011, table 2 and section 4.3)."""
    x, key = list(counter), list(key)
    for _ in range(10):
        high_0, low_0 = divmod(0xD2511F53 * x[0], 2**32)
        high_1, low_1 = divmod(0xCD9E8D57 * x[2], 2**32)
        x = [high_1 ^ x[1] ^ key[0], low_1, high_0 ^ x[3] ^ key[1], low_0]
        key = [(key[0] + 0x9E3779B9) & _MASK, (key[1] + 0xBB67AE85) & _MASK]
    return x


def _finalize(word: int) -> int:
    """Mix a 32-bit word with the finaliser fmix32 of Appleby2016."""
    for shift, factor in ((16, 0x85EBCA6B), (13, 0xC2B2AE35), (16, 1)):
        word = (word ^ (word >> shift)) * factor & _MASK
    return word


def _swap_halves(word: int) -> int:
    """Swap the two 16-bit halves of a 32-bit word."""
    return (word & 0xFFFF) << 16 | word >> 16


def _combine(run: Sequence[int], low: int) -> Key:
    """Hash four words of seed and upper point id with the lower 32 bits of the id, or with a stream number."""
    x, y, z, w = run
    x = _finalize(low ^ x)
    return x, (y + _swap_halves(x)) & _MASK, (z + x) & _MASK, w


def _premixed_words(seed: int, point: int) -> Key:
    """Return the partly mixed key of a surface point: four words that still need a hash."""
    return _combine(philox4x32_10([point >> 32, 0, 0, 2], [seed & _MASK, seed >> 32]), point & _MASK)


def _raw_words(seed: int, point: int) -> Key:
    """Return the key of a surface point for the sequence "philox": the 32-bit halves of the point's id and of the seed."""
    return point & _MASK, point >> 32, seed & _MASK, seed >> 32


def _key(seed: int, point: int) -> Key:
    """Return the key of a surface point: four random words from its id and the seed."""
    return pcg4d(*_premixed_words(seed, point))


def _stream_key(seed: int, point: int, stream: int) -> Key:
    """Return the random key of one independent stream of a surface point: four words."""
    return pcg4d(*_combine(_key(seed, point), stream))


def _variates_from_words(words: Sequence[int], sample: int) -> tuple[int, int]:
    """Return the two random numbers of a sample, from four random words that two consecutive samples share."""
    first = 2 * (sample & 1)
    return words[first] >> 8, words[first + 1] >> 8


def _independent(key: Key, sample: int, count: int) -> tuple[int, int]:
    """Return one sample of the sequence "independent", as two integers in units of 2^-24."""
    half = sample >> 1
    half = (half ^ half >> 16) * 0x85EBCA6B & _MASK
    half ^= half >> 13
    return _variates_from_words(pcg4d(key[1] ^ half, key[0], key[2], (key[3] + _swap_halves(half)) & _MASK), sample)


def _philox(key: Key, sample: int, count: int) -> tuple[int, int]:
    """Return one sample of the sequence "philox", as two integers in units of 2^-24."""
    return _variates_from_words(philox4x32_10([sample >> 1, key[0], key[1], 0], key[2:]), sample)


def _rotation(sample: int, step: int, key: int) -> int:
    """Return one coordinate of a lattice point, (sample * step + key) modulo 1, in units of 2^-24."""
    return (((sample * step % 2**64) >> 32) + key & _MASK) >> 8


def _r2(key: Key, sample: int, count: int) -> tuple[int, int]:
    """Return one sample of the sequence "r2", as two integers in units of 2^-24."""
    return _rotation(sample, 0xC13FA9A902A6328F, key[0]), _rotation(sample, 0x91E10DA5C79E7B1D, key[1])


def _fibonacci(key: Key, sample: int, count: int) -> tuple[int, int]:
    """Return one sample of the sequence "fibonacci", as two integers in units of 2^-24."""
    along = (sample + Fraction(key[0], 2**32)) / count * _CELLS
    return min(int(along), _CELLS - 1), _rotation(sample, 0x9E3779B97F4A7C15, key[1])


def _reverse_bits(x: int) -> int:
    """Reverse the order of the bits of a 32-bit word."""
    return int(f"{x:032b}"[::-1], 2)


def _owen(x: int, key: int) -> int:
    """Scramble a bit-reversed word by the hash of Vegdahl2021 (nested uniform scrambling)."""
    x ^= x * 0x3D20ADEA & _MASK
    x = (x + key) * ((key >> 16) | 1) & _MASK
    x ^= x * 0x05526C56 & _MASK
    return x ^ (x * 0x53A22864 & _MASK)


def _sobol(key: Key, sample: int, count: int) -> tuple[int, int]:
    """Return one sample of the sequence "sobol", as two integers in units of 2^-24.

    In the second dimension each direction number is v ^ (v >> 1) of the previous one, starting from 1/2.
    """
    index = _reverse_bits(_owen(_reverse_bits(sample), key[0]))
    second, direction = 0, 1 << 31
    for bit in range(32):
        second ^= direction if index >> bit & 1 else 0
        direction ^= direction >> 1
    return _reverse_bits(_owen(index, key[1])) >> 8, _reverse_bits(_owen(_reverse_bits(second), key[2])) >> 8


def _stratified(key: Key, sample: int, count: int) -> tuple[int, int]:
    """Return one sample of the sequence "stratified", as two integers in units of 2^-24."""
    rows = isqrt(count)
    short, long_rows = divmod(count, rows)
    in_long = long_rows * (short + 1)
    skipped, length = (0, short + 1) if sample < in_long else (long_rows, short)
    row, column = divmod(sample - skipped, length)
    jitter = [Fraction(cells, _CELLS) for cells in _independent(key, sample, count)]
    u = (skipped + (row + jitter[0]) * length) / count, (column + jitter[1]) / length
    return min(int(u[0] * _CELLS), _CELLS - 1), min(int(u[1] * _CELLS), _CELLS - 1)


# A changed stream changes every result that users have stored, so a change must be intentional.
_TWINS = {
    "fibonacci": (_fibonacci, _key, "9b6a304645396704"),
    "independent": (_independent, _premixed_words, "3f50d8566dcc3184"),
    "philox": (_philox, _raw_words, "d0a7cbe4f6926d5d"),
    "r2": (_r2, _key, "1ef78d50553aa7c2"),
    "sobol": (_sobol, _key, "2c778d1aeb322b6f"),
    "stratified": (_stratified, _premixed_words, "a0bc03828ed04ed8"),
}
