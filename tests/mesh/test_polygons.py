"""The triangles of a polygon cover it once, whatever its shape, and keep its orientation."""

from math import pi

import numpy as np
import pytest

from warpsample.mesh.polygons import triangles


def areas(points, faces):
    first, second = points[faces[:, 1]] - points[faces[:, 0]], points[faces[:, 2]] - points[faces[:, 0]]
    return 0.5 * np.cross(first, second)


def area_of(polygon):
    return 0.5 * np.cross(polygon, np.roll(polygon, -1, axis=0)).sum(axis=0)


def star(corners, seed):
    """A polygon around the origin that is hardly ever convex, in any plane."""
    rng = np.random.default_rng(seed)
    angle = 2.0 * pi * (np.arange(corners) + rng.uniform(0.0, 0.7, corners)) / corners
    flat = rng.uniform(0.1, 1.0, (corners, 1)) * np.stack([np.cos(angle), np.sin(angle)], axis=1)
    axes = np.linalg.qr(rng.normal(size=(3, 3)))[0]
    return np.roll(flat @ axes[:2], rng.integers(corners), axis=0)


@pytest.mark.parametrize("offset", [0.0, 5e6])
def test_polygons_that_are_not_convex(offset):
    polygons = [star(corners, seed) for seed in range(40) for corners in (3, 4, 5, 9, 30)]
    counts = np.array([len(polygon) for polygon in polygons])
    points = np.vstack(polygons) + offset
    faces = triangles(points, counts, np.arange(len(points), dtype=np.int32))
    assert len(faces) == (counts - 2).sum()
    owner = np.repeat(np.arange(len(counts)), counts - 2)
    for number, polygon in enumerate(polygons):
        cut, whole = areas(points - offset, faces[owner == number]), area_of(polygon)
        assert np.abs(cut.sum(axis=0) - whole).max() <= 1e-7
        assert np.linalg.norm(cut, axis=1).sum() == pytest.approx(np.linalg.norm(whole), abs=1e-7)  # none overlaps another


def test_a_comb_a_hole_with_a_bridge_and_corners_in_a_line():
    comb = [
        (0.0, -1.0),
        (12.0, -1.0),
        *((x, y) for k in range(6, 0, -1) for x, y in ((2.0 * k, 0.0), (2.0 * k, 5.0), (2.0 * k - 1, 1.0))),
    ]
    holed = [(0, 0), (4, 0), (4, 4), (0, 4), (0, 0), (1, 1), (1, 2), (2, 2), (2, 1), (1, 1)]
    lined = [(0, 0), (1, 0), (2, 0), (2, 1), (1, 1), (1, 2), (1, 3), (0, 3)]
    for polygon in (comb, holed, lined):
        points = np.pad(np.float64(polygon), ((0, 0), (0, 1)))
        faces = triangles(points, np.array([len(points)]), np.arange(len(points)))
        assert len(faces) == len(points) - 2
        assert np.abs(areas(points, faces)[:, 2]).sum() == pytest.approx(abs(area_of(points)[2]))


@pytest.mark.parametrize(
    ("counts", "indices", "message"),
    [
        ([3], [0, 1], "the 1 faces need 3 corners, but there are 2"),
        ([3, 2], [0, 1, 2, 0, 1], "face 1 has 2 corners, want at least 3"),
        ([4], [0, 1, 2, 3], "a face has the vertex 3, want a vertex from 0 to 2"),
        ([3], [0, 1, -1], "a face has the vertex -1, want a vertex from 0 to 2"),
    ],
)
def test_what_is_no_polygon_is_named(counts, indices, message):
    with pytest.raises(ValueError, match=f"^{message}$"):
        triangles(np.eye(3), np.array(counts), np.array(indices))


def test_corners_that_repeat_or_lie_in_a_line_leave_triangles_without_area():
    notch = [(0, 0), (0, 0), (4, 0), (4, 4), (2, 1), (2, 1), (0, 4), (0, 2), (0, 1)]
    points = np.pad(np.float64(notch), ((0, 0), (0, 1)))
    faces = triangles(points, np.array([len(points)]), np.arange(len(points)))
    found = areas(points, faces)[:, 2]
    assert (len(faces), np.count_nonzero(found)) == (7, 5)  # a triangle less for each repeated corner
    assert (found >= 0.0).all()
    assert found.sum() == pytest.approx(area_of(points)[2])
    assert len(np.unique(points[faces[found > 0.0]].reshape(-1, 3), axis=0)) == 7  # none in a line is left out


def test_a_polygon_that_crosses_itself_stays_a_fan():
    """Its triangles overlap, and none of its corners is lost."""
    points = np.array([(2, 0, 0), (1, 4, 0), (0, 4, 0), (3, 2, 0), (4, 4, 0)], float)
    assert triangles(points, np.array([5]), np.arange(5)).tolist() == [[0, 1, 2], [0, 2, 3], [0, 3, 4]]
    bow = np.array([(0, 0, 0), (1, 1, 0), (1, 0, 0), (0, 1, 0)], float)
    assert triangles(bow, np.array([4]), np.arange(4)).tolist() == [[0, 1, 2], [0, 2, 3]]


def test_a_polygon_of_ten_thousand_corners_is_covered_once():
    points = star(10_000, 1)
    faces = triangles(points, np.array([len(points)]), np.arange(len(points)))
    assert np.linalg.norm(areas(points, faces), axis=1).sum() == pytest.approx(np.linalg.norm(area_of(points)), abs=1e-7)
