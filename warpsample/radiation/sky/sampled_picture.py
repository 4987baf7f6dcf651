"""Integrands of a picture that rays sample from two distributions, weighted by the balance heuristic (Veach1995)."""

from typing import Any

import numpy as np
import warp as wp

from warpsample.distributions.lights.picture import LUMINANCE
from warpsample.distributions.lights.picture_reading import PictureReading
from warpsample.distributions.lights.pixel_draws import cap_of
from warpsample.distributions.lights.pixel_table import HEADER, ROW
from warpsample.estimate.integrand import Integrand, Lobe
from warpsample.maths.angles import turns_of
from warpsample.maths.frames import frame_about, to_local
from warpsample.maths.numerics import INV_PI, ONE, ZERO

_PI = wp.constant(wp.float32(3.141592653589793))
_RED, _GREEN, _BLUE = (wp.constant(wp.float32(weight)) for weight in LUMINANCE)
_LEAST_COSINE = wp.constant(wp.float32(2.0**-12))


@wp.struct
class SampledPicture:
    """Data of the integrands: the picture as in `Weights`, the table of its density, and rays of the other distribution.

    table: Address of the table of a `PictureReading`.
    ratio: Number of rays from the other distribution for each ray.
    floor: Luminance that is subtracted from that of each pixel for the density of the rays of the picture.
    per_luminance: Density of the rays of the picture over the luminance that is left.
    """

    x: wp.float32
    y: wp.float32
    z: wp.float32
    pixels: wp.uint64
    width: wp.int32
    height: wp.int32
    table: wp.uint64
    ratio: wp.float32
    floor: wp.float32
    per_luminance: wp.float64


SampledPictureArgs: Any = type(SampledPicture().__ctype__())


@wp.func
def _pixel(data: SampledPicture, column: wp.int32, row: wp.int32) -> wp.vec3:
    """Return the radiance of a pixel; columns -1 and `width` are the last and the first, and rows beyond a pole repeat."""
    pixels = wp.array(ptr=data.pixels, shape=(3,), dtype=wp.uint32)  # no float32: see `pixel_table`
    across = wp.where(column < 0, data.width - 1, wp.where(column >= data.width, 0, column))
    at = 3 * (wp.clamp(row, 0, data.height - 1) * data.width + across)
    return wp.vec3(wp.cast(pixels[at], wp.float32), wp.cast(pixels[at + 1], wp.float32), wp.cast(pixels[at + 2], wp.float32))


@wp.func
def _excess(c: wp.vec3, data: SampledPicture) -> wp.float32:
    """Return how much the luminance of a colour, as of `weigh_colours`, exceeds the floor; 0 below the floor."""
    return wp.max(_RED * c[0] + _GREEN * c[1] + _BLUE * c[2] - data.floor, 0.0)


@wp.func
def _read(d: wp.vec3, data: SampledPicture):
    """Return the radiance in a direction, `picture_radiance` but for rounding, and the density of the picture's rays.

    There are no calls of libm and no branches, so that a loop over directions is vectorised.
    """
    w = to_local(frame_about(wp.vec3(data.x, data.y, data.z)), d)
    across = turns_of(w[0], w[1]) * wp.float32(data.width) - 0.5
    down = turns_of(w[2], wp.sqrt(w[0] * w[0] + w[1] * w[1])) * 2.0 * wp.float32(data.height) - 0.5
    column = wp.int32(wp.floor(across))
    row = wp.int32(wp.floor(down))
    right = across - wp.float32(column)
    a, b = _pixel(data, column, row), _pixel(data, column + 1, row)
    c, e = _pixel(data, column, row + 1), _pixel(data, column + 1, row + 1)
    # The density is bilinear in the area of the cap above a direction, see `PictureReading`.
    lines = wp.array(ptr=data.table + wp.uint64(8 * HEADER), shape=(ROW,), dtype=wp.float64)
    at = ROW * wp.clamp(row + 1, 0, data.height)
    lower = wp.clamp((cap_of(wp.vec3d(w)) - lines[at + 2]) / lines[at + 3], ZERO, ONE)
    top, bottom = wp.lerp(_excess(a, data), _excess(b, data), right), wp.lerp(_excess(c, data), _excess(e, data), right)
    density = wp.float32(wp.float64(wp.lerp(top, bottom, wp.float32(lower))) * data.per_luminance)
    return wp.lerp(wp.lerp(a, b, right), wp.lerp(c, e, right), down - wp.float32(row)), density


@wp.func
def by_cosine(d: wp.vec3, lobe: Lobe, data: SampledPicture) -> wp.vec3:
    """Return radiance * cosine / (cosine / pi + ratio * density of the picture), for rays of the cosine lobe."""
    radiance, density = _read(d, data)
    cosine = wp.max(wp.dot(d, lobe.normal), _LEAST_COSINE)
    return radiance * (_PI / (1.0 + data.ratio * _PI * density / cosine))


@wp.func
def by_picture(d: wp.vec3, lobe: Lobe, data: SampledPicture) -> wp.vec3:
    """Return radiance * cosine / (density of the picture + ratio * cosine / pi), for rays of the picture."""
    cosine = wp.dot(d, lobe.normal)
    density = lobe.pdf + data.ratio * cosine * INV_PI
    counts = cosine >= _LEAST_COSINE and lobe.pdf > 0.0  # 0: luminances that underflow
    radiance, _density = _read(d, data)
    return radiance * wp.where(counts, cosine / density, 0.0)


def sampled_by(function: wp.Function, pixels: np.ndarray, lobe: PictureReading, floor: float, ratio: float) -> Integrand:
    """Return the integrand `by_cosine` or `by_picture` of a picture (H, W, 3), contiguous float32.

    Args:
        function: `by_cosine` or `by_picture`.
        pixels: radiances.
        lobe: density of the rays of the picture; its `up` is that of the picture.
        floor: luminance that was subtracted from that of each pixel for the density.
        ratio: number of rays from the other distribution for each ray.
    """
    height, width = pixels.shape[:2]
    sizes: dict[str, Any] = {"width": width, "height": height, **dict(zip("xyz", lobe.up, strict=True))}
    data = SampledPictureArgs(**sizes, ratio=ratio, floor=floor, per_luminance=lobe.per_luminance)
    arrays = (("pixels", pixels), ("table", lobe.table_array))
    is_cosine = function is by_cosine
    return Integrand(function, 3, data, SampledPicture, reads_pdf=not is_cosine, sparse=not is_cosine, arrays=arrays)
