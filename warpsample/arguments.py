"""Checks of arguments, each with an error that names the argument, what it got and what it wants."""

from math import hypot, inf
from numbers import Real
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


def check_number(value: Any, argument: str, low: float, high: float) -> float:
    """`value` as a float, if it is a number in [low, high].

    Raises:
        TypeError: not a real number.
        ValueError: outside the range, or NaN.
    """
    wants = f"a number from {low:g} to {high:g}"
    if not isinstance(value, Real) or isinstance(value, bool):
        raise TypeError(f"{argument}: got {value!r}, want {wants}")
    if not low <= value <= high:
        raise ValueError(f"{argument}: got {value!r}, want {wants}")
    return float(value)


def check_view(value: Any, argument: str) -> tuple[float, float, float]:
    """`value` as a unit vector, if it is a direction at or above the surface.

    Raises:
        TypeError, ValueError: not three finite numbers, the zero vector, or below.
    """
    wants = "three finite numbers, not all 0, the last at least 0"
    try:
        x, y, z = (float(v) for v in value)
    except (TypeError, ValueError):
        raise TypeError(f"{argument}: got {value!r}, want {wants}") from None
    length = hypot(x, y, z)
    if not (0.0 < length < inf and z >= 0.0):
        raise ValueError(f"{argument}: got {value!r}, want {wants}")
    return x / length, y / length, z / length


def check_seed(seed: Any) -> int:
    """A seed of 64 bits."""
    return check_integer(seed, "seed", 0, 2**64 - 1, "a whole number of 64 bits, 0 to 2^64 - 1")


def check_first_point(first_point: Any, points: int) -> int:
    """A global point id that leaves room for `points` ids of 64 bits."""
    return check_integer(first_point, "first_point", 0, 2**64 - points, f"an id of 64 bits with room for {points} points")
