"""Arrays of vectors as kernels take them: their memory, size and device; and those that results are written to."""

from dataclasses import dataclass
from functools import lru_cache
from math import prod
from typing import Any

import numpy as np
import warp as wp

from warpsample.host.arrays import Array, cpu
from warpsample.host.neighbours import address_of, as_ndarray, from_cuda, kind_told, own_memory

_SHORTEST, _LONGEST = 1e-30, 1e30  # of a vector in float64 whose components keep their digits in float32
_FLOATS = (np.dtype(np.float32), np.dtype(np.float64))  # compared with a type, a dtype takes three times as long
_DIMENSIONS = {wp.vec2: 2, wp.vec3: 3}


@dataclass(frozen=True)
class Vectors:
    """An array of float32 vectors, C-contiguous, on a device; its shape is without the vectors' own axis, `width` long.

    Holding `owner`, the array, keeps the address valid.
    """

    owner: Array
    shape: tuple[int, ...]
    width: int
    device: wp.Device

    @property
    def address(self) -> int:
        """Address of the first component."""
        return address_of(self.owner)

    @property
    def count(self) -> int:
        """How many vectors."""
        return prod(self.shape)


def as_vectors(value: Any, width: int, argument: str, shape: str = "(..., {})") -> Vectors:
    """`value` as float32 vectors; without a copy where it is C-contiguous float32 already.

    What is no array of floating-point numbers is a TypeError, a last axis that is not `width` long a ValueError.
    """
    value = from_cuda(value, argument)
    if isinstance(value, wp.array):
        return _warp_vectors(value, width, argument)
    array = as_ndarray(value, argument)
    if array.dtype not in _FLOATS:
        raise TypeError(f"{argument}: got dtype {array.dtype}, want float32 (or float64, which is rounded to float32)")
    if array.ndim == 0 or array.shape[-1] != width:
        raise ValueError(f"{argument}: got shape {array.shape}, want {shape.format(width)}")
    owner = as_directions(array) if argument == "normals" else _rounded(array)
    return Vectors(owner, owner.shape[:-1], width, cpu())


def _rounded(array: np.ndarray) -> np.ndarray:
    """The array as C-contiguous float32, copied only if it is not that already."""
    if array.dtype == _FLOATS[0] and array.flags.c_contiguous and type(array) is np.ndarray:
        return array
    with np.errstate(over="ignore"):
        return np.ascontiguousarray(array, np.float32)


def as_directions(array: np.ndarray) -> np.ndarray:
    """(..., 3) vectors of any length as float32 ones: scaled by a power of two where their length has no float32."""
    if array.dtype != _FLOATS[0]:
        largest = np.abs(array).max(axis=-1, initial=0.0)
        outside = np.isfinite(largest) & (largest > 0.0) & ~((largest > _SHORTEST) & (largest < _LONGEST))
        if outside.any():
            array = array.copy()
            array[outside] = np.ldexp(array[outside], -np.frexp(largest[outside])[1][:, None])
    return _rounded(array)


def _warp_vectors(array: wp.array, width: int, argument: str) -> Vectors:
    of_vectors = _DIMENSIONS.get(array.dtype) == width
    of_floats = array.dtype is wp.float32 and array.ndim > 0 and array.shape[-1] == width
    if not (of_vectors or of_floats):
        raise TypeError(
            f"{argument}: got a wp.array of {array.dtype.__name__} with shape {array.shape}, "
            f"want vec{width} or float32 with a last axis of {width}"
        )
    if not array.is_contiguous:
        raise ValueError(
            f"{argument}: got a wp.array that is not contiguous, want a contiguous one (see wp.array.contiguous)"
        )
    return Vectors(array, array.shape if of_vectors else array.shape[:-1], width, array.device)


def new_vectors(like: Vectors, shape: tuple[int, ...], width: int) -> Vectors:
    """Uninitialised vectors of the same kind, NumPy's or Warp's, on the same device. Width 1 has no axis of its own."""
    if isinstance(like.owner, wp.array):
        kind = {1: wp.float32, 2: wp.vec2, 3: wp.vec3}[width]
        return Vectors(wp.empty(shape, dtype=kind, device=like.device), shape, width, like.device)
    return Vectors(np.empty(shape if width == 1 else (*shape, width), np.float32), shape, width, like.device)


@lru_cache(maxsize=64)
def _wanted(shape: tuple[int, ...]) -> str:
    """What `out` is to be, in words that are seldom read."""
    return f"a C-contiguous, writeable float32 array of shape {(*shape, 3)}"


def check_out(out: Any, like: Vectors, shape: tuple[int, ...]) -> Vectors:
    """The caller's own output array, if it can be written as it is: (*shape, 3) float32, C-contiguous, same kind and device.

    Another kind or type is a TypeError; another shape or device, and one that is not contiguous, read-only, or over the
    normals, a ValueError.
    """
    want = _wanted(shape)
    out = own_memory(from_cuda(out, "out"), want)
    if isinstance(out, wp.array) and isinstance(like.owner, wp.array):
        vectors = _warp_vectors(out, 3, "out")
        if vectors.device != like.device:
            raise ValueError(f"out: got an array on {vectors.device}, want one on {like.device}, where the normals are")
    elif isinstance(out, np.ndarray) and isinstance(like.owner, np.ndarray):
        as_ndarray(out, "out", want)
        if out.dtype != _FLOATS[0]:
            raise TypeError(f"out: got dtype {out.dtype}, want {want}")
        if not (out.flags.c_contiguous and out.flags.writeable):
            flaw = "read-only" if out.flags.c_contiguous else "not C-contiguous"
            raise ValueError(f"out: got an array that is {flaw}, want {want}")
        vectors = Vectors(out, out.shape[:-1], out.shape[-1] if out.ndim else 0, like.device)
    else:
        raise TypeError(f"out: got {kind_told(out)}, want {kind_told(like.owner)}, as the normals are")
    if (*vectors.shape, vectors.width) != (*shape, 3):
        raise ValueError(f"out: got shape {(*vectors.shape, vectors.width)}, want {want}")
    first, other = vectors.address, like.address
    if first < other + 12 * like.count and other < first + 12 * prod(shape):
        raise ValueError("out: got an array that overlaps the normals, want one apart from them")
    return vectors
