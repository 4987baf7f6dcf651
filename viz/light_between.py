"""Light between and through faces: a courtyard with black and with reflecting faces, and the shade of a tree over a day."""

from math import sqrt
from pathlib import Path
from typing import Annotated

import numpy as np
import typer

import warpsample as ws
from warpsample.cli.terminal import FigureFile, Size, fail_plainly, show_or_save
from warpsample.plotting import rendering, style
from warpsample.plotting.map_sheet import Map, map_sheet, square_steps

DAY = ("06-21", "06-21")
LEAN = 0.7  # shift to the north per unit of height, so that walls to the south are seen
PIXELS = 320  # along a side of a map
REFLECTANCE = 0.4
MEADOW = 28.0  # side in metres
LEAVES = 0.2  # transmitted share of the light that crosses both sides of the crown
TRUNK, CROWN = ((0.3, 0.0), (0.3, 4.0)), ((0.01, 3.6), (2.5, 4.2), (3.2, 6.0), (2.2, 8.0), (0.01, 9.0))
"""(radius, height) of the rings of trunk and crown, in metres."""


def revolve(rings: tuple[tuple[float, float], ...], corners: int = 32) -> tuple[np.ndarray, np.ndarray]:
    """Return the vertices and faces of a surface of revolution about the z axis through rings."""
    turn = 2.0 * np.pi * np.arange(corners) / corners
    vertices = np.concatenate(
        [np.stack([r * np.cos(turn), r * np.sin(turn), np.full(corners, z)], axis=1) for r, z in rings]
    )
    here, there = np.arange(corners), (np.arange(corners) + 1) % corners
    bands = [corners * k for k in range(len(rings) - 1)]
    lower = [np.stack([b + here, b + there, b + corners + there], axis=1) for b in bands]
    upper = [np.stack([b + here, b + corners + there, b + corners + here], axis=1) for b in bands]
    return vertices, np.concatenate(lower + upper)


def meadow() -> ws.Mesh:
    """Return the mesh of a meadow and a tree; the crown has a transmittance."""
    half = MEADOW / 2.0
    ground = np.array([[-half, -half, 0.0], [half, -half, 0.0], [half, half, 0.0], [-half, half, 0.0]])
    parts = [(ground, np.array([[0, 1, 2], [0, 2, 3]])), revolve(TRUNK), revolve(CROWN)]
    first = np.cumsum([0] + [len(vertices) for vertices, _ in parts])
    faces = np.concatenate([faces + start for (_, faces), start in zip(parts, first, strict=False)])
    share = np.repeat([0.0, 0.0, sqrt(LEAVES)], [len(faces) for _, faces in parts])
    return ws.as_mesh((np.concatenate([vertices for vertices, _ in parts]), faces), transmittance=share)


def map_points(mesh: ws.Mesh, side: float) -> tuple[ws.SurfacePoints, np.ndarray]:
    """Return the points of a mesh that an oblique map shows, and the mask of pixels with a point, (R, R) bool.

    The map shows a square about the middle.
    """
    middle, low, high = mesh.bounds.mean(axis=0), mesh.bounds[0, 2], mesh.bounds[1, 2] + 1.0
    off = side * ((np.arange(PIXELS) + 0.5) / PIXELS - 0.5)
    right, up = np.meshgrid(middle[0] + off, middle[1] + LEAN * low - off)
    origins = np.stack([right, up - LEAN * high, np.full_like(right, high)], axis=-1).reshape(-1, 3)
    way = np.array([0.0, LEAN, -1.0]) / np.hypot(LEAN, 1.0)
    hits = ws.trace(mesh, origins, np.broadcast_to(way, origins.shape))
    face = hits.face[hits.face >= 0]
    normal = mesh.face_normals[face]
    normal = np.where((normal @ way > 0.0)[:, None], -normal, normal)
    position = origins[hits.face >= 0] + hits.distance[hits.face >= 0, None].astype(float) * way
    return ws.SurfacePoints(position, normal, face), hits.face.reshape(PIXELS, PIXELS) >= 0


def irradiation_map(mesh: ws.Mesh, points: ws.SurfacePoints, shown: np.ndarray, **options: object) -> np.ndarray:
    """Compute the irradiation of the points of a map on 21 June, (R, R), kWh/m²; NaN in pixels without a point."""
    values = np.full(shown.shape, np.nan)
    values[shown] = ws.irradiation(mesh, points, period=DAY, patches="tregenza", **options).value
    return values


def courtyards(mesh: ws.Mesh, **options: object) -> list[Map]:
    """Compute maps of the irradiation of a courtyard with black faces and with reflecting faces, in the same colours."""
    side = 1.1 * float(np.ptp(mesh.bounds[:, :2], axis=0).max())
    points, shown = map_points(mesh, side)
    values = [irradiation_map(ws.as_mesh(mesh, reflectance=rho), points, shown, **options) for rho in (0.0, REFLECTANCE)]
    span = 0.0, float(rendering.round_ticks(float(np.nanmax(values)), 5)[-1])
    titles = "Courtyard, faces reflect nothing", f"Courtyard, faces reflect {100 * REFLECTANCE:.0f} %"
    return [
        Map(value, square_steps(side / PIXELS), title, "irradiation on 21 June, kWh/m²", style.ENERGY, span)
        for value, title in zip(values, titles, strict=True)
    ]


def shade(**options: object) -> Map:
    """Compute the map of the irradiation of the ground below a tree on 21 June."""
    off = MEADOW * ((np.arange(PIXELS) + 0.5) / PIXELS - 0.5)
    x, y = np.meshgrid(off, -off)
    shown = np.hypot(x, y) > 1.05 * TRUNK[0][0]
    position = np.stack([x[shown], y[shown], np.zeros(shown.sum())], axis=1)
    points = ws.SurfacePoints(position, np.tile(np.float32([0.0, 0.0, 1.0]), (len(position), 1)))
    value = irradiation_map(meadow(), points, shown, **options)
    span = 0.0, float(rendering.round_ticks(float(np.nanmax(value)), 5)[-1])
    title = f"Shade of a tree that transmits {100 * LEAVES:.0f} %"
    return Map(value, square_steps(MEADOW / PIXELS), title, "irradiation on 21 June, kWh/m²", style.ENERGY, span)


@fail_plainly(count="--samples")
def main(
    mesh: Annotated[Path, typer.Argument(help="Mesh file in metres, or courtyard, an example.")] = Path("courtyard"),
    weather: Annotated[Path, typer.Option(help="Weather of a year: an .epw file, or athens, an example.")] = Path("athens"),
    samples: Annotated[int, typer.Option(help="Number of rays per pixel.")] = 256,
    seed: Annotated[int, typer.Option(help="Seed of the rays.")] = 0,
    screenshot: FigureFile = None,
    size: Size = (1800, 760),
) -> None:
    """Show the irradiation of a courtyard without and with reflections between its faces, and the shade of a tree."""
    rendering.check_output(screenshot, rendering.FIGURE_SUFFIXES, mesh, weather)
    rendering.check_size(size, (900, 340))
    rendering.check_rendering()
    options = {"weather": weather, "count": samples, "seed": seed}
    maps = [*courtyards(ws.load_mesh(mesh), **options), shade(**options)]
    summary = f"{mesh.name}, and a tree of 9 m; weather: {weather.stem}; {samples:,} rays per pixel; seed {seed}"
    figure = map_sheet(maps, summary)
    rendering.size_figure(figure, size)
    show_or_save(figure, screenshot, summary)


if __name__ == "__main__":
    typer.run(main)
