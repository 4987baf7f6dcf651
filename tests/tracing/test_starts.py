"""Rays of surface points start on the correct side at corners, edges and the foot of a wall, in any closed workspace."""

import numpy as np
import pytest
import trimesh
from affine import Affine
from estimate_cases import at, same
from meshes import turned
from second_device import second_device
from trimesh import creation

import warpsample as ws

LARGE = ("annulus", "torus")
ALONG_AXES = ("box", "star")
ROOMS = {
    "attic": trimesh.convex.convex_hull([(x, y, z) for x in (0, 10) for y, z in ((-2, 0), (2, 0), (0, 0.7))]),
    "box": creation.box(),
    "flat": creation.box((1.0, 1.0, 1e-3)),
    "tetrahedron": creation.cone(1.0, 2.0, sections=3),
    "cone": creation.cone(1.0, 3.0, sections=20),
    "torus": creation.torus(1.0, 0.3, major_sections=12, minor_sections=8),
    "ring": creation.torus(1.0, 0.3, major_sections=6, minor_sections=3),
    "annulus": creation.annulus(0.5, 1.0, 1.0),  # edges that stand out into the workspace
    "star": trimesh.Trimesh(  # saddles: spikes of many lengths on a sphere
        creation.icosphere(1).vertices * np.random.default_rng(3).uniform(0.3, 1.0, (42, 1)), creation.icosphere(1).faces
    ),
}


def on_all_edges(mesh):
    """Corners and points along every edge of every face, with the face's normal."""
    corners, next_ones = mesh.vertices[mesh.faces], mesh.vertices[np.roll(mesh.faces, -1, axis=1)]
    shares = np.array([0.0, 0.3, 0.5])[:, None, None, None]
    position = ((1.0 - shares) * corners + shares * next_ones).reshape(-1, 3)
    face = np.broadcast_to(np.arange(len(mesh.faces))[:, None], (3, len(mesh.faces), 3)).ravel()
    return position, mesh.face_normals[face], face


@pytest.mark.parametrize(
    ("name", "turn"),
    [
        *(pytest.param(name, 3, marks=pytest.mark.slow if name in LARGE else ()) for name in ROOMS),
        *(pytest.param(n, 0, marks=pytest.mark.slow if n in ALONG_AXES else pytest.mark.thorough) for n in ROOMS),
    ],
)
def test_no_point_of_a_closed_room_sees_out_of_it(name, turn):
    """The workspace is stored with shared corners or as an .stl, oriented inwards, or outwards and seen from behind."""
    vertices, faces = ROOMS[name].vertices @ turned(turn).T, ROOMS[name].faces
    split = vertices[faces].reshape(-1, 3), np.arange(faces.size).reshape(-1, 3)
    for corners, triangles in ((vertices, faces), split):
        for inside, wound in ((1.0, triangles[:, ::-1]), (-1.0, triangles)):
            mesh = ws.as_mesh((corners, wound))
            vertex, center = ws.vertex_points(mesh), ws.face_centers(mesh)
            position, normal, face = on_all_edges(mesh)
            for points in (
                ws.SurfacePoints(vertex.position, inside * vertex.normal),
                ws.SurfacePoints(center.position, inside * center.normal, center.face),
                ws.SurfacePoints(position, inside * normal, face),
                ws.SurfacePoints(position, inside * normal),
            ):
                found = ws.ambient_occlusion(mesh, points, 256)
                assert same(found, ws.ambient_occlusion(mesh, points, 256, skip=False))
                assert found.value.max() == 0.0
                hits = ws.trace(mesh, points, ws.sample_directions(points, 32).vectors)
                assert (hits.face[found.status == 0] >= 0).all()


@pytest.mark.parametrize("turn", [0, 3])
@pytest.mark.parametrize("seed", range(3))
@pytest.mark.parametrize("name", ["attic", "box", "flat", "tetrahedron", "cone"])
def test_nor_if_half_of_its_faces_are_turned_over(name, seed, turn):
    """On the rim of an attic's floor, whose roof has its front outside, rays started above the roof."""
    mesh = ROOMS[name]
    turned_over = np.random.default_rng(seed).random(len(mesh.faces)) < 0.5
    faces = np.where(turned_over[:, None], mesh.faces[:, ::-1], mesh.faces)
    mesh = ws.as_mesh((mesh.vertices @ turned(turn).T, faces))
    position, normal, face = on_all_edges(mesh)
    normal = np.where(turned_over[face, None], 1.0, -1.0) * normal
    for points in (ws.SurfacePoints(position, normal, face), ws.SurfacePoints(position, normal)):
        assert ws.ambient_occlusion(mesh, points, 256).value.max() == 0.0


@pytest.mark.parametrize("sections", [3, 5, 6, 8])
def test_nor_where_a_slab_goes_through_a_corner(sections):
    """The start was in front of the corner's other wall, and ended behind it after the move off the slab."""
    room = creation.cylinder(4.0, 3.0, sections=sections)
    corner = np.array([4.0, 0.0, 0.0])
    walls = np.flatnonzero((np.abs(room.triangles - corner)[..., :2] < 1e-6).all(axis=2).sum(axis=1) == 2)
    for seed in range(30):
        turn = trimesh.transformations.euler_matrix(*np.random.default_rng(seed).uniform(-1.2, 1.2, 3))
        slab = creation.box((14.0, 14.0, 0.2)).apply_transform(turn).apply_translation(corner)
        faces = np.concatenate([room.faces[:, ::-1], slab.faces + len(room.vertices)])
        mesh = ws.Mesh(np.concatenate([room.vertices, slab.vertices]), faces)
        places = corner + np.array([[0.0, 0.0, -0.1], [0.0, 0.0, 0.1]]) / turn[2, 2]
        points = ws.SurfacePoints(np.repeat(places, 2, axis=0), mesh.face_normals[[*walls, *walls]], np.tile(walls, 2))
        assert ws.ambient_occlusion(mesh, points, 256).value.max() == 0.0


def test_next_to_an_acute_edge_no_point_sees_out():
    """In an attic of 10 x 14, points of floor and roof are 10^-12 to 10^-2 off the eave."""
    distance = 10.0 ** np.arange(-12.0, -2.0, 0.1)
    for angle in np.radians([45.0, 20.0, 5.0, 1.0]):
        profile = np.array([[0.0, 0.0], [10.0, 0.0], [5.0, 5.0 * np.tan(angle)]])
        vertices = np.array([[x, y, z] for y in (0.0, 14.0) for x, z in profile])
        triangles = [(0, 1, 2), (5, 4, 3), (0, 3, 4), (0, 4, 1), (1, 4, 5), (1, 5, 2), (2, 5, 3), (2, 3, 0)]
        workspace = ws.as_mesh((vertices, np.array(triangles)[:, ::-1]))
        workspace = workspace if workspace.face_normals[3, 2] > 0.9 else ws.as_mesh((vertices, triangles))
        along = np.full(len(distance), 5.0)
        floor = np.stack([10.0 - distance, along, 0.0 * distance], axis=1)
        roof = np.stack([10.0 - distance * np.cos(angle), along, distance * np.sin(angle)], axis=1)
        for position, face in ((floor, 3), (roof, 4)):
            normal = np.repeat(workspace.face_normals[[face]], len(distance), axis=0)
            for known in (None, np.full(len(distance), face)):
                points = ws.SurfacePoints(position, normal, known)
                assert ws.ambient_occlusion(workspace, points, 128).value.max() == 0.0
                assert (ws.trace(workspace, points, ws.sample_directions(points, 16).vectors).face >= 0).all()


SPIKE = np.array(  # of 3.5 degrees: at its first vertex the sum of the normals is against one of them
    [
        (-0.054020, -0.116001, 0.038622),
        (-0.003089, 0.104871, -0.108134),
        (0.029919, -0.049113, -0.017599),
        (-0.057033, -0.011214, -0.032946),
    ]
)
SOLIDS = {
    "attic": trimesh.convex.convex_hull([(x, y, z) for x in (0, 10) for y, z in ((-2, 0), (2, 0), (0, 0.7))]),
    "box": creation.box(),
    "thin plate": creation.box((100.0, 83.1, 0.3)),
    "spike": trimesh.Trimesh(SPIKE, [(0, 2, 1), (0, 1, 3), (1, 2, 3), (2, 0, 3)]),
    "ball": creation.icosphere(2),
    "blade": trimesh.Trimesh(creation.icosphere(1).vertices * [1.25, 1.23, 0.01], creation.icosphere(1).faces),
}


@pytest.mark.parametrize("turn", [0, 3])
@pytest.mark.parametrize("name", SOLIDS)
def test_a_convex_solid_sees_only_sky_from_outside_and_none_from_inside(name, turn):
    vertices, faces = SOLIDS[name].vertices @ turned(turn).T, SOLIDS[name].faces
    split = vertices[faces].reshape(-1, 3), np.arange(faces.size).reshape(-1, 3)
    for inside, (corners, triangles) in ((False, (vertices, faces)), (False, split), (True, (vertices, faces[:, ::-1]))):
        mesh = ws.as_mesh((corners, triangles))
        position, normal, face = on_all_edges(mesh)
        for points in (ws.vertex_points(mesh), ws.SurfacePoints(position, normal, face), ws.SurfacePoints(position, normal)):
            value = ws.ambient_occlusion(mesh, points, 128).value
            assert (value == (0.0 if inside else 1.0)).all()


def test_a_convex_solid_casts_no_ray_from_its_vertices():
    for name in ("box", "ball"):
        mesh = ws.as_mesh(SOLIDS[name])
        assert ws.ambient_occlusion(mesh, ws.vertex_points(mesh), 64).rays.sum() == 0


# A floor and a wall on it


def corner(side, across=0.0, wall_first=1.0):
    """A floor z = 0 from x = -across to 1, and a wall at x = 0 up from it, its front towards +x or, for side -1, -x."""
    floor = [(-across, -9, 0), (9, -9, 0), (9, 9, 0), (-across, 9, 0)]
    wall = [(0, -9, 0), (0, 9, 0), (0, 9, 1e4), (0, -9, 1e4)]
    front = [(4, 5, 6), (4, 6, 7)]
    return ws.as_mesh((floor + wall, [(0, 1, 2), (0, 2, 3), *(f[:: int(side)] for f in front)]))


# An endless wall hides half of the lobe. This one is 18 long and a point is at least 4 from its ends: up to
# 0.5 (1 - 1/sqrt(1 + (x/4)^2)) of the lobe passes it, nothing where x is 0; 1,024 rays are accurate to 0.01.
HALF = 0.012


@pytest.mark.parametrize("side", [1, -1])
def test_on_the_foot_of_a_wall_a_point_sees_what_its_face_sees_just_beside_it(side):
    mesh = corner(side)
    where = [(0.0, 0.0, 0.0), (0.0, 3.3, 0.0), (1e-9, 0.7, 0.0), (0.0, -5.0, 0.0)]
    beside = ws.ambient_occlusion(mesh, at((1e-4, 0.3, 0.0), (0, 0, 1)), 1024).value[0]
    assert abs(beside - 0.5) <= HALF
    for face in (None, np.array([1, 1, 1, 0])):
        points = ws.SurfacePoints(np.array(where), np.float32([(0, 0, 1)] * 4), face)
        found = ws.ambient_occlusion(mesh, points, 1024)
        assert np.abs(found.value - 0.5).max() <= HALF
        assert same(found, ws.ambient_occlusion(mesh, points, 1024, skip=False))


@pytest.mark.parametrize("side", [1, -1])
def test_a_wall_in_the_middle_of_a_floor_has_the_points_on_its_foot_on_its_front(side):
    mesh = corner(side, across=9.0)
    foot = at((0.0, 0.4, 0.0), (0, 0, 1))
    assert abs(ws.ambient_occlusion(mesh, foot, 1024).value[0] - 0.5) <= HALF
    towards = np.float32([[side, 0.0, 0.2], [-side, 0.0, 0.2]])
    hits = ws.trace(mesh, ws.SurfacePoints(np.repeat(foot.position, 2, 0), np.repeat(foot.normal, 2, 0)), towards)
    assert hits.face.tolist()[0] == -1
    assert hits.face[1] in (2, 3)


def edges_and_peaks():
    """Pairs of a mesh and points: a closed room's corners and edges, the foot of a wall, and peaks as steep as walls."""
    room = ws.as_mesh((ROOMS["tetrahedron"].vertices @ turned(3).T, ROOMS["tetrahedron"].faces[:, ::-1]))
    yield room, ws.SurfacePoints(*on_all_edges(room))
    yield room, ws.vertex_points(room)
    foot = np.stack([np.zeros(50), np.linspace(-5.0, 5.0, 50), np.zeros(50)], axis=1)
    yield corner(1), ws.SurfacePoints(foot, np.tile(np.float32([0, 0, 1]), (50, 1)), np.full(50, 1))
    heights = np.random.default_rng(1).uniform(0.0, 30.0, (12, 12))
    terrain = ws.rasters.surface((heights, Affine(1, 0, 0, 0, -1, 0), None), model="tin")
    yield terrain.mesh, terrain.points("surface")[0]


def test_with_wp_mesh_points_on_edges_see_what_they_see_with_the_wide_tree():
    """On a device, too; before, points on edges saw through walls with wp.Mesh, and were off by up to 1."""
    for mesh, points in edges_and_peaks():
        wide, warp = (ws.ambient_occlusion(mesh, points, 256, tracer=tracer) for tracer in ("wide", "warp"))
        assert np.abs(wide.value - warp.value).max() <= 4 / 256  # rays at edges of other faces
        ways = ws.sample_directions(points, 16).vectors
        hits = ws.trace(mesh, points, ways, tracer="warp")
        assert np.count_nonzero((hits.face >= 0) != (ws.trace(mesh, points, ways).face >= 0)) <= ways.size // 3000
        with second_device():
            assert np.array_equal(ws.ambient_occlusion(mesh, points, 256).value, warp.value)
            assert np.array_equal(ws.trace(mesh, points, ways).face, hits.face)


def test_what_floats_starts_where_it_is(bunny, points):
    """What is on the surface starts within a few millionths of it, on the side of its normal."""
    from warpsample.tracing import placed_points

    started = []

    def watched(scene, *arguments, **how):
        starts = set_starts(scene, *arguments, **how)
        started.append(starts / scene.scale + scene.centre)
        return starts

    set_starts = placed_points.set_starts
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(placed_points, "set_starts", watched)
        ways = points.normal[:, None]
        ws.trace(bunny, points, ways)
        floating = ws.SurfacePoints(points.position + 0.01 * points.normal, points.normal)
        ws.trace(bunny, floating, ways)
    height = ((started[0] - points.position[:, None]) * points.normal[:, None]).sum(axis=2)
    # 32 roundings (2^-24) of up to 1.4 along a normal and three axes; rounded to float32 themselves.
    assert (height[:, 0] >= 0.25 * 2.0**-19).all()
    assert (height[:, 0] <= 3.0 * 2.0**-19).all()
    assert (height[:, 1] <= -0.25 * 2.0**-19).all()
    assert np.abs(started[1] - floating.position[:, None]).max() <= 2.0**-24
