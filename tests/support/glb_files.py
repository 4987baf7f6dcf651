"""Small .glb files by hand: a tree, and the arrays that its accessors are."""

import json
import struct

import numpy as np

_KINDS = {"f4": 5126, "u4": 5125, "u2": 5123, "u1": 5121, "i2": 5122, "i1": 5120}
_TYPES = {1: "SCALAR", 2: "VEC2", 3: "VEC3", 4: "VEC4"}


def accessor(view, array, **more):
    """What the file says of an array: whole numbers of two and more components are shares."""
    width = array.shape[1] if array.ndim > 1 else 1
    made = {"bufferView": view, "componentType": _KINDS[array.dtype.str[1:]], "count": len(array), "type": _TYPES[width]}
    if array.dtype.kind != "f" and width > 1:
        made["normalized"] = True
    if width == 3 and array.dtype.kind == "f":
        made |= {"min": array.min(axis=0).tolist(), "max": array.max(axis=0).tolist()}
    return made | more


def glb(tree, arrays):
    """The bytes of a file: accessor i is array i; the scene has the nodes that are no children, if the tree has none."""
    data, views = b"", []
    for array in arrays:
        data += b"\0" * (-len(data) % 4)
        views.append({"buffer": 0, "byteOffset": len(data), "byteLength": array.nbytes})
        data += np.ascontiguousarray(array).tobytes()
    data += b"\0" * (-len(data) % 4)
    below = {child for node in tree.get("nodes", []) for child in node.get("children", [])}
    whole = {
        "asset": {"version": "2.0", "generator": "by hand"},
        "scene": 0,
        "scenes": [{"nodes": [i for i in range(len(tree.get("nodes", []))) if i not in below]}],
        "accessors": [accessor(i, array) for i, array in enumerate(arrays)],
        "bufferViews": views,
        "buffers": [{"byteLength": len(data)}],
        **tree,
    }
    text = json.dumps(whole).encode()
    text += b" " * (-len(text) % 4)
    head = struct.pack("<4sIIII", b"glTF", 2, 28 + len(text) + len(data), len(text), 0x4E4F534A)
    return head + text + struct.pack("<II", len(data), 0x004E4942) + data


def placed_twice(path, quad):
    """A quad at two nodes, one of which mirrors it, with two sets of coordinates; and as a strip with one, of 16 bits."""
    uv = np.stack([quad[:, 0] / 2, 1 - quad[:, 1]], axis=1)
    order = [0, 1, 3, 2]
    arrays = [quad, uv, 3 * uv, np.array([0, 1, 2, 0, 2, 3], np.uint16), quad[order], (uv[order] * 65535).astype(np.uint16)]
    quads = {"attributes": {"POSITION": 0, "TEXCOORD_0": 1, "TEXCOORD_1": 2}, "indices": 3}
    strip = {"attributes": {"POSITION": 4, "TEXCOORD_0": 5}, "mode": 5}
    tree = {
        "meshes": [{"primitives": [quads]}, {"primitives": [{"attributes": {"POSITION": 0}, "mode": 1}, strip]}],
        "nodes": [{"mesh": 0}, {"mesh": 0, "scale": [-1, 1, 1]}, {"mesh": 1}],
    }
    path.write_bytes(glb(tree, arrays))
    return path
