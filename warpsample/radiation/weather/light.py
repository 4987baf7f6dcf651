"""Light of a period from weather: directions and radiation of the sun, and radiances of sky and ground."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from warpsample.host.arguments import check_number
from warpsample.host.locks import multiply
from warpsample.radiation.sky.patches import SkyPatches, sky_patches
from warpsample.radiation.weather.perez import perez_sky
from warpsample.radiation.weather.weather import Weather, read_weather


@dataclass(frozen=True, eq=False)
class Light:
    """Radiation of sun, sky and ground in the T hours of a period.

    Attributes:
        sky: Patches of the sky.
        below: Patches of the half-sphere below the horizon, where the ground is visible.
        hours: (T,) datetime64[m], begin of each hour.
        sun_rows: (S,) indices of the hours in which the sun shines.
        sun: (S, 3) unit vectors towards the sun, in the mesh's coordinates.
        direct: (S,) direct normal irradiance, in W/m².
        sky_rows: (L,) indices of the hours with any light.
        radiance: (K, L) radiance of each patch, in W/m²/sr.
        ground: (L,) radiation that the ground reflects, in W/m².
    """

    sky: SkyPatches
    below: SkyPatches
    hours: np.ndarray
    sun_rows: np.ndarray
    sun: np.ndarray
    direct: np.ndarray
    sky_rows: np.ndarray
    radiance: np.ndarray
    ground: np.ndarray

    def only(self, columns: slice) -> "Light":
        """Return the radiation of sun, sky and ground in a slice of the L hours with light."""
        rows = self.sky_rows[columns]
        shining = np.isin(self.sun_rows, rows)
        return replace(
            self,
            sun_rows=self.sun_rows[shining],
            sun=self.sun[shining],
            direct=self.direct[shining],
            sky_rows=rows,
            radiance=self.radiance[:, columns],
            ground=self.ground[columns],
        )


def light_of(weather: Any, *, period: Sequence[str] | None, ground_albedo: Any, patches: Any, up: Any, north: Any) -> Light:
    """Compute the radiation of sun, sky and ground in a period from a weather file; arguments as for `irradiation`."""
    albedo, sky = check_number(ground_albedo, "ground_albedo", 0.0, 1.0), sky_patches(patches, up=up, north=north)
    found = read_weather(weather, period)
    shining = (found.direct_normal > 0.0) & (found.sun_altitude > 0.0)
    lit = shining | (found.diffuse_horizontal > 0.0)
    rows = np.flatnonzero(lit) if lit.any() else np.zeros(1, np.int64)  # a period without light keeps one dark hour
    horizontal = found.diffuse_horizontal + np.where(shining, found.direct_normal * np.sin(found.sun_altitude), 0.0)
    return Light(
        sky=sky,
        below=sky_patches("tregenza", up=-np.array(sky.up), north=sky.north),
        hours=found.hours,
        sun_rows=np.flatnonzero(shining),
        sun=sun_directions(found.chosen(shining), sky.frame),
        direct=found.direct_normal[shining],
        sky_rows=rows,
        radiance=perez_sky(found.chosen(rows), sky.name),
        ground=albedo * horizontal[rows],
    )


def sun_directions(weather: Weather, axes: np.ndarray) -> np.ndarray:
    """Return unit vectors towards the sun in mesh coordinates, (T, 3).

    `axes` (3, 3) are east, north and up.
    """
    altitude, azimuth = weather.sun_altitude, weather.sun_azimuth
    level = np.cos(altitude)
    local = np.stack([level * np.sin(azimuth), level * np.cos(azimuth), np.sin(altitude)], axis=1)
    return multiply(local, axes)
