"""Timings that can be compared: interleaved, so that a slow minute hits every case."""

from collections.abc import Callable, Mapping
from math import inf
from time import perf_counter
from typing import TypeVar

Case = TypeVar("Case")

_LEAST_REPEATS = 3
WARM_UP = 0.03
"""Seconds of untimed runs before a timed one."""


def stopwatch(work: Callable[[], object], warm: Callable[[], object] | None = None) -> Callable[[], float]:
    """A case that says how many seconds `work` took.

    Before it `warm`, or `work` itself, runs untimed, over and over for 30 ms: so kernels are loaded, arrays are where that
    case leaves them, and all cores are awake, which takes a virtual machine's second one longer than many a run.
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


def in_turns(cases: Mapping[Case, Callable[[], float]], repeats: int, budget: float = inf) -> dict[Case, list[float]]:
    """The seconds of all cases, which are run in turn, `repeats` rounds of it.

    Args:
        cases: each says how many seconds it took, such as a `stopwatch`.
        repeats: rounds, at most.
        budget: seconds; once they are over, three rounds are enough.
    """
    seconds: dict[Case, list[float]] = {case: [] for case in cases}
    start = perf_counter()
    for done in range(repeats):
        if done >= _LEAST_REPEATS and perf_counter() - start > budget:
            break
        for case, run in cases.items():
            seconds[case].append(run())
    return seconds


def timed(works: Mapping[Case, Callable[[], object]], repeats: int, budget: float = inf) -> dict[Case, list[float]]:
    """The seconds of all works, each timed by a stopwatch, in turns."""
    return in_turns({case: stopwatch(work) for case, work in works.items()}, repeats, budget)
