"""Checks of the texts of a raster (.vrt, .aux.xml) and of its mask (.msk), whose damage GDAL ignores."""

import re
from html import unescape
from pathlib import Path
from typing import Any

from rasterio.enums import MaskFlags

_NUMBERS = re.compile(
    rb"<(NoDataValue|NODATA|Scale|Offset|ScaleRatio|ScaleOffset|LUT)\b[^>/]*>\s*([^<]*?)\s*<", re.IGNORECASE
)
"""Elements of numbers; GDAL reads 0, or the first digits, for another text."""

_COMMENT, _END = re.compile(rb"<!--.*?-->", re.DOTALL), re.compile(rb"</PAMDataset>|<PAMDataset\s*/>")


def check_texts(path: str, file: Any) -> None:
    """Raise a ValueError for a damaged .vrt, .aux.xml or .msk of an open raster file.

    Rasterio loses GDAL's errors about file names that are not in UTF-8, so their heights would be 0.
    """
    if file.driver == "VRT" and Path(path).is_file():
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
        content = text.read_bytes()
        if not _END.search(content):
            raise ValueError(f"source: got {path!r} next to {text.name}, whose end is missing: repair or remove it")
        _check_numbers(str(text), content)
    if masks and any({MaskFlags.all_valid, MaskFlags.nodata} & set(flags) for flags in file.mask_flag_enums):
        raise ValueError(f"source: got {path!r} next to {masks[0].name}, whose mask GDAL cannot use: repair or remove it")


def list_side_files(path: str) -> tuple[list[Path], list[Path]]:
    """Return the existing .aux.xml files and .msk files of a raster."""
    suffixes = (".aux.xml", ".AUX.XML"), (".msk", ".MSK")
    texts, masks = ([file for suffix in each if (file := Path(f"{path}{suffix}")).is_file()] for each in suffixes)
    return texts, masks


def _check_numbers(path: str, content: bytes) -> None:
    """Raise a ValueError for another text than a number in a .vrt or .aux.xml."""
    for name, found in _NUMBERS.findall(_COMMENT.sub(b"", content)):
        text = unescape(found.decode(errors="replace"))
        parts = re.split("[,:]", text.rstrip(",")) if name.upper() == b"LUT" else [text]
        if not all(map(_is_number, parts)):
            raise ValueError(f"source: got {path!r} with the {name.decode()} {text!r}, want a number")


def _is_number(text: str) -> bool:
    """Return True if the text is a number to GDAL, too, which does not read 1_0 as 10, but 1.#QNAN as NaN."""
    try:
        float(text)
    except ValueError:
        return text.strip().upper().lstrip("+-") in ("1.#QNAN", "1.#IND", "1.#INF")
    return "_" not in text
