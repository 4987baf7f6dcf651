"""The error of an estimate, from its few squared differences and from what is known of edges, as a t distribution.

A stratum that some rays left and some did not is *mixed*: an edge passes through it. How many rays of a low-discrepancy set
are on one side of an edge varies by about one, whatever the edge (`Sequence.edge`). So the difference between a stratum's
two replicates is not the only witness of its error. What edges let expect counts as if it were some differences more, which
is the conjugate prior of a normal's variance, and the posterior is a t distribution; where the differences exceed what edges
make, as among leaves, it counts for less. Strata without an edge speak for themselves.

What no ray has met may be there all the same. If all rays agree, as they do under a small opening or below a wire, 3.7 rays
are compatible with none at 95 %, by the bounds of Clopper1934, which hold for stratified rays, too; and so it is, within
2 %, at all levels from 0.9 to 0.99, by a t distribution of 9 degrees of freedom and a scale of 1.64 rays. Else, `unseen` of
the sequence is added: half a ray of a lattice, more of independent rays, of which two may be met where six are expected. If
a single ray differs from the others of its stratum, 5.6 are compatible with it.
"""

from typing import NamedTuple

import numpy as np
import warp as wp
from numpy.typing import NDArray

from warpsample.host.locks import imported
from warpsample.maths.numerics import ONE, TWO, ZERO

_HALF_A_RAY, _IF_ALL_AGREE, _IF_ONE_DIFFERS = 0.25, 1.64**2, 3.85  # variances of what no ray has met, in rays squared
_WORTH_IF_ALL_AGREE = 9.0
_WORTH_OF_COUNTS = 16.0  # differences: the variance varies by a third of itself from edge to edge, at 4 to 8 samples
_WORTH_OF_WEIGHTS = 4.0  # by how much an edge changes a weight is not known, but read off the rays
_THREE = wp.constant(wp.float64(3.0))


class Interval(NamedTuple):
    """The ends of an interval.

    Attributes:
        lower: (P,) float32, or (P, 3).
        upper: of the same shape.
    """

    lower: NDArray[np.float32]
    upper: NDArray[np.float32]


def interval_of(value: np.ndarray, spread: np.ndarray, degrees: np.ndarray, level: float) -> Interval:
    """The interval about a value with that much of a t distribution, of a scale and degrees of freedom."""
    half = spread * imported("scipy.special").stdtrit(np.maximum(degrees, 1.0).astype(np.float64), 0.5 + 0.5 * level)
    return Interval((value - half).astype(np.float32), (value + half).astype(np.float32))


@wp.struct
class Prior:
    """What is expected before any ray is cast.

    worth, unseen: differences that the expectation is worth, and the variance of what no ray has met, in rays squared.
    worth_if_all_agree, unseen_if_all_agree: likewise where no stratum is mixed. unseen_if_one_differs: where one ray is all.
    """

    worth: wp.float64
    unseen: wp.float64
    worth_if_all_agree: wp.float64
    unseen_if_all_agree: wp.float64
    unseen_if_one_differs: wp.float64


def prior_numbers(counts: bool, unseen: float, traced: bool) -> tuple[float, ...]:
    """The fields of a Prior, of rays that count 1 or 0 or have other weights, and that may be blocked or not."""
    worth = _WORTH_OF_COUNTS if counts else _WORTH_OF_WEIGHTS
    if not traced:
        return worth, _HALF_A_RAY, worth, _HALF_A_RAY, _HALF_A_RAY
    return worth, unseen, _WORTH_IF_ALL_AGREE, _IF_ALL_AGREE, _IF_ONE_DIFFERS


@wp.func
def edge_variance(free: wp.int32, rays: wp.int32, limit: wp.float32) -> wp.float64:
    """The variance to expect of the difference between a stratum's replicates, in rays squared; 0 where all rays agree.

    That of independent rays, of which `free` went one way, or a limit if that is less.
    """
    share = wp.float64(free) * wp.float64(rays - free) / wp.float64(rays - 1)
    return wp.min(share, wp.float64(limit))


@wp.func
def posterior(
    variance: wp.float64,
    expected: wp.float64,
    unseen: wp.float64,
    rest: wp.float64,
    fourth: wp.float64,
    mixed: wp.int32,
    fewer: wp.int32,
    strata: wp.int32,
    prior: Prior,
):
    """(square of the scale, degrees of freedom) of the t distribution of a sum of rays.

    Args:
        variance: the sum of the strata's squared differences.
        expected: of the mixed strata, what `edge_variance` expects of that.
        unseen: what a ray more would add, squared.
        rest: the part of `variance` that is of other strata.
        fourth: the sum of the squares of what adds up to `rest`.
        mixed: strata.
        fewer: rays of these that differ from most of their stratum.
        strata: all.
        prior: differences that the expectation is worth count for less by the square of how far they exceed it.
    """
    worth = wp.where(mixed > 0, prior.worth, prior.worth_if_all_agree)
    of_ray = wp.where(fewer == 1, prior.unseen_if_one_differs, prior.unseen)
    edges = expected + wp.where(mixed > 0, of_ray, prior.unseen_if_all_agree) * unseen
    seen = wp.where(mixed > 0, variance - rest, ZERO)
    if seen > edges:
        worth *= (edges / seen) * (edges / seen)
    degrees = worth + wp.float64(mixed)
    shrunk = (worth * edges + wp.float64(mixed) * wp.max(seen, ZERO)) / degrees  # rounding leaves seen below 0
    square = shrunk + rest
    if rest > ZERO:
        # Welch and Satterthwaite; of normal differences, E[d^4] = 3 E[d^2]^2.
        own = wp.clamp(_THREE * (rest / fourth) * rest - TWO, ONE, wp.float64(strata))
        first = shrunk / square
        second = rest / square
        degrees = ONE / (first * first / degrees + second * second / own)
    return square, degrees
