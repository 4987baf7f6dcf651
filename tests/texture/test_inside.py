"""What is inside of a closed body, and what is not: bodies that are open or inside out have no inside."""

import numpy as np
import pytest
import trimesh

import warpsample as ws
from warpsample.texture.inside import Closed

BALL = trimesh.creation.icosphere(2)


def floor_and(*bodies):
    """A floor at z = 0, as a sheet, and bodies; vertices at the same place are split, as files have them."""
    parts = [(np.array([(-4, -4, 0), (4, -4, 0), (4, 4, 0), (-4, 4, 0)], float), np.array([[0, 1, 2], [0, 2, 3]]))]
    parts += [(body[faces].reshape(-1, 3), np.arange(3 * len(faces)).reshape(-1, 3)) for body, faces in bodies]
    starts = np.cumsum([0] + [len(vertices) for vertices, _ in parts])
    faces = [faces + start for (_, faces), start in zip(parts, starts[:-1], strict=True)]
    return ws.Mesh(np.concatenate([vertices for vertices, _ in parts]), np.concatenate(faces))


def around(mesh):
    """Whether points of the floor are inside, by their distance from the middle."""
    points = ws.sample_surface(ws.Mesh(mesh.vertices, mesh.faces[:2]), 2000, seed=1)
    return Closed(mesh).around(points), np.hypot(*points.position[:, :2].T)


@pytest.mark.parametrize("shift", [0.0, 1e6])
def test_the_floor_under_a_ball_is_inside(shift):
    mesh = floor_and((BALL.vertices, BALL.faces))
    mesh = ws.Mesh(mesh.vertices + shift, mesh.faces)
    points = ws.sample_surface(ws.Mesh(mesh.vertices, mesh.faces[:2]), 2000, seed=1)
    distance = np.hypot(*(points.position - shift)[:, :2].T)
    found = Closed(mesh).around(points)
    assert found[distance < 0.95].all()  # facets are within the ball by 0.03
    outside = distance > 1.0
    assert outside.sum() > 100
    assert (~found[outside]).all()


@pytest.mark.parametrize("name", ["open", "inside out", "wound both ways"])
def test_other_bodies_have_no_inside(name):
    faces = BALL.faces.copy()
    if name == "open":
        faces = faces[1:]
    elif name == "inside out":
        faces = faces[:, ::-1]
    else:
        faces[5] = faces[5, ::-1]
    found, _ = around(floor_and((BALL.vertices, faces)))
    assert not found.any()


def test_each_body_is_taken_alone():
    """A closed ball beside an open one, and faces without an area within: only the closed one has an inside."""
    faces = np.concatenate([BALL.faces, [[0, 0, 1]]])
    mesh = floor_and((BALL.vertices * 0.5 + np.array((2, 0, 0)), faces), (BALL.vertices, BALL.faces[3:]))
    points = ws.sample_surface(ws.Mesh(mesh.vertices, mesh.faces[:2]), 4000, seed=1)
    found = Closed(mesh).around(points)
    assert found.sum() > 20
    assert np.hypot(*(points.position[found, :2] - (2, 0)).T).max() < 0.5
