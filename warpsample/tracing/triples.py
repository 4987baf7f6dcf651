"""Arrays of 3D points or directions that a caller passes: float32 or float64, on the CPU or a CUDA device."""

from dataclasses import dataclass
from typing import Any

import numpy as np
import warp as wp

from warpsample.host.arrays import Array, cpu
from warpsample.host.neighbours import as_array

_DOUBLE = {np.float32: False, np.float64: True, wp.vec3: False, wp.vec3d: True, wp.float32: False, wp.float64: True}


@dataclass(frozen=True, eq=False)
class Triples:
    """Checked array of 3D points or directions that a caller passes.

    Attributes:
        owner: the array, contiguous.
        shape: shape without the last axis of 3.
        double: whether the numbers are float64.
        device: device of the array.
    """

    owner: Array
    shape: tuple[int, ...]
    double: bool
    device: wp.Device

    @classmethod
    def of(cls, value: Any, argument: str, shape: str = "(..., 3)") -> "Triples":
        """Check an array of 3D points or directions and wrap it; it is copied only where it is not contiguous.

        Raises:
            TypeError, ValueError: not triples of floating-point numbers; the message names the argument.
        """
        value = as_array(value, argument)
        if isinstance(value, wp.array):
            vectors = value.dtype in (wp.vec3, wp.vec3d)
            if value.dtype not in _DOUBLE or not (vectors or (value.ndim and value.shape[-1] == 3)):
                raise TypeError(
                    f"{argument}: got a wp.array of {value.dtype.__name__} with shape {value.shape}, "
                    "want vec3, vec3d, or float32 or float64 with a last axis of 3"
                )
            if not value.is_contiguous:
                raise ValueError(f"{argument}: got a wp.array that is not contiguous, want a contiguous array")
            return cls(value, value.shape if vectors else value.shape[:-1], _DOUBLE[value.dtype], value.device)
        if value.dtype not in (np.float32, np.float64):
            raise TypeError(f"{argument}: got dtype {value.dtype}, want float32 or float64")
        if value.ndim == 0 or value.shape[-1] != 3:
            raise ValueError(f"{argument}: got shape {value.shape}, want {shape}")
        return cls(np.ascontiguousarray(value), value.shape[:-1], _DOUBLE[value.dtype.type], cpu())

    def empty(self, dtype: Any) -> Array:
        """Allocate an array of one number per point or direction, of the same library and on the same device."""
        if isinstance(self.owner, wp.array):
            return wp.empty(self.shape, dtype=wp.dtype_from_numpy(dtype), device=self.device)
        return np.empty(self.shape, dtype)
