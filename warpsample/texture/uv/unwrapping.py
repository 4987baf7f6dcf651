"""New texture coordinates: `unwrap`, by xatlas."""

import signal
from dataclasses import replace
from importlib.util import find_spec
from io import BytesIO
from typing import Any

import numpy as np

from warpsample.host.arguments import check_integer
from warpsample.host.extras import REFUSED, missing, run_program
from warpsample.mesh.mesh import Mesh, as_mesh
from warpsample.texture.uv.charts import add_left_out
from warpsample.texture.uv.pieces import NO_CHARTS, MeshCharts, divide_meshes, find_kept, join_charts

PADDING = 4
"""Default number of texels between charts."""

_MOST_SIDE = 1 << 14
_TRIES = 3  # xatlas crashes by chance: once in 600 runs on the same mesh, with several at a time
_CRASHES = (-signal.SIGSEGV, -signal.SIGABRT)
_PROGRAM = "from warpsample.texture.uv import charting; charting.main({size}, {padding})"


def unwrap(mesh: Any, size: int, *, padding: int = PADDING) -> tuple[Mesh, np.ndarray]:
    """Compute new texture coordinates for a mesh: charts side by side in one square image, by xatlas.

    Charts that xatlas lays on themselves are divided, so that at most about 0.05 % of the texels lie in two faces.
    `texture_points(...).report` counts these texels. xatlas takes minutes for some smooth meshes of 10,000 faces and more:
    waves, and sheets of long twisted faces.

    Args:
        mesh: a Mesh, or anything that `as_mesh` accepts.
        size: width and height of the image in texels, 1 to 16384.
        padding: least number of texels between charts, 0 to 64; usually there are twice as many. Level k of a mipmap needs
            3 x 2^k texels. With 64 in an image of 16384 texels, packing takes minutes.

    Returns:
        the mesh with vertices split at the borders of charts, and the same faces in the same order; and (F, 3, 2) float64
        coordinates from 0 to 1, v downward. A face without an area in float32 has equal coordinates at its three corners.
        Slivers, narrower than 1/10,000 of their longest edge, have the coordinates of a neighbour's corner if they are
        longer than all else, or if they would make all charts smaller. Beside large parts, faces of a part below 1/5,000 of
        the mesh's size may have no area, and so may faces narrower than about 1/1,000,000 of their chart.

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
    kept, given = find_kept(parts), {}
    shown = [i for i, rows in enumerate(kept) if len(rows)]
    pieces = divide_meshes([(parts[i][0], parts[i][1][kept[i]]) for i in shown])
    for i, one in enumerate(pieces):
        given |= {f"v{i}": one.vertices, f"f{i}": one.faces.astype(np.uint32)}
    made = _run(given, size, padding)
    charts = [(made[f"old{i}"], made[f"f{i}"], made[f"uv{i}"]) for i in range(len(pieces))]
    joined = dict(zip(shown, join_charts(pieces, charts, len(shown)), strict=True))
    return [add_left_out(faces, kept[i], *joined.get(i, NO_CHARTS)) for i, (_, faces) in enumerate(parts)]


def _run(given: dict[str, np.ndarray], size: int, padding: int) -> Any:
    """Run the program of `charting` on meshes, and return the arrays of its answer.

    Raises:
        ValueError: xatlas fails on the meshes, or the image is too small for the charts.
    """
    stream = BytesIO()
    np.savez(stream, **given)
    for _ in range(_TRIES):
        status, answer = run_program(_PROGRAM.format(size=size, padding=padding), stream.getvalue())
        if status not in _CRASHES:
            break
    if status == REFUSED:
        raise ValueError(answer.decode())
    if status:
        raise ValueError(
            f"mesh: got a mesh on which xatlas ended with {status}, want texture coordinates made by another program"
        )
    return np.load(BytesIO(answer))
