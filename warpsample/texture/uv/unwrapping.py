"""New texture coordinates: `unwrap`, by xatlas."""

import sys
from dataclasses import replace
from importlib.util import find_spec
from io import BytesIO
from typing import Any

import numpy as np

from warpsample.host.arguments import check_integer
from warpsample.host.extras import REFUSED, missing, run_program
from warpsample.mesh.mesh import Mesh, as_mesh

MeshCharts = tuple[np.ndarray, np.ndarray, np.ndarray]
"""Charts of a mesh: (V2,) old vertex of each new vertex, (F, 3) new vertices of each face, and (V2, 2) coordinates."""

PADDING = 4
"""Default number of texels between charts."""

_MOST_SIDE = 1 << 14
_DIAGONAL = 1000.0  # diagonal of the scaled mesh for xatlas, which drops faces with an area below 1e-7
_PROGRAM = "import sys; sys.path[:] = {path!r}; from warpsample.texture.uv import charting; charting.main({size}, {padding})"


def unwrap(mesh: Any, size: int, *, padding: int = PADDING) -> tuple[Mesh, np.ndarray]:
    """Compute new texture coordinates for a mesh: charts side by side in one square image, by xatlas.

    Charts do not overlap, but on rough terrain xatlas may fold a chart: up to 0.05 % of the texels then lie in two faces.
    `texture_points(...).report` counts them.

    Args:
        mesh: a Mesh, or anything that `as_mesh` accepts.
        size: width and height of the image in texels, 1 to 16384.
        padding: texels between charts, 0 to 64. Level k of a mipmap needs 3 x 2^k texels, so the default of 4 is enough for
            the image itself and nearly for the next level.

    Returns:
        the mesh with vertices split at the borders of charts, and the same faces in the same order; and (F, 3, 2) float64
        coordinates from 0 to 1, v downward. A face without an area has equal coordinates at its three corners.

    Raises:
        TypeError, ValueError: an argument is invalid, xatlas fails on the mesh, or the image is too small for the charts.
        ModuleNotFoundError: xatlas is missing; the message names the install command.

    Example:
        >>> split, uv = ws.unwrap(ws.load_mesh("courtyard"), 256)
        >>> print(uv.shape, ws.texture_points(split, uv, 256).report.overlapped)
        (2080, 3, 2) 0
    """
    mesh = as_mesh(mesh)
    size = check_integer(size, "size", 1, _MOST_SIDE)
    padding = check_integer(padding, "padding", 0, 64)
    ((vertex, faces, uv),) = unwrap_meshes([(mesh.vertices, mesh.faces)], size, padding)
    return replace(mesh, vertices=mesh.vertices[vertex], faces=faces), uv[faces]


def unwrap_meshes(parts: list[tuple[np.ndarray, np.ndarray]], size: int, padding: int) -> list[MeshCharts]:
    """Compute charts of several meshes in one square image of `size` texels; coordinates are from 0 to 1.

    Args:
        parts: vertices and faces of each mesh.
        size: width and height of the image in texels.
        padding: texels between charts.
    """
    if find_spec("xatlas") is None:
        raise missing("new texture coordinates need xatlas", "xatlas")
    used = np.concatenate([vertices[np.unique(faces)] for vertices, faces in parts])
    low, high = used.min(axis=0), used.max(axis=0)
    scale = _DIAGONAL / (float(np.linalg.norm(high - low)) or 1.0)
    given = {}
    for i, (vertices, faces) in enumerate(parts):
        given |= {f"v{i}": ((vertices - 0.5 * (low + high)) * scale).astype(np.float32), f"f{i}": faces.astype(np.uint32)}
    stream = BytesIO()
    np.savez(stream, **given)
    status, answer = run_program(_PROGRAM.format(path=sys.path, size=size, padding=padding), stream.getvalue())
    if status == REFUSED:
        raise ValueError(answer.decode())
    if status:
        raise ValueError(
            f"mesh: got a mesh on which xatlas ended with {status}, want texture coordinates made by another program"
        )
    made = np.load(BytesIO(answer))
    share = made["share"]
    return [(made[f"old{i}"], made[f"f{i}"], made[f"uv{i}"].astype(np.float64) * share) for i in range(len(parts))]
