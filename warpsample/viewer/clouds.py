"""Sampled directions as point clouds for the viewer, and the counts of their angles."""

from dataclasses import dataclass, replace

import numpy as np

from warpsample import sequences
from warpsample.directions.sample import sample_directions
from warpsample.distributions.record import Distribution
from warpsample.mesh.surface import SurfacePoints
from warpsample.viewer.choice import Choice
from warpsample.viewer.counts import AngleCounts, count_directions
from warpsample.viewer.lobes import peaks_of, probabilities_of, shape_of
from warpsample.viewer.own_lobes import constant_lobes, usable_rows

OUTSIDE = 0.5
"""Distance of drawn directions with a density of 0 from their point, as a share of the lobe's length."""
MOST_COUNTED = 100
"""Number of points whose directions are counted, if the lobes of points differ: the integrals take 4 ms for a point."""


@dataclass(frozen=True, eq=False)
class Clouds:
    """Point clouds of sampled directions at all points of the mesh.

    A direction is drawn as a dot on the surface of the lobe at its point.

    Attributes:
        position: (N, 3) float32, drawn positions in the coordinates of the points.
        pdf: (N,) float32, compared density per steradian; 0 outside its support.
        color: (N,) numbers for the colours: `pdf`, or, if the lobes of points differ, `pdf` as a share of the largest
            density at the point.
        peak: number with the last colour.
        rows: (p,) rows of the points with directions. Others have invalid parameters, such as a view from below.
        local: (p, n, 3) float32 directions in the tangent frames of these points.
    """

    position: np.ndarray
    pdf: np.ndarray
    color: np.ndarray
    peak: float
    rows: np.ndarray
    local: np.ndarray

    @property
    def outside(self) -> int:
        """Number of directions at which the compared density is 0."""
        return int(np.count_nonzero(self.pdf == 0.0))


@dataclass(frozen=True, eq=False)
class NearCloud:
    """Point cloud of the directions at the selected point, relative to the point's tangent frame.

    Attributes:
        position: (n, 3) float32, positions on the surface of the lobe, at most 1 from the origin.
        pdf: (n,) compared density per steradian.
        disk: (n, 2) components of the directions along the tangent and the bitangent.
        lobe: distribution that the directions are compared with, with constant parameters.
    """

    position: np.ndarray
    pdf: np.ndarray
    disk: np.ndarray
    lobe: Distribution


def all_clouds(choice: Choice, points: SurfacePoints, scale: float) -> Clouds:
    """Sample directions at all points of the mesh.

    Args:
        choice: settings, whose parameters by point have a row for each point.
        points: P points, whose tangents set the x axes of the frames.
        scale: length of a lobe in the unit of the points.
    """
    rows, world, local, pdf = _sample_compared(choice, points, 0)
    if choice.claim.by_point:
        share = pdf / peaks_of(choice.claim.take(rows), len(rows))[:, None]
        color, peak = share, 1.0
    else:
        color, peak = pdf, shape_of(choice.claim).peak
        share = pdf / np.float32(peak)
    length = (np.float32(scale) * _lengths(share))[..., None]
    position = points.position[rows, None].astype(np.float32) + length * world
    return Clouds(position.reshape(-1, 3), pdf.ravel(), color.ravel(), peak, rows, local)


def count_clouds(choice: Choice, clouds: Clouds) -> AngleCounts | None:
    """Count the angles of the directions of clouds, and compare the counts with the densities; None without directions.

    If the lobes of points differ, the directions of the first MOST_COUNTED points are counted.

    Raises:
        ValueError: a lobe is too narrow, or its density cannot be integrated.
    """
    rows, local, claim = clouds.rows, clouds.local, choice.claim
    if not len(rows):
        return None
    independent = sequences.get(choice.sequence).random
    if claim.by_point:
        rows, local = rows[:MOST_COUNTED], local[:MOST_COUNTED]
        probabilities = probabilities_of(claim.take(rows), len(rows))
    else:
        probabilities = probabilities_of(claim)
    return count_directions(local.reshape(-1, 3), probabilities, independent, choice.claim_name)


def one_cloud(choice: Choice, point: SurfacePoints, first: int) -> NearCloud | None:
    """Sample the directions at the selected point, which has the global id `first`.

    Return None if the point has no directions, as for a view from below.
    """
    rows, _, local, pdf = _sample_compared(choice, point, first)
    if not len(rows):
        return None
    lobe = constant_lobes(choice.claim)[0]
    length = _lengths(pdf[0] / np.float32(shape_of(lobe).peak))[:, None]
    return NearCloud(length * local[0], pdf[0], local[0, :, :2], lobe)


def _sample_compared(
    choice: Choice, points: SurfacePoints, first: int
) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
    """Sample directions at points, and compute the densities that the directions are compared with.

    Returns:
        (p,) rows of the points with directions; (p, n, 3) world directions; (p, n, 3) local ones; (p, n) compared densities.
    """
    own = choice.claim == choice.distribution
    found = sample_directions(
        replace(points, id=None),
        choice.samples,
        distribution=choice.distribution,
        sequence=choice.sequence,
        seed=choice.seed,
        first_point=first,
        pdf=own,
    )
    rows = np.arange(len(points))[usable_rows(choice.distribution, choice.claim)]
    local = points.to_local(found.vectors)[rows]
    pdf = found.pdf[rows] if own else choice.claim.take(rows).pdf(local)
    return rows, found.vectors[rows], local, pdf


def _lengths(share: np.ndarray) -> np.ndarray:
    """Return the lengths of drawn directions, for densities as shares of the density with length 1."""
    return np.where(share > 0.0, np.minimum(share, np.float32(1.0)), np.float32(OUTSIDE))
