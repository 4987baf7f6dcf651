"""Checks of arguments, each with an error that names the argument, what it got and what it wants."""

from operator import index
from typing import Any


def check_integer(value: Any, argument: str, low: int, high: int, wants: str | None = None) -> int:
    """`value` as an int, if it is a whole number in [low, high].

    Raises:
        TypeError: not a whole number.
        ValueError: outside the range.
    """
    wants = wants or (f"a whole number of at least {low}" if high >= 2**62 else f"a whole number from {low} to {high}")
    try:
        number = index(value)
    except TypeError:
        raise TypeError(f"{argument}: got {value!r}, want {wants}") from None
    if isinstance(value, bool):
        raise TypeError(f"{argument}: got {value!r}, want {wants}")
    if not low <= number <= high:
        raise ValueError(f"{argument}: got {number}, want {wants}")
    return number


def check_seed(seed: Any) -> int:
    """A seed of 64 bits."""
    return check_integer(seed, "seed", 0, 2**64 - 1, "a whole number of 64 bits, 0 to 2^64 - 1")


def check_first_point(first_point: Any, points: int) -> int:
    """A global point id that leaves room for `points` ids of 64 bits."""
    return check_integer(first_point, "first_point", 0, 2**64 - points, f"an id of 64 bits with room for {points} points")
