"""Cosine lobes about random normals: the mean cosine of each method, and the rim that the offset method draws anew."""

import numpy as np
import pytest

import warpsample as ws
from warpsample.proof import laws, twins
from warpsample.proof.twins.sequences import pcg4d


def unit(normals):
    n = normals.astype(np.float64)
    return n / np.linalg.norm(n, axis=-1, keepdims=True)


def test_offset_is_sphere_plus_normal_with_its_rim_redrawn():
    normals = np.random.default_rng(5).normal(size=(40_000, 3)).astype(np.float32)
    n = unit(normals)
    u = ws.sample_square("independent", len(n), 64, seed=7)
    total = n[:, None] + twins.directions(ws.UniformSphere(), u.astype(np.float64))
    length = np.linalg.norm(total, axis=-1)
    got = ws.sample_directions(
        normals, 64, distribution=ws.CosineHemisphere("offset"), sequence="independent", seed=7, pdf=True
    )
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


@pytest.mark.parametrize(
    "distribution",
    [
        pytest.param(case, marks=pytest.mark.slow if case.method in ("polar", "offset") else pytest.mark.thorough)
        for case in ws.CosineHemisphere.cases()
    ],
    ids=repr,
)
def test_mean_cosine_of_ten_million_directions_about_random_normals(distribution):
    normals = np.random.default_rng(6).normal(size=(160_000, 3)).astype(np.float32)
    got = ws.sample_directions(normals, 64, distribution=distribution, sequence="independent", seed=8)
    cosine = np.einsum("psk,pk->ps", got.vectors, unit(normals))
    assert cosine.size >= 10**7
    assert abs(cosine.mean(dtype=np.float64) - 2.0 / 3.0) <= 4.0 * np.sqrt(1.0 / 18.0 / cosine.size)  # standard errors
    assert cosine.min() > 0.0


def test_rim_of_the_offset_method_is_neither_cut_nor_crowded(plausible):
    normals = np.random.default_rng(7).normal(size=(320_000, 3)).astype(np.float32)
    got = ws.sample_directions(normals, 64, distribution=ws.CosineHemisphere("offset"), sequence="independent", seed=9)
    cosine = np.einsum("psk,pk->ps", got.vectors, unit(normals))
    for limit in (0.002, 0.005, 2.0**-7, 0.01):  # inside the rim, across it, outside
        plausible(laws.count_p_value((cosine < limit).sum(), cosine.size, limit**2))
