"""Triangulation and areas of polygons with holes, in the plane of Newell's normal."""

from dataclasses import dataclass

import numpy as np
from mapbox_earcut import triangulate_float64

from warpsample.mesh.polygons import triangles


@dataclass(frozen=True, eq=False)
class Outlines:
    """N polygons with holes, as rings of corners: for each polygon the outer ring first, then its holes.

    Attributes:
        corners: (K,) int64 indices of points, ring after ring; the first corner is not repeated at the end of a ring.
        sizes: (R,) int64 number of corners of each ring.
        rings: (N,) int64 number of rings of each face, at least 1.
    """

    corners: np.ndarray
    sizes: np.ndarray
    rings: np.ndarray

    @property
    def outer(self) -> np.ndarray:
        """Number of each polygon's outer ring, (N,)."""
        return np.cumsum(self.rings) - self.rings

    def crosses(self, points: np.ndarray) -> np.ndarray:
        """Return the normal of each ring of corners, (R, 3), with a length of twice the ring's area (Newell's formula).

        The normal is 0 for a ring with fewer than three corners.
        """
        starts = np.cumsum(self.sizes) - self.sizes
        ring = np.repeat(np.arange(len(self.sizes)), self.sizes)
        about = points[self.corners] - points[self.corners[starts[ring]]]
        following = np.arange(1, len(about) + 1)
        following[np.cumsum(self.sizes)[self.sizes > 0] - 1] = starts[self.sizes > 0]
        crosses = np.cross(about, about[following])
        return np.stack([np.bincount(ring, axis, len(self.sizes)) for axis in crosses.T], axis=1)

    def areas(self, points: np.ndarray) -> np.ndarray:
        """Return the (N,) areas of the faces: outer ring minus holes, for either winding of the holes, at least 0."""
        twice = np.linalg.norm(self.crosses(points), axis=1)
        signed = -twice
        signed[self.outer] = twice[self.outer]
        face = np.repeat(np.arange(len(self.rings)), self.rings)
        return 0.5 * np.maximum(np.bincount(face, signed, len(self.rings)), 0.0)

    def triangles(self, points: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Return (T, 3) int64 triangles in the winding and order of the faces, and the (T,) face number of each triangle.

        A face with fewer than three corners has no triangles. Holes that cross an edge are cut as earcut cuts them.
        """
        starts, outer = np.cumsum(self.sizes) - self.sizes, self.outer
        plain = np.flatnonzero((self.rings == 1) & (self.sizes[outer] > 2))
        is_plain = np.zeros(len(self.sizes), np.bool_)
        is_plain[outer[plain]] = True
        sizes = self.sizes[outer[plain]]
        cut = [triangles(points, sizes, self.corners[np.repeat(is_plain, self.sizes)])]
        owners = [np.repeat(plain, sizes - 2)]
        for face in np.flatnonzero((self.rings > 1) & (self.sizes[outer] > 2)).tolist():
            first, last = outer[face], outer[face] + self.rings[face] - 1
            held = self.corners[starts[first] : starts[last] + self.sizes[last]]
            found = _cut(points[held], self.sizes[first : last + 1])
            cut.append(held[found])
            owners.append(np.full(len(found), face))
        owner = np.concatenate(owners)
        order = np.argsort(owner, kind="stable")
        return np.concatenate(cut)[order], owner[order]


def _cut(corners: np.ndarray, sizes: np.ndarray) -> np.ndarray:
    """Triangulate one polygon with holes, given by corners (n, 3) in rings; return (T, 3) corner numbers."""
    flat = _flattened(corners, int(sizes[0]))
    ends = np.cumsum(sizes)
    following = np.arange(1, len(flat) + 1)
    following[ends[sizes > 0] - 1] = (ends - sizes)[sizes > 0]
    alone = (flat != flat[following]).any(axis=1)  # as in `polygons`, repeated corners are hidden from earcut
    ring = np.repeat(np.arange(len(sizes)), sizes)
    alone &= (np.bincount(ring, alone, len(sizes)) > 2)[ring]
    kept = np.flatnonzero(alone)
    left = np.bincount(ring[kept], minlength=len(sizes))
    if left[0] < 3:
        return np.empty((0, 3), np.int64)
    ends = np.cumsum(left[left > 0]).astype(np.uint32)
    return kept[triangulate_float64(flat[kept], ends).reshape(-1, 3)]


def _flattened(corners: np.ndarray, outer: int) -> np.ndarray:
    """Project corners (n, 3) to the plane of the outer ring, so that the ring is counter-clockwise in the (n, 2) result.

    The outer ring consists of the first `outer` corners.
    """
    about = corners - corners[0]
    normal = np.cross(about[1 : outer - 1], about[2:outer]).sum(axis=0)
    least = np.eye(3)[np.argmin(np.abs(normal))]
    first = np.cross(least, normal)
    axes = np.stack([first, np.cross(normal, first)])
    lengths = np.linalg.norm(axes, axis=1, keepdims=True)
    return np.ascontiguousarray(about @ np.divide(axes, lengths, out=np.zeros_like(axes), where=lengths > 0.0).T)
