"""`bench lights`: directions towards a picture, and time to an error of the irradiance from a picture with a sun."""

from dataclasses import dataclass
from importlib.metadata import version
from math import pi
from typing import Annotated, Any

import numpy as np
import typer

from warpsample.bench.record import SEED, Benchmark, Picture, Repeats, RowsByPart, Track
from warpsample.bench.reporting.tables import TableView
from warpsample.bench.rows import Spread, ToolRow, column, optional_column
from warpsample.bench.running.child import ChildJob
from warpsample.bench.running.turns import run_tools
from warpsample.bench.scenes import sample_clear_points
from warpsample.bench.tools.lights import BOTH, COSINE, DRAWS, LIGHTS, SEEDS, build_picture
from warpsample.host.engine import check_workers

SUNS = (0.0, 0.27, 1.0, 3.0)
"""Degrees from the centre of the sun to its edge; 0 for a sky without a sun."""
RAYS = 256
"""Rays per point of the irradiance."""

_COUNT, _HEIGHT, _DEGREES = 64, 1024, 0.5  # directions per point, rows and sun of the large picture
_LIGHT_HEIGHT = 128  # rows of the picture of the irradiance
_REFERENCE_RAYS, _REFERENCE_SEED = 1 << 12, 1 << 40
_MOST_DEVIATION = 4.5  # standard errors
_MOST_APART = 0.03  # pictures of Mitsuba reach half a pixel further: 0.7 degrees


def _format_ratio(x: float) -> str:
    """Return a ratio with two digits and thousands separators."""
    return f"{x:.2g}" if x < 10.0 else f"{float(f'{x:.2g}'):,.0f}"


def _format_sun(degrees: float) -> str:
    return f"sun {degrees:g}°" if degrees else "no sun"


@dataclass(frozen=True)
class DrawSpeed(ToolRow):
    """Row of `bench lights`: directions per second towards a picture of 2048 x 1024 pixels, by one tool."""

    million_per_second: Spread | None = optional_column("million directions per second", "with their densities")
    ratio: Spread | None = optional_column("time / warpsample", "time divided by that of warpsample in the same round")
    deviation: float | None = optional_column(
        "error of mean 1 / density, standard errors",
        "difference from the exact mean, the solid angle 4 pi, divided by the standard error",
    )
    agrees: bool | None = optional_column("agrees", f"yes if this error is at most {_MOST_DEVIATION:g}")


@dataclass(frozen=True)
class IrradianceTime(ToolRow):
    """Row of `bench lights`: time and error of the irradiance of one scene from a picture, by one tool."""

    tool: str = column(
        "tool",
        "picture: directions of rays drawn by the picture's brightness; cosine: by the cosine lobe; both: rays of each",
        kw_only=True,
    )
    sun: float = column("sun", "angle from its centre to its edge", show=_format_sun, kw_only=True)
    microseconds: Spread | None = optional_column("µs per point", f"time of {RAYS} rays")
    rmse: float | None = optional_column(
        "relative RMSE", "root mean square error over the points, divided by the mean irradiance", show=".2g"
    )
    times_ours: float | None = optional_column(
        "time / warpsample",
        "time to the RMSE of `warpsample, both`, divided by its time; the RMSE falls with the root of the number of rays",
        show=_format_ratio,
    )
    apart: float | None = optional_column(
        "difference of mean irradiance", f"relative to that of `warpsample, both`, with {2 * _REFERENCE_RAYS:,} rays"
    )
    agrees: bool | None = optional_column(
        "agrees", f"yes if the difference is at most {_MOST_APART:g}; cosine is not judged, because few rays hit a sun"
    )


def build_draws(tool: str, points: int, workers: int) -> ChildJob:
    """Build the job that draws directions towards the large picture with one tool; the report judges the densities."""
    work, densities = DRAWS[tool].make(build_picture(_HEIGHT, _DEGREES), points, _COUNT, workers)

    def report() -> dict[str, Any]:
        inverse = 1.0 / densities().astype(np.float64)
        deviation = abs(inverse.mean() - 4.0 * pi) / (inverse.std() / np.sqrt(inverse.size))
        return {
            "version": version(DRAWS[tool].library),
            "deviation": float(deviation),
            "agrees": bool(deviation <= _MOST_DEVIATION),
        }

    return ChildJob(work, report)


def build_irradiance(tool: str, sun: float, points: int, workers: int) -> ChildJob:
    """Build the job that computes the irradiance of points of the city; the report has the error and a reference."""
    picture = build_picture(_LIGHT_HEIGHT, sun) if sun else np.ones((_LIGHT_HEIGHT, 2 * _LIGHT_HEIGHT), np.float32)
    mesh, at = sample_clear_points("city", points)
    run = LIGHTS[tool].make(picture, mesh, at, workers)

    def report() -> dict[str, Any]:
        reference = np.mean([run(_REFERENCE_RAYS, _REFERENCE_SEED + i) for i in range(2)], axis=0, dtype=np.float64)
        squares = [np.mean((run(RAYS, seed) - reference) ** 2) for seed in SEEDS]
        mean = float(reference.mean())
        return {"version": version(LIGHTS[tool].library), "rmse": float(np.sqrt(np.mean(squares))) / mean, "mean": mean}

    return ChildJob(lambda: run(RAYS, SEED), report)


def measure(
    track: Track,
    *,
    points: Annotated[
        int, typer.Option(help="Number of points on the city, and of normals with 64 directions times 16.", min=64)
    ] = 4096,
    repeats: Repeats = 5,
) -> RowsByPart:
    """Time directions and irradiance with alternating runs of all tools; return the rows."""
    rows: RowsByPart = {"draws": [], "irradiance": []}
    for sun in track([None, *SUNS], 1 + len(SUNS)):
        if sun is None:
            rows["draws"] += compare_draws(16 * points, repeats)
        else:
            rows["irradiance"] += compare_irradiance(sun, points, repeats)
    return rows


def compare_draws(points: int, repeats: int) -> list[DrawSpeed]:
    """Time directions towards the large picture by all tools."""
    turns = run_tools(build_draws, DRAWS, repeats, points=points, workers=check_workers(None))
    baseline = turns.seconds["warpsample"]

    def figures(tool: str) -> dict[str, Any]:
        seconds = turns.seconds[tool]
        speed = Spread.of([points * _COUNT / t / 1e6 for t in seconds])
        return {"million_per_second": speed, "ratio": Spread.of_ratios(seconds, baseline), **turns.reports[tool]}

    return turns.rows(DrawSpeed, figures)


def compare_irradiance(sun: float, points: int, repeats: int) -> list[IrradianceTime]:
    """Time the irradiance from a picture with one sun by all tools."""
    turns = run_tools(build_irradiance, LIGHTS, repeats, sun=sun, points=points, workers=check_workers(None))
    ours = turns.reports[BOTH]

    def figures(tool: str) -> dict[str, Any]:
        found, seconds = turns.reports[tool], turns.seconds[tool]
        times = Spread.of_ratios(seconds, turns.seconds[BOTH]).median * (found["rmse"] / ours["rmse"]) ** 2
        apart = abs(found["mean"] / ours["mean"] - 1.0)
        return {
            "version": found["version"],
            "microseconds": Spread.of([1e6 * t / points for t in seconds]),
            "rmse": found["rmse"],
            "times_ours": times,
            "apart": apart,
            "agrees": None if tool == COSINE else apart <= _MOST_APART,  # 8,192 rays of the cosine lobe hit a sun by luck
        }

    return turns.rows(IrradianceTime, figures, sun=sun)


_DRAWN = "million_per_second ratio deviation agrees"
_PLACE = "256 rays at each point of the city"

RECORD = Benchmark(
    name="lights",
    summary="Directions towards a picture, and irradiance from a picture with a sun, beside Mitsuba.",
    measure=measure,
    parts={"draws": DrawSpeed, "irradiance": IrradianceTime},
    views=[
        TableView("draws", "Directions towards a picture of 2048 x 1024 pixels", "tool", _DRAWN),
        TableView("irradiance", f"Irradiance from a picture, {_PLACE}", "tool", "rmse times_ours", across="sun"),
        TableView("irradiance", "Irradiance from a picture, time and check of the mean", "sun tool",
                  "microseconds apart agrees", page_rows=None),
    ],
    pictures=[Picture("lights", "irradiance", "microseconds", y="rmse", panels="sun", log="xy")],
)  # fmt: skip
