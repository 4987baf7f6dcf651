"""New texture coordinates: `unwrap`, by xatlas."""

from dataclasses import replace
from typing import Any

import numpy as np

from warpsample.host.arguments import check_integer
from warpsample.host.making import imported, missing
from warpsample.mesh.mesh import Mesh, as_mesh

Charted = tuple[np.ndarray, np.ndarray, np.ndarray]
"""Of a mesh: (V2,) the vertex that each new one is, (F, 3) new vertices of its faces, and (V2, 2) their coordinates."""

PADDING = 4
"""Texels between charts, if nothing else is said."""

_MOST_SIDE = 1 << 14
_DIAGONAL = 1000.0  # that xatlas gets of a mesh: it drops faces whose area is below 1e-7
_TRIES = 12
_SLACK = 0.995  # by which a try is smaller than what would just fit: packing is uneven


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
        TypeError, ValueError: an argument that cannot be used, or an image too small for so many charts.
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
    """Charts of several meshes, vertices and faces, in one image.

    The library makes an image of about the size that it is asked for; so it is asked for ever fewer texels of a unit of
    length, until all charts fit, and its coordinates are told in shares of the image that was meant.
    """
    library = _library()
    used = np.concatenate([vertices[np.unique(faces)] for vertices, faces in parts])
    low, high = used.min(axis=0), used.max(axis=0)
    scale = _DIAGONAL / (float(np.linalg.norm(high - low)) or 1.0)
    scaled = [(((v - 0.5 * (low + high)) * scale).astype(np.float32), f.astype(np.uint32)) for v, f in parts]
    wanted = 0.0
    for _ in range(_TRIES):
        atlas = library.Atlas()
        for vertices, faces in scaled:
            atlas.add_mesh(vertices, faces)
        options = library.PackOptions()
        options.resolution, options.texels_per_unit, options.padding = 0 if wanted else size, wanted, padding
        atlas.generate(pack_options=options)
        side = max(atlas.width, atlas.height)
        if not side:
            raise ValueError("mesh: got faces without an area, want at least one that has some")
        if side <= size:
            share = np.array((atlas.width, atlas.height)) / size
            return [
                (vertex, faces, uv.astype(np.float64) * share)
                for vertex, faces, uv in map(atlas.get_mesh, range(len(parts)))
            ]
        wanted = atlas.texels_per_unit * _SLACK * size / side
    raise ValueError(
        f"size: got {size}, where {atlas.chart_count:,} charts, {padding} texels apart, take {side} texels, want more"
    )


def _library() -> Any:
    try:
        return imported("xatlas")
    except ModuleNotFoundError:
        raise missing("new texture coordinates need xatlas", "xatlas") from None
