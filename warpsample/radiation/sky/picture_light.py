"""Distant light given as a picture of the whole sphere, with rays from the cosine lobe, from the picture, or from both."""

from dataclasses import dataclass
from functools import cached_property
from hashlib import sha256
from math import pi
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
_MOST_OF_SPOTS, _LEAST_OF_SPOTS = 0.5, 0.125  # and for a few bright pixels
_FEW = 0.05  # largest part of the sphere that these cover
_LEVELS = (1.0, 2.0, 4.0, 8.0)  # luminances above which pixels are bright, relative to the mean; see `_split` for the last
_NOISE = 0.01  # least relative variance of a ray by them; below, they add at most 1 % to the error of 100 rays


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
    def _means(self) -> tuple[float, float, float]:
        """Mean luminance over the sphere; relative to it the mean square, and the mean of what exceeds it; not for black."""
        largest = float(self.luminance.max())
        relative = self.luminance.astype(np.float64) / largest
        mean = self._average(relative)
        square, excess = (self._average(each) for each in (np.square(relative), np.maximum(relative - mean, 0.0)))
        return largest * mean, square / mean**2, excess / mean

    def _average(self, pixels: np.ndarray) -> float:
        """Return the mean over the sphere of numbers of the pixels."""
        height, width = pixels.shape
        weights = np.broadcast_to(solid_angles(pixel_angles(height), width)[:, None], pixels.shape)
        return float(np.average(pixels, weights=weights))

    @property
    def _typical(self) -> tuple[float, ...]:
        """Irradiance from a hemisphere as bright as the mean of the sphere, for each colour."""
        weights = solid_angles(pixel_angles(len(self.pixels)), self.pixels.shape[1])
        rows = self.pixels.mean(axis=1, dtype=np.float64)
        return tuple((pi * np.average(rows, axis=0, weights=weights)).tolist())

    @cached_property
    def _split(self) -> tuple[float, float]:
        """Fraction of the rays that "both" draws from the picture, and the luminance that their density leaves out.

        They follow from the picture alone, so that the estimate stays unbiased. With q the part of the mean square of the
        luminance that is not the square of the mean, the fraction rises from 0 at q = 1/2 to 7/8 at q = 1: below, few rays
        from the picture would add more noise than they remove. It is at most the part of the light that exceeds the mean.

        If this is below 1/10, a few pixels may still be far brighter than all others, and the rays of the cosine lobe find
        them by luck. Then the fraction is the part of the light that exceeds the others, from 1/8 to 1/2. Above 8 times the
        mean there are always few pixels: 1/20 of the sphere would have 2/5 of the light, and a fraction above 1/10.
        """
        if not self.pixels.any():
            return 0.0, 0.0
        mean, square, excess = self._means
        share = min(_MOST * (1.0 - 2.0 / square), excess)
        if share > _LEAST:
            return share, mean
        relative = self.luminance.astype(np.float64) / mean
        for level in _LEVELS:
            if self._average(relative > level) >= _FEW:
                continue
            others = np.minimum(relative, level)
            light = self._average(others)
            noise = square - 1.0 - (self._average(np.square(others)) - light**2)
            if noise > _NOISE:
                return min(max(1.0 - light, _LEAST_OF_SPOTS), _MOST_OF_SPOTS), level * mean
        return 0.0, mean

    @property
    def share(self) -> float:
        """Fraction of the rays that "both" draws from the picture: 0 for an even or cloudy sky, 7/8 for a small sun."""
        return self._split[0]

    def floor(self, sampling: Sampling) -> float:
        """Return the luminance that the density of the rays from the picture leaves out: 0 but for "both".

        Rays of the cosine lobe reach what is darker, and rays of the picture that went there would add noise (Karlik2019).
        """
        return self._split[1] if sampling == "both" else 0.0

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
