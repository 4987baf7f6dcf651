"""Checked arguments of an estimate, and the definition of the quantity that the rays of a point sum to."""

from dataclasses import dataclass
from math import inf
from typing import Any

import numpy as np
from typing_extensions import Unpack

from warpsample.distributions import as_spatial
from warpsample.distributions.record import Distribution
from warpsample.estimate.integrand import Integrand
from warpsample.estimate.result import Estimate
from warpsample.estimate.strata import POLAR_COSINE
from warpsample.host.arguments import check_integer, check_number
from warpsample.host.engine import check_memory
from warpsample.host.options import RayKeywords
from warpsample.tracing.options import RayOptions
from warpsample.tracing.placed_points import PlacedPoints

_MOST_RAYS = 2**24  # per point: hits are counted in float64 and rays in int32, and one task computes a whole point
_BYTES_PER_POINT = 132


@dataclass(frozen=True)
class RaySum:
    """Definition of an estimated quantity: the weight of a ray, the length of rays, the unit and the type of the result.

    Attributes:
        integrand: Weight of an unoccluded ray, as a function of the direction.
        reach: Length of the rays, in mesh units.
        unit: Factor by which the mean over the rays is multiplied.
        falloff: Exponent of the falloff with distance, see `ambient_occlusion`; None if occluded rays add 0.
        result: Type of the result, a subclass of `Estimate`.
        typical: Typical value of one ray for each component, in the unit of the result. It widens the intervals of points
            whose rays have less weight, as above the dark half of a picture; 0 if unknown.
    """

    integrand: Integrand
    reach: float = inf
    unit: float = 1.0
    falloff: float | None = None
    result: type[Estimate] = Estimate
    typical: tuple[float, ...] = (0.0,)


@dataclass(frozen=True)
class Plan:
    """Checked arguments of an estimate: points, number of rays, tolerance and distribution of the rays.

    Attributes:
        at: Points, with the mesh that may block their rays.
        count: Number of rays per point.
        options: Options that all calls share.
        tolerance: Standard error to reach with at most `count` rays; None to cast all `count` rays.
        distribution: Distribution of the ray directions.
        tangents: Whether the tangents of the points, if any, orient the distribution.
    """

    at: PlacedPoints
    count: int
    options: RayOptions
    tolerance: float | None
    distribution: Distribution
    tangents: bool = False

    @property
    def tangent(self) -> np.ndarray | None:
        """Tangents that orient the distribution, (P, 4) float32, or None."""
        return self.at.points.tangent if self.tangents else None

    @classmethod
    def of(
        cls,
        at: PlacedPoints,
        count: Any,
        options: RayOptions,
        *,
        tolerance: Any = None,
        distribution: Any = POLAR_COSINE,
        tangents: bool = False,
    ) -> "Plan":
        """Check the ray count, the tolerance and the distribution of an estimate, and return all checked arguments.

        Raises:
            TypeError, ValueError: an argument cannot be used; the message names the argument, what it got and what it wants.
            MemoryError: the results need more memory than is free.
        """
        if at.mesh is not None and at.mesh.transmits:
            options.check_through_glass()
        lobe = as_spatial(distribution)
        lobe.check_points(len(at))
        check_memory(_BYTES_PER_POINT * len(at), f"the numbers of {len(at):,} points", "take them in parts")
        return cls(
            at,
            check_integer(count, "count", 2, _MOST_RAYS),
            options,
            None if tolerance is None else check_number(tolerance, "tolerance", 1e-12, 1e12),
            lobe,
            tangents,
        )


def plan_of(
    at: PlacedPoints, count: Any, *, distribution: Any = POLAR_COSINE, tangents: bool = False, **options: Unpack[RayKeywords]
) -> Plan:
    """Check the options of an estimate at the given points, and return all checked arguments as a `Plan`."""
    tolerance = options.pop("tolerance", None)
    checked = RayOptions.of(len(at), ids=at.id, **options)
    return Plan.of(at, count, checked, tolerance=tolerance, distribution=distribution, tangents=tangents)


def reach_of(max_distance: Any) -> float:
    """Return the option `max_distance`, the length of rays, as a float; infinity for None.

    Raises:
        TypeError, ValueError: `max_distance` is not a number of at least 0.
    """
    return inf if max_distance is None else check_number(max_distance, "max_distance", 0.0, inf)
