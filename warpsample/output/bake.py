"""Writes numbers at the points of a mesh into a file: `warpsample bake`."""

from collections.abc import Iterator
from pathlib import Path
from time import perf_counter
from typing import Any, Protocol

import numpy as np

from warpsample.estimate.quantities.record import Numbers, Quantity
from warpsample.estimate.result import PointStatus, Skipped
from warpsample.host.device_memory import Memory
from warpsample.host.files import check_output, complete_or_absent
from warpsample.mesh.files import load_mesh
from warpsample.mesh.files.beside import files_beside
from warpsample.mesh.surface import SurfacePoints
from warpsample.output.baked import WRITERS, Baked, BakeRun, check_glb, writers_of
from warpsample.output.by_parts import check_parts, city_of, is_by_parts, points_of_parts, write_parts
from warpsample.output.faces_option import with_optics
from warpsample.output.kept_glb import keeps, told_of_kept
from warpsample.output.places import check_places, points_on
from warpsample.output.quantities import check_options, quantity_of
from warpsample.output.report import check_report, write_report
from warpsample.output.terminal_bar import terminal_bar
from warpsample.plotting.rendering import check_rendering
from warpsample.radiation.sky.sky_matrix import SkySkipped

SUFFIXES = tuple(WRITERS)

RAYS_PER_PART = 1 << 22
"""Rays, half a second, after which the progress moves and an interrupt says how far it came."""

_TRIED = 1 << 14  # points of a part with a tolerance, whose trial takes a share of them
_RAYS = 256  # of a point, where a quantity takes no number of them
_FULL = 1 << 20  # points of a part on a CUDA device: with fewer it is idle for most of the time


def bake(run: BakeRun) -> str:
    """Runs and writes `run.output`, which appears when it is complete; an interrupted run leaves the old file.

    Gives a report in sentences. An argument that cannot be used is refused before anything is computed; a KeyboardInterrupt
    says how far it was, and a WriteError that the file cannot be written.
    """
    quantity = quantity_of(run.quantity)
    _check(run, quantity)
    city = city_of(run)
    mesh = with_optics(load_mesh(run.mesh) if city is None else city.mesh, **run.optics)
    into_itself = city is None and keeps(run.mesh, run.output, run.at)
    said = told_of_kept(run.mesh) if into_itself else []
    if run.output.suffix == ".glb" and not into_itself:
        check_glb(run, mesh)
    by_parts = is_by_parts(run)
    points = points_of_parts(run, mesh, city) if by_parts else points_on(mesh, run.points, run.at, run.options["seed"])
    numbers = quantity.numbers(mesh, len(points), run.options)
    numbers(points.take(slice(0, 1)), 0)  # builds the tree and the kernel
    start = perf_counter()
    found = quantity.joined(list(numbers_by_parts(points, run, quantity, numbers)))
    seconds = perf_counter() - start
    baked = Baked(run, mesh, points, found)
    if by_parts:
        write_parts(baked, city)
    else:
        with complete_or_absent(run.output) as file:
            writers_of(quantity)[run.output.suffix](file, baked)
    if run.report is not None:
        write_report(run.report, baked, city)
        said = [*said, f"{run.report}: a report, with a histogram, all arguments and, where pictures can be drawn, one"]
    return "\n  ".join([_summary(run, quantity, found, seconds), *said])


def _check(run: BakeRun, quantity: Quantity) -> None:
    check_parts(run, quantity)
    suffixes = tuple(writers_of(quantity))
    if not is_by_parts(run) and run.output.suffix not in suffixes:
        raise ValueError(f"--output: got {str(run.output)!r}, want a file that ends in one of {' '.join(suffixes)}")
    if run.output.suffix == ".png":
        check_rendering()
    if quantity.is_matrix and run.report is not None:
        raise ValueError(f"--report: got {run.report.name!r} for {quantity.name}, want one of a few numbers at each point")
    check_report(run.report, run.mesh, run.output)
    Memory.of(run.options.get("device"))
    files = [run.options.get(option) for option in quantity.files]
    check_output(
        run.output, "--output", run.mesh, *files_beside(run.mesh), *files, *([Path(run.context)] if run.context else [])
    )
    check_places(run.points, run.at)
    if run.points is not None and run.output.suffix in (".ply", ".glb"):
        raise ValueError(
            f"--output: got {run.output.name!r} for --points, want .vtp, .npz or .csv; "
            f"a {run.output.suffix} holds the numbers of vertices or faces (--at)"
        )
    check_options(quantity, run.options)


class Takeable(Protocol):
    """Points that are taken part by part."""

    def __len__(self) -> int:
        """How many there are."""

    def take(self, rows: slice) -> SurfacePoints:
        """Some of them."""


def numbers_by_parts(points: Takeable, run: BakeRun, quantity: Quantity, numbers: Numbers) -> Iterator[Any]:
    """The numbers part by part, with a progress bar if stderr is a terminal."""
    rays = run.options.get("samples") or quantity.default("samples") or _RAYS
    least = _TRIED if run.options.get("tolerance") else 1
    step = max(least if Memory.of(run.options.get("device")).in_place else _FULL, RAYS_PER_PART // rays)
    cast, start, done = 0, perf_counter(), 0
    with terminal_bar() as progress:
        task = progress.add_task(quantity.title, total=len(points), told="")
        try:
            for first in range(0, len(points), step):
                part = numbers(points.take(slice(first, first + step)), first)
                cast, done = cast + int(part.rays.sum()), min(first + step, len(points))
                error = float(np.sqrt(np.mean(np.square(part.standard_error))))
                speed = cast / (perf_counter() - start) / 1e6
                progress.update(task, completed=done, told=f"{speed:.1f} million rays/s, standard error {error:.2g}")
                yield part
        except KeyboardInterrupt as interrupt:  # raised again itself: it may stand for another signal
            interrupt.args = (f"interrupted after {done:,} of {len(points):,} points; {run.output} is as it was before",)
            raise


def _summary(run: BakeRun, quantity: Quantity, found: Any, seconds: float) -> str:
    good = found.status == 0
    cast = int(found.rays.sum(dtype=np.int64))
    lines = [f"{run.output}: {quantity.title} of {len(good):,} {run.at or 'points'}"]
    if good.any():
        error = float(np.sqrt(np.mean(np.square(found.standard_error[good]))))
        mean = f"mean {found.value[good].mean():.4f} {quantity.unit}".rstrip()
        lines.append(f"{mean}; standard error {error:.2g}, root mean square over the points" if cast else mean)
    rays = f"{cast:,} rays cast in {seconds:.2f} s, {cast / max(seconds, 1e-9) / 1e6:.1f} million a second"
    lines += [rays if cast else f"took {seconds:.2f} s", *_skips(getattr(found, "skipped", None))]
    bad = {PointStatus(code): int(n) for code, n in enumerate(np.bincount(found.status)) if n and code != PointStatus.OK}
    if bad:
        lines.append("points without a number: " + ", ".join(f"{n:,} {status.name.lower()}" for status, n in bad.items()))
    return "\n  ".join(lines)


def _skips(skipped: Skipped | SkySkipped | None) -> Iterator[str]:
    """What was not done, in sentences."""
    if isinstance(skipped, SkySkipped):
        yield from _told("sky patches without rays: ", {"open": skipped.open_patches, "closed": skipped.closed_patches})
    if isinstance(skipped, Skipped):
        told = {
            "in empty strata": skipped.empty_rays,
            "without weight": skipped.weightless_rays,
            "not needed for the tolerance": skipped.unneeded_rays,
        }
        yield from _told("rays skipped: ", told)
    if skipped is not None and skipped.open_points:
        yield f"{skipped.open_points:,} {'point' if skipped.open_points == 1 else 'points'} needed no rays"


def _told(what: str, counts: dict[str, int]) -> Iterator[str]:
    """The numbers that are not 0, if any."""
    if any(counts.values()):
        yield what + ", ".join(f"{n:,} {name}" for name, n in counts.items() if n)
