"""Texels as points on a mesh: `texture_points`, by which every number at points becomes an image."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from warpsample.host.arguments import check_choice, check_integer, told
from warpsample.host.arrays import as_real
from warpsample.host.locks import once_property
from warpsample.host.options import CallOptions, explained_by
from warpsample.host.summary import Summary
from warpsample.mesh.mesh import Mesh, as_mesh
from warpsample.mesh.surface import SurfacePoints
from warpsample.texture.charts import label_charts
from warpsample.texture.claims import MOST_TEXELS, claim_points, compute_weights
from warpsample.texture.image import TexelRows, check_gutter, fill_texels
from warpsample.texture.report import TextureReport, build_report, find_face_flaws
from warpsample.texture.shading import NORMALS, compute_corner_normals, shade_points

_MOST_SAMPLES = 1024
_MOST_SIDE = 1 << 16


@dataclass(frozen=True, eq=False, repr=False)
class TexturePoints(Summary):
    """The texels of a texture as points on a mesh, and images of what is known at them.

    Attributes:
        mesh: that they are on.
        corners: (F, 3, 2) float64, the texture coordinates of its faces in texels, v downward.
        size: width and height of the image, in texels.
        samples: points of each texel, at most.
        normals: "face", "smooth" or "lifted".
        corner_normals: (F, 3, 3) float64, of which the last two are made; None for the first.
        id: (P,) uint64, ascending: the texel times the number of samples, plus the sample's number.
        face: (P,) int32, the face that each point is on.
        report: counts of texels, and of faces that have none or share some.
        options: where points are computed.
    """

    mesh: Mesh
    corners: NDArray[np.float64]
    size: tuple[int, int]
    samples: int
    normals: str
    corner_normals: NDArray[np.float64] | None
    id: NDArray[np.uint64]
    face: NDArray[np.int32]
    report: TextureReport
    options: CallOptions

    def __len__(self) -> int:
        """How many points."""
        return len(self.id)

    @property
    def texel(self) -> np.ndarray:
        """(P,) int64, the texel of each point: row * width + column."""
        return (self.id // np.uint64(self.samples)).astype(np.int64)

    @property
    def covered(self) -> np.ndarray:
        """(H, W) bool: the texels that have a point, without those that images fill around them."""
        return self._texel_rows.covered.reshape(self.size[1], self.size[0])

    @once_property
    def points(self) -> SurfacePoints:
        """All points, with `id`, by which random numbers are drawn: those of a texel depend on nothing but its number."""
        return self.take(slice(None))

    def take(self, rows: slice) -> SurfacePoints:
        """The points of some rows, made when they are asked for: a large image is computed part by part.

        Args:
            rows: a slice of the P points.

        Returns:
            position and barycentric float64, normal, face (-1 of points that are lifted) and id.

        Raises:
            TypeError: no slice.

        Example:
            >>> triangle = ws.Mesh([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]])
            >>> t = ws.texture_points(triangle, [[[0, 1], [1, 1], [0, 0]]], 8)
            >>> print(len(t), t.take(slice(0, 2)).position.tolist())
            43 [[0.0625, 0.9375, 0.0], [0.125, 0.875, 0.0]]
        """
        if not isinstance(rows, slice):
            raise TypeError(f"rows: got {told(rows)}, want a slice")
        id, face = np.ascontiguousarray(self.id[rows]), np.ascontiguousarray(self.face[rows])
        how = {"samples": self.samples, "memory": self.options.memory, "workers": self.options.workers}
        weights = compute_weights(self.corners, id, face, self.size[0], **how)
        position, normal, on = shade_points(self.mesh, self.corner_normals, face, weights, self.normals)
        return SurfacePoints(position, normal, on, weights, id)

    def image(self, values: Any, *, gutter: Any = "all") -> np.ndarray:
        """The image of numbers at the points: of each texel the mean of its points.

        Texels none of whose points has a finite number are fill_texels from the nearest texel of the same chart that has one.

        Args:
            values: (P,) or (P, C) numbers, NaN of points that have none.
            gutter: how far from the texels that faces reach the others are fill_texels from the nearest one of these: "all", or
                a whole number of texels. What is left is 0.

        Returns:
            (H, W) or (H, W, C) float32, the first row at v = 0.

        Raises:
            TypeError, ValueError: numbers or a gutter that cannot be used.

        Example:
            >>> triangle = ws.Mesh([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]])
            >>> t = ws.texture_points(triangle, [[[0, 1], [1, 1], [0, 0]]], 4)
            >>> print(t.image(t.points.position[:, 0])[3])
            [0.125 0.375 0.625 0.875]
        """
        values = self._rows(values, "values")
        flat = values.reshape(len(self), *values.shape[1:] or (1,))
        return self._image(self._texel_rows.means(flat.shape[1], lambda rows, _: flat[rows])[0], values, gutter)

    def image_error(self, errors: Any, *, gutter: Any = "all") -> np.ndarray:
        """The image of the standard errors of what `image` shows.

        Args:
            errors: the `Estimate` at the points; of one sample a texel also its standard errors, (P,) or (P, C). With
                several samples the errors are of the differences between a texel's values, and rather too large:
                samples are stratified. A texel with one sample takes the differences of the texels around it.
            gutter: as of `image`.

        Returns:
            (H, W) or (H, W, C) float32; a texel that is fill_texels has the error of the one it is fill_texels from.

        Raises:
            TypeError, ValueError: errors or a gutter that cannot be used.

        Example:
            >>> triangle = ws.Mesh([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]])
            >>> t = ws.texture_points(triangle, [[[0, 1], [1, 1], [0, 0]]], 4, samples=4)
            >>> print(t.image_error(ws.ambient_occlusion(triangle, t.points, 16)).max())
            0.0
        """
        own = self._rows(getattr(errors, "standard_error", errors), "errors")
        flat = own.reshape(len(self), *own.shape[1:] or (1,))
        if self.samples == 1:
            made = self._texel_rows.means(flat.shape[1], lambda rows, _: flat[rows])[0]
        elif hasattr(errors, "value"):
            values = self._rows(errors.value, "errors").reshape(flat.shape)
            made = self._texel_rows.errors(values, flat, self.size[0])
        else:
            raise TypeError(f"errors: got {told(errors)}, want the Estimate: of {self.samples} samples the values tell")
        return self._image(made, own, gutter)

    @property
    def _texel_rows(self) -> TexelRows:
        return TexelRows(self.id, self.samples, self.size[0] * self.size[1])

    def _rows(self, values: Any, argument: str) -> np.ndarray:
        wants = f"({len(self)},) or ({len(self)}, C) real numbers, a row for each point"
        rows = as_real(values, argument, wants)
        if rows.ndim not in (1, 2) or len(rows) != len(self) or 0 in rows.shape[1:]:
            raise ValueError(f"{argument}: got shape {rows.shape}, want {wants}")
        return rows

    def _image(self, found: np.ndarray, rows: np.ndarray, gutter: Any) -> np.ndarray:
        made = fill_texels(found, self._texel_rows.covered, self._charts, self.size, check_gutter(gutter))
        return made if rows.ndim == 2 else made[..., 0]

    def _charts(self) -> np.ndarray:
        """(texels,) int32: the chart that each texel is of, -1 of none."""
        charts = np.full(self.size[0] * self.size[1], -1, np.int32)
        charts[self.texel[::-1]] = label_charts(self.corners)[self.face[::-1]]
        return charts


@explained_by(CallOptions)
def texture_points(
    mesh: Any,
    uv: Any,
    size: int | Sequence[int],
    *,
    samples: int = 1,
    normals: str = "face",
    corner_normals: Any = None,
    device: Any = None,
    workers: int | None = None,
) -> TexturePoints:
    """The texels of a texture as points on a mesh, at which everything that takes points is computed.

    A texel gets a point if a bilinear lookup on the surface reads it: if its centre is nearer than 1 texel to a face, along
    either axis. The point is where the centre is, or, if that is outside, the nearest point of a face; of several faces at
    the same distance the one of the lowest number has it. The id of a point is a number of its texel, so that the random
    numbers of a texel depend on nothing else.

    Args:
        mesh: a Mesh or whatever `as_mesh` takes.
        uv: (F, 3, 2) texture coordinates of the corners of its faces, u to the right and v down from the upper left corner
            of the image, as `load_uv` gives them; NaN of faces that have none.
        size: width and height of the image in texels, or one number for both.
        samples: how many points a texel gets. Of one, values are those at its centre; of several, means over the part of it
            that faces cover: they are stratified over the texel, and those outside of all faces are left out. Rays of
            each point are by as many fewer, for the same work.
        normals: "face" for the normals of the faces; "smooth" for those of their corners, interpolated, by which dark bands
            appear where the faces are few; "lifted" for the same at points moved to where the smooth surface would be.
        corner_normals: (F, 3, 3) of the corners of faces, of any length; by default those of the vertices.
        device, workers: see `CallOptions`.

    Returns:
        the points, and what makes images of numbers at them.

    Raises:
        TypeError, ValueError: an argument that cannot be used; names it, what it got and what it wants.
        MemoryError: more than is free.

    Source: Hasselgren2005 for what a face reaches; Hanika2021 for the lift.

    Example:
        >>> triangle = ws.Mesh([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]])
        >>> t = ws.texture_points(triangle, [[[0, 1], [1, 1], [0, 0]]], 64)
        >>> ao = ws.ambient_occlusion(triangle, t.points, 64)
        >>> print(t.report.covered, t.image(ao.value).shape, t.image(ao.value).min())
        2143 (64, 64) 1.0
    """
    mesh = as_mesh(mesh)
    uv, samples = _check_uv(uv, len(mesh.faces)), check_samples(samples)
    size = check_size(size, samples)
    check_choice(normals, "normals", NORMALS)
    unused = normals == "face"
    turned = None if unused and corner_normals is None else compute_corner_normals(mesh, corner_normals)
    options = CallOptions.of(1, device=device, workers=workers)
    flaws, corners = find_face_flaws(uv), uv * np.array(size, np.float64)
    claims = claim_points(corners, ~(flaws["without_uv"] | flaws["zero_area"]), size, samples, options.memory)
    report = build_report(mesh, claims.covered, claims.overlapped, flaws | {"overlapped": claims.overlapping})
    turned = None if unused else turned
    return TexturePoints(mesh, corners, size, samples, normals, turned, claims.id, claims.face, report, options)


def _check_uv(uv: Any, faces: int) -> np.ndarray:
    wants = f"({faces}, 3, 2) real numbers, u and v of each corner of a face"
    found = as_real(uv, "uv", wants)
    if found.shape != (faces, 3, 2):
        raise ValueError(f"uv: got shape {found.shape}, want {wants}")
    return found.astype(np.float64)


def check_samples(samples: Any, argument: str = "samples") -> int:
    """Points of a texel."""
    return check_integer(samples, argument, 1, _MOST_SAMPLES)


def check_size(size: Any, samples: int, argument: str = "size") -> tuple[int, int]:
    """Width and height of an image of so many samples a texel."""
    wants = f"a whole number from 1 to {_MOST_SIDE}, or two, width and height"
    both = size if isinstance(size, Sequence) and not isinstance(size, str | bytes) else (size, size)
    if len(both) != 2:
        raise ValueError(f"{argument}: got {told(size)}, want {wants}")
    width, height = (check_integer(side, argument, 1, _MOST_SIDE, wants) for side in both)
    if width * height * samples > MOST_TEXELS:
        raise ValueError(f"{argument}: got {told(size)} by {samples} samples a texel, want at most {MOST_TEXELS:,} in all")
    return width, height
