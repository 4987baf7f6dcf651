"""Menus and sliders in a PyVista window."""

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from warpsample.plotting.style import DOTS, INK, font_file

if TYPE_CHECKING:
    import pyvista

WIDTH = 0.17
"""Width of the panel with menus and sliders, as a share of the window's width."""
ROW = 1.0 / 42.0
"""Height of a row of the panel, as a share of the window's height."""

_LEFT = 0.06  # of the panel
_BUTTON = 0.65  # of a row
_TEXT = 0.02  # of the window's height
_ASPECT = 16.0 / 9.0
_LETTERS = 22  # of the longest text of the panel in the usual size; longer ones are smaller


def fit_texts(plotter: "pyvista.Plotter") -> None:
    """Fit the size of all texts in a window to the size of the window."""
    import pyvista as pv

    width, height = plotter.window_size
    for renderer in plotter.renderers:
        for actor in renderer.actors.values():
            if isinstance(actor, pv.Text):
                share = min(1.0, _LETTERS / max(len(actor.input), 1)) if renderer is plotter.renderers[0] else 1.0
                actor.prop.font_size = int(share * _TEXT * min(height, width / _ASPECT))


class Menu:
    """Menu of a window: a title and radio buttons, with exactly one button on."""

    def __init__(
        self, plotter: "pyvista.Plotter", title: str, entries: list[str], *, top: float, choose: Callable[[str], None]
    ):
        """Create the menu in the current panel of the window.

        Args:
            plotter: plotter with the renderer.
            title: text above the buttons.
            entries: texts of the buttons.
            top: height of the title, as a share of the renderer's height.
            choose: function that is called with the text of a button that was pressed.
        """
        self._plotter = plotter
        self._texts = [_add_text(plotter, title, _LEFT, top, bold=True)]
        self._tops = [top - (i + 1) * ROW for i in range(len(entries))]
        self.buttons = {}
        height = plotter.window_size[1]
        for entry, low in zip(entries, self._tops, strict=True):
            self._texts.append(_add_text(plotter, entry, 3 * _LEFT, low))
            self.buttons[entry] = plotter.add_radio_button_widget(
                lambda entry=entry: choose(entry),
                f"menu {title}",
                size=int(_BUTTON * ROW * height),
                border_size=3,
                color_on=DOTS,
                color_off="#bbbbbb",
                background_color="white",
            )
        self.lay_out()

    def lay_out(self) -> None:
        """Place each button of the menu next to its text, for the current size of the window."""
        width, height = self._plotter.window_size
        side = _BUTTON * ROW * height
        for button, low in zip(self.buttons.values(), self._tops, strict=True):
            x, y = _LEFT * WIDTH * width, low * height
            button.GetRepresentation().PlaceWidget((x, x + side, y, y + side, 0.0, 0.0))

    def set(self, entry: str | None) -> None:
        """Select one entry of the menu: turn its button on and all other buttons off. None hides the menu."""
        for text in self._texts:
            text.SetVisibility(entry is not None)
        for name, button in self.buttons.items():
            _set_visible(button, entry is not None)
            button.GetRepresentation().SetState(int(name == entry))


class Slider:
    """Slider of a window, with its name and value above."""

    def __init__(
        self,
        plotter: "pyvista.Plotter",
        top: float,
        turn: Callable[[float], None],
        *,
        name: Callable[[float], str],
        low: float,
        high: float,
    ):
        """Create the slider in the current panel of the window.

        Args:
            plotter: plotter with the renderer.
            top: height of the text above the slider, as a share of the renderer's height.
            turn: function that is called with each new value.
            name: function from a value to the text above the slider.
            low: smallest value.
            high: largest value.
        """
        self._name, self._ready = name, False
        self.title = _add_text(plotter, "", _LEFT, top)
        self.widget = plotter.add_slider_widget(
            lambda value: self._update(value, turn),
            (low, high),
            value=low,
            pointa=(_LEFT, top - 0.6 * ROW),
            pointb=(1.0 - _LEFT, top - 0.6 * ROW),
            interaction_event="always",
            style="modern",
            color=INK,
            slider_width=0.02,
            tube_width=0.004,
        )
        slider = self.widget.GetRepresentation()
        slider.ShowSliderLabelOff()
        slider.GetSliderProperty().SetColor(*_parse_colour(DOTS))
        self._ready = True

    def _update(self, value: float, turn: Callable[[float], None]) -> None:
        """Show the slider's new value, and call the function `turn` with the value."""
        if self._ready:  # PyVista calls this function once while it makes the slider
            self.title.input = self._name(value)
            turn(value)

    def set(
        self, value: float | None, span: tuple[float, float] | None = None, name: Callable[[float], str] | None = None
    ) -> None:
        """Move the slider to a value without calling its function; None hides the slider.

        `span` and `name` replace its range and its text, where given.
        """
        self.title.SetVisibility(value is not None)
        _set_visible(self.widget, value is not None)
        if value is None:
            return
        slider = self.widget.GetRepresentation()
        if span is not None:
            slider.SetMinimumValue(span[0])
            slider.SetMaximumValue(span[1])
        self._name = name or self._name
        slider.SetValue(value)
        self.title.input = self._name(value)


def _add_text(plotter: "pyvista.Plotter", words: str, x: float, y: float, bold: bool = False) -> Any:
    """Add a text to the panel, at fractions x and y of its width and height, and return the actor."""
    return plotter.add_text(words, position=(x, y), viewport=True, color=INK, font_file=font_file(bold))


def _set_visible(widget: Any, visible: bool) -> None:
    """Show or hide a button or a slider.

    `SetEnabled` is not used, because it would move the widget to the renderer under the mouse.
    """
    widget.GetRepresentation().SetVisibility(visible)
    widget.SetProcessEvents(visible)


def _parse_colour(colour: str) -> tuple[float, ...]:
    """Convert a colour, for example "#2f6690", to red, green and blue from 0 to 1."""
    return tuple(int(colour[i : i + 2], 16) / 255.0 for i in (1, 3, 5))
