"""The calls of the package over Dask, lazily, and into Zarr stores that resume."""
