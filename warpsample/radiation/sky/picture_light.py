"""Distant light given as a picture of the whole sphere, with rays from the cosine lobe, from the picture, or from both."""

from dataclasses import dataclass
from functools import cached_property
from hashlib import sha256
from math import pi, sqrt
from typing import Any, Literal

import numpy as np

from warpsample.distributions.lights.picture import weigh_colours
from warpsample.distributions.lights.picture_reading import PictureReading
from warpsample.distributions.lights.pixel_table import pixel_angles, solid_angles
from warpsample.estimate.plan import RaySum
from warpsample.estimate.result import Estimate
from warpsample.estimate.split import SplitSum
from warpsample.estimate.weights import build_environment_integrand
from warpsample.host.shared_values import find_or_make
from warpsample.radiation.sky.sampled_picture import by_cosine, by_picture, sampled_by

Sampling = Literal["cosine", "picture", "both"]

_MOST, _LEAST = 0.875, 0.1  # share of the rays from the picture with "both"
_MOST_OF_SPOTS, _LEAST_OF_SPOTS = 0.5, 0.125  # and for the light of few pixels
_SPREAD = 5.0 / 3.0  # relative variance of one ray of the picture: cosines above the receiver's plane, of all directions
_GAIN = 0.9  # most variance of all rays with such a share, relative to the variance without
_SHADOWS = 0.05  # relative variance of one ray of the lobe by what blocks it, as between trees and houses


@dataclass(frozen=True, eq=False)
class PictureLight:
    """Picture of distant light.

    Attributes:
        pixels: (H, W, 3) contiguous float32, radiances.
        up: Unit vector towards row 0.
        colours: Number of colours, 1 or 3.
    """

    pixels: np.ndarray
    up: tuple[float, ...]
    colours: int

    @classmethod
    def of(cls, picture: np.ndarray, up: tuple[float, ...]) -> "PictureLight":
        """Return the light of a picture (H, W) or (H, W, 3)."""
        pixels = picture if picture.ndim == 3 else picture[..., None]
        pixels = np.ascontiguousarray(np.broadcast_to(pixels, (*picture.shape[:2], 3)))
        return cls(pixels, up, 1 if picture.ndim == 2 else 3)

    @cached_property
    def cache_key(self) -> str:
        """Text that identifies the picture."""
        return f"{sha256(self.pixels.tobytes()).hexdigest()} {self.pixels.shape} {self.up}"

    @cached_property
    def luminance(self) -> np.ndarray:
        """Luminance of the pixels, (H, W) float32."""
        return weigh_colours(self.pixels) if self.colours == 3 else self.pixels[..., 0]

    @cached_property
    def _means(self) -> tuple[float, float, float, float]:
        """Mean luminance over the sphere; relative to it the mean square, and the mean of what exceeds it; not for black.

        The last number is the variance that the relative luminance would have if no pixel exceeded the mean.
        """
        largest = float(self.luminance.max())
        relative = self.luminance.astype(np.float64) / largest
        height, width = relative.shape
        weights = np.broadcast_to(solid_angles(pixel_angles(height), width)[:, None], relative.shape)
        mean = float(np.average(relative, weights=weights))
        arrays = np.square(relative), np.maximum(relative - mean, 0.0), np.square(np.minimum(relative, mean))
        square, excess, below = (float(np.average(each, weights=weights)) for each in arrays)
        return largest * mean, square / mean**2, excess / mean, below / mean**2 - (1.0 - excess / mean) ** 2

    @property
    def _typical(self) -> tuple[float, ...]:
        """Irradiance from a hemisphere as bright as the mean of the sphere, for each colour."""
        weights = solid_angles(pixel_angles(len(self.pixels)), self.pixels.shape[1])
        rows = self.pixels.mean(axis=1, dtype=np.float64)
        return tuple((pi * np.average(rows, axis=0, weights=weights)).tolist())

    @cached_property
    def share(self) -> float:
        """Fraction of the rays that "both" draws from the picture: 0 for an even or cloudy sky, 7/8 for a small sun.

        It follows from the picture alone, so that the estimate stays unbiased. With q the part of the mean square of the
        luminance that is not the square of the mean, it rises from 0 at q = 1/2 to 7/8 at q = 1: below, few rays from the
        picture would add more noise than they remove. It is at most the part of the light that exceeds the mean.

        If this is below 1/10, few pixels may still be far brighter than the others, and the rays of the cosine lobe find
        them by luck. Where rays from the picture lower the noise, the fraction then is the part of the light that exceeds
        the mean, from 1/8 to 1/2.
        """
        if not self.pixels.any():
            return 0.0
        _mean, square, excess, below = self._means
        share = min(_MOST * (1.0 - 2.0 / square), excess)
        if share > _LEAST:
            return share
        lobe, picture = sqrt(below + _SHADOWS), excess * sqrt(_SPREAD)  # noise of one ray of each
        is_quieter = (lobe + picture) ** 2 < _GAIN * (square - 1.0 + _SHADOWS)
        return min(max(excess, _LEAST_OF_SPOTS), _MOST_OF_SPOTS) if is_quieter else 0.0

    def floor(self, sampling: Sampling) -> float:
        """Return the luminance that the density of the rays from the picture leaves out: with "both" the mean, else 0.

        Rays of the cosine lobe reach what is darker, and rays of the picture that went there would add noise (Karlik2019).
        """
        return self._means[0] if sampling == "both" else 0.0

    def lobe(self, sampling: Sampling) -> PictureReading:
        """Return the distribution of the rays from the picture, which is not black; see `floor`."""
        floor = self.floor(sampling)
        excess = np.maximum(self.luminance - np.float32(floor), 0.0)
        return find_or_make(f"lobe of {self.cache_key} above {floor}", lambda: PictureReading(excess, self.up))

    def summed(self, sampling: Sampling, result: type[Estimate]) -> RaySum | SplitSum:
        """Return the sum over the rays of a point that gives the irradiance, with a way of sampling and a type of result."""
        share = {"cosine": 0.0, "picture": 1.0, "both": self.share}[sampling]
        if share == 0.0 or not self.pixels.any():
            integrand = build_environment_integrand(self.pixels, self.up)
            return RaySum(integrand, unit=pi, result=result, typical=self._typical)
        lobe, floor = self.lobe(sampling), self.floor(sampling)

        def sum_by(function: Any) -> Any:
            return lambda ratio: RaySum(sampled_by(function, self.pixels, lobe, floor, ratio), result=result)

        return SplitSum(sum_by(by_cosine), sum_by(by_picture), lobe, share, self._typical)
