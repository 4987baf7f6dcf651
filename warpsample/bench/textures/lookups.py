"""Error of reading values from a baked texture, and its parts: noise, overlap and resolution."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from warpsample.estimate.visibility import ambient_occlusion
from warpsample.mesh.mesh import Mesh, unit_or_zero
from warpsample.mesh.points.sampling import sample_surface
from warpsample.mesh.surface import SurfacePoints
from warpsample.texture.claims import claim_points
from warpsample.texture.report import find_face_flaws
from warpsample.texture.texture_points import TexturePoints
from warpsample.texture.uv.charts import label_charts


@dataclass(frozen=True, eq=False)
class LookupPlaces:
    """Positions on a surface at which a baked texture is read, with reference values.

    Attributes:
        uv: (N, 2) float64, texture coordinates.
        right: (N,) float32, reference values.
        shared: (N,) bool, True if a lookup reads a texel that another chart claims too, which can make the lookup wrong.
    """

    uv: np.ndarray
    right: np.ndarray
    shared: np.ndarray

    def compute_error(self, images: Sequence[np.ndarray]) -> dict[str, float]:
        """Compute the RMSE of the values read from a baked texture, and its parts from noise, overlap and resolution.

        The two images differ only by their random numbers. Noise is the difference of the images. Overlap and resolution are
        their common error, at shared positions and at the other positions. The common error of a tool without seeds includes
        the tool's noise. The squares of the three parts add up to the square of the whole.
        """
        first, second = (read_bilinear(image, self.uv) - self.right for image in images)
        common = first * second
        squares = {
            "lookup": np.mean(first**2 + second**2) / 2.0,
            "noise": np.mean((first - second) ** 2) / 2.0,
            "overlap": np.mean(common * self.shared),
            "resolution": np.mean(common * ~self.shared),
        }
        return {name: float(np.sqrt(max(0.0, square))) for name, square in squares.items()}


def read_bilinear(image: np.ndarray, uv: np.ndarray) -> np.ndarray:
    """Read a square image (H, H) at (N, 2) texture coordinates with bilinear interpolation; return (N,).

    The row index increases with v, and coordinates are clamped as in viewers.
    """
    texels, weights = _find_texels(uv, len(image))
    return (image.ravel()[texels] * weights).sum(axis=1)


def _find_texels(uv: np.ndarray, side: int) -> tuple[np.ndarray, np.ndarray]:
    """Return the four texels (N, 4) that each bilinear lookup reads, and their weights."""
    place = np.clip(uv * side - 0.5, 0.0, side - 1.0)
    low = np.minimum(place.astype(int), max(side - 2, 0))
    (s, t), (x, y) = (place - low).T, low.T
    texels = [(y + j) * side + x + i for j in (0, 1) for i in (0, 1)]
    weights = [(t if j else 1.0 - t) * (s if i else 1.0 - s) for j in (0, 1) for i in (0, 1)]
    return np.stack(texels, axis=1), np.stack(weights, axis=1)


def sample_places(t: TexturePoints, uv: np.ndarray, count: int, rays: int, seed: int) -> LookupPlaces:
    """Sample `count` positions uniformly by area on the faces with texture coordinates, with reference values.

    The reference values use many rays.
    """
    mesh, rows = t.mesh, np.flatnonzero(np.isfinite(uv).all(axis=(1, 2)))
    samples = sample_surface(Mesh(mesh.vertices, mesh.faces[rows]), count, seed=seed, barycentric=True)
    face, weights = rows[samples.face], samples.barycentric
    normal = unit_or_zero(np.einsum("pk,pkc->pc", weights, t.corner_normals[face]))
    right = ambient_occlusion(mesh, SurfacePoints(samples.position, normal, face, weights), rays, seed=seed).value
    at = np.einsum("pk,pkc->pc", weights, uv[face])
    return LookupPlaces(at, right, _find_shared(t, at, face))


def _find_shared(t: TexturePoints, at: np.ndarray, face: np.ndarray) -> np.ndarray:
    """Return (N,) bool, True for texture lookups that read a texel that two or more charts claim.

    Charts with equal texture coordinates would count as one chart, so positions in space separate them. The two sides of a
    folded chart are separated by orientation.
    """
    flaws = find_face_flaws(t.corners)
    mirrored = np.repeat(flaws["mirrored"], 3).reshape(-1, 3, 1)
    charts = label_charts(np.concatenate([t.corners, t.mesh.vertices[t.mesh.faces], mirrored], axis=2))
    usable = ~(flaws["without_uv"] | flaws["zero_area"])
    backwards = np.ascontiguousarray(t.corners[::-1])
    last = len(charts) - 1 - claim_points(backwards, usable[::-1], t.size, 1, t.options.memory).face
    texels, weights = _find_texels(at, t.size[0])
    shared = np.zeros(len(at), np.bool_)
    for owners in (t.face, last):
        owner = np.zeros(t.size[0] * t.size[1], np.int64)
        owner[t.texel] = owners
        shared |= ((charts[owner[texels]] != charts[face][:, None]) & (weights > 0.0)).any(axis=1)
    return shared
