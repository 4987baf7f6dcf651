"""The sky's radiance, patch by patch and hour by hour: the model of Perez1993, by Radiance's `gendaymtx`."""

from functools import lru_cache
from typing import Any

import numpy as np

from warpsample.host.extras import missing
from warpsample.host.locks import imported
from warpsample.radiation.exchange.matrix_files import read_matrix
from warpsample.radiation.sky.patches import MULTIPLES, SkyPatches, sky_patches
from warpsample.radiation.weather.weather import Weather


def perez_sky(weather: Weather, patches: str) -> np.ndarray:
    """(K, T) float64, W/m²/sr: the radiance of each sky patch in each of T hours, without the sun.

    gendaymtx scales the sky by the sum of the patches' solid angles times the sine of their centres, which is 0.5 to 0.04 %
    off the integral that their share of a lobe is. So each hour is scaled here: on an open horizontal plane the diffuse
    radiation of the file comes in.

    Raises:
        ModuleNotFoundError: pyradiance is missing; says how to install it.
        RuntimeError: gendaymtx gave something else than was asked for.
    """
    share = _horizontal_shares(sky_patches(patches))
    if len(weather.hours) == 0:
        return np.zeros((len(share), 0))
    shape = len(share), len(weather.hours)
    radiance = _gendaymtx(_pyradiance(), _wea(weather), MULTIPLES[patches], shape).astype(np.float64)
    received = np.pi * (share @ radiance)
    dark = received == 0.0  # below 1e-4 W/m² gendaymtx has no sky
    radiance *= np.where(dark, 0.0, weather.diffuse_horizontal) / np.where(dark, 1.0, received)
    return radiance


def _horizontal_shares(sky: SkyPatches) -> np.ndarray:
    """(K,) each patch's exact share of the lobe of an open horizontal plane; they add up to 1."""
    low, high = np.square(np.sin(np.radians(sky.altitudes.T)))
    return np.radians(np.diff(sky.azimuths, axis=1)[:, 0]) * (high - low) / (2.0 * np.pi)


@lru_cache(maxsize=1)
def _gendaymtx(pyradiance: Any, hours: bytes, split: int, shape: tuple[int, int]) -> np.ndarray:
    """(K, T) float32, of which the last is kept: 10 MB of a year and the default patches, and half a second."""
    content = pyradiance.gendaymtx(
        hours, outform="f", mfactor=split, sky_only=True, solar_radiance=True, sky_color=[1, 1, 1]
    )
    found = read_matrix(content, "gendaymtx")[1:, :, 0]  # without the ground, and grey
    if found.shape != shape or not np.isfinite(found).all():
        raise RuntimeError(f"gendaymtx: got {found.shape} numbers, want {shape[0]} patches of {shape[1]} hours")
    return np.ascontiguousarray(found)


def _pyradiance() -> Any:
    try:
        return imported("pyradiance")
    except ModuleNotFoundError:
        raise missing("the Perez sky needs pyradiance", "pyradiance") from None


def _wea(weather: Weather) -> bytes:
    """The hours in Radiance's format, whose places are degrees to the west, each with its middle as its time.

    It has no zones beyond 12 hours: those of Samoa or Kiribati, 13 and 14, are told as the same hours of the day before.
    """
    days = round(weather.time_zone / 24.0)
    head = [
        "place warpsample",
        f"latitude {weather.latitude}",
        f"longitude {-weather.longitude}",
        f"time_zone {-15.0 * (weather.time_zone - 24.0 * days)}",
        f"site_elevation {weather.altitude}",
        "weather_data_file_units 1",
    ]
    hours = weather.hours - np.timedelta64(days, "D")
    rows = zip(hours.tolist(), weather.direct_normal.tolist(), weather.diffuse_horizontal.tolist(), strict=True)
    return "\n".join([*head, *(f"{t.month} {t.day} {t.hour + 0.5} {sun} {sky}" for t, sun, sky in rows), ""]).encode()
