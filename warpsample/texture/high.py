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
from warpsample.tracing.placement import OFFSET
from warpsample.tracing.scene import scene_of
from warpsample.tracing.trace import trace
from warpsample.tracing.trace_all import trace_all

_SLIVER = 1e-3  # area divided by the square of the longest edge: normals of narrower faces are uncertain, and count less
_CANCELLED = 1e-5  # length of a mean normal that is rounding, as where two sides of a sheet meet


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

        Rays run against the normals of the points. The rays of points on an edge are shifted into their face by a few
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
        middle = low.vertices[low.faces[points.face]].mean(axis=1) - points.position
        share = self._resolutions_at(points.position) / np.maximum(np.linalg.norm(middle, axis=1, keepdims=True), 1e-300)
        start = points.position + np.minimum(share, 0.5) * middle - self.cage * inward
        face = self._find_front_faces(start, inward, workers)
        missed = face < 0
        weights = _compute_plane_weights(self.mesh.vertices[self.mesh.faces[np.maximum(face, 0)]], start, inward)
        position, normal, on = shade_points(self.mesh, self.corner_normals, np.maximum(face, 0), weights, self.normals)
        if self.normals == "face":
            normal = self.mesh.face_normals[np.maximum(face, 0)]
        normal = np.where(missed[:, None], np.float32(0.0), normal)
        position = np.where(missed[:, None], points.position, position)
        return SurfacePoints(position, normal, np.where(missed, -1, on).astype(np.int32), weights, points.id), missed

    def _resolutions_at(self, places: np.ndarray) -> np.ndarray:
        """Return the lengths that rays against the fine mesh resolve at each place, (P, 1) float64."""
        scene = scene_of(self.mesh, through=True)
        reach = np.abs(places - scene.centre).max(axis=1, keepdims=True)
        return OFFSET * np.maximum(reach, scene.spread.max() / scene.scale)

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


def average_normals(mesh: Mesh) -> np.ndarray:
    """Return the (F, 3, 3) float64 corner normals, equal at all corners with the same position.

    Equal normals leave no gaps between the rays at hard edges and seams. Faces count by their angle at the position. If they
    counted by area, a large floor would turn the rays of a wall beside it along the wall. Normals that cancel give 0.
    """
    places, vertex = np.unique(mesh.vertices + 0.0, axis=0, return_inverse=True)  # + 0.0 turns -0 into 0
    faces = vertex.reshape(-1)[mesh.faces]
    edges = np.roll(places[faces], -1, axis=1) - places[faces]
    longest = lengths(edges.reshape(-1, 3)).reshape(-1, 3).max(axis=1)
    edges = unit_or_zero(edges.reshape(-1, 3)).reshape(edges.shape).astype(np.float64)
    cosine = -np.einsum("fkx,fkx->fk", edges, np.roll(edges, 1, axis=1))
    scale = np.where(longest > 0.0, longest, 1.0)
    ratio = mesh.face_areas / scale / scale  # the square may underflow
    weight = np.arccos(np.clip(cosine, -1.0, 1.0)) * np.minimum(ratio / _SLIVER, 1.0)[:, None]
    corners = np.concatenate([weight[..., None] * mesh.face_normals[:, None], weight[..., None]], axis=2).reshape(-1, 4)
    sums = np.stack([np.bincount(faces.ravel(), column, len(places)) for column in corners.T], axis=1)
    mean = sums[:, :3]
    mean[np.linalg.norm(mean, axis=1) <= _CANCELLED * sums[:, 3]] = 0.0
    return unit_or_zero(mean)[faces].astype(np.float64)


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
