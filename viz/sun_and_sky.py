"""Irradiation of a courtyard in a year and in an hour, and the sky above its most enclosed ground."""

from datetime import date
from pathlib import Path
from typing import Annotated, Any, Literal

import numpy as np
import typer

import warpsample as ws
from warpsample.cli.terminal import Size, fail_plainly, show_or_save
from warpsample.host.arguments import check_integer
from warpsample.plotting import rendering, style
from warpsample.plotting.panels import Panel
from warpsample.plotting.sky_scene import SkyMap, sun_and_sky
from warpsample.radiation.weather.weather import Weather, read_weather

NORTH = {"x": (0, 0, 1), "y": (0, 0, -1), "z": (0, 1, 0)}
"""Direction to the north, keyed by the name of the axis that points up."""
PATHS = ("12-21", "03-21", "06-21")
"""Days, month-day, whose paths of the sun are drawn."""


def find_enclosed(points: ws.SurfacePoints, shares: np.ndarray, up: np.ndarray) -> int:
    """Return the row, in an array of points, of the upward-facing point that sees the least sky."""
    level = points.normal.astype(np.float64) @ up > 0.9
    return int(np.argmin(np.where(level, shares.sum(axis=1, dtype=np.float64), np.inf)))


def sun_angles(weather: Weather) -> np.ndarray:
    """Return altitude and azimuth of the sun in each hour, (T, 2), in degrees."""
    return np.degrees(np.stack([weather.sun_altitude, weather.sun_azimuth], axis=1))


def name_day(day: str) -> str:
    """Convert a day such as "06-21" to words: "21 June"."""
    month, number = day.split("-")
    return f"{int(number)} {date(2000, int(month), int(number)):%B}"


def sky_map(matrix: ws.SkyMatrix, row: int, weather: Any, day: str) -> SkyMap:
    """Compute the map of the sky above one point, with the paths of the sun and the sun in the hours of a day."""
    paths = {name_day(path): sun_angles(read_weather(weather, (path, path))) for path in PATHS}
    paths = {name: path[path[:, 0] > 0.0] for name, path in paths.items()}
    patches = matrix.patches
    return SkyMap(
        patches.altitudes, patches.azimuths, matrix.value[row], paths, sun_angles(read_weather(weather, (day, day)))
    )


@fail_plainly(count="--samples", period="--day")
def main(
    mesh: Annotated[Path, typer.Argument(help="Mesh file, or courtyard, an example.")] = Path("courtyard"),
    weather: Annotated[Path, typer.Option(help="Weather of a year: an .epw file, or athens, an example.")] = Path("athens"),
    day: Annotated[str, typer.Option(help="Day of the hour that is shown, month-day.")] = "06-21",
    hour: Annotated[int, typer.Option(help="Hour that is shown first, 0 to 23.")] = 9,
    samples: Annotated[int, typer.Option(help="Number of rays per face.")] = 256,
    seed: Annotated[int, typer.Option(help="Seed of the rays.")] = 0,
    up: Annotated[Literal["x", "y", "z"], typer.Option(help="Axis of the mesh that points up.")] = "z",
    screenshot: Annotated[
        Path | None, typer.Option(help="Save to this file, .png or .html, in place of a window.", show_default=False)
    ] = None,
    size: Size = (1800, 680),
) -> None:
    """Show the irradiation of a mesh in a year and in an hour, and the sky above one point with the paths of the sun."""
    rendering.check_output(screenshot, rendering.SCENE_SUFFIXES, mesh, weather)
    rendering.check_size(size, (900, 340))
    check_integer(hour, "--hour", 0, 23)
    rendering.check_rendering()
    surface, axes = ws.load_mesh(mesh), {"up": rendering.AXES[up], "north": NORTH[up]}
    points = ws.face_centers(surface)
    year = ws.irradiation(surface, points, weather, count=samples, seed=seed, **axes)
    hours = ws.irradiation(surface, points, weather, period=(day, day), count=samples, seed=seed, series=True, **axes)
    matrix = ws.sky_matrix(surface, points, samples, patches="reinhart2", seed=seed, **axes)
    row = find_enclosed(points, matrix.value, np.array(axes["up"]))
    high = rendering.round_ticks(float(year.value.max()), 5)[-1]
    error = np.sqrt(np.mean(np.square(year.standard_error)))
    numbers = f"mean {year.value.mean():.0f} kWh/m², RMS standard error {error:.2g} kWh/m²"
    summary = (
        f"{mesh.name}: {len(points):,} faces, {samples:,} rays each; weather: {weather.stem}; year: {numbers}; seed {seed}"
    )
    plotter = sun_and_sky(
        (surface.vertices, surface.faces),
        Panel(year.value, "Sun and sky in a year", style.ENERGY, high, "irradiation of the year, kWh/m²"),
        hours=hours.value.T,
        hour=hour,
        sky=sky_map(matrix, row, weather, day),
        point=points.position[row],
        captions=(summary, lambda now: f"{name_day(day)}, {now} to {now + 1} h"),
        up=up,
        off_screen=screenshot is not None,
        size=size,
    )
    show_or_save(plotter, screenshot, summary)


if __name__ == "__main__":
    typer.run(main)
