"""Built-in integrands: Warp functions that return the weight of a ray, for ambient occlusion, sky view and others."""

from typing import Any

import numpy as np
import warp as wp

from warpsample.estimate.integrand import Integrand, Lobe
from warpsample.maths.frames import frame_about, to_local
from warpsample.maths.memory import vec3_at

_TURNS = wp.constant(wp.float32(0.15915494309189535))


@wp.struct
class Weights:
    """Data of the built-in integrands: a unit vector (x, y, z), and the address and size of an RGB float32 picture."""

    x: wp.float32
    y: wp.float32
    z: wp.float32
    pixels: wp.uint64
    width: wp.int32
    height: wp.int32


WeightsArgs: Any = type(Weights().__ctype__())


@wp.func
def everywhere(d: wp.vec3, lobe: Lobe, weights: Weights) -> wp.vec3:
    """Return the weight 1 of a ray in any direction, as the vector (1, 0, 0); used for ambient occlusion."""
    return wp.vec3(1.0, 0.0, 0.0)


@wp.func
def above(d: wp.vec3, lobe: Lobe, weights: Weights) -> wp.vec3:
    """Return the weight (1, 0, 0) of a direction above the horizon, or 0 below; the vector in `weights` points up."""
    return wp.vec3(wp.where(d[0] * weights.x + d[1] * weights.y + d[2] * weights.z > 0.0, 1.0, 0.0), 0.0, 0.0)


@wp.func
def itself(d: wp.vec3, lobe: Lobe, weights: Weights) -> wp.vec3:
    """Return the ray's direction as the weight, so that the mean weight is the bent normal."""
    return d


@wp.func
def _pixel(weights: Any, column: wp.int32, row: wp.int32) -> wp.vec3:
    column = wp.where(column < 0, column + weights.width, column)
    column = wp.where(column >= weights.width, column - weights.width, column)
    row = wp.clamp(row, 0, weights.height - 1)
    at = wp.uint64(row) * wp.uint64(weights.width) + wp.uint64(column)
    return vec3_at(weights.pixels + at * wp.uint64(12), 0)


@wp.func
def picture_radiance(d: wp.vec3, weights: Any):
    """Return the radiance of an environment picture in direction `d`, interpolated bilinearly.

    Rows go from the vector in `weights` down to its opposite. Columns go by azimuth in the frame about the vector.
    """
    w = to_local(frame_about(wp.vec3(weights.x, weights.y, weights.z)), d)
    turns = wp.atan2(w[1], w[0]) * _TURNS
    across = (turns - wp.floor(turns)) * wp.float32(weights.width) - 0.5
    down = wp.acos(wp.clamp(w[2], -1.0, 1.0)) * 2.0 * _TURNS * wp.float32(weights.height) - 0.5
    column = wp.int32(wp.floor(across))
    row = wp.int32(wp.floor(down))
    right = across - wp.float32(column)
    lower = down - wp.float32(row)
    top = wp.lerp(_pixel(weights, column, row), _pixel(weights, column + 1, row), right)
    bottom = wp.lerp(_pixel(weights, column, row + 1), _pixel(weights, column + 1, row + 1), right)
    return wp.lerp(top, bottom, lower)


@wp.func
def environment(d: wp.vec3, lobe: Lobe, weights: Weights) -> wp.vec3:
    """Return the radiance of an environment picture in direction `d`, see `picture_radiance`."""
    return picture_radiance(d, weights)


OPEN = Integrand(everywhere, 1, WeightsArgs(), Weights, constant=True, binary=True)
"""Integrand that is 1 in each direction, for ambient occlusion."""

DIRECTION = Integrand(itself, 3, WeightsArgs(), Weights)
"""Integrand that is the direction itself, for bent normals."""


def build_sky_integrand(up: Any) -> Integrand:
    """Build the integrand of the sky view factor: 1 for directions above the horizon, 0 below; `up` is a unit vector."""
    return Integrand(above, 1, WeightsArgs(x=up[0], y=up[1], z=up[2]), Weights, binary=True)


def build_environment_integrand(pixels: np.ndarray, up: Any) -> Integrand:
    """Build the integrand that looks up the radiance of a direction in an environment picture, (H, W, 3) float32."""
    height, width = pixels.shape[:2]
    data = WeightsArgs(x=up[0], y=up[1], z=up[2], width=width, height=height)
    return Integrand(environment, 3, data, Weights, arrays=(("pixels", pixels),))
