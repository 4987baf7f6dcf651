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
