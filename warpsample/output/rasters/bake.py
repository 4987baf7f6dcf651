"""`warpsample bake` of a raster: compute tile by tile into a folder or store that can be resumed, then write the output."""

from collections.abc import Iterator, Mapping
from contextlib import AbstractContextManager, contextmanager
from dataclasses import dataclass
from pathlib import Path
from types import SimpleNamespace
from typing import Any, Protocol

import numpy as np

from warpsample.city.rasters.cog import check_reference, check_sidecars, write_cog
from warpsample.city.rasters.tiles import RasterRun, Span
from warpsample.estimate.quantities.record import Quantity
from warpsample.host.files import WriteError, check_output, write_bytes
from warpsample.output.bake_rules import check_table
from warpsample.output.bake_table import STORE
from warpsample.output.baked import BakeRun
from warpsample.output.pictured import draw_picture
from warpsample.output.quantities import quantity_of
from warpsample.output.rasters.content import digests_of
from warpsample.output.rasters.job import RasterJob, check_unchanged, describe_heights
from warpsample.output.report import check_report, write_report
from warpsample.output.run_record import RunRecord, summarize
from warpsample.plotting.rendering import check_rendering

GEOTIFF = (".tif", ".tiff")
"""Suffixes of outputs that are GeoTIFFs."""

WORK = "cog"
"""Name of the folder, within that of the tiles, in which a GeoTIFF is written."""

Tiles = Iterator[tuple[Span, Mapping[str, np.ndarray]]]
"""Spans of tiles and arrays by name."""


class TileStore(Protocol):
    """Interface of the storage of computed raster tiles, from which an interrupted computation can be resumed."""

    path: Path

    def locked(self) -> AbstractContextManager[Any]:
        """Lock the storage within a `with` statement, so that no other process writes tiles."""

    def begin(self, run: RasterRun, about: dict[str, Any]) -> np.ndarray:
        """Create the storage, or check that an existing one belongs to the same run; return the mask of complete tiles."""

    def compute(self, job: RasterJob, digests: Mapping[str, np.ndarray], tiles: list[int]) -> Iterator[np.void]:
        """Compute and store the tiles with the given numbers, and yield counts and sums of the values of each."""

    def tiles(self, run: RasterRun) -> Tiles:
        """Yield the (rows and columns, arrays) of all tiles, after all have been computed."""

    def about(self) -> dict[str, Any]:
        """Return the stored attributes that identify the computation: arguments and hashes of the inputs."""

    def remove(self) -> None:
        """Delete the storage at the end, unless it is the output itself."""


def bake_raster(run: BakeRun, store: TileStore) -> str:
    """Compute a quantity on a raster, tile by tile into a store, and write the output.

    Args:
        run: Arguments of the command.
        store: Store of the tiles; a .zarr output itself, or a hidden folder next to the output until the output is complete.

    Returns:
        a report for the terminal, in lines.

    Raises:
        TypeError, ValueError, FileNotFoundError: an argument that cannot be used, before anything is computed; or an
            input file that has changed since the run began.
        KeyboardInterrupt: the run is interrupted; the message states how many tiles are done.
        OSError: the output cannot be written, or another process is writing it.
    """
    check_table(run)
    job = RasterJob.of(run)
    check_raster_files(run, job)
    quantity = quantity_of(run.quantity)
    record = RunRecord.of(quantity, "tiles")
    with record.show(f"reading {run.mesh.name}"), store.locked():
        notes, shape = _bake(run, job, store, record)
    tiles = f"{record.total:,} {'tile' if record.total == 1 else 'tiles'}"
    first = f"{run.output}: {quantity.title} of {shape[0]:,} x {shape[1]:,} cells in {tiles}"
    return "\n  ".join([first, *record.describe(), *notes])


def check_raster_files(run: BakeRun, job: RasterJob) -> None:
    """Check that the output and the report of a run can be written, and that neither is an input."""
    if run.output.suffix == ".png":
        check_rendering()
    if run.output.suffix != STORE:
        check_output(run.output, "--output", *job.files)
        check_sidecars(run.output, "--output", job.files)
    check_report(run.report, run.output, *job.files)


def _bake(run: BakeRun, job: RasterJob, store: TileStore, record: RunRecord) -> tuple[list[str], tuple[int, int]]:
    """Compute all tiles that are missing in the store and write the output; return notes, and the raster's shape."""
    raster, about = job.read()
    raster.check_size()  # a store would be of other tiles than those of the next run
    raster.check()
    if run.output.suffix in GEOTIFF:
        check_reference(raster, run.output, "--output")
    if run.output.suffix == ".png" or run.report is not None:
        _ = raster.reader.outline.north  # a map has an arrow to it, and an error here would come after all tiles
    digests = {name: digests_of(reader) for name, reader in raster.rasters.items()}
    about |= describe_heights(digests)
    whole = store.begin(raster, about)
    with _resumable(store.path), record.count(len(whole), f"{store.path} can be resumed"):
        record.skip(int(whole.sum()))
        for summary in store.compute(job, digests, np.flatnonzero(~whole).tolist()):
            record.add(summary, 1)
        check_unchanged(job, store.about(), store.path)
        notes = _finish(run, raster, about, store)
        store.remove()
    return notes, raster.reader.shape


def _finish(run: BakeRun, raster: RasterRun, about: Mapping[str, Any], store: TileStore) -> list[str]:
    """Write the output file and the report of a raster command from the computed tiles; return notes for the user."""
    notes = []
    if run.output.suffix in GEOTIFF:
        removed = write_cog(run.output, raster, about, lambda: store.tiles(raster), store.path / WORK)
        names = ", ".join(file.name for file in removed)
        notes += [f"removed {names}: overviews, masks or statistics of the file that was replaced"] if removed else []
    if run.output.suffix != ".png" and run.report is None:
        return notes
    baked = BakedRaster.of(run, raster, store.tiles(raster))
    if run.output.suffix == ".png":
        write_bytes(run.output, draw_picture(baked))
    if run.report is None:
        return notes
    write_report(run.report, baked, None)
    return [*notes, f"{run.report}: a report with histogram and arguments, and a picture if this machine can draw one"]


@contextmanager
def _resumable(store: Path) -> Iterator[None]:
    """Add to any WriteError inside a `with` statement that the computation can be resumed from the store."""
    try:
        yield
    except WriteError as error:
        raise WriteError(f"{error}; {store} can be resumed") from error


@dataclass(frozen=True, eq=False)
class BakedRaster:
    """Computed values in the cells of a raster, in the form that pictures and reports use.

    Attributes:
        run: Arguments of the command.
        result: Flat arrays `value`, `standard_error`, `rays` and `status`; the status is 0 in cells with a value.
        shape: Rows and columns.
        steps: (2, 2) steps in metres, east and north on the map, to the next cell in a row, and in a column.
        north: Direction of true north on the map.
    """

    run: BakeRun
    result: Any
    shape: tuple[int, int]
    steps: np.ndarray
    north: tuple[float, float]
    mesh: None = None

    @classmethod
    def of(cls, run: BakeRun, raster: RasterRun, tiles: Tiles) -> "BakedRaster":
        """Join the values of all tiles to arrays of the whole raster."""
        names = ("value", "standard_error")
        laid = {name: np.full(raster.reader.shape, np.nan, np.float32) for name in names}
        for span, arrays in tiles:
            for name in names:
                laid[name][span] = arrays[name]
        value, error = (laid[name].ravel() for name in names)
        status = np.isnan(value).astype(np.uint8)
        found = SimpleNamespace(value=value, standard_error=error, rays=np.zeros(1, np.int64), status=status)
        outline = raster.reader.outline
        return cls(run, found, raster.reader.shape, outline.steps, outline.north[:2])

    @property
    def quantity(self) -> Quantity:
        """Description of the computed quantity: its name, unit and options."""
        return quantity_of(self.run.quantity)


def summarize_tile(arrays: Mapping[str, np.ndarray]) -> np.void:
    """Return the number, sums and range of the values in a tile, as a NumPy record of dtype SUMMARY."""
    return summarize(arrays["value"].ravel(), arrays["standard_error"].ravel(), 0)
