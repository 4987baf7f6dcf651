"""Sequences: known answers, exact structure, uniformity, and streams that never meet."""

import hashlib

import numpy as np
import pytest
import warp as wp
from twins import pcg4d

import warpsample as ws
from warpsample.proof.laws import uniform_p_value
from warpsample.sequences.philox import philox4x32_10

NAMES = ws.sequences.names()
GRID = 2**24

# Random123 1.14, tests/kat_vectors, "philox4x32 10": counter, key, output.
KNOWN_ANSWERS = [
    ([0] * 4, [0] * 2, [0x6627E8D5, 0xE169C58D, 0xBC57AC4C, 0x9B00DBD8]),
    ([0xFFFFFFFF] * 4, [0xFFFFFFFF] * 2, [0x408F276D, 0x41C83B0E, 0xA20BC7C6, 0x6D5451FD]),
    (
        [0x243F6A88, 0x85A308D3, 0x13198A2E, 0x03707344],
        [0xA4093822, 0x299F31D0],
        [0xD16CFE09, 0x94FDCCEB, 0x5001E420, 0x24126EA1],
    ),
]


@wp.kernel(enable_backward=False)
def _philox(counter: wp.array[wp.vec4ui], key: wp.array[wp.vec2ui], out: wp.array[wp.vec4ui]):
    i = wp.tid()
    out[i] = philox4x32_10(counter[i], key[i][0], key[i][1])


def cells(u):
    """Coordinates as exact integers on the 2^24 grid."""
    scaled = u.astype(np.float64) * GRID
    assert np.array_equal(scaled, np.floor(scaled))
    return scaled.astype(np.int64)


def test_philox_gives_its_published_answers():
    counters, keys, answers = (np.array(column, np.uint32) for column in zip(*KNOWN_ANSWERS, strict=True))
    out = wp.zeros(3, dtype=wp.vec4ui, device="cpu")
    inputs = [wp.array(counters, dtype=wp.vec4ui, device="cpu"), wp.array(keys, dtype=wp.vec2ui, device="cpu")]
    wp.launch(_philox, 3, inputs=inputs, outputs=[out], device="cpu")
    assert out.numpy().tolist() == answers.tolist()


def test_independent_is_pcg4d_of_sample_point_and_seed():
    u = ws.sample_square("independent", 3, 5, seed=(7 << 32) | 9, first_point=2**32 - 2)
    point = np.arange(2**32 - 2, 2**32 + 1)[:, None]
    far = (point >> 32).astype(np.uint32)
    words = pcg4d(
        np.arange(5)[None],
        point & 0xFFFFFFFF,
        np.uint32(9) + far * np.uint32(0x9E3779B9),
        np.uint32(7) ^ (far * np.uint32(0x85EBCA6B)),
    )
    assert np.array_equal(cells(u)[..., 0], words[0] >> 8)
    assert np.array_equal(cells(u)[..., 1], words[1] >> 8)


@pytest.mark.parametrize("name", NAMES)
def test_stream_is_frozen(name):
    """A change of the stream changes every result anyone has stored: it must be meant."""
    u = ws.sample_square(name, 257, 67, seed=12345, first_point=2**33 - 100)
    assert hashlib.sha256(cells(u).tobytes()).hexdigest()[:16] == FROZEN[name]


FROZEN = {
    "fibonacci": "152cf731deb08c76",
    "independent": "253d196e104cc34d",
    "philox": "000027d475b38e9f",
    "r2": "fedda182c7cb5b06",
    "sobol": "d327ca05417a79a5",
    "stratified": "c66abff138fafcd8",
}


@pytest.mark.parametrize("name", NAMES)
@pytest.mark.parametrize("count", [1, 7, 64])
def test_every_coordinate_is_uniform_over_points(name, count, plausible):
    """Whatever the samples of one point share, one from each of many points are uniform: every average is unbiased."""
    u = ws.sample_square(name, 20_160, count, seed=3)
    point = np.arange(len(u))
    for axis in (0, 1):
        # Half a cell up, to the middle of what a grid value stands for.
        plausible(uniform_p_value(u[point, point % count, axis] + 0.5 / GRID))


@pytest.mark.parametrize("name", NAMES)
def test_coordinates_and_neighbours_are_uncorrelated(name, plausible):
    from scipy.stats import norm

    u = ws.sample_square(name, 100_000, 4, seed=4)[:, 1].astype(np.float64) - 0.5
    other = ws.sample_square(name, 100_000, 4, seed=5)[:, 1].astype(np.float64) - 0.5
    for a, b in [
        (u[:, 0], u[:, 1]),
        (u[1:, 0], u[:-1, 0]),
        (u[1:, 0], u[:-1, 1]),
        (u[:, 0], other[:, 0]),
        (u[:, 1], other[:, 1]),
    ]:
        plausible(2.0 * norm.sf(abs(np.corrcoef(a, b)[0, 1]) * np.sqrt(len(a))))


@pytest.mark.parametrize("log_count", [1, 4, 6, 9])
def test_sobol_fills_every_elementary_interval_once(log_count):
    """A (0, m, 2)-net: each of the 2^m boxes of each shape 2^-k x 2^(k-m) holds one of 2^m points."""
    u = ws.sample_square("sobol", 8, 2**log_count, seed=6)
    for k in range(log_count + 1):
        box = (u[..., 0] * 2**k).astype(int) * 2 ** (log_count - k) + (u[..., 1] * 2 ** (log_count - k)).astype(int)
        assert np.array_equal(np.sort(box, axis=1), np.broadcast_to(np.arange(2**log_count), box.shape))


def test_sobol_pairs_of_two_seeds_are_not_locked_together():
    """Without the shuffled index the first bits of equal samples of two calls would agree always or never."""
    first, second = (ws.sample_square("sobol", 2000, 16, seed=s)[..., 0] < 0.5 for s in (1, 2))
    agree = (first == second).sum(axis=1)
    assert len(np.unique(agree)) > 3


@pytest.mark.parametrize("count", [1, 2, 3, 5, 12, 64, 101])
def test_stratified_has_one_point_in_each_cell(count):
    u = ws.sample_square("stratified", 50, count, seed=7).astype(np.float64)
    rows = int(np.sqrt(count))
    lengths = [count // rows + (row < count % rows) for row in range(rows)]
    start = 0
    for length in lengths:
        inside = u[:, start : start + length]
        # A cell's border may lie between two grid values.
        assert (inside[..., 0] >= start / count - 2.0**-24).all()
        assert (inside[..., 0] <= (start + length) / count).all()
        columns = np.arange(length) / length
        assert (inside[..., 1] >= columns - 2.0**-24).all()
        assert (inside[..., 1] <= columns + 1.0 / length).all()
        start += length


@pytest.mark.parametrize("count", [1, 10, 1000, 2**20])
def test_fibonacci_lattice_is_exact(count):
    u = cells(ws.sample_square("fibonacci", 1, count, seed=8)[0])
    assert np.array_equal(u[:, 0] * count // GRID, np.arange(count) if count < GRID else u[:, 0])
    turn = [(i * 0x9E3779B97F4A7C15 % 2**64) / 2**64 for i in range(0, count, max(1, count // 1000))]
    rotation = (u[:: max(1, count // 1000), 1] - u[0, 1]) / GRID - np.array(turn)
    assert np.abs(rotation - np.round(rotation)).max() <= 2.0**-24


def test_r2_is_exact_at_a_million():
    u = cells(ws.sample_square("r2", 1, 10**6 + 1, seed=9)[0])
    g = 1.32471795724474602596
    for axis, step in ((0, 1 / g), (1, 1 / g**2)):
        shift = (u[-1, axis] - u[0, axis]) / GRID - 10**6 * step
        assert abs(shift - round(shift)) <= 2.0**-24 + 1e-9  # the grid, and float64's own error of 10^6 / g


@pytest.mark.parametrize("name", NAMES)
def test_progressive_sequences_extend_and_the_others_say_so(name):
    short, long = (ws.sample_square(name, 40, count, seed=10) for count in (16, 64))
    assert np.array_equal(short, long[:, :16]) == ws.sequences.get(name).progressive


@pytest.mark.parametrize("name", NAMES)
def test_no_two_points_or_seeds_share_a_stream(name):
    """Two pairs of coordinates, 96 bits: any repeat among 4 x 10^5 streams would be a defect."""
    streams = [ws.sample_square(name, 200_000, 2, seed=seed).reshape(-1, 4) for seed in (0, 1)]
    rows = np.concatenate(streams).view(np.dtype((np.void, 16))).ravel()
    assert len(np.unique(rows)) == len(rows)


@pytest.mark.parametrize("name", NAMES)
@pytest.mark.parametrize("first", [2**24 - 1, 2**31 - 1, 2**32 - 1, 2**40, 2**64 - 3])
def test_point_ids_are_64_bits_wide(name, first):
    u = ws.sample_square(name, 3, 4, seed=11, first_point=first)
    assert len(np.unique(u[:, 0, 1])) == 3
    for row in range(3):
        assert np.array_equal(u[row], ws.sample_square(name, 1, 4, seed=11, first_point=first + row)[0])
    assert (
        not np.array_equal(u[-1], ws.sample_square(name, 1, 4, seed=11, first_point=(first + 2) % 2**32)[0]) or first < 2**32
    )


def test_seeds_are_64_bits_wide():
    assert not np.array_equal(ws.sample_square("philox", 1, 4, seed=1), ws.sample_square("philox", 1, 4, seed=1 + 2**32))
    assert ws.sample_square("sobol", 1, 1, seed=2**64 - 1).shape == (1, 1, 2)


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (("halton", 1, 1), "sequence: got 'halton', want one of fibonacci, independent, philox, r2, sobol, stratified"),
        (("sobol", 0, 1), "points: got 0, want a whole number of at least 1"),
        (("sobol", 1, -4), "count: got -4, want a whole number from 1 to 2147483647"),
        (("sobol", 1, 1, -1), "seed: got -1, want a whole number of 64 bits"),
        (("sobol", 1, 1, 2**64), "seed: got 18446744073709551616, want a whole number of 64 bits"),
        (("sobol", 2, 1, 0, 2**64 - 1), "first_point: got 18446744073709551615, want an id of 64 bits with room for 2"),
    ],
)
def test_bad_arguments_are_named(arguments, message):
    with pytest.raises(ValueError, match="^" + message.replace("^", r"\^")):
        ws.sample_square(*arguments)


def test_too_many_points_are_refused_with_a_way_out():
    with pytest.raises(MemoryError, match=r"points of the square need [\d.]+ GB and [\d.]+ GB are free; take them in parts"):
        ws.sample_square("sobol", 10**9, 10**6)
