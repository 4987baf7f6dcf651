"""Sun, sky and ground of a period as distant light for reflections: irradiance of patches of faces."""

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import numpy as np

from warpsample.host.locks import imported, multiply
from warpsample.radiation.reflection.lobe_shares import Targets
from warpsample.radiation.reflection.patches import Patches
from warpsample.radiation.reflection.reflections import Probes
from warpsample.radiation.sky.patches import patches_at
from warpsample.radiation.sun.direct_sun import SunCall
from warpsample.radiation.weather.light import Light
from warpsample.tracing.options import RayOptions
from warpsample.tracing.placed_points import PlacedPoints

if TYPE_CHECKING:
    from scipy.sparse import csr_array

_SUNS = 512  # from twice this number on, the sample positions of a replicate test a random choice of suns


@dataclass(frozen=True, eq=False)
class WeatherLight:
    """Light of sun, sky and ground in a period: the sum in kWh/m², or a column in W/m² for each hour.

    Only hours with light have a column.

    Attributes:
        light: Light of the period.
        series: Whether each hour is a column.
    """

    light: Light
    series: bool

    @property
    def size(self) -> int:
        """Number of columns of the light: hours with light, or 1 for the sum."""
        return len(self.light.sky_rows) if self.series else 1

    def targets(self, patches: Patches, _workers: int) -> Targets:
        """Return the light sources that rays of reflecting patches may reach: the patches, the sky and the ground."""
        sky, csr_array = self.light.sky, imported("scipy.sparse").csr_array

        def light_outside(directions: np.ndarray) -> "csr_array":
            found = patches_at(sky, directions)
            column, one = np.where(found < 0, len(sky), found), np.ones(len(found), np.float32)
            return csr_array((one, column, np.arange(len(found) + 1)), shape=(len(found), len(sky) + 1))

        return Targets(patches, light_outside)

    def irradiance_of(self, probes: Probes, columns: slice) -> np.ndarray:
        """Return the irradiance of reflecting patches: sky and ground from rays, the sun at sample positions."""
        light = self.light
        if not self.series:
            bright = sum_hours(np.concatenate([np.pi * light.radiance, light.ground[None]]))
            direct = direct_light(probes.at, probes.options, _fewer_suns(light, probes.options.seed), False)
            return (probes.light_outside @ bright)[:, None] + probes.means(direct, 1)
        light = light.only(columns)
        falling = probes.light_outside @ np.concatenate([np.pi * light.radiance, light.ground[None]])
        direct = direct_light(probes.at, probes.options, light, True)
        falling[:, np.searchsorted(light.sky_rows, light.sun_rows)] += probes.means(direct, len(light.sun))
        return falling


def _fewer_suns(light: Light, seed: int) -> Light:
    """Merge the sun positions of a period into at most about 1,000, for the light that faces reflect.

    Of each run of neighbouring suns one is drawn at random, with the radiation of the run. Few suns are all kept.
    """
    step = len(light.sun) // _SUNS
    if step < 2:
        return light
    first = np.arange(0, len(light.sun), step)
    sizes = np.diff(first, append=len(light.sun))
    drawn = first + np.floor(np.random.default_rng(seed).random(len(first)) * sizes).astype(np.int64)
    return replace(light, sun=light.sun[drawn], direct=sizes * light.direct[drawn])


def sum_hours(hourly: np.ndarray) -> np.ndarray:
    """Sum hourly irradiance in W/m² over the last axis, and return it in kWh/m²."""
    return hourly.sum(axis=-1) / 1000.0


def direct_light(at: PlacedPoints, options: RayOptions, light: Light, series: bool) -> np.ndarray:
    """Compute the irradiation of points by direct sunlight, (P,) in kWh/m²; with `series` (P, S) in W/m², hour by hour."""
    if len(light.sun) == 0:
        return np.zeros((len(at), 0) if series else len(at))
    if not series:
        return SunCall(at, light.sun, light.direct / 1000.0, options, cosine=True).answer()
    lit = SunCall(at, light.sun, None, options).answer()
    normal = at.normal.astype(np.float64)
    length = np.linalg.norm(normal, axis=1, keepdims=True)
    normal = np.divide(normal, length, out=np.zeros_like(normal), where=np.isfinite(length) & (length > 0.0))
    return lit * (np.maximum(multiply(normal, light.sun.T), 0.0) * light.direct)
