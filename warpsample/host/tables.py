"""Columns as a table: a frame of pandas, or a .csv."""

import csv
import io
from collections.abc import Iterator, Mapping
from typing import Any, BinaryIO

import numpy as np

_BLOCK = 1 << 14  # rows that are written at a time


def frame_of(columns: Mapping[str, np.ndarray]) -> Any:
    """A pandas.DataFrame of columns, or these as a dictionary where pandas is not installed."""
    try:
        import pandas as pd
    except ModuleNotFoundError:
        return dict(columns)
    return pd.DataFrame(dict(columns))


def write_csv(stream: BinaryIO, columns: Mapping[str, np.ndarray]) -> None:
    """Writes a .csv in UTF-8 with a header; floats to nine digits, NaN as nothing, texts in quotes where it takes them."""
    stream.write(_lines([list(columns)]))
    for first in range(0, len(next(iter(columns.values()))), _BLOCK):
        cells = (list(_cells(column[first : first + _BLOCK])) for column in columns.values())
        stream.write(_lines(zip(*cells, strict=True)))


def _lines(rows: Any) -> bytes:
    text = io.StringIO()
    csv.writer(text, lineterminator="\n").writerows(rows)
    return text.getvalue().encode("utf-8", "backslashreplace")


def _cells(column: np.ndarray) -> Iterator[Any]:
    """What a column has in each row."""
    if column.dtype.kind != "f":
        yield from column.tolist()
    else:
        yield from ("" if np.isnan(number) else f"{number:.9g}" for number in column.tolist())
