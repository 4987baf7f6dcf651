"""From the square to directions: distributions, a file each."""

import ast
import sys
from dataclasses import fields
from typing import Any

from warpsample.distributions.record import Distribution
from warpsample.host.arguments import told
from warpsample.host.registry import look_up, records_of

_KNOWN = records_of(sys.modules[__name__])


def names() -> list[str]:
    """Names of all distributions, sorted."""
    return sorted(_KNOWN)


def classes() -> dict[str, type[Distribution]]:
    """All distributions, by the names of their classes."""
    return {kind.__name__: kind for kind in _KNOWN.values()}


def get(name: str) -> type[Distribution]:
    """The class of a distribution; calling it with the parameters makes one.

    Raises:
        ValueError: the name is not known; the message lists those that are.
    """
    return look_up(_KNOWN, name, "distribution")


def as_distribution(value: Any) -> Distribution:
    """A distribution from an instance, a name, or a name with parameters such as "beckmann(alpha=0.1)".

    Raises:
        ValueError: an unknown name, or a value that the distribution refuses.
        TypeError: neither a string nor an instance, or parameters that are missing, unknown or no literals.
    """
    if isinstance(value, Distribution):
        return value
    if not isinstance(value, str):
        raise TypeError(f"distribution: got {told(value)}, want a name or an instance such as CosineHemisphere()")
    name, _, inside = value.partition("(")
    kind = get(name.strip())
    try:
        return kind(**_keywords(inside.removesuffix(")")))
    except (TypeError, SyntaxError) as error:
        example = f"{name}({', '.join(f'{field.name}=...' for field in fields(kind))})"
        reason = "" if "__init__()" in str(error) or isinstance(error, SyntaxError) else f" ({error})"
        raise TypeError(f"distribution: got {told(value)}, want {example}{reason}") from None


def as_spatial(value: Any) -> Distribution:
    """Like `as_distribution`, for directions in space.

    Raises:
        TypeError: a distribution in a plane.
    """
    distribution = as_distribution(value)
    if distribution.width != 3:
        raise TypeError(f"distribution: got {distribution!r}, which lies in a plane, want one of directions in space")
    return distribution


def _keywords(text: str) -> dict[str, Any]:
    try:
        call = ast.parse(f"_({text})", mode="eval").body
    except (ValueError, RecursionError, MemoryError) as error:  # zero bytes, or more nested brackets than the parser allows
        raise SyntaxError from error
    if not isinstance(call, ast.Call) or call.args or any(keyword.arg is None for keyword in call.keywords):
        raise TypeError("parameters go by name")
    try:
        return {str(keyword.arg): ast.literal_eval(keyword.value) for keyword in call.keywords}
    except ValueError:
        raise TypeError("parameters are plain numbers, strings or tuples") from None
