"""The triangles of rasters: where cells share corners, where walls stand and which way they face, whatever the transform."""

import numpy as np
import pytest
from affine import Affine
from raster_cases import NORTH_UP, corners_of, flux, rough

from warpsample import rasters

pytest.importorskip("rasterio")
pytest.importorskip("rioxarray")

MODELS = ("joined", "block", "tin")
LONG, SHEARED = Affine(1.0, 0.0, 0.0, 0.0, 4.0, 0.0), Affine(3.0, 0.5, 0.0, 0.2, -0.5, 0.0)
TURNED = Affine.translation(563999.5, 5147000.25) @ Affine.rotation(33.0) @ Affine.scale(0.5, -0.5)


def surface(heights, transform=NORTH_UP, model="joined"):
    return rasters.surface((heights, transform, None), model=model)


def test_a_step_has_a_wall_of_its_height_that_faces_the_lower_cell():
    for transform in (NORTH_UP, Affine(1.0, 0.0, 0.0, 0.0, 1.0, 0.0), Affine(-1.0, 0.0, 0.0, 0.0, -1.0, 0.0)):
        for heights, towards in (([[9.0, 2.0]], (1, 0)), ([[2.0, 9.0]], (-1, 0)), ([[9.0], [2.0]], (0, 1))):
            made = surface(np.array(heights), transform)
            wall = made.kind == 1
            assert made.mesh.face_areas[wall].sum() == 7.0
            facing = np.array(transform @ towards) - np.array(transform @ (0, 0))
            assert np.array_equal(made.mesh.face_normals[wall], np.tile([*facing, 0.0], (2, 1)))
            assert set(made.cell[wall]) == {int(np.argmax(heights))}
            assert np.array_equal(made.mesh.face_normals[~wall], np.tile([0.0, 0.0, 1.0], (4, 1)))
            assert sorted(made.cell[~wall]) == [0, 0, 1, 1]


def ring_mean(heights, row, column, corner):
    """The height of a corner of a cell, by a walk over the ring of four cells about it; `corner` is its (row, column)."""
    ring = [(corner[0] - 1, corner[1] - 1), (corner[0] - 1, corner[1]), corner, (corner[0], corner[1] - 1)]
    ring = [cell if 0 <= cell[0] < heights.shape[0] and 0 <= cell[1] < heights.shape[1] else None for cell in ring]
    found, new = set(), {ring.index((row, column))}
    while new:
        found |= new
        near = {(k, (k + way) % 4) for k in new for way in (-1, 1)}
        new = {m for k, m in near if ring[m] and abs(heights[ring[m]] - heights[ring[k]]) <= 2.0} - found
    return np.mean([heights[ring[k]] for k in found])


def test_the_corners_of_joined_cells_are_means_of_what_is_a_step_apart_in_the_ring():
    heights = rough()
    heights[6, 6] = heights[9, 2] = np.nan
    made = surface(heights)
    for row, column in np.argwhere(~np.isnan(heights)):
        corners = made.mesh.vertices[made.mesh.faces[(made.kind == 0) & (made.cell == row * 11 + column)]].reshape(-1, 3)
        found = {(-y, x): z for x, y, z in corners}
        for corner in ((row, column), (row, column + 1), (row + 1, column), (row + 1, column + 1)):
            assert found.pop(corner) == pytest.approx(ring_mean(heights, row, column, corner), abs=1e-12)
        assert found in ({}, {(row + 0.5, column + 0.5): heights[row, column]})
    assert set(made.cell) == set(np.flatnonzero(~np.isnan(heights)))


@pytest.mark.parametrize("model", MODELS)
@pytest.mark.parametrize("transform", [NORTH_UP, LONG, SHEARED])
def test_a_pit_holds_the_same_volume_by_all_three_coordinates(model, transform):
    """A hole, an overlap, or a wall that faces inwards breaks it; on long cells edges of neighbours cross."""
    heights = rough() - 9.0  # the rim, and with it the lid, is at 0
    made = surface(heights, transform, model)
    sums = flux(made.mesh)
    volume = np.diag(sums)
    area = abs(transform.determinant)
    if model == "block":
        assert volume[2] == pytest.approx(heights.sum() * area, rel=1e-12)
    else:  # about the same: corners are shared
        assert volume[2] == pytest.approx(heights.sum() * area, rel=0.15)
    assert np.allclose(volume, volume[2], rtol=1e-10)
    assert np.allclose((sums - np.diag(volume))[:, :2], 0.0, atol=1e-9 * abs(volume[2]))
    border = 1.0 if model == "tin" else 0.0  # half a cell on each side
    plan = area * (heights.shape[0] - border) * (heights.shape[1] - border)
    assert np.allclose(0.5 * made.mesh.cross_products.sum(axis=0), [0.0, 0.0, plan], atol=1e-9)
    assert (made.mesh.face_areas > 0.0).all()
    assert made.mesh.report.duplicate_faces == 0
    if model != "tin":
        walls = made.mesh.face_normals[made.kind == 1]
        assert abs(walls[:, 2]).max() < 1e-6
    assert (made.mesh.face_normals[made.kind == 0][:, 2] > 0.0).all()


def test_edges_of_long_cells_cross_in_a_vertex():
    """The law above has nothing to say of them if there are none."""
    made = surface(rough(), LONG)
    x, y, _ = made.mesh.vertices.T
    off = (x % 0.5 > 1e-9) | ((y / 4.0) % 0.5 > 1e-9)
    assert 0 < off.sum() < 20


def by_cell(made, numbers):
    """Area, area vector and mean height of the triangles of each cell's top and of its walls; cells by their `numbers`."""
    mesh, key = made.mesh, 2 * numbers.ravel()[made.cell] + made.kind
    columns = [mesh.face_areas, *mesh.cross_products.T, mesh.face_areas * mesh.vertices[mesh.faces, 2].mean(axis=1)]
    return np.stack([np.bincount(key, column, 2 * numbers.size) for column in columns])


@pytest.mark.parametrize("model", MODELS)
def test_a_raster_stored_another_way_is_the_same_surface(model):
    heights = rough() + np.random.default_rng(1).uniform(0.0, 0.01, (14, 11)) * (model == "tin")  # no square is flat
    heights[3, 3] = np.nan
    rows, columns = heights.shape
    numbers = np.arange(heights.size).reshape(heights.shape)
    right = surface(heights, TURNED, model)
    a, b, c, d, e, f = TURNED[:6]
    for store, transform in (
        (lambda array: array[::-1], TURNED @ Affine(1.0, 0.0, 0.0, 0.0, -1.0, rows)),
        (lambda array: array[:, ::-1], TURNED @ Affine(-1.0, 0.0, columns, 0.0, 1.0, 0.0)),
        (lambda array: array.T, Affine(b, a, c, e, d, f)),
        (np.rot90, TURNED @ Affine(0.0, -1.0, columns, 1.0, 0.0, 0.0)),
    ):
        found = surface(store(heights), transform, model)
        if model == "tin":  # whose squares belong to no cell in particular
            assert np.allclose(corners_of(found.mesh), corners_of(right.mesh), atol=3e-6)  # coordinates of 5e6, rounded
        else:
            assert np.allclose(by_cell(found, store(numbers)), by_cell(right, numbers), atol=1e-6)


@pytest.mark.parametrize("model", MODELS)
def test_turning_scaling_and_raising_move_the_same_triangles(model):
    heights = rough()
    right = surface(heights, NORTH_UP, model).mesh
    turned = surface(heights, Affine.rotation(-71.0) @ NORTH_UP, model).mesh
    assert np.array_equal(turned.faces, right.faces)
    angle = np.radians(-71.0)
    turn = np.array([[np.cos(angle), -np.sin(angle), 0.0], [np.sin(angle), np.cos(angle), 0.0], [0.0, 0.0, 1.0]])
    assert np.allclose(turned.vertices, right.vertices @ turn.T)
    large = surface(3.0 * heights, NORTH_UP @ Affine.scale(3.0), model).mesh
    raised = surface(heights + 1024.0, NORTH_UP, model).mesh
    assert np.array_equal(large.faces, right.faces)
    assert np.allclose(large.vertices, 3.0 * right.vertices)
    assert np.array_equal(raised.faces, right.faces)
    assert np.allclose(raised.vertices, right.vertices + np.array([0.0, 0.0, 1024.0]))
    mirrored = surface(heights, Affine.scale(-1.0, 1.0) @ NORTH_UP, model).mesh
    assert np.allclose(corners_of(mirrored)[:, 2::3].sum(), corners_of(right)[:, 2::3].sum())
    assert np.allclose(flux(mirrored), flux(right) * [[1.0, -1.0, -1.0], [-1.0, 1.0, 1.0], [-1.0, 1.0, 1.0]])


@pytest.mark.parametrize("model", MODELS)
def test_nothing_stands_where_there_is_no_height(model):
    heights = rough()
    hole = np.zeros(heights.shape, bool)
    hole[7:9, 3:6] = True
    made = surface(np.where(hole, np.nan, heights), NORTH_UP, model)
    x, y, _ = made.mesh.vertices[made.mesh.faces].mean(axis=1).T
    around = 0.5 if model == "tin" else 0.0  # centres take their squares with them
    assert len(x) > 0
    assert ((x <= 3 - around) | (x >= 6 + around) | (-y <= 7 - around) | (-y >= 9 + around)).all()
    assert not np.isin(made.cell, np.flatnonzero(hole)).any()
    points, cell = made.points()
    assert np.array_equal(cell, np.flatnonzero(~hole))
    assert np.array_equal(points.position[:, 2], heights.ravel()[cell])
    laid = made.to_raster(points.position[:, 2].astype(np.float32), cell)
    assert laid.dtype == np.float32
    assert np.array_equal(np.isnan(laid), hole)


@pytest.mark.parametrize("transform", [NORTH_UP, Affine(1, 0, 0, 0, 1, 0)])
@pytest.mark.parametrize("model", MODELS)
def test_walls_next_to_cells_without_data_reach_the_ground(model, transform):
    """A house of 5 m beside a strip of 2 cells without data, behind which is the ground."""
    heights = np.array([[5.0, 5.0, np.nan, np.nan, 0.0, 0.0]] * 4)
    made = surface(heights, transform, model)
    walls = made.kind == 1
    corners = made.mesh.vertices[made.mesh.faces[walls]]
    assert corners.shape == (6 if model == "tin" else 8, 3, 3)
    assert (corners[..., 0] == (1.5 if model == "tin" else 2.0)).all()
    assert np.array_equal(np.unique(corners[..., 2]), [0.0, 5.0])
    assert np.allclose(made.mesh.face_normals[walls], [1.0, 0.0, 0.0])
    assert made.mesh.face_areas[walls].sum() == pytest.approx(5.0 * (3 if model == "tin" else 4))
    assert (made.cell[walls] % 6 == 1).all()
    border = surface(np.pad(np.full((3, 3), 5.0), 1, constant_values=np.nan), transform, model)
    assert (border.kind == 0).all()  # nothing is behind cells without data along the outside


def test_map_coordinates_are_exact():
    made = surface(np.zeros((3, 4)), Affine(0.5, 0.0, 563999.5, 0.0, -0.5, 5147000.25))
    assert np.array_equal(np.unique(made.mesh.vertices[:, 0]), 563999.5 + 0.5 * np.arange(5))
    points, cell = made.points()
    assert np.array_equal(points.position[5], [564000.25, 5146999.5, 0.0])
    assert cell[5] == 5


def test_a_receiver_on_a_slope_has_its_normal_on_each_model():
    row, column = np.mgrid[:5, :6]
    slope = np.array([-0.3, 0.4, 1.0])  # of a plane that rises to the east and, rows going south, falls to the north
    heights = 0.3 * column + 0.4 * row
    for model in ("joined", "tin"):
        points, cell = surface(heights, model=model).points("surface")
        inner = np.isin(cell, np.arange(30).reshape(5, 6)[1:-1, 1:-1])
        assert np.allclose(points.normal[inner], slope / np.linalg.norm(slope), atol=1e-6)
    for model, receiver in (("block", "surface"), ("joined", "horizontal"), ("tin", "horizontal")):
        points, _ = surface(heights, model=model).points(receiver)
        assert np.array_equal(points.normal, np.tile(np.float32([0.0, 0.0, 1.0]), (30, 1)))
