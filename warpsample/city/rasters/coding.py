"""How heights are written as numbers: what stands for none, a scale and an offset."""

import re
from dataclasses import dataclass
from math import isfinite
from pathlib import Path
from typing import Any

import numpy as np
import xarray as xr

from warpsample.host.arguments import told

_UNDECLARED = (-9999.0, -99999.0, -32767.0, -32768.0)
"""Heights that stand for none also where no tag says so: no place on Earth is as low, and programs write them."""

_LARGEST = 1e30
"""What is larger stands for none, such as float32's largest number in a raster whose tag is float64's copy of it."""

_SCALING = {"scale_factor": 1.0, "add_offset": 0.0}
_ATTRIBUTES = ("_FillValue", "missing_value", "fill_value", "nodata", *_SCALING)
_DECLARED = re.compile(rb"<NoDataValue[^>/]*>([^<]+)<")  # in the text of a VRT


@dataclass(frozen=True)
class Coding:
    """What numbers of a raster stand for.

    Attributes:
        nodata: what stands for no height, or None.
        scale, offset: a height is a number times the one, and more by the other.
    """

    nodata: float | None = None
    scale: float = 1.0
    offset: float = 0.0

    def __post_init__(self) -> None:
        """Refuses a scale and an offset that no height comes through; ValueError."""
        if not (isfinite(self.scale) and isfinite(self.offset) and self.scale):
            raise ValueError(
                f"source: got heights of scale {self.scale:g} and offset {self.offset:g}, want finite ones, the scale not 0"
            )

    @classmethod
    def of_file(cls, path: str, file: Any, band: int) -> "Coding":
        """That of a band of an open file; a ValueError for a VRT whose nodata is a text, of which GDAL makes a number, 0."""
        declared = _DECLARED.findall(Path(path).read_bytes()) if file.driver == "VRT" and Path(path).is_file() else []
        for text in declared:
            if not _is_number(text):
                raise ValueError(f"source: got {path!r} with the nodata value {text.decode()!r}, want a number")
        return cls(file.nodatavals[band - 1], file.scales[band - 1], file.offsets[band - 1])

    @classmethod
    def of_array(cls, array: xr.DataArray) -> "Coding":
        """That of an array whose attributes tell it; a ValueError where these are no numbers."""
        given = {name: array.attrs[name] for name in _ATTRIBUTES if name in array.attrs}
        try:
            scale, offset = (np.asarray(given.get(*one), np.float64).item() for one in _SCALING.items())
            nodata = array.rio.nodata
        except (TypeError, ValueError, OverflowError):
            raise ValueError(f"source: got an xarray.DataArray of attributes {told(given)}, want numbers") from None
        return cls(nodata, scale, offset)

    def heights(self, values: np.ndarray) -> np.ndarray:
        """A float64 copy of the heights that numbers stand for, NaN where there is none.

        Raises:
            TypeError: they are no real numbers.
        """
        if values.dtype.kind not in "fiu":
            raise TypeError(f"source: got heights of dtype {values.dtype}, want real numbers")
        heights = values.astype(np.float64)
        none = ~(np.abs(heights) < _LARGEST)
        with np.errstate(over="ignore"):  # what float32 does not hold is none anyway
            declared = () if self.nodata is None else (self.nodata, np.float32(self.nodata))
        for code in (*_UNDECLARED, *declared):
            none |= heights == float(code)
        heights = heights * self.scale + self.offset
        heights[none] = np.nan
        return heights


def _is_number(text: bytes) -> bool:
    try:
        float(text)
    except ValueError:
        return False
    return True
