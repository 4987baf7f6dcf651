"""Program that unwraps meshes with xatlas into one image; it runs in a separate process because some meshes crash xatlas."""

import os
import sys
from collections.abc import Iterator
from io import BytesIO
from typing import Any, NoReturn

import numpy as np

from warpsample.host.extras import REFUSED
from warpsample.texture.uv.charts import find_areas, find_longest_edges, find_wide, label_charts

_TRIES = 12
_LARGER_STEPS = 8  # further tries with larger and larger steps: many equal charts, of whole texels, do not shrink otherwise
_DROPPED = 1e-7  # area of the faces that xatlas leaves out
_FULL = 0.9  # of the side of the image
_LONGEST = 16.0  # longest connected part of which xatlas chooses the scale, in sides of a square with the area of all faces
_IMAGE = 1.6  # side of an image by xatlas, in sides of a square with the area of all faces
_SLACK = 0.995  # factor on the scale that would just fit, because packing is uneven
_STRETCHED = 1.5  # longer than in space: faces of flat charts are not stretched, and those of curved ones by up to 1.4
_ROUNDED = 4.0  # texels: charts are rounded up to whole texels
_alive: list[Any] = []  # all atlases: destroying one can wait forever for a thread of xatlas


def main(size: int, padding: int) -> NoReturn:
    """Read meshes from standard input, unwrap the meshes, write charts to standard output, as .npz archives, and exit.

    The input has vertices and faces of each mesh: "v0", "f0", "v1", ... The output has "share", the (2,) used fractions of
    the image's width and height, and for each mesh "old0", the original vertex of each new vertex, "uv0", texture
    coordinates in the used part of the image, and "f0", the new faces.
    """
    output = os.dup(1)
    os.dup2(os.open(os.devnull, os.O_WRONLY), 1)  # xatlas prints failed assertions to standard output
    given = np.load(BytesIO(sys.stdin.buffer.read()))
    parts = [(given[f"v{i}"], given[f"f{i}"]) for i in range(len(given.files) // 2)]
    try:
        share, atlas, kept = _packed(parts, size, padding)
    except ValueError as error:
        _answer(output, str(error).encode(), REFUSED)
    arrays = {"share": share}
    for i, ((_, faces), rows, made) in enumerate(zip(parts, kept, _read_meshes(atlas, kept), strict=True)):
        old, corners, uv = _add_left_out(faces, rows, *made)
        arrays |= {f"old{i}": old, f"f{i}": corners, f"uv{i}": uv}
    stream = BytesIO()
    np.savez(stream, **arrays)
    _answer(output, stream.getvalue(), 0)


def _answer(output: int, content: bytes, status: int) -> NoReturn:
    """Write bytes to an open file and end the process without destroying any atlas."""
    with os.fdopen(output, "wb") as stream:
        stream.write(content)
    os._exit(status)


def _packed(parts: list[tuple[np.ndarray, np.ndarray]], size: int, padding: int) -> tuple[np.ndarray, Any, list[np.ndarray]]:
    """Pack the charts of all meshes into one image with xatlas.

    xatlas makes an image of only about the requested size. So charts are packed with fewer and fewer texels per unit of
    length, until all charts fit. If slivers by rounding have huge charts, they are left out, and packing starts again: first
    without slivers that are connected to other faces, then without any. Wires alone begin small, and grow until they fit.

    Returns:
        used fractions of width and height, the atlas, and for each mesh the rows of the faces in the atlas.
    """
    import xatlas

    wanted, longest = _plan(parts, size)
    choices = _list_choices(parts, longest)
    slack, tries, kept = _SLACK, 0, next(choices)
    while tries < _TRIES + _LARGER_STEPS:
        atlas = xatlas.Atlas()
        _alive.append(atlas)
        for (vertices, faces), rows in zip(parts, kept, strict=True):
            if len(rows):
                atlas.add_mesh(vertices, faces[rows])
        options = xatlas.PackOptions()
        options.resolution, options.texels_per_unit, options.padding = 0 if wanted else size, wanted, padding
        atlas.generate(pack_options=options)
        side = max(atlas.width, atlas.height)
        if not side:
            raise ValueError("mesh: got only faces without an area, want at least one face with an area")
        if not tries and _is_spoiled(parts, kept, atlas) and (fewer := next(choices, None)) is not None:
            kept = fewer
            continue
        if side <= size and (not wanted or side >= _FULL * size or tries >= _TRIES):
            return np.array((atlas.width, atlas.height)) / size, atlas, kept
        tries += 1
        slack = _SLACK if tries <= _TRIES else slack**2
        wanted = atlas.texels_per_unit * slack * size / side
    raise ValueError(
        f"size: got {size}, want a larger image: {atlas.chart_count:,} charts, {padding} texels apart, take {side} texels"
    )


def _plan(parts: list[tuple[np.ndarray, np.ndarray]], size: int) -> tuple[float, float]:
    """Return the texels per unit of length to begin with, and the length of the longest sliver to keep.

    The scale 0 leaves the choice to xatlas, which goes by the area alone. Wires alone have so little area that charts would
    be tens or millions of times as long as the image. Slivers count only if there are no other faces; longer than the
    image, and than all connected other faces, they would shrink all charts.
    """
    corners = np.concatenate([vertices[faces] for vertices, faces in parts]).astype(np.float64)
    wide, areas = find_wide(corners), find_areas(corners)
    counted = wide if wide.any() else areas > _DROPPED
    side = np.sqrt(areas[counted].sum())
    if np.linalg.norm(np.ptp(corners, axis=(0, 1))) <= _IMAGE * side:
        return 0.0, np.inf
    longest = _find_longest_part(corners[counted])
    scale = 2.0 * size / longest if longest > _LONGEST * side else 0.0
    return scale, max(longest, _IMAGE * side) if wide.any() else np.inf


def _find_longest_part(corners: np.ndarray) -> float:
    """Return the largest diagonal of the bounding boxes of connected faces (F, 3, 3); 0 without faces."""
    if not len(corners):
        return 0.0
    label = label_charts(corners)
    order = np.argsort(label, kind="stable")
    starts = np.flatnonzero(np.diff(label[order], prepend=-1))
    low = np.minimum.reduceat(corners.min(axis=1)[order], starts)
    high = np.maximum.reduceat(corners.max(axis=1)[order], starts)
    return float(np.linalg.norm(high - low, axis=1).max())


def _list_choices(parts: list[tuple[np.ndarray, np.ndarray]], longest: float) -> Iterator[list[np.ndarray]]:
    """Yield rows of faces to give to xatlas: all; without slivers connected to other faces; and without any slivers.

    All are without slivers longer than `longest`.
    """
    corners = [vertices[faces] for vertices, faces in parts]
    wide = [find_wide(own) for own in corners]
    short = [own_wide | (find_longest_edges(own) <= longest) for own, own_wide in zip(corners, wide, strict=True)]
    yield [np.flatnonzero(own) for own in short]
    if all(own.all() for own in wide) or not any(own.any() for own in wide):
        return
    kept = []
    for own, own_wide, own_short in zip(corners, wide, short, strict=True):
        label = label_charts(own.astype(np.float64))
        kept.append(np.flatnonzero(own_wide | (own_short & (np.bincount(label, own_wide) == 0)[label])))
    yield kept
    yield [np.flatnonzero(own) for own in wide]


def _read_meshes(atlas: Any, kept: list[np.ndarray]) -> Iterator[tuple[np.ndarray, np.ndarray, np.ndarray]]:
    """Yield the old vertices, the corners and the coordinates of each mesh; empty for a mesh without faces in the atlas."""
    number = 0
    for rows in kept:
        if len(rows):
            yield atlas.get_mesh(number)
            number += 1
        else:
            yield np.zeros(0, np.uint32), np.zeros((0, 3), np.uint32), np.zeros((0, 2), np.float32)


def _is_spoiled(parts: list[tuple[np.ndarray, np.ndarray]], kept: list[np.ndarray], atlas: Any) -> bool:
    """Return whether a sliver is longer in the image than in space, by more than charts are rounded up to whole texels."""
    for (vertices, faces), rows, (_, corners, uv) in zip(parts, kept, _read_meshes(atlas, kept), strict=True):
        texels = find_longest_edges(uv[corners] * np.float32([atlas.width, atlas.height]))
        expected = atlas.texels_per_unit * find_longest_edges(vertices[faces[rows]])
        if ((texels > _STRETCHED * expected + _ROUNDED) & ~find_wide(vertices[faces[rows]])).any():
            return True
    return False


def _add_left_out(
    faces: np.ndarray, kept: np.ndarray, old: np.ndarray, corners: np.ndarray, uv: np.ndarray
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return charts of all faces of a mesh: a face left out has the coordinates of one of its vertices, or 0."""
    left = np.ones(len(faces), np.bool_)
    left[kept] = False
    if not left.any():
        return old, corners, uv
    place = np.zeros(int(faces.max()) + 1, np.int64)
    place[old] = 1 + np.arange(len(old))
    at = place[faces[left]].max(axis=1)  # any vertex that another face shares
    own = np.concatenate([np.zeros((1, 2), np.float32), uv])[at]
    whole = np.empty((len(faces), 3), np.uint32)
    whole[~left] = corners
    whole[left] = len(old) + np.arange(3 * len(at)).reshape(-1, 3)
    return np.concatenate([old, faces[left].ravel()]), whole, np.concatenate([uv, np.repeat(own, 3, axis=0)])
