"""Functions of a direction with a known cosine-weighted mean, and estimates of the mean.

The functions are smooth, discontinuous or peaked. No function shares an axis with the unit square's coordinates: a
half-space along the strata of the azimuth would have no error. Axes are float32 in the kernels; rounding an axis moves a
mean by at most 1e-7.
"""

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from math import cos, radians, sin, sqrt
from typing import Any

import numpy as np
import warp as wp

from warpsample import sequences
from warpsample.bench.record import SEED
from warpsample.directions.means import direction_means
from warpsample.distributions.cosine_hemisphere import CosineHemisphere
from warpsample.distributions.elementwise import FLAT_BLOCK, elementwise
from warpsample.distributions.parameters import bind_parameters
from warpsample.host.arrays import cpu
from warpsample.host.engine import check_workers, run
from warpsample.host.vectors import as_vectors, new_vectors


@dataclass(frozen=True)
class KnownIntegral:
    """Function of a unit direction, with its known cosine-weighted mean.

    Attributes:
        name: name in tables.
        kind: "smooth", "discontinuous" or "peaked".
        function: `wp.func` (w: vec3) -> float32.
        mean: mean over directions of density cos(theta) / pi.
    """

    name: str
    kind: str
    function: wp.Function
    mean: float


def _build_axis(tilt: float, azimuth: float) -> tuple[wp.float32, wp.float32, wp.float32]:
    """Return a unit vector from its tilt and azimuth; `tilt` is the angle from +z in degrees."""
    t, a = radians(tilt), radians(azimuth)
    x, y, z = (np.float32(v) for v in (sin(t) * cos(a), sin(t) * sin(a), cos(t)))
    return wp.constant(wp.float32(x)), wp.constant(wp.float32(y)), wp.constant(wp.float32(z))


_CAP, _STREET_HEIGHT, _STREET_LEFT, _STREET_RIGHT, _LOBE = radians(20.0), 1.5, 0.6, 1.4, 64
_UP_X, _UP_Y, _UP_Z = _build_axis(60.0, 25.0)
_HALF_X, _HALF_Y, _HALF_Z = _build_axis(65.0, 40.0)
_CAP_X, _CAP_Y, _CAP_Z = _build_axis(35.0, 110.0)
_STREET_X, _STREET_Y, _ = _build_axis(90.0, 25.0)
_LOBE_X, _LOBE_Y, _LOBE_Z = _build_axis(30.0, 70.0)
_COS_CAP = wp.constant(wp.float32(cos(_CAP)))
_LEFT = wp.constant(wp.float32(_STREET_LEFT / _STREET_HEIGHT))
_RIGHT = wp.constant(wp.float32(_STREET_RIGHT / _STREET_HEIGHT))


@wp.func
def cosine(w: wp.vec3) -> wp.float32:
    """Return cos(theta), the cosine of the angle to the normal."""
    return w[2]


@wp.func
def cosine_power(w: wp.vec3) -> wp.float32:
    """Return the eighth power of the cosine of the angle to the normal, cos(theta)^8."""
    squared = w[2] * w[2]
    return squared * squared * squared * squared


@wp.func
def sky_gradient(w: wp.vec3) -> wp.float32:
    """Return Moon and Spencer's overcast sky, (1 + 2 sin(elevation)) / 3, over a tilted plane."""
    return (1.0 + 2.0 * (w[0] * _UP_X + w[1] * _UP_Y + w[2] * _UP_Z)) / 3.0


@wp.func
def half_space(w: wp.vec3) -> wp.float32:
    """Return 1 if w is on the front side of a tilted plane, else 0."""
    return wp.where(w[0] * _HALF_X + w[1] * _HALF_Y + w[2] * _HALF_Z > 0.0, 1.0, 0.0)


@wp.func
def cap(w: wp.vec3) -> wp.float32:
    """Return 1 if w is within 20 degrees of an axis, else 0."""
    return wp.where(w[0] * _CAP_X + w[1] * _CAP_Y + w[2] * _CAP_Z > _COS_CAP, 1.0, 0.0)


@wp.func
def canyon(w: wp.vec3) -> wp.float32:
    """Return 1 if w leaves an infinitely long street from its floor, else 0."""
    across = w[0] * _STREET_X + w[1] * _STREET_Y
    return wp.where(-w[2] * _LEFT < across, wp.where(across < w[2] * _RIGHT, 1.0, 0.0), 0.0)


@wp.func
def narrow_lobe(w: wp.vec3) -> wp.float32:
    """Return cos^64 of the angle to an axis: a peak 12 degrees wide at half its height."""
    x = wp.max(w[0] * _LOBE_X + w[1] * _LOBE_Y + w[2] * _LOBE_Z, 0.0)
    x = x * x
    x = x * x
    x = x * x
    x = x * x
    x = x * x
    return x * x


def _compute_street_mean() -> float:
    left, right = (side / sqrt(side**2 + _STREET_HEIGHT**2) for side in (_STREET_LEFT, _STREET_RIGHT))
    return (left + right) / 2.0


INTEGRANDS = (
    KnownIntegral("cosine", "smooth", cosine, 2.0 / 3.0),
    KnownIntegral("cosine^8", "smooth", cosine_power, 2.0 / 10.0),
    KnownIntegral("sky gradient", "smooth", sky_gradient, (1.0 + 4.0 / 3.0 * float(_UP_Z)) / 3.0),
    KnownIntegral("half-space", "discontinuous", half_space, (1.0 + float(_HALF_Z)) / 2.0),
    KnownIntegral("20° cap", "discontinuous", cap, float(_CAP_Z) * sin(_CAP) ** 2),
    KnownIntegral("street canyon", "discontinuous", canyon, _compute_street_mean()),
    KnownIntegral("narrow lobe", "peaked", narrow_lobe, 2.0 * float(_LOBE_Z) / (_LOBE + 2)),
)


def evaluate(integrand: KnownIntegral, w: np.ndarray) -> np.ndarray:
    """Evaluate an integrand at unit directions (..., 3) in the local frame; return (...) float32."""
    source = as_vectors(w, 3, "w")
    target = new_vectors(source, source.shape, 1)
    kernel = elementwise(bind_parameters(integrand.function, wp.vec3, 0), 3, 1)
    inputs = [source.count, FLAT_BLOCK, source.address, target.address, CosineHemisphere().kernel_parameters()]
    run(kernel, -(-source.count // FLAT_BLOCK), inputs, source.device, workers=check_workers(None), work=source.count)
    return target.owner


def compute_estimates(
    integrand: KnownIntegral, sequence: str, count: int, randomisations: int, *, seed: int = SEED, workers: int | None = None
) -> np.ndarray:
    """Compute means over `count` directions, one randomisation of the sequence each; return (randomisations,) float64."""
    out = np.empty(randomisations)
    build_estimator(integrand, sequence, count, out, seed=seed, workers=workers)()
    return out


def build_estimator(
    integrand: KnownIntegral, sequence: str, count: int, out: np.ndarray, *, seed: int = SEED, workers: int | None = None
) -> Callable[[], Any]:
    """Build a function that fills `out`, float64, with means over `count` directions, one randomisation each."""
    lobe = CosineHemisphere()
    kernel = direction_means(sequences.get(sequence), lobe.about(), integrand.function)
    inputs = [seed, 0, count, out.__array_interface__["data"][0], lobe.kernel_parameters().__ctype__()]
    return partial(run, kernel, len(out), inputs, cpu(), workers=check_workers(workers), work=len(out) * count)
