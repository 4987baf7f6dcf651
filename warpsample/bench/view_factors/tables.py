"""What the benchmark of view factors says."""

from warpsample.bench.report import SPREAD, Table, digits, figure, spread
from warpsample.bench.result import Result
from warpsample.bench.view_factors.jobs import REFERENCE_RAYS
from warpsample.bench.view_factors.measuring import Factors, Found
from warpsample.bench.view_factors.tools import PAIRS

_HEADINGS = ["tool", "rays", "seconds", "/ trace", "RMSE", "times ours", "error² / due", "entries", "MB", "above"]
_REFERENCE = (
    f"The reference is `view_factors` with {REFERENCE_RAYS:,} rays a face and another seed, at 256 faces; the square "
    "error of independent rays by embreex is what is due to them, ours what our error bars say or less."
)
_TIMES = "times ours: to the same RMSE, extrapolated by each tool's rate (pyViewFactor's has none: by ours)"


def tables(result: Result) -> list[Table | str]:
    """A table for each scene and number of threads."""
    found = result.found
    parts: list[Table | str] = [f"All view factors of a mesh: {SPREAD}. {_TIMES}. MB: peak memory.", _REFERENCE]
    for case in dict.fromkeys((row.scene, row.faces, row.workers) for row in found.rows):
        mine = [row for row in found.rows if (row.scene, row.faces, row.workers) == case and row.took]
        parts.append(Table(f"{case[0]}, {case[1]:,} faces, threads: {case[2]}", _HEADINGS, [_cells(row) for row in mine]))
    return [*parts, *_in_words(found)]


def readme(result: Result) -> list[Table | str]:
    """All threads, by scene; and what pyViewFactor would take on the large one."""
    found = result.found
    most = max((row.workers for row in found.rows), default=1)
    rows = [row for row in found.rows if row.workers == most and row.took]
    scenes = {row.scene: row.faces for row in rows}
    known = {(row.tool, row.scene): row for row in rows}
    cells = [
        [label, *(_short(known.get((tool, scene))) for scene in scenes)]
        for tool, label in {row.tool: _label(row) for row in rows}.items()
    ]
    return [
        (
            f"All view factors of two boxes in one another and of two cities, {result.settings.rays:,} rays a face, {most} "
            "threads: seconds; as a multiple of `ws.trace` alone with as many rays; RMSE over all entries of 256 rows; how "
            "many times as long as ours to the same RMSE, extrapolated; and the process's peak memory:"
        ),
        Table("", ["tool", *(f"{scene.split()[0]}, {faces:,} faces" for scene, faces in scenes.items())], cells),
        " ".join([_REFERENCE, *_in_words(found)]),
    ]


def _label(row: Factors) -> str:
    return row.tool if row.version is None or row.tool.startswith(("warpsample", "ws.")) else f"{row.tool} ({row.version})"


def _short(row: Factors | None) -> str:
    if row is None or row.took is None or row.traces is None:
        return ""
    rays = "" if row.rays is None else f" ({row.rays:,} rays)"
    cost = f"{digits(row.took.median)} s{rays}; {row.traces.median:.2f}"
    if row.rmse is None or row.times_ours is None:
        return f"{digits(row.took.median)} s"
    memory = "" if row.peak_megabytes is None else f"; {row.peak_megabytes:.0f} MB"
    return f"{cost}; {row.rmse:.1e}; {digits(row.times_ours.median)}{memory}"


def _cells(row: Factors) -> list[str]:
    return [
        _label(row),
        "–" if row.rays is None else f"{row.rays:,}",
        spread(row.took),
        "–" if row.traces is None else figure(row.traces.median),
        "–" if row.rmse is None else f"{row.rmse:.1e}",
        "–" if row.times_ours is None else figure(row.times_ours.median),
        figure(row.due),
        "–" if row.entries is None else f"{row.entries:,}",
        *("–" if megabytes is None else f"{megabytes:.0f}" for megabytes in (row.peak_megabytes, row.above)),
    ]


def _in_words(found: Found) -> list[str]:
    """What pyViewFactor would take on the largest scene, and what did not run."""
    largest = max((row.faces for row in found.rows), default=0)
    pairs = [row for row in found.rows if row.tool == PAIRS and row.took]
    told = []
    if pairs and pairs[-1].faces < largest and pairs[-1].took:
        more = (largest / pairs[-1].faces) ** 2
        told.append(
            f"On {largest:,} faces pyViewFactor, whose pairs grow with the square, would take "
            f"{digits(more * pairs[-1].took.median)} s, and {8e-9 * largest**2:.1f} GB for its matrix alone."
        )
    reasons = dict.fromkeys((row.tool, row.failure) for row in found.rows if row.failure)
    return [*told, *(f"{tool} did not run here: {failure}." for tool, failure in reasons)]
