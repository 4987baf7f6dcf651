"""Figures that explain: Shirley's overlay, the offset family, the half angle, the sequences."""

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from warpsample import sequences
from warpsample.plotting.rendering import BARS, DOTS, INK, LOBE
from warpsample.statistics.histogram import HistogramTest

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

_FINER = 3  # pixels of the overlay to one of the picture
_DOT = 4.0  # pixels
_RED, _GREEN, _YELLOW = "#ff0000", "#00ff00", "#ffff00"


def overlay(red: np.ndarray, green: np.ndarray, size: int) -> tuple[np.ndarray, float]:
    """Two sets of directions along the normal, added as light: where both are, it is yellow.

    Args:
        red: (N, 3) unit directions, +z towards the viewer.
        green: (M, 3).
        size: pixels of either side.

    Returns:
        (size, size, 3) float in [0, 1], +y up; and the share of the lit area that is yellow.
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
    """Overlays side by side on black, each with a part of it enlarged.

    Args:
        panels: of each: what is red, what is green, the picture, the share that is yellow.
        caption: below.
    """
    from matplotlib.figure import Figure  # noqa: PLC0415

    figure = Figure(figsize=(16.0, 8.6), facecolor="black", dpi=100)
    for k, (red, green, picture, share) in enumerate(panels):
        left = 0.02 + k / len(panels)
        axes = figure.add_axes((left - 0.01, 0.06, 0.37, 0.37 * 16.0 / 8.6))
        axes.imshow(picture, interpolation="nearest")
        axes.axis("off")
        size = len(picture)
        window = (slice(int(0.60 * size), int(0.76 * size)), slice(int(0.42 * size), int(0.58 * size)))
        zoom = figure.add_axes((left + 0.365, 0.10, 0.11, 0.11 * 16.0 / 8.6))
        zoom.imshow(picture[window], interpolation="nearest")
        zoom.set(xticks=[], yticks=[], title="enlarged")
        zoom.title.set(color="white", fontsize=14)
        for side in zoom.spines.values():
            side.set_color("white")
        for line, (words, colour) in enumerate(
            ((f"red: {red}", _RED), (f"green: {green}", _GREEN), (f"yellow: both, {share:.0%} of what is lit", _YELLOW))
        ):
            figure.text(left + 0.01, 0.945 - 0.05 * line, words, color=colour, fontsize=19)
    figure.text(0.03, 0.02, caption, color="white", fontsize=13)
    return figure


@dataclass(frozen=True, eq=False)
class SetPanel:
    """A set about the tip of the normal, seen from the side, and what its projection makes of theta.

    Attributes:
        title: above.
        points: (N, 2) of the set, normal up.
        directions: (N, 2) the same, projected onto the unit circle or sphere.
        edges: (K + 1,) degrees.
        observed: (K,) per radian.
        angles: (M,) degrees.
        density: (M,) per radian.
        formula: of the density, for the legend.
        test: of the histogram.
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
    """The projected offset sets and spheres of other radii: points, histograms; and the half angle that proves the third.

    Args:
        sets: four.
        spheres: three.
        caption: below.
    """
    from matplotlib.figure import Figure  # noqa: PLC0415

    figure = Figure(figsize=(16.0, 16.5), layout="constrained", dpi=100)
    grid = figure.add_gridspec(4, 4, height_ratios=(1.15, 1.0, 1.15, 1.0))
    for row, panels in ((0, sets), (2, spheres)):
        for column, panel in enumerate(panels):
            _draw_set(figure.add_subplot(grid[row, column]), panel)
            _draw_density(figure.add_subplot(grid[row + 1, column]), panel)
    draw_half_angle(figure.add_subplot(grid[2:, 3]))
    figure.supxlabel(caption, fontsize=11, color=INK)
    return figure


def draw_half_angle(axes: "Axes", theta: float = 1.15) -> None:
    """The construction of the Shirley trick's proof, figure 1 (b): n, a sphere point ω_temp, their sum ω, and θ = 2θ′."""
    turn = np.linspace(0.0, 2.0 * np.pi, 181)
    axes.plot(np.sin(turn), 1.0 + np.cos(turn), color="0.7", linewidth=1)
    point = np.array([np.sin(theta), 1.0 + np.cos(theta)])
    for end, start, colour in (((0, 1), (0, 0), INK), (point, (0, 1), DOTS), (point, (0, 0), LOBE)):
        _arrow(axes, end, start, colour)
    axes.plot([0, 0], [1, 2], color="0.7", linewidth=1, linestyle="--")
    for centre, angle, radius, name in (((0, 1), theta, 0.35, "θ"), ((0, 0), theta / 2, 0.6, "θ′")):
        arc = np.linspace(0.0, angle, 40)
        axes.plot(centre[0] + radius * np.sin(arc), centre[1] + radius * np.cos(arc), color=INK, linewidth=1.2)
        middle = (radius + 0.13) * np.array([np.sin(angle / 2), np.cos(angle / 2)]) + centre
        axes.text(*middle, name, fontsize=19, ha="center", va="center", color=INK)
    axes.text(-0.2, 0.5, "n", fontsize=19, color=INK)
    axes.text(0.97, 1.42, "ω$_{temp}$", fontsize=19, color=DOTS)
    axes.text(0.95, 0.2, "ω, not yet\nnormalised", fontsize=15, color=LOBE)
    axes.set(aspect="equal", xlim=(-1.1, 1.85), ylim=(-0.15, 2.1))
    axes.set_title("why it is a cosine lobe: θ = 2θ′,\nso sin θ/2 dθ becomes sin 2θ′ dθ′", fontsize=15)
    axes.axis("off")


@dataclass(frozen=True, eq=False)
class Convergence:
    """Errors of all sequences on one integrand.

    Attributes:
        title: above.
        counts: (C,) samples.
        rmse: of each sequence, (C,).
    """

    title: str
    counts: np.ndarray
    rmse: dict[str, np.ndarray]


def sequence_sheet(
    squares: dict[str, np.ndarray], lobes: dict[str, np.ndarray], curves: list[Convergence], caption: str
) -> "Figure":
    """The sequences on the square, on the hemisphere, and what they are worth.

    Args:
        squares: of each sequence, (N, 2) points of the unit square.
        lobes: of each, (N, 3) the directions that the cosine lobe's map makes of them.
        curves: errors.
        caption: below.
    """
    from matplotlib.figure import Figure  # noqa: PLC0415

    figure = Figure(figsize=(16.0, 11.0), layout="constrained", dpi=100)
    above, below = figure.subfigures(2, 1, height_ratios=(1.25, 1.0))
    grid = above.subplots(2, len(squares))
    for (square, lobe), name in zip(grid.T, squares, strict=True):
        colour = sequences.get(name).colour
        square.plot(*squares[name].T, ".", color=colour, markersize=4)
        square.set(aspect="equal", xlim=(0, 1), ylim=(0, 1), xticks=(0, 1), yticks=(0, 1))
        square.set_xlabel("u[0]", labelpad=-12)
        square.set_ylabel("u[1]", labelpad=-8)
        square.set_title(name, fontsize=16, color=INK)
        _draw_hemisphere(lobe, lobes[name], colour)
    for axes, curve in zip(below.subplots(1, len(curves), sharey=True), curves, strict=True):
        _draw_convergence(axes, curve)
    below.axes[0].set_ylabel("RMSE", fontsize=12)
    below.axes[-1].legend(frameon=False, fontsize=11, loc="lower left")
    below.supxlabel(caption, fontsize=11, color=INK)
    return figure


def _arrow(axes: "Axes", end: tuple[float, float], start: tuple[float, float], colour: str) -> None:
    style = {"arrowstyle": "-|>", "color": colour, "linewidth": 2, "shrinkA": 0, "shrinkB": 0}
    axes.annotate("", end, start, arrowprops=style)


def _draw_set(axes: "Axes", panel: SetPanel) -> None:
    turn = np.linspace(-np.pi / 2, np.pi / 2, 91)
    axes.plot(np.sin(turn), np.cos(turn), color="0.75", linewidth=1)
    axes.plot(*panel.points.T, ".", color=BARS, markersize=4, label="n + point of the set")
    axes.plot(*panel.directions.T, ".", color=LOBE, markersize=4, label="projected: ω")
    _arrow(axes, (0, 1), (0, 0), INK)
    reach = max(1.0, float(np.abs(panel.points - [0.0, 1.0]).max()))
    axes.set(aspect="equal", xlim=(-1.3 * reach, 1.3 * reach), ylim=(min(-0.12, 0.95 - reach), 1.0 + 1.4 * reach))
    axes.set_title(panel.title, fontsize=15)
    axes.legend(loc="upper center", ncols=2, frameon=False, fontsize=10, handletextpad=0.1, columnspacing=0.8, markerscale=2)


def _draw_density(axes: "Axes", panel: SetPanel) -> None:
    axes.stairs(panel.observed, panel.edges, fill=True, color=BARS, label="directions")
    axes.plot(panel.angles, panel.density, color=LOBE, linewidth=2, label=panel.formula)
    axes.set(xlim=(panel.edges[0], panel.edges[-1]), ylim=(0, 1.35 * max(panel.observed)))
    axes.set_xticks(np.linspace(panel.edges[0], panel.edges[-1], 7))
    axes.set_xlabel("θ from the normal [degrees]")
    axes.set_ylabel("density [1/rad]")
    axes.set_title(f"χ² = {panel.test.chi_square:.1f}, dof = {panel.test.dof}, p = {panel.test.p_value:.2f}", fontsize=11)
    axes.legend(frameon=False, fontsize=11, loc="upper right", handlelength=1.2)


def _draw_hemisphere(axes: "Axes", w: np.ndarray, colour: str) -> None:
    """Directions as seen from 35 degrees above the plane, with the rim and the normal."""
    tilt = np.radians(35.0)
    turn = np.linspace(0.0, 2.0 * np.pi, 181)
    rim = np.stack([np.cos(turn), np.sin(turn), 0.0 * turn], axis=1)
    arch = np.stack([np.cos(turn[:91]), 0.0 * turn[:91], np.sin(turn[:91])], axis=1)
    up = np.array([[0.0, 0.0, 0.0], [0.0, 0.0, 1.15]])
    for line, shade in ((rim, "0.7"), (arch, "0.88"), (up, INK)):
        axes.plot(*_seen(line, tilt), color=shade, linewidth=1)
    axes.plot(*_seen(w, tilt), ".", color=colour, markersize=4)
    axes.set(aspect="equal", xlim=(-1.08, 1.08), ylim=(-0.68, 1.08))
    axes.axis("off")


def _seen(points: np.ndarray, tilt: float) -> tuple[np.ndarray, np.ndarray]:
    return points[:, 0], points[:, 1] * np.sin(tilt) + points[:, 2] * np.cos(tilt)


def _draw_convergence(axes: "Axes", curve: Convergence) -> None:
    for name, rmse in curve.rmse.items():
        style: dict[str, Any] = {"color": sequences.get(name).colour, "marker": sequences.get(name).marker, "markersize": 6}
        axes.loglog(curve.counts, rmse, label=name, **style)
    first = max(rmse[0] for rmse in curve.rmse.values())
    for power in (-0.5, -1.0):
        label = "$N^{-1/2}$, $N^{-1}$" if power == -1.0 else None
        axes.loglog(
            curve.counts,
            first * np.float_power(curve.counts / curve.counts[0], power),
            ":",
            color="0.5",
            linewidth=1.2,
            label=label,
        )
    axes.set_title(curve.title, fontsize=13)
    axes.set_xlabel("samples N of an estimate")
    axes.grid(alpha=0.3)
