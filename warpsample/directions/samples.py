"""What the two kernels for directions share; their loops differ in shape, their results in no bit.

*Rows* (`rows`) walk the samples of one point, so all that depends on the point alone (frame, scramble keys) is
computed once: for many samples on the CPU. In segments of one sample they serve CUDA, where neighbouring threads then store
side by side. *Blocks* (`blocks`) walk consecutive (point, sample) pairs: for few samples on the CPU, where a row
would not fill a vector.
"""

import warp as wp

from warpsample.distributions.parameters import Parameters
from warpsample.host.locks import once
from warpsample.maths.numerics import scaled_to_unit

OK = 0
INACTIVE = 1
ZERO_NORMAL = 2
NONFINITE_NORMAL = 3


@wp.func
def normal_status(n: wp.vec3, weight: wp.float32) -> wp.int32:
    """INACTIVE where the weight is 0, else OK, ZERO_NORMAL or NONFINITE_NORMAL."""
    finite = (n[0] - n[0]) + (n[1] - n[1]) + (n[2] - n[2]) == 0.0
    zero = wp.abs(n[0]) + wp.abs(n[1]) + wp.abs(n[2]) == 0.0
    code = wp.where(finite, wp.where(zero, ZERO_NORMAL, 0), NONFINITE_NORMAL)
    return wp.where(weight == 0.0, INACTIVE, code)


@wp.func
def store_direction(vectors: wp.array[wp.float32], pdf: wp.array[wp.float32], i: wp.int32, d: wp.vec4):
    """Writes the direction in d at index i."""
    vectors[3 * i] = d[0]
    vectors[3 * i + 1] = d[1]
    vectors[3 * i + 2] = d[2]


@wp.func
def store_direction_and_pdf(vectors: wp.array[wp.float32], pdf: wp.array[wp.float32], i: wp.int32, d: wp.vec4):
    """The direction and its density, d[3]."""
    store_direction(vectors, pdf, i, d)
    pdf[i] = d[3]


@wp.func
def weigh_by_mask(active: wp.array[wp.uint8], i: wp.int32) -> wp.float32:
    """0 where the mask is, else 1: what the normal is multiplied by."""
    return wp.where(active[i] == wp.uint8(0), 0.0, 1.0)


@wp.func
def weigh_all(active: wp.array[wp.uint8], i: wp.int32) -> wp.float32:
    """1, without a mask."""
    return 1.0


def select_accessors(with_pdf: bool, masked: bool) -> tuple[wp.Function, wp.Function]:
    """(store, weigh) of a kernel that stores the density or does not, reads the mask or does not."""
    return store_direction_and_pdf if with_pdf else store_direction, weigh_by_mask if masked else weigh_all


@wp.struct
class Samples:
    """Scalars and addresses: normals (P, 3), vectors (P, count, 3), pdf (P, count) float32; status, active (P,) uint8.

    The ids of all points have the same high word, which went into the run, what their keys have in common; the low ones
    begin with first_point. Or they are `ids`, (P,) uint64, else 0, of a run by the seed. A task is `rows` rows or
    blocks, or one segment, if `segment` samples are fewer than `count`.
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


SamplesArgs = type(Samples().__ctype__())
"""As ctypes takes it: made in 2 us, where setting the fields of `Samples` one by one takes 50."""


@once
def build_unit_writer(masked: bool, stride: int, with_check: bool) -> wp.Function:
    """A function that writes unit normals: x of all rows from 0 on, y from stride, z from 2 stride; the check from 3 stride.

    A normal that is not active becomes 0. The check, if it is asked for, is below 0.1 where a normal has a direction.
    """
    weigh = weigh_by_mask if masked else weigh_all

    @wp.func
    def write_units(normals: wp.array[wp.float32], active: wp.array[wp.uint8], rows: wp.int32, units: wp.array[wp.float32]):
        """1 if some normal has no direction, else 0."""
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
