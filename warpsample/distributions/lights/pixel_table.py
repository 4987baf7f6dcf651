"""Table from which kernels draw pixels of a picture of the sphere, each with the share of its luminance and solid angle.

The table is one block of memory, so that a kernel needs one address:

- 20 float64: the numbers of rows, columns and buckets of columns, 1 / columns, the bytes before the shares, the margin of
  the azimuth in pixels at the equator, the number of buckets of rows, the bits of a step below its bucket of columns, the
  bytes before the luminances, and the density of a luminance of 1; from number 10 on the frame of the picture (x and y:
  azimuth, z: row 0, in columns).
- For each row 8 float64, a cache line: cumulative share at its start and end, sin^2(theta / 2) at its start and the
  difference to its end, 1 / the row's share, the density of one step of a pixel, and the margin at both edges as a fraction.
- The guide to the rows, int32: the first row that each bucket of u[0] can reach, and the last row of all.
- For each row W + 1 uint32, the cumulative shares of its pixels as multiples of 1 / COLUMN_STEPS.
- For each row the guide to its columns, int32: the first column that each bucket of u[1] can reach, and the last of all.
- For `PictureReading` the luminances of the picture's pixels relative to the brightest, float32.

A guide leaves one or two entries on average to search, for any picture (Chen1974). The numbers of buckets are powers of 2,
so that a bucket is found without rounding. The shares are integers: the density is computed from the same integers as the
draws. Every pixel with a luminance above 0 has at least one step, all others none.

Kernels take no float32 from the table as such: a compiler that knows that the float32 that a loop stores do not overlap the
table can vectorise the loop.
"""

from dataclasses import dataclass
from math import pi

import numpy as np

COLUMN_STEPS = 2**32 - 1
"""Number of steps into which the light of a row is divided."""

ROW_STEPS = 2**48
"""Number of steps into which the light of a picture is divided among its rows."""

HEADER, FRAME, ROW = 20, 10, 8
"""Number of float64 in the header of the table, before the frame in the header, and for each row."""

MARGIN = 3e-7
"""Angle in radians that draws keep from the edges of their pixel: the rounding of float32 directions."""

MOST_OF_POLAR_ROW = 0.02
"""Largest part of the row at a pole, as an angle, that draws keep from the pole."""

SEARCH_STEPS = 15
"""Steps of a search among the entries between two buckets, which are at most `MOST_PIXELS`."""

MOST_PIXELS = 2**SEARCH_STEPS
"""Largest number of rows or columns of a table."""


def pixel_angles(height: int) -> np.ndarray:
    """Return the angle to row 0's pole at the upper edge of each row and at the lower edge of the last, (H + 1,) float64."""
    return pi * np.arange(height + 1) / height


def solid_angles(angles: np.ndarray, width: int) -> np.ndarray:
    """Return the solid angle of a pixel of each row, (H,) float64, from the angles at the edges of rows, without loss."""
    middle, half = 0.5 * (angles[1:] + angles[:-1]), 0.5 * np.diff(angles)
    return 4.0 * pi / width * np.sin(middle) * np.sin(half)


def divide_steps(weights: np.ndarray, steps: int) -> np.ndarray:
    """Divide `steps` steps among the entries of each row in proportion to weights; return cumulative numbers from 0.

    An entry above 0 gets at least one step, an entry of 0 none. A row of zeros gets no step.

    Args:
        weights: (R, N) float64, at least 0.
        steps: number of steps of a row, at most 2^53.

    Returns:
        (R, N + 1) float64 of whole numbers, ascending.
    """
    sums = np.zeros((len(weights), weights.shape[1] + 1))
    largest = weights.max(axis=1, keepdims=True)
    # Relative to the largest entry: no sum overflows, and no sum is 0.
    np.cumsum(weights / np.where(largest > 0.0, largest, 1.0), axis=1, out=sums[:, 1:])
    lit = np.zeros(sums.shape)
    np.cumsum(weights > 0.0, axis=1, out=lit[:, 1:])
    total = np.where(largest > 0.0, sums[:, -1:], 1.0)
    return lit + np.rint(sums / total * (steps - lit[:, -1:]) * (largest > 0.0))


def _guide(ends: np.ndarray, last: float, buckets: int) -> np.ndarray:
    """Return the first entry that each bucket can reach, and the last entry that is reached at all, (buckets + 1,) int32.

    Args:
        ends: (N,) cumulative shares at the end of each entry, ascending, at most 1.
        last: largest share that is searched for.
        buckets: number of buckets of [0, 1).
    """
    first = np.minimum(np.arange(buckets + 1) / buckets, last)
    return np.minimum(np.searchsorted(ends, first, side="right"), len(ends) - 1).astype(np.int32)


@dataclass(frozen=True)
class Layout:
    """Sizes and positions in the table of a picture.

    Attributes:
        height, width: numbers of rows and columns.
        pixels: number of luminances.
    """

    height: int
    width: int
    pixels: int = 0

    @property
    def row_buckets(self) -> int:
        """Number of buckets of the guide to the rows: 2 to 4 for each row."""
        return 1 << self.height.bit_length() + 1

    @property
    def buckets(self) -> int:
        """Number of buckets of the guide to the columns of a row: 1 for 2 to 4 columns, and at least 2."""
        return 1 << max(self.width.bit_length() - 2, 1)

    @property
    def row_bytes(self) -> int:
        """Size of the shares and of the guide of one row, in bytes."""
        return 4 * (self.width + 1 + self.buckets + 1)

    @property
    def columns_at(self) -> int:
        """Bytes before the shares of the first row: the header, the rows and the guide to the rows."""
        return 8 * (HEADER + ROW * self.height) + 4 * (self.row_buckets + 1)

    @property
    def pixels_at(self) -> int:
        """Bytes before the luminances."""
        return self.columns_at + self.row_bytes * self.height

    @property
    def bytes(self) -> int:
        """Size of the table in bytes."""
        return self.pixels_at + 4 * self.pixels


def _fill_rows(rows: np.ndarray, sums: np.ndarray, angles: np.ndarray, width: int) -> None:
    """Write the (H, 8) float64 of the rows from the sum of the luminances of each row and the angles at its edges."""
    height = len(sums)
    edges = np.square(np.sin(0.5 * angles))
    share = divide_steps((sums * solid_angles(angles, width))[None], ROW_STEPS)[0] / ROW_STEPS
    size, lit = np.diff(edges), share[1:] > share[:-1]
    sine = 2.0 * np.sqrt(edges * (1.0 - edges))
    rows[:, 0], rows[:, 1], rows[:, 2], rows[:, 3] = share[:-1], share[1:], edges[:-1], size
    rows[:, 4] = np.divide(1.0, np.diff(share), out=np.zeros(height), where=lit)
    rows[:, 5] = np.diff(share) * (width / (COLUMN_STEPS * 4.0 * pi)) / size
    rows[:, 6] = np.minimum(0.5 * MARGIN * np.maximum(sine[:-1], sine[1:]) / size, 0.5)
    # About a pole the azimuth of a float32 direction is lost: there draws keep off the pole, too.
    pole = np.square(np.sin(0.5 * np.minimum(MARGIN * width / pi, MOST_OF_POLAR_ROW * np.diff(angles)[[0, -1]])))
    rows[[0, -1], 6] = np.minimum(np.maximum(rows[[0, -1], 6], pole / size[[0, -1]]), 0.5)


@dataclass(frozen=True)
class Views:
    """Parts of a table, as arrays that share its memory; see the top of this file.

    Attributes:
        header: (10,) float64, numbers.
        frame: (9,) float64, frame of the picture with its axes in columns.
        rows: (H, 8) float64.
        guide: (row_buckets + 1,) int32, guide to the rows.
        columns: (H, W + 1 + buckets + 1) uint32, the shares of pixels and the guides to them.
        pixels: (pixels,) float32, luminances.
    """

    header: np.ndarray
    frame: np.ndarray
    rows: np.ndarray
    guide: np.ndarray
    columns: np.ndarray
    pixels: np.ndarray

    @classmethod
    def of(cls, table: np.ndarray, layout: Layout) -> "Views":
        """Return the parts of a table, given as bytes, as arrays that share its memory."""
        begin, guide, end = 8 * HEADER, 8 * (HEADER + ROW * layout.height), layout.columns_at
        return cls(
            table[: 8 * FRAME].view(np.float64),
            table[8 * FRAME : begin].view(np.float64)[:9],
            table[begin:guide].view(np.float64).reshape(layout.height, ROW),
            table[guide:end].view(np.int32),
            table[end : layout.pixels_at].view(np.uint32).reshape(layout.height, -1),
            table[layout.pixels_at : layout.bytes].view(np.float32),
        )


def build_table(weights: np.ndarray, frame: np.ndarray, angles: np.ndarray, pixels: int = 0) -> tuple[np.ndarray, Views]:
    """Build the table of a picture, as bytes; return it and its parts.

    Args:
        weights: (H, W) float32, densities of the pixels in any unit, at least 0, with a number above 0.
        frame: (3, 3) float64, matrix from world coordinates to the picture's frame.
        angles: (H + 1,) float64, angles to the pole of row 0 at the edges of rows.
        pixels: number of luminances, which are left 0.
    """
    height, width = weights.shape
    layout = Layout(height, width, pixels)
    table = np.zeros(layout.bytes // 8 + 1).view(np.uint8)
    views, sums = Views.of(table, layout), np.empty(height)
    margin, shift = MARGIN * width / (2.0 * pi), 33 - layout.buckets.bit_length()
    views.header[:6] = height, width, layout.buckets, 1.0 / width, layout.columns_at, margin
    views.header[6:9] = layout.row_buckets, shift, layout.pixels_at
    views.frame[:] = frame.T.ravel()
    for row in range(height):  # one row at a time: a float64 copy of a large picture needs 300 MB
        line = weights[row].astype(np.float64)
        steps = divide_steps(line[None], COLUMN_STEPS)[0]
        views.columns[row, : width + 1] = steps.astype(np.uint32)
        views.columns[row, width + 1 :] = _guide(steps[1:] / 2.0**32, (COLUMN_STEPS - 1) / 2.0**32, layout.buckets)
        sums[row] = line.sum()
    _fill_rows(views.rows, sums, angles, width)
    views.guide[:] = _guide(views.rows[:, 1], 1.0 - 0.5 / ROW_STEPS, layout.row_buckets)
    return table, views


def read_shares(table: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return cumulative shares of the rows, (H + 1,) float64 from 0 to 1, and of each row's pixels, (H, W + 1)."""
    height, width = (int(size) for size in table[:16].view(np.float64))
    views = Views.of(table, Layout(height, width))
    return np.append(views.rows[:, 0], views.rows[-1, 1]), views.columns[:, : width + 1] / float(COLUMN_STEPS)
