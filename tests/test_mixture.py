"""Mixtures draw each lobe by its weight, keep strata within lobes, and have the weighted sum of densities."""

import pickle
from math import pi

import numpy as np
import pytest
import warp as wp

import warpsample as ws
from warpsample import funcs
from warpsample.proof import laws

U = ws.sample_square("sobol", 1, 4096, seed=5)[0]
NAN = float("nan")
SIGNS = np.array([[x, y, z] for z in (1.0, -1.0) for y in (1.0, -1.0) for x in (1.0, -1.0)])
OCTANTS = [ws.SphericalTriangle(np.diag(signs)) for signs in SIGNS[:2]]
"""Lobes that are apart: directions tell which lobe they are of."""
VIEW = (0.6, 0.0, 0.8)


def test_dyadic_weights_have_exact_counts_and_strata_stay():
    """Of 4096 Sobol' points, a quarter has 1024, whose own u[0] is once in each of 1024 intervals."""
    mixture = ws.Mixture(OCTANTS, [1.0, 3.0])
    assert mixture.weights == (0.25, 0.75)
    w = mixture.sample(U)
    for lobe, inside, count in ((OCTANTS[0], w[:, 0] > 0.0, 1024), (OCTANTS[1], w[:, 0] < 0.0, 3072)):
        assert inside.sum() == count
        u = lobe.invert(w[inside]).astype(np.float64)
        off_seam = u[:, 1] > 1e-3  # where u[0] is lost
        cells = np.floor(u[off_seam, 0] * 1024 + 0.5 / 1024).astype(int)
        assert np.bincount(cells, minlength=1024).max() <= (1 if count == 1024 else 4)
    assert mixture.pdf(w) == pytest.approx(np.where(w[:, 0] > 0.0, 0.25, 0.75) * 2.0 / pi, rel=1e-6)


def test_the_inner_u_is_the_stretched_one():
    lobes = [ws.CosineHemisphere(), ws.GGX(0.3)]
    w = ws.Mixture(lobes, [0.25, 0.75]).sample(U)
    first = U[:, 0] < 0.25
    x = U[:, 0].astype(np.float64)
    stretched = np.where(first, x / 0.25, (x - 0.25) / 0.75)
    u = np.stack([np.floor(stretched * 2**24) / 2**24, U[:, 1]], axis=1).astype(np.float32)
    for lobe, rows in zip(lobes, (first, ~first), strict=True):
        assert np.array_equal(w[rows], lobe.sample(u[rows]))


@pytest.mark.parametrize(
    "lobe",
    [
        pytest.param(ws.GGX(0.3), marks=pytest.mark.thorough),
        ws.CosineHemisphere("offset"),
        ws.Reflection(ws.VisibleGGX(0.3, VIEW), VIEW),
        ws.VisibleGGX(0.3, VIEW),
    ],
    ids=repr,
)
def test_a_mixture_of_one_is_its_lobe_bit_for_bit(lobe):
    mixture = ws.Mixture([lobe], [2.0])
    w = lobe.sample(U)
    assert np.array_equal(mixture.sample(U), w)
    assert np.array_equal(mixture.pdf(w), lobe.pdf(w))
    assert np.array_equal(mixture.invert(w), lobe.invert(w))
    normals = np.random.default_rng(1).normal(size=(50, 3)).astype(np.float32)
    for count in (1, 5, 40):
        one, other = (ws.sample_directions(normals, count, distribution=d, pdf=True) for d in (mixture, lobe))
        assert np.array_equal(one.vectors, other.vectors)
        assert np.array_equal(one.pdf, other.pdf)


def test_a_weight_of_0_is_never_drawn_and_a_tiny_one_has_its_share():
    corners = laws.corner_grid()
    for weights in ([0.0, 1.0], [1.0, 0.0]):
        drawn = ws.Mixture(OCTANTS, weights).sample(corners)[:, 0] * SIGNS[int(weights[1]), 0]
        assert (drawn >= 0.0).all()
    tiny = ws.Mixture(OCTANTS, [1e-12, 1.0])
    assert tiny.weights == (2.0**-24, 1.0 - 2.0**-24)
    w = tiny.sample(corners)
    first = corners[:, 0] == 0.0  # one of the 2^24 values of u[0]
    assert (w[first, 0] >= 0.0).all()
    assert (w[~first, 0] <= 0.0).all()
    inside = tiny.pdf(ws.SphericalTriangle(np.eye(3)).sample(U[(U > 0.0).all(axis=1)]))
    assert inside == pytest.approx(2.0**-24 * 2.0 / pi, rel=1e-6)


def test_shares_are_multiples_of_the_grid_and_sum_to_1():
    rng = np.random.default_rng(2)
    rows = 10.0 ** rng.uniform(-12.0, 3.0, (1000, 8)) * (rng.random((1000, 8)) < 0.8)
    rows[:, 0] += 1e-3
    shares = ws.Mixture([ws.UniformSphere()] * 8, rows).weights.astype(np.float64)
    assert (shares.sum(axis=1) == 1.0).all()
    assert np.array_equal(shares > 0.0, rows > 0.0)
    assert np.array_equal(shares * 2**24, np.rint(shares * 2**24))
    assert np.abs(shares - rows / rows.sum(axis=1, keepdims=True)).max() <= 8 * 2.0**-24


@pytest.mark.parametrize("count", [3, *(pytest.param(n, marks=pytest.mark.thorough) for n in (1, 40))])
def test_weights_by_point_have_the_bits_of_constants_and_bad_rows_are_counted(count):
    lobes = [ws.CosineHemisphere(), ws.GGX(0.3), ws.UniformSphere()]
    rows = np.array([[1.0, 2.0, 3.0], [0.0, 1.0, 0.0], [-1.0, 1.0, 1.0], [NAN, 1.0, 1.0], [0.0] * 3, [5.0, 1.0, 1.0]])
    bad = [2, 3, 4]
    normals = np.tile(np.float32([0.48, 0.6, 0.64]), (len(rows), 1))
    got = ws.sample_directions(normals, count, distribution=ws.Mixture(lobes, rows), pdf=True)
    assert np.flatnonzero(got.status).tolist() == bad
    assert got.counts()[ws.Status.INVALID_PARAMETER] == len(bad)
    assert not got.vectors[bad].any()
    assert not got.pdf[bad].any()
    for i in (0, 1, 5):
        alone = ws.sample_directions(normals[:1], count, distribution=ws.Mixture(lobes, rows[i]), pdf=True, first_point=i)
        assert np.array_equal(got.vectors[i], alone.vectors[0])
        assert np.array_equal(got.pdf[i], alone.pdf[0])


def test_a_bad_row_of_any_lobe_is_a_bad_row_of_the_mixture():
    alpha = np.array([0.3, NAN, 0.5])
    mixture = ws.Mixture([ws.CosineHemisphere(), ws.GGX(alpha)], [0.5, 0.5])
    got = ws.sample_directions(np.eye(3, dtype=np.float32), 4, distribution=mixture)
    assert np.flatnonzero(got.status).tolist() == [1]
    assert list(mixture.by_point) == ["lobes[1].alpha"]
    assert np.array_equal(mixture.take([2]).lobes[1].alpha, np.float32([0.5]))
    with pytest.raises(ValueError, match=r"^distribution: got lobes\[1\].alpha with 3 rows, want 2, one for each point"):
        ws.sample_directions(np.eye(3, dtype=np.float32)[:2], 4, distribution=mixture)
    with pytest.raises(ValueError, match=r"^weights: got 2 rows, want 3, as lobes\[1\].alpha has"):
        ws.Mixture([ws.CosineHemisphere(), ws.GGX(alpha)], np.ones((2, 2)))


def test_directions_have_the_density_of_all_lobes_in_any_frame():
    """A reflection's own density comes from its normal, and is 2e-6 from that of the rounded direction."""
    lobe = ws.Mixture([ws.CosineHemisphere(), ws.Reflection(ws.VisibleGGX(0.5, VIEW), VIEW)], [0.4, 0.6])
    points = ws.sample_surface(ws.load_mesh("courtyard"), 200)
    d = ws.sample_directions(points, 32, distribution=lobe, pdf=True)
    assert d.pdf == pytest.approx(lobe.pdf(points.to_local(d.vectors)), rel=2e-5)  # local again: another rounding of w
    assert lobe.pdf(lobe.sample(U)) == pytest.approx(
        0.4 * ws.CosineHemisphere().pdf(lobe.sample(U)) + 0.6 * lobe.lobes[1].pdf(lobe.sample(U)), rel=1e-6
    )


def test_the_balance_heuristic_integrates_a_lamp_and_a_lobe():
    """The cosine-weighted solid angle of an octant of the sky is 1/4 of pi; the mixture covers it by lobe and lamp."""
    lamp = ws.SphericalTriangle(np.eye(3))
    u = ws.sample_square("sobol", 16, 4096, seed=3).reshape(-1, 2)
    for weights in ([0.5, 0.5], [0.1, 0.9]):
        mixture = ws.Mixture([ws.CosineHemisphere(), lamp], weights)
        w = mixture.sample(u)
        value = np.where((w > 0.0).all(axis=1), w[:, 2], 0.0) / mixture.pdf(w)
        assert value.mean() == pytest.approx(pi / 4.0, rel=1e-3)  # 65,536 Sobol' points of a step: 2e-4


@pytest.mark.parametrize(
    ("lobes", "weights", "error", "message"),
    [
        ([], [], TypeError, "lobes: got "),
        ([ws.GGX(0.3)] * 9, [1.0] * 9, TypeError, "lobes: got "),
        ([ws.UniformDisk()], [1.0], TypeError, "lobes: got "),
        (ws.GGX(0.3), [1.0], TypeError, "lobes: got "),
        ([ws.GGX(0.3)], [1.0, 2.0], ValueError, r"weights: got shape \(2,\), want 1 numbers"),
        ([ws.GGX(0.3)], [0.0], ValueError, "weights: got "),
        ([ws.GGX(0.3)] * 2, [-1.0, 2.0], ValueError, "weights: got "),
        ([ws.GGX(0.3)] * 2, [NAN, 2.0], ValueError, "weights: got "),
        (
            [ws.LinearlyTransformedCosine()] * 3,
            [1.0] * 3,
            ValueError,
            "lobes: got 30 numbers with the weights, want at most",
        ),
    ],
)
def test_wrong_mixtures_are_named(lobes, weights, error, message):
    with pytest.raises(error, match=f"^{message}"):
        ws.Mixture(lobes, weights)


def test_mixtures_are_values_and_texts():
    mixture = ws.Mixture([ws.CosineHemisphere(), ws.GGX(0.3)], [1.0, 3.0])
    assert pickle.loads(pickle.dumps(mixture)) == mixture
    assert hash(mixture) == hash(ws.Mixture([ws.CosineHemisphere(), ws.GGX(0.3)], [0.25, 0.75]))
    assert mixture != ws.Mixture([ws.GGX(0.3), ws.CosineHemisphere()], [1.0, 3.0])
    text = "mixture(lobes=[cosine_hemisphere(), ggx(alpha=0.3)], weights=[1, 3])"
    assert ws.distributions.as_distribution(text) == mixture
    with pytest.raises(NotImplementedError, match="this distribution has no inverse"):
        mixture.invert(mixture.sample(U))


def sky():
    picture = np.random.default_rng(4).random((8, 16)) + 0.2
    picture[2, 3] = 50.0
    return ws.EnvironmentMap(picture)


@pytest.mark.parametrize("tangents", [False, pytest.param(True, marks=pytest.mark.thorough)])
def test_a_picture_and_a_lobe_about_the_normal_are_mixed(tangents):
    """Each direction is that of its lobe alone at the stretched u, and its density is the sum of both."""
    normals = np.random.default_rng(1).normal(size=(40, 3)).astype(np.float32)
    points = ws.SurfacePoints(np.zeros((40, 3), np.float32), normals)
    points = points.with_tangents([0.3, 0.5, 0.8]) if tangents else points
    lobes = [ws.GGX(0.3, 0.1), sky(), ws.CosineHemisphere()]
    mixture = ws.Mixture(lobes, [0.25, 0.5, 0.25])
    for count in (64, 1) if tangents else (64,):
        d = ws.sample_directions(points, count, distribution=mixture, sequence="sobol", seed=3, pdf=True)
        first = ws.sample_square("sobol", 40, count, seed=3)
        which = np.digitize(first[..., 0], [0.25, 0.75])
        local = np.stack([points.to_local(d.vectors[:, i]) for i in range(count)], axis=1)
        for i, (start, width) in enumerate([(0.0, 0.25), (0.25, 0.5), (0.75, 0.25)]):
            stretched = np.stack([(first[..., 0].astype(np.float64) - start) / width, first[..., 1]], axis=-1)
            chosen = which == i
            w = lobes[i].sample(stretched[chosen].astype(np.float32))
            assert (d.vectors if i == 1 else local)[chosen] == pytest.approx(w, abs=3e-7)
        density = 0.25 * lobes[0].pdf(local) + 0.5 * lobes[1].pdf(d.vectors) + 0.25 * lobes[2].pdf(local)
        relative = np.abs(d.pdf / density - 1.0)
        assert np.quantile(relative, 0.99) <= 1e-4  # `local` is rounded to 6e-8, which matters at grazing angles


def test_a_mixture_with_a_picture_integrates_and_has_no_map_without_normals():
    mixture = ws.Mixture([ws.CosineHemisphere(), sky()], weights=np.tile([0.5, 0.5], (64, 1)))
    normals = np.random.default_rng(1).normal(size=(64, 3)).astype(np.float32)
    found = ws.integrate(normals, over_the_sphere, 4096, distribution=mixture)
    assert np.abs(found.value - 4.0 * pi).max() <= 5.0 * found.standard_error.max()
    assert found.standard_error.max() < 0.5  # 4 % of the sphere: a wrong density would move the mean by more
    for call in (lambda: mixture.sample(U), lambda: mixture.pdf(np.eye(3)), lambda: mixture.invert(np.eye(3))):
        with pytest.raises(NotImplementedError, match="normals|inverse"):
            call()
    with pytest.raises(NotImplementedError, match="^lobes: got a mixture with a lobe in world coordinates"):
        ws.Mixture([mixture, ws.GGX(0.3)], [0.5, 0.5])
    with pytest.raises(ValueError, match="world coordinates"):
        ws.Reflection(mixture, view=VIEW)
    one = ws.Mixture([sky()], [1.0])
    assert np.array_equal(one.sample(U), sky().sample(U))
    assert pickle.loads(pickle.dumps(mixture)) == mixture


@wp.func
def over_the_sphere(w: wp.vec3, lobe: funcs.Lobe) -> float:
    return 1.0 / lobe.pdf
