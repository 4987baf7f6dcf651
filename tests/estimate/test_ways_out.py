"""Results as PyVista's PolyData and xarray's datasets, one way for all that have a row for each point."""

import numpy as np
import pytest

import warpsample as ws

MESH = ws.load_mesh("courtyard")
POINTS = ws.sample_surface(MESH, 24, seed=2)


@pytest.fixture(scope="module")
def year():
    return ws.irradiation(MESH, POINTS, "athens", period=("06-21T09", "06-21T12"), patches="tregenza", count=64, series=True)


def test_an_estimate_is_a_dataset():
    found = ws.sky_view_factor(MESH, POINTS, 64)
    data = found.to_xarray(POINTS)
    assert dict(data.sizes) == {"point": 24}
    assert np.array_equal(data["value"], found.value)
    assert np.array_equal(data["z"], POINTS.position[:, 2])
    assert {"standard_error", "rays", "status", "below_horizon"} <= set(data)
    assert set(data.coords) == {"x", "y", "z", "face"}
    own = ws.SurfacePoints(POINTS.position, POINTS.normal, id=np.arange(24) + 7)
    assert np.array_equal(found.to_xarray(own)["id"], np.arange(24) + 7)
    with pytest.raises(ValueError, match="points: got 3 points, want the 24 points of this result"):
        found.to_xarray(POINTS.take(slice(0, 3)))
    with pytest.raises(TypeError, match="points: got .*, want SurfacePoints"):
        found.to_xarray(MESH)


def test_results_of_no_points_are_polydata():
    """PyVista refuses arrays of vectors without a row, in its own words."""
    none = POINTS.take(slice(0, 0))
    for found in (ws.bent_normals(MESH, none, 64), ws.sky_view_factor(MESH, none, 64)):
        made = found.to_polydata(none)
        assert (made.n_points, len(made["value"])) == (0, 0)


@pytest.mark.slow
def test_a_sky_matrix_and_a_year_have_names_for_their_columns(year):
    sky = ws.sky_matrix(MESH, POINTS, 64)
    assert dict(sky.to_xarray(POINTS)["value"].sizes) == {"point": 24, "patch": 145}
    assert np.array_equal(sky.to_polydata(POINTS)["value"], sky.value)
    data = year.to_xarray(POINTS)
    assert data["direct"].dims == ("point", "hour")
    assert np.array_equal(data["hour"], year.hours)
    assert np.array_equal(year.to_polydata(POINTS)["diffuse"], year.diffuse)
    assert sum(year.counts().values()) == 24
