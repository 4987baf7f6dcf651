"""`warpsample bake` of parts: means over the names that a file has, and over the surfaces of CityJSON."""

import csv
import json

import city_files as cases
import numpy as np
import pytest
import trimesh

import warpsample as ws
from warpsample.estimate.intervals import raised_errors
from warpsample.output import by_parts
from warpsample.output.quantities import quantities


def rows(path):
    with path.open(encoding="utf-8", newline="") as file:
        return list(csv.DictReader(file))


@pytest.fixture
def site(tmp_path):
    """A box on a plate, as objects of an .obj; the second has a comma in its name, and there are faces without one."""
    path = tmp_path / "site.obj"
    box, plate = trimesh.creation.box((2.0, 2.0, 2.0)), trimesh.creation.box((20.0, 20.0, 0.2))
    plate.vertices[:, 2] -= 1.1
    text, first = "", 1
    for name, part in (("box", box), ("plate, low", plate)):
        text += f"o {name}\n" + "".join(f"v {x} {y} {z}\n" for x, y, z in part.vertices.tolist())
        text += "".join(f"f {a} {b} {c}\n" for a, b, c in (part.faces + first).tolist())
        first += len(part.vertices)
    path.write_text(text)
    return path


def test_a_row_for_each_part(call, site, tmp_path):
    output = tmp_path / "out.csv"
    status, out, err = call("bake", site, "-o", output, "--by", "part", "--samples", 32, "--points", 400, "--seed", 2)
    assert (status, err) == (0, "")
    assert out.startswith(f"{output}: ambient occlusion of ")
    box, plate = rows(output)
    assert list(box) == ["part", "faces", "area_m2", "ambient_occlusion", "ambient_occlusion_error"]
    assert (box["part"], plate["part"]) == ("box", "plate, low")
    assert (float(box["area_m2"]), float(plate["area_m2"])) == pytest.approx((24.0, 816.0))
    # A wall on a wide plate sees half; top and bottom of the box are open and closed: 4 of 6 sides half, one 1, one 0.
    assert float(box["ambient_occlusion"]) == pytest.approx(0.5, abs=4 * float(box["ambient_occlusion_error"]) + 0.03)
    assert 0.9 < float(plate["ambient_occlusion"]) < 1.0
    assert 0.0 < float(box["ambient_occlusion_error"]) < 0.1


def test_at_the_centres_of_faces_it_is_their_mean_by_area(call, site, tmp_path):
    call("bake", site, "-o", tmp_path / "out.csv", "--by", "part", "--at", "faces", "--samples", 32)
    mesh = ws.load_mesh(site)
    right = ws.ambient_occlusion(mesh, ws.face_centers(mesh), 32)
    for number, row in enumerate(rows(tmp_path / "out.csv")):
        inside = mesh.part == number
        weights = mesh.face_areas[inside] / mesh.face_areas[inside].sum()
        assert float(row["ambient_occlusion"]) == pytest.approx((weights * right.value[inside]).sum(), rel=1e-6)
        unseen = weights * raised_errors(right)[inside]  # at a large face all rays agree
        error = max(np.sqrt(np.square(weights * right.standard_error[inside]).sum()), unseen.max())
        assert float(row["ambient_occlusion_error"]) == pytest.approx(error, rel=1e-6)


def test_cityjson_gets_attributes_or_a_table(call, tmp_path):
    path, output = cases.written(tmp_path / "a.city.json", cases.house()), tmp_path / "b.city.json"
    given = ["--quantity", "sky", "--samples", 64, "--points", 600]
    assert call("bake", path, "-o", output, *given)[0] == 0
    made = json.loads(output.read_text())
    assert cases.unmarked(made) == cases.unmarked(cases.house())
    ground, roof, wall = made["CityObjects"]["house"]["geometry"][0]["semantics"]["surfaces"]
    assert ground == {"type": "GroundSurface"}
    assert roof["ws_sky_view_factor"] == 1.0
    # 200 m2 see half of the sky's lobe, and 40 m2 in the shaft of 2 x 2 x 5 m next to nothing: less than 10 %.
    assert 0.40 < wall["ws_sky_view_factor"] < 0.44
    found = made["CityObjects"]["house"]["attributes"]
    assert found["ws_sky_view_factor_wall"] == wall["ws_sky_view_factor"]
    assert found["ws_sky_view_factor_error_wall"] == wall["ws_sky_view_factor_error"] > 0.0
    assert call("bake", path, "-o", tmp_path / "b.csv", *given)[0] == 0
    table = {row["type"]: row for row in rows(tmp_path / "b.csv")}
    assert table["GroundSurface"]["sky_view_factor"] == ""
    assert float(table["WallSurface"]["sky_view_factor"]) == pytest.approx(wall["ws_sky_view_factor"], rel=1e-6)
    assert table["RoofSurface"] | {"object": "house", "lod": "2.2", "faces": "1", "area_m2": "96"} == table["RoofSurface"]


def test_a_picture_of_cityjson_shows_the_means_of_its_surfaces(call, tmp_path, monkeypatch, can_render):
    shown = []
    monkeypatch.setattr(by_parts, "draw_picture", lambda _baked, of_faces: shown.append(of_faces) or b"a picture")
    path = cases.written(tmp_path / "a.city.json", cases.house())
    given = ["--quantity", "sky", "--samples", 64, "--points", 600]
    assert call("bake", path, "-o", tmp_path / "b.png", *given)[0] == 0
    assert (tmp_path / "b.png").read_bytes() == b"a picture"
    assert call("bake", path, "-o", tmp_path / "b.csv", *given)[0] == 0
    table = {row["type"]: row["sky_view_factor"] for row in rows(tmp_path / "b.csv")}
    wall, roof = np.unique(shown[0][np.isfinite(shown[0])])  # none of the GroundSurface
    assert (wall, roof) == (pytest.approx(float(table["WallSurface"]), rel=1e-6), 1.0)


def test_options_of_cityjson(call, tmp_path):
    low = {"type": "Solid", "lod": 1, "boundaries": [cases.FACES[:6]]}
    path, plane = cases.written(tmp_path / "a.json", cases.house(cases.SOLID, low)), tmp_path / "plane.obj"
    plane.write_text("v 80000 440000 -2\nv 90000 440000 -2\nv 90000 450000 -2\nv 80000 450000 -2\nf 1 2 3 4\n")
    given = ["--samples", 32, "--points", 300]
    assert call("bake", path, "-o", tmp_path / "b.csv", "--lod", "1", "--split", "--context", plane, *given)[0] == 0
    found = rows(tmp_path / "b.csv")
    assert [row["lod"] for row in found] == ["1"] * 6
    walls = [float(row["ambient_occlusion"]) for row in found if row["type"] == "WallSurface"]
    assert np.mean(walls) == pytest.approx(0.5, abs=0.05)  # on a plane; without it they are open
    assert call("bake", path, "-o", tmp_path / "b.csv", "--lod", "1", *given)[0] == 0
    assert {row["ambient_occlusion"] for row in rows(tmp_path / "b.csv")} == {"", "1"}
    assert call("bake", path, "-o", tmp_path / "b.ply", "--at", "faces", *given[:2])[0] == 0
    assert len(ws.load_mesh(tmp_path / "b.ply").faces) == len(ws.load_city(path).mesh.faces)


def test_terrain_around_a_city_may_be_a_raster(call, tmp_path):
    """Of one height, 2 m below the house, so that the walls see half of their lobe, and a bit between."""
    rasterio = pytest.importorskip("rasterio")
    where = {"transform": rasterio.Affine(50, 0, 83000, 0, -50, 448000), "crs": "EPSG:28992"}
    with rasterio.open(tmp_path / "dtm.tif", "w", width=80, height=80, count=1, dtype="float32", **where) as file:
        file.write(np.full((1, 80, 80), -3.5, np.float32))
    system = {"metadata": {"referenceSystem": "EPSG:28992"}}
    path = cases.written(tmp_path / "a.json", cases.house(cases.surfaces(boundaries=cases.FACES[:6]), **system))
    given = ["--samples", 32, "--points", 300, "--split", "--context", tmp_path / "dtm.tif"]
    status, _, err = call("bake", path, "-o", tmp_path / "b.csv", *given)
    assert (status, err) == (0, "")
    walls = [float(row["ambient_occlusion"]) for row in rows(tmp_path / "b.csv") if row["type"] == "WallSurface"]
    assert np.mean(walls) == pytest.approx(0.5, abs=0.05)


@pytest.mark.slow  # kernels of reflected light
def test_terrain_reflects_and_transmits_no_light(call, tmp_path):
    """A number applied to it, too: walls of one house received a quarter more light than without a reflectance."""
    path = cases.written(tmp_path / "a.json", cases.house(cases.surfaces(boundaries=cases.FACES[:6])))
    given = ["--samples", 64, "--points", 300, "--context", "ground"]
    day = ["--quantity", "irradiation", "--weather", "athens", "--period", "06-21", "06-21", "--patches", "tregenza"]
    for options, optics in ((day, "--reflectance"), ([], "--transmittance")):
        for name, more in (("b.csv", ()), ("c.csv", (optics, 0.5))):
            assert call("bake", path, "-o", tmp_path / name, *given, *options, *more)[0] == 0
        column = "irradiation_kwh_m2" if options else "ambient_occlusion"
        black, shown = ([float(row[column] or 0.0) for row in rows(tmp_path / name)] for name in ("b.csv", "c.csv"))
        assert shown == pytest.approx(black, rel=1e-6)
        assert max(black) > 0.0


def test_a_warning_about_the_raster_names_context(call, tmp_path):
    """Not "source", which is the city."""
    pytest.importorskip("rasterio")
    rows_of_heights = "\n".join([" ".join(["-3.5"] * 40)] * 40)
    header = "ncols 40\nnrows 40\nxllcorner 83000\nyllcorner 446000\ncellsize 50\n"
    (tmp_path / "dtm.asc").write_text(header + rows_of_heights)
    system = {"metadata": {"referenceSystem": "EPSG:28992"}}
    path = cases.written(tmp_path / "a.json", cases.house(cases.surfaces(boundaries=cases.FACES[:6]), **system))
    with pytest.warns(UserWarning, match=r"^context: got '.*dtm\.asc' without a CRS"):
        status = call("bake", path, "-o", tmp_path / "b.csv", "--samples", 4, "--context", tmp_path / "dtm.asc")[0]
    assert status == 0


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["cube.ply", "-o", "x.csv", "--by", "part"], "--by: got part for 'cube.ply', which has no named parts"),
        (["cube.ply", "-o", "x.ply", "--by", "part"], "--by: got part for x.ply; the option applies only to .csv"),
        (
            ["cube.ply", "-o", "x.csv", "--by", "part", "--at", "vertices"],
            "--at: got vertices for means over parts, want faces",
        ),
        (["cube.ply", "-o", "x.csv", "--split"], "--split: got True for cube.ply; the option applies only to CityJSON"),
        (["cube.ply", "-o", "x.csv", "--lod", "2"], "--lod: got 2 for cube.ply; the option applies only to CityJSON"),
        (["cube.ply", "-o", "x.json"], "--output: got 'x.json', want a file that ends in one of .ply"),
        (["a.json", "-o", "x.csv", "--lod", "high"], "--lod: got 'high', want a level of detail, such as 2.2"),
        (
            ["a.json", "-o", "x.csv", "--lod", "3"],
            "--lod: got 3, want a level of detail with surfaces in 'a.json': 2.2",
        ),
        (["a.json", "-o", "x.jsonl"], "--output: got 'x.jsonl' for 'a.json', want a file that ends in .json, too"),
        (
            ["a.json", "-o", "x.csv", "--quantity", "sky-matrix"],
            "--output: got 'x.csv' for sky-matrix, want a file",
        ),
        (["a.json", "-o", "x.csv", "--context", "no.obj"], "path: got 'no.obj', which is missing, want a mesh file"),
        (["a.json", "-o", "x.csv", "--context", "no.tif"], "--context: got 'no.tif', which is missing, want the path"),
        (["a.json", "-o", "x.csv", "--at", "vertices"], "--at: got vertices for means over parts, want faces, or --points"),
        (["a.json", "-o", "x.csv", "--points", "0"], "--points: got 0, want a whole number from 1"),
        (["a.json", "-o", "a.json"], "--output: got 'a.json', which is the input"),
        (
            ["a.json", "-o", "x.zarr"],
            "--output: got 'x.zarr' for CityJSON, want a file that ends in one of .json .jsonl .ply .vtp",
        ),
        (
            ["cube.ply", "-o", "x.zarr", "--by", "part"],
            "--by: got part for x.zarr; the option applies only to .csv",
        ),
    ],
)
def test_bad_input_is_one_line(call, cube, tmp_path, monkeypatch, arguments, message):
    if "x.zarr" in arguments:
        pytest.importorskip("zarr")
    monkeypatch.chdir(tmp_path)
    path = cases.written(tmp_path / "a.json", cases.house())
    status, out, err = call("bake", *arguments)
    assert (status, out) == (2, "")
    assert err.startswith(f"error: {message}"), err
    assert err.count("\n") == 1
    assert set(tmp_path.iterdir()) == {cube, path}


def test_headers_tell_the_unit():
    known = quantities()
    found = {name: [known[name].header(column) for column in ("value", "standard_error", "rays")] for name in known}
    assert found["sky"] == ["sky_view_factor", "sky_view_factor_error", "rays"]
    assert found["irradiation"] == ["irradiation_kwh_m2", "irradiation_kwh_m2_error", "rays"]
    assert found["sun-hours"] == ["sun_hours_h", "sun_hours_h_error", "rays"]
    assert found["mean-distance"] == ["mean_distance", "mean_distance_error", "rays"]
    assert known["irradiation"].header("direct") == "direct_kwh_m2"
    assert known["irradiance"].header("standard_error_g") == "irradiance_g_error"
