"""Warp functions that read or write one number or vector at a memory address.

Loops that must vectorise open a view, `wp.array(ptr=...)`, and index that view instead. An index may have any integer type.
"""

from typing import Any

import warp as wp


def _reader(kind: Any) -> wp.Function:
    """Build the Warp function that reads the i-th number or vector of a type at an address."""
    size = wp.types.type_size_in_bytes(kind)

    @wp.func
    def read(address: wp.uint64, i: Any):
        return wp.array(ptr=address + wp.uint64(i) * wp.uint64(size), shape=(1,), dtype=kind)[0]

    return read


def _writer(kind: Any) -> wp.Function:
    """Build the Warp function that writes the i-th number or vector of a type at an address."""
    size = wp.types.type_size_in_bytes(kind)

    @wp.func
    def write(address: wp.uint64, i: Any, x: kind):
        view = wp.array(ptr=address + wp.uint64(i) * wp.uint64(size), shape=(1,), dtype=kind)
        view[0] = x

    return write


float_at: wp.Function = _reader(wp.float32)
int_at: wp.Function = _reader(wp.int32)
long_at: wp.Function = _reader(wp.int64)
address_at: wp.Function = _reader(wp.uint64)
byte_at: wp.Function = _reader(wp.uint8)
vec3_at: wp.Function = _reader(wp.vec3)
vec4_at: wp.Function = _reader(wp.vec4)
vec3i_at: wp.Function = _reader(wp.vec3i)
vec3d_at: wp.Function = _reader(wp.vec3d)
set_float: wp.Function = _writer(wp.float32)
set_int: wp.Function = _writer(wp.int32)
set_address: wp.Function = _writer(wp.uint64)
set_vec3: wp.Function = _writer(wp.vec3)
set_vec4i: wp.Function = _writer(wp.vec4i)


@wp.func
def set_byte(address: wp.uint64, i: Any, x: wp.int32):
    """Write x as the i-th uint8 at an address."""
    view = wp.array(ptr=address + wp.uint64(i), shape=(1,), dtype=wp.uint8)
    view[0] = wp.uint8(x)
