"""Points or directions as a caller gives them: float32 or float64, in the CPU's memory or on a CUDA device."""

from dataclasses import dataclass
from typing import Any

import numpy as np
import warp as wp

from warpsample.host.arrays import Array, cpu
from warpsample.host.neighbours import as_ndarray, from_cuda

_DOUBLE = {np.float32: False, np.float64: True, wp.vec3: False, wp.vec3d: True, wp.float32: False, wp.float64: True}


@dataclass(frozen=True, eq=False)
class Triples:
    """An array of points or directions, as it is given: float32 or float64."""

    owner: Array
    shape: tuple[int, ...]
    double: bool
    device: wp.Device

    @classmethod
    def of(cls, value: Any, argument: str, shape: str = "(..., 3)") -> "Triples":
        """`value`, copied only where it is not contiguous.

        Raises:
            TypeError, ValueError: not triples of floating-point numbers; names the argument.
        """
        value = from_cuda(value, argument)
        if isinstance(value, wp.array):
            vectors = value.dtype in (wp.vec3, wp.vec3d)
            if value.dtype not in _DOUBLE or not (vectors or (value.ndim and value.shape[-1] == 3)):
                raise TypeError(
                    f"{argument}: got a wp.array of {value.dtype.__name__} with shape {value.shape}, "
                    "want vec3, vec3d, or float32 or float64 with a last axis of 3"
                )
            if not value.is_contiguous:
                raise ValueError(f"{argument}: got a wp.array that is not contiguous, want a contiguous one")
            return cls(value, value.shape if vectors else value.shape[:-1], _DOUBLE[value.dtype], value.device)
        array = as_ndarray(value, argument)
        if array.dtype not in (np.float32, np.float64):
            raise TypeError(f"{argument}: got dtype {array.dtype}, want float32 or float64")
        if array.ndim == 0 or array.shape[-1] != 3:
            raise ValueError(f"{argument}: got shape {array.shape}, want {shape}")
        return cls(np.ascontiguousarray(array), array.shape[:-1], _DOUBLE[array.dtype.type], cpu())

    def empty(self, dtype: Any) -> Array:
        """Uninitialised numbers, one for each vector, of the same kind and in the same place."""
        if isinstance(self.owner, wp.array):
            return wp.empty(self.shape, dtype=wp.dtype_from_numpy(dtype), device=self.device)
        return np.empty(self.shape, dtype)
