"""Normals in mesh files, at the corners of faces: a roof with a hard crease, in each format."""

import numpy as np
import pytest
from glb_files import glb

import warpsample as ws
from warpsample.mesh.files.normals import read_normals

VERTICES = np.array([[0, 0, 0], [1, 0, 0.2], [2, 0, 0], [0, 1, 0], [1, 1, 0.2], [2, 1, 0]], float)
FACES = np.array([[0, 1, 4], [0, 4, 3], [1, 2, 5], [1, 5, 4]])
LEFT, RIGHT = np.array([(-0.2, 0, 1), (0.2, 0, 1)]) / np.hypot(0.2, 1.0)
CORNERS = np.repeat([LEFT, LEFT, RIGHT, RIGHT], 3, axis=0).reshape(4, 3, 3)
APART = VERTICES[FACES].reshape(-1, 3)


def obj(path, normals="vn -0.2 0 1\nvn 0.2 0 1\n", second="{}//2"):
    rows = [" ".join(("{}//1" if k < 2 else second).format(v + 1) for v in face) for k, face in enumerate(FACES)]
    lines = [f"v {x} {y} {z}\n" for x, y, z in VERTICES] + [normals] + [f"f {row}\n" for row in rows]
    path.write_text("".join(lines))
    return path


def ply(path):
    names = "".join(f"property float {name}\n" for name in ("x", "y", "z", "nx", "ny", "nz"))
    faces = "element face 4\nproperty list uchar int vertex_indices\nend_header\n"
    head = f"ply\nformat ascii 1.0\nelement vertex 12\n{names}{faces}"
    rows = [" ".join(map(str, row)) + "\n" for row in np.hstack([APART, CORNERS.reshape(-1, 3)]).tolist()]
    path.write_text(head + "".join(rows) + "".join(f"3 {k} {k + 1} {k + 2}\n" for k in range(0, 12, 3)))
    return path


def in_glb(path):
    tree = {"meshes": [{"primitives": [{"attributes": {"POSITION": 0, "NORMAL": 1}}]}], "nodes": [{"mesh": 0}]}
    path.write_bytes(glb(tree, [np.float32(APART), np.float32(CORNERS.reshape(-1, 3))]))
    return path


def usd(path, how="uniform", name="normals", values=(LEFT, LEFT, RIGHT, RIGHT), matrix="scale = (1, 1, 1)"):
    """With `uniform`, a normal for each face."""

    def text(rows):
        return ", ".join(f"({', '.join(map(str, row))})" for row in np.asarray(rows).tolist())

    path.write_text(f"""#usda 1.0
def Mesh "roof" {{
    point3f[] points = [{text(VERTICES)}]
    int[] faceVertexCounts = [3, 3, 3, 3]
    int[] faceVertexIndices = {FACES.ravel().tolist()}
    normal3f[] {name} = [{text(values)}] ( interpolation = "{how}" )
    float3 xformOp:{matrix}
    uniform token[] xformOpOrder = ["xformOp:{matrix.split()[0]}"]
}}
""")
    return path


WRITERS = {"obj": obj, "ply": ply, "glb": in_glb, "usda": usd}


@pytest.mark.parametrize("suffix", WRITERS)
def test_each_format_has_the_same_normals(tmp_path, suffix):
    if suffix == "usda":
        pytest.importorskip("pxr")
    path = WRITERS[suffix](tmp_path / f"roof.{suffix}")
    found = read_normals(path)
    assert found.shape == (*ws.load_mesh(path).faces.shape, 3)
    assert found / np.linalg.norm(found, axis=2, keepdims=True) == pytest.approx(CORNERS, abs=1e-6)


def test_lines_of_an_obj_may_end_with_carriage_returns(tmp_path):
    """Its normals were ignored, and its faces were not."""
    path = obj(tmp_path / "roof.obj")
    path.write_bytes(path.read_bytes().replace(b"\n", b"\r"))
    assert read_normals(path) == pytest.approx(read_normals(obj(tmp_path / "same.obj")))


@pytest.mark.parametrize(
    ("how", "name", "values"),
    [("faceVarying", "primvars:normals", CORNERS.reshape(-1, 3)), ("vertex", "normals", np.tile((0, 0, 1), (6, 1)))],
)
def test_normals_of_usd_are_placed_in_the_scene(tmp_path, how, name, values):
    """Mirrored along x and stretched along z: the normals of the mirrored faces still point up."""
    pytest.importorskip("pxr")
    path = usd(tmp_path / "roof.usda", how, name, values, "scale = (-1, 1, 2)")
    found, mesh = read_normals(path), ws.load_mesh(path)
    assert (found[..., 2] > 0.0).all()
    if how == "faceVarying":
        assert found == pytest.approx(np.repeat(mesh.face_normals[:, None], 3, axis=1), abs=1e-6)


@pytest.mark.parametrize("wrong", [4, -1])
def test_an_index_beyond_the_values_of_usd_is_refused(tmp_path, wrong):
    """Before, the mesh had no normals or texture coordinates."""
    pytest.importorskip("pxr")
    path = usd(tmp_path / "roof.usda", name="primvars:normals")
    more = [
        f"int[] primvars:normals:indices = [{wrong}, 0, 1, 2]",
        'texCoord2f[] primvars:st = [(0, 0), (1, 0)] ( interpolation = "uniform" )',
        f"int[] primvars:st:indices = [0, 1, {wrong}, 0]",
    ]
    path.write_text(path.read_text().replace("    float3 ", "\n".join(more) + "\n    float3 ", 1))
    span = f"{min(wrong, 0)} to {max(wrong, 2)}"
    with pytest.raises(ValueError, match=f"the prim /roof has normals with indices {span}, want 0 to 3$"):
        read_normals(path)
    span = f"{min(wrong, 0)} to {max(wrong, 1)}"
    with pytest.raises(ValueError, match=f"the prim /roof has texture coordinates with indices {span}, want 0 to 1$"):
        ws.load_uv(path)


def test_corners_without_a_normal_are_nan(tmp_path):
    found = read_normals(obj(tmp_path / "a.obj", second="{}"))
    assert np.isfinite(found[:2]).all()
    assert np.isnan(found[2:]).all()
    assert np.array_equal(read_normals(obj(tmp_path / "b.obj", second="{}//-1")), read_normals(obj(tmp_path / "c.obj")))
    for path in (obj(tmp_path / "none.obj", "vn 0 0 1\n", "{}//1"), tmp_path / "none.stl"):
        path.write_text(path.read_text().replace("//1", "")) if path.suffix == ".obj" else None
        assert read_normals(path) is None


def test_a_missing_normal_is_refused_by_its_line(tmp_path):
    with pytest.raises(ValueError, match=r"^line 11: a face has the normals 7 to 7, want 1 to 2$"):
        read_normals(obj(tmp_path / "a.obj", second="{}//7"))


@pytest.mark.parametrize("suffix", ["obj", "ply", "glb"])
def test_a_crease_of_the_finer_mesh_is_baked_as_in_its_file(call, tmp_path, suffix):
    """Before, normals of an .obj were averaged over the crease."""
    low, high = tmp_path / "low.obj", WRITERS[suffix](tmp_path / f"high.{suffix}")
    low.write_text("v 0 0 0\nv 2 0 0\nv 2 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nf 1/1 2/2 3/3 4/4\n")
    command = ("bake", low, "-o", tmp_path / "a.npz", "--texture", 8, "--uv", 0, "--quantity", "normals")
    assert call(*command, "--high", high, "--cage", 0.5)[0] == 0
    with np.load(tmp_path / "a.npz") as file:
        value = file["value"]
    assert value[:, :4] == pytest.approx(np.broadcast_to(LEFT, (8, 4, 3)), abs=1e-5)
    assert value[:, 4:] == pytest.approx(np.broadcast_to(RIGHT, (8, 4, 3)), abs=1e-5)


def test_the_frame_of_a_normal_map_is_that_of_the_file(call, tmp_path):
    """An .obj onto itself: in the frame of its own normals all texels are (0, 0, 1). Before, up to 0.2 of x."""
    from PIL import Image

    path = tmp_path / "roof.obj"
    obj(path, "vn -0.2 0 1\nvn 0.2 0 1\n" + "".join(f"vt {x / 2} {y}\n" for x, y, _ in VERTICES))
    path.write_text("\n".join(_with_uv(line) for line in path.read_text().splitlines()) + "\n")
    options = ("--texture", 8, "--uv", 0, "--quantity", "normals", "--normals", "face", "--high", path, "--cage", 0.1)
    assert call("bake", path, "-o", tmp_path / "a.png", *options)[0] == 0
    assert np.abs(np.array(Image.open(tmp_path / "a.png")).astype(int) - (128, 128, 255)).max() <= 1


def _with_uv(line):
    """A face line with the texture coordinates of its vertices: 1//2 becomes 1/1/2."""
    if not line.startswith("f "):
        return line
    return "f " + " ".join("{0}/{0}/{1}".format(*word.split("//")) for word in line.split()[1:])
