"""The time to the RMSE of our sky matrix, by each tool."""

from typing import TYPE_CHECKING

from warpsample.bench.pictures import OURS, THEIRS, dots
from warpsample.bench.radiation.measuring import Found
from warpsample.bench.report import digits

if TYPE_CHECKING:
    from matplotlib.figure import Figure


def draw(found: Found, caption: str) -> dict[str, "Figure"]:
    """A dot for each tool, a plot to each scene, all threads."""
    from matplotlib.figure import Figure  # noqa: PLC0415

    most = max(row.workers for row in found.sky)
    rows = [row for row in found.sky if row.workers == most and row.times_ours]
    scenes = list(dict.fromkeys(row.scene for row in rows))
    figure = Figure(figsize=(5.0 * len(scenes) + 1.0, 3.4), layout="constrained")
    for axes, scene in zip(figure.subplots(1, len(scenes), squeeze=False)[0], scenes, strict=True):
        mine = [row for row in rows if row.scene == scene]
        colours = [OURS if row.tool == "warpsample" else THEIRS for row in mine]
        times = [row.times_ours for row in mine]
        dots(axes, [row.tool for row in mine], times, colours, [digits(t.median) for t in times])
        axes.set_title(scene, fontsize=11)
    figure.supxlabel(f"time of a sky matrix to the RMSE of ours, times ours\n{caption}", fontsize=10)
    return {"radiation": figure}
