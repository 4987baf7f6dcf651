"""Mesh files: .glb and .gltf."""

import json
from base64 import b64decode
from collections.abc import Iterator
from pathlib import Path
from typing import Any
from urllib.parse import unquote

import numpy as np

from warpsample.mesh.files.placing import joined
from warpsample.mesh.polygons import triangles

_KINDS = {5120: "<i1", 5121: "<u1", 5122: "<i2", 5123: "<u2", 5125: "<u4", 5126: "<f4"}
_WIDTHS = {"SCALAR": 1, "VEC3": 3}
_TRIANGLES, _STRIP, _FAN = 4, 5, 6
# They change the faces, and are not supported.
_EXTENSIONS = {"KHR_draco_mesh_compression", "EXT_meshopt_compression", "EXT_mesh_gpu_instancing"}


def read(path: Path) -> tuple[np.ndarray, np.ndarray]:
    """Vertices and faces of the file's scene in its rest pose; lines and points are left out.

    Raises:
        ValueError: the file is shorter or longer than it declares, or compressed, sparse or instanced by an extension.
    """
    is_binary = path.suffix.lower() == ".glb"
    tree, chunk = _parts(path.read_bytes()) if is_binary else (json.loads(path.read_bytes()), memoryview(b""))
    needed = _EXTENSIONS & set(tree.get("extensionsUsed", []))
    if needed:
        raise ValueError(f"it uses {', '.join(sorted(needed))}, want a file that does not")
    try:
        return joined(_surfaces(tree, [_buffer(path, buffer, chunk) for buffer in tree.get("buffers", [])]))
    except (KeyError, IndexError, TypeError, AttributeError) as error:
        raise ValueError(f"its JSON is incomplete: {error!r}") from None


def _surfaces(tree: dict[str, Any], buffers: list[memoryview]) -> Iterator[tuple[np.ndarray, np.ndarray, np.ndarray]]:
    """Points, triangles and matrix of each surface of the scene."""
    scenes = tree.get("scenes", [{}])
    for root in scenes[tree.get("scene", 0)].get("nodes", []):
        for mesh, matrix in _placed(tree["nodes"], root, np.eye(4)):
            for primitive in tree["meshes"][mesh]["primitives"]:
                if primitive.get("mode", _TRIANGLES) >= _TRIANGLES:
                    yield (*_surface(tree, buffers, primitive), matrix)


def _parts(content: bytes) -> tuple[dict[str, Any], memoryview]:
    """The JSON part of a .glb, and the bytes of its first buffer."""
    version, length, size = (int.from_bytes(content[at : at + 4], "little") for at in (4, 8, 12))
    if content[:4] != b"glTF" or content[16:20] != b"JSON" or version != 2:
        raise ValueError("it does not begin as a .glb of version 2")
    if length != len(content) or size > length - 20:
        raise ValueError(f"its header declares {length:,} bytes, {size:,} in the first part, but it has {len(content):,}")
    return json.loads(content[20 : 20 + size]), memoryview(content)[28 + size :]


def _buffer(path: Path, buffer: dict[str, Any], chunk: memoryview) -> memoryview:
    uri = buffer.get("uri")
    if uri is None:
        content = chunk
    elif uri.startswith("data:"):
        content = memoryview(b64decode(uri.partition("base64,")[2]))
    else:
        content = memoryview((path.parent / unquote(uri)).read_bytes())
    if len(content) < buffer["byteLength"]:
        raise ValueError(f"it declares {buffer['byteLength']:,} bytes of data, but there are {len(content):,}")
    return content[: buffer["byteLength"]]


def _placed(nodes: list[dict[str, Any]], number: int, above: np.ndarray) -> Iterator[tuple[int, np.ndarray]]:
    """Each mesh at or below a node with its matrix, which multiplies from the right; `above` is that of the parent."""
    node = nodes[number]
    matrix = _matrix(node) @ above
    if "mesh" in node:
        yield node["mesh"], matrix
    for child in node.get("children", []):
        yield from _placed(nodes, child, matrix)


def _matrix(node: dict[str, Any]) -> np.ndarray:
    from scipy.spatial.transform import Rotation  # noqa: PLC0415  (heavy, and only scenes need it)

    if "matrix" in node:
        return np.array(node["matrix"], np.float64).reshape(4, 4)
    matrix = np.eye(4)
    matrix[:3, :3] = Rotation.from_quat(node.get("rotation", (0.0, 0.0, 0.0, 1.0))).as_matrix().T
    matrix[:3, :3] *= np.array(node.get("scale", (1.0, 1.0, 1.0)))[:, None]
    matrix[3, :3] = node.get("translation", (0.0, 0.0, 0.0))
    return matrix


def _surface(tree: dict[str, Any], buffers: list[memoryview], primitive: dict[str, Any]) -> tuple[np.ndarray, np.ndarray]:
    points = _numbers(tree, buffers, primitive["attributes"]["POSITION"])
    if "indices" in primitive:
        corners = _numbers(tree, buffers, primitive["indices"]).ravel()
    else:
        corners = np.arange(len(points), dtype=np.int32)
    if primitive.get("mode", _TRIANGLES) != _TRIANGLES:
        first = np.arange(max(len(corners) - 2, 0))
        odd = first % 2
        rows = (
            (first, first + 1 + odd, first + 2 - odd) if primitive["mode"] == _STRIP else (first + 1, first + 2, 0 * first)
        )
        corners = corners[np.stack(rows, axis=1).ravel()]
    return points, triangles(points, np.broadcast_to(3, len(corners) // 3), corners)


def _numbers(tree: dict[str, Any], buffers: list[memoryview], number: int) -> np.ndarray:
    """The numbers of an accessor, without a copy; NumPy refuses an array that goes beyond its buffer."""
    accessor = tree["accessors"][number]
    if "sparse" in accessor or "bufferView" not in accessor:
        raise ValueError("it has sparse data, want a file that holds all numbers")
    view = tree["bufferViews"][accessor["bufferView"]]
    kind, shape = np.dtype(_KINDS[accessor["componentType"]]), (accessor["count"], _WIDTHS[accessor["type"]])
    begin = view.get("byteOffset", 0)
    data = buffers[view["buffer"]][begin : begin + view["byteLength"]]
    strides = (view.get("byteStride", shape[1] * kind.itemsize), kind.itemsize)
    try:
        found = np.ndarray(shape, kind, data, accessor.get("byteOffset", 0), strides)
    except (TypeError, ValueError):
        raise ValueError(f"it declares {shape[0]:,} {accessor['type']} in {len(data):,} bytes") from None
    return np.maximum(found / np.iinfo(kind).max, -1.0) if accessor.get("normalized") else found
