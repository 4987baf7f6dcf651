"""Information from a coordinate reference system (CRS) of a raster or of CityJSON: units, true north, and map distortion."""

import re
from collections.abc import Mapping
from typing import Any

import numpy as np
import pyproj
import rasterio
from pyproj.exceptions import CRSError, ProjError

from warpsample.host.arguments import quote

_FOOT, _SURVEY_FOOT = 0.3048, 1200.0 / 3937.0
_METRES = {"m": 1.0, "mm": 0.001, "cm": 0.01, "dm": 0.1, "dam": 10.0, "km": 1000.0}
for _prefix, _factor in (("", 1.0), ("milli", 0.001), ("centi", 0.01), ("deci", 0.1), ("deca", 10.0), ("kilo", 1000.0)):
    _METRES |= dict.fromkeys((f"{_prefix}{metre}" for metre in ("metre", "metres", "meter", "meters")), _factor)
_METRES |= dict.fromkeys(("ft", "foot", "feet", "international foot", "international feet"), _FOOT)
_METRES |= dict.fromkeys(("us-ft", "ftus", "us survey foot", "us survey feet", "foot_us", "sft"), _SURVEY_FOOT)
_METRES |= dict.fromkeys(("foot (us)", "feet (us)", "us foot", "us feet", "survey foot", "survey feet"), _SURVEY_FOOT)
_METRES |= dict.fromkeys(("inch", "inches"), 0.0254) | dict.fromkeys(("yd", "yard", "yards"), 0.9144)
_METRES |= dict.fromkeys(("fathom", "fathoms"), 1.8288)
_ANGLE = re.compile(r"(arc|deg|grad|rad)[a-z_ -]*|°|(grid_)?(latitude|longitude)")  # units and standard names of netCDF
_DEPTH = re.compile(r"(^|_)depth(_|$)")  # in standard names of netCDF, as sea_floor_depth_below_geoid
_PART = re.compile(r"[?&]\d+=([^?&]+)")  # of an address of several systems: crs-compound?1=...&2=...
_EPSG = re.compile(r"EPSG(?:/|::|:)(?:[^/:]*[/:])?(\d+)/?$", re.IGNORECASE)
_UNNAMED = {"", "unknown", "unnamed", "undefined"}  # names of maps that say nothing, in lower case
_SAME = 1.0  # m: versions of a datum differ by less, other maps by more
_STRETCHED = 0.05  # relative error of lengths; UTM has at most 0.001, a map of a continent 0.03
REPROJECT = "reproject it first, as by da.rio.reproject(da.rio.estimate_utm_crs())"
_STEP = 1e-4  # degrees of latitude, 11 m: short enough for a straight meridian, long enough for nine digits in float64


def crs_of(crs: Any) -> pyproj.CRS | None:
    """Return a pyproj CRS whose first two axes are lengths; None for None.

    Raises:
        TypeError, ValueError: Not a CRS, or a CRS in degrees; the message names `source`.
    """
    if crs is None:
        return None
    try:
        found = pyproj.CRS.from_user_input(crs)
    except CRSError as error:
        raise ValueError(
            f"source: got {quote(crs)} for its CRS, want a CRS that pyproj knows, such as 'EPSG:3794', or None"
        ) from error
    if isinstance(crs, rasterio.CRS):
        _check_database(found)
    check_map(found, "source", f"{REPROJECT} or gdalwarp")
    return found


def _check_database(crs: pyproj.CRS) -> None:
    """Raise a ValueError for a map that GDAL has read without its database: it may lack its place on Earth and its units."""
    try:
        rasterio.CRS.from_epsg(3035)
    except rasterio.errors.CRSError as error:
        raise ValueError(
            f"source: got a map, {crs.name}, that GDAL has read without its database of maps; unset PROJ_DATA and PROJ_LIB, "
            "which may belong to another program"
        ) from error


def check_map(crs: pyproj.CRS, argument: str, mend: str) -> None:
    """Raise a ValueError for a CRS of depths, or one whose first two axes are not lengths; the message names `argument`."""
    axes = _flat(crs).axis_info
    unit = axes[0].unit_name if axes else ""
    if any(angle in unit.lower() for angle in ("degree", "radian", "grad", "arc")):
        raise ValueError(f"{argument}: got coordinates in {unit} of {crs.name}, want lengths, as heights are; {mend}")
    if crs.is_geocentric or crs.type_name == "Vertical CRS":
        raise ValueError(f"{argument}: got coordinates of {crs.name}, want a map with two horizontal axes")
    if any(axis.direction == "down" for axis in crs.axis_info):
        raise ValueError(
            f"{argument}: got depths (CRS {crs.name}), want heights; multiply the depths by -1, and use a CRS of heights"
        )


def crs_by_address(text: str) -> pyproj.CRS:
    """Return the CRS of an OGC address or URN, or of any text that pyproj accepts.

    PROJ cannot read addresses of several systems, crs-compound?1=...&2=..., which CityJSON uses for a map and its heights.

    Raises:
        CRSError: An unknown CRS.
    """
    parts = [part for address in _PART.findall(text) if (part := _EPSG.search(address))]
    if len(parts) != len(_PART.findall(text)) or "crs-compound" not in text:
        return pyproj.CRS.from_user_input(text)
    return pyproj.CRS.from_user_input("EPSG:" + "+".join(part[1] for part in parts))


def is_same_crs(one: pyproj.CRS, other: pyproj.CRS) -> bool:
    """Return True if two CRS are equal. Maps without a place on Earth must have equal names, too, unless one has no name."""
    names = {each.name.lower() for each in (one, other)} - _UNNAMED
    return one == other and (one.geodetic_crs is not None or len(names) < 2)


def is_same_map(one: pyproj.CRS, other: pyproj.CRS, x: float, y: float) -> bool:
    """Return True if two CRS place the point (x, y) of the first within 1 m of each other, regardless of units."""
    same = is_same_crs(_flat(one), _flat(other))
    if same or None in (one.geodetic_crs, other.geodetic_crs):
        return same
    try:
        there = pyproj.Transformer.from_crs(_flat(one), _flat(other), always_xy=True).transform(x, y, errcheck=True)
    except ProjError:
        return False
    off = np.array(there) * metres_of(other) - np.array((x, y)) * metres_of(one)
    return bool(np.abs(off).max() <= _SAME)


def describe_stretch(crs: pyproj.CRS | None, x: float, y: float) -> str:
    """Describe the distortion of a map where lengths around (x, y) are wrong by 5 % or more; return "" for other maps."""
    least, most = stretches_of(crs, x, y)
    if crs is None or max(1.0 - least, most - 1.0) <= _STRETCHED:
        return ""
    ratio = f"{most:.2f}" if most - least < 0.01 else f"{least:.2f} to {most:.2f}"
    return f"got a map, {crs.name}, on which distances are {ratio} times as long as on the ground, unlike heights"


def metres_of(crs: pyproj.CRS | None) -> float:
    """Return the length in metres of the unit of a CRS's first two axes; 1 if the unit is unknown."""
    axes = _flat(crs).axis_info if crs else []
    return axes[0].unit_conversion_factor or 1.0 if axes else 1.0


def check_unit(unit: str, crs: pyproj.CRS | None, what: str) -> None:
    """Raise a ValueError if the named unit of coordinates differs from that of their CRS; without a CRS it is the metre.

    Args:
        unit: Name of a unit of lengths or angles, or a standard name of netCDF such as "longitude". Others are ignored.
        crs: CRS in lengths, or None.
        what: Name of the coordinates for the message.
    """
    name, metres = unit.strip().lower(), metres_of(crs)
    if _ANGLE.fullmatch(name):
        raise ValueError(f"source: got {what} in {unit!r}, want lengths, as heights are; {REPROJECT} or gdalwarp")
    length = length_of(unit)
    if length is not None and abs(length - metres) > 1e-5 * metres:
        raise ValueError(
            f"source: got {what} in {unit!r}, want the unit of the CRS ({metres:g} m); convert the numbers to that unit"
        )


def check_upward(attributes: Mapping[str, Any]) -> None:
    """Raise a ValueError if the netCDF attributes of an array or a band state that the numbers are depths, not heights."""
    positive, name = (str(attributes.get(key, "")).strip().lower() for key in ("positive", "standard_name"))
    if positive == "down" or (_DEPTH.search(name) and positive != "up"):
        got = f"standard_name={name!r}" if positive != "down" else "positive='down'"
        raise ValueError(f"source: got {got}, want heights (positive up); negate the numbers, and correct the attribute")


def length_of(unit: str) -> float | None:
    """Return the length in metres of a unit by its name in any case, such as "cm" or "US survey foot"; None if unknown."""
    return _METRES.get(unit.strip().lower().replace("u.s.", "us"))


def height_metres_of(crs: pyproj.CRS | None) -> float | None:
    """Return the length in metres of the unit of a CRS's third axis, or None without a third axis."""
    parts = crs.sub_crs_list if crs else []
    axes = parts[1].axis_info if len(parts) > 1 else crs.axis_info[2:] if crs else []
    return axes[0].unit_conversion_factor or None if axes else None


def true_north(crs: pyproj.CRS | None, x: float, y: float) -> tuple[float, float, float]:
    """Return the unit vector on the map that points to true north at (x, y); (0, 1, 0) for a map without a place on Earth.

    Raises:
        ValueError: The point is outside the CRS's domain, or the map mirrors the ground; the message names `source`.
    """
    if crs is None or crs.geodetic_crs is None:
        return 0.0, 1.0, 0.0
    north, east, _ = _steps(crs, x, y)
    if east[0] * north[1] < east[1] * north[0]:
        raise ValueError(
            f"source: got a map, {crs.name}, on which east is to the left of north, want a map that does not mirror the "
            f"ground; {REPROJECT}"
        )
    length = float(np.hypot(*north))
    return float(north[0]) / length, float(north[1]) / length, 0.0


def stretches_of(crs: pyproj.CRS | None, x: float, y: float) -> tuple[float, float]:
    """Return the least and the largest ratio of map length to ground length at (x, y), over all directions.

    Both are 1 for a map without a place on Earth. They differ on maps that are not conformal, such as EPSG:4087.
    """
    if crs is None or crs.geodetic_crs is None:
        return 1.0, 1.0
    try:
        north, east, lengths = _steps(crs, x, y)
    except ValueError:
        return 1.0, 1.0
    if lengths[1] < 1e-6 * lengths[0]:  # at a pole, where all directions are north or south
        east, lengths[1] = north[::-1] * (1.0, -1.0), lengths[0]
    most, least = metres_of(crs) * np.linalg.svd(np.stack([north, east]) / lengths[:, None], compute_uv=False)
    return float(least), float(most)


def _steps(crs: pyproj.CRS, x: float, y: float) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return small steps to north and east at (x, y) as map vectors, and their lengths on the ground in metres, (2,)."""
    geodetic = crs.geodetic_crs.to_2d()
    radian = geodetic.axis_info[0].unit_conversion_factor or np.radians(1.0)
    degree = np.radians(1.0) / radian  # in the unit of the CRS, such as 10/9 grads
    step, pole = degree * _STEP, degree * 90.0
    try:
        to_map = pyproj.Transformer.from_crs(geodetic, _flat(crs), always_xy=True)
        longitude, latitude = to_map.transform(x, y, direction="INVERSE", errcheck=True)
        south, north = np.clip([latitude - step, latitude + step], -pole, pole)
        around = [longitude, longitude, longitude - step, longitude + step], [south, north, latitude, latitude]
        middle, *places = np.transpose(to_map.transform(*np.c_[(longitude, latitude), around], errcheck=True))
        ends = np.reshape(around, (2, 2, 2)).swapaxes(0, 1) / degree  # (step, longitude or latitude, end)
        lengths = np.array([crs.get_geod().line_length(*each) for each in ends])
        if not lengths[0] > 0.0:
            raise ProjError("no step to the north")
    except ProjError as error:
        raise ValueError(
            f"source: got a raster around ({x:g}, {y:g}), which is not on Earth in {crs.name}; check the CRS and "
            "the transform"
        ) from error
    halves = places[3] - middle, middle - places[2]  # one of which may cross the edge of a map of the world
    return places[1] - places[0], 2.0 * min(halves, key=np.linalg.norm), lengths


def _flat(crs: pyproj.CRS) -> pyproj.CRS:
    """Return the horizontal part of a coordinate reference system, without a vertical axis."""
    flat = crs.sub_crs_list[0] if crs.sub_crs_list else crs
    return flat.source_crs if flat.is_bound else flat
