"""Description of a computation on raster files, and its check that the files stay the same while it runs."""

import re
import warnings
from collections.abc import Mapping
from dataclasses import dataclass
from importlib.metadata import version
from pathlib import Path
from typing import Any

import numpy as np

from warpsample.city.rasters.datasets import run_of
from warpsample.city.rasters.sources.inputs import files_read
from warpsample.city.rasters.tiles import RasterRun
from warpsample.estimate.quantities.record import ARGUMENTS
from warpsample.host.arguments import quote
from warpsample.host.shared_values import HEIGHTS_OF, digest_of
from warpsample.output.baked import BakeRun
from warpsample.output.quantities import quantity_of
from warpsample.output.rasters.content import digests_of, place_of, unchanging
from warpsample.radiation.weather.weather import read_weather
from warpsample.sequences.record import STREAMS

STREAMS_OF, VERSIONS = "streams", ("warpsample", "warp-lang")
"""Attributes of the random streams, and the libraries whose versions determine the values."""


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
