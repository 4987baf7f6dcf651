"""Checks of the texts of a raster (.vrt, .aux.xml) and of its mask (.msk), whose damage GDAL ignores."""

import re
from html import unescape
from math import isclose, isfinite, isnan
from pathlib import Path
from typing import Any
from xml.etree import ElementTree as ET

from rasterio.enums import MaskFlags

from warpsample.city.rasters.sources.arc_grid import SPECIAL
from warpsample.host.arguments import is_file

_NUMBERS = re.compile(
    rb"<(NoDataValue|NODATA|Scale|Offset|ScaleRatio|ScaleOffset|LUT)\b[^>/]*>\s*([^<]*?)\s*<", re.IGNORECASE
)
"""Elements of numbers; GDAL reads 0, or the first digits, for another text."""

_NUMBER = re.compile(rb"[+-]?(?:\d+[.]?\d*|[.]\d+)(?:[eE][+-]?\d+)?|" + SPECIAL)
_COMMENT = re.compile(rb"<!--.*?-->", re.DOTALL)
_DEFAULTS = {"NoDataValue": None, "Scale": 1.0, "Offset": 0.0, "UnitType": None}  # what GDAL says without such an element


def check_texts(path: str, file: Any) -> None:
    """Raise a ValueError for a damaged .vrt, .aux.xml or .msk of an open raster file.

    Rasterio loses GDAL's errors about file names that are not in UTF-8, so their heights would be 0.
    """
    if file.driver == "VRT" and is_file(path):
        content = Path(path).read_bytes()
        try:
            content.decode()
        except UnicodeDecodeError as error:
            raise ValueError(
                f"source: got {path!r}, which is not in UTF-8 ({error.reason}); write its file names in UTF-8"
            ) from error
        _check_numbers(path, content)
    texts, masks = list_side_files(path)
    for text in texts:
        _check_aux(path, file, text)
    if masks and any({MaskFlags.all_valid, MaskFlags.nodata} & set(flags) for flags in file.mask_flag_enums):
        raise ValueError(f"source: got {path!r} next to {masks[0].name}, whose mask GDAL cannot use: repair or remove it")


def _check_aux(path: str, file: Any, text: Path) -> None:
    """Raise a ValueError for an .aux.xml that is damaged, or whose numbers GDAL does not read, as after <?xml ...?>."""
    got = f"source: got {path!r} next to {text.name}"
    try:
        root = ET.fromstring(text.read_bytes().decode(errors="replace"))
    except ET.ParseError as error:
        raise ValueError(f"{got}, which is damaged ({error})") from error
    read = {"NoDataValue": file.nodatavals, "Scale": file.scales, "Offset": file.offsets, "UnitType": file.units}
    for place in range(file.count):
        for element in root.findall(f"PAMRasterBand[@band='{place + 1}']/*"):
            name, number = element.tag, (element.text or "").strip()
            if name in read and (number or name != "UnitType"):
                value = read[name][place]
                if name != "UnitType":
                    _check_number(str(text), name, number)
                # In other formats, a value of the raster itself can count instead.
                counts = value in (_DEFAULTS[name], "") or file.driver == "GTiff"
                if counts and not _is_same(value, number):
                    raise ValueError(
                        f"{got}, whose {name} {number} GDAL does not read; remove what is before <PAMDataset>, and unset "
                        "variables such as GDAL_PAM_ENABLED"
                    )


def _is_same(value: float | str | None, text: str) -> bool:
    """Return whether a value that GDAL has read is the text of its element; numbers may be rounded to float32."""
    if value is None or isinstance(value, str):
        return (value or "").strip() == text
    if "#" in text:  # 1.#QNAN and such, which Python does not read
        return not isfinite(value)
    return isclose(value, float(text), rel_tol=1e-6) or (isnan(value) and isnan(float(text)))


def list_side_files(path: str) -> tuple[list[Path], list[Path]]:
    """Return the existing .aux.xml files and .msk files of a raster."""
    suffixes = (".aux.xml", ".AUX.XML"), (".msk", ".MSK")
    texts, masks = ([file for suffix in each if is_file(file := Path(f"{path}{suffix}"))] for each in suffixes)
    return texts, masks


def _check_numbers(path: str, content: bytes) -> None:
    """Raise a ValueError for another text than a number in a .vrt."""
    for name, found in _NUMBERS.findall(_COMMENT.sub(b"", content)):
        _check_number(path, name.decode(), unescape(found.decode()))


def _check_number(path: str, name: str, text: str) -> None:
    """Raise a ValueError for an element that is not a number, or not a list of numbers where a list is wanted."""
    parts = re.split("[,:]", text.rstrip(",")) if name.upper() == "LUT" else [text]
    if not all(map(_is_number, parts)):
        raise ValueError(f"source: got {path!r} with the {name} {text!r}, want a number")


def _is_number(text: str) -> bool:
    """Return True if the text is a number to GDAL, which reads neither 1_0 nor -nan as Python does."""
    return _NUMBER.fullmatch(text.strip().encode()) is not None
