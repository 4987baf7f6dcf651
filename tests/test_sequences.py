"""Sequences: known answers, exact structure, uniformity, and streams that no two points share."""

import subprocess
import sys
from itertools import islice

import numpy as np
import pytest
import warp as wp

import warpsample as ws
from warpsample.proof.laws import joint_p_value, uniform_p_value
from warpsample.proof.mixing import POINTS, dependence_p_value, grid_cells, judge_mixing
from warpsample.proof.streams import emitted_bytes, judge_sequence
from warpsample.proof.stress import judge_indices
from warpsample.sequences.hashing import philox4x32_10, run_key, run_words

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


@wp.kernel(enable_backward=False)
def _common(seed: wp.uint64, high: wp.uint32, out: wp.array[wp.vec4ui]):
    out[0] = run_key(seed, high)


def cells(u):
    """Return coordinates as exact integers on the 2^24 grid."""
    scaled = u.astype(np.float64) * GRID
    assert np.array_equal(scaled, np.floor(scaled))
    return scaled.astype(np.int64)


def test_philox_gives_its_published_answers():
    counters, keys, answers = (np.array(column, np.uint32) for column in zip(*KNOWN_ANSWERS, strict=True))
    out = wp.zeros(3, dtype=wp.vec4ui, device="cpu")
    inputs = [wp.array(counters, dtype=wp.vec4ui, device="cpu"), wp.array(keys, dtype=wp.vec2ui, device="cpu")]
    wp.launch(_philox, 3, inputs=inputs, outputs=[out], device="cpu")
    assert out.numpy().tolist() == answers.tolist()


@pytest.mark.parametrize(("seed", "high"), [(0, 0), (2**64 - 1, 2**32 - 1), (0x0123456789ABCDEF, 7)])
def test_the_words_of_a_run_are_the_same_on_the_host(seed, high):
    out = wp.zeros(1, dtype=wp.vec4ui, device="cpu")
    wp.launch(_common, 1, inputs=[seed, high], outputs=[out], device="cpu")
    assert tuple(out.numpy()[0]) == run_words(seed, high)


@pytest.mark.parametrize("name", [pytest.param(n, marks=() if n == "sobol" else pytest.mark.thorough) for n in NAMES])
def test_every_law_of_streams_holds(name):
    """The laws test each bit of seeds and ids, correlation, repeats, shared streams, a recorded hash, and exact integers."""
    found = [*judge_sequence(name, points=200_000), *judge_mixing(name), judge_indices(name)]
    assert len(found) >= 10
    assert [verdict for verdict in found if not verdict.passed] == []


def test_emitted_bytes_are_the_variates():
    first, second = (next(block) for block in [islice(emitted_bytes("philox"), k, None) for k in (0, 1)])
    for seed, block in ((0, first), (1, second)):
        u = cells(ws.sample_square("philox", 128, 128, seed=seed))
        u = (u if seed == 0 else u.swapaxes(0, 1)).reshape(-1)
        words = np.frombuffer(block, np.uint8).reshape(-1, 3).astype(np.int64)
        assert np.array_equal(words @ [1, 256, 65536], u)


def ids_of(words, seed):
    """Return the ids below 2^32 of points whose keys begin with these words, by the inverse of the finaliser."""
    words = words ^ words >> 16
    words = words * 0x7ED1B41D & 0xFFFFFFFF  # 1 / 0xC2B2AE35 modulo 2^32
    words = words ^ words >> 13 ^ words >> 26
    words = words * 0xA5CB9243 & 0xFFFFFFFF  # 1 / 0x85EBCA6B
    return words ^ words >> 16 ^ run_words(seed, 0)[0]


@pytest.mark.parametrize("name", ["independent", "philox"])
def test_a_sample_undoes_no_bit_of_a_point(name):
    # Where a key's second word met the sample's half number by an exclusive or: a bit of one undid a bit of the other.
    random, seed = np.random.default_rng(3), 123
    words, samples = random.integers(2**32, size=POINTS), random.integers(2**30, size=POINTS)
    counts, p_values = np.full(POINTS, 2**31 - 1), []
    own = grid_cells(name, seed, None, ids_of(words, seed), samples, counts).T
    for bit in range(31):
        others = ids_of(words ^ 1 << (bit + 16) % 32, seed), samples ^ 2 << bit & 0x7FFFFFFF
        p_values.append(dependence_p_value(own, grid_cells(name, seed, None, *others, counts).T))
    assert joint_p_value(*p_values) > 1e-6  # a right sampler fails by chance once in a million seeds; it was 0


@pytest.mark.slow
def test_emitted_stream_stops_with_its_reader(child_environment):
    """A reader such as `head` stops it; an unknown name gives a usage line."""
    command, pipe = [sys.executable, "-m", "warpsample.proof.streams"], subprocess.PIPE
    with subprocess.Popen([*command, "sobol"], stdout=pipe, stderr=pipe, env=child_environment) as child:
        head = child.stdout.read(30)
        child.stdout.close()
        assert "Traceback" not in child.stderr.read().decode()
    assert head == next(emitted_bytes("sobol"))[:30]
    wrong = subprocess.run([*command, "halton"], env=child_environment, capture_output=True, text=True, check=False)
    assert (wrong.returncode, wrong.stderr.split("|")[0]) == (1, "usage: python -m warpsample.proof.streams fibonacci")


@pytest.mark.parametrize("name", NAMES)
@pytest.mark.parametrize("count", [1, 7, 64])
def test_every_coordinate_is_uniform_over_points(name, count, plausible):
    """One sample from each of many points is uniform, so every average is unbiased."""
    u = ws.sample_square(name, 20_160, count, seed=3)
    point = np.arange(len(u))
    for axis in (0, 1):
        # Half a cell up, to the middle of what a grid value stands for.
        plausible(uniform_p_value(u[point, point % count, axis] + 0.5 / GRID))


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


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (("halton", 1, 1), "sequence: got 'halton', want one of fibonacci, independent, philox, r2, sobol, stratified"),
        (("sobol", 0, 1), "points: got 0, want a whole number of at least 1"),
        (("sobol", 1, -4), "count: got -4, want a whole number from 1 to 2147483647"),
        (("sobol", 1, 1, {"seed": -1}), "seed: got -1, want a whole number of 64 bits"),
        (("sobol", 1, 1, {"seed": 2**64}), "seed: got 18446744073709551616, want a whole number of 64 bits"),
        (
            ("sobol", 2, 1, {"first_point": 2**64 - 1}),
            "first_point: got 18446744073709551615, want an id of 64 bits with room for 2",
        ),
    ],
)
def test_bad_arguments_are_named(arguments, message):
    with pytest.raises(ValueError, match="^" + message.replace("^", r"\^")):
        ws.sample_square(*arguments[:3], **dict(*arguments[3:]))


def test_too_many_points_are_refused_with_a_way_out():
    with pytest.raises(
        MemoryError, match=r"points of the square need [\d.]+ GB and [\d.]+ GB are free; compute them in parts"
    ):
        ws.sample_square("sobol", 10**9, 10**6)
