"""Pictures of light in a grid."""

from typing import TYPE_CHECKING

import numpy as np

from warpsample.plotting.rendering import INK

if TYPE_CHECKING:
    from matplotlib.figure import Figure

_WIDTH = 16.0  # inches, for which the text is sized
_GAMMA = 2.2


def light_sheet(columns: dict[str, list[np.ndarray]], heights: tuple[float, ...], caption: str) -> "Figure":
    """Draws pictures of light as a screen shows them, in columns below their titles.

    Each is (H, W) or (H, W, 3): 0 is black, 1 and more the brightest, NaN white. The heights of the rows are relative to
    each other.
    """
    from matplotlib.figure import Figure

    figure = Figure(figsize=(_WIDTH, 6.8), layout="constrained", dpi=100)
    grid = figure.subplots(len(heights), len(columns), height_ratios=heights, squeeze=False)
    for axes_below, (title, pictures) in zip(grid.T, columns.items(), strict=True):
        axes_below[0].set_title(title, fontsize=17, color=INK)
        for axes, light in zip(axes_below, pictures, strict=True):
            shown = np.where(np.isnan(light), 1.0, np.float_power(np.clip(light, 0.0, 1.0), 1.0 / _GAMMA))
            axes.imshow(shown, cmap="gray", vmin=0.0, vmax=1.0, interpolation="nearest")
            axes.axis("off")
    figure.supxlabel(caption, fontsize=14, color=INK)
    return figure
