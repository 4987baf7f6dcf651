"""Charts of the viewer: histograms of angles with densities and residuals, a map of both angles, and the projected disk.

All charts are on one sheet. Parts that do not change between two drawings are drawn once, so that a knob responds fast.
"""

from typing import TYPE_CHECKING, Any

import numpy as np

from warpsample.plotting.angle_histogram import AngleHistogram
from warpsample.plotting.cell_map import CellMap
from warpsample.plotting.map_chart import MapChart
from warpsample.plotting.style import BARS, DOTS, INK, LOBE, round_up

if TYPE_CHECKING:
    from matplotlib.axes import Axes

_TEXT, _SMALL = 11, 10
_WIDTH = 7.4  # width of the sheet in inches, for which the text is sized
_MOST_SIGMA = 6.0
_MOST_WRONG = 3.0  # times the density: taller bars are cut
_MOST_STILLS = 64  # cached sheets of 3 MB
_BAND = 2.0  # standard deviations

_WIDE = {
    "theta": ((0.1, 0.685, 0.88, 0.25), (0.1, 0.575, 0.88, 0.085)),
    "azimuth": ((0.1, 0.185, 0.37, 0.235), (0.1, 0.075, 0.37, 0.085)),
    "disk": (0.56, 0.085, 0.42, 0.335),
}
"""Places of the charts on a sheet without a map: left, bottom, width and height of axes, as shares of the sheet."""
_WITH_MAP = {
    "theta": ((0.1, 0.805, 0.365, 0.12), (0.1, 0.7, 0.365, 0.085)),
    "azimuth": ((0.575, 0.805, 0.405, 0.12), (0.575, 0.7, 0.405, 0.085)),
    "disk": (0.64, 0.06, 0.34, 0.27),
}
"""Places of the charts on a sheet with a map."""


class LobeCharts:
    """Sheet with charts of the viewer: histograms of theta and azimuth, the projected disk, and for some lobes a map.

    `size` is the width and height of the sheet in pixels. `map` is the chart of both angles, or None.

    Fixed parts are drawn once (blitting): matplotlib takes 2 to 6 ms for a text, and a knob would respond half as fast.
    """

    def __init__(self, size: tuple[int, int], with_map: bool = False):
        """Create empty charts on a sheet of the given width and height in pixels, with a map of both angles or without."""
        from matplotlib.backends.backend_agg import FigureCanvasAgg
        from matplotlib.figure import Figure

        self.size = size
        self.figure: Figure = Figure(figsize=(_WIDTH, _WIDTH * size[1] / size[0]), dpi=size[0] / _WIDTH)
        self._canvas = FigureCanvasAgg(self.figure)
        places = _WITH_MAP if with_map else _WIDE
        names = (("theta", "θ", "from the normal"), ("azimuth", "φ", "about the normal"))
        self.theta, self.azimuth = (
            HistogramChart(self.figure, above=places[key][0], below=places[key][1], name=name, label=label)
            for key, name, label in names
        )
        style = {"frameon": False, "fontsize": _TEXT, "handlelength": 1.2, "ncols": 2 if with_map else 1}
        self.figure.legend(handles=self.theta.handles, loc="upper right", bbox_to_anchor=(0.99, 1.005), **style)
        self.disk: DiskChart = DiskChart(self.figure, places["disk"])
        self.map: MapChart | None = MapChart(self.figure) if with_map else None
        self._parts = (self.theta, self.azimuth, self.disk, *([self.map] if self.map else []))
        self._frames: tuple[Any, ...] = ()
        self._stills: dict[tuple[Any, ...], Any] = {}

    def draw(
        self, theta: AngleHistogram, azimuth: AngleHistogram, disk: np.ndarray, cells: CellMap | None = None
    ) -> np.ndarray:
        """Draw the charts with new data, and return the pixels of the sheet, (H, W, 3) uint8.

        Args:
            theta: angles to the normal, 0 to 180 degrees.
            azimuth: angles about the normal, 0 to 360 degrees.
            disk: (N, 2) components of unit directions along the tangent and the bitangent.
            cells: both angles together, for a sheet with a map.
        """
        self.theta.show(theta)
        self.azimuth.show(azimuth)
        self.disk.show(disk)
        if self.map is not None and cells is not None:
            self.map.show(cells)
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
        top = round_up(1.15 * min(max(tallest, float(seen.observed.max())), _MOST_WRONG * tallest))
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
