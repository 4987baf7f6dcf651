"""Baking from a fine mesh to the texture of a coarse one: texels are projected onto the fine mesh by rays."""

from dataclasses import dataclass
from pathlib import Path

import numpy as np

from warpsample.host.arguments import naming_file
from warpsample.mesh.files import load_mesh
from warpsample.mesh.files.normals import read_normals, read_smooth_normals
from warpsample.mesh.mesh import Mesh, lengths, unit_or_zero
from warpsample.mesh.surface import SurfacePoints
from warpsample.texture.shading import compute_corner_normals, shade_points
from warpsample.tracing.placement import resolutions_at
from warpsample.tracing.scene import scene_of
from warpsample.tracing.trace import trace
from warpsample.tracing.trace_all import trace_all

_NARROW = 1.0 / 16.0  # of the cage: narrower faces turn rays only if their normals are no rounding
_ROUNDINGS = 16.0  # widths of faces in roundings of float32 corners, below which normals are not sure
_STRAIGHT = -0.999  # cosine of an angle that counts as 180 degrees, as of the slivers that close T-junctions
_SURE = 0.1  # certainty of normals that a mean normal has to agree with
_BLOCK = 1 << 22  # pairs of corners in memory at a time
_GRAZING = 0.05  # cosine to a face's normal: with less, a mean normal is of no use to the rays of the face


@dataclass(frozen=True, eq=False)
class HighMesh:
    """Fine mesh on whose surface values are computed for the texture of a coarse mesh.

    Attributes:
        mesh: the fine mesh.
        corner_normals: (F, 3, 3) float64, normals of the fine mesh's file, or of its vertices.
        cage: distance from the coarse mesh, outward to the start of rays and inward to their end, in units of the mesh.
        normals: normals of the projected points: "face", "file", "smooth" or "lifted".
    """

    mesh: Mesh
    corner_normals: np.ndarray
    cage: float
    normals: str

    @classmethod
    def load(cls, path: Path, cage: float, normals: str) -> "HighMesh":
        """Read the fine mesh and its normals from a file; `cage` is the distance at which projecting rays start."""
        mesh = load_mesh(path)
        with naming_file("--high", path, "a mesh with normals"):
            given = read_smooth_normals(path, mesh) if normals in ("smooth", "lifted") else read_normals(path)
        return cls(mesh, compute_corner_normals(mesh, given), cage, normals)

    def project(self, points: SurfacePoints, low: Mesh, workers: int | None = None) -> tuple[SurfacePoints, np.ndarray]:
        """Project points of the coarse mesh onto the fine mesh: the first front-facing hit of a ray through each point.

        Rays run against the normals of the points. The rays of points beside an edge are shifted into their face by a few
        rounding errors, so that they hit the texel's own side where both meshes have the same hard edge.

        Args:
            points: P points on faces of the coarse mesh, with its averaged normals.
            low: the coarse mesh.
            workers: number of threads.

        Returns:
            points on the fine mesh, with the ids of `points`; and (P,) bool, True where a ray has no hit. Such points keep
            their position and have a normal of 0.
        """
        inward = -np.asarray(points.normal, np.float64)
        scene = scene_of(self.mesh, through=True)
        depth = 0.5 * resolutions_at(scene, np.abs(points.position - scene.centre).max(axis=1))
        start = _move_off_edges(points, low, depth) - self.cage * inward
        face = self._find_front_faces(start, inward, workers)
        missed, face = face < 0, np.maximum(face, 0)
        weights = _compute_plane_weights(self.mesh.vertices[self.mesh.faces[face]], start, inward)
        position, normal, on = shade_points(self.mesh, self.corner_normals[face], face, weights, self.normals)
        if self.normals == "face":
            normal = self.mesh.face_normals[face]
        normal = np.where(missed[:, None], np.float32(0.0), normal)
        position = np.where(missed[:, None], points.position, position)
        return SurfacePoints(position, normal, np.where(missed, -1, on).astype(np.int32), weights, points.id), missed

    def _find_front_faces(self, start: np.ndarray, inward: np.ndarray, workers: int | None) -> np.ndarray:
        """Return the first face that each ray hits from the front, (P,), within twice the cage; -1 without a hit."""
        reach, directions = 2.0 * self.cage, inward.astype(np.float32)
        hits = trace(self.mesh, start, directions, workers=workers)
        is_hit = (hits.face >= 0) & (hits.distance <= reach)
        front = is_hit & self._faces_rays(hits.face, inward)
        found = np.where(front, hits.face, -1).astype(np.int64)
        behind = np.flatnonzero(is_hit & ~front)
        every = trace_all(self.mesh, start[behind], directions[behind], max_distance=1.001 * reach, workers=workers)
        ray = np.repeat(behind, np.diff(every.first))
        usable = np.flatnonzero((every.distance <= reach) & self._faces_rays(every.face, inward[ray]))
        rows, first = np.unique(ray[usable], return_index=True)  # hits are sorted by distance
        found[rows] = every.face[usable[first]]
        return found

    def _faces_rays(self, face: np.ndarray, inward: np.ndarray) -> np.ndarray:
        """Return whether rays along `inward`, (P, 3), hit the fronts of faces, (P,) bool."""
        return (self.mesh.face_normals[face] * inward).sum(axis=1) < 0.0


def _move_off_edges(points: SurfacePoints, low: Mesh, depth: np.ndarray) -> np.ndarray:
    """Return the positions (P, 3) of points, moved within their faces to a distance of `depth`, (P,), from the edges.

    At most to a third of the face's height, so that all three edges can be this far away. Then all points move by `depth`
    towards the middle of their face: texel centres often lie exactly above edges of the finer mesh.
    """
    corners, position = low.vertices[low.faces[points.face]], points.position.astype(np.float64)
    edges = np.roll(corners, -1, axis=1) - corners
    ways = unit_or_zero(np.cross(low.face_normals[points.face][:, None], edges).reshape(-1, 3)).reshape(edges.shape)
    heights = np.einsum("pkx,pkx->pk", np.roll(corners, -2, axis=1) - corners, ways)
    least = np.minimum(depth[:, None], heights / 3.0)
    for edge in range(3):
        missing = least[:, edge] - np.einsum("px,px->p", position - corners[:, edge], ways[:, edge])
        position += np.maximum(missing, 0.0)[:, None] * ways[:, edge]
    reached = np.einsum("pkx,pkx->pk", position[:, None] - corners, ways)
    sharp = np.flatnonzero((reached < 0.5 * least).any(axis=1))  # a step from one edge was a step to another
    weights = np.maximum(reached[sharp], least[sharp]) / heights[sharp]
    weights /= weights.sum(axis=1, keepdims=True)
    position[sharp] = np.einsum("pk,pkx->px", weights, np.roll(corners[sharp], -2, axis=1))
    middle = corners.mean(axis=1) - position
    share = depth / np.maximum(lengths(middle), 1e-300)
    return position + np.minimum(share, 0.5)[:, None] * middle


def average_normals(mesh: Mesh, cage: float) -> np.ndarray:
    """Return the (F, 3, 3) float64 corner normals, equal at corners with the same position, see below.

    Equal normals leave no gaps between the rays at hard edges and seams. Faces count by their angle at the position. If they
    counted by area, a large floor would turn the rays of a wall beside it along the wall. Where the mean would be along or
    behind one of the faces, each corner has a mean of its own, of faces that look the same way: the two sides of a sheet, or
    of a wall between two rooms, would cancel, and what is left has any direction.

    Args:
        mesh: coarse mesh with F faces.
        cage: distance at which rays start; faces that are much narrower count less.
    """
    points, vertex = np.unique(mesh.vertices + 0.0, axis=0, return_inverse=True)  # + 0.0 turns -0 into 0
    faces = vertex.reshape(-1)[mesh.faces]
    edges = np.roll(points[faces], -1, axis=1) - points[faces]
    longest = edges[np.arange(len(faces)), lengths(edges.reshape(-1, 3)).reshape(-1, 3).argmax(axis=1)]
    edges = unit_or_zero(edges.reshape(-1, 3)).reshape(edges.shape).astype(np.float64)
    cosine = -np.einsum("fkx,fkx->fk", edges, np.roll(edges, 1, axis=1))
    certainty = _find_certainties(mesh, points[faces], longest, cosine.min(axis=1), cage)
    weight = np.arccos(np.clip(cosine, -1.0, 1.0)) * certainty[:, None]
    places = faces.ravel()
    parts = (weight[..., None] * mesh.face_normals[:, None]).reshape(-1, 3)
    sums = np.stack([np.bincount(places, column, len(points)) for column in parts.T], axis=1)
    mean = unit_or_zero(sums).astype(np.float64)[faces]
    is_grazing = (np.einsum("fkx,fx->fk", mean, mesh.face_normals) < _GRAZING) & (certainty > _SURE)[:, None]
    rows = np.flatnonzero(np.isin(places, faces[is_grazing]) & np.repeat(certainty > 0.0, 3))
    mean.reshape(-1, 3)[rows] = _average_sides(places[rows], mesh.face_normals[rows // 3], parts[rows])
    return mean


def _find_certainties(mesh: Mesh, corners: np.ndarray, longest: np.ndarray, cosine: np.ndarray, cage: float) -> np.ndarray:
    """Return how sure the normals of faces are, (F,) from 0 to 1: less for faces so narrow that rounding may turn them.

    Files round their numbers to float32 or to decimals, before or after nodes move them. So a face that is much narrower
    than the cage is trusted only if it is wider than roundings of float32, and no sliver of a T-junction.

    Args:
        mesh: the mesh.
        corners: (F, 3, 3) positions.
        longest: (F, 3) longest edges.
        cosine: (F,) cosines of the largest angles.
        cage: distance at which rays start.
    """
    spacing = np.spacing(np.minimum(np.abs(corners).max(axis=1), np.finfo(np.float32).max).astype(np.float32))
    across = np.abs(unit_or_zero(np.cross(mesh.face_normals, longest))).astype(np.float64)
    length = lengths(longest)
    width = 2.0 * mesh.face_areas / np.where(length > 0.0, length, 1.0)
    rounding = np.where(cosine < _STRAIGHT, np.inf, _ROUNDINGS * (across * spacing).sum(axis=1))
    limit = np.minimum(_NARROW * cage, rounding)
    return np.minimum(width / np.maximum(limit, 1e-300), 1.0) ** 2  # as errors grow, weights by variance fall


def _average_sides(places: np.ndarray, normals: np.ndarray, parts: np.ndarray) -> np.ndarray:
    """Return mean normals of corners, (n, 3), in which faces at the same place count by their cosine to the own face.

    Args:
        places: (n,) numbers of the places.
        normals: (n, 3) normals of the faces.
        parts: (n, 3) weighted normals.
    """
    means, order = np.empty(parts.shape), np.argsort(places, kind="stable")
    _, first, counts = np.unique(places[order], return_index=True, return_counts=True)
    for count in np.unique(counts).tolist():  # all places with this number of corners at once
        rows = order[first[counts == count][:, None] + np.arange(count)]
        for some in np.array_split(rows, 1 + rows.size * count // _BLOCK):
            for own in np.array_split(some, 1 + count * count // _BLOCK, axis=1):
                cosines = normals[own] @ normals[some].transpose(0, 2, 1)
                means[own] = np.maximum(cosines, 0.0) @ parts[some]
    return unit_or_zero(means)


def _compute_plane_weights(corners: np.ndarray, start: np.ndarray, directions: np.ndarray) -> np.ndarray:
    """Return the (P, 3) float64 weights of face corners (P, 3, 3) where rays cross the planes of the faces.

    Weights are clipped to [0, 1] and have the sum 1.
    """
    first, second, offset = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0], start - corners[:, 0]
    across = np.cross(directions, second)
    volume = (first * across).sum(axis=1)
    volume = np.where(volume == 0.0, 1.0, volume)
    b = (offset * across).sum(axis=1) / volume
    c = (directions * np.cross(offset, first)).sum(axis=1) / volume
    weights = np.clip(np.stack([1.0 - b - c, b, c], axis=1), 0.0, 1.0)
    return weights / np.maximum(weights.sum(axis=1, keepdims=True), 1e-300)
