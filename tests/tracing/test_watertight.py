"""No ray gets through a closed mesh, not even at an edge, and none meets the face that it starts on."""

import ctypes
import re
from io import StringIO

import numpy as np
import pytest
from meshes import CLOSED, SPHERE
from rich.console import Console

import warpsample as ws
from warpsample.proof import report
from warpsample.proof.rays import judge_mesh, rays_inside
from warpsample.tracing.scene import scene_of


@pytest.mark.parametrize("name", CLOSED)
def test_no_ray_leaves_a_closed_mesh(name):
    verdicts = judge_mesh(name, *CLOSED[name], 1 << 18, 100_000)
    assert [verdict for verdict in verdicts if not verdict.passed] == []
    report.show(verdicts, Console(file=(shown := StringIO()), width=200))
    assert all(f"{verdict.law}: " in shown.getvalue() for verdict in verdicts)
    assert not re.search(r"wp.Mesh 0$", verdicts[1].note)  # so aiming at edges is a trial


def test_float32_rays_leave_no_closed_mesh_either():
    for mesh, _ in CLOSED.values():
        origins, directions = rays_inside(mesh, 1 << 16, 3)
        assert (ws.trace(mesh, origins.astype(np.float32), directions).face >= 0).all()


@pytest.mark.parametrize("turned", [False, True])
@pytest.mark.parametrize("height", [-1.0, 1.0])
def test_rays_exactly_at_edges_and_corners_meet_a_face_from_both_sides(height, turned):
    """All numbers are small multiples of 1/2: every edge function that can be 0 is exactly 0."""
    x, y = np.meshgrid(np.arange(-4, 5), np.arange(-4, 5))
    corner = 9 * np.arange(8)[:, None] + np.arange(8)
    faces = np.stack([corner, corner + 1, corner + 10, corner, corner + 10, corner + 9], axis=-1).reshape(-1, 3)
    mesh = ws.as_mesh((np.stack([x, y, 0 * x], axis=-1).reshape(-1, 3), faces[:, ::-1] if turned else faces))
    origins = np.stack([*np.meshgrid(np.arange(-8, 9) / 2.0, np.arange(-8, 9) / 2.0), np.full((17, 17), height)], axis=-1)
    downwards = np.broadcast_to([0.0, 0.0, -height], (289, 3))
    for any_hit in (False, True):
        assert (ws.trace(mesh, origins.reshape(-1, 3), downwards, any_hit=any_hit).distance == 1.0).all()


def test_leaks_are_found():
    """The trees have a triangle missing, or boxes that are a little too small."""
    missing, small = (ws.Mesh(SPHERE.vertices, SPHERE.faces) for _ in range(2))
    scene_of(missing).tree(1).leaves[7, :12, 3] = 0.0
    scene_of(small).tree(1).nodes[:, :3] += np.float32(2e-3)
    for mesh in (missing, small):
        broken = {v.law for v in judge_mesh("damaged", mesh, (0.0, 0.0, 0.0), 1 << 18, 100_000) if not v.passed}
        assert broken >= {"rays that leave a closed mesh", "rays between two faces"}


def test_points_that_start_on_their_face_are_found(monkeypatch):
    mesh = ws.Mesh(SPHERE.vertices, SPHERE.faces)

    def not_moved(scene, placement, *_, **__):
        """The starts, right on the faces."""
        memory = (ctypes.c_double * (3 * placement.points)).from_address(placement.origins)
        places = np.ctypeslib.as_array(memory).reshape(-1, 3)
        starts = np.repeat(((places - scene.centre) * scene.scale).astype(np.float32)[:, None], 2, axis=1)
        placement.starts = starts.ctypes.data
        return starts

    monkeypatch.setattr("warpsample.tracing.placed_points.set_starts", not_moved)
    broken = {v.law for v in judge_mesh("sphere", mesh, (0.0, 0.0, 0.0), 1 << 16, 64) if not v.passed}
    assert "rays that hit their own face" in broken


@pytest.mark.parametrize("tracer", ["wide", "warp"])
@pytest.mark.parametrize("name", CLOSED)
@pytest.mark.parametrize(("scale", "offset"), [(1.0, 0.0), (1e-6, 0.0), (1e3, 5e6), (5e6, 0.0)])
def test_surface_points_start_off_their_own_face(name, scale, offset, tracer):
    """From a convex mesh all rays outward escape; inward all meet another face, at any scale and far from the origin."""
    mesh = ws.Mesh(CLOSED[name][0].vertices * scale + offset, CLOSED[name][0].faces)
    points = ws.sample_surface(mesh, 2000, seed=5)
    cosines = ws.sample_directions(points, 16, seed=6).vectors
    # Closer to the horizon a direction's own rounding decides on which side of the next face a ray passes.
    up = (cosines * points.normal[:, None]).sum(axis=2) > 1e-5
    outward, inward = (ws.trace(mesh, points, way, tracer=tracer).face for way in (cosines, -cosines))
    assert not (outward == points.face[:, None])[up].any()
    assert not (inward == points.face[:, None])[up].any()
    assert np.count_nonzero(inward[up] < 0) <= (0 if tracer == "wide" else 5)
    if name != "torus":
        assert (outward == -1)[up].all()


def test_points_that_are_float32_themselves_are_moved_off_further():
    mesh = ws.Mesh(SPHERE.vertices * 1e3 + 5e6, SPHERE.faces)
    exact = ws.sample_surface(mesh, 2000, seed=5)
    points = ws.SurfacePoints(exact.position.astype(np.float32), exact.normal)  # off by up to 0.25
    cosines = ws.sample_directions(points, 16, seed=6).vectors
    up = (cosines * points.normal[:, None]).sum(axis=2) > 1e-2
    assert (ws.trace(mesh, points, cosines).face == -1)[up].all()
