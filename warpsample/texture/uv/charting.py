"""Program that unwraps meshes with xatlas into one image; it runs in a separate process because some meshes crash xatlas."""

import os
import sys
from io import BytesIO
from typing import Any, NoReturn

import numpy as np

from warpsample.host.extras import REFUSED

_TRIES = 12
_SLACK = 0.995  # factor on the scale that would just fit, because packing is uneven
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
        share, atlas = _packed(parts, size, padding)
    except ValueError as error:
        _answer(str(error).encode(), REFUSED)
    arrays = {"share": share}
    for i in range(len(parts)):
        old, faces, uv = atlas.get_mesh(i)
        arrays |= {f"old{i}": old, f"f{i}": faces, f"uv{i}": uv}
    stream = BytesIO()
    np.savez(stream, **arrays)
    _answer(stream.getvalue(), 0)


def _answer(content: bytes, status: int) -> NoReturn:
    """Write bytes to standard output and end the process without destroying any atlas."""
    sys.stdout.buffer.write(content)
    sys.stdout.flush()
    os._exit(status)


def _packed(parts: list[tuple[np.ndarray, np.ndarray]], size: int, padding: int) -> tuple[np.ndarray, Any]:
    """Pack the charts of all meshes into one image with xatlas; return (used fractions of width and height, the atlas).

    xatlas makes an image of only about the requested size. So charts are packed with fewer and fewer texels per unit of
    length, until all charts fit.
    """
    import xatlas

    wanted = 0.0
    for _ in range(_TRIES):
        atlas = xatlas.Atlas()
        _alive.append(atlas)
        for vertices, faces in parts:
            atlas.add_mesh(vertices, faces)
        options = xatlas.PackOptions()
        options.resolution, options.texels_per_unit, options.padding = 0 if wanted else size, wanted, padding
        atlas.generate(pack_options=options)
        side = max(atlas.width, atlas.height)
        if not side:
            raise ValueError("mesh: got only faces without an area, want at least one face with an area")
        if side <= size:
            return np.array((atlas.width, atlas.height)) / size, atlas
        wanted = atlas.texels_per_unit * _SLACK * size / side
    raise ValueError(
        f"size: got {size}, want a larger image: {atlas.chart_count:,} charts, {padding} texels apart, take {side} texels"
    )
