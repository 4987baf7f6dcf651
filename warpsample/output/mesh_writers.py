"""Writers of meshes and clouds as .ply, .vtp and .glb, block by block, so that no array is in memory twice.

The writers of libraries do not suffice: those of trimesh and VTK write only float32 into .ply, VTK crashes when the disk is
full, and trimesh holds a .glb three times in memory. These libraries read the files that are written here.
"""

import json
import struct
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import Any, BinaryIO
from xml.sax.saxutils import quoteattr

import numpy as np

_BLOCK = 1 << 16  # rows at a time
_PLY = {"f4": "float", "f8": "double", "i4": "int", "u1": "uchar"}
_VTK = {"f4": "Float32", "f8": "Float64", "i4": "Int32", "i8": "Int64", "u1": "UInt8"}
_GLB = {"f4": 5126, "u4": 5125, "u1": 5121}


@dataclass(frozen=True)
class Lazy:
    """Array whose rows are computed only when written; the function `make` computes the rows of (n,) int64 indices."""

    shape: tuple[int, ...]
    dtype: np.dtype
    make: Callable[[np.ndarray], np.ndarray]

    def __len__(self) -> int:
        """Return the number of rows."""
        return self.shape[0]

    def __getitem__(self, rows: slice) -> np.ndarray:
        """Compute and return the rows of a slice."""
        return self.make(np.arange(*rows.indices(len(self)))).astype(self.dtype, copy=False)


Rows = np.ndarray | Lazy
"""Arrays (n,) or (n, k), or `Lazy` ones."""


def write_ply(file: BinaryIO, elements: dict[str, dict[str, Rows]]) -> None:
    """Write a binary .ply file from the columns of its vertices and faces: {"vertex": columns, "face": columns}.

    The key of a column is the name of its property, or of several properties with blanks between the names.
    "vertex_indices" are the (F, 3) corners of faces.
    """
    head = ["ply", "format binary_little_endian 1.0"]
    for element, columns in elements.items():
        head.append(f"element {element} {_count(columns)}")
        for names, rows in columns.items():
            kind = "list uchar int" if names == "vertex_indices" else _PLY[rows.dtype.str[1:]]
            head += [f"property {kind} {name}" for name in names.split()]
    file.write("\n".join([*head, "end_header\n"]).encode())
    for columns in elements.values():
        fields: list[Any] = [(names, rows.dtype.newbyteorder("<"), rows.shape[1:]) for names, rows in columns.items()]
        if "vertex_indices" in columns:
            fields.insert(0, ("corners", "u1"))
        for first in range(0, _count(columns), _BLOCK):
            parts = {names: rows[first : first + _BLOCK] for names, rows in columns.items()}
            block = np.empty(_count(parts), fields)
            for names in block.dtype.names or ():
                block[names] = parts.get(names, 3)
            file.write(block)


def write_vtp(
    file: BinaryIO, points: Rows, faces: Rows | None, point_data: dict[str, Rows], cell_data: dict[str, Rows]
) -> None:
    """Write a binary .vtp file of points (N, 3), with triangles (F, 3) or without.

    Data are arrays (N, ...) or (F, ...) by name; "Normals" of points become the active normals.
    """
    count, corners = (len(points), 1) if faces is None else (len(faces), 3)
    kind = np.dtype(np.int32 if corners * count < 2**31 else np.int64)
    cells: dict[str, Rows] = {
        "connectivity": Lazy((count,), kind, lambda i: i) if faces is None else faces,
        "offsets": Lazy((count,), kind, lambda i: corners * (i + 1)),
    }
    name = "Verts" if faces is None else "Polys"
    active = ' Normals="Normals"' if "Normals" in point_data else ""
    sections = [("Points", "", {"Points": points}), ("PointData", active, point_data), ("CellData", "", cell_data)]
    head = [
        '<?xml version="1.0"?>\n<VTKFile type="PolyData" version="1.0" byte_order="LittleEndian" header_type="UInt64">',
        f'<PolyData><Piece NumberOfPoints="{len(points)}" NumberOf{name}="{count}">',
    ]
    offset = 0
    for section, attributes, arrays in [*sections, (name, "", cells)]:
        head.append(f"<{section}{attributes}>")
        for array, rows in arrays.items():
            width = rows.shape[1] if len(rows.shape) > 1 and section != name else 1
            head.append(
                f'<DataArray type="{_VTK[rows.dtype.str[1:]]}" Name={quoteattr(array)} NumberOfComponents="{width}" '
                f'format="appended" offset="{offset}"/>'
            )
            offset += 8 + _bytes(rows)
        head.append(f"</{section}>")
    file.write("\n".join([*head, '</Piece></PolyData><AppendedData encoding="raw">\n_']).encode())
    for rows in [rows for _, _, arrays in sections for rows in arrays.values()] + list(cells.values()):
        file.write(struct.pack("<Q", _bytes(rows)))
        file.writelines(_blocks(rows))
    file.write(b"\n</AppendedData></VTKFile>\n")


def write_glb(
    file: BinaryIO, vertices: Rows, corners: Rows, attributes: dict[str, Rows], placed: dict[str, list[float]]
) -> None:
    """Write a binary glTF of one mesh: vertices (V, 3) float32, and corners (F, 3) uint32, indices of vertices.

    Attributes are (V,) or (V, 4) by name, float32, or uint8 that stands for 0 to 1. The node is placed by its translation
    and rotation, in float64.
    """
    low, high = np.full(3, np.inf), np.full(3, -np.inf)
    for block in _blocks(vertices):
        low, high = np.minimum(low, block.min(axis=0)), np.maximum(high, block.max(axis=0))
    arrays = {"POSITION": vertices, **attributes, "corners": corners}
    views, accessors, offset = [], [], 0
    for name, rows in arrays.items():
        scalars = name == "corners" or len(rows.shape) == 1
        accessor = {
            "bufferView": len(views),
            "componentType": _GLB[rows.dtype.str[1:]],
            "count": len(rows) * (3 if name == "corners" else 1),
            "type": "SCALAR" if scalars else f"VEC{rows.shape[1]}",
            "normalized": rows.dtype == np.uint8,
        }
        accessors.append(accessor | ({"min": low.tolist(), "max": high.tolist()} if name == "POSITION" else {}))
        views.append({"buffer": 0, "byteOffset": offset, "byteLength": _bytes(rows)})
        offset += _bytes(rows)
    *of_vertices, _ = range(len(arrays))
    primitive = {"attributes": dict(zip(arrays, of_vertices, strict=False)), "indices": len(of_vertices)}
    tree = {
        "asset": {"version": "2.0", "generator": "warpsample"},
        "scene": 0,
        "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0, **placed}],
        "meshes": [{"primitives": [primitive]}],
        "buffers": [{"byteLength": offset}],
        "bufferViews": views,
        "accessors": accessors,
    }
    text = json.dumps(tree).encode()
    text += b" " * (-len(text) % 4)
    file.write(struct.pack("<4sIIII", b"glTF", 2, 28 + len(text) + offset, len(text), 0x4E4F534A))
    file.write(text + struct.pack("<II", offset, 0x004E4942))
    for rows in arrays.values():
        file.writelines(_blocks(rows))


def _count(columns: dict[str, Any]) -> int:
    """Return the number of rows of a table, given its columns."""
    return len(next(iter(columns.values())))


def _bytes(rows: Rows) -> int:
    """Return the size in bytes of an array, or of a `Lazy` array when computed."""
    return int(np.prod(rows.shape)) * rows.dtype.itemsize


def _blocks(rows: Rows) -> Iterator[np.ndarray]:
    """Yield the rows of an array in contiguous little-endian blocks, so that little memory is used."""
    for first in range(0, len(rows), _BLOCK):
        yield np.ascontiguousarray(rows[first : first + _BLOCK], rows.dtype.newbyteorder("<"))
