"""Fixtures that the tests of clusters share."""

from importlib import import_module

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


@pytest.fixture(scope="session")
def right(mesh):
    """The numbers of the stores of `store_cases`, without a store."""
    from store_cases import POINTS, RAYS

    return ws.ambient_occlusion(mesh, ws.sample_surface(mesh, POINTS), RAYS)


@pytest.fixture
def in_this_thread():
    import dask

    with dask.config.set(scheduler="sync"):
        yield


@pytest.fixture
def computed(monkeypatch):
    """The first rows of the chunks that are computed."""
    baking = import_module("warpsample.cluster.baking")
    ran, bake_chunk = [], baking.bake_chunk

    def counted(call, path, span, *rest):
        ran.append(span.start)
        return bake_chunk(call, path, span, *rest)

    monkeypatch.setattr(baking, "bake_chunk", counted)
    return ran


@pytest.fixture
def folder(tmp_path):
    """An empty folder for what is written."""
    made = tmp_path / "made"
    made.mkdir()
    return made


@pytest.fixture
def computed_tiles(monkeypatch):
    """The tiles of a raster that are computed; the test may set after how many comes an interrupt."""
    from warpsample.city.rasters.tiles import RasterRun

    ran, numbers = [], RasterRun.numbers

    def counted(run, span):
        if run.reader.shape == (2, 2):  # a check of the options
            return numbers(run, span)
        if len(ran) == counted.most:
            raise KeyboardInterrupt
        ran.append(list(run.spans()).index(span))
        return numbers(run, span)

    counted.most = -1
    monkeypatch.setattr(RasterRun, "numbers", counted)
    return ran, counted
