"""Estimates against closed forms: streets, planes, a square, a disk, a sphere; and closed meshes, inside and outside."""

from math import cos, hypot, pi, sqrt

import numpy as np
import pytest
import trimesh
from estimate_cases import at, square, street
from meshes import CLOSED

import warpsample as ws

RAYS = 65_536

WIDTH, HEIGHT = 1.0, 1.7
ACROSS = (np.arange(64) + 0.5) / 64


def floor_sky(x):
    return 0.5 * (x / hypot(x, HEIGHT) + (WIDTH - x) / hypot(WIDTH - x, HEIGHT))


def wall_sky(z):
    """Sky view of a wall at height z, from the angle between the horizontal and the edge of the other wall."""
    return 0.5 * (1.0 - (HEIGHT - z) / hypot(HEIGHT - z, WIDTH))


def means():
    """(name, mesh, points, up, exact value at each, exact mean of all) of cases without curved faces."""
    floor = np.column_stack([WIDTH * ACROSS, np.full(64, 0.3), np.zeros(64)])
    yield "floor", street(WIDTH, HEIGHT), at(floor, (0, 0, 1)), [floor_sky(x) for x in floor[:, 0]], sqrt(1.0 + 1.7**2) - 1.7
    wall = np.column_stack([np.zeros(64), np.full(64, -0.2), HEIGHT * ACROSS])
    mean = 0.5 * (1.0 + 1.0 / 1.7 - sqrt(1.0 + 1.0 / 1.7**2))
    yield "wall", street(WIDTH, HEIGHT), at(wall, (1, 0, 0)), [wall_sky(z) for z in wall[:, 2]], mean
    tilted = at((0.0, 0.0, 9.0), (sqrt(1.0 - 0.819152**2), 0.0, 0.819152), 64)
    yield "tilted", square(), tilted, [0.909576] * 64, 0.909576


@pytest.mark.parametrize("case", list(means()), ids=lambda case: case[0])
def test_sky_of_streets_and_planes(case):
    _, mesh, where, exact, mean = case
    found = ws.sky_view_factor(mesh, where, RAYS)
    error = found.value - exact
    assert np.isfinite(error).all()
    assert np.sqrt(np.mean(error**2)) <= 2e-4
    # About 20 of the 128 strata see an edge, so 4 bars are passed by one point in a thousand.
    outside = np.abs(error) / (found.standard_error + 1e-6)
    assert np.mean(outside > 4.0) <= 2 / 64
    assert outside.max() <= 6.0
    # The midpoint rule over 64 points is within 3e-5 of these means.
    assert abs(found.value.mean() - mean) <= 1e-4
    up = np.asarray(where.normal)[:, 2]
    assert np.abs(found.below_horizon - (0.5 - 0.5 * up)).max() <= 1e-6


def test_a_square_seen_from_the_square_below_it():
    grid = np.stack(np.meshgrid(ACROSS[::4] - ACROSS[0] + 1 / 32, ACROSS[::4] - ACROSS[0] + 1 / 32), -1).reshape(-1, 2)
    found = ws.ambient_occlusion(square(), at(np.column_stack([grid, np.zeros(256)]), (0, 0, 1)), 4096)
    assert abs(1.0 - found.value.mean() - 0.19982489569838746) <= 2e-4  # 256 midpoints: 1.2e-4; the rays: 1e-5


def test_a_disk_and_a_sphere():
    turns = 2.0 * pi * np.arange(2048) / 2048
    rim = 1.3 * np.column_stack([np.cos(turns), np.sin(turns), np.zeros(2048)]) + [0, 0, 0.7]
    fan = [(2048, i, (i + 1) % 2048) for i in range(2048)]
    disk = ws.as_mesh((np.vstack([rim, [[0, 0, 0.7]]]), fan))
    found = ws.ambient_occlusion(disk, at((0, 0, 0), (0, 0, 1), 16), RAYS)
    assert np.abs(1.0 - found.value - 1.3**2 / (1.3**2 + 0.7**2)).max() <= 6e-4  # 4 of 1.5e-4
    ball = trimesh.creation.icosphere(5, 0.5)
    ball.apply_scale(sqrt(4.0 * pi * 0.25 / ball.area))  # its silhouettes' mean area, by Cauchy
    tilt = 0.6
    found = ws.ambient_occlusion(ball, at((0, 0, -1.2), (np.sin(tilt), 0.0, cos(tilt)), 16), RAYS)
    assert np.abs(1.0 - found.value - cos(tilt) * (0.5 / 1.2) ** 2).max() <= 8e-4  # and the tessellation's 2e-4


@pytest.mark.parametrize("name", CLOSED)
def test_from_inside_nothing_escapes_and_from_outside_of_a_convex_mesh_all_does(name):
    mesh, _ = CLOSED[name]
    outside = ws.sample_surface(mesh, 500)
    inside = ws.SurfacePoints(outside.position, -outside.normal, outside.face)
    found = ws.ambient_occlusion(mesh, inside, 512)
    assert (found.value == 0.0).all()
    assert (found.standard_error == 0.0).all()
    convex = trimesh.Trimesh(mesh.vertices, mesh.faces).is_convex
    if convex:
        found = ws.ambient_occlusion(mesh, outside, 512)
        assert (found.value == 1.0).all()
        assert found.rays.sum() == 0
        assert found.skipped == ws.Skipped(open_points=500, empty_rays=500 * 512)


def test_points_on_a_convex_mesh_cast_no_ray_from_32_on():
    """Fewer rays have no strata; they are cast where rounding may put the faces around a point above its horizon."""
    ball = ws.as_mesh(trimesh.creation.icosphere(3))
    points = ws.face_centers(ball)
    rays = {count: int(ws.ambient_occlusion(ball, points, count).rays.sum()) for count in (30, 32)}
    assert rays[30] > 0
    assert rays[32] == 0
