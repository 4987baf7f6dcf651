"""What the viewer shows of a choice: clouds, the density they should have, and how well they keep to it."""

from dataclasses import dataclass, fields
from functools import lru_cache

import numpy as np

from warpsample.directions.sample import sample_directions, sample_square
from warpsample.distributions.record import Distribution
from warpsample.mesh.surface import SurfacePoints
from warpsample.plotting.charts import AngleHistogram
from warpsample.proof.twins import frames
from warpsample.statistics.charts import SPHERE
from warpsample.statistics.histogram import joined_test
from warpsample.statistics.quadrature import cell_masses

CELLS, SECTORS = 45, 24
_FINE = 8  # points of the density's line in a cell
_RINGS, _SPOKES = 96, 72
_PILOT = 4096
_ALMOST_ALL = 0.998
_TALLEST = 8.0  # times the median density: what rises higher (an offset sphere's edge) is cut
OUTSIDE = 0.5
"""Where directions of density 0 are drawn, as a share of the lobe's length."""
_NARROWEST = 1e-2  # degrees
_ROUND = (0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1, 2, 3, 6, 12, 18, 24, 30, 45, 60, 90, 120, 180)  # degrees


@dataclass(frozen=True)
class Choice:
    """What the knobs say.

    Attributes:
        distribution: whose directions are drawn.
        density: what they are held against; None for the distribution's own.
        sequence: a name.
        samples: directions at each point.
        seed: of the directions.
    """

    distribution: Distribution
    density: Distribution | None = None
    sequence: str = "sobol"
    samples: int = 1024
    seed: int = 0

    @property
    def claim(self) -> Distribution:
        """What the directions are held against."""
        return self.density or self.distribution


@dataclass(frozen=True, eq=False)
class Lobe:
    """A density as a surface over the tangent plane, and its masses.

    Attributes:
        surface: (I, J, 3) local coordinates: directions times density over peak, at most 1.
        peak: density per steradian at which the surface has length 1.
        edges: (CELLS + 2,) radians; the last cell reaches from where the chart ends to pi.
        theta: (CELLS + 1,) chance of each.
        azimuth: (SECTORS,) chance of each.
        angles: (M,) radians, of `line`.
        line: (M,) density of theta per radian.
    """

    surface: np.ndarray
    peak: float
    edges: np.ndarray
    theta: np.ndarray
    azimuth: np.ndarray
    angles: np.ndarray
    line: np.ndarray


@dataclass(frozen=True, eq=False)
class Clouds:
    """Directions at all points, as points of their lobes' surfaces, and what they add up to.

    Attributes:
        position: (N, 3) float32, in the coordinates of the points.
        pdf: (N,) float32 per steradian, of what is claimed; 0 outside its support.
        theta: of all directions.
        azimuth: of all directions, about each point's tangent.
    """

    position: np.ndarray
    pdf: np.ndarray
    theta: AngleHistogram
    azimuth: AngleHistogram

    @property
    def outside(self) -> int:
        """How many directions have a claimed density of 0."""
        return int(np.count_nonzero(self.pdf == 0.0))


@dataclass(frozen=True, eq=False)
class Chosen:
    """Directions at one point, in its tangent frame.

    Attributes:
        position: (n, 3) float32, points of the lobe's surface, at most 1 long.
        pdf: (n,) float32 per steradian, of what is claimed.
        disk: (n, 2) tangent components of the directions.
    """

    position: np.ndarray
    pdf: np.ndarray
    disk: np.ndarray


def told(distribution: Distribution) -> str:
    """As the command line takes it, numbers to three digits: "ggx(alpha=0.1)", "cosine_hemisphere(method='offset')"."""
    names = type(distribution).parameters or [item.name for item in fields(distribution)]
    values = (f"{name}={_rounded(getattr(distribution, name))}" for name in names)
    return f"{distribution.name}({', '.join(values)})".replace("()", "")


def _rounded(value: float | str | tuple[float, ...]) -> str:
    if isinstance(value, str):
        return repr(value)
    return f"({', '.join(_rounded(v) for v in value)})" if isinstance(value, tuple) else f"{value:.3g}"


def all_clouds(choice: Choice, points: SurfacePoints, scale: float) -> Clouds:
    """The clouds at points, (P, 3); `scale` is the length of a lobe in the unit of their positions."""
    lobe = lobe_of(choice.claim)
    world, local, pdf = _directions(choice, points, 0)
    length = (np.float32(scale) * _lengths(pdf, lobe.peak))[..., None]
    position = points.position[:, None].astype(np.float32) + length * world
    return Clouds(position.reshape(-1, 3), pdf.ravel(), *histograms(local.reshape(-1, 3), lobe))


def one_cloud(choice: Choice, point: SurfacePoints, first: int) -> Chosen:
    """The cloud at one point, whose global id is `first`."""
    _, local, pdf = _directions(choice, point, first)
    length = _lengths(pdf[0], lobe_of(choice.claim).peak)[:, None]
    return Chosen(length * local[0], pdf[0], local[0, :, :2])


@lru_cache(maxsize=256)
def lobe_of(claim: Distribution) -> Lobe:
    """The density that a distribution claims.

    Raises:
        ValueError: it is narrower than float32 directions about a normal resolve.
    """
    pilot = claim.sample(sample_square("fibonacci", 1, _PILOT)[0])
    high = _reach(claim, pilot)
    edges = np.append(np.linspace(0.0, high, CELLS + 1), max(np.pi, high + 1e-9))
    theta, azimuth = _masses(claim, edges)
    fine = np.linspace(0.0, high, _FINE * CELLS + 1) if claim.symmetric else edges[:-1]
    line = (np.diff(claim.cdf(fine)) if claim.symmetric else theta[:-1]) / np.diff(fine)
    grid = SPHERE.point(np.linspace(0.0, high, _RINGS)[:, None], np.linspace(0.0, 1.0, _SPOKES)).astype(np.float32)
    pdf, on_grid = claim.pdf(pilot), claim.pdf(grid)
    peak = min(float(max(pdf.max(), on_grid.max())), _TALLEST * float(np.median(pdf)))
    surface = np.minimum(on_grid / peak, 1.0)[..., None] * grid
    return Lobe(surface, peak, edges, theta, azimuth, 0.5 * (fine[1:] + fine[:-1]), line)


def _reach(claim: Distribution, pilot: np.ndarray) -> float:
    """The angle, round in degrees, within which almost all directions are."""
    reach = float(np.degrees(np.quantile(SPHERE.polar(pilot), _ALMOST_ALL)))
    if reach < _NARROWEST:
        raise ValueError(
            f"distribution: got {claim!r}, a lobe of {reach:.1g} degrees, want one of {_NARROWEST} at least to see"
        )
    return float(np.radians(next(angle for angle in _ROUND if angle >= reach - 1e-3)))


def _masses(claim: Distribution, edges: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Chances of the cells of theta, and of the sectors."""
    if claim.symmetric:
        return np.diff(claim.cdf(edges)), np.full(SECTORS, 1.0 / SECTORS)
    masses = cell_masses(claim, edges, SECTORS)
    masses /= masses.sum()
    return masses.sum(axis=1), masses.sum(axis=0)


def histograms(local: np.ndarray, lobe: Lobe) -> tuple[AngleHistogram, AngleHistogram]:
    """Angles to the normal and about it against the lobe's: local is (N, 3), unit vectors."""
    cell = np.minimum((SPHERE.polar(local) * (CELLS / lobe.edges[-2])).astype(np.intp), CELLS)
    sector = np.minimum((SPHERE.azimuth(local) * SECTORS).astype(np.intp), SECTORS - 1)
    around = np.linspace(0.0, 2.0 * np.pi, SECTORS + 1)
    middle = 0.5 * (around[1:] + around[:-1])
    density = lobe.azimuth * SECTORS / (2.0 * np.pi)
    return (
        _histogram(np.bincount(cell, minlength=CELLS + 1), lobe.theta, lobe.edges, lobe.angles, lobe.line),
        _histogram(np.bincount(sector, minlength=SECTORS), lobe.azimuth, around, middle, density),
    )


def _histogram(
    observed: np.ndarray, masses: np.ndarray, edges: np.ndarray, angles: np.ndarray, line: np.ndarray
) -> AngleHistogram:
    """Of the cells that the chart shows; the test is over all, those beyond the chart too."""
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
    )


def _directions(choice: Choice, points: SurfacePoints, first: int) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """(P, n, 3) in the world, (P, n, 3) in the tangent frames, (P, n) claimed density."""
    own = choice.claim == choice.distribution
    found = sample_directions(
        points.normal, choice.samples, choice.distribution, choice.sequence, choice.seed, first_point=first, pdf=own
    )
    unit = points.normal / np.linalg.norm(points.normal, axis=1, keepdims=True)
    local = np.matmul(found.vectors, frames(unit.astype(np.float64)).astype(np.float32))
    return found.vectors, local, found.pdf if own else choice.claim.pdf(local)


def _lengths(pdf: np.ndarray, peak: float) -> np.ndarray:
    return np.where(pdf > 0.0, np.minimum(pdf / np.float32(peak), np.float32(1.0)), np.float32(OUTSIDE))
