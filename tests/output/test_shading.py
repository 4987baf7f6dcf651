"""`warpsample shading`: the sunlit shares of surfaces for EnergyPlus, by the sun's angles, and what is refused."""

import numpy as np
import pytest
import trimesh
from weather_files import write_epw

from warpsample.radiation.weather.epw import YEAR
from warpsample.radiation.weather.weather import read_weather

pytestmark = pytest.mark.slow  # seconds each, and kernels to compile; .ci/run runs them too

pytest.importorskip("pvlib")

# A floor of 2 by 1 whose eastern half is a surface of its own, and a wall of height 1 along its east side, seen from both.
CORNERS = [[0, 0, 0], [1, 0, 0], [2, 0, 0], [0, 1, 0], [1, 1, 0], [2, 1, 0], [2, 0, 1], [2, 1, 1]]
QUADS = {"west": (0, 1, 4, 3), "east": (1, 2, 5, 4), "inner": (2, 6, 7, 5), "outer": (2, 5, 7, 6)}


@pytest.fixture(scope="module")
def athens(tmp_path_factory):
    return write_epw(tmp_path_factory.mktemp("weather") / "athens.epw")


@pytest.fixture
def made(tmp_path):
    """A mesh file and its groups."""
    faces = [[quad[i] for i in corners] for quad in QUADS.values() for corners in ((0, 1, 2), (0, 2, 3))]
    mesh, groups = tmp_path / "wall.off", tmp_path / "groups.txt"
    mesh.write_text("\n".join(["OFF", f"8 {len(faces)} 0", *(" ".join(map(str, c)) for c in CORNERS)]))
    mesh.write_text(mesh.read_text() + "\n" + "\n".join(" ".join(map(str, [3, *face])) for face in faces) + "\n")
    groups.write_text("".join(f"{name}\n{name}\n" for name in QUADS))
    return mesh, groups


def test_the_shares_are_those_of_the_wall_s_shadow(call, athens, made, tmp_path):
    output = tmp_path / "shading.csv"
    status, out, err = call("shading", *made, "-o", output, "--weather", athens, "--samples", 1024)
    assert (status, err) == (0, "")
    assert out.startswith(f"{output}: 4 surfaces, 8,760 hours; standard error 0.00")
    head, *rows = [line.split(",") for line in output.read_text().splitlines()]
    assert head == ["Surface Name", *QUADS]
    assert [row[0] for row in rows] == [f"{month:02}/{day:02} {hour:02}:00" for month, day, hour in YEAR]
    share = dict(zip(head[1:], np.array([row[1:] for row in rows], float).T, strict=True))
    weather = read_weather(athens)
    level = np.cos(weather.sun_altitude)
    east, north, height = (
        level * np.sin(weather.sun_azimuth),
        level * np.cos(weather.sun_azimuth),
        np.sin(weather.sun_altitude),
    )
    up = height > 0.0
    assert not any(column[~up].any() for column in share.values())
    assert np.array_equal(share["outer"] > 0.5, up & (east > 0.0))  # nothing is before it
    assert np.array_equal(share["inner"] > 0.5, up & (east < 0.0))
    assert (share["west"][up & (east < 0.0)] == 1.0).all()
    # In the morning the wall's shadow reaches 1 / tan of the altitude to the west, and is shifted along the wall.
    morning = np.flatnonzero((height > 0.1) & (east > 0.1))
    assert len(morning) > 1000
    reach = np.clip(east[morning] / height[morning], 0.0, 1.0)
    along = np.abs(north / east)[morning]
    dark = reach - np.minimum(along, 1.0 / reach) * np.square(reach) / 2.0
    whole = reach * along <= 1.0
    assert np.abs(1.0 - dark - share["east"][morning])[whole].max() < 0.08
    assert np.abs((1.0 - dark - share["east"][morning])[whole].mean()) < 0.02


@pytest.mark.parametrize(
    ("lines", "message"),
    [
        (["a"] * 7, "of 7 lines, want 8 lines, each with the name of its triangle's surface"),
        ([*["a"] * 7, "b,c"], "with the name 'b,c', want names without commas and quotes"),
        ([*["a"] * 7, " "], "with the name '', want names without commas and quotes"),
    ],
)
def test_wrong_groups_are_a_sentence(call, athens, made, tmp_path, lines, message):
    mesh, groups = made
    groups.write_text("\n".join(lines) + "\n")
    status, out, err = call("shading", mesh, groups, "-o", tmp_path / "x.csv", "--weather", athens)
    assert (status, out) == (2, "")
    assert err == f"error: groups: got {str(groups)!r} {message}\n"
    assert not (tmp_path / "x.csv").exists()


def test_a_surface_without_area_is_a_sentence(call, athens, tmp_path):
    mesh, groups = tmp_path / "flat.off", tmp_path / "groups.txt"
    mesh.write_text("OFF\n3 2 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n3 0 1 1\n")
    groups.write_text("a\nb\n")
    err = call("shading", mesh, groups, "-o", tmp_path / "x.csv", "--weather", athens)[2]
    assert (
        err
        == f"error: groups: got {str(groups)!r} with the surface 'b', whose triangles have no area, want an area above 0\n"
    )


@pytest.mark.parametrize(
    ("options", "message"),
    [
        (["-o", "x.txt"], "--output: got 'x.txt', want a file that ends in .csv"),
        (["-o", "x.csv", "--samples", "0"], "--samples: got 0, want a whole number from 1"),
        (["-o", "x.csv", "--north", "0", "0", "1"], "--north: got (0.0, 0.0, 1.0), which is along up"),
        (["-o", "x.csv", "--weather", "no.epw"], "--weather: got 'no.epw', which is missing"),
    ],
)
def test_bad_input_is_one_line(call, made, tmp_path, monkeypatch, options, message):
    monkeypatch.chdir(tmp_path)
    status, out, err = call("shading", *made, "--weather", "athens", *options)
    assert (status, out) == (2, "")
    assert err.startswith(f"error: {message}")
    assert err.count("\n") == 1


def test_a_box_is_lit_from_above(call, tmp_path):
    mesh, groups, output = tmp_path / "box.off", tmp_path / "groups.txt", tmp_path / "x.csv"
    box = trimesh.creation.box()
    box.export(mesh)
    names = {1.0: "roof", -1.0: "floor", 0.0: "wall"}
    groups.write_text("".join(f"{names[round(z, 3) + 0.0]}\n" for z in box.face_normals[:, 2]))
    call("shading", mesh, groups, "-o", output, "--weather", "athens", "--samples", 16)
    table = np.genfromtxt(output, delimiter=",", names=True, encoding="utf-8")
    up = read_weather("athens").sun_altitude > 0.0
    assert np.array_equal(table["roof"] == 1.0, up)
    assert not table["floor"].any()
