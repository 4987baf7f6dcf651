"""Pictures of benchmark results: curves whose labels are column headings."""

from collections.abc import Callable
from dataclasses import dataclass
from importlib.util import find_spec
from io import BytesIO
from math import ceil
from pathlib import Path
from textwrap import fill
from typing import TYPE_CHECKING, Any

from warpsample import sequences
from warpsample.bench.reporting.picture_parts import LABELS, TITLES, draw_bars
from warpsample.bench.reporting.tables import format_named, group_rows
from warpsample.bench.rows import Spread, format_field, get_columns
from warpsample.host.extras import missing
from warpsample.host.files import write_bytes

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

_MARKERS = "osD^v<>ph*"
_MOST_ACROSS = 5  # plots side by side


@dataclass(frozen=True)
class Picture:
    """Layout of one picture of a benchmark: the rows and fields that it shows.

    Several fields are one text, separated by blanks.

    Attributes:
        name: name of the file.
        part: part with the rows.
        x: field along the x axis, or a function of a row.
        y: fields along the y axis, one plot each; text values have one line each, the first on top.
        series: fields that identify a curve.
        panels: fields; each combination of their values is a plot, side by side.
        down: fields; each combination of their values is a plot, one below the other.
        where: function that selects the rows to draw.
        log: logarithmic axes: "x", "y" or "xy".
    """

    name: str
    part: str
    x: str | Callable[[Any], Any]
    y: str
    series: str = "tool"
    panels: str = ""
    down: str = ""
    where: Callable[[list[Any]], list[Any]] = list
    log: str = ""


def check_matplotlib(argument: str) -> None:
    """Raise an error if matplotlib is missing, before a benchmark runs for minutes.

    Raises:
        ModuleNotFoundError: matplotlib is missing; the message explains how to install it.
    """
    if find_spec("matplotlib") is None:
        raise missing(f"{argument} needs matplotlib", "matplotlib")


def save_figures(figures: dict[str, "Figure"], folder: Path, source: str = "") -> list[Path]:
    """Write each figure to `folder/name.png` at 150 dots per inch, with `source` as description; return the files."""
    folder.mkdir(parents=True, exist_ok=True)
    files = [folder / f"{name}.png" for name in figures]
    for file, figure in zip(files, figures.values(), strict=True):
        picture = BytesIO()
        figure.savefig(picture, format="png", dpi=150, metadata={"Description": source})
        write_bytes(file, picture.getvalue())
    return files


def draw_figure(picture: Picture, rows: list[Any], caption: str) -> "Figure":
    """Draw the figure of a benchmark's rows: one plot for each panel, and a caption below."""
    from matplotlib.figure import Figure

    rows = [row for row in picture.where(rows) if None not in _get_values(picture, row)]
    plots = [(y, [row for row in group if row in beside])
             for group in group_rows(rows, picture.down).values() for y in picture.y.split()
             for beside in group_rows(rows, picture.panels).values()]  # fmt: skip
    panels = len(group_rows(rows, picture.panels))
    across = ceil(panels / ceil(panels / _MOST_ACROSS))
    down = ceil(len(plots) / across)
    figure = Figure(figsize=(max(7.0, 1.8 + 3.2 * across), 0.8 + 3.0 * down), layout="constrained")
    grid = figure.subplots(down, across, squeeze=False, sharex="col", sharey="row")
    for axes in grid.ravel()[len(plots) :]:
        axes.axis("off")
    for i, (axes, (y, group)) in enumerate(zip(grid.ravel(), plots, strict=False)):
        axes.set_title(", ".join(_list_titles(picture, group)), fontsize=10)
        _draw_curves(axes, picture, group, y)
        if i % across == 0:
            axes.set_ylabel(_get_label(picture, rows, y))
        if i + across >= len(plots):  # also above an empty place
            axes.tick_params(labelbottom=True)
    for axes, *_ in grid:
        if isinstance(getattr(rows[0], plots[0][0]), str):
            axes.invert_yaxis()  # the first name on top
        elif "y" not in picture.log:
            axes.set_ylim(bottom=0.0)
    _draw_legend(figure, grid, LABELS.get((picture.name, picture.series)))
    figure.suptitle(TITLES.get(picture.name), fontsize=12)
    x = _get_label(picture, rows, picture.x) if isinstance(picture.x, str) else ""
    figure.supxlabel("\n".join(filter(None, [x, fill(caption, int(14 * figure.get_figwidth()))])), fontsize=10)
    return figure


def _get_values(picture: Picture, row: Any) -> list[Any]:
    """Return the x value and all y values that a picture plots for one benchmark row."""
    x = picture.x(row) if callable(picture.x) else getattr(row, picture.x)
    return [x, *(getattr(row, name) for name in picture.y.split())]


def _list_titles(picture: Picture, rows: list[Any]) -> list[str]:
    names = [*picture.panels.split(), *picture.down.split()]
    return [title for row in rows[:1] for name in names if (title := format_named(row, name))]


def _get_label(picture: Picture, rows: list[Any], name: str) -> str:
    """Return the label of a field of a picture: from LABELS, or the heading of its column."""
    if (picture.name, name) in LABELS:
        return LABELS[picture.name, name]
    columns = get_columns(type(rows[0]))
    return columns[name].metadata["heading"] if name in columns else name.replace("_", " ")


def _draw_curves(axes: "Axes", picture: Picture, rows: list[Any], name: str) -> None:
    """Draw a curve through the medians of each series, with whiskers where repeats differ.

    Draw bars instead if the x values are texts.
    """
    if isinstance(_get_values(picture, rows[0])[0], str) and isinstance(getattr(rows[0], name), Spread):
        bars = {LABELS.get((picture.name, of), of): mine for (of,), mine in group_rows(rows, picture.series).items()}
        draw_bars(axes, {of: {getattr(row, picture.x): getattr(row, name) for row in mine} for of, mine in bars.items()})
        return
    for i, group in enumerate(group_rows(rows, picture.series).values()):
        label = ", ".join(format_field(group[0], field) for field in picture.series.split())
        x = [getattr(v, "median", v) for v in (_get_values(picture, row)[0] for row in group)]
        y = [getattr(v, "median", v) for v in (getattr(row, name) for row in group)]
        width = 0 if isinstance(y[0], str) else 1
        style = {"marker": _choose_marker(label, i), "markersize": 4, "linewidth": width, "label": label}
        (line,) = axes.plot(x, y, color=_choose_colour(label), fillstyle="none" if i >= len(_MARKERS) else "full", **style)
        for at, row in zip(x, group, strict=True):
            if isinstance(spread := getattr(row, name), Spread):
                axes.plot([at, at], [spread.low, spread.high], color=line.get_color(), linewidth=0.8)
    for axis in picture.log:
        getattr(axes, f"set_{axis}scale")("log")
    axes.tick_params(which="minor", labelbottom=False, labelleft=False)
    axes.grid(alpha=0.3)


def _choose_marker(label: str, number: int) -> str:
    """Return the plot marker of a sequence, the same in all pictures.

    For other labels, return the marker of the given series number.
    """
    return sequences.get(label).marker if label in sequences.names() else _MARKERS[number % len(_MARKERS)]


def _choose_colour(label: str) -> str | None:
    """Return the plot colour of a sequence, the same in all pictures; None for other labels."""
    return sequences.get(label).colour if label in sequences.names() else None


def _draw_legend(figure: "Figure", grid: Any, title: str | None) -> None:
    """Draw one legend for all plots of a figure if there is more than one curve."""
    named = {label: handle for axes in grid.ravel() for handle, label in zip(*axes.get_legend_handles_labels(), strict=True)}
    if len(named) > 1:
        figure.legend(named.values(), named, loc="outside right center", frameon=False, fontsize=10, title=title)
