"""The tables of tools, and their pictures."""

from typing import TYPE_CHECKING

from warpsample.bench.peers.jobs import SAMPLES, TASKS
from warpsample.bench.peers.measuring import Found, Speed, ToError
from warpsample.bench.pictures import OURS, THEIRS, ceiling, dots, new_figure
from warpsample.bench.report import SPREAD, Table, digits, figure, spread
from warpsample.bench.result import Result

if TYPE_CHECKING:
    from matplotlib.figure import Figure

_TITLES = {
    "directions": f"Directions of the cosine lobe, {SAMPLES} at each normal, float32, million a second",
    "surface": "Points on a mesh, uniform by area, million a second",
}


def tables(result: Result) -> list[Table | str]:
    """A table for each task, and the times to an error."""
    parts: list[Table | str] = [f"The same task by other tools, a process each, taking turns: {SPREAD}."]
    for task in dict.fromkeys(row.task for row in result.found.rows):
        mine = [row for row in result.found.rows if row.task == task]
        cells = [
            [row.peer, row.library, str(row.threads), spread(row.million_per_second), spread(row.ours), _agreement(row)]
            for row in mine
            if row.failure is None
        ]
        parts.append(Table(_TITLES[task], ["tool", "version", "threads", "M/s", _ratio(task), "off by"], cells))
        parts += [f"{row.peer}: {row.failure}" for row in mine if row.failure is not None]
    parts.append(
        "off by: the worst of the means of seven integrals, on the mesh of three, in standard errors from the exact value"
    )
    return [*parts, *([_targets(result.found.time_to_error)] if result.found.time_to_error else [])]


def readme(result: Result) -> list[Table | str]:
    """The directions; then the times to an error and the points on a mesh in words."""
    ran = [row for row in result.found.rows if row.failure is None and row.peer != "fill"]
    missing = [row.peer for row in result.found.rows if row.failure is not None]
    shown = [row for row in ran if row.task == "directions"]
    cells = [
        [
            row.peer if row.peer.startswith("warpsample") else f"{row.peer} ({row.library.split()[-1]})",
            str(row.threads),
            spread(row.million_per_second),
            "" if row.peer.startswith("warpsample") else spread(row.ours),
        ]
        for row in shown
    ]
    agree = "agree with" if all(row.agrees for row in shown) else "do NOT all agree with"
    return [
        (
            f"{result.settings.points:,} normals × {SAMPLES}, the same task in a process each; the tools' means of the "
            f"seven integrals {agree} the exact values:"
        ),
        Table("", ["tool", "threads", "million a second", _ratio("directions")], cells),
        *map(_target_in_words, result.found.time_to_error),
        *_surface_in_words([row for row in ran if row.task == "surface"]),
        *([f"Did not run here: {', '.join(missing)}."] if missing else []),
    ]


def draw(found: Found, caption: str) -> dict[str, "Figure"]:
    """A dot for the speed of each tool, with the ratio of ours to it and the ceiling."""
    figures = {}
    for task in dict.fromkeys(row.task for row in found.rows):
        ran = [row for row in found.rows if row.task == task and row.million_per_second is not None]
        shown = [row for row in ran if row.peer != "fill"]
        figure, axes = new_figure(caption, 9.0, 1.6 + 0.35 * len(shown))
        dots(
            axes,
            [f"{row.peer} ({row.threads})" for row in shown],
            [row.million_per_second for row in shown],
            [OURS if row.peer.startswith("warpsample") else THEIRS for row in shown],
            [_told(row) for row in shown],
        )
        axes.set_xlabel("million per second")
        axes.set_title(f"{task}, tool (threads); ours: {TASKS[task].ours}", fontsize=11)
        for row in ran:
            if row.peer == "fill":
                ceiling(axes, row.million_per_second.median, "NumPy's fill")
        figures[f"peers_{task}"] = figure
    return figures


def _ratio(task: str) -> str:
    return f"{TASKS[task].ours.removeprefix('warpsample ')} / it"


def _told(row: Speed) -> str:
    speed = digits(row.million_per_second.median) if row.million_per_second else ""
    return speed if row.ours is None or row.peer.startswith("warpsample") else f"{speed}, ours {row.ours.median:.2g} times"


def _agreement(row: Speed) -> str:
    if row.worst_deviation is None:
        return "–"
    return f"{row.worst_deviation:.1f}" + ("" if row.agrees else " WRONG")


def _targets(targets: list[ToError]) -> Table:
    cells = [
        [
            t.integrand,
            f"{t.rmse:g}",
            f"{t.samples:,}",
            digits(t.microseconds.median),
            t.peer,
            f"{t.independent_samples:,.0f}",
            digits(t.peer_microseconds),
            f"{t.ratio:,.0f}",
        ]
        for t in targets
    ]
    headings = ["integrand", "RMSE", "N", "µs", "fastest other", "N", "µs", "ratio"]
    title = "Time to an RMSE at a point, sampling alone: ours by default (sobol), theirs independent"
    return Table(title, headings, cells)


def _target_in_words(t: ToError) -> str:
    return (
        f"To an RMSE of {t.rmse:g} on the {t.integrand} the default takes {t.samples:,} samples and "
        f"{digits(t.microseconds.median)} µs a point; independent samples by the fastest other tool ({t.peer}) take "
        f"{t.ratio:,.0f} times as long."
    )


def _surface_in_words(rows: list[Speed]) -> list[str]:
    ours = [row for row in rows if row.peer == TASKS["surface"].ours]
    others = [f"{figure(row.ours.median)} times as many as {row.library}" for row in rows if row not in ours and row.ours]
    return [
        f"Points on a mesh of 81,920 faces: {figure(row.million_per_second.median)} million a second"
        + (f", {' and '.join(others)}, each on its one thread." if others else ".")
        for row in ours
        if row.million_per_second
    ]
