"""What is inside of a closed body, and what is not: bodies that are open or inside out have no inside."""

import tracemalloc

import numpy as np
import pytest
import trimesh

import warpsample as ws
from warpsample.texture.inside import Closed, Enclosed

BALL = trimesh.creation.icosphere(2)


def floor_and(*bodies):
    """A floor at z = 0, as a sheet, and bodies; vertices at the same place are split, as files have them."""
    parts = [(np.array([(-4, -4, 0), (4, -4, 0), (4, 4, 0), (-4, 4, 0)], float), np.array([[0, 1, 2], [0, 2, 3]]))]
    parts += [(body[faces].reshape(-1, 3), np.arange(3 * len(faces)).reshape(-1, 3)) for body, faces in bodies]
    starts = np.cumsum([0] + [len(vertices) for vertices, _ in parts])
    faces = [faces + start for (_, faces), start in zip(parts, starts[:-1], strict=True)]
    return ws.Mesh(np.concatenate([vertices for vertices, _ in parts]), np.concatenate(faces))


def inside(mesh, points):
    """Whether points on the first faces of a mesh are inside a closed body."""
    return Closed(mesh).count_bodies(points, points.face)[0][:, 0] > 0


def around(mesh):
    """Whether points of the floor are inside, by their distance from the middle."""
    points = ws.sample_surface(ws.Mesh(mesh.vertices, mesh.faces[:2]), 2000, seed=1)
    return inside(mesh, points), np.hypot(*points.position[:, :2].T)


@pytest.mark.parametrize("shift", [0.0, 1e6])
def test_the_floor_under_a_ball_is_inside(shift):
    mesh = floor_and((BALL.vertices, BALL.faces))
    mesh = ws.Mesh(mesh.vertices + shift, mesh.faces)
    points = ws.sample_surface(ws.Mesh(mesh.vertices, mesh.faces[:2]), 2000, seed=1)
    distance = np.hypot(*(points.position - shift)[:, :2].T)
    found = inside(mesh, points)
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


@pytest.mark.parametrize("named", [False, True])
@pytest.mark.parametrize(
    ("name", "boxes"),
    [
        ("a wall", [((-3, -1), (0, 1)), ((0, -1), (3, 1))]),
        ("an edge", [((-3, -1), (0, 1)), ((0, 1), (3, 3))]),
        ("a storey", [((-1, -1), (1, 1)), ((-1, -1), (1, 1))]),
    ],
)
def test_crates_that_share_a_wall_or_an_edge_are_closed(name, boxes, named):
    bodies, covered = [], []
    for number, (low, high) in enumerate(boxes):
        box = trimesh.creation.box(bounds=[(*low, 2 * number if name == "a storey" else -1), (*high, 2 * number + 2)])
        bodies.append((box.vertices, box.faces))
        covered.append((np.array(low), np.array(high)))
    mesh = floor_and(*bodies)
    if named:
        part = np.repeat(np.arange(3), [2, 12, 12])
        mesh = ws.Mesh(mesh.vertices, mesh.faces, part, ["floor", "one", "two"])
    points = ws.sample_surface(ws.Mesh(mesh.vertices, mesh.faces[:2]), 2000, seed=1)
    under = np.any([(points.position[:, :2] > low).all(axis=1) & (points.position[:, :2] < high).all(axis=1)
                    for low, high in covered], axis=0)  # fmt: skip
    assert 100 < under.sum() < 1900
    assert np.array_equal(inside(mesh, points), under)


@pytest.mark.parametrize("height", [2.0, 1.0])
def test_a_crate_twice_or_on_its_plinth_is_closed(height):
    """All edges, or those below, belong to four faces, so both are one body. A ray from inside crosses it twice."""
    boxes = [trimesh.creation.box(bounds=[(-1, -1, -1), (1, 1, top)]) for top in (2.0, height)]
    mesh = floor_and(*((box.vertices, box.faces) for box in boxes))
    points = ws.sample_surface(ws.Mesh(mesh.vertices, mesh.faces[:2]), 2000, seed=1)
    assert np.array_equal(inside(mesh, points), (np.abs(points.position[:, :2]) < 1.0).all(axis=1))


def test_each_body_is_taken_alone():
    """A closed ball beside an open one, and faces without an area within: only the closed one has an inside."""
    faces = np.concatenate([BALL.faces, [[0, 0, 1]]])
    mesh = floor_and((BALL.vertices * 0.5 + np.array((2, 0, 0)), faces), (BALL.vertices, BALL.faces[3:]))
    points = ws.sample_surface(ws.Mesh(mesh.vertices, mesh.faces[:2]), 4000, seed=1)
    found = inside(mesh, points)
    assert found.sum() > 20
    assert np.hypot(*(points.position[found, :2] - (2, 0)).T).max() < 0.5


def sheet(half, z=0.0):
    """A square sheet that faces upward, and its place in the image: all of it."""
    vertices = np.array([(-half, -half, z), (half, -half, z), (half, half, z), (-half, half, z)], float)
    return vertices, np.array([[0, 1, 2], [0, 2, 3]])


def box(size, centre, *, inverted=False):
    made = trimesh.creation.box(size)
    return made.vertices + np.array(centre), made.faces[:, ::-1] if inverted else made.faces


def mesh_of(*parts):
    """A mesh of some parts, and coordinates of the first, a sheet."""
    starts = np.cumsum([0] + [len(vertices) for vertices, _ in parts])
    faces = np.concatenate([faces + start for (_, faces), start in zip(parts, starts[:-1], strict=True)])
    mesh = ws.Mesh(np.concatenate([vertices for vertices, _ in parts]), faces)
    uv = np.full((len(mesh.faces), 3, 2), np.nan)
    uv[:2] = np.array([(0, 0), (1, 0), (1, 1), (0, 1)], float)[mesh.faces[:2]]
    return mesh, uv


def buried(*parts, side=32):
    """Which texels of the first of some parts, a sheet, are to be filled: (H, W), rows from y = -half on."""
    return buried_of(*mesh_of(*parts), side)


def enclosed_of(mesh, uv, side):
    t = ws.texture_points(mesh, uv, side)
    enclosed = Enclosed(Closed(mesh), t)
    for start in range(0, len(t), 300):
        part = t.take(slice(start, start + 300))
        enclosed.add(start, part, part, None)
    return enclosed, t


def buried_of(mesh, uv, side):
    enclosed, t = enclosed_of(mesh, uv, side)
    found = np.zeros(side * side, bool)
    found[t.texel[enclosed.find_buried(np.ones(len(t), bool))]] = True
    return found.reshape(side, side)


def centre(half, side=32):
    """The texels of a sheet within `half` of its middle of 8 x 8."""
    at = np.abs((np.arange(side) + 0.5) / side * 8 - 4) < half
    return at[:, None] & at


CRATE = box((2, 2, 2), (0, 0, 1))  # it stands on the sheet, face on face


def test_texels_may_all_be_on_edges_of_faces():
    """Then nothing was filled: in a floor of squares, with a texel in the middle of each."""
    lines = np.linspace(-4.0, 4.0, 33)
    vertices = np.stack(np.meshgrid(lines, lines, [0.0]), axis=-1).reshape(-1, 3)
    first = np.add.outer(33 * np.arange(32), np.arange(32)).reshape(-1, 1)
    faces = np.concatenate([first + np.array([0, 1, 34]), first + np.array([0, 34, 33])])
    crate = CRATE[0] * (0.99, 0.99, 1.0)  # no texel is in one of its walls
    mesh = ws.Mesh(np.concatenate([vertices, crate]), np.concatenate([faces, CRATE[1] + len(vertices)]))
    uv = np.full((len(mesh.faces), 3, 2), np.nan)
    uv[: len(faces)] = (vertices[faces, :2] + 4.0) / 8.0
    assert np.array_equal(buried_of(mesh, uv, 32), centre(0.99))


@pytest.mark.parametrize("inverted", [False, True])
@pytest.mark.parametrize("width", [8.0, 8.001, 12.0])  # a carpet from wall to wall, nearly so, and a smaller one
def test_a_carpet_in_a_room_keeps_its_numbers(inverted, width):
    """Whichever way its walls face; and under a crate in the room the carpet is filled all the same."""
    room = box((width, width, 6), (0, 0, 3), inverted=inverted)
    assert not buried(sheet(4), room).any()
    assert np.array_equal(buried(sheet(4), room, CRATE), centre(1))


def test_a_floor_that_a_hollow_house_stands_on_is_filled_under_its_walls_alone():
    """Walls from 2 to 3, as two shells: the cavity is a room."""
    house = box((6, 6, 6), (0, 0, 2)), box((4, 4, 4), (0, 0, 2), inverted=True)
    assert np.array_equal(buried(sheet(4), *house), centre(3) & ~centre(2))
    assert np.array_equal(buried(sheet(4), *house, CRATE), centre(3) & ~centre(2) | centre(1))


def test_an_inside_out_crate_in_a_room_changes_nothing():
    assert not buried(sheet(4), box((12, 12, 12), (0, 0, 3)), box((2, 2, 2), (0, 0, 1), inverted=True)).any()


@pytest.mark.parametrize("share", [0.05, 0.5, 0.74, 0.79, 0.97])
def test_any_share_of_a_post_in_the_ground_is_filled(share):
    """A post's side, 8 long, stands in a closed ground up to z = 0; what is above, however little, fills it."""
    vertices, faces = sheet(4)
    upright = vertices[:, [2, 0, 1]] + np.array((0, 0, 4 - 8 * share))  # rows rise with z
    found = buried((upright, faces), box((20, 20, 10), (0, 0, -5)))
    height = (np.arange(32) + 0.5) / 4 - 8 * share
    assert np.array_equal(found, np.repeat((height < 0)[:, None], 32, axis=1))


def test_charts_at_one_place_of_the_image_are_looked_at_each_alone():
    """A carpet in a closed room, and one in the open, whose texels are those at the left half of the same image."""
    parts = [sheet(4), box((12, 12, 12), (0, 0, 3)), (sheet(4)[0] + np.array((50.0, 0, 0)), sheet(4)[1])]
    starts = np.cumsum([0] + [len(vertices) for vertices, _ in parts])
    faces = np.concatenate([faces + start for (_, faces), start in zip(parts, starts[:-1], strict=True)])
    mesh = ws.Mesh(np.concatenate([vertices for vertices, _ in parts]), faces)
    uv = np.full((len(faces), 3, 2), np.nan)
    uv[:2] = np.array([(0, 0), (0.5, 0), (0.5, 1), (0, 1)])[mesh.faces[:2]]
    uv[-2:] = np.array([(0, 0), (1, 0), (1, 1), (0, 1)])[mesh.faces[:2]]
    assert not buried_of(mesh, uv, 32).any()


def test_rays_are_cast_only_near_other_bodies():
    """None without closed bodies, or beside one: and two for points in a cell of the grid around it, 1/64 wide."""
    points = ws.sample_surface(ws.Mesh(*sheet(4)), 2000, seed=1)
    near = np.count_nonzero((np.abs(points.position[:, :2]) < 1 + 2 / 64).all(axis=1))
    for mesh, count in ((floor_and(), 0), (floor_and(box((2, 2, 2), (0, 0, 5))), 0), (floor_and(CRATE), near)):
        nested, _, rays = Closed(mesh).count_bodies(points, points.face)
        assert rays <= 2 * count
        assert nested.any() == (count > 0)
    ball = ws.Mesh(BALL.vertices, BALL.faces)
    points = ws.face_centers(ball)
    assert Closed(ball).count_bodies(points, points.face)[2] == 0


def test_hits_of_few_points_are_in_memory_at_a_time():
    """Those of 65,536 points below 400 plates took 3 GB; counts are the same in whatever blocks."""
    plates = [box((7, 7, 0.01), (0, 0, 0.1 + 0.1 * height)) for height in range(30)]
    mesh = floor_and(box((7, 7, 9), (0, 0, 0)), *plates)
    quad = np.array([[(0, 1), (1, 1), (1, 0)], [(0, 1), (1, 0), (0, 0)]], float)
    uv = np.concatenate([quad, np.full((len(mesh.faces) - 2, 3, 2), np.nan)])
    texels = ws.texture_points(mesh, uv, 256)
    closed, enclosed = Closed(mesh), Enclosed(Closed(mesh), texels)
    enclosed.add(0, texels.points, texels.points, 1)  # compiles
    whole = closed.count_bodies(texels.points, texels.face)[0][:, 0] > 0
    tracemalloc.start()
    enclosed.add(0, texels.points, texels.points, 1)
    peak = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    assert np.array_equal(enclosed.inside, whole)
    assert 0 < whole.sum() < len(texels)
    assert peak < 6e7  # 3e7; in one block of all points 19e7


def test_a_sheet_with_two_sides_is_no_body():
    """The volume between its sides is rounding, and was taken for that of a body without extent along an axis."""
    x, y = np.meshgrid(*np.random.default_rng(0).random((2, 9)))
    corners = np.stack([x, y, np.full_like(x, 0.7)], axis=-1).reshape(-1, 3)
    first = np.array([row * 9 + column for row in range(8) for column in range(8)])[:, None]
    front = np.concatenate([first + np.array(corner) for corner in ([0, 9, 1], [1, 9, 10])])
    closed = Closed(floor_and((corners, np.concatenate([front, front[:, ::-1]]))))
    assert len(closed.bodies[1]) == 0
    points = ws.SurfacePoints([[0.5, 0.5, 0.7]], [[0.0, 0.0, 1.0]])
    assert closed.count_bodies(points, np.array([-1]))[2] == 0


def test_a_body_that_transmits_light_has_no_inside():
    """A glass box beside an opaque one: the floor under glass is lit and visible."""
    opaque, glass = (box((2, 2, 2), (x, 0, 0)) for x in (-2, 2))
    mesh = floor_and(opaque, glass)
    for share, count in ((0.0, 2), (0.2, 1)):
        shares = np.zeros(len(mesh.faces))
        shares[-1] = share  # one pane
        made = ws.Mesh(mesh.vertices, mesh.faces, transmittance=shares)
        points = ws.sample_surface(ws.Mesh(mesh.vertices, mesh.faces[:2]), 2000, seed=1)
        x, y = points.position[:, 0], np.abs(points.position[:, 1])
        under = np.any([(np.abs(x - middle) < 1) & (y < 1) for middle in (-2, 2)[:count]], axis=0)
        assert np.array_equal(inside(made, points), under)


@pytest.mark.parametrize("shared", ["a vertex", "an edge"])
def test_overlapping_walls_that_share_vertices_are_counted_each_alone(shared):
    """Two walls of a corner in one mesh: where both overlap, the parity of all their faces is even."""
    height = 2 if shared == "an edge" else 3  # of the second wall; the lower ends share a vertex only
    bounds = ((-2, -2, -1), (2, -1, 2)), ((-2, -2, -1), (-1, 2, height - 1))
    walls = [trimesh.creation.box(bounds=one) for one in bounds]
    mesh = floor_and(*[(wall.vertices, wall.faces) for wall in walls])
    points = ws.sample_surface(ws.Mesh(mesh.vertices, mesh.faces[:2]), 2000, seed=1)
    at = points.position
    counts = [((at[:, :2] > low[:2]) & (at[:, :2] < high[:2])).all(axis=1) for low, high in bounds]
    assert (counts[0] & counts[1]).sum() > 10
    assert np.array_equal(Closed(mesh).count_bodies(points, points.face)[0][:, 0], np.sum(counts, axis=0))


def test_charts_that_are_filled_by_more_than_half_are_counted():
    """A floor that reaches out of a closed room by a rim, and one of which a crate covers a sixteenth."""
    for size, count in ((7.6, 1), (2.0, 0)):
        mesh, uv = mesh_of(sheet(4), box((size, size, 6), (0, 0, 2)))
        enclosed, t = enclosed_of(mesh, uv, 32)
        found = enclosed.find_buried(np.ones(len(t), bool))
        assert found.any()
        assert enclosed.count_mostly_buried(found) == count
    assert enclosed.count_mostly_buried(np.zeros(len(t), bool)) == 0


@pytest.mark.parametrize("size", [1.0, 0.7, 1.0 / 3.0])
def test_rims_at_a_border_of_the_grid_are_inside(size):
    """A rounding moved the lower rim of a post in a slab out of the cells of the post, so that it counted as visible."""
    bounds = [((1, 1, 1), (2, 2, 3)), ((0, 0, 0), (4, 4, 2)), ((0, 0, 3.5), (0.5, 0.5, 4))]
    boxes = [trimesh.creation.box(bounds=size * np.array(each)) for each in bounds]
    mesh = floor_and(*((box.vertices, box.faces) for box in boxes))
    rim = np.nextafter(np.float32(size), np.float32([0.0, size, 9.0]))
    points = ws.SurfacePoints([(size, 1.5 * size, z) for z in rim], [(-1.0, 0.0, 0.0)] * 3, [2, 2, 2])
    assert inside(mesh, points).all()
