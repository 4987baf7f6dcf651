"""`warpsample bake` of irradiation, sun hours and sky matrices: the numbers in the files, and what is refused."""

import json
import re

import numpy as np
import pytest
import trimesh
from weather_files import write_epw

import warpsample as ws
from warpsample.output import bake
from warpsample.radiation.exchange.matrix_files import read_matrix
from warpsample.radiation.quantities.sun_hours import sun_hours
from warpsample.radiation.sky.sky_matrix import sky_matrix
from warpsample.radiation.sun.direct_sun import direct_sun
from warpsample.radiation.weather.light import sun_directions
from warpsample.radiation.weather.weather import read_weather

pytestmark = pytest.mark.slow  # seconds each, and kernels to compile; .ci/run runs them too

pytest.importorskip("pvlib")
pytest.importorskip("pyradiance")


@pytest.fixture(scope="module")
def athens(tmp_path_factory):
    return write_epw(tmp_path_factory.mktemp("weather") / "athens.epw")


@pytest.fixture(scope="module")
def yard():
    return ws.load_mesh("courtyard")


def test_irradiation_of_faces(call, athens, yard, tmp_path, monkeypatch):
    import pyvista as pv

    monkeypatch.setattr(bake, "RAYS_PER_PART", 64 * 1000)  # several parts
    output = tmp_path / "year.vtp"
    given = ["--weather", athens, "--period", "06-21", "06-22", "--ground-albedo", 0.5, "--north", 1, 1, 0]
    where = ["--at", "faces", "--samples", 64, "--patches", "tregenza", "--seed", 2]
    status, out, err = call("bake", "courtyard", "-o", output, "--quantity", "irradiation", *given, *where)
    assert (status, err) == (0, "")
    right = ws.irradiation(
        yard,
        ws.face_centers(yard),
        athens,
        ground_albedo=0.5,
        period=("06-21", "06-22"),
        patches="tregenza",
        count=64,
        north=(1, 1, 0),
        seed=2,
    )
    found = pv.read(output).cell_data
    for name in ("value", "standard_error", "direct", "diffuse", "ground", "rays", "status"):
        assert np.array_equal(found[name], getattr(right, name)), name
    first, second, third, fourth, fifth, *_ = out.splitlines()
    assert first == f"{output}: irradiation of 2,080 faces"
    ends = f"from {right.value.min():.4g} to {right.value.max():.4g}"
    assert second.startswith(f"  mean {right.value.mean():.4f} kWh/m2, {ends}; standard error ")
    assert third.startswith(f"  {right.rays.sum():,} rays cast in ")
    skipped = right.skipped
    assert re.fullmatch(r"  took \d+\.\d\d s, with reading, compiling and writing", fourth)
    assert fifth == f"  sky patches known without rays: {skipped.open_patches:,} open, {skipped.closed_patches:,} covered"


def test_irradiation_in_columns_and_by_default_of_the_year(call, yard, tmp_path):
    output = tmp_path / "year.csv"
    call("bake", "courtyard", "-o", output, "--quantity", "irradiation", "--weather", "athens", "--points", 9)
    table = np.genfromtxt(output, delimiter=",", names=True)
    names = ("irradiation_kwh_m2", "irradiation_kwh_m2_error", "direct_kwh_m2", "diffuse_kwh_m2", "ground_kwh_m2")
    assert table.dtype.names[3:8] == names
    right = ws.irradiation(yard, ws.sample_surface(yard, 9), "athens")
    np.testing.assert_allclose(table[names[0]], right.value, rtol=1e-6)


def test_irradiation_of_a_city_with_its_sums(call, athens, tmp_path):
    """By the surfaces' areas, with errors; the year's numbers are those of the calls that `bake` makes."""
    given = ["--weather", athens, "--period", "06-21", "06-22", "--samples", 64, "--patches", "tregenza", "--points", 900]
    path = tmp_path / "yard.city.json"
    path.write_bytes(ws.load_city("courtyard").content)
    for name in ("out.city.json", "out.csv"):
        assert call("bake", path, "-o", tmp_path / name, "--quantity", "irradiation", "--lod", "1", *given)[0] == 0
    city = ws.load_city(path)
    points = city.points(900)
    options = {"period": ("06-21", "06-22"), "patches": "tregenza", "count": 64}
    right = ws.irradiation(city.mesh, points, athens, **options)
    values, errors, areas = city.surface_means(right.value, right.standard_error, points=points)
    table = np.genfromtxt(tmp_path / "out.csv", delimiter=",", names=True, dtype=None, encoding="utf-8")
    for name, column in (("_m2", values), ("_m2_error", errors), ("", values * areas), ("_error", errors * areas)):
        assert table[f"irradiation_kwh{name}"] == pytest.approx(column, rel=1e-6), name
    ground, buildings = json.loads((tmp_path / "out.city.json").read_text())["CityObjects"].values()
    assert ground["attributes"]["ws_irradiation_kwh"] == pytest.approx((values * areas)[0], rel=1e-6)
    assert buildings["attributes"]["ws_irradiation_kwh_wall"] == pytest.approx((values * areas)[2], rel=1e-6)
    assert buildings["attributes"]["ws_irradiation_kwh_m2_error_roof"] == pytest.approx(errors[1], rel=1e-6)


def test_sun_hours_of_points(call, athens, yard, tmp_path):
    output = tmp_path / "hours.npz"
    where = ["--weather", athens, "--period", "03-21T06", "03-21T20", "--up", 0, 1, 0, "--north", 0, 0, -1]
    status, out, _ = call("bake", "courtyard", "-o", output, "--quantity", "sun-hours", "--points", 50, *where)
    weather = read_weather(athens, ("03-21T06", "03-21T20"))
    axes = np.array([[1.0, 0, 0], [0, 0, -1], [0, 1, 0]])
    suns = sun_directions(weather.chosen(weather.sun_altitude > 0.0), axes)
    assert len(suns) == 13  # of the 14 hours
    points = ws.sample_surface(yard, 50)
    right = direct_sun(yard, points, suns).sum(axis=1)
    with np.load(output) as file:
        assert np.array_equal(file["value"], right)
        assert not file["standard_error"].any()
        assert 0.0 < right.mean() < 13.0
    found = sun_hours(yard, points, athens, period=("03-21T06", "03-21T20"), up=(0, 1, 0), north=(0, 0, -1))
    assert np.array_equal(found.to_polydata(points)["value"], right)
    assert status == 0
    assert out.splitlines()[:2] == [
        f"{output}: sun hours of 50 points",
        f"  mean {right.mean():.4f} h, from {right.min():.4g} to {right.max():.4g}",
    ]


def test_shades_of_what_is_more_than_1_are_of_the_largest(call, tmp_path):
    """Two floors, one under a roof that keeps the sun off it but for the first and the last hours."""
    path, output = tmp_path / "floors.off", tmp_path / "out.ply"
    path.write_text(
        "OFF\n9 3 0\n0 0 0\n1 0 0\n0 1 0\n90 0 0\n91 0 0\n90 1 0\n-1 -1 0.9\n3 -1 0.9\n-1 3 0.9\n3 0 1 2\n3 3 4 5\n3 6 7 8\n"
    )
    given = ["--quantity", "sun-hours", "--weather", "athens", "--period", "06-21", "06-21", "--at", "faces"]
    assert call("bake", path, "-o", output, *given)[0] == 0
    data = trimesh.load(output, process=False).metadata["_ply_raw"]["face"]["data"]
    hours = data["value"].ravel()
    assert hours[0] != hours[1] == hours.max() > 1.0
    assert np.array_equal(data["red"].ravel(), np.round(255.0 * hours / hours.max()))


def test_sun_hours_of_a_night_are_0(call, tmp_path):
    output = tmp_path / "night.csv"
    night = ["--weather", "athens", "--period", "01-01T00", "01-01T03"]
    assert call("bake", "courtyard", "-o", output, "--quantity", "sun-hours", *night)[0] == 0
    assert not np.genfromtxt(output, delimiter=",", names=True)["sun_hours_h"].any()


def test_points_without_a_normal_have_no_sun_hours(call, athens, tmp_path):
    path, output = tmp_path / "flawed.off", tmp_path / "out.csv"
    path.write_text("OFF\n3 2 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n3 0 1 1\n")
    given = ["--quantity", "sun-hours", "--weather", athens, "--period", "06-21T12", "06-21T13", "--at", "faces"]
    _, out, _ = call("bake", path, "-o", output, *given)
    assert out.endswith("points without a value: 1 zero_normal\n")
    table = np.genfromtxt(output, delimiter=",", names=True)
    assert (table["sun_hours_h"].tolist(), table["status"].tolist()) == ([1.0, 0.0], [0.0, 2.0])


def test_a_sky_matrix_with_its_directions_and_for_radiance(call, yard, tmp_path, monkeypatch):
    monkeypatch.setattr(bake, "RAYS_PER_PART", 64 * 10)  # several parts
    given = ["--quantity", "sky-matrix", "--points", 25, "--samples", 64, "--patches", "reinhart2", "--seed", 3]
    right = sky_matrix(yard, ws.sample_surface(yard, 25, seed=3), 64, patches="reinhart2", seed=3)
    for name in ("sky.npz", "sky.mtx"):
        status, out, err = call("bake", "courtyard", "-o", tmp_path / name, *given)
        assert (status, err) == (0, "")
        assert out.startswith(f"{tmp_path / name}: sky matrix of 25 points\n")
    with np.load(tmp_path / "sky.npz") as file:
        for name in ("value", "standard_error", "rays", "status"):
            assert np.array_equal(file[name], getattr(right, name)), name
        assert np.array_equal(file["directions"], right.patches.directions)
        assert np.array_equal(file["solid_angles"], right.patches.solid_angles)
        assert file["position"].shape == (25, 3)
    right.save(tmp_path / "saved.mtx")
    assert (tmp_path / "sky.mtx").read_bytes() == (tmp_path / "saved.mtx").read_bytes()
    assert read_matrix((tmp_path / "sky.mtx").read_bytes()).shape == (25, 578, 3)


def test_a_sky_matrix_that_does_not_fit_is_refused(call, tmp_path, monkeypatch):
    monkeypatch.setattr("psutil.virtual_memory", lambda: type("Memory", (), {"available": 1 << 20}))
    status, _, err = call(
        "bake", "courtyard", "-o", tmp_path / "sky.mtx", "--quantity", "sky-matrix", "--patches", "reinhart4"
    )
    assert status == 2
    assert err.startswith("error: 1,089 rows of 2,305 patches and their errors need")


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (
            ["-o", "x.ply", "--quantity", "sky-matrix"],
            "--output: got 'x.ply' for sky-matrix, want a file that ends in one of .npz .mtx",
        ),
        (["-o", "x.mtx"], "--output: got 'x.mtx' for ao, want a file that ends in one of .ply .vtp .glb .npz .csv"),
        (["-o", "x.csv", "--quantity", "irradiation"], "--weather: got None for irradiation, want an EPW weather file"),
        (["-o", "x.csv", "--quantity", "sun-hours"], "--weather: got None for sun-hours, want an EPW weather file"),
        (
            ["-o", "x.csv", "--weather", "a.epw"],
            "--weather: got a.epw for ao; the option applies only to irradiation and sun-hours",
        ),
        (["-o", "x.csv", "--quantity", "irradiation", "--weather", "no.epw"], "--weather: got 'no.epw', which is missing"),
        (
            ["-o", "x.csv", "--quantity", "irradiation", "--weather", "bad.epw"],
            "--weather: got 'bad.epw', which cannot be read",
        ),
        (["-o", "bad.epw", "--quantity", "sun-hours", "--weather", "bad.epw"], "--output: got 'bad.epw', want"),
        (
            ["-o", "x.csv", "--period", "06-01", "06-02"],
            "--period: got ('06-01', '06-02') for ao; the option applies only to",
        ),
        (
            ["-o", "x.csv", "--quantity", "sun-hours", "--weather", "athens", "--period", "02-29", "03-01"],
            "--period: got ('02-29', '03-01'), want two days",
        ),
        (
            ["-o", "x.csv", "--quantity", "irradiation", "--weather", "athens", "--ground-albedo", "2"],
            "--ground-albedo: got 2.0, want a number from 0 to 1",
        ),
        (["-o", "x.mtx", "--quantity", "sky-matrix", "--patches", "klems"], "--patches: got 'klems', want one of"),
        (["-o", "x.mtx", "--quantity", "sky-matrix", "--north", "0", "0", "1"], "--north: got (0.0, 0.0, 1.0), which is"),
        (
            ["-o", "x.mtx", "--quantity", "sky-matrix", "--sequence", "sobol"],
            "--sequence: got sobol for sky-matrix; the option applies only to",
        ),
    ],
)
def test_bad_input_is_one_line(call, cube, tmp_path, monkeypatch, arguments, message):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "bad.epw").write_text("x\n")
    status, out, err = call("bake", cube, *arguments)
    assert (status, out) == (2, "")
    assert err.startswith(f"error: {message}")
    assert err.count("\n") == 1
    assert set(tmp_path.iterdir()) == {cube, tmp_path / "bad.epw"}
