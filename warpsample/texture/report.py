"""Report on texture coordinates: overlapping texels, faces outside the image, and other flaws."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from warpsample.mesh.mesh import Mesh
from warpsample.texture.uv.charts import (
    POINT,
    find_edge_lengths,
    find_flat_areas,
    find_longest_edges,
    find_wide,
    label_charts,
)

_OUTSIDE = 1e-6  # of the image: tolerance for coordinates 0 and 1 rounded to float32
_FLAT = 2.0**-48  # of the longest edge's square: less is no area but a rounding error (16 float64 epsilons)
_LONG = 0.8  # of the longest edge of a face in the image
_TINY = 16.0  # texels: length of a face that xatlas may have stretched to a texel in an image an eighth as large
_WIDE = 8.0  # texels; a face of this width whose image is narrower than one texel is squeezed


@dataclass(frozen=True)
class TextureReport:
    """Report on texture coordinates: number of covered texels, and counts of overlaps and other flaws.

    Attributes:
        covered: number of texels with at least one point.
        overlapped: number of texels in which two or more faces overlap within 0.001 texels of the centre, or in which the
            areas of faces sum to more than a rectangle around these faces, as for very small faces that choose a colour of a
            palette. Such a texel shows the face of the lowest number.
        outside: number of faces partly or wholly outside the image. The part outside has no texels.
        zero_area: number of faces without an area in the image, which have no texels; without `flat_slivers`.
        flat_slivers: number of faces without an area in the image that are less than 1/10,000 as wide in space as their
            longest edge is long, as by rounding. They have no texels.
        mirrored: number of faces mirrored in the image, which is no flaw.
        without_uv: number of faces with coordinates that are not finite, which have no texels.
        squeezed: number of faces narrower than a texel in the image that would be wider than eight texels at the scale of
            their longest edge there, or of an edge nearly as long; faces of up to 16 texels in the image, also at the usual
            scale. A row of texels has all their values.
        named: names of the mesh parts with overlapped, outside, zero_area, flat_slivers, mirrored, without_uv and squeezed
            faces, keyed by these words; empty for a mesh without parts.
    """

    covered: int
    overlapped: int
    outside: int
    zero_area: int
    flat_slivers: int
    mirrored: int
    without_uv: int
    squeezed: int
    named: Mapping[str, tuple[str, ...]]


def merge_flaws(reports: Sequence[TextureReport], names: Sequence[str]) -> TextureReport:
    """Return the first report, with those flaws of the given names that only other reports have."""
    found = reports[0]
    for other in reports[1:]:
        for name in names:
            if getattr(other, name) and not getattr(found, name):
                named = {**found.named, name: other.named[name]}
                found = replace(found, **{name: getattr(other, name)}, named=named)
    return found


def find_face_flaws(uv: np.ndarray) -> dict[str, np.ndarray]:
    """Return masks of faces with flawed texture coordinates, (F,), keyed by flaw, for example "outside" or "mirrored"."""
    finite = np.isfinite(uv).all(axis=(1, 2))
    uv = np.where(finite[:, None, None], uv, 0.0)
    first, second = uv[:, 1] - uv[:, 0], uv[:, 2] - uv[:, 0]
    area = first[:, 0] * second[:, 1] - first[:, 1] * second[:, 0]
    flat = finite & (np.abs(area) <= _FLAT * find_longest_edges(uv) ** 2)
    return {
        "outside": find_outside_faces(uv),
        "zero_area": flat,
        "mirrored": finite & ~flat & (area > 0.0),  # v points down
        "without_uv": ~finite,
    }


def find_slivers(mesh: Mesh, faces: np.ndarray | None, among: np.ndarray) -> np.ndarray:
    """Return the mask of the faces in the mask `among`, (R,), that are slivers in space.

    `faces` holds the numbers of the R faces, or is None for all.
    """
    rows, slivers = np.flatnonzero(among), np.zeros(len(among), np.bool_)
    slivers[rows] = ~find_wide(mesh.vertices[mesh.faces[rows if faces is None else faces[rows]]])
    return slivers


def find_outside_faces(uv: np.ndarray) -> np.ndarray:
    """Return the (F,) mask of faces with a corner outside the image, by finite texture coordinates (F, 3, 2)."""
    return (uv < -_OUTSIDE).any(axis=(1, 2)) | (uv > 1.0 + _OUTSIDE).any(axis=(1, 2))


def find_squeezed_faces(mesh: Mesh, faces: np.ndarray | None, corners: np.ndarray, flat: np.ndarray) -> np.ndarray:
    """Return the mask of faces that the image shows much narrower than they are, (R,), as where u is wrapped from 1 to 0.

    A squeezed face is narrower than a texel in the image. It would be wider than eight texels at the scale of its longest
    edge there, or of one nearly as long. A face of up to 16 texels must be as wide at the usual scale of the image or of
    its chart, too, because xatlas stretches tiny faces to a texel.

    Args:
        mesh: Mesh.
        faces: (R,) numbers of the faces, or None for all.
        corners: (R, 3, 2) texture coordinates of face corners in texels, not finite for faces without coordinates.
        flat: (R,) mask of faces without an area, from `find_face_flaws`, which are not squeezed.
    """
    corners = np.where(np.isfinite(corners).all(axis=(1, 2), keepdims=True), corners, 0.0)
    lengths = find_edge_lengths(corners)
    longest = lengths.max(axis=1)
    area = 2.0 * find_flat_areas(corners)
    narrow = np.flatnonzero(~flat & (area < longest))
    number = narrow if faces is None else faces[narrow]
    edges = np.maximum(find_edge_lengths(mesh.vertices[mesh.faces[number]]), POINT)
    widths = 2.0 * mesh.face_areas[number, None] / edges
    is_long = lengths[narrow] > _LONG * longest[narrow, None]
    is_wide = is_long & (widths * lengths[narrow] > _WIDE * edges)
    squeezed = np.zeros(len(corners), np.bool_)
    if is_wide.any():
        scale = _find_usual_scale(mesh, slice(None) if faces is None else faces, corners)[narrow, None]
        squeezed[narrow] = (is_wide & ((widths * scale > _WIDE) | (longest[narrow, None] > _TINY))).any(axis=1)
    return squeezed


def _find_usual_scale(mesh: Mesh, faces: np.ndarray | slice, corners: np.ndarray) -> np.ndarray:
    """Return the usual number of texels per unit of length about each face, (R,): that of the image or of its chart.

    This is the larger one of two means weighted by area: that of the largest stretch of an edge, over the image, and that
    of the longest edges, over the chart.
    """
    lengths, edges = find_edge_lengths(corners), find_edge_lengths(mesh.vertices[mesh.faces[faces]])
    longest, chart = lengths.max(axis=1), label_charts(corners)
    area = np.where(longest > 0.0, mesh.face_areas[faces], 0.0)  # faces without coordinates do not count
    own = longest / np.maximum(edges.max(axis=1), POINT)
    of_charts = np.bincount(chart, area * own) / np.maximum(np.bincount(chart, area), POINT)
    stretch = (lengths / np.maximum(edges, POINT)).max(axis=1)
    return np.maximum(of_charts[chart], np.average(stretch, weights=area))


def build_report(
    mesh: Mesh, faces: np.ndarray | None, covered: int, overlapped: int, flaws: Mapping[str, np.ndarray]
) -> TextureReport:
    """Build the report on the texture coordinates of some faces from counts of texels and masks of flawed faces.

    `faces` holds the numbers of the faces, (R,), or is None for all.
    """
    counts = {name: int(np.count_nonzero(mask)) for name, mask in flaws.items() if name != "overlapped"}
    part = mesh.part if mesh.part is None or faces is None else mesh.part[faces]
    named = {name: () if part is None else _list_parts(mesh, part[mask]) for name, mask in flaws.items()}
    return TextureReport(covered=covered, overlapped=overlapped, **counts, named=named)


def _list_parts(mesh: Mesh, part: np.ndarray) -> tuple[str, ...]:
    """Return the names of the mesh parts with some numbers, each once."""
    numbers = np.unique(part)
    return tuple(dict.fromkeys(mesh.parts[number] for number in numbers[numbers >= 0].tolist()))
