"""Uniform distribution of directions in a cone about the normal."""

from dataclasses import dataclass
from typing import ClassVar

import numpy as np
import warp as wp

from warpsample.distributions.by_point.rows import as_rows, copy_rows, is_array
from warpsample.distributions.record import Cases, Distribution, Maps, Range
from warpsample.host.arguments import check_number
from warpsample.maths.angles import turns_of, versine
from warpsample.maths.numerics import INV_TWO_PI, TWO, clamp_uniform, root, sincos_turns

_RIM = wp.constant(wp.float64(5e-7))  # directions within rounding of the edge are in the cone
_LEAST = 1e-24


@wp.func
def square_to_uniform_cone(u: wp.vec2, one_minus_cos: wp.float32) -> wp.vec3:
    """Map a point of the unit square to a uniform direction in the cone 1 - cos theta < one_minus_cos about +z.

    h = 1 - cos theta = u[0] one_minus_cos, azimuth 2 pi u[1]. sin theta = sqrt(h (2 - h)) is precise for narrow cones. 2 - h
    is a sum of two positive terms, so that a cone of the whole sphere is precise at the far pole, too.
    """
    h = u[0] * one_minus_cos
    rest = (2.0 - one_minus_cos) + (1.0 - u[0]) * one_minus_cos
    r = root(h * rest)
    cs = sincos_turns(u[1])
    return wp.vec3(r * cs[0], r * cs[1], wp.where(h < 1.0, 1.0 - h, rest - 1.0))


@wp.func
def square_to_uniform_cone_pdf(w: wp.vec3, one_minus_cos: wp.float32) -> wp.float32:
    """Return the density 1 / (2 pi one_minus_cos) per steradian inside the cone, else 0."""
    edge = wp.float64(one_minus_cos)
    return wp.where(versine(w) <= edge + _RIM * wp.min(edge, TWO - edge), INV_TWO_PI / one_minus_cos, 0.0)


@wp.func
def uniform_cone_to_square(w: wp.vec3, one_minus_cos: wp.float32) -> wp.vec2:
    """Return the point u of the unit square that `square_to_uniform_cone` maps to the direction w.

    u[0] = (1 - cos theta) / one_minus_cos, u[1] the azimuth in turns.
    """
    return wp.vec2(clamp_uniform(wp.float32(versine(w) / wp.float64(one_minus_cos))), turns_of(w[0], w[1]))


@dataclass(frozen=True)
class UniformCone(Distribution):
    """Uniform distribution in a cone of half angle θₘ about the normal, with density 1 / (2π(1 − cosθₘ)) per steradian.

    Give one of the two attributes.

    Attributes:
        cos_angle: cosine of the half angle θₘ between axis and edge, in [-1, 1).
        one_minus_cos: 1 - cos_angle, in [1e-24, 2], for narrow cones: a half angle of 1e-6 rad gives 5e-13, of which
            cos_angle keeps only four digits.
    """

    cos_angle: float | None = None
    one_minus_cos: float | None = None

    name = "uniform_cone"
    density = "1/(2π(1−cosθₘ))"
    support = "cone"
    parameters: ClassVar[tuple[str, ...]] = ("one_minus_cos",)
    shown: ClassVar[Range] = (1e-4, 2.0)
    source = "Pharr2023, section A.5.4"
    # Values of one_minus_cos from the whole sphere to the sun's disk (1.08e-5) and narrower.
    case_values: ClassVar[Cases] = ((None, 2.0), (None, 1.999), (None, 1.0), (None, 0.25), (None, 1.08e-5), (None, 1e-24))
    maps: ClassVar[Maps] = Maps(square_to_uniform_cone, square_to_uniform_cone_pdf, uniform_cone_to_square)

    def __post_init__(self) -> None:
        """Check that one attribute is given, or two that agree, and compute the other attribute."""
        if is_array(self.one_minus_cos) or is_array(self.cos_angle):
            self._set_rows()
        elif self.one_minus_cos is None:
            if self.cos_angle is None:
                raise TypeError("cos_angle: got None, want a number from -1 to below 1, or one_minus_cos instead")
            cosine = check_number(self.cos_angle, "cos_angle", -1.0, 1.0)
            if cosine == 1.0:
                raise ValueError("cos_angle: got 1.0, want a number from -1 to below 1")
            object.__setattr__(self, "one_minus_cos", 1.0 - cosine)
            object.__setattr__(self, "cos_angle", 1.0 - self.one_minus_cos)
        else:
            object.__setattr__(self, "one_minus_cos", check_number(self.one_minus_cos, "one_minus_cos", _LEAST, 2.0))
            cos_angle = None if self.cos_angle is None else check_number(self.cos_angle, "cos_angle", -1.0, 1.0)
            if cos_angle not in (None, 1.0 - self.one_minus_cos):
                raise TypeError(f"cos_angle: got {cos_angle!r} together with one_minus_cos, want only one of the two")
            object.__setattr__(self, "cos_angle", 1.0 - self.one_minus_cos)

    def _set_rows(self) -> None:
        """Check the attribute that is an array with a row per point, and compute the other attribute from it."""
        if self.cos_angle is not None and self.one_minus_cos is not None:
            raise TypeError("cos_angle: got both cos_angle and one_minus_cos, want only one of the two")
        name = "cos_angle" if self.one_minus_cos is None else "one_minus_cos"
        rows = as_rows(getattr(self, name), name, 0)
        if rows is None:
            check_number(getattr(self, name), name, -1.0, 2.0)  # an array without dimensions is an error
            return
        rows = rows.astype(np.float64)
        depth = copy_rows(1.0 - rows if name == "cos_angle" else rows, _LEAST, 2.0)
        object.__setattr__(self, "one_minus_cos", depth)
        object.__setattr__(self, "cos_angle", copy_rows(1.0 - depth))

    @property
    def largest_angle(self) -> float:
        """Half angle of the cone, between axis and edge, in radians."""
        return float(2.0 * np.arcsin(np.sqrt(0.5 * self.one_minus_cos)))

    def _cdf(self, theta: np.ndarray) -> np.ndarray:
        """Return the probability that the angle to +z is at most theta: (1 - cos theta) / one_minus_cos, at most 1."""
        return np.minimum(2.0 * np.sin(0.5 * theta) ** 2 / self.one_minus_cos, 1.0)


RECORD = UniformCone
