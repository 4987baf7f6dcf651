"""What sun and sky bring to a city: its faces by the year and by the hour, and the sky above its most closed-in ground."""

from pathlib import Path
from typing import Annotated, Any, Literal

import numpy as np
import typer

import warpsample as ws
from warpsample.cli.terminal import Size, fail_plainly, show_or_save
from warpsample.host.arguments import check_integer
from warpsample.plotting import rendering
from warpsample.plotting.scenes import Panel
from warpsample.plotting.sky_scene import SkyMap, sun_and_sky
from warpsample.radiation.weather.weather import Weather, read_weather

NORTH = {"x": (0, 0, 1), "y": (0, 0, -1), "z": (0, 1, 0)}  # by the axis that points up
PATHS = ("12-21", "03-21", "06-21")


def closed_in(points: ws.SurfacePoints, shares: np.ndarray, up: np.ndarray) -> int:
    """The row of the point that sees the least sky, of those that look up."""
    level = points.normal.astype(np.float64) @ up > 0.9
    return int(np.argmin(np.where(level, shares.sum(axis=1, dtype=np.float64), np.inf)))


def angles(weather: Weather) -> np.ndarray:
    """(T, 2) altitude and azimuth of the sun, in degrees."""
    return np.degrees(np.stack([weather.sun_altitude, weather.sun_azimuth], axis=1))


def sky_map(matrix: ws.SkyMatrix, row: int, weather: Any, day: str) -> SkyMap:
    """The sky of a point, the sun's paths over it, and where the sun is in the hours of a day."""
    paths = {date: angles(read_weather(weather, (date, date))) for date in PATHS}
    paths = {date: path[path[:, 0] > 0.0] for date, path in paths.items()}
    patches = matrix.patches
    return SkyMap(patches.altitudes, patches.azimuths, matrix.value[row], paths, angles(read_weather(weather, (day, day))))


@fail_plainly(count="--samples", period="--day")
def main(
    mesh: Annotated[Path, typer.Argument(help="Mesh file, or courtyard, an example.")] = Path("courtyard"),
    weather: Annotated[Path, typer.Option(help="A year, .epw, or athens, an example.")] = Path("athens"),
    day: Annotated[str, typer.Option(help="The day that the slider goes through.")] = "06-21",
    hour: Annotated[int, typer.Option(help="The hour that is shown first, 0 to 23.")] = 9,
    samples: Annotated[int, typer.Option(help="Rays of each face.")] = 256,
    seed: Annotated[int, typer.Option(help="Seed of the rays.")] = 0,
    up: Annotated[Literal["x", "y", "z"], typer.Option(help="The mesh's axis that points up.")] = "z",
    screenshot: Annotated[
        Path | None, typer.Option(help="No window, but a file: .png, or .html to turn in a browser.")
    ] = None,
    size: Size = (1800, 680),
) -> None:
    """Show the irradiation of a year at a mesh's faces, that of an hour, and the sky of one point with the sun's paths."""
    rendering.check_output(screenshot, rendering.SCENE_SUFFIXES, mesh, weather)
    rendering.check_size(size, (900, 340))
    check_integer(hour, "--hour", 0, 23)
    rendering.check_rendering()
    surface, axes = ws.load_mesh(mesh), {"up": rendering.AXES[up], "north": NORTH[up]}
    points = ws.face_centers(surface)
    year = ws.irradiation(surface, points, weather, count=samples, seed=seed, **axes)
    hours = ws.irradiation(surface, points, weather, period=(day, day), count=samples, seed=seed, series=True, **axes)
    matrix = ws.sky_matrix(surface, points, samples, patches="reinhart2", seed=seed, **axes)
    row = closed_in(points, matrix.value, np.array(axes["up"]))
    high = rendering.round_ticks(float(year.value.max()), 5)[-1]
    error = np.sqrt(np.mean(np.square(year.standard_error)))
    what = f"{len(points):,} faces; {year.value.mean():.0f} kWh/m2 on average; RMS standard error {error:.2g}; seed {seed}"
    plotter = sun_and_sky(
        (surface.vertices, surface.faces),
        Panel(year.value, "A year, kWh/m2", "inferno", high),
        hours=hours.value.T,
        hour=hour,
        sky=sky_map(matrix, row, weather, day),
        point=points.position[row],
        captions=(what, lambda now: f"{day}, {now} to {now + 1} h, W/m2"),
        up=up,
        off_screen=screenshot is not None,
        size=size,
    )
    show_or_save(plotter, screenshot, what)


if __name__ == "__main__":
    typer.run(main)
