"""The command line: what it prints, what it writes, and what it leaves behind when it fails."""

import json
from types import SimpleNamespace

import numpy as np
import pytest
import rasterio
from affine import Affine

import warpsample as ws
from warpsample.output import export


def test_info_counts_and_explains(call, tmp_path):
    path = tmp_path / "flawed.off"
    path.write_text("OFF\n4 3 0\n0 0 0\n1 0 0\n0 1 0\n5 5 5\n3 0 1 2\n3 0 1 1\n3 0 1 2\n")
    status, out, err = call("info", path)
    assert (status, err) == (0, "")
    assert [line for line in out.splitlines() if "degenerate faces" in line and " 1 " in line and "no points" in line]
    assert [line for line in out.splitlines() if "duplicate faces" in line and " 1 " in line]
    assert max(map(len, out.splitlines())) <= 80


def test_info_tells_apart_the_ends_of_a_house_on_a_map(call, tmp_path):
    """Six digits were the same, or kilometres off."""
    path = tmp_path / "house.off"
    path.write_text("OFF\n3 1 0\n0.25 5100000.377 0\n12 5100000.377 0\n0.25 5100019.377 0\n3 0 1 2\n")
    out = call("info", path)[1]
    assert "5100000.377, 5100019.377" in out
    assert "0.25, 12" in out


def test_info_measures_cells_and_extent_of_a_turned_raster(call, tmp_path):
    """A raster turned by 90 degrees had cells of 0 x 0, and one by 45 degrees a fifth of its height."""
    path, where = tmp_path / "turned.tif", Affine.translation(100.0, 200.0) * Affine.rotation(90) * Affine.scale(2.0, -3.0)
    with rasterio.open(
        path, "w", driver="GTiff", height=4, width=5, count=1, dtype="float32", transform=where, crs="EPSG:32633"
    ) as file:
        file.write(np.zeros((4, 5), np.float32), 1)
    told = {
        name.strip(): value.strip()
        for _, name, value, *_ in (row.split("│") for row in call("info", path)[1].splitlines() if "│" in row)
    }
    assert told["cell size"] == "2 x 3"
    assert (told["x from, to"], told["y from, to"]) == ("100, 112", "200, 210")


@pytest.mark.parametrize(("where", "rows"), [(("--points", 777), 777), (("--at", "faces"), 12), (("--at", "vertices"), 8)])
def test_directions_file_holds_the_run(call, cube, tmp_path, where, rows, monkeypatch):
    monkeypatch.setattr(export, "DIRECTIONS_PER_PART", 100)  # several parts
    output = tmp_path / "d.npz"
    options = ["--samples", 5, "--sequence", "r2", "--seed", 3, *where]
    status, out, err = call("directions", cube, "-o", output, *options)
    assert (status, err) == (0, "")
    assert out == f"{output}: {5 * rows:,} directions at {rows:,} points\n"
    with np.load(output) as file:
        run = json.loads(str(file["run"]))
        kept = {name: file[name] for name in ("position", "normal", "face", "vectors", "status")}
    mesh = ws.load_mesh(run["mesh"])
    points = {
        None: lambda: ws.sample_surface(mesh, run["points"], seed=run["seed"]),
        "faces": lambda: ws.face_centers(mesh),
        "vertices": lambda: ws.vertex_points(mesh),
    }[run["at"]]()
    again = ws.sample_directions(
        points, run["samples"], distribution=run["distribution"], sequence=run["sequence"], seed=run["seed"]
    )
    assert np.array_equal(kept["position"], points.position)
    assert np.array_equal(kept["normal"], points.normal)
    assert np.array_equal(kept["face"], points.face)
    assert np.array_equal(kept["vectors"], again.vectors)
    assert np.array_equal(kept["status"], again.status)
    assert set(run["versions"]) == {"warpsample", "warp-lang", "numpy", "streams"}
    assert len(run["mesh_sha256"]) == 64
    assert list(tmp_path.iterdir()) == [cube, output] or set(tmp_path.iterdir()) == {cube, output}


@pytest.mark.parametrize("at", ["vertices", "faces", None])
def test_lobes_of_a_textured_mesh_lie_along_u(call, tmp_path, at, monkeypatch):
    """Of a quad whose u grows along y; a lobe that is symmetric needs no tangents."""
    monkeypatch.setattr(export, "DIRECTIONS_PER_PART", 100)  # several parts
    mesh, output = tmp_path / "quad.obj", tmp_path / "d.npz"
    corners = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 0 1\nvt 1 1\nvt 1 0\n"
    mesh.write_text(corners + "f 1/1 2/2 3/3 4/4\n")
    options = ["-o", output, *(("--at", at) if at else ("--points", 30)), "--samples", 50, "--distribution"]
    assert call("directions", mesh, *options, "ggx(alpha=0.02, alpha_y=0.5)")[0] == 0
    with np.load(output) as file:
        assert np.array_equal(np.sign(file["tangent"][:, :3]), np.tile([0.0, 1.0, 0.0], (len(file["face"]), 1)))
        points = ws.SurfacePoints(file["position"], file["normal"], tangent=file["tangent"])
        lobe = ws.GGX(0.02, 0.5)
        assert np.array_equal(file["vectors"], ws.sample_directions(points, 50, distribution=lobe).vectors)
    assert call("directions", mesh, *options, "ggx(alpha=0.02)")[0] == 0
    with np.load(output) as file:
        assert "tangent" not in file


def test_directions_file_holds_the_hash_of_a_picture(call, cube, tmp_path):
    """The name alone does not tell two pictures apart."""
    picture, output, kept = tmp_path / "sky.npy", tmp_path / "d.npz", []
    for pixels in (np.ones((2, 4)), np.ones((2, 4)), np.eye(2, 4)):
        np.save(picture, pixels)
        options = ("--points", 3, "--samples", 2, "--distribution", f"environment_map(picture='{picture}')")
        assert call("directions", cube, "-o", output, *options)[0] == 0
        with np.load(output) as file:
            kept.append(json.loads(str(file["run"]))["pictures_sha256"])
    assert kept[0] == kept[1] != kept[2]
    assert list(map(len, kept[0])) == [64]


def test_skipped_points_are_counted_in_the_summary(call, tmp_path):
    path = tmp_path / "flat.off"
    path.write_text("OFF\n3 2 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n3 0 1 1\n")
    _, out, _ = call("directions", path, "-o", tmp_path / "d.npz", "--at", "faces")
    assert out.endswith("128 directions at 2 points, 1 zero_normal\n")


@pytest.mark.parametrize("stop", [KeyboardInterrupt, MemoryError("no room")])
def test_an_interrupted_run_leaves_the_old_file_and_no_half_one(call, cube, tmp_path, monkeypatch, stop):
    output = tmp_path / "d.npz"
    output.write_text("old")
    sample = export.sample_directions

    def interrupted(*arguments, first_point, **rest):
        if first_point:
            raise stop
        return sample(*arguments, first_point=first_point, **rest)

    monkeypatch.setattr(export, "sample_directions", interrupted)
    monkeypatch.setattr(export, "DIRECTIONS_PER_PART", 640)
    status, _, err = call("directions", cube, "-o", output)
    assert status == (130 if stop is KeyboardInterrupt else 2)
    assert err.startswith("interrupted after 10 of 10,000 points; " if stop is KeyboardInterrupt else "error: no room")
    assert output.read_text() == "old"
    assert set(tmp_path.iterdir()) == {cube, output}


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["info", "nothing.ply"], "error: path: got 'nothing.ply', which is missing, want a mesh file"),
        (
            ["directions", "CUBE", "-o", "d.txt"],
            "error: --output: got 'd.txt', want a file that ends in one of .npz .vtp .ply",
        ),
        (["directions", "CUBE", "-o", "no/d.npz"], "error: --output: got 'no/d.npz', whose folder does not exist"),
        (["directions", "CUBE", "-o", "d.npz", "--points", "0"], "error: --points: got 0, want a whole number from 1"),
        (["directions", "CUBE", "-o", "d.npz", "--samples", "-3"], "error: --samples: got -3"),
        (["directions", "CUBE", "-o", "d.npz", "--workers", "0"], "error: --workers: got 0, want a whole number from 1"),
        (["directions", "CUBE", "-o", "d.npz", "--seed", "-1"], "error: --seed: got -1, want a whole number of 64 bits"),
        (
            ["directions", "CUBE", "-o", "d.npz", "--sequence", "halton"],
            "error: --sequence: got 'halton', want one of fib",
        ),
        (
            ["directions", "CUBE", "-o", "d.npz", "--distribution", "offset_disk"],
            "error: --distribution: got OffsetDisk(), which is planar, want a distribution of directions in space",
        ),
        (
            ["directions", "CUBE", "-o", "d.npz", "--distribution", "x"],
            "error: --distribution: got 'x', want one of beckmann, cosine",
        ),
    ],
)
def test_bad_input_is_one_line_and_writes_nothing(call, cube, tmp_path, monkeypatch, arguments, message):
    monkeypatch.chdir(tmp_path)
    status, out, err = call(*[cube if a == "CUBE" else a for a in arguments])
    assert status == 2
    assert out == ""
    assert err.startswith(message)
    assert err.count("\n") == 1
    assert set(tmp_path.iterdir()) == {cube}


@pytest.mark.parametrize("command", ["directions", "bake"])
def test_every_command_has_the_same_two_options_for_its_points(call, cube, tmp_path, command, monkeypatch):
    output = tmp_path / "d.npz"
    status, _, err = call(command, cube, "-o", output, "--at", "corners")
    assert status == 2
    assert all(word in err for word in ("--at", "faces", "vertices"))
    status, _, err = call(command, cube, "-o", output, "--at", "faces", "--points", 9)
    assert (status, err) == (2, "error: --points: got 9 together with --at faces, want only one of the two\n")
    monkeypatch.setattr("psutil.virtual_memory", lambda: SimpleNamespace(available=10**9))
    monkeypatch.setattr("shutil.disk_usage", lambda _: SimpleNamespace(free=10**15))
    status, _, err = call(command, cube, "-o", output, "--points", 2**31 - 1)
    assert status == 2
    assert err == "error: 2,147,483,647 surface points need 85.9 GB and 1.0 GB are free; take fewer with --points\n"
    for old in ("--count", "--placement"):
        assert call(command, cube, "-o", output, old, "faces")[0] == 2
    assert not output.exists()


def test_directions_that_no_disk_holds_are_refused_at_once(call, cube, tmp_path, monkeypatch):
    monkeypatch.setattr("shutil.disk_usage", lambda _: SimpleNamespace(free=2_500_000))
    output = tmp_path / "d.npz"
    status, _, err = call("directions", cube, "-o", output, "--points", 10**8, "--samples", 10**5)
    wants = "10,000,000,000,000 directions take 120.000 TB, and 2.500 MB are free"
    assert (status, err) == (1, f"error: {output} cannot be written: {wants}\n")
    assert set(tmp_path.iterdir()) == {cube}


@pytest.mark.parametrize(("command", "rows"), [("directions", 10_000), ("bake", 8)])
def test_without_them_points_are_where_they_were(call, cube, tmp_path, command, rows):
    assert call(command, cube, "-o", tmp_path / "d.npz", "--samples", 2)[0] == 0
    with np.load(tmp_path / "d.npz") as file:
        assert len(file["status"]) == rows


def test_the_courtyard_stands_upright_in_the_viewer(call, cube, tmp_path, monkeypatch, can_render):
    pytest.importorskip("pyvista")
    from warpsample.viewer import start

    ups = []
    monkeypatch.setattr(start, "save", lambda *_, up, **__: ups.append(up) or "drawn")
    for mesh, *options in (("courtyard",), ("courtyard", "--up", "x"), (cube,)):
        status, _, _ = call("view", mesh, *options, "--screenshot", tmp_path / "picture.png")
        assert status == 0
    assert ups == ["z", "x", "y"]
