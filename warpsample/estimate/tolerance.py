"""Search for the number of rays that reaches a standard error, by trial rounds with more and more rays from some points.

The trial uses its own random numbers and its values are discarded, so the trial does not bias the result. All points take
the same number of rays. A number for each point would save little, because empty strata cost no ray, and the trial of each
point would cost more than the saving.
"""

from math import inf, log

import numpy as np

from warpsample.estimate.result import Estimate, has_value
from warpsample.estimate.runner import Runner
from warpsample.estimate.strata import counts_with_the_strata_of, strata_of
from warpsample.sequences.hashing import seed_for

MISSED = 1.1
"""Largest ratio of an error to a tolerance that counts as reached: the error's own error is a few percent."""

_AIM = 0.98  # of the tolerance: the trial's error has an error of 3 %, its forecast errs upwards, and counts are rounded up
_SHARE, _LEAST_SHARE = 12, 48  # one point in 12 to 48 is tried: the more strata a lobe has, the fewer points are needed
_FEWEST_POINTS, _MOST_POINTS = 256, 1 << 14
_TURN = 0.6180339887498949  # 1 / phi: any number of first points is evenly spread over the rows
_FIRST, _LEAST = 8, 4  # rays of the first round; fewest rays of the result, two for each replicate
# Largest ratio of the needed rays to the tried rays that is extrapolated (the second for a single stratum), and the largest
# ratio of one round's rays to those of the round before.
_FAR, _FAR_OF_ONE_CELL, _FARTHEST = 1.3, 2.0, 32.0
_WORTH_TRYING = 1.5  # finer strata are tried if they begin below this multiple of the needed rays
_SLOWEST, _FASTEST = 0.5, 2.0  # limits of the exponent r: the error falls as rays^-r
_APART = 4.0  # ratio of the rays of two rounds from which on the two rounds give an exponent
_APART_IF_SMOOTH = 1.5  # the same ratio without a mesh: exponents differ by integrand, and the error is known better
_ROUNDS = 8
_NEXT = 1.5  # ratio of the numbers of rays of two confirmations
_PRIOR = 16.0  # weight of the prior on edges, as a number of points: for few points, and where no ray has hit anything


def find_count(trial: "Trial", tolerance: float) -> int:
    """Find the number of rays per point for which the root mean square of the standard errors is `tolerance`.

    The number is at most the plan's count.
    """
    most, traced = trial.runner.plan.count, trial.runner.traced
    trial.run(_FIRST)
    while True:
        needed = max(_LEAST, trial.needed(_AIM * tolerance))
        fewest, top = counts_with_the_strata_of(trial.count, traced)
        if needed > top and trial.needed(tolerance) <= top:
            needed = top
        if fewest / 2 <= needed < fewest:
            needed = fewest  # coarser strata may have a larger error
        far = (_FAR if fewest > _FIRST else _FAR_OF_ONE_CELL) * trial.count
        near = traced or trial.count <= _FAR_OF_ONE_CELL * needed
        if near and (fewest <= needed <= min(far, top) or (trial.count == most and needed >= fewest)):
            break
        following, tried = trial.whole(min(needed, _FARTHEST * trial.count)), dict(trial.tried)
        if following in tried or len(tried) == _ROUNDS:
            # The rounds go to and fro between strata: at walls, only strata that end at the horizon have no error.
            needed = min((count for count, error in tried.items() if error <= tolerance), default=most)
            break
        trial.run(following)
    if not traced:
        return trial.whole(needed)
    return _confirm(trial, trial.whole(_finer_if_less(trial, needed, _AIM * tolerance)), tolerance)


def _confirm(trial: "Trial", count: int, tolerance: float) -> int:
    """Return `count` rays per point, or more if these miss the tolerance in a trial of their own.

    That trial is for few rays, whose error does not fall steadily with their number, as at walls below an open sky, and for
    far fewer rays than in the last round, because errors may fall faster than forecast, as below stripes of a picture.
    """
    most, top = trial.runner.plan.count, counts_with_the_strata_of(_FIRST)[1]
    if count > top and trial.count <= _FAR * count:
        return count
    while count < most and dict(trial.tried).get(count, inf) > tolerance:
        trial.run(count, _LEAST_SHARE)
        if trial.error <= MISSED * tolerance:
            break
        enough = (more for more, error in trial.tried if more > count and error <= tolerance)
        count = trial.whole(min(_NEXT * count, min(enough, default=most)))
    return count


def _finer_if_less(trial: "Trial", needed: float, aim: float) -> float:
    """Return the number of rays per point, `needed` or a larger one that is cheaper because more rays are skipped.

    Finer strata may be cheaper because more strata are empty.
    """
    cast, top = trial.cast * needed, counts_with_the_strata_of(needed)[1]
    finer = counts_with_the_strata_of(_WORTH_TRYING * needed)[0]
    if not (counts_with_the_strata_of(_FIRST)[1] < top < finer <= trial.runner.plan.count):
        return needed
    trial.run(finer)
    rather = max(finer, trial.needed(aim))
    return rather if trial.cast * rather < cast else needed


class Trial:
    """Trial estimates at a few of the points, from which the required number of rays is extrapolated.

    Attributes:
        count: Number of rays per point in the last round; 0 before the first.
        error: Root mean square of the standard errors in the last round.
        cast: Share of the rays of the last round that were cast; the rest was skipped.
        rate: Exponent r of the error, which falls as rays^-r: the sequence's, or estimated from two rounds.
        rays: Number of rays cast in all rounds, (P,) int32.
        tried: Number of rays per point and error of each round.
    """

    def __init__(self, runner: Runner) -> None:
        """Choose the trial points, in an order whose first points are spread over all active points."""
        self.runner, self.rate, self.count = runner, runner.options.sequence.rate, 0
        active = runner.options.active
        rows = np.arange(len(runner.at)) if active is None else np.flatnonzero(active)
        some = min(max(len(rows) // _SHARE, _FEWEST_POINTS), _MOST_POINTS, len(rows))
        self.rows = rows if some == len(rows) else rows[(np.arange(some) * _TURN % 1.0 * len(rows)).astype(np.int64)]
        self.active, self.rays = len(rows), np.zeros(len(runner.at), np.int32)
        self.tried: list[tuple[int, float]] = []

    def whole(self, count: float) -> int:
        """Round a number of rays up to a number that the strata and the sequence allow, at most the plan's count."""
        plan = self.runner.plan
        rays = int(np.ceil(min(count, plan.count)))
        if self.runner.options.sequence.nets:  # the numbers of strata and replicates are powers of two, too
            return min(1 << (rays - 1).bit_length(), plan.count)
        step = strata_of(rays, traced=self.runner.traced).step
        return min(-(-rays // step) * step, plan.count)

    def run(self, count: float, share: float = 0.0) -> None:
        """Estimate the trial points with `count` rays each; update the measured error and its rate of convergence.

        One point in `share` is tried. Default: the number of points falls with the square root of the number of strata.
        """
        traced, count = self.runner.traced, self.whole(count)
        strata = strata_of(count, traced=traced)
        share = share or min(_SHARE * np.sqrt(strata.bands * strata.sectors), _LEAST_SHARE)
        chosen = np.zeros(len(self.runner.at), bool)
        chosen[self.rows[: max(int(self.active / share), _FEWEST_POINTS)]] = True
        # Skip always, whatever the call's `skip`: skipping changes no bit, and the count must not depend on the option.
        found = self.runner.result(seed_for("trial", self.runner.options.seed), count, chosen, skip=True)
        good = chosen & (has_value(found.status))
        error = error_of(found, good)
        alike = counts_with_the_strata_of(self.count, traced) == counts_with_the_strata_of(count, traced)
        if self.count and alike and error > 0.0 and self._is_far_from_last(count):
            self.rate = min(max(log(self.error / error) / log(count / self.count), _SLOWEST), _FASTEST)
        self.count, self.error, self.rays = count, error, self.rays + found.rays
        self.tried.append((count, error))
        self.cast = float(found.rays[good].mean()) / count if good.any() else 0.0

    def _is_far_from_last(self, count: int) -> bool:
        """Return whether `count` differs enough from the last trial's number of rays to estimate the rate of convergence."""
        if self.runner.traced:
            return count >= _APART * self.count
        return max(count / self.count, self.count / count) >= _APART_IF_SMOOTH

    def needed(self, error: float) -> float:
        """Return the number of rays per point for a standard error of `error`, extrapolated from the last trial."""
        return self.count * float(np.float_power(self.error / error, 1.0 / self.rate))


def error_of(found: Estimate, good: np.ndarray) -> float:
    """Return the root mean square of the standard errors at the points in `good`, for the component with the largest."""
    points = np.count_nonzero(good)
    squares = [np.square(a[good].astype(np.float64)).sum(axis=0) for a in (found.standard_error, found.spread)]
    return float(np.sqrt(np.max((squares[0] + _PRIOR / max(points, 1) * squares[1]) / (points + _PRIOR), initial=0.0)))
