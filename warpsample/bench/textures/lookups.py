"""What a viewer reads of a texture, how wrong it is, and what that error is made of."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from warpsample.estimate.visibility import ambient_occlusion
from warpsample.mesh.mesh import Mesh, unit_or_zero
from warpsample.mesh.points.sampling import sample_surface
from warpsample.mesh.surface import SurfacePoints
from warpsample.texture.charts import charts_of
from warpsample.texture.claims import claims_of
from warpsample.texture.report import face_flaws
from warpsample.texture.texture_points import TexturePoints


@dataclass(frozen=True, eq=False)
class LookupPlaces:
    """Places on the surface that are looked up in an image.

    Attributes:
        uv: (N, 2) float64, where.
        right: (N,) float32, what is right there.
        shared: (N,) bool, whether a lookup reads a texel that another chart claims, too, and so may be wrong here.
    """

    uv: np.ndarray
    right: np.ndarray
    shared: np.ndarray

    def error(self, images: Sequence[np.ndarray]) -> dict[str, float]:
        """The RMSE of lookups in two images that differ by their random numbers alone, and its parts.

        Noise is what the images differ by; overlap and resolution are what they have in common, at places that are shared
        and at all others; of a tool without seeds they have the noise, too. The squares of the three add up to that of the
        whole.
        """
        first, second = (read(image, self.uv) - self.right for image in images)
        common = first * second
        squares = {
            "lookup": np.mean(first**2 + second**2) / 2.0,
            "noise": np.mean((first - second) ** 2) / 2.0,
            "overlap": np.mean(common * self.shared),
            "resolution": np.mean(common * ~self.shared),
        }
        return {name: float(np.sqrt(max(0.0, square))) for name, square in squares.items()}


def read(image: np.ndarray, uv: np.ndarray) -> np.ndarray:
    """(N,) of a square image (H, H) at (N, 2) coordinates, v down, as viewers read it: bilinear, clamped."""
    texels, weights = _texels_read(uv, len(image))
    return (image.ravel()[texels] * weights).sum(axis=1)


def _texels_read(uv: np.ndarray, side: int) -> tuple[np.ndarray, np.ndarray]:
    """The four texels (N, 4) that a lookup reads, and their weights."""
    place = np.clip(uv * side - 0.5, 0.0, side - 1.0)
    low = np.minimum(place.astype(int), max(side - 2, 0))
    (s, t), (x, y) = (place - low).T, low.T
    texels = [(y + j) * side + x + i for j in (0, 1) for i in (0, 1)]
    weights = [(t if j else 1.0 - t) * (s if i else 1.0 - s) for j in (0, 1) for i in (0, 1)]
    return np.stack(texels, axis=1), np.stack(weights, axis=1)


def places_of(t: TexturePoints, uv: np.ndarray, count: int, rays: int, seed: int) -> LookupPlaces:
    """So many places on the faces that have coordinates, uniform by area; what is right there by many rays."""
    mesh, rows = t.mesh, np.flatnonzero(np.isfinite(uv).all(axis=(1, 2)))
    drawn = sample_surface(Mesh(mesh.vertices, mesh.faces[rows]), count, seed=seed, barycentric=True)
    face, weights = rows[drawn.face], drawn.barycentric
    normal = unit_or_zero(np.einsum("pk,pkc->pc", weights, t.corner_normals[face]))
    right = ambient_occlusion(mesh, SurfacePoints(drawn.position, normal, face, weights), rays, seed=seed).value
    at = np.einsum("pk,pkc->pc", weights, uv[face])
    return LookupPlaces(at, right, _shared(t, at, face))


def _shared(t: TexturePoints, at: np.ndarray, face: np.ndarray) -> np.ndarray:
    """(N,) bool: whether lookups at coordinates of faces read a texel that another chart claims: the first or the last one.

    Charts that lie on one another hold together by their coordinates, so theirs are told apart by places in space, and the
    two sides of one that is folded by which of them are mirrored.
    """
    flaws = face_flaws(t.corners)
    mirrored = np.repeat(flaws["mirrored"], 3).reshape(-1, 3, 1)
    charts = charts_of(np.concatenate([t.corners, t.mesh.vertices[t.mesh.faces], mirrored], axis=2))
    usable = ~(flaws["without_uv"] | flaws["zero_area"])
    backwards = np.ascontiguousarray(t.corners[::-1])
    last = len(charts) - 1 - claims_of(backwards, usable[::-1], t.size, 1, t.options.memory).face
    texels, weights = _texels_read(at, t.size[0])
    found = np.zeros(len(at), np.bool_)
    for owners in (t.face, last):
        owner = np.zeros(t.size[0] * t.size[1], np.int64)
        owner[t.texel] = owners
        found |= ((charts[owner[texels]] != charts[face][:, None]) & (weights > 0.0)).any(axis=1)
    return found
