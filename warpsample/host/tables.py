"""Tables of columns: a pandas.DataFrame, or a .csv file."""

import csv
import io
from collections.abc import Iterator, Mapping
from typing import Any, BinaryIO

import numpy as np

_BLOCK = 1 << 14  # number of rows that are written at a time


def frame_of(columns: Mapping[str, np.ndarray]) -> Any:
    """Return a pandas.DataFrame of columns; a dictionary of the columns where pandas is not installed."""
    try:
        import pandas as pd
    except ModuleNotFoundError:
        return dict(columns)
    return pd.DataFrame(dict(columns))


def write_csv(stream: BinaryIO, columns: Mapping[str, np.ndarray]) -> None:
    """Write a dictionary of columns as a .csv file in UTF-8, with a header line.

    Floats have nine digits, NaN is an empty cell, and texts are in quotes where .csv requires quotes.
    """
    stream.write(_lines([list(columns)]))
    for first in range(0, len(next(iter(columns.values()))), _BLOCK):
        cells = (list(_cells(column[first : first + _BLOCK])) for column in columns.values())
        stream.write(_lines(zip(*cells, strict=True)))


def _lines(rows: Any) -> bytes:
    """Convert rows to the lines of a .csv file, as UTF-8 bytes."""
    text = io.StringIO()
    csv.writer(text, lineterminator="\n").writerows(rows)
    return text.getvalue().encode("utf-8", "backslashreplace")


def _cells(column: np.ndarray) -> Iterator[Any]:
    """Yield the texts of a table column for a .csv file; NaN becomes an empty cell."""
    if column.dtype.kind != "f":
        yield from column.tolist()
    else:
        yield from ("" if np.isnan(number) else f"{number:.9g}" for number in column.tolist())
