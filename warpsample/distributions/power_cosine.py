"""Power cosine lobe (Phong's lobe about the normal): density proportional to cos^n(theta)."""

from dataclasses import dataclass
from typing import ClassVar

import numpy as np
import warp as wp

from warpsample.distributions.record import Cases, Distribution, Maps, Range
from warpsample.maths.angles import tan_squared, turns_of
from warpsample.maths.exponentials import exp_double, log1p_double
from warpsample.maths.numerics import HALF, INV_TWO_PI_DOUBLE, ONE, clamp_uniform, root_double, sincos_turns


@wp.func
def square_to_power_cosine(u: wp.vec2, exponent: wp.float32) -> wp.vec3:
    """Map a point of the unit square to a direction about +z with density proportional to cos^exponent(theta).

    cos theta = (1 - u[0])^(1 / (exponent + 1)) = e^s, sin^2 theta = (1 - e^s)(1 + e^s), azimuth 2 pi u[1]. Narrow lobes need
    the precise 1 - e^s. Exponent 1 gives the cosine lobe, 0 the uniform hemisphere.
    """
    power = exp_double(log1p_double(-wp.float64(u[0])) * (ONE / (wp.float64(exponent) + ONE)))
    r = wp.float32(root_double(-power[0] * (ONE + power[1])))
    cs = sincos_turns(u[1])
    return wp.vec3(r * cs[0], r * cs[1], wp.float32(power[1]))


@wp.func
def square_to_power_cosine_pdf(w: wp.vec3, exponent: wp.float32) -> wp.float32:
    """Return the density (exponent + 1) / (2 pi) cos^exponent(theta) per steradian above the surface, else 0."""
    n = wp.float64(exponent)
    power = exp_double(-HALF * n * log1p_double(tan_squared(w)))
    return wp.where(w[2] > 0.0, wp.float32((n + ONE) * INV_TWO_PI_DOUBLE * power[1]), 0.0)


@wp.func
def power_cosine_to_square(w: wp.vec3, exponent: wp.float32) -> wp.vec2:
    """Return the point u of the unit square that `square_to_power_cosine` maps to the direction w.

    u[0] = 1 - cos^(exponent + 1)(theta), u[1] the azimuth in turns.
    """
    power = exp_double(-HALF * (wp.float64(exponent) + ONE) * log1p_double(tan_squared(w)))
    return wp.vec2(clamp_uniform(-wp.float32(power[0])), turns_of(w[0], w[1]))


@dataclass(frozen=True)
class PowerCosine(Distribution):
    """Power cosine lobe about the normal, with density (n + 1) cosⁿθ / (2π) per steradian.

    Attributes:
        exponent: exponent n, from 0 (uniform hemisphere) to 1e9; 1 gives the cosine lobe.
    """

    exponent: float

    name = "power_cosine"
    density = "(n+1)cosⁿθ/(2π)"
    support = "hemisphere"
    parameters: ClassVar[tuple[str, ...]] = ("exponent",)
    shown: ClassVar[Range] = (0.1, 1000.0)
    bounds: ClassVar[Range] = (0.0, 1e9)
    source = "Lafortune1994, equation 8 (Phong's lobe); exponent 3: Chizhov2019, section 4.1"
    case_values: ClassVar[Cases] = (
        (0.0,),
        (1.0,),
        (2.5,),
        (100.0,),
        (1e9,),
    )  # from the uniform hemisphere to a lobe of 3e-5 rad
    maps: ClassVar[Maps] = Maps(square_to_power_cosine, square_to_power_cosine_pdf, power_cosine_to_square)

    def _cdf(self, theta: np.ndarray) -> np.ndarray:
        """Return the probability that the angle to +z is at most theta: 1 - cos^(n + 1)(theta). See `Distribution.cdf`."""
        # log cos = log1p(-2 sin^2(theta / 2)), which stays precise for narrow lobes.
        with np.errstate(divide="ignore"):
            log_cos = np.log1p(-2.0 * np.sin(0.5 * np.clip(theta, 0.0, np.pi / 2.0, dtype=np.float64)) ** 2)
        return -np.expm1((self.exponent + 1.0) * log_cos)


RECORD = PowerCosine
