"""Named parts: read from every kind of file that has them, kept where the mesh goes, and without effect on numbers."""

import copy
import json
import pickle

import mesh_file_cases as cases
import numpy as np
import pytest
import trimesh

import warpsample as ws
from warpsample.host import shared_values

TRIANGLE = "v 0 0 {0}\nv 1 0 {0}\nv 0 1 {0}\n"


def named(mesh):
    """The name of each face."""
    return None if mesh.part is None else [mesh.parts[number] if number >= 0 else None for number in mesh.part]


def loaded(path, text):
    path.write_text(text)
    return ws.load_mesh(path)


def test_objects_groups_and_materials_of_an_obj(tmp_path):
    face = "f -3 -2 -1\n"
    text = f"{TRIANGLE.format(0)}{face}o house\n{face}g north wall\n{face}usemtl brick\nf 1 2 3 1\n{face}"
    mesh = loaded(tmp_path / "a.obj", f"{text}o shed\ng\nusemtl\n{face}o empty\no house\ng north wall\nusemtl brick\n{face}")
    brick = "house/north wall/brick"
    assert named(mesh) == ["", "house", "house/north wall", brick, brick, brick, "shed", brick]
    assert mesh.parts == ("", "house", "house/north wall", brick, "shed")
    assert loaded(tmp_path / "b.obj", f"{TRIANGLE.format(0)}{face}o after\n").part is None


def test_solids_of_an_stl(tmp_path):
    facet = "facet normal 0 0 0\nouter loop\nvertex 0 0 {0}\nvertex 1 0 {0}\nvertex 0 1 {0}\nendloop\nendfacet\n"
    solids = [("roof top", 1), ("", 2), ("roof top", 1)]
    text = "".join(f"solid {name}\n{facet.format(z) * z}endsolid {name}\n" for z, (name, _) in enumerate(solids, 1))
    mesh = loaded(tmp_path / "a.stl", text)
    assert (named(mesh), mesh.parts) == (["roof top", "", "", *["roof top"] * 3], ("roof top", "", "roof top"))
    nameless = loaded(tmp_path / "b.stl", f"solid\n{facet.format(0)}endsolid\n")
    assert (nameless.part, nameless.parts) == (None, ())


@pytest.mark.parametrize("kind", ["ply_little", "ply_text", "stl", "off"])
def test_files_without_names(kind, tmp_path):
    mesh = ws.load_mesh(cases.write(kind, tmp_path, cases.SPHERE.vertices, cases.SPHERE.faces))
    assert (mesh.part, mesh.parts) == (None, ())


def test_nodes_of_a_gltf(tmp_path):
    scene = trimesh.Scene()
    for name, size in (("tower", 1.0), ("hall", 2.0)):
        scene.add_geometry(trimesh.creation.box((size,) * 3), node_name=f"{name} node", geom_name=name)
    path = tmp_path / "a.glb"
    path.write_bytes(trimesh.exchange.gltf.export_glb(scene))
    mesh = ws.load_mesh(path)
    areas = dict(zip(mesh.parts, np.bincount(mesh.part, mesh.face_areas), strict=True))
    assert areas == pytest.approx({"tower node": 6.0, "hall node": 24.0})
    tree = json.loads(trimesh.exchange.gltf.export_gltf(scene, embed_buffers=True)["model.gltf"])
    for node in tree["nodes"]:
        node.pop("name", None)
    unnamed = loaded(tmp_path / "b.gltf", json.dumps(tree))
    assert sorted(unnamed.parts) == ["hall", "tower"]  # the meshes' names
    for item in tree["meshes"]:
        del item["name"]
    assert loaded(tmp_path / "b.gltf", json.dumps(tree)).part is None


def test_prims_of_a_usd(tmp_path):
    shape = "point3f[] points = [(0,0,0),(1,0,0),(0,1,0)]\nint[] faceVertexCounts = [3]\nint[] faceVertexIndices = [0,1,2]\n"
    meshes = "".join(f'def Mesh "{name}" {{\n{shape}}}\n' for name in ("wall", "roof"))
    instances = (
        'def PointInstancer "trees" {\nrel prototypes = [</site/trees/tree>]\nint[] protoIndices = [0,0]\n'
        f'point3f[] positions = [(0,0,9),(0,0,8)]\ndef Mesh "tree" {{\n{shape}}}\n}}\n'
    )
    mesh = loaded(tmp_path / "a.usda", f'#usda 1.0\ndef Xform "site" {{\n{meshes}{instances}}}\n')
    assert named(mesh) == ["/site/wall", "/site/roof", "/site/trees", "/site/trees"]


def test_surfaces_of_a_cityjson():
    city = ws.load_city("courtyard")
    assert city.mesh.parts == ("ground", "buildings/RoofSurface", "buildings/WallSurface")
    assert np.array_equal(city.mesh.part, city.surface)


BOX = trimesh.creation.box()
PART = np.repeat([1, -1, 0], 4)


def test_parts_go_where_the_mesh_goes():
    mesh = ws.Mesh(BOX.vertices, BOX.faces, PART, ["a", "b"])
    plain, other = ws.Mesh(BOX.vertices, BOX.faces), ws.Mesh(BOX.vertices, BOX.faces, PART, ["a", "c"])
    assert mesh.digest == plain.digest == other.digest  # numbers at points are the same
    pickled = pickle.dumps([plain, mesh, other])
    shared_values._values.clear()
    for one in (pickle.loads(pickled)[1], copy.deepcopy(mesh), ws.refit(mesh, mesh.vertices + 1.0)):
        assert one.parts == ("a", "b")
        assert np.array_equal(one.part, PART)
    assert [one.parts for one in pickle.loads(pickled)] == [(), ("a", "b"), ("a", "c")]
    with pytest.raises(ValueError, match="read-only"):
        mesh.part[0] = 5


@pytest.mark.parametrize(
    ("part", "parts", "message"),
    [
        (PART, ["a"], r"part: got numbers from -1 to 1, want \(12,\) whole numbers from -1 to 0, one for each face$"),
        (PART - 1, ["a", "b"], "part: got numbers from -2 to 0, want"),
        (PART[:-1], ["a", "b"], r"part: got shape \(11,\), want \(12,\) whole numbers"),
        (PART * 1.0, ["a", "b"], "part: got dtype float64, want"),
        (None, ["a"], "part: got .*, want"),
        (PART, "ab", "parts: got 'ab', want a sequence of names$"),
        (PART, [1, 2], r"parts: got \[1, 2\], want a sequence of names$"),
    ],
)
def test_parts_that_do_not_fit(part, parts, message):
    with pytest.raises((TypeError, ValueError), match=f"^{message}"):
        ws.Mesh(BOX.vertices, BOX.faces, part, parts)
