"""The weather of a year from an EPW file: radiation hour by hour, and where the sun stands."""

import re
from collections.abc import Sequence
from dataclasses import dataclass, replace
from io import StringIO
from pathlib import Path
from typing import Any

import numpy as np

from warpsample.host.arguments import check_file, naming_file, told

_HEADER = 8  # lines, the first LOCATION, the last DATA PERIODS
_FIELDS = 16  # of a row, up to the diffuse radiation; pvlib names 35, and some files have fewer
_PVLIB_FIELDS = 35
_STRONGEST = 1500.0  # W/m²: outside the atmosphere it is 1,412, and what is missing is told as 9999
_NIGHT = -10.0  # degrees: in an hour whose middle is as deep, the sun is down all the time
_LIMITS = {"latitude": 90, "longitude": 180, "time zone": 14, "altitude": 9000}  # degrees, hours, metres
_DAYS = (31, 28, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31)
_PERIOD = re.compile(r"(\d\d)-(\d\d)(?:T(\d\d))?")

YEAR = [(month, day, hour) for month in range(1, 13) for day in range(1, _DAYS[month - 1] + 1) for hour in range(1, 25)]
"""(month, day, hour 1 to 24) of the 8,760 rows of a file."""


@dataclass(frozen=True, eq=False)
class Weather:
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

    def chosen(self, rows: np.ndarray) -> "Weather":
        """Some of the hours, by a mask or by indices."""
        arrays = {name: array[rows] for name, array in vars(self).items() if isinstance(array, np.ndarray)}
        return replace(self, **arrays)


def read_weather(weather: Any, period: Sequence[str] | None = None) -> Weather:
    """Reads an EPW file by pvlib, which takes nearly anything: what it would read wrongly is refused.

    Latin letters in any encoding are read, and what follows the diffuse radiation in a row is ignored.

    Args:
        weather: the path of a file of 8,760 hours.
        period: as of `hours_of`; by default the year.

    Raises:
        TypeError, ValueError, FileNotFoundError: no such file, or not the weather of a year, hour by hour; a wrong period.
        ModuleNotFoundError: pvlib is missing; says how to install it.
    """
    chosen = hours_of(period)
    pvlib = _pvlib()
    path = check_file(weather, "weather", "an EPW weather file")
    with naming_file("weather", path, "an EPW weather file"):
        table, place = pvlib.iotools.read_epw(StringIO(_checked_text(path)))
        middle = table.index + np.timedelta64(30, "m")
        latitude, longitude, zone, altitude = (place[name] for name in ("latitude", "longitude", "TZ", "altitude"))
        sun = pvlib.solarposition.get_solarposition(middle, latitude, longitude, altitude)
        direct, diffuse = _radiation(table, "dni", "direct normal"), _radiation(table, "dhi", "diffuse horizontal")
        _check_nights(direct, sun["elevation"].to_numpy())
    hours = table.index.tz_localize(None).to_numpy().astype("datetime64[m]")
    angles = (np.radians(sun[name].to_numpy(np.float64)) for name in ("apparent_elevation", "azimuth"))
    return Weather(latitude, longitude, zone, altitude, hours, direct, diffuse, *angles).chosen(chosen)


def hours_of(period: Any) -> np.ndarray:
    """Which of the 8,760 hours are in a period: (8760,) bool.

    Args:
        period: two texts, the first and the last day, both included, as ("06-01", "08-31"); or with the hour at which it
            begins or ends, ("03-21T09", "03-21T15"). If the first is later, the period goes on over New Year. None is all.

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
    """How many hours of the year are over.

    Raises:
        ValueError: no such day or hour.
    """
    month, day = int(match[1]), int(match[2])
    hour = default if match[3] is None else int(match[3])
    if hour > 24:
        raise ValueError
    return YEAR.index((month, day, 1)) + hour


def _pvlib() -> Any:
    try:
        import pvlib  # noqa: PLC0415  (a second, with pandas)
        import pvlib.iotools  # noqa: PLC0415
    except ModuleNotFoundError:
        raise ModuleNotFoundError("weather needs pvlib: pip install 'warpsample[radiation]'") from None
    return pvlib


def _checked_text(path: Path) -> str:
    """The file's text with 35 fields in each row: pvlib shifts the columns of longer ones, and guesses wrong types.

    Raises:
        ValueError: other lines than those of 8,760 hours.
    """
    lines = path.read_bytes().decode("utf-8-sig", errors="replace").splitlines()
    for number, name in ((1, "LOCATION"), (_HEADER, "DATA PERIODS")):
        if len(lines) < number or not lines[number - 1].upper().startswith(f"{name},"):
            raise ValueError(f"line {number} does not begin with {name}")
    _check_place(lines[0])
    header, rows = lines[:_HEADER], [line.split(",") for line in lines[_HEADER:] if line.strip()]
    for number, row in enumerate(rows, _HEADER + 1):
        if len(row) < _FIELDS:
            raise ValueError(f"line {number} has {len(row)} fields, want at least {_FIELDS}, up to the diffuse radiation")
    if len(rows) != len(YEAR):
        leap = ", with 29 February" if len(rows) == len(YEAR) + 24 else ""
        raise ValueError(f"it has {len(rows):,} hours{leap}, want the {len(YEAR):,} of a year without 29 February")
    for number, (row, right) in enumerate(zip(rows, YEAR, strict=True), _HEADER + 1):
        if tuple(map(str.strip, row[1:4])) not in (tuple(map(str, right)), tuple(f"{part:02}" for part in right)):
            date = "month {}, day {}, hour {}"
            raise ValueError(f"line {number} is of {date.format(*row[1:4])}, want {date.format(*right)}")
    return "\n".join(header + [",".join(row[:_FIELDS]) + "," * (_PVLIB_FIELDS - _FIELDS) for row in rows])


def _check_place(line: str) -> None:
    """Refuses a first line without the numbers of a place.

    Raises:
        ValueError: says what is wrong.
    """
    fields = line.split(",")
    if len(fields) < 10:
        raise ValueError(
            f"line 1 has {len(fields)} fields, want 10, the last the latitude, longitude, time zone and altitude"
        )
    for value, (name, limit) in zip(map(float, fields[6:10]), _LIMITS.items(), strict=True):
        if not -limit <= value <= limit:
            raise ValueError(f"line 1 has the {name} {value:g}, want one from -{limit} to {limit}")


def _radiation(table: Any, column: str, name: str) -> np.ndarray:
    """(8760,) W/m².

    Raises:
        ValueError: numbers that are missing or cannot be.
    """
    values = table[column].to_numpy(np.float64)
    bad = np.flatnonzero(~((values >= 0.0) & (values <= _STRONGEST)))
    if len(bad):
        row = bad[0]
        raise ValueError(
            f"{name} radiation is missing or out of range in {len(bad):,} of the hours, first {values[row]:g} in line "
            f"{_HEADER + 1 + row}, want 0 to {_STRONGEST:g} W/m²"
        )
    return values


def _check_nights(direct: np.ndarray, altitude: np.ndarray) -> None:
    """Refuses a place that does not fit the hours, as one whose longitude is counted towards the west.

    Raises:
        ValueError: says how much of the sun's radiation comes at night.
    """
    share = direct[altitude < _NIGHT].sum() / max(direct.sum(), 1.0)
    if share > 0.01:
        raise ValueError(
            f"{share:.0%} of its direct radiation comes at night by the latitude, longitude and time zone of line 1"
        )
