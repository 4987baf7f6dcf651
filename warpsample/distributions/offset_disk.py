"""In the plane: a point of the disk that touches the surface point, seen from there: density cosine squared."""

from dataclasses import dataclass
from typing import ClassVar

import numpy as np
import warp as wp

from warpsample.distributions.record import Distribution, Maps
from warpsample.maths.numerics import TWO_OVER_PI, root, sincos_turns


@wp.func
def square_to_offset_disk(u: wp.vec2) -> wp.vec2:
    """(sin theta, cos theta): the abscissa of a uniform point of the disk is the sine of a cosine-squared angle.

    Half the chord above x is cos theta, so x = sin theta has density 2 cos^2 theta / pi in theta: the law of
    Chizhov2019, section 3.1, without his root finding or his singularity.
    cos^2 theta = 1 - x^2 = (1 - u[0]) + u[0] sin^2(2 pi u[1]).
    """
    cs = sincos_turns(u[1])
    return wp.vec2(root(u[0]) * cs[0], wp.sqrt((1.0 - u[0]) + u[0] * (cs[1] * cs[1])))


@wp.func
def square_to_offset_disk_pdf(w: wp.vec2) -> wp.float32:
    """2 cos^2 theta / pi per radian on the half circle above, else 0. Chizhov2019, section 3.1."""
    return wp.where(w[1] > 0.0, TWO_OVER_PI * (w[1] * w[1]), 0.0)


@dataclass(frozen=True)
class OffsetDisk(Distribution):
    """A uniform point of the unit disk plus the normal, normalised: 2 cos²θ / π per radian in the plane."""

    name = "offset_disk"
    density = "2cos²θ/π"
    measure = "per radian"
    support = "half circle"
    width = 2
    source = "Chizhov2019, sections 3.1 and 3.2"
    limits = "two variates give one angle, so there is no inverse"
    maps: ClassVar[Maps] = Maps(square_to_offset_disk, square_to_offset_disk_pdf)

    def _cdf(self, theta: np.ndarray) -> np.ndarray:
        """(theta + sin theta cos theta) / pi + 1/2, where Chizhov2019 prints + 1. See `Distribution.cdf`."""
        theta = np.clip(theta, -np.pi / 2.0, np.pi / 2.0, dtype=np.float64)
        return (theta + np.sin(theta) * np.cos(theta)) / np.pi + 0.5


RECORD = OffsetDisk
