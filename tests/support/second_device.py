"""The CPU in the place of a CUDA device: it gets NumPy's arrays in small parts, and runs the kernels that CUDA launches."""

import ctypes
import weakref
from contextlib import contextmanager
from dataclasses import dataclass

import pytest
import warp as wp

from warpsample.host import device_memory

BUDGET = 1 << 14


@dataclass
class Allocator:
    """Memory of the second device: counted, full of junk, and none at the request `fails_at`.

    live and most are bytes, now and at most; asked are requests.
    """

    fails_at: int = 0
    asked: int = 0
    live: int = 0
    most: int = 0

    def __call__(self, shape, dtype, device):
        self.asked += 1
        if self.asked == self.fails_at:
            raise MemoryError("the second device is full")
        array = wp.empty(shape, dtype=dtype, device=device)
        ctypes.memset(array.ptr, 0xA5, array.capacity)
        self.live += array.capacity
        self.most = max(self.most, self.live)
        weakref.finalize(array, self._free, array.capacity)
        return array

    def _free(self, size):
        self.live -= size


@contextmanager
def second_device(fails_at=0, budget=BUDGET):
    """The device "cpu", and the default one, are the second device within."""
    allocator = Allocator(fails_at)
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(device_memory, "HOME", ())
        patch.setattr(device_memory, "BUDGET", budget)
        patch.setattr(device_memory, "allocate", allocator)
        yield allocator
