"""The tables of times to an RMSE."""

from warpsample.bench.report import SPREAD, Table, digits, figure, spread
from warpsample.bench.result import Result
from warpsample.bench.visibility.measuring import Found, Many, TimeToError
from warpsample.bench.visibility.reference import Confirmation


def tables(result: Result) -> list[Table | str]:
    """A table for each scene and RMSE, a line about many points, and one about the reference of each scene."""
    found = result.found
    parts: list[Table | str] = [
        f"Ambient occlusion, its rays and everything before them, to an RMSE over all points: {SPREAD}."
    ]
    for case in dict.fromkeys((row.scene, row.target, row.open_points) for row in found.rows):
        mine = [row for row in found.rows if (row.scene, row.target, row.open_points) == case and row.points]
        if mine:
            parts.append(_of_case(mine))
    failures = dict.fromkeys((row.tool, row.failure) for row in found.rows if row.failure)
    return [
        *parts,
        *map(_many_in_words, found.many),
        *_confirmations(found.confirmed),
        *(f"{tool}: {failure}; pip install mitsuba embreex open3d" for tool, failure in failures),
    ]


_FOOT_OF_A_WALL = (
    "In the city one of the points is nearer to the foot of a wall than 10⁻⁶ of the mesh's size. The peers take it to be "
    "inside of the building, we in front of it (see `ambient_occlusion`). This point alone gives the peers an RMSE that "
    "hardly falls below 0.005: their times to 0.003 there are of this definition, not of their speed."
)


def readme(result: Result) -> list[Table | str]:
    """The tools by scene and RMSE; points under an open sky and many points in words; and what the reference is."""
    found = result.found
    rows = [row for row in found.rows if not row.open_points and row.microseconds]
    by_case = {(row.tool, row.scene, row.target): row for row in rows}
    cases = list(dict.fromkeys((row.scene, row.target) for row in rows))
    scenes = list(dict.fromkeys(scene for scene, _ in cases))
    cases.sort(key=lambda case: scenes.index(case[0]))
    tools = {row.tool: row for row in rows}
    cells = [[_label(row), *(_cell(by_case.get((tool, *case))) for case in cases)] for tool, row in tools.items()]
    return [
        (
            f"Microseconds of a point's ambient occlusion, from the mesh's tree on, to an RMSE over "
            f"{result.settings.points:,} points; after it how many times ours that is, for ours the rays cast of those "
            "asked for. The peers trace independent cosine directions (NumPy's; Mitsuba its own, in one kernel). Every tool "
            "uses all cores:"
        ),
        Table("", ["tool", *(f"{scene}, to {target:g}" for scene, target in cases)], cells),
        *([_FOOT_OF_A_WALL] if "city" in scenes else []),
        *_confirmations(found.confirmed),
        " ".join([*_open_in_words(found), *map(_many_in_words, found.many), *_missing(found)]),
    ]


def time_to(found: Found, tool: str, scene: str, target: float) -> float | None:
    """Microseconds of a point by a tool; None if it did not run."""
    same = [r for r in found.rows if (r.tool, r.scene, r.target, r.open_points) == (tool, scene, target, False)]
    return same[0].microseconds.median if same and same[0].microseconds else None


def _of_case(rows: list[TimeToError]) -> Table:
    first = rows[0]
    cells = [
        [
            f"{row.tool} ({row.version})",
            f"{row.rays:,}",
            f"{row.cast:,.0f}",
            f"{row.rmse:.4f}",
            spread(row.microseconds),
            spread(row.times_ours),
        ]
        for row in rows
    ]
    what = "only points that see nothing but sky, rays as for all" if first.open_points else f"RMSE {first.target:g}"
    title = f"{first.scene}, {first.points:,} points, {first.workers} workers: {what}"
    return Table(title, ["tool", "rays", "cast", "RMSE", "µs per point", "times ours"], cells)


def _label(row: TimeToError) -> str:
    return row.tool if row.tool.startswith("warpsample") else f"{row.tool} ({row.version})"


def _cell(row: TimeToError | None) -> str:
    if row is None:
        return ""
    if row.tool == "warpsample":
        return f"{digits(row.microseconds.median)} ({row.cast:,.0f} of {row.rays:,})"
    return f"{digits(row.microseconds.median)}, {row.times_ours.median:.1f}"


def _confirmations(confirmed: list[Confirmation]) -> list[Table | str]:
    if not confirmed:
        return ["Embree was not at hand to confirm the reference of these errors."]
    what = (
        f"The reference of these errors is `ambient_occlusion` itself, with {confirmed[0].reference_rays:,} rays a point, "
        "Fibonacci points, our own tracer and another seed."
    )
    cells = [
        [
            c.scene + ("" if c.agrees else ", DISAGREES"),
            f"{c.points:,}",
            f"{c.embree_rays:,}",
            f"{1e5 * c.mean_difference:.1f} ± {1e5 * c.mean_error:.1f}",
            f"{c.rms:.2f}",
            f"{c.worst:.1f}",
        ]
        for c in confirmed
    ]
    headings = ["scene", "points", "rays of each", "mean difference, 10⁻⁵", "RMS, standard errors", "worst"]
    note = (
        f"{what} Embree confirms it by independent cosine rays: the differences are as large as their standard errors, "
        "so that their RMS is about 1, and none is above 5."
        if all(c.agrees for c in confirmed)
        else f"{what} Embree does NOT confirm it."
    )
    return [note, Table("The reference against Embree", headings, cells)]


def _open_in_words(found: Found) -> list[str]:
    parts = []
    for scene in dict.fromkeys(row.scene for row in found.rows if row.open_points):
        mine = {row.tool: row for row in found.rows if row.open_points and row.scene == scene}
        ours, all_rays = mine.get("warpsample"), mine.get("warpsample, skip=False")
        if ours and all_rays and all_rays.times_ours:
            times = f"{figure(all_rays.times_ours.median)} times less than without skipping"
            parts.append(f"{digits(ours.microseconds.median)} µs in the scene {scene}, {times}")
    return [f"Points that see nothing but sky take {'; '.join(parts)}."] if parts else []


def _many_in_words(many: Many) -> str:
    memory = f" and {many.peak_megabytes:,.0f} MB at most, Python, mesh and points included" if many.peak_megabytes else ""
    return (
        f"{many.points:,} points in the scene {many.scene} with {many.rays} rays each take {digits(many.seconds)} s{memory}."
    )


def _missing(found: Found) -> list[str]:
    missing = dict.fromkeys(row.tool for row in found.rows if row.failure)
    return [f"Did not run here: {', '.join(missing)}."] if missing else []
