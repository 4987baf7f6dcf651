"""Normals of the points as a quantity, for normal maps."""

import numpy as np

from warpsample.estimate.quantities.position import vectors_of
from warpsample.estimate.quantities.record import Quantity
from warpsample.estimate.result import ExactResult
from warpsample.mesh.mesh import Mesh
from warpsample.mesh.surface import SurfacePoints


def surface_normals(
    mesh: Mesh, points: SurfacePoints, *, seed: int = 0, first_point: int = 0, workers: int | None = None
) -> ExactResult:
    """Return the normal of each point as given, in mesh coordinates, float32."""
    del mesh, seed, first_point, workers  # nothing is computed
    return vectors_of(points, np.asarray(points.normal, np.float32))


RECORD = Quantity(
    name="normals",
    call=surface_normals,
    title="normals",
    value="unit normal of the surface; in a .glb, the normal map of a finer mesh",
    result=ExactResult,
    shared=(),
    channels="xyz",
    black=-1.0,
    in_stores=False,
)
