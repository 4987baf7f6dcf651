"""Conversion of meshes and points to PyVista's PolyData, for PyVista's filters, writers and plots."""

from typing import Any

import numpy as np

from warpsample.host.extras import missing


def pyvista() -> Any:
    """Import and return the module `pyvista`; raise a ModuleNotFoundError that explains how to install PyVista."""
    try:
        import pyvista as pv
    except ModuleNotFoundError:
        raise missing("PolyData needs PyVista", "pyvista") from None
    return pv


def surface(vertices: np.ndarray, faces: np.ndarray) -> Any:
    """Return a PolyData of the triangles with vertices (V, 3) and faces (F, 3)."""
    return pyvista().PolyData.from_regular_faces(vertices, faces)


def cloud(position: np.ndarray, normal: np.ndarray, **arrays: np.ndarray | None) -> Any:
    """Return a PolyData of points (N, 3) with active normals "Normals" and further point arrays (N, ...) by name.

    Arrays that are None are left out.
    """
    made = pyvista().PolyData(position)
    made.point_data.active_normals = np.ascontiguousarray(normal, np.float32)
    for name, array in arrays.items():
        if array is not None:
            made.point_data[name] = array
    return made
