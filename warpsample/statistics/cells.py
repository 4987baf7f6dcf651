"""Integrals of the densities of many lobes over cells of the angles theta and phi, refined where a density is narrow."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

_TOLERANCE = 1e-6  # of the probability of one rectangle: the standard deviation of 1e6 directions in 400 cells is 5e-5
_MOST_RECTANGLES = 1 << 14  # waiting at a time, for each lobe on average; a cone's edge has some 2,000
_PART = 1 << 13  # rectangles that are evaluated at a time: 25 directions each
_DEEPEST = 24  # halvings of a cell

Density = Callable[[np.ndarray, np.ndarray], np.ndarray]
"""Function (rows (A,) of lobes, directions (A, n, 3) float32) -> (A, n) densities per steradian."""


def _rule() -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return the nodes on [0, 1] of two Gauss-Legendre rules, of 4 and 3 nodes, and the weights of each rule."""
    fine, coarse = (np.polynomial.legendre.leggauss(n) for n in (4, 3))
    return 0.5 * (1.0 + np.append(fine[0], coarse[0])), 0.5 * fine[1], 0.5 * coarse[1]


_NODES, _FINE, _COARSE = _rule()


@dataclass
class _Rectangles:
    """Rectangles of theta and phi that wait to be integrated, A in all.

    Attributes:
        lobe: (A,) row of the lobe.
        cell: (A,) number of the cell.
        low: (A, 2) smallest theta and phi, radians.
        size: (A, 2) extents in theta and phi.
        seed: (A, 2) theta and phi of a direction with a high density; NaN for none.
        height: (A,) density at `seed`; 0 for none.
    """

    lobe: np.ndarray
    cell: np.ndarray
    low: np.ndarray
    size: np.ndarray
    seed: np.ndarray
    height: np.ndarray

    def __len__(self) -> int:
        """Return the number of rectangles."""
        return len(self.lobe)

    def take(self, rows: np.ndarray | slice) -> "_Rectangles":
        """Return some of the rectangles."""
        return _Rectangles(*(array[rows] for array in vars(self).values()))

    def quarters(self) -> "_Rectangles":
        """Return the four quarters of each rectangle; the seed stays with the quarter that contains it."""
        parts = []
        for corner in ((0.0, 0.0), (0.0, 0.5), (0.5, 0.0), (0.5, 0.5)):
            low, size = self.low + np.array(corner) * self.size, 0.5 * self.size
            inside = ((self.seed >= low) & (self.seed <= low + size)).all(axis=1)
            parts.append(_Rectangles(self.lobe, self.cell, low, size, self.seed, np.where(inside, self.height, 0.0)))
        return _Rectangles(*(np.concatenate(arrays) for arrays in zip(*(vars(p).values() for p in parts), strict=True)))


def integrate_lobes(density: Density, lobes: int, edges: np.ndarray, columns: int, pilot: np.ndarray) -> np.ndarray:
    """Integrate the densities of several lobes over cells of theta and phi, by Gauss-Legendre rules.

    A rectangle is divided into quarters until two rules agree, and until it is small beside the peak of the lobe.

    Args:
        density: densities of the lobes.
        lobes: number of lobes L.
        edges: (R + 1,) ascending angles to +z, radians, in [0, pi].
        columns: number C of cells of equal azimuth in a row.
        pilot: (L, S, 3) directions with high densities, so that no narrow peak is missed. They change the division of the
            cells, not the integrand.

    Returns:
        (L, R, C) float64 probabilities.

    Raises:
        ValueError: the density is too rough to be integrated.
    """
    waiting = _cells(density, lobes, edges, columns, pilot)
    cells = (len(edges) - 1) * columns
    found = np.zeros(lobes * cells)
    for _ in range(_DEEPEST):
        left = []
        for start in range(0, len(waiting), _PART):
            part = waiting.take(slice(start, start + _PART))
            value, error = _integrate(density, part)
            done = (error <= _TOLERANCE) & (part.height * _area(part) <= 1.0)
            index = part.lobe[done] * cells + part.cell[done]
            found += np.bincount(index, value[done], minlength=len(found))
            left.append(part.take(~done).quarters())
        waiting = _Rectangles(*(np.concatenate(arrays) for arrays in zip(*(vars(p).values() for p in left), strict=True)))
        if not len(waiting):
            return found.reshape(lobes, len(edges) - 1, columns)
        if len(waiting) > _MOST_RECTANGLES * lobes:
            break
    raise ValueError("pdf: got a density that is too rough to be integrated over cells, want a smoother density")


def _cells(density: Density, lobes: int, edges: np.ndarray, columns: int, pilot: np.ndarray) -> _Rectangles:
    """Return the cells of all lobes as rectangles, each with the pilot direction of the highest density in the cell."""
    rows, width = len(edges) - 1, 2.0 * np.pi / columns
    row, column = (index.ravel() for index in np.indices((rows, columns)))
    low = np.stack([edges[row], width * column], axis=1)
    size = np.stack([np.diff(edges)[row], np.full(rows * columns, width)], axis=1)
    count = rows * columns
    made = _Rectangles(
        np.repeat(np.arange(lobes), count),
        np.tile(np.arange(count), lobes),
        np.tile(low, (lobes, 1)),
        np.tile(size, (lobes, 1)),
        np.full((lobes * count, 2), np.nan),
        np.zeros(lobes * count),
    )
    height = density(np.arange(lobes), pilot).astype(np.float64).ravel()
    w = pilot.reshape(-1, 3).astype(np.float64)
    theta = np.arctan2(np.hypot(w[:, 0], w[:, 1]), w[:, 2])
    phi = np.arctan2(w[:, 1], w[:, 0]) % (2.0 * np.pi)
    cell = np.clip(np.searchsorted(edges, theta, side="right") - 1, 0, rows - 1) * columns
    cell += np.minimum((phi / width).astype(np.intp), columns - 1)
    owner = np.repeat(np.arange(lobes), pilot.shape[1]) * count + cell
    order = np.argsort(height, kind="stable")  # the last one in a cell is the highest
    made.seed[owner[order]] = np.stack([theta, phi], axis=1)[order]
    made.height[owner[order]] = height[order]
    return made


def _area(part: _Rectangles) -> np.ndarray:
    """Return an upper bound of the solid angle of each rectangle."""
    low, high = part.low[:, 0], part.low[:, 0] + part.size[:, 0]
    sine = np.where((low < 0.5 * np.pi) & (high > 0.5 * np.pi), 1.0, np.maximum(np.sin(low), np.sin(high)))
    return part.size.prod(axis=1) * sine


def _integrate(density: Density, part: _Rectangles) -> tuple[np.ndarray, np.ndarray]:
    """Return the integral of the density over each rectangle by the finer rule, and its difference from the coarser rule."""
    theta, phi = (part.low[:, None] + _NODES[:, None] * part.size[:, None]).transpose(2, 0, 1)
    sine, cosine, x, y = np.sin(theta), np.cos(theta), np.cos(phi), np.sin(phi)
    directions, weights = [], []
    for nodes, rule in ((slice(0, 4), _FINE), (slice(4, 7), _COARSE)):
        across, up = sine[:, nodes, None], np.repeat(cosine[:, nodes, None], len(rule), axis=2)
        w = np.stack([across * x[:, None, nodes], across * y[:, None, nodes], up], axis=-1)
        directions.append(w.reshape(len(part), -1, 3))
        weights.append((np.outer(rule, rule) * across).reshape(len(part), -1))
    values = density(part.lobe, np.concatenate(directions, axis=1).astype(np.float32)).astype(np.float64)
    size, split = part.size.prod(axis=1), len(_FINE) ** 2
    fine = size * (weights[0] * values[:, :split]).sum(axis=1)
    return fine, np.abs(fine - size * (weights[1] * values[:, split:]).sum(axis=1))
