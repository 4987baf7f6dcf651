"""Meshes of every kind that users hold, and every fault that a mesh can have."""

import meshio
import numpy as np
import pytest
import pyvista as pv
import trimesh

import warpsample as ws

CUBE = trimesh.creation.box()


def test_bunny(bunny_path):
    report = ws.load_mesh(bunny_path).report
    assert (report.faces, report.degenerate_faces, report.boundary_edges, report.inconsistent_edges) == (
        12_200,
        0,
        0,
        0,
    )


def test_what_users_hold():
    box = pv.Box()  # quads
    held = [
        CUBE,
        (CUBE.vertices, CUBE.faces),
        (CUBE.vertices.tolist(), CUBE.faces.tolist()),
        pv.wrap(CUBE),
        meshio.Mesh(CUBE.vertices, [("triangle", CUBE.faces)]),
        ws.Mesh(CUBE.vertices, CUBE.faces),
    ]
    for value in held:
        mesh = ws.as_mesh(value)
        assert mesh.report.area == pytest.approx(6.0)
        assert mesh.report.faces == 12
    assert ws.as_mesh(box).report.area == pytest.approx(24.0)
    assert ws.as_mesh(held[-1]) is held[-1]


def test_polygons_of_meshio_are_cut_and_none_is_dropped():
    points = [(0, 0), (2, 0), (2, 2), (0, 2), (4, 0), (5, 1), (4, 2)]
    held = meshio.Mesh(
        np.pad(np.float64(points), ((0, 0), (0, 1))),
        [
            ("vertex", [[0]]),
            ("line", [[0, 1]]),
            ("triangle", [[0, 1, 2]]),
            ("quad", [[0, 1, 2, 3]]),
            ("polygon", [[1, 4, 5, 6, 2]]),
            ("triangle", [[0, 2, 3]]),
        ],
    )
    mesh = ws.as_mesh(held)
    assert mesh.report.faces == 1 + 2 + 3 + 1
    assert mesh.report.area == pytest.approx(2.0 + 4.0 + 5.0 + 2.0)
    assert (mesh.face_normals == (0, 0, 1)).all()
    held.cells.append(meshio.CellBlock("tetra", [[0, 1, 2, 3]]))
    with pytest.raises(ValueError, match=r"^mesh: got cells of type tetra, want only triangle, quad and polygon$"):
        ws.as_mesh(held)
    with pytest.raises(ValueError, match=r"^mesh: got a meshio.Mesh whose cells are not faces: a face has the vertex 9"):
        ws.as_mesh(meshio.Mesh(held.points, [("quad", [[0, 1, 2, 9]])]))


def test_strips_of_polydata_are_not_dropped():
    strip = pv.PolyData(np.float64([(0, 0, 0), (1, 0, 0), (0, 1, 0), (1, 1, 0)]), strips=[4, 0, 1, 2, 3], faces=[3, 0, 1, 3])
    assert ws.as_mesh(strip).report.faces == 3


def test_report_counts_faults():
    v = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (1, 1, 0), (0, 0, 1), (9, 9, 9), (0.5, 0, 0)]
    f = [
        (0, 1, 2),  # agrees with the next along its diagonal
        (1, 3, 2),
        (0, 1, 4),  # runs along 0-1 like the first
        (2, 0, 1),  # the first again
        (0, 1, 1),  # no area: a corner twice
        (0, 6, 1),  # no area: collinear
    ]
    report = ws.Mesh(np.array(v, float), np.array(f)).report
    assert report.degenerate_faces == 2
    assert report.duplicate_faces == 1
    assert report.unreferenced_vertices == 1
    assert report.inconsistent_edges >= 1
    assert report.nonmanifold_edges >= 1
    assert report.area == pytest.approx(2.0)


def test_closed_cube_is_clean():
    report = ws.as_mesh(CUBE).report
    assert (report.boundary_edges, report.nonmanifold_edges, report.inconsistent_edges, report.duplicate_faces) == (0,) * 4
    flipped = CUBE.faces.copy()
    flipped[0] = flipped[0, ::-1]
    assert ws.Mesh(CUBE.vertices, flipped).report.inconsistent_edges == 3


@pytest.mark.parametrize("offset", [0.0, 5e6])
@pytest.mark.parametrize("scale", [1e-6, 1.0, 1e6])
def test_normals_and_areas_hold_at_any_scale_and_place(scale, offset):
    mesh = ws.Mesh(CUBE.vertices * scale + (0.0 if scale < 1 else offset), CUBE.faces)
    assert mesh.report.area == pytest.approx(6.0 * scale**2, rel=1e-8)
    assert np.allclose(np.abs(mesh.face_normals).max(axis=1), 1.0)
    assert mesh.report.degenerate_faces == 0


def test_slivers_with_a_meaningless_normal_are_degenerate():
    x = 1e-3
    v = np.array([(0, 0, 0), (1, x, 0), (2, 2 * x * (1 + 1e-16), 0), (0, 1e-9, 0)])
    mesh = ws.Mesh(v, np.array([(0, 1, 2), (0, 1, 3)]))
    assert (mesh.face_areas == 0.0).tolist() == [True, False]
    assert mesh.face_normals[0].tolist() == [0, 0, 0]


V, F = np.eye(3), np.array([[0, 1, 2]])


@pytest.mark.parametrize(
    ("vertices", "faces", "error", "message"),
    [
        (np.eye(3)[:, :2], F, ValueError, r"vertices: got shape \(3, 2\), want \(V, 3\)"),
        (np.empty((0, 3)), F, ValueError, r"vertices: got shape \(0, 3\)"),
        (V.astype(complex), F, TypeError, "vertices: got dtype complex128, want real numbers"),
        (
            np.array([[0, 0, np.nan], [0, np.inf, 0], [1, 0, 0]]),
            F,
            ValueError,
            "vertices: got coordinates that are not finite, the first in row",
        ),
        (V, np.empty((0, 3), int), ValueError, r"faces: got shape \(0, 3\), want \(F, 3\) with F of at least 1"),
        (V, np.array([[0, 1, 2, 0]]), ValueError, r"faces: got shape \(1, 4\)"),
        (V, F.astype(float), TypeError, "faces: got dtype float64, want whole numbers"),
        (
            V,
            np.array([[0, 1, 3]]),
            ValueError,
            r"faces: got indices from 0 to 3, the first wrong one in face 0, \[0 1 3\], want 0 to 2$",
        ),
        (V, np.array([[0, 1, -1]]), ValueError, "faces: got indices from -1 to 1, the first wrong one in face 0"),
    ],
)
def test_bad_arrays_are_named(vertices, faces, error, message):
    with pytest.raises(error, match="^" + message):
        ws.Mesh(vertices, faces)


def test_other_things_are_no_mesh():
    with pytest.raises(TypeError, match="^mesh: got a value of type int, want a warpsample.Mesh, a tuple"):
        ws.as_mesh(3)
    with pytest.raises(TypeError, match="^mesh: got 'bunny.ply', want a mesh; warpsample.load_mesh reads files"):
        ws.as_mesh("bunny.ply")
    with pytest.raises(ValueError, match=r"^faces: got shape \(0, 3\)"):
        ws.as_mesh(meshio.Mesh(CUBE.vertices, [("line", [[0, 1]])]))


@pytest.mark.parametrize("scale", [1e-90, 1e-40, 1e35])
def test_areas_and_normals_of_sizes_whose_squares_are_no_float64(scale):
    mesh, plain = ws.Mesh(scale * CUBE.vertices, CUBE.faces), ws.Mesh(CUBE.vertices, CUBE.faces)
    assert mesh.face_areas / scale / scale == pytest.approx(plain.face_areas, rel=1e-14)
    assert np.abs(mesh.face_normals - plain.face_normals).max() <= 1e-7
    assert mesh.report.degenerate_faces == 0


def test_blocks_of_faces_change_no_bit(bunny, monkeypatch):
    assert len(bunny.faces) % 4096
    monkeypatch.setattr("warpsample.mesh.mesh._BLOCK", 4096)
    assert np.array_equal(ws.Mesh(bunny.vertices, bunny.faces).cross_products, bunny.cross_products)
