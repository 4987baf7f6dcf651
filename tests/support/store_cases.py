"""Stores of 130 points in three chunks: how they are written, and whether they are whole."""

from importlib import import_module

import numpy as np
import xarray as xr

from warpsample import cluster

holdings = import_module("warpsample.cluster.holdings")

POINTS, RAYS, CHUNK = 130, 40, 50
ARRAYS = ("value", "standard_error", "spread", "degrees_of_freedom", "rays", "status")


def bake(path, mesh, *more, **options):
    return cluster.bake(path, "ambient_occlusion", mesh, *(more or (POINTS, RAYS)), **{"chunk": CHUNK, **options})


def whole_chunks(path):
    return holdings.whole_chunks(path, [file.parent.name for file in path.glob("[!.]*/zarr.json")])


def assert_whole(path, right):
    with xr.open_zarr(path) as found:
        for name in ARRAYS:
            assert found[name].dtype == getattr(right, name).dtype
            assert np.array_equal(found[name], getattr(right, name)), name
    assert all(whole_chunks(path))
    assert list(path.parent.iterdir()) == [path]
