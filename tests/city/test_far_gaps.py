"""Gaps at the edge between a raster and another one beyond it: triangles of "tin" do not cover the cells next to a gap."""

import numpy as np
import pytest
from affine import Affine

pytest.importorskip("rasterio")
pytest.importorskip("rioxarray")

from warpsample import rasters

NORTH_UP = Affine(1.0, 0.0, 0.0, 0.0, -1.0, 0.0)


def block_at_the_edge():
    """Heights of 32 x 60 cells without terrain to the north of rows 10 to 21, where a raster has a block of 20 m."""
    land = np.zeros((32, 60))
    land[:10] = np.nan
    land[10:14, 10:30] = 20.0
    return land, (slice(10, 22), slice(10, 50))


def canal_at_the_edge():
    """Heights of 20 x 40 cells, of which a raster has the upper half. Its last row is a canal without data."""
    land = np.zeros((20, 40))
    land[10:] = 2.0
    land[9] = np.nan
    return land, (slice(0, 10), slice(0, 40))


@pytest.mark.parametrize("options", [{}, {"tile": 10, "margin": 2}])
@pytest.mark.parametrize("under", ["the same", "nothing", "data"])
@pytest.mark.parametrize("scene", [block_at_the_edge, canal_at_the_edge])
def test_the_bound_holds_beside_gaps(scene, under, options):
    """Cells were too low by up to 0.05 with a `far_error` of 0, as if triangles reached over the gaps."""
    land, inner = scene()
    whole = rasters.sky_view_factor((land, NORTH_UP, None), 1024, model="tin")
    corner = NORTH_UP @ Affine.translation(inner[1].start, inner[0].start)
    far = land.copy()
    if under != "the same":
        far[inner] = {"nothing": np.nan, "data": 0.0}[under]
    own = np.ascontiguousarray(land[inner]), corner, None
    found = rasters.sky_view_factor(own, 1024, model="tin", far=(far, NORTH_UP, None), **options)
    truth, its_error = (getattr(whole, name).values[inner].astype(np.float64) for name in ("value", "standard_error"))
    error = 4.0 * np.hypot(found.standard_error.values, its_error)
    within = np.abs(found.value.values - truth) <= found.far_error.values + error + 1e-4  # float32 rounding
    assert np.array_equal(within, np.isfinite(land[inner]))
