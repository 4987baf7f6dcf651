"""Where points are, and which way they face, as quantities: maps of a surface itself."""

from dataclasses import dataclass

import numpy as np

from warpsample.estimate.quantities.record import Quantity
from warpsample.estimate.result import PointStatus, status_of
from warpsample.host.summary import Summary
from warpsample.mesh.mesh import Mesh
from warpsample.mesh.surface import SurfacePoints


@dataclass(frozen=True, eq=False, repr=False)
class OwnVectors(Summary):
    """Vectors that P points have of themselves.

    Attributes:
        value: (P, 3) float32; 0 where the status is not 0.
        standard_error: (P, 3) float32, 0: they are known.
        rays: (P,) int32, 0.
        status: (P,) uint8, a `PointStatus`.
    """

    value: np.ndarray
    standard_error: np.ndarray
    rays: np.ndarray
    status: np.ndarray

    @classmethod
    def of(cls, points: SurfacePoints, vectors: np.ndarray) -> "OwnVectors":
        """Vectors (P, 3) of points."""
        status = status_of(points)
        value = np.where((status == int(PointStatus.OK))[:, None], vectors, 0.0).astype(np.float32)
        return cls(value, np.zeros_like(value), np.zeros(len(value), np.int32), status)


def position(
    mesh: Mesh, points: SurfacePoints, *, seed: int = 0, first_point: int = 0, workers: int | None = None
) -> OwnVectors:
    """Where each point is, in the coordinates of the mesh, by float32."""
    del mesh, seed, first_point, workers  # nothing is computed
    return OwnVectors.of(points, np.asarray(points.position))


RECORD = Quantity(
    name="position",
    call=position,
    title="positions",
    value="where it is",
    result=OwnVectors,
    shared=(),
    unit="mesh units",
    channels="xyz",
    in_stores=False,
)
