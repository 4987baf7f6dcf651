"""Reader of the normals in mesh files, at the corners of faces."""

from collections.abc import Callable
from pathlib import Path

import numpy as np

from warpsample.mesh.files import gltf, ply, text, usd

_READERS: dict[str, Callable[[Path], np.ndarray | None]] = {
    ".obj": text.read_obj_normals,
    ".ply": ply.read_normals,
    **dict.fromkeys((".glb", ".gltf"), lambda path: gltf.read_corners(path, "NORMAL")),
    **dict.fromkeys((".usd", ".usda", ".usdc", ".usdz"), usd.read_normals),
}


def read_normals(path: Path) -> np.ndarray | None:
    """Read the normals at the corners of the faces that `load_mesh` reads from the same file.

    Normals are placed in the scene like the faces. Their length is that of the file, or 1.

    Args:
        path: Path of a file that `load_mesh` has read.

    Returns:
        (F, 3, 3) float64, NaN at corners without a normal; None for a file without normals. Normals of .stl and .off are not
        read.

    Raises:
        ValueError: Normals that cannot be read.
    """
    reader = _READERS.get(path.suffix.lower())
    found = None if reader is None else reader(path)
    return None if found is None or np.isnan(found).all() else found
