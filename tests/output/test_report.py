"""`bake -o picture.png` and `--report`: what is drawn and told, offline, and what is refused before any work."""

import base64
import re
from io import BytesIO

import city_files
import numpy as np
import pytest
import trimesh
from matplotlib.image import imread

import warpsample as ws
from warpsample.output import pictured

BAKE = ("bake", "courtyard", "--quantity", "sky", "--samples", "16", "--at", "faces")


def colours_of(data):
    """How many of a picture's pixels are coloured, not grey or of the background."""
    pixels = imread(BytesIO(data))[..., :3]
    return np.count_nonzero(np.ptp(pixels, axis=-1) > 0.2)


@pytest.mark.slow
def test_a_picture_shows_the_numbers(call, tmp_path, can_render):
    for at, said in ((["--at", "vertices"], "1,089 vertices"), (["--points", "3000"], "3,000 points"), ([], "2,080 faces")):
        status, out, err = call(*BAKE[:6], *at, "-o", tmp_path / "sky.png")
        assert (status, err) == (0, "")
        assert said in out
        assert colours_of((tmp_path / "sky.png").read_bytes()) > 20_000


@pytest.mark.slow
def test_a_glb_stands_upright(call, tmp_path, can_render):
    """Seen from a little above, a high box is higher than wide where its long side is the file's own y."""
    tall = {}
    for name, extents in (("high", (1.0, 4.0, 1.0)), ("deep", (1.0, 1.0, 4.0))):
        trimesh.creation.box(extents).export(tmp_path / f"{name}.glb")
        status, _, err = call("bake", tmp_path / f"{name}.glb", "--samples", "16", "-o", tmp_path / "box.png")
        assert (status, err) == (0, "")
        rows, columns = np.nonzero(np.ptp(imread(tmp_path / "box.png")[100:700, :, :3], axis=-1) > 0.3)
        tall[name] = np.ptp(rows) / np.ptp(columns)
    assert tall["high"] > 1.5 * tall["deep"]  # what is deep is foreshortened; the wrong axis exchanges both


@pytest.mark.slow
def test_a_report_on_means_at_faces_of_a_city_leaves_the_ground_grey(call, tmp_path, can_render, monkeypatch):
    """Faces of the ground have no values; PyVista refused the array, after the output was written."""
    city, scenes = city_files.written(tmp_path / "house.city.json", city_files.house()), []
    draw = pictured.number_scene
    monkeypatch.setattr(
        pictured, "number_scene", lambda scene, *args, **more: scenes.append(scene) or draw(scene, *args, **more)
    )
    known = ws.load_city(city)
    kind = known.surfaces.type[known.surface]
    run = "bake", city, "--quantity", "sky", "--samples", "16", "--at", "faces", "--report", tmp_path / "r.html"
    for output in ("out.csv", "out.city.json"):
        status, _, err = call(*run, "-o", tmp_path / output)
        assert (status, err) == (0, "")
        page = (tmp_path / "r.html").read_text()
        assert colours_of(base64.b64decode(re.search(r"data:image/png;base64,([^\"]+)", page)[1])) > 20_000
        shown = scenes.pop().cell_data["shown"]
        assert np.array_equal(np.isnan(shown), kind == "GroundSurface")
        assert (shown[kind == "RoofSurface"] > 0.99).all()  # flat, with nothing above
        assert (shown[kind == "WallSurface"] < 0.6).all()  # upright: half of the sky at most, and noise of 16 rays


@pytest.mark.slow
def test_a_report_tells_all_and_needs_no_network(call, tmp_path, can_render, monkeypatch):
    monkeypatch.chdir(tmp_path)
    box = trimesh.creation.box((2.0, 2.0, 2.0))
    lines = [f"v {' '.join(map(str, v))}" for v in box.vertices]
    for name, faces in (("walls <a>", box.faces[:8]), ("rest", box.faces[8:])):
        lines += [f"o {name}", *(f"f {' '.join(map(str, face + 1))}" for face in faces)]
    (tmp_path / "box.obj").write_text("\n".join(lines))
    run = ("bake", "box.obj", "-o", "sky.csv", "--quantity", "sky", "--samples", "16", "--at", "faces", "--report", "r.html")
    status, out, err = call(*run)
    assert (status, err) == (0, "")
    assert "r.html: a report" in out
    page = (tmp_path / "r.html").read_text()
    assert re.findall(r"https?://", page) == []
    assert colours_of(base64.b64decode(re.search(r"data:image/png;base64,([^\"]+)", page)[1])) > 20_000
    assert page.count("<rect ") == 40
    for said in ("walls &lt;a&gt;", "sky_view_factor_error", "<td>samples</td><td>16</td>", "<td>seed</td><td>0</td>"):
        assert said in page
    assert "<a>" not in page
    assert f"<td>warpsample</td><td>{ws.__version__}</td>" in page
    assert call(*run)[0] == 0
    assert (tmp_path / "r.html").read_text() == page


def test_a_name_that_is_not_in_utf8_is_shown(call, tmp_path):
    """The report ended in an error of the codec, after the output had been written."""
    mesh, page = tmp_path / "box\udcff.off", tmp_path / "r.html"
    trimesh.creation.box().export(tmp_path / "box.off")
    (tmp_path / "box.off").rename(mesh)
    assert call("bake", mesh, "-o", tmp_path / "o.csv", "--samples", 4, "--at", "faces", "--report", page)[0] == 0
    assert r"box\udcff.off" in page.read_text()


def test_what_cannot_be_reported_is_refused_before_any_work(call, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    for more, said in (
        (("-o", "sky.csv", "--report", "r.txt"), "error: --report: got 'r.txt', want a file that ends in .html"),
        (
            ("-o", "sky.zarr", "--report", "r.html"),
            "error: --report: got r.html for sky.zarr; the option applies only to .ply",
        ),
        (("-o", "sky.csv", "--report", "none/r.html"), "error: --report: got 'none/r.html'"),
    ):
        status, out, err = call(*BAKE, *more)
        assert (status, out) == (2, "")
        assert err.startswith(said)
    status, _, err = call("bake", "courtyard", "-o", "m.npz", "--quantity", "sky-matrix", "--report", "r.html")
    assert (status, err[:40]) == (2, "error: --report: got r.html for sky-matr")
    assert list(tmp_path.iterdir()) == []
