"""Integrals of a sampler's density over cells of directions, refined until they have converged."""

from itertools import pairwise

import numpy as np

from warpsample.statistics.charts import Chart, Sampler, chart_of

_COARSEST, _FINEST = 8, 256
_TOLERANCE = 5e-5  # relative change between two refinements; 2^20 directions resolve 1e-3
_LONGEST_PANEL = 4.0  # largest ratio of the ends of one panel: lobes span ten powers of ten


def cell_masses(
    sampler: Sampler, edges: np.ndarray, columns: int, weight: int = 0, *, chart: Chart | None = None
) -> np.ndarray:
    """Integrate a sampler's density, times a^weight, over cells of the polar coordinates (a, phi).

    Args:
        sampler: its pdf is integrated.
        edges: (rows + 1,) ascending values of the coordinate a.
        columns: number of cells of equal azimuth in a row.
        weight: exponent of a.
        chart: chart of the cells. Default: the chart of the sampler.

    Returns:
        (rows, columns) float64.

    Raises:
        ValueError: the integral does not converge; a test based on it could reject a correct sampler.
    """
    chart = chart or chart_of(sampler)
    before = _integrate_cells(sampler, chart, edges, columns, weight, nodes=_COARSEST)
    nodes = 2 * _COARSEST
    while nodes <= _FINEST:
        after = _integrate_cells(sampler, chart, edges, columns, weight, nodes=nodes)
        change = np.abs(after - before).sum() / max(np.abs(after).sum(), 1e-30)
        if change <= _TOLERANCE:
            return after
        before, nodes = after, 2 * nodes
    raise ValueError(
        f"pdf: got an integral that still changes by a relative {change:.1e} at {_FINEST} nodes per cell, want a "
        "smoother density"
    )


def _integrate_cells(
    sampler: Sampler, chart: Chart, edges: np.ndarray, columns: int, weight: int, *, nodes: int
) -> np.ndarray:
    """Integrate a sampler's density, times a^weight, over cells, by Gauss-Legendre quadrature with `nodes` nodes."""
    panels, owner = _divide_cells(edges)
    t, gauss = np.polynomial.legendre.leggauss(nodes)
    # With a = low + length sin^2(pi (t + 1) / 4) an inverse root at either end is smooth, as at an offset sphere's edge.
    angle = np.pi * (t + 1.0) / 4.0
    length = np.diff(panels)[:, None]
    a = panels[:-1, None] + length * np.sin(angle) ** 2
    step = length * np.sin(2.0 * angle) * gauss * np.pi / 4.0
    # The density is smooth in azimuth, so a few midpoints are enough.
    fine = 1 if sampler.symmetric else max(1, nodes // 4)
    turns, share = (np.arange(columns * fine) + 0.5) / (columns * fine), 1.0
    if chart.cornered:  # within columns only: midpoints would converge slowly
        inner, weights = np.polynomial.legendre.leggauss(fine)
        turns = (np.arange(columns)[:, None] + 0.5 * (inner + 1.0)).ravel() / columns
        share = np.tile(0.5 * fine * weights, columns)
    density = sampler.pdf(chart.point(a[..., None], turns).astype(np.float32)).astype(np.float64)
    elements = chart.element(a[..., None], turns)
    ring = (density * elements * (np.float_power(a, weight) * step)[..., None]).sum(axis=1) * share
    rows = np.add.reduceat(ring, np.flatnonzero(np.diff(owner, prepend=-1)), axis=0)
    return rows.reshape(len(rows), columns, fine).sum(axis=2) * chart.azimuths / (columns * fine)


def _divide_cells(edges: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Divide long cells into panels for quadrature; return the panels' edges and the cell of each panel."""
    panels, owner = [edges[0]], []
    for cell, (low, high) in enumerate(pairwise(edges)):
        pieces = max(1, int(np.ceil(np.log(high / low) / np.log(_LONGEST_PANEL)))) if low > 0.0 else 1
        panels += [*np.geomspace(low, high, pieces + 1)[1:]] if pieces > 1 else [high]
        owner += [cell] * pieces
    return np.array(panels), np.array(owner)
