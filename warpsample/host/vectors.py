"""Arrays of vectors in the form that kernels take, and checks of the argument `out`."""

from dataclasses import dataclass
from functools import lru_cache
from math import prod
from typing import Any

import numpy as np
import warp as wp

from warpsample.host.arrays import Array, cpu
from warpsample.host.neighbours import address_of, as_array, as_ndarray, describe_type, from_cuda, own_memory

_SHORTEST, _LONGEST = 1e-30, 1e30  # length of a float64 vector whose components keep their digits in float32
_FLOATS = (np.dtype(np.float32), np.dtype(np.float64))  # compared with a type, a dtype takes three times as long
_DIMENSIONS = {wp.vec2: 2, wp.vec3: 3}


@dataclass(frozen=True)
class Vectors:
    """Array of float32 vectors for kernels, with its memory address, shape and device.

    Attributes:
        owner: the array, which keeps the address valid.
        shape: shape of the array without the axis of the components.
        width: number of components of a vector.
        device: device whose memory holds the array.
    """

    owner: Array
    shape: tuple[int, ...]
    width: int
    device: wp.Device

    @property
    def address(self) -> int:
        """Memory address of the first component."""
        return address_of(self.owner)

    @property
    def count(self) -> int:
        """Number of vectors."""
        return prod(self.shape)


def as_vectors(value: Any, width: int, argument: str, shape: str = "(..., {})") -> Vectors:
    """Convert an array to float32 vectors, without a copy if it is contiguous float32 already.

    Args:
        value: array of floating-point numbers, whose last axis has the length `width`; or a wp.array of vectors.
        width: number of components of a vector.
        argument: name of the argument in errors; "normals" are scaled if float32 cannot hold their length.
        shape: format of the wanted shape in errors, with {} for `width`.

    Raises:
        TypeError: the value is no array of floating-point numbers.
        ValueError: the last axis has another length.
    """
    array = as_array(value, argument)
    if isinstance(array, wp.array):
        return _warp_vectors(array, width, argument)
    if array.dtype not in _FLOATS:
        raise TypeError(f"{argument}: got dtype {array.dtype}, want float32 (or float64, which is rounded to float32)")
    if array.ndim == 0 or array.shape[-1] != width:
        raise ValueError(f"{argument}: got shape {array.shape}, want {shape.format(width)}")
    owner = as_directions(array) if argument == "normals" else _rounded(array)
    return Vectors(owner, owner.shape[:-1], width, cpu())


def _rounded(array: np.ndarray) -> np.ndarray:
    """Round an array to contiguous float32; return an array unchanged that is contiguous float32 already."""
    if array.dtype == _FLOATS[0] and array.flags.c_contiguous and type(array) is np.ndarray:
        return array
    with np.errstate(over="ignore"):
        return np.ascontiguousarray(array, np.float32)


def as_directions(array: np.ndarray) -> np.ndarray:
    """Convert directions, (..., 3), of any length to float32; very long and short vectors are scaled first."""
    if array.dtype != _FLOATS[0]:
        largest = np.abs(array).max(axis=-1, initial=0.0)
        outside = np.isfinite(largest) & (largest > 0.0) & ~((largest > _SHORTEST) & (largest < _LONGEST))
        if outside.any():
            array = array.copy()
            array[outside] = np.ldexp(array[outside], -np.frexp(largest[outside])[1][:, None])
    return _rounded(array)


def _warp_vectors(array: wp.array, width: int, argument: str) -> Vectors:
    """Convert a wp.array of vectors, or of float32 numbers, to `Vectors`; raise the errors of `as_vectors`."""
    of_vectors = _DIMENSIONS.get(array.dtype) == width
    of_floats = array.dtype is wp.float32 and array.ndim > 0 and array.shape[-1] == width
    if not (of_vectors or of_floats):
        raise TypeError(
            f"{argument}: got a wp.array of {array.dtype.__name__} with shape {array.shape}, "
            f"want vec{width} or float32 with a last axis of {width}"
        )
    if not array.is_contiguous:
        raise ValueError(
            f"{argument}: got a wp.array that is not contiguous, want a contiguous array; wp.array.contiguous() makes one"
        )
    return Vectors(array, array.shape if of_vectors else array.shape[:-1], width, array.device)


def new_vectors(like: Vectors, shape: tuple[int, ...], width: int) -> Vectors:
    """Allocate vectors, without setting values, in an array of the same library and device as `like`.

    With `width` 1 the array has no axis of components.
    """
    if isinstance(like.owner, wp.array):
        kind = {1: wp.float32, 2: wp.vec2, 3: wp.vec3}[width]
        return Vectors(wp.empty(shape, dtype=kind, device=like.device), shape, width, like.device)
    return Vectors(np.empty(shape if width == 1 else (*shape, width), np.float32), shape, width, like.device)


@lru_cache(maxsize=64)
def _describe_output(shape: tuple[int, ...]) -> str:
    """Return the phrase for error messages that describes the required shape of `out`."""
    return f"a C-contiguous, writeable float32 array of shape {(*shape, 3)}"


def check_out(out: Any, like: Vectors, shape: tuple[int, ...]) -> Vectors:
    """Check the argument `out`, an array for (*shape, 3) float32 results, and return it as `Vectors`.

    Raises:
        TypeError: the array is of another library or another type.
        ValueError: the shape or the device is another one, or the array is not contiguous, is read-only, or overlaps the
            normals.
    """
    want = _describe_output(shape)
    out = own_memory(from_cuda(out, "out"), want)
    if isinstance(out, wp.array) and isinstance(like.owner, wp.array):
        vectors = _warp_vectors(out, 3, "out")
        if vectors.device != like.device:
            raise ValueError(
                f"out: got an array on {vectors.device}, want an array on {like.device}, the device of the normals"
            )
    elif isinstance(out, np.ndarray) and isinstance(like.owner, np.ndarray):
        as_ndarray(out, "out", want)
        if out.dtype != _FLOATS[0]:
            raise TypeError(f"out: got dtype {out.dtype}, want {want}")
        if not (out.flags.c_contiguous and out.flags.writeable):
            flaw = "read-only" if out.flags.c_contiguous else "not C-contiguous"
            raise ValueError(f"out: got an array that is {flaw}, want {want}")
        vectors = Vectors(out, out.shape[:-1], out.shape[-1] if out.ndim else 0, like.device)
    else:
        raise TypeError(f"out: got {describe_type(out)}, want {describe_type(like.owner)}, the type of the normals")
    if (*vectors.shape, vectors.width) != (*shape, 3):
        raise ValueError(f"out: got shape {(*vectors.shape, vectors.width)}, want {want}")
    first, other = vectors.address, like.address
    if first < other + 12 * like.count and other < first + 12 * prod(shape):
        raise ValueError("out: got an array that overlaps the normals, want an array with memory of its own")
    return vectors
