"""PyVista gets points, clouds and numbers on meshes; and every PolyData has an accessor."""

import sys

import numpy as np
import pytest
import pyvista as pv

import warpsample as ws
from warpsample.output import export

SQUARE = ws.Mesh(np.array([[0, 0, 0], [2, 0, 0], [2, 2, 0], [0, 2, 0], [9, 9, 9]], float), np.array([[0, 1, 2], [0, 2, 3]]))


@pytest.fixture(scope="module")
def ball():
    return pv.Plane(i_size=4, j_size=4).triangulate().merge(pv.Sphere(center=(0, 0, 1.2))).extract_surface(algorithm=None)


def test_points_keep_their_rows():
    points = ws.sample_surface(SQUARE, 50, seed=1, barycentric=True)
    made = points.to_polydata()
    for name, array in (("Normals", points.normal), ("face", points.face), ("barycentric", points.barycentric)):
        assert np.array_equal(made.point_data[name], array)
    assert np.array_equal(made.points, points.position)


def test_a_cloud_is_positions_plus_scaled_directions():
    """The fifth vertex has no face and so no normal: its row is left out, and the others keep their numbers."""
    points = ws.vertex_points(SQUARE)
    points = ws.SurfacePoints(points.position[::-1], points.normal[::-1])
    found = ws.sample_directions(points, 7, pdf=True)
    made = found.to_polydata(points, 0.25)
    assert made.point_data["point"].tolist() == np.repeat([1, 2, 3, 4], 7).tolist()
    expected = points.position[1:, None] + 0.25 * found.vectors[1:]
    assert np.array_equal(made.points, expected.reshape(-1, 3))
    assert np.array_equal(made.point_data["Normals"], found.vectors[1:].reshape(-1, 3))
    assert np.array_equal(made.point_data["pdf"], found.pdf[1:].ravel())
    about_origin = found.to_polydata()
    assert np.abs(np.linalg.norm(about_origin.points, axis=1) - 1.0).max() <= 2e-7
    with pytest.raises(ValueError, match="^points: got 2 points, want 5"):
        found.to_polydata(ws.face_centers(SQUARE))


def test_numbers_go_where_they_are_of():
    at_faces = ws.sky_view_factor(SQUARE, ws.face_centers(SQUARE), 32)
    at_vertices = ws.sky_view_factor(SQUARE, ws.vertex_points(SQUARE), 32)
    assert np.array_equal(at_faces.to_polydata(SQUARE).cell_data["value"], at_faces.value)
    on_vertices = at_vertices.to_polydata(SQUARE)
    numbers = {"value", "standard_error", "spread", "degrees_of_freedom", "below_horizon"}
    assert set(on_vertices.point_data) == numbers | {"rays", "status"}
    assert on_vertices.point_data["status"][4] == ws.PointStatus.ZERO_NORMAL
    points = ws.sample_surface(SQUARE, 3)
    assert ws.sky_view_factor(SQUARE, points, 32).to_polydata(points).n_points == 3
    for wrong in ({"on": points}, {"on": SQUARE, "at": "vertices"}):
        with pytest.raises(ValueError, match="^on: got .* for 2 values"):
            at_faces.to_polydata(**wrong)
    tetrahedron = ws.as_mesh(pv.Tetrahedron())
    both = ws.ambient_occlusion(tetrahedron, ws.face_centers(tetrahedron), 32)
    with pytest.raises(ValueError, match="want at= to choose one of the two"):
        both.to_polydata(tetrahedron)
    assert "value" in both.to_polydata(tetrahedron, at="faces").cell_data


@pytest.mark.slow
def test_the_accessor_comes_by_entry_point(child_environment):
    """The process has imported PyVista alone."""
    import subprocess

    code = "import pyvista as pv; print(pv.Sphere().warpsample.sample_directions(2).n_points)"
    done = subprocess.run([sys.executable, "-c", code], env=child_environment, capture_output=True, text=True, check=True)
    assert done.stdout.split()[-1] == str(2 * pv.Sphere().n_points)


def test_the_accessor_gives_what_the_functions_give(ball):
    mesh = ws.as_mesh(ball)
    cloud = ball.warpsample.sample_directions(
        12, distribution="uniform_sphere", points=30, scale=0.5, seed=4, sequence="r2", pdf=True
    )
    points = ws.sample_surface(mesh, 30, seed=4)
    assert cloud == ws.sample_directions(
        points, 12, distribution="uniform_sphere", sequence="r2", seed=4, pdf=True
    ).to_polydata(points, 0.5)
    shaded = ball.warpsample.ambient_occlusion(32, seed=2)
    right = ws.ambient_occlusion(mesh, ws.vertex_points(mesh), 32, seed=2)
    assert np.array_equal(shaded["ambient_occlusion"], right.value)
    assert np.array_equal(shaded["standard_error"], right.standard_error)
    assert "ambient_occlusion" not in ball.point_data
    seen = ball.warpsample.sky_view_factor(32, at="faces")
    assert np.array_equal(seen.cell_data["sky_view_factor"], ws.sky_view_factor(mesh, ws.face_centers(mesh), 32).value)
    with pytest.raises(ValueError, match="^at: got 'corners', want one of vertices, faces"):
        ball.warpsample.ambient_occlusion(32, at="corners")


def test_the_accessor_follows_its_mesh(ball):
    """When the ball is moved, so is its shadow; until then the tree is kept."""
    moved = ball.copy()
    before = moved.warpsample.mesh
    assert moved.warpsample.mesh is before
    shadow = moved.warpsample.ambient_occlusion(64)["ambient_occlusion"]
    moved.points[4:, 0] += 50.0  # the plane's four corners come first
    assert moved.warpsample.mesh is not before
    assert moved.warpsample.ambient_occlusion(64)["ambient_occlusion"][:4].mean() > shadow[:4].mean()


def test_polygons_are_cut(ball):
    """A mesh of quads and triangles gets numbers at its own vertices, and at the faces of its triangles."""
    mixed = pv.Plane(i_resolution=2, j_resolution=2).merge(pv.Sphere(center=(0, 0, 2.0))).extract_surface(algorithm=None)
    assert mixed.warpsample.ambient_occlusion(32).n_cells == mixed.n_cells
    assert mixed.warpsample.ambient_occlusion(32, at="faces").n_cells == mixed.n_cells + 4


@pytest.mark.parametrize("suffix", [".vtp", ".ply"])
def test_a_cloud_in_a_file(call, cube, tmp_path, suffix):
    output = tmp_path / f"cloud{suffix}"
    status, out, err = call("directions", cube, "-o", output, "--points", 9, "--samples", 5, "--seed", 2)
    assert (status, err, out) == (0, "", f"{output}: 45 directions at 9 points\n")
    mesh = ws.load_mesh(cube)
    points = ws.sample_surface(mesh, 9, seed=2)
    w = ws.sample_directions(points, 5, seed=2).vectors
    found = pv.read(output)
    scale = export.CLOUD_SCALE * np.sqrt(3.0)
    assert np.abs(found.points - (points.position[:, None] + scale * w).reshape(-1, 3)).max() <= 1e-6
    assert np.abs(found.point_data["Normals"] - w.reshape(-1, 3)).max() <= 1e-6
    assert list(tmp_path.glob(".*")) == []


def test_a_cloud_needs_room(call, cube, tmp_path):
    huge = ("--points", 1000, "--samples", 100_000_000)
    status, _, err = call("directions", cube, "-o", tmp_path / "cloud.vtp", *huge)
    assert status == 2
    assert err.startswith("error: the 100,000,000,000 directions of the cloud need")
    assert err.endswith("take fewer, or write .npz, which is streamed\n")
    assert set(tmp_path.iterdir()) == {cube}
