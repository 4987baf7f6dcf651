"""Numbers measured on one sampler, shared by all its tests: directions, and worst errors over many inputs."""

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property
from typing import Any
from zlib import crc32

import numpy as np

from warpsample.directions.sample import sample_square
from warpsample.proof import laws, twins
from warpsample.statistics.charts import DISK, SPHERE, Chart, chart_of, support_of

_SAMPLES = 16
_CELL_DRAWS = 1 << 20
_ROWS = 40


def independent(points: int, count: int, seed: int) -> np.ndarray:
    """Return independent uniform random numbers, (points, count, 2) float32, of the sequence "independent"."""
    return sample_square("independent", points, count, seed=seed)


@dataclass(frozen=True)
class Subject:
    """Sampler under test, with its name in tables and a second implementation in float64 to compare with.

    Attributes:
        name: name in tables.
        sampler: the distribution itself, or a wrong sampler in its place (see `warpsample.statistics.charts.Sampler`).
        twin: distribution whose float64 implementation gives the exact values.
        variates: function (points, count, seed) -> (points, count, 2) float32.
    """

    name: str
    sampler: Any
    twin: Any
    variates: Callable[[int, int, int], np.ndarray] = independent


class Evidence:
    """Directions and errors measured on one sampler, each computed when a test first needs it."""

    subject: Subject
    sampler: Any
    every: int
    draws: int

    def __init__(self, subject: Subject, every: int = 1, draws: int = 1 << 22):
        """Set the sampler under test, and how many inputs to measure.

        Args:
            subject: sampler to be judged.
            every: the sweep takes every n-th variate.
            draws: number of independent directions for statistics.
        """
        self.subject, self.sampler, self.every, self.draws = subject, subject.sampler, every, draws
        self.chart: Chart = chart_of(subject.sampler)

    def draw(self, seed: int, draws: int) -> np.ndarray:
        """Sample `draws` directions of the sampler from independent random numbers."""
        u = self.subject.variates(draws // _SAMPLES, _SAMPLES, seed)
        return self.sampler.sample(u.reshape(-1, 2))

    @cached_property
    def seed(self) -> int:
        """Seed of the random numbers: a hash of the sampler's name, so that no two samplers share random numbers."""
        return crc32(self.subject.name.encode())

    @cached_property
    def directions(self) -> np.ndarray:
        """Sampled directions from independent random numbers, `draws` in number."""
        return self.draw(self.seed, self.draws)

    @cached_property
    def first_directions(self) -> np.ndarray:
        """First 2^20 of the independent sampled directions, or all if there are fewer."""
        return self.directions[:_CELL_DRAWS]

    @cached_property
    def angles(self) -> np.ndarray:
        """Angle to the normal (or radius, on the disk) of each independent sampled direction."""
        return self.chart.polar(self.directions)

    @cached_property
    def edges(self) -> np.ndarray:
        """Polar coordinates that divide the directions into cells with about equal counts, found in a pilot run.

        The ends of the support and of the chart are edges, too.
        """
        low, high = support_of(self.sampler)
        pilot = self.chart.polar(self.draw(self.seed + 1, 1 << 16))
        pilot = pilot[np.isfinite(pilot)]
        inner = np.quantile(pilot, np.arange(1, _ROWS) / _ROWS) if len(pilot) else np.empty(0)
        if self.chart is SPHERE:
            inner = np.append(inner, np.pi / 2.0)  # where an offset sphere's density bends within 5e-4 rad
        inner = np.append(inner, self.sampler.jumps)
        inside = inner[(inner > low) & (inner < high)]
        return np.unique([self.chart.low, low, *inside, high, self.chart.high])

    @cached_property
    def smooth(self) -> np.ndarray:
        """Points of the unit square at which the sampler's map is smooth, (N, 2).

        The points are at least 2^-7 from the rim, and off seams and the kinks of the concentric map.
        """
        k = np.arange(4096)
        u = np.stack([(k + 0.5) / 4096, k * 0.618033988749895 % 1.0], axis=1) * (1 - 2**-6) + 2**-7
        a, b = np.abs(u - 0.5).T
        return u[(np.abs(a - b) > 2**-6) & (np.abs(u - 0.5).max(axis=1) > 2**-6) & ~self.sampler.seam(u)]

    @cached_property
    def stretch(self) -> tuple[float, float]:
        """Largest and mean difference from 1 of the product of the density and the map's local stretch of areas.

        The product is 1 for a correct sampler.
        """
        with np.errstate(all="ignore"):
            return laws.area_stretch_error(self.sampler, self.smooth)

    @cached_property
    def sweep(self) -> dict[str, float]:
        """Worst errors of the sampler over many points of the unit square, keyed by the kind of error.

        The key "broken" is the number of invalid values.
        """
        found: dict[str, float] = {}
        for u in (laws.corner_grid(), *laws.all_variates(self.every)):
            for name, value in self._errors(u).items():
                before = found.get(name, 0.0)
                found[name] = before + value if name == "broken" else max(before, value)
        return found

    def _errors(self, u: np.ndarray) -> dict[str, float]:
        """Return the worst errors of the sampler at points u of the unit square, keyed by the kind of error."""
        sampler, twin = self.sampler, self.subject.twin
        w, exact = sampler.sample(u), twins.directions(twin, u.astype(np.float64))
        pdf = sampler.pdf(w)
        wide = w.astype(np.float64)
        broken = ~(np.isfinite(wide @ np.ones(wide.shape[-1])) & np.isfinite(pdf) & (pdf > 0.0))
        found = {"broken": float(broken.sum())}
        if self.chart is not DISK:
            found["length"] = laws.length_error(wide)
        found["angle"] = laws.distance_error(wide, exact) if self.chart is DISK else laws.angle_error(wide, exact)
        if self.chart is SPHERE and sampler.symmetric:
            found["sine"] = laws.sine_error(wide, exact)
        # At the sampled direction, so that an error of the direction does not count as an error of the density.
        with np.errstate(all="ignore"):
            found["pdf"] = laws.density_error(pdf, twins.density(twin, wide))
        if sampler.maps.invert is not None:
            off_seams = ~sampler.seam(u)
            back = sampler.invert(w)[off_seams, : sampler.variates]
            found["round trip"] = laws.round_trip_error(back, u[off_seams, : sampler.variates])
        return found
