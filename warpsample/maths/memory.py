"""One number or vector at an address: what kernels read and write without a view of a whole array.

Loops that are to vectorise open a view, `wp.array(ptr=...)`, and index that. An index is of any integer type, from 0 on.
"""

from typing import Any

import warp as wp


def _reader(kind: Any) -> wp.Function:
    """A function (address, i) -> the i-th number or vector of a kind."""
    size = wp.types.type_size_in_bytes(kind)

    @wp.func
    def read(address: wp.uint64, i: Any):
        return wp.array(ptr=address + wp.uint64(i) * wp.uint64(size), shape=(1,), dtype=kind)[0]

    return read


def _writer(kind: Any) -> wp.Function:
    """A function (address, i, x) that writes the i-th number or vector of a kind."""
    size = wp.types.type_size_in_bytes(kind)

    @wp.func
    def write(address: wp.uint64, i: Any, x: kind):
        view = wp.array(ptr=address + wp.uint64(i) * wp.uint64(size), shape=(1,), dtype=kind)
        view[0] = x

    return write


float_at, int_at, long_at, address_at, byte_at = map(_reader, (wp.float32, wp.int32, wp.int64, wp.uint64, wp.uint8))
vec3_at, vec3i_at, vec3d_at = map(_reader, (wp.vec3, wp.vec3i, wp.vec3d))
set_float, set_int, set_address = map(_writer, (wp.float32, wp.int32, wp.uint64))
set_vec3, set_vec4i = map(_writer, (wp.vec3, wp.vec4i))


@wp.func
def set_byte(address: wp.uint64, i: Any, x: wp.int32):
    """Writes the i-th uint8."""
    view = wp.array(ptr=address + wp.uint64(i), shape=(1,), dtype=wp.uint8)
    view[0] = wp.uint8(x)
