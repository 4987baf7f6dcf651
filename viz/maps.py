"""Maps of terrain and of a city: heights, visible sky, and a year's irradiation of real buildings."""

from pathlib import Path
from typing import Annotated

import numpy as np
import typer

import warpsample as ws
from warpsample.cli.terminal import FigureFile, Size, fail_plainly, show_or_save
from warpsample.plotting import rendering, style
from warpsample.plotting.map_sheet import Map, map_sheet, square_steps

HERE = Path(__file__).parent
HILLS = HERE / "data" / "tm1_564_146.tif"
TOWN = HERE.parent / "tests" / "city" / "data" / "3dbag_901.city.jsonl"
LEAN = 0.7  # shift to the north per metre of height, in metres, so that walls to the south are seen
PIXELS = 1200  # along a side of the map of buildings


def hills(path: Path, samples: int, seed: int) -> list[Map]:
    """Compute two maps of a raster: the heights, and the fraction of the sky that is visible from each cell."""
    from warpsample import rasters  # noqa: PLC0415  (an import error names the extra)

    surface = rasters.surface(path)
    found = rasters.visible_sky(path, samples, seed=seed)
    height, steps, north = surface.grid.height, surface.grid.steps, surface.north[:2]
    low = float(np.floor(20.0 * np.nanquantile(found.value, 0.005)) / 20.0)
    span = (float(np.nanmin(height)), float(np.nanmax(height)))
    return [
        Map(height, steps, "Terrain", "height, m", "viridis", span, north),
        Map(
            found.value.to_numpy(),
            steps,
            "Visible sky of each cell",
            "visible share of the sky",
            style.OPENNESS,
            (low, 1.0),
            north,
        ),
    ]


def town(path: Path, weather: Path, side: float, seed: int) -> Map:
    """Compute a map of the irradiation of a year on buildings, averaged over each roof and each wall.

    The map shows a square about the middle building.
    """
    city = ws.load_city(path, split=True)
    points = city.points(seed=seed)
    year = ws.irradiation(city.mesh, points, weather, seed=seed)
    values, _, _ = city.surface_means(year, points=points)
    surface = seen_from_above(city.mesh, city.surface, side)
    shown = np.where(surface < 0, np.nan, values[surface])
    high = float(rendering.round_ticks(float(np.nanmax(values)), 5)[-1])
    title, label = (
        "Sun and sky in a year, roofs and walls",
        f"irradiation of the year, kWh/m²; weather: {weather.stem}",
    )
    return Map(shown, square_steps(side / PIXELS), title, label, style.ENERGY, (0.0, high))


def seen_from_above(mesh: ws.Mesh, part: np.ndarray, side: float) -> np.ndarray:
    """Return the number of the mesh part that each pixel of an oblique map shows, (R, R); -1 for no face."""
    middle = np.median(mesh.vertices[mesh.faces].mean(axis=1), axis=0)
    high = mesh.vertices[:, 2].max() + 1.0
    off = side * ((np.arange(PIXELS) + 0.5) / PIXELS - 0.5)
    right, up = np.meshgrid(middle[0] + off, middle[1] + LEAN * middle[2] - off)
    origins = np.stack([right, up - LEAN * high, np.full_like(right, high)], axis=-1).reshape(-1, 3)
    face = ws.trace(mesh, origins, np.broadcast_to([0.0, LEAN, -1.0], origins.shape)).face
    return np.where(face < 0, -1, part[face]).reshape(PIXELS, PIXELS)


@fail_plainly(count="--samples")
def main(
    terrain: Annotated[
        Path, typer.Option(help="Raster of heights. Default: a hillside in Slovenia.", show_default=False)
    ] = HILLS,
    city: Annotated[
        Path, typer.Option(help="CityJSON file. Default: 52 buildings in the Netherlands.", show_default=False)
    ] = TOWN,
    weather: Annotated[Path, typer.Option(help="Weather of a year: an .epw file, or athens, an example.")] = Path("athens"),
    side: Annotated[float, typer.Option(help="Width of the map of buildings in metres.", min=1.0)] = 170.0,
    samples: Annotated[int, typer.Option(help="Number of rays per cell of the terrain.")] = 256,
    seed: Annotated[int, typer.Option(help="Seed of the rays.")] = 0,
    screenshot: FigureFile = None,
    size: Size = (1800, 760),
) -> None:
    """Show maps of terrain heights, of the visible sky of the terrain, and of a year's irradiation of buildings."""
    rendering.check_output(screenshot, rendering.FIGURE_SUFFIXES, terrain, city, weather)
    rendering.check_size(size, (900, 340))
    rendering.check_rendering()
    maps = [*hills(terrain, samples, seed), town(city, weather, side, seed)]
    summary = f"{terrain.name}, {samples:,} rays per cell; {city.name}; seed {seed}"
    figure = map_sheet(maps, summary)
    rendering.size_figure(figure, size)
    show_or_save(figure, screenshot, summary)


if __name__ == "__main__":
    typer.run(main)
