"""One number or vector at an address: what kernels read and write without a view of a whole array.

Loops that are to vectorise open a view, `wp.array(ptr=...)`, and index that. An index is of any integer type, from 0 on.
"""

from typing import Any

import warp as wp


@wp.func
def float_at(address: wp.uint64, i: Any) -> wp.float32:
    """The i-th float32."""
    return wp.array(ptr=address + wp.uint64(i) * wp.uint64(4), shape=(1,), dtype=wp.float32)[0]


@wp.func
def int_at(address: wp.uint64, i: Any) -> wp.int32:
    """The i-th int32."""
    return wp.array(ptr=address + wp.uint64(i) * wp.uint64(4), shape=(1,), dtype=wp.int32)[0]


@wp.func
def long_at(address: wp.uint64, i: Any) -> wp.int64:
    """The i-th int64."""
    return wp.array(ptr=address + wp.uint64(i) * wp.uint64(8), shape=(1,), dtype=wp.int64)[0]


@wp.func
def address_at(address: wp.uint64, i: Any) -> wp.uint64:
    """The i-th uint64."""
    return wp.array(ptr=address + wp.uint64(i) * wp.uint64(8), shape=(1,), dtype=wp.uint64)[0]


@wp.func
def byte_at(address: wp.uint64, i: Any) -> wp.uint8:
    """The i-th uint8."""
    return wp.array(ptr=address + wp.uint64(i), shape=(1,), dtype=wp.uint8)[0]


@wp.func
def vec3_at(address: wp.uint64, i: Any) -> wp.vec3:
    """The i-th vector of float32."""
    return wp.array(ptr=address + wp.uint64(i) * wp.uint64(12), shape=(1,), dtype=wp.vec3)[0]


@wp.func
def vec3i_at(address: wp.uint64, i: Any) -> wp.vec3i:
    """The i-th vector of int32."""
    return wp.array(ptr=address + wp.uint64(i) * wp.uint64(12), shape=(1,), dtype=wp.vec3i)[0]


@wp.func
def vec3d_at(address: wp.uint64, i: Any) -> wp.vec3d:
    """The i-th vector of float64."""
    return wp.array(ptr=address + wp.uint64(i) * wp.uint64(24), shape=(1,), dtype=wp.vec3d)[0]


@wp.func
def set_float(address: wp.uint64, i: Any, x: wp.float32):
    """Writes the i-th float32."""
    view = wp.array(ptr=address + wp.uint64(i) * wp.uint64(4), shape=(1,), dtype=wp.float32)
    view[0] = x


@wp.func
def set_int(address: wp.uint64, i: Any, x: wp.int32):
    """Writes the i-th int32."""
    view = wp.array(ptr=address + wp.uint64(i) * wp.uint64(4), shape=(1,), dtype=wp.int32)
    view[0] = x


@wp.func
def set_address(address: wp.uint64, i: Any, x: wp.uint64):
    """Writes the i-th uint64."""
    view = wp.array(ptr=address + wp.uint64(i) * wp.uint64(8), shape=(1,), dtype=wp.uint64)
    view[0] = x


@wp.func
def set_byte(address: wp.uint64, i: Any, x: wp.int32):
    """Writes the i-th uint8."""
    view = wp.array(ptr=address + wp.uint64(i), shape=(1,), dtype=wp.uint8)
    view[0] = wp.uint8(x)


@wp.func
def set_vec3(address: wp.uint64, i: Any, x: wp.vec3):
    """Writes the i-th vector of float32."""
    view = wp.array(ptr=address + wp.uint64(i) * wp.uint64(12), shape=(1,), dtype=wp.vec3)
    view[0] = x
