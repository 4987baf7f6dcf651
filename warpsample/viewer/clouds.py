"""What the viewer draws of a choice: clouds of directions, and the histograms of their angles."""

from dataclasses import dataclass

import numpy as np

from warpsample import sequences
from warpsample.directions.sample import sample_directions
from warpsample.mesh.surface import SurfacePoints
from warpsample.plotting.angle_histogram import AngleHistogram
from warpsample.proof.twins import frames
from warpsample.statistics.charts import SPHERE
from warpsample.statistics.histogram import joined_test
from warpsample.viewer.choice import Choice
from warpsample.viewer.lobes import CELLS, SECTORS, LobeShape, lobe_of

OUTSIDE = 0.5
"""Where directions of density 0 are drawn, as a share of the lobe's length."""


@dataclass(frozen=True, eq=False)
class Clouds:
    """Directions at all points, drawn as points of their lobes' surfaces, and their angles to and about the normals.

    `position`: (N, 3) float32, in the coordinates of the points; `pdf`: (N,) float32, the claimed density per steradian, 0
    outside its support. Azimuths are from each point's tangent.
    """

    position: np.ndarray
    pdf: np.ndarray
    theta: AngleHistogram
    azimuth: AngleHistogram

    @property
    def outside(self) -> int:
        """The number of directions with a claimed density of 0."""
        return int(np.count_nonzero(self.pdf == 0.0))


@dataclass(frozen=True, eq=False)
class Chosen:
    """Directions at one point, in its tangent frame: `disk` has their tangent components, (n, 2).

    `position`: (n, 3) float32, of the lobe's surface, at most 1 from the origin; `pdf`: (n,), the claimed density per
    steradian.
    """

    position: np.ndarray
    pdf: np.ndarray
    disk: np.ndarray


def all_clouds(choice: Choice, points: SurfacePoints, scale: float) -> Clouds:
    """The clouds at all points; `scale` is the length of a lobe in the unit of their positions."""
    lobe = lobe_of(choice.claim)
    world, local, pdf = _directions(choice, points, 0)
    length = (np.float32(scale) * _lengths(pdf, lobe.peak))[..., None]
    position = points.position[:, None].astype(np.float32) + length * world
    return Clouds(
        position.reshape(-1, 3), pdf.ravel(), *histograms(local.reshape(-1, 3), lobe, sequences.get(choice.sequence).random)
    )


def one_cloud(choice: Choice, point: SurfacePoints, first: int) -> Chosen:
    """The cloud at one point, whose global id is `first`."""
    _, local, pdf = _directions(choice, point, first)
    length = _lengths(pdf[0], lobe_of(choice.claim).peak)[:, None]
    return Chosen(length * local[0], pdf[0], local[0, :, :2])


def histograms(local: np.ndarray, lobe: LobeShape, independent: bool) -> tuple[AngleHistogram, AngleHistogram]:
    """The angles of unit directions, (N, 3) with +z the normal, to it and about it, each with what the lobe predicts."""
    cell = np.minimum((SPHERE.polar(local) * (CELLS / lobe.edges[-2])).astype(np.intp), CELLS)
    sector = np.minimum((SPHERE.azimuth(local) * SECTORS).astype(np.intp), SECTORS - 1)
    around = np.linspace(0.0, 2.0 * np.pi, SECTORS + 1)
    middle = 0.5 * (around[1:] + around[:-1])
    density = lobe.azimuth * SECTORS / (2.0 * np.pi)
    theta, azimuth = np.bincount(cell, minlength=CELLS + 1), np.bincount(sector, minlength=SECTORS)
    return (
        _histogram(theta, lobe.theta, lobe.edges, angles=lobe.angles, line=lobe.line, independent=independent),
        _histogram(azimuth, lobe.azimuth, around, angles=middle, line=density, independent=independent),
    )


def _histogram(
    observed: np.ndarray, masses: np.ndarray, edges: np.ndarray, *, angles: np.ndarray, line: np.ndarray, independent: bool
) -> AngleHistogram:
    """The bins that the chart shows; the test is over all bins, also those beyond the chart."""
    total = observed.sum()
    shown = min(len(masses), CELLS)
    expected = total * masses
    deviation = np.sqrt(np.maximum(expected * (1.0 - masses), 1e-9))
    residuals = np.where(expected >= 1.0, (observed - expected) / deviation, 0.0)[:shown]
    return AngleHistogram(
        edges=np.degrees(edges[: shown + 1]),
        observed=observed[:shown] / (total * np.diff(edges)[:shown]),
        expected=masses[:shown] / np.diff(edges)[:shown],
        angles=np.degrees(angles),
        density=line,
        residuals=residuals,
        test=joined_test(observed, expected),
        independent=independent,
    )


def _directions(choice: Choice, points: SurfacePoints, first: int) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Directions (P, n, 3) in the world, the same in the tangent frames, and (P, n) claimed densities."""
    own = choice.claim == choice.distribution
    found = sample_directions(
        points.normal,
        choice.samples,
        distribution=choice.distribution,
        sequence=choice.sequence,
        seed=choice.seed,
        first_point=first,
        pdf=own,
    )
    unit = points.normal / np.linalg.norm(points.normal, axis=1, keepdims=True)
    local = np.matmul(found.vectors, frames(unit.astype(np.float64)).astype(np.float32))
    return found.vectors, local, found.pdf if own else choice.claim.pdf(local)


def _lengths(pdf: np.ndarray, peak: float) -> np.ndarray:
    return np.where(pdf > 0.0, np.minimum(pdf / np.float32(peak), np.float32(1.0)), np.float32(OUTSIDE))
