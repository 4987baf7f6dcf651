"""Powers of the cosine: Phong's lobe about the normal."""

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
    """cos theta = (1 - u[0])^(1 / (exponent + 1)) = e^s; sin^2 theta = (1 - e^s)(1 + e^s).

    1 - e^s is precise, as narrow lobes need. Exponent 1 is the cosine lobe, 0 the uniform hemisphere.
    """
    power = exp_double(log1p_double(-wp.float64(u[0])) * (ONE / (wp.float64(exponent) + ONE)))
    r = wp.float32(root_double(-power[0] * (ONE + power[1])))
    cs = sincos_turns(u[1])
    return wp.vec3(r * cs[0], r * cs[1], wp.float32(power[1]))


@wp.func
def square_to_power_cosine_pdf(w: wp.vec3, exponent: wp.float32) -> wp.float32:
    """(exponent + 1) / (2 pi) cos^exponent theta per steradian above the surface, else 0."""
    n = wp.float64(exponent)
    power = exp_double(-HALF * n * log1p_double(tan_squared(w)))
    return wp.where(w[2] > 0.0, wp.float32((n + ONE) * INV_TWO_PI_DOUBLE * power[1]), 0.0)


@wp.func
def power_cosine_to_square(w: wp.vec3, exponent: wp.float32) -> wp.vec2:
    """1 - cos^(exponent + 1) theta, and the azimuth in turns."""
    power = exp_double(-HALF * (wp.float64(exponent) + ONE) * log1p_double(tan_squared(w)))
    return wp.vec2(clamp_uniform(-wp.float32(power[0])), turns_of(w[0], w[1]))


@dataclass(frozen=True)
class PowerCosine(Distribution):
    """A power of the cosine about the normal: (n + 1) cosⁿθ / (2π) per steradian.

    Attributes:
        exponent: n, from 0 (the uniform hemisphere) to 1e9; 1 is the cosine lobe.
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
        """1 - cos^(n + 1) theta. See `Distribution.cdf`."""
        # log cos = log1p(-2 sin^2(theta / 2)), which stays precise for narrow lobes.
        with np.errstate(divide="ignore"):
            log_cos = np.log1p(-2.0 * np.sin(0.5 * np.clip(theta, 0.0, np.pi / 2.0, dtype=np.float64)) ** 2)
        return -np.expm1((self.exponent + 1.0) * log_cos)


RECORD = PowerCosine
