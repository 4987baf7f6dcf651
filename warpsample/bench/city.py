"""`bench city`: error and time of the visible fraction of the sky in raster cells, for each tool."""

from dataclasses import dataclass
from importlib.metadata import version
from pathlib import Path
from typing import Annotated, Any

import numpy as np
import typer

from warpsample.bench.record import Benchmark, Picture, Repeats, RowsByPart, Track
from warpsample.bench.reporting.tables import TableView
from warpsample.bench.rows import Spread, ToolRow, column, optional_column
from warpsample.bench.running.child import ChildJob
from warpsample.bench.running.turns import keep_last_result, run_tools
from warpsample.bench.tools.rasters import RASTER_TOOLS
from warpsample.estimate.quantities.visible_sky import visible_sky
from warpsample.host.engine import check_workers

_AZIMUTHS = 1 << 14  # azimuths of an exact value
_RAYS = 1 << 14  # rays of a judged cell of terrain
_JUDGED = 2000  # judged cells of terrain
_SEED = 1 << 40  # far from the seeds of the estimates


@dataclass(frozen=True)
class CellSky(ToolRow):
    """Row of `bench city`: error and time of one tool that computes the visible sky in the cells of one raster."""

    scene: str = column("raster")
    cells: int = column("cells")
    workers: int = column("workers")
    bias: float | None = optional_column("bias", "mean error of the judged cells", show="+.4f")
    rmse: float | None = optional_column("RMSE", "RMSE of the judged cells", show=".4f")
    worst: float | None = optional_column("worst", "largest absolute error of the judged cells", show=".3f")
    microseconds: Spread | None = optional_column(
        "µs per cell", "time per cell of the raster, with building the mesh and the tree"
    )


def build_yard(side: int = 21, around: int = 60) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return the raster of a square yard with walls of 20 m: (heights, cells to judge, exact visible sky there).

    The visible sky is exact but for the sum over azimuths.
    """
    heights = np.full((side + 2 * around,) * 2, 20.0)
    heights[around:-around, around:-around] = 0.0
    row, column_ = np.mgrid[:side, :side].reshape(2, -1) + 0.5
    turn = 2.0 * np.pi * (np.arange(_AZIMUTHS) + 0.5) / _AZIMUTHS
    x, y = np.cos(turn), np.sin(turn)
    to_wall = [np.where(d > 0.0, side - p[:, None], p[:, None]) / np.abs(d) for p, d in ((column_, x), (row, y))]
    exact = 1.0 - np.sin(np.arctan(20.0 / np.minimum(*to_wall))).mean(axis=1)
    cells = (np.floor(row) + around) * len(heights) + np.floor(column_) + around
    return heights, cells.astype(np.int64), exact


def build_slope(degrees: float = 30.0, side: int = 401) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return the raster of a plane that rises to the east: (heights, cells to compare, exact visible sky there).

    These cells are near the middle of the plane.
    """
    rise = np.tan(np.radians(degrees))
    heights = rise * np.arange(side) * np.ones((side, 1))
    up = np.maximum(rise * np.cos(2.0 * np.pi * (np.arange(_AZIMUTHS) + 0.5) / _AZIMUTHS), 0.0)
    near = np.arange(side // 2 - 10, side // 2 + 11)
    cells = (near[:, None] * side + near).ravel()
    return heights, cells, np.full(len(cells), 1.0 - np.sin(np.arctan(up)).mean())


def load_terrain(path: Path) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Read a raster of heights, and return (heights, indices of the compared cells, reference visible sky in each of them).

    The reference traces 16,384 rays per compared cell on the triangulated raster.
    """
    from warpsample import rasters

    surface = rasters.surface(path, model="tin")
    points, cells = surface.points()
    rows = np.linspace(0, len(cells) - 1, _JUDGED).astype(np.int64)
    right = visible_sky(surface.mesh, points.take(rows), _RAYS, seed=_SEED).value
    return surface.grid.height, cells[rows], right.astype(np.float64)


def build_sky(tool: str, scene: str, raster: Path | None, workers: int) -> ChildJob:
    """Prepare one tool to compute the visible sky in all cells of a raster, and return the work to time.

    The job's report has the errors in the compared cells.
    """
    heights, cells, right = SCENES[scene]() if raster is None else load_terrain(raster)
    library, make, _ = RASTER_TOOLS[tool]
    model = {"model": "tin"} if raster is not None and library == "warpsample" else {}
    work, last = keep_last_result(make(heights, workers, **model))

    def report() -> dict[str, Any]:
        off = last().ravel()[cells] - right
        figures = {"bias": float(off.mean()), "rmse": float(np.sqrt(np.mean(off**2))), "worst": float(np.abs(off).max())}
        return {"version": version(library), **figures}

    return ChildJob(work, report)


SCENES: dict[str, Any] = {"yard": build_yard, "slope": build_slope}
"""Functions that return heights in cells of 1 m, indices of the judged cells, and the visible sky there, keyed by scene."""


def measure(
    track: Track,
    *,
    raster: Annotated[
        Path | None,
        typer.Option(
            help="Path of a raster of heights with cells of 1 m, for example dsm.tif. Default: only a yard and a slope."
        ),
    ] = None,
    repeats: Repeats = 3,
) -> RowsByPart:
    """Measure the visible sky of rasters with all tools, one raster after the other; return the rows."""
    scenes: dict[str, Path | None] = dict.fromkeys(SCENES)
    scenes |= {} if raster is None else {raster.name: raster}
    rows = [row for name in track(scenes, len(scenes)) for row in measure_scene(name, scenes[name], repeats)]
    return {"rows": rows}


def measure_scene(scene: str, raster: Path | None, repeats: int) -> list[CellSky]:
    """Measure all tools on one raster, with alternating runs; return one row per tool."""
    heights = SCENES[scene]()[0] if raster is None else load_terrain(raster)[0]
    case = {"scene": scene, "workers": check_workers(None)}
    turns = run_tools(build_sky, RASTER_TOOLS, repeats, raster=raster, **case)

    def figures(tool: str) -> dict[str, Any]:
        each = [1e6 * seconds / heights.size for seconds in turns.seconds[tool]]
        return {**turns.reports[tool], "microseconds": Spread.of(each)}

    return turns.rows(CellSky, figures, cells=heights.size, **case)


RECORD = Benchmark(
    name="city",
    summary="Measure error and time of the visible sky in the cells of rasters: warpsample, RVT and xarray-spatial.",
    measure=measure,
    parts={"rows": CellSky},
    views=[TableView("rows", "Visible sky", "tool", "bias rmse worst microseconds", split="scene cells")],
    pictures=[Picture("city", "rows", "microseconds", y="tool", series="scene", log="x")],
)
