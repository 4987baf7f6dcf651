"""Estimates whose rays come from two distributions: each has rays and replicates of its own, and the results are added."""

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from warpsample.distributions.record import Distribution
from warpsample.estimate.intervals import widen
from warpsample.estimate.plan import Plan, RaySum
from warpsample.estimate.result import Estimate, Skipped
from warpsample.estimate.runner import Runner
from warpsample.estimate.strata import strata_of
from warpsample.host.device_memory import Loan
from warpsample.sequences.hashing import seed_for

_FEWEST = 2  # rays of each distribution


@dataclass(frozen=True)
class SplitSum:
    """Definition of a sum over rays from the plan's distribution and from another one.

    Attributes:
        first, second: Functions (number of rays from the other distribution for each ray) -> sum over the rays of the plan's
            distribution, and over those of `distribution`.
        distribution: Distribution of the other rays.
        share: Fraction of the rays from `distribution`, 0 to 1. It must not depend on the rays.
        typical: Typical value of one ray, see `RaySum`.
    """

    first: Callable[[float], RaySum]
    second: Callable[[float], RaySum]
    distribution: Distribution
    share: float
    typical: tuple[float, ...] = (0.0,)


class SplitRunner:
    """The two runners of a `SplitSum`, with the interface of a `Runner`."""

    plan: Plan
    traced: bool

    def __init__(self, plan: Plan, summed: SplitSum, loan: Loan) -> None:
        """Prepare nothing yet: the integrands depend on the number of rays."""
        self.plan, self.summed, self.loan = plan, summed, loan
        self.at, self.options, self.traced = plan.at, plan.options, plan.at.scene is not None

    def counts(self, count: int) -> tuple[int, int]:
        """Return the numbers of rays from both distributions for at most `count` rays, after rounding to their strata.

        Both are 0 or at least 2; the first is 0 only for a share of 1. Sequences of powers of two get halves.
        """
        share = self.summed.share
        if self.options.sequence.nets and 0.0 < share < 1.0:
            share = 0.5
        # With a share below 1 the plan's distribution always has rays: only they may reach some of the directions.
        second = min(round(share * count), count if share == 1.0 else count - _FEWEST)
        second = 0 if second < _FEWEST else second
        both = (count - second, second)
        first, second = (strata_of(n, None, self.traced).rays if n else 0 for n in both)
        return first, second

    def result(self, seed: int, count: int, chosen: np.ndarray | None = None, skip: bool | None = None) -> Estimate:
        """Compute the estimate with at most `count` rays per point; see `Runner.result`."""
        first, second = self.counts(count)
        parts = []
        if first:
            runner = Runner(self.plan, self.summed.first(second / first), self.loan)
            parts.append(runner.result(seed, first, chosen, skip))
        if second:
            plan = replace(self.plan, distribution=self.summed.distribution)
            runner = Runner(plan, self.summed.second(first / second), self.loan)
            parts.append(runner.result(seed_for("second", seed), second, chosen, skip))
        with np.errstate(under="ignore"):  # of pictures as dark as 1e-38
            return widen(parts[0] if len(parts) == 1 else add_estimates(*parts), self.summed.typical, first + second)


def add_estimates(one: Estimate, other: Estimate) -> Estimate:
    """Return the sum of two independent estimates of the same points, with the errors of both.

    The degrees of freedom are the harmonic mean of both, weighted by the squared spreads. The rays of each are in few
    strata, and intervals with the degrees of Welch and Satterthwaite would be too short: 92 % at a nominal 95 % under suns.
    """
    squares = [np.square(each.spread.astype(np.float64)) for each in (one, other)]
    total, least = sum(squares), np.maximum(one.degrees_of_freedom, other.degrees_of_freedom).astype(np.float64)
    weight = sum(s / np.maximum(e.degrees_of_freedom, 1.0) for s, e in zip(squares, (one, other), strict=True))
    spread, degrees = np.sqrt(total), np.divide(total, weight, out=least, where=weight > 0.0)
    good = one.status == other.status
    status = np.where(good, one.status, np.maximum(one.status, other.status)).astype(np.uint8)
    numbers: dict[str, Any] = {
        "value": one.value + other.value,
        "standard_error": np.sqrt(sum(np.square(each.standard_error.astype(np.float64)) for each in (one, other))),
        "spread": spread,
        "degrees_of_freedom": degrees,
    }
    for name, array in numbers.items():
        array[~good] = 0.0
        numbers[name] = array.astype(np.float32)
    skipped = Skipped(
        points=int(np.count_nonzero(~good)) + one.skipped.points,
        open_points=min(one.skipped.open_points, other.skipped.open_points),
        empty_rays=one.skipped.empty_rays + other.skipped.empty_rays,
        weightless_rays=one.skipped.weightless_rays + other.skipped.weightless_rays,
    )
    return replace(one, **numbers, rays=one.rays + other.rays, status=status, skipped=skipped)


def add_spreads(*parts: tuple[np.ndarray, np.ndarray]) -> tuple[np.ndarray, np.ndarray]:
    """Return the spread and the degrees of freedom of a sum of independent t distributions (Welch and Satterthwaite).

    Args:
        parts: spread and degrees of freedom of each distribution, arrays of one shape.
    """
    squares = [np.square(spread.astype(np.float64)) for spread, _ in parts]
    weight = sum(np.square(s) / np.maximum(degrees, 1.0) for s, (_, degrees) in zip(squares, parts, strict=True))
    total = sum(squares)
    degrees = np.divide(np.square(total), weight, out=np.float64(parts[0][1]), where=weight > 0.0)
    return np.sqrt(total), degrees
