"""`warpsample bake` of a mesh or CityJSON into a file: compute part by part, write, and report."""

from collections.abc import Iterator
from typing import Any, Protocol

import numpy as np

from warpsample.estimate.quantities.record import Numbers, Quantity
from warpsample.estimate.result import PointStatus, Skipped
from warpsample.host.device_memory import Memory
from warpsample.host.files import complete_or_absent
from warpsample.mesh.surface import SurfacePoints
from warpsample.output.bake_rules import is_by_parts
from warpsample.output.baked import WRITERS, Baked, writers_of
from warpsample.output.by_parts import write_parts
from warpsample.output.report import write_report
from warpsample.output.run_record import RunRecord, summarize_result
from warpsample.output.source import Source
from warpsample.radiation.sky.sky_matrix import SkySkipped

SUFFIXES = tuple(WRITERS)

RAYS_PER_PART = 1 << 22
"""Rays of a part, half a second, after which the progress bar moves."""

_TRIED = 1 << 14  # points of a part with a tolerance, whose trial takes a share of them
_RAYS = 256  # rays per point, for quantities without a number of rays
_FULL = 1 << 20  # points of a part on a CUDA device, which is idle most of the time with fewer points


def bake(source: Source, record: RunRecord) -> str:
    """Compute the quantity of a `warpsample bake` command, write the output file, and return a report in lines.

    The file appears when it is complete; an interrupt leaves the old file.

    Args:
        source: Source of the run, as `read_source` returns it.
        record: Record of the run.

    Returns:
        a report for the terminal, in lines.

    Raises:
        TypeError, ValueError: an option of the quantity that cannot be used, or an input .glb that has changed meanwhile.
        KeyboardInterrupt: the run is interrupted; the message states how many points are done.
        WriteError: the file cannot be written.
    """
    run, points = source.run, source.points
    found = _compute(source, record)
    notes = _write(Baked(run, source.mesh, points, found), source)
    first = f"{run.output}: {record.title} of {len(points):,} {run.at or 'points'}"
    return "\n  ".join([first, *record.describe(), *_describe_skips(found), *source.notes, *notes])


def _compute(source: Source, record: RunRecord) -> Any:
    """Compute the quantity of a `warpsample bake` command at all points, part by part, and return the result."""
    quantity, points, options = source.quantity, source.points, source.run.options
    numbers = quantity.numbers(source.mesh, len(points), options)
    numbers(points.take(slice(0, 1)), 0)  # builds the tree and the kernel
    with record.count(len(points), f"{source.run.output} is as it was before"):
        return quantity.joined(list(compute_parts(points, numbers, part_size(quantity, options), record)))


def part_size(quantity: Quantity, options: dict[str, Any]) -> int:
    """Return the number of points to compute at a time, between two updates of the progress bar."""
    rays = options.get("samples") or quantity.default("samples") or _RAYS
    least = _TRIED if options.get("tolerance") else 1
    return max(least if Memory.of(options.get("device")).in_place else _FULL, RAYS_PER_PART // rays)


class Takeable(Protocol):
    """Interface of a set of points with a method to select a range, for example SurfacePoints."""

    def __len__(self) -> int:
        """Return the number of points."""

    def take(self, rows: slice) -> SurfacePoints:
        """Return the points of the selected rows."""


def compute_parts(points: Takeable, numbers: Numbers, size: int, record: RunRecord) -> Iterator[Any]:
    """Compute a quantity for `size` points at a time, yield each result, and add each to the progress record."""
    for first in range(0, len(points), size):
        part = numbers(points.take(slice(first, first + size)), first)
        record.add(summarize_result(part, record.vectors))
        yield part


def _write(baked: Baked, source: Source) -> list[str]:
    """Write the output file and the .html report of a `warpsample bake` command; return a sentence on the report."""
    run = baked.run
    if is_by_parts(run):
        write_parts(baked, source.city)
    else:
        with complete_or_absent(run.output) as file:
            writers_of(baked.quantity)[run.output.suffix](file, baked)
            source.state.check()
    if run.report is None:
        return []
    write_report(run.report, baked, source.city)
    return [f"{run.report}: a report with histogram and arguments, and a picture if this machine can draw one"]


def _describe_skips(found: Any) -> Iterator[str]:
    """Yield sentences with the numbers of skipped rays and of points without a value."""
    skipped = getattr(found, "skipped", None)
    if isinstance(skipped, SkySkipped):
        yield from _describe(
            "sky patches known without rays: ", {"open": skipped.open_patches, "covered": skipped.closed_patches}
        )
    if isinstance(skipped, Skipped):
        counts = {
            "known to hit nothing": skipped.empty_rays,
            "of weight 0, such as below the horizon": skipped.weightless_rays,
            "not needed for the tolerance": skipped.unneeded_rays,
        }
        yield from _describe("rays skipped: ", counts)
    if skipped is not None and skipped.open_points:
        points, whose = ("point", "its") if skipped.open_points == 1 else ("points", "their")
        yield f"{skipped.open_points:,} {points} cast no rays, because {whose} open directions are known"
    bad = {PointStatus(code).name.lower(): int(n) for code, n in enumerate(np.bincount(found.status)) if code}
    yield from _describe("points without a value: ", bad)


def _describe(what: str, counts: dict[str, int]) -> Iterator[str]:
    """Yield one sentence that lists the names with a count above 0, or nothing if all counts are 0."""
    if any(counts.values()):
        yield what + ", ".join(f"{n:,} {name}" for name, n in counts.items() if n)
