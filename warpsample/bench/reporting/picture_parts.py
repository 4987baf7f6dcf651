"""Titles, axis labels and bars of benchmark pictures."""

from typing import TYPE_CHECKING

from warpsample.bench.rows import Spread

if TYPE_CHECKING:
    from matplotlib.axes import Axes

TITLES = {
    "error": "Error of a mean over the cosine lobe by run time, for seven integrands (lower left is better)",
    "rays": "Speed of rays on one thread, by the kind of rays (higher is better)",
    "visibility": "Time of one point to reach an error of its ambient occlusion (left is better)",
}
"""Title of each picture, keyed by the name of the picture."""

LABELS = {
    ("error", "microseconds"): "wall time of one estimate with all threads, sampling included [µs]",
    ("error", "rmse"): "RMSE of the mean",
    ("rays", "kind"): "kind of rays",
    ("rays", "million_per_second"): "million rays per second",
    ("rays", "wide"): "warpsample",
    ("visibility", "microseconds"): "time per point with all threads [µs]",
    ("visibility", "tool"): "",
    ("visibility", "target"): "RMSE to reach",
}
"""Labels that replace column headings, keyed by the name of the picture and of the field or value."""

_WIDTH = 0.8  # of a group of bars, whose centres are 1 apart


def draw_bars(axes: "Axes", groups: dict[str, dict[str, Spread]]) -> None:
    """Draw groups of vertical bars with whiskers from the 25th to the 75th percentile.

    Args:
        axes: axes to draw into.
        groups: heights of the bars, keyed by the label of the series, then by the name of the group.
    """
    names = list(dict.fromkeys(name for bars in groups.values() for name in bars))
    width = _WIDTH / len(groups)
    for i, (label, bars) in enumerate(groups.items()):
        x = [names.index(name) + (i - 0.5 * (len(groups) - 1)) * width for name in bars]
        axes.bar(x, [bar.median for bar in bars.values()], width, label=label)
        axes.vlines(x, [bar.low for bar in bars.values()], [bar.high for bar in bars.values()], color="0.2", linewidth=0.8)
    axes.set_xticks(range(len(names)), names)
    axes.grid(axis="y", alpha=0.3)
    axes.set_axisbelow(True)
