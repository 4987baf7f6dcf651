"""Tests of random numbers: changing any bit of seed, point id, stream or sample number gives independent numbers.

Each pair of runs differs in one bit. A chi-square test compares one variate of each of 2^16 points between the two runs, on
16 x 16 cells. A second test counts the points at which each of the 24 bits of a variate changes, which should be half of all
points. The lowest bits of keys, and of samples far from each other, have separate tests, since no variate of one sample
shows these bits of keys.
"""

from collections.abc import Callable, Iterator
from functools import cache

import numpy as np
import warp as wp

from warpsample import sequences
from warpsample.host.kernel_cache import load
from warpsample.maths.numerics import high_word, low_word
from warpsample.proof.laws import joint_p_value
from warpsample.proof.verify import Verdict
from warpsample.sequences.hashing import point_key, seed_for, stream_key

Cells = Callable[..., np.ndarray]
"""Function (seed, first point, stream or None, sample) -> (2, POINTS) integers below 2^24, one variate per point."""

Pair = tuple[np.ndarray, np.ndarray]

POINTS = 1 << 16
"""Number of points in a run.

A shift by half of the range, with a correlation of -1/2, then gives a thousand times the signal needed.
"""

_SIDE, _BITS = 16, 24
_SEED, _BASE = 0x0123456789ABCDEF, 0xFEDCBA9876540000  # ordinary seed and point id; the id is a multiple of POINTS
_UNLIKELY = (6, 9492, 176047, 93987, 15790880)
"""Seeds for which a word shared by all points is divisible by 2^19 or more after a step of pcg4d, and an ordinary seed."""

_PURPOSES = ("trial", "ground", "sky", "sun", "faces")


@cache
def _variates_kernel(name: str) -> wp.Kernel:
    """Build a kernel that evaluates a sequence for given point ids, samples and counts.

    The kernel takes the points themselves, or one random stream of each point.
    """
    sequence = sequences.get(name)
    run_of, key_of, sample_of = sequence.run, sequence.key, sequence.sample

    @wp.kernel(module="unique", enable_backward=False)
    def one_variate(
        seed: wp.uint64,
        stream: wp.int64,
        point: wp.array[wp.uint64],
        sample: wp.array[wp.uint32],
        count: wp.array[wp.uint32],
        out: wp.array[wp.vec2],
    ):
        """Write the random numbers of one sample of one point, chosen by the thread's index."""
        i = wp.tid()
        key = key_of(run_of(seed, high_word(point[i])), low_word(point[i]))
        if stream >= wp.int64(0):
            key = stream_key(point_key(seed, point[i]), wp.uint32(stream))
        out[i] = sample_of(key, sample[i], count[i])

    load(one_variate, "cpu")
    return one_variate


def grid_cells(name: str, seed: int, stream: int | None, *asked: np.ndarray) -> np.ndarray:
    """Return (N, 2) random numbers of a sequence as integers below 2^24.

    `asked` holds three (N,) arrays: point ids, sample numbers and counts.
    """
    columns = [
        wp.array(a, dtype=kind, device="cpu") for a, kind in zip(asked, (wp.uint64, wp.uint32, wp.uint32), strict=True)
    ]
    out = wp.empty(len(asked[0]), dtype=wp.vec2, device="cpu")
    inputs = [seed, -1 if stream is None else stream, *columns]
    wp.launch(_variates_kernel(name), len(asked[0]), inputs=inputs, outputs=[out], device="cpu")
    return (out.numpy() * np.float32(2**_BITS)).astype(np.int64)


def cells_of(name: str) -> Cells:
    """Return a function that evaluates a sequence at many consecutive point ids."""

    def cells(seed: int, first: int, stream: int | None = None, sample: int = 0) -> np.ndarray:
        """Return one sample of each of many points, as integers below 2^24."""
        points = np.uint64(first) + np.arange(POINTS, dtype=np.uint64)
        samples = np.full(POINTS, sample, np.uint32)
        return grid_cells(name, seed, stream, points, samples, samples + np.uint32(1)).T

    return cells


def dependence_p_value(first: np.ndarray, second: np.ndarray) -> float:
    """Return the combined p-value of several tests of whether two arrays of random numbers are independent."""
    from scipy.special import chdtrc, erfc

    coarse = [cells >> (_BITS - 4) for cells in (first, second)]
    counts = np.array([np.bincount(a * _SIDE + b, minlength=_SIDE**2) for a in coarse[0] for b in coarse[1]])
    square = np.square(counts - POINTS / _SIDE**2).sum(axis=1) / (POINTS / _SIDE**2)
    flips = np.concatenate([_count_bits(cells >> shift & 255) for cells in first ^ second for shift in (0, 8, 16)])
    scores = np.abs(flips - POINTS / 2) / np.sqrt(POINTS / 4)
    p_values = np.concatenate([chdtrc(_SIDE**2 - 1, square), erfc(scores / np.sqrt(2.0))])
    return joint_p_value(*p_values.tolist())


def _count_bits(octets: np.ndarray) -> np.ndarray:
    """Count how often each of the eight bits is set in an array of integers below 256; return (8,)."""
    return np.bincount(octets, minlength=256) @ (np.arange(256)[:, None] >> np.arange(8) & 1)


def seed_pairs(cells: Cells) -> Iterator[Pair]:
    """Yield pairs of arrays of random numbers, with seeds that differ in one bit, are consecutive, or are random."""
    rng = np.random.default_rng(1)
    random = [tuple(map(int, rng.integers(2**64, size=2, dtype=np.uint64))) for _ in range(64)]
    for base in (0, _SEED):
        pairs = [(base, base ^ (1 << bit)) for bit in range(64)]
        for one, other in [*pairs, (base, base + 1), *(random if base else [])]:
            yield cells(one, base & ~(POINTS - 1)), cells(other, base & ~(POINTS - 1))


def point_pairs(cells: Cells) -> Iterator[Pair]:
    """Yield pairs of arrays of random numbers, for point ids that differ in one bit, are consecutive, or are random."""
    rng = np.random.default_rng(2)
    far = [(int(first) * POINTS, int(second) * POINTS) for first, second in rng.integers(2**48, size=(64, 2))]
    row = np.arange(POINTS)
    for base in (0, _BASE):
        own = cells(_SEED, base)
        yield from ((own, own[:, row ^ (1 << bit)]) for bit in range(16))
        yield from ((own, cells(_SEED, base ^ (1 << bit))) for bit in range(16, 64))
        yield own, np.roll(own, 1, axis=1)
    yield from ((cells(_SEED, one), cells(_SEED, other)) for one, other in far)


def stream_pairs(cells: Cells) -> Iterator[Pair]:
    """Yield pairs of arrays of random numbers with one seed that must be independent: different streams.

    The runs are two streams of a point, a stream and its point, or the seeds of two internal purposes.
    """
    own = cells(_SEED, 0)
    streams = [cells(_SEED, 0, stream) for stream in (0, *(1 << bit for bit in range(32)))]
    yield from ((streams[0], stream) for stream in streams[1:])
    yield from ((own, stream) for stream in streams)
    yield from ((streams[stream], np.roll(streams[1 - stream], 1, axis=1)) for stream in (0, 1))
    inner = [cells(seed_for(purpose, _SEED), 0) for purpose in _PURPOSES]
    yield from ((one, other) for k, one in enumerate([own, *inner]) for other in inner[k:])


def sample_pairs(cells: Cells) -> Iterator[Pair]:
    """Yield pairs of arrays of random numbers, for sample numbers that differ in one bit.

    The sequence must have independent samples.
    """
    for base in (0, 0x2468ACE1):
        own = cells(_SEED, 0, sample=base)
        yield from ((own, cells(_SEED, 0, sample=base ^ (1 << bit))) for bit in range(31))


@cache
def _keys_kernel() -> wp.Kernel:
    """Build a kernel that fills an array with the random keys, four words each, of points or of one point's streams."""

    @wp.kernel(module="unique", enable_backward=False)
    def words(seed: wp.uint64, streams: wp.bool, out: wp.array[wp.vec4ui]):
        """Write one random key to out[thread]: of point number `thread`, or of stream number `thread` of point 1."""
        thread = wp.tid()
        if streams:
            out[thread] = stream_key(point_key(seed, wp.uint64(1)), wp.uint32(thread))
        else:
            out[thread] = point_key(seed, wp.uint64(thread))

    return words


def keys_of(seed: int, streams: bool) -> np.ndarray:
    """Return the random keys of many points, or of many streams of one point: (N, 4) 32-bit words."""
    load(_keys_kernel(), "cpu")
    out = wp.empty(16 * POINTS, dtype=wp.vec4ui, device="cpu")
    wp.launch(_keys_kernel(), 16 * POINTS, inputs=[seed, streams], outputs=[out], device="cpu")
    return out.numpy()


def far_samples_of(name: str) -> np.ndarray:
    """Return pairs of consecutive samples of one point, 1,024 samples apart, as (N, 4) integers below 2^24."""
    first = 1024 * np.arange(16 * POINTS)
    ones, most = np.ones_like(first), np.full_like(first, 2**31 - 1)
    return np.hstack([grid_cells(name, _SEED, None, ones, sample, most) for sample in (first, first + 1)])


def low_bits_p_value(words: np.ndarray, bits: int) -> float:
    """Return the p-value of a chi-square test that all patterns of the lowest bits of (N, K) words are equally frequent.

    There are 2^(K bits) patterns.
    """
    from scipy.special import chdtrc

    patterns = (words.astype(np.int64) & ((1 << bits) - 1)) @ (1 << bits * np.arange(words.shape[1]))
    counts = np.bincount(patterns, minlength=2 ** (bits * words.shape[1]))
    expected = len(words) / len(counts)
    return float(chdtrc(len(counts) - 1, np.square(counts - expected).sum() / expected))


def judge_keys(name: str, keys: Callable[[int, bool], np.ndarray] = keys_of) -> Verdict:
    """Test whether the lowest bits of the random keys of points and streams are uniform; return the result.

    The seeds are ordinary ones and ones for which a weak hash fails.
    """
    drawn = [keys(seed, streams) for streams in (False, True) for seed in _UNLIKELY]
    p_values = [low_bits_p_value(words[:, triple], 4) for words in drawn for triple in ((0, 1, 2), (1, 2, 3))]
    return Verdict.from_p_value("low bits of keys", name, min(1.0, len(p_values) * min(p_values)), f"{len(p_values)} sets")


def judge_far_samples(name: str, samples: np.ndarray) -> Verdict:
    """Test whether the lowest bits of samples that are 1,024 apart are uniform; return the result.

    The sequence must have independent samples.
    """
    return Verdict.from_p_value("low bits of far samples", name, low_bits_p_value(samples, 3), f"{len(samples)} pairs")


_LAWS = {"bits of seeds": seed_pairs, "bits of ids": point_pairs, "streams and purposes": stream_pairs}
_OF_RANDOM = {"bits of samples": sample_pairs}


def judge_cells(name: str, cells: Cells, random: bool = True) -> list[Verdict]:
    """Test that changing one bit of seed, point id, stream or sample gives independent random numbers; return results.

    `random` states whether the samples of one point should be independent, too.
    """
    verdicts = []
    for law, pairs in (_LAWS | (_OF_RANDOM if random else {})).items():
        p_values = [dependence_p_value(*pair) for pair in pairs(cells)]
        verdicts.append(Verdict.from_p_value(law, name, joint_p_value(*p_values), f"{len(p_values)} pairs"))
    return verdicts


def judge_mixing(name: str) -> list[Verdict]:
    """Run all tests of this module on a sequence, and return the results."""
    random = sequences.get(name).random
    verdicts = [judge_keys(name), *judge_cells(name, cells_of(name), random)]
    return [*verdicts, judge_far_samples(name, far_samples_of(name))] if random else verdicts
