"""Integrals of densities over cells, and the chi-square test of counts of several lobes together."""

import numpy as np
import pytest
from scipy.stats import kstest
from significance import ALPHA

import warpsample as ws
from warpsample.statistics.cells import integrate_lobes
from warpsample.statistics.histogram import joined_test, mixture_test

EDGES = np.append(np.linspace(0.0, np.pi / 2.0, 46), np.pi)


def integrated(lobe, lobes=1, edges=EDGES, columns=24):
    u = np.broadcast_to(ws.sample_square("fibonacci", 1, 256), (lobes, 256, 2))
    return integrate_lobes(lambda rows, w: lobe.take(rows).pdf(w), lobes, edges, columns, lobe.sample(u))


@pytest.mark.parametrize(
    "lobe",
    [ws.CosineHemisphere(), ws.UniformCone(0.4), ws.GGX(0.3), ws.GGX(1e-3), ws.Beckmann(1e-3), ws.UniformSphere()],
    ids=repr,
)
def test_cells_of_symmetric_lobes_are_those_of_their_cdf(lobe):
    """Narrow peaks inside one cell and edges inside cells, too; each of the 1,104 cells is off by 1e-6 at most."""
    found = integrated(lobe)[0]
    exact = np.diff(lobe.cdf(EDGES))[:, None] / 24
    # A row of 24 cells of an edge is off by 24e-6 if all errors have one sign; densities are rounded to 2e-6.
    assert np.abs(found - exact).max() <= 2e-5
    assert found.sum() == pytest.approx(1.0, abs=3e-4)


def test_azimuths_of_a_brushed_lobe_are_those_of_the_stretched_plane():
    """The azimuth of the slopes divided by (alpha, alpha_y) is uniform, whatever the distribution of their length."""
    sectors = 2.0 * np.pi * np.arange(25) / 24
    for alpha, alpha_y in ((0.3, 0.1), (0.02, 0.5), (0.5, 0.5)):
        stretched = np.unwrap(np.arctan2(np.sin(sectors) / alpha_y, np.cos(sectors) / alpha))
        for kind in (ws.GGX, ws.Beckmann):
            found = integrated(kind(alpha, alpha_y))[0].sum(axis=0)
            assert np.abs(found - np.diff(stretched) / (2.0 * np.pi)).max() <= 5e-5  # 46 cells of 1e-6


def test_lobes_together_and_one_by_one_have_the_same_cells():
    view = np.array([[0.0, 0.0, 1.0], [0.9, 0.3, 0.1], [-0.5, 0.5, 0.7]])
    alpha = np.array([0.05, 0.3, 0.9])
    together = integrated(ws.VisibleGGX(alpha, view, alpha[::-1]), 3)
    assert np.abs(together.sum(axis=(1, 2)) - 1.0).max() <= 3e-4
    for i in range(3):
        alone = integrated(ws.VisibleGGX(float(alpha[i]), tuple(view[i]), float(alpha[2 - i])))[0]
        assert np.abs(together[i] - alone).max() <= 2e-6


def test_a_density_that_is_noise_is_an_error():
    def noise(rows, w):
        return np.sin(1e6 * w[..., 2].astype(np.float64)) ** 2

    with pytest.raises(ValueError, match="pdf: got a density that is too rough to be integrated"):
        integrate_lobes(noise, 1, EDGES, 24, np.array([[[0.0, 0.0, 1.0]]]))


def test_a_single_lobe_is_judged_as_by_pearson():
    rng = np.random.default_rng(3)
    p = np.append(rng.dirichlet(np.ones(30)), [0.0, 1e-4, 0.0])
    p /= p.sum()
    observed = rng.multinomial(2000, p)
    pearson, mixture = joined_test(observed, 2000 * p), mixture_test(observed, p[None])
    assert mixture.dof == pearson.dof == len(pearson.expected) - 1
    assert mixture.chi_square == pytest.approx(pearson.chi_square, rel=1e-9)
    assert np.allclose(mixture.residuals, pearson.residuals, rtol=1e-9)
    assert mixture_test(np.array([3, 4]), np.array([[0.5, 0.5]])) is None


def test_counts_of_different_lobes_are_judged_by_their_own_variance(plausible):
    """p-values of right counts are uniform; those of Pearson's test with the mean probabilities are not."""
    rng = np.random.default_rng(4)
    p = np.stack([np.roll(np.append([0.6, 0.2, 0.1, 0.05, 0.05], np.zeros(15)), 3 * i) for i in range(6)])
    p_values, dofs, pearson = [], set(), []
    for _ in range(400):
        observed = sum(rng.multinomial(500, row) for row in p)
        test = mixture_test(observed, p)
        p_values.append(test.p_value)
        dofs.add(test.dof)
        pearson.append(joined_test(observed, 500 * p.sum(axis=0)).p_value)
    assert dofs == {18}  # 19 cells that can be hit, and one sum
    plausible(kstest(p_values, "uniform").pvalue)
    assert kstest(pearson, "uniform").pvalue < ALPHA
    swapped = sum(rng.multinomial(500, row) for row in p[[0, 1, 2, 3, 4, 4]])
    assert mixture_test(swapped, p).p_value < ALPHA


def test_lobes_that_lie_in_cells_of_their_own_leave_nothing_to_judge():
    assert mixture_test(np.array([50, 50, 50]), np.eye(3)) is None
    half = np.array([[0.5, 0.5, 0.0, 0.0], [0.0, 0.0, 0.5, 0.5]])
    assert mixture_test(np.array([30, 20, 28, 22]), half).dof == 2
