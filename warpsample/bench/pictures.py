"""Pictures of what was found: a dot for each row, or curves. Labels are the headings of the rows' columns."""

from collections.abc import Callable
from dataclasses import dataclass
from importlib.util import find_spec
from io import BytesIO
from itertools import zip_longest
from math import ceil, floor, log10
from pathlib import Path
from textwrap import fill
from typing import TYPE_CHECKING, Any

import numpy as np

from warpsample import sequences
from warpsample.bench.rows import Spread, columns, digits, shown
from warpsample.bench.tables import grouped, named
from warpsample.host.files import write_bytes

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

_OURS, _THEIRS = "#2f6690", "#8f8878"
_MARKERS = "osD^v<>ph*"
_MOST_ACROSS = 5  # plots side by side


@dataclass(frozen=True)
class Picture:
    """How rows of a part are drawn. Several fields are named in one text, with blanks between.

    Attributes:
        name: of its file.
        part: whose rows are drawn.
        x: field along the x axis, or a function of a row.
        y: fields along the y axis, a plot to each; without any there is a dot for each row, one below the other.
        series: fields that name a dot or a curve.
        panels: fields; there are plots side by side for each of their values.
        down: likewise, one below the other.
        where: which rows are drawn, of all.
        told: fields that are told beside a dot, after x.
        log: axes that are logarithmic, of curves.
    """

    name: str
    part: str
    x: str | Callable[[Any], Any]
    y: str = ""
    series: str = "tool"
    panels: str = ""
    down: str = ""
    where: Callable[[list[Any]], list[Any]] = list
    told: str = ""
    log: str = ""


def check_drawing(argument: str) -> None:
    """Refuses if there is no matplotlib, before minutes of work.

    Raises:
        ModuleNotFoundError: says how to install it.
    """
    if find_spec("matplotlib") is None:
        raise ModuleNotFoundError(f"{argument} needs matplotlib: pip install matplotlib")


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

    rows = [row for row in picture.where(rows) if _value(picture, row) is not None]
    plots = [(y, [row for row in mine if row in beside])
             for mine in grouped(rows, picture.down).values() for y in picture.y.split() or [""]
             for beside in grouped(rows, picture.panels).values()]  # fmt: skip
    panels = len(grouped(rows, picture.panels))
    across = ceil(panels / ceil(panels / _MOST_ACROSS))
    plots_of = [plots[i : i + across] for i in range(0, len(plots), across)]
    heights = [3.0 if picture.y else 0.7 + 0.28 * len(_names(picture, plots)) for plots in plots_of]
    figure = Figure(figsize=(max(7.0, 1.8 + 3.2 * across), 0.8 + sum(heights)), layout="constrained")
    share = {"sharex": "col" if picture.y else True, "sharey": "row"}
    grid = figure.subplots(len(plots_of), across, squeeze=False, height_ratios=heights, **share)
    if not picture.y:
        _log_ticks(grid[0][0], [_spread(picture, row) for row in rows])
    for axes_of, mine in zip(grid, plots_of, strict=True):
        for axes, (y, shown_there) in zip_longest(axes_of, mine, fillvalue=("", [])):
            axes.set_title(_title(picture, shown_there), fontsize=10)
            if picture.y:
                _curves(axes, picture, shown_there, y)
            else:
                _dots(axes, picture, shown_there, _names(picture, mine))
        if picture.y:
            axes_of[0].set_ylabel(_label(rows, mine[0][0]))
            axes_of[0].set_ylim(bottom=None if "y" in picture.log else 0.0)
    if picture.y:
        _legend(figure, grid)
    x = _label(rows, picture.x) if isinstance(picture.x, str) else ""
    figure.supxlabel("\n".join(filter(None, [x, fill(caption, int(14 * figure.get_figwidth()))])), fontsize=9)
    return figure


def _names(picture: Picture, plots: list[tuple[str, list[Any]]]) -> list[str]:
    """What the dots of some plots are called, each once."""
    return list(dict.fromkeys(_name(picture, row) for _, rows in plots for row in rows))


def _name(picture: Picture, row: Any) -> str:
    return ", ".join(shown(row, name) for name in picture.series.split())


def _title(picture: Picture, rows: list[Any]) -> str:
    names = [*picture.panels.split(), *picture.down.split()]
    return ", ".join(filter(None, (named(row, name) for row in rows[:1] for name in names)))


def _label(rows: list[Any], name: str) -> str:
    known = columns(type(rows[0]))
    return known[name].metadata["heading"] if name in known else name.replace("_", " ")


def _value(picture: Picture, row: Any) -> Any:
    return picture.x(row) if callable(picture.x) else getattr(row, picture.x)


def _spread(picture: Picture, row: Any) -> Spread:
    value = _value(picture, row)
    return value if isinstance(value, Spread) else Spread(value, value, value)


def _dots(axes: "Axes", picture: Picture, rows: list[Any], names: list[str]) -> None:
    """A dot for each median on a logarithmic axis, the first on top, with whiskers over the middle half and a text."""
    middle = np.sqrt(np.prod(axes.get_xlim()))
    for row in rows:
        name, spread = _name(picture, row), _spread(picture, row)
        y, colour = -names.index(name), _OURS if name.startswith("warpsample") else _THEIRS
        axes.plot([spread.low, spread.high], [y, y], color=colour, linewidth=1.2)
        axes.plot(spread.median, y, "o", color=colour, markersize=6)
        others = [name for name in picture.told.split() if getattr(row, name)]
        told = [f"{_label(rows, other)} {shown(row, other, digits)}" for other in others]
        x, away, side = (spread.high, 6, "left") if spread.median < middle else (spread.low, -6, "right")
        text, style = "; ".join([digits(spread.median), *told]), {"va": "center", "ha": side, "fontsize": 8}
        axes.annotate(text, (x, y), (away, 0), textcoords="offset points", **style)
    axes.set_yticks(range(0, -len(names), -1), names, fontsize=9)
    axes.set_ylim(0.4 - len(names), 0.6)
    axes.grid(alpha=0.3)


def _log_ticks(axes: "Axes", spreads: list[Spread]) -> None:
    """A logarithmic x axis between whole decades with room for a text, and ticks in plain figures."""
    axes.set_xscale("log")
    first = floor(log10(min(spread.low for spread in spreads)))
    last = max(ceil(log10(max(spread.high for spread in spreads))), first + 2)
    axes.set_xlim(10.0**first, 10.0**last)
    apart = 2 if last - first > 3 else 1
    ticks = range(first, last + 1)
    axes.set_xticks([10.0**k for k in ticks], ["" if (k - first) % apart else f"{10.0**k:,.12g}" for k in ticks])


def _curves(axes: "Axes", picture: Picture, rows: list[Any], name: str) -> None:
    """A curve through the medians of each series, with whiskers where there is a spread."""
    if not rows:
        axes.axis("off")
        return
    for i, mine in enumerate(grouped(rows, picture.series).values()):
        label = _name(picture, mine[0])
        x = [getattr(v, "median", v) for v in (_value(picture, row) for row in mine)]
        y = [getattr(v, "median", v) for v in (getattr(row, name) for row in mine)]
        style = {"marker": _MARKERS[i % len(_MARKERS)], "markersize": 4, "linewidth": 1, "label": label}
        (line,) = axes.plot(x, y, color=_colour(label), fillstyle="none" if i >= len(_MARKERS) else "full", **style)
        for at, row in zip(x, mine, strict=True):
            if isinstance(spread := getattr(row, name), Spread):
                axes.plot([at, at], [spread.low, spread.high], color=line.get_color(), linewidth=0.8)
    for axis in picture.log:
        getattr(axes, f"set_{axis}scale")("log")
    axes.tick_params(which="minor", labelbottom=False, labelleft=False)
    axes.grid(alpha=0.3)


def _colour(label: str) -> str | None:
    """The colour that a sequence has in all pictures; others get one after the other."""
    return sequences.get(label).colour if label in sequences.names() else None


def _legend(figure: "Figure", grid: Any) -> None:
    """One legend for all plots, if there is more than one curve."""
    named = {label: handle for axes in grid.ravel() for handle, label in zip(*axes.get_legend_handles_labels(), strict=True)}
    if len(named) > 1:
        figure.legend(named.values(), named, loc="outside right center", frameon=False, fontsize=8)
