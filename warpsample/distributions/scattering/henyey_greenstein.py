"""Henyey-Greenstein phase function: light scattered by small particles, about the direction of flight."""

from dataclasses import dataclass
from typing import ClassVar

import numpy as np
import warp as wp

from warpsample.distributions.record import Cases, Distribution, Maps, Range
from warpsample.maths.angles import turns_of
from warpsample.maths.numerics import INV_PI, ONE, TWO, clamp_uniform, fma, root_double, sincos_turns

_MOST = 0.999999


@wp.func
def _versines(w: wp.vec3) -> wp.vec2:
    """Return (1 - cos, 1 + cos) of the angle between w and +z, both precise at every angle."""
    across = fma(w[0], w[0], w[1] * w[1])
    small = across / (1.0 + wp.abs(w[2]))
    large = 1.0 + wp.abs(w[2])
    return wp.vec2(wp.where(w[2] > 0.0, small, large), wp.where(w[2] > 0.0, large, small))


@wp.func
def _squared_distance(w: wp.vec3, g: wp.float32) -> wp.float32:
    """Return 1 + g^2 - 2 g cos of the angle between w and +z, as a sum of two numbers that are not negative."""
    versines = _versines(w)
    edge = wp.where(g > 0.0, 1.0 - g, 1.0 + g)
    return fma(edge, edge, 2.0 * wp.where(g > 0.0, g * versines[0], -g * versines[1]))


@wp.func
def square_to_henyey_greenstein(u: wp.vec2, g: wp.float32) -> wp.vec3:
    """Map a point of the unit square to a direction scattered by Henyey and Greenstein's phase function about +z.

    1 - cos theta = 2 (1 - g)^2 u[0] (1 + g (1 - u[0])) / d^2 and 1 + cos theta = 2 (1 + g)^2 (1 - u[0]) (1 - g u[0]) / d^2
    with d = 1 + g - 2 g u[0], azimuth 2 pi u[1]. No formula divides by g, so that the smallest g is as precise as any other.
    The arithmetic is float64, because 1 - abs(g) is small in a narrow lobe.
    """
    x = wp.float64(u[0])
    size = wp.float64(g)
    inverse = ONE / (ONE + size - TWO * size * x)
    near = (ONE - size) * inverse
    far = (ONE + size) * inverse
    near = TWO * near * near * x * (ONE + size * (ONE - x))
    far = TWO * far * far * (ONE - x) * (ONE - size * x)
    r = wp.float32(root_double(near * far))
    cs = sincos_turns(u[1])
    return wp.vec3(r * cs[0], r * cs[1], wp.float32(wp.where(near < far, ONE - near, far - ONE)))


@wp.func
def square_to_henyey_greenstein_pdf(w: wp.vec3, g: wp.float32) -> wp.float32:
    """Return Henyey and Greenstein's phase function at a direction w, per steradian; 0 where w is NaN.

    The density is (1 - g^2) / (4 pi (1 + g^2 - 2 g cos theta)^(3/2)), with theta the angle between w and +z.
    """
    inverse = 1.0 / _squared_distance(w, g)
    density = 0.25 * INV_PI * (1.0 - g) * (1.0 + g) * inverse * wp.sqrt(inverse)
    return wp.where(w[2] == w[2], density, 0.0)


@wp.func
def henyey_greenstein_to_square(w: wp.vec3, g: wp.float32) -> wp.vec2:
    """Return the point u of the unit square that `square_to_henyey_greenstein` maps to the direction w.

    u[0] = (1 + g) (1 - cos theta) / (r (1 - g + r)) with r^2 = 1 + g^2 - 2 g cos theta, u[1] the azimuth in turns.
    """
    r = wp.sqrt(_squared_distance(w, g))
    share = (1.0 + g) * _versines(w)[0] / (r * (1.0 - g + r))
    return wp.vec2(clamp_uniform(share), turns_of(w[0], w[1]))


@dataclass(frozen=True)
class HenyeyGreenstein(Distribution):
    """Henyey-Greenstein phase function of scattered light, with density (1−g²) / (4π(1+g²−2g cosθ)^(3/2)) per steradian.

    θ is the angle to the direction of flight, which takes the place of the normal, so g > 0 scatters forward.

    Attributes:
        g: mean cosine of the scattering angle, from -0.999999 (backward) to 0.999999 (forward); 0 is uniform.
    """

    g: float

    name = "henyey_greenstein"
    density = "(1−g²)/(4π(1+g²−2g cosθ)^(3/2))"
    support = "sphere"
    parameters: ClassVar[tuple[str, ...]] = ("g",)
    shown: ClassVar[Range] = (0.1, 0.98)
    bounds: ClassVar[Range] = (-_MOST, _MOST)
    source = "Henyey1941; sampled as in Pharr2023, section 11.3.1"
    # Uniform, almost uniform, backward, forward, and almost a beam.
    case_values: ClassVar[Cases] = ((0.0,), (1e-7,), (-1e-3,), (-0.7,), (0.7,), (-0.99,), (0.9999,), (_MOST,))
    maps: ClassVar[Maps] = Maps(square_to_henyey_greenstein, square_to_henyey_greenstein_pdf, henyey_greenstein_to_square)

    def _cdf(self, theta: np.ndarray) -> np.ndarray:
        """Return the probability that the angle to +z is at most theta: (1 + g) (1 - cos theta) / (r (1 - g + r))."""
        g = float(np.float32(self.g))  # as in the kernels: 1 - g may be small
        sine, cosine = np.sin(0.5 * theta), np.cos(0.5 * theta)
        r = np.hypot((1.0 - g) * cosine, (1.0 + g) * sine)
        return 2.0 * (1.0 + g) * sine**2 / (r * (1.0 - g + r))


RECORD = HenyeyGreenstein
