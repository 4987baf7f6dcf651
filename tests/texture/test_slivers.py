"""New texture coordinates of meshes with slivers and wires: they take no texels from other faces, and hang nothing."""

import subprocess
import sys

import numpy as np
import pytest
import trimesh

import warpsample as ws
from warpsample.texture.uv import unwrapping
from warpsample.texture.uv.charts import find_wide
from warpsample.texture.uv.pieces import divide_meshes

SPHERE = trimesh.creation.icosphere(3)


@pytest.mark.parametrize("width", [1e-7, 1e-9, 1e-12])
def test_slivers_by_rounding_do_not_set_the_scale(width):
    """More slivers than faces, as in triangulations with vertices along edges; scaled by these, xatlas ran for minutes."""
    random = np.random.default_rng(0)
    edges = SPHERE.faces[random.integers(0, 1280, 1600), :2]
    middle = SPHERE.vertices[edges].mean(axis=1) + width * random.normal(size=(1600, 3))
    slivers = np.column_stack([edges, 642 + np.arange(1600)])
    mesh = ws.Mesh(np.concatenate([SPHERE.vertices, middle]), np.concatenate([SPHERE.faces, slivers]))
    assert [len(piece.rows) for piece in divide_meshes([(mesh.vertices, mesh.faces)])] == [2880]
    split, uv = ws.unwrap(mesh, 512)
    report = ws.texture_points(split, uv, 512).report
    assert report.overlapped < 0.0005 * report.covered  # as the docstring says of folds
    first, second = uv[:1280, 1] - uv[:1280, 0], uv[:1280, 2] - uv[:1280, 0]
    density = np.sqrt(0.5 * np.abs(first[:, 0] * second[:, 1] - first[:, 1] * second[:, 0]) / mesh.face_areas[:1280])
    assert density.max() / density.min() < 3.0


def panels(decimals, size=(3, 2)):
    """Twelve roof panels in any direction: fans of triangles over vertices along their edges, as CAD writes them."""
    random, panels = np.random.default_rng(1), []
    for _ in range(12):
        along = np.arange(3) / 3
        border = [(along, 0 * along), (1 + 0 * along, along), (1 - along, 1 + 0 * along), (0 * along, 1 - along)]
        flat = np.concatenate([np.column_stack(side) for side in border]) * size
        turn = np.linalg.qr(random.normal(size=(3, 3)))[0]
        panels.append(np.round(flat @ turn[:2] + 5 * random.normal(size=3), decimals))
    fan = np.array([(0, i, i + 1) for i in range(1, 11)])
    return ws.Mesh(np.concatenate(panels), np.concatenate([fan + 12 * i for i in range(12)]))


@pytest.mark.parametrize("decimals", [4, 6, 17])
def test_slivers_do_not_take_the_picture(decimals):
    """A sliver got a chart of thousands of texels, and all other charts shrank to 0.5 % of the picture, without a word."""
    mesh = panels(decimals)
    split, uv = ws.unwrap(mesh, 512)
    assert np.array_equal(split.vertices[split.faces], mesh.vertices[mesh.faces])
    t = ws.texture_points(split, uv, 512)
    assert t.report.covered > 0.4 * 512**2
    wide = np.flatnonzero(mesh.face_areas > 1e-3)
    first, second = uv[wide, 1] - uv[wide, 0], uv[wide, 2] - uv[wide, 0]
    density = np.sqrt(0.5 * np.abs(first[:, 0] * second[:, 1] - first[:, 1] * second[:, 0]) / mesh.face_areas[wide])
    assert density.max() / density.min() < 2.0
    left = np.flatnonzero((uv == uv[:, :1]).all(axis=(1, 2)) & (mesh.face_areas > 0))
    drawn = np.setdiff1d(np.arange(len(uv)), left)
    for face in left:  # faces left out show a texel of a neighbour
        touching = np.isin(mesh.faces[drawn], mesh.faces[face]).any(axis=1)
        assert (np.abs(uv[drawn[touching]] - uv[face, 0]).max(axis=2) == 0).any()


SCALES = """
import os, numpy as np
from warpsample.texture.uv import cutting, packing, pieces

pack, scales = packing._pack, []

def recorded(charts, scale, size, padding):
    scales.append(scale * charts.sizes.max())
    return pack(charts, scale, size, padding)

packing._pack = recorded
turns = np.linspace(0, 2 * np.pi, 64, endpoint=False)
ring = np.column_stack([np.cos(turns), np.sin(turns), np.zeros(64)])
vertices = np.concatenate([radius * ring for line in range(9) for radius in (40.0 + line, 40.05 + line)])
start = np.arange(64)
one = np.concatenate([np.column_stack([start, 64 + start, 64 + (start + 1) % 64]),
                      np.column_stack([start, 64 + (start + 1) % 64, (start + 1) % 64])])
faces = (one + 128 * np.arange(9)[:, None, None]).reshape(-1, 3)
meshes = [(p.vertices, p.faces.astype(np.uint32)) for p in pieces.divide_meshes([(vertices, faces)])]
packing.pack_charts(cutting.cut_meshes(meshes, 256, 4).charts, 256, 4)
print(len(scales), max(scales), flush=True)
os._exit(0)
"""


def test_rings_alone_begin_small():
    """The lines of a running track: a first image was 20 times too long, and took minutes at 2048."""
    made = subprocess.run([sys.executable, "-c", SCALES], capture_output=True, text=True, check=True)
    tries, longest = map(float, made.stdout.split()[-2:])
    assert tries <= 6
    assert longest <= 256


def test_slivers_on_edges_leave_other_faces_their_area():
    """In a chart with a sliver of thousands of times its length, faces of a crate collapsed to points."""
    random, crates = np.random.default_rng(2), []
    for _ in range(20):
        turn = np.eye(4)
        turn[:3, :3], turn[:3, 3] = np.linalg.qr(random.normal(size=(3, 3)))[0], random.uniform(-9, 9, 3)
        crates.append(trimesh.creation.box(random.uniform(0.1, 3, 3)).apply_transform(turn))
    whole = trimesh.util.concatenate(crates)
    ends = whole.faces[::3, :2]
    share = random.uniform(0.1, 0.9, (len(ends), 1))
    on_edges = ((1 - share) * whole.vertices[ends[:, 0]] + share * whole.vertices[ends[:, 1]]).astype(np.float32)
    slivers = np.column_stack([ends[:, 0], len(whole.vertices) + np.arange(len(ends)), ends[:, 1]])
    mesh = ws.Mesh(np.concatenate([whole.vertices, on_edges]), np.concatenate([whole.faces, slivers]))
    split, uv = ws.unwrap(mesh, 1024)
    assert ws.texture_points(split, uv, 1024).report.zero_area == 0
    first, second = uv[:240, 1] - uv[:240, 0], uv[:240, 2] - uv[:240, 0]
    density = np.sqrt(0.5 * np.abs(first[:, 0] * second[:, 1] - first[:, 1] * second[:, 0]) / mesh.face_areas[:240])
    assert density.max() / density.min() < 2.0


@pytest.mark.parametrize("length", [9, 11, 13])
def test_a_strip_about_as_long_as_the_image_shrinks_no_charts(length):
    """Slivers of 1.0 to 1.6 times the root of the area had taken up to 71 % of the texels; here the root is 8.5."""
    mesh = panels(17)
    wide = ws.Mesh(mesh.vertices, mesh.faces[find_wide(mesh.vertices[mesh.faces])])
    line = np.array([(0, 0, 30), (length, 0, 30), (0.5 * length, 3e-5 * length, 30)])
    count = len(mesh.vertices)
    longer = ws.Mesh(np.concatenate([mesh.vertices, line]), [*wide.faces, (count, count + 1, count + 2)])
    covered = [ws.texture_points(*ws.unwrap(one, 512), 512).report.covered for one in (longer, wide)]
    assert covered[0] > 0.85 * covered[1]


@pytest.mark.parametrize("gap", [0.0, 1e-11, 1e-8, 1e-6])
def test_a_sliver_between_two_charts_covers_no_texels(gap):
    """Its corners were in two charts, so that its triangle covered half of the image."""
    corners = [(0, 0), (1, 0), (1, 1), (0, 1), (0.5, -gap), (1.5, -gap), (1.5, -1 - gap), (0.5, -1 - gap)]
    faces = [(0, 1, 2), (0, 2, 3), (4, 6, 5), (4, 7, 6), (0, 4, 1), (1, 4, 5)]
    split, uv = ws.unwrap(ws.Mesh(np.pad(corners, ((0, 0), (0, 1))), faces), 256)
    report = ws.texture_points(split, uv, 256).report
    assert report.overlapped == 0
    assert report.covered > 0.4 * 256**2


def test_slivers_along_edges_do_not_end_xatlas():
    """Panels with vertices on one edge: with charts of 10^7 texels in a first image, xatlas ended with a signal."""
    rng, corners, faces = np.random.default_rng(3), [], []
    for start in range(0, 84, 7):
        along = np.sort(rng.uniform(0, 10, 3))
        flat = np.array([(0, 0, 0), (10, 0, 0), (10, 3, 0), (0, 3, 0), *((x, 0, 0) for x in along)])
        turned = flat @ np.linalg.qr(rng.normal(size=(3, 3)))[0] + rng.uniform(-20, 20, 3)
        corners.append(turned.astype(np.float32))
        faces += [(start + a, start + b, start + c) for a, b, c in [(0, 1, 2), (0, 2, 3), (0, 4, 1), (4, 5, 1), (5, 6, 1)]]
    uv = ws.unwrap(ws.Mesh(np.concatenate(corners), np.array(faces)), 4096)[1]
    first, second = uv[:, 1] - uv[:, 0], uv[:, 2] - uv[:, 0]
    assert 0.5 * np.abs(first[:, 0] * second[:, 1] - first[:, 1] * second[:, 0]).sum() > 0.4


def test_long_slivers_shrink_no_charts():
    """Charts of slivers two or three times as long as a strip of 20 x 1 had left 0.22 of the texels."""
    mesh = panels(6, (20, 1))
    wide = ws.Mesh(mesh.vertices, mesh.faces[find_wide(mesh.vertices[mesh.faces])])
    covered = [ws.texture_points(*ws.unwrap(one, 512), 512).report.covered for one in (mesh, wide)]
    assert len(wide.faces) < len(mesh.faces)
    assert covered[0] > 0.9 * covered[1]


@pytest.mark.parametrize("first", [0, 1])
@pytest.mark.parametrize("kind", ["cable", "slivers", "point"])
def test_slivers_of_other_meshes_shrink_no_charts_either(first, kind):
    """A first mesh of slivers alone had ended with "operands could not be broadcast" or "want a larger image"."""
    mesh = panels(4)
    turns = np.linspace(0, 2 * np.pi, 8, endpoint=False)
    ends = [np.column_stack([1e-4 * np.cos(turns), 1e-4 * np.sin(turns), np.full(8, z)]) for z in (0.0, 5.0)]
    around = [face for i in range(8) for face in [(i, (i + 1) % 8, 8 + i), ((i + 1) % 8, 8 + (i + 1) % 8, 8 + i)]]
    slivers = mesh.faces[~find_wide(mesh.vertices[mesh.faces])]
    cases = {"cable": (np.concatenate(ends), np.array(around)), "slivers": (mesh.vertices, slivers)}
    cases["point"] = np.ones((3, 3)), np.array([[0, 1, 2]])
    parts = [(mesh.vertices, mesh.faces)]
    parts.insert(first, cases[kind])
    made = unwrapping.unwrap_meshes(parts, 512, 4)
    for (vertices, faces), (old, corners, uv) in zip(parts, made, strict=True):
        assert np.array_equal(vertices[old][corners], vertices[faces])
        assert ((uv >= 0) & (uv <= 1)).all()
    uv = made[1 - first][2][made[1 - first][1]]
    first, second = uv[:, 1] - uv[:, 0], uv[:, 2] - uv[:, 0]
    assert 0.5 * np.abs(first[:, 0] * second[:, 1] - first[:, 1] * second[:, 0]).sum() > 0.3


def test_a_rope_is_no_sliver_by_rounding():
    """Its faces had the coordinates of a corner of the floor, because a screw has charts rounded up to whole texels."""
    turns = np.linspace(0, 2 * np.pi, 6, endpoint=False)
    ends = [np.column_stack([4e-3 * np.cos(turns), np.full(6, z), 3 + 4e-3 * np.sin(turns)]) for z in (0.0, 60.0)]
    around = [face for i in range(6) for face in [(i, 6 + i, (i + 1) % 6), ((i + 1) % 6, 6 + i, 6 + (i + 1) % 6)]]
    floor = trimesh.creation.box((20, 60, 1))
    screw = trimesh.creation.box((0.01, 0.01, 0.01))
    screw.apply_translation((5, 0, 4))
    rope = trimesh.Trimesh(np.concatenate(ends), around, process=False)
    whole = trimesh.util.concatenate([floor, screw, rope])
    uv = ws.unwrap(ws.as_mesh(whole), 1024)[1]
    assert not (uv[-12:] == uv[-12:, :1]).all(axis=(1, 2)).any()


def test_a_mesh_of_slivers_alone_is_unwrapped():
    """A cable has no other faces, so that none is left out."""
    turns = np.linspace(0, 2 * np.pi, 8, endpoint=False)
    ring = np.column_stack([np.cos(turns), np.sin(turns)]) * 1e-5
    ends = [np.column_stack([ring, np.full(8, z)]) for z in (0.0, 10.0)]
    faces = [(i, (i + 1) % 8, 8 + i) for i in range(8)] + [((i + 1) % 8, 8 + (i + 1) % 8, 8 + i) for i in range(8)]
    split, uv = ws.unwrap(ws.Mesh(np.concatenate(ends), np.array(faces)), 256)
    assert len(split.faces) == 16
    assert ((uv >= 0) & (uv <= 1)).all()
    assert ws.texture_points(split, uv, 256).report.covered > 100


def straight_wires():
    """Thirty quads of 300 x 0.005, in all directions."""
    rng, corners = np.random.default_rng(1), np.array([(0, 0, 0), (300, 0, 0), (300, 0.005, 0), (0, 0.005, 0)])
    turns = np.linalg.qr(rng.normal(size=(30, 3, 3)))[0]
    vertices = (corners @ turns + rng.uniform(-300, 300, (30, 1, 3))).reshape(-1, 3)
    return vertices, (4 * np.arange(30)[:, None, None] + np.array([(0, 1, 2), (0, 2, 3)])).reshape(-1, 3)


def hanging_cables(count):
    """Cables of 300 m, 2 cm thick, of 50 pieces with three sides each."""
    turns, along = np.arange(3) * 2 * np.pi / 3, np.linspace(-1, 1, 51)
    ring = np.column_stack([np.zeros(3), np.cos(turns), np.sin(turns)]) * 0.01
    axis = np.column_stack([150 * along, np.zeros(51), 8 * along**2])
    one = (axis[:, None] + ring).reshape(-1, 3)
    start = np.arange(150)
    beside = start // 3 * 3 + (start + 1) % 3
    faces = np.concatenate([np.column_stack([start, start + 3, beside]), np.column_stack([beside, start + 3, beside + 3])])
    vertices = one + np.array([0, 3, 0]) * np.arange(count)[:, None, None]
    return vertices.reshape(-1, 3), (faces + len(one) * np.arange(count)[:, None, None]).reshape(-1, 3)


def cables_and_house():
    vertices, faces = hanging_cables(3)
    house = trimesh.creation.box((8, 8, 8)).apply_translation((0, 20, 0))
    return np.concatenate([vertices, house.vertices]), np.concatenate([faces, house.faces + len(vertices)])


def cable_and_sliver(width):
    vertices, faces = hanging_cables(1)
    sliver = [(-100, 0, 9), (100, 0, 9), (50, width, 9)]
    return np.concatenate([vertices, sliver]), np.concatenate([faces, [len(vertices) + np.arange(3)]])


@pytest.mark.parametrize(
    ("scene", "sizes", "ratio"),
    [
        (straight_wires(), (256, 1024), 2.5),
        (hanging_cables(1), (256, 512), 1.8),
        (cable_and_sliver(0.0), (256, 512), 1.8),
        (cable_and_sliver(1e-3), (256, 512), 1.8),
        (cables_and_house(), (128, 256), 1.9),
    ],
)
def test_wires_have_more_texels_in_a_larger_image(scene, sizes, ratio):
    """They had fewer, as the charts of the first try were ten times as long as the image, and later ones too small."""
    mesh, counts = ws.Mesh(*scene), []
    for size in sizes:
        split, uv = ws.unwrap(mesh, size)
        counts.append(ws.texture_points(split, uv, size).report.covered)
    assert counts[1] > ratio * counts[0]


@pytest.mark.parametrize("width", [1e-5, 1e-9, 1e-12, 1e-15])
def test_a_sliver_alone_hangs_nothing(width):
    """Charts were a million times as long as the image, and had no end; printed assertions of xatlas spoiled its answer."""
    sliver = ws.Mesh([[0, 0, 0], [100, 0, 0], [50, width, 0]], [[0, 1, 2]])
    split, uv = ws.unwrap(sliver, 64)
    assert ((uv >= 0) & (uv <= 1)).all()
    assert len(split.faces) == 1


@pytest.mark.parametrize("first", [0, 8])  # connected to the crate, or not
@pytest.mark.parametrize(("length", "width"), [(3000, 0), (3000, 0.1), (3000, 1e-9), (40, 1e-3)])
def test_a_long_sliver_shrinks_no_charts(length, width, first):
    """Beside a crate of 1 m, a line took all texels, if it was longer than the image and not stretched."""
    box = trimesh.creation.box()
    line = box.vertices[0] + np.array([(0, 0, 0), (length, 0, 0), (0.5 * length, width, 0)])
    mesh = ws.Mesh(np.concatenate([box.vertices, line]), [*box.faces, (first, 9, 10)])
    split, uv = ws.unwrap(mesh, 128)
    assert ws.texture_points(split, uv, 128).report.covered > 0.4 * 128**2


@pytest.mark.parametrize("height", [1e5, 1e11, 1e30])
def test_a_vertex_far_away_shrinks_no_charts(height):
    """By a damaged number in a file: with a scale for its faces, the others had no area, and at 1e11 xatlas hung."""
    ball = trimesh.creation.icosphere(1)
    vertices = ball.vertices.copy()
    vertices[5] = 0.0, 0.5, height
    split, uv = ws.unwrap(ws.Mesh(vertices, ball.faces), 64)
    report = ws.texture_points(split, uv, 64).report
    assert (report.zero_area, report.flat_slivers) == (0, 5)
    assert report.covered > 1000


def test_a_mesh_of_long_slivers_alone_beside_another_has_no_charts():
    ball = trimesh.creation.icosphere(1)
    line = np.array([(0, 0, 5), (900, 0, 5), (400, 1e-3, 5), (0, 0, 9)], np.float64)
    made = unwrapping.unwrap_meshes([(line, np.array([(0, 1, 2)])), (ball.vertices, ball.faces)], 128, 4)
    (old, corners, uv), (_, faces, _) = made
    assert old[corners].tolist() == [[0, 1, 2]]
    assert not uv.any()
    assert len(faces) == len(ball.faces)


def test_a_collapsed_face_shrinks_no_charts():
    """One of 3 km took all texels, though xatlas gives it no chart."""
    box = trimesh.creation.box()
    mesh = ws.Mesh(np.concatenate([box.vertices, [(3000, 0, 0)]]), [*box.faces, (0, 8, 0)])
    split, uv = ws.unwrap(mesh, 128)
    assert ws.texture_points(split, uv, 128).report.covered > 0.4 * 128**2
