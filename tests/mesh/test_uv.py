"""Texture coordinates of files: of the corners of the faces that `load_mesh` gives, in their order, with v downward."""

import json
import struct

import numpy as np
import pytest
from glb_files import glb, placed_twice

import warpsample as ws

QUAD = np.array([(0, 0, 0), (2, 0, 0), (2, 1, 0), (0, 1, 0)], np.float32)  # x is u, y is v upward, of a picture of 2 x 1


def at_positions(mesh, uv):
    """Whether each corner of the quad, wherever it is, has the coordinates that its position says."""
    corners = mesh.vertices[mesh.faces]
    return np.array_equal(uv, np.stack([corners[..., 0] / 2.0, 1.0 - corners[..., 1]], axis=-1))


def test_obj_polygons_keep_the_order_of_their_corners(tmp_path):
    """An L that earcut cuts, its vertices and its texture coordinates in different orders, and a face without any."""
    path = tmp_path / "l.obj"
    outline = [(0, 0), (2, 0), (2, 0.5), (0.5, 0.5), (0.5, 1), (0, 1)]
    lines = [f"v {x} {y} 0" for x, y in outline] + [f"vt {x / 2} {y} 0" for x, y in reversed(outline)]
    path.write_text("\n".join([*lines, "f " + " ".join(f"{i}/{7 - i}" for i in range(1, 7)), "f 1/-1 2/-2 3/-3", "f 1 2 3"]))
    mesh, uv = ws.load_mesh(path), ws.load_uv(path)
    assert uv.shape == (6, 3, 2)
    assert at_positions(ws.Mesh(mesh.vertices, mesh.faces[:5]), uv[:5])
    assert np.isnan(uv[5]).all()


@pytest.mark.parametrize(
    ("line", "why"),
    [
        ("f 1/1 2/2 3/9", "line 8: a face has the texture coordinates 1 to 9, want 1 to 3"),
        ("f 1/1 2/2 3", "line 8: '1/1 2/2 3' is not a face, want .*"),
        ("f 1/1 2/2 3/0", "line 8: a face has the vertex 0"),
        ("vt", "line 8: .*"),
        ("f 1 2 3", "no face of the file has set 0 of texture coordinates"),
    ],
)
def test_an_obj_without_what_it_refers_to_is_refused(line, why, tmp_path):
    path = tmp_path / "a.obj"
    path.write_text(f"v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\n\n{line}\n")
    with pytest.raises(
        ValueError, match=f"^path: got .*a.obj', which cannot be read as a mesh with texture coordinates: {why}"
    ):
        ws.load_uv(path)


def test_directions_name_coordinates_that_cannot_be_read(call, tmp_path):
    """They were taken for none, and the lobes of a brushed metal had axes of no meaning."""
    path, out = tmp_path / "a.obj", tmp_path / "out.npz"
    corners = "v 0 0 0\nv 1 0 0\nv 0 1 0\n"
    lobe = ("--points", 3, "--samples", 4, "--distribution", "ggx(alpha=0.05, alpha_y=0.6)")
    path.write_text(f"{corners}f 1 2 3\n")
    assert call("directions", path, "-o", out, *lobe)[0] == 0
    path.write_text(f"{corners}vt 0 0\nf 1/1 2/1 3/9\n")
    status, _, err = call("directions", path, "-o", out, *lobe)
    assert status == 2
    assert "line 5: a face has the texture coordinates 1 to 9, want 1 to 1" in err


def test_gltf_nodes_strips_sets_and_short_numbers(tmp_path):
    """A quad at two nodes, one of which mirrors it; a strip of 16-bit shares; and a second set that only the quad has."""
    path = placed_twice(tmp_path / "a.glb", QUAD)
    mesh = ws.load_mesh(path)
    uv = ws.load_uv(path)
    assert uv.shape == (6, 3, 2)
    assert (mesh.face_normals == (0, 0, 1)).all()
    alone = ws.Mesh(np.abs(mesh.vertices), mesh.faces)  # as one that is not mirrored
    assert at_positions(alone, np.round(uv * 65535) / 65535)
    second = ws.load_uv(path, set=1)
    assert np.isnan(second[4:]).all()
    assert np.array_equal(second[:4], 3.0 * uv[:4])
    with pytest.raises(ValueError, match="no face of the file has set 2 of texture coordinates"):
        ws.load_uv(path, set=2)


def test_gltf_coordinates_that_are_too_few_are_refused(tmp_path):
    path = tmp_path / "a.glb"
    arrays = [QUAD, np.zeros((3, 2), np.float32)]
    primitive = {"attributes": {"POSITION": 0, "TEXCOORD_0": 1}, "mode": 6}
    path.write_bytes(glb({"meshes": [{"primitives": [primitive]}], "nodes": [{"mesh": 0}]}, arrays))
    with pytest.raises(ValueError, match=r"meshes\[0\].*TEXCOORD_0: got 3 values, want one for each of 4 positions"):
        ws.load_uv(path)


def test_gltf_normals_turn_as_the_surface_does(tmp_path):
    """Under a scale that is not uniform, a mirror and a turn: the normals of a flat face stay its normals."""
    from warpsample.mesh.files.gltf import read_corners

    tilted = np.array([(0, 0, 0), (1, 0, 1), (0, 1, 0)], np.float32)
    normal = np.array([(-1, 0, 1)] * 3, np.float32) / np.float32(np.sqrt(2))
    nodes = [{"mesh": 0, "scale": [-1, 2, 3]}, {"mesh": 0, "rotation": [0.5, 0.5, 0.5, 0.5], "scale": [4, 1, 1]}]
    path = tmp_path / "a.glb"
    primitive = {"attributes": {"POSITION": 0, "NORMAL": 1}}
    path.write_bytes(glb({"meshes": [{"primitives": [primitive]}], "nodes": nodes}, [tilted, normal]))
    mesh, normals = ws.load_mesh(path), read_corners(path, "NORMAL")
    assert np.abs(normals - mesh.face_normals[:, None]).max() <= 1e-6  # of float32 normals


def test_usd_sets_and_interpolations(tmp_path):
    """Per vertex, per corner and by an index; left-handed and mirrored; and another set by its name."""
    from pxr import Sdf, Usd, UsdGeom

    stage = Usd.Stage.CreateNew(str(tmp_path / "a.usda"))
    for name, kind in (("vertex", "vertex"), ("corner", "faceVarying"), ("none", None), ("empty", "vertex")):
        prim = UsdGeom.Mesh.Define(stage, f"/{name}")
        prim.GetPointsAttr().Set(QUAD)
        prim.GetFaceVertexCountsAttr().Set([4])
        prim.GetFaceVertexIndicesAttr().Set([0, 3, 2, 1])
        prim.CreateOrientationAttr("leftHanded")
        if kind:
            made = UsdGeom.PrimvarsAPI(prim).CreatePrimvar("st", Sdf.ValueTypeNames.TexCoord2fArray, kind)
            values = QUAD[:, :2] / (2, 1) if name != "empty" else QUAD[:0, :2]
            made.Set(values if kind == "vertex" else values[::-1])
            if kind == "faceVarying":
                made.SetIndices([3, 0, 1, 2])
    stage.GetRootLayer().Save()
    mesh, uv = ws.load_mesh(tmp_path / "a.usda"), ws.load_uv(tmp_path / "a.usda")
    assert (mesh.face_normals == (0, 0, 1)).all()
    assert at_positions(ws.Mesh(mesh.vertices, mesh.faces[:4]), uv[:4])
    assert np.isnan(uv[4:]).all()


def test_other_files_are_refused(tmp_path):
    path = tmp_path / "a.stl"
    path.write_text("solid")
    with pytest.raises(ValueError, match=r"^path: got 'a.stl', want a file that ends in one of .obj .ply .glb"):
        ws.load_uv(path)


def test_the_header_of_the_files_of_these_tests(tmp_path):
    made = glb({"meshes": [], "nodes": []}, [QUAD])
    assert struct.unpack("<I", made[8:12])[0] == len(made)
    assert json.loads(made[20 : 20 + struct.unpack("<I", made[12:16])[0]])["accessors"][0]["count"] == 4


def ply(path, names, values):
    """The quad as a text .ply, one polygon, with two further properties of its vertices."""
    properties = "".join(f"property float {name}\n" for name in ("x", "y", "z", *names))
    head = f"ply\nformat ascii 1.0\nelement vertex 4\n{properties}"
    rows = "".join(" ".join(map(str, row)) + "\n" for row in np.hstack([QUAD, values]).tolist())
    path.write_text(f"{head}element face 1\nproperty list uchar int vertex_indices\nend_header\n{rows}4 0 1 2 3\n")
    return path


@pytest.mark.parametrize("names", [("s", "t"), ("u", "v"), ("texture_u", "texture_v")])
def test_coordinates_of_the_vertices_of_a_ply(names, call, tmp_path):
    """Before, `--uv 0` stated that all faces lack coordinates."""
    path = ply(tmp_path / "a.ply", names, QUAD[:, :2] / (2, 1))
    assert at_positions(ws.load_mesh(path), ws.load_uv(path))
    with pytest.raises(ValueError, match="no vertex of the file has set 1 of texture coordinates, such as s and t$"):
        ws.load_uv(path, set=1)
    status, out, err = call("bake", path, "-o", tmp_path / "a.png", "--texture", 8, "--samples", 4, "--uv", 0)
    assert (status, err, "'a.ply', set 0: 64 texels" in out) == (0, "", True)


def test_a_ply_without_coordinates_gets_new_ones(call, tmp_path):
    path = ply(tmp_path / "a.ply", ("s", "r"), QUAD[:, :2])
    with pytest.raises(ValueError, match="no vertex of the file has set 0 of texture coordinates, such as s and t$"):
        ws.load_uv(path)
    command = ("bake", path, "-o", tmp_path / "a.npz", "--texture", 16, "--samples", 4)
    assert "'a.ply', new coordinates: " in call(*command)[1]
    assert "want a set of texture coordinates for all faces of 'a.ply', but 2 of 2 lack it" in call(*command, "--uv", 0)[2]


def test_coordinates_of_a_ply_that_are_no_numbers_are_named(call, tmp_path):
    path = ply(tmp_path / "a.ply", ("s", "t"), np.full((4, 2), np.nan))
    status, out, err = call("bake", path, "-o", tmp_path / "a.npz", "--texture", 16, "--samples", 4)
    why = "(set 0 is passed over: 2 of 2 faces lack it or have no finite numbers in it)"
    assert (status, err, f", new coordinates {why}: " in out) == (0, "", True)
