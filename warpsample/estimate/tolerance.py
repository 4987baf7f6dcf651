"""How many rays reach a standard error: found by a trial, by more and more rays from some of the points.

The trial has random numbers of its own and is then forgotten, so what its rays happened to meet does not sway the result.
All points take one count: where nothing is to be met, strata of the lobe are found empty and cost no ray, so counts of their
own would save little, and a trial of each point would cost more than that.
"""

from math import log

import numpy as np

from warpsample.estimate.result import Estimate
from warpsample.estimate.runner import Runner
from warpsample.estimate.strata import counts_with_the_strata_of, strata_of
from warpsample.sequences.hashing import seed_for

_AIM = 0.98  # of the tolerance: the trial's own error is 3 %, what it foretells errs upwards, and counts are rounded up
_SHARE, _LEAST_SHARE = 12, 48  # one point in so many: the more strata a lobe has, the more each point tells
_FEWEST_POINTS, _MOST_POINTS = 256, 1 << 14
_TURN = 0.6180339887498949  # 1 / phi: points that are evenly spread over the rows, however many are taken
_FIRST, _LEAST = 8, 4  # rays of the first round; and the fewest of the result, two of each replicate
_FAR, _FAR_OF_ONE_CELL, _FARTHEST = 1.3, 2.0, 32.0  # needed of those tried: foretold; tried of those of the round before
_WORTH_TRYING = 1.5  # rays where finer strata begin, of those needed
_SLOWEST, _FASTEST, _APART = 0.5, 2.0, 4.0  # powers of the rays with which an error falls; told by so many times the rays
_APART_IF_SMOOTH = 1.5  # where nothing blocks: the powers differ by integrands, and the error's own error is less
_ROUNDS = 8
_PRIOR = 16.0  # points' worth of what edges let expect, for few points and for where no ray has met anything


def count_within(runner: Runner, tolerance: float) -> tuple[int, np.ndarray]:
    """The rays of each point that reach a standard error in the root mean square over the points.

    Returns:
        (rays, at most those of the plan; rays that the trial cast from each point, (P,) int32).
    """
    trial, most, traced = _Trial(runner), runner.plan.count, runner.traced
    trial.run(_FIRST)
    for _ in range(_ROUNDS):
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
        trial.run(min(needed, _FARTHEST * trial.count))
    return trial.whole(_finer_if_less(trial, needed, _AIM * tolerance) if traced else needed), trial.rays


def _finer_if_less(trial: "_Trial", needed: float, aim: float) -> float:
    """What is needed, or more with finer strata, if fewer rays of these are cast: more strata are empty."""
    cast, top = trial.cast * needed, counts_with_the_strata_of(needed)[1]
    finer = counts_with_the_strata_of(_WORTH_TRYING * needed)[0]
    if not (counts_with_the_strata_of(_FIRST)[1] < top < finer <= trial.runner.plan.count):
        return needed
    trial.run(finer)
    rather = max(finer, trial.needed(aim))
    return rather if trial.cast * rather < cast else needed


class _Trial:
    """Some of the points of a runner, what they tell about the error by some rays, and all rays that they have cast.

    Attributes:
        count: rays of the last round.
        error: the standard error by these, root mean square.
        cast: the share of them that is cast; the rest is skipped.
        rate: the error falls as the rays to the power of -rate: the sequence's, or as two rounds tell it.
        rays: (P,) int32, in all rounds.
    """

    def __init__(self, runner: Runner) -> None:
        """Orders the points that are active, so that the first ones are spread over all."""
        self.runner, self.rate, self.count = runner, runner.options.sequence.rate, 0
        active = runner.options.active
        rows = np.arange(len(runner.at)) if active is None else np.flatnonzero(active)
        some = min(max(len(rows) // _SHARE, _FEWEST_POINTS), _MOST_POINTS, len(rows))
        self.rows = rows if some == len(rows) else rows[(np.arange(some) * _TURN % 1.0 * len(rows)).astype(np.int64)]
        self.active, self.rays = len(rows), np.zeros(len(runner.at), np.int32)

    def whole(self, count: float) -> int:
        """A count rounded up to what the strata and the sequence go into, but not beyond the plan's."""
        plan = self.runner.plan
        rays = int(np.ceil(min(count, plan.count)))
        if self.runner.options.sequence.nets:  # of strata and replicates there are powers of two, too
            return min(1 << (rays - 1).bit_length(), plan.count)
        step = strata_of(rays, traced=self.runner.traced).step
        return min(-(-rays // step) * step, plan.count)

    def run(self, count: float) -> None:
        """A round: the rows that are taken fall with the root of the number of strata."""
        traced, count = self.runner.traced, self.whole(count)
        strata = strata_of(count, traced=traced)
        share = min(_SHARE * np.sqrt(strata.bands * strata.sectors), _LEAST_SHARE)
        chosen = np.zeros(len(self.runner.at), bool)
        chosen[self.rows[: max(int(self.active / share), _FEWEST_POINTS)]] = True
        # Skipping whatever the call says, as it changes no bit: so the count does not depend on it either.
        found = self.runner.result(seed_for("trial", self.runner.options.seed), count, chosen, skip=True)
        good = chosen & (found.status == 0)
        error = error_of(found, good)
        alike = counts_with_the_strata_of(self.count, traced) == counts_with_the_strata_of(count, traced)
        if self.count and alike and error > 0.0 and self._apart(count):
            self.rate = min(max(log(self.error / error) / log(count / self.count), _SLOWEST), _FASTEST)
        self.count, self.error, self.rays = count, error, self.rays + found.rays
        self.cast = float(found.rays[good].mean()) / count if good.any() else 0.0

    def _apart(self, count: int) -> bool:
        """Whether a round differs enough from the one before to tell a power."""
        if self.runner.traced:
            return count >= _APART * self.count
        return max(count / self.count, self.count / count) >= _APART_IF_SMOOTH

    def needed(self, error: float) -> float:
        """How many rays a standard error takes, by what the last round had."""
        return self.count * float(np.float_power(self.error / error, 1.0 / self.rate))


def error_of(found: Estimate, good: np.ndarray) -> float:
    """The root mean square of the errors of some points, of the worst component."""
    points = np.count_nonzero(good)
    squares = [np.square(a[good].astype(np.float64)).sum(axis=0) for a in (found.standard_error, found.spread)]
    return float(np.sqrt(np.max((squares[0] + _PRIOR / max(points, 1) * squares[1]) / (points + _PRIOR), initial=0.0)))
