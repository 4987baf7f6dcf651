"""Radiance of the sky by patch and hour: the model of Perez1993, computed by Radiance's `gendaymtx`."""

from functools import lru_cache
from typing import Any

import numpy as np

from warpsample.host.extras import missing
from warpsample.host.locks import imported, multiply
from warpsample.radiation.exchange.matrix_files import read_matrix
from warpsample.radiation.sky.patches import MULTIPLES, SkyPatches, sky_patches
from warpsample.radiation.weather.weather import Weather


def perez_sky(weather: Weather, patches: str) -> np.ndarray:
    """Return the radiance of each sky patch in each of T hours, without the sun, (K, T) float64 in W/m²/sr.

    gendaymtx normalises the sky with the patches' solid angles times the sine of their centres, which differs from the exact
    integral by 0.5 to 0.04 %. So each hour is scaled here: an open horizontal plane receives the file's diffuse radiation.

    Raises:
        ModuleNotFoundError: pyradiance is not installed.
        RuntimeError: the output of gendaymtx has another size or numbers that are not finite.
    """
    share = _horizontal_shares(sky_patches(patches))
    if len(weather.hours) == 0:
        return np.zeros((len(share), 0))
    shape = len(share), len(weather.hours)
    radiance = _run_gendaymtx(_pyradiance(), _format_wea(weather), MULTIPLES[patches], shape).astype(np.float64)
    received = np.pi * multiply(share, radiance)
    dark = received == 0.0  # gendaymtx returns 0 below 1e-4 W/m²
    radiance *= np.where(dark, 0.0, weather.diffuse_horizontal) / np.where(dark, 1.0, received)
    return radiance


def _horizontal_shares(sky: SkyPatches) -> np.ndarray:
    """Return the cosine-weighted share of each sky patch in the sky above a horizontal plane, (K,); the sum is 1."""
    low, high = np.square(np.sin(np.radians(sky.altitudes.T)))
    return np.radians(np.diff(sky.azimuths, axis=1)[:, 0]) * (high - low) / (2.0 * np.pi)


@lru_cache(maxsize=1)
def _run_gendaymtx(pyradiance: Any, hours: bytes, split: int, shape: tuple[int, int]) -> np.ndarray:
    """Run Radiance's gendaymtx on hours of weather, and return the sky radiances (K, T) float32.

    The last result is cached: for a year and the default patches 10 MB, and half a second.
    """
    content = pyradiance.gendaymtx(
        hours, outform="f", mfactor=split, sky_only=True, solar_radiance=True, sky_color=[1, 1, 1]
    )
    found = read_matrix(content, "gendaymtx")[1:, :, 0]  # without the ground; the three colours are equal
    if found.shape != shape or not np.isfinite(found).all():
        raise RuntimeError(f"gendaymtx: got {found.shape} numbers, want {shape[0]} patches of {shape[1]} hours")
    return np.ascontiguousarray(found)


def _pyradiance() -> Any:
    """Import pyradiance; raise a ModuleNotFoundError that states how to install it."""
    try:
        return imported("pyradiance")
    except ModuleNotFoundError:
        raise missing("the Perez sky needs pyradiance", "pyradiance") from None


def _format_wea(weather: Weather) -> bytes:
    """Return hours of weather in Radiance's WEA format, as bytes.

    WEA counts degrees to the west, and the time is the middle of the hour. Time zones beyond 12 hours are invalid: hours of
    Samoa or Kiribati, with zones 13 and 14, are written as the same hours of the day before.
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
