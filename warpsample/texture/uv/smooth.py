"""Division of smooth surfaces, because xatlas takes any chain of nearly coplanar faces for a plane and projects it."""

import numpy as np

from warpsample.mesh.mesh import Mesh
from warpsample.texture.uv.charts import connect_nodes
from warpsample.tracing.trace_all import trace_all

_COPLANAR = 1.1e-4  # 1 - cosine of two neighbours' normals: for xatlas, neighbours below 1e-4 are coplanar
_FLAT = 1e-9  # 1 - cosine with the mean normal, of faces of a plane by rounding in float32
_TURNED = 0.866  # least cosine with the mean normal, 30 degrees, of surfaces that are not divided by direction
_NEAR = 0.94  # least cosine of a side's first face with the axis, 20 degrees
_WEIGHTS = 1.0, 0.97, 0.94  # of the axes, so that a wall at 45 degrees is on one side in spite of rounding
_ROUNDS = 8  # times that surfaces are divided by layers; three were enough for all ramps and springs that were tried
_CORNER = 1e-4  # barycentric distance of points from the corners of their face
_SAMPLES = np.concatenate([np.full((1, 3), 1 / 3), np.eye(3) * (1 - 3 * _CORNER) + _CORNER])
"""Barycentric coordinates of the points of a face that have to be above no other face."""
_APART = 1e-6  # of the mesh's diagonal: least distance between two layers
_BLOCK = 1 << 16  # faces whose rays are traced at once


def divide_smooth(corners: np.ndarray, numbers: np.ndarray) -> list[np.ndarray]:
    """Return rows of faces in groups for xatlas: smooth surfaces in parts that a projection shows once, and all other faces.

    xatlas projects a plane along the normal of its first face. Of a tube with 600 sides, the front lay on the back, and of
    a spiral ramp, all turns lay on each other. So surfaces that turn are divided by the axis nearest to the normals. Then
    surfaces with parts above each other are divided by layers. The face nearest to the axis, or to the mean normal of a
    surface that does not turn, comes first.

    Args:
        corners: (F, 3, 3) positions of the corners of each face.
        numbers: (F, 3) numbers of the corners; equal positions have equal numbers.
    """
    normals = _find_normals(corners)
    rows = np.flatnonzero(normals.any(axis=1))
    pairs = rows[_find_neighbours(numbers[rows])]
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
    group = _divide_layers(corners, normals, pairs, order, np.where(is_bent, side, -1))
    order = order[np.lexsort((group[order], side[order]))]
    return np.split(order, np.flatnonzero(np.diff(side[order]) | np.diff(group[order])) + 1)


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


def _divide_layers(
    corners: np.ndarray, normals: np.ndarray, pairs: np.ndarray, order: np.ndarray, side: np.ndarray
) -> np.ndarray:
    """Return a group for each face, (F,), such that no face lies above another one of its connected part of a group.

    A layer is the number of faces of the same part that a face lies above. Layers next to each other have different groups.

    Args:
        corners: (F, 3, 3) positions of the corners of each face.
        normals: (F, 3) normals.
        pairs: (2, E) nearly coplanar neighbours.
        order: (F,) order of faces for xatlas; a part is projected along the normal of its first face.
        side: (F,) direction by which faces are divided already, or -1 for faces of planes, which have no layers.
    """
    group, place = np.zeros(len(corners), np.int64), np.argsort(order)
    left = np.flatnonzero(side >= 0)
    for _ in range(_ROUNDS):
        a, b = pairs[:, (side[pairs[0]] == side[pairs[1]]) & (group[pairs[0]] == group[pairs[1]])]
        part = connect_nodes(a, b, len(corners))
        first = np.full(len(corners), len(corners))
        np.minimum.at(first, part, place)
        layer = _count_below(corners[left], part[left], normals[order[first[part[left]]]])
        if not layer.any():
            break
        group *= 2
        group[left] += layer % 2
        left = left[np.isin(part[left], part[left[layer > 0]])]
    return group


def _count_below(corners: np.ndarray, part: np.ndarray, axis: np.ndarray) -> np.ndarray:
    """Return the largest number of faces of its own part that each face lies above, (F,), along an axis for each face."""
    vertices, count = corners.reshape(-1, 3), len(corners)
    mesh, below = Mesh(vertices, np.arange(3 * count).reshape(-1, 3)), np.zeros(count, np.int64)
    nearest = _APART * float(np.linalg.norm(np.ptp(vertices, axis=0)))
    for start in range(0, count, _BLOCK):
        block = slice(start, start + _BLOCK)
        origins = (_SAMPLES @ corners[block]).reshape(-1, 3)
        hits = trace_all(mesh, origins, -np.repeat(axis[block], len(_SAMPLES), axis=0))
        ray = np.repeat(np.arange(len(origins)), np.diff(hits.first))
        own = start + ray // len(_SAMPLES)
        is_below = (part[hits.face] == part[own]) & (hits.face != own) & (hits.distance > nearest)
        below[block] = np.bincount(ray[is_below], minlength=len(origins)).reshape(-1, len(_SAMPLES)).max(axis=1)
    return below


def _find_normals(corners: np.ndarray) -> np.ndarray:
    """Return the normals of faces, (F, 3), or 0 for faces without an area."""
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    return normals / np.maximum(np.linalg.norm(normals, axis=1), np.finfo(np.float64).tiny)[:, None]


def _find_neighbours(numbers: np.ndarray) -> np.ndarray:
    """Return pairs of faces that share an edge, (2, E), for the numbers of each face's corners, (F, 3)."""
    start, end = numbers.ravel(), np.roll(numbers, -1, axis=1).ravel()
    edge = np.minimum(start, end) * (numbers.max(initial=0) + 1) + np.maximum(start, end)
    order = np.argsort(edge, kind="stable")
    pairs = [np.stack([order[:-step], order[step:]])[:, edge[order[step:]] == edge[order[:-step]]] for step in (1, 2)]
    return np.concatenate(pairs, axis=1) // 3
