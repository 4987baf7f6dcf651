"""The errors of what faces send back, over many seeds: as large as they say, and no energy is lost."""

import numpy as np
import pytest
import reflection_cases as known
from irradiation_cases import DAY

import warpsample as ws

pytest.importorskip("pvlib")
pytest.importorskip("pyradiance")
pytestmark = pytest.mark.thorough


@pytest.mark.parametrize(("rho", "seeds"), [(0.3, 16), (0.6, 32), (0.9, 64)])
def test_energy_is_kept_to_a_ten_thousandth(rho, seeds):
    """As many seeds as make the mean's own error smaller than that."""
    runs = np.array([known.balance(rho, 512, seed, times=36) for seed in range(seeds)])
    error = runs.std(ddof=1) / np.sqrt(seeds)
    assert abs(runs.mean() - 1.0) < 1e-4 + 3.0 * error
    assert error < 1e-4


def spread_of_errors(call, names, seeds=24):
    """For each (number, its error): the variance of runs over the mean of their squared errors, in the sum over points."""
    runs = [call(seed) for seed in range(seeds)]
    for name, error in names:
        numbers, bars = (np.stack([getattr(run, of).astype(float) for run in runs]) for of in (name, error))
        yield numbers.var(axis=0, ddof=1).sum() / np.square(bars).mean(axis=0).sum()


@pytest.mark.parametrize("scene", ["courtyard", "street", "pit"])
def test_errors_are_as_large_as_they_say(scene):
    mesh, points = known.canyon(0.5, 0.5), known.in_canyon(40)
    if scene != "street":
        mesh = known.pit(0.8) if scene == "pit" else ws.load_mesh("courtyard", reflectance=0.5)
        points = ws.sample_surface(mesh, 150, seed=2)
    names = ("reflected", "reflected_error"), ("value", "standard_error")
    day = {"period": DAY, "patches": "tregenza", "count": 256}
    for call in (
        lambda seed: ws.irradiance(mesh, points, known.SKY, 256, seed=seed),
        lambda seed: ws.irradiation(mesh, points, "athens", seed=seed, **day),
    ):
        for ratio in spread_of_errors(call, names):
            assert 0.8 < ratio < 1.2  # of 24 runs and 8 replicates each; points share part of their errors
