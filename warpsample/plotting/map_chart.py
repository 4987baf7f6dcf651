"""Chart of a map over (cos theta, phi): counted directions, the density, and their difference in standard deviations."""

from typing import TYPE_CHECKING, Any

import numpy as np

from warpsample.plotting.cell_map import CellMap
from warpsample.plotting.style import COUNTS, DIFFERENCE, INK, LOBE, round_up

if TYPE_CHECKING:
    from matplotlib.axes import Axes

_TEXT, _SMALL = 11, 10
_GAP = 5.0  # points between the map of residuals and the verdict above
_MOST_SIGMA = 4.0
_PIXELS = 512  # of the height of an image, whose rows have different heights
_AROUND = (0.1, 0.055, 0.095, 0.035)  # labels at the left, below, at the right and above, as shares of the sheet
_MAPS = ("observed", "expected", "residuals")

MAP_PLACES = {
    "observed": (0.1, 0.45, 0.365, 0.165),
    "expected": (0.505, 0.45, 0.365, 0.165),
    "density": (0.885, 0.45, 0.02, 0.165),
    "residuals": (0.1, 0.06, 0.365, 0.265),
    "sigma": (0.48, 0.06, 0.02, 0.265),
}
"""Places of the maps and colour bars on the viewer's sheet: left, bottom, width and height, as shares of the sheet."""


class MapChart:
    """Chart of both angles: maps of the counted directions and of the density, and a map of the residuals with a verdict.

    `moving` has the meaning of `HistogramChart.moving`.
    """

    def __init__(self, figure: Any, places: dict[str, tuple[float, ...]] = MAP_PLACES, animated: bool = True):
        """Create the maps in a figure, without data.

        Args:
            figure: figure to draw into.
            places: places of the axes, with the keys of MAP_PLACES. Maps next to each other share the labels of cos theta,
                maps above each other those of phi.
            animated: whether the caller draws the artists in `moving`.
        """
        from matplotlib.colors import Normalize, PowerNorm
        from matplotlib.transforms import ScaledTranslation

        self._places, self._beside = tuple(places.values()), places["observed"][1] == places["expected"][1]
        self._axes: dict[str, Axes] = {name: figure.add_axes(place) for name, place in places.items()}
        self._density, sigma = PowerNorm(0.5, 0.0, 1.0), Normalize(-_MOST_SIGMA, _MOST_SIGMA)
        images = []
        for name, norm, colours in (
            ("observed", self._density, COUNTS),
            ("expected", self._density, COUNTS),
            ("residuals", sigma, DIFFERENCE),
        ):
            axes = self._axes[name]
            style = {"norm": norm, "cmap": colours, "aspect": "auto", "interpolation": "nearest", "animated": animated}
            images.append((axes, axes.imshow(np.zeros((1, 1)), extent=(0.0, 360.0, -1.0, 1.0), **style)))
            axes.set(xlim=(0.0, 360.0), xticks=(0, 90, 180, 270, 360))
            axes.tick_params(labelsize=_SMALL)
        words = {"fontsize": _TEXT, "color": INK}
        residuals = self._axes["residuals"]
        above = residuals.transAxes + ScaledTranslation(0.0, _GAP / 72.0, figure.dpi_scale_trans)
        verdict = residuals.text(0.0, 1.0, "", transform=above, animated=animated, **words)
        self.moving = (*images, (residuals, verdict))
        self._draw_fixed_parts(figure, images, words)

    def _draw_fixed_parts(self, figure: Any, images: list[Any], words: dict[str, Any]) -> None:
        """Draw titles, labels and colour bars."""
        self._axes["observed"].set_title("density of the directions", loc="left", **words)
        self._axes["expected"].set_title("compared density", loc="left", **words)
        for name in _MAPS:
            if not (self._beside and name == "expected"):
                self._axes[name].set_ylabel("cos θ", labelpad=1, **words)
            if self._beside or name == "residuals":
                self._axes[name].set_xlabel("φ about the normal [degrees]", labelpad=2, **words)
            else:
                self._axes[name].set_xticklabels([])
        for (_, image), name, label in ((images[1], "density", "density [1/sr]"), (images[2], "sigma", "residual [σ]")):
            bar = figure.colorbar(image, cax=self._axes[name])
            bar.set_label(label, **words)
            bar.ax.tick_params(labelsize=_SMALL)
            bar.ax.locator_params(nbins=4)

    @property
    def frame(self) -> tuple[float, ...]:
        """Range of cos theta, and the density with the last colour."""
        return (*self._axes["observed"].get_ylim(), float(self._density.vmax))

    def draw_still(self, canvas: Any) -> None:
        """Redraw the axes of the chart and their labels."""
        pixels, renderer = np.asarray(canvas.buffer_rgba()), canvas.get_renderer()
        height, width = pixels.shape[:2]
        for left, bottom, wide, high in self._places:
            x0, x1 = max(0.0, left - _AROUND[0]), left + wide + _AROUND[2]
            y0, y1 = bottom + high + _AROUND[3], max(0.0, bottom - _AROUND[1])
            pixels[round((1.0 - y0) * height) : round((1.0 - y1) * height), round(x0 * width) : round(x1 * width)] = 255
        for axes in self._axes.values():
            axes.draw(renderer)

    def show(self, seen: CellMap) -> None:
        """Replace the maps and the verdict."""
        (_, observed), (_, expected), (_, residuals), (_, verdict) = self.moving
        row = np.searchsorted(-seen.edges, -np.linspace(1.0, seen.edges[-1], 2 * _PIXELS + 1)[1::2], side="right") - 1
        for image, values in ((observed, seen.observed), (expected, seen.expected), (residuals, seen.residuals)):
            image.set_data(values[row])
            image.set_extent((0.0, 360.0, float(seen.edges[-1]), 1.0))
        top = round_up(max(float(seen.expected.max()), 1e-9))
        if self._density.vmax != top:
            self._density.vmax = top
        self._set_range(float(seen.edges[-1]))
        verdict.set_text(f"(θ, φ) {seen.verdict()}")
        verdict.set_color(LOBE if seen.is_wrong else INK)

    def _set_range(self, low: float) -> None:
        """Set the range of cos theta, from 1 down to `low`."""
        ticks = np.linspace(1.0, low, 5 if low < -0.5 else 3)
        digits = max(1, int(np.ceil(-np.log10(1.0 - low))) + 1)
        for name in _MAPS:
            self._axes[name].set(ylim=(low, 1.0), yticks=ticks)
            labelled = not (self._beside and name == "expected")
            self._axes[name].set_yticklabels([f"{tick:.{digits}f}" if labelled else "" for tick in ticks])
