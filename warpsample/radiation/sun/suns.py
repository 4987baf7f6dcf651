"""Tree of sun directions, so that visibility can be decided for a whole group of neighbouring suns at once.

Each group has a shaft, a pyramid of directions around it. The groups are the leaves of a complete binary tree; each node's
suns are halved across their widest axis. A shaft is a pyramid from the point: four planes around the suns, or around their
discs.
"""

from dataclasses import dataclass
from functools import lru_cache
from math import radians

import numpy as np

from warpsample.tracing.sight.shafts import shaft_vectors

GROUP = 16
"""Largest number of suns in a group; a group's suns are tested together."""

_MOST_KEPT = 1 << 16  # suns of a cached tree: 3 MB, with discs 15 MB
_WIDEST = 0.6  # radians from the axis: wider shafts nearly always hit something
_NO_AXIS = 0.5  # least cosine of the suns to their mean direction


@dataclass(frozen=True, eq=False)
class SunTree:
    """Binary tree of T sun directions: G leaves with groups of neighbouring suns, N nodes in all.

    Attributes:
        groups: (G, 3, 16) float32, x, y, z of directions; 0 where a group has fewer suns.
        columns: (G, 16) int32, row of each sun in the caller's array.
        spans: (N, 4) int32, nodes in depth-first order: first group, group after the last, next node that is no descendant,
            and 1 if the node's shaft is usable, else 0.
        shafts: (N, 3, 16) float32, x, y, z of inward normals of planes, from the second on, and directions of the corners.
        disc_shafts: (G, 16, 3, 16) float32, the same for each sun's disc; empty without discs.
    """

    groups: np.ndarray
    columns: np.ndarray
    spans: np.ndarray
    shafts: np.ndarray
    disc_shafts: np.ndarray

    @classmethod
    def of(cls, directions: np.ndarray, disc: float) -> "SunTree":
        """Return the tree of (T, 3) float32 unit vectors towards suns, from a cache if possible.

        There must be at least one. `disc` is the angular diameter in degrees.
        """
        return _cached_tree(directions.tobytes(), disc) if len(directions) <= _MOST_KEPT else cls.built(directions, disc)

    @classmethod
    def built(cls, directions: np.ndarray, disc: float) -> "SunTree":
        """Build a tree of sun directions; arguments as for `SunTree.of`, without the cache."""
        count, radius = len(directions), radians(0.5 * disc)
        levels = max(0, int(np.ceil(np.log2(count / GROUP))))
        bounds = [(np.arange(2**level + 1) * count) >> level for level in range(levels + 1)]
        order = np.arange(count)
        for level in range(levels):
            order = order[_sort_parts(directions[order], bounds[level])]
        suns, leaves = directions[order].astype(np.float64), bounds[levels]
        of, lane = _locate_in_parts(leaves)
        groups = np.zeros((2**levels, 3, GROUP), np.float32)
        groups[of, :, lane] = suns
        columns = np.zeros((2**levels, GROUP), np.int32)
        columns[of, lane] = order
        nodes = 2 ** (levels + 1) - 1
        spans, shafts = np.zeros((nodes, 4), np.int32), np.zeros((nodes, 3, GROUP), np.float32)
        for level, at in enumerate(_index_nodes(levels)):
            shafts[at], of_use = _build_shafts(suns, bounds[level], radius)
            first = np.arange(2**level) << (levels - level)
            below = 2 ** (levels - level + 1) - 1
            spans[at] = np.stack([first, first + 2 ** (levels - level), at + below, of_use], axis=1)
        disc_shafts = np.zeros((2**levels if disc else 0, GROUP, 3, GROUP), np.float32)
        if disc:
            disc_shafts[of, lane] = _build_shafts(suns, np.arange(count + 1), radius)[0]
        return cls(groups, columns, spans, shafts, disc_shafts)


@lru_cache(maxsize=4)
def _cached_tree(directions: bytes, disc: float) -> SunTree:
    """Return the tree for the bytes of (T, 3) float32 sun directions, from a cache where possible."""
    return SunTree.built(np.frombuffer(directions, np.float32).reshape(-1, 3), disc)


def _locate_in_parts(bounds: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return, for each row of an array that is divided at `bounds`, the number of its part and its index there."""
    of = np.repeat(np.arange(len(bounds) - 1), np.diff(bounds))
    return of, np.arange(bounds[-1]) - bounds[of]


def _sort_parts(directions: np.ndarray, bounds: np.ndarray) -> np.ndarray:
    """Return the order that sorts the suns of each part along the coordinate axis with the widest extent."""
    low, high = (f.reduceat(directions, bounds[:-1]) for f in (np.minimum, np.maximum))
    of, lane = _locate_in_parts(bounds)
    along = np.full((len(bounds) - 1, np.diff(bounds).max()), np.inf, np.float32)  # parts differ in size by at most one
    along[of, lane] = directions[np.arange(len(of)), np.argmax(high - low, axis=1)[of]]
    order = np.argsort(along, axis=1, kind="stable") + bounds[:-1, None]
    return order[of, lane]


def _index_nodes(levels: int) -> list[np.ndarray]:
    """Return the indices of the tree's nodes on each level, in depth-first order."""
    places = [np.zeros(1, np.int64)]
    for level in range(levels):
        below = 2 ** (levels - level) - 1
        places.append((places[-1][:, None] + np.array([1, 1 + below])).ravel())
    return places


def _build_shafts(suns: np.ndarray, bounds: np.ndarray, radius: float) -> tuple[np.ndarray, np.ndarray]:
    """Return a pyramid of directions around each part's suns, (N, 3, 16), and a mask of the sufficiently narrow ones."""
    first, size = bounds[:-1], np.diff(bounds)
    total = np.add.reduceat(suns, first)
    length = np.linalg.norm(total, axis=1, keepdims=True)
    axis = np.where(length > _NO_AXIS, total, suns[first]) / np.where(length > _NO_AXIS, length, 1.0)
    forward = np.maximum(_compute_dots(suns, axis, size), 1e-3)
    of_use = np.minimum.reduceat(forward, first) > _NO_AXIS
    across, aside = _choose_sides(suns, axis, forward, first, size)
    normals, tangents = [], []
    for side in (across, aside):
        along = _compute_dots(suns, side, size)
        angle, half = np.arctan2(along, forward), 0.0
        if radius:  # half the disc's angular width in that plane
            half = np.arcsin(np.minimum(1.0, np.sin(radius) / np.hypot(along, forward)))
        low, high = np.minimum.reduceat(angle - half, first), np.maximum.reduceat(angle + half, first)
        of_use &= np.maximum(-low, high) < _WIDEST
        low, high = np.clip([low, high], -_WIDEST, _WIDEST)[..., None]
        normals += [np.cos(low) * side - np.sin(low) * axis, np.sin(high) * axis - np.cos(high) * side]
        tangents.append((np.tan(low) * side, np.tan(high) * side))
    corners = [axis + x + y for x in tangents[0] for y in tangents[1]]
    lengths = np.linalg.norm(corners, axis=2, keepdims=True)
    return shaft_vectors(np.stack(normals, axis=1), np.moveaxis(corners / lengths, 0, 1)), of_use


def _compute_dots(suns: np.ndarray, vectors: np.ndarray, size: np.ndarray) -> np.ndarray:
    """Return the dot product of each sun direction with the vector of its part; parts have `size` suns each."""
    return np.einsum("ij,ij->i", suns, np.repeat(vectors, size, axis=0))


def _choose_sides(
    suns: np.ndarray, axis: np.ndarray, forward: np.ndarray, first: np.ndarray, size: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """Return two unit vectors perpendicular to each part's axis: along the widest spread of its suns, and across."""
    least = np.eye(3)[np.abs(axis).argmin(axis=1)]
    x = np.cross(axis, least) / np.maximum(np.linalg.norm(np.cross(axis, least), axis=1, keepdims=True), 1e-3)
    y = np.cross(axis, x)
    u, v = (_compute_dots(suns, side, size) / forward for side in (x, y))
    moments = [np.add.reduceat(p, first) for p in (u, v, u * u, v * v, u * v)]
    u, v, uu, vv, uv = (moment / size for moment in moments)
    turn = 0.5 * np.arctan2(2.0 * (uv - u * v), (uu - u * u) - (vv - v * v))[:, None]
    across = np.cos(turn) * x + np.sin(turn) * y
    return across, np.cross(axis, across)
