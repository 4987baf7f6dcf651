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

Charted = tuple[np.ndarray, np.ndarray, np.ndarray]
"""Of a mesh: (V2,) the vertex that each new one is, (F, 3) new vertices of its faces, and (V2, 2) their coordinates."""

PADDING = 4
"""Texels between charts, if nothing else is said."""

_MOST_SIDE = 1 << 14
_DIAGONAL = 1000.0  # that xatlas gets of a mesh: it drops faces whose area is below 1e-7
_PROGRAM = "import sys; sys.path[:] = {path!r}; from warpsample.mesh import charting; charting.main({size}, {padding})"


def unwrap(mesh: Any, size: int, *, padding: int = PADDING) -> tuple[Mesh, np.ndarray]:
    """New texture coordinates for a mesh: charts that do not overlap, by xatlas, in one square image.

    Args:
        mesh: a Mesh or whatever `as_mesh` takes.
        size: width and height of the image that they are for, in texels, 1 to 16384.
        padding: texels between charts, 0 to 64. Level k of a mipmap needs 3 x 2^k of them, so 4 serve the image itself and
            nearly the next level.

    Returns:
        the mesh with its vertices split where charts end, so that each has one place in the image, the same faces in the
        same order; and (F, 3, 2) float64, v downward. Faces without an area are all at one place.

    Raises:
        TypeError, ValueError: an argument that cannot be used, a mesh that xatlas does not bear, or an image too small for
            so many charts.
        ModuleNotFoundError: xatlas is missing; says how to install it.

    Example:
        >>> split, uv = ws.unwrap(ws.load_mesh("courtyard"), 256)
        >>> print(uv.shape, ws.texture_points(split, uv, 256).report.overlapped)
        (2080, 3, 2) 0
    """
    mesh = as_mesh(mesh)
    size = check_integer(size, "size", 1, _MOST_SIDE)
    padding = check_integer(padding, "padding", 0, 64)
    ((vertex, faces, uv),) = charted([(mesh.vertices, mesh.faces)], size, padding)
    return replace(mesh, vertices=mesh.vertices[vertex], faces=faces), uv[faces]


def charted(parts: list[tuple[np.ndarray, np.ndarray]], size: int, padding: int) -> list[Charted]:
    """Charts of several meshes, vertices and faces, in one image; coordinates are told in shares of it."""
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
        raise ValueError(f"mesh: got one on which xatlas ended with {status}, want coordinates by another program")
    made = np.load(BytesIO(answer))
    share = made["share"]
    return [(made[f"old{i}"], made[f"f{i}"], made[f"uv{i}"].astype(np.float64) * share) for i in range(len(parts))]
