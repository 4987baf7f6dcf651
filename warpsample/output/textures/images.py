"""Images of a quantity at the texels of a mesh, or at the points of a finer mesh beneath the texels."""

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from warpsample.estimate.intervals import errors_for_means, raised_errors
from warpsample.estimate.quantities.record import Quantity
from warpsample.estimate.quantities.thickness import Thickness
from warpsample.estimate.result import ExactResult, PointStatus
from warpsample.host.engine import check_memory, check_workers
from warpsample.mesh.surface import SurfacePoints
from warpsample.output.bake import compute_parts, part_size
from warpsample.output.baked import BakeRun
from warpsample.output.quantities import quantity_of
from warpsample.output.run_record import RunRecord
from warpsample.texture.high import HighMesh
from warpsample.texture.inside import Closed, Enclosed
from warpsample.texture.jobs import SCENES, TextureJob
from warpsample.texture.materials import slot_for_quantity
from warpsample.texture.report import TextureReport
from warpsample.texture.sets import TextureOptions
from warpsample.texture.tangents import FrameReader
from warpsample.texture.texture_points import TexturePoints, find_rows

COUNTS = ("inside", "enclosed", "mostly_inside", "missed", "lost")
"""Fields of `Filled` that are counts of points or charts."""


@dataclass(frozen=True, eq=False)
class Images:
    """Computed images of one texture.

    Attributes:
        value: (H, W) or (H, W, C) values, float32, or float64 for positions.
        error: Standard errors of the same shape, float32, raised where they ignore geometry that no ray has hit.
        unbiased: Standard errors that are 0 where all rays agree, without a gutter: their squares may be added.
        noise: Errors with which places are compared: the parts of `error` and `unbiased` that come from rays, without the
            spread of several samples within a texel. The whole errors if the texture is not compared.
        own: (H, W) bool, texels with a value of their own, which is no copy of another texel's value.
        points: Texels as points.
    """

    value: np.ndarray
    error: np.ndarray
    unbiased: np.ndarray
    noise: tuple[np.ndarray, np.ndarray]
    own: np.ndarray
    points: TexturePoints

    @property
    def known_error(self) -> float:
        """Root mean square of the unbiased standard errors of the covered texels."""
        return float(np.sqrt(np.mean(np.square(self.unbiased[self.points.covered], dtype=np.float64))))


@dataclass(frozen=True, eq=False)
class Filled:
    """Numbers on the computed images of one texture, such as counts of points without a value of their own.

    Attributes:
        job: Texture that the images belong to.
        report: Report on its coordinates.
        error: Root mean square of the standard errors of the texels.
        mean: Mean of the values at the points.
        inside: Number of points inside closed bodies that are filled.
        enclosed: Number of points inside closed bodies that keep their values.
        mostly_inside: Number of charts with more than half of their points filled for being inside.
        missed: Number of points without a hit on a finer mesh.
        lost: Number of points without a value for another reason.
        rays: Number of rays for the values.
        inside_rays: Number of rays to find points inside closed bodies.
    """

    job: TextureJob
    report: TextureReport
    error: float
    mean: float
    inside: int
    enclosed: int
    mostly_inside: int
    missed: int
    lost: int
    rays: int
    inside_rays: int


def fill_texture(
    job: TextureJob,
    points: TexturePoints,
    *,
    is_compared: bool,
    run: BakeRun,
    how: TextureOptions,
    closed: Closed,
    high: HighMesh | None,
    reader: FrameReader,
    record: RunRecord,
) -> tuple[Filled, Images]:
    """Compute a quantity at all texels of one texture, and return the images of values and standard errors.

    `points` are the texels of the job, and `is_compared` states whether the picture is compared with those of other places.
    """
    quantity, options = quantity_of(run.quantity), dict(run.options)
    if how.samples > 1 and quantity.takes("samples"):
        options["samples"] = max(2, (options.get("samples") or quantity.default("samples")) // how.samples)
    numbers = quantity.numbers(closed.mesh, len(points), options)
    workers = check_workers(options.get("workers"))
    missed, bodies = np.zeros(len(points), np.bool_), Enclosed(closed, points)
    looks = how.inside == "fill" and quantity.result is not ExactResult
    convert = _converter(job, points, run, quantity, reader)

    def of_part(part: SurfacePoints, first: int) -> Any:
        """Compute the quantity at a range of the texels' points, beginning with point number `first`."""
        rows, places = slice(first, first + len(part)), part
        if high is not None:
            places, missed[rows] = high.project(part, points.mesh, workers)
        if looks:
            bodies.add(first, part, places, workers)
        found = numbers(places, 0)  # the points have ids
        value = convert(found.value, places.normal, points.face[rows], part.barycentric)
        lost = ~np.isfinite(value.reshape(len(value), -1)).all(axis=1) & (found.status == 0)
        return replace(found, value=value, status=np.where(lost, np.uint8(PointStatus.NONFINITE_VALUE), found.status))

    errors_of = raised_errors if how.samples == 1 else errors_for_means
    kept, runs, rays, bad = [], list[np.ndarray](), 0, 0
    for part in compute_parts(points, of_part, part_size(quantity, options), record):
        if not kept:
            _check_memory(points, how.size, part.value)
        kept.append((np.where(part.status == 0, part.value.T, np.nan).T, errors_of(part), part.standard_error))
        if how.samples > 1 and getattr(part, "reflected_runs", None) is not None:
            runs.append(part.reflected_runs)
        rays, bad = rays + int(part.rays.sum(dtype=np.int64)), bad + int(np.count_nonzero(part.status))
    value, error, unbiased = (np.concatenate(arrays) for arrays in zip(*kept, strict=True))
    del kept
    buried = bodies.find_buried(np.isfinite(value.reshape(len(value), -1)).all(axis=1)) & ~missed
    within, kept_own, none = (int(np.count_nonzero(some)) for some in (buried, bodies.inside & ~buried & ~missed, missed))
    value[buried] = np.nan
    images, mean = _make_images(points, how, value, error, unbiased, runs, is_compared=is_compared)
    charts = bodies.count_mostly_buried(buried)
    counts = {"mostly_inside": charts, "inside": within, "enclosed": kept_own, "missed": none, "lost": bad - none}
    numbers_of_rays = {"rays": rays, "inside_rays": bodies.rays}
    return Filled(job, points.report, images.known_error, mean, **counts, **numbers_of_rays), images


def _check_memory(points: TexturePoints, size: tuple[int, int], value: np.ndarray) -> None:
    """Raise MemoryError if the values of a texture and its images do not fit into the free memory.

    Args:
        points: points of the texture.
        size: columns and rows of the images.
        value: (P, ...) values of some points.
    """
    (width, height), columns = size, int(np.prod(value.shape[1:]))
    # Bytes, fitted to the peaks of bakes of 1,000^2 and 3,000^2 texels, with 1 and 4 samples, of 1 and 3 columns.
    needed = len(points) * (14 + 19 * columns) + width * height * (15 + 42 * columns)
    check_memory(needed, f"values of {width} x {height} texels", "take fewer texels")


def _make_images(
    points: TexturePoints,
    how: TextureOptions,
    value: np.ndarray,
    error: np.ndarray,
    unbiased: np.ndarray,
    runs: list[np.ndarray],
    *,
    is_compared: bool,
) -> tuple[Images, float]:
    """Return the images of values at points and of their standard errors, and the mean of the values.

    `runs` holds, in parts, the light that faces reflect in each of its independent runs; empty without such light.
    """
    known, texels = np.isfinite(value), points.texel_rows
    mean = float(value.mean(where=known, dtype=np.float64)) if known.any() else float("nan")
    error[~known] = unbiased[~known] = np.nan
    rows = [some.reshape(len(value), -1) for some in (value, error, unbiased)]
    means, *errors = texels.means_and_errors(rows[0], rows[1:])
    if runs:
        shared = texels.shared_errors(rows[0], np.concatenate(runs))
        errors = [np.hypot(one, shared) for one in errors]
    own_texels = np.isfinite(means).all(axis=1).reshape(how.size[::-1])

    def fill(some: np.ndarray, gutter: Any, kind: Any = np.float32) -> np.ndarray:
        """Return the image of values at texels."""
        return texels.fill(some, gutter, value.shape[1:]).astype(kind)

    image = fill(means, how.gutter, value.dtype)  # positions are float64
    raised, plain = fill(errors[0], how.gutter), fill(errors[1], 0)
    noise = raised, plain
    if is_compared and how.samples > 1:
        least, own = texels.ray_errors(*rows)
        noise = fill(least, 0), fill(own, 0)
    return Images(image, raised, plain, noise, own_texels, points), mean


def _converter(
    job: TextureJob, points: TexturePoints, run: BakeRun, quantity: Quantity, reader: FrameReader
) -> Callable[[np.ndarray, np.ndarray, np.ndarray, np.ndarray], np.ndarray]:
    """Return the function that converts values for the picture, for example to tangent-space normals.

    Its arguments are the values, the normals along which they are computed, the faces, and the barycentric weights.
    """
    if slot_for_quantity(quantity.name).directed and run.output.suffix in (*SCENES, ".png"):
        frames = reader.frames(points.corners, points.faces, job.group)
        return lambda value, _, face, weights: frames.to_components(value, find_rows(points, face), weights)
    if quantity.result is Thickness and job.group:
        return job.convert_lengths
    return lambda value, *_: value
