"""What the benchmarks' pictures share. They draw what they are given."""

from collections.abc import Sequence
from io import BytesIO
from pathlib import Path
from typing import TYPE_CHECKING, Any

from warpsample.bench.timing import Spread
from warpsample.host.files import write_bytes

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

OURS, THEIRS, CEILING = "#2f6690", "#8f8878", "black"


def check_drawing(argument: str) -> None:
    """Whether there is matplotlib, before minutes of work.

    Raises:
        ModuleNotFoundError: says how to install it.
    """
    try:
        import matplotlib  # noqa: F401, ICN001, PLC0415
    except ModuleNotFoundError:
        raise ModuleNotFoundError(f"{argument} needs matplotlib: pip install matplotlib") from None


def save(figures: dict[str, "Figure"], folder: Path, source: str = "") -> list[Path]:
    """Writes each as `folder/name.png`, 150 dots an inch, with `source` as its description; returns the files."""
    folder.mkdir(parents=True, exist_ok=True)
    files = [folder / f"{name}.png" for name in figures]
    for file, figure in zip(files, figures.values(), strict=True):
        picture = BytesIO()
        figure.savefig(picture, format="png", dpi=150, metadata={"Description": source})
        write_bytes(file, picture.getvalue())
    return files


def new_figure(caption: str, width: float, height: float) -> tuple["Figure", "Axes"]:
    """One plot, with a caption below."""
    from matplotlib.figure import Figure  # noqa: PLC0415

    figure = Figure(figsize=(width, height), layout="constrained")
    figure.supxlabel(caption, fontsize=9)
    return figure, figure.subplots()


def bars(axes: "Axes", places: Sequence[float], rows: Sequence[Any], colour: str, label: str, width: float = 0.12) -> None:
    """Of `million_per_second`, from 0 on, with whiskers over the middle half."""
    axes.bar(places, [row.million_per_second.median for row in rows], width=width, color=colour, label=label)
    for x, row in zip(places, rows, strict=True):
        axes.plot([x, x], [row.million_per_second.low, row.million_per_second.high], color="black", linewidth=0.8)


def dots(axes: "Axes", names: Sequence[str], found: Sequence[Spread], colours: Sequence[str], told: Sequence[str]) -> None:
    """A dot for each median on a logarithmic axis, the first on top, with whiskers over the middle half and a text."""
    places = range(len(names))[::-1]
    for y, spread, colour in zip(places, found, colours, strict=True):
        axes.plot([spread.low, spread.high], [y, y], color=colour, linewidth=1.2)
        axes.plot(spread.median, y, "o", color=colour, markersize=7)
    axes.set_yticks(places, names, fontsize=9)
    axes.set_ylim(-0.6, len(names) - 0.4)
    axes.grid(axis="x", alpha=0.3)
    axes.grid(axis="y", alpha=0.3, linestyle=":")
    log_ticks(axes, [s.low for s in found], [s.high for s in found])
    for y, spread, text in zip(places, found, told, strict=True):
        _tell(axes, spread, y, text)


def _tell(axes: "Axes", spread: Spread, y: float, text: str) -> None:
    """Writes a text on the side of a dot where there is more room."""
    share = axes.transAxes.inverted().transform(axes.transData.transform((spread.median, y)))[0]
    x, away, side = (spread.high, 8, "left") if share < 0.6 else (spread.low, -8, "right")
    axes.annotate(text, (x, y), (away, 0), textcoords="offset points", va="center", ha=side, fontsize=9)


def log_ticks(axes: "Axes", low: Sequence[float], high: Sequence[float]) -> None:
    """A logarithmic x axis between whole decades, with ticks at 1, 10, 100 in plain figures; of many, every other."""
    from math import ceil, floor, log10  # noqa: PLC0415

    first, last = floor(log10(min(low))), ceil(log10(max(high)) + 1.2)  # room for what is told beside the last dot
    axes.set_xscale("log")
    axes.set_xlim(10.0**first, 10.0**last)
    ticks = [10.0**k for k in range(first, last + 1)]
    apart = 2 if len(ticks) > 4 else 1
    axes.set_xticks(ticks, ["" if i % apart else f"{tick:,.12g}" for i, tick in enumerate(ticks)])


def ceiling(axes: "Axes", x: float, label: str) -> None:
    """A dashed line that nothing can pass."""
    axes.axvline(x, color=CEILING, linestyle="--", linewidth=1)
    axes.annotate(
        f"{label} ", (x, 0.02), xycoords=("data", "axes fraction"), rotation=90, ha="right", fontsize=9, color=CEILING
    )
