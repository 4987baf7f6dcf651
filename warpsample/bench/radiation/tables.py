"""What the benchmark of sky and sun says."""

from collections.abc import Sequence

from warpsample.bench.radiation.measuring import RAYS, Found, Sky, Sun, Year
from warpsample.bench.radiation.sky_tools import VIEW
from warpsample.bench.report import SPREAD, Table, digits, spread
from warpsample.bench.result import Result


def tables(result: Result) -> list[Table | str]:
    """A table for each scene and number of threads, of sky and of suns; and the year."""
    found = result.found
    parts: list[Table | str] = [f"{SPREAD[0].upper()}{SPREAD[1:]}. Threads: of ours and of each tool.", _CHECKED]
    for case in dict.fromkeys((row.scene, row.workers) for row in found.sky):
        mine = [row for row in found.sky if (row.scene, row.workers) == case and row.microseconds]
        title = f"Sky matrix, {case[0]}, {RAYS:,} rays a point, {result.settings.points:,} points, threads: {case[1]}"
        parts.append(Table(title, _SKY_HEADINGS, [_sky_cells(row) for row in mine]))
    for case in dict.fromkeys((row.scene, row.workers) for row in found.sun):
        mine = [row for row in found.sun if (row.scene, row.workers) == case and row.million_pairs]
        parts.append(
            Table(f"Suns of a year, {case[0]}, threads: {case[1]}", _SUN_HEADINGS, [_sun_cells(row) for row in mine])
        )
    return [*parts, *map(_year_in_words, found.year), *_failures(found)]


_SKY_HEADINGS = ["tool", "µs per point", "/ sky_view_factor", "RMSE", "to our RMSE, times ours", "error² / spread²"]
_SUN_HEADINGS = ["tool", "million pairs a second", "/ ws.trace", "pairs that differ"]
_CHECKED = (
    "The sky's reference is `sky_matrix` itself with 65,536 rays and another seed; the mean of two runs of a right tool is "
    "no farther from it than these runs are from one another: error² / spread² is about 1. The suns' is `ws.trace`."
)


def readme(result: Result) -> list[Table | str]:
    """All threads: the sky and the suns by scene, and the year in words."""
    found = result.found
    most = max((row.workers for row in found.sky), default=1)
    sky = [row for row in found.sky if row.workers == most and row.microseconds]
    sun = [row for row in found.sun if row.workers == most and row.million_pairs]
    return [
        (
            f"A sky matrix of 145 patches by {RAYS:,} rays a point, {result.settings.points:,} points, {most} threads: "
            "microseconds of a point; as a multiple of `sky_view_factor` with as many rays; RMSE over points and patches; "
            "and how many times as long as ours a tool takes to the RMSE of ours, extrapolated by its own rate:"
        ),
        _by_scene(sky, _short_sky),
        _CHECKED,
        (
            "Which suns of a year (4,400 hourly positions) the points see: million pairs of point and sun a second, averted "
            "ones included, and the time as a multiple of that of `ws.trace` for all pairs; Mitsuba masks averted pairs, "
            "embreex gets the others alone:"
        ),
        _by_scene(sun, _short_sun),
        " ".join([*map(_year_in_words, found.year), *_failures(found)]),
    ]


def _by_scene(rows: Sequence[Sky] | Sequence[Sun], cell: object) -> Table:
    scenes = list(dict.fromkeys(row.scene for row in rows))
    tools = {row.tool: _label(row) for row in rows}
    known = {(row.tool, row.scene): cell(row) for row in rows}  # type: ignore[operator]
    return Table("", ["tool", *scenes], [[label, *(known.get((t, s), "") for s in scenes)] for t, label in tools.items()])


def _short_sky(row: Sky) -> str:
    cost = f"{digits(row.microseconds.median)}; {row.views.median:.2f}" if row.microseconds and row.views else ""
    if row.tool == VIEW or row.rmse is None or row.times_ours is None:
        return cost
    return f"{cost}; {row.rmse:.1e}; {digits(row.times_ours.median)}"


def _short_sun(row: Sun) -> str:
    return f"{digits(row.million_pairs.median)}; {row.traces.median:.2f}" if row.million_pairs and row.traces else ""


def _label(row: Sky | Sun) -> str:
    return (
        row.tool
        if row.version is None or row.tool.startswith(("warpsample", "ws.", VIEW))
        else f"{row.tool} ({row.version})"
    )


def _sky_cells(row: Sky) -> list[str]:
    return [
        _label(row),
        spread(row.microseconds),
        spread(row.views),
        "–" if row.rmse is None else f"{row.rmse:.2e}",
        spread(row.times_ours),
        "–" if row.apart is None else f"{row.apart:.2f}",
    ]


def _sun_cells(row: Sun) -> list[str]:
    return [_label(row), spread(row.million_pairs), spread(row.traces), f"{row.different:.1e}"]


def _year_in_words(year: Year) -> str:
    then = year.extrapolated()
    if then is None or year.seconds is None:
        return f"A year's irradiation: {year.failure}; pip install pvlib pyradiance."
    memory = "" if year.peak_megabytes is None else f" and {year.peak_megabytes:.0f} MB at most, Python and mesh included"
    return (
        f"A year's irradiation of {year.points:,} points of the scene {year.scene}, by the sun of each hour and 2,305 "
        f"patches, {year.workers} threads, takes {digits(year.seconds)} s{memory}, "
        f"{digits(year.fewer_seconds or 0.0)} s of it whatever the points; 100,000 points would take {digits(then)} s."
    )


def _failures(found: Found) -> list[str]:
    reasons = dict.fromkeys((row.tool, row.failure) for row in (*found.sky, *found.sun) if row.failure)
    return [f"{tool} did not run here: {failure}." for tool, failure in reasons]
