"""Timings that can be compared: interleaved, so that a slow minute hits every case, and reported with their spread."""

from collections.abc import Callable, Sequence
from statistics import median
from time import perf_counter


def interleave(cases: Sequence[Callable[[], object]], repeats: int) -> list[list[float]]:
    """Seconds of `repeats` runs of each case, in rounds of all cases in turn.

    Each timed run follows an untimed one of the same case, so that kernels are loaded, arrays are where that case leaves
    them, and all cores are awake: a virtual machine may take milliseconds to wake one.
    """
    times: list[list[float]] = [[] for _ in cases]
    for _ in range(repeats):
        for case, kept in zip(cases, times, strict=True):
            case()
            start = perf_counter()
            case()
            kept.append(perf_counter() - start)
    return times


def ratio_of(numerators: list[float], denominators: list[float]) -> tuple[float, float, float]:
    """(median, least, greatest) of the ratios within each round."""
    ratios = [a / b for a, b in zip(numerators, denominators, strict=True)]
    return median(ratios), min(ratios), max(ratios)
