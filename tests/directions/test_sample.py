"""sample_directions: the same bits however it is run, the kinds of arrays it takes, and what it says of bad normals."""

from itertools import pairwise

import numpy as np
import pytest
import warp as wp

import warpsample as ws

SLOW = pytest.mark.slow
# The ways through the kernels: a map in a frame, one without a frame and with a rim drawn anew, one with parameters.
CASES = [ws.CosineHemisphere("polar"), ws.CosineHemisphere("offset"), ws.VisibleGGX(0.3, (0.6, -0.64, 0.48))]
EACH = pytest.mark.parametrize("distribution", CASES, ids=repr)
# Short rows in flat blocks; rows with a remainder. Slow: one sample; full vectors. Thorough: more than one part of a row.
COUNTS = [
    3,
    23,
    *(pytest.param(n, marks=SLOW) for n in (1, 64)),
    *(pytest.param(n, marks=pytest.mark.thorough) for n in (16, 100)),
]


@pytest.mark.parametrize(
    ("count", "distribution"),
    [
        *((count, CASES[0]) for count in (3, 23)),
        *(pytest.param(count, CASES[0], marks=SLOW) for count in (1, 64)),
        *(pytest.param(3, case, marks=SLOW) for case in CASES[1:]),
        *(pytest.param(count, CASES[0], marks=pytest.mark.thorough) for count in (16, 100)),
        *(pytest.param(count, case, marks=pytest.mark.thorough) for case in CASES[1:] for count in (1, 16, 23, 64, 100)),
    ],
    ids=repr,
)
def test_same_bits_in_chunks_threads_offsets_and_with_half_inactive(distribution, count, monkeypatch):
    """Global ids pass a multiple of 2^32 in the middle of the call, and at the start of one of its parts."""
    normals = np.random.default_rng(3).normal(size=(9001, 3)).astype(np.float32)
    whole = ws.sample_directions(
        normals, count, distribution=distribution, seed=5, first_point=2**32 - 4000, pdf=True, workers=1
    )
    monkeypatch.setattr("warpsample.host.engine.LEAST_WORK", 1)
    for workers in (2, 3):
        threaded = ws.sample_directions(
            normals, count, distribution=distribution, seed=5, first_point=2**32 - 4000, pdf=True, workers=workers
        )
        assert np.array_equal(whole.vectors, threaded.vectors)
    cuts = [0, 1, 257, 1500, 4000, 4001, 8000, 9001]
    for start, end in pairwise(cuts):
        part = ws.sample_directions(
            normals[start:end], count, distribution=distribution, seed=5, first_point=2**32 - 4000 + start, pdf=True
        )
        assert np.array_equal(whole.vectors[start:end], part.vectors)
    active = np.arange(len(normals)) % 2 == 0
    half = ws.sample_directions(
        normals, count, distribution=distribution, seed=5, first_point=2**32 - 4000, pdf=True, active=active, workers=2
    )
    assert np.array_equal(whole.vectors[active], half.vectors[active])
    assert np.array_equal(whole.pdf[active], half.pdf[active])
    assert not half.vectors[~active].any()
    assert not half.pdf[~active].any()
    assert half.counts() == {ws.Status.OK: 4501, ws.Status.INACTIVE: 4500}


@pytest.mark.parametrize(
    ("sequence", "distribution"),
    [
        ("sobol", CASES[0]),
        *(pytest.param("sobol", case, marks=SLOW) for case in CASES[1:]),
        pytest.param("fibonacci", CASES[0], marks=SLOW),
        *(pytest.param(n, CASES[0], marks=pytest.mark.thorough) for n in ("independent", "philox", "r2", "stratified")),
    ],
    ids=str,
)
def test_directions_about_z_are_the_map_of_the_sequence_bit_for_bit(sequence, distribution):
    """This holds for each of the three loops: one sample per point, flat blocks, and rows."""
    up = np.tile(np.float32([0.0, 0.0, 1.0]), (100, 1))
    for count in (1, 2, 23):
        u = ws.sample_square(sequence, 100, count, seed=5, first_point=2**40)
        got = ws.sample_directions(
            up, count, distribution=distribution, sequence=sequence, seed=5, first_point=2**40, pdf=True
        )
        kept = u[..., 0] < 0.9999  # the offset method draws its rim anew, about a normal by another hash
        assert np.array_equal(got.vectors[kept], distribution.sample(u)[kept])


@EACH
def test_few_samples_are_the_first_of_many_bit_for_bit(distribution, normals):
    """The counts go through flat blocks, rows, and rows that are shared out in parts."""
    counts = [1, 2, 11, 12, 23, 20_000]
    for less, more in pairwise(counts):
        some = normals[:: 1 if more < 100 else 200]
        few, many = (ws.sample_directions(some, count, distribution=distribution, pdf=True) for count in (less, more))
        assert np.array_equal(few.vectors, many.vectors[:, :less])
        assert np.array_equal(few.pdf, many.pdf[:, :less])
    parts = ws.sample_directions(some, 40_000, distribution=distribution, pdf=True)
    assert np.array_equal(parts.vectors[:, :20_000], many.vectors)


@pytest.mark.parametrize("count", [1, 5, 64])
@pytest.mark.parametrize("distribution", [ws.CosineHemisphere("polar"), ws.CosineHemisphere("offset")], ids=repr)
def test_bad_normals_get_zero_vectors_a_status_and_a_count(distribution, count, normals):
    normals[3] = 0.0
    normals[4] = (np.nan, 0, 1)
    normals[500] = (0, np.inf, 0)
    normals[999] = -0.0
    got = ws.sample_directions(normals, count, distribution=distribution, pdf=True)
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
    named = ws.sample_directions(normals, 16, distribution="cosine_hemisphere", sequence="sobol", seed=0, first_point=0)
    assert np.array_equal(ws.sample_directions(normals, 16).vectors, named.vectors)
    assert np.array_equal(
        ws.sample_directions(normals, 16, distribution=ws.CosineHemisphere("polar")).vectors, named.vectors
    )


@pytest.mark.skipif(not wp.is_cuda_available(), reason="no CUDA device")
@EACH
@pytest.mark.parametrize(("points", "count"), [(1000, 1), (1000, 23), (300_000, 64)])
def test_cuda_agrees_with_the_cpu(distribution, points, count):
    """The last case has more than 2^28 bytes, so that it goes to the device in parts."""
    normals = np.random.default_rng(1).normal(size=(points, 3)).astype(np.float32)
    normals[3] = 0.0
    here, there = (
        ws.sample_directions(normals, count, distribution=distribution, pdf=True, device=d) for d in ("cpu", "cuda")
    )
    assert isinstance(there.vectors, np.ndarray)
    assert np.abs(here.vectors - there.vectors).max() <= 3e-5  # the offset rim loses digits
    assert np.array_equal(here.status, there.status)
