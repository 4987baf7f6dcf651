"""Conversion of a raster's stored numbers to heights: nodata values, scale and offset."""

import warnings
from collections.abc import Mapping
from contextlib import suppress
from copy import copy
from dataclasses import dataclass
from math import inf, isfinite
from typing import Any

import numpy as np
import xarray as xr

from warpsample.host.arguments import quote

_UNDECLARED = (*(1.0 - 10.0**digits for digits in range(4, 10)), -32767.0, -32768.0)
"""Nodata values that are recognized without a tag: many programs write these numbers, and no place on Earth is as low."""

_LARGEST = 2.0**31 - 1
"""From here on, numbers count as nodata: the limits of int32, uint32 and float32 often have no tag, or a rounded one."""

_SCALING = {"scale_factor": 1.0, "add_offset": 0.0}
_DECODED = ("_FillValue", "missing_value")  # by xarray; its encoding also has the `fill_value` of Zarr, which marks nothing
_NODATA = (*_DECODED, "fill_value", "nodata")
VALID = ("valid_min", "valid_max", "valid_range")
_KINDS = {"true": "u", "false": "i"}  # of NumPy, by the attribute `_Unsigned`
_ENDS = (-(2.0**31), 1.0 - 2.0**31, 2.0**31 - 1.0, 2.0**32 - 1.0)  # of int32 and uint32; netCDF fills with the second


@dataclass(frozen=True)
class Coding:
    """Rule to convert a raster's stored numbers to heights: number * scale + offset, NaN for the nodata value.

    Attributes:
        nodata: Numbers that mark cells without data.
        scale, offset: Factor and summand that convert a stored number to a height.
        valid: Lowest and highest stored number that counts as data.
        kind: "u" if stored integers stand for unsigned ones of the same bits, "i" for signed ones, "" for themselves.
    """

    nodata: tuple[float, ...] = ()
    scale: float = 1.0
    offset: float = 0.0
    valid: tuple[float, float] = (-inf, inf)
    kind: str = ""

    def __post_init__(self) -> None:
        """Raise a ValueError for a scale or an offset that is not finite, or a scale of 0."""
        if not (isfinite(self.scale) and isfinite(self.offset) and self.scale):
            raise ValueError(
                f"source: got heights of scale {self.scale:g} and offset {self.offset:g}, want finite numbers, "
                "and a scale other than 0"
            )

    @classmethod
    def of_file(cls, file: Any, band: int) -> "Coding":
        """Read nodata value, scale and offset of one band of an open raster file."""
        nodata = file.nodatavals[band - 1]
        return cls(() if nodata is None else (nodata,), file.scales[band - 1], file.offsets[band - 1])

    @classmethod
    def of_array(cls, array: xr.DataArray, got: str) -> "Coding":
        """Read nodata values, scale and offset from the attributes of an xarray.DataArray.

        Raises:
            ValueError: An attribute is not a number; the message describes the array as in `got`.
        """
        kind, numbers = stored_attributes(array)
        stated = {name: value for name, value in array.attrs.items() if value is not None}
        given = {name: numbers.get(name, stated[name]) for name in (*_NODATA, *_SCALING) if name in stated}
        try:
            scale, offset = (np.asarray(given.get(*one), np.float64).item() for one in _SCALING.items())
            nodata = np.concatenate([np.ravel(given.get(name, [])) for name in _NODATA]).astype(np.float64).tolist()
            nodata += _nodata_of_rioxarray(array)
            with suppress(TypeError, ValueError, OverflowError):  # an encoding that states no number
                nodata += _unpacked_codes(array.encoding)
        except (TypeError, ValueError, OverflowError):
            raise ValueError(f"source: got {got} of attributes {quote(given)}, want numbers") from None
        return cls(tuple(nodata), scale, offset, kind=kind)

    def heights(self, values: np.ndarray) -> np.ndarray:
        """Convert stored numbers of a raster to heights, as a float64 copy with NaN in cells without data.

        Raises:
            TypeError: Values that are not real numbers.
        """
        if values.dtype.kind not in "fiu":
            raise TypeError(f"source: got heights of dtype {values.dtype}, want real numbers")
        values = _as_kind(values, self.kind)
        heights = values.astype(np.float64)
        none = ~(np.abs(heights) < _LARGEST) | (heights < self.valid[0]) | (heights > self.valid[1])
        is_scaled = (self.scale, self.offset) != (1.0, 0.0)  # then the lowest integers may be heights
        codes = self.nodata if is_scaled and self.nodata else (*_UNDECLARED, *self.nodata)
        kinds = {np.float64, np.float32, values.dtype.type if values.dtype.kind == "f" else np.float64}
        with np.errstate(over="ignore"):  # numbers outside float32 count as nodata anyway
            rounded = {float(kind(code)) for code in codes for kind in kinds}  # in float16, -9999 is -10000
        none |= np.isin(heights, list(rounded))
        heights = heights * self.scale + self.offset
        heights[none] = np.nan
        return heights


def _nodata_of_rioxarray(array: xr.DataArray) -> list[float]:
    """Return the nodata value that rioxarray reads, which also knows the one that its `set_nodata` has stored.

    It refuses arrays of numbers, and numbers outside of the array's type, such as NaN for integers, which are in no cell. A
    copy is asked, because it remembers its first answer, which changed attributes would not change.
    """
    with suppress(OverflowError, ValueError, TypeError):
        nodata = copy(array.rio).nodata
        return [] if nodata is None else [float(nodata)]
    return []


def stored_attributes(array: xr.DataArray) -> tuple[str, dict[str, Any]]:
    """Return the kind of stored integers, see `Coding.kind`, and the nodata values and limits as integers of this kind."""
    kind = _KINDS.get(str(array.attrs.get("_Unsigned")).lower(), "")
    given = {name: array.attrs[name] for name in (*_NODATA, *VALID) if array.attrs.get(name) is not None}
    alike = {name: value for name, value in given.items() if np.asarray(value).itemsize == array.dtype.itemsize}
    return kind, given | {name: _as_kind(value, kind) for name, value in alike.items()}


def _as_kind(values: Any, kind: str) -> np.ndarray:
    """Return integers as those of the same bits and of a kind, "i" or "u". Others, and those of "", are as they are."""
    values = np.asarray(values)
    if not kind or values.dtype.kind not in "iu":
        return values
    return values.view(values.dtype.str.replace(values.dtype.kind, kind))


def _unpacked_codes(encoding: Mapping[str, Any]) -> list[float]:
    """Return the heights into which xarray has converted nodata values of an array, because it did not find them.

    Stated values may be of another type than the numbers, or be compared after a conversion to float32. Without a stated
    one, these are the usual ones of scaled numbers. With `_Unsigned`, those stand for heights.
    """
    stored = np.dtype(encoding.get("dtype", np.float32))
    attributes = {name: encoding[name] for name in (*_DECODED, *_SCALING, "_Unsigned") if encoding.get(name) is not None}
    if attributes.keys().isdisjoint((*_DECODED, *_SCALING)) or stored.kind not in "iuf":
        return []
    is_whole = stored.kind != "f"
    lowest, highest = (getattr((np.iinfo if is_whole else np.finfo)(stored), end) for end in ("min", "max"))
    rounded = highest + (stored.itemsize > 3)  # in float32, for whole numbers
    stated = [number for name in _DECODED if name in attributes for number in np.ravel(attributes[name]).tolist()]
    usual = () if "_Unsigned" in attributes else (*_UNDECLARED, *_ENDS)
    codes = [code for code in stated or usual if lowest <= code <= rounded and not (is_whole and code % 1)]
    packed = xr.Variable("code", np.array([min(code, highest) for code in codes], stored), attributes)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # about several nodata values
        found = xr.conventions.decode_cf_variable("codes", packed).to_numpy().astype(np.float64)
    return found[~np.isnan(found)].tolist()
