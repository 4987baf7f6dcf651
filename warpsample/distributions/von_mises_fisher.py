"""Von Mises-Fisher distribution, the counterpart of a Gaussian on the sphere."""

from dataclasses import dataclass
from typing import ClassVar

import numpy as np
import warp as wp

from warpsample.distributions.record import Cases, Distribution, Maps, Range
from warpsample.maths.angles import turns_of, versine
from warpsample.maths.exponentials import exp_double, log1p_double
from warpsample.maths.numerics import INV_TWO_PI_DOUBLE, ONE, TWO, clamp_uniform, root_double, sincos_turns

# Above this kappa no point of the unit square maps to the lower hemisphere, and e^(2 kappa) could overflow.
_NO_BACK = wp.constant(wp.float64(20.0))


@wp.func
def square_to_von_mises_fisher(u: wp.vec2, kappa: wp.float32) -> wp.vec3:
    """Map a point of the unit square to a direction of the von Mises-Fisher distribution about +z.

    1 - cos theta = -log(1 - u[0] (1 - e^(-2 kappa))) / kappa, azimuth 2 pi u[1]. Below the equator, for precision,
    1 + cos theta = log(1 + (1 - u[0]) (e^(2 kappa) - 1)) / kappa.
    """
    k = wp.float64(kappa)
    x = wp.float64(u[0])
    upper = x * (ONE + exp_double(-k)[1]) < ONE
    rise = (ONE - x) * exp_double(TWO * wp.min(k, _NO_BACK))[0]
    fall = x * exp_double(-TWO * k)[0]
    near = wp.abs(log1p_double(wp.where(upper, fall, rise))) * (ONE / k)
    r = wp.float32(root_double(near * (TWO - near)))
    z = wp.float32(ONE - near)
    cs = sincos_turns(u[1])
    return wp.vec3(r * cs[0], r * cs[1], wp.where(upper, z, -z))


@wp.func
def square_to_von_mises_fisher_pdf(w: wp.vec3, kappa: wp.float32) -> wp.float32:
    """Return the von Mises-Fisher density of a direction w, per steradian; 0 where w is NaN.

    The density is kappa e^(-kappa (1 - cos theta)) / (2 pi (1 - e^(-2 kappa))), with theta the angle between w and +z.
    """
    k = wp.float64(kappa)
    density = k * INV_TWO_PI_DOUBLE * exp_double(-k * versine(w))[1] / -exp_double(-TWO * k)[0]
    return wp.where(w[2] == w[2], wp.float32(density), 0.0)


@wp.func
def von_mises_fisher_to_square(w: wp.vec3, kappa: wp.float32) -> wp.vec2:
    """Return the point u of the unit square that `square_to_von_mises_fisher` maps to the direction w.

    u[0] = (1 - e^(-kappa (1 - cos theta))) / (1 - e^(-2 kappa)), u[1] the azimuth in turns.
    """
    k = wp.float64(kappa)
    share = exp_double(-k * versine(w))[0] / exp_double(-TWO * k)[0]
    return wp.vec2(clamp_uniform(wp.float32(share)), turns_of(w[0], w[1]))


@dataclass(frozen=True)
class VonMisesFisher(Distribution):
    """Von Mises-Fisher distribution about the normal, with density κ exp(κ(cosθ−1)) / (2π(1−e^(−2κ))) per steradian.

    Attributes:
        kappa: concentration, from 1e-6 (almost uniform) to 1e12.
    """

    kappa: float

    name = "von_mises_fisher"
    density = "κexp(κ(cosθ−1))/(2π(1−e^(−2κ)))"
    support = "sphere"
    parameters: ClassVar[tuple[str, ...]] = ("kappa",)
    shown: ClassVar[Range] = (0.1, 10000.0)
    bounds: ClassVar[Range] = (1e-6, 1e12)
    source = "Fisher1953; sampled as in Jakob2012"
    case_values: ClassVar[Cases] = (
        (1e-6,),
        (0.5,),
        (8.0,),
        (20.0,),
        (1000.0,),
        (1e12,),
    )  # from almost uniform to a millionth of a radian
    maps: ClassVar[Maps] = Maps(square_to_von_mises_fisher, square_to_von_mises_fisher_pdf, von_mises_fisher_to_square)

    def _cdf(self, theta: np.ndarray) -> np.ndarray:
        """Return the probability that the angle to +z is at most theta. See `Distribution.cdf`.

        It is (1 - e^(-kappa (1 - cos theta))) / (1 - e^(-2 kappa)).
        """
        versine = 2.0 * np.sin(0.5 * theta) ** 2
        return np.expm1(-self.kappa * versine) / np.expm1(-2.0 * self.kappa)


RECORD = VonMisesFisher
