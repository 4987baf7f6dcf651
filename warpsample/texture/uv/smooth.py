"""Division of smooth surfaces, because xatlas takes any chain of nearly coplanar faces for a plane and projects it."""

import numpy as np

from warpsample.texture.uv.charts import connect_nodes, find_neighbours

_COPLANAR = 1.1e-4  # 1 - cosine of two neighbours' normals: for xatlas, neighbours below 1e-4 are coplanar
_FLAT = 1e-9  # 1 - cosine with the mean normal, of faces of a plane by rounding in float32
_TURNED = 0.866  # least cosine with the mean normal, 30 degrees, of surfaces that are not divided by direction
_NEAR = 0.94  # least cosine of a side's first face with the axis, 20 degrees
_WEIGHTS = 1.0, 0.97, 0.94  # of the axes, so that a wall at 45 degrees is on one side in spite of rounding


def divide_smooth(corners: np.ndarray, numbers: np.ndarray) -> list[np.ndarray]:
    """Return rows of faces in groups for xatlas: smooth surfaces that turn, by direction, and all other faces together.

    xatlas projects a plane along the normal of its first face. Of a tube with 600 sides, the front lay on the back. So
    surfaces that turn are divided by the axis nearest to the normals. The face nearest to the axis, or to the mean normal
    of a surface that does not turn, comes first.

    Args:
        corners: (F, 3, 3) positions of the corners of each face.
        numbers: (F, 3) numbers of the corners; equal positions have equal numbers.
    """
    normals = _find_normals(corners)
    rows = np.flatnonzero(normals.any(axis=1))
    pairs = rows[find_neighbours(numbers[rows])]
    pairs = pairs[:, (normals[pairs[0]] * normals[pairs[1]]).sum(axis=1) > 1.0 - _COPLANAR]
    label = connect_nodes(pairs[0], pairs[1], len(corners))
    mean = np.column_stack([np.bincount(label, own) for own in normals.T])
    mean /= np.maximum(np.linalg.norm(mean, axis=1), np.finfo(np.float64).tiny)[:, None]
    closeness, least = (normals * mean[label]).sum(axis=1), np.ones(len(mean))
    np.minimum.at(least, label[rows], closeness[rows])
    is_bent = (least < 1.0 - _FLAT)[label]
    if not is_bent.any():
        return [np.arange(len(corners))]
    side = np.zeros(len(corners), np.int64)
    turned = np.flatnonzero((least < _TURNED)[label])
    side[turned], closeness[turned] = _find_sides(normals[turned], label[turned])
    best = np.zeros(len(corners))
    np.maximum.at(best, label, closeness)
    key = np.where(side > 0, -closeness, (closeness < best[label]) | ~is_bent)  # other faces keep their order
    order = np.lexsort((key, label * (side > 0), side))
    return np.split(order, np.flatnonzero(np.diff(side[order])) + 1)


def _find_sides(normals: np.ndarray, label: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return the side of each face, 1 to 30, and how close its normal is to the middle of the side.

    Sides 1 to 6 are about an axis. If no face of a surface is near this axis, as on a cone of 43 degrees, its faces are
    divided by the second nearest axis, too.

    Args:
        normals: (F, 3) normals.
        label: (F,) number of each face's surface.
    """
    axes = np.argsort(-np.abs(normals) * _WEIGHTS, axis=1)
    ahead = np.take_along_axis(normals, axes, axis=1)
    side, second = 2 * axes[:, :2].T + (ahead[:, :2].T < 0.0)
    surface, own = np.unique(6 * label + side, return_inverse=True)
    closest = np.zeros(len(surface))
    np.maximum.at(closest, own, np.abs(ahead[:, 0]))
    is_far = (closest < _NEAR)[own]
    return 1 + side + 6 * (1 + second) * is_far, np.abs(ahead[:, 0]) + np.abs(ahead[:, 1]) * is_far


def _find_normals(corners: np.ndarray) -> np.ndarray:
    """Return the normals of faces, (F, 3), or 0 for faces without an area."""
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    return normals / np.maximum(np.linalg.norm(normals, axis=1), np.finfo(np.float64).tiny)[:, None]
