"""Weather of a year from an EPW file: hourly radiation and positions of the sun."""

import re
from collections.abc import Sequence
from dataclasses import dataclass, replace
from datetime import timedelta, timezone
from functools import lru_cache
from io import StringIO
from os import PathLike, fspath
from pathlib import Path
from typing import Any

import numpy as np

from warpsample.host.arguments import check_file, naming_file, quote
from warpsample.host.extras import missing
from warpsample.host.locks import imported
from warpsample.host.shared_values import digest_of
from warpsample.host.summary import Summary
from warpsample.radiation.weather.epw import YEAR, check_text, radiation

_NIGHT = -10.0  # degrees: if the sun is lower at mid-hour, it is below the horizon for the whole hour
_PERIOD = re.compile(r"([0-9]{2})-([0-9]{2})(?:T([0-9]{2}))?")


@dataclass(frozen=True, eq=False, repr=False)
class Weather(Summary):
    """Hourly radiation at a place, with the positions of the sun.

    Attributes:
        latitude: Degrees north.
        longitude: Degrees east.
        time_zone: Hours that local standard time is ahead of UTC.
        altitude: Metres above the sea.
        hours: (T,) datetime64[m], begin of each hour, in local standard time.
        direct_normal: (T,) direct radiation on a plane perpendicular to it, in W/m².
        diffuse_horizontal: (T,) radiation of the sky on a horizontal plane, in W/m².
        sun_altitude: (T,) altitude of the sun at mid-hour, in radians, with refraction.
        sun_azimuth: (T,) azimuth of the sun at mid-hour, in radians from north towards east.
    """

    latitude: float
    longitude: float
    time_zone: float
    altitude: float
    hours: np.ndarray
    direct_normal: np.ndarray
    diffuse_horizontal: np.ndarray
    sun_altitude: np.ndarray
    sun_azimuth: np.ndarray

    @property
    def digest(self) -> str:
        """SHA-256 of place, hours and radiation; positions of the sun follow from place and hours."""
        place = np.array([self.latitude, self.longitude, self.time_zone, self.altitude])
        return digest_of(place, self.hours.view(np.int64), self.direct_normal, self.diffuse_horizontal)

    def chosen(self, rows: np.ndarray) -> "Weather":
        """Return the weather of some hours, chosen by a mask or by indices."""
        arrays = {name: array[rows] for name, array in vars(self).items() if isinstance(array, np.ndarray)}
        return replace(self, **arrays)


def read_weather(weather: Any, period: Sequence[str] | None = None) -> Weather:
    """Read the weather of a year or a period from an EPW file.

    `weather` is a path or "athens", as for `irradiation`, or a Weather. Any encoding of Latin letters is accepted. Fields
    after the diffuse radiation are ignored.

    Raises:
        TypeError, ValueError, FileNotFoundError: no such file, not the hourly weather of a year, or an invalid period.
        ModuleNotFoundError: pvlib is not installed.
    """
    chosen = hours_of(period)
    if isinstance(weather, Weather):
        return weather.chosen(chosen)
    if isinstance(weather, str | PathLike) and fspath(weather) == "athens" and not Path(weather).exists():
        return _build_athens(_import_pvlib()).chosen(chosen)
    path = check_file(weather, "weather", "an EPW weather file")
    pvlib = _import_pvlib()
    with naming_file("weather", path, "an EPW weather file"):
        return _build_year(pvlib, check_text(path)).chosen(chosen)


@lru_cache(maxsize=2)
def _build_year(pvlib: Any, text: str) -> Weather:
    """Return the `Weather` of the year in the text of an EPW file, from a cache if possible.

    Reading the text and computing the sun takes a fifth of a second.
    """
    table, place = pvlib.iotools.read_epw(StringIO(text))
    where = tuple(place[name] for name in ("latitude", "longitude", "TZ", "altitude"))
    sun = _compute_sun(pvlib, table.index, where)
    direct, diffuse = radiation(table, "dni", "direct normal"), radiation(table, "dhi", "diffuse horizontal")
    _check_nights(direct, sun["elevation"].to_numpy())
    return _build_weather(where, sun, direct, diffuse)


@lru_cache(maxsize=1)
def _build_athens(pvlib: Any) -> Weather:
    """Build the weather of a cloudless year in Athens, with the clear sky of Ineichen2008."""
    where = (37.98, 23.73, 2.0, 107.0)
    hours = imported("pandas").date_range("2021-01-01", periods=len(YEAR), freq="h", tz=timezone(timedelta(hours=where[2])))
    sun = _compute_sun(pvlib, hours, where)
    with np.errstate(under="ignore"):  # at night
        sky = pvlib.clearsky.simplified_solis(sun["apparent_elevation"])
    return _build_weather(where, sun, sky["dni"].to_numpy(np.float64), sky["dhi"].to_numpy(np.float64))


def _compute_sun(pvlib: Any, hours: Any, where: tuple[float, ...]) -> Any:
    """Compute pvlib's table of the sun's position at the middle of each hour."""
    latitude, longitude, _, altitude = where
    return pvlib.solarposition.get_solarposition(hours + np.timedelta64(30, "m"), latitude, longitude, altitude)


def _build_weather(where: tuple[float, ...], sun: Any, direct: np.ndarray, diffuse: np.ndarray) -> Weather:
    """Build the `Weather` of a place from pvlib's table of the sun and the hourly radiation."""
    hours = (sun.index.tz_localize(None) - np.timedelta64(30, "m")).to_numpy().astype("datetime64[m]")
    angles = (np.radians(sun[name].to_numpy(np.float64)) for name in ("apparent_elevation", "azimuth"))
    return Weather(*where, hours, direct, diffuse, *angles)


def hours_of(period: Any) -> np.ndarray:
    """Return the (8760,) bool mask of the hours of a year in a period, which is given as for `irradiation`.

    Raises:
        TypeError, ValueError: not a period.
    """
    year = len(YEAR)
    wants = 'two days "MM-DD", or hours "MM-DDTHH", of a year without 29 February, as ("06-01", "08-31")'
    if period is None:
        return np.ones(year, bool)
    if isinstance(period, str) or not isinstance(period, Sequence) or not all(isinstance(text, str) for text in period):
        raise TypeError(f"period: got {quote(period)}, want {wants}")
    found = [_PERIOD.fullmatch(text) for text in period]
    try:
        (first, last) = (_parse_hour(match, default) for match, default in zip(found, (0, 24), strict=True))  # type: ignore[arg-type]
    except (ValueError, TypeError, IndexError):
        raise ValueError(f"period: got {quote(period)}, want {wants}") from None
    start, end = (text[:5] for text in period)  # the days; a period of a whole year ends where it begins
    count = last - first + (year if start > end or first > last else 0)
    if count == 0:
        raise ValueError(f"period: got {quote(period)}, which contains no hour, want {wants}")
    return (np.arange(year) - first) % year < count


def _parse_hour(match: re.Match[str], default: int) -> int:
    """Return the number of hours from the start of the year to a matched date; raise a ValueError for an invalid one."""
    month, day = int(match[1]), int(match[2])
    hour = default if match[3] is None else int(match[3])
    if hour > 24:
        raise ValueError
    return YEAR.index((month, day, 1)) + hour


def _import_pvlib() -> Any:
    """Import pvlib; raise a ModuleNotFoundError that states how to install it."""
    try:
        imported("pvlib.iotools")
        return imported("pvlib")
    except ModuleNotFoundError:
        raise missing("weather needs pvlib", "pvlib") from None


def _check_nights(direct: np.ndarray, altitude: np.ndarray) -> None:
    """Check that nearly all direct radiation falls in hours outside the night, when the sun is below `_NIGHT`.

    Raises:
        ValueError: over 1 % falls at night, as with a longitude counted towards the west.
    """
    share = direct[altitude < _NIGHT].sum() / max(direct.sum(), 1.0)
    if share > 0.01:
        raise ValueError(
            f"{share:.0%} of the direct radiation is at night; check the latitude, longitude and time zone in line 1"
        )
