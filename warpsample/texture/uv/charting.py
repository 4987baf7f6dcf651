"""Program that unwraps meshes with xatlas into one image; it runs in a separate process because some meshes crash xatlas."""

import os
import sys
from collections.abc import Iterator
from io import BytesIO
from typing import Any, NoReturn

import numpy as np

from warpsample.host.extras import REFUSED
from warpsample.texture.uv.charts import find_areas, find_longest_edges, find_longest_part, find_wide, label_charts
from warpsample.texture.uv.pieces import NO_CHARTS, MeshCharts, add_left_out

_TRIES = 12
_LARGER_STEPS = 8  # further tries with larger and larger steps: many equal charts, of whole texels, do not shrink otherwise
_LAST = _TRIES + _LARGER_STEPS
_DROPPED = 1e-7  # area of the faces that xatlas leaves out
_FULL = 0.9  # of the side of the image
_LONGEST = 16.0  # longest connected part of which xatlas chooses the scale, in sides of a square with the area of all faces
_COMPACT = 1.5  # longest connected part that needs no small image first, in such sides: a square has 1.4, a long house 1.6
_SMALL = 64  # side of the small image
_FAR = 6.0  # small images whose charts begin small: with many charts of a texel, up to 3 are usual
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
        old, corners, uv = add_left_out(faces, rows, *made)
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
    choices = list(_list_choices(parts))
    if small := _small_scale(parts):
        _pack_unspoiled(parts, choices, size, small, padding)
    wanted = _first_scale(parts, choices[0], size)
    atlas = _pack_unspoiled(parts, choices, size, wanted, padding)
    kept = choices[0]
    slack = _SLACK
    for tries in range(_LAST):
        side = max(atlas.width, atlas.height)
        if side <= size and (not wanted or side >= _FULL * size or tries >= _TRIES):
            return np.array((atlas.width, atlas.height)) / size, atlas, kept
        slack = _SLACK if tries < _TRIES else slack**2
        wanted = atlas.texels_per_unit * slack * size / side
        atlas = _pack(parts, kept, size, wanted, padding, is_square=tries + 1 == _LAST)
    if atlas.atlas_count == 1:  # a sliver can stay longer than the image at any scale; in a square, it is shrunk
        return np.array((atlas.width, atlas.height)) / size, atlas, kept
    raise ValueError(
        f"size: got {size}, want a larger image: {atlas.chart_count:,} charts, {padding} texels apart, take {side} texels"
    )


def _pack_unspoiled(
    parts: list[tuple[np.ndarray, np.ndarray]], choices: list[list[np.ndarray]], size: int, scale: float, padding: int
) -> Any:
    """Return an atlas of the first of the choices without huge charts, and remove those before it from the list."""
    atlas = _pack(parts, choices[0], size, scale, padding)
    while len(choices) > 1 and _is_spoiled(parts, choices[0], atlas):
        del choices[0]
        atlas = _pack(parts, choices[0], size, scale, padding)
    return atlas


def _pack(
    parts: list[tuple[np.ndarray, np.ndarray]],
    kept: list[np.ndarray],
    size: int,
    scale: float,
    padding: int,
    *,
    is_square: bool = False,
) -> Any:
    """Return an atlas of some faces with `scale` texels per unit of length; 0 takes the scale by which `size` about fits.

    Images have any sides, of the least area; or they are square, of this size, and as many as needed.

    Raises:
        ValueError: xatlas takes none of the faces.
    """
    import xatlas

    atlas = xatlas.Atlas()
    _alive.append(atlas)
    for (vertices, faces), rows in zip(parts, kept, strict=True):
        if len(rows):
            atlas.add_mesh(vertices, faces[rows])
    options = xatlas.PackOptions()
    options.resolution, options.texels_per_unit, options.padding = 0 if scale and not is_square else size, scale, padding
    atlas.generate(pack_options=options)
    if not atlas.width:
        raise ValueError("mesh: got only faces without an area, want at least one face with an area")
    return atlas


def _small_scale(parts: list[tuple[np.ndarray, np.ndarray]]) -> float:
    """Return the texels per unit of length for an image of a texel, if there are slivers among other faces, or 0.

    Charts of slivers may be millions of times as long as all else, and end xatlas: they are found in a small image.
    """
    corners = np.concatenate([vertices[faces] for vertices, faces in parts]).astype(np.float64)
    wide = find_wide(corners)
    return 0.0 if wide.all() or not wide.any() else float(1.0 / np.sqrt(find_areas(corners[wide]).sum()))


def _first_scale(parts: list[tuple[np.ndarray, np.ndarray]], kept: list[np.ndarray], size: int) -> float:
    """Return the texels per unit of length to begin with; 0 leaves the choice to xatlas, which goes by the area alone.

    Thin parts alone have so little area that charts would be tens or millions of times as long as the image. Slivers count
    only if there are no other faces. Of thin parts in rings or coils, a small image tells how long their charts are.
    """
    corners = np.concatenate([vertices[faces] for vertices, faces in parts]).astype(np.float64)
    wide, areas = find_wide(corners), find_areas(corners)
    counted = wide if wide.any() else areas > _DROPPED
    side = np.sqrt(areas[counted].sum())
    longest = find_longest_part(corners[counted], _COMPACT * side)
    if longest > _LONGEST * side or not longest:
        return 2.0 * size / longest if longest else 0.0
    atlas = _pack(parts, kept, _SMALL, 0.0, 0)
    reached = max(atlas.width, atlas.height)
    return 2.0 * atlas.texels_per_unit * size / reached if reached > _FAR * _SMALL else 0.0


def _list_choices(parts: list[tuple[np.ndarray, np.ndarray]]) -> Iterator[list[np.ndarray]]:
    """Yield rows of faces to give to xatlas: all; without slivers connected to other faces; and without any slivers."""
    wide = [find_wide(vertices[faces]) for vertices, faces in parts]
    yield [np.arange(len(own)) for own in wide]
    if all(own.all() for own in wide) or not any(own.any() for own in wide):
        return
    kept = []
    for (vertices, faces), own in zip(parts, wide, strict=True):
        label = label_charts(vertices[faces].astype(np.float64))
        kept.append(np.flatnonzero(own | (np.bincount(label, own) == 0)[label]))
    yield kept
    yield [np.flatnonzero(own) for own in wide]


def _read_meshes(atlas: Any, kept: list[np.ndarray]) -> Iterator[MeshCharts]:
    """Yield the old vertices, the corners and the coordinates of each mesh; empty for a mesh without faces in the atlas."""
    number = 0
    for rows in kept:
        if len(rows):
            yield atlas.get_mesh(number)
            number += 1
        else:
            yield NO_CHARTS


def _is_spoiled(parts: list[tuple[np.ndarray, np.ndarray]], kept: list[np.ndarray], atlas: Any) -> bool:
    """Return whether a sliver is longer in the image than in space, by more than charts are rounded up to whole texels."""
    for (vertices, faces), rows, (_, corners, uv) in zip(parts, kept, _read_meshes(atlas, kept), strict=True):
        texels = find_longest_edges(uv[corners] * np.float32([atlas.width, atlas.height]))
        expected = atlas.texels_per_unit * find_longest_edges(vertices[faces[rows]])
        if ((texels > _STRETCHED * expected + _ROUNDED) & ~find_wide(vertices[faces[rows]])).any():
            return True
    return False
