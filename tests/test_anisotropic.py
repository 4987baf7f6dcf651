"""Anisotropic microfacets: equal roughnesses change no bit, and unequal ones give the moments and limits of theory."""

import numpy as np
import pytest

import warpsample as ws
from warpsample.proof import laws

KINDS = (ws.GGX, ws.Beckmann, ws.VisibleGGX, ws.VisibleBeckmann)
VIEW = (0.6, -0.64, 0.48)
U = ws.sample_square("sobol", 16, 4096, seed=12).reshape(-1, 2)
INDEPENDENT = ws.sample_square("independent", 1 << 14, 16, seed=12).reshape(-1, 2)


def lobe_of(kind, alpha, alpha_y=None, view=VIEW):
    return kind(alpha, alpha_y=alpha_y, **({"view": view} if "view" in kind.parameters else {}))


@pytest.mark.parametrize("view", [VIEW, (0.0, 0.0, 1.0), (1.0, 0.0, 0.0)])
@pytest.mark.parametrize("alpha", [1e-6, 1e-3, 0.0123, 0.3, 0.777, 1.0])
@pytest.mark.parametrize("kind", KINDS)
def test_equal_roughnesses_change_no_bit(kind, alpha, view):
    one, two = lobe_of(kind, alpha, view=view), lobe_of(kind, alpha, alpha, view=view)
    w = one.sample(U)
    assert np.array_equal(two.sample(U), w)
    turned = np.concatenate([w, w[:, [1, 2, 0]], -w])
    assert np.array_equal(two.pdf(turned), one.pdf(turned))
    assert np.array_equal(two.invert(w), one.invert(w))


def test_the_mean_of_equal_roughnesses_is_the_roughness():
    """For every mantissa the square root of the rounded square is the number; the exponents change by whole powers of 4."""
    for start in range(0, 1 << 24, 1 << 22):
        a = np.arange(start, start + (1 << 22), dtype=np.int64).astype(np.float32) / np.float32(1 << 24) + np.float32(1.0)
        for x in (a, a * np.float32(2.0)):
            assert np.array_equal(np.sqrt(x * x), x)


def slopes(lobe):
    w = lobe.sample(INDEPENDENT).astype(np.float64)
    return w[:, :2] / w[:, 2:]


@pytest.mark.parametrize("alphas", [(0.3, 0.1), (1e-6, 1e-3), (0.5, 0.01)])
def test_s_has_its_law_and_the_stretched_azimuth_is_uniform(alphas, plausible):
    for kind in (ws.GGX, ws.Beckmann):
        x, y = (slopes(lobe_of(kind, *alphas)) / np.float32(alphas).astype(np.float64)).T
        s = x * x + y * y
        plausible(laws.uniform_p_value(s / (1.0 + s) if kind is ws.GGX else -np.expm1(-s)))
        turns = np.arctan2(y, x) / (2.0 * np.pi) % 1.0
        plausible(laws.uniform_p_value(turns))


def test_slopes_of_beckmann_have_the_variances_of_their_axes():
    """alpha^2 / 2 along each axis, of 2^18 Gaussian slopes: 5.3 standard errors of a variance are 1.5 %."""
    variance = slopes(ws.Beckmann(0.3, 0.1)).var(axis=0)
    assert variance == pytest.approx([0.045, 0.005], rel=0.015)


def test_long_tails_of_ggx_lie_along_the_rougher_axis():
    """Half of abs(x / z) are below alpha_x tan(pi / 6): the slope along an axis has P(< t) = t / sqrt(1 + t^2)."""
    x, y = np.abs(slopes(ws.GGX(0.3, 0.1))).T
    for slope, alpha in ((x, 0.3), (y, 0.1)):
        assert np.median(slope) == pytest.approx(alpha * np.tan(np.pi / 6.0), rel=0.01)


@pytest.mark.parametrize("kind", KINDS)
def test_exchanged_axes_exchange_the_roughnesses(kind):
    lobe = lobe_of(kind, 0.3, 0.1)
    other = lobe_of(kind, 0.1, 0.3, view=(VIEW[1], VIEW[0], VIEW[2]))
    w = lobe.sample(U)
    assert other.pdf(w[:, [1, 0, 2]]) == pytest.approx(lobe.pdf(w), rel=3e-6)  # each is accurate to 1e-6


@pytest.mark.parametrize("kind", KINDS[2:])
def test_a_visible_lobe_is_the_isotropic_lobe_of_the_stretched_view(kind):
    """Stretching y by k turns alpha_y = k alpha into alpha: slopes along y are k times those of the isotropic lobe."""
    k = 0.25
    lobe = lobe_of(kind, 0.4, 0.1)
    round_one = lobe_of(kind, 0.4, view=(VIEW[0], k * VIEW[1], VIEW[2]))
    w, v = (one.sample(INDEPENDENT).astype(np.float64) for one in (lobe, round_one))
    moved = v * (1.0, k, 1.0)
    moved /= np.linalg.norm(moved, axis=1)[:, None]
    assert laws.angle_error(w, moved) <= 2e-6  # two maps of float32, one of them stretched once more


@pytest.mark.parametrize("kind", [*KINDS[:1], *(pytest.param(kind, marks=pytest.mark.thorough) for kind in KINDS[1:])])
def test_roughnesses_by_point_have_the_bits_of_constants(kind):
    normals = np.tile(np.array([0.0, 0.6, 0.8], np.float32), (4, 1))
    along, across = np.array([0.3, 0.05, 2.0, 0.3]), np.array([0.1, 0.5, 0.1, 0.0])
    got = ws.sample_directions(normals, 16, distribution=lobe_of(kind, along, across), pdf=True)
    assert np.flatnonzero(got.status).tolist() == [2, 3]
    assert not got.vectors[2:].any()
    for i in (0, 1):
        lobe = lobe_of(kind, along[i], across[i])
        alone = ws.sample_directions(normals[:1], 16, distribution=lobe, pdf=True, first_point=i)
        assert np.array_equal(got.vectors[i], alone.vectors[0])
        assert np.array_equal(got.pdf[i], alone.pdf[0])
    mixed = ws.sample_directions(normals[:1], 16, distribution=lobe_of(kind, along[:1], 0.1), pdf=True)
    assert np.array_equal(mixed.pdf, got.pdf[:1])


def test_texts_and_errors_name_the_second_roughness():
    assert repr(ws.GGX(0.3)) == "GGX(alpha=0.3)"
    assert repr(ws.GGX(0.3, 0.1)) == "GGX(alpha=0.3, alpha_y=0.1)"
    assert ws.distributions.as_distribution("beckmann(alpha=0.3, alpha_y=0.1)") == ws.Beckmann(0.3, 0.1)
    assert ws.GGX(0.3) != ws.GGX(0.3, 0.3)
    with pytest.raises(ValueError, match="^alpha_y: got 0.0, want a number from 1e-06 to 1"):
        ws.VisibleGGX(0.3, alpha_y=0.0)
    with pytest.raises(
        NotImplementedError, match=r"GGX\(alpha=0.3, alpha_y=0.1\): this distribution has no cdf of the angle"
    ):
        ws.GGX(0.3, 0.1).cdf(0.1)
