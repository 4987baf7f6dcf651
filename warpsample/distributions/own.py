"""Distributions of users' own, from outside of the package: checked, and found by their names like all others."""

from collections.abc import Callable
from dataclasses import dataclass, is_dataclass
from typing import Any

import numpy as np
import warp as wp

from warpsample.distributions.record import Distribution, Maps
from warpsample.host.arguments import told

Twin = tuple[Callable[[Any, np.ndarray], np.ndarray], Callable[[Any, np.ndarray], np.ndarray]]
"""Directions of u, and densities of w, each of (distribution, float64 array)."""

_TEXTS = ("name", "density", "measure", "support", "source")
_MEASURES = ("per steradian", "per unit area", "per radian")


@dataclass(frozen=True)
class UserDistribution:
    """What was user_distributions: the class, and its twin, if there is one."""

    kind: type[Distribution]
    twin: Twin | None = None


user_distributions: dict[str, UserDistribution] = {}
"""By name."""


def is_same_class(one: type, other: type) -> bool:
    """Whether two classes are one, or come of the same lines: a cell of a notebook that is run again makes a new class."""
    return one is other or (one.__module__, one.__qualname__) == (other.__module__, other.__qualname__)


def check_kind(kind: Any) -> type[Distribution]:
    """A class that names, laws and kernels can take; a TypeError or ValueError says what it lacks."""
    if not isinstance(kind, type) or not issubclass(kind, Distribution):
        raise TypeError(f"kind: got {told(kind)}, want a subclass of warpsample.distributions.Distribution")
    title = kind.__name__
    if not is_dataclass(kind) or not kind.__dataclass_params__.frozen:  # type: ignore[attr-defined]
        raise TypeError(f"kind: got {title}, which is no frozen dataclass, want @dataclass(frozen=True) above it")
    for name in _TEXTS:
        if not isinstance(getattr(kind, name, None), str):
            raise TypeError(f"kind: got {title} with {name} = {told(getattr(kind, name, None))}, want a text")
    if not kind.name.isidentifier():
        raise ValueError(f"kind: got {title} with name = {kind.name!r}, want letters, digits and underscores")
    if kind.measure not in _MEASURES:
        raise ValueError(f"kind: got {title} with measure = {kind.measure!r}, want one of {', '.join(_MEASURES)}")
    _check_maps(kind)
    if kind.symmetric and kind._cdf is Distribution._cdf:
        raise TypeError(f"kind: got {title} without _cdf, want the chance of an angle up to theta, or symmetric = False")
    return kind


def _check_maps(kind: type[Distribution]) -> None:
    maps = kind.__dict__.get("maps", getattr(kind, "maps", None))
    if isinstance(maps, property):  # the maps depend on a parameter
        return
    if not isinstance(maps, Maps) or not all(isinstance(func, wp.Function) for func in (maps.sample, maps.pdf)):
        raise TypeError(f"kind: got {kind.__name__} with maps = {told(maps)}, want Maps(sample, pdf, invert) of wp.funcs")
    for func in filter(None, (maps.sample, maps.pdf, maps.invert)):
        after = list(func.input_types)[1:]
        if len(after) != len(kind.parameters):
            raise TypeError(
                f"kind: got {kind.__name__} with parameters = {kind.parameters!r}, while {func.key} takes {after} after its "
                f"first argument, want the names of the fields that the maps take, as parameters = {tuple(after)!r}"
            )


def check_twin(twin: Any) -> Twin | None:
    """Two functions, or None."""
    if twin is None or (isinstance(twin, tuple) and len(twin) == 2 and all(map(callable, twin))):
        return twin
    raise TypeError(f"twin: got {told(twin)}, want two functions in float64, (directions, density)")
