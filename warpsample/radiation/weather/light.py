"""The light of a period: where the sun stands, what it brings, and how bright sky and ground are."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from warpsample.host.arguments import check_number
from warpsample.radiation.sky.patches import SkyPatches, sky_patches
from warpsample.radiation.weather.perez import perez_sky
from warpsample.radiation.weather.weather import Weather, read_weather


@dataclass(frozen=True, eq=False)
class Light:
    """Sun, sky and ground in the T hours of a period.

    Attributes:
        sky: patches of the sky above.
        below: patches of the half below the horizon, through which the ground is seen.
        hours: (T,) datetime64[m], where each hour begins.
        sun_rows: (S,) hours in which the sun shines.
        sun: (S, 3) unit vectors towards it, in the mesh's coordinates.
        direct: (S,) W/m², across these directions.
        sky_rows: (L,) hours in which there is any light.
        radiance: (K, L) W/m²/sr, of each patch.
        ground: (L,) W/m² that leave the ground.
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
        """The light of some of the L hours in which there is any."""
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
    """The light that the weather of a file makes; arguments as of `irradiation`."""
    albedo, sky = check_number(ground_albedo, "ground_albedo", 0.0, 1.0), sky_patches(patches, up=up, north=north)
    found = read_weather(weather, period)
    shining = (found.direct_normal > 0.0) & (found.sun_altitude > 0.0)
    lit = shining | (found.diffuse_horizontal > 0.0)
    rows = np.flatnonzero(lit) if lit.any() else np.zeros(1, np.int64)  # a polar night has an hour without light
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
    """Unit vectors (T, 3) towards the sun in the coordinates of a mesh, whose axes to east, north and up are (3, 3)."""
    altitude, azimuth = weather.sun_altitude, weather.sun_azimuth
    level = np.cos(altitude)
    return np.stack([level * np.sin(azimuth), level * np.cos(azimuth), np.sin(altitude)], axis=1) @ axes
