"""Grids of pictures of light, and pictures of irradiance on a floor with a colour bar."""

from typing import TYPE_CHECKING

import numpy as np

from warpsample.plotting.style import INK

if TYPE_CHECKING:
    from matplotlib.figure import Figure

_WIDTH = 16.0  # inches, for which the text is sized
_TITLE, _TEXT = 17, 14
_GAMMA = 2.2


def light_sheet(
    columns: dict[str, list[np.ndarray]], rows: tuple[str, ...], heights: tuple[float, ...], caption: str
) -> "Figure":
    """Draw a grid of pictures of light with the usual gamma of 1/2.2; values above 1 are white.

    Args:
        columns: pictures of each column, (H, W) or (H, W, 3), keyed by the title above the column. Light of 0 is black,
            1 and more is brightest, NaN is white.
        rows: title at the left of each row.
        heights: relative heights of the rows.
        caption: text below the grid.
    """
    from matplotlib.figure import Figure

    figure = Figure(figsize=(_WIDTH, 6.8), layout="constrained", dpi=100)
    grid = figure.subplots(len(heights), len(columns), height_ratios=heights, squeeze=False)
    for axes_below, (title, pictures) in zip(grid.T, columns.items(), strict=True):
        axes_below[0].set_title(title, fontsize=_TITLE, color=INK)
        for axes, light in zip(axes_below, pictures, strict=True):
            shown = np.where(np.isnan(light), 1.0, np.float_power(np.clip(light, 0.0, 1.0), 1.0 / _GAMMA))
            axes.imshow(shown, cmap="gray", vmin=0.0, vmax=1.0, interpolation="nearest")
            axes.set(xticks=[], yticks=[])
            axes.spines[:].set_visible(False)
    for axes, name in zip(grid[:, 0], rows, strict=True):
        axes.set_ylabel(name, fontsize=_TEXT, color=INK)
    figure.supxlabel(caption, fontsize=_TEXT, color=INK)
    return figure


def irradiance_sheet(
    pictures: dict[str, np.ndarray],
    extent: tuple[float, float, float, float],
    labels: tuple[str, str, str],
    high: float,
    caption: str,
) -> "Figure":
    """Draw pictures of irradiance, (H, W), side by side with a shared colour bar from 0 to `high`.

    Args:
        pictures: irradiance keyed by the title above the picture; the first row is at the top.
        extent: coordinates of the left, right, bottom and top edge.
        labels: labels of the x axis, the y axis and the colour bar, with units.
        high: irradiance with the last colour; larger values have the last colour too.
        caption: text below the pictures.
    """
    from matplotlib.colors import PowerNorm
    from matplotlib.figure import Figure

    figure = Figure(figsize=(_WIDTH, 6.8), layout="constrained", dpi=100)
    grid = figure.subplots(1, len(pictures), sharey=True, squeeze=False)[0]
    for axes, (title, values) in zip(grid, pictures.items(), strict=True):
        norm = PowerNorm(1.0 / _GAMMA, 0.0, high, clip=True)  # as a screen shows light
        image = axes.imshow(values, cmap="gray", norm=norm, extent=extent, interpolation="nearest")
        axes.set_title(title, fontsize=_TITLE, color=INK)
        axes.set_xlabel(labels[0], fontsize=_TEXT, color=INK)
        axes.tick_params(labelsize=_TEXT)
    grid[0].set_ylabel(labels[1], fontsize=_TEXT, color=INK)
    bar = figure.colorbar(image, ax=list(grid), extend="max", aspect=25, pad=0.02)
    bar.set_label(labels[2], fontsize=_TEXT, color=INK)
    bar.set_ticks(np.linspace(0.0, high, 7))
    bar.ax.tick_params(labelsize=_TEXT)
    figure.supxlabel(caption, fontsize=_TEXT, color=INK)
    return figure
