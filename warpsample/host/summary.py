"""Short descriptions of results, which `print` and notebooks show instead of whole arrays."""

from dataclasses import fields, is_dataclass
from html import escape
from typing import Any, ClassVar

import numpy as np

_LONGEST = 60  # characters of a value that is no array


class Summary:
    """Base class of results: `print` and notebooks show one line per field instead of whole arrays."""

    _counted: ClassVar[str] = "points"
    """Plural noun of the things that the first axis counts."""

    def __repr__(self) -> str:
        """Return a short description of the result: its kind, and one line for each field."""
        rows = self._rows()
        width = max(map(len, rows), default=0)
        return "\n".join([self._title(), *(f"  {name:{width}}  {text}" for name, text in rows.items())])

    def _repr_html_(self) -> str:
        """Return the description of the result as an HTML table, for notebooks."""
        cells = (f"<tr><th>{escape(name)}</th><td>{escape(text)}</td></tr>" for name, text in self._rows().items())
        return f"<table><caption>{escape(self._title())}</caption>{''.join(cells)}</table>"

    def _title(self) -> str:
        """Return the kind of result, with the number of points where the result has one row for each."""
        rows = self if hasattr(self, "__len__") else getattr(self, "status", None)
        return type(self).__name__ + ("" if rows is None else f" of {len(rows):,} {self._counted}")

    def _rows(self) -> dict[str, str]:
        """Return the description of each field that has a value."""
        rows = {item.name: describe(getattr(self, item.name)) for item in fields(self)}  # type: ignore[arg-type]
        if hasattr(self, "counts"):
            rows["status"] = ", ".join(f"{number:,} {status.name}" for status, number in self.counts().items())
        return {name: text for name, text in rows.items() if text}


def describe(value: Any) -> str:
    """Describe a value in a few words: for an array its shape, kind of number, mean and range."""
    if value is None or (isinstance(value, tuple | list | dict) and not value):
        return ""
    if hasattr(value, "shape"):
        return _describe_array(value)
    if isinstance(value, Summary):
        return value._title()
    if is_dataclass(value) or isinstance(value, bytes | list):
        return _describe_parts(value)
    text = " ".join(repr(value).split())
    return text if len(text) <= _LONGEST else f"{text[: _LONGEST - 3]}..."


def _describe_array(array: Any) -> str:
    """Return shape and kind of number of an array of NumPy, Warp or SciPy; arrays on a device are not read."""
    if isinstance(array, np.ndarray):
        return f"{array.shape} {array.dtype}{_statistics(array)}"
    if hasattr(array, "nnz"):
        return f"{array.shape} {array.dtype}, {array.nnz:,} entries{_statistics(array.data)}"
    return f"{tuple(array.shape)} {getattr(array.dtype, '__name__', array.dtype)} on {array.device}"


def _describe_parts(value: Any) -> str:
    """Describe a value that is no array: the counts above 0 of a record of counts, else type and length."""
    counts = {item.name: getattr(value, item.name) for item in fields(value)} if is_dataclass(value) else {}
    if counts and all(isinstance(count, int) for count in counts.values()):
        return ", ".join(f"{count:,} {name}" for name, count in counts.items() if count) or "nothing"
    return type(value).__name__ + (f" of length {len(value):,}" if hasattr(value, "__len__") else "")


def _statistics(array: np.ndarray) -> str:
    """Return text on the numbers in an array: range, mean, and the number of infinite and NaN entries."""
    if array.dtype.kind in "Mm" and array.size:
        return f", {array.min()} to {array.max()}"
    if array.dtype.kind not in "iuf" or not array.size:
        return ""
    finite = array[np.isfinite(array)] if array.dtype.kind == "f" else array
    if not finite.size:
        return ", no finite number"
    mean = f", mean {finite.mean(dtype=np.float64):.4g}" if array.dtype.kind == "f" and array.ndim == 1 else ""
    missing = f", {array.size - finite.size:,} not finite" if finite.size < array.size else ""
    return f"{mean}, {finite.min():.4g} to {finite.max():.4g}{missing}"
