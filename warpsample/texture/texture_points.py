"""Texels as points on a mesh, and images of values at the points: `texture_points`."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from warpsample.estimate.intervals import errors_for_means, raised_errors
from warpsample.host.arguments import check_choice, check_flag, quote
from warpsample.host.arrays import as_real
from warpsample.host.locks import once_property
from warpsample.host.options import CallOptions
from warpsample.host.summary import Summary
from warpsample.mesh.mesh import Mesh, as_mesh
from warpsample.mesh.surface import SurfacePoints, check_uv
from warpsample.mesh.tangents import compute_tangents
from warpsample.texture.claims import check_samples, check_size, claim_points, compute_weights
from warpsample.texture.image import TexelRows
from warpsample.texture.report import TextureReport, build_report, find_face_flaws, find_slivers, find_squeezed_faces
from warpsample.texture.shading import NORMALS, compute_corner_normals, shade_points
from warpsample.texture.uv.charts import label_charts


@dataclass(frozen=True, eq=False, repr=False)
class TexturePoints(Summary):
    """Texels of a texture as points on a mesh, with methods that turn values at the points into images.

    Attributes:
        mesh: mesh of the points.
        corners: (F, 3, 2) float64, texture coordinates of the face corners in texels, v downward. With `faces`, this and
            other arrays of corners have rows for these faces alone.
        size: width and height of the image in texels.
        samples: largest number of points per texel.
        normals: normals of the points: "face", "smooth" or "lifted".
        corner_normals: (F, 3, 3) float64, corner normals for "smooth" and "lifted"; None for "face".
        id: (P,) uint64, point numbers in ascending order: texel * samples + sample.
        face: (P,) int32, the face of each point.
        report: counts of texels, and of faces with flawed coordinates.
        options: device and number of threads for the computation of points.
        corner_tangents: (F, 3, 4) float64, tangents of face corners with the sign of the bitangent; None without tangents.
        faces: (R,) int64, ascending numbers of the faces with coordinates; None if the arrays have a row for each face.
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
    corner_tangents: NDArray[np.float64] | None = None
    faces: NDArray[np.int64] | None = None

    def __len__(self) -> int:
        """Return the number of points in all texels."""
        return len(self.id)

    @property
    def texel(self) -> np.ndarray:
        """Number of each point's texel, row * width + column, (P,) int64."""
        return (self.id // np.uint64(self.samples)).astype(np.int64)

    @property
    def covered(self) -> np.ndarray:
        """Mask of the texels with at least one point, (H, W) bool."""
        return self.texel_rows.covered.reshape(self.size[1], self.size[0]).copy()

    @once_property
    def points(self) -> SurfacePoints:
        """Compute all points, with `id`: the random numbers of a texel depend only on the texel's number."""
        return self.take(slice(None))

    def take(self, rows: slice) -> SurfacePoints:
        """Compute the points of some rows; use it to process a large image part by part.

        Args:
            rows: slice of the P points.

        Returns:
            points with position and barycentric (float64), normal, face (-1 for lifted points) and id, and with tangents if
            `texture_points` was asked for tangents.

        Raises:
            TypeError: `rows` is not a slice.

        Example:
            >>> triangle = ws.Mesh([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]])
            >>> t = ws.texture_points(triangle, [[[0, 1], [1, 1], [0, 0]]], 8)
            >>> print(len(t), t.take(slice(0, 2)).position.tolist())
            43 [[0.0625, 0.9375, 0.0], [0.125, 0.875, 0.0]]
        """
        if not isinstance(rows, slice):
            raise TypeError(f"rows: got {quote(rows)}, want a slice")
        id, face = np.ascontiguousarray(self.id[rows]), np.ascontiguousarray(self.face[rows])
        how = {"samples": self.samples, "memory": self.options.memory, "workers": self.options.workers}
        row = find_rows(self, face)
        weights = compute_weights(self.corners, id, row, self.size[0], **how)
        turned = None if self.corner_normals is None else self.corner_normals.take(row, axis=0)
        position, normal, on = shade_points(self.mesh, turned, face, weights, self.normals)
        tangent = None if self.corner_tangents is None else interpolate_tangents(self.corner_tangents, row, weights)
        return SurfacePoints(position, normal, on, weights, id, tangent=tangent)

    def image(self, values: Any, *, gutter: Any = "all") -> np.ndarray:
        """Return the image of values at the points; each texel has the mean of its points' values.

        A texel without a finite value is filled from the nearest texel of the same chart with one.

        Args:
            values: (P,) or (P, C) numbers, NaN for points without a value.
            gutter: Distance in texels up to which texels without points are filled from the nearest texel with points, or
                "all". Texels farther away are 0. Default: "all".

        Returns:
            (H, W) or (H, W, C) float32, with the first row at v = 0.

        Raises:
            TypeError, ValueError: `values` or `gutter` is invalid.

        Example:
            >>> triangle = ws.Mesh([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]])
            >>> t = ws.texture_points(triangle, [[[0, 1], [1, 1], [0, 0]]], 4)
            >>> print(t.image(t.points.position[:, 0])[3])
            [0.125 0.375 0.625 0.875]
        """
        return self.precise_image(values, gutter=gutter).astype(np.float32)

    def precise_image(self, values: Any, *, gutter: Any = "all") -> np.ndarray:
        """Return the same image as `image` in float64, for values such as positions far from the origin.

        Args:
            values: (P,) or (P, C) numbers, as for `image`.
            gutter: Fill distance, as for `image`. Default: "all".

        Returns:
            (H, W) or (H, W, C) float64.

        Raises:
            TypeError, ValueError: `values` or `gutter` is invalid.

        Example:
            >>> triangle = ws.Mesh([[1e7, 0, 0], [1e7 + 1, 0, 0], [1e7, 1, 0]], [[0, 1, 2]])
            >>> t = ws.texture_points(triangle, [[[0, 1], [1, 1], [0, 0]]], 4)
            >>> print(t.precise_image(t.points.position[:, 0])[3])
            [10000000.125 10000000.375 10000000.625 10000000.875]
        """
        values = self._check_rows(values, "values")
        texels = self.texel_rows
        mean, _ = texels.means(values.reshape(len(self), *values.shape[1:] or (1,)))
        return texels.fill(mean, gutter, values.shape[1:])

    def image_error(self, errors: Any, *, gutter: Any = "all") -> np.ndarray:
        """Return the image of the standard errors of the values that `image` shows.

        Args:
            errors: `Estimate` at the points, or with one sample per texel standard errors, (P,) or (P, C). Where all rays of
                a point agree, the error of an `Estimate` is that of its interval, unless the point is proven to be free.
                With several samples, the errors come from the spread of the values in a texel and from the runs of reflected
                light. They are up to 5 times too large, since samples are stratified. A texel with a single sample uses the
                spread in the surrounding texels.
            gutter: Fill distance, as for `image`. Default: "all".

        Returns:
            (H, W) or (H, W, C) float32. A filled texel has the error of its source texel. Infinite errors stay
            infinite.

        Raises:
            TypeError, ValueError: `errors` or `gutter` is invalid, for example a negative error.

        Example:
            >>> triangle = ws.Mesh([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]])
            >>> t = ws.texture_points(triangle, [[[0, 1], [1, 1], [0, 0]]], 4, samples=4)
            >>> print(t.image_error(ws.ambient_occlusion(triangle, t.points, 16)).max())
            0.0
        """
        values, own = None, errors
        if hasattr(errors, "standard_error") and hasattr(errors, "value"):
            values, shape = self._check_rows(errors.value, "errors"), np.shape(errors.standard_error)
            if values.shape != shape:
                raise ValueError(f"errors: got {shape} standard errors of {values.shape} values, want equal shapes")
            own = raised_errors(errors) if self.samples == 1 else errors_for_means(errors)
        own = self._check_rows(own, "errors")
        least = np.fmin.reduce(own, axis=None, initial=0)
        if least < 0:
            raise ValueError(f"errors: got {least:g}, want standard errors of at least 0, or NaN for points without a value")
        if values is not None:
            own = np.where(np.isfinite(values), own, np.nan)
        flat, texels = own.reshape(len(self), *own.shape[1:] or (1,)), self.texel_rows
        if self.samples == 1:
            return texels.fill(texels.copy_errors(flat), gutter, own.shape[1:]).astype(np.float32)
        if values is None:
            raise TypeError(
                f"errors: got {quote(errors)}, want the whole Estimate, because errors of {self.samples} samples per "
                "texel need its values, too"
            )
        values = values.reshape(flat.shape)
        made = texels.means_and_errors(values, [flat])[1]
        if getattr(errors, "reflected", None) is not None:
            if errors.reflected_runs is None:
                raise ValueError("errors: got a series of light that faces reflect, want the light of the whole period")
            made = np.hypot(made, texels.shared_errors(values, errors.reflected_runs))
        return texels.fill(made, gutter, own.shape[1:]).astype(np.float32)

    @property
    def texel_rows(self) -> TexelRows:
        """Return the grouping of the points by texel."""
        return TexelRows(self.id, self.samples, self.size, self._charts)

    def _check_rows(self, values: Any, argument: str) -> np.ndarray:
        wants = f"({len(self)},) or ({len(self)}, C) real numbers, one row for each point"
        rows = as_real(values, argument, wants)
        if rows.ndim not in (1, 2) or len(rows) != len(self) or 0 in rows.shape[1:]:
            raise ValueError(f"{argument}: got shape {rows.shape}, want {wants}")
        return rows

    def _charts(self) -> np.ndarray:
        """Return the number of the UV chart of each texel, (texels,) int32; -1 for texels outside all charts."""
        charts = np.full(self.size[0] * self.size[1], -1, np.int32)
        charts[self.texel[::-1]] = label_charts(self.corners)[find_rows(self, self.face[::-1])]
        return charts


def texture_points(
    mesh: Any,
    uv: Any,
    size: int | Sequence[int],
    *,
    samples: int = 1,
    normals: str = "face",
    corner_normals: Any = None,
    tangents: bool = False,
    device: Any = None,
    workers: int | None = None,
) -> TexturePoints:
    """Return the texels of a texture as points on a mesh, for use with every function that takes points.

    A texel gets a point if a bilinear lookup on the surface reads the texel: its centre is closer than 1 texel to a face
    along both axes. The point is at the centre or, if the centre is outside all faces, at the nearest point of a face. Among
    faces at the same distance, the one with the lowest number is taken. The id of a point, and so its random numbers,
    depends only on the texel.

    Args:
        mesh: Mesh or anything that `as_mesh` accepts.
        uv: (F, 3, 2) texture coordinates of face corners, as from `load_uv`: u to the right and v down from the upper left
            corner of the image. NaN for faces without coordinates.
        size: Width and height of the image in texels, or one number for both.
        samples: Number of points per texel, 1 to 1024: one at its centre, or several, stratified over the part that faces
            cover, for means over that part. Default: 1.
        normals: "face" for face normals, "smooth" for interpolated corner normals, which make dark bands on coarse meshes,
            or "lifted" for interpolated normals at points moved to the smooth surface. Default: "face".
        corner_normals: (F, 3, 3) normals of face corners, of any length. Default: None, those of the vertices.
        tangents: Whether the points have tangents, along which u grows, by MikkTSpace. Directions are then sampled in these
            frames. Default: False.
        device: Warp device, such as "cuda:0", which computes in parts and returns NumPy arrays. Default: None, the CPU.
        workers: Number of CPU threads, an integer. Default: None, the value of WARPSAMPLE_WORKERS or all cores.

    Returns:
        the points, with methods that make images of values at the points.

    Raises:
        TypeError, ValueError: an argument is invalid; the message names it.
        MemoryError: the image needs more memory than is free.

    Source: Hasselgren2005 for the coverage test; Hanika2021 for lifted points; Mikkelsen2008 for tangents.

    Example:
        >>> triangle = ws.Mesh([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]])
        >>> t = ws.texture_points(triangle, [[[0, 1], [1, 1], [0, 0]]], 64)
        >>> ao = ws.ambient_occlusion(triangle, t.points, 64)
        >>> print(t.report.covered, t.image(ao.value).shape, t.image(ao.value).min())
        2143 (64, 64) 1.0
    """
    mesh = as_mesh(mesh)
    uv, samples = check_uv(uv, len(mesh.faces)), check_samples(samples)
    size = check_size(size, samples)
    check_choice(normals, "normals", NORMALS)
    turned = None if normals == "face" and corner_normals is None else compute_corner_normals(mesh, corner_normals)
    options = CallOptions.of(1, device=device, workers=workers)
    made = place_texels(mesh, None, uv, turned, size, samples=samples, normals=normals, options=options)
    return replace(made, corner_tangents=_corner_tangents(made, uv)) if check_flag(tangents, "tangents") else made


def place_texels(
    mesh: Mesh,
    faces: np.ndarray | None,
    uv: np.ndarray,
    corner_normals: np.ndarray | None,
    size: tuple[int, int],
    *,
    samples: int,
    normals: str,
    options: CallOptions,
) -> TexturePoints:
    """Return the texels of some faces as points, see `texture_points`, in time and memory of these faces alone.

    Args:
        mesh: mesh with the faces.
        faces: (R,) int64, ascending numbers of the faces; None for all faces.
        uv: (R, 3, 2) texture coordinates of their corners.
        corner_normals: (R, 3, 3) unit normals of their corners; None or unused for "face".
        size: width and height of the image.
        samples: number of points per texel.
        normals: normals of the points, one of NORMALS.
        options: device and number of threads.
    """
    flaws, corners = find_face_flaws(uv), uv * np.array(size, np.float64)
    claims = claim_points(corners, ~(flaws["without_uv"] | flaws["zero_area"]), size, samples, options.memory)
    slivers = find_slivers(mesh, faces, flaws["zero_area"])
    squeezed = find_squeezed_faces(mesh, faces, corners, flaws["zero_area"])
    flaws |= {"overlapped": claims.overlapping, "squeezed": squeezed}
    flaws |= {"zero_area": flaws["zero_area"] & ~slivers, "flat_slivers": slivers}
    report = build_report(mesh, faces, claims.covered, claims.overlapped, flaws)
    turned = None if normals == "face" else corner_normals
    on = claims.face if faces is None else faces.astype(np.int32)[claims.face]
    return TexturePoints(mesh, corners, size, samples, normals, turned, claims.id, on, report, options, None, faces)


def _corner_tangents(points: TexturePoints, uv: np.ndarray) -> np.ndarray:
    """Return the (F, 3, 4) tangents of face corners, 0 for faces without coordinates; by default for face normals."""
    mesh, normals = points.mesh, points.corner_normals
    normals = np.repeat(mesh.face_normals[:, None], 3, axis=1) if normals is None else normals
    known = np.flatnonzero(np.isfinite(uv).all(axis=(1, 2)))
    made = np.zeros((len(uv), 3, 4))
    made[known] = compute_tangents(mesh.vertices[mesh.faces[known]], normals[known].astype(np.float64), uv[known])
    return made


def find_rows(points: TexturePoints, face: np.ndarray) -> np.ndarray:
    """Return the rows of some faces, (n,) int32, in `corners` and other arrays of corners."""
    return face if points.faces is None else np.searchsorted(points.faces, face).astype(np.int32)


def interpolate_tangents(corners: np.ndarray, face: np.ndarray, weights: np.ndarray) -> np.ndarray:
    """Interpolate the tangents of face corners at points, (P, 4) float32: unit vector and sign of the bitangent."""
    made = np.empty((len(face), 4), np.float32)
    made[:, :3] = sum(weights[:, k : k + 1] * corners[face, k, :3] for k in range(3))
    made[:, 3] = corners[face, 0, 3]
    return made
