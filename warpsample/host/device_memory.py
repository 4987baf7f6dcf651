"""Transfer of arrays to kernels: no copies on the CPU; on a CUDA device, NumPy arrays are copied part by part."""

from collections.abc import Iterable
from dataclasses import dataclass
from math import prod
from typing import Any

import numpy as np
import warp as wp

from warpsample.host.arrays import Array, check_device, cpu
from warpsample.host.neighbours import address_of

HOME = ("cpu",)
"""Names of the devices that read the memory of NumPy arrays, and run the kernels and the tracer for the CPU. Other devices
run the kernels for CUDA. Tests remove "cpu" to run the kernels for CUDA on the CPU."""

BUDGET = 1 << 28
"""Bytes of NumPy arrays, with a row for each point or ray, that are copied to a CUDA device at a time."""


def at_home(device: wp.Device) -> bool:
    """Return True if a device is the CPU, where kernels read NumPy arrays directly."""
    return device.alias in HOME


def allocate(shape: tuple[int, ...], dtype: Any, device: wp.Device) -> "wp.array[Any]":
    """Allocate a wp.array on a device, without setting its values.

    Raises:
        MemoryError: the device has too little free memory.
    """
    try:
        return wp.empty(shape, dtype=dtype, device=device)
    except RuntimeError as error:
        size = prod(shape) * wp.types.type_size_in_bytes(dtype)
        raise MemoryError(
            f"arrays of the call need {size:,} bytes more than {device} has free; free memory there, or compute fewer "
            "points at once"
        ) from error


@dataclass(frozen=True)
class Memory:
    """Device of a call, and whether its kernels use the caller's arrays directly or copies, made part by part.

    Attributes:
        device: device that runs the kernels.
        in_place: whether kernels read and write the caller's arrays without copies.
    """

    device: wp.Device
    in_place: bool

    def __reduce__(self) -> tuple[Any, ...]:
        """Pickle the device by its name, because a wp.Device holds pointers."""
        return _memory_of, (self.device.alias, self.in_place)

    @classmethod
    def of(cls, device: Any, given: Array | None = None, argument: str = "") -> "Memory":
        """Choose the device of a call: the named one, by default that of a wp.array among the arguments, else the CPU.

        Args:
            device: name of a device, a wp.Device or None.
            given: array that the caller gave.
            argument: name of that array in errors.

        Raises:
            TypeError: `device` is neither a string nor a wp.Device.
            ValueError: this machine has no such device, or a given wp.array is on another device.
        """
        of_warp = isinstance(given, wp.array)
        default = given.device if of_warp else cpu()
        target = check_device(device, default)
        if of_warp and target != default:
            raise ValueError(f"device: got {target}, want {default}, the device of the {argument}")
        return cls(target, of_warp or at_home(target))

    def fits(self, size: int) -> bool:
        """Return True if `size` bytes fit into the budget of device memory; always True on the CPU."""
        return self.in_place or size <= BUDGET

    def parts(self, rows: int, size: int, besides: int = 0) -> Iterable[slice]:
        """Divide rows into slices that fit into device memory; on the CPU, one slice has all rows.

        Args:
            rows: number of rows.
            size: bytes of a row.
            besides: bytes of the part that do not depend on the number of rows.
        """
        if self.in_place:
            return (slice(0, rows),) if rows else ()
        step = max(1, (BUDGET - besides) // size)
        return (slice(start, min(start + step, rows)) for start in range(0, rows, step))

    def loan(self) -> "Loan":
        """Return a context manager that holds the device memory of one part of a call."""
        return Loan(self)


def _memory_of(name: str, in_place: bool) -> Memory:
    """Return a pickled `Memory`.

    Raises:
        ValueError: this machine has no device of that name.
    """
    return Memory(check_device(name, cpu()), in_place)


class Loan:
    """Context manager for the arrays of one part of a call on the device; results are copied back at its end."""

    def __init__(self, memory: Memory) -> None:
        self.memory = memory
        self._inputs: list[Array] = []
        self._results: list[tuple[np.ndarray, wp.array]] = []

    def __enter__(self) -> "Loan":
        """Enter the `with` statement, and return this object."""
        return self

    def __exit__(self, kind: type[BaseException] | None, *_: object) -> None:
        """Copy the results to the caller's arrays, if there was no error, and free the memory in any case."""
        try:
            while self._results and kind is None:
                array, there = self._results.pop()
                array[...] = there.numpy()  # waits for the kernels
        finally:
            self._results.clear()
            self._inputs.clear()

    def lend(self, array: Array | None, rows: slice = slice(None)) -> int:
        """Copy rows of an input array to the device if necessary, and return their address for kernels; 0 for None.

        Kernels read rows in C order: a NumPy array in another memory order is copied. `rows` is a slice of `Memory.parts`,
        or all rows. In place it is not used: kernels get the whole array.
        """
        if array is None:
            return 0
        if not self.memory.in_place:
            return self._keep(self._copy(np.ascontiguousarray(array[rows])))
        return self._keep(np.ascontiguousarray(array) if isinstance(array, np.ndarray) else array)

    def output(self, array: Array, rows: slice = slice(None), zero: bool = False) -> int:
        """Return the address to which kernels write results; the results are copied to rows of `array` at the end.

        `zero` sets copied memory to 0 first, for kernels that do not write all rows of an array of zeros.
        """
        if self.memory.in_place:
            return self._keep(array)
        there = allocate(array[rows].shape, wp.dtype_from_numpy(array.dtype), self.memory.device)
        if zero:
            there.zero_()
        self._results.append((array[rows], there))
        return self._keep(there)

    def clone(self, array: "wp.array[Any]") -> "wp.array[Any]":
        """Copy a wp.array from the CPU to the device if necessary, and return the array that kernels can read."""
        if self.memory.in_place or not array.ptr or not array.device.is_cpu:
            return array
        there = allocate(array.shape, array.dtype, self.memory.device)
        wp.copy(there, array)
        self._keep(there)
        return there

    def _copy(self, array: np.ndarray) -> wp.array:
        """Copy a NumPy array to the device, and return the wp.array."""
        there = allocate(array.shape, wp.dtype_from_numpy(array.dtype), self.memory.device)
        there.assign(array)
        return there

    def _keep(self, array: Array) -> int:
        """Keep an array in memory until the end of the `with` statement, and return its address."""
        self._inputs.append(array)
        return address_of(array)
