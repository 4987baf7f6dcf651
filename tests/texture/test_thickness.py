"""Thickness against the normal, and as a texture of materials that have a volume."""

import re
from types import SimpleNamespace

import numpy as np
import pytest
import trimesh
from glb_files import glb
from textured_scenes import SQUARE, TWO, changed, opened, picture

import warpsample as ws
from warpsample.estimate.result import PointStatus
from warpsample.host.json_tree import Part
from warpsample.texture.jobs import TextureJob
from warpsample.texture.primitives import Primitive


def test_balls_and_sheets_and_points_without_a_normal():
    """A ball of radius 2: 4 at its middle, up to what its facets are off; above a sheet there is nothing to go through."""
    ball = ws.as_mesh(trimesh.creation.icosphere(4, radius=2.0))
    points = ws.face_centers(ball)
    found = ws.thickness(ball, points)
    assert np.abs(found.value - 4.0).max() < 0.02  # the sagitta of facets of 0.15 on either side, and their tilt
    assert ws.thickness(ball, points, max_distance=1.0).value.max() == 1.0
    normal = points.normal.copy()
    normal[:2] = [0.0, 0.0, 0.0], [np.nan, 0.0, 0.0]
    bad = ws.thickness(ball, ws.SurfacePoints(points.position, normal, points.face))
    assert bad.status[:3].tolist() == [PointStatus.ZERO_NORMAL, PointStatus.NONFINITE_NORMAL, PointStatus.OK]
    assert (bad.value[:2].tolist(), bad.rays[:3].tolist()) == ([0.0, 0.0], [0, 0, 1])
    assert np.array_equal(bad.value[2:], found.value[2:])
    sheet = ws.Mesh([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]])
    assert ws.thickness(sheet, ws.face_centers(sheet)).value.tolist() == [0.0]
    assert found.counts() == {PointStatus.OK: len(points)}
    assert np.array_equal(found.to_polydata(ball)["value"], found.value)


@pytest.mark.parametrize("site", [30.0, 300.0])
def test_thin_panes_on_a_large_site_have_their_thickness(site):
    """Lengths began where rays start, 2^-19 of the site within the pane: 6 mm on 300 m were 5.6 mm, of 4 mm 3.6."""
    rng, panes = np.random.default_rng(0), [trimesh.creation.box((site, 0.1, site))]
    thick = np.array([0.001, 0.004, 0.006, 0.02] * 5)
    for place, side in enumerate(thick):
        pane = trimesh.creation.box((2.0, 2.0, side))
        pane.apply_transform(trimesh.transformations.rotation_matrix(rng.uniform(0, 7), (0, 1, 0)))
        pane.apply_translation(((place / 20 - 0.45) * site, 2.0, rng.uniform(-0.45, 0.45) * site))
        panes.append(pane)
    mesh = ws.as_mesh(trimesh.util.concatenate(panes))
    points = ws.face_centers(mesh)
    value, large = ws.thickness(mesh, points).value[12:].reshape(20, 12), mesh.face_areas[12:].reshape(20, 12) > 1.0
    assert (large.sum(axis=1) == 4).all()
    assert np.abs(value / thick[:, None] - 1.0)[large].max() < 1e-5  # a pane's vertices are float64


def test_a_slender_mast_on_a_large_site_has_its_thickness():
    """Sides at 0.1 degrees to the rays: their distances were off by up to 0.1 %, 3.0896 for 3.0861."""
    half, height = 0.05, 30.0
    base = half * np.array([(-1, -1, 0), (1, -1, 0), (1, 1, 0), (-1, 1, 0)])
    ground = 300 * np.array([(0, 0, -0.01), (1, 0, -0.01), (1, 1, -0.01), (0, 1, -0.01)])
    mast = np.array([*base, (0, 0, height)]) + np.array([111, 63, 0])
    faces = [(0, 2, 1), (0, 3, 2), (0, 1, 4), (1, 2, 4), (2, 3, 4), (3, 0, 4), (5, 6, 7), (5, 7, 8)]
    mesh = ws.Mesh(np.concatenate([mast, ground]), np.array(faces))
    rng = np.random.default_rng(0)
    place = rng.uniform(-0.9 * half, 0.9 * half, (2000, 2))
    position = np.column_stack([place + np.array([111, 63]), np.zeros(2000)])
    face = np.where(place[:, 0] > place[:, 1], 0, 1).astype(np.int32)
    points = ws.SurfacePoints(position, np.tile(np.float32([0, 0, -1]), (2000, 1)), face)
    want = height * (1.0 - np.abs(place).max(axis=1) / half)
    assert np.abs(ws.thickness(mesh, points).value / want - 1.0).max() < 1e-5


@pytest.mark.parametrize("kind", [np.float32, np.float64])
def test_boxes_far_from_the_origin_have_their_thickness(kind):
    """With float32 positions, rays start 2 spacings of the coordinates off their face: 1 at 5e6."""
    box = trimesh.creation.box((64, 64, 16))
    box.apply_translation((5e6, 5e6, 0))
    mesh = ws.as_mesh(box)
    points = ws.face_centers(mesh)
    points = ws.SurfacePoints(np.rint(points.position).astype(kind), points.normal, points.face)
    assert sorted(ws.thickness(mesh, points).value.tolist()) == [16.0] * 4 + [64.0] * 8


def test_light_that_passes_a_body_changes_no_thickness():
    """Rays passed the back of glass, and the thickness of a slab reached to the ground below."""
    glass, ground = trimesh.creation.box((1.0, 1.0, 0.2)), trimesh.creation.box((9.0, 9.0, 1.0))
    ground.apply_translation((0.0, 0.0, -2.0))
    mesh = ws.as_mesh(trimesh.util.concatenate([glass, ground]))
    points, share = ws.face_centers(mesh), np.where(np.arange(24) < 12, 0.5, 0.0)
    found = [ws.thickness(one, points).value for one in (mesh, ws.as_mesh(mesh, transmittance=share))]
    assert np.array_equal(found[0], found[1])


@pytest.mark.parametrize(
    ("options", "error", "message"),
    [
        ({"max_distance": -1.0}, ValueError, "max_distance: got -1.0, want a number from 0"),
        ({"max_distance": "1"}, TypeError, "max_distance: got '1'"),
        ({"workers": 0}, ValueError, "workers: got 0"),
        ({"count": 3}, TypeError, r"thickness\(\) got an unexpected keyword argument 'count'"),
    ],
)
def test_arguments_that_cannot_be_used(options, error, message):
    sheet = ws.Mesh([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]])
    with pytest.raises(error, match=f"^{message}"):
        ws.thickness(sheet, ws.face_centers(sheet), **options)


def boxes(path, extensions, place=None):
    """A box of 1 x 2 x 3, four times as large by its node, and a quad far from it, whose material is another."""
    box = trimesh.creation.box((1, 2, 3))
    arrays = [np.float32(box.vertices), np.uint16(box.faces).ravel()]
    arrays += [np.float32([(90, 0, 0), (91, 0, 0), (91, 1, 0), (90, 1, 0)]), np.float32(SQUARE), TWO]
    meshes = [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1, "material": 0}]}]
    meshes += [{"primitives": [{"attributes": {"POSITION": 2, "TEXCOORD_0": 3}, "indices": 4, "material": 1}]}]
    tree = {"meshes": meshes, "nodes": [{"mesh": 0, **(place or {"scale": [4, 4, 4]})}, {"mesh": 1}]}
    tree |= {"materials": [{"name": "glass", **extensions}, {"name": "paper"}]}
    path.write_bytes(glb(tree, arrays))
    return path


@pytest.mark.parametrize(
    "place",
    [
        {"scale": [4, 4, 4]},
        {"scale": [1, 2, 4]},
        {"scale": [1, 2, -4], "rotation": [0.1, 0.5, -0.7, 0.5]},
    ],
)
def test_a_box_in_units_of_its_mesh(call, tmp_path, place):
    """1, 2 and 3 through its sides wherever its node places it, as shares of the factor; paper without a volume stays.

    Before, a scale that differs by axis counted as its geometric mean.
    """
    volume = {"extensions": {"KHR_materials_volume": {"thicknessFactor": 7.0, "attenuationDistance": 2.0}}}
    path, output = boxes(tmp_path / "in.glb", volume, place), tmp_path / "out.glb"
    status, out, err = call("bake", path, "-o", output, "--texture", 64, "--quantity", "thickness")
    assert (status, err) == (0, "")
    assert "thickness in one picture of 64 x 64 texels" in out
    assert out.count(" is replaced") == 1  # the factor; this material has no picture
    tree, data, _ = opened(output)
    made = tree["materials"][0]["extensions"]["KHR_materials_volume"]
    info = made.pop("thicknessTexture")
    assert made == {"thicknessFactor": pytest.approx(3.0, rel=1e-5), "attenuationDistance": 2.0}  # rays start off a face
    assert info == {"index": 0}
    levels, counts = np.unique(np.round(255 * picture(tree, data, 0)), return_counts=True)
    assert levels.tolist() == [85, 170, 255]
    assert counts.min() > 300  # each has two of six sides
    assert tree["materials"][1] == {"name": "paper"}


def primitive(matrix, scale=1.0):
    """Two triangles of a glTF mesh, the faces 5 and 6 of a loaded mesh."""
    triangles = np.array([(0, 1, 2), (0, 2, 3)])
    part = Part({})
    return Primitive(0, 0, part, "a", slice(5, 7), slice(9, 13), triangles, False, scale, matrix, [0], 0)


def test_lengths_in_the_scene_are_distances_in_the_mesh():
    """Of two ends of a segment, any matrix: their distance before it; a uniform scale divides as it did, to the bit."""
    rng = np.random.default_rng(0)
    ends, matrix = rng.normal(size=(2, 50, 3)), rng.normal(size=(3, 3))
    way = (ends[1] - ends[0]) @ matrix
    face, weights = np.full(50, 5), rng.dirichlet((1, 1, 1), 50)
    lengths, normals = np.linalg.norm(way, axis=1), way / np.linalg.norm(way, axis=1, keepdims=True)
    found = primitive(matrix).convert_lengths(lengths, normals, face, weights)
    assert np.allclose(found, np.linalg.norm(ends[1] - ends[0], axis=1), rtol=1e-12)
    turn, thin = np.linalg.qr(matrix)[0], normals.astype(np.float32)
    assert np.array_equal(primitive(3.0 * turn, 3.0).convert_lengths(lengths, thin, face, weights), lengths / 3.0)


def test_lengths_are_converted_by_the_primitives_that_have_points_alone():
    """Each of 5,000 primitives of a material took 10 ms for each part of the points, also without a point."""
    seen = []

    def part(number, size=3):
        def convert(lengths, directions, face, weights):
            seen.append(number)
            assert (face // 3 == number).all()
            assert size
            return lengths / (number + 1)

        return SimpleNamespace(faces=slice(3 * number, 3 * number + size), convert_lengths=convert)

    empty = part(2, size=0), part(40, size=0)  # of strips of two vertices
    job = TextureJob("m", None, None, 0, None, 0, "", [part(40), part(2), *empty, part(0), part(7)])
    face = np.array([121, 6, 0, 122, 8, 120])
    found = job.convert_lengths(np.full(6, 82.0), np.ones((6, 3)), face, np.ones((6, 3)))
    assert sorted(seen) == [0, 2, 40]
    assert found.tolist() == [2.0, 82.0 / 3.0, 82.0, 2.0, 82.0 / 3.0, 2.0]


def test_directions_that_a_place_flattens_have_no_length():
    flat = primitive(np.diag([1.0, 0.5, 0.0]), 0.0)
    found = flat.convert_lengths(np.ones(3), np.eye(3), np.full(3, 5), np.full((3, 3), 1 / 3))
    assert np.array_equal(found, [1.0, 2.0, np.nan], equal_nan=True)


def test_a_place_that_flattens_a_box_has_no_part_in_the_mean(call, tmp_path):
    """Rays through a box of thickness 0 have no length in units of the mesh: the mean is that of the other place."""
    path, output = boxes(tmp_path / "in.glb", {"extensions": {"KHR_materials_volume": {}}}), tmp_path / "out.glb"
    turn = np.linalg.qr(np.random.default_rng(0).normal(size=(3, 3)))[0]  # leaves rounding errors along the flat axis
    flat = np.eye(4)
    flat[:3, :3], flat[3, 1] = np.diag([1.0, 0.0, 1.0]) @ turn, 50.0
    place = {"mesh": 0, "matrix": flat.ravel().tolist()}
    path.write_bytes(
        changed(path.read_bytes(), lambda tree: (tree["nodes"].append(place), tree["scenes"][0]["nodes"].append(2)))
    )
    for supersample in (1, 2):
        options = ("--texture", 64, "--quantity", "thickness", "--instances", "mean", "--supersample", supersample)
        assert call("bake", path, "-o", output, *options)[0] == 0
        tree, data, _ = opened(output)
        assert tree["materials"][0]["extensions"]["KHR_materials_volume"]["thicknessFactor"] == pytest.approx(3.0, rel=1e-5)
        levels = np.unique(np.round(255 * picture(tree, data, 0)))
        assert levels.tolist() == [85, 170, 255]
    status, out, _ = call("bake", path, "-o", output, "--texture", 64, "--quantity", "thickness")
    assert (status, "nan" in out, "none with a value" in out) == (0, False, True)


def test_joints_scale_lengths_between_their_vertices():
    """Twice as large at the vertices 0 and 1 and unchanged at 2 and 3; weights follow the corners of the second triangle."""
    poses = np.eye(3) * np.array([2, 2, 1, 1])[:, None, None]
    weights = np.array([(1, 0, 0), (0.5, 0.5, 0), (0, 0.5, 0.5)])
    found = primitive(poses).convert_lengths(np.ones(3), np.eye(3), np.full(3, 6), weights)
    assert found.tolist() == [0.5, 0.75, 1.0]


@pytest.mark.parametrize(
    ("suffix", "normals", "why"),
    [
        (
            ".glb",
            "face",
            "--quantity: got thickness for 'in.glb', whose materials lack KHR_materials_volume, .*, want a file",
        ),
        (".png", "face", "--output: got .*out.png' for thickness, want a file that ends in one of .glb .gltf .exr .npz"),
        (".exr", "lifted", "--normals: got lifted for thickness, want face or smooth: its rays start beneath the face"),
    ],
)
def test_what_has_no_place_for_it_is_refused(call, tmp_path, suffix, normals, why):
    path, output = boxes(tmp_path / "in.glb", {}), tmp_path / f"out{suffix}"
    status, _, err = call("bake", path, "-o", output, "--texture", 64, "--quantity", "thickness", "--normals", normals)
    assert status == 2
    assert re.search(f"^error: {why}", err), err
