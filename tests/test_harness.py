"""The laws must reject wrong samplers: each defect here is caught by the law named beside it."""

from dataclasses import dataclass
from functools import partial

import numpy as np
import pytest
from conftest import ALPHA
from twins import cosine_polar, spherical

import warpsample as ws
from warpsample.proof import laws
from warpsample.proof.histogram import cosine_lobe_angles, histogram_test

RIGHT = ws.CosineHemisphere()
DRAWS = 1 << 20


@dataclass
class Wrong:
    """The cosine lobe with one defect."""

    draw: object = RIGHT.sample
    density: object = RIGHT.pdf
    inverse: object = RIGHT.invert

    def sample(self, u):
        return self.draw(np.asarray(u, np.float32))

    def pdf(self, w):
        return self.density(w)

    def invert(self, w):
        return self.inverse(w)


def plus_normal(sphere):
    d = sphere + np.array((0.0, 0.0, 1.0))
    return (d / np.linalg.norm(d, axis=-1, keepdims=True)).astype(np.float32)


def scaled_sphere(scale, u):
    return plus_normal(scale * ws.UniformSphere().sample(u).astype(np.float64))


def lifted_in_float32(u):
    r = np.sqrt(u[..., 0])
    x, y = (r * f(np.float32(2 * np.pi) * u[..., 1]) for f in (np.cos, np.sin))
    return np.stack([x, y, np.sqrt(np.maximum(np.float32(1) - x * x - y * y, 0))], axis=-1)


def coarse(bits, u):
    return RIGHT.sample((np.floor(u * 2**bits) / 2**bits).astype(np.float32))


def ball(u):
    return spherical(np.arccos((1.0 - u[..., 0].astype(np.float64)) ** 0.25), u[..., 1].astype(np.float64)).astype(
        np.float32
    )


def gap(u):
    return RIGHT.sample(np.stack([u[..., 0], (u[..., 1] * (1 - 1e-3 / (2 * np.pi))).astype(np.float32)], axis=-1))


def swapped_quadrant(u):
    w = RIGHT.sample(u)
    quadrant = (u[..., 1] >= 0.25) & (u[..., 1] < 0.5)
    w[quadrant, 0], w[quadrant, 1] = w[quadrant, 1].copy(), w[quadrant, 0].copy()
    return w


def nan_in_the_middle(u):
    w = RIGHT.sample(u)
    w[(u == 0.5).all(axis=-1)] = np.nan
    return w


def one_in_a_hundred_thousand_below(u):
    w = RIGHT.sample(u)
    w[::100_000, 2] *= -1
    return w


def swapped_pair(w):
    return RIGHT.invert(w)[..., ::-1]


@pytest.fixture(scope="module")
def u():
    return ws.sample_square("independent", DRAWS // 64, 64, seed=1).reshape(-1, 2)


@pytest.fixture(scope="module")
def smooth():
    k = np.arange(2048)
    return np.stack([(k + 0.5) / 2048, k * 0.618033988749895 % 1.0], axis=1) * (1 - 2**-6) + 2**-7


def shape(wrong, u):
    return laws.solid_angle_test(wrong, wrong.sample(u)).p_value


def rim(wrong, u):
    return laws.count_p_value((wrong.sample(u)[:, 2] < 0.01).sum(), len(u), 1e-4)


def azimuth(wrong, u):
    return laws.azimuth_gap_p_value(wrong.sample(u))


@pytest.mark.parametrize(
    ("wrong", "law"),
    [
        pytest.param(Wrong(ball, RIGHT.pdf), shape, id="ball for sphere"),
        pytest.param(Wrong(partial(scaled_sphere, 0.98)), rim, id="sphere scaled by 0.98"),
        pytest.param(Wrong(partial(coarse, 12)), rim, id="u on 12 bits"),
        pytest.param(Wrong(gap), azimuth, id="azimuth gap of 1e-3 rad"),
        pytest.param(Wrong(swapped_quadrant), shape, id="sin and cos swapped in a quadrant"),
        pytest.param(Wrong(one_in_a_hundred_thousand_below), shape, id="one in 10^5 below the surface"),
        pytest.param(Wrong(ws.UniformHemisphere().sample), shape, id="uniform for cosine"),
        pytest.param(Wrong(lambda u: RIGHT.sample(u) * np.float32([1, 1, -1])), shape, id="upside down"),
    ],
)
def test_statistics_reject(wrong, law, u):
    assert law(RIGHT, u) >= ALPHA
    assert law(wrong, u) < ALPHA


def test_rim_of_ten_million_rejects_a_sphere_scaled_by_0_99999():
    """The published remedy against a zero sum; chi-square of 10^6 directions never sees it."""
    rims = {}
    for name, sampler in (("right", RIGHT.sample), ("scaled", partial(scaled_sphere, 0.99999))):
        z = [sampler(ws.sample_square("independent", 1 << 18, 1, seed).reshape(-1, 2))[:, 2] for seed in range(40)]
        rims[name] = laws.count_p_value((np.concatenate(z) < 0.004).sum(), 40 << 18, 0.004**2)
    assert rims["right"] >= ALPHA
    assert rims["scaled"] < ALPHA


@pytest.mark.parametrize(
    "draw",
    [
        pytest.param(lifted_in_float32, id="sqrt(1 - x^2 - y^2)"),
        pytest.param(nan_in_the_middle, id="NaN at the centre"),
        pytest.param(lambda u: RIGHT.sample(u) * np.float32(1 + 4e-7), id="length off by 4e-7"),
        pytest.param(lambda u: RIGHT.sample(u)[..., [1, 0, 2]], id="axes swapped"),
        pytest.param(partial(coarse, 16), id="u on 16 bits"),
    ],
)
def test_twins_reject(draw):
    u = np.concatenate([laws.corner_grid(), ws.sample_square("independent", 1, 1 << 18)[0]])
    w = draw(u)
    exact = cosine_polar(u.astype(np.float64))
    good = RIGHT.sample(u)
    assert max(laws.length_error(good) / 2e-7, laws.angle_error(good, exact) / 3e-7) <= 1.0
    assert max(laws.length_error(w) / 2e-7, laws.angle_error(w, exact) / 3e-7) > 1.0


@pytest.mark.parametrize(
    "wrong",
    [
        pytest.param(Wrong(density=lambda w: RIGHT.pdf(w) * np.float32(1.001)), id="pdf off by 1e-3"),
        pytest.param(Wrong(density=lambda w: np.float32(0.5) * (1 + RIGHT.pdf(w))), id="pdf of another law"),
        pytest.param(
            Wrong(density=lambda w: RIGHT.pdf(w) * np.sqrt(1 - w[..., 2] ** 2)), id="per radian called per steradian"
        ),
        pytest.param(Wrong(draw=ball), id="ball for sphere"),
    ],
)
def test_stretch_of_area_rejects(wrong, smooth):
    assert abs(laws.area_stretch_error(RIGHT, smooth)[1]) <= 1e-5
    assert abs(laws.area_stretch_error(wrong, smooth)[1]) > 1e-5


def test_mass_rejects_a_density_per_radian():
    assert abs(laws.mass(Wrong(density=lambda w: RIGHT.pdf(w) * np.sqrt(1 - w[..., 2] ** 2))) - 1.0) > 0.1


def test_unconverged_expectation_is_an_error_and_not_a_rejection(u):
    with pytest.raises(ValueError, match="pdf: its integral over the sphere converges to 1.00"):
        laws.solid_angle_test(Wrong(density=lambda w: RIGHT.pdf(w) * np.float32(1.005)), RIGHT.sample(u))
    with pytest.raises(ValueError, match="expected: got a count of 1, want at least 5"):
        histogram_test(np.array([1, 9]), np.array([1, 9]))
    with pytest.raises(ValueError, match="expected: got a sum of 20, want that of the observed counts, 18"):
        histogram_test(np.array([9, 9]), np.array([10, 10]))


def test_round_trip_rejects_a_swapped_pair_and_nan(u):
    assert laws.round_trip_error(RIGHT, u) <= 2e-6
    assert laws.round_trip_error(Wrong(inverse=swapped_pair), u) > 0.1
    assert laws.round_trip_error(Wrong(inverse=lambda w: RIGHT.invert(w) * np.nan), u) == np.inf


def test_viewer_histogram_rejects_the_wrong_lobe(u):
    angles = {law: np.arccos(sampler(u)[:, 2]) for law, sampler in (("right", RIGHT.sample), ("ball", ball))}
    assert cosine_lobe_angles(angles["right"], 90)[1].p_value >= ALPHA
    assert cosine_lobe_angles(angles["ball"], 90)[1].p_value < ALPHA


def test_moments_reject_a_shift_of_a_thousandth(u):
    z = RIGHT.sample(u)[:, 2].astype(np.float64)
    assert laws.mean_error(z, 2 / 3) <= 5.3
    assert laws.mean_error(z * 1.003, 2 / 3) > 5.3
