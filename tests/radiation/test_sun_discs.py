"""Discs of suns: the share that is seen, by formula, and the same whatever is skipped."""

import numpy as np
import pytest
from sun_cases import at, mesh_of, mixed, plane_and, unit, upright, year

import warpsample as ws

pytestmark = pytest.mark.slow  # seconds each, and kernels to compile; .ci/run runs them too

ERROR = 0.037  # of a disc's share, where an edge cuts it


def test_half_of_a_disc_behind_an_edge():
    mesh = plane_and(upright((-90.0, 0.0), (0.0, 90.0), 40.0))  # its edge is at y = 0
    place = np.column_stack([np.zeros(600), np.zeros(600), np.linspace(0.0, 0.5, 600)])
    sun = unit([[40.0, 0.0, 10.0]])
    shares = ws.direct_sun(mesh, at(place), sun, disc=0.533)
    assert shares.dtype == np.float32
    assert abs(shares.mean(dtype=np.float64) - 0.5) < 4.0 * ERROR / np.sqrt(600)
    assert np.sqrt(np.mean((shares.astype(np.float64) - 0.5) ** 2)) < 1.3 * ERROR
    assert not np.array_equal(shares, ws.direct_sun(mesh, at(place), sun, disc=0.533, seed=1))
    twice = ws.direct_sun(mesh, at(place), np.concatenate([sun, sun]), disc=0.533).astype(np.float64)
    assert np.array_equal(twice[:, :1], shares)
    assert abs(np.corrcoef(twice.T)[0, 1]) < 0.2  # each sun has rays of its own


def test_a_disc_cut_anywhere():
    mesh = plane_and(upright((-90.0, 0.0), (0.0, 90.0), 40.0))
    radius, h = np.radians(5.0), np.linspace(-1.3, 1.3, 27)  # in radii, to the side that is free
    up, free = unit([40.0, 0.0, 10.0]), np.array([0.0, 1.0, 0.0])
    suns = np.cos(h * radius)[:, None] * up + np.sin(h * radius)[:, None] * free
    shares = ws.direct_sun(mesh, at(np.zeros((400, 3))), suns, disc=10.0).astype(np.float64)
    x = np.clip(-h, -1.0, 1.0)
    area = (np.arccos(x) - x * np.sqrt(1.0 - x * x)) / np.pi  # of a flat disc: the cap's differs by the square of its radius
    error = shares - area
    assert np.abs(error.mean(axis=0)).max() < 4.0 * ERROR / np.sqrt(400) + radius**2 / 4.0
    assert np.sqrt(np.mean(np.square(error[:, np.abs(h) < 1.0]))) < 1.3 * ERROR
    assert (shares[:, h > 1.01] == 1.0).all()
    assert (shares[:, h < -1.01] == 0.0).all()


@pytest.mark.parametrize("height", [0.0, 5.0])
def test_what_of_a_disc_is_below_the_horizon_is_dark(height):
    """On the ground, which blocks it, and above all there is."""
    mesh = plane_and() if height == 0.0 else ws.as_mesh(upright((-1.0, 0.0), (1.0, 1.0)))
    place = np.tile([0.0, 0.0, height], (300, 1))
    angle = np.radians([-0.1, 1e-3, 0.1, 0.26, 0.27, 10.0])
    suns = np.column_stack([np.cos(angle), np.zeros(6), np.sin(angle)])
    shares = ws.direct_sun(mesh, at(place), suns, disc=0.533).astype(np.float64)
    assert (shares[:, 0] == 0.0).all()
    x = -np.degrees(angle[1:4]) / 0.2665
    area = (np.arccos(x) - x * np.sqrt(1.0 - x * x)) / np.pi
    assert np.abs(shares[:, 1:4].mean(axis=0) - area).max() < 4.0 * ERROR / np.sqrt(300)
    assert (shares[:, 4:] == 1.0).all()


@pytest.mark.parametrize("name", ["city", "hostile"])
def test_discs_are_the_same_without_skipping(bunny, name):
    mesh, suns = mesh_of(name, bunny), np.concatenate([year(40), mixed(np.random.default_rng(8), 60)])
    points = ws.sample_surface(mesh, 60, seed=5)
    sharp = ws.direct_sun(mesh, points, suns)
    for disc in (1e-6, 0.533, 20.0):
        skipping, plain = (ws.direct_sun(mesh, points, suns, disc=disc, skip=skip) for skip in (True, False))
        assert np.array_equal(skipping, plain)
        assert (skipping >= 0.0).all()
        assert (skipping <= 1.0).all()
        if disc < 1.0:
            assert np.abs(skipping.astype(np.float64) - sharp).mean() < 0.02
            assert ((skipping > 0.0) & (skipping < 1.0)).mean() < 0.05
