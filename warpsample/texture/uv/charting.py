"""Program that unwraps meshes with xatlas into one image; it runs in a separate process because some meshes crash xatlas."""

import os
import sys
from io import BytesIO
from typing import Any, NoReturn

import numpy as np

from warpsample.host.extras import REFUSED
from warpsample.texture.uv.charts import find_longest_edges, find_wide

_TRIES = 12
_SLACK = 0.995  # factor on the scale that would just fit, because packing is uneven
_STRETCHED = 4.0  # longer than in space: such a face is spoiled, as xatlas stretches edges by less than 1.5
_alive: list[Any] = []  # all atlases: destroying one can wait forever for a thread of xatlas


def main(size: int, padding: int) -> NoReturn:
    """Read meshes from standard input, unwrap the meshes, write charts to standard output, as .npz archives, and exit.

    The input has vertices and faces of each mesh: "v0", "f0", "v1", ... The output has "share", the (2,) used fractions of
    the image's width and height, and for each mesh "old0", the original vertex of each new vertex, "uv0", texture
    coordinates in the used part of the image, and "f0", the new faces.
    """
    given = np.load(BytesIO(sys.stdin.buffer.read()))
    parts = [(given[f"v{i}"], given[f"f{i}"]) for i in range(len(given.files) // 2)]
    try:
        share, atlas, kept = _packed(parts, size, padding)
    except ValueError as error:
        _answer(str(error).encode(), REFUSED)
    arrays = {"share": share}
    for i in range(len(parts)):
        old, faces, uv = _add_left_out(parts[i][1], kept[i], *atlas.get_mesh(i))
        arrays |= {f"old{i}": old, f"f{i}": faces, f"uv{i}": uv}
    stream = BytesIO()
    np.savez(stream, **arrays)
    _answer(stream.getvalue(), 0)


def _answer(content: bytes, status: int) -> NoReturn:
    """Write bytes to standard output and end the process without destroying any atlas."""
    sys.stdout.buffer.write(content)
    sys.stdout.flush()
    os._exit(status)


def _packed(
    parts: list[tuple[np.ndarray, np.ndarray]], size: int, padding: int
) -> tuple[np.ndarray, Any, list[np.ndarray | slice]]:
    """Pack the charts of all meshes into one image with xatlas.

    xatlas makes an image of only about the requested size. So charts are packed with fewer and fewer texels per unit of
    length, until all charts fit. If slivers by rounding have huge charts, they are left out, and packing starts again.

    Returns:
        used fractions of width and height, the atlas, and for each mesh the rows of the faces in the atlas.
    """
    import xatlas

    wanted, kept = 0.0, [slice(None) for _ in parts]
    for _ in range(_TRIES):
        atlas = xatlas.Atlas()
        _alive.append(atlas)
        for (vertices, faces), rows in zip(parts, kept, strict=True):
            atlas.add_mesh(vertices, faces[rows])
        options = xatlas.PackOptions()
        options.resolution, options.texels_per_unit, options.padding = 0 if wanted else size, wanted, padding
        atlas.generate(pack_options=options)
        side = max(atlas.width, atlas.height)
        if not side:
            raise ValueError("mesh: got only faces without an area, want at least one face with an area")
        if not wanted and isinstance(kept[0], slice) and _is_spoiled(parts, atlas):
            wide = [np.flatnonzero(find_wide(vertices[faces])) for vertices, faces in parts]
            if any(0 < len(rows) < len(faces) for rows, (_, faces) in zip(wide, parts, strict=True)):
                kept = [rows if len(rows) else slice(None) for rows in wide]
                continue
        if side <= size:
            return np.array((atlas.width, atlas.height)) / size, atlas, kept
        wanted = atlas.texels_per_unit * _SLACK * size / side
    raise ValueError(
        f"size: got {size}, want a larger image: {atlas.chart_count:,} charts, {padding} texels apart, take {side} texels"
    )


def _is_spoiled(parts: list[tuple[np.ndarray, np.ndarray]], atlas: Any) -> bool:
    """Return whether a face is far longer in the image than in space."""
    for i, (vertices, faces) in enumerate(parts):
        _, corners, uv = atlas.get_mesh(i)
        texels = find_longest_edges(uv[corners] * np.float32([atlas.width, atlas.height]))
        if (texels > _STRETCHED * atlas.texels_per_unit * find_longest_edges(vertices[faces])).any():
            return True
    return False


def _add_left_out(
    faces: np.ndarray, kept: np.ndarray | slice, old: np.ndarray, corners: np.ndarray, uv: np.ndarray
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return charts of all faces of a mesh: faces left out have the coordinates of one of their vertices at all corners."""
    left = np.ones(len(faces), np.bool_)
    left[kept] = False
    if not left.any():
        return old, corners, uv
    place = np.full(int(max(faces.max(), old.max(initial=0))) + 1, -1)
    place[old] = np.arange(len(old))
    at = place[faces[left]].max(axis=1)  # any vertex that another face shares
    own = np.where((at >= 0)[:, None], uv[np.maximum(at, 0)], np.float32(0.0)) if len(uv) else np.zeros((len(at), 2), "f4")
    whole = np.empty((len(faces), 3), corners.dtype)
    whole[~left] = corners
    whole[left] = len(old) + np.arange(3 * len(at)).reshape(-1, 3)
    return np.concatenate([old, faces[left].ravel()]), whole, np.concatenate([uv, np.repeat(own, 3, axis=0)])
