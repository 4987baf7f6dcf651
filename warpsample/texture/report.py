"""What texture coordinates are like: what of them an image can hold, and what not."""

from collections.abc import Mapping
from dataclasses import dataclass
from types import MappingProxyType

import numpy as np

from warpsample.mesh.mesh import Mesh

_OUTSIDE = 1e-6  # of the image: float32 roundings of 0 and 1
_FLAT = 2.0**-48  # of the product of two edges: below 16 roundings of it a face has no area


@dataclass(frozen=True)
class TextureReport:
    """Counts of what texture coordinates do to an image.

    Attributes:
        covered: texels that have a point.
        overlapped: texels whose centres are strictly inside of two or more faces; they show the one of the lowest number.
        outside: faces that reach beyond the image; what is out there has no texels.
        zero_area: faces without an area in the image; they have no texels of their own.
        mirrored: faces that the image shows mirrored, which is no flaw.
        without_uv: faces whose coordinates are not finite; they have no texels.
        named: which parts of the mesh the overlapped, outside, zero_area, mirrored and without_uv ones are of, by the names
            of the counts; empty for a mesh without parts.
    """

    covered: int
    overlapped: int
    outside: int
    zero_area: int
    mirrored: int
    without_uv: int
    named: Mapping[str, tuple[str, ...]]


def find_face_flaws(uv: np.ndarray) -> dict[str, np.ndarray]:
    """(F,) bool for each of outside, zero_area, mirrored and without_uv: which faces (F, 3, 2) float64 are that."""
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
    """The report on texels of a mesh; `flaws` are (F,) bool by name, those of "overlapped" among them."""
    counts = {name: int(np.count_nonzero(faces)) for name, faces in flaws.items() if name != "overlapped"}
    named = {name: _list_parts(mesh, faces) for name, faces in flaws.items()}
    return TextureReport(covered=covered, overlapped=overlapped, **counts, named=MappingProxyType(named))


def _list_parts(mesh: Mesh, faces: np.ndarray) -> tuple[str, ...]:
    """The names of the parts that some faces are of, each once, in the order of the parts."""
    if mesh.part is None:
        return ()
    numbers = np.unique(mesh.part[faces])
    return tuple(dict.fromkeys(mesh.parts[number] for number in numbers[numbers >= 0].tolist()))
