"""Checks of EPW weather files before pvlib reads them, because pvlib accepts nearly any file."""

import re
from pathlib import Path
from typing import Any

import numpy as np

from warpsample.host.arguments import quote

_HEADER = 8  # lines, the first LOCATION, the last DATA PERIODS
_FIELDS = 16  # per row, up to the diffuse radiation; pvlib names 35 fields, and some files have fewer
_PVLIB_FIELDS = 35
_DIRECT = 14  # the field of the direct radiation, from 0
_YEAR = re.compile("(1[89]|2[01])[0-9]{2}")
_NUMBER = re.compile(r"[+-]?([0-9]+[.]?[0-9]*|[.][0-9]+)(e[+-]?[0-9]+)?|nan|[+-]?inf", re.IGNORECASE)
_QUOTED_COMMA = re.compile(r'(?:^|,)\s*"[^"]*,[^"]*"\s*(?:,|$)')
_STRONGEST = 1500.0  # W/m²: 1,412 outside the atmosphere; files mark missing values with 9999
_LIMITS = {"latitude": 90, "longitude": 180, "time zone": 14, "altitude": 9000}  # degrees, hours, metres
_DAYS = (31, 28, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31)

YEAR = [(month, day, hour) for month in range(1, 13) for day in range(1, _DAYS[month - 1] + 1) for hour in range(1, 25)]
"""(month, day, hour 1 to 24) of the 8,760 rows of a file."""


def check_text(path: Path) -> str:
    """Check an EPW weather file, and return its text with the fields that are read.

    These are place, dates, hours and radiation.

    Raises:
        ValueError: the lines are not those of 8,760 hours.
    """
    lines = re.split("\r\n|\r|\n", path.read_bytes().decode("utf-8-sig", errors="replace"))
    for number, name in ((1, "LOCATION"), (_HEADER, "DATA PERIODS")):
        if len(lines) < number or not lines[number - 1].upper().startswith(f"{name},"):
            raise ValueError(f"line {number} does not begin with {name}, as in an EPW file")
    _check_place(lines[0])
    data = [line for line in lines[_HEADER:] if line.strip()]
    rows = [line.replace('"', "").split(",") for line in data]
    for number, (line, row) in enumerate(zip(data, rows, strict=True), _HEADER + 1):
        quoted = _QUOTED_COMMA.search(line)
        if quoted and line.count(",", 0, quoted.start()) < _FIELDS - 1:  # the fields after it would be shifted
            raise ValueError(f"line {number} has a comma between quotation marks, want none up to the diffuse radiation")
        if len(row) < _FIELDS:
            raise ValueError(f"line {number} has {len(row)} fields, want at least {_FIELDS}, up to the diffuse radiation")
    if len(rows) != len(YEAR):
        leap = ", with 29 February" if len(rows) == len(YEAR) + 24 else ""
        raise ValueError(
            f"the file has {len(rows):,} hours{leap}, want the {len(YEAR):,} hours of a year without 29 February"
        )
    for number, (row, right) in enumerate(zip(rows, YEAR, strict=True), _HEADER + 1):
        if tuple(map(str.strip, row[1:4])) not in (tuple(map(str, right)), tuple(f"{part:02}" for part in right)):
            date = "month {}, day {}, hour {}"
            raise ValueError(
                f"line {number} has the data of {date.format(*row[1:4])}, want {date.format(*right)}, next in the year"
            )
        if not _YEAR.fullmatch(row[0].strip()):
            raise ValueError(f"line {number} has the year {quote(row[0])}, want a year from 1800 to 2199")
        for text in map(str.strip, row[_DIRECT:_FIELDS]):
            if text and not _NUMBER.fullmatch(text):  # float() would read 1_000 as 1000
                raise ValueError(f"line {number} has the radiation {quote(text)}, want a number")
    between, after = [""] * (_DIRECT - 4), [""] * (_PVLIB_FIELDS - _FIELDS)
    kept = [",".join([*row[:4], *between, *row[_DIRECT:_FIELDS], *after]) for row in rows]
    return "\n".join([lines[0], *["-"] * (_HEADER - 1), *kept])


def _check_place(line: str) -> None:
    """Check that the first line of an EPW file has the latitude, longitude, time zone and altitude of a place.

    Raises:
        ValueError: fields are missing or out of range.
    """
    fields = line.split(",")
    if len(fields) < 10:
        raise ValueError(
            f"line 1 has {len(fields)} fields, want 10, the last the latitude, longitude, time zone and altitude"
        )
    for text, (name, limit) in zip(map(str.strip, fields[6:10]), _LIMITS.items(), strict=True):
        if not (_NUMBER.fullmatch(text) and -limit <= float(text) <= limit):
            got = f"{float(text):g}" if _NUMBER.fullmatch(text) else quote(text)
            raise ValueError(f"line 1 has the {name} {got}, want a number from -{limit} to {limit}")


def radiation(table: Any, column: str, name: str) -> np.ndarray:
    """Return the radiation of each hour from one column of an EPW file, (8760,) W/m².

    Raises:
        ValueError: values are missing or out of range.
    """
    values = table[column].to_numpy(np.float64)
    bad = np.flatnonzero(~((values >= 0.0) & (values <= _STRONGEST)))
    if len(bad):
        row = bad[0]
        raise ValueError(
            f"{name} radiation is missing or out of range in {len(bad):,} of the hours, first {values[row]:g} in line "
            f"{_HEADER + 1 + row}, want 0 to {_STRONGEST:g} W/m2"
        )
    return values
