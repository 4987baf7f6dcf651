"""Figure that explains Shirley's trick: sampling directions by adding the normal to points of a sphere or disk."""

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from warpsample.plotting.style import BARS, DOTS, INK, LOBE
from warpsample.statistics.histogram import HistogramTest

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

_TITLE, _TEXT, _TICKS = 18, 15, 13
_SYMBOL = 22


@dataclass(frozen=True, eq=False)
class SetPanel:
    """One panel of the figure: points around the tip of the normal, and the angles of the directions to the points.

    Attributes:
        title: text above the panel.
        points: (N, 2) points of the set, with the normal up.
        directions: (N, 2) the same points projected onto the unit circle or sphere.
        edges: (K + 1,) edges of the histogram's bins, degrees.
        observed: (K,) density of the directions, per radian.
        angles: (M,) angles of `density`, degrees.
        density: (M,) density of the distribution, per radian.
        formula: formula of the density, for the legend.
        test: chi-square test of the histogram against the density.
    """

    title: str
    points: np.ndarray
    directions: np.ndarray
    edges: np.ndarray
    observed: np.ndarray
    angles: np.ndarray
    density: np.ndarray
    formula: str
    test: HistogramTest


def family_sheet(sets: list[SetPanel], spheres: list[SetPanel], caption: str) -> "Figure":
    """Draw a figure on Shirley's trick: four sets of points around the normal's tip, three spheres, and the proof."""
    from matplotlib.figure import Figure

    figure = Figure(figsize=(16.0, 16.5), layout="constrained", dpi=100)
    grid = figure.add_gridspec(4, 4, height_ratios=(1.15, 1.0, 1.15, 1.0))
    for row, panels in ((0, sets), (2, spheres)):
        for column, panel in enumerate(panels):
            _draw_set(figure.add_subplot(grid[row, column]), panel)
            _draw_density(figure.add_subplot(grid[row + 1, column]), panel)
    _draw_half_angle(figure.add_subplot(grid[2:, 3]))
    figure.supxlabel(caption, fontsize=_TEXT, color=INK)
    return figure


def _draw_set(axes: "Axes", panel: SetPanel) -> None:
    """Draw points around the tip of the normal and the directions to the points, seen from the side."""
    turn = np.linspace(-np.pi / 2, np.pi / 2, 91)
    axes.plot(np.sin(turn), np.cos(turn), color="0.75", linewidth=1)
    axes.plot(*panel.points.T, ".", color=BARS, markersize=4, label="n + point")
    axes.plot(*panel.directions.T, ".", color=LOBE, markersize=4, label="direction ω")
    _draw_arrow(axes, (0, 1), (0, 0), INK)
    reach = max(1.0, float(np.abs(panel.points - [0.0, 1.0]).max()))
    axes.set(aspect="equal", xlim=(-1.3 * reach, 1.3 * reach), ylim=(min(-0.12, 0.95 - reach), 1.0 + 1.5 * reach))
    axes.locator_params(nbins=6)
    axes.tick_params(labelsize=_TICKS)
    axes.set_title(panel.title, fontsize=_TITLE)
    axes.set_xlabel("across the normal", fontsize=_TEXT)
    axes.set_ylabel("along the normal", fontsize=_TEXT)
    style = {"frameon": False, "handletextpad": 0.1, "columnspacing": 0.8, "markerscale": 2}
    axes.legend(loc="upper center", ncols=2, fontsize=_TICKS, **style)


def _draw_density(axes: "Axes", panel: SetPanel) -> None:
    """Draw the histogram of the directions' angles, with the density and the result of the chi-square test."""
    axes.stairs(panel.observed, panel.edges, fill=True, color=BARS, label="directions")
    axes.plot(panel.angles, panel.density, color=LOBE, linewidth=2, label=panel.formula)
    axes.set(xlim=(panel.edges[0], panel.edges[-1]), ylim=(0, 1.4 * max(panel.observed)))
    axes.set_xticks(np.linspace(panel.edges[0], panel.edges[-1], 7))
    axes.locator_params(axis="y", nbins=6)
    axes.tick_params(labelsize=_TICKS)
    axes.set_xlabel("θ from the normal [degrees]", fontsize=_TEXT)
    axes.set_ylabel("density [1/rad]", fontsize=_TEXT)
    axes.set_title(f"χ² = {panel.test.chi_square:.1f}, dof = {panel.test.dof}, p = {panel.test.p_value:.2f}", fontsize=_TEXT)
    right = panel.density[panel.angles > 0.55 * panel.edges[-1] + 0.45 * panel.edges[0]]
    side = "left" if right.max() > 0.75 * axes.get_ylim()[1] else "right"  # where the legend hides no data
    axes.legend(frameon=False, fontsize=_TICKS, loc=f"upper {side}", handlelength=1.2)


def _draw_half_angle(axes: "Axes", theta: float = 1.15) -> None:
    """Draw figure 1 (b) of the proof of Shirley's trick: n, a sphere point ω_temp, the sum ω, and θ = 2θ′."""
    turn = np.linspace(0.0, 2.0 * np.pi, 181)
    axes.plot(np.sin(turn), 1.0 + np.cos(turn), color="0.7", linewidth=1)
    point = np.array([np.sin(theta), 1.0 + np.cos(theta)])
    for end, start, colour in (((0, 1), (0, 0), INK), (point, (0, 1), DOTS), (point, (0, 0), LOBE)):
        _draw_arrow(axes, end, start, colour)
    axes.plot([0, 0], [1, 2], color="0.7", linewidth=1, linestyle="--")
    for centre, angle, radius, name in (((0, 1), theta, 0.35, "θ"), ((0, 0), theta / 2, 0.6, "θ′")):
        arc = np.linspace(0.0, angle, 40)
        axes.plot(centre[0] + radius * np.sin(arc), centre[1] + radius * np.cos(arc), color=INK, linewidth=1.2)
        middle = (radius + 0.13) * np.array([np.sin(angle / 2), np.cos(angle / 2)]) + centre
        axes.text(*middle, name, fontsize=_SYMBOL, ha="center", va="center", color=INK)
    axes.text(-0.27, 0.5, "n", fontsize=_SYMBOL, color=INK)
    axes.text(0.97, 1.42, "ω$_{temp}$", fontsize=_SYMBOL, color=DOTS)
    axes.text(0.93, 0.2, "ω, not yet\nnormalised", fontsize=_TEXT, color=LOBE)
    axes.set(aspect="equal", xlim=(-1.1, 1.75), ylim=(-0.15, 2.1))
    axes.set_title("Why sphere + normal is a\ncosine lobe: θ = 2θ′, so\nsin θ/2 dθ becomes sin 2θ′ dθ′", fontsize=_TEXT)
    axes.axis("off")


def _draw_arrow(axes: "Axes", end: tuple[float, float], start: tuple[float, float], colour: str) -> None:
    """Draw an arrow from `start` to `end`."""
    style = {"arrowstyle": "-|>", "color": colour, "linewidth": 2, "shrinkA": 0, "shrinkB": 0}
    axes.annotate("", end, start, arrowprops=style)
