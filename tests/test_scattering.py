"""Distributions of scattered light have the values that their theory states, at ordinary and extreme parameters."""

import numpy as np
import pytest

import warpsample as ws
from warpsample.proof import laws, verify

U = ws.sample_square("sobol", 16, 4096, seed=11).reshape(-1, 2)


def half_share(g):
    """Closed form of the share of directions with a positive cosine, for g other than 0."""
    return (1.0 - g * g) / (2.0 * g) * (1.0 / (1.0 - g) - 1.0 / np.sqrt(1.0 + g * g))


@pytest.mark.parametrize("g", [-0.999, -0.7, -1e-3, 1e-3, 0.3, 0.9])
def test_henyey_greenstein_has_its_mean_and_its_share_forward(g):
    """By Sobol' points, whose means of a smooth or stepped function are within 2e-4 here."""
    z = ws.HenyeyGreenstein(g).sample(U)[:, 2].astype(np.float64)
    assert z.mean() == pytest.approx(g, abs=2e-4)
    assert (z > 0.0).mean() == pytest.approx(half_share(g), abs=2e-4)
    assert ws.HenyeyGreenstein(g).cdf(np.pi / 2) == pytest.approx(half_share(g), abs=1e-6)  # g is rounded to float32


@pytest.mark.parametrize("g", [1e-4, 0.5, 0.99, 0.999999])
def test_henyey_greenstein_of_minus_g_is_the_mirrored_lobe(g):
    forward, backward = ws.HenyeyGreenstein(g), ws.HenyeyGreenstein(-g)
    w = forward.sample(U)
    mirrored = w * np.float32([1.0, 1.0, -1.0])
    assert np.array_equal(backward.pdf(mirrored), forward.pdf(w))
    inner = U[U[:, 0] > 0.0]
    other = np.stack([1.0 - inner[:, 0], inner[:, 1]], axis=-1)
    # Each map is accurate to 1e-7.
    assert laws.angle_error(backward.sample(other).astype(np.float64), mirrored[U[:, 0] > 0.0].astype(np.float64)) <= 3e-7


def test_henyey_greenstein_of_tiny_g_is_no_uniform_sphere():
    """cos = 1 - 2 u + 6 g u (1 - u), and a term below 2 g^2, by expansion about g = 0."""
    u = U.astype(np.float64)
    for g in (1e-3, -1e-4):
        z = ws.HenyeyGreenstein(g).sample(U)[:, 2]
        flat = 1.0 - 2.0 * u[:, 0]
        bent = flat + 6.0 * g * u[:, 0] * (1.0 - u[:, 0])
        assert np.abs(z - bent).max() <= 2.0 * g * g + 1e-7
        assert np.abs(z - flat).max() >= 1.4 * abs(g)


def test_a_beam_keeps_its_digits():
    """At g = 0.999999 half of the directions are within 1.8e-6 rad of the flight: all laws of angles hold there, too."""
    case = ws.HenyeyGreenstein(0.999999)
    w = case.sample(U).astype(np.float64)
    half = np.median(np.hypot(w[:, 0], w[:, 1]))
    g = float(np.float32(0.999999))
    assert case.cdf(half) == pytest.approx(0.5, abs=1e-4)
    assert half == pytest.approx(np.sqrt(3.0) * (1.0 - g), rel=1e-3)  # r = 2 (1 - g) halves 1 / r: theta = sqrt(3) (1 - g)
    assert case.pdf([[0.0, 0.0, 1.0]])[0] == pytest.approx((1.0 + g) / (4.0 * np.pi * (1.0 - g) ** 2), rel=1e-6)
    subject = verify.Subject(repr(case), case, case)
    assert verify.Evidence(subject, every=64, draws=1 << 16).sweep["broken"] == 0


@pytest.mark.parametrize("g", [1.0, -1.0, float("nan"), 2])
def test_bad_asymmetry_is_named(g):
    with pytest.raises(ValueError, match=f"^g: got {g}, want a number from -0.999999 to 0.999999"):
        ws.HenyeyGreenstein(g)


LEANING = ((0.4, 0.0, 0.3), (0.0, 0.3, 0.0), (-0.25, 0.0, 1.0))
MIRRORED = ((0.2, -0.5, 0.9), (1.0, 0.3, 0.2), (0.4, 0.7, 0.1))


def test_the_identity_transforms_nothing():
    lobe = ws.LinearlyTransformedCosine()
    w = lobe.sample(U)
    cosine = ws.CosineHemisphere()
    assert np.abs(w - cosine.sample(U)).max() <= 2e-7  # each is accurate to 1.2e-7
    assert lobe.pdf(w) == pytest.approx(cosine.pdf(w), rel=3e-7)


@pytest.mark.parametrize("matrix", [LEANING, MIRRORED])
def test_the_scale_of_a_matrix_does_not_matter(matrix):
    lobe = ws.LinearlyTransformedCosine(matrix)
    for scale in (2.0, 2.0**-120, 2.0**120):  # powers of two: every bit stays
        other = ws.LinearlyTransformedCosine(scale * np.array(matrix))
        assert other == lobe
        assert np.array_equal(other.sample(U), lobe.sample(U))
    third = ws.LinearlyTransformedCosine(np.array(matrix) / 3.0)
    assert np.abs(third.sample(U) - lobe.sample(U)).max() <= 1e-6  # another rounding of the matrix, 6e-8 of each number


def test_a_rotation_rotates_the_lobe():
    turn, tilt = 0.7, 0.4
    about_z = np.array([[np.cos(turn), -np.sin(turn), 0.0], [np.sin(turn), np.cos(turn), 0.0], [0.0, 0.0, 1.0]])
    about_y = np.array([[np.cos(tilt), 0.0, np.sin(tilt)], [0.0, 1.0, 0.0], [-np.sin(tilt), 0.0, np.cos(tilt)]])
    rotated, lobe = ws.LinearlyTransformedCosine(about_y @ about_z @ LEANING), ws.LinearlyTransformedCosine(LEANING)
    w = lobe.sample(U).astype(np.float64)
    there = w @ (about_y @ about_z).T
    assert np.abs(rotated.sample(U) - there).max() <= 1e-6
    assert rotated.pdf(there) == pytest.approx(lobe.pdf(w), rel=1e-5)  # rounded directions and matrices, stretched


def test_a_mirrored_lobe_has_a_negative_determinant_and_the_same_density():
    lobe = ws.LinearlyTransformedCosine(LEANING)
    mirrored = ws.LinearlyTransformedCosine(np.array(LEANING) * [1.0, -1.0, 1.0])  # o mirrored in y: the same set
    w = lobe.sample(U)
    assert mirrored.pdf(w) == pytest.approx(lobe.pdf(w), rel=3e-7)
    upside = ws.LinearlyTransformedCosine(-np.array(LEANING))
    assert np.array_equal(upside.sample(U), -w)
    assert np.array_equal(upside.pdf(-w), lobe.pdf(w))
    assert not upside.pdf(w).any()


@pytest.mark.parametrize("a", [1.0, 0.3, 1e-4])
def test_a_narrow_lobe_has_its_peak(a):
    lobe = ws.LinearlyTransformedCosine(np.diag([a, a, 1.0]))
    assert lobe.pdf([[0.0, 0.0, 1.0]])[0] == pytest.approx(1.0 / (np.pi * a * a), rel=3e-7)


def test_a_lobe_may_reach_below_the_surface():
    lobe = ws.LinearlyTransformedCosine(MIRRORED)
    w = lobe.sample(U)
    assert 0.02 < (w[:, 2] < 0.0).mean() < 0.98
    assert (lobe.pdf(w) > 0.0).all()
    axis = np.linalg.inv(np.array(MIRRORED)).T @ [0.0, 0.0, 1.0]
    above = w.astype(np.float64) @ axis
    assert (above > -1e-7).all()
    assert (lobe.pdf(-w[above > 1e-5]) == 0.0).all()


NAN = float("nan")


@pytest.mark.parametrize(
    "matrix",
    [
        [[1.0, 2.0], [3.0, 4.0]],
        np.zeros((3, 3)),
        [[1.0, 2.0, 3.0], [2.0, 4.0, 6.0], [0.0, 0.0, 1.0]],
        [[NAN, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
        [[float("inf"), 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
    ],
)
def test_a_matrix_that_transforms_to_no_lobe_is_named(matrix):
    with pytest.raises(ValueError, match="^matrix: got .*, want 3 x 3 finite numbers with a determinant other than 0$"):
        ws.LinearlyTransformedCosine(matrix)


def test_scattering_by_point_has_the_bits_of_constants_and_counts_bad_rows():
    points = np.tile(np.array([0.0, 0.6, 0.8], np.float32), (5, 1))
    matrices = np.array([LEANING, MIRRORED, np.zeros((3, 3)), np.array(LEANING) / 3.0, LEANING])
    gs = np.array([0.7, -0.3, 1.0, NAN, 0.0])
    for kind, rows, bad in ((ws.LinearlyTransformedCosine, matrices, [2]), (ws.HenyeyGreenstein, gs, [2, 3])):
        got = ws.sample_directions(points, 16, distribution=kind(rows), pdf=True)
        assert np.flatnonzero(got.status).tolist() == bad
        assert not got.vectors[bad].any()
        assert not got.pdf[bad].any()
        for i in set(range(5)) - set(bad):
            alone = ws.sample_directions(points[:1], 16, distribution=kind(rows[i]), pdf=True, first_point=i)
            assert np.array_equal(got.vectors[i], alone.vectors[0])
            assert np.array_equal(got.pdf[i], alone.pdf[0])
