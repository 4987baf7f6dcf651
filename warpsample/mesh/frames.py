"""Frames of surface points: checks of tangents, and the change between world and local coordinates."""

from typing import Any

import numpy as np
import warp as wp

from warpsample.host.arrays import as_real, cpu
from warpsample.host.engine import check_workers, run
from warpsample.host.locks import once
from warpsample.host.vectors import as_directions
from warpsample.maths.frames import frame_about, frame_along, to_local, to_world
from warpsample.maths.memory import set_vec3, vec3_at, vec4_at
from warpsample.maths.numerics import scaled_to_unit

_BLOCK = 256  # points of a task


def as_tangents(value: Any, points: int, argument: str = "tangent", one_for_all: bool = False) -> np.ndarray:
    """Return tangents as a C-contiguous (P, 4) float32 array, with the sign of the bitangent last.

    Raises:
        TypeError: the value is no array of real numbers.
        ValueError: the shape is neither (P, 3) nor (P, 4), nor (3,) if one vector may hold for all points.
    """
    array = as_real(value, argument)
    if one_for_all and array.shape == (3,):
        array = np.broadcast_to(array, (points, 3))
    if array.ndim != 2 or len(array) != points or array.shape[1] not in (3, 4):
        also = ", or (3,) for all points" if one_for_all else ""
        raise ValueError(f"{argument}: got shape {array.shape}, want {(points, 3)} or {(points, 4)}{also}")
    if array.shape[1] == 4 and array.dtype == np.float32 and array.flags.c_contiguous:
        return array
    made = np.ones((points, 4), np.float32)
    made[:, :3] = as_directions(array[:, :3])
    if array.shape[1] == 4:
        made[:, 3] = np.sign(array[:, 3])
    return made


def turn_vectors(normal: np.ndarray, tangent: np.ndarray | None, vectors: Any, *, to_world: bool) -> np.ndarray:
    """Convert vectors at points between world coordinates and the points' tangent frames.

    Args:
        normal: (P, 3) normals of any length.
        tangent: (P, 4) float32, see `as_tangents`, or None.
        vectors: (3,), (P, 3) or (P, n, 3) real numbers.
        to_world: whether to change from local to world coordinates.

    Returns:
        (P, 3) or (P, n, 3) float32.
    """
    points, array = len(normal), as_real(vectors, "vectors")
    if array.shape == (3,):
        array = np.broadcast_to(array, (points, 3))
    if array.ndim not in (2, 3) or array.shape[0] != points or array.shape[-1] != 3:
        raise ValueError(f"vectors: got shape {array.shape}, want (3,), {(points, 3)} or ({points}, n, 3)")
    with np.errstate(over="ignore"):
        source, normals = np.ascontiguousarray(array, np.float32), as_directions(normal)
    target = np.empty_like(source)
    count = target.size // (3 * points) if points else 0
    tangents = 0 if tangent is None else tangent.ctypes.data
    inputs = [points, count, normals.ctypes.data, tangents, source.ctypes.data, target.ctypes.data]
    if target.size:
        kernel, tasks = _turn(tangent is not None, to_world), -(-points // _BLOCK)
        run(kernel, tasks, inputs, cpu(), workers=check_workers(None), work=points * count)
    return target


@wp.func
def _frame_without(n: wp.vec3, tangents: wp.uint64, point: wp.int64):
    """Return the frame of a point without a tangent: any two axes perpendicular to the normal."""
    return frame_about(n)


@wp.func
def _frame_with(n: wp.vec3, tangents: wp.uint64, point: wp.int64):
    """Return the frame of a point with a tangent: x along the tangent, z along the normal."""
    frame, _usable = frame_along(n, vec4_at(tangents, point))
    return frame


@once
def _turn(with_tangents: bool, outwards: bool) -> wp.Kernel:
    """Build the kernel that changes the coordinates of `count` vectors at each of `points` points."""
    frame_of, change = _frame_with if with_tangents else _frame_without, to_world if outwards else to_local

    @wp.kernel(module="unique", enable_backward=False, grid_stride=False)
    def turn(
        points: wp.int64,
        count: wp.int64,
        normals: wp.uint64,
        tangents: wp.uint64,
        source: wp.uint64,
        target: wp.uint64,
        first_task: wp.int64,
    ):
        first = (first_task + wp.int64(wp.tid())) * wp.int64(_BLOCK)
        for i in range(wp.int32(wp.min(wp.int64(_BLOCK), points - first))):
            point = first + wp.int64(i)
            unit = scaled_to_unit(vec3_at(normals, point))
            frame = frame_of(wp.vec3(unit[0], unit[1], unit[2]), tangents, point)
            if wp.abs(unit[3]) >= 0.1 or unit[3] != unit[3]:
                frame = wp.mat33(0.0)
            j = wp.int64(0)
            while j < count:
                set_vec3(target, point * count + j, change(frame, vec3_at(source, point * count + j)))
                j += wp.int64(1)

    return turn
