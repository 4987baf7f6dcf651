"""Planar direction to a random point in the unit disk that touches the surface: density 2 cos^2(theta) / pi."""

from dataclasses import dataclass
from typing import ClassVar

import numpy as np
import warp as wp

from warpsample.distributions.record import Distribution, Maps
from warpsample.maths.numerics import TWO_OVER_PI, root, sincos_turns


@wp.func
def square_to_offset_disk(u: wp.vec2) -> wp.vec2:
    """Map a point of the unit square to a planar direction with density 2 cos^2(theta) / pi per radian about +y.

    The abscissa x of a random point in the unit disk is taken as sin theta. The chord at x has half length cos theta, so
    theta has the density 2 cos^2(theta) / pi of Chizhov2019, section 3.1, here without root finding and singularity.
    cos^2 theta = 1 - x^2 = (1 - u[0]) + u[0] sin^2(2 pi u[1]).
    """
    cs = sincos_turns(u[1])
    return wp.vec2(root(u[0]) * cs[0], wp.sqrt((1.0 - u[0]) + u[0] * (cs[1] * cs[1])))


@wp.func
def square_to_offset_disk_pdf(w: wp.vec2) -> wp.float32:
    """Return the density 2 cos^2(theta) / pi per radian on the half circle about +y, else 0. Chizhov2019, section 3.1."""
    return wp.where(w[1] > 0.0, TWO_OVER_PI * (w[1] * w[1]), 0.0)


@dataclass(frozen=True)
class OffsetDisk(Distribution):
    """Planar direction of the normal plus a random point in the unit disk, with density 2 cos²θ / π per radian."""

    name = "offset_disk"
    density = "2cos²θ/π"
    measure = "per radian"
    support = "half circle"
    width = 2
    source = "Chizhov2019, sections 3.1 and 3.2"
    limits = "there is no inverse, because many points u map to the same angle"
    maps: ClassVar[Maps] = Maps(square_to_offset_disk, square_to_offset_disk_pdf)

    def _cdf(self, theta: np.ndarray) -> np.ndarray:
        """Return the probability that the signed angle to +y is at most theta: (theta + sin theta cos theta) / pi + 1/2.

        Chizhov2019 prints + 1 in error. See `Distribution.cdf`.
        """
        theta = np.clip(theta, -np.pi / 2.0, np.pi / 2.0, dtype=np.float64)
        return (theta + np.sin(theta) * np.cos(theta)) / np.pi + 0.5


RECORD = OffsetDisk
