"""Figure of the point sequences: on the unit square, on the hemisphere, and the errors of means over the directions."""

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from warpsample import sequences
from warpsample.plotting.style import INK

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

_TITLE, _TEXT, _TICKS = 17, 14, 12
_TILT = np.radians(35.0)  # angle of the view above the tangent plane
_SLOPES = ((-0.5, "--", "$N^{-1/2}$"), (-1.0, ":", "$N^{-1}$"))


@dataclass(frozen=True, eq=False)
class Convergence:
    """Errors of the mean of one integrand: root mean square error by number of samples, for each sequence.

    Attributes:
        title: name of the integrand.
        counts: (C,) numbers of samples per estimate.
        rmse: (C,) root mean square errors, keyed by the name of the sequence.
    """

    title: str
    counts: np.ndarray
    rmse: dict[str, np.ndarray]


def sequence_sheet(
    squares: dict[str, np.ndarray], lobes: dict[str, np.ndarray], curves: list[Convergence], caption: str
) -> "Figure":
    """Draw the sequences on the square and on the hemisphere, and their errors by the number of samples.

    Args:
        squares: (N, 2) points of the unit square, keyed by the name of the sequence.
        lobes: (N, 3) directions that belong to the points, keyed in the same way.
        curves: errors of each integrand.
        caption: text below the charts.
    """
    from matplotlib.figure import Figure

    figure = Figure(figsize=(16.0, 11.0), layout="constrained", dpi=100)
    above, below = figure.subfigures(2, 1, height_ratios=(1.0, 1.1))
    grid = above.subplots(2, len(squares))
    for (square, lobe), name in zip(grid.T, squares, strict=True):
        colour = sequences.get(name).colour
        square.plot(*squares[name].T, ".", color=colour, markersize=4)
        square.set(aspect="equal", xlim=(0, 1), ylim=(0, 1), xticks=(0, 1), yticks=(0, 1))
        square.tick_params(labelsize=_TICKS)
        square.set_xlabel("u[0]", labelpad=-12, fontsize=_TEXT)
        square.set_ylabel("u[1]", labelpad=-10, fontsize=_TEXT)
        square.set_title(name, fontsize=_TITLE, color=INK)
        _draw_hemisphere(lobe, lobes[name], colour)
    for axes, curve in zip(below.subplots(1, len(curves), sharey=True), curves, strict=True):
        _draw_convergence(axes, curve)
    below.axes[0].set_ylabel("root mean square error", fontsize=_TEXT)
    handles, labels = below.axes[0].get_legend_handles_labels()
    below.legend(handles, labels, frameon=False, fontsize=_TEXT, loc="outside right center")
    below.supxlabel(caption, fontsize=_TEXT, color=INK)
    return figure


def _draw_hemisphere(axes: "Axes", w: np.ndarray, colour: str) -> None:
    """Draw directions on a hemisphere, with its rim and the normal."""
    turn = np.linspace(0.0, 2.0 * np.pi, 181)
    rim = np.stack([np.cos(turn), np.sin(turn), 0.0 * turn], axis=1)
    arch = np.stack([np.cos(turn[:91]), 0.0 * turn[:91], np.sin(turn[:91])], axis=1)
    up = np.array([[0.0, 0.0, 0.0], [0.0, 0.0, 1.15]])
    for line, shade in ((rim, "0.7"), (arch, "0.88"), (up, INK)):
        axes.plot(*_project(line), color=shade, linewidth=1)
    axes.plot(*_project(w), ".", color=colour, markersize=4)
    axes.set(aspect="equal", xlim=(-1.08, 1.08), ylim=(-0.68, 1.08))
    axes.axis("off")


def _project(points: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Project points, (N, 3), to the two coordinates of a drawing, seen from 35 degrees above the tangent plane."""
    return points[:, 0], points[:, 1] * np.sin(_TILT) + points[:, 2] * np.cos(_TILT)


def _draw_convergence(axes: "Axes", curve: Convergence) -> None:
    """Draw the errors of each sequence as a line with dots, and the slopes N^(-1/2) and N^(-1)."""
    for name, rmse in curve.rmse.items():
        record = sequences.get(name)
        axes.loglog(curve.counts, rmse, label=name, color=record.colour, marker=record.marker, markersize=7, linewidth=1)
    first = max(rmse[0] for rmse in curve.rmse.values())
    for power, dashes, label in _SLOPES:
        falling = first * np.float_power(curve.counts / curve.counts[0], power)
        axes.loglog(curve.counts, falling, dashes, color="0.5", linewidth=1.2, label=label)
    axes.set_title(curve.title, fontsize=_TITLE)
    axes.set_xlabel("samples per estimate, N", fontsize=_TEXT)
    axes.tick_params(labelsize=_TICKS)
    axes.grid(alpha=0.3)
