"""Menus and sliders that change the settings of the viewer."""

from collections.abc import Callable
from dataclasses import MISSING, fields, replace
from math import exp, log, log2
from typing import TYPE_CHECKING, Any, get_args

import numpy as np

from warpsample import distributions, sequences
from warpsample.distributions.cosine_hemisphere import CosineHemisphere, Method
from warpsample.distributions.microfacets.visible_ggx import VisibleGGX
from warpsample.distributions.record import Distribution
from warpsample.distributions.scattering.base import ScatteredLight
from warpsample.viewer.choice import COSINE, OWN, Choice, default_density
from warpsample.viewer.widgets import ROW, Menu, Slider, fit_texts

if TYPE_CHECKING:
    import pyvista

NORMALS = VisibleGGX(0.3)
"""Lobe of normals for the menu's distributions of scattered light."""

_CLAIMS = {OWN: None, COSINE: CosineHemisphere()}
_MOST_SAMPLES, _MOST_SEED = 4096, 99


def spatial_names() -> list[str]:
    """Return the names of the distributions of 3-D directions that can be drawn on a mesh with default parameters."""
    return [name for name in distributions.names() if _has_defaults(distributions.get(name))]


def _has_defaults(kind: type[Distribution]) -> bool:
    """Return whether `make_distribution` can build a distribution of a class: one about the normal, without an array."""
    required = {item.name for item in fields(kind) if item.default is MISSING}
    from_slider = set(kind.parameters[:1]) if kind.shown else set()
    return kind.width == 3 and not kind.in_world and (issubclass(kind, ScatteredLight) or required <= from_slider)


def make_distribution(name: str) -> Distribution:
    """Build the distribution that a menu entry names, with its first parameter in the middle of the slider's range.

    The middle is the geometric mean of the ends. Scattered light has the normals `NORMALS`.
    """
    kind = distributions.get(name)
    if issubclass(kind, ScatteredLight):
        return kind(NORMALS, NORMALS.view)
    low, high = kind.shown or (1.0, 1.0)
    return kind(**{kind.parameters[0]: (low * high) ** 0.5}) if kind.shown else kind()


def with_scalar(distribution: Distribution, value: float) -> Distribution:
    """Copy a distribution, with another value of its first parameter."""
    kind = type(distribution)
    others = {name: getattr(distribution, name) for name in kind.parameters[1:]}
    return kind(**{kind.parameters[0]: value}, **others)


class Controls:
    """Menus and sliders of the viewer; each change calls a function with the new settings."""

    def __init__(self, plotter: "pyvista.Plotter", choice: Choice, changed: Callable[[Choice], None]):
        """Create the menus and sliders in the left panel of the window."""
        self.choice, self._changed, self._plotter = choice, changed, plotter
        top, self.menus = 1.0 - 1.5 * ROW, {}
        for name, title, entries, choose in (
            ("distribution", "Distribution", spatial_names(), self._choose_distribution),
            ("method", "Method", list(get_args(Method)), lambda to: self._change(distribution=CosineHemisphere(to))),
            ("density", "Compared with", [OWN, COSINE], lambda to: self._change(density=_CLAIMS[to])),
            ("sequence", "Point sequence", sequences.names(), lambda to: self._change(sequence=to)),
        ):
            self.menus[name] = Menu(plotter, title, entries, top=top, choose=choose)
            top -= (len(entries) + 1.5) * ROW
        self.sliders = {}
        for name, high, words, change in (
            ("scalar", 1.0, str, self._set_scalar),
            ("samples", log2(_MOST_SAMPLES), lambda v: f"{round(2**v):,} directions per point", self._set_samples),
            ("seed", float(_MOST_SEED), "seed: {:.0f}".format, lambda to: self._change(seed=round(to))),
        ):
            self.sliders[name] = Slider(plotter, top, change, name=words, low=0.0, high=high)
            top -= 2.0 * ROW
        self.show(choice)

    def show(self, choice: Choice) -> None:
        """Set every menu and slider of the viewer to the given settings."""
        self.choice, distribution = choice, choice.distribution
        kind = type(distribution)
        self.menus["distribution"].set(kind.name)
        self.menus["method"].set(distribution.method if isinstance(distribution, CosineHemisphere) else None)
        cosine = COSINE if isinstance(choice.density, CosineHemisphere) else ""  # neither, for one of the command line's
        self.menus["density"].set(OWN if choice.density is None else cosine)
        self.menus["sequence"].set(choice.sequence)
        value = getattr(distribution, kind.parameters[0]) if kind.shown else None
        if kind.shown and not isinstance(value, np.ndarray):  # no slider sets a parameter of each point
            name = kind.parameters[0]
            span = tuple(log(end) for end in kind.shown)
            self.sliders["scalar"].set(log(max(value, 1e-30)), span, lambda v: f"{name} = {exp(v):.3g}")
        else:
            self.sliders["scalar"].set(None)
        self.sliders["samples"].set(log2(choice.samples))
        self.sliders["seed"].set(float(choice.seed))

    def lay_out(self, *_: Any) -> None:
        """Fit the texts and buttons of all menus to the size of the window."""
        fit_texts(self._plotter)
        for menu in self.menus.values():
            menu.lay_out()

    def _change(self, **what: Any) -> None:
        self.choice = replace(self.choice, **what)
        self._changed(self.choice)

    def _choose_distribution(self, name: str) -> None:
        distribution = make_distribution(name)
        self.show(replace(self.choice, distribution=distribution, density=default_density(distribution), camera=True))
        self._changed(self.choice)

    def _set_scalar(self, value: float) -> None:
        low, high = type(self.choice.distribution).shown
        self._change(distribution=with_scalar(self.choice.distribution, min(max(exp(value), low), high)))

    def _set_samples(self, value: float) -> None:
        self._change(samples=round(2**value))
