"""R2 sequence: multiples of powers of the plastic number modulo 1, with a random shift at every surface point."""

import warp as wp

from warpsample.maths.numerics import uniform_from_bits, weyl
from warpsample.sequences.hashing import point_key
from warpsample.sequences.record import Sequence

# 2^64 / g and 2^64 / g^2, rounded to odd integers, for the plastic number g, the real root of g^3 = g + 1.
_STEP_X = wp.constant(wp.uint64(0xC13FA9A902A6328F))
_STEP_Y = wp.constant(wp.uint64(0x91E10DA5C79E7B1D))


@wp.func
def r2_sample(key: wp.vec4ui, sample: wp.uint32, count: wp.uint32) -> wp.vec2:
    """Return point number `sample` of the R2 sequence: (sample / g, sample / g^2) + shift, modulo 1.

    g is the plastic number, and the random shift is from the key.

    The result is exact for any sample.
    """
    return wp.vec2(uniform_from_bits(weyl(sample, _STEP_X) + key[0]), uniform_from_bits(weyl(sample, _STEP_Y) + key[1]))


@wp.func
def r2(seed: wp.uint64, point: wp.uint64, sample: wp.uint32, count: wp.uint32) -> wp.vec2:
    """Return point number `sample` of the R2 sequence in the unit square, with a random shift at each surface point."""
    return r2_sample(point_key(seed, point), sample, count)


RECORD = Sequence(
    name="r2",
    sample=r2_sample,
    progressive=True,
    wraps=True,
    edge=0.45,
    unseen=0.9,
    colour="#5b8e3e",
    marker="^",
    summary="additive recurrence of the plastic number, cheap and progressive",
    source="Roberts2018",
)
