"""Pictures of what was found: curves through the rows. Labels are the headings of the rows' columns."""

from collections.abc import Callable
from dataclasses import dataclass
from importlib.util import find_spec
from io import BytesIO
from math import ceil
from pathlib import Path
from textwrap import fill
from typing import TYPE_CHECKING, Any

from warpsample import sequences
from warpsample.bench.rows import Spread, columns, shown
from warpsample.bench.running.picture_parts import LABELS, TITLES, draw_bars
from warpsample.bench.tables import grouped, named
from warpsample.host.files import write_bytes
from warpsample.host.making import missing

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

_MARKERS = "osD^v<>ph*"
_MOST_ACROSS = 5  # plots side by side


@dataclass(frozen=True)
class Picture:
    """How rows of a part are drawn. Several fields are named in one text, with blanks between.

    Attributes:
        name: of its file.
        part: whose rows are drawn.
        x: field along the x axis, or a function of a row.
        y: fields along the y axis, a plot to each; names have a line each, the first on top.
        series: fields that name a curve.
        panels: fields; there are plots side by side for each of their values.
        down: likewise, one below the other.
        where: which rows are drawn, of all.
        log: axes that are logarithmic.
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


def check_drawing(argument: str) -> None:
    """Refuses if there is no matplotlib, before minutes of work.

    Raises:
        ModuleNotFoundError: says how to install it.
    """
    if find_spec("matplotlib") is None:
        raise missing(f"{argument} needs matplotlib", "matplotlib")


def save(figures: dict[str, "Figure"], folder: Path, source: str = "") -> list[Path]:
    """Writes each as `folder/name.png`, 150 dots an inch, with `source` as its description; returns the files."""
    folder.mkdir(parents=True, exist_ok=True)
    files = [folder / f"{name}.png" for name in figures]
    for file, figure in zip(files, figures.values(), strict=True):
        picture = BytesIO()
        figure.savefig(picture, format="png", dpi=150, metadata={"Description": source})
        write_bytes(file, picture.getvalue())
    return files


def draw(picture: Picture, rows: list[Any], caption: str) -> "Figure":
    """The figure: a plot for each panel, with a caption below."""
    from matplotlib.figure import Figure

    rows = [row for row in picture.where(rows) if None not in _values(picture, row)]
    plots = [(y, [row for row in mine if row in beside])
             for mine in grouped(rows, picture.down).values() for y in picture.y.split()
             for beside in grouped(rows, picture.panels).values()]  # fmt: skip
    panels = len(grouped(rows, picture.panels))
    across = ceil(panels / ceil(panels / _MOST_ACROSS))
    down = ceil(len(plots) / across)
    figure = Figure(figsize=(max(7.0, 1.8 + 3.2 * across), 0.8 + 3.0 * down), layout="constrained")
    grid = figure.subplots(down, across, squeeze=False, sharex="col", sharey="row")
    for axes in grid.ravel()[len(plots) :]:
        axes.axis("off")
    for i, (axes, (y, mine)) in enumerate(zip(grid.ravel(), plots, strict=False)):
        axes.set_title(", ".join(_titles(picture, mine)), fontsize=10)
        _curves(axes, picture, mine, y)
        if i % across == 0:
            axes.set_ylabel(_label(picture, rows, y))
    for axes, *_ in grid:
        if isinstance(getattr(rows[0], plots[0][0]), str):
            axes.invert_yaxis()  # the first name is on top
        elif "y" not in picture.log:
            axes.set_ylim(bottom=0.0)
    _legend(figure, grid, LABELS.get((picture.name, picture.series)))
    figure.suptitle(TITLES.get(picture.name), fontsize=12)
    x = _label(picture, rows, picture.x) if isinstance(picture.x, str) else ""
    figure.supxlabel("\n".join(filter(None, [x, fill(caption, int(14 * figure.get_figwidth()))])), fontsize=10)
    return figure


def _values(picture: Picture, row: Any) -> list[Any]:
    """What is drawn of a row: its x and each y."""
    x = picture.x(row) if callable(picture.x) else getattr(row, picture.x)
    return [x, *(getattr(row, name) for name in picture.y.split())]


def _titles(picture: Picture, rows: list[Any]) -> list[str]:
    names = [*picture.panels.split(), *picture.down.split()]
    return [told for row in rows[:1] for name in names if (told := named(row, name))]


def _label(picture: Picture, rows: list[Any], name: str) -> str:
    """Return the label of a field: from LABELS, or the heading of its column."""
    if (picture.name, name) in LABELS:
        return LABELS[picture.name, name]
    known = columns(type(rows[0]))
    return known[name].metadata["heading"] if name in known else name.replace("_", " ")


def _curves(axes: "Axes", picture: Picture, rows: list[Any], name: str) -> None:
    """Draw a curve through the medians of each series, with whiskers where there is a spread; bars over an x of texts."""
    if isinstance(_values(picture, rows[0])[0], str) and isinstance(getattr(rows[0], name), Spread):
        bars = {LABELS.get((picture.name, of), of): mine for (of,), mine in grouped(rows, picture.series).items()}
        draw_bars(axes, {of: {getattr(row, picture.x): getattr(row, name) for row in mine} for of, mine in bars.items()})
        return
    for i, mine in enumerate(grouped(rows, picture.series).values()):
        label = ", ".join(shown(mine[0], field) for field in picture.series.split())
        x = [getattr(v, "median", v) for v in (_values(picture, row)[0] for row in mine)]
        y = [getattr(v, "median", v) for v in (getattr(row, name) for row in mine)]
        width = 0 if isinstance(y[0], str) else 1
        style = {"marker": _marker(label, i), "markersize": 4, "linewidth": width, "label": label}
        (line,) = axes.plot(x, y, color=_colour(label), fillstyle="none" if i >= len(_MARKERS) else "full", **style)
        for at, row in zip(x, mine, strict=True):
            if isinstance(spread := getattr(row, name), Spread):
                axes.plot([at, at], [spread.low, spread.high], color=line.get_color(), linewidth=0.8)
    for axis in picture.log:
        getattr(axes, f"set_{axis}scale")("log")
    axes.tick_params(which="minor", labelbottom=False, labelleft=False)
    axes.grid(alpha=0.3)


def _marker(label: str, number: int) -> str:
    """Return the marker that a sequence has in all pictures, or another one for each series."""
    return sequences.get(label).marker if label in sequences.names() else _MARKERS[number % len(_MARKERS)]


def _colour(label: str) -> str | None:
    """The colour that a sequence has in all pictures; others get one after the other."""
    return sequences.get(label).colour if label in sequences.names() else None


def _legend(figure: "Figure", grid: Any, title: str | None) -> None:
    """Add one legend for all plots, if there is more than one curve."""
    named = {label: handle for axes in grid.ravel() for handle, label in zip(*axes.get_legend_handles_labels(), strict=True)}
    if len(named) > 1:
        figure.legend(named.values(), named, loc="outside right center", frameon=False, fontsize=10, title=title)
