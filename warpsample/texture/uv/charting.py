"""Program that unwraps meshes with xatlas into one image; it runs in a separate process because some meshes crash xatlas."""

import os
import sys
from io import BytesIO
from typing import NoReturn

import numpy as np

from warpsample.host.extras import REFUSED
from warpsample.texture.uv.charts import add_left_out
from warpsample.texture.uv.cutting import cut_meshes, separate_overlaps
from warpsample.texture.uv.packing import pack_charts


def main(size: int, padding: int) -> NoReturn:
    """Read meshes from standard input, unwrap the meshes, write charts to standard output, as .npz archives, and exit.

    The input has vertices and faces of each mesh: "v0", "f0", "v1", ... The output has for each mesh "old0", the original
    vertex of each new vertex, "uv0", texture coordinates from 0 to 1, and "f0", the new faces.
    """
    output = os.dup(1)
    os.dup2(os.open(os.devnull, os.O_WRONLY), 1)  # xatlas prints failed assertions to standard output
    given = np.load(BytesIO(sys.stdin.buffer.read()))
    meshes = [(given[f"v{i}"], given[f"f{i}"]) for i in range(len(given.files) // 2)]
    try:
        cut = separate_overlaps(cut_meshes(meshes, size, padding), size, padding)
        uv, is_packed = pack_charts(cut.charts, size, padding)
    except ValueError as error:
        _answer(output, str(error).encode(), REFUSED)
    arrays, packed = {}, np.flatnonzero(is_packed)
    starts = np.searchsorted(cut.mesh[packed], np.arange(len(meshes) + 1))
    for i, (_, faces) in enumerate(meshes):
        own = packed[starts[i] : starts[i + 1]]
        vertex, corners = np.unique(cut.charts.faces[own], return_inverse=True)
        made = add_left_out(faces, cut.row[own], cut.old[vertex], corners.reshape(-1, 3), uv[vertex])
        arrays |= dict(zip((f"old{i}", f"f{i}", f"uv{i}"), made, strict=True))
    stream = BytesIO()
    np.savez(stream, **arrays)
    _answer(output, stream.getvalue(), 0)


def _answer(output: int, content: bytes, status: int) -> NoReturn:
    """Write bytes to an open file and end the process without destroying any atlas."""
    with os.fdopen(output, "wb") as stream:
        stream.write(content)
    os._exit(status)
