"""The arrays of other libraries (PyTorch, JAX, CuPy), taken by their protocols and without a copy.

In the CPU's memory they become NumPy's (`__array_interface__`, `__array__`, `__dlpack__`), on a CUDA device a wp.array
(`__dlpack__`, `__cuda_array_interface__`).
"""

from contextlib import suppress
from ctypes import addressof, c_char
from typing import Any

import numpy as np
import warp as wp

from warpsample.host.arguments import told
from warpsample.host.kernel_cache import start

_NUMPY_KNOWS = ("__array__", "__array_interface__", "__array_struct__")
_ARRAYS = (np.ndarray, wp.array)
_DLPACK_CUDA = 2  # what `__dlpack_device__` calls a CUDA device's memory


def address_of(array: Any) -> int:
    """Address of the first element, on the array's device."""
    if isinstance(array, wp.array):
        return array.ptr or 0
    with suppress(TypeError, ValueError, BufferError):  # it is not contiguous, empty, or of a type that no buffer has
        if array.flags.writeable:
            return addressof(c_char.from_buffer(array))  # in a third of the time
    return array.__array_interface__["data"][0]


def kind_told(value: Any) -> str:
    """What kind of thing `value` is, as a message shows it."""
    if isinstance(value, wp.array):
        return "a wp.array"
    return "a NumPy array" if isinstance(value, np.ndarray) else f"a value of type {type(value).__name__}"


def from_cuda(value: Any, argument: str) -> Any:
    """Another library's array on a CUDA device as a wp.array of the same memory; everything else as it is.

    A device that Warp does not have, a gradient, or what no wp.array holds is a TypeError.
    """
    return value if isinstance(value, _ARRAYS) else _from_cuda(value, argument)


def _from_cuda(value: Any, argument: str) -> Any:
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

    A mask, which nothing here heeds, and what NumPy makes no array of, such as ragged lists, are a TypeError.
    """
    return value if type(value) is np.ndarray else _to_ndarray(value, argument, wants)


def _to_ndarray(value: Any, argument: str, wants: str) -> np.ndarray:
    if _has_mask(value):
        raise TypeError(f"{argument}: got a masked array, want {wants} without a mask, as numpy.ma.filled gives")
    value = from_cuda(value, argument)
    if isinstance(value, wp.array):
        return value.numpy()
    try:
        # By __array__ where there is one: of PyTorch's exports it alone heeds the sign that conj().imag leaves to be taken.
        only_dlpack = hasattr(type(value), "__dlpack__") and not any(hasattr(value, name) for name in _NUMPY_KNOWS)
        return np.from_dlpack(value) if only_dlpack else np.asarray(value)
    except Exception as error:  # whatever the value's own code raises
        raise TypeError(
            f"{argument}: got {told(value)}, which NumPy makes no array of ({_reason(error)}), want {wants}"
        ) from error


def _reason(error: Exception) -> str:
    return " ".join(str(error).split())


def _has_mask(value: Any) -> bool:
    return isinstance(value, np.ma.MaskedArray) or (isinstance(value, list | tuple) and any(map(_has_mask, value)))


def own_memory(out: Any, wants: str) -> Any:
    """Another library's array as NumPy's of the same memory; everything else as it is."""
    if isinstance(out, _ARRAYS) or not any(hasattr(out, name) for name in (*_NUMPY_KNOWS, "__dlpack__")):
        return out
    view, again = as_ndarray(out, "out", wants), as_ndarray(out, "out", wants)
    return view if address_of(view) == address_of(again) else out  # a copy is another each time
