"""Reader of .stl files, binary or text; equal corners are merged, because faces of an .stl share no vertices.

trimesh, meshio and VTK are not used: for a truncated binary file whose header begins with "solid" all three return a mesh
without faces and raise no error. For a truncated text of 80 faces, meshio returns 78.
"""

from array import array
from collections import Counter
from pathlib import Path

import numpy as np

from warpsample.mesh.files.text import numbered, three
from warpsample.mesh.parts import Named, named_parts

_HEADER = 84  # bytes, the last four of which are the number of faces
_FACE = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")])
_WORDS = {"solid", "facet", "outer", "vertex", "endloop", "endfacet", "endsolid"}


def read(path: Path) -> Named:
    """Read vertices, faces and named parts of an .stl file; corners with equal coordinates become one vertex.

    Solids of a text file become named parts. A text file declares no number of solids, so a file that ends between two
    solids, or within the name after `endsolid`, raises no error.

    Raises:
        ValueError: A size other than the header declares, unknown words, or facets, loops or solids without an end.
    """
    size = path.stat().st_size
    with path.open("rb") as file:
        header = file.read(_HEADER)
    faces = int.from_bytes(header[80:], "little")
    if size == _HEADER + faces * _FACE.itemsize and size > _HEADER:
        return *_merged(np.fromfile(path, _FACE, offset=_HEADER)["corners"].reshape(-1, 3)), None, ()
    if header[:5].lower() == b"solid":
        corners, counts, names = _text(path)
        return *_merged(corners), *named_parts(counts, names)
    wants = f"but the header declares {faces:,} faces, which take {_HEADER + faces * _FACE.itemsize:,} bytes"
    raise ValueError(f"the file has {size:,} bytes, {wants}" if size > _HEADER else "the file has no faces")


def _text(path: Path) -> tuple[np.ndarray, list[int], list[str]]:
    """Read a text .stl; return the (N, 3) corners of all facets, and the number of facets and name of each solid."""
    positions, seen = array("d"), Counter(dict.fromkeys(_WORDS, 0))
    starts, names = [], []
    for number, words in numbered(path):
        word = words[0].lower()
        if word not in _WORDS:
            raise ValueError(f"line {number} begins with {words[0][:20]!r}, which is not a keyword of STL")
        seen[word] += 1
        if word == "solid":
            starts.append(seen["facet"])
            names.append(" ".join(words[1:]))
        if word == "vertex":
            positions.extend(three(words[1:]))
        elif word == "endfacet" and len(positions) != 9 * seen[word]:
            raise ValueError(f"line {number} ends a facet that does not have three corners")
    if len({seen[word] for word in ("facet", "outer", "endloop", "endfacet")}) > 1 or seen["solid"] != seen["endsolid"]:
        raise ValueError("the file ends within a solid; an endsolid, endloop or endfacet is missing")
    counts = np.diff([*starts, seen["facet"]]).tolist()
    return np.frombuffer(positions).reshape(-1, 3), counts, names


def _merged(corners: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Merge equal corners; return unique vertices (V, 3) and faces (F, 3)."""
    order = np.lexsort(corners.T)
    is_new = np.arange(len(corners)) == 0
    for axis in corners.T:
        along = axis[order]
        is_new[1:] |= along[1:] != along[:-1]
    vertex = np.empty(len(corners), np.int32)
    vertex[order] = np.cumsum(is_new) - 1
    return corners[order[is_new]], vertex.reshape(-1, 3)
