"""Writes one mesh into every kind of file that `load_mesh` reads, with all digits that the kind holds; and its refusal."""

import re
import struct

import numpy as np
import pytest
import trimesh

SUFFIXES = {
    **dict.fromkeys(("ply_text", "ply_little", "ply_big", "ply_double"), ".ply"),
    **dict.fromkeys(("stl", "stl_text"), ".stl"),
    **{kind: f".{kind}" for kind in ("obj", "off", "glb", "gltf", "usda", "usdc", "usdz")},
}
KINDS = list(SUFFIXES)
"""All kinds. Reading USD takes a process, a third of a second: of its kinds one is quick, and the others are slow tests."""

EACH_KIND = [pytest.param(kind, marks=pytest.mark.slow if kind in ("usda", "usdz") else ()) for kind in KINDS]
"""All kinds, as parameters of a test."""
ONE_USD = [pytest.param(kind, marks=pytest.mark.thorough if kind in ("usda", "usdz") else ()) for kind in KINDS]
"""All kinds, for tests that read a file several times: the other kinds of USD are thorough tests."""
TEXTS = ("ply_text", "stl_text", "obj", "off")  # of any number of digits
HOLDS = {kind: np.float64 if kind in (*TEXTS, "ply_double") else np.float32 for kind in KINDS}

SPHERE = trimesh.creation.icosphere(subdivisions=1)


def refused(path, why=".+"):
    """Expects the error of a file that cannot be read as a mesh, for that reason, a pattern."""
    return pytest.raises(ValueError, match=f"^path: got '{re.escape(str(path))}', which cannot be read as a mesh: {why}$")


def write(kind, folder, vertices, faces):
    """The path of a file of the mesh."""
    path = folder / f"{kind}{SUFFIXES[kind]}"
    if kind.startswith("ply"):
        path.write_bytes(_ply(kind, vertices, faces))
    elif kind.startswith("usd"):
        _usd(path, vertices, faces)
    elif kind in ("glb", "gltf"):
        scene = trimesh.Scene(trimesh.Trimesh(vertices, faces, process=False))
        gltf = trimesh.exchange.gltf
        made = gltf.export_glb(scene) if kind == "glb" else gltf.export_gltf(scene, embed_buffers=True)["model.gltf"]
        path.write_bytes(made)
    else:
        content = {"stl": _stl, "stl_text": _stl_text, "obj": _obj, "off": _off}[kind](vertices, faces)
        path.write_bytes(content)
    return path


def rows(array, before="", first=0):
    """Lines of numbers, as text holds them exactly."""
    return "".join(before + " ".join(str(number + first) for number in row) + "\n" for row in np.asarray(array).tolist())


def ply(order, vertices, polygons, kind="float", dtype="f4"):
    """A .ply of polygons with different numbers of corners."""
    head = f"ply\nformat {order} 1.0\ncomment by hand\nelement vertex {len(vertices)}\n"
    head += "".join(f"property {kind} {axis}\n" for axis in "xyz")
    head += f"element face {len(polygons)}\nproperty uchar flag\nproperty list uchar int vertex_indices\nend_header\n"
    if order == "ascii":
        return (head + rows(vertices) + "".join(rows([[7, len(p), *p]]) for p in polygons)).encode()
    sign = "<" if "little" in order else ">"
    data = b"".join(struct.pack(f"{sign}BB{len(p)}i", 7, len(p), *p) for p in polygons)
    return head.encode() + np.asarray(vertices, sign + dtype).tobytes() + data


def _ply(kind, vertices, faces):
    order = {"ply_text": "ascii", "ply_big": "binary_big_endian"}.get(kind, "binary_little_endian")
    wide = ("double", "f8") if kind == "ply_double" else ("float", "f4")
    return ply(order, vertices, np.asarray(faces).tolist(), *wide)


def _stl(vertices, faces):
    record = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")])
    made = np.zeros(len(faces), record)
    made["corners"] = vertices[faces]
    return b"solid, says the header of this binary file".ljust(80) + struct.pack("<I", len(faces)) + made.tobytes()


def _stl_text(vertices, faces):
    facets = (f"facet normal 0 0 0\nouter loop\n{rows(t, 'vertex ')}endloop\nendfacet\n" for t in vertices[faces])
    return f"solid a vertex of a facet\n{''.join(facets)}endsolid a vertex of a facet\n".encode()


def _obj(vertices, faces):
    return f"# by hand\nmtllib no.mtl\n{rows(vertices, 'v ')}g all\nusemtl no\n{rows(faces, 'f ', 1)}".encode()


def _off(vertices, faces):
    return f"OFF # by hand\n\n{len(vertices)} {len(faces)} 0\n{rows(vertices)}{rows(faces, '3 ')}".encode()


def _usd(path, vertices, faces):
    from pxr import Usd, UsdGeom, UsdUtils

    if path.suffix == ".usdz":
        inner = path.with_name("inner.usdc")
        _usd(inner, vertices, faces)
        assert UsdUtils.CreateNewUsdzPackage(str(inner), str(path))
        inner.unlink()
        return
    stage = Usd.Stage.CreateNew(str(path))
    mesh = UsdGeom.Mesh.Define(stage, "/mesh")
    mesh.GetPointsAttr().Set(np.float32(vertices))
    mesh.GetFaceVertexCountsAttr().Set(np.full(len(faces), 3, np.int32))
    mesh.GetFaceVertexIndicesAttr().Set(np.int32(faces).ravel())
    stage.GetRootLayer().Save()
