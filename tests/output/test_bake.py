"""`warpsample bake`: the numbers in every kind of file, the printed report, and what remains after an error."""

import json
import re
from dataclasses import replace
from functools import wraps

import numpy as np
import pytest
import trimesh

import warpsample as ws
from warpsample.output import bake, source
from warpsample.output.baked import BakeRun
from warpsample.output.places import PLACES
from warpsample.output.quantities import quantity_of
from warpsample.output.run_record import RunRecord, summarize
from warpsample.output.source import read_source

TORUS = trimesh.creation.torus(2.0, 0.6, 24, 12)


@pytest.fixture
def torus(tmp_path):
    path = tmp_path / "torus.ply"
    TORUS.export(path)
    return path


def read(path):
    """{name: array} of the numbers in a file."""
    if path.suffix == ".npz":
        with np.load(path) as file:
            return {name: file[name] for name in file}
    if path.suffix == ".csv":
        table = np.genfromtxt(path, delimiter=",", names=True)
        return {_field(name): table[name] for name in table.dtype.names}
    if path.suffix == ".vtp":
        import pyvista as pv

        data = pv.read(path)
        return dict(data.cell_data if data.n_cells == len(data.cell_data.get("value", [])) else data.point_data)
    made = trimesh.load(path, process=False, force="mesh")
    if path.suffix == ".glb":
        return {name.removeprefix("_"): array for name, array in made.vertex_attributes.items()}
    raw = made.metadata["_ply_raw"]
    return {name: column for kind in ("vertex", "face") for name, column in _columns(raw[kind]["data"]).items()}


def _field(header):
    """The field of the result that a column of a .csv is of: headers tell the quantity and its unit."""
    found = re.fullmatch(r"(?:ambient_occlusion|sky_view_factor|irradiance)(_[rgb])?(_error)?", header)
    return header if found is None else f"{'standard_error' if found[2] else 'value'}{found[1] or ''}"


def _columns(data):
    return {name: np.asarray(data[name]).ravel() for name in ("value", "standard_error", "rays") if name in data.dtype.names}


@pytest.mark.parametrize("suffix", bake.SUFFIXES)
@pytest.mark.parametrize("at", ["vertices", "faces"])
def test_every_file_holds_the_numbers(call, torus, tmp_path, suffix, at, monkeypatch):
    monkeypatch.setattr(bake, "RAYS_PER_PART", 4096)  # several parts
    output = tmp_path / f"out{suffix}"
    status, out, err = call("bake", torus, "-o", output, "--at", at, "--samples", 64, "--seed", 3)
    assert (status, err) == (0, "")
    mesh = ws.load_mesh(torus)
    right = ws.ambient_occlusion(mesh, PLACES[at](mesh), 64, seed=3)
    found = read(output)
    step = 3 if suffix == ".glb" and at == "faces" else 1
    for name in ("value", "standard_error", "rays"):
        assert np.array_equal(np.float32(found[name]).ravel()[::step], np.float32(getattr(right, name))), name
    first, *rest = out.splitlines()
    assert first == f"{output}: ambient occlusion of {len(right.value):,} {at}"
    assert (
        f"mean {right.value.mean(dtype=np.float64):.4f}, from {right.value.min():.4g} to {right.value.max():.4g}; stand"
        in rest[0]
    )
    assert re.search(rf"{right.rays.sum():,} rays cast in \d+\.\d\d s", rest[1])
    assert re.fullmatch(r"  took \d+\.\d\d s, with reading, compiling and writing", rest[2])
    assert f"{right.skipped.empty_rays:,} known to hit nothing" in rest[3]
    assert right.skipped.open_points == 0 or rest[4].startswith(f"  {right.skipped.open_points:,} points cast no rays")
    assert set(tmp_path.iterdir()) == {torus, output}


def test_a_mesh_file_is_the_mesh_in_shades(call, torus, tmp_path):
    output = tmp_path / "out.ply"
    call("bake", torus, "-o", output, "--samples", 64)
    made = trimesh.load(output, process=False)
    assert np.allclose(made.vertices, TORUS.vertices, atol=1e-6)
    assert np.array_equal(made.faces, TORUS.faces)
    shades = np.round(255 * read(output)["value"])
    assert np.array_equal(made.visual.vertex_colors[:, 0], shades)


@pytest.mark.slow
def test_sky_at_points_and_light(call, torus, tmp_path):
    output, light = tmp_path / "out.npz", tmp_path / "light.npy"
    np.save(light, np.dstack([np.ones((4, 8)), np.zeros((4, 8)), np.ones((4, 8))]))
    where = ["--points", 100, "--samples", 64]
    status, out, _ = call("bake", torus, "-o", output, "--quantity", "sky", "--up", 1, 0, 0, *where)
    assert status == 0
    assert "sky view factor of 100 points" in out
    assert "of weight 0, such as below the horizon" in out
    found = read(output)
    mesh = ws.load_mesh(torus)
    right = ws.sky_view_factor(mesh, ws.sample_surface(mesh, 100), 64, up=(1, 0, 0))
    assert np.array_equal(found["value"], right.value)
    assert np.array_equal(found["below_horizon"], right.below_horizon)
    assert json.loads(str(found["run"]))["quantity"] == "sky"
    csv = tmp_path / "out.csv"
    status, out, _ = call("bake", torus, "-o", csv, "--quantity", "irradiance", "--environment", light, *where)
    assert status == 0
    columns = read(csv)
    assert list(columns)[:6] == ["x", "y", "z", "value_r", "value_g", "value_b"]
    assert np.array_equal(columns["value_r"], columns["value_b"])
    assert columns["value_g"].max() == 0.0


def test_points_without_a_number_are_counted(call, tmp_path):
    path = tmp_path / "flawed.off"
    path.write_text("OFF\n3 2 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n3 0 1 1\n")
    _, out, _ = call("bake", path, "-o", tmp_path / "out.csv", "--at", "faces", "--samples", 64)
    assert out.endswith("points without a value: 1 zero_normal\n")
    assert read(tmp_path / "out.csv")["status"].tolist() == [0, 2]


def test_an_interrupt_leaves_the_old_file_and_says_how_far_it_came(call, torus, tmp_path, monkeypatch):
    output = tmp_path / "out.csv"
    output.write_text("old")

    class Terminated(KeyboardInterrupt):
        """What another signal raises."""

    def interrupted(*arguments, first_point, **rest):
        if first_point:
            raise Terminated
        return ws.ambient_occlusion(*arguments, first_point=first_point, **rest)

    changed = replace(quantity_of("ao"), call=wraps(ws.ambient_occlusion)(interrupted))
    monkeypatch.setattr(source, "quantity_of", lambda _: changed)
    monkeypatch.setattr(bake, "RAYS_PER_PART", 64 * 100)
    status, out, err = call("bake", torus, "-o", output, "--samples", 64)
    assert (status, out) == (130, "")
    assert err == f"interrupted after 100 of 288 points; {output} is as it was before\n"
    assert output.read_text() == "old"
    assert set(tmp_path.iterdir()) == {torus, output}
    run = BakeRun(torus, output, "ao", "vertices", None, {"samples": 64, "seed": 0})
    with pytest.raises(Terminated, match="^interrupted after 100 of 288 points"):
        bake.bake(read_source(run), RunRecord("ambient occlusion"))


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["-o", "x.txt"], "error: --output: got 'x.txt', want a file that ends in one of .ply .vtp .glb .npz .csv"),
        (["-o", "no/x.ply"], "error: --output: got 'no/x.ply', whose folder does not exist"),
        (["-o", "x.ply", "--points", "9"], "error: --points: got 9 for x.ply; the option applies only to .vtp, .npz, .csv"),
        (["-o", "x.csv", "--quantity", "irradiance"], "error: --environment: got None for irradiance"),
        (
            ["-o", "x.csv", "--environment", "a.hdr"],
            "error: --environment: got a.hdr for ao; the option applies only to irr",
        ),
        (["-o", "x.csv", "--samples", "1"], "error: --samples: got 1, want a whole number from 2"),
        (["-o", "x.csv", "--falloff", "1"], "error: --max-distance: got None, want a finite distance"),
        (
            ["-o", "x.csv", "--falloff", "1", "--quantity", "sky"],
            "error: --falloff: got 1.0 for sky; the option applies only to ao",
        ),
        (["-o", "x.csv", "--points", "0"], "error: --points: got 0"),
        (["-o", "x.csv", "--tolerance", "-1"], "error: --tolerance: got -1.0"),
    ],
)
def test_bad_input_is_one_line(call, cube, tmp_path, monkeypatch, arguments, message):
    monkeypatch.chdir(tmp_path)
    status, out, err = call("bake", cube, *arguments)
    assert (status, out) == (2, "")
    assert err.startswith(message)
    assert err.count("\n") == 1
    assert set(tmp_path.iterdir()) == {cube}


def test_the_summary_of_colours_is_their_mean(call, torus, tmp_path):
    """The length of three equal colours was 1.73 times the irradiance. Vectors keep their length."""
    picture = tmp_path / "white.npy"
    np.save(picture, np.ones((4, 8, 3), np.float32))
    options = ("--samples", 32, "--quantity", "irradiance", "--environment", picture)
    _, out, _ = call("bake", torus, "-o", tmp_path / "out.npz", *options)
    value = np.load(tmp_path / "out.npz")["value"]
    assert value.shape[1] == 3
    assert value.max() == pytest.approx(np.pi, rel=1e-5)
    assert f"mean {value.mean(dtype=np.float64):.4f}, from {value.min():.4g} to {value.max():.4g};" in out
    lengths = summarize(np.array([[0.0, 3.0, 4.0]]), np.zeros((1, 3)), 0, vectors=True)
    assert lengths["sum"] == 5.0
