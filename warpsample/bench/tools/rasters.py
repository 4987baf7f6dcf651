"""Functions of each tool that compute the visible sky in the cells of a raster, (rows, columns), new at each call."""

from collections.abc import Callable
from functools import partial
from itertools import count as count_from
from typing import Any

import numpy as np

from warpsample.bench.running.turns import Tool

SkyOfCells = Callable[[], np.ndarray]

_NORTH_UP = (1.0, 0.0, 0.0, 0.0, -1.0, 0.0)  # cells of 1 m; the first row is the northernmost


def _ours(heights: np.ndarray, workers: int, *, count: int, **options: Any) -> SkyOfCells:
    from warpsample import rasters

    source, seeds = (heights, _NORTH_UP, None), count_from()

    def sky() -> np.ndarray:
        return rasters.visible_sky(source, count, seed=next(seeds), workers=workers, **options).value.to_numpy()

    return sky


def _rvt(heights: np.ndarray, workers: int, *, directions: int, radius: int) -> SkyOfCells:
    from rvt.vis import sky_view_factor

    return lambda: sky_view_factor(heights, 1.0, svf_n_dir=directions, svf_r_max=radius)["svf"]


def _xarray_spatial(heights: np.ndarray, workers: int, *, directions: int, radius: int) -> SkyOfCells:
    from xrspatial.sky_view_factor import sky_view_factor

    from warpsample import rasters

    array = rasters.surface((heights, _NORTH_UP, None), model="tin").to_raster(heights.ravel(), np.arange(heights.size))
    return lambda: sky_view_factor(array, max_radius=radius, n_directions=directions).to_numpy()


_RAYS = {f"warpsample, {count} rays": partial(_ours, count=count) for count in (64, 256)}
_RAYS |= {f"warpsample without horizons, {count} rays": partial(_ours, count=count, tracer="wide") for count in (64, 256)}
_SWEEPS = {f"{count} directions of {radius} cells": (count, radius) for count, radius in ((16, 10), (32, 100))}
RASTER_TOOLS = {name: Tool("warpsample", make) for name, make in _RAYS.items()}
RASTER_TOOLS |= {
    f"{name}, {label}": Tool(library, partial(make, directions=directions, radius=radius), threaded=False)
    for name, library, make in (("RVT", "rvt-py", _rvt), ("xarray-spatial", "xarray-spatial", _xarray_spatial))
    for label, (directions, radius) in _SWEEPS.items()
}
"""Tools by name; `make(heights, threads)` returns a function that computes the visible sky of each cell."""
