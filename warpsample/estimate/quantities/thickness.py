"""How thick a body is beneath a surface, as a quantity: what glTF's KHR_materials_volume is told."""

from dataclasses import dataclass
from math import inf

import numpy as np

from warpsample.estimate.quantities.record import Quantity
from warpsample.estimate.result import PointStatus, status_of
from warpsample.host.arguments import check_number
from warpsample.host.summary import Summary
from warpsample.host.vectors import as_directions
from warpsample.mesh.mesh import Mesh
from warpsample.mesh.surface import SurfacePoints
from warpsample.tracing.trace import trace


@dataclass(frozen=True, eq=False, repr=False)
class Thickness(Summary):
    """How far it is through a body at P points.

    Attributes:
        value: (P,) float32, in units of the coordinates; 0 where nothing is beneath, and where the status is not 0.
        standard_error: (P,) float32, 0: nothing is drawn at random.
        rays: (P,) int32, 1, or 0 where the status is not 0.
        status: (P,) uint8, a `PointStatus`.
    """

    value: np.ndarray
    standard_error: np.ndarray
    rays: np.ndarray
    status: np.ndarray


def thickness(
    mesh: Mesh,
    points: SurfacePoints,
    *,
    max_distance: float | None = None,
    seed: int = 0,
    first_point: int = 0,
    workers: int | None = None,
) -> Thickness:
    """How far it is to the face that a ray against the normal meets first, at most `max_distance`.

    A ray that meets nothing at all has nothing to go through: there the thickness is 0.
    """
    del seed, first_point  # nothing is random
    most = inf if max_distance is None else check_number(max_distance, "max_distance", 0.0, inf)
    status = status_of(points)
    good = status == int(PointStatus.OK)
    inward = np.where(good[:, None], -as_directions(points.normal), (0.0, 0.0, 1.0)).astype(np.float32)
    distance = trace(mesh, points, inward, workers=workers).distance
    value = np.where(good & np.isfinite(distance), np.minimum(distance, most), 0.0).astype(np.float32)
    return Thickness(value, np.zeros(len(value), np.float32), good.astype(np.int32), status)


RECORD = Quantity(
    name="thickness",
    call=thickness,
    title="thickness",
    value="how far it is through the body, against the normal",
    result=Thickness,
    shared=(),
    unit="mesh units",
    in_stores=False,
)
