"""The sky matrix as a quantity of the command line and of stores."""

from typing import Any

from warpsample.estimate.quantities.record import Numbers, Quantity
from warpsample.host.engine import check_memory
from warpsample.mesh.mesh import Mesh
from warpsample.radiation.sky.patches import sky_patches
from warpsample.radiation.sky.result import SkyMatrix
from warpsample.radiation.sky.sky_matrix import sky_matrix

_COPIES = 2  # the parts, and the whole matrix
_BYTES = 8  # per value and error


def _prepare(mesh: Mesh, total: int, **options: Any) -> Numbers:
    """Return a function that computes the sky matrix, with a row for each surface point.

    Raises:
        MemoryError: the rows of all points need more memory than is free.
    """
    patches = len(sky_patches(options["patches"]))
    what = f"{total:,} rows of {patches:,} patches and their errors"
    check_memory(_COPIES * _BYTES * total * patches, what, "take fewer points, or coarser --patches")
    return lambda points, first: sky_matrix(mesh, points, first_point=first, **options)


RECORD = Quantity(
    name="sky-matrix",
    call=sky_matrix,
    title="sky matrix",
    value="visible part of each patch of the sky, weighted by the cosine; the sum over an open sky is 1",
    result=SkyMatrix,
    shared=("skipped", "patches", "folded"),
    unit="a patch",
    prepare=_prepare,
    in_stores=False,
    is_matrix=True,
)
