"""Integrands of a picture that rays sample from two distributions, weighted by the balance heuristic (Veach1995)."""

from typing import Any

import numpy as np
import warp as wp

from warpsample.distributions.lights.picture_reading import PictureReading, square_to_reading_pdf
from warpsample.estimate.integrand import Integrand, Lobe
from warpsample.estimate.weights import picture_radiance
from warpsample.maths.numerics import INV_PI

_PI = wp.constant(wp.float32(3.141592653589793))
_LEAST_COSINE = wp.constant(wp.float32(2.0**-12))


@wp.struct
class SampledPicture:
    """Data of the integrands: the picture as in `Weights`, the table of its density, and rays of the other distribution.

    table: Address of the table of a `PictureReading`.
    ratio: Number of rays from the other distribution for each ray.
    """

    x: wp.float32
    y: wp.float32
    z: wp.float32
    pixels: wp.uint64
    width: wp.int32
    height: wp.int32
    table: wp.uint64
    ratio: wp.float32


SampledPictureArgs: Any = type(SampledPicture().__ctype__())


@wp.func
def by_cosine(d: wp.vec3, lobe: Lobe, data: SampledPicture) -> wp.vec3:
    """Return radiance * cosine / (cosine / pi + ratio * density of the picture), for rays of the cosine lobe."""
    radiance = picture_radiance(d, data)
    if radiance[0] + radiance[1] + radiance[2] > 0.0:
        cosine = wp.max(wp.dot(d, lobe.normal), _LEAST_COSINE)
        radiance *= _PI / (1.0 + data.ratio * _PI * square_to_reading_pdf(d, data.table) / cosine)
    return radiance


@wp.func
def by_picture(d: wp.vec3, lobe: Lobe, data: SampledPicture) -> wp.vec3:
    """Return radiance * cosine / (density of the picture + ratio * cosine / pi), for rays of the picture."""
    cosine = wp.dot(d, lobe.normal)
    if cosine < _LEAST_COSINE or lobe.pdf <= 0.0:  # 0: luminances that underflow
        return wp.vec3(0.0)
    return picture_radiance(d, data) * (cosine / (lobe.pdf + data.ratio * cosine * INV_PI))


def sampled_by(function: wp.Function, pixels: np.ndarray, lobe: PictureReading, ratio: float) -> Integrand:
    """Return the integrand `by_cosine` or `by_picture` of a picture (H, W, 3), contiguous float32.

    Args:
        function: `by_cosine` or `by_picture`.
        pixels: radiances.
        lobe: density of the rays of the picture; its `up` is that of the picture.
        ratio: number of rays from the other distribution for each ray.
    """
    height, width = pixels.shape[:2]
    x, y, z = lobe.up
    data = SampledPictureArgs(x=x, y=y, z=z, width=width, height=height, ratio=ratio)
    arrays = (("pixels", pixels), ("table", lobe.table_array))
    is_cosine = function is by_cosine
    return Integrand(function, 3, data, SampledPicture, reads_pdf=not is_cosine, sparse=not is_cosine, arrays=arrays)
