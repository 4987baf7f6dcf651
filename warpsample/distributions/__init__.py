"""Distributions that map points of the unit square to directions; each is defined in a file of its own."""

import ast
import re
import sys
from collections.abc import Callable
from dataclasses import MISSING, fields
from functools import cache
from typing import Any, TypeAlias

import numpy as np

from warpsample.distributions import lights, microfacets, scattering
from warpsample.distributions.own import Twin, UserDistribution, check_kind, check_twin, is_same_class, user_distributions
from warpsample.distributions.record import Distribution, Maps
from warpsample.host.arguments import quote
from warpsample.host.registry import look_up, records_of

__all__ = ["Distribution", "Maps", "as_distribution", "as_spatial", "classes", "get", "names", "register"]


Arrays: TypeAlias = Callable[[str], np.ndarray]
"""Function that returns the array of a name, with one row for each point."""

_ARRAY = re.compile(r"(?<!')@([\w.-]+)")


@cache
def _find_package_distributions() -> dict[str, type[Distribution]]:
    """Import and return the distributions of the package, name -> class; the import takes half as long as `import warp`."""
    rooms = (sys.modules[__name__], lights, microfacets, scattering)
    return {name: record for room in rooms for name, record in records_of(room).items()}


def _find_distributions() -> dict[str, type[Distribution]]:
    """Return all distributions, of the package and of users: name -> class."""
    return _find_package_distributions() | {name: entry.kind for name, entry in user_distributions.items()}


def register(kind: type[Distribution], *, twin: Twin | None = None) -> type[Distribution]:
    """Register a user-defined distribution, so that calls accept its name and `warpsample verify --only` can test it.

    Calls accept an instance of any distribution, also of one that is not registered.

    Args:
        kind: a subclass of `ws.distributions.Distribution`: a frozen dataclass of its parameters with the attributes `name`,
            `density`, `support`, `source` and `maps`, and with `_cdf` unless `symmetric` is False.
        twin: (directions, density), a second implementation in float64 NumPy that only `warpsample verify` uses. The first
            function maps (distribution, u (..., 2)) to directions (..., 3), the second (distribution, w (..., 3)) to
            densities (...).

    Returns:
        the class. A class that is registered again, as when a cell of a notebook runs twice, replaces the older one.

    Raises:
        TypeError: `kind` is not a subclass of Distribution, or an attribute is missing or has a wrong type.
        ValueError: the name or the measure is invalid, or another distribution has the name.

    Example:
        >>> print(ws.distributions.register(ws.GGX).name)  # GGX is registered already; the README has a new distribution
        ggx
    """
    kind, twin = check_kind(kind), check_twin(twin)
    other = _find_distributions().get(kind.name)
    if other is not None and not is_same_class(kind, other):
        raise ValueError(
            f"kind: got {kind.__name__} with name = {kind.name!r}, the name of {other.__name__}, want another name"
        )
    if kind.name not in _find_package_distributions():
        user_distributions[kind.name] = UserDistribution(kind, twin)
    return kind


def names() -> list[str]:
    """Return the names of all distributions.

    Returns:
        the names, sorted; each is a value for the argument `distribution`.

    Example:
        >>> print(ws.distributions.names()[:3])
        ['beckmann', 'cosine_hemisphere', 'environment_map']
    """
    return sorted(_find_distributions())


def classes() -> dict[str, type[Distribution]]:
    """Return all distributions, keyed by the names of the classes.

    Returns:
        class name -> class.

    Example:
        >>> print(ws.distributions.classes()["GGX"].density)
        cosθ/(πα_xα_y(x²/α_x²+y²/α_y²+cos²θ)²)
    """
    return {kind.__name__: kind for kind in _find_distributions().values()}


def get(name: str) -> type[Distribution]:
    """Return the class of a distribution; call the class with parameters to create an instance.

    Args:
        name: one of `names()`.

    Returns:
        the class, not an instance.

    Raises:
        TypeError: the name is not a string.
        ValueError: the name is unknown; the message lists the known names.

    Example:
        >>> kind = ws.distributions.get("beckmann")
        >>> print(kind(alpha=0.1), kind.measure)
        Beckmann(alpha=0.1) per steradian
    """
    return look_up(_find_distributions(), name, "distribution")


def as_distribution(value: Any, arrays: Arrays | None = None) -> Distribution:
    """Convert a value of the argument `distribution`, such as the text "beckmann(alpha=0.1)", to an instance.

    Args:
        value: an instance, which is returned unchanged; a name, for the default parameters; or a name with parameters, such
            as "beckmann(alpha=0.1)". "beckmann(alpha=@roughness)" takes the parameter from an array with one row for each
            point. A parameter may be a distribution, such as "reflection(visible_ggx(alpha=0.3), view=(0, 0, 1))".
        arrays: function that returns the array of a name. Default: None, a name with @ is an error.

    Returns:
        an instance.

    Raises:
        ValueError: the name is unknown, or a parameter is outside its range.
        TypeError: the value is neither a string nor an instance, or parameters are missing, unknown or not literals.

    Example:
        >>> print(ws.distributions.as_distribution("offset_disk"))
        OffsetDisk()
        >>> print(ws.distributions.as_distribution("beckmann(alpha=0.1)"))
        Beckmann(alpha=0.1)
    """
    if arrays is not None and not callable(arrays):
        raise TypeError(f"arrays: got {quote(arrays)}, want a function (name) -> array, or None")
    if isinstance(value, Distribution):
        return value
    if not isinstance(value, str):
        raise TypeError(f"distribution: got {quote(value)}, want a name or an instance such as CosineHemisphere()")
    name, opened, inside = value.rstrip().partition("(")
    kind = get(name.strip())
    try:
        if opened and not inside.endswith(")"):
            raise SyntaxError
        return kind(**_parse_keywords(kind, inside.removesuffix(")"), arrays))
    except (TypeError, SyntaxError) as error:
        required = [field for field in fields(kind) if field.default is MISSING] or fields(kind)
        example = f"{name}({', '.join(f'{field.name}=...' for field in required)})"
        reason = "" if "__init__()" in str(error) or isinstance(error, SyntaxError) else f" ({error})"
        raise TypeError(f"distribution: got {quote(value)}, want {example}{reason}") from None


def as_spatial(value: Any, arrays: Arrays | None = None) -> Distribution:
    """Convert a value of the argument `distribution` to an instance, and refuse distributions in the plane.

    Args:
        value: an instance, a name, or a name with parameters.
        arrays: function that returns the array of a name; see `as_distribution`.

    Returns:
        an instance whose directions have three components.

    Raises:
        ValueError: the name is unknown, or a parameter is outside its range.
        TypeError: the value is neither a string nor an instance, parameters are wrong, or the distribution is planar.

    Example:
        >>> print(ws.distributions.as_spatial("ggx(alpha=0.5)").width)
        3
    """
    distribution = as_distribution(value, arrays)
    if distribution.width != 3:
        raise TypeError(f"distribution: got {distribution!r}, which is planar, want a distribution of directions in space")
    return distribution


def _parse_keywords(kind: type[Distribution], text: str, arrays: Arrays | None) -> dict[str, Any]:
    """Parse the text between the parentheses of a call, such as "alpha=0.1", to keyword arguments of a class.

    Distributions may come first without a name, in the order of the fields.
    """
    quoted = _ARRAY.sub(r"'@\1'", text)
    try:
        call = ast.parse(f"_({quoted})", mode="eval").body
    except (ValueError, RecursionError, MemoryError) as error:  # zero bytes, or more nested brackets than the parser allows
        raise SyntaxError from error
    nameless = not isinstance(call, ast.Call) or any(not isinstance(argument, ast.Call) for argument in call.args)
    if nameless or any(keyword.arg is None for keyword in call.keywords):
        raise TypeError("give parameters by name")
    first = {field.name: argument for field, argument in zip(fields(kind), call.args, strict=False)}
    given = first | {str(keyword.arg): keyword.value for keyword in call.keywords}
    if len(given) < len(call.args) + len(call.keywords):
        raise TypeError("give each parameter once")
    return {name: _parse_value(node, arrays) for name, node in given.items()}


def _parse_value(node: ast.expr, arrays: Arrays | None) -> Any:
    """Evaluate the text of a parameter: a number, string or tuple, an array named like "@roughness", or a lobe."""
    if isinstance(node, ast.Call):
        return as_distribution(ast.unparse(node), arrays)
    if isinstance(node, ast.List | ast.Tuple) and any(isinstance(item, ast.Call) for item in node.elts):
        return tuple(_parse_value(item, arrays) for item in node.elts)
    try:
        value = ast.literal_eval(node)
    except ValueError:
        raise TypeError("parameters must be plain numbers, strings or tuples") from None
    return _find_array(value, arrays)  # whose errors name the array


def _find_array(value: Any, arrays: Arrays | None) -> Any:
    """Look up the array that a value such as "@roughness" names; return any other value unchanged."""
    if not isinstance(value, str) or not _ARRAY.fullmatch(value):
        return value
    if arrays is None:
        raise TypeError(f"{value} names an array, which this call does not have; make an instance with the array instead")
    return arrays(value.removeprefix("@"))
