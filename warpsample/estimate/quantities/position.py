"""Positions of the points as a quantity, for maps of positions."""

import numpy as np

from warpsample.estimate.quantities.record import Quantity
from warpsample.estimate.result import ExactResult, PointStatus, status_of
from warpsample.mesh.mesh import Mesh
from warpsample.mesh.surface import SurfacePoints


def vectors_of(points: SurfacePoints, vectors: np.ndarray) -> ExactResult:
    """Wrap (P, 3) vectors of points as a result without errors, of the same type; rows of invalid points are 0."""
    status = status_of(points)
    value = np.where((status == int(PointStatus.OK))[:, None], vectors, vectors.dtype.type(0.0))
    return ExactResult(value, np.zeros(value.shape, np.float32), np.zeros(len(value), np.int32), status)


def position(
    mesh: Mesh, points: SurfacePoints, *, seed: int = 0, first_point: int = 0, workers: int | None = None
) -> ExactResult:
    """Return the position of each point in mesh coordinates, float64: float32 has only 7 digits, too few for a map."""
    del mesh, seed, first_point, workers  # nothing is computed
    return vectors_of(points, np.asarray(points.position, np.float64))


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
