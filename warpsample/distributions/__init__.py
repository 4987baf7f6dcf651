"""From the square to directions: distributions, a file each."""

import sys
from typing import Any

from warpsample.distributions.record import Distribution
from warpsample.registry import look_up, records_of

_KNOWN = records_of(sys.modules[__name__])


def names() -> list[str]:
    """Names of all distributions, sorted."""
    return sorted(_KNOWN)


def get(name: str) -> type[Distribution]:
    """The class of a distribution; calling it with the parameters makes one.

    Raises:
        ValueError: the name is not known; the message lists those that are.
    """
    return look_up(_KNOWN, name, "distribution")


def as_distribution(value: Any) -> Distribution:
    """An instance as it is, a name with its defaults.

    Raises:
        ValueError: an unknown name.
        TypeError: neither a name nor an instance, or a name whose parameters have no defaults.
    """
    if isinstance(value, Distribution):
        return value
    if not isinstance(value, str):
        raise TypeError(f"distribution: got {value!r}, want a name or an instance such as CosineHemisphere()")
    kind = get(value)
    try:
        return kind()
    except TypeError:
        raise TypeError(
            f"distribution: {value!r} has no defaults, want {kind.__name__}({', '.join(kind.parameters)})"
        ) from None
