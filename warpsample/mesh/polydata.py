"""Meshes and points as PyVista's PolyData, for its filters, writers and pictures."""

from typing import Any

import numpy as np

from warpsample.host.extras import missing


def pyvista() -> Any:
    """The module `pyvista`, imported when it is first needed; a ModuleNotFoundError says how to install it."""
    try:
        import pyvista as pv
    except ModuleNotFoundError:
        raise missing("PolyData needs PyVista", "pyvista") from None
    return pv


def surface(vertices: np.ndarray, faces: np.ndarray) -> Any:
    """The triangles of vertices (V, 3) and faces (F, 3)."""
    return pyvista().PolyData.from_regular_faces(vertices, faces)


def cloud(position: np.ndarray, normal: np.ndarray, **arrays: np.ndarray | None) -> Any:
    """Points (N, 3) with normals, the active array "Normals", and further arrays, (N, ...) by name; None is left out."""
    made = pyvista().PolyData(position)
    made.point_data.active_normals = np.ascontiguousarray(normal, np.float32)
    for name, array in arrays.items():
        if array is not None:
            made.point_data[name] = array
    return made
