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


@pytest.mark.parametrize("turn", [0, 1])
def test_faces_at_the_same_place_with_different_reflectances_are_warned_of(turn):
    """Rays meet the first of the two, whichever way it faces: a floor below had 0.26 or 2.33."""
    square = np.array([(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)])
    vertices = [(x, y, z) for z in (0.0, 1.0, 1.0) for x, y in square]
    faces = np.array([(0, 1, 2), (0, 2, 3), (4, 6, 5), (4, 7, 6), *np.roll([(8, 9, 10), (8, 10, 11)], turn, axis=1)])
    share, points = np.array([0.0, 0.0, 0.0, 0.0, 0.8, 0.8]), ws.SurfacePoints([(0.0, 0.0, 0.0)], [(0.0, 0.0, 1.0)])
    sky = np.ones((4, 8), np.float32)
    with pytest.warns(UserWarning, match="^mesh: 2 pairs of faces are at the same place and have different reflectances"):
        ws.irradiance(ws.Mesh(vertices, faces, reflectance=share), points, sky, 16)
    apart = np.array(vertices) + [(0.0, 0.0, 1e-6 * (i >= 8)) for i in range(12)]
    for mesh in (ws.Mesh(apart, faces, reflectance=share), ws.Mesh(vertices, faces, reflectance=0.8)):
        ws.irradiance(mesh, points, sky, 16)  # warnings are errors in tests
