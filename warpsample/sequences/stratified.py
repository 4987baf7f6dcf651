"""Stratified points: one random point in each of `count` strata of equal area, for any count."""

import warp as wp

from warpsample.maths.numerics import high_word, low_word, uniform_from_double
from warpsample.sequences.hashing import premixed_key, run_key
from warpsample.sequences.independent import independent_sample
from warpsample.sequences.record import Sequence


@wp.func
def stratified_sample(key: wp.vec4ui, sample: wp.uint32, count: wp.uint32) -> wp.vec2:
    """Return a random point in stratum number `sample` of `count` strata, each of area 1/count.

    The strata lie in floor(sqrt(count)) rows. If the number of rows does not divide count, the first rows hold one stratum
    more and are higher in proportion, so that all strata have the same area. Samples follow the order of the strata: to pair
    two calls sample by sample, shuffle one of the calls.
    """
    n = wp.float64(count)
    rows = wp.floor(wp.sqrt(n))
    short_length = wp.floor(n / rows)
    long_rows = n - rows * short_length
    j = wp.float64(wp.int32(sample))
    is_long = j < long_rows * (short_length + wp.float64(1.0))
    # Rows have one length when counted from the first long row, or from the first short row.
    skipped = wp.where(is_long, wp.float64(0.0), long_rows)
    length = wp.where(is_long, short_length + wp.float64(1.0), short_length)
    row = wp.floor((j - skipped + wp.float64(0.5)) / length)
    column = j - skipped - row * length
    jitter = independent_sample(key, sample, count)
    return wp.vec2(
        uniform_from_double((skipped + (row + wp.float64(jitter[0])) * length) / n),
        uniform_from_double((column + wp.float64(jitter[1])) / length),
    )


@wp.func
def stratified(seed: wp.uint64, point: wp.uint64, sample: wp.uint32, count: wp.uint32) -> wp.vec2:
    """Return a random point in stratum number `sample` of `count` strata of the unit square, each of area 1/count."""
    return stratified_sample(premixed_key(run_key(seed, high_word(point)), low_word(point)), sample, count)


RECORD = Sequence(
    name="stratified",
    key=premixed_key,
    sample=stratified_sample,
    progressive=False,
    edge=0.36,
    unseen=1.2,
    colour="#8c6bb1",
    marker="D",
    cells_off=1,
    summary="one jittered point in each stratum of an equal-area grid",
    source="Pharr2023, section 8.5; rows of two lengths allow any count",
)
