"""The checked call of an estimate, and what it sums over the rays of a point."""

from dataclasses import dataclass
from math import inf
from typing import Any

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

_MOST_RAYS = 2**24  # of a point: hits are counted in float64 and rays in int32, and one point is one task
_BYTES_PER_POINT = 132


@dataclass(frozen=True)
class RaySum:
    """What is summed over the rays of a point.

    Attributes:
        integrand: what a ray adds that meets nothing.
        reach: how far rays go, in the user's units.
        unit: what the mean of the rays is multiplied by.
        falloff: see `ambient_occlusion`; None: a ray that meets something adds nothing.
        result: the type of the estimate.
    """

    integrand: Integrand
    reach: float = inf
    unit: float = 1.0
    falloff: float | None = None
    result: type[Estimate] = Estimate


@dataclass(frozen=True)
class Plan:
    """A checked call, apart from what it sums.

    Attributes:
        at: the points, and the mesh that they see.
        count: rays of each point.
        options: what calls share.
        tolerance: the standard error to reach by at most `count` rays; None: by all of them.
        distribution: of the rays.
    """

    at: PlacedPoints
    count: int
    options: RayOptions
    tolerance: float | None
    distribution: Distribution

    @classmethod
    def of(
        cls, at: PlacedPoints, count: Any, options: RayOptions, *, tolerance: Any = None, distribution: Any = POLAR_COSINE
    ) -> "Plan":
        """The plan of a call from points that are placed and options that are checked.

        Raises:
            TypeError, ValueError: an argument that cannot be used; names it, what it got and what it wants.
            MemoryError: more than is free.
        """
        if at.mesh is not None and at.mesh.transmits:
            options.check_through_glass()
        check_memory(_BYTES_PER_POINT * len(at), f"the numbers of {len(at):,} points", "take them in parts")
        return cls(
            at,
            check_integer(count, "count", 2, _MOST_RAYS),
            options,
            None if tolerance is None else check_number(tolerance, "tolerance", 1e-12, 1e12),
            as_spatial(distribution),
        )


def plan_of(at: PlacedPoints, count: Any, *, distribution: Any = POLAR_COSINE, **options: Unpack[RayKeywords]) -> Plan:
    """Check the options of a call, and return its plan; errors are those of `Plan.of`."""
    tolerance = options.pop("tolerance", None)
    checked = RayOptions.of(len(at), ids=at.id, **options)
    return Plan.of(at, count, checked, tolerance=tolerance, distribution=distribution)


def reach_of(max_distance: Any) -> float:
    """How far rays go: infinitely far by default.

    Raises:
        TypeError, ValueError: not a number from 0 on.
    """
    return inf if max_distance is None else check_number(max_distance, "max_distance", 0.0, inf)
