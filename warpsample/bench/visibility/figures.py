"""The time to an RMSE by each tool."""

from typing import TYPE_CHECKING

from warpsample.bench.pictures import OURS, THEIRS, dots, log_ticks
from warpsample.bench.report import digits
from warpsample.bench.visibility.measuring import Found, TimeToError

if TYPE_CHECKING:
    from matplotlib.figure import Figure


def draw(found: Found, caption: str) -> dict[str, "Figure"]:
    """A dot for the time of each tool, a plot to each scene and RMSE, with how many times ours it is."""
    from matplotlib.figure import Figure  # noqa: PLC0415

    ran = [row for row in found.rows if row.microseconds is not None and not row.open_points]
    scenes, targets = (list(dict.fromkeys(getattr(row, name) for row in ran)) for name in ("scene", "target"))
    rows_of = [max(sum((r.scene, r.target) == (s, t) for r in ran) for s in scenes) for t in targets]
    figure = Figure(figsize=(4.4 * len(scenes) + 1.6, 1.6 + 0.42 * sum(rows_of)), layout="constrained")
    grid = figure.subplots(len(targets), len(scenes), squeeze=False, sharex=True, sharey="row", height_ratios=rows_of)
    for axes_of, target in zip(grid, targets, strict=True):
        for axes, scene in zip(axes_of, scenes, strict=True):
            mine = [row for row in ran if (row.scene, row.target) == (scene, target)]
            times = [row.microseconds for row in mine]
            colours = [OURS if row.tool.startswith("warpsample") else THEIRS for row in mine]
            dots(axes, [row.tool for row in mine], times, colours, [_told(row) for row in mine])
            axes.set_title(f"{scene}, to an RMSE of {target:g}", fontsize=11)
    spreads = [row.microseconds for row in ran]
    log_ticks(grid[0][0], [s.low for s in spreads], [s.high for s in spreads])
    figure.supxlabel(
        "time of a point's ambient occlusion [µs], and how many times ours that is; whiskers over the middle half of the "
        f"repeats\n{caption}",
        fontsize=10,
    )
    return {"visibility": figure}


def _told(row: TimeToError) -> str:
    time = digits(row.microseconds.median)
    return time if row.tool == "warpsample" else f"{time}, {row.times_ours.median:.3g} times"
