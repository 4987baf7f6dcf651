"""Regular grids of points: where they are, where there are none, and how far they are apart."""

import numpy as np
import pytest
import trimesh

import warpsample as ws
from warpsample.mesh.points.lattice import lattice_points


def box(low, high):
    return ws.as_mesh(trimesh.creation.box(bounds=(low, high)))


def quad(*corners):
    return np.array(corners, float), np.array([[0, 1, 2], [0, 2, 3]])


def together(*meshes):
    """One mesh of several."""
    starts = np.cumsum([0, *(len(v) for v, _ in meshes)])
    return ws.as_mesh(
        (np.concatenate([v for v, _ in meshes]), np.concatenate([f + s for (_, f), s in zip(meshes, starts, strict=False)]))
    )


def plate(size, z=0.0, at=(0.0, 0.0), down=False):
    x, y = at
    ends = [(x, y, z), (x + size, y, z), (x + size, y + size, z), (x, y + size, z)]
    return quad(*(ends[::-1] if down else ends))


def cube(low, size):
    mesh = box(low, np.add(low, size))
    return mesh.vertices, mesh.faces


def test_a_grid_above_flat_ground_is_a_lattice_in_odd_halves():
    points = ws.grid_points(plate(10.0), 0.5)
    middles = np.arange(20) * 0.5 + 0.25
    x, y = np.meshgrid(middles, middles)
    want = np.stack([x.ravel(), y.ravel(), np.full(400, 1.5)], axis=1)
    assert np.array_equal(points.position, want)
    assert (points.normal == (0.0, 0.0, 1.0)).all()
    assert (points.face == -1).all()


def test_neighbouring_meshes_have_one_grid():
    whole = ws.grid_points(plate(8.0), 0.5, height=0.0)
    half = ws.grid_points(plate(4.0), 0.5, height=0.0)
    rows = (whole.position[:, :2] < 4.0).all(axis=1)
    assert np.array_equal(whole.position[rows], half.position)
    assert set(whole.face) == {0, 1}


def test_a_slope_is_followed_and_a_wall_is_not_walked_on():
    slope = quad((0, 0, 0), (4, 0, 4), (4, 4, 4), (0, 4, 0))
    points = ws.grid_points(slope, 1.0, height=2.0)
    assert len(points) == 16
    assert np.allclose(points.position[:, 2], points.position[:, 0] + 2.0, rtol=0, atol=1e-14)
    steep = quad((0, 0, 0), (4, 0, 40), (4, 4, 40), (0, 4, 0))  # 84 degrees
    assert len(ws.grid_points(steep, 1.0)) == 0


def test_there_are_none_in_bodies_nor_where_the_head_hits_something():
    """On a plate of 12: a house of 4 on it, a table at 1 m, and a roof of its own at 5 m, each with its underside."""
    house, table = cube((1.0, 1.0, 0.0), (4.0, 4.0, 4.0)), cube((7.0, 1.0, 1.0), (3.0, 3.0, 0.1))
    roof = cube((1.0, 7.0, 5.0), (3.0, 3.0, 0.5))
    mesh = together(plate(12.0), house, table, roof)
    points = ws.grid_points(mesh, 1.0, height=1.5)
    z = points.position[:, 2]
    counts = {height: int(np.count_nonzero(np.isclose(z, height))) for height in (1.5, 5.5, 2.6, 7.0)}
    assert counts == {1.5: 144 - 16 - 9, 5.5: 16, 2.6: 9, 7.0: 9}
    assert sum(counts.values()) == len(points)
    under = (points.position[:, :2] > (1.0, 7.0)).all(axis=1) & (points.position[:, :2] < (4.0, 10.0)).all(axis=1)
    assert set(z[under]) == {1.5, 7.0}  # below the roof and on it
    low = ws.grid_points(mesh, 1.0, height=0.5)
    assert np.count_nonzero(low.position[:, 2] == 0.5) == 144 - 16  # below the table, too
    ground = np.arange(len(mesh.faces)) < 2
    assert set(ws.grid_points(mesh, 1.0, faces=ground).position[:, 2]) == {1.5}


@pytest.mark.parametrize("up", [(0, 0, 1), (0, 1, 0), (1, 0, 0), (1, 2, 3)])
def test_up_is_what_the_caller_says(up):
    """The scene turned has the points turned."""
    unit = np.array(up) / np.linalg.norm(up)
    near = np.array([1.0, 0, 0]) if up != (1, 0, 0) else np.array([0, 1.0, 0])
    x = near - near @ unit * unit
    x /= np.linalg.norm(x)
    turn = np.stack([x, np.cross(unit, x), unit])
    flat, house = plate(6.0), cube((1.0, 1.0, 0.0), (2.0, 2.0, 3.0))
    mesh = together(flat, house)
    turned = ws.grid_points((mesh.vertices @ turn, mesh.faces), 1.0, up=up)
    assert np.allclose(turned.position, ws.grid_points(mesh, 1.0).position @ turn, rtol=0, atol=1e-12)


def test_a_box_has_a_grid_on_each_side():
    points = ws.grid_points(box((0, 0, 0), (4, 5, 6)), 1.0, on="faces")
    assert len(points) == 2 * (20 + 24 + 30)
    assert np.allclose(np.round(2.0 * points.position), 2.0 * points.position)
    mesh = box((0, 0, 0), (4, 5, 6))
    corners = mesh.vertices[mesh.faces[points.face]]
    assert np.allclose(points.position, (points.barycentric[:, :, None] * corners).sum(axis=1))
    assert np.array_equal(points.normal, mesh.face_normals[points.face])
    off = ws.grid_points(mesh, 1.0, on="faces", height=0.25)
    assert np.allclose(off.position, points.position + 0.25 * points.normal)
    assert (off.face == -1).all()


def test_a_grid_lies_in_the_middle_and_small_parts_have_their_centre():
    points = ws.grid_points(plate(2.5), 1.0, on="faces")
    assert sorted({*points.position[:, 0]}) == [0.75, 1.75]
    corner = [(0, 0, 0), (3, 0, 0), (3, 1, 0), (1, 1, 0), (1, 3, 0), (0, 3, 0)]  # the middle of its square is not on it
    ell = ws.grid_points((corner, [[0, 1, 2], [0, 2, 3], [0, 3, 4], [0, 4, 5]]), 3.0, on="faces")
    assert np.allclose(ell.position, [[2.0, 1 / 3, 0.0]])


def test_a_city_far_from_the_origin_keeps_its_grid():
    far = np.array([5e6, 4e6, 100.0])
    mesh = box((0, 0, 0), (30, 30, 30))
    near, moved = (ws.grid_points((mesh.vertices + shift, mesh.faces), 1.0, on="faces") for shift in (0.0, far))
    assert np.allclose(moved.position - far, near.position, rtol=0, atol=4 * np.spacing(5e6))


def test_no_point_falls_between_triangles_of_a_fan():
    """Lattice points on edges and at the hub are found, whichever way the edges run."""
    angle = np.arange(12) * np.pi / 6
    rim = 10.0 * np.stack([np.cos(angle), np.sin(angle)], axis=1)
    hub = np.array([3.0, 2.0])
    corners = np.array([[hub, rim[k], rim[(k + 1) % 12]][:: 1 if k % 2 else -1] for k in range(12)])
    found = {tuple(place) for place in lattice_points(corners).place}
    x, y = np.meshgrid(np.arange(-10, 11), np.arange(-10, 11))
    normals = np.stack([np.cos(angle + np.pi / 12), np.sin(angle + np.pi / 12)], axis=1)
    inside = (np.stack([x, y], axis=-1) @ normals.T < 10.0 * np.cos(np.pi / 12) - 1e-9).all(axis=-1)
    assert set(zip(x[inside], y[inside], strict=True)) <= found
    assert (3, 2) in found


@pytest.mark.parametrize(
    ("given", "error", "match"),
    [
        ({"spacing": 0.0}, ValueError, "spacing: got 0.0, want a number from"),
        ({"spacing": "1"}, TypeError, "spacing: got '1'"),
        ({"height": -1.0}, ValueError, "height: got -1.0, want a number from 0"),
        ({"on": "roofs"}, ValueError, "on: got 'roofs', want one of ground, faces"),
        ({"faces": [0, 1]}, TypeError, r"faces: got dtype int64, want \(12,\) bool"),
        ({"faces": [True]}, ValueError, r"faces: got shape \(1,\), want \(12,\) bool"),
        ({"faces": [False] * 12}, ValueError, "faces: got only faces without an area"),
        ({"up": (0, 0, 0)}, ValueError, "up: got"),
        ({"spacing": 1e-9}, MemoryError, "need .* GB and .* are free; widen the spacing"),
    ],
)
def test_arguments_without_sense_are_reported(given, error, match):
    with pytest.raises(error, match=match):
        ws.grid_points(box((0, 0, 0), (1, 1, 1)), **{"spacing": 0.1, **given})
