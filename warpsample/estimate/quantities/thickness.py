"""Thickness of a body beneath the surface, as used by glTF's KHR_materials_volume."""

from dataclasses import dataclass
from typing import Any

import numpy as np

from warpsample.estimate.plan import reach_of
from warpsample.estimate.quantities.record import Quantity
from warpsample.estimate.result import ExactResult, PointStatus, status_of
from warpsample.host.engine import check_workers
from warpsample.host.options import CallOptions
from warpsample.host.vectors import as_directions
from warpsample.mesh.mesh import Mesh, as_mesh
from warpsample.mesh.surface import SurfacePoints
from warpsample.tracing.placed_points import PlacedPoints
from warpsample.tracing.placement import OFFSET
from warpsample.tracing.scene import coarseness_of, scene_of
from warpsample.tracing.trace import Hits, trace

_BLOCK = 1 << 16  # points at a time
_STEPS = 4.0  # steps off a face, the largest along an axis; the step at a corner is longer than that off a plane


@dataclass(frozen=True, eq=False, repr=False)
class Thickness(ExactResult):
    """Thickness of a body at P points, in mesh units.

    The fields are `value`, `standard_error` (0, because nothing is random), `rays` and `status`, each (P,).
    """


def thickness(
    mesh: Any,
    points: SurfacePoints,
    *,
    max_distance: float | None = None,
    seed: int = 0,
    first_point: int = 0,
    workers: int | None = None,
) -> Thickness:
    """Measure the thickness of a body at each point: the distance against the normal to the first face.

    A sheet encloses no body, even with two layers at the same place: its value is the distance to the face behind it. So is
    that of a wall thinner than two millionths of the mesh's extent, the step off the face at which rays start. Light that
    passes faces changes nothing.

    `mean_distance` with normals inward is the mean over a lobe in place of this single ray.

    Args:
        mesh: Mesh or anything that `as_mesh` accepts.
        points: P SurfacePoints.
        max_distance: Largest thickness to return, a float in mesh units. Default: None, no limit.
        seed: Random seed, an integer of 64 bits. Default: 0. Has no effect: nothing is random.
        first_point: Global id of row 0, an integer; 0 for points with an `id`. Default: 0. Has no effect: nothing is random.
        workers: Number of CPU threads, an integer. Default: None, the value of WARPSAMPLE_WORKERS or all cores.

    Returns:
        value (P,) from 0 to `max_distance` in mesh units, 0 where the ray hits nothing, and a status for each point.

    Raises:
        TypeError, ValueError: an argument that cannot be used; names it, what it got and what it wants.
        MemoryError: more than is free.

    Example:
        >>> slab = ws.Mesh([[0, 0, 0], [3, 0, 0], [0, 3, 0], [0, 0, 2], [3, 0, 2], [0, 3, 2]], [[0, 2, 1], [3, 4, 5]])
        >>> print(ws.thickness(slab, ws.face_centers(slab)).value.round(3))
        [2. 2.]
    """
    mesh = as_mesh(mesh)
    CallOptions.of(
        len(PlacedPoints.of(mesh, points)), seed=seed, first_point=first_point
    )  # raises errors alone: nothing is random
    most, status = reach_of(max_distance), status_of(points)
    good = status == int(PointStatus.OK)
    inward = np.where(good[:, None], -as_directions(points.normal), (0.0, 0.0, 1.0)).astype(np.float32)
    if mesh.transmits:
        scene_of(mesh.like or mesh, through=True).tree(check_workers(workers))  # the copy shares this tree
        mesh = as_mesh(mesh, transmittance=0.0)
    hits = trace(mesh, points, inward, workers=workers)
    distance = _exact_distances(mesh, points, inward, hits)
    value = np.where(good & np.isfinite(distance), np.minimum(distance, most), 0.0).astype(np.float32)
    return Thickness(value, np.zeros(len(value), np.float32), good.astype(np.int32), status)


def _exact_distances(mesh: Mesh, points: SurfacePoints, directions: np.ndarray, hits: Hits) -> np.ndarray:
    """Return distances from points to the planes of hit faces, (P,), in float64.

    Rays start a step inside of their face, which is much for thin walls in a large mesh, and for faces nearly parallel to
    the ray. The distance stays the ray's if the plane is met outside the face, and more than such steps away from the hit.
    """
    scene, found = scene_of(mesh, through=True), hits.distance.astype(np.float64)
    position = np.asarray(points.position)
    coarseness = coarseness_of(scene, position.dtype == np.float64)
    step = _STEPS * (OFFSET * float(scene.extent.max()) + coarseness) / scene.scale
    for start in range(0, len(found), _BLOCK):
        rows = start + np.flatnonzero(hits.face[start : start + _BLOCK] >= 0)
        face, way = hits.face[rows], directions[rows].astype(np.float64)
        way /= np.linalg.norm(way, axis=1, keepdims=True)
        normal, corners, origin = mesh.cross_products[face], mesh.vertices[mesh.faces[face]], position[rows]
        with np.errstate(divide="ignore", invalid="ignore"):
            exact = (normal * (corners[:, 0] - origin)).sum(axis=1) / (normal * way).sum(axis=1)
            met = (exact > 0.0) & _are_inside(corners, normal, origin + exact[:, None] * way)
        found[rows] = np.where(met | (np.abs(exact - found[rows]) <= step), np.maximum(exact, 0.0), found[rows])
    return found


def _are_inside(corners: np.ndarray, normals: np.ndarray, points: np.ndarray) -> np.ndarray:
    """Return whether points (N, 3), in the planes of triangles (N, 3, 3), are inside the triangles, (N,)."""
    edges = np.roll(corners, -1, axis=1) - corners
    return ((np.cross(edges, points[:, None] - corners) * normals[:, None]).sum(axis=2) >= 0.0).all(axis=1)


RECORD = Quantity(
    name="thickness",
    call=thickness,
    title="thickness",
    value="distance through the body, against the normal",
    result=Thickness,
    shared=(),
    unit="mesh units",
    in_stores=False,
)
