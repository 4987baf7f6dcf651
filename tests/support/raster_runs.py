"""Runs that bake a raster of 12 tiles, as the command does, without the command."""

from importlib import import_module

from warpsample.output.baked import BakeRun

baking = import_module("warpsample.cluster.raster_baking")
raster_bake = import_module("warpsample.output.rasters.bake")
tile_files = import_module("warpsample.output.rasters.tile_files")

TILES, RAYS = 12, 32  # 15 x 15 cells of 60 x 44


def job(dsm, quantity="sky", **options):
    """The options of a run."""
    given = {"samples": RAYS, "tile": 15, "margin": 6, **options} if quantity == "sky" else options
    return dsm, quantity, given


def bake_job(job, output, resume=False, processes=None):
    source, quantity, given = job
    run = BakeRun.of(source, output, quantity, {"seed": 0, **given})
    if output.suffix == ".zarr":
        return raster_bake.bake_raster(run, baking.ZarrTiles(output, resume, processes))
    return raster_bake.bake_raster(run, tile_files.TileFiles(output, resume))


def bake(dsm, output, resume=False, processes=None, **options):
    return bake_job(job(dsm, **options), output, resume, processes)


def contents(store):
    """The bytes of all files of a store, by their paths."""
    return {str(path.relative_to(store)): path.read_bytes() for path in store.rglob("*") if path.is_file()}
