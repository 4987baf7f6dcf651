"""Conversion of arrays of other libraries (PyTorch, JAX, CuPy) without a copy.

Arrays in the memory of the CPU become NumPy arrays (`__array_interface__`, `__array__`, `__dlpack__`). Arrays on a CUDA
device become a wp.array (`__dlpack__`, `__cuda_array_interface__`).
"""

from contextlib import suppress
from ctypes import addressof, c_char
from typing import Any

import numpy as np
import warp as wp

from warpsample.host.arguments import quote
from warpsample.host.kernel_cache import start

_NUMPY_KNOWS = ("__array__", "__array_interface__", "__array_struct__")
_ARRAYS = (np.ndarray, wp.array)
_DLPACK_CUDA = 2  # what `__dlpack_device__` calls a CUDA device's memory


def address_of(array: Any) -> int:
    """Return the memory address of an array's first element, on the array's device."""
    if isinstance(array, wp.array):
        return array.ptr or 0
    with suppress(TypeError, ValueError, BufferError):  # not contiguous, empty, or of a type that no buffer has
        if array.flags.writeable:
            return addressof(c_char.from_buffer(array))  # in a third of the time
    return array.__array_interface__["data"][0]


def describe_type(value: Any) -> str:
    """Return a noun phrase for the type of a value, for an error message."""
    if isinstance(value, wp.array):
        return "a wp.array"
    return "a NumPy array" if isinstance(value, np.ndarray) else f"a value of type {type(value).__name__}"


def from_cuda(value: Any, argument: str) -> Any:
    """Wrap a CUDA array of another library as a wp.array without a copy; return other values unchanged.

    Raises:
        TypeError: Warp does not have the device, the array has a gradient, or no wp.array can hold the numbers.
    """
    return value if isinstance(value, _ARRAYS) else _from_cuda(value, argument)


def _from_cuda(value: Any, argument: str) -> Any:
    """Wrap a CUDA array as `from_cuda` does, for a value that is no array of NumPy or Warp."""
    try:
        if not _on_cuda(value):
            return value
        start()
        if hasattr(value, "__dlpack__"):  # knows its device, and waits for kernels that still write to the array
            return wp.from_dlpack(value)
        return wp.array(data=value, device=wp.get_cuda_device(), copy=False)
    except Exception as error:  # of the value's own code, or of Warp
        known = ", ".join(map(str, wp.get_devices()))
        raise TypeError(
            f"{argument}: got {describe_type(value)} on a CUDA device, which Warp cannot convert to an array "
            f"({_reason(error)}), "
            f"want an array without gradients on one of {known}"
        ) from error


def _on_cuda(value: Any) -> bool:
    """Return whether a value is an array on a CUDA device."""
    try:
        return value.__dlpack_device__()[0] == _DLPACK_CUDA
    except Exception:  # there is no such method, or DLPack has no number for the device
        return getattr(value, "__cuda_array_interface__", None) is not None


def as_ndarray(value: Any, argument: str, wants: str = "an array") -> np.ndarray:
    """Convert a value to a NumPy array, without a copy if it is an array on the CPU.

    Raises:
        TypeError: the value has a mask, which would be ignored, or NumPy makes no array of it, as of a ragged list.
    """
    array = as_array(value, argument, wants)
    return array.numpy() if isinstance(array, wp.array) else array


def as_array(value: Any, argument: str, wants: str = "an array") -> Any:
    """Convert a value to a wp.array if it is one or is on a CUDA device, else to a NumPy array; avoid copies.

    Raises:
        TypeError: as for `as_ndarray` and `from_cuda`.
    """
    return value if type(value) in _ARRAYS else _to_array(value, argument, wants)


def _to_array(value: Any, argument: str, wants: str) -> Any:
    """Convert a value that is neither a NumPy nor a Warp array to one of the two; see `as_array`."""
    if _has_mask(value):
        raise TypeError(f"{argument}: got a masked array, want {wants} without a mask; numpy.ma.filled removes the mask")
    value = from_cuda(value, argument)
    if isinstance(value, wp.array):
        return value
    try:
        # By __array__ where there is one: PyTorch's other exports ignore the sign that conj().imag leaves to be applied.
        only_dlpack = hasattr(type(value), "__dlpack__") and not any(hasattr(value, name) for name in _NUMPY_KNOWS)
        return np.from_dlpack(value) if only_dlpack else np.asarray(value)
    except Exception as error:  # of the value's own code
        raise TypeError(
            f"{argument}: got {quote(value)}, which NumPy cannot convert to an array ({_reason(error)}), want {wants}"
        ) from error


def _reason(error: Exception) -> str:
    """Return the message of an error on one line."""
    return " ".join(str(error).split())


def _has_mask(value: Any) -> bool:
    """Return whether a value, or an item of a nested list, is a masked array."""
    return isinstance(value, np.ma.MaskedArray) or (isinstance(value, list | tuple) and any(map(_has_mask, value)))


def own_memory(out: Any, wants: str) -> Any:
    """Wrap a CPU array of another library as a NumPy array that shares its memory; return other values unchanged."""
    if isinstance(out, _ARRAYS) or not any(hasattr(out, name) for name in (*_NUMPY_KNOWS, "__dlpack__")):
        return out
    view, again = as_ndarray(out, "out", wants), as_ndarray(out, "out", wants)
    return view if address_of(view) == address_of(again) else out  # each call makes a new copy, at another address
