"""Timings that can be compared: interleaved, so that a slow minute hits every case, and reported with their spread."""

from collections.abc import Callable, Sequence
from statistics import median
from time import perf_counter


def interleave(cases: Sequence[Callable[[], object]], repeats: int) -> list[list[float]]:
    """Seconds of each run of each case: one round to warm up, then `repeats` rounds of all cases in turn."""
    times: list[list[float]] = [[] for _ in cases]
    for turn in range(repeats + 1):
        for case, kept in zip(cases, times, strict=True):
            start = perf_counter()
            case()
            if turn:
                kept.append(perf_counter() - start)
    return times


def ratio_of(numerators: list[float], denominators: list[float]) -> tuple[float, float, float]:
    """(median, least, greatest) of the ratios within each round."""
    ratios = [a / b for a, b in zip(numerators, denominators, strict=True)]
    return median(ratios), min(ratios), max(ratios)
