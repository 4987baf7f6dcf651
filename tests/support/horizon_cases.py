"""Rasters whose sky view is known without a ray, for tests of error bars of horizons."""

import numpy as np
from raster_cases import NORTH_UP

from warpsample import rasters
from warpsample.city.rasters.horizons import sky_by_horizons

FLOOR = 1e-3
"""Largest error of the known numbers: those of blocks are means over 2,048 azimuths, and off by 7e-4 at most."""


def blocks(side=40, houses=22, seed=11):
    """(side, side) heights of houses with flat roofs, some of them joined, on level ground."""
    rng = np.random.default_rng(seed)
    heights = np.zeros((side, side))
    for _ in range(houses):
        (row, column), (depth, width) = rng.integers(0, side - 4, 2), rng.integers(3, 11, 2)
        heights[row : row + depth, column : column + width] = rng.uniform(3.0, 24.0)
    return heights


def sines_of_blocks(heights, cell, azimuths):
    """(A,) sines of the horizons from the middle of a cell of side 1, in float64, to azimuths from the east to the north.

    A flat cell is highest as seen from where the ray enters it, at a line between columns or between rows.
    """
    row, column = divmod(cell, heights.shape[1])
    slope = np.zeros(len(azimuths))
    for field, here, along, across in (
        (heights, (row, column), np.cos(azimuths), -np.sin(azimuths)),
        (heights.T, (column, row), -np.sin(azimuths), np.cos(azimuths)),
    ):
        rows, columns = field.shape
        for step in (1, -1):
            ahead = step * along > 1e-12
            lines = np.arange(1, columns - here[1] if step > 0 else here[1] + 1)
            distance = (lines - 0.5) / np.abs(along[ahead])[:, None]
            aside = np.floor(here[0] + 0.5 + distance * across[ahead][:, None]).astype(int)
            above = field[np.clip(aside, 0, rows - 1), here[1] + step * lines] - field[here]
            above = np.where((aside >= 0) & (aside < rows), above, 0.0)
            if above.size:
                slope[ahead] = np.maximum(slope[ahead], (above / distance).max(axis=1))
    return slope / np.hypot(1.0, slope)


def exact_sky(heights, cells, azimuths=2048):
    """(sky view factors, visible skies) of cells of flat blocks with a level receiver, (C,) float64 each."""
    angles = 2.0 * np.pi * (np.arange(azimuths) + 0.5) / azimuths
    sines = np.array([sines_of_blocks(heights, cell, angles) for cell in cells])
    return (1.0 - sines**2).mean(axis=1), (1.0 - sines).mean(axis=1)


def hills(side=60, seed=12):
    """(side, side) heights of terrain: waves of all lengths with random phases, and 3 cm of noise."""
    rng = np.random.default_rng(seed)
    row, column = np.mgrid[:side, :side] / side
    heights = rng.normal(0.0, 0.03, (side, side))
    for wave in range(1, 14):
        angle, phase = rng.uniform(0.0, 2.0 * np.pi, 2)
        direction = np.cos(angle) * column + np.sin(angle) * row
        heights += 7.0 / np.float_power(wave, 1.5) * np.sin(2.0 * np.pi * wave * direction + phase)
    return heights


def yard(side=21, around=4, depth=20.0):
    """(side + 2 around,) twice, heights of a square yard."""
    heights = np.full((side + 2 * around,) * 2, depth)
    heights[around:-around, around:-around] = 0.0
    return heights


def points_of(heights, model, receiver, cells):
    made = rasters.surface((heights, NORTH_UP, None), model=model)
    points, known = made.points(receiver)
    chosen = np.flatnonzero(np.isin(known, cells))
    return made.mesh, points.take(chosen), known[chosen]


def shares(quantity, mesh, points, right, count, seeds):
    """[within two standard errors, within the 95 % interval, mean square error, mean squared standard error]."""
    found = [sky_by_horizons(quantity, mesh, points, {"count": count, "seed": seed}) for seed in range(seeds)]
    off = np.abs([one.value.astype(np.float64) - right for one in found])
    error, half = (np.array([getattr(one, name) for one in found], np.float64) for name in ("standard_error", "half_width"))
    assert (error[off > FLOOR] > 0.0).all()
    return np.array([(off <= 2.0 * error).mean(), (off <= half).mean(), (off**2).mean(), (error**2).mean()])
