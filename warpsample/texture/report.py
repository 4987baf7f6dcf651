"""Report on texture coordinates: overlapping texels, faces outside the image, and other flaws."""

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from warpsample.mesh.mesh import Mesh

_OUTSIDE = 1e-6  # of the image: tolerance for coordinates 0 and 1 rounded to float32
_FLAT = 2.0**-48  # of the product of two edge lengths: a smaller area is rounding error (16 float64 epsilons)


@dataclass(frozen=True)
class TextureReport:
    """Report on texture coordinates: number of covered texels, and counts of overlaps and other flaws.

    Attributes:
        covered: number of texels with at least one point.
        overlapped: number of texels whose centres are strictly inside two or more faces. Such a texel shows the face of the
            lowest number.
        outside: number of faces partly or wholly outside the image. The part outside has no texels.
        zero_area: number of faces without an area in the image, which have no texels.
        mirrored: number of faces mirrored in the image, which is no flaw.
        without_uv: number of faces with coordinates that are not finite, which have no texels.
        named: names of the mesh parts with overlapped, outside, zero_area, mirrored and without_uv faces, keyed by these
            words; empty for a mesh without parts.
    """

    covered: int
    overlapped: int
    outside: int
    zero_area: int
    mirrored: int
    without_uv: int
    named: Mapping[str, tuple[str, ...]]


def find_face_flaws(uv: np.ndarray) -> dict[str, np.ndarray]:
    """Return masks of faces with flawed texture coordinates, (F,), keyed by flaw, for example "outside" or "mirrored"."""
    finite = np.isfinite(uv).all(axis=(1, 2))
    uv = np.where(finite[:, None, None], uv, 0.0)
    first, second = uv[:, 1] - uv[:, 0], uv[:, 2] - uv[:, 0]
    area = first[:, 0] * second[:, 1] - first[:, 1] * second[:, 0]
    lengths = np.sqrt((first**2).sum(axis=1) * (second**2).sum(axis=1))
    flat = finite & (np.abs(area) <= _FLAT * lengths)
    outside = (uv < -_OUTSIDE).any(axis=(1, 2)) | (uv > 1.0 + _OUTSIDE).any(axis=(1, 2))
    return {
        "outside": outside,
        "zero_area": flat,
        "mirrored": finite & ~flat & (area > 0.0),  # v points down
        "without_uv": ~finite,
    }


def build_report(mesh: Mesh, covered: int, overlapped: int, flaws: Mapping[str, np.ndarray]) -> TextureReport:
    """Build the report on a mesh's texture coordinates from counts of texels and masks of flawed faces."""
    counts = {name: int(np.count_nonzero(faces)) for name, faces in flaws.items() if name != "overlapped"}
    named = {name: _list_parts(mesh, faces) for name, faces in flaws.items()}
    return TextureReport(covered=covered, overlapped=overlapped, **counts, named=named)


def _list_parts(mesh: Mesh, faces: np.ndarray) -> tuple[str, ...]:
    """Return the names of the mesh parts that contain the faces in a mask, each once."""
    if mesh.part is None:
        return ()
    numbers = np.unique(mesh.part[faces])
    return tuple(dict.fromkeys(mesh.parts[number] for number in numbers[numbers >= 0].tolist()))
