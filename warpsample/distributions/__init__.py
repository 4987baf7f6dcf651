"""From the square to directions: distributions, a file each."""

import ast
import sys
from dataclasses import fields
from functools import cache
from typing import Any

from warpsample.distributions.own import Twin, UserDistribution, check_kind, check_twin, is_same_class, user_distributions
from warpsample.distributions.record import Distribution, Maps
from warpsample.host.arguments import told
from warpsample.host.registry import look_up, records_of

__all__ = ["Distribution", "Maps", "as_distribution", "as_spatial", "classes", "get", "names", "register"]


@cache
def _find_package_distributions() -> dict[str, type[Distribution]]:
    """By name. Found when first asked for: reading all files takes as long as half of `import warp`."""
    return records_of(sys.modules[__name__])


def _find_distributions() -> dict[str, type[Distribution]]:
    """Those of the package, and users' own."""
    return _find_package_distributions() | {name: entry.kind for name, entry in user_distributions.items()}


def register(kind: type[Distribution], *, twin: Twin | None = None) -> type[Distribution]:
    """Lets a distribution of your own go by its name, as those of the package, and `warpsample verify --only` judge it.

    An instance is taken wherever a distribution is, user_distributions or not.

    Args:
        kind: a subclass of `ws.distributions.Distribution`, a frozen dataclass of its parameters that has `name`, `density`,
            `support`, `source` and `maps`, and `_cdf` unless it is not `symmetric`.
        twin: (directions, density), a second implementation in float64 NumPy, of (distribution, u (..., 2)) ->
            (..., 3) and (distribution, w (..., 3)) -> (...); the laws need it, nothing else does.

    Returns:
        the class. Where it is user_distributions again, as by a cell of a notebook, the newest counts.

    Raises:
        TypeError: no such class, or something it lacks.
        ValueError: a name or a measure that cannot be, or a name that another distribution has.

    Example:
        >>> print(ws.distributions.register(ws.GGX).name)  # known already; the room's README has one that is new
        ggx
    """
    kind, twin = check_kind(kind), check_twin(twin)
    other = _find_distributions().get(kind.name)
    if other is not None and not is_same_class(kind, other):
        raise ValueError(f"kind: got {kind.__name__} with name = {kind.name!r}, which {other.__name__} has, want another")
    if kind.name not in _find_package_distributions():
        user_distributions[kind.name] = UserDistribution(kind, twin)
    return kind


def names() -> list[str]:
    """Names of all distributions.

    Returns:
        the names, sorted; what `distribution=` takes.

    Example:
        >>> print(ws.distributions.names()[:3])
        ['beckmann', 'cosine_hemisphere', 'ggx']
    """
    return sorted(_find_distributions())


def classes() -> dict[str, type[Distribution]]:
    """All distributions, by the names of their classes.

    Returns:
        class name -> class.

    Example:
        >>> print(ws.distributions.classes()["GGX"].density)
        α²cosθ/(π(sin²θ+α²cos²θ)²)
    """
    return {kind.__name__: kind for kind in _find_distributions().values()}


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
    return look_up(_find_distributions(), name, "distribution")


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
        return kind(**_parse_keywords(inside.removesuffix(")")))
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


def _parse_keywords(text: str) -> dict[str, Any]:
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
