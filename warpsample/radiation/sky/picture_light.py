"""Distant light given as a picture of the whole sphere, with rays from the cosine lobe, from the picture, or from both."""

from dataclasses import dataclass
from functools import cached_property
from hashlib import sha256
from math import pi
from typing import Any, Literal

import numpy as np

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
    def lobe(self) -> PictureReading | None:
        """Density of rays towards the picture, by the bilinear reading of its luminance; None if it is black."""
        if not self.pixels.any():
            return None
        pixels = self.pixels if self.colours == 3 else self.pixels[..., 0]
        return find_or_make(f"lobe of {self.cache_key}", lambda: PictureReading(pixels, self.up))

    @cached_property
    def share(self) -> float:
        """Fraction of the rays that "both" draws from the picture: 0 for an even or cloudy sky, 7/8 for a small sun.

        It follows from the picture alone, so that the estimate stays unbiased. With q the part of the mean square of the
        luminance that is not the square of the mean, it rises from 0 at q = 1/2 to 7/8 at q = 1: below, few rays from the
        picture would add more noise than they remove.
        """
        if self.lobe is None:
            return 0.0
        luminance = self.lobe.picture.astype(np.float64) / float(self.lobe.picture.max())
        height, width = luminance.shape
        weights = np.broadcast_to(solid_angles(pixel_angles(height), width)[:, None], luminance.shape)
        mean = np.average(luminance, weights=weights)
        part = 1.0 - np.square(mean) / np.average(np.square(luminance), weights=weights)
        share = _MOST * (2.0 * float(part) - 1.0)
        return share if share > _LEAST else 0.0

    def summed(self, sampling: Sampling, result: type[Estimate]) -> RaySum | SplitSum:
        """Return the sum over the rays of a point that gives the irradiance, with a way of sampling and a type of result."""
        share = {"cosine": 0.0, "picture": 1.0, "both": self.share}[sampling]
        lobe = self.lobe
        if share == 0.0 or lobe is None:
            return RaySum(build_environment_integrand(self.pixels, self.up), unit=pi, result=result)

        def sum_by(function: Any) -> Any:
            return lambda ratio: RaySum(sampled_by(function, self.pixels, lobe, ratio), result=result)

        return SplitSum(sum_by(by_cosine), sum_by(by_picture), lobe, share)
