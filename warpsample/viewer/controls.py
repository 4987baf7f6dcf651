"""The knobs: menus and sliders, as PyVista widgets, that turn one choice into another."""

from collections.abc import Callable
from dataclasses import replace
from math import atan2, cos, degrees, exp, log, log2, radians, sin
from typing import TYPE_CHECKING, Any, get_args

from warpsample import distributions, sequences
from warpsample.distributions.cosine_hemisphere import CosineHemisphere, Method
from warpsample.distributions.record import Distribution
from warpsample.plotting.rendering import DOTS, INK
from warpsample.viewer.lobes import Choice

if TYPE_CHECKING:
    import pyvista

WIDTH = 0.17
"""Of the panel, as a share of the window."""
MOST_SAMPLES, MOST_SEED = 4096, 99
OWN, COSINE = "their own density", "the cosine lobe"

_ROW = 1.0 / 42.0  # of the window's height
_LEFT = 0.06  # of the panel
_BUTTON = 0.65  # of a row


def spatial() -> list[str]:
    """Names of the distributions that a mesh can show."""
    return [name for name in distributions.names() if distributions.get(name).width == 3]


def made(name: str) -> Distribution:
    """The distribution of that name, in the middle of what its slider spans."""
    kind = distributions.get(name)
    low, high = kind.shown or (1.0, 1.0)
    found = kind(**{kind.parameters[0]: (low * high) ** 0.5}) if kind.shown else kind()
    return tilted(found, 45.0) if "view" in kind.parameters else found


def tilted(distribution: Distribution, angle: float) -> Distribution:
    """With its view so many degrees from the normal."""
    return replace(distribution, view=(sin(radians(angle)), 0.0, cos(radians(angle))))


def with_scalar(distribution: Distribution, value: float) -> Distribution:
    """With another value of its scalar."""
    kind = type(distribution)
    kept = {name: getattr(distribution, name) for name in kind.parameters[1:]}
    return kind(**{kind.parameters[0]: value}, **kept)


class Menu:
    """A title and radio buttons, one of which is on."""

    def __init__(
        self, plotter: "pyvista.Plotter", title: str, entries: list[str], top: float, choose: Callable[[str], None]
    ):
        """`top`: of the title, as a share of the window's height."""
        self._plotter = plotter
        self._texts = [_text(plotter, title, _LEFT, top, bold=True)]
        self._tops = [top - (i + 1) * _ROW for i in range(len(entries))]
        self.buttons = {}
        height = plotter.window_size[1]
        for entry, low in zip(entries, self._tops, strict=True):
            self._texts.append(_text(plotter, entry, 3 * _LEFT, low))
            self.buttons[entry] = plotter.add_radio_button_widget(
                lambda entry=entry: choose(entry),
                f"menu {title}",
                size=int(_BUTTON * _ROW * height),
                border_size=3,
                color_on=DOTS,
                color_off="#bbbbbb",
                background_color="white",
            )
        self.place()

    def place(self) -> None:
        """Puts the buttons beside their texts, whatever size the window has."""
        width, height = self._plotter.window_size
        side = _BUTTON * _ROW * height
        for button, low in zip(self.buttons.values(), self._tops, strict=True):
            x, y = _LEFT * WIDTH * width, low * height
            button.GetRepresentation().PlaceWidget((x, x + side, y, y + side, 0.0, 0.0))

    def set(self, entry: str | None) -> None:
        """Turns one button on, and the others off; None hides the menu."""
        for text in self._texts:
            text.SetVisibility(entry is not None)
        for name, button in self.buttons.items():
            _reveal(button, entry is not None)
            button.GetRepresentation().SetState(int(name == entry))


class Knob:
    """A slider that says its name and value."""

    def __init__(
        self,
        plotter: "pyvista.Plotter",
        top: float,
        turn: Callable[[float], None],
        says: Callable[[float], str],
        low: float,
        high: float,
    ):
        """From `low` to `high`; `turn` gets the slider's value, `says` makes the text of it."""
        self._says, self._ready = says, False
        self._title = _text(plotter, "", _LEFT, top)
        self.widget = plotter.add_slider_widget(
            lambda value: self._turned(value, turn),
            (low, high),
            value=low,
            pointa=(_LEFT, top - 0.6 * _ROW),
            pointb=(1.0 - _LEFT, top - 0.6 * _ROW),
            interaction_event="always",
            style="modern",
            color=INK,
            slider_width=0.02,
            tube_width=0.004,
        )
        slider = self.widget.GetRepresentation()
        slider.ShowSliderLabelOff()
        slider.GetSliderProperty().SetColor(*_rgb(DOTS))
        self._ready = True

    def _turned(self, value: float, turn: Callable[[float], None]) -> None:
        if self._ready:  # PyVista calls once while it makes the slider
            self._title.input = self._says(value)
            turn(value)

    def set(
        self, value: float | None, span: tuple[float, float] | None = None, says: Callable[[float], str] | None = None
    ) -> None:
        """Moves the slider without turning anything; None hides it."""
        self._title.SetVisibility(value is not None)
        _reveal(self.widget, value is not None)
        if value is None:
            return
        slider = self.widget.GetRepresentation()
        if span is not None:
            slider.SetMinimumValue(span[0])
            slider.SetMaximumValue(span[1])
        self._says = says or self._says
        slider.SetValue(value)
        self._title.input = self._says(value)


class Controls:
    """All knobs, which agree with the choice and call back with another."""

    def __init__(self, plotter: "pyvista.Plotter", choice: Choice, changed: Callable[[Choice], None]):
        """Into the plotter's current renderer, at the left of the window."""
        self.choice, self._changed = choice, changed
        top, self.menus = 1.0 - 1.5 * _ROW, {}
        for name, title, entries in (
            ("distribution", "directions of", spatial()),
            ("method", "by the method", list(get_args(Method))),
            ("density", "held against", [OWN, COSINE]),
            ("sequence", "points of the square", sequences.names()),
        ):
            self.menus[name] = Menu(plotter, title, entries, top, getattr(self, f"_choose_{name}"))
            top -= (len(entries) + 1.5) * _ROW
        self.knobs = {}
        for name, low, high, says in (
            ("scalar", 0.0, 1.0, str),
            ("view", 0.0, 89.0, lambda v: f"view, {v:.0f}° from n"),
            ("samples", 0.0, log2(MOST_SAMPLES), lambda v: f"{round(2**v):,} directions a point"),
            ("seed", 0.0, float(MOST_SEED), lambda v: f"seed {round(v)}"),
        ):
            self.knobs[name] = Knob(plotter, top, getattr(self, f"_turn_{name}"), says, low, high)
            top -= 2.0 * _ROW
        self.show(choice)

    def show(self, choice: Choice) -> None:
        """Sets every knob to what the choice says."""
        self.choice, distribution = choice, choice.distribution
        kind = type(distribution)
        self.menus["distribution"].set(kind.name)
        self.menus["method"].set(distribution.method if isinstance(distribution, CosineHemisphere) else None)
        cosine = COSINE if isinstance(choice.density, CosineHemisphere) else ""  # neither, for one of the command line's
        self.menus["density"].set(OWN if choice.density is None else cosine)
        self.menus["sequence"].set(choice.sequence)
        if kind.shown:
            name, value = kind.parameters[0], getattr(distribution, kind.parameters[0])
            span = tuple(log(end) for end in kind.shown)
            self.knobs["scalar"].set(log(max(value, 1e-30)), span, lambda v: f"{name} = {exp(v):.3g}")
        else:
            self.knobs["scalar"].set(None)
        view = getattr(distribution, "view", None)
        self.knobs["view"].set(None if view is None else degrees(atan2((view[0] ** 2 + view[1] ** 2) ** 0.5, view[2])))
        self.knobs["samples"].set(log2(choice.samples))
        self.knobs["seed"].set(float(choice.seed))

    def place(self, *_: Any) -> None:
        """After the window has another size."""
        for menu in self.menus.values():
            menu.place()

    def _change(self, **what: Any) -> None:
        self.choice = replace(self.choice, **what)
        self._changed(self.choice)

    def _choose_distribution(self, name: str) -> None:
        self.show(replace(self.choice, distribution=made(name), density=None))
        self._changed(self.choice)

    def _choose_method(self, name: str) -> None:
        self._change(distribution=CosineHemisphere(name))

    def _choose_density(self, name: str) -> None:
        self._change(density=CosineHemisphere() if name == COSINE else None)

    def _choose_sequence(self, name: str) -> None:
        self._change(sequence=name)

    def _turn_scalar(self, value: float) -> None:
        low, high = type(self.choice.distribution).shown
        self._change(distribution=with_scalar(self.choice.distribution, min(max(exp(value), low), high)))

    def _turn_view(self, value: float) -> None:
        self._change(distribution=tilted(self.choice.distribution, value))

    def _turn_samples(self, value: float) -> None:
        self._change(samples=round(2**value))

    def _turn_seed(self, value: float) -> None:
        self._change(seed=round(value))


def _text(plotter: "pyvista.Plotter", words: str, x: float, y: float, bold: bool = False) -> Any:
    """At a share of the panel, sized for 900 rows of pixels."""
    text = plotter.add_text(words, position=(x, y), viewport=True, color=INK, font_size=9)
    text.prop.bold = bold
    return text


def _reveal(widget: Any, visible: bool) -> None:
    """Not by SetEnabled, which would put it into whatever renderer the mouse is in."""
    widget.GetRepresentation().SetVisibility(visible)
    widget.SetProcessEvents(visible)


def _rgb(colour: str) -> tuple[float, ...]:
    return tuple(int(colour[i : i + 2], 16) / 255.0 for i in (1, 3, 5))
