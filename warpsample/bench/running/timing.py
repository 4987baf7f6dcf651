"""Interleaved timings, so that a slow minute of the machine affects every case."""

from collections.abc import Callable, Mapping
from math import inf
from time import perf_counter
from typing import TypeVar

Case = TypeVar("Case")

_LEAST_REPEATS = 3
WARM_UP = 0.03
"""Minimum seconds of untimed runs before a timed run."""


def build_stopwatch(work: Callable[[], object], warm: Callable[[], object] | None = None) -> Callable[[], float]:
    """Build a function that runs `work` once and returns the seconds.

    Before that run, `warm` (default: `work`) runs untimed for at least 30 ms. This loads kernels and arrays and wakes all
    cores; waking the second core of a virtual machine takes longer than many runs.
    """

    def case() -> float:
        start = perf_counter()
        while True:
            (warm or work)()
            if perf_counter() - start >= WARM_UP:
                break
        start = perf_counter()
        work()
        return perf_counter() - start

    return case


def run_interleaved(cases: Mapping[Case, Callable[[], float]], repeats: int, budget: float = inf) -> dict[Case, list[float]]:
    """Run timed functions in alternation for `repeats` rounds and return the seconds of each run.

    Args:
        cases: functions that return the seconds of one run, such as from `build_stopwatch`.
        repeats: maximum number of rounds.
        budget: seconds after which the rounds stop, once there are three.
    """
    seconds: dict[Case, list[float]] = {case: [] for case in cases}
    start = perf_counter()
    for done in range(repeats):
        if done >= _LEAST_REPEATS and perf_counter() - start > budget:
            break
        for case, run in cases.items():
            seconds[case].append(run())
    return seconds


def time_interleaved(
    works: Mapping[Case, Callable[[], object]], repeats: int, budget: float = inf
) -> dict[Case, list[float]]:
    """Time several functions in alternation for `repeats` rounds; return the seconds of each run."""
    return run_interleaved({case: build_stopwatch(work) for case, work in works.items()}, repeats, budget)
