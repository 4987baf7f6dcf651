"""Figure of Keinert's experiment: a red and a green set of directions are added as light; equal directions are yellow."""

from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from matplotlib.figure import Figure

_FINER = 3  # pixels of the overlay to one of the picture
_DOT = 4.0  # radius of a direction's dot, in pixels of the picture
_RED, _GREEN, _YELLOW = "#ff0000", "#00ff00", "#ffff00"
_WIDTH, _HEIGHT = 16.0, 8.6  # inches
_TITLE, _TEXT = 19, 15


def overlay(red: np.ndarray, green: np.ndarray, size: int) -> tuple[np.ndarray, float]:
    """Draw two sets of unit directions, (N, 3), seen along the normal, +z, as red and green light; the sum is yellow.

    Returns:
        picture, (size, size, 3) float in [0, 1] with +y up, and the share of the lit area that is yellow.
    """
    fine = size * _FINER
    lit = np.zeros((fine, fine, 2), bool)
    reach = int(_DOT * _FINER)
    steps = np.mgrid[-reach : reach + 1, -reach : reach + 1].reshape(2, -1)
    steps = steps[:, (steps**2).sum(axis=0) <= (_DOT * _FINER) ** 2]
    radius = 0.5 * fine - reach - 1
    for channel, w in enumerate((red, green)):
        at = np.rint(0.5 * fine + radius * np.array([-w[:, 1], w[:, 0]])).astype(int)  # row, column
        rows, columns = (np.clip(at[k][:, None] + steps[k], 0, fine - 1) for k in (0, 1))
        lit[rows, columns, channel] = True
    share = float(lit.all(axis=2).sum() / max(lit.any(axis=2).sum(), 1))
    smooth = lit.reshape(size, _FINER, size, _FINER, 2).mean(axis=(1, 3))
    return np.concatenate([smooth, np.zeros((size, size, 1))], axis=2), share


def overlay_sheet(panels: list[tuple[str, str, np.ndarray, float]], caption: str) -> "Figure":
    """Draw several overlays of a red and a green set side by side on black, each with an enlarged part.

    Args:
        panels: of each overlay the name of the red set, the name of the green set, the picture, and the yellow share of the
            lit area.
        caption: text below the overlays.
    """
    from matplotlib.figure import Figure

    figure = Figure(figsize=(_WIDTH, _HEIGHT), facecolor="black", dpi=100)
    for k, (red, green, picture, share) in enumerate(panels):
        left = 0.02 + k / len(panels)
        axes = figure.add_axes((left - 0.01, 0.06, 0.37, 0.37 * _WIDTH / _HEIGHT))
        axes.imshow(picture, interpolation="nearest")
        axes.axis("off")
        _draw_enlarged(figure, picture, left + 0.365)
        legend = (
            (f"red: {red}", _RED),
            (f"green: {green}", _GREEN),
            (f"yellow: both, {share:.0%} of the lit area", _YELLOW),
        )
        for line, (words, colour) in enumerate(legend):
            figure.text(left + 0.01, 0.945 - 0.05 * line, words, color=colour, fontsize=_TITLE)
    figure.text(0.03, 0.02, caption, color="white", fontsize=_TEXT)
    return figure


def _draw_enlarged(figure: "Figure", picture: np.ndarray, left: float) -> None:
    """Draw a part of the overlay at twice its size; `left` is a fraction of the figure's width."""
    size = len(picture)
    window = (slice(int(0.60 * size), int(0.76 * size)), slice(int(0.42 * size), int(0.58 * size)))
    axes = figure.add_axes((left, 0.10, 0.11, 0.11 * _WIDTH / _HEIGHT))
    axes.imshow(picture[window], interpolation="nearest")
    axes.set(xticks=[], yticks=[])
    axes.set_title("enlarged", color="white", fontsize=_TEXT)
    for side in axes.spines.values():
        side.set_color("white")
