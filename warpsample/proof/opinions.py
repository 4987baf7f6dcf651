"""Values of a sampler's functions and of its second implementation at the same arguments, for comparison."""

from collections.abc import Callable
from functools import cached_property
from typing import Any

import numpy as np

from warpsample.proof import laws, twins
from warpsample.proof.evidence import Evidence, Subject
from warpsample.statistics.charts import DISK, SPHERE, support_of
from warpsample.statistics.quadrature import cell_masses

MAPS = ("map", "twin's map")
DENSITIES = ("density", "twin's density")
COLUMNS = 16
_EVERY = 64  # every 64th variate of the sweep, which are 2^18
_ROWS = 40
MARGIN = 1e-3  # fraction of the support's width by which rounding alone may leave the support
STEP = 2.0**-16  # of central differences; a twin in float32 then errs by 4e-3


class SamplerWithDensity:
    """Sampler whose density is replaced by another function, so that quadrature and tests use this function."""

    def __init__(self, sampler: Any, pdf: Callable[[np.ndarray], np.ndarray]):
        self.sampler, self.pdf = sampler, pdf

    def __getattr__(self, name: str) -> Any:
        """Return an attribute of the original sampler, for every name except `pdf`."""
        return getattr(self.sampler, name)


class Opinions:
    """Results of a sampler's own functions and of its second implementation, to be compared.

    A part is one of MAPS or DENSITIES: "map", "twin's map", "density" or "twin's density".
    """

    def __init__(self, subject: Subject):
        self.subject, self.sampler = subject, subject.sampler
        self._draws = Evidence(subject, draws=1 << 20)
        self.chart = self._draws.chart
        self.low, self.high = support_of(subject.sampler)

    def directions(self, part: str, u: np.ndarray) -> np.ndarray:
        """Return the directions of one of the two maps for points u of the unit square, float64."""
        with np.errstate(all="ignore"):
            w = self.sampler.sample(u) if part == "map" else twins.directions(self.subject.twin, u.astype(np.float64))
        return np.asarray(w, np.float64)

    def density(self, part: str, w: np.ndarray) -> np.ndarray:
        """Return the values of one of the two densities at directions w, float64; w is rounded to float32."""
        w = w.astype(np.float32)
        with np.errstate(all="ignore"):
            own = part == "density"
            pdf = self.sampler.pdf(w) if own else twins.density(self.subject.twin, w.astype(np.float64))
        return np.asarray(pdf, np.float64)

    def is_inside(self, w: np.ndarray, margin: float = 0.0) -> np.ndarray:
        """Return a mask of the directions w inside the sampler's declared support, enlarged by `margin` times its width."""
        a, margin = self.chart.polar(w), margin * (self.high - self.low)
        return (a >= self.low - margin) & (a <= self.high + margin)

    @cached_property
    def u(self) -> np.ndarray:
        """Points of the unit square at which the two maps are compared, (N, 2)."""
        u = np.concatenate(list(laws.all_variates(_EVERY)))
        return u[~self.sampler.seam(u)]

    @cached_property
    def at_u(self) -> dict[str, np.ndarray]:
        """Directions of both maps at the points `u`, keyed by part."""
        return {part: self.directions(part, self.u) for part in MAPS}

    @cached_property
    def draws(self) -> dict[str, np.ndarray]:
        """Independent directions of both maps that are finite and in the support, keyed by part."""
        u = self.subject.variates((1 << 20) // 16, 16, self._draws.seed).reshape(-1, 2)
        drawn = {part: self.directions(part, u) for part in MAPS}
        return {part: w[self.is_inside(w)] for part, w in drawn.items()}

    @cached_property
    def edges(self) -> np.ndarray:
        """Angles that divide the support into cells for integrals: quantiles of both maps, and the ends of the support."""
        quantiles = np.arange(1, _ROWS) / _ROWS
        inner = [np.quantile(self.chart.polar(w), quantiles) for w in self.draws.values() if len(w)]
        bend = [np.pi / 2.0] if self.chart is SPHERE else []
        edges = np.sort(np.concatenate([*inner, bend]))
        width = self.high - self.low
        edges = edges[(edges > self.low + 1e-6 * width) & (edges < self.high - 1e-6 * width)]
        apart = np.diff(edges, prepend=self.low) > 1e-5 * np.maximum(edges, 1e-30)  # equal quantiles of both maps
        return np.concatenate([[self.low], edges[apart], [self.high]])

    @cached_property
    def masses(self) -> dict[str, np.ndarray | None]:
        """Integrals of both densities over the cells of the support, keyed by part; None for a divergent integral."""
        return {part: self.integrate(part, self.edges) for part in DENSITIES}

    def integrate(self, part: str, edges: np.ndarray, weight: int = 0) -> np.ndarray | None:
        """Integrate one density, times angle^weight, over cells between the angles `edges`; return None if it diverges."""
        try:
            return cell_masses(self.sampler_with_density(part), edges, COLUMNS if self.chart.azimuths > 1.0 else 1, weight)
        except ValueError:
            return None

    def sampler_with_density(self, part: str, mass: float = 1.0) -> SamplerWithDensity:
        """Return a sampler whose density is one of the two densities, divided by `mass`."""
        return SamplerWithDensity(self.sampler, lambda w: self.density(part, w) / mass)

    def sampler_in_support(self, part: str, mass: float) -> SamplerWithDensity:
        """Return a sampler whose density is one of the two densities, divided by `mass` and set to 0 outside the support."""
        return SamplerWithDensity(self.sampler, lambda w: np.where(self.is_inside(w), self.density(part, w) / mass, 0.0))

    def mean_angle(self, part: str) -> float | None:
        """Return the mean angle to the normal under one map or density; None if an integral does not converge."""
        if part in MAPS:
            return float(self.chart.polar(self.draws[part]).mean()) if len(self.draws[part]) else None
        masses, first = self.masses[part], self.integrate(part, self.edges, 1)
        return None if masses is None or first is None else float(first.sum() / masses.sum())

    def stretch(self, part: str, u: np.ndarray) -> np.ndarray:
        """Return by how much one map stretches areas at u, from the square to the sphere, by central differences.

        u: (N, 2), at least STEP from the rim of the square.
        """
        u = u.astype(np.float64)
        ends = [(self.directions(part, u + step), self.directions(part, u - step)) for step in STEP * np.eye(2)]
        along = [(high - low) / (2.0 * STEP) for high, low in ends]
        if self.chart.azimuths == 1.0:
            return np.linalg.norm(along[0], axis=-1)
        if self.chart is DISK:
            return np.abs(along[0][..., 0] * along[1][..., 1] - along[0][..., 1] * along[1][..., 0])
        return np.linalg.norm(np.cross(*along), axis=-1)

    def directions_outside(self, part: str) -> np.ndarray:
        """Return the finite directions of one map, at the points `u`, that are clearly outside the declared support."""
        w = self.at_u[part]
        return w[np.isfinite(w).all(axis=-1) & ~self.is_inside(w, MARGIN)]

    def greatest_angle(self, part: str) -> float:
        """Return the largest angle to the normal among the directions of one map at the points `u`."""
        return float(np.nanmax(np.abs(self.chart.polar(self.at_u[part])), initial=0.0))
