"""Confidence intervals of estimates, by Student's t distribution with a prior for geometry that few rays have hit.

A stratum is *mixed* if some of its rays are occluded and some are not: an edge passes through the stratum. The number of
rays of a low-discrepancy set on one side of an edge varies by about one, whatever the edge (`Sequence.edge`). The expected
variance of edges is therefore a second source, besides the difference between a stratum's two replicates. The expectation
counts as a number of further differences, the conjugate prior of a normal's variance. The posterior is a t distribution.
The prior counts for less where the differences exceed the expectation, as among leaves. Strata without an edge have no
prior.

Openings or blockers may exist that no ray has hit. If all rays agree, as under a small opening or below a wire, up to 3.7
rays of the other kind are compatible with the sample at 95 % (Clopper1934; the bound holds for stratified rays, too). A t
distribution with 9 degrees of freedom and a scale of 1.64 rays gives the same bound within 2 % at levels from 0.9 to 0.99.
If rays disagree, the variance `unseen` of the sequence is added: half a ray squared for a lattice, more for independent
rays, of which two may hit where six are expected. If a single ray differs from the others of its stratum, up to 5.6 rays
are compatible with the sample.

Where the rays of each stratum agree, the unbiased standard error of an `Estimate` is 0. Files of rasters and textures hold
only a standard error. So errors in files include geometry between the rays, too.
"""

from dataclasses import replace
from math import sqrt
from typing import Any, NamedTuple

import numpy as np
import warp as wp
from numpy.typing import NDArray

from warpsample.host.locks import imported
from warpsample.maths.numerics import ONE, TWO, ZERO

_HALF_A_RAY, _IF_ALL_AGREE, _IF_ONE_DIFFERS = 0.25, 1.64**2, 3.85  # variances of geometry without a hit, in rays squared
_WORTH_IF_ALL_AGREE = 9.0
_AGREE = 0.3  # largest standard error of rays that nearly agree, in standard deviations of what they may have missed
_WORTH_OF_COUNTS = 16.0  # differences: from edge to edge the variance varies by a third of its mean, at 4 to 8 samples
_WORTH_OF_WEIGHTS = 4.0  # less than for counts: the change of the weight at an edge is estimated from the rays
_THREE = wp.constant(wp.float64(3.0))

LEVEL = 0.95
DEGREES = np.float64(9.0)
"""Degrees of freedom of the t distribution for other levels, as in `estimate.intervals`."""

_LEAST = np.float32(0.5)  # of the interval: at 64 rays, it raises the rms error of occlusion by 0.1 %, of distances by 8 %


class Interval(NamedTuple):
    """Lower and upper ends of a confidence interval for each point.

    Attributes:
        lower: Lower ends, (P,) or (P, 3) float32, in the unit of the values.
        upper: Upper ends, of the same shape and unit.
    """

    lower: NDArray[np.float32]
    upper: NDArray[np.float32]


def interval_of(value: np.ndarray, spread: np.ndarray, degrees: np.ndarray, level: float) -> Interval:
    """Return the confidence intervals of values that have t-distributed errors with scale `spread`, at the given level.

    Degrees of freedom below 1 count as 1.
    """
    known, which = np.unique(degrees, return_inverse=True)  # 400,000 points of a yard share 44
    quantiles = imported("scipy.special").stdtrit(np.maximum(known, 1.0).astype(np.float64), 0.5 + 0.5 * level)
    half = spread * quantiles[which].reshape(np.shape(degrees))
    return Interval((value - half).astype(np.float32), (value + half).astype(np.float32))


def half_width_of(found: Any) -> np.ndarray:
    """Return half the width of the 95 % confidence interval at each point of a result, (P,) float32, in its unit."""
    if hasattr(found, "spread"):
        return interval_of(np.float32(0.0), found.spread, found.degrees_of_freedom, LEVEL).upper
    return half_width_of_normal(found.standard_error)


def half_width_of_normal(standard_error: np.ndarray) -> np.ndarray:
    """Return half the width of the 95 % confidence interval for each standard error of a sum of many terms, float32."""
    return interval_of(np.float32(0.0), standard_error, DEGREES, LEVEL).upper


def least_errors(half_width: np.ndarray) -> np.ndarray:
    """Return the standard errors of 95 % confidence intervals with the given half widths: half width / 2.26, float32."""
    return (half_width / half_width_of_normal(np.float32(1.0))).astype(np.float32)


def raised_errors(found: Any) -> np.ndarray:
    """Return the standard errors of a result, raised at points where rays may have missed geometry.

    An error of 0 becomes that of `least_errors`. Other errors become at least half of it, because with weights, as of
    distances, the error is small but above 0 where all rays agree. Errors of exact values do not change, and none is raised
    above the `largest_error` of its value.

    Args:
        found: Result with `standard_error`. Only errors of an `Estimate` change.

    Returns:
        float32 errors, (P,) or (P, 3).
    """
    if not hasattr(found, "spread"):
        return found.standard_error
    error, least = found.standard_error, least_errors(half_width_of(found))
    least = np.minimum(least, found.largest_error.reshape(-1, *[1] * (error.ndim - 1)))
    return np.where(error > 0.0, np.maximum(error, _LEAST * least), least)


def errors_for_means(found: Any) -> np.ndarray:
    """Return the least errors of points for means over surfaces, on which rays may have missed geometry.

    Args:
        found: Result with `standard_error`.

    Returns:
        float32 errors, (P,) or (P, 3): `raised_errors`, or the field `unseen_error` of an exact result.
    """
    unseen = getattr(found, "unseen_error", None)
    return raised_errors(found) if unseen is None else unseen


@wp.struct
class Prior:
    """Prior assumptions on the variance of a sum over rays, with which few rays still give a valid confidence interval.

    worth: Weight of the expected variance, as a number of squared differences.
    unseen: Variance of geometry that no ray has hit, in rays squared.
    worth_if_all_agree, unseen_if_all_agree: The same two numbers for a point without a mixed stratum.
    unseen_if_one_differs: The number `unseen` for a point where a single ray differs from its stratum.
    """

    worth: wp.float64
    unseen: wp.float64
    worth_if_all_agree: wp.float64
    unseen_if_all_agree: wp.float64
    unseen_if_one_differs: wp.float64


def prior_numbers(counts: bool, unseen: float, traced: bool) -> tuple[float, ...]:
    """Return the numbers of the prior that confidence intervals use, in the order of the fields of `Prior`.

    Args:
        counts: Whether each ray adds exactly 0 or 1.
        unseen: Variance of geometry that no ray has hit, in rays squared, of the sequence.
        traced: Whether rays are traced against a mesh.
    """
    worth = _WORTH_OF_COUNTS if counts else _WORTH_OF_WEIGHTS
    if not traced:
        return worth, _HALF_A_RAY, worth, _HALF_A_RAY, _HALF_A_RAY
    return worth, unseen, _WORTH_IF_ALL_AGREE, _IF_ALL_AGREE, _IF_ONE_DIFFERS


def widen(found: Any, typical: tuple[float, ...], count: int) -> Any:
    """Return an `Estimate` whose intervals allow for a few rays of typical value where the rays of a point nearly agree.

    Args:
        found: Estimate with `count` rays per point.
        typical: Typical value of a ray for each component; 0 if unknown.
        count: Number of rays per point.
    """
    if not any(typical):
        return found
    least = np.float32(sqrt(_IF_ALL_AGREE) / count) * np.array(typical, np.float32)
    is_narrow = (found.degrees_of_freedom > 0.0) & (found.spread < least)  # points without a value have no degrees
    is_narrow &= found.standard_error <= _AGREE * least
    spread = np.where(is_narrow, least, found.spread)
    degrees = np.where(is_narrow, np.float32(_WORTH_IF_ALL_AGREE), found.degrees_of_freedom)
    return replace(found, spread=spread, degrees_of_freedom=degrees)


@wp.func
def edge_variance(free: wp.int32, rays: wp.int32, limit: wp.float32) -> wp.float64:
    """Return the variance expected between two independent sets of rays in one stratum, in rays squared.

    The variance is that of independent rays, free * (rays - free) / (rays - 1), or `limit` if that is less. It is 0 where
    all rays agree.
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
    """Return (squared scale, degrees of freedom) of Student's t distribution for the error of a sum over rays.

    Args:
        variance: Sum over all strata of the squared difference between the replicates.
        expected: Expected value of the mixed strata's part of `variance`, from `edge_variance`.
        unseen: Squared weight of one ray, the mean over the strata.
        rest: Part of `variance` from strata that are not mixed.
        fourth: Sum of the squares of the terms of `rest`.
        mixed: Number of mixed strata.
        fewer: Number of rays of mixed strata that differ from the majority of their stratum.
        strata: Number of all strata.
        prior: Prior. Where the differences exceed the expectation, its `worth` is divided by the square of their ratio.
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
