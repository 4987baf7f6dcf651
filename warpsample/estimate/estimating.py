"""Computation of an estimate, with a fixed number of rays per point or with as many as a tolerance requires."""

import warnings
from collections.abc import Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from dataclasses import replace
from math import sqrt

import numpy as np

from warpsample.estimate.plan import Plan, RaySum
from warpsample.estimate.result import Estimate, has_value
from warpsample.estimate.runner import Runner
from warpsample.estimate.split import SplitRunner, SplitSum
from warpsample.estimate.strata import strata_of
from warpsample.estimate.tolerance import MISSED, Trial, error_of, find_count
from warpsample.host.progress import bar, log

_messages: ContextVar[list[str] | None] = ContextVar("messages", default=None)


@contextmanager
def collect_missed_tolerances() -> Iterator[list[str]]:
    """Collect the warnings of tolerances that are not reached within a `with` statement, in place of showing them.

    A call that consists of several estimates uses this function to warn once.
    """
    messages: list[str] = []
    token = _messages.set(messages)
    try:
        yield messages
    finally:
        _messages.reset(token)


def warn_of_missed_tolerance(message: str, stacklevel: int) -> None:
    """Warn of a tolerance that is not reached, or hand the message to the enclosing `collect_missed_tolerances`.

    Args:
        message: Text of the warning.
        stacklevel: Level of the caller to blame, as for `warnings.warn` in the calling function.
    """
    if (messages := _messages.get()) is None:
        warnings.warn(message, stacklevel=stacklevel + 1)
    else:
        messages.append(message)


def estimate(plan: Plan, summed: RaySum | SplitSum) -> Estimate:
    """Cast rays from each point of a checked call, and return the mean of the rays' weights with its standard error.

    With a tolerance, a trial first finds the number of rays. A warning reports a tolerance that `count` rays do not reach.
    """
    options, traced = plan.options, plan.at.scene is not None
    with bar(options.progress, "casting rays" if traced else "sampling directions"), options.memory.loan() as loan:
        runner = SplitRunner(plan, summed, loan) if isinstance(summed, SplitSum) else Runner(plan, summed, loan)
        if plan.tolerance is None or len(plan.at) == 0:
            return runner.result(options.seed, plan.count)
        trial = Trial(runner)
        count = find_count(trial, plan.tolerance)
        log.info("tolerance %g: %d of at most %d rays of each point", plan.tolerance, count, plan.count)
        main = runner.result(options.seed, count)
        hint = "allow more rays with a larger count (--samples)"
        if count < plan.count:
            hint = f"its rays met what the trial missed; without a tolerance, {plan.count:,} rays per point are cast"
        if _is_missed(main, plan.tolerance, is_most=count == plan.count):
            message = f"tolerance: got {plan.tolerance:g}, which is not reached with {count:,} rays per point; {hint}"
            warn_of_missed_tolerance(message, stacklevel=4)
    saved = strata_of(plan.count, traced=traced).rays - strata_of(count, traced=traced).rays
    unneeded = saved * int(np.count_nonzero(has_value(main.status))) - int(trial.rays.sum(dtype=np.int64))
    return replace(main, rays=main.rays + trial.rays, skipped=replace(main.skipped, unneeded_rays=max(0, unneeded)))


def _is_missed(found: Estimate, tolerance: float, *, is_most: bool) -> bool:
    """Return whether the standard errors exceed a tolerance, with the most rays that are allowed or with fewer.

    Values above 0 without rays and differences are proven. Values of 0 are not, as below the horizon of the sky. With fewer
    rays, errors of few points may be larger by chance: three standard deviations, if the error of one point may be as large
    as the tolerance.
    """
    good = has_value(found.status)
    is_proven = found.value[good].all() and not (found.rays.any() or found.standard_error.any())
    times = MISSED if is_most else MISSED + 3.0 / sqrt(max(np.count_nonzero(good), 1))
    return not is_proven and error_of(found, good) > times * tolerance
