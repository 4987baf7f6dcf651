"""Memory of a call: in place without a copy, elsewhere in parts within the budget, and fetched only if nothing failed."""

from contextlib import suppress

import numpy as np
import pytest
import warp as wp
from second_device import BUDGET, second_device

from warpsample.host import device_memory
from warpsample.host.arrays import cpu
from warpsample.host.device_memory import Memory, allocate


def numbers_at(address, count):
    """What a kernel would read there."""
    return wp.array(ptr=address, dtype=wp.float32, shape=(count,), device="cpu").numpy()


def test_in_place_arrays_are_used_themselves():
    given, found = np.arange(6, dtype=np.float32), np.zeros(6, np.float32)
    memory = Memory.of(None)
    assert memory == Memory(cpu(), in_place=True)
    assert list(memory.parts(6, 10**12)) == [slice(0, 6)]
    assert memory.fits(10**12)
    with memory.loan() as loan:
        assert loan.lend(given) == given.ctypes.data
        assert loan.output(found) == found.ctypes.data
        array = wp.array(given, dtype=wp.float32, device="cpu")
        assert loan.clone(array) is array
        assert loan.lend(None) == 0
    assert not found.any()


def test_elsewhere_parts_are_within_the_budget_and_cover_all_rows():
    with second_device() as allocator:
        memory = Memory.of("cpu")
        assert memory == Memory(cpu(), in_place=False)
        for rows, size, besides in (
            (1000, 100, 0),
            (1000, 100, 400),
            (1, 100, 0),
            (7, BUDGET, 0),
            (3, 10 * BUDGET, 0),
            (0, 1, 0),
        ):
            parts = list(memory.parts(rows, size, besides))
            assert [row for part in parts for row in range(rows)[part]] == list(range(rows))
            assert all(part.stop - part.start == 1 or (part.stop - part.start) * size + besides <= BUDGET for part in parts)
        assert (memory.fits(BUDGET), memory.fits(BUDGET + 1)) == (True, False)
        assert allocator.asked == 0


def test_elsewhere_rows_are_copied_there_and_back():
    given = np.arange(24, dtype=np.float32).reshape(8, 3)
    found = np.full((8, 3), 7.0, np.float32)
    with second_device() as allocator:
        memory = Memory.of(None)
        with memory.loan() as loan:
            address = loan.lend(given[:, ::-1], slice(2, 4))
            assert address not in (0, given.ctypes.data, given[2:].ctypes.data)
            assert numbers_at(address, 6).tolist() == [8.0, 7.0, 6.0, 11.0, 10.0, 9.0]
            numbers_at(loan.output(found, slice(2, 4)), 6)[:] = numbers_at(address, 6)
            assert not numbers_at(loan.output(found, slice(6, 7), zero=True), 3).any()
            assert (found == 7.0).all()
            assert allocator.live == 4 * (6 + 6 + 3)
        assert allocator.live == 0
    expected = np.full((8, 3), 7.0, np.float32)
    expected[2:4], expected[6] = given[2:4, ::-1], 0.0
    assert np.array_equal(found, expected)


def test_after_a_failure_nothing_is_fetched_and_all_is_given_back():
    found = np.full(8, 7.0, np.float32)
    with second_device() as allocator:
        memory = Memory.of(None)
        with suppress(KeyError), memory.loan() as loan:
            loan.lend(found)
            loan.output(found, zero=True)
            assert allocator.live == 64
            raise KeyError
        assert allocator.live == 0
    assert (found == 7.0).all()


def test_memory_that_warp_does_not_get_is_named(monkeypatch):
    def full(*_, **__):
        raise RuntimeError("Failed to allocate 12 bytes on device 'cuda:0'")

    monkeypatch.setattr(device_memory.wp, "empty", full)
    with pytest.raises(
        MemoryError,
        match="^arrays of the call need 12 bytes more than cpu has free; free memory there, or compute fewer points",
    ):
        allocate((3,), wp.float32, cpu())


def test_a_device_beside_a_warp_array_must_be_its_own(monkeypatch):
    array = wp.zeros(3, dtype=wp.vec3, device="cpu")
    assert Memory.of("cpu", array, "rays") == Memory.of(None, array, "rays") == Memory(cpu(), in_place=True)
    monkeypatch.setattr(device_memory, "check_device", lambda *_: "cuda:0")
    with pytest.raises(ValueError, match="^device: got cuda:0, want cpu, the device of the rays$"):
        Memory.of("cuda:0", array, "rays")
