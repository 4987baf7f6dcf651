"""Sampled directions as point clouds for the viewer, and histograms of their angles."""

from dataclasses import dataclass
from typing import Any

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
"""Distance of drawn directions with a density of 0 from their point, as a share of the lobe's length."""


@dataclass(frozen=True, eq=False)
class Clouds:
    """Point clouds of sampled directions at all points of the mesh, and histograms of all their angles.

    A direction is drawn as a dot on the surface of the lobe at its point.

    Attributes:
        position: (N, 3) float32, drawn positions in the coordinates of the points.
        pdf: (N,) float32, compared density per steradian; 0 outside its support.
        theta: histogram of the angles to the normals.
        azimuth: histogram of the angles about the normals, from the tangent of each point.
    """

    position: np.ndarray
    pdf: np.ndarray
    theta: AngleHistogram
    azimuth: AngleHistogram

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
    """

    position: np.ndarray
    pdf: np.ndarray
    disk: np.ndarray


def all_clouds(choice: Choice, points: SurfacePoints, scale: float) -> Clouds:
    """Sample directions at all points of the mesh, and count the angles in histograms.

    `scale` is the length of a lobe in the unit of the points.
    """
    lobe = lobe_of(choice.claim)
    world, local, pdf = _sample_compared(choice, points, 0)
    length = (np.float32(scale) * _lengths(pdf, lobe.peak))[..., None]
    position = points.position[:, None].astype(np.float32) + length * world
    independent = sequences.get(choice.sequence).random
    theta, azimuth = histograms(local.reshape(-1, 3), lobe, independent, choice.claim_name)
    return Clouds(position.reshape(-1, 3), pdf.ravel(), theta, azimuth)


def one_cloud(choice: Choice, point: SurfacePoints, first: int) -> NearCloud:
    """Sample the directions at the selected point, which has the global id `first`."""
    _, local, pdf = _sample_compared(choice, point, first)
    length = _lengths(pdf[0], lobe_of(choice.claim).peak)[:, None]
    return NearCloud(length * local[0], pdf[0], local[0, :, :2])


def histograms(
    local: np.ndarray, lobe: LobeShape, independent: bool, claim: str = "the density"
) -> tuple[AngleHistogram, AngleHistogram]:
    """Build histograms of the directions' polar angle and azimuth, and compare both with a density by chi-square tests.

    Args:
        local: (N, 3) unit directions with the normal along +z.
        lobe: compared lobe.
        independent: whether the directions are independent of each other.
        claim: name of the compared density.
    """
    cell = np.minimum((SPHERE.polar(local) * (CELLS / lobe.edges[-2])).astype(np.intp), CELLS)
    sector = np.minimum((SPHERE.azimuth(local) * SECTORS).astype(np.intp), SECTORS - 1)
    around = np.linspace(0.0, 2.0 * np.pi, SECTORS + 1)
    middle = 0.5 * (around[1:] + around[:-1])
    density = lobe.azimuth * SECTORS / (2.0 * np.pi)
    theta, azimuth = np.bincount(cell, minlength=CELLS + 1), np.bincount(sector, minlength=SECTORS)
    names = {"independent": independent, "claim": claim}
    return (
        _build_histogram(theta, lobe.theta, lobe.edges, angles=lobe.angles, line=lobe.line, **names),
        _build_histogram(azimuth, lobe.azimuth, around, angles=middle, line=density, **names),
    )


def _build_histogram(
    observed: np.ndarray, masses: np.ndarray, edges: np.ndarray, *, angles: np.ndarray, line: np.ndarray, **names: Any
) -> AngleHistogram:
    """Build the histogram of one angle, with a chi-square test against the expected counts.

    The test includes bins that are outside the chart.
    """
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
        **names,
    )


def _sample_compared(choice: Choice, points: SurfacePoints, first: int) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Sample directions at points; return world and local directions, (P, n, 3) each, and their densities, (P, n)."""
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
