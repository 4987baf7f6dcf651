"""Rays a second by each tool."""

from typing import TYPE_CHECKING

from warpsample.bench.pictures import OURS, THEIRS, bars
from warpsample.bench.rays.measuring import Found

if TYPE_CHECKING:
    from matplotlib.figure import Figure

_COLOURS = {"wide": OURS, "wp.Mesh": "#5b8e3e", "Embree": "#d1495b", "Open3D": THEIRS}


def draw(found: Found, caption: str) -> dict[str, "Figure"]:
    """Bars of rays a second on one thread, a plot to each scene and query, a group to each kind of rays."""
    from matplotlib.figure import Figure  # noqa: PLC0415

    rows = [row for row in found.rows if row.workers == 1]
    scenes = list(dict.fromkeys((row.scene, row.triangles) for row in rows))
    tools, kinds = (list(dict.fromkeys(getattr(row, name) for row in rows)) for name in ("tool", "kind"))
    figure = Figure(figsize=(3.0 * len(scenes) + 1.0, 6.5), layout="constrained")
    grid = figure.subplots(2, len(scenes), sharey="row", squeeze=False)
    for axes_of, any_hit in zip(grid, (True, False), strict=True):
        for axes, (scene, triangles) in zip(axes_of, scenes, strict=True):
            for k, tool in enumerate(tools):
                mine = [row for row in rows if (row.scene, row.any_hit, row.tool) == (scene, any_hit, tool)]
                places = [i + 0.2 * (k - len(tools) / 2 + 0.5) for i in range(len(mine))]
                bars(axes, places, mine, _COLOURS[tool], tool, 0.18)
            axes.set_xticks(range(len(kinds)), kinds, fontsize=10)
            axes.set_title(f"{scene.split(',')[0]}, {triangles:,} triangles", fontsize=11)
        axes_of[0].set_ylabel(f"{'any' if any_hit else 'nearest'} hit, million rays a second")
    figure.legend(*grid[0][0].get_legend_handles_labels(), loc="outside upper center", ncols=4, frameon=False)
    figure.supxlabel(f"one thread; whiskers over the middle half of the repeats\n{caption}", fontsize=10)
    return {"rays": figure}
