"""Positions of the points as a quantity, for maps of positions."""

import numpy as np

from warpsample.estimate.quantities.record import Quantity
from warpsample.estimate.result import ExactResult, PointStatus, status_of
from warpsample.mesh.mesh import Mesh
from warpsample.mesh.surface import SurfacePoints


def vectors_of(points: SurfacePoints, vectors: np.ndarray) -> ExactResult:
    """Wrap (P, 3) vectors of points as a result without errors, in float32; rows of invalid points are 0."""
    status = status_of(points)
    value = np.where((status == int(PointStatus.OK))[:, None], vectors, 0.0).astype(np.float32)
    return ExactResult(value, np.zeros_like(value), np.zeros(len(value), np.int32), status)


def position(
    mesh: Mesh, points: SurfacePoints, *, seed: int = 0, first_point: int = 0, workers: int | None = None
) -> ExactResult:
    """Return the position of each point in mesh coordinates, float32."""
    del mesh, seed, first_point, workers  # nothing is computed
    return vectors_of(points, np.asarray(points.position))


RECORD = Quantity(
    name="position",
    call=position,
    title="positions",
    value="position of the point",
    result=ExactResult,
    shared=(),
    unit="mesh units",
    channels="xyz",
    in_stores=False,
)
