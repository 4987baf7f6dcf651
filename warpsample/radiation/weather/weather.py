"""The weather of a year from an EPW file: radiation hour by hour, and where the sun stands."""

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

from warpsample.host.arguments import check_file, naming_file, told
from warpsample.host.extras import missing
from warpsample.host.known import digest_of
from warpsample.host.locks import imported
from warpsample.host.summary import Summary
from warpsample.radiation.weather.epw import YEAR, checked_text, radiation

_NIGHT = -10.0  # degrees: in an hour whose middle is as deep, the sun is down all the time
_PERIOD = re.compile(r"(\d\d)-(\d\d)(?:T(\d\d))?")


@dataclass(frozen=True, eq=False, repr=False)
class Weather(Summary):
    """Hours of radiation at a place.

    Attributes:
        latitude: degrees north.
        longitude: degrees east.
        time_zone: hours that local standard time is ahead of UTC.
        altitude: metres above the sea.
        hours: (T,) datetime64[m], where each hour begins, in local standard time.
        direct_normal: (T,) W/m² from the sun, on a plane across its direction.
        diffuse_horizontal: (T,) W/m² from the sky, on a horizontal plane.
        sun_altitude: (T,) radians above the horizon at mid-hour, with refraction.
        sun_azimuth: (T,) radians from north towards east at mid-hour.
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
        """SHA-256 of what a file tells: the place, the hours and their radiation. The sun follows from the first two."""
        place = np.array([self.latitude, self.longitude, self.time_zone, self.altitude])
        return digest_of(place, self.hours.view(np.int64), self.direct_normal, self.diffuse_horizontal)

    def chosen(self, rows: np.ndarray) -> "Weather":
        """Some of the hours, by a mask or by indices."""
        arrays = {name: array[rows] for name, array in vars(self).items() if isinstance(array, np.ndarray)}
        return replace(self, **arrays)


def read_weather(weather: Any, period: Sequence[str] | None = None) -> Weather:
    """The weather of a year, or of a period of it; arguments as of `irradiation`, or the Weather of a year.

    Latin letters in any encoding are read, and what follows the diffuse radiation in a row is ignored.

    Raises:
        TypeError, ValueError, FileNotFoundError: no such file, or not the weather of a year, hour by hour; a wrong period.
        ModuleNotFoundError: pvlib is missing; says how to install it.
    """
    chosen = hours_of(period)
    if isinstance(weather, Weather):
        return weather.chosen(chosen)
    if isinstance(weather, str | PathLike) and fspath(weather) == "athens" and not Path(weather).exists():
        return _athens(_pvlib()).chosen(chosen)
    path = check_file(weather, "weather", "an EPW weather file")
    pvlib = _pvlib()
    with naming_file("weather", path, "an EPW weather file"):
        return _year(pvlib, checked_text(path)).chosen(chosen)


@lru_cache(maxsize=2)
def _year(pvlib: Any, text: str) -> Weather:
    """The weather of a file, by its content: reading it and finding the sun takes a fifth of a second."""
    table, place = pvlib.iotools.read_epw(StringIO(text))
    where = tuple(place[name] for name in ("latitude", "longitude", "TZ", "altitude"))
    sun = _sun(pvlib, table.index, where)
    direct, diffuse = radiation(table, "dni", "direct normal"), radiation(table, "dhi", "diffuse horizontal")
    _check_nights(direct, sun["elevation"].to_numpy())
    return _weather(where, sun, direct, diffuse)


@lru_cache(maxsize=1)
def _athens(pvlib: Any) -> Weather:
    """A cloudless year in Athens, by the clear sky of Ineichen2008."""
    where = (37.98, 23.73, 2.0, 107.0)
    hours = imported("pandas").date_range("2021-01-01", periods=len(YEAR), freq="h", tz=timezone(timedelta(hours=where[2])))
    sun = _sun(pvlib, hours, where)
    sky = pvlib.clearsky.simplified_solis(sun["apparent_elevation"])
    return _weather(where, sun, sky["dni"].to_numpy(np.float64), sky["dhi"].to_numpy(np.float64))


def _sun(pvlib: Any, hours: Any, where: tuple[float, ...]) -> Any:
    """pvlib's table of where the sun stands at the middle of hours."""
    latitude, longitude, _, altitude = where
    return pvlib.solarposition.get_solarposition(hours + np.timedelta64(30, "m"), latitude, longitude, altitude)


def _weather(where: tuple[float, ...], sun: Any, direct: np.ndarray, diffuse: np.ndarray) -> Weather:
    hours = (sun.index.tz_localize(None) - np.timedelta64(30, "m")).to_numpy().astype("datetime64[m]")
    angles = (np.radians(sun[name].to_numpy(np.float64)) for name in ("apparent_elevation", "azimuth"))
    return Weather(*where, hours, direct, diffuse, *angles)


def hours_of(period: Any) -> np.ndarray:
    """Which of the 8,760 hours are in a period, as `irradiation` takes it: (8760,) bool.

    Raises:
        TypeError, ValueError: something else.
    """
    wants = 'two days "MM-DD", or hours "MM-DDTHH", of a year without 29 February, as ("06-01", "08-31")'
    if period is None:
        return np.ones(len(YEAR), bool)
    if isinstance(period, str) or not isinstance(period, Sequence) or not all(isinstance(text, str) for text in period):
        raise TypeError(f"period: got {told(period)}, want {wants}")
    found = [_PERIOD.fullmatch(text) for text in period]
    try:
        (first, last) = (_hour(match, default) for match, default in zip(found, (0, 24), strict=True))  # type: ignore[arg-type]
    except (ValueError, TypeError, IndexError):
        raise ValueError(f"period: got {told(period)}, want {wants}") from None
    if first == last:
        raise ValueError(f"period: got {told(period)}, which has no hour, want {wants}")
    hour = np.arange(len(YEAR))
    return (first <= hour) & (hour < last) if first < last else (first <= hour) | (hour < last)


def _hour(match: re.Match[str], default: int) -> int:
    """How many hours of the year are over; a ValueError where there is no such day or hour."""
    month, day = int(match[1]), int(match[2])
    hour = default if match[3] is None else int(match[3])
    if hour > 24:
        raise ValueError
    return YEAR.index((month, day, 1)) + hour


def _pvlib() -> Any:
    try:
        imported("pvlib.iotools")
        return imported("pvlib")
    except ModuleNotFoundError:
        raise missing("weather needs pvlib", "pvlib") from None


def _check_nights(direct: np.ndarray, altitude: np.ndarray) -> None:
    """Refuses a place that does not fit the hours, as one whose longitude is counted towards the west."""
    share = direct[altitude < _NIGHT].sum() / max(direct.sum(), 1.0)
    if share > 0.01:
        raise ValueError(
            f"{share:.0%} of its direct radiation comes at night by the latitude, longitude and time zone of line 1"
        )
