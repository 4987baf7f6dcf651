"""Light between faces and through them: a courtyard that is black, and one that reflects, and a tree's shade over a day."""

from math import sqrt
from pathlib import Path
from typing import Annotated

import numpy as np
import typer

import warpsample as ws
from warpsample.cli.terminal import FigureFile, Size, fail_plainly, show_or_save
from warpsample.plotting import rendering
from warpsample.plotting.map_sheet import Map, map_sheet

DAY = ("06-21", "06-21")
LEAN = 0.7  # units to the north by which what is a unit higher is drawn, so that walls to the south are seen
PIXELS = 320  # along a side of a map
REFLECTANCE = 0.4
MEADOW = 28.0  # metres along its sides
LEAVES = 0.2  # of the light passes the crown, whose two sides it crosses
TRUNK, CROWN = ((0.3, 0.0), (0.3, 4.0)), ((0.01, 3.6), (2.5, 4.2), (3.2, 6.0), (2.2, 8.0), (0.01, 9.0))
"""(radius, height) of rings, in metres."""


def turned(rings: tuple[tuple[float, float], ...], corners: int = 32) -> tuple[np.ndarray, np.ndarray]:
    """(vertices, faces) of a body between rings about the z axis."""
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
    """A meadow and a tree."""
    half = MEADOW / 2.0
    ground = np.array([[-half, -half, 0.0], [half, -half, 0.0], [half, half, 0.0], [-half, half, 0.0]])
    parts = [(ground, np.array([[0, 1, 2], [0, 2, 3]])), turned(TRUNK), turned(CROWN)]
    first = np.cumsum([0] + [len(vertices) for vertices, _ in parts])
    faces = np.concatenate([faces + start for (_, faces), start in zip(parts, first, strict=False)])
    share = np.repeat([0.0, 0.0, sqrt(LEAVES)], [len(faces) for _, faces in parts])
    return ws.as_mesh((np.concatenate([vertices for vertices, _ in parts]), faces), transmittance=share)


def from_above(mesh: ws.Mesh, side: float) -> tuple[ws.SurfacePoints, np.ndarray]:
    """(the points that an oblique map of a square about the middle shows, (R, R) bool: in which of its pixels)."""
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


def received(mesh: ws.Mesh, points: ws.SurfacePoints, shown: np.ndarray, **options: object) -> np.ndarray:
    """(R, R) what the points of a map receive on a day in June, kWh/m²; NaN where it shows none."""
    values = np.full(shown.shape, np.nan)
    values[shown] = ws.irradiation(mesh, points, period=DAY, patches="tregenza", **options).value
    return values


def courtyards(mesh: ws.Mesh, **options: object) -> list[Map]:
    """A courtyard whose faces are black, and one whose faces reflect, by the same colours."""
    side = 1.1 * float(np.ptp(mesh.bounds[:, :2], axis=0).max())
    points, shown = from_above(mesh, side)
    values = [received(ws.as_mesh(mesh, reflectance=rho), points, shown, **options) for rho in (0.0, REFLECTANCE)]
    span = 0.0, float(rendering.round_ticks(float(np.nanmax(values)), 5)[-1])
    titles = "A day in June, between black walls", f"Walls and ground that reflect {100 * REFLECTANCE:.0f} %"
    return [
        Map(value, side / PIXELS, title, "received on 21 June, kWh/m²", "inferno", span)
        for value, title in zip(values, titles, strict=True)
    ]


def shade(**options: object) -> Map:
    """The shade of a tree: what the ground below it receives on a day."""
    off = MEADOW * ((np.arange(PIXELS) + 0.5) / PIXELS - 0.5)
    x, y = np.meshgrid(off, -off)
    shown = np.hypot(x, y) > 1.05 * TRUNK[0][0]
    position = np.stack([x[shown], y[shown], np.zeros(shown.sum())], axis=1)
    points = ws.SurfacePoints(position, np.tile(np.float32([0.0, 0.0, 1.0]), (len(position), 1)))
    value = received(meadow(), points, shown, **options)
    span = 0.0, float(rendering.round_ticks(float(np.nanmax(value)), 5)[-1])
    title = f"Under a tree that lets {100 * LEAVES:.0f} % through"
    return Map(value, MEADOW / PIXELS, title, "received on 21 June, kWh/m²", "inferno", span)


@fail_plainly(count="--samples")
def main(
    mesh: Annotated[Path, typer.Argument(help="A mesh file, in metres; by default an example.")] = Path("courtyard"),
    weather: Annotated[Path, typer.Option(help="A year, .epw, or athens, an example.")] = Path("athens"),
    samples: Annotated[int, typer.Option(help="Rays of each pixel.")] = 256,
    seed: Annotated[int, typer.Option(help="Seed of the rays.")] = 0,
    screenshot: FigureFile = None,
    size: Size = (1800, 760),
) -> None:
    """Show what faces that reflect bring to one another, and what leaves let through."""
    rendering.check_output(screenshot, rendering.FIGURE_SUFFIXES, mesh, weather)
    rendering.check_size(size, (900, 340))
    rendering.check_rendering()
    options = {"weather": weather, "count": samples, "seed": seed}
    maps = [*courtyards(ws.load_mesh(mesh), **options), shade(**options)]
    what = f"{mesh.name}, and a tree of 9 m; weather: {weather.stem}; {samples:,} rays a pixel; seed {seed}"
    figure = map_sheet(maps, what)
    rendering.size_figure(figure, size)
    show_or_save(figure, screenshot, what)


if __name__ == "__main__":
    typer.run(main)
