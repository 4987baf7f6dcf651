"""Means over surfaces in light that faces reflect: errors that points share do not average out."""

import csv
import json

import city_files as cases
import numpy as np
import pytest

import warpsample as ws
from warpsample.city.cityjson.city import write_columns
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


def walls_of(path):
    """Return the mean and the error of each building's walls in a CityJSON file."""
    objects = json.loads(path.read_text(encoding="utf-8"))["CityObjects"].values()
    names = ("ws_irradiation_kwh_m2_wall", "ws_irradiation_kwh_m2_error_wall")
    return np.array([[thing["attributes"][name] for name in names] for thing in objects])


def test_errors_of_objects_contain_the_light_that_their_surfaces_share(city, call, tmp_path):
    """The variances of the runs' means over an object, and of the surfaces without the part that the runs explain."""
    mesh, points = ws.as_mesh(city.mesh, reflectance=0.8), city.points(4000)
    light = ws.irradiation(mesh, points, "athens", count=16, refine=5.0, **DAY)
    city.write(tmp_path / "a.city.json", {"ws_irradiation_kwh_m2": light}, points=points)
    found = walls_of(tmp_path / "a.city.json")
    value, error, area = city.surface_means(light, points=points)
    runs = np.array([city.surface_means(light.reflected_runs[:, 0, r], points=points)[0] for r in range(8)])
    for row, name in enumerate("abcd"):
        held = (city.surfaces.object == name) & (city.surfaces.type == "WallSurface")
        share = area[held] / area[held].sum()
        own = np.square(error[held]) - runs[:, held].var(axis=0, ddof=1) / 8
        right = np.square(share) @ own + (runs[:, held] @ share).var(ddof=1) / 8
        assert found[row] == pytest.approx([share @ value[held], np.sqrt(right)], rel=1e-5)
    day = ["--weather", "athens", "--period", "06-21", "06-21", "--patches", "tregenza", "--refine", "5"]
    given = ["--quantity", "irradiation", "--samples", 16, "--reflectance", "0.8", "--split", "--points", 4000, *day]
    assert call("bake", city.path, "-o", tmp_path / "b.city.json", *given)[0] == 0
    assert walls_of(tmp_path / "b.city.json") == pytest.approx(found, rel=1e-5)


def test_an_error_that_all_surfaces_share_is_that_of_their_object(city, tmp_path):
    """With independent surfaces it would be less: 0.6 times as much for walls whose areas are 1.5, 5, 1.5 and 5 parts."""
    wave = np.arange(8.0) - 3.5
    shared, own = np.sqrt(wave.var(ddof=1) / 8), 0.3
    count = len(city.surfaces)
    columns = {"a_m2": np.ones(count), "a_m2_error": np.full(count, np.hypot(shared, own))}
    write_columns(city, tmp_path / "a.city.json", columns, {"a_m2": np.tile(1.0 + wave[:, None], count)})
    attributes = json.loads((tmp_path / "a.city.json").read_text(encoding="utf-8"))["CityObjects"]["a"]["attributes"]
    share = np.array([1.5, 5.0, 1.5, 5.0]) / 13.0
    right = np.sqrt(shared**2 + own**2 * np.square(share).sum())
    assert attributes["a_m2_error_wall"] == pytest.approx(right, rel=1e-6)
    assert attributes["a_error_wall"] == pytest.approx(right * 2 * (6 + 20) * 15, rel=1e-6)


def test_a_result_is_written_as_its_means(city, tmp_path):
    points = city.points(4000)
    sky = ws.sky_view_factor(city.mesh, points, 16)
    mean, error, _ = city.surface_means(sky, points=points)
    city.write(tmp_path / "a.city.json", {"sky": sky}, points=points)
    city.write(tmp_path / "b.city.json", {"sky": mean, "sky_error": error})
    assert (tmp_path / "a.city.json").read_bytes() == (tmp_path / "b.city.json").read_bytes()
    with pytest.raises(ValueError, match="results: got 'sky_error' for a result, want 'sky' alone"):
        city.write(tmp_path / "c.city.json", {"sky": sky, "sky_error": error}, points=points)
    with pytest.raises(ValueError, match=r"results\['sky'\]: got shape \(3996,\), want \(40,\), one for each point"):
        city.write(tmp_path / "c.city.json", {"sky": sky})


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
