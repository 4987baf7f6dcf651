"""Means over surfaces in light that faces reflect: errors that points share do not average out."""

import csv

import city_files as cases
import numpy as np
import pytest

import warpsample as ws
from warpsample.output import bake

pytest.importorskip("pvlib")
pytest.importorskip("pyradiance")

DAY = {"period": ("06-21", "06-21"), "patches": "tregenza"}


def blocks():
    """Two blocks 2 m apart and 15 m high, in a closed yard: walls get most of their light from walls."""
    vertices, solids = [], {}
    for name, (x, y, width, depth) in {
        "a": (0, 0, 6, 20),
        "b": (8, 0, 6, 20),
        "c": (0, -6, 14, 4),
        "d": (0, 22, 14, 4),
    }.items():
        first = len(vertices)
        corners = [(x, y), (x + width, y), (x + width, y + depth), (x, y + depth)]
        vertices += [[1000 * a, 1000 * b, z] for z in (0, 15000) for a, b in corners]
        faces = [[4, 5, 6, 7], *([i, (i + 1) % 4, 4 + (i + 1) % 4, 4 + i] for i in range(4))]
        shape = {"type": "MultiSurface", "lod": "2", "boundaries": [[[first + c for c in face]] for face in faces]}
        solids[name] = {"type": "Building", "geometry": [shape]}
    return cases.house(CityObjects=solids, vertices=vertices)


@pytest.fixture(scope="module")
def city(tmp_path_factory):
    return ws.load_city(cases.written(tmp_path_factory.mktemp("blocks") / "a.city.json", blocks()), split=True)


def test_the_shared_error_of_a_result_is_in_the_error_of_a_mean(city):
    mesh, points = ws.as_mesh(city.mesh, reflectance=0.8), city.points(4000)
    light = ws.irradiation(mesh, points, "athens", count=16, refine=5.0, **DAY)
    assert light.reflected_runs.shape == (len(points), 1, 8)
    np.testing.assert_allclose(light.reflected_runs.mean(axis=(1, 2)), light.reflected, rtol=1e-5)
    value, error, _ = city.surface_means(light, points=points)
    plain = city.surface_means(light.value, light.standard_error, points=points)
    assert np.array_equal(value, plain[0], equal_nan=True)
    between = city.surface_means(light.reflected, points=points)[0] > 0.0  # roofs and outer walls see no face
    assert between.sum() == 8
    assert np.array_equal(error[~between], plain[1][~between])
    assert (error[between] > plain[1][between]).all()


def test_a_table_has_the_same_errors(city, call, tmp_path, monkeypatch):
    monkeypatch.setattr(bake, "part_size", lambda *_: 1000)  # several parts of the points
    day = ["--weather", "athens", "--period", "06-21", "06-21", "--patches", "tregenza", "--refine", "5"]
    given = ["--quantity", "irradiation", "--samples", 16, "--reflectance", "0.8", "--split", "--points", 4000, *day]
    assert call("bake", city.path, "-o", tmp_path / "b.csv", *given)[0] == 0
    with (tmp_path / "b.csv").open(encoding="utf-8", newline="") as file:
        errors = [float(row["irradiation_kwh_m2_error"]) for row in csv.DictReader(file)]
    points = city.points(4000)
    light = ws.irradiation(ws.as_mesh(city.mesh, reflectance=0.8), points, "athens", count=16, refine=5.0, **DAY)
    assert errors == pytest.approx(city.surface_means(light, points=points)[1], rel=1e-5)
    assert call("bake", city.path, "-o", tmp_path / "b.npz", *[g for g in given if g != "--split"])[0] == 0
    with np.load(tmp_path / "b.npz") as arrays:
        assert "reflected" in arrays
        assert "reflected_runs" not in arrays


@pytest.mark.thorough
def test_two_errors_contain_the_means_of_walls_with_many_points(city):
    """By 12 seeds. With errors as of independent points it was 77 % of the walls' means, and 42 % of the worst wall's."""
    mesh, runs = ws.as_mesh(city.mesh, reflectance=0.8), []
    for seed in range(12):
        points = city.points(30_000, seed=seed)
        light = ws.irradiation(mesh, points, "athens", count=16, seed=seed, refine=5.0, **DAY)
        runs.append(city.surface_means(light, points=points)[:2])
    value, error = (np.array(runs)[:, k][:, city.surfaces.type == "WallSurface"] for k in (0, 1))
    away = np.abs(value - (value.sum(axis=0) - value) / 11)
    # 192 values, known to 2 %; seven degrees of freedom cost 4 %.
    assert (away <= 2.0 * error * np.sqrt(12 / 11)).mean() > 0.88
