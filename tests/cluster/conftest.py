"""Fixtures that the tests of clusters share."""

import pytest

import warpsample as ws


@pytest.fixture(scope="session")
def mesh() -> ws.Mesh:
    return ws.load_mesh("courtyard")


@pytest.fixture
def path(tmp_path):
    """Of a store that is not there yet."""
    return tmp_path / "out.zarr"


@pytest.fixture
def dsm(tmp_path):
    """A GeoTIFF of heights, alone in its folder."""
    from raster_cases import SLOVENIA, heights, write_tif

    folder = tmp_path / "given"
    folder.mkdir()
    return write_tif(folder / "dsm.tif", heights(), transform=SLOVENIA)
