"""Linearly transformed cosine: the cosine lobe after a linear transformation of its directions."""

from dataclasses import dataclass
from typing import Any, ClassVar

import numpy as np
import warp as wp

from warpsample.distributions.record import Cases, Distribution, Maps
from warpsample.host.arguments import quote
from warpsample.host.arrays import as_real
from warpsample.maths.angles import sincos_turns_double, turns_of
from warpsample.maths.numerics import INV_PI_DOUBLE, ONE, ZERO, clamp_uniform, root_double

Matrix = tuple[tuple[float, float, float], tuple[float, float, float], tuple[float, float, float]]

_WANTS = "3 x 3 finite numbers with a determinant other than 0"
_LEAST_DETERMINANT = 1e-15  # of the cube of the Frobenius norm: below, float32 directions do not resolve the lobe
_BLUR = wp.constant(wp.float64(2.0**-23))


@wp.func
def adjugate_of(matrix: wp.mat33) -> wp.mat33d:
    """Return the adjugate of a matrix, its inverse times its determinant, in float64: float32 products are exact there."""
    a, b, c = wp.float64(matrix[0, 0]), wp.float64(matrix[0, 1]), wp.float64(matrix[0, 2])
    d, e, f = wp.float64(matrix[1, 0]), wp.float64(matrix[1, 1]), wp.float64(matrix[1, 2])
    g, h, i = wp.float64(matrix[2, 0]), wp.float64(matrix[2, 1]), wp.float64(matrix[2, 2])
    return wp.mat33d(
        e * i - f * h, c * h - b * i, b * f - c * e,
        f * g - d * i, a * i - c * g, c * d - a * f,
        d * h - e * g, b * g - a * h, a * e - b * d,
    )  # fmt: skip


@wp.func
def determinant_of(matrix: wp.mat33, adjugate: wp.mat33d) -> wp.float64:
    """Return the determinant of a matrix with a known adjugate, in float64."""
    return (
        wp.float64(matrix[0, 0]) * adjugate[0, 0]
        + wp.float64(matrix[0, 1]) * adjugate[1, 0]
        + wp.float64(matrix[0, 2]) * adjugate[2, 0]
    )


@wp.func
def transformed(matrix: wp.mat33d, x: wp.float64, y: wp.float64, z: wp.float64) -> wp.vec3d:
    """Return the product of a 3 x 3 matrix and the vector (x, y, z)."""
    return wp.vec3d(
        matrix[0, 0] * x + matrix[0, 1] * y + matrix[0, 2] * z,
        matrix[1, 0] * x + matrix[1, 1] * y + matrix[1, 2] * z,
        matrix[2, 0] * x + matrix[2, 1] * y + matrix[2, 2] * z,
    )


@wp.func
def square_to_linearly_transformed_cosine(u: wp.vec2, matrix: wp.mat33) -> wp.vec3:
    """Map a point of the unit square to a direction M o / abs(M o), for a matrix M and a cosine-distributed direction o.

    o has cos theta = sqrt(1 - u[0]) and azimuth 2 pi u[1]. The arithmetic is float64, because M can stretch a rounding error
    of o.
    """
    r = root_double(wp.float64(u[0]))
    cs = sincos_turns_double(wp.float64(u[1]))
    v = transformed(wp.mat33d(matrix), r * cs[0], r * cs[1], wp.sqrt(ONE - wp.float64(u[0])))
    inverse = ONE / wp.sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2])
    return wp.vec3(wp.float32(v[0] * inverse), wp.float32(v[1] * inverse), wp.float32(v[2] * inverse))


@wp.func
def square_to_linearly_transformed_cosine_pdf(w: wp.vec3, matrix: wp.mat33) -> wp.float32:
    """Return the density of a linearly transformed cosine at a direction w, per steradian; 0 where o.z is below 0.

    The density is max(0, sign(D) (A w).z) D^2 / (pi abs(A w)^4), with the adjugate A and the determinant D of the matrix.
    The horizon, (A w).z = 0, is blurred by the rounding error of (A w).z, so that no sampled direction has density 0.
    """
    adjugate = adjugate_of(matrix)
    determinant = determinant_of(matrix, adjugate)
    x, y, z = wp.float64(w[0]), wp.float64(w[1]), wp.float64(w[2])
    v = transformed(adjugate, x, y, z)
    rounding = _BLUR * (wp.abs(adjugate[2, 0] * x) + wp.abs(adjugate[2, 1] * y) + wp.abs(adjugate[2, 2] * z))
    above = wp.where(determinant > ZERO, v[2], -v[2])
    ratio = determinant / (v[0] * v[0] + v[1] * v[1] + v[2] * v[2])
    return wp.where(above > -rounding, wp.float32(wp.max(above, rounding) * ratio * ratio * INV_PI_DOUBLE), 0.0)


@wp.func
def linearly_transformed_cosine_to_square(w: wp.vec3, matrix: wp.mat33) -> wp.vec2:
    """Return the point u of the unit square that `square_to_linearly_transformed_cosine` maps to the direction w.

    For o along the inverse of the matrix times w, u[0] = sin^2 theta and u[1] is the azimuth in turns.
    """
    adjugate = adjugate_of(matrix)
    v = transformed(adjugate, wp.float64(w[0]), wp.float64(w[1]), wp.float64(w[2]))
    across = v[0] * v[0] + v[1] * v[1]
    square = ONE / (across + v[2] * v[2])
    per_length = wp.sqrt(square)
    per_length = wp.where(determinant_of(matrix, adjugate) > ZERO, per_length, -per_length)
    turns = turns_of(wp.float32(v[0] * per_length), wp.float32(v[1] * per_length))
    return wp.vec2(clamp_uniform(wp.float32(across * square)), turns)


@dataclass(frozen=True)
class LinearlyTransformedCosine(Distribution):
    """Linearly transformed cosine (LTC): directions M o / abs(M o), for a matrix M and cosine-distributed directions o.

    The density is max(0, o_z) / (π abs(det M) abs(M⁻¹w)³) per steradian. It is above 0 in a hemisphere, which may reach
    below the surface. Published tables often hold the inverse of M.

    Attributes:
        matrix: matrix M, 3 x 3 numbers, with a determinant above 1e-15 of the cube of its Frobenius norm, of any sign. The
            scale of M does not matter; M is stored with its largest entry between 1 and 2.
    """

    matrix: Matrix = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))

    name = "linearly_transformed_cosine"
    density = "max(0,o_z)/(π abs(det M)abs(M⁻¹w)³), o=M⁻¹w/abs(M⁻¹w)"
    support = "hemisphere"
    parameters: ClassVar[tuple[str, ...]] = ("matrix",)
    source = "Heitz2016, equation 1"
    symmetric = False
    polar = False
    worst_round_trip: ClassVar[float] = 1e-5
    limits = (
        "the support is the hemisphere about M⁻ᵀz. The density is blurred by rounding at the horizon of o. The error of the "
        "inverse is measured for u[0] above 0.01, and grows with the condition of M, because M⁻¹ stretches the rounding of w"
    )
    # The cosine lobe, one as of a rough mirror, a long one along y, a narrow one that leans, and a mirrored one that reaches
    # below the surface.
    case_values: ClassVar[Cases] = (
        (((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)),),
        (((0.4, 0.0, 0.3), (0.0, 0.3, 0.0), (-0.25, 0.0, 1.0)),),
        (((0.01, 0.0, 0.0), (0.0, 0.5, 0.0), (0.0, 0.0, 1.0)),),
        (((0.016, 0.0, 0.6), (0.0, 0.01, 0.0), (-0.012, 0.0, 0.8)),),
        (((0.2, -0.5, 0.9), (1.0, 0.3, 0.2), (0.4, 0.7, 0.1)),),
    )
    maps: ClassVar[Maps] = Maps(
        square_to_linearly_transformed_cosine,
        square_to_linearly_transformed_cosine_pdf,
        linearly_transformed_cosine_to_square,
    )

    def __post_init__(self) -> None:
        """Raise an error if the matrix is singular or not finite, and scale the matrix."""
        super().__post_init__()
        if getattr(self.matrix, "ndim", 2) == 3:
            return
        matrix = as_real(self.matrix, "matrix", _WANTS)
        usable = matrix.shape == (3, 3) and not np.isnan(scaled := _scale(matrix[None])[0]).any()
        if not usable:
            raise ValueError(f"matrix: got {quote(self.matrix)}, want {_WANTS}")
        object.__setattr__(self, "matrix", tuple(map(tuple, scaled.tolist())))

    def _copy_rows(self, name: str, rows: np.ndarray) -> np.ndarray:
        """Return a read-only float32 copy of matrices with one per point, scaled."""
        return super()._copy_rows(name, _scale(rows))

    @property
    def stretch(self) -> Matrix:
        """Matrix of the distribution, rounded to float32."""
        return tuple(map(tuple, np.array(self.matrix, np.float32).astype(np.float64).tolist()))

    @property
    def largest_angle(self) -> float:
        """Largest angle between the directions before the transformation and +z, in radians, with a margin for rounding."""
        return float(np.pi / 2.0 + 2.0 * float(_BLUR) * min(np.linalg.cond(self.stretch), 1e5))

    def seam(self, u: Any) -> Any:
        """Return a mask of unit-square points that `invert` cannot recover precisely. See `Distribution.seam`."""
        return u[..., 0] < 0.01


def _scale(matrices: np.ndarray) -> np.ndarray:
    """Scale matrices, (P, 3, 3), by powers of two to a largest entry from 1 to 2; matrices out of range become NaN."""
    matrices = matrices.astype(np.float64)
    largest = np.abs(matrices).max(axis=(1, 2))
    usable = (largest > 0.0) & (largest < np.inf)
    _, exponent = np.frexp(np.where(usable, largest, 1.0))
    scaled = np.ldexp(np.where(usable[:, None, None], matrices, 1.0), 1 - exponent[:, None, None])
    rounded = scaled.astype(np.float32).astype(np.float64)
    norm = np.sqrt(np.square(rounded).sum(axis=(1, 2)))
    usable &= np.abs(np.linalg.det(rounded)) > _LEAST_DETERMINANT * norm * np.square(norm)
    return np.where(usable[:, None, None], scaled, np.nan)


RECORD = LinearlyTransformedCosine
