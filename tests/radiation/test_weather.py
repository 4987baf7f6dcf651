"""Weather files: what is read, where the sun stands, and what is refused."""

import re
import sys
from contextlib import nullcontext

import numpy as np
import pytest
from weather_files import ATHENS, COLUMNS, header, rows, sun_altitude, write_epw

from warpsample.host.locks import imported
from warpsample.radiation.weather.epw import YEAR
from warpsample.radiation.weather.weather import _build_athens, hours_of, read_weather

pytest.importorskip("pvlib")


def test_the_numbers_of_the_file_come_hour_by_hour(athens):
    weather = read_weather(athens)
    for name, column in (("direct_normal", COLUMNS["dni"]), ("diffuse_horizontal", COLUMNS["dhi"])):
        assert np.array_equal(getattr(weather, name), [float(row[column]) for row in rows()])
    assert (weather.latitude, weather.longitude, weather.time_zone, weather.altitude) == tuple(ATHENS.values())
    assert weather.hours[0] == np.datetime64("2021-01-01T00:00")
    assert (np.diff(weather.hours) == np.timedelta64(60, "m")).all()


def test_errors_of_floating_point_numbers_do_not_reach_pvlib():
    hours_of_sun = read_weather("athens").direct_normal > 0.0
    _build_athens.cache_clear()
    with np.errstate(all="raise"):  # as `np.seterr` of a user; its exponential underflows at night
        assert np.array_equal(read_weather("athens").direct_normal > 0.0, hours_of_sun)


def test_the_sun_stands_where_it_is_at_mid_hour(athens):
    """Cooper's and Spencer's formulas agree with pvlib to 1.2°; at the hours' ends they would be 7° and more off."""
    weather = read_weather(athens)
    right = np.degrees(np.arcsin(sun_altitude(**ATHENS)))
    assert np.abs(np.degrees(weather.sun_altitude) - right).max() < 1.3
    summer = 24 * (sum((31, 28, 31, 30, 31)) + 20)  # 21 June
    azimuth = np.degrees(weather.sun_azimuth[summer : summer + 24])
    assert 70.0 < azimuth[6] < 80.0  # 6:30 in the morning: east by north
    assert 170.0 < azimuth[12] < 190.0  # 12:30, at 23.7° east in the zone of 30°: south
    assert 270.0 < azimuth[17] < 285.0


def test_half_hours_of_a_time_zone_count(tmp_path):
    india = {"latitude": 28.6, "longitude": 77.2, "zone": 5.5}
    weather = read_weather(write_epw(tmp_path / "delhi.epw", **india))
    right = np.degrees(np.arcsin(sun_altitude(**ATHENS | india)))
    assert np.abs(np.degrees(weather.sun_altitude) - right).max() < 1.3


def test_years_of_months_may_differ_and_letters_be_of_any_encoding(tmp_path, athens):
    def mixed(table):
        return [[str(1990 + int(row[1])), *(f"{int(part):02}" for part in row[1:4]), *row[4:]] for row in table]

    path = write_epw(tmp_path / "typical.epw", change=mixed)
    path.write_bytes(path.read_bytes().replace(b"Athens,-", "São Tomé,-".encode("latin-1")))
    weather = read_weather(path)
    assert (weather.hours[0], weather.hours[-1]) == (np.datetime64("1991-01-01T00:00"), np.datetime64("2002-12-31T23:00"))
    assert np.array_equal(weather.direct_normal, read_weather(athens).direct_normal)


@pytest.mark.parametrize("width", [16, *(pytest.param(n, marks=pytest.mark.slow) for n in (33, 35, 40))])
def test_what_follows_the_diffuse_radiation_does_not_count(tmp_path, athens, width):
    path = write_epw(tmp_path / "wide.epw", change=lambda table: [(row + 5 * ['"x, y"'])[:width] for row in table])
    assert np.array_equal(read_weather(path).diffuse_horizontal, read_weather(athens).diffuse_horizontal)


def test_quotation_marks_and_odd_line_ends_in_what_is_not_read_do_not_count(tmp_path, athens):
    """pandas takes lines between two marks for one text; Python knows more ends of a line than files of weather."""

    def marked(table):
        return [[*row[:5], '"' if 4000 <= i < 4002 else "\x0c", *row[6:]] for i, row in enumerate(table)]

    path = write_epw(tmp_path / "marked.epw", change=marked)
    path.write_bytes(path.read_bytes().replace(b"1,none", '1,5" of rain\u2028and more'.encode(), 1))
    weather, right = read_weather(path), read_weather(athens)
    for name in ("hours", "direct_normal", "diffuse_horizontal", "sun_altitude"):
        assert np.array_equal(getattr(weather, name), getattr(right, name))


def test_athens_is_an_example_of_a_cloudless_year(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    weather = read_weather("athens")
    noon = weather.sun_altitude.reshape(365, 24).max(axis=1)
    assert np.degrees([noon.min(), noon.max()]) == pytest.approx([28.6, 75.5], abs=0.5)
    assert 900.0 < weather.direct_normal.max() < 1100.0
    assert 0.05 < weather.diffuse_horizontal.sum() / weather.direct_normal.sum() < 0.2
    night = weather.sun_altitude < 0.0
    assert 4000 < night.sum() < 4700  # a little less than half of 8,760 hours
    assert (weather.direct_normal[night] == 0.0).all()
    (tmp_path / "athens").write_text("mine")
    with pytest.raises(ValueError, match="^weather: got 'athens', which cannot be read"):
        read_weather("athens")


def cell(line, column, text):
    """Another text in a field of a line of the file."""

    def change(table):
        table[line - 9][column] = text
        return table

    return change


def leap(table):
    february = [[*row[:2], "29", *row[3:]] for row in table[58 * 24 : 59 * 24]]
    return table[: 59 * 24] + february + table[59 * 24 :]


FLAWS = {
    "truncated": (lambda table: table[:5000], "the file has 5,000 hours, want the 8,760 hours of a year"),
    "cut in a row": (lambda table: [*table[:4999], table[4999][:7]], "line 5008 has 7 fields, want at least 16"),
    "leap": (leap, "the file has 8,784 hours, with 29 February, want the 8,760"),
    "half-hourly": (lambda table: [row for row in table for _ in range(2)], "the file has 17,520 hours"),
    "few columns": (lambda table: [row[:14] for row in table], "line 9 has 14 fields"),
    "no dni column": (
        lambda table: [row[:14] + row[15:] for row in table],
        "diffuse horizontal radiation is missing or out of range in 8,760 of the hours, first 999999 in line 9",
    ),
    "an hour twice": (cell(12, 3, "3"), "line 12 has the data of month 1, day 1, hour 3, want month 1, day 1, hour 4"),
    "hours from 0": (
        lambda table: [[*row[:3], str(int(row[3]) - 1), *row[4:]] for row in table],
        "line 9 has the data of month 1, day 1, hour 0, want month 1, day 1, hour 1",
    ),
    "july first": (lambda table: table[181 * 24 :] + table[: 181 * 24], "line 9 has the data of month 7, day 1, hour 1"),
    "missing": (
        cell(4000, 14, "9999"),
        "direct normal .* in 1 of the hours, first 9999 in line 4000, want 0",
    ),
    "negative": (cell(4000, 15, "-1"), "diffuse horizontal radiation .* first -1 in line 4000"),
    "blank": (cell(4000, 15, ""), "diffuse horizontal radiation .* first nan in line 4000"),
    "infinite": (cell(4000, 15, "inf"), "diffuse horizontal radiation .* first inf in line 4000"),
    "words": (cell(4000, 15, "bright"), "line 4000 has the radiation 'bright', want a number"),
    "a year of words": (cell(4000, 0, "now"), "line 4000 has the year 'now', want a year from 1800 to 2199"),
    "commas in a field": (  # the global radiation was taken for the direct one: 3,064 kWh/m2 for 1,861
        lambda table: [[*row[:5], '"?9,A"', *row[6:13], "300", *row[14:]] for row in table],
        "line 9 has a comma between quotation marks, want none up to the diffuse radiation",
    ),
    "a decimal comma": (cell(4000, 15, '"1,5"'), "line 4000 has a comma between quotation marks"),
    "an underscore": (cell(4000, 14, "1_000"), "line 4000 has the radiation '1_000', want a number"),
    "a year of two digits": (cell(4000, 0, "99"), "line 4000 has the year '99', want a year from 1800 to 2199"),
}


@pytest.mark.parametrize("flaw", FLAWS)
def test_a_flawed_file_is_a_sentence(tmp_path, flaw):
    change, message = FLAWS[flaw]
    path = write_epw(tmp_path / "flawed.epw", change=change)
    with pytest.raises(ValueError, match=rf"^weather: got '{re.escape(str(path))}', which cannot be read as .*{message}"):
        read_weather(path)


PLACES = {
    "latitude": ({"latitude": 91.0}, "line 1 has the latitude 91, want a number from -90 to 90"),
    "zone": ({"zone": 120.0}, "line 1 has the time zone 120, want a number from -14 to 14"),
    "nan": ({"longitude": float("nan")}, "line 1 has the longitude nan"),
    "west": ({"longitude": -118.0, "zone": 8.0}, r"\d+% of the direct radiation is at night"),
    "words": ({"altitude": "high"}, "line 1 has the altitude 'high', want a number from -9000 to 9000"),
    "underscore": ({"altitude": "1_000"}, "line 1 has the altitude '1_000', want a number"),
}


@pytest.mark.parametrize("flaw", PLACES)
def test_a_wrong_place_is_a_sentence(tmp_path, flaw):
    place, message = PLACES[flaw]
    path = tmp_path / "flawed.epw"
    table = rows(**ATHENS)
    path.write_text("\n".join(header(**ATHENS | place) + [",".join(row) for row in table]))
    with pytest.raises(ValueError, match=message):
        read_weather(path)


@pytest.mark.parametrize("share", [0.009, 0.011])
def test_over_one_percent_of_direct_radiation_at_night_is_refused(share, tmp_path):
    def change(table):
        day = sum(float(row[14]) for row in table)
        for row in table[::24]:  # from midnight to 1
            row[14] = f"{day / 365 * share / (1 - share):.3f}"
        return table

    path = write_epw(tmp_path / "night.epw", change=change)
    with nullcontext() if share < 0.01 else pytest.raises(ValueError, match="1% of the direct radiation is at night"):
        assert len(read_weather(path).hours) == 8760


@pytest.mark.parametrize(
    ("content", "message"),
    [
        (b"", "the file is empty"),
        (b"\x89PNG\r\n\x1a\n\x00\x00", "line 1 does not begin with LOCATION"),
        (b"x,y,z\n1,2,3\n", "line 1 does not begin with LOCATION"),
        (b"LOCATION,a,b\n" + 7 * b"DATA PERIODS,1\n", "line 1 has 3 fields, want 10"),
        (b"LOCATION,a,b\n", "line 8 does not begin with DATA PERIODS"),
    ],
)
def test_what_is_no_weather_file_is_a_sentence(tmp_path, content, message):
    path = tmp_path / "not.epw"
    path.write_bytes(content)
    with pytest.raises(ValueError, match=rf"^weather: got .*not\.epw.*{message}"):
        read_weather(path)


def test_no_file_is_a_sentence(tmp_path):
    with pytest.raises(FileNotFoundError, match=r"^weather: got .*gone\.epw', which is missing, want an EPW weather file"):
        read_weather(tmp_path / "gone.epw")
    with pytest.raises(TypeError, match="^weather: got 3, want the path of an EPW weather file"):
        read_weather(3)


def test_pvlib_is_asked_for_by_the_extra(athens, monkeypatch):
    monkeypatch.setitem(sys.modules, "pvlib", None)
    imported.cache_clear()
    imported.cache_clear()
    with pytest.raises(ModuleNotFoundError, match=r"pip install '\.\[radiation\]'"):
        read_weather(athens)


PERIODS = {
    ("01-01", "12-31"): (0, 8760),
    ("01-01", "01-01"): (0, 24),
    ("03-21T09", "03-21T15"): (79 * 24 + 9, 79 * 24 + 15),
    ("06-01", "08-31"): (151 * 24, 243 * 24),
    ("06-01T00", "08-31T24"): (151 * 24, 243 * 24),
}


@pytest.mark.parametrize("period", PERIODS)
def test_a_period_has_its_hours(period):
    first, last = PERIODS[period]
    assert np.array_equal(np.flatnonzero(hours_of(period)), np.arange(first, last))


def test_a_period_goes_on_over_new_year():
    found = hours_of(["12-31T23", "01-01T01"])
    assert np.array_equal(np.flatnonzero(found), [0, 8759])
    assert [YEAR[i] for i in (0, 8759)] == [(1, 1, 1), (12, 31, 24)]


@pytest.mark.parametrize(
    "period",
    [("07-01", "06-30"), ("01-02", "01-01"), ("11-01", "10-31"), ("03-01", "02-28"), ("07-01T00", "06-30T24")],
)
def test_a_period_from_a_day_to_the_day_before_is_the_year(period, athens):
    assert hours_of(period).all()
    assert np.array_equal(read_weather(athens, period).hours, read_weather(athens).hours)  # in the order of the file


def test_a_period_may_lack_a_single_hour_of_the_year():
    for period in (("07-01", "06-30T23"), ("07-01T00", "06-30T23"), ("06-30T24", "06-30T23")):
        assert np.array_equal(np.flatnonzero(~hours_of(period)), [181 * 24 - 1])


@pytest.mark.parametrize("period", ["06-01", 3, (1, 2), ["06-01", None]])
def test_a_period_of_another_type_is_refused(period):
    with pytest.raises(TypeError, match="^period: got .*, want two days"):
        hours_of(period)


@pytest.mark.parametrize(
    "period",
    [
        ("06-01",),
        ("06-01", "06-31"),
        ("02-29", "03-01"),
        ("6-1", "8-31"),
        ("06-01T25", "07-01"),
        ("a", "b"),
        (),
        ("03-21T09",) * 2,
        ("03-21T24", "03-22T00"),
        ("12-31T24", "01-01T00"),
        ("02-28", "02-29"),
        ("\uff10\uff16-21", "06-22"),  # full-width digits, which made the period a year
    ],
)
def test_a_period_of_no_hours_is_refused(period):
    with pytest.raises(ValueError, match="^period: got .*, want two days"):
        hours_of(period)


def test_a_period_is_a_part_of_the_year(athens):
    year, part = read_weather(athens), read_weather(athens, ("06-01", "06-30"))
    assert len(part.hours) == 720
    for name in ("hours", "direct_normal", "diffuse_horizontal", "sun_altitude", "sun_azimuth"):
        assert np.array_equal(getattr(part, name), getattr(year, name)[151 * 24 : 181 * 24])
