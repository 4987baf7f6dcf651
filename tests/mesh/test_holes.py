"""Faces with holes: areas by Newell's formula, and triangles that cover them once, in any plane."""

import numpy as np
import pytest

from warpsample.mesh.holes import Outlines

SQUARES = [(0.0, 10.0), (2.0, 4.0), (6.0, 7.0)]


def square(low, high):
    return np.float64([(low, low), (high, low), (high, high), (low, high)])


def outlines(rings, of_faces):
    sizes = np.array([len(ring) for ring in rings])
    return Outlines(np.arange(sizes.sum()), sizes, np.array(of_faces))


def turned(rings, seed, offset):
    """The points of flat rings in a plane of any direction, far away."""
    axes = np.linalg.qr(np.random.default_rng(seed).normal(size=(3, 3)))[0]
    return np.vstack(rings) @ axes[:2] + offset


@pytest.mark.parametrize("offset", [0.0, 5e6])
@pytest.mark.parametrize("seed", range(6))
@pytest.mark.parametrize("same_way", [False, True])
def test_holes_are_left_out(offset, seed, same_way):
    outer, *holes = [square(*ends) for ends in SQUARES]
    rings = [outer, *(hole if same_way else hole[::-1] for hole in holes), outer, outer[:2]]
    points = turned(rings, seed, offset)
    faces = outlines(rings, [3, 1, 1])
    assert faces.areas(points) == pytest.approx([95.0, 100.0, 0.0], rel=1e-8)
    triangles, owner = faces.triangles(points)
    crosses = 0.5 * np.cross(
        points[triangles[:, 1]] - points[triangles[:, 0]], points[triangles[:, 2]] - points[triangles[:, 0]]
    )
    normal = faces.crosses(points)[0]
    assert (crosses @ normal >= 0.0).all()
    assert np.bincount(owner, np.linalg.norm(crosses, axis=1)) == pytest.approx([95.0, 100.0], rel=1e-8)
    assert np.bincount(owner).tolist() == [12 + 2 * 2 - 2, 2]


def test_corners_that_repeat_and_holes_without_area():
    rings = [
        square(0, 10)[[0, 0, 1, 2, 2, 3]],
        square(2, 4)[[0, 3, 3, 2, 1]],
        square(5, 6)[:2],
        np.zeros((0, 2)),
        np.zeros((3, 2)),
    ]
    points = turned(rings, 1, 0.0)
    faces = outlines(rings, [5])
    triangles, _ = faces.triangles(points)
    crosses = np.cross(points[triangles[:, 1]] - points[triangles[:, 0]], points[triangles[:, 2]] - points[triangles[:, 0]])
    assert faces.areas(points) == pytest.approx([96.0])
    assert 0.5 * np.linalg.norm(crosses, axis=1).sum() == pytest.approx(96.0)
    empty = outlines([square(0, 1)[[0, 0, 0, 0]], square(0, 1)], [2])
    assert empty.areas(turned([square(0, 1)[[0, 0, 0, 0]], square(0, 1)], 1, 0.0)).tolist() == [0.0]
    assert len(empty.triangles(turned([square(0, 1)[[0, 0, 0, 0]], square(0, 1)], 1, 0.0))[0]) == 0
