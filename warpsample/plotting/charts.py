"""Charts of the viewer: histograms of angles with densities and residuals, and the projected disk.

All charts are on one sheet. Parts that do not change between two drawings are drawn once, so that a knob responds fast.
"""

from typing import TYPE_CHECKING, Any

import numpy as np

from warpsample.plotting.angle_histogram import AngleHistogram
from warpsample.plotting.style import BARS, DOTS, INK, LOBE

if TYPE_CHECKING:
    from matplotlib.axes import Axes

_STEPS = (1.0, 1.2, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 8.0, 10.0)
_TEXT, _SMALL = 11, 10
_WIDTH = 7.4  # width of the sheet in inches, for which the text is sized
_MOST_SIGMA = 6.0
_MOST_WRONG = 3.0  # times the density: taller bars are cut
_MOST_STILLS = 64  # cached sheets of 3 MB
_BAND = 2.0  # standard deviations


class LobeCharts:
    """Sheet with charts of the viewer: histograms of theta and azimuth, and the projected disk.

    `size` is the width and height of the sheet in pixels.

    Fixed parts are drawn once (blitting): matplotlib takes 2 to 6 ms for a text, and a knob would respond half as fast.
    """

    def __init__(self, size: tuple[int, int]):
        """Create empty charts on a sheet of the given width and height in pixels."""
        from matplotlib.backends.backend_agg import FigureCanvasAgg
        from matplotlib.figure import Figure

        self.size = size
        self.figure: Figure = Figure(figsize=(_WIDTH, _WIDTH * size[1] / size[0]), dpi=size[0] / _WIDTH)
        self._canvas = FigureCanvasAgg(self.figure)
        self.theta: HistogramChart = HistogramChart(
            self.figure, above=(0.1, 0.685, 0.88, 0.25), below=(0.1, 0.575, 0.88, 0.085), name="θ", label="from the normal"
        )
        self.azimuth: HistogramChart = HistogramChart(
            self.figure, above=(0.1, 0.185, 0.37, 0.235), below=(0.1, 0.075, 0.37, 0.085), name="φ", label="about the normal"
        )
        style = {"frameon": False, "fontsize": _TEXT, "handlelength": 1.2}
        self.figure.legend(handles=self.theta.handles, loc="upper right", bbox_to_anchor=(0.99, 1.005), **style)
        self.disk: DiskChart = DiskChart(self.figure, (0.56, 0.085, 0.42, 0.335))
        self._parts = (self.theta, self.azimuth, self.disk)
        self._frames: tuple[Any, ...] = ()
        self._stills: dict[tuple[Any, ...], Any] = {}

    def draw(self, theta: AngleHistogram, azimuth: AngleHistogram, disk: np.ndarray) -> np.ndarray:
        """Draw the charts with new data, and return the pixels of the sheet, (H, W, 3) uint8.

        Args:
            theta: angles to the normal, 0 to 180 degrees.
            azimuth: angles about the normal, 0 to 360 degrees.
            disk: (N, 2) components of unit directions along the tangent and the bitangent.
        """
        self.theta.show(theta)
        self.azimuth.show(azimuth)
        self.disk.show(disk)
        self._draw_still()
        for part in self._parts:
            for axes, artist in part.moving:
                axes.draw_artist(artist)
        return np.asarray(self._canvas.buffer_rgba())[..., :3].copy()

    def _draw_still(self) -> None:
        """Draw the axes of all charts without data; axes with an unchanged range are copied from a cached sheet."""
        frames = tuple(part.frame for part in self._parts)
        if frames in self._stills:
            self._canvas.restore_region(self._stills[frames])
        elif not self._stills:
            self._canvas.draw()
        else:
            self._canvas.restore_region(self._stills[self._frames])
            for part, before, now in zip(self._parts, self._frames, frames, strict=True):
                if before != now:
                    part.draw_still(self._canvas)
        if frames not in self._stills:
            if len(self._stills) == _MOST_STILLS:
                self._stills.clear()
            self._stills[frames] = self._canvas.copy_from_bbox(self.figure.bbox)
        self._frames = frames


class HistogramChart:
    """Chart of one angle: histogram as bars, density as a line, verdict above and residuals below.

    Attributes:
        moving: (axes, artist) of each artist that every drawing replaces.
        handles: bars and line, for a legend.
    """

    def __init__(self, figure: Any, *, above: tuple[float, ...], below: tuple[float, ...], name: str, label: str):
        """Create the chart of one angle in a figure, without data.

        Args:
            figure: figure to draw into.
            above: left, bottom, width and height of the histogram, as shares of the figure.
            below: left, bottom, width and height of the residuals, as shares of the figure.
            name: letter of the angle.
            label: origin of the angle, in words.
        """
        self._name = name
        self._box = (above[0] - 0.1, below[1] - 0.075, above[0] + above[2] + 0.02, above[1] + above[3] + 0.012)
        self._above, self._below = figure.add_axes(above), figure.add_axes(below)
        one, unit = np.zeros(1), np.array([0.0, 1.0])
        bars = self._above.stairs(one, unit, fill=True, color=BARS, label="directions", animated=True)
        (curve,) = self._above.plot([], [], color=LOBE, linewidth=2, label="compared density", animated=True)
        verdict = self._above.text(0.0, 1.03, "", transform=self._above.transAxes, fontsize=_TEXT, color=INK, animated=True)
        residuals = self._below.stairs(one, unit, fill=True, color=BARS, animated=True)
        self.moving = ((self._above, bars), (self._above, curve), (self._above, verdict), (self._below, residuals))
        self.handles = [bars, curve]
        self._draw_fixed_parts(f"{name} {label} [degrees]")

    def _draw_fixed_parts(self, label: str) -> None:
        """Draw the fixed parts of the chart: labels, ticks and the band of two standard deviations."""
        self._above.set_ylabel("density [1/rad]", fontsize=_TEXT)
        self._above.set_xticklabels([])
        self._above.locator_params(axis="y", nbins=5)
        self._below.set(ylim=(-_MOST_SIGMA, _MOST_SIGMA), yticks=(-4, 0, 4))
        self._below.axhspan(-_BAND, _BAND, color="0.92")
        self._below.axhline(0, color="0.3", linewidth=0.8)
        self._below.set_ylabel("residual [σ]", fontsize=_TEXT)
        self._below.set_xlabel(label, fontsize=_TEXT)
        for axes in (self._above, self._below):
            axes.tick_params(labelsize=_SMALL)

    @property
    def frame(self) -> tuple[float, ...]:
        """Range of the histogram's axes: left, right, bottom, top."""
        return (*self._above.get_xlim(), *self._above.get_ylim())

    def draw_still(self, canvas: Any) -> None:
        """Redraw the axes of the chart and their labels."""
        pixels = np.asarray(canvas.buffer_rgba())
        height, width = pixels.shape[:2]
        left, bottom, right, top = self._box
        rows = slice(round((1.0 - top) * height), round((1.0 - bottom) * height))
        pixels[rows, round(left * width) : round(right * width)] = 255
        for axes in (self._above, self._below):
            axes.draw(canvas.get_renderer())

    def show(self, seen: AngleHistogram) -> None:
        """Replace the histogram, the density and the verdict in the chart.

        The range of the axes changes in steps, so that most drawings need no new axes.
        """
        bars, curve, verdict, residuals = (artist for _, artist in self.moving)
        bars.set_data(seen.observed, seen.edges)
        curve.set_data(seen.angles, seen.density)
        verdict.set_text(f"{self._name} {seen.verdict()}")
        verdict.set_color(LOBE if seen.is_wrong else INK)
        residuals.set_data(np.clip(seen.residuals, -_MOST_SIGMA, _MOST_SIGMA), seen.edges)
        self._set_range(float(seen.edges[0]), float(seen.edges[-1]))
        tallest = float(seen.expected.max(initial=1e-9))
        top = _round_up(1.15 * min(max(tallest, float(seen.observed.max())), _MOST_WRONG * tallest))
        if self._above.get_ylim() != (0.0, top):
            self._above.set_ylim(0.0, top)

    def _set_range(self, low: float, high: float) -> None:
        """Set the range of the chart's horizontal axes, in degrees."""
        if self._below.get_xlim() == (low, high):
            return
        ticks = np.linspace(low, high, 4)
        for axes in (self._above, self._below):
            axes.set(xlim=(low, high), xticks=ticks)
        self._below.set_xticklabels([f"{tick:.4g}" for tick in ticks])
        self._above.set_xticklabels([])


class DiskChart:
    """Chart of directions seen along the normal: the projected hemisphere, which a cosine lobe fills uniformly (Nusselt).

    `moving` has the meaning of `HistogramChart.moving`. The range of the axes never changes, so `frame` is empty.
    """

    def __init__(self, figure: Any, box: tuple[float, ...]):
        """Create the chart of the projected hemisphere in a figure, without data.

        `box` is left, bottom, width and height as fractions of the figure.
        """
        axes: Axes = figure.add_axes(box)
        (points,) = axes.plot([], [], "o", markersize=2.2, color=DOTS, markeredgewidth=0, animated=True)
        turn = np.linspace(0.0, 2.0 * np.pi, 181)
        (rim,) = axes.plot(np.cos(turn), np.sin(turn), color=INK, linewidth=1, animated=True)
        words = axes.text(0.0, 1.03, "", transform=axes.transAxes, fontsize=_TEXT, color=INK, animated=True)
        self.moving = ((axes, points), (axes, rim), (axes, words))
        self.frame = ()
        axes.set(aspect="equal", xlim=(-1.03, 1.03), ylim=(-1.03, 1.03), xticks=(-1, 0, 1), yticks=(-1, 0, 1))
        axes.tick_params(labelsize=_SMALL)
        axes.set_xlabel("ω·t, along the tangent", fontsize=_TEXT)
        axes.set_ylabel("ω·b, along the bitangent", fontsize=_TEXT, labelpad=-6)

    def show(self, disk: np.ndarray) -> None:
        """Show other directions, given by components along tangent and bitangent, (N, 2)."""
        points, _, words = (artist for _, artist in self.moving)
        points.set_data(disk[:, 0], disk[:, 1])
        words.set_text(f"{len(disk):,} directions of the\npinned point, seen along n")


def _round_up(x: float) -> float:
    """Round x up to one of _STEPS times a power of ten."""
    scale = 10.0 ** np.floor(np.log10(x))
    return float(next(step * scale for step in _STEPS if step * scale >= x * (1 - 1e-9)))
