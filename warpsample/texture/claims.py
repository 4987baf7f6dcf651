"""Assignment of the texels of an image to the faces of a mesh, and detection of faces that overlap in the image."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from warpsample.host.arguments import check_integer, quote
from warpsample.host.device_memory import Memory
from warpsample.host.engine import check_memory, run
from warpsample.sequences.hashing import seed_for
from warpsample.texture.coverage import claim_texels, mark_overlaps, weigh_corners
from warpsample.texture.uv.charts import find_box_sides, find_flat_areas

_BYTES = 42  # memory per texel while texels are assigned to faces
_POINT_BYTES = 25  # memory per point afterwards
_MOST_TEXELS = (1 << 31) - 1  # times samples per texel: kernels index samples by int32
_MOST_SAMPLES, _MOST_SIDE = 1024, 1 << 16
_TASK = 1 << 16  # texels per kernel task; the bounding box of a large face is divided among several tasks
_SEED = seed_for("texels", 0)
_LAST_FACE = 0xFFFFFFFF
_CROWDED = 1.1  # times the area of a rectangle; 1 plus rounding of the areas of very narrow faces


@dataclass(frozen=True, eq=False)
class Claims:
    """Assignment of texels to faces: points in texels, each with its number and the face that covers it.

    Attributes:
        id: (P,) uint64, point numbers in ascending order: (row * width + column) * samples + sample.
        face: (P,) int32, the face of each point.
        covered: number of texels with at least one point.
        overlapped: number of texels with a point within 0.001 texels of the centre that is inside two or more faces, and of
            texels with crowded faces.
        overlapping: (F,) bool, faces that contain this point of an overlapped texel, and crowded faces.
    """

    id: np.ndarray
    face: np.ndarray
    covered: int
    overlapped: int
    overlapping: np.ndarray


def claim_points(corners: np.ndarray, usable: np.ndarray, size: tuple[int, int], samples: int, memory: Memory) -> Claims:
    """Find all texels that a viewer reads when it draws the faces, and return a point with a face for each.

    With one sample, a point is at the texel's centre, or at the nearest point of a face. With several samples, a texel has a
    point for each sample inside a face, or for its first sample if none is inside.

    Args:
        corners: (F, 3, 2) float64, corners of the faces in texels.
        usable: (F,) bool, faces that may have texels.
        size: columns and rows of the image.
        samples: samples per texel.
        memory: memory of the device that runs the kernels.

    Raises:
        MemoryError: the image needs more memory than is free.
    """
    texels, images = size[0] * size[1], f"images of {size[0]} x {size[1]} texels"
    check_memory(texels * (_BYTES + 4 * samples), images, "take fewer texels")
    nearest, centre_counts = np.zeros(texels, np.uint64), np.zeros(texels, np.int32)
    owners = np.zeros(texels * samples if samples > 1 else 0, np.uint32)
    marks = np.zeros(len(corners), np.int32)
    boxes, tasks, rows = _split_into_tasks(corners, usable, size)
    sides = np.maximum(boxes[:, 1::2] - boxes[:, ::2], 0)
    work = int(sides.prod(axis=1, dtype=np.int64).sum())  # texels in the boxes of all faces, many times those of the image
    with memory.loan() as loan:
        shared_inputs = loan.lend(corners), loan.lend(boxes), loan.lend(tasks), rows
        with memory.loan() as inner:
            outputs = [inner.output(array, zero=True) if array.size else 0 for array in (nearest, owners, centre_counts)]
            inputs = [*shared_inputs, *size, samples, len(corners), _SEED, *outputs]
            if len(tasks):  # one thread: Warp's atomic functions are not atomic on the CPU
                run(claim_texels(), len(tasks), inputs, memory.device, workers=1, work=work * samples)
        overlapped = centre_counts > 1
        if overlapped.any():
            inputs = [*shared_inputs, size[0], loan.lend(centre_counts), loan.output(marks, zero=True)]
            run(mark_overlaps(), len(tasks), inputs, memory.device, workers=1, work=work)
    id, face = _list_points(nearest, owners, samples, len(corners))
    check_memory(len(id) * _POINT_BYTES, images, "take fewer texels")
    crowded, crowded_texels = _find_crowded(corners, usable, size)
    overlapped[crowded_texels] = True
    return Claims(id, face, int(np.count_nonzero(nearest)), int(np.count_nonzero(overlapped)), (marks > 0) | crowded)


def _find_crowded(corners: np.ndarray, usable: np.ndarray, size: tuple[int, int]) -> tuple[np.ndarray, np.ndarray]:
    """Find faces that must overlap, although they may be smaller than a texel and contain no centre.

    Faces with their middles in one texel are crowded if their areas sum to more than a rectangle around them all, as where
    coordinates only choose a colour of a palette. Arguments are those of `claim_points`.

    Returns:
        The (F,) mask of the crowded faces, and the numbers of their texels.
    """
    rows = np.flatnonzero(usable)
    middle = np.floor(corners[rows].mean(axis=1))
    inside = ((middle >= 0.0) & (middle < size)).all(axis=1)
    rows, middle = rows[inside], middle[inside]
    texel, group = np.unique(middle.astype(np.int64) @ (1, size[0]), return_inverse=True)
    sides = find_box_sides(corners[rows], group)
    crowded = np.bincount(group, find_flat_areas(corners[rows])) > _CROWDED * np.prod(sides, axis=1)
    mask = np.zeros(len(corners), np.bool_)
    mask[rows] = crowded[group]
    return mask, texel[crowded]


def compute_weights(
    corners: np.ndarray, id: np.ndarray, face: np.ndarray, width: int, *, samples: int, memory: Memory, workers: int
) -> np.ndarray:
    """Return the (P, 3) float64 barycentric weights of the points of `Claims` on their faces."""
    weights = np.empty((len(id), 3))
    with memory.loan() as loan:
        inputs = [loan.lend(corners), loan.lend(id), loan.lend(face), width, samples, _SEED, loan.output(weights)]
        if len(id):
            run(weigh_corners(), len(id), inputs, memory.device, workers=workers, work=8 * len(id))
    return weights


def _split_into_tasks(corners: np.ndarray, usable: np.ndarray, size: tuple[int, int]) -> tuple[np.ndarray, np.ndarray, int]:
    """Divide the texels around each face into kernel tasks; return (boxes of texels, tasks, image rows per task).

    Boxes and tasks have the layout that `claim_texels` describes. A box holds all texels with a centre nearer than 1 to the
    face, along both axes.
    """
    most = np.array(size, np.float64)
    with np.errstate(invalid="ignore"):
        low = np.clip(np.floor(corners.min(axis=1) - 1.5) + 1.0, 0.0, most)
        high = np.clip(np.ceil(corners.max(axis=1) + 0.5), 0.0, most)
    boxes = np.stack([low, high], axis=2).reshape(-1, 4)
    boxes[~usable] = 0.0
    boxes = boxes.astype(np.int32)
    rows = max(1, _TASK // size[0])
    height = np.where(boxes[:, 1] > boxes[:, 0], boxes[:, 3] - boxes[:, 2], 0)
    counts = -(-height // rows)
    face = np.repeat(np.arange(len(boxes), dtype=np.int32), counts)
    part = np.arange(len(face)) - np.repeat(np.cumsum(counts) - counts, counts)
    return boxes, np.stack([face, boxes[face, 2] + rows * part], axis=1).astype(np.int32), rows


def _list_points(nearest: np.ndarray, owners: np.ndarray, samples: int, faces: int) -> tuple[np.ndarray, np.ndarray]:
    """Return (point numbers, face numbers) of all points, from the output arrays of the kernel of `claim_texels`."""
    texel = np.flatnonzero(nearest)
    face = (np.uint64(_LAST_FACE) - (nearest[texel] & np.uint64(_LAST_FACE))).astype(np.int32)
    if samples == 1:
        return texel.view(np.uint64), face
    alone = np.flatnonzero(~owners.reshape(-1, samples)[texel].any(axis=1))
    owners[texel[alone] * samples] = faces - face[alone]
    id = np.flatnonzero(owners)
    return id.view(np.uint64), (np.uint32(faces) - owners[id]).view(np.int32)


def check_samples(samples: Any, argument: str = "samples") -> int:
    """Check the option `samples`, the number of points per texel, and return it."""
    return check_integer(samples, argument, 1, _MOST_SAMPLES)


def check_size(size: Any, samples: int, argument: str = "size") -> tuple[int, int]:
    """Return the checked width and height of an image with `samples` samples per texel."""
    wants = f"a whole number from 1 to {_MOST_SIDE}, or two, width and height"
    both = size if isinstance(size, Sequence) and not isinstance(size, str | bytes) else (size, size)
    if len(both) != 2:
        raise ValueError(f"{argument}: got {quote(size)}, want {wants}")
    width, height = (check_integer(side, argument, 1, _MOST_SIDE, wants) for side in both)
    if width * height * samples > _MOST_TEXELS:
        raise ValueError(
            f"{argument}: got {quote(size)} with {samples} samples per texel, want at most {_MOST_TEXELS:,} samples in all"
        )
    return width, height
