"""`warpsample bake` of a raster: compute tile by tile into a folder or store that can be resumed, then write the output."""

import re
import warnings
from collections.abc import Iterator, Mapping
from contextlib import AbstractContextManager, contextmanager
from dataclasses import dataclass
from importlib.metadata import version
from pathlib import Path
from types import SimpleNamespace
from typing import Any, Protocol

import numpy as np

from warpsample.city.rasters.cog import check_reference, check_sidecars, write_cog
from warpsample.city.rasters.datasets import run_of
from warpsample.city.rasters.sources.inputs import files_read
from warpsample.city.rasters.tiles import RasterRun, Span
from warpsample.estimate.quantities.record import ARGUMENTS, Quantity
from warpsample.host.arguments import quote
from warpsample.host.files import WriteError, check_output, write_bytes
from warpsample.host.shared_values import HEIGHTS_OF, digest_of
from warpsample.output.bake_rules import check_table
from warpsample.output.bake_table import STORE
from warpsample.output.baked import BakeRun
from warpsample.output.pictured import draw_picture
from warpsample.output.quantities import quantity_of
from warpsample.output.rasters.content import digests_of, place_of, unchanging
from warpsample.output.report import check_report, write_report
from warpsample.output.run_record import RunRecord, summarize
from warpsample.plotting.rendering import check_rendering
from warpsample.radiation.weather.weather import read_weather
from warpsample.sequences.record import STREAMS

STREAMS_OF, VERSIONS = "streams", ("warpsample", "warp-lang")
"""Attributes of the random streams, and the libraries whose versions determine the values."""

GEOTIFF = (".tif", ".tiff")
"""Suffixes of outputs that are GeoTIFFs."""

WORK = "cog"
"""Name of the folder, within that of the tiles, in which a GeoTIFF is written."""

Tiles = Iterator[tuple[Span, Mapping[str, np.ndarray]]]
"""Spans of tiles and arrays by name."""


@dataclass(frozen=True)
class RasterJob:
    """Description of a computation on raster files, small enough to send to worker processes, which read the files.

    Attributes:
        source: Path of the raster of heights.
        quantity: Name of the quantity on the command line.
        model: Surface model, as for `rasters`.
        receiver: Receiver, as for `rasters`.
        options: Further arguments of the call of `rasters`, sorted (name, value).
    """

    source: str
    quantity: str
    model: str
    receiver: str
    options: tuple[tuple[str, Any], ...]

    @classmethod
    def of(cls, run: BakeRun) -> "RasterJob":
        """Build the description of the computation from the arguments of a `warpsample bake` command."""
        given = run.options | {name: run.more[name] for name in _RASTER_OPTIONS if name in run.more}
        given |= {} if run.transmittance is None else {"transmittance": run.transmittance}
        options = {ARGUMENTS.get(name, name): _to_plain(name, value) for name, value in given.items()}
        default = next(iter(quantity_of(run.quantity).on_rasters))
        model, receiver = options.pop("model", "joined"), options.pop("receiver", default)
        return cls(str(run.mesh), run.quantity, model, receiver, tuple(sorted(options.items())))

    @property
    def files(self) -> list[Path]:
        """Paths of all input files: rasters and weather."""
        rasters = [self.source, *(value for name, value in self.options if name in ("canopy", "trunk", "far"))]
        weather = [Path(value) for name, value in self.options if name == "weather"]
        return [file for path in rasters if isinstance(path, str) for file in files_read(path)] + weather

    def read(self) -> tuple[RasterRun, dict[str, Any]]:
        """Check the input files; return the computation, and attributes (arguments, place on the map) that identify it."""
        how = {"model": self.model, "receiver": self.receiver}
        run, about = run_of(quantity_of(self.quantity), self.source, dict(self.options), **how)
        about.pop("workers", None)
        for name, raster in run.rasters.items():
            about |= {f"{name}_{what}": value for what, value in place_of(raster).items()}
        if "weather" in run.options:
            weather = run.options["weather"] = read_weather(run.options["weather"])
            about["weather_content"] = weather.digest
        return run, about | {STREAMS_OF: STREAMS, **{name: version(name) for name in VERSIONS}}


_RASTER_OPTIONS = ("model", "receiver", "canopy", "trunk", "tile", "margin", "far")
"""Options of rasters in `BakeRun.more`."""


def _to_plain(name: str, value: Any) -> Any:
    """Return a path as a string, a numeric trunk as a float, transmittances as floats, and other values unchanged.

    Several transmittances are separated by commas or, as in messages and in attributes of outputs, by blanks.
    """
    if name in ("trunk", "transmittance"):
        texts = re.split(r"\s*,\s*|\s+", str(value).strip()) if name == "transmittance" else [value]
        try:
            numbers = tuple(map(float, texts))
            return numbers[0] if len(numbers) == 1 else numbers
        except ValueError:
            return value
    return str(value) if isinstance(value, Path) else value


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
    raster.check()
    if run.output.suffix in GEOTIFF:
        check_reference(raster, run.output, "--output")
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
        cell: Width of a cell in units of the map.
        north: Direction of true north on the picture, to the right and up.
    """

    run: BakeRun
    result: Any
    shape: tuple[int, int]
    cell: float
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
        cell, north = abs(float(outline.transform.a)), (float(outline.north[0]), float(outline.north[1]))
        return cls(run, found, raster.reader.shape, cell, north)

    @property
    def quantity(self) -> Quantity:
        """Description of the computed quantity: its name, unit and options."""
        return quantity_of(self.run.quantity)


def describe_heights(digests: Mapping[str, np.ndarray]) -> dict[str, str]:
    """Return a hash of each input raster, as an attribute of the run, from the hashes of its blocks."""
    return {f"{name}{HEIGHTS_OF}": digest_of(found) for name, found in digests.items()}


def check_unchanged(
    job: RasterJob, kept: Mapping[str, Any], store: Path, digests: Mapping[str, np.ndarray] | None = None
) -> RasterRun:
    """Read a computation's input files again, and raise an error if any has changed since the computation began.

    Args:
        job: Computation to run.
        kept: Attributes of the store.
        store: Path of the store, for the error message.
        digests: Digests of the blocks of each raster when the run began, by name. Default: None, read the rasters again.

    Raises:
        ValueError: if an input file has changed; the message names the input.
    """
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", UserWarning)  # warnings about the rasters were shown before the first tile
        run, about = job.read()
    about |= describe_heights(digests or {name: digests_of(raster) for name, raster in run.rasters.items()})
    for name, now in about.items():
        if kept.get(name) != now:
            raise ValueError(
                f"{name.rpartition('_')[0] or name}: got {name} {quote(now)}, which was {quote(kept.get(name))} when the "
                f"run began; with the original file {store} can be resumed"
            )
    return run


def read_unchanging(job: RasterJob, kept: Mapping[str, Any], store: Path, digests: Mapping[str, np.ndarray]) -> RasterRun:
    """Return a computation whose reads raise an error where an input raster has changed since the computation began."""
    run = check_unchanged(job, kept, store, digests)
    return run.reading({name: unchanging(raster, digests[name], name) for name, raster in run.rasters.items()})


def summarize_tile(arrays: Mapping[str, np.ndarray]) -> np.void:
    """Return the number, sums and range of the values in a tile, as a NumPy record of dtype SUMMARY."""
    return summarize(arrays["value"].ravel(), arrays["standard_error"].ravel(), 0)
