"""Checks of arrays that users give: real numbers, masks, points of the unit square, unit vectors, and devices."""

from math import frexp, hypot, inf, ldexp
from typing import Any, TypeAlias

import numpy as np
import warp as wp
from numpy.typing import NDArray

from warpsample.host.arguments import quote
from warpsample.host.kernel_cache import start
from warpsample.host.locks import once
from warpsample.host.neighbours import as_ndarray

Array: TypeAlias = NDArray[Any] | Any
"""A NumPy array or a wp.array. Type checkers see a NumPy array, the usual case."""
Floats: TypeAlias = NDArray[np.float32] | Any
"""A float32 NumPy array, or a wp.array of float32 or of its vectors."""


@once
def cpu() -> wp.Device:
    """Return Warp's device object of the CPU, after starting Warp if necessary."""
    start()
    return wp.get_device("cpu")


def check_device(device: Any, default: wp.Device) -> wp.Device:
    """Convert an argument `device` to a wp.Device: a name such as "cuda:0", a wp.Device, or None for the default.

    Raises:
        TypeError: the value is neither a string nor a wp.Device.
        ValueError: this machine has no such device.
    """
    if device is None:
        return default
    return _device(device)


def _device(device: Any) -> wp.Device:
    """Return the Warp device with a given name, or raise the errors of `check_device`."""
    known = ", ".join(str(d) for d in wp.get_devices())
    if not isinstance(device, str | wp.Device):
        raise TypeError(f"device: got {quote(device)}, want one of {known}")
    try:
        if device == "cuda" and not wp.is_cuda_available():  # get_device would print errors of a driver that is missing
            raise ValueError("this machine has no CUDA device")
        return wp.get_device(device)
    except Exception as error:  # Warp raises several types for a device that does not exist
        raise ValueError(f"device: got {quote(device)}, want one of {known}") from error


def as_real(value: Any, argument: str, wants: str = "real numbers") -> np.ndarray:
    """Convert a value to an array of real numbers: float32 stays float32, every other type becomes float64.

    Raises:
        TypeError: the value is no array of real numbers.
    """
    array = as_ndarray(value, argument, wants)
    if array.dtype.kind not in "fiu":
        raise TypeError(f"{argument}: got {f'dtype {array.dtype}' if array.ndim else quote(value)}, want {wants}")
    if array.dtype in (np.float32, np.float64):
        return array
    with np.errstate(over="ignore"):
        return array.astype(np.float64)


def check_active(active: Any, points: int) -> np.ndarray | None:
    """Check the argument `active`, a mask of points, and return it as a (points,) uint8 array, or None.

    Raises:
        TypeError: the mask is neither bool nor uint8, which is Warp's type for bool.
        ValueError: the mask has another shape.
    """
    if active is None:
        return None
    wants = f"an array of bool of shape {(points,)}, one for each point"
    mask = as_ndarray(active, "active", wants)
    if mask.dtype not in (np.bool_, np.uint8):
        raise TypeError(f"active: got {f'dtype {mask.dtype}' if mask.ndim else quote(active)}, want {wants}")
    if mask.shape != (points,):
        raise ValueError(f"active: got shape {mask.shape}, want {wants}")
    return np.array(mask, order="C").view(np.uint8)  # a copy: results may be written to its memory


def as_square(value: Any, argument: str) -> np.ndarray:
    """Check an array of points of the unit square, and return it; float64 arrays are rounded to float32.

    A float64 number that would round up to 1 becomes the largest float32 below 1.

    Raises:
        ValueError: a number is outside [0, 1).
    """
    array = as_ndarray(value, argument)
    if array.dtype in (np.float32, np.float64) and array.size:
        if not (array.min() >= 0.0 and array.max() < 1.0):
            raise ValueError(f"{argument}: got values from {array.min()} to {array.max()}, want values in [0, 1)")
        if array.dtype == np.float64:
            array = np.minimum(array.astype(np.float32), np.float32(1 - 2**-24))
    return array


def as_unit(value: Any, argument: str, wants: str = "three finite numbers, not all 0") -> tuple[float, float, float]:
    """Check a vector of three numbers, and return it scaled to length 1, as a tuple of floats.

    Raises:
        TypeError: the value is no array of real numbers.
        ValueError: the value is not three finite numbers, or all three are 0.
    """
    vector = as_real(value, argument, wants)
    largest = float(np.abs(vector).max()) if vector.shape == (3,) else 0.0
    if not 0.0 < largest < inf:
        raise ValueError(f"{argument}: got {quote(value)}, want {wants}")
    # By a power of two, which changes no digit, so that no square over- or underflows.
    x, y, z = (ldexp(v, -frexp(largest)[1]) for v in vector.tolist())
    length = hypot(x, y, z)
    return x / length, y / length, z / length


def as_view(value: Any, argument: str) -> tuple[float, float, float]:
    """Check a view direction relative to a surface (+z is the normal), and return it scaled to length 1.

    Raises:
        TypeError: the value is no array of real numbers.
        ValueError: the value is not three finite numbers, all three are 0, or z is below 0.
    """
    wants = "three finite numbers, not all 0, the last at least 0"
    view = as_unit(value, argument, wants)
    if view[2] < 0.0:
        raise ValueError(f"{argument}: got {quote(value)}, want {wants}")
    return view
