"""From a finer mesh to the texels of a coarse one: its normals, positions and occlusion."""

import tracemalloc
from types import SimpleNamespace

import numpy as np
import pytest
import trimesh
from glb_files import glb
from lookups import floor_by_a_wall
from textured_scenes import SQUARE, TWO, corner, opened, picture

import warpsample as ws
from warpsample.texture.high import HighMesh, average_normals
from warpsample.texture.shading import compute_corner_normals, shade_points

RADIUS, HALF, SIZE = 2.0, 1.2, 32


def quad(path, half=HALF, height=RADIUS):
    """A level square, u along x and v along z, at the height of a ball's top."""
    square = (np.float32([(-1, 0, 1), (1, 0, 1), (1, 0, -1), (-1, 0, -1)]) * half + np.float32((0, height, 0))).astype("f4")
    attributes = {"POSITION": 0, "TEXCOORD_0": 1}
    tree = {"meshes": [{"primitives": [{"attributes": attributes, "indices": 2}]}], "nodes": [{"mesh": 0}]}
    path.write_bytes(glb(tree, [square, np.float32(SQUARE * (1, -1) + (0, 1)), TWO]))
    return path


@pytest.fixture
def ball(tmp_path):
    path = tmp_path / "ball.ply"
    trimesh.creation.icosphere(5, radius=RADIUS).export(path)
    return path


def places(half=HALF):
    """(SIZE, SIZE) x and z of the texels' centres."""
    at = half * (2 * (np.arange(SIZE) + 0.5) / SIZE - 1)
    return np.meshgrid(at, at)


def test_places_with_flat_facets_share_a_normal_map(call, tmp_path):
    """A distant place rounds rays, so that single samples of a texel are on the next facet."""
    path = quad(tmp_path / "low.glb")
    tree = opened(path)[0]
    nodes = [{"mesh": 0, "translation": [x, 0, 0]} for x in (0, 373, -817)]
    square = (np.float32([(-1, 0, 1), (1, 0, 1), (1, 0, -1), (-1, 0, -1)]) * HALF + np.float32((0, RADIUS, 0))).astype("f4")
    arrays = [square, np.float32(SQUARE * (1, -1) + (0, 1)), TWO]
    path.write_bytes(glb({"meshes": tree["meshes"], "nodes": nodes}, arrays))
    facets = trimesh.creation.icosphere(2, radius=RADIUS)
    arrays = [facets.triangles.reshape(-1, 3).astype("f4"), np.arange(3 * len(facets.faces), dtype="u4")]
    arrays += [np.repeat(facets.face_normals, 3, axis=0).astype("f4")]
    part = {"attributes": {"POSITION": 0, "NORMAL": 2}, "indices": 1}
    ball = {"meshes": [{"primitives": [part]}], "nodes": nodes}
    (tmp_path / "ball.glb").write_bytes(glb(ball, arrays))
    options = ("--quantity", "normals", "--high", tmp_path / "ball.glb", "--cage", 0.6, "--supersample", 16)
    status, out, err = call("bake", path, "-o", tmp_path / "out.glb", "--texture", 128, *options)
    assert (status, err, "the 3 places of 'meshes[0]' share one picture" in out) == (0, "", True)


def test_a_ball_above_a_square(call, tmp_path, ball):
    """n = (x, y, z) / R, as colours: 191, 128, 238 at x = 1; the image's up is -z."""
    low, output = quad(tmp_path / "low.glb"), tmp_path / "out.glb"
    options = ("--texture", SIZE, "--high", ball, "--cage", 1)
    status, out, err = call("bake", low, "-o", output, *options, "--quantity", "normals")
    assert (status, err, "finer mesh" in out) == (0, "", False)
    tree, data, _ = opened(output)
    read = 255 * picture(tree, data, tree["materials"][0]["normalTexture"]["index"])
    x, z = places()
    y = np.sqrt(RADIUS**2 - x**2 - z**2)
    want = 127.5 + 127.5 * np.stack([x, -z, y], axis=2) / RADIUS
    assert np.abs(read - want).max() < 0.5 + 0.3  # rounding; facets of 0.04 turn smooth normals by 0.001
    assert call("bake", low, "-o", tmp_path / "out.npz", *options, "--quantity", "position")[0] == 0
    with np.load(tmp_path / "out.npz") as found:
        assert np.abs(found["value"] - np.stack([x, y, z], axis=2)).max() < 1e-3  # the sagitta of the facets is 3e-4


@pytest.mark.parametrize("far", [1e4, 1e6])
def test_a_distant_face_of_the_finer_mesh_moves_no_texel(call, tmp_path, ball, far):
    """Rays start beside edges by a share of the mesh's size; a distant face made this 13 texels."""
    low, both = quad(tmp_path / "low.glb"), tmp_path / "far.ply"
    options = ("--texture", SIZE, "--cage", 1, "--quantity", "position")
    mesh = trimesh.load(ball)
    away = np.array([(far, 0, 0), (far, 1e-4 * far, 0), (far, 0, 1e-4 * far)])
    faces = np.vstack([mesh.faces, len(mesh.vertices) + np.arange(3)])
    trimesh.Trimesh(np.vstack([mesh.vertices, away]), faces, process=False).export(both)
    found = []
    for high in (ball, both):
        assert call("bake", low, "-o", tmp_path / "out.npz", *options, "--high", high)[0] == 0
        with np.load(tmp_path / "out.npz") as file:
            found.append(file["value"])
    assert np.abs(found[0] - found[1]).max() < 0.01 * 2 * HALF / SIZE


def test_what_the_cage_does_not_reach_is_counted_and_filled(call, tmp_path, ball):
    """Rays start at 3 and end at 1: they miss the ball beyond sqrt(3) of its axis."""
    low = quad(tmp_path / "low.glb", half=3.0)
    options = ("--texture", SIZE, "--high", ball, "--cage", 1, "--quantity", "position")
    status, out, _ = call("bake", low, "-o", tmp_path / "out.npz", *options)
    x, z = places(3.0)
    missed = int(np.count_nonzero(x**2 + z**2 > 3.0))  # no texel's centre is nearer than 0.01 to the circle
    assert (status, f"  {missed:,} points without a hit on the finer mesh within the cage, filled" in out) == (0, True)
    assert "points without a value" not in out
    with np.load(tmp_path / "out.npz") as found:
        assert found["value"][..., 1].min() > 0.99


def test_the_occlusion_is_of_the_finer_mesh(call, tmp_path):
    """A floor beside a wall that the coarse mesh has not: V = (1 + d / sqrt(d^2 + h^2)) / 2."""
    high, _ = floor_by_a_wall(1.0, 100.0, 2.0)
    turned = high.vertices[:, [0, 2, 1]] * (1, 1, -1) + (-1.0, 0.0, 0.0)  # y up, the floor from -1 to 1
    path = tmp_path / "high.obj"
    trimesh.Trimesh(turned, high.faces, process=False).export(path)
    low = quad(tmp_path / "low.glb", half=1.0, height=0.01)
    options = ("--texture", SIZE, "--high", path, "--cage", 0.1, "--samples", 1024)
    assert call("bake", low, "-o", tmp_path / "out.npz", *options)[0] == 0
    d = places(1.0)[0] + 1.0
    with np.load(tmp_path / "out.npz") as found:
        error = found["value"] - (1 + d / np.hypot(d, 1)) / 2
    assert np.sqrt(np.mean(error**2)) < 0.006  # 1,024 rays give 0.004; without the wall it is 0.2


def test_a_mesh_upon_itself_is_as_it_is(call, tmp_path):
    """A box with hard edges, whose averaged normals are slanted: its normal map is flat to its borders."""
    box = trimesh.creation.box((2, 2, 2))
    tree = {"meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}], "nodes": [{"mesh": 0}]}
    path = tmp_path / "box.glb"
    path.write_bytes(glb(tree, [np.float32(box.vertices), np.uint16(box.faces).ravel()]))
    uv = ("--texture", 64, "--uv", "new")
    status, out, _ = call(
        "bake", path, "-o", tmp_path / "out.glb", *uv, "--high", path, "--cage", 0.1, "--quantity", "normals"
    )
    assert (status, "finer mesh" in out) == (0, False)
    made, data, _ = opened(tmp_path / "out.glb")
    read = np.round(255 * picture(made, data, made["materials"][0]["normalTexture"]["index"]))
    assert np.abs(read - (128, 128, 255)).max() <= 1


def test_light_passes_through_the_finer_mesh(call, tmp_path):
    """The floor beside a wall, onto itself: a wall that transmits half of the light hides half as much."""
    path = tmp_path / "in.glb"
    path.write_bytes(floor_and_wall())
    means = []
    for options in ((), ("--transmittance", 0.5), ("--transmittance", "wall=1")):
        output = tmp_path / "out.npz"
        command = ("bake", path, "-o", output, "--texture", SIZE, "--uv", 0, "--samples", 64, *options)
        assert call(*command, "--high", path, "--cage", 0.1)[0] == 0
        with np.load(output) as found:
            means.append(1 - found["value"].mean())
    assert means[0] > 0.1
    assert means[1] == pytest.approx(means[0] / 2, rel=1e-4)  # the same rays
    assert means[2] == 0.0


def floor_and_wall():
    """A floor with texture coordinates, and a wall called "wall" that is outside of the image."""
    floor, wall = corner()
    outside = np.full((4, 2), 5, np.float32)
    parts = [{"primitives": [{"attributes": {"POSITION": i, "TEXCOORD_0": i + 2}, "indices": 4}]} for i in (0, 1)]
    nodes = [{"mesh": 0, "name": "floor"}, {"mesh": 1, "name": "wall"}]
    return glb({"meshes": parts, "nodes": nodes}, [floor, wall, SQUARE, outside, TWO])


def test_a_finer_mesh_elsewhere_is_refused(call, tmp_path, ball):
    """No texel has a value: an occlusion of 0 everywhere would be no result."""
    low = quad(tmp_path / "low.glb", height=9.0)
    status, _, err = call("bake", low, "-o", tmp_path / "out.glb", "--texture", 8, "--high", ball, "--cage", 1)
    want = "want a larger distance, or a finer mesh in the same place"
    assert (status, err) == (2, f"error: --cage: got 1, within which no texel finds a face of {str(ball)!r}, {want}\n")
    assert not (tmp_path / "out.glb").exists()


def test_back_faces_are_passed():
    """A ball within a ball whose faces are turned inward: rays from outside go through the near side of that."""
    inner, outer = trimesh.creation.icosphere(3, radius=1.0), trimesh.creation.icosphere(3, radius=1.5)
    vertices = np.concatenate([inner.vertices, outer.vertices])
    faces = np.concatenate([inner.faces, outer.faces[:, ::-1] + len(inner.vertices)])
    mesh = ws.Mesh(vertices, faces)
    high = HighMesh(mesh, mesh.vertex_normals[mesh.faces].astype(float), 1.0, "face")
    low = ws.as_mesh(inner)
    found, missed = high.project(ws.face_centers(low), low)
    assert not missed.any()
    assert np.array_equal(found.face, np.arange(len(inner.faces)))


def test_rays_of_a_wall_are_not_turned_by_a_large_floor_beside_it():
    """By area, the floor has 99 % of the edge's normal, and rays along the wall leave the cage before they meet it."""
    corners = np.array([(0, 0, 0), (1, 0, 0), (1, 0, 1), (0, 0, 1), (1, 100, 0), (0, 100, 0)], float)
    low = ws.Mesh(corners, [[0, 1, 2], [0, 2, 3], [0, 4, 1], [0, 5, 4]])  # a wall of 1, and a floor of 100, at right angles
    normals = average_normals(low, 0.1)
    assert np.abs(normals[0, 0]).round(6).tolist() == [0.0, 0.707107, 0.707107]
    assert normals[0, 2].tolist() == low.face_normals[0].tolist()
    scaled = average_normals(ws.Mesh(1e-20 * corners, low.faces), 1e-21)
    assert np.allclose(normals, scaled, atol=1e-6)


def test_each_side_of_a_sheet_has_normals_of_its_own():
    """Their sum is 0 but for rounding, which was taken for a direction: half of the texels showed the other side."""
    ball = trimesh.creation.icosphere(2)
    sheet = ws.Mesh(ball.vertices, np.concatenate([ball.faces, ball.faces[:, ::-1]]))
    one_sided = average_normals(ws.as_mesh(ball), 0.1)
    assert (average_normals(sheet, 0.1)[: len(ball.faces)] * one_sided).sum(
        axis=2
    ).min() > 0.9999  # weights have cosines, too
    high = HighMesh(sheet, np.repeat(sheet.face_normals[:, None], 3, axis=1).astype(float), 0.1, "face")
    low = ws.face_centers(sheet)
    found, missed = high.project(low, sheet)
    assert not missed.any()
    assert ((found.normal * low.normal).sum(axis=1) > 0.9).all()


def points_at(mesh, face, weights):
    """Points on faces with barycentric weights."""
    position = np.einsum("pk,pkx->px", weights, mesh.vertices[mesh.faces[face]])
    return ws.SurfacePoints(position, mesh.face_normals[face], face.astype(np.int32), weights)


def evenly_per_face(mesh, count):
    """`count` points on each face, whatever its area."""
    face = np.repeat(np.arange(len(mesh.faces)), count)
    return points_at(mesh, face, np.random.default_rng(0).dirichlet((1, 1, 1), len(face)))


def interpolated(mesh, points, cage):
    """Points with the normals that rays to a finer mesh have."""
    turned = compute_corner_normals(mesh, average_normals(mesh, cage))[points.face]
    normals = shade_points(mesh, turned, points.face, points.barycentric, "file")
    return ws.SurfacePoints(points.position, normals[1], points.face, points.barycentric)


def fans_of_squares(height, distance, n=9):
    """A height field over [-1, 1]^2 with an upper and a lower side, whose squares have different diagonals, on a map."""
    x, y = np.meshgrid(*2 * [np.linspace(-1.0, 1.0, n)])
    corner = (np.arange(n - 1)[:, None] * n + np.arange(n - 1)).reshape(-1, 1)
    square = corner + np.array([0, 1, n + 1, n])
    faces = np.concatenate([side[:, fan] for side in (square, square[:, ::-1]) for fan in ([0, 1, 2], [0, 2, 3])])
    return on_a_map(SimpleNamespace(vertices=np.stack([x, y, height(x, y)], axis=-1).reshape(-1, 3), faces=faces), distance)


def on_a_map(one, distance):
    """A mesh `distance` along x from a ground below, which has most of the vertices."""
    ground = np.random.default_rng(0).random((600, 3)) * (1.0, 1.0, 0.0) - (0.0, 0.0, 2e3)
    faces = len(one.vertices) + np.arange(600).reshape(-1, 3)
    moved = one.vertices + np.array([distance, 0.0, 0.0])
    return ws.Mesh(np.concatenate([moved, ground]), np.concatenate([one.faces, faces]))


@pytest.mark.parametrize("distance", [0.0, 1e5])
def test_a_curved_sheet_with_other_diagonals_on_its_back_shows_its_own_sides(distance):
    """Its mean normals cancel but for the curvature: what was left led half of the rays to the other side."""
    sheet = fans_of_squares(lambda x, y: 0.15 * np.sin(2.0 * x) * np.cos(2.0 * y) + 0.05 * np.sin(5.0 * x * y), distance)
    fine = ws.Mesh(sheet.vertices[:81], sheet.faces[:256])  # without the ground, whose distance would coarsen its rays
    high = HighMesh(fine, np.repeat(fine.face_normals[:, None], 3, axis=1).astype(float), 0.1, "face")
    points = interpolated(sheet, ws.sample_surface(sheet, 2000, barycentric=True), high.cage)
    points = points.take(np.flatnonzero(points.position[:, 2] > -1e3))
    found, missed = high.project(points, sheet)
    assert not missed.any()
    assert ((found.normal * sheet.face_normals[points.face]).sum(axis=1) > 0.9).all()


def test_many_corners_at_one_place_take_no_memory_for_their_pairs():
    """A leaf whose pivot is where an object is that a scale of 0 hides, and two fans of 6,000 faces: they took gigabytes."""
    turn = np.linspace(0.0, 2.0 * np.pi, 6_001)
    rim = np.stack([np.cos(turn), np.sin(turn), 0.0 * turn], axis=1)
    fan = np.stack([np.zeros(6_000, int), np.arange(1, 6_001), np.arange(2, 6_002)], axis=1)
    hidden = np.zeros((20_000, 3), int)
    mesh = ws.Mesh(np.concatenate([np.zeros((1, 3)), rim]), np.concatenate([fan, fan[:, ::-1], hidden]))
    tracemalloc.start()
    normals = average_normals(mesh, 0.1)
    peak = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    assert peak < 200e6  # the pairs alone would take 8 * 12,000^2 bytes = 1.2 GB
    assert np.abs(normals[:6_000] - (0.0, 0.0, 1.0)).max() < 1e-6


@pytest.mark.parametrize(
    ("size", "distance"),
    [((2.0, 0.002, 1.0), 0.0), ((2.0, 0.001, 1.0), 0.0), ((20.0, 0.003, 20.0), 0.0), ((1.0, 0.005, 1.0), 2000.1)],
)
def test_the_rim_of_a_thin_plate_shows_itself(size, distance):
    """A finer plate larger by a tenth of its thickness: top and bottom turned 13 to 67 % of the rays of such rims."""
    low = on_a_map(trimesh.creation.box(size), distance)
    fine = on_a_map(trimesh.creation.box(np.array(size) + 0.2 * min(size)), distance)
    high = HighMesh(fine, np.repeat(fine.face_normals[:, None], 3, axis=1).astype(float), 0.45 * min(size), "face")
    points = interpolated(low, evenly_per_face(low, 200), high.cage)
    points = points.take(np.flatnonzero(points.position[:, 2] > -1e3))
    found, missed = high.project(points, low)
    assert not missed.any()
    assert ((found.normal * low.face_normals[points.face]).sum(axis=1) > 0.9).all()


@pytest.mark.parametrize("size", [(2.0, 2.0, 2.0), (20.0, 0.03, 0.03), (20.0, 0.1, 20.0)])
@pytest.mark.parametrize("seed", [0, 1])
def test_points_on_edges_show_their_own_side(size, seed):
    """Also of long faces, where the way to the middle is nearly along the edge; upon a finer mesh with the same edges."""
    box = trimesh.creation.box(size, trimesh.transformations.random_rotation_matrix(np.random.default_rng(seed).random(3)))
    mesh = ws.as_mesh(box)
    high = HighMesh(mesh, np.repeat(mesh.face_normals[:, None], 3, axis=1).astype(float), 0.3 * min(size), "face")
    share = np.linspace(0.0, 1.0, 40)[:, None]
    weights = np.concatenate([np.roll(np.hstack([share, 1.0 - share, 0.0 * share]), turn, axis=1) for turn in range(3)])
    face = np.repeat(np.arange(len(mesh.faces)), len(weights))
    points = interpolated(mesh, points_at(mesh, face, np.tile(weights, (len(mesh.faces), 1))), high.cage)
    found, missed = high.project(points, mesh)
    assert not missed.any()
    assert ((found.normal * mesh.face_normals[face]).sum(axis=1) > 0.9).all()


def test_rays_of_a_large_scene_are_moved_by_what_they_resolve():
    """Crates over 2 km: they were moved by 7 times as much, half a texel, and the report compared with this length."""
    square = np.float64([(-1, -1, 0), (1, -1, 0), (1, 1, 0), (-1, 1, 0)])
    places = np.random.default_rng(1).uniform(-1000.0, 1000.0, (300, 1, 3)) * (1, 1, 0)
    corners = (square + places).reshape(-1, 3)
    faces = (np.array([[0, 1, 2], [0, 2, 3]]) + 4 * np.arange(300)[:, None, None]).reshape(-1, 3)
    mesh = ws.Mesh(corners, faces)
    high = HighMesh(mesh, np.repeat(mesh.face_normals[:, None], 3, axis=1).astype(float), 0.1, "face")
    points = ws.sample_surface(mesh, 2000)
    found, missed = high.project(points, mesh)
    assert not missed.any()
    # Half of what rays resolve towards the middle, and as far from one edge, or from two at a right angle.
    assert np.linalg.norm(found.position - points.position, axis=1).max() < 1.21 * 2.0**-19 * 1000.0


ROUNDED = {  # how files round corners, and nodes place them
    "float32": lambda corners: corners.astype(np.float32),
    "float32, 1 km away": lambda corners: (corners + 1000.0).astype(np.float32),
    "float32, 1 km away, moved back": lambda corners: (corners + 1000.0).astype(np.float32) - 1000.0,
    "float32, 1 km away, scaled": lambda corners: 0.01 * (100.0 * (corners + 1000.0)).astype(np.float32).astype(float),
    "five decimals": lambda corners: corners.round(5),
}


@pytest.mark.parametrize("seed", range(4))
@pytest.mark.parametrize("rounded", ROUNDED.values(), ids=ROUNDED)
def test_slivers_turn_no_rays(seed, rounded):
    """A cap triangle at a T-junction has an angle of 180 degrees, and a normal of rounding."""
    corners = np.array([(0, 0, 0), (2, 0, 0), (2, 2, 0), (0, 2, 0), (0.7, 0, 0), (1, -1, 0)], float)
    turn = trimesh.transformations.random_rotation_matrix(np.random.default_rng(seed).random(3))[:3, :3]
    low = ws.Mesh(rounded(corners @ turn.T).astype(float), [[0, 2, 3], [0, 1, 2], [0, 5, 4], [4, 5, 1], [0, 4, 1]])
    # Up to 1e-4 wide, less than a tenth of 1/16 of the cage: of a weight of 0.01, which turns by up to 0.01 radians.
    assert (average_normals(low, 0.02)[:4] @ low.face_normals[1].astype(float)).min() > 1.0 - 0.5 * 0.015**2


@pytest.mark.parametrize("backs_first", [False, True])
def test_front_faces_that_coincide_with_back_faces_are_found(backs_first):
    """Leaves and cloth have two layers. Rays that met the back layer first passed both: half of the points missed."""
    ball = trimesh.creation.icosphere(3)
    both = [ball.faces[:, ::-1], ball.faces] if backs_first else [ball.faces, ball.faces[:, ::-1]]
    mesh = ws.Mesh(ball.vertices, np.concatenate(both))
    high = HighMesh(mesh, np.repeat(mesh.face_normals[:, None], 3, axis=1).astype(float), 0.5, "face")
    low = ws.as_mesh(ball)
    found, missed = high.project(ws.face_centers(low), low)
    assert not missed.any()
    assert np.array_equal(found.face, np.arange(len(ball.faces)) + (len(ball.faces) if backs_first else 0))


@pytest.mark.parametrize(
    ("options", "why"),
    [
        (["--high", "ball.ply"], "--high: got one of --high and --cage, want both"),
        (["--cage", 1], "--high: got one of --high and --cage, want both"),
        (["--high", "ball.ply", "--cage", 0], "--cage: got 0.0, want a number"),
        (["--high", "none.ply", "--cage", 1], "--high: got 'none.ply', which is missing"),
    ],
)
def test_wrong_options_are_named(call, tmp_path, ball, monkeypatch, options, why):
    monkeypatch.chdir(tmp_path)
    quad(tmp_path / "low.glb")
    status, _, err = call("bake", "low.glb", "-o", "out.glb", "--texture", 8, *options)
    assert (status, err[: 7 + len(why)]) == (2, f"error: {why}")
