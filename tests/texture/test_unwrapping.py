"""New texture coordinates: the same faces, without overlap, as far apart as was asked for, in the size that was meant."""

import signal
import subprocess
import sys

import numpy as np
import pytest
import trimesh
from meshes import quads

import warpsample as ws
from warpsample.texture.jobs import square_side
from warpsample.texture.uv import unwrapping
from warpsample.texture.uv.charts import label_charts

GROUND = np.array([(0.0, 0, 0), (50, 0, 0), (50, 50, 0), (0, 50, 0)])[[0, 1, 2, 0, 2, 3]]
SPHERE = trimesh.creation.icosphere(3)


@pytest.mark.parametrize("mesh", [ws.load_mesh("courtyard"), ws.as_mesh(SPHERE)], ids=["courtyard", "sphere"])
@pytest.mark.parametrize("size", [128, 1000])
def test_charts_fit_and_keep_their_distance(mesh, size):
    """Lengths in the image are those on the surface within a factor of 2 by xatlas' stretch; texels of charts are apart."""
    padding = 4
    split, uv = ws.unwrap(mesh, size, padding=padding)
    assert np.array_equal(split.vertices[split.faces], mesh.vertices[mesh.faces])
    assert (uv >= 0.0).all()
    assert (uv <= 1.0).all()
    t = ws.texture_points(split, uv, size)
    assert (t.report.overlapped, t.report.outside, t.report.zero_area) == (0, 0, 0)
    chart = np.full(size * size, -1)
    chart[t.texel] = label_charts(uv)[t.face]
    chart = chart.reshape(size, size)
    assert len(np.unique(chart)) > 4
    for step in range(1, padding - 1):  # texels that are covered reach up to 1 beyond each chart
        beside = np.stack([chart[:, step:].ravel(), chart[:, :-step].ravel()])
        both = beside[:, (beside >= 0).all(axis=0)]
        assert both.shape[1] > 0
        assert (both[0] == both[1]).all()
    first, second = uv[:, 1] - uv[:, 0], uv[:, 2] - uv[:, 0]
    areas = 0.5 * np.abs(first[:, 0] * second[:, 1] - first[:, 1] * second[:, 0])
    density = np.sqrt(areas / mesh.face_areas)
    assert density.max() / density.min() < 2.0
    assert areas.sum() > 0.2  # of the image, most of which xatlas fills


def test_parts_stay_and_size_and_place_do_not_matter():
    """A mesh of a millionth of the size, far away, has the same charts; the same call gives the same bits."""
    named = {"part": np.arange(1280) % 2, "parts": ("a", "b")}
    mesh = ws.Mesh(SPHERE.vertices, SPHERE.faces, **named, transmittance=np.linspace(0, 1, 1280))
    split, uv = ws.unwrap(mesh, 256)
    assert np.array_equal(split.part, mesh.part)
    assert np.array_equal(split.transmittance, mesh.transmittance)
    assert np.array_equal(ws.unwrap(mesh, 256)[1], uv)
    tiny = ws.Mesh(mesh.vertices * 2.0**-20, mesh.faces)
    assert np.array_equal(ws.unwrap(tiny, 256)[1], uv)
    assert np.array_equal(ws.unwrap(ws.Mesh(mesh.vertices * 2.0**20, mesh.faces), 256)[1], uv)


@pytest.mark.parametrize("distance", [1e3, 1e5, 1e8])
def test_distant_faces_leave_the_charts_of_others_as_they_are(distance):
    """A face 10 km from a sphere of 1 m gave areas from 0.1 to 3.8 times the mean, and at 1,000 km there was no chart.

    Two equal spheres do not become one.
    """
    stray = np.array([(distance, 0, 0), (distance + 0.5, 0, 0), (distance, 0.5, 0)])
    vertices = np.concatenate([SPHERE.vertices, stray, SPHERE.vertices + np.array([0, distance, 0])])
    mesh = ws.Mesh(vertices, np.concatenate([SPHERE.faces, [[642, 643, 644]], SPHERE.faces + 645]))
    split, uv = ws.unwrap(mesh, 512)
    assert np.array_equal(split.vertices[split.faces], mesh.vertices[mesh.faces])
    report = ws.texture_points(split, uv, 512).report
    assert (report.overlapped, report.outside, report.zero_area) == (0, 0, 0)
    first, second = uv[:, 1] - uv[:, 0], uv[:, 2] - uv[:, 0]
    density = np.sqrt(0.5 * np.abs(first[:, 0] * second[:, 1] - first[:, 1] * second[:, 0]) / mesh.face_areas)
    assert density.max() / density.min() < 2.0  # xatlas' stretch, as without distant faces


CREATE = trimesh.creation


def arc(degrees):
    """An open part of a tube with 300 x 4 quads, from one end to the other."""
    turns = np.radians(np.linspace(0, degrees, 301))
    ring = np.column_stack([np.cos(turns), np.sin(turns)])
    vertices = [np.column_stack([ring, np.full(301, height)]) for height in np.linspace(0, 1, 5)]
    return trimesh.Trimesh(np.concatenate(vertices), quads(5, 301), process=False)


def tube_with_collapsed_faces():
    tube = CREATE.cylinder(1, 2, sections=600)
    a, b, c = tube.faces.T
    faces = np.stack([tube.faces, *(np.column_stack([p, q, q]) for p, q in ((a, b), (b, c), (c, a)))], axis=1)
    return trimesh.Trimesh(tube.vertices, faces.reshape(-1, 3), process=False)


@pytest.mark.parametrize(
    "shape",
    [
        lambda: CREATE.cylinder(1, 2, sections=512),
        lambda: CREATE.annulus(0.9, 1, 3, sections=700),
        pytest.param(lambda: CREATE.torus(1, 0.3, 600, 60), marks=pytest.mark.thorough),
        lambda: CREATE.icosphere(6),
        pytest.param(lambda: CREATE.uv_sphere(count=(64, 512)), marks=pytest.mark.thorough),
        lambda: arc(90),
        lambda: arc(99),
        lambda: CREATE.cone(1, 0.9, sections=600),
    ],
    ids=["tube", "pipe", "torus", "sphere", "belts", "quarter", "more", "cone"],
)
def test_finely_divided_surfaces_are_no_planes(shape):
    """xatlas took a tube for a plane, so that its front and back had the same texels; on the sphere it ended with -11."""
    mesh = ws.as_mesh(shape())
    split, uv = ws.unwrap(mesh, 512)
    report = ws.texture_points(split, uv, 512).report
    assert (report.overlapped, report.zero_area) == (0, 0)
    assert report.covered > 0.3 * 512**2
    lengths = [np.linalg.norm(np.roll(own, -1, axis=1) - own, axis=2) for own in (uv, mesh.vertices[mesh.faces])]
    density = lengths[0] / lengths[1]
    assert density.min() / np.median(density) > 0.4  # across 45 degrees from the middle, cos 45 = 0.7; corners are 0.58
    assert density.max() / np.median(density) < 1.6  # xatlas' stretch; at most 1.4 was measured


@pytest.mark.parametrize("noise", [0.0, 1e-10, 1e-6])
def test_seams_may_agree_up_to_rounding_alone(noise):
    """xatlas joins vertices that are equal in float32: six parts of a tube, each 60 degrees wide, became a plane."""
    angle = np.linspace(0, np.pi / 3, 101)
    part = np.concatenate([np.column_stack([np.cos(angle), np.sin(angle), np.full(101, z)]) for z in np.linspace(0, 2, 5)])
    turns = [trimesh.transformations.rotation_matrix(k * np.pi / 3, (0, 0, 1))[:3, :3] for k in range(6)]
    vertices = np.concatenate([part @ turn.T for turn in turns])
    vertices += noise * np.random.default_rng(0).standard_normal(vertices.shape)
    split, uv = ws.unwrap(ws.Mesh(vertices, np.concatenate([quads(5, 101) + 505 * k for k in range(6)])), 512)
    assert ws.texture_points(split, uv, 512).report.overlapped == 0


@pytest.mark.parametrize(
    "repeat",
    [
        lambda faces: np.concatenate([faces, faces[:, ::-1]]),
        lambda faces: np.stack([faces, faces[:, ::-1]], axis=1).reshape(-1, 3),
        lambda faces: np.concatenate([faces, np.roll(faces, 1, axis=1)]),
        lambda faces: np.concatenate([faces, faces[:, [0, 1, 1]], faces[:, [2, 1, 0]]]),
    ],
    ids=["two sides", "in pairs", "twice", "collapsed"],
)
def test_faces_with_the_same_corners_have_charts_of_their_own(repeat):
    """xatlas laid a face given twice on itself, and gave each face of a surface with two sides a chart of its own."""
    tube = CREATE.cylinder(1, 2, sections=24)
    split, uv = ws.unwrap(ws.Mesh(tube.vertices, repeat(tube.faces)), 512)
    report = ws.texture_points(split, uv, 512).report
    assert report.overlapped == 0
    assert report.covered > 0.4 * 512**2  # one side alone: 0.54
    assert label_charts(uv[(np.ptp(uv, axis=1) > 0).all(axis=1)]).max() + 1 <= 12  # one side alone has 6


PLACES = """
import os, numpy as np
from warpsample.texture.uv import packing

square = np.array([(0, 0), (1, 0), (1, 1), (0, 1)], float)
faces = np.array([(0, 1, 2), (0, 2, 3), (4, 5, 6), (4, 6, 7)])
charts = packing.measure_charts(np.concatenate([square, 0.01 * square + 2]), faces, np.array([0, 0, 1, 1]))
print([packing._pack(charts, scale, 100, 4).is_whole for scale in (99.0, 90.0, 80.0)], flush=True)
os._exit(0)
"""


def test_a_chart_without_a_place_is_not_laid_on_others():
    """In an image of any size, xatlas laid it at the origin: leaves of 0.5 m on a floor of 100 m, from 8192 texels on."""
    made = subprocess.run([sys.executable, "-c", PLACES], capture_output=True, text=True, check=True)
    assert made.stdout == "[False, False, True]\n"


def test_collapsed_faces_do_not_hide_that_a_tube_is_smooth():
    split, uv = ws.unwrap(tube_with_collapsed_faces(), 512)
    assert ws.texture_points(split, uv, 512).report.overlapped == 0


@pytest.mark.parametrize(("count", "size"), [(500, 1024), (500, 900)])
def test_many_equal_charts_fit(count, size):
    """Charts have whole texels, so that a slightly smaller scale changed nothing: the size was refused after 12 tries."""
    box = trimesh.creation.box()
    places = np.array([(2.0 * (i % 30), 0, 2.0 * (i // 30)) for i in range(count)])
    vertices = (box.vertices + places[:, None]).reshape(-1, 3)
    faces = (box.faces + 8 * np.arange(count)[:, None, None]).reshape(-1, 3)
    split, uv = ws.unwrap(ws.Mesh(vertices, faces), size)
    report = ws.texture_points(split, uv, size).report
    assert (report.overlapped, report.zero_area) == (0, 0)


def test_a_ground_that_is_large_beside_a_town_is_unwrapped():
    """Most vertices are within 1 m, and the ground is 100 km wide; both are in the image."""
    ground = 1e5 * np.array([(-1, -1, 0), (1, -1, 0), (1, 1, 0), (-1, 1, 0)])
    faces = np.concatenate([SPHERE.faces, [[642, 643, 644], [642, 644, 645]]])
    split, uv = ws.unwrap(ws.Mesh(np.concatenate([SPHERE.vertices, ground]), faces), 256)
    sides = np.ptp(uv[-2:].reshape(-1, 2), axis=0)
    assert (sides > 0.7).all()  # the charts of the sphere are beside it, 4 texels apart
    assert np.isfinite(uv).all()
    assert len(split.faces) == len(faces)


def test_xatlas_is_run_again_where_it_crashes_by_chance(monkeypatch):
    """Once in 600 runs on the same mesh it ended by a signal, and the bake was refused."""
    run, seen = unwrapping.run_program, []

    def crashing(*arguments):
        seen.append(arguments)
        return (-signal.SIGSEGV, b"") if len(seen) < 3 else run(*arguments)

    expected = ws.unwrap(SPHERE, 256)[1]
    monkeypatch.setattr(unwrapping, "run_program", crashing)
    assert np.array_equal(ws.unwrap(SPHERE, 256)[1], expected)
    assert len(seen) == 3


def test_a_mesh_that_ends_xatlas_is_reported(monkeypatch):
    """As a sphere of 81,920 triangles does: github.com/jpcy/xatlas/issues/146."""
    monkeypatch.setattr(unwrapping, "_PROGRAM", "import os, signal; os.kill(os.getpid(), signal.SIGSEGV)")
    with pytest.raises(
        ValueError,
        match=r"^mesh: got a mesh on which xatlas ended with -11, want texture coordinates made by another program$",
    ):
        ws.unwrap(SPHERE, 64)


WAITING = """
import numpy as np


class Atlas:
    width = height = 8


    def add_mesh(self, vertices, faces):
        pass

    def add_uv_mesh(self, places, faces, materials):
        pass

    def generate(self, pack_options):
        self.atlas_count = 1 if pack_options.resolution > 4 else 2

    def get_mesh(self, number):
        return np.arange(3), np.array([[0, 1, 2]]), np.eye(3, 2, dtype=np.float32)

    def get_mesh_vertex_assignment(self, number):
        return np.zeros(3, np.uint32), np.zeros(3, np.uint32)

    def __del__(self):
        __import__("time").sleep(1000.0)


class PackOptions:
    pass
"""


@pytest.mark.parametrize("size", [4, 8])
def test_an_atlas_that_is_never_destroyed_stops_nothing(monkeypatch, tmp_path, size):
    """Destroying an atlas of xatlas waits forever for one of its threads, once in some thousand times."""
    (tmp_path / "xatlas.py").write_text(WAITING)
    monkeypatch.syspath_prepend(tmp_path)
    triangle = ws.Mesh([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]])
    if size == 8:
        assert len(ws.unwrap(triangle, size)[0].faces) == 1
    else:
        with pytest.raises(ValueError, match="^size: got 4, want a larger image"):
            ws.unwrap(triangle, size)


def test_a_picture_that_is_not_square_says_why_it_needs_new_coordinates():
    with pytest.raises(ValueError, match=r"3x9 for new texture coordinates \(set 0 is flat\), want a square, such as 9$"):
        square_side((3, 9), ["set 0 is flat"])


def test_what_cannot_be_unwrapped_is_named(monkeypatch):
    with pytest.raises(
        ValueError, match=r"^size: got 8, want a larger image: 6 charts with a padding of 4 take about 22 texels$"
    ):
        ws.unwrap(trimesh.creation.box(), 8)
    with pytest.raises(ValueError, match="^size: got 1, want a larger image: 1 chart with a padding of 0 takes about "):
        ws.unwrap(([[0.0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]]), 1, padding=0)
    with pytest.raises(ValueError, match="^mesh: got only faces without an area"):
        ws.unwrap(([[0.0, 0, 0], [1, 0, 0], [2, 0, 0]], [[0, 1, 2]]), 8)
    monkeypatch.setitem(sys.modules, "xatlas", None)
    with pytest.raises(ModuleNotFoundError, match=r"^new texture coordinates need xatlas: pip install '\.\[texture\]'$"):
        ws.unwrap(SPHERE, 64)


@pytest.mark.parametrize("seed", [0, 5])
def test_faces_of_rough_surfaces_keep_their_width(seed):
    """xatlas made single faces of a rough scan less than an eighth as wide as they are, and `--strict` refused the set."""
    ball = trimesh.creation.icosphere(subdivisions=4)
    vertices = ball.vertices * (1.0 + 0.05 * np.random.default_rng(seed).normal(size=(len(ball.vertices), 1)))
    split, uv = ws.unwrap(ws.Mesh(vertices, ball.faces), 2048)
    assert np.array_equal(split.vertices[split.faces], vertices[ball.faces])
    report = ws.texture_points(split, uv, 2048).report
    assert (report.squeezed, report.zero_area) == (0, 0)
    assert report.overlapped < 1e-4 * report.covered  # 0 was measured, and the page states 5e-4


def test_blades_of_grass_are_not_squeezed():
    """xatlas makes charts shorter than a texel a texel long and wide, and the faces counted as eight texels wide."""
    blade = np.array([(0.0, 0, 0), (0.0024, 0, 0), (0.0012, 0, 0.035)])
    foot = np.append(np.random.default_rng(0).uniform(0, 50, (300, 2)), np.full((300, 1), 0.01), axis=1)
    vertices = np.concatenate([GROUND, (foot[:, None] + blade).reshape(-1, 3)])
    split, uv = ws.unwrap(ws.Mesh(vertices, np.arange(len(vertices)).reshape(-1, 3)), 1024)
    assert ws.texture_points(split, uv, 1024).report.squeezed == 0


def test_bent_blades_of_grass_are_not_squeezed_in_larger_images():
    """In coordinates made at 512, 28 faces of charts stretched to a texel counted at 1024; `--uv auto` made others."""
    rng, along = np.random.default_rng(1), np.linspace(0.0, 1.0, 5)[:, None]
    length, foot = 10.0 ** rng.uniform(-1.2, 0.3, 600), np.append(rng.uniform(0, 50, (600, 2)), np.zeros((600, 1)), axis=1)
    width = length * 10.0 ** rng.uniform(-2.5, -0.5, 600)
    lean, turn = rng.normal(scale=0.4, size=(600, 2)), rng.uniform(0.0, 2.0 * np.pi, 600)
    up = np.append(lean, np.ones((600, 1)), axis=1) / np.sqrt(1.0 + (lean**2).sum(axis=1, keepdims=True))
    across = np.cross(up, np.column_stack([np.cos(turn), np.sin(turn), 0.0 * turn])) * width[:, None] * 0.5
    middle = foot[:, None] + length[:, None, None] * (along * up[:, None] - along**2 * [0.0, 0.0, 0.5])
    sides = across[:, None] * (1.1 - along)
    blades = np.stack([middle - sides, middle + sides], axis=2).reshape(-1, 10, 3)
    strip = np.concatenate([[(i, i + 1, i + 3), (i, i + 3, i + 2)] for i in range(0, 8, 2)])
    vertices = np.concatenate([GROUND, blades[:, strip].reshape(-1, 3)])
    split, uv = ws.unwrap(ws.Mesh(vertices, np.arange(len(vertices)).reshape(-1, 3)), 512)
    for size in (512, 1024, 8192):
        assert ws.texture_points(split, uv, size).report.squeezed == 0
    uv[:2] *= (1e-4, 1.0)
    assert ws.texture_points(split, uv, 1024).report.squeezed == 2  # the ground
