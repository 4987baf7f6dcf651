"""`bench lobes`: time of directions of lobes that differ from point to point, beside constant lobes and Mitsuba's."""

from dataclasses import dataclass
from importlib.metadata import version
from math import hypot
from typing import Annotated, Any

import numpy as np
import typer

from warpsample.bench.record import Benchmark, Picture, Repeats, RowsByPart, Track
from warpsample.bench.reporting.tables import TableView
from warpsample.bench.rows import Spread, ToolRow, column, optional_column
from warpsample.bench.running.child import ChildJob
from warpsample.bench.running.turns import run_tools
from warpsample.bench.tools.lobes import BY_POINT, CONSTANT, LOBES, WAYS, build_surface
from warpsample.host.engine import check_workers

COUNTS = (64, 1)
"""Directions per point."""

_MOST_DEVIATION = 4.5  # standard errors; six comparisons exceed this by chance once in 20,000 runs


def _format_count(count: int) -> str:
    return f"{count} directions per point" if count > 1 else "1 direction per point"


@dataclass(frozen=True)
class LobeSpeed(ToolRow):
    """Row of `bench lobes`: time of a direction and its density, by one tool."""

    tool: str = column(
        "tool", "by point: roughness and view differ from point to point; constant: one lobe for all points", kw_only=True
    )
    lobe: str = column("lobe", kw_only=True)
    count: int = column("directions per point", show=_format_count, kw_only=True)
    nanoseconds: Spread | None = optional_column("ns per direction", "with its density")
    ratio: Spread | None = optional_column(
        "time / warpsample, by point", "time divided by that of `warpsample, by point` in the same round"
    )
    deviation: float | None = optional_column(
        "difference, standard errors", "difference of the mean cosine from `warpsample, by point`, over its standard error"
    )
    agrees: bool | None = optional_column("agrees", f"yes if the difference is at most {_MOST_DEVIATION:g} standard errors")


def build_directions(tool: str, lobe: str, points: int, count: int, workers: int) -> ChildJob:
    """Build the job that samples directions and densities of a lobe with one tool.

    The job reports the mean cosine between directions and normals, and its standard error.
    """
    surface = build_surface(points)
    work, cosines = WAYS[tool].make(lobe, surface, count, workers)

    def report() -> dict[str, Any]:
        z = cosines()
        return {"version": version(WAYS[tool].library), "mean": float(z.mean(dtype=np.float64)),
                "error": float(z.std(dtype=np.float64) / np.sqrt(z.size))}  # fmt: skip

    return ChildJob(work, report)


def measure(
    track: Track,
    *,
    points: Annotated[
        int,
        typer.Option(help="Number of points with 64 directions each; 16 times as many points have one.", min=64),
    ] = 65_536,
    repeats: Repeats = 9,
) -> RowsByPart:
    """Time each lobe with each tool, with alternating runs; return the rows."""
    cases = [(count, lobe) for count in COUNTS for lobe in LOBES]
    return {"rows": [row for case in track(cases, len(cases)) for row in compare(*case, points, repeats)]}


def compare(count: int, lobe: str, points: int, repeats: int) -> list[LobeSpeed]:
    """Time one lobe with all tools, with alternating runs."""
    points = points if count > 1 else 16 * points
    turns = run_tools(build_directions, WAYS, repeats, lobe=lobe, points=points, count=count, workers=check_workers(None))
    first = turns.reports[BY_POINT]

    def figures(tool: str) -> dict[str, Any]:
        seconds, found = turns.seconds[tool], turns.reports[tool]
        deviation = None
        if tool not in (CONSTANT, BY_POINT):
            deviation = abs(found["mean"] - first["mean"]) / hypot(found["error"], first["error"])
        return {
            "version": found["version"],
            "nanoseconds": Spread.of([1e9 * t / (points * count) for t in seconds]),
            "ratio": Spread.of_ratios(seconds, turns.seconds[BY_POINT]),
            "deviation": deviation,
            "agrees": None if deviation is None else deviation <= _MOST_DEVIATION,
        }

    return turns.rows(LobeSpeed, figures, lobe=lobe, count=count)


RECORD = Benchmark(
    name="lobes",
    summary="Directions of lobes whose roughness and view differ from point to point, beside constant ones and Mitsuba's.",
    measure=measure,
    parts={"rows": LobeSpeed},
    views=[
        TableView("rows", "Time of a direction and its density", "lobe tool", "nanoseconds ratio", across="count"),
        TableView("rows", "Check of the directions: mean cosine to the normal", "lobe tool", "deviation agrees",
                  across="count", page_rows=None, where=lambda row: row.agrees is not None),
    ],
    pictures=[Picture("lobes", "rows", "nanoseconds", y="tool", series="count", panels="lobe", log="x")],
)  # fmt: skip
