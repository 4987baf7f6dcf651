"""Ring of cells around a raster, with heights of the raster of the terrain beyond its edges.

The surface of a cell at the raster's edge depends on the cells beyond the edge: in "joined" by the corners that cells share,
in "tin" by the triangles between centres. So both models get one ring of cells from the other raster. Where the other raster
has only bounds of the ring's heights, because its cells are larger or are other cells, the ring is too low rather than too
high. The columns of the distant terrain, which begin at the edge, are high enough for the upper bound.
"""

from dataclasses import replace

import numpy as np
from affine import Affine

from warpsample.city.rasters.cells import STEP
from warpsample.city.rasters.grid import Bounds, Grid, resample_extremes
from warpsample.city.rasters.raster_surface import RasterSurface
from warpsample.city.rasters.scenery import Part

_SAME = 1.0 + 1e-6  # length of the other raster's cells, in cells, up to which they are not larger

Window = tuple[slice, slice]
"""Rows and columns."""


def fringe_bounds(heights: np.ndarray, grown: Bounds) -> Bounds:
    """Return bounds of heights in the ring: the heights of the other raster, or `grown` if that raster has larger cells.

    Args:
        heights: (rows, columns) heights of the other raster.
        grown: Bounds of the other raster's surface: the extremes of each cell and its neighbours.
    """
    a, b, _, d, e, _ = grown.transform[:6]
    larger = max(np.hypot(a, d), np.hypot(b, e)) > _SAME
    return grown if larger else Bounds(heights, heights, grown.transform)


def add_fringe(grid: Grid, window: Window, shape: tuple[int, int], bounds: Bounds, model: str) -> tuple[Grid, Window]:
    """Return a part of a raster, with a row or a column of the ring on each side at the raster's edge, and its window.

    Args:
        grid: Heights of the part.
        window: Rows and columns of the part.
        shape: Numbers of rows and columns of the raster.
        bounds: Bounds of the heights in the ring, from `fringe_bounds`.
        model: Surface model, "joined" or "tin".
    """
    sides = [(int(part.start == 0), int(part.stop == size)) for part, size in zip(window, shape, strict=True)]
    rows, columns = (slice(part.start - first, part.stop + last) for part, (first, last) in zip(window, sides, strict=True))
    inner = np.pad(np.ones(grid.height.shape, bool), sides)
    upper, lower = resample_extremes(bounds, Affine.translation(columns.start, rows.start), inner.shape)
    own = np.pad(grid.height, sides, mode="edge")
    low = lower
    if model == "joined":  # a ring that is lower by more than a step is not joined with the cells at the edge
        low = np.clip(lower, own - STEP * min(grid.sides), own)
    ring = np.where(upper == lower, lower, low)
    transform = grid.transform @ Affine.translation(-sides[1][0], -sides[0][0])
    return replace(grid, height=np.where(inner, own, ring), transform=transform, coordinates={}), (rows, columns)


def cut_fringe(surface: RasterSurface, window: Window, kept: Window) -> Part:
    """Return the triangles of a part of a raster, its window, without the tops and walls of cells outside a smaller window.

    The outer corners of these cells are not joined with the cells beyond. Triangles of "tin" reach to the ring's centres.
    """
    if surface.model == "tin":
        return surface.mesh.vertices, surface.mesh.faces
    place = np.divmod(surface.cell, surface.grid.height.shape[1])
    rows, columns = (
        (at + part.start >= inner.start) & (at + part.start < inner.stop)
        for at, part, inner in zip(place, window, kept, strict=True)
    )
    inside = rows & columns
    return surface.mesh.vertices, surface.mesh.faces if inside.all() else surface.mesh.faces[inside]
