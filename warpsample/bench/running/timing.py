"""Timings that can be compared: interleaved, so that a slow minute hits every case."""

from collections.abc import Callable, Sequence
from math import inf
from time import perf_counter

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


def interleave(
    cases: Sequence[Callable[[], float]],
    repeats: int,
    reference: Callable[[], float] | None = None,
    budget: float = inf,
) -> tuple[list[list[float]], list[list[float]]]:
    """Runs all cases in turn, `repeats` rounds of it.

    Args:
        cases: each says how many seconds it took, such as a `stopwatch`.
        repeats: rounds, at most.
        reference: run after each case, to be its ratio's other side.
        budget: seconds; once they are over, three rounds are enough.

    Returns:
        the seconds of each case, and those of the reference beside it (empty without one).
    """
    times: list[list[float]] = [[] for _ in cases]
    beside: list[list[float]] = [[] for _ in cases]
    start = perf_counter()
    for done in range(repeats):
        if done >= _LEAST_REPEATS and perf_counter() - start > budget:
            break
        for i, case in enumerate(cases):
            times[i].append(case())
            if reference is not None:
                beside[i].append(reference())
    return times, beside
