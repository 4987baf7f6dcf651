"""From the square to directions: distributions, a file each."""

import ast
import sys
from dataclasses import fields
from functools import cache
from typing import Any

from warpsample.distributions.record import Distribution
from warpsample.host.arguments import told
from warpsample.host.registry import look_up, records_of


@cache
def _known() -> dict[str, type[Distribution]]:
    """By name. Found when first asked for: reading all files takes as long as half of `import warp`."""
    return records_of(sys.modules[__name__])


def names() -> list[str]:
    """Names of all distributions.

    Returns:
        the names, sorted; what `distribution=` takes.

    Example:
        >>> print(ws.distributions.names()[:3])
        ['beckmann', 'cosine_hemisphere', 'ggx']
    """
    return sorted(_known())


def classes() -> dict[str, type[Distribution]]:
    """All distributions, by the names of their classes.

    Returns:
        class name -> class.

    Example:
        >>> print(ws.distributions.classes()["GGX"].density)
        α²cosθ/(π(sin²θ+α²cos²θ)²)
    """
    return {kind.__name__: kind for kind in _known().values()}


def get(name: str) -> type[Distribution]:
    """The class of a distribution; calling it with the parameters makes one.

    Args:
        name: one of `names()`.

    Returns:
        the class, not an instance.

    Raises:
        TypeError: not a string.
        ValueError: the name is not known; the message lists those that are.

    Example:
        >>> kind = ws.distributions.get("beckmann")
        >>> print(kind(alpha=0.1), kind.measure)
        Beckmann(alpha=0.1) per steradian
    """
    return look_up(_known(), name, "distribution")


def as_distribution(value: Any) -> Distribution:
    """The distribution that an argument of that name stands for.

    Args:
        value: an instance as it is; a name with its defaults; or a name with parameters, as "beckmann(alpha=0.1)".

    Returns:
        an instance.

    Raises:
        ValueError: an unknown name, or a value that the distribution refuses.
        TypeError: neither a string nor an instance, or parameters that are missing, unknown or not literals.

    Example:
        >>> print(ws.distributions.as_distribution("offset_disk"))
        OffsetDisk()
        >>> print(ws.distributions.as_distribution("beckmann(alpha=0.1)"))
        Beckmann(alpha=0.1)
    """
    if isinstance(value, Distribution):
        return value
    if not isinstance(value, str):
        raise TypeError(f"distribution: got {told(value)}, want a name or an instance such as CosineHemisphere()")
    name, opened, inside = value.rstrip().partition("(")
    kind = get(name.strip())
    try:
        if opened and not inside.endswith(")"):
            raise SyntaxError
        return kind(**_keywords(inside.removesuffix(")")))
    except (TypeError, SyntaxError) as error:
        example = f"{name}({', '.join(f'{field.name}=...' for field in fields(kind))})"
        reason = "" if "__init__()" in str(error) or isinstance(error, SyntaxError) else f" ({error})"
        raise TypeError(f"distribution: got {told(value)}, want {example}{reason}") from None


def as_spatial(value: Any) -> Distribution:
    """Like `as_distribution`, for directions in space.

    Args:
        value: an instance, a name, or a name with parameters.

    Returns:
        an instance whose directions have three components.

    Raises:
        ValueError: an unknown name, or a value that the distribution refuses.
        TypeError: neither a string nor an instance, wrong parameters, or a distribution that lies in a plane.

    Example:
        >>> print(ws.distributions.as_spatial("ggx(alpha=0.5)").width)
        3
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
