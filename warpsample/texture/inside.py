"""Detection of texel points inside closed bodies (for example a floor under a wall), which are not visible."""

from itertools import product

import numpy as np

from warpsample.directions.sample import sample_directions
from warpsample.host.locks import once_property
from warpsample.mesh.mesh import Mesh
from warpsample.mesh.surface import SurfacePoints
from warpsample.sequences.hashing import seed_for
from warpsample.texture.texture_points import TexturePoints, find_rows
from warpsample.texture.uv.charts import label_charts, label_closed
from warpsample.tracing.trace_all import trace_all

_RAYS = 3  # two rays per point, and a third one where the first two disagree
_SEED = seed_for("inside", 0)
_CELLS = 64  # cells of the grid along each axis: 2^18 counts
_NEAR = 0.01  # of a cell
_BLOCK = 1 << 13  # points whose hits are held in memory at a time: 100 bytes each, and up to thousands per point
_FLAT = 1e-12  # of the sum of absolute parts of a volume: with less, as between the sides of a sheet, it is rounding
_WITHIN = 1e-6  # least corner weight of a point in the interior of its face; points on an edge have a weight near 0


class Closed:
    """Closed opaque bodies of a mesh, for example walls and boxes, with a test whether points are inside."""

    def __init__(self, mesh: Mesh) -> None:
        """Store the mesh; bodies are searched at first use."""
        self.mesh = mesh

    @once_property
    def bodies(self) -> tuple[np.ndarray, np.ndarray]:
        """Find the closed body of each face, (F,) int64, -1 in open parts, and a mask of the outward-facing bodies.

        Vertices with the same position count as one vertex, at first within named parts alone: crates that touch are bodies
        of their own. Faces that belong to no closed body then are joined over all parts. A body with a face that transmits
        light encloses nothing, since points inside are lit and visible: its faces get -1.
        """
        _, vertex = np.unique(self.mesh.vertices + 0.0, axis=0, return_inverse=True)  # + 0.0 turns -0 into 0
        faces = vertex.reshape(-1)[self.mesh.faces].astype(np.int64)
        flat = (faces == np.roll(faces, 1, axis=1)).any(axis=1)
        part = np.zeros(len(faces), np.int64) if self.mesh.part is None else self.mesh.part.astype(np.int64) + 1
        body = np.full(len(faces), -1, np.int64)
        for corners in (part[:, None] * (faces.max() + 1) + faces, faces):
            rows = np.flatnonzero((body < 0) & ~flat)
            label = label_closed(corners[rows])
            body[rows] = np.where(label < 0, -1, label + body.max() + 1)
        parts = self._volumes[body >= 0]
        volume, most = (np.bincount(body[body >= 0], some) for some in (parts, np.abs(parts)))
        volume[np.abs(volume) <= _FLAT * most] = 0.0
        if self.mesh.transmittance is not None:
            volume[body[(body >= 0) & (self.mesh.transmittance > 0.0)]] = 0.0
        body[body >= 0] = np.where(volume == 0.0, -1, np.cumsum(volume != 0.0) - 1)[body[body >= 0]]
        return body, volume[volume != 0.0] > 0.0

    @property
    def _volumes(self) -> np.ndarray:
        """Six times the signed volume between each face and the mesh's centre, (F,); negative for faces that face inward."""
        corner = self.mesh.vertices[self.mesh.faces[:, 0]] - self.mesh.bounds.mean(axis=0)
        return (corner * self.mesh.cross_products).sum(axis=1)

    @once_property
    def _grid(self) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Grid of cells around all bodies: lower corner, cells per length, and the number of bodies' boxes in each cell."""
        body, outward = self.bodies
        corners = self.mesh.vertices[self.mesh.faces[body >= 0]]
        lower, upper = np.full((len(outward), 3), np.inf), np.full((len(outward), 3), -np.inf)
        np.minimum.at(lower, body[body >= 0], corners.min(axis=1))
        np.maximum.at(upper, body[body >= 0], corners.max(axis=1))
        origin, cells = lower.min(axis=0), _CELLS / (upper.max(axis=0) - lower.min(axis=0))
        near = _NEAR / cells  # so that rounding moves no point out of the cells of its own body
        ends = [_locate_cells(lower - near, origin, cells), _locate_cells(upper + near, origin, cells) + 1]
        counts = np.zeros((_CELLS + 1,) * 3, np.int32)
        for sides in product((0, 1), repeat=3):  # differences at box corners, whose cumulative sums are the counts
            at = tuple(ends[side][:, axis] for axis, side in enumerate(sides))
            np.add.at(counts, at, (-1) ** sum(sides))
        for axis in range(3):
            np.cumsum(counts, axis=axis, out=counts)
        return origin, cells, counts[:-1, :-1, :-1]

    def _find_candidates(self, position: np.ndarray, own: np.ndarray) -> np.ndarray:
        """Return the rows of the points that may be inside a body other than their own, by a grid of bounding boxes."""
        if not len(self.bodies[1]):
            return np.zeros(0, np.int64)
        origin, cells, counts = self._grid
        place = (position - origin) * cells
        count = counts[tuple(_locate_cells(position, origin, cells).T)] - (own >= 0)
        return np.flatnonzero(((place >= -_NEAR) & (place <= _CELLS + _NEAR)).all(axis=1) & (count > 0))

    def count_bodies(
        self, points: SurfacePoints, face: np.ndarray, workers: int | None = None
    ) -> tuple[np.ndarray, np.ndarray, int]:
        """Count the closed bodies that contain each point, by ray crossings, without the point's own body.

        Args:
            points: P points.
            face: (P,) face of each point, or -1.
            workers: number of threads.

        Returns:
            (P, 2) int32, numbers of outward-facing and of inward-facing bodies around each point; (P,) bool, True where the
            first two rays disagreed and a third one decided; and the number of rays cast.
        """
        nested, unsure = np.zeros((len(points), 2), np.int32), np.zeros(len(points), np.bool_)
        own = np.where(face >= 0, self.bodies[0][face], -1)
        rows = self._find_candidates(np.asarray(points.position), own)
        if not len(rows):
            return nested, unsure, 0
        some, own = points.take(rows), own[rows]
        directions = sample_directions(some, _RAYS, seed=_SEED, sequence="sobol", workers=workers).vectors
        first, second = (self._count_by_crossings(some, directions[:, ray], own, workers) for ray in (0, 1))
        nested[rows], unsure[rows] = first, (first != second).any(axis=1)
        doubt = np.flatnonzero(unsure[rows])
        if len(doubt):
            third = self._count_by_crossings(some.take(doubt), directions[doubt, 2], own[doubt], workers)
            nested[rows[doubt]] = np.median([first[doubt], second[doubt], third], axis=0)
        return nested, unsure, 2 * len(rows) + len(doubt)

    def _count_by_crossings(
        self, points: SurfacePoints, directions: np.ndarray, own: np.ndarray, workers: int | None
    ) -> np.ndarray:
        """Return how many outward-facing and inward-facing bodies contain each point, (P, 2), by one ray per point.

        A body counts if the ray leaves it more often than it enters it, or less often if its faces face inward: 1 time for a
        body alone, and 1 or 2 times for two bodies that share vertices. A point's own body does not count.
        """
        hits = trace_all(self.mesh, points, np.ascontiguousarray(directions), workers=workers)
        body, outward = self.bodies
        ray, met = np.repeat(np.arange(len(points)), np.diff(hits.first)), body[hits.face]
        outwards = np.sign((directions[ray] * self.mesh.cross_products[hits.face]).sum(axis=1))
        counted = (met >= 0) & (met != own[ray])
        pairs, pair = np.unique(ray[counted] * len(outward) + met[counted], return_inverse=True)
        windings = np.bincount(pair, outwards[counted], minlength=len(pairs))
        ray, met = np.divmod(pairs[windings != 0.0], len(outward))
        kinds = (ray[outward[met]], ray[~outward[met]])
        return np.stack([np.bincount(kind, minlength=len(points)) for kind in kinds], axis=1).astype(np.int32)


def _locate_cells(position: np.ndarray, origin: np.ndarray, cells: np.ndarray) -> np.ndarray:
    """Return the grid cell of each position, (P, 3), clipped to the grid."""
    return np.clip((position - origin) * cells, 0, _CELLS - 1).astype(np.int64)


class Enclosed:
    """Counts of the closed bodies that contain each point of a texture, computed part by part.

    Attributes:
        rays: number of rays cast so far.
    """

    rays: int

    def __init__(self, closed: Closed, points: TexturePoints) -> None:
        """Prepare the counting; at first, all points count as outside of all bodies."""
        self.rays = 0
        self._closed, self._points = closed, points
        self._depths = np.zeros((len(points), 2), np.int32)
        self._is_within, self._is_sure = np.zeros(len(points), np.bool_), np.zeros(len(points), np.bool_)

    def add(self, first: int, texels: SurfacePoints, places: SurfacePoints, workers: int | None) -> None:
        """Count the bodies around some points of the texture.

        Args:
            first: row of the first point.
            texels: the points as `TexturePoints.take` returns them.
            places: points at which the values are computed: `texels`, or projections on a finer mesh.
            workers: number of threads.
        """
        rows = slice(first, first + len(texels))
        face = self._points.face[rows] if places is texels else np.asarray(places.face)
        self._is_within[rows] = (np.asarray(texels.barycentric) > _WITHIN).all(axis=1)
        for start in range(0, len(texels), _BLOCK):
            block = slice(start, start + _BLOCK)
            nested, unsure, rays = self._closed.count_bodies(places.take(block), face[block], workers)
            rows = slice(first + start, first + start + len(nested))
            self._depths[rows], self.rays = nested, self.rays + rays
            self._is_sure[rows] = ~unsure

    @property
    def inside(self) -> np.ndarray:
        """Mask of the points inside an outward-facing closed body, (P,) bool."""
        return self._depths[:, 0] > 0

    def find_buried(self, usable: np.ndarray) -> np.ndarray:
        """Return a mask of hidden points: inside more closed bodies than another point of the same UV chart, (P,).

        The image is filled at such points. A chart wholly inside a body counts as being in a room, and none of its points
        are marked. A chart cut by a hollow body is examined separately inside and outside of the hollow.

        Args:
            usable: (P,) bool, points with a value. Only usable points are compared with; points whose rays disagreed are
                left out, and points on edges of faces, such as the rim of a chart, unless their chart has no others.
        """
        if not self.inside.any():
            return np.zeros(len(usable), np.bool_)
        depth, hollow = self._depths.T
        group = self._chart * (int(hollow.max()) + 1) + hollow
        least = np.full(int(group.max()) + 1, np.iinfo(np.int32).max, np.int32)
        source = self._is_sure & usable
        source &= self._is_within | (np.bincount(self._chart, self._is_within & source) == 0.0)[self._chart]
        np.minimum.at(least, group[source], depth[source])
        return depth > least[group]

    def count_mostly_buried(self, buried: np.ndarray) -> int:
        """Count the UV charts that have more than half of their points in the mask `buried`."""
        if not buried.any():
            return 0
        return int(np.count_nonzero(2 * np.bincount(self._chart, buried) > np.bincount(self._chart)))

    @once_property
    def _chart(self) -> np.ndarray:
        """Compute the number of the UV chart of each point, (P,) int32; charts that overlap have different numbers."""
        points, mesh = self._points, self._points.mesh
        faces = mesh.faces if points.faces is None else mesh.faces[points.faces]
        return label_charts(np.concatenate([points.corners, mesh.vertices[faces]], axis=2))[find_rows(points, points.face)]
