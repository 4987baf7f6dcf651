"""Time per direction against error, and the sequences by samples per point."""

from typing import TYPE_CHECKING

from warpsample import sequences
from warpsample.bench.directions.measuring import Found, Speed
from warpsample.bench.directions.tables import short_name
from warpsample.bench.pictures import CEILING, bars, ceiling, new_figure

if TYPE_CHECKING:
    from matplotlib.figure import Figure


def draw(found: Found, caption: str) -> dict[str, "Figure"]:
    """Time per direction against the worst angle, a point for each map; and bars of sequences by samples per point."""
    everyone = max(row.workers for row in found.rows)
    return {
        "maps": _draw_maps([row for row in found.rows if row.table == "maps"], everyone, caption),
        "sequences": _draw_sequences([row for row in found.rows if row.table == "sequences"], everyone, caption),
    }


def _draw_maps(rows: list[Speed], everyone: int, caption: str) -> "Figure":
    figure, axes = new_figure(caption, 9.0, 5.0)
    shown = [row for row in rows if row.distribution != "fill" and row.workers == everyone and not row.pdf]
    for i, row in enumerate(sorted(shown, key=lambda row: row.nanoseconds.median)):
        hollow = "none" if i >= 10 else "full"
        style = {"marker": "osD^v<>ph*"[i % 10], "color": f"C{i % 10}", "fillstyle": hollow, "linestyle": ""}
        axes.plot(row.nanoseconds.median, row.worst["angle"], label=short_name(row), **style)
    axes.legend(fontsize=8, frameon=False, loc="center left", bbox_to_anchor=(1.0, 0.5), title="fastest first")
    axes.set(xscale="log", yscale="log", xlabel="time per direction [ns]", ylabel="worst angle to float64 [rad]")
    axes.set_title(f"Maps, {shown[0].points:,} points x {shown[0].samples} directions, {everyone} workers")
    ceiling(axes, next(row for row in rows if row.distribution == "fill").nanoseconds.median, "NumPy's fill")
    return figure


def _draw_sequences(rows: list[Speed], everyone: int, caption: str) -> "Figure":
    figure, axes = new_figure(caption, 9.0, 5.0)
    counts = list(dict.fromkeys(row.samples for row in rows))
    names = list(dict.fromkeys(row.sequence for row in rows if row.sequence))
    for k, name in enumerate(names):
        mine = [row for row in rows if row.sequence == name and row.workers == everyone]
        places = [i + 0.13 * (k - len(names) / 2 + 0.5) for i in range(len(counts))]
        bars(axes, places, mine, sequences.get(name).colour, name)
    fills = [row.million_per_second.median for row in rows if row.distribution == "fill"]
    for i, height in enumerate(fills):
        axes.hlines(height, i - 0.45, i + 0.45, color=CEILING, label=None if i else "NumPy's fill, 1 thread")
    axes.set_xticks(range(len(counts)), [str(n) for n in counts])
    axes.set(xlabel="samples per point", ylabel="million directions per second")
    axes.set_title(f"Sequences, cosine lobe, {everyone} workers; whiskers over the middle half of the repeats")
    axes.legend(ncols=4, fontsize=9, frameon=False, loc="lower center", bbox_to_anchor=(0.5, 1.06))
    return figure
