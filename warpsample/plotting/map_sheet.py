"""Figure of maps side by side, each with a colour bar, a scale bar and an arrow to the north."""

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from warpsample.plotting.style import INK, SKY

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

_WIDTH, _HEIGHT = 18.0, 7.6  # inches, for which the text is sized
_TITLE, _TEXT = 17, 14
_FROM_EDGE = 0.035  # of the map's longer side


@dataclass(frozen=True, eq=False)
class Map:
    """Map of numbers seen from above, with its title, colours and scale.

    Attributes:
        value: (R, C) numbers; NaN shows the background.
        steps: (2, 2) steps in metres, to the right and up, to the next cell in a row, and to the next one in a column.
        title: text above the map.
        label: text below the colour bar: quantity and unit.
        colours: name of a colour map.
        span: numbers with the first and with the last colour. Lower numbers have the first colour; no number is higher.
        north: (2,) direction of true north, to the right and up.
    """

    value: np.ndarray
    steps: np.ndarray
    title: str
    label: str
    colours: str
    span: tuple[float, float]
    north: tuple[float, float] = (0.0, 1.0)

    @property
    def corners(self) -> np.ndarray:
        """(4, 2) corners of the map in metres, to the right and up from its lowest and leftmost places."""
        rows, columns = self.value.shape
        corners = np.array([(0, 0), (columns, 0), (0, rows), (columns, rows)]) @ self.steps
        return corners - corners.min(axis=0)

    @property
    def size(self) -> np.ndarray:
        """(2,) width and height of the map in metres."""
        return self.corners.max(axis=0)


def square_steps(side: float) -> np.ndarray:
    """Return the steps between square cells whose rows run to the right, the first row on top."""
    return np.array([[side, 0.0], [0.0, -side]])


def map_sheet(maps: list[Map], caption: str) -> "Figure":
    """Draw maps of equal height side by side, with a caption below."""
    from matplotlib.figure import Figure

    figure = Figure(figsize=(_WIDTH, _HEIGHT), layout="compressed", dpi=100)
    ratios = [width / height for width, height in (each.size for each in maps)]
    grid = figure.subplots(1, len(maps), width_ratios=ratios, squeeze=False)
    for axes, each in zip(grid[0], maps, strict=True):
        _draw_map(axes, each)
    figure.supxlabel(caption, fontsize=_TEXT, color=INK)
    return figure


def _draw_map(axes: "Axes", each: Map) -> None:
    """Draw a map with its title, colour bar, scale bar and arrow to the north."""
    from matplotlib.transforms import Affine2D

    (rows, columns), (low, high), (width, height) = each.value.shape, each.span, each.size
    placed = Affine2D(np.vstack([np.column_stack([each.steps.T, each.corners[0]]), (0.0, 0.0, 1.0)]))
    shown = axes.imshow(each.value, cmap=each.colours, vmin=low, vmax=high, extent=(0.0, columns, rows, 0.0))
    shown.set_transform(placed + axes.transData)
    axes.set(xticks=[], yticks=[], facecolor=SKY, xlim=(0.0, width), ylim=(0.0, height))
    axes.set_title(each.title, fontsize=_TITLE, color=INK)
    extend = "min" if np.nanmin(each.value, initial=high) < low else "neither"
    bar = axes.figure.colorbar(shown, ax=axes, orientation="horizontal", extend=extend, shrink=0.9, pad=0.02, aspect=25)
    bar.set_label(each.label, fontsize=_TEXT, color=INK)
    bar.ax.tick_params(labelsize=_TEXT)
    edge = _FROM_EDGE * max(width, height)
    _draw_scale(axes, width, edge)
    _draw_north(axes, each.size - 2.5 * edge, edge, each.north)


def scale_length(width: float) -> float:
    """Return the longest length of 1, 2 or 5 times a power of ten that is at most a third of a map's width."""
    power = 10.0 ** np.floor(np.log10(width / 3.0))
    return float(max(step * power for step in (1.0, 2.0, 5.0) if step * power <= width / 3.0))


def _draw_scale(axes: "Axes", width: float, edge: float) -> None:
    """Draw a scale bar of a round length in the lower left corner of a map."""
    length = scale_length(width)
    _draw_rectangle(axes, (0.5 * edge, 0.5 * edge), length + edge, 2.3 * edge, color="white", alpha=0.85)
    _draw_rectangle(axes, (edge, edge), length, 0.25 * edge, color=INK)
    axes.text(edge + 0.5 * length, 1.4 * edge, f"{length:g} m", ha="center", va="bottom", fontsize=_TEXT, color=INK)


def _draw_north(axes: "Axes", at: np.ndarray, edge: float, north: tuple[float, float]) -> None:
    """Draw an arrow to the north through the position `at`, above an N."""
    _draw_rectangle(axes, at + edge * np.array([-1.0, -2.4]), 2.0 * edge, 4.0 * edge, color="white", alpha=0.85)
    along = edge * np.array(north)
    style = {"arrowstyle": "-|>", "mutation_scale": 22, "linewidth": 2.5, "color": INK, "shrinkA": 0, "shrinkB": 0}
    axes.annotate("", at + 1.2 * along, at - 0.6 * along, arrowprops=style)
    axes.text(at[0], at[1] - 0.9 * edge, "N", ha="center", va="top", fontsize=_TEXT, color=INK)


def _draw_rectangle(axes: "Axes", corner: Any, width: float, height: float, **style: Any) -> None:
    """Draw a filled rectangle, given by its lower left corner and size."""
    from matplotlib.patches import Rectangle

    axes.add_patch(Rectangle(corner, width, height, linewidth=0.0, **style))
