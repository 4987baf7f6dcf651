"""The arrays of users, NumPy's, Warp's and other libraries': checked once, and from then on known by their address.

What another library holds is taken by its protocols, without a copy: in the CPU's memory it becomes a NumPy array
(`__array_interface__`, `__array__`, `__dlpack__`), on a CUDA device a wp.array (`__dlpack__`, `__cuda_array_interface__`).
"""

from math import frexp, hypot, inf, ldexp
from typing import Any, TypeAlias

import numpy as np
import warp as wp

from warpsample.host.arguments import told
from warpsample.host.kernel_cache import start

Array: TypeAlias = np.ndarray | wp.array

NUMPY_KNOWS = ("__array__", "__array_interface__", "__array_struct__")
"""Protocols by which NumPy takes the arrays of others."""

_DLPACK_CUDA = 2  # what `__dlpack_device__` calls a CUDA device's memory


def cpu() -> wp.Device:
    """The CPU as a device; the first call of a process starts Warp."""
    start()
    return wp.get_device("cpu")


def check_device(device: Any, default: wp.Device) -> wp.Device:
    """The device that a caller names, as "cuda:0" or a wp.Device; the default for None.

    Raises:
        TypeError, ValueError: no device of this machine.
    """
    if device is None:
        return default
    known = ", ".join(str(d) for d in wp.get_devices())
    if not isinstance(device, str | wp.Device):
        raise TypeError(f"device: got {told(device)}, want one of {known}")
    try:
        return wp.get_device(device)
    except Exception as error:  # Warp raises several types for a device that does not exist
        raise ValueError(f"device: got {told(device)}, want one of {known}") from error


def address_of(array: Array) -> int:
    """Address of the first element, on the array's device."""
    return array.ptr or 0 if isinstance(array, wp.array) else array.__array_interface__["data"][0]


def kind_told(value: Any) -> str:
    """What kind of thing `value` is, as a message shows it."""
    if isinstance(value, wp.array):
        return "a wp.array"
    return "a NumPy array" if isinstance(value, np.ndarray) else f"a value of type {type(value).__name__}"


def from_cuda(value: Any, argument: str) -> Any:
    """Another library's array on a CUDA device as a wp.array of the same memory; everything else as it is.

    Raises:
        TypeError: it is on a device that Warp does not have, needs a gradient, or holds what no wp.array does.
    """
    if isinstance(value, np.ndarray | wp.array):
        return value
    try:
        if not _on_cuda(value):
            return value
        start()
        if hasattr(value, "__dlpack__"):  # knows the number of its device, and waits for what still writes to it
            return wp.from_dlpack(value)
        return wp.array(data=value, device=wp.get_cuda_device(), copy=False)
    except Exception as error:  # whatever the value's own code raises, and Warp
        known = ", ".join(map(str, wp.get_devices()))
        raise TypeError(
            f"{argument}: got {kind_told(value)} on a CUDA device, which Warp makes no array of ({_reason(error)}), "
            f"want an array without gradients on one of {known}"
        ) from error


def _on_cuda(value: Any) -> bool:
    try:
        return value.__dlpack_device__()[0] == _DLPACK_CUDA
    except Exception:  # it has no such method, or is where DLPack has no number for
        return getattr(value, "__cuda_array_interface__", None) is not None


def as_ndarray(value: Any, argument: str, wants: str = "an array") -> np.ndarray:
    """`value` as NumPy has it, without a copy where it is an array in the CPU's memory.

    Raises:
        TypeError: an array with a mask, which nothing here heeds; or what NumPy makes no array of, such as ragged lists.
    """
    if _has_mask(value):
        raise TypeError(f"{argument}: got a masked array, want {wants} without a mask, as numpy.ma.filled gives")
    value = from_cuda(value, argument)
    if isinstance(value, wp.array):
        return value.numpy()
    try:
        # By __array__ where there is one: of PyTorch's exports it alone heeds the sign that conj().imag leaves to be taken.
        only_dlpack = hasattr(type(value), "__dlpack__") and not any(hasattr(value, name) for name in NUMPY_KNOWS)
        return np.from_dlpack(value) if only_dlpack else np.asarray(value)
    except Exception as error:  # whatever the value's own code raises
        raise TypeError(
            f"{argument}: got {told(value)}, which NumPy makes no array of ({_reason(error)}), want {wants}"
        ) from error


def _reason(error: Exception) -> str:
    return " ".join(str(error).split())


def _has_mask(value: Any) -> bool:
    return isinstance(value, np.ma.MaskedArray) or (isinstance(value, list | tuple) and any(map(_has_mask, value)))


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
