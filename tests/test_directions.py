"""sample_directions: the same bits however it is run, correct about any normal, and clear errors for bad input."""

from itertools import pairwise

import numpy as np
import pytest
import warp as wp

import warpsample as ws
from warpsample.directions import sample as module
from warpsample.proof import laws, twins
from warpsample.proof.twins.sequences import pcg4d

COSINES = ws.CosineHemisphere.cases()
# The ways through the kernels: a map in a frame, one without a frame and with a rim drawn anew, one with parameters.
CASES = [ws.CosineHemisphere("polar"), ws.CosineHemisphere("offset"), ws.VisibleGGX(0.3, (0.6, -0.64, 0.48))]
EACH = pytest.mark.parametrize("distribution", CASES, ids=repr)
# One sample; short rows in flat blocks; full vectors; rows with a remainder; more than one part of a row.
COUNTS = [1, 3, 16, 23, 64, 100]


def unit(normals):
    n = normals.astype(np.float64)
    return n / np.linalg.norm(n, axis=-1, keepdims=True)


@EACH
@pytest.mark.parametrize("count", COUNTS)
def test_same_bits_in_chunks_threads_offsets_and_with_half_inactive(distribution, count, monkeypatch):
    normals = np.random.default_rng(3).normal(size=(9001, 3)).astype(np.float32)
    whole = ws.sample_directions(normals, count, distribution, seed=5, first_point=2**32 - 4000, pdf=True, workers=1)
    monkeypatch.setattr("warpsample.host.engine._LEAST_WORK", 1)
    monkeypatch.setattr("warpsample.host.engine._FEW_CHUNKS", 7)
    monkeypatch.setattr("warpsample.host.engine._MANY_CHUNKS", 7)
    for workers in (2, 3):
        threaded = ws.sample_directions(
            normals, count, distribution, seed=5, first_point=2**32 - 4000, pdf=True, workers=workers
        )
        assert np.array_equal(whole.vectors, threaded.vectors)
    cuts = [0, 1, 257, 1500, 4000, 4001, 8000, 9001]
    for start, end in pairwise(cuts):
        part = ws.sample_directions(
            normals[start:end], count, distribution, seed=5, first_point=2**32 - 4000 + start, pdf=True
        )
        assert np.array_equal(whole.vectors[start:end], part.vectors)
    active = np.arange(len(normals)) % 2 == 0
    half = ws.sample_directions(
        normals, count, distribution, seed=5, first_point=2**32 - 4000, pdf=True, active=active, workers=2
    )
    assert np.array_equal(whole.vectors[active], half.vectors[active])
    assert np.array_equal(whole.pdf[active], half.pdf[active])
    assert not half.vectors[~active].any()
    assert not half.pdf[~active].any()
    assert half.counts() == {ws.Status.OK: 4501, ws.Status.INACTIVE: 4500}


@pytest.mark.parametrize(
    ("first", "points", "rows"),
    [
        (0, 5, [(0, 5)]),
        (2**32 - 3, 5, [(0, 3), (3, 5)]),
        (2**32, 5, [(0, 5)]),
        (7 * 2**32 - 5, 5, [(0, 5)]),
        (2**40 + 1, 2**33, [(0, 2**32 - 1), (2**32 - 1, 2**33 - 1), (2**33 - 1, 2**33)]),
    ],
)
def test_jobs_do_not_cross_a_high_word(first, points, rows):
    assert module._same_high_word(first, points) == rows


@pytest.mark.parametrize(
    "sequence",
    [
        "sobol",
        "fibonacci",
        *(pytest.param(n, marks=pytest.mark.slow) for n in ("independent", "philox", "r2", "stratified")),
    ],
)
def test_flat_blocks_and_rows_agree_bit_for_bit(sequence, normals, monkeypatch):
    for distribution in (ws.CosineHemisphere("polar"), ws.CosineHemisphere("offset"))[: 2 if sequence == "sobol" else 1]:
        for count in (1, 2, 23):
            monkeypatch.setattr(module, "_ROW", 100)
            blocks = ws.sample_directions(normals, count, distribution, sequence, pdf=True)
            monkeypatch.setattr(module, "_ROW", 1)
            monkeypatch.setattr(module, "_PART", 6)
            rows = ws.sample_directions(normals, count, distribution, sequence, pdf=True)
            monkeypatch.undo()
            assert np.array_equal(blocks.vectors, rows.vectors)
            assert np.array_equal(blocks.pdf, rows.pdf)


def test_offset_is_sphere_plus_normal_with_its_rim_redrawn():
    normals = np.random.default_rng(5).normal(size=(40_000, 3)).astype(np.float32)
    n = unit(normals)
    u = ws.sample_square("independent", len(n), 64, seed=7)
    total = n[:, None] + twins.directions(ws.UniformSphere(), u.astype(np.float64))
    length = np.linalg.norm(total, axis=-1)
    got = ws.sample_directions(normals, 64, ws.CosineHemisphere("offset"), "independent", seed=7, pdf=True)
    clear = length > 2.0**-6 * 1.001
    # n and s are each 1e-7 off and their sum at least 2^-6 long.
    assert laws.angle_error(got.vectors[clear], total[clear] / length[clear, None]) <= 1.3e-5
    assert np.abs(got.pdf[clear] / (length[clear] / (2 * np.pi)) - 1.0).max() <= 2e-5
    rim = length < 2.0**-6 * 0.999
    assert 80 <= rim.sum() <= 250  # 156 expected
    k = (u[rim].astype(np.float64) * 2**24).astype(int).tolist()
    fresh, turns = (np.array([pcg4d(*pair, 0, 0)[:2] for pair in k]) >> 9).T / 2**23
    redrawn = twins.spherical(np.arccos(2.0**-7 * np.sqrt(fresh + 2.0**-24)), turns)
    exact = np.einsum("nij,nj->ni", twins.frames(n)[np.nonzero(rim)[0]], redrawn)
    assert laws.angle_error(got.vectors[rim], exact) <= 5e-7


@pytest.mark.parametrize("distribution", COSINES, ids=repr)
def test_mean_cosine_of_ten_million_directions_about_random_normals(distribution):
    normals = np.random.default_rng(6).normal(size=(160_000, 3)).astype(np.float32)
    got = ws.sample_directions(normals, 64, distribution, "independent", seed=8)
    cosine = np.einsum("psk,pk->ps", got.vectors, unit(normals))
    assert cosine.size >= 10**7
    assert abs(cosine.mean(dtype=np.float64) - 2.0 / 3.0) <= 4.0 * np.sqrt(1.0 / 18.0 / cosine.size)  # standard errors
    assert cosine.min() > 0.0


def test_rim_of_the_offset_method_is_neither_cut_nor_crowded(plausible):
    normals = np.random.default_rng(7).normal(size=(320_000, 3)).astype(np.float32)
    got = ws.sample_directions(normals, 64, ws.CosineHemisphere("offset"), "independent", seed=9)
    cosine = np.einsum("psk,pk->ps", got.vectors, unit(normals))
    for limit in (0.002, 0.005, 2.0**-7, 0.01):  # inside the rim, across it, outside
        plausible(laws.count_p_value((cosine < limit).sum(), cosine.size, limit**2))


@pytest.mark.parametrize("count", [1, 5, 64])
@pytest.mark.parametrize("distribution", [ws.CosineHemisphere("polar"), ws.CosineHemisphere("offset")], ids=repr)
def test_bad_normals_get_zero_vectors_a_status_and_a_count(distribution, count, normals):
    normals[3] = 0.0
    normals[4] = (np.nan, 0, 1)
    normals[500] = (0, np.inf, 0)
    normals[999] = -0.0
    got = ws.sample_directions(normals, count, distribution, pdf=True)
    assert got.counts() == {ws.Status.OK: 996, ws.Status.ZERO_NORMAL: 2, ws.Status.NONFINITE_NORMAL: 2}
    assert got.status[[3, 4, 500, 999]].tolist() == [2, 3, 3, 2]
    assert np.array_equal(got.vectors[got.status > 0], np.zeros((4, count, 3)))
    assert np.array_equal(got.pdf[got.status > 0], np.zeros((4, count)))
    assert (got.pdf[got.status == 0] > 0).all()


def test_a_wrong_normal_does_not_change_its_neighbours(normals):
    right = ws.sample_directions(normals, 3)
    normals[10] = 0.0
    spoiled = ws.sample_directions(normals, 3)
    rest = np.arange(len(normals)) != 10
    assert np.array_equal(right.vectors[rest], spoiled.vectors[rest])


def test_out_is_written_and_returned(normals):
    out = np.full((1000, 8, 3), np.nan, np.float32)
    got = ws.sample_directions(normals, 8, out=out)
    assert got.vectors is out
    assert np.array_equal(out, ws.sample_directions(normals, 8).vectors)
    assert got.pdf is None


def test_kinds_in_are_kinds_out(normals):
    expected = ws.sample_directions(normals, 8, pdf=True)
    assert isinstance(expected.vectors, np.ndarray)
    for given in (wp.array(normals, dtype=wp.vec3, device="cpu"), wp.array(normals, dtype=wp.float32, device="cpu")):
        out = wp.zeros((1000, 8), dtype=wp.vec3, device="cpu")
        got = ws.sample_directions(given, 8, pdf=True, out=out, active=wp.ones(1000, dtype=wp.uint8, device="cpu"))
        assert got.vectors is out
        assert [type(a) for a in (got.pdf, got.status)] == [wp.array] * 2
        assert np.array_equal(got.vectors.numpy(), expected.vectors)
        assert np.array_equal(got.pdf.numpy(), expected.pdf)
        assert got.counts() == expected.counts()
    points = ws.SurfacePoints(np.zeros((1000, 3)), normals)
    assert np.array_equal(ws.sample_directions(points, 8).vectors, expected.vectors)
    assert np.array_equal(ws.sample_directions(normals.astype(np.float64), 8).vectors, expected.vectors)
    strided = np.repeat(normals, 2, axis=0)[::2]
    assert np.array_equal(ws.sample_directions(strided, 8).vectors, expected.vectors)
    assert np.array_equal(ws.sample_directions(normals.tolist(), 8).vectors, expected.vectors)


def test_defaults_are_a_polar_cosine_lobe_from_sobol(normals):
    named = ws.sample_directions(normals, 16, "cosine_hemisphere", "sobol", 0, 0)
    assert np.array_equal(ws.sample_directions(normals, 16).vectors, named.vectors)
    assert np.array_equal(ws.sample_directions(normals, 16, ws.CosineHemisphere("polar")).vectors, named.vectors)


@pytest.mark.skipif(not wp.is_cuda_available(), reason="no CUDA device")
@EACH
@pytest.mark.parametrize("count", [1, 23, 64])
def test_cuda_agrees_with_the_cpu(distribution, count, normals, monkeypatch):
    normals[3] = 0.0
    monkeypatch.setattr(module, "_UPLOAD", 100_000)
    here, there = (ws.sample_directions(normals, count, distribution, pdf=True, device=d) for d in ("cpu", "cuda"))
    assert isinstance(there.vectors, np.ndarray)
    assert np.abs(here.vectors - there.vectors).max() <= 3e-5  # the offset rim loses digits
    assert np.array_equal(here.status, there.status)


GOOD = np.ones((4, 3), np.float32)
READ_ONLY = np.zeros((4, 2, 3), np.float32)
READ_ONLY.setflags(write=False)


@pytest.mark.parametrize(
    ("normals", "arguments", "error", "message"),
    [
        (
            np.empty((0, 3), np.float32),
            {},
            ValueError,
            r"normals: got shape \(0, 3\), want \(P, 3\) with P of at least 1",
        ),
        (np.ones((4, 2), np.float32), {}, ValueError, r"normals: got shape \(4, 2\), want \(P, 3\)"),
        (np.ones(3, np.float32), {}, ValueError, r"normals: got shape \(3,\), want \(P, 3\) with P"),
        (np.ones((2, 2, 3), np.float32), {}, ValueError, r"normals: got shape \(2, 2, 3\), want \(P, 3\) with P"),
        (np.ones((4, 3), int), {}, TypeError, "normals: got dtype int64, want float32"),
        (np.ones((4, 3), complex), {}, TypeError, "normals: got dtype complex128"),
        ("bunny", {}, TypeError, "normals: got dtype <U5"),
        (None, {}, TypeError, "normals: got dtype object"),
        (GOOD, {"count": 0}, ValueError, "count: got 0, want a whole number from 1"),
        (GOOD, {"count": -1}, ValueError, "count: got -1"),
        (GOOD, {"count": 2**31}, ValueError, "count: got 2147483648"),
        (GOOD, {"count": 2.5}, TypeError, "count: got 2.5, want a whole number"),
        (GOOD, {"count": True}, TypeError, "count: got True"),
        (GOOD, {"seed": -1}, ValueError, "seed: got -1, want a whole number of 64 bits"),
        (GOOD, {"seed": 2**64}, ValueError, "seed: got 18446744073709551616"),
        (
            GOOD,
            {"first_point": 2**64 - 3},
            ValueError,
            "first_point: got 18446744073709551613, want an id of 64 bits with",
        ),
        (GOOD, {"sequence": "halton"}, ValueError, "sequence: got 'halton', want one of fibonacci, independent"),
        (
            GOOD,
            {"distribution": "lambert"},
            ValueError,
            "distribution: got 'lambert', want one of beckmann",
        ),
        (GOOD, {"workers": 0}, ValueError, "workers: got 0, want a whole number from 1"),
        (GOOD, {"workers": 1.5}, TypeError, "workers: got 1.5"),
        (GOOD, {"active": np.ones(3, bool)}, ValueError, r"active: got shape \(3,\), want \(4,\)"),
        (GOOD, {"active": np.ones(4)}, TypeError, "active: got dtype float64, want bool"),
        (GOOD, {"out": np.zeros((4, 2, 3))}, TypeError, "out: got dtype float64, want a C-contiguous"),
        (
            GOOD,
            {"out": np.zeros((4, 3, 3), np.float32)},
            ValueError,
            r"out: got shape \(4, 3, 3\), want .* \(4, 2, 3\)",
        ),
        (
            GOOD,
            {"out": np.zeros((2, 4, 3), np.float32).swapaxes(0, 1)},
            ValueError,
            "out: got an array that is not C-cont",
        ),
        (GOOD, {"out": READ_ONLY}, ValueError, "out: got an array that is read-only"),
        (GOOD, {"out": [0.0]}, TypeError, "out: got list, want ndarray"),
        (GOOD, {"device": "tpu"}, ValueError, "device: got 'tpu', want one of cpu"),
    ],
)
def test_bad_input_is_named_before_any_work(normals, arguments, error, message):
    with pytest.raises(error, match="^" + message):
        ws.sample_directions(normals, **{"count": 2, **arguments})


def test_out_may_not_overlap_the_normals(normals):
    with pytest.raises(ValueError, match=r"^out: got an array that overlaps the normals, want one of its own"):
        ws.sample_directions(normals, 1, out=normals[:, None])


def test_nothing_is_written_when_an_argument_is_bad(normals):
    out = np.full((1000, 2, 3), 7.0, np.float32)
    with pytest.raises(ValueError, match="sequence"):
        ws.sample_directions(normals, 2, out=out, sequence="halton")
    assert (out == 7.0).all()


def test_more_than_memory_is_refused_with_a_way_out(normals):
    with pytest.raises(
        MemoryError, match=r"1,000,000,000,000 directions need 12000\.0 GB and .* are free; stream them: slices"
    ):
        ws.sample_directions(normals, 10**9)
