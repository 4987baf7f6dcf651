"""Parameters by point from arrays of files and datasets, by their names."""

from dataclasses import replace

import numpy as np
import pytest

import warpsample as ws
from warpsample.mesh.points.arrays import carry_to_points, read_array
from warpsample.output.export import DirectionsRun, export
from warpsample.output.mesh_writers import write_ply

pv = pytest.importorskip("pyvista")


@pytest.fixture(scope="module")
def mesh():
    return ws.load_mesh("courtyard")


@pytest.fixture
def rough(mesh):
    return np.linspace(0.1, 0.9, len(mesh.vertices)).astype(np.float32)


@pytest.fixture
def files(mesh, rough, tmp_path):
    """The same array in a .ply, a .vtp and an .npz, and a vector in the .ply and the .npz."""
    view = np.tile(np.float32([0.1, 0.2, 0.9]), (len(rough), 1))
    with (tmp_path / "mesh.ply").open("wb") as file:
        columns = {"x y z": mesh.vertices, "roughness": rough, "view_x view_y view_z": view}
        write_ply(file, {"vertex": columns, "face": {"vertex_indices": mesh.faces}})
    surface = mesh.to_polydata()
    surface["roughness"] = rough
    surface.save(tmp_path / "arrays.vtp")
    np.savez(tmp_path / "arrays.npz", roughness=rough, view=view)
    return tmp_path


def run_of(files, arrays, **changed):
    values = {"points": None, "samples": 4, "distribution": "ggx(alpha=@roughness)", "sequence": "sobol", "seed": 0}
    values |= {"at": "vertices"} | changed
    return DirectionsRun(files / "mesh.ply", files / "out.npz", arrays=arrays and files / arrays, **values)


@pytest.mark.parametrize("arrays", [None, "arrays.vtp", "arrays.npz"])
def test_the_command_reads_a_parameter_of_each_vertex(arrays, files, mesh, rough):
    export(run_of(files, arrays))
    found = np.load(files / "out.npz")["vectors"]
    points = ws.vertex_points(mesh)
    assert np.array_equal(found, ws.sample_directions(points, 4, distribution=ws.GGX(rough)).vectors)
    assert not np.array_equal(found, ws.sample_directions(points, 4, distribution=ws.GGX(0.5)).vectors)


def test_vectors_have_three_properties_or_columns(files, mesh):
    for name in ("mesh.ply", "arrays.npz"):
        assert np.allclose(read_array(files / name, "view", "--arrays").array, [0.1, 0.2, 0.9])
    export(run_of(files, None, distribution="visible_ggx(alpha=@roughness, view=@view)"))
    assert np.load(files / "out.npz")["vectors"].any(axis=(1, 2)).all()


def test_points_on_faces_get_interpolated_numbers(mesh):
    points = ws.sample_surface(mesh, 300, seed=2)
    linear = mesh.vertices @ [0.3, -0.2, 0.5] + 1.0
    found = carry_to_points(linear, "x", mesh, points)
    assert np.allclose(found, points.position @ [0.3, -0.2, 0.5] + 1.0, rtol=1e-9, atol=1e-9)
    exact = ws.sample_surface(mesh, 300, seed=2, barycentric=True)
    assert np.allclose(found, carry_to_points(linear, "x", mesh, exact), rtol=1e-9, atol=1e-9)
    assert np.array_equal(carry_to_points(np.arange(len(mesh.faces)), "x", mesh, points), points.face)
    own = np.arange(300.0)
    assert np.array_equal(carry_to_points(own, "x", mesh, points), own)
    with pytest.raises(ValueError, match="want rows for 1,089"):
        carry_to_points(np.zeros(7), "x", mesh, points)


def test_a_long_run_takes_the_rows_of_each_part(files, mesh, rough, monkeypatch):
    export(run_of(files, None))
    whole = np.load(files / "out.npz")["vectors"]
    monkeypatch.setattr("warpsample.output.export.DIRECTIONS_PER_PART", 4 * 100)
    export(run_of(files, None))
    assert np.array_equal(np.load(files / "out.npz")["vectors"], whole)


def test_wrong_names_are_refused_before_anything_is_written(files):
    for distribution, message in (
        ("ggx(alpha=@nothing)", "got the array name @nothing, want an array of arrays.npz: 'roughness, view'"),
        ("ggx(alpha=@view)", "alpha: got shape"),
    ):
        with pytest.raises(ValueError, match=message):
            export(run_of(files, "arrays.npz", distribution=distribution))
    with pytest.raises(FileNotFoundError, match="--arrays: got"):
        export(run_of(files, "none.npz"))
    assert not (files / "out.npz").exists()
    with pytest.raises(TypeError, match="@roughness names an array, which this call does not have"):
        ws.sample_directions([[0.0, 0.0, 1.0]], 4, distribution="ggx(alpha=@roughness)")


def test_the_accessor_takes_point_arrays_by_name(mesh, rough):
    surface = mesh.to_polydata()
    surface["roughness"] = rough
    cloud = surface.warpsample.sample_directions(4, distribution="ggx(alpha=@roughness)", scale=1.0)
    found = ws.sample_directions(ws.vertex_points(mesh), 4, distribution=ws.GGX(rough))
    assert np.array_equal(cloud["Normals"], found.vectors.reshape(-1, 3))
    assert surface.warpsample.sample_directions(4, points=50, distribution="ggx(alpha=@roughness)").n_points == 200
    with pytest.raises(ValueError, match="got the array name @gloss, want an array of the dataset"):
        surface.warpsample.sample_directions(4, distribution="ggx(alpha=@gloss)")


def open_cylinder(corners=6):
    """A cylinder without ends: as many triangles as vertices. Each face has a roughness of its own."""
    turn = 2.0 * np.pi * np.arange(corners) / corners
    ring = np.stack([np.cos(turn), np.sin(turn)], axis=1)
    vertices = np.concatenate([np.column_stack([ring, np.full(corners, z)]) for z in (0.0, 1.0)])
    a, b = np.arange(corners), (np.arange(corners) + 1) % corners
    faces = np.concatenate([np.stack([a, b, b + corners], axis=1), np.stack([a, b + corners, a + corners], axis=1)])
    return ws.as_mesh((vertices, faces)), np.linspace(0.05, 0.95, 2 * corners).astype(np.float32)


def test_an_array_of_cells_stays_at_faces_if_there_are_as_many_vertices(tmp_path):
    mesh, rough = open_cylinder()
    surface = mesh.to_polydata()
    surface.cell_data["roughness"] = rough
    surface.save(tmp_path / "mesh.vtp")
    with (tmp_path / "mesh.ply").open("wb") as file:
        write_ply(file, {"vertex": {"x y z": mesh.vertices}, "face": {"vertex_indices": mesh.faces, "roughness": rough}})
    points = ws.sample_surface(mesh, 50, seed=1)
    lobe = ws.GGX(rough[points.face])
    found = ws.sample_directions(points, 4, distribution=lobe, seed=1).vectors
    cloud = surface.warpsample.sample_directions(4, points=50, seed=1, distribution="ggx(alpha=@roughness)")
    assert np.array_equal(cloud["Normals"], found.reshape(-1, 3))
    for name in ("mesh.vtp", "mesh.ply"):
        array, at = read_array(tmp_path / name, "roughness", "--arrays")
        assert np.array_equal(carry_to_points(array, "roughness", mesh, points, at), rough[points.face])
        with pytest.raises(ValueError, match="got @roughness with shape .* at faces, want points inside faces"):
            carry_to_points(array, "roughness", mesh, ws.vertex_points(mesh), at)
        with pytest.raises(ValueError, match="at faces, want 12 rows, one for each triangle"):
            carry_to_points(array[:6], "roughness", mesh, points, at)


def test_other_arrays_of_a_file_are_not_read_and_a_number_alone_is_refused(files, mesh, rough):
    np.savez(files / "mixed.npz", roughness=rough, notes=np.array([None, {}], object), alone=np.float32(0.3))
    assert np.array_equal(read_array(files / "mixed.npz", "roughness", "--arrays").array, rough)
    with pytest.raises(ValueError, match="got the array name @nothing, want an array of mixed.npz: 'alone, notes, rough"):
        read_array(files / "mixed.npz", "nothing", "--arrays")
    with pytest.raises(ValueError, match=r"got @alone with shape \(\), want rows for 1,089"):
        export(run_of(files, "mixed.npz", distribution="ggx(alpha=@alone)"))


def test_the_file_of_the_arrays_is_not_overwritten(files):
    run = DirectionsRun(files / "mesh.ply", files / "arrays.npz", 5, 4, "ggx(alpha=@roughness)", "sobol", 0, None)
    with pytest.raises(ValueError, match="--output: got .*arrays.npz"):
        export(replace(run, arrays=files / "arrays.npz"))
    assert np.load(files / "arrays.npz").files == ["roughness", "view"]


def test_the_command_names_the_parameters_with_invalid_rows(files, mesh, rough):
    view = np.tile(np.float32([0.1, 0.2, 0.9]), (len(rough), 1))
    view[:3], rough[1:5] = -view[:3], 0.0
    np.savez(files / "bad.npz", rough=rough, fine=np.full(len(rough), 0.3), view=view)
    for distribution, names in (
        ("visible_ggx(alpha=@rough, view=@view)", "5 invalid_parameter (alpha, view)"),
        ("visible_ggx(alpha=@fine, view=@view)", "3 invalid_parameter (view)"),
    ):
        assert export(run_of(files, "bad.npz", distribution=distribution)).endswith(f" points, {names}")
