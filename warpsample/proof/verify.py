"""List of all tests of samplers, with limits, and functions that run the tests, for `warpsample verify`.

Errors are compared with the limits in the record of each distribution. Statistical tests reject p-values below LEVEL, so
that correct samplers fail by chance in at most FAMILY_WISE of all runs, on any machine.
"""

from collections.abc import Callable, Iterable
from dataclasses import dataclass
from typing import Any

import numpy as np

from warpsample import distributions
from warpsample.distributions.record import Distribution
from warpsample.proof import laws
from warpsample.proof.evidence import Evidence, Subject
from warpsample.proof.twins import check_twin

FAMILY_WISE = 1e-4
MOST_STATISTICS = 1000
LEVEL = FAMILY_WISE / MOST_STATISTICS


@dataclass(frozen=True)
class Verdict:
    """Result of one test of one sampler: the measured error or p-value, and its limit.

    Attributes:
        law: name of the law.
        subject: name of the subject.
        measured: worst error, or p-value.
        limit: greatest error allowed, or smallest p-value allowed, LEVEL.
        statistical: whether `measured` is a p-value.
        note: reason for a missing number, or exceptions from the law.
    """

    law: str
    subject: str
    measured: float
    limit: float
    statistical: bool
    note: str = ""

    @classmethod
    def from_error(cls, law: str, subject: str, measured: float, *, limit: float = 0.0, note: str = "") -> "Verdict":
        """Build the result of a test from a measured error or a number of failures, which must not exceed `limit`."""
        return cls(law, subject, float(measured), limit, False, note)

    @classmethod
    def from_p_value(cls, law: str, subject: str, p_value: float, note: str = "") -> "Verdict":
        """Build the result of a statistical test from its p-value, which must be at least LEVEL."""
        return cls(law, subject, p_value, LEVEL, True, note)

    @property
    def passed(self) -> bool:
        """True if the sampler has passed the test."""
        return self.measured >= self.limit if self.statistical else self.measured <= self.limit


@dataclass(frozen=True)
class Law:
    """Test of samplers: function that measures an error or p-value, its limit, and the samplers to which it applies.

    Attributes:
        name: name in tables.
        summary: one line for tables.
        measure: function that returns the error or the p-value from the evidence.
        limit: function that returns the greatest error allowed for the distribution that the subject claims to be; None if
            `measure` returns p-values.
        applies: predicate of the samplers to which the law applies.
    """

    name: str
    summary: str
    measure: Callable[[Evidence], float]
    limit: Callable[[Distribution], float] | None = None
    applies: Callable[[Any], bool] = lambda sampler: True

    def judge(self, evidence: Evidence) -> Verdict:
        """Run this test on a sampler, and return the result; a test that cannot be evaluated counts as failed."""
        note, subject = "", evidence.subject
        try:
            with np.errstate(all="ignore"):  # a wrong sampler may return anything
                measured = self.measure(evidence)
        except ValueError as error:  # a density whose integral is not 1 or does not converge
            measured, note = 0.0 if self.limit is None else float("inf"), str(error)
        if self.limit is None:
            return Verdict.from_p_value(self.name, subject.name, measured, note)
        return Verdict.from_error(self.name, subject.name, measured, limit=self.limit(subject.twin), note=note)


def _constant_limit(limit: float) -> Callable[[Distribution], float]:
    """Return a function that returns `limit` for every distribution."""
    return lambda distribution: limit


def _has_cdf(sampler: Any) -> bool:
    """Return True if a sampler is symmetric about its axis and so has a closed-form distribution function (cdf)."""
    return sampler.symmetric


def _has_azimuth(sampler: Any) -> bool:
    """Return True if a sampler is symmetric about its axis and its directions have an azimuth."""
    return sampler.symmetric and sampler.measure != "per radian"


def _has_inverse(sampler: Any) -> bool:
    """Return True if a sampler has an inverse, from directions to the unit square."""
    return sampler.maps.invert is not None


LAWS = (
    Law(
        "finite",
        "number of u that give NaN, an infinity or density 0, over the corners of the square and the sweep",
        lambda e: e.sweep["broken"],
        _constant_limit(0.0),
    ),
    Law(
        "unit length",
        "worst | |w| - 1 | over the sweep",
        lambda e: e.sweep["length"],
        lambda d: d.worst_unit_length,
        lambda s: s.measure != "per unit area",
    ),
    Law(
        "direction",
        "worst angle in radians from the float64 twin over the sweep; for disks the worst distance",
        lambda e: e.sweep["angle"],
        lambda d: d.worst_angle,
    ),
    Law(
        "sine",
        "worst relative error of sin θ over the sweep",
        lambda e: e.sweep["sine"],
        _constant_limit(1e-6),
        lambda s: s.symmetric and s.measure == "per steradian",
    ),
    Law(
        "density",
        "worst relative error of the pdf at the sampled directions, from its float64 twin",
        lambda e: e.sweep["pdf"],
        lambda d: d.worst_pdf,
    ),
    Law(
        "round trip",
        "worst distance from u to invert(sample(u)), away from stated seams",
        lambda e: e.sweep["round trip"],
        lambda d: d.worst_round_trip,
        _has_inverse,
    ),
    Law(
        "outside",
        "greatest density outside the support, and at NaN",
        lambda e: laws.density_outside(e.sampler),
        _constant_limit(0.0),
    ),
    Law(
        "mass",
        "| integral of the density - 1 |, by a quadrature that has converged",
        lambda e: laws.mass_error(e.sampler, e.edges),
        _constant_limit(1e-4),
    ),
    # An error of 1e-7 in float32 directions at the ends of a side of 2^-10 gives 4e-4. Curvature gives the same error, and
    # ten times that near the horizon of a view. Both average out.
    Law(
        "stretch",
        "pdf times the stretch of area is 1: worst deviation",
        lambda e: e.stretch[0],
        lambda d: 1e-3 if d.symmetric else 5e-3,
        lambda s: _has_inverse(s) and s.measure != "per radian",
    ),
    Law(
        "mean stretch",
        "pdf times the stretch of area is 1: mean deviation",
        lambda e: abs(e.stretch[1]),
        lambda d: 2e-5 if d.symmetric else 5e-5,
        lambda s: _has_inverse(s) and s.measure != "per radian",
    ),
    Law(
        "cells",
        "chi-square of 2²⁰ directions in cells of the support, and a Poisson test of all other cells",
        lambda e: laws.cells_p_value(e.sampler, e.first_directions, e.edges),
    ),
    Law(
        "angle",
        "Kolmogorov-Smirnov test of θ against its closed distribution function",
        lambda e: laws.angles_p_value(e.sampler, e.angles[: len(e.first_directions)]),
        applies=_has_cdf,
    ),
    Law(
        "tails",
        "counts of 2²² directions in tails of probability 10⁻⁵ at the pole and the far end (offset spheres below 1: 10⁻²)",
        lambda e: laws.tails_p_value(e.sampler, e.angles),
        applies=_has_cdf,
    ),
    Law(
        "moments",
        "means of θ and θ² against their integrals under the density",
        lambda e: laws.moments_p_value(e.sampler, e.angles, e.edges),
    ),
    Law(
        "azimuth",
        "Rayleigh's test for a preferred azimuth",
        lambda e: laws.azimuth_p_value(e.directions),
        applies=_has_azimuth,
    ),
    Law(
        "azimuth gap",
        "the widest gap between the azimuths of 2²² directions",
        lambda e: laws.azimuth_gap_p_value(e.directions),
        applies=_has_azimuth,
    ),
)


def cases(only: str | None = None) -> list[Distribution]:
    """Return all distributions to test, with several cases of parameters each, or the cases of the distribution `only`.

    Raises:
        NotImplementedError: a distribution has no twin.
    """
    names = distributions.names() if only is None else [only]
    found = [case for name in names for case in distributions.get(name).cases()]
    for case in found:
        check_twin(case)
    return found


def judge(evidence: Evidence, which: Iterable[Law] = LAWS) -> list[Verdict]:
    """Run all tests that apply to a sampler, and return the results."""
    return [law.judge(evidence) for law in which if law.applies(evidence.sampler)]


def judge_case(case: Distribution, **effort: int) -> list[Verdict]:
    """Run all tests that apply to a distribution, and return the results.

    `effort` holds keyword arguments of `Evidence`.
    """
    return judge(Evidence(Subject(repr(case), case, case), **effort))
