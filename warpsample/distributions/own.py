"""Registry of user-defined distributions, with the checks that a class must pass to be registered."""

from collections.abc import Callable
from dataclasses import dataclass, is_dataclass
from typing import Any

import numpy as np
import warp as wp

from warpsample.distributions.record import Distribution, Maps
from warpsample.host.arguments import quote

Twin = tuple[Callable[[Any, np.ndarray], np.ndarray], Callable[[Any, np.ndarray], np.ndarray]]
"""Pair of functions of (distribution, float64 array): directions of points u, and densities of directions w."""

_TEXTS = ("name", "density", "measure", "support", "source")
_MEASURES = ("per steradian", "per unit area", "per radian")


@dataclass(frozen=True)
class UserDistribution:
    """User-defined distribution that is registered under its name.

    Attributes:
        kind: the class.
        twin: a second implementation in float64, for `warpsample verify`; None if the user gave none.
    """

    kind: type[Distribution]
    twin: Twin | None = None


user_distributions: dict[str, UserDistribution] = {}
"""Registered user-defined distributions, keyed by name."""


def is_same_class(one: type, other: type) -> bool:
    """Return whether two classes have the same name and module, as after a notebook cell has run twice."""
    return one is other or (one.__module__, one.__qualname__) == (other.__module__, other.__qualname__)


def check_kind(kind: Any) -> type[Distribution]:
    """Check that a class defines a complete distribution and return the class; raise TypeError or ValueError otherwise."""
    if not isinstance(kind, type) or not issubclass(kind, Distribution):
        raise TypeError(f"kind: got {quote(kind)}, want a subclass of warpsample.distributions.Distribution")
    title = kind.__name__
    if not is_dataclass(kind) or not kind.__dataclass_params__.frozen:  # type: ignore[attr-defined]
        raise TypeError(f"kind: got {title}, which is not a frozen dataclass, want @dataclass(frozen=True) above the class")
    for name in _TEXTS:
        if not isinstance(getattr(kind, name, None), str):
            raise TypeError(f"kind: got {title} with {name} = {quote(getattr(kind, name, None))}, want a string")
    if not kind.name.isidentifier():
        raise ValueError(f"kind: got {title} with name = {kind.name!r}, want a name of letters, digits and underscores")
    if kind.measure not in _MEASURES:
        raise ValueError(f"kind: got {title} with measure = {kind.measure!r}, want one of {', '.join(_MEASURES)}")
    _check_maps(kind)
    if kind.symmetric and kind._cdf is Distribution._cdf:
        raise TypeError(f"kind: got {title} without _cdf, want a method _cdf(theta), or symmetric = False")
    return kind


def _check_maps(kind: type[Distribution]) -> None:
    """Check that `maps` holds wp.funcs whose arguments after the first are the parameters of the distribution."""
    maps = kind.__dict__.get("maps", getattr(kind, "maps", None))
    if isinstance(maps, property):  # the maps depend on a parameter and cannot be checked here
        return
    if not isinstance(maps, Maps) or not all(isinstance(func, wp.Function) for func in (maps.sample, maps.pdf)):
        raise TypeError(f"kind: got {kind.__name__} with maps = {quote(maps)}, want Maps(sample, pdf, invert) of wp.funcs")
    for func in filter(None, (maps.sample, maps.pdf, maps.invert)):
        after = list(func.input_types)[1:]
        if len(after) != len(kind.parameters):
            raise TypeError(
                f"kind: got {kind.__name__} with parameters = {kind.parameters!r}, while {func.key} takes {after} after its "
                f"first argument, want the names of these arguments, as in parameters = {tuple(after)!r}"
            )


def check_twin(twin: Any) -> Twin | None:
    """Check that a twin is a pair of functions or None, and return the twin."""
    if twin is None or (isinstance(twin, tuple) and len(twin) == 2 and all(map(callable, twin))):
        return twin
    raise TypeError(f"twin: got {quote(twin)}, want None or a pair (directions, density) of functions in float64 NumPy")
