"""Where arrays lie while kernels run: where they are, or NumPy's on a device, to which they go in parts and come back."""

from collections.abc import Iterable
from dataclasses import dataclass
from math import prod
from typing import Any

import numpy as np
import warp as wp

from warpsample.host.arrays import Array, check_device, cpu
from warpsample.host.neighbours import address_of

HOME = ("cpu",)
"""Names of the devices that read NumPy's own memory, and run the kernels and the tracer of the CPU. The others run those of
CUDA; so do tests on the CPU, by leaving it out here."""

BUDGET = 1 << 28
"""Bytes of NumPy's arrays with a row for each point or ray that a device holds at a time."""


def at_home(device: wp.Device) -> bool:
    """Whether kernels on a device read NumPy's memory, and are shaped for the CPU."""
    return device.alias in HOME


def allocate(shape: tuple[int, ...], dtype: Any, device: wp.Device) -> "wp.array[Any]":
    """Uninitialised memory of a device; a MemoryError if it has too little left."""
    try:
        return wp.empty(shape, dtype=dtype, device=device)
    except RuntimeError as error:
        size = prod(shape) * wp.types.type_size_in_bytes(dtype)
        raise MemoryError(
            f"arrays of the call need {size:,} bytes more than {device} has free; free some of it first"
        ) from error


@dataclass(frozen=True)
class Memory:
    """The memory that a call works in: a device's, whose kernels may read and write the caller's arrays `in_place`."""

    device: wp.Device
    in_place: bool

    @classmethod
    def of(cls, device: Any, given: Array | None = None, argument: str = "") -> "Memory":
        """The memory of a call on the device that its caller names, by default the one of the array that is given.

        No device of this machine, or another one than that of a given wp.array, is a TypeError or ValueError.
        """
        of_warp = isinstance(given, wp.array)
        default = given.device if of_warp else cpu()
        target = check_device(device, default)
        if of_warp and target != default:
            raise ValueError(f"device: got {target}, want {default}, where the {argument} are")
        return cls(target, of_warp or at_home(target))

    def fits(self, size: int) -> bool:
        """Whether so many bytes are within the budget."""
        return self.in_place or size <= BUDGET

    def parts(self, rows: int, size: int, besides: int = 0) -> Iterable[slice]:
        """Rows of `size` bytes, by as many as fit into the budget with `besides` bytes; in place all of them at once."""
        if self.in_place:
            return (slice(0, rows),) if rows else ()
        step = max(1, (BUDGET - besides) // size)
        return (slice(start, min(start + step, rows)) for start in range(0, rows, step))

    def loan(self) -> "Loan":
        """Memory for one part, by a `with` statement."""
        return Loan(self)


class Loan:
    """Memory that one part of a call holds. In the end results are fetched, if nothing failed, and all is given back."""

    def __init__(self, memory: Memory) -> None:
        self.memory = memory
        self._held: list[Array] = []
        self._results: list[tuple[np.ndarray, wp.array]] = []

    def __enter__(self) -> "Loan":
        """The loan itself, for the body of a `with` statement."""
        return self

    def __exit__(self, kind: type[BaseException] | None, *_: object) -> None:
        """Fetches the results, and gives the memory back in any case."""
        try:
            while self._results and kind is None:
                array, there = self._results.pop()
                array[...] = there.numpy()  # waits for the kernels
        finally:
            self._results.clear()
            self._held.clear()

    def put(self, array: Array | None, rows: slice = slice(None)) -> int:
        """The address of rows of an array that kernels read, those of `Memory.parts` or all; 0 for None."""
        if array is None:
            return 0
        return self._keep(array) if self.memory.in_place else self._keep(self._copy(np.ascontiguousarray(array[rows])))

    def output(self, array: Array, rows: slice = slice(None), zero: bool = False) -> int:
        """The address to which kernels write rows of an array: all of them, or those that are not 0 of an array that is."""
        if self.memory.in_place:
            return self._keep(array)
        there = allocate(array[rows].shape, wp.dtype_from_numpy(array.dtype), self.memory.device)
        if zero:
            there.zero_()
        self._results.append((array[rows], there))
        return self._keep(there)

    def clone(self, array: "wp.array[Any]") -> "wp.array[Any]":
        """A wp.array in the host's memory as kernels read it; one on a device as it is."""
        if self.memory.in_place or not array.ptr or not array.device.is_cpu:
            return array
        there = allocate(array.shape, array.dtype, self.memory.device)
        wp.copy(there, array)
        self._keep(there)
        return there

    def _copy(self, array: np.ndarray) -> wp.array:
        there = allocate(array.shape, wp.dtype_from_numpy(array.dtype), self.memory.device)
        there.assign(array)
        return there

    def _keep(self, array: Array) -> int:
        self._held.append(array)
        return address_of(array)
