"""Struct, constants and functions shared by the two kernels for directions, which give the same bits.

The kernel for rows (`rows.py`) loops over the samples of one point and computes the frame and the key of the point once.
Rows are best for many samples on the CPU. With segments of one sample, rows serve CUDA, where neighbouring threads
then store to neighbouring addresses. The kernel for blocks (`blocks.py`) loops over consecutive (point, sample) pairs.
Blocks are best for few samples on the CPU, where one row would not fill a SIMD vector.
"""

import warp as wp

from warpsample.distributions.parameters import Parameters
from warpsample.host.locks import once
from warpsample.maths.frames import frame_along
from warpsample.maths.memory import set_byte, vec4_at
from warpsample.maths.numerics import scaled_to_unit

OK = 0
INACTIVE = 1
ZERO_NORMAL = 2
NONFINITE_NORMAL = 3
INVALID_PARAMETER = 6
INVALID_TANGENT = 7


@wp.func
def normal_status(n: wp.vec3, weight: wp.float32) -> wp.int32:
    """Return the status of a point: INACTIVE for a weight of 0, else OK, ZERO_NORMAL or NONFINITE_NORMAL."""
    finite = (n[0] - n[0]) + (n[1] - n[1]) + (n[2] - n[2]) == 0.0
    zero = wp.abs(n[0]) + wp.abs(n[1]) + wp.abs(n[2]) == 0.0
    code = wp.where(finite, wp.where(zero, ZERO_NORMAL, 0), NONFINITE_NORMAL)
    return wp.where(weight == 0.0, INACTIVE, code)


@wp.func
def store_direction(vectors: wp.array[wp.float32], pdf: wp.array[wp.float32], i: wp.int32, d: wp.vec4):
    """Write the direction d[0:3] as the i-th row of the array of vectors."""
    vectors[3 * i] = d[0]
    vectors[3 * i + 1] = d[1]
    vectors[3 * i + 2] = d[2]


@wp.func
def store_direction_and_pdf(vectors: wp.array[wp.float32], pdf: wp.array[wp.float32], i: wp.int32, d: wp.vec4):
    """Write the direction d[0:3] and its density d[3] as the i-th entries of the two output arrays."""
    store_direction(vectors, pdf, i, d)
    pdf[i] = d[3]


@wp.func
def weigh_by_mask(active: wp.array[wp.uint8], i: wp.int32) -> wp.float32:
    """Return 0 if the mask excludes the i-th point, else 1, as a factor for the point's normal."""
    return wp.where(active[i] == wp.uint8(0), 0.0, 1.0)


@wp.func
def weigh_all(active: wp.array[wp.uint8], i: wp.int32) -> wp.float32:
    """Return 1 for every point: without a mask, no point is excluded."""
    return 1.0


def select_accessors(with_pdf: bool, masked: bool) -> tuple[wp.Function, wp.Function]:
    """Return two wp.funcs: one stores a direction, with density or without; the other reads the mask of active points."""
    return store_direction_and_pdf if with_pdf else store_direction, weigh_by_mask if masked else weigh_all


@wp.struct
class Samples:
    """Arguments of the kernels for directions: scalars and addresses of arrays.

    Attributes:
        run: words of `Sequence.run`, for the upper half that the ids of all points share.
        first_point: lower half of the id of row 0, if ids are consecutive.
        seed: seed, used with `ids`.
        ids: address of (P,) uint64 user-defined ids, or 0.
        points: number of points, P.
        count: samples per point.
        segment: samples of a segment; below `count`, a task is one segment.
        rows: number of rows or blocks in a task.
        normals, vectors, pdf: addresses of (P, 3), (P, count, 3) and (P, count) float32.
        status, active: addresses of (P,) uint8; `active` is 0 without a mask.
        parameters: parameters of the distribution; 0 where they are by point.
        tables: address of the addresses of the parameters by point, see `distributions.by_point.tables`, or 0.
        row: row of the first point in these tables.
        tangents: address of (P, 4) float32, tangents with the sign of the bitangent last, or 0.
    """

    run: wp.vec4ui
    first_point: wp.uint32
    seed: wp.uint64
    ids: wp.uint64
    points: wp.int64
    count: wp.int32
    segment: wp.int32
    rows: wp.int32
    normals: wp.uint64
    vectors: wp.uint64
    pdf: wp.uint64
    status: wp.uint64
    active: wp.uint64
    parameters: Parameters
    tables: wp.uint64
    row: wp.int64
    tangents: wp.uint64


SamplesArgs = type(Samples().__ctype__())
"""The ctypes structure of `Samples`: creating one takes 2 us, setting the fields of a `Samples` takes 50 us."""


@once
def build_unit_writer(masked: bool, stride: int, with_check: bool) -> wp.Function:
    """Build the wp.func that normalises normals and writes their x, y and z as three consecutive arrays of `stride` numbers.

    Inactive normals become 0. With `with_check`, a fourth array holds a number below 0.1 in magnitude where a normal has a
    direction.
    """
    weigh = weigh_by_mask if masked else weigh_all

    @wp.func
    def write_units(normals: wp.array[wp.float32], active: wp.array[wp.uint8], rows: wp.int32, units: wp.array[wp.float32]):
        """Write the unit normals of `rows` points; return 1 if a normal is inactive, zero or not finite, else 0."""
        rare = wp.int32(0)
        r = wp.int32(0)
        while r < rows:
            unit = scaled_to_unit(weigh(active, r) * wp.vec3(normals[3 * r], normals[3 * r + 1], normals[3 * r + 2]))
            units[r] = unit[0]
            units[stride + r] = unit[1]
            units[2 * stride + r] = unit[2]
            if wp.static(with_check):
                units[3 * stride + r] = unit[3]
            rare = rare | wp.where(wp.abs(unit[3]) < 0.1, 0, 1)
            r += 1
        return rare

    return write_units


@once
def build_orienter(tangents: bool) -> wp.Function:
    """Build the wp.func that returns the unit normal of a point or, with tangents, the tangent frame."""
    if not tangents:

        @wp.func
        def orient(samples: Samples, point: wp.int64, n: wp.vec3):
            """Return the unit normal n of the point, which orients the sampled directions."""
            return n

    else:

        @wp.func
        def orient(samples: Samples, point: wp.int64, n: wp.vec3):
            """Return the frame with x along the point's tangent; write a status code if the tangent is invalid."""
            frame, usable = frame_along(n, vec4_at(samples.tangents, point))
            if usable == 0:
                set_byte(samples.status, point, INVALID_TANGENT)
            return frame

    return orient
