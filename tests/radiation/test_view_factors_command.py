"""`warpsample view-factors` and the picture of a row."""

import re
from pathlib import Path

import numpy as np
import pytest
import pyvista as pv
import trimesh
from scipy import sparse
from view_factor_cases import box, scene

import warpsample as ws
from warpsample.radiation.exchange import casting

pytestmark = pytest.mark.slow  # seconds each, and kernels to compile; .ci/run runs them too


@pytest.fixture
def cube_inwards(tmp_path):
    mesh, groups = scene(*box())
    path = tmp_path / "cube.off"
    lines = ["OFF", f"{len(mesh.vertices)} {len(mesh.faces)} 0"]
    lines += [" ".join(map(str, row)) for row in mesh.vertices.tolist()]
    lines += [" ".join(map(str, [3, *row])) for row in mesh.faces.tolist()]
    path.write_text("\n".join(lines) + "\n")
    np.savetxt(tmp_path / "groups.txt", groups, fmt="%d")
    np.save(tmp_path / "groups.npy", groups)
    return path


def test_the_file_holds_what_the_call_gives(call, cube_inwards, tmp_path):
    output = tmp_path / "factors.npz"
    status, out, err = call("view-factors", cube_inwards, "-o", output, "--count", 256, "--seed", 3, "--up", 0, 0, 1)
    assert (status, err) == (0, "")
    right = ws.view_factors(ws.load_mesh(cube_inwards), 256, seed=3, up=(0, 0, 1))
    assert (sparse.load_npz(output) != right.matrix).nnz == 0
    assert re.fullmatch(
        rf".*factors.npz: {right.matrix.nnz} view factors between 12 surfaces by 3,072 rays\n"
        r"  sums of rows differ from 1 by at most 0 \(closure\)\n"
        r"  A_i F_ij and A_j F_ji differ by 0\.\d+ of their size \(reciprocity\)\n"
        r"  0 of the radiation leaves to the outside\n  0 of the radiation hits backs of faces\n",
        out,
    )


def test_a_room_that_looks_outwards_is_reported(call, tmp_path):
    path = tmp_path / "room.ply"
    trimesh.creation.box((2.0, 2.0, 2.0)).export(path)
    status, out, err = call("view-factors", path, "-o", tmp_path / "factors.npz", "--count", 16)
    assert (status, err) == (0, "")
    assert "1 of the radiation leaves to the outside\n  0 of the radiation hits backs of faces\n" in out
    assert "12 faces see only the outside and cast no rays\n  no front faces another front" in out


@pytest.mark.parametrize("groups", ["groups.txt", "groups.npy"])
def test_groups_and_reciprocity(call, cube_inwards, tmp_path, groups):
    output = tmp_path / "vfsparse.inp.1"
    options = ["--groups", tmp_path / groups, "--reciprocal", "--count", 256]
    status, out, err = call("view-factors", cube_inwards, "-o", output, *options)
    assert (status, err) == (0, "")
    assert re.search(
        r"30 view factors between 6 surfaces [^?]* by at most \de-(09|1\d) [^?]* differ by (0|\d.*e-1\d) of", out
    )
    assert len(output.read_text().splitlines()) == 30
    assert len((tmp_path / "svf.inp.1").read_text().splitlines()) == 7


def test_groups_are_the_named_parts(call, cube_inwards, tmp_path):
    mesh = ws.load_mesh(cube_inwards)
    corners = [f"v {x} {y} {z}" for x, y, z in mesh.vertices]
    sides = [f"o side{k}\nf {a + 1} {b + 1} {c + 1}" for k, (a, b, c) in enumerate(mesh.faces)]
    (tmp_path / "named.obj").write_text("\n".join([*corners, *sides]))
    status, _, err = call(
        "view-factors", tmp_path / "named.obj", "-o", tmp_path / "v.npz", "--groups", "part", "--count", 16
    )
    assert (status, err) == (0, "")
    assert ws.ViewFactors.load(tmp_path / "v.npz").names == tuple(f"side{k}" for k in range(12))


@pytest.mark.parametrize("stop", [KeyboardInterrupt, MemoryError("no room")])
def test_an_interrupted_run_leaves_the_old_file(call, cube_inwards, tmp_path, monkeypatch, stop):
    output = tmp_path / "factors.npz"
    output.write_text("old")
    before = set(tmp_path.iterdir())
    monkeypatch.setattr(casting.Casting, "_cast_block", lambda *_: (_ for _ in ()).throw(stop))
    status, _, err = call("view-factors", cube_inwards, "-o", output)
    assert status != 0
    assert len(err.splitlines()) == 1
    assert output.read_text() == "old"
    assert set(tmp_path.iterdir()) == before


@pytest.mark.parametrize(
    ("options", "said"),
    [
        (("-o", "a.txt"), "error: --output: got .*want a name that ends"),
        (("-o", "factors.npz", "--count", 3), "error: --count: got 3, want"),
        (("-o", "factors.npz", "--groups", "cube.off"), "error: --groups: got .*cannot be read"),
        (("-o", "factors.npz", "--groups", "none.txt"), "error: --groups: got .*missing"),
        (("-o", "factors.npz", "--groups", "pickled.npy"), "error: --groups: got .*cannot be read"),
        (("-o", "factors.npz", "--groups", "archive.npy"), "error: --groups: got .*cannot be read"),
        (("-o", "factors.npz", "--groups", "huge.npy"), "error: --groups: got .*cannot be read"),
        (("-o", "factors.npz", "--up", 0, 0, 0), "error: --up: got"),
    ],
)
def test_one_sentence_says_what_is_wrong(call, cube_inwards, tmp_path, monkeypatch, options, said):
    monkeypatch.chdir(tmp_path)
    np.save("pickled.npy", np.array([{}] * 12, object))
    np.savez("archive.npz", np.zeros(12, int))
    with Path("huge.npy").open("wb") as file:  # whose header declares what the file does not hold
        np.lib.format.write_array_header_1_0(file, {"descr": "<i8", "fortran_order": False, "shape": (10**12,)})
    (tmp_path / "archive.npz").rename("archive.npy")  # which numpy.load would leave open
    status, out, err = call("view-factors", cube_inwards, *options)
    assert (status, out) == (2, "")
    assert re.match(said, err)
    assert len(err.splitlines()) == 1
    assert not (tmp_path / "factors.npz").exists()


def test_the_picture_shows_the_row(script):
    mesh, _ = scene(*box())
    found = ws.view_factors(mesh, 256, up=(0, 0, 1))
    row, error, sky = script("view_factors").make_panels(found, 3)
    factors, errors = found.matrix.toarray()[3], found.standard_error.toarray()[3]
    seen = factors > 0.0
    assert 0 < seen.sum() < len(seen)
    assert np.array_equal(row.value[::3], np.where(seen, factors, np.nan), equal_nan=True)
    assert np.array_equal(error.value[2::3], np.where(seen, errors, np.nan), equal_nan=True)
    assert np.array_equal(sky.value[1::3], found.sky)
    assert row.high >= np.quantile(factors[seen], 0.9)


def test_the_picture_is_of_ground_between_walls_and_outlines_it(script, can_render):
    module, mesh = script("view_factors"), ws.load_mesh("courtyard")
    found = ws.view_factors(mesh, 64, up=(0, 0, 1))
    face = module.choose_face(mesh, found, "z")
    assert mesh.face_normals[face].tolist() == [0.0, 0.0, 1.0]
    assert found.outside[face] < 0.6
    roof = ws.Mesh(mesh.vertices[mesh.faces[0]], [[0, 1, 2]])
    assert module.choose_face(roof, ws.view_factors(roof, 64, up=(1, 0, 0)), "x") == 0
    plotter = pv.Plotter(shape=(2, 2), off_screen=True)
    module.outline(plotter, mesh, face, "z", 2)
    for column in range(2):
        edges, sides = (actor.mapper.dataset for actor in plotter.renderers[column].actors.values())
        assert edges.n_cells > 100
        assert np.array_equal(np.unique(sides.points, axis=0), np.unique(mesh.vertices[mesh.faces[face]], axis=0))


@pytest.mark.slow
def test_the_picture_is_drawn(can_render, script, tmp_path, capsys):
    file = tmp_path / "row.png"
    script("view_factors").main(count=64, screenshot=file, size=(900, 340))
    assert "face " in capsys.readouterr().out
    assert file.stat().st_size > 10_000


def test_the_picture_says_what_is_wrong(can_render, script, tmp_path, capsys):
    with pytest.raises(SystemExit):
        script("view_factors").main(face=2080, screenshot=tmp_path / "row.png")
    assert re.match("error: --face: got 2080, want a whole number from 0 to 2079", capsys.readouterr().err)
