"""Synthetic weather files: 8,760 hours at a place, under a clear sky or an overcast one."""

import numpy as np

from warpsample.radiation.weather.epw import YEAR

ATHENS = {"latitude": 37.9, "longitude": 23.73, "zone": 2.0, "altitude": 107.0}
COLUMNS = {"dni": 14, "dhi": 15}
"""Of a row, from 0."""


def sun_altitude(latitude, longitude, zone, **_):
    """(8760,) sine of the sun's altitude at mid-hour, to half a degree: Cooper's declination, Spencer's equation of time."""
    day = np.arange(8760) // 24
    hour = np.arange(8760) % 24 + 0.5
    turn = 2 * np.pi * day / 365
    minutes = 229.18 * (
        7.5e-5
        + 0.001868 * np.cos(turn)
        - 0.032077 * np.sin(turn)
        - 0.014615 * np.cos(2 * turn)
        - 0.040849 * np.sin(2 * turn)
    )
    angle = np.radians(15 * (hour - 12 + longitude / 15 - zone + minutes / 60))
    declination = np.radians(23.45) * np.sin(2 * np.pi * (285 + day) / 365)
    north = np.radians(latitude)
    return np.sin(north) * np.sin(declination) + np.cos(north) * np.cos(declination) * np.cos(angle)


def rows(sky="clear", **place):
    """8,760 lists of 35 texts."""
    height = np.maximum(sun_altitude(**ATHENS | place), 0.0)
    up = height > 0.0
    direct = np.where(up & (sky == "clear"), 1000.0 * np.exp(-0.13 / np.maximum(height, 0.01)), 0.0)
    diffuse = np.where(up, 120.0 * np.sqrt(height) if sky == "clear" else 350.0 * height, 0.0)
    numbers = zip(YEAR, np.round(direct), np.round(diffuse), np.round(direct * height + diffuse), strict=True)
    return [
        ["2021", *map(str, date), "60", "?9?9?9", "15.0", "8.0", "60", "101000", "9999", "9999", "9999"]
        + [f"{value:g}" for value in (both, sun, dim)]
        + ["999999", "999999", "999999", "9999", "0", "2.0", "5", "5", "9999", "99999", "9", "999999999", "20"]
        + ["0.1", "0", "88", "0.2", "0.0", "1.0"]
        for date, sun, dim, both in numbers
    ]


def header(latitude, longitude, zone, altitude):
    """The eight lines above the rows."""
    return [
        f"LOCATION,Athens,-,GRC,made by a test,167160,{latitude},{longitude},{zone},{altitude}",
        "DESIGN CONDITIONS,0",
        "TYPICAL/EXTREME PERIODS,0",
        "GROUND TEMPERATURES,0",
        "HOLIDAYS/DAYLIGHT SAVINGS,No,0,0,0",
        "COMMENTS 1,none",
        "COMMENTS 2,none",
        "DATA PERIODS,1,1,Data,Friday,1/1,12/31",
    ]


def write_epw(path, sky="clear", change=None, **place):
    """Writes the file and returns its path; `change` takes the lists of the rows and returns other ones."""
    table = rows(sky, **place)
    lines = header(**ATHENS | place) + [",".join(row) for row in (change(table) if change else table)]
    path.write_bytes(("\r\n".join(lines) + "\r\n").encode())
    return path
