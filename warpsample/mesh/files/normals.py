"""Reader of the normals in mesh files, at the corners of faces."""

from collections.abc import Callable
from pathlib import Path

import numpy as np

from warpsample.mesh.files import gltf, ply, text, usd
from warpsample.mesh.mesh import Mesh

_SCENES = (".glb", ".gltf")
_READERS: dict[str, Callable[[Path], np.ndarray | None]] = {
    ".obj": text.read_obj_normals,
    ".ply": lambda path: ply.read_corners(path, ("nx", "ny", "nz")),
    **dict.fromkeys(_SCENES, lambda path: gltf.read_corners(path, "NORMAL")),
    **dict.fromkeys((".usd", ".usda", ".usdc", ".usdz"), usd.read_normals),
}


def read_normals(path: Path) -> np.ndarray | None:
    """Read the normals at the corners of the faces that `load_mesh` reads from the same file.

    Normals are placed in the scene like the faces. Their length is that of the file, or 1.

    Args:
        path: Path of a file that `load_mesh` has read.

    Returns:
        (F, 3, 3) float64, NaN at corners without a normal; None for a file without normals. Normals of .stl and .off are not
        read. Files of glTF always have an array, because a primitive without normals has those of its faces (glTF 2.0,
        3.7.2.1).

    Raises:
        ValueError: Normals that cannot be read.
    """
    reader = _READERS.get(path.suffix.lower())
    found = None if reader is None else reader(path)
    return None if found is None or (np.isnan(found).all() and path.suffix.lower() not in _SCENES) else found


def read_smooth_normals(path: Path, mesh: Mesh) -> np.ndarray | None:
    """Read normals at face corners as `read_normals` does, but with vertex normals for glTF primitives without normals.

    Args:
        path: Path of the file.
        mesh: Mesh as `load_mesh` reads it.
    """
    found = read_normals(path)
    if found is not None and path.suffix.lower() in _SCENES:
        lacking = ~gltf.find_faces_with(path, "NORMAL")
        found[lacking] = mesh.vertex_normals[mesh.faces[lacking]]
    return found
