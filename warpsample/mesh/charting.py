"""What a process of its own does with xatlas, which some meshes crash: charts of meshes, packed into one image."""

import sys
from io import BytesIO
from typing import Any

import numpy as np

from warpsample.host.extras import REFUSED

_TRIES = 12
_SLACK = 0.995  # by which a try is smaller than what would just fit: packing is uneven


def main(size: int, padding: int) -> None:
    """Reads vertices and faces of meshes as "v0", "f0", "v1" ... in an .npz, and writes their charts as another.

    It has the share of the image that is taken, (2,), and for each mesh the old vertices of its new ones, their coordinates
    in that share and the new faces, "old0", "uv0", "f0".
    """
    given = np.load(BytesIO(sys.stdin.buffer.read()))
    parts = [(given[f"v{i}"], given[f"f{i}"]) for i in range(len(given.files) // 2)]
    try:
        share, atlas = _packed(parts, size, padding)
    except ValueError as error:
        sys.stdout.buffer.write(str(error).encode())
        sys.stdout.flush()
        sys.exit(REFUSED)
    arrays = {"share": share}
    for i in range(len(parts)):
        old, faces, uv = atlas.get_mesh(i)
        arrays |= {f"old{i}": old, f"f{i}": faces, f"uv{i}": uv}
    np.savez(sys.stdout.buffer, **arrays)


def _packed(parts: list[tuple[np.ndarray, np.ndarray]], size: int, padding: int) -> tuple[np.ndarray, Any]:
    """The share of an image that charts take, and the atlas.

    The library makes an image of about the size that it is asked for; so it is asked for ever fewer texels of a unit of
    length, until all charts fit.
    """
    import xatlas

    wanted = 0.0
    for _ in range(_TRIES):
        atlas = xatlas.Atlas()
        for vertices, faces in parts:
            atlas.add_mesh(vertices, faces)
        options = xatlas.PackOptions()
        options.resolution, options.texels_per_unit, options.padding = 0 if wanted else size, wanted, padding
        atlas.generate(pack_options=options)
        side = max(atlas.width, atlas.height)
        if not side:
            raise ValueError("mesh: got faces without an area, want at least one that has some")
        if side <= size:
            return np.array((atlas.width, atlas.height)) / size, atlas
        wanted = atlas.texels_per_unit * _SLACK * size / side
    raise ValueError(
        f"size: got {size}, where {atlas.chart_count:,} charts, {padding} texels apart, take {side} texels, want more"
    )
