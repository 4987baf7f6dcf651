"""The tables as pictures: work against precision, tools as bars, cost against size. Draws what it is given."""

from collections.abc import Sequence
from io import BytesIO
from pathlib import Path
from typing import TYPE_CHECKING, Any

from warpsample import sequences
from warpsample.bench import directions, error, peers, rays, scaling, visibility
from warpsample.bench.directions import short_name
from warpsample.host.files import write_bytes

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

_OURS, _THEIRS, _CEILING = "#2f6690", "#b9b4a7", "black"
_TRACERS = {"wide": _OURS, "wp.Mesh": "#5b8e3e", "Embree": "#d1495b", "Open3D": _THEIRS}


def check_drawing() -> None:
    """Whether there is matplotlib, before hours of work.

    Raises:
        ModuleNotFoundError: says how to install it.
    """
    try:
        import matplotlib  # noqa: F401, ICN001, PLC0415
    except ModuleNotFoundError:
        raise ModuleNotFoundError("--plot needs matplotlib: pip install matplotlib") from None


def save(figures: dict[str, "Figure"], folder: Path) -> list[Path]:
    """Writes each as `folder/name.png`, 150 dots an inch; returns the files."""
    folder.mkdir(parents=True, exist_ok=True)
    files = [folder / f"{name}.png" for name in figures]
    for file, figure in zip(files, figures.values(), strict=True):
        picture = BytesIO()
        figure.savefig(picture, format="png", dpi=150)
        write_bytes(file, picture.getvalue())
    return files


def draw_directions(rows: list[directions.Row], caption: str) -> dict[str, "Figure"]:
    """Time per direction against worst angle, a point to each map; and bars of sequences by samples per point."""
    samplers = [row for row in rows if row.distribution != "fill"]
    everyone = max(row.workers for row in samplers)
    maps, axes = _figure(caption, 9.0, 5.0)
    shown = [row for row in samplers if row.table == "maps" and row.workers == everyone and not row.pdf]
    for i, row in enumerate(sorted(shown, key=lambda row: row.nanoseconds.median)):
        hollow = "none" if i >= 10 else "full"
        style = {"marker": "osD^v<>ph*"[i % 10], "color": f"C{i % 10}", "fillstyle": hollow, "linestyle": ""}
        axes.plot(row.nanoseconds.median, row.worst["angle"], label=short_name(row.distribution), **style)
    axes.legend(fontsize=7, frameon=False, loc="center left", bbox_to_anchor=(1.0, 0.5), title="by time")
    axes.set(xscale="log", yscale="log", xlabel="time per direction [ns]", ylabel="worst angle to float64 [rad]")
    axes.set_title(f"Maps, {shown[0].points:,} x {shown[0].samples}, {everyone} workers")
    fill = next(row for row in rows if row.table == "maps" and row.distribution == "fill")
    _ceiling(axes, fill.nanoseconds.median, "NumPy's fill")

    streams, axes = _figure(caption, 9.0, 5.0)
    chosen = [row for row in rows if row.table == "sequences" and row.workers in (everyone, 1)]
    counts = list(dict.fromkeys(row.samples for row in chosen))
    names = list(dict.fromkeys(row.sequence for row in chosen if row.sequence))
    for k, name in enumerate(names):
        mine = [row for row in chosen if row.sequence == name and row.workers == everyone]
        places = [i + 0.13 * (k - len(names) / 2 + 0.5) for i in range(len(counts))]
        _bars(axes, places, mine, sequences.get(name).colour, name)
    fills = [row.million_per_second.median for row in chosen if row.distribution == "fill"]
    for i, height in enumerate(fills):
        axes.hlines(height, i - 0.45, i + 0.45, color=_CEILING, label=None if i else "NumPy's fill, 1 thread")
    axes.set_xticks(range(len(counts)), [str(n) for n in counts])
    axes.set(xlabel="samples per point", ylabel="million directions per second")
    axes.set_title(f"Sequences, cosine lobe, {everyone} workers; bars to the middle half of the repeats")
    axes.legend(ncols=4, fontsize=8, frameon=False, loc="lower center", bbox_to_anchor=(0.5, 1.06))
    return {"maps": maps, "sequences": streams}


def draw_error(curves: list[error.Curve], caption: str) -> dict[str, "Figure"]:
    """RMSE against wall time in log-log, a plot to each integrand."""
    from matplotlib.figure import Figure  # noqa: PLC0415

    names = list(dict.fromkeys(curve.integrand for curve in curves))
    figure = Figure(figsize=(12.0, 6.5), layout="constrained")
    grid = figure.subplots(2, -(-len(names) // 2), squeeze=False).ravel()
    for axes, name in zip(grid, names, strict=False):
        for curve in (c for c in curves if c.integrand == name):
            times, errors = zip(*((p.microseconds.median, p.rmse) for p in curve.points), strict=True)
            axes.loglog(times, errors, "o-", color=sequences.get(curve.sequence).colour, markersize=3, label=curve.sequence)
        axes.set_title(f"{name} ({curve.kind})", fontsize=10)
        axes.grid(alpha=0.3)
    for axes in grid[len(names) :]:
        axes.axis("off")
    handles, labels = grid[0].get_legend_handles_labels()
    grid[-1].legend(handles, labels, frameon=False, loc="center") if len(names) < len(grid) else grid[0].legend()
    figure.supxlabel(f"wall time of one estimate [µs]\n{caption}", fontsize=9)
    figure.supylabel("RMSE")
    return {"error": figure}


def draw_peers(rows: list[peers.Row], caption: str) -> dict[str, "Figure"]:
    """Bars of speed, with the ratio of ours to each and the ceiling."""
    figures = {}
    for job in dict.fromkeys(row.job for row in rows):
        ran = [row for row in rows if row.job == job and row.million_per_second is not None]
        bars = [row for row in ran if row.peer != "fill"]
        figure, axes = _figure(caption, 9.0, 1.6 + 0.35 * len(bars))
        for i, row in enumerate(reversed(bars)):
            speed = row.million_per_second
            axes.barh(i, speed.median, color=_OURS if row.peer.startswith("warpsample") else _THEIRS)
            axes.plot([speed.low, speed.high], [i, i], color="black", linewidth=1)
            told = f" {speed.median:.3g}"
            if row.ours is not None and not row.peer.startswith("warpsample"):
                told += f", ours {row.ours.median:.2g} times"
            axes.annotate(told, (speed.high, i), va="center", fontsize=8)
        axes.set_yticks(range(len(bars)), [f"{row.peer} ({row.threads})" for row in reversed(bars)], fontsize=8)
        axes.set(xscale="log", xlabel="million per second")
        axes.margins(x=0.15)
        axes.set_title(f"{job}, tool (threads); ours: {peers.OURS[job]}", fontsize=10)
        for row in ran:
            if row.peer == "fill":
                _ceiling(axes, row.million_per_second.median, "NumPy's fill")
        figures[f"peers_{job}"] = figure
    return figures


def draw_scaling(rows: list[scaling.Row], caption: str) -> dict[str, "Figure"]:
    """Cost per direction and peak memory against points, samples and workers."""
    from matplotlib.figure import Figure  # noqa: PLC0415

    figure = Figure(figsize=(12.0, 5.5), layout="constrained")
    names = list(dict.fromkeys(row.axis for row in rows))
    grid = figure.subplots(2, len(names), sharex="col", squeeze=False)
    for axis, (above, below) in zip(names, grid.T, strict=True):
        mine = [row for row in rows if row.axis == axis]
        x = [getattr(row, axis) for row in mine]
        low, high = [row.nanoseconds.low for row in mine], [row.nanoseconds.high for row in mine]
        above.fill_between(x, low, high, color=_OURS, alpha=0.25)
        above.plot(x, [row.nanoseconds.median for row in mine], "o-", color=_OURS)
        below.plot(x, [row.peak_megabytes or 0.0 for row in mine], "o-", color=_THEIRS)
        above.set_title(f"by {axis}")
        below.set_xlabel(axis)
        for axes in (above, below):
            axes.set_xscale("log", base=2 if x[-1] < 1000 else 10)
            axes.set_ylim(0.0, 1.1 * axes.get_ylim()[1])
            axes.grid(alpha=0.3)
    grid[0][0].set_ylabel("time per direction [ns]")
    grid[1][0].set_ylabel("peak memory [MB]")
    figure.supxlabel(caption, fontsize=9)
    return {"scaling": figure}


def draw_rays(rows: list[rays.Row], caption: str) -> dict[str, "Figure"]:
    """Bars of rays a second on one thread, a plot to each scene and query, a group to each kind of rays."""
    from matplotlib.figure import Figure  # noqa: PLC0415

    scenes = list(dict.fromkeys((row.scene, row.triangles) for row in rows))
    tools, kinds = (list(dict.fromkeys(getattr(row, name) for row in rows)) for name in ("tool", "kind"))
    figure = Figure(figsize=(3.0 * len(scenes) + 1.0, 6.5), layout="constrained")
    grid = figure.subplots(2, len(scenes), sharey="row", squeeze=False)
    for axes_of, any_hit in zip(grid, (True, False), strict=True):
        for axes, (scene, triangles) in zip(axes_of, scenes, strict=True):
            for k, tool in enumerate(tools):
                mine = [r for r in rows if (r.scene, r.any_hit, r.tool, r.workers) == (scene, any_hit, tool, 1)]
                places = [i + 0.2 * (k - len(tools) / 2 + 0.5) for i in range(len(mine))]
                _bars(axes, places, mine, _TRACERS[tool], tool, 0.18)
            axes.set_xticks(range(len(kinds)), kinds, fontsize=8)
            axes.set_title(f"{scene.split(',')[0]}, {triangles:,} triangles", fontsize=9)
        axes_of[0].set_ylabel(f"{'any' if any_hit else 'nearest'} hit, million rays a second")
    figure.legend(*grid[0][0].get_legend_handles_labels(), loc="outside upper center", ncols=4, frameon=False)
    figure.supxlabel(f"one thread; bars to the middle half of the repeats\n{caption}", fontsize=8)
    return {"rays": figure}


def draw_visibility(rows: list[visibility.Row], caption: str) -> dict[str, "Figure"]:
    """Bars of the time to an RMSE, a plot to each scene and RMSE, with how many times ours it is."""
    from matplotlib.figure import Figure  # noqa: PLC0415

    ran = [row for row in rows if row.microseconds is not None and not row.open_points]
    scenes, targets = (list(dict.fromkeys(getattr(row, name) for row in ran)) for name in ("scene", "target"))
    figure = Figure(figsize=(4.5 * len(scenes) + 1.0, 6.0), layout="constrained")
    grid = figure.subplots(len(targets), len(scenes), squeeze=False, sharex=True)
    for axes_of, target in zip(grid, targets, strict=True):
        for axes, scene in zip(axes_of, scenes, strict=True):
            mine = [row for row in ran if (row.scene, row.target) == (scene, target)][::-1]
            for i, row in enumerate(mine):
                x = row.microseconds.median
                axes.barh(i, x, color=_OURS if row.tool.startswith("warpsample") else _THEIRS)
                told = f" {x:,.0f}" if x >= 100.0 else f" {x:.3g}"
                told += f", {row.times_ours.median:.3g} times" if row.tool != "warpsample" else ""
                axes.annotate(told, (x, i), va="center", fontsize=8)
            axes.set_yticks(range(len(mine)), [row.tool for row in mine], fontsize=8)
            axes.set(xscale="log", title=f"{scene}, to an RMSE of {target:g}")
            axes.margins(x=0.8)  # room for what is told
    figure.supxlabel(f"time of a point's ambient occlusion [µs]\n{caption}", fontsize=9)
    return {"visibility": figure}


def _figure(caption: str, width: float, height: float) -> tuple["Figure", "Axes"]:
    from matplotlib.figure import Figure  # noqa: PLC0415

    figure = Figure(figsize=(width, height), layout="constrained")
    figure.supxlabel(caption, fontsize=8)
    return figure, figure.subplots()


def _bars(axes: "Axes", places: Sequence[float], rows: Sequence[Any], colour: str, label: str, width: float = 0.12) -> None:
    axes.bar(places, [row.million_per_second.median for row in rows], width=width, color=colour, label=label)
    for x, row in zip(places, rows, strict=True):
        axes.plot([x, x], [row.million_per_second.low, row.million_per_second.high], color="black", linewidth=0.8)


def _ceiling(axes: "Axes", x: float, label: str) -> None:
    axes.axvline(x, color=_CEILING, linestyle="--", linewidth=1)
    axes.annotate(
        f"{label} ", (x, 0.02), xycoords=("data", "axes fraction"), rotation=90, ha="right", fontsize=8, color=_CEILING
    )
