"""`bench city`: the visible sky in the cells of rasters and its error, by horizons, by rays and by other tools."""

from dataclasses import dataclass
from importlib.metadata import version
from pathlib import Path
from typing import Annotated, Any

import numpy as np
import typer

from warpsample.bench.record import Benchmark, Found, Picture, Repeats, Track
from warpsample.bench.rows import Spread, ToolRow, column, maybe
from warpsample.bench.running.child import ChildJob
from warpsample.bench.running.turns import keeping_last, take_turns
from warpsample.bench.tables import TableView
from warpsample.bench.tools.rasters import RASTER_TOOLS
from warpsample.estimate.quantities.visible_sky import visible_sky
from warpsample.host.engine import check_workers

_AZIMUTHS = 1 << 14  # of exact values
_RAYS = 1 << 14  # of a cell of terrain that is looked at
_LOOKED_AT = 2000
_SEED = 1 << 40  # far from those of the estimates


@dataclass(frozen=True)
class CellSky(ToolRow):
    """One tool on one raster."""

    scene: str = column("raster")
    cells: int = column("cells")
    workers: int = column("workers")
    bias: float | None = maybe("bias", "the mean of what the cells looked at are off by", show="+.4f")
    rmse: float | None = maybe("RMSE", "of these cells", show=".4f")
    worst: float | None = maybe("worst", "of these cells", show=".3f")
    microseconds: Spread | None = maybe("µs", "of a cell, mesh and tree included")


def yard(side: int = 21, around: int = 60) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """A square yard of walls of 20 m, its cells, and what each sees of the sky: exact but for the sum over azimuths."""
    heights = np.full((side + 2 * around,) * 2, 20.0)
    heights[around:-around, around:-around] = 0.0
    row, column_ = np.mgrid[:side, :side].reshape(2, -1) + 0.5
    turn = 2.0 * np.pi * (np.arange(_AZIMUTHS) + 0.5) / _AZIMUTHS
    x, y = np.cos(turn), np.sin(turn)
    to_wall = [np.where(d > 0.0, side - p[:, None], p[:, None]) / np.abs(d) for p, d in ((column_, x), (row, y))]
    exact = 1.0 - np.sin(np.arctan(20.0 / np.minimum(*to_wall))).mean(axis=1)
    cells = (np.floor(row) + around) * len(heights) + np.floor(column_) + around
    return heights, cells.astype(np.int64), exact


def slope(degrees: float = 30.0, side: int = 401) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """A plane to the east, the cells about its middle, and what they see of the sky."""
    rise = np.tan(np.radians(degrees))
    heights = rise * np.arange(side) * np.ones((side, 1))
    up = np.maximum(rise * np.cos(2.0 * np.pi * (np.arange(_AZIMUTHS) + 0.5) / _AZIMUTHS), 0.0)
    near = np.arange(side // 2 - 10, side // 2 + 11)
    cells = (near[:, None] * side + near).ravel()
    return heights, cells, np.full(len(cells), 1.0 - np.sin(np.arctan(up)).mean())


def terrain(path: Path) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """A raster's heights, some of its cells, and what these see by very many rays among triangles between their centres."""
    from warpsample import rasters

    made = rasters.surface(path, model="tin")
    points, known = made.points()
    rows = np.linspace(0, len(known) - 1, _LOOKED_AT).astype(np.int64)
    right = visible_sky(made.mesh, points.take(rows), _RAYS, seed=_SEED).value
    return made.grid.height, known[rows], right.astype(np.float64)


def build_sky(tool: str, scene: str, raster: Path | None, workers: int) -> ChildJob:
    """A tool's numbers in all cells of a raster, and what they are off by."""
    heights, cells, right = SCENES[scene]() if raster is None else terrain(raster)
    library, make, _ = RASTER_TOOLS[tool]
    model = {"model": "tin"} if raster is not None and library == "warpsample" else {}
    work, last = keeping_last(make(heights, workers, **model))

    def report() -> dict[str, Any]:
        off = last().ravel()[cells] - right
        figures = {"bias": float(off.mean()), "rmse": float(np.sqrt(np.mean(off**2))), "worst": float(np.abs(off).max())}
        return {"version": version(library), **figures}

    return ChildJob(work, report)


SCENES: dict[str, Any] = {"yard": yard, "slope": slope}
"""By name: heights in cells of a metre, the numbers of some cells, and what these see."""


def measure(
    track: Track,
    *,
    raster: Annotated[Path | None, typer.Option(help="Terrain, in cells of a metre, besides a yard and a slope.")] = None,
    repeats: Repeats = 3,
) -> Found:
    """Raster by raster."""
    scenes: dict[str, Path | None] = dict.fromkeys(SCENES)
    scenes |= {} if raster is None else {raster.name: raster}
    rows = [row for name in track(scenes, len(scenes)) for row in measure_scene(name, scenes[name], repeats)]
    return {"rows": rows}


def measure_scene(scene: str, raster: Path | None, repeats: int) -> list[CellSky]:
    """All tools on one raster, taking turns."""
    heights = SCENES[scene]()[0] if raster is None else terrain(raster)[0]
    case = {"scene": scene, "workers": check_workers(None)}
    turns = take_turns(build_sky, RASTER_TOOLS, repeats, raster=raster, **case)

    def figures(tool: str) -> dict[str, Any]:
        each = [1e6 * seconds / heights.size for seconds in turns.seconds[tool]]
        return {**turns.told[tool], "microseconds": Spread.of(each)}

    return turns.rows(CellSky, figures, cells=heights.size, **case)


RECORD = Benchmark(
    name="city",
    summary="The visible sky in the cells of rasters: error and time, ours, RVT and xarray-spatial.",
    measure=measure,
    parts={"rows": CellSky},
    views=[TableView("rows", "Visible sky", "tool", "bias rmse worst microseconds", split="scene cells")],
    pictures=[Picture("city", "rows", "microseconds", y="tool", series="scene", log="x")],
)
