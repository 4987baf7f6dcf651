"""The arrays of users: checked once, and from then on known by their address."""

from dataclasses import dataclass
from functools import cached_property
from math import frexp, hypot, inf, ldexp, prod
from typing import Any, TypeAlias

import numpy as np
import warp as wp

from warpsample.host.arguments import told
from warpsample.host.kernel_cache import start
from warpsample.host.neighbours import address_of, as_ndarray, from_cuda, kind_told, own_memory

Array: TypeAlias = np.ndarray | wp.array

_SHORTEST, _LONGEST = 1e-30, 1e30  # of a vector in float64 whose components keep their digits in float32
_DIMENSIONS = {wp.vec2: 2, wp.vec3: 3}


@dataclass(frozen=True)
class Vectors:
    """An array of float32 vectors, C-contiguous.

    Attributes:
        owner: the array; holding it keeps the address valid.
        shape: without the vectors' own axis.
        width: components of a vector.
        device: where it lies.
    """

    owner: Array
    shape: tuple[int, ...]
    width: int
    device: wp.Device

    @cached_property
    def address(self) -> int:
        """Address of the first component."""
        return address_of(self.owner)

    @cached_property
    def count(self) -> int:
        """How many vectors."""
        return prod(self.shape)


def cpu() -> wp.Device:
    """The CPU as a device; the first call of a process starts Warp."""
    start()
    return wp.get_device("cpu")


def as_real(value: Any, argument: str, wants: str = "real numbers") -> np.ndarray:
    """`value` as float32 where it is that already, else as float64.

    Raises:
        TypeError: not an array of real numbers.
    """
    array = as_ndarray(value, argument, wants)
    if array.dtype.kind not in "fiu":
        raise TypeError(f"{argument}: got {f'dtype {array.dtype}' if array.ndim else told(value)}, want {wants}")
    if array.dtype in (np.float32, np.float64):
        return array
    with np.errstate(over="ignore"):
        return array.astype(np.float64)


def check_active(active: Any, points: int) -> np.ndarray | None:
    """Which of the points count: a copy as (points,) uint8, C-contiguous; None if all do.

    Raises:
        TypeError: not an array of bool (or of uint8, as Warp has it).
        ValueError: of another shape.
    """
    if active is None:
        return None
    wants = f"an array of bool of shape {(points,)}, one for each point"
    mask = as_ndarray(active, "active", wants)
    if mask.dtype not in (np.bool_, np.uint8):
        raise TypeError(f"active: got {f'dtype {mask.dtype}' if mask.ndim else told(active)}, want {wants}")
    if mask.shape != (points,):
        raise ValueError(f"active: got shape {mask.shape}, want {wants}")
    return np.array(mask, order="C").view(np.uint8)  # a copy: it may lie where results are written to


def as_square(value: Any, argument: str) -> np.ndarray:
    """`value`, if its numbers are in [0, 1); float64 ones that would round up to 1 become the float32 below it.

    Raises:
        TypeError: not an array.
        ValueError: numbers outside of [0, 1).
    """
    array = as_ndarray(value, argument)
    if array.dtype in (np.float32, np.float64) and array.size:
        if not (array.min() >= 0.0 and array.max() < 1.0):
            raise ValueError(f"{argument}: got values from {array.min()} to {array.max()}, want values in [0, 1)")
        if array.dtype == np.float64:
            array = np.minimum(array.astype(np.float32), np.float32(1 - 2**-24))
    return array


def as_unit(value: Any, argument: str, wants: str = "three finite numbers, not all 0") -> tuple[float, float, float]:
    """`value` as a unit vector.

    Raises:
        TypeError: not numbers.
        ValueError: not three finite ones, or all 0.
    """
    vector = as_real(value, argument, wants)
    largest = float(np.abs(vector).max()) if vector.shape == (3,) else 0.0
    if not 0.0 < largest < inf:
        raise ValueError(f"{argument}: got {told(value)}, want {wants}")
    # By a power of two, which changes no digit, so that no square over- or underflows.
    x, y, z = (ldexp(v, -frexp(largest)[1]) for v in vector.tolist())
    length = hypot(x, y, z)
    return x / length, y / length, z / length


def as_view(value: Any, argument: str) -> tuple[float, float, float]:
    """`value` as a unit vector, if it is a direction at or above the surface.

    Raises:
        TypeError, ValueError: not three finite numbers, the zero vector, or below.
    """
    wants = "three finite numbers, not all 0, the last at least 0"
    view = as_unit(value, argument, wants)
    if view[2] < 0.0:
        raise ValueError(f"{argument}: got {told(value)}, want {wants}")
    return view


def as_vectors(value: Any, width: int, argument: str, shape: str = "(..., {})") -> Vectors:
    """`value` as float32 vectors; without a copy where it is C-contiguous float32 already.

    Raises:
        TypeError: `value` is not an array of real floating-point numbers.
        ValueError: its last axis is not `width` long.
    """
    value = from_cuda(value, argument)
    if isinstance(value, wp.array):
        return _warp_vectors(value, width, argument)
    array = as_ndarray(value, argument)
    if array.dtype not in (np.float32, np.float64):
        raise TypeError(f"{argument}: got dtype {array.dtype}, want float32 (or float64, which is rounded to float32)")
    if array.ndim == 0 or array.shape[-1] != width:
        raise ValueError(f"{argument}: got shape {array.shape}, want {shape.format(width)}")
    owner = as_directions(array) if argument == "normals" else _rounded(array)
    return Vectors(owner, owner.shape[:-1], width, cpu())


def _rounded(array: np.ndarray) -> np.ndarray:
    """The array as C-contiguous float32, copied only if it is not that already."""
    with np.errstate(over="ignore"):
        return np.ascontiguousarray(array, np.float32)


def as_directions(array: np.ndarray) -> np.ndarray:
    """(..., 3) vectors of any length as float32 ones: scaled by a power of two where their length has no float32."""
    if array.dtype != np.float32:
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
    """Uninitialised vectors of the same kind and place: NumPy by NumPy, Warp by Warp. Width 1 has no axis of its own."""
    if isinstance(like.owner, wp.array):
        kind = {1: wp.float32, 2: wp.vec2, 3: wp.vec3}[width]
        return Vectors(wp.empty(shape, dtype=kind, device=like.device), shape, width, like.device)
    return Vectors(np.empty(shape if width == 1 else (*shape, width), np.float32), shape, width, like.device)


def check_out(out: Any, like: Vectors, shape: tuple[int, ...]) -> Vectors:
    """The caller's own output array, if it can be written as it is: (*shape, 3) float32, C-contiguous, same kind and place.

    Raises:
        TypeError: another kind of array than the input, or not float32.
        ValueError: another shape or device, not contiguous, read-only, or over the normals.
    """
    want = f"a C-contiguous, writeable float32 array of shape {(*shape, 3)}"
    out = own_memory(from_cuda(out, "out"), want)
    if isinstance(out, wp.array) and isinstance(like.owner, wp.array):
        vectors = _warp_vectors(out, 3, "out")
        if vectors.device != like.device:
            raise ValueError(f"out: got an array on {vectors.device}, want one on {like.device}, where the normals are")
    elif isinstance(out, np.ndarray) and isinstance(like.owner, np.ndarray):
        as_ndarray(out, "out", want)
        if out.dtype != np.float32:
            raise TypeError(f"out: got dtype {out.dtype}, want {want}")
        if not (out.flags.c_contiguous and out.flags.writeable):
            flaw = "read-only" if out.flags.c_contiguous else "not C-contiguous"
            raise ValueError(f"out: got an array that is {flaw}, want {want}")
        vectors = Vectors(out, out.shape[:-1], out.shape[-1] if out.ndim else 0, like.device)
    else:
        raise TypeError(f"out: got {kind_told(out)}, want {kind_told(like.owner)}, as the normals are")
    if (*vectors.shape, vectors.width) != (*shape, 3):
        raise ValueError(f"out: got shape {(*vectors.shape, vectors.width)}, want {want}")
    if vectors.address < like.address + 12 * like.count and like.address < vectors.address + 12 * vectors.count:
        raise ValueError("out: got an array that overlaps the normals, want one apart from them")
    return vectors
