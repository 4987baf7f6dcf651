"""Rays of points on the floor start in front of all walls that stand on it at the point, and no further away than needed."""

import numpy as np
import pytest
import trimesh
from estimate_cases import at
from meshes import turned
from trimesh import creation

import warpsample as ws

HALF = 0.012  # 1,024 rays are accurate to 0.01, and the walls are long beside the distance of the starts


def box_in_a_floor(squares, turn, depth=7.5):
    """A floor from 0 to 8 of squares of two triangles, and a box `depth` in it at x from 2 to 6 and y from 3 to 5.5."""
    lines = np.linspace(0.0, 8.0, squares + 1)
    floor = np.stack(np.meshgrid(lines, lines, [0.0]), axis=-1).reshape(-1, 3)
    first = np.add.outer(np.arange(squares) * (squares + 1), np.arange(squares)).reshape(-1, 1)
    faces = np.concatenate([first + np.array([0, 1, squares + 2]), first + np.array([0, squares + 2, squares + 1])])
    box = creation.box((4.0, 2.5, 40.0))
    vertices = np.concatenate([floor, box.vertices + np.array([4.0, 4.25, 20.0 - depth])]) @ turned(turn).T
    return ws.Mesh(vertices, np.concatenate([faces, box.faces + len(floor)]))


@pytest.mark.parametrize("depth", [0.0, 7.5])
@pytest.mark.parametrize("turn", [0, 3, 4, 5])
@pytest.mark.parametrize("squares", [1, 2, 8])
def test_at_the_foot_of_a_wall_a_point_is_in_front_of_it_whatever_the_edges_of_the_floor(squares, turn, depth):
    """Vertices of the floor saw nothing at two of the four walls, and at all walls of a box that stands on the floor."""
    feet = np.array([[2, 4, 0], [2, 5, 0], [6, 4, 0], [6, 5, 0], [3, 3, 0], [4, 3, 0], [5, 3, 0], [5.5, 5.5, 0]])
    points = at(feet @ turned(turn).T, turned(turn)[:, 2])
    found = ws.ambient_occlusion(box_in_a_floor(squares, turn, depth), points, 1024)
    assert np.abs(found.value - 0.5).max() <= HALF


@pytest.mark.parametrize("turn", [0, 3])
@pytest.mark.parametrize("face", [0, 1])
def test_and_whichever_face_of_the_floor_it_is_on(face, turn):
    """Points on the diagonal of the floor saw nothing if most of their triangle is behind the wall."""
    feet = np.array([[3.0, 3.0, 0.0], [5.5, 5.5, 0.0]]) @ turned(turn).T
    points = ws.SurfacePoints(feet, np.tile(turned(turn)[:, 2].astype(np.float32), (2, 1)), np.array([face, face]))
    found = ws.ambient_occlusion(box_in_a_floor(1, turn), points, 1024)
    assert np.abs(found.value - 0.5).max() <= HALF


def sector(start, end, bottom):
    """A body 500 high of the angles about the z axis from `start` to `end`, below 180 degrees, and 9 long."""
    angles = np.radians(np.linspace(start, end, 5))
    outline = [(0.0, 0.0), *(9.0 * np.stack([np.cos(angles), np.sin(angles)], axis=1))]
    return trimesh.convex.convex_hull([(x, y, z) for z in (bottom, 500.0) for x, y in outline])


@pytest.mark.parametrize("bottom", [0.0, -1.0])
@pytest.mark.parametrize("turn", [0, 3, 4, 5])
@pytest.mark.parametrize("degrees", [90, 50, 25])
def test_a_point_between_the_walls_of_two_houses_is_in_front_of_both(degrees, turn, bottom):
    """The moves off walls with nearly opposite fronts, or off the hidden walls between the houses, cancelled each other."""
    middle = 180.0 + 0.5 * degrees
    houses = sector(degrees, middle, bottom), sector(middle, 360.0, bottom)
    floor = np.array([[-40, -40, 0], [40, -35, 0], [40, 40, 0], [-40, 40, 0]])
    parts = [(floor, np.array([[0, 1, 2], [0, 2, 3]])), *((each.vertices, each.faces) for each in houses)]
    rows = np.cumsum([0, *(len(vertices) for vertices, _ in parts)])
    faces = np.concatenate([faces + row for (_, faces), row in zip(parts, rows[:-1], strict=True)])
    mesh = ws.Mesh(np.concatenate([vertices for vertices, _ in parts]) @ turned(turn).T, faces)
    found = ws.ambient_occlusion(mesh, at((0.0, 0.0, 0.0), turned(turn)[:, 2]), 4096)
    assert found.value[0] == pytest.approx(degrees / 360.0, abs=0.01)  # the houses are high and, next to the start, long


@pytest.mark.parametrize("turn", [0, 3, 4])
@pytest.mark.parametrize("bottom", [0.0, -1.0])
@pytest.mark.parametrize("degrees", [90, 70, 45, 20])
def test_a_point_at_the_inner_corner_of_a_house_of_two_wings_is_in_front_of_both(degrees, bottom, turn):
    """Where walls run on into the other wing, the nearest wall alone decided, and half of such points saw nothing."""
    wings = [
        creation.box((18.0, 4.0, 500.0)).apply_translation((x, y, 250.0 + bottom)) for x, y in ((2.0, -2.0), (-3.0, 2.0))
    ]
    wings[1].apply_transform(trimesh.transformations.rotation_matrix(np.radians(degrees), (0, 0, 1)))
    floor = creation.box((80.0, 90.0, 1.0)).apply_translation((3.0, 1.0, -0.5))
    mesh = trimesh.util.concatenate([floor, *wings])
    mesh = ws.Mesh(mesh.vertices @ turned(turn).T, mesh.faces)
    found = ws.ambient_occlusion(mesh, at([(0, 0, 0)], turned(turn)[:, 2]), 4096)
    assert found.value[0] == pytest.approx(degrees / 360.0, abs=HALF)


@pytest.mark.parametrize("degrees", [48, 46])
@pytest.mark.parametrize("face", [0, 1])
def test_and_at_whichever_angle_the_wall_crosses_an_edge(face, degrees):
    """Below 8 degrees, such points saw nothing if most of their triangle is behind the wall."""
    house = sector(degrees, degrees + 180.0 - 1e-9, -1.0)
    floor = np.array([[-9, -9, 0], [9, -8, 0], [10, 10, 0], [-9, 9, 0]])  # its shared edge is at 45 degrees
    mesh = ws.Mesh(np.concatenate([floor, house.vertices]), np.concatenate([[(0, 1, 2), (0, 2, 3)], house.faces + 4]))
    points = ws.SurfacePoints(np.zeros((1, 3)), np.float32([[0, 0, 1]]), np.array([face]))
    assert ws.ambient_occlusion(mesh, points, 1024).value[0] == pytest.approx(0.5, abs=HALF)


@pytest.mark.parametrize("turn", [0, 3])
@pytest.mark.parametrize("face", [0, 1])
def test_at_an_edge_of_the_floor_a_point_is_in_front_of_a_high_facade_of_panels(face, turn):
    """The narrow bit of a panel beside the point had ended where the foot of the facade was looked for."""
    edges = np.array([-101.0, -1.0, 0.0, 1.0, 101.0])
    front = np.array([(x, 0.0, z) for z in (-0.5, 100.0) for x in edges])
    k = np.arange(4)[:, None]
    panels = np.concatenate([k + np.array([0, 6, 1]), k + np.array([0, 5, 6])])  # their front is towards +y
    floor = np.array([(-30, -30, 0), (30, -30, 0), (30, 30, 0), (-30, 30, 0)])
    vertices = np.concatenate([floor, front, front - (0.0, 0.5, 0.0)]) @ turned(turn).T
    mesh = ws.Mesh(vertices, np.concatenate([[(0, 1, 2), (0, 2, 3)], panels + 4, panels[:, ::-1] + 14]))
    normal = np.float32(turned(turn)[:, 2])
    found = ws.ambient_occlusion(mesh, ws.SurfacePoints(np.zeros((1, 3)), normal[None], np.array([face])), 1024)
    assert found.value[0] == pytest.approx(0.5, abs=HALF)


@pytest.mark.parametrize("turn", [0, 3])
@pytest.mark.parametrize("first", [0, 2])
@pytest.mark.parametrize("degrees", [88, 85, 70, 50, 40, 20])
def test_at_the_foot_of_a_leaning_wall_both_see_the_wedge_between_wall_and_floor(degrees, first, turn):
    """A move off the wall along its normal ended below the floor, and one off the floor behind the wall."""
    up = 300.0 * np.array([np.cos(np.radians(degrees)), 0.0, np.sin(np.radians(degrees))])
    along = np.array([0.0, 300.0, 0.0])
    wall = [-along - up, along - up, along + up, up - along]
    floor = np.roll([(-300, -300, 0), (300, -290, 0), (310, 300, 0), (-300, 310, 0)], first, axis=0)
    faces = np.array([(0, 1, 2), (0, 2, 3), (4, 5, 6), (4, 6, 7)])  # the wall's front is towards +x, and down
    mesh = ws.Mesh(np.array([*floor, *wall], float) @ turned(turn).T, faces)
    foot = np.array([(0.0, y, 0.0) for y in (-11.3, 0.0, 1.7, 20.0)]) @ turned(turn).T
    for face in (0, 2):
        found = ws.ambient_occlusion(mesh, at(foot, mesh.face_normals[face]), 4096)
        assert found.value == pytest.approx(0.5 * (1.0 - np.cos(np.radians(degrees))), abs=0.015)  # the wall is 300 long


@pytest.mark.parametrize("turn", [0, 3])
@pytest.mark.parametrize("cards", [2, 3, 4, 5, 8])
def test_a_point_on_the_axis_of_crossed_cards_sees_the_wedge_beside_its_card(cards, turn):
    """Points on the axis of a tree of three cards started between the other two, and some of four cards saw nothing."""
    angles = np.pi * np.arange(cards) / cards
    out = 300.0 * np.stack([np.cos(angles), np.sin(angles), 0.0 * angles], axis=1)
    up = np.array([0.0, 0.0, 300.0])
    corners = np.concatenate([-out - up, out - up, out + up, up - out]) @ turned(turn).T
    first = np.arange(cards)[:, None]
    mesh = ws.Mesh(corners, np.concatenate([first + cards * np.array([0, 1, 2]), first + cards * np.array([0, 2, 3])]))
    axis = np.repeat([(0.0, 0.0, -11.3), (0.0, 0.0, 7.9)], cards, axis=0) @ turned(turn).T
    found = ws.ambient_occlusion(mesh, at(axis, np.tile(mesh.face_normals[:cards], (2, 1))), 4096)
    assert found.value == pytest.approx(0.5 * (1.0 - np.cos(np.pi / cards)), abs=0.015)  # the cards are 300 long


@pytest.mark.parametrize("degrees", [1, 3, 5])
def test_so_do_points_on_a_floor_beside_a_low_wall(degrees):
    """Rays started below the floor, as the offset of a floor that is wide and low is small."""
    lean = 0.5 * np.tan(np.radians(degrees))
    house = trimesh.convex.convex_hull([(x, *yz) for x in (-2, 2) for yz in ((-1, 0), (1, 0), (-1 - lean, 0.5), (1, 0.5))])
    floor = np.array([(-10, -11, 0), (12, -10, 0), (11, 12, 0), (-12, 10, 0)])
    mesh = ws.Mesh(np.concatenate([floor, house.vertices]), np.concatenate([[(0, 1, 2), (0, 2, 3)], house.faces + 4]))
    feet = np.array([(x, -1.0, 0.0) for x in (-1.3, 0.2, 1.1)])
    found = ws.ambient_occlusion(mesh, at(feet, (0, 0, 1)), 1024)
    beside = ws.ambient_occlusion(mesh, at(feet - (0.0, 1e-3, 0.0), (0, 0, 1)), 1024)
    assert found.value == pytest.approx(beside.value, abs=HALF)


@pytest.mark.parametrize("slope", [0.02, 0.3, 0.8])
@pytest.mark.parametrize("turn", range(4))
def test_in_the_corner_of_a_court_on_a_slope_a_point_is_in_front_of_its_walls(turn, slope):
    """The upper corners of a wall counted, which a slope moves along its foot, and half of such points saw nothing."""
    houses = [creation.box((4.0, 4.0, 300.0)).apply_translation((x, y, 150.0)) for x, y in ((2, 2), (-2, 2), (2, -2))]
    lines = np.linspace(-8.0, 8.0, 9)
    floor = np.stack(np.meshgrid(lines, lines, [0.0]), axis=-1).reshape(-1, 3)
    first = np.add.outer(9 * np.arange(8), np.arange(8)).reshape(-1, 1)
    faces = np.concatenate([first + np.array([0, 1, 10]), first + np.array([0, 10, 9])])
    town = trimesh.util.concatenate(houses)
    angle = 0.4 + turn * np.pi / 2.0
    up = np.array([-slope * np.cos(angle), -slope * np.sin(angle), 1.0])
    vertices = np.concatenate([floor, town.vertices])
    vertices[:, 2] -= vertices @ up - vertices[:, 2]
    mesh = ws.Mesh(vertices, np.concatenate([faces, town.faces + len(floor)]))
    normal = up / np.linalg.norm(up)
    aside = np.array([-2e-3, -2e-3, 2e-3 * (up[0] + up[1])]) + 1e-4 * normal
    corner, beside = ws.ambient_occlusion(mesh, at([np.zeros(3), aside], normal), 4096).value
    assert corner == pytest.approx(beside, abs=0.02)  # 4,096 rays are accurate to 0.005, on each side


@pytest.mark.parametrize("tracer", ["wide", "warp"])
def test_rays_of_a_vertex_start_straight_above_it(tracer):
    """They started beside the vertex, on one face, where it sees less of a gentle terrain: 0.955."""
    vertices = [(-1, -1, 0.25), (0, -1, 0.19), (-1, 0, 0.53), (0, 0, 0), (1, 0, 0.19)]
    mesh = ws.Mesh(np.array(vertices, float), np.array([(0, 1, 3), (0, 3, 2), (1, 4, 3)]))
    vertex = ws.vertex_points(mesh).take([3])
    above = ws.SurfacePoints(vertex.position + 1e-4 * vertex.normal, vertex.normal)
    found, want = (ws.ambient_occlusion(mesh, points, 16384, tracer=tracer).value[0] for points in (vertex, above))
    assert found == pytest.approx(want, abs=0.002)  # 16,384 rays; it was 0.014


@pytest.mark.parametrize("width", [1.7, 1.9])
def test_rays_of_a_vertex_in_a_notch_start_straight_above_it(width):
    """They started beside it, as one wall of the notch, 80 or 87 degrees wide, is above the other: 0.75 in place of 0.85."""
    plan = np.array([(0, 0), (2, width), (-1, 0), (2, -width)])
    vertices = np.concatenate([np.insert(plan, 2, height, axis=1) for height in (0.0, 3.0)])
    ends = np.array([(0, 1, 2), (0, 2, 3)])
    walls = [face for i, j in ((0, 1), (1, 2), (2, 3), (3, 0)) for face in ((i, j, 4 + j), (i, 4 + j, 4 + i))]
    mesh = ws.Mesh(vertices, np.concatenate([ends + 4, ends[:, ::-1], walls]))
    vertex = ws.vertex_points(mesh).take([4])
    above = ws.SurfacePoints(vertex.position + 1e-3 * vertex.normal, vertex.normal)
    found, want = (ws.ambient_occlusion(mesh, points, 16384).value[0] for points in (vertex, above))
    assert found == pytest.approx(want, abs=0.004)  # 16,384 rays


@pytest.mark.parametrize("noise", [1e-5, 3e-4])
def test_vertices_of_a_nearly_level_floor_stay_where_they_are(noise):
    """They moved by up to half of their face, to be on the same side as its centre of faces in nearly the same plane."""
    lines = np.linspace(-100.0, 100.0, 21)
    floor = np.stack(np.meshgrid(lines, lines, [0.0]), axis=-1).reshape(-1, 3)
    first = np.add.outer(21 * np.arange(20), np.arange(20)).reshape(-1, 1)
    faces = np.concatenate([first + np.array([0, 1, 22]), first + np.array([0, 22, 21])])
    posts = [creation.box((1.0, 1.0, 8.0)).apply_translation((x + 0.7, y, 0.0)) for x, y, _ in floor[::7]]
    post = trimesh.util.concatenate(posts)
    found = []
    for some in (0.0, noise):
        level = floor + some * np.random.default_rng(1).normal(size=(len(floor), 1)) * (0.0, 0.0, 1.0)
        mesh = ws.Mesh(np.concatenate([level, post.vertices]), np.concatenate([faces, post.faces + len(floor)]))
        found.append(ws.ambient_occlusion(mesh, at(level, (0, 0, 1)), 256).value)
    assert np.abs(found[1] - found[0]).max() < 0.02
