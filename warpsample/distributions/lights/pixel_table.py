"""Table from which kernels draw pixels of a picture of the sphere, each with the share of its luminance and solid angle.

The table is one block of memory, so that a kernel needs one address:

- 16 float64: the numbers of rows, columns and buckets, 1 / columns, the bytes before the shares, the margin of the azimuth
  in pixels at the equator; from number 8 on the frame of the picture, 9 float32 (x and y: azimuth, z: row 0, in columns).
- For each row 8 float64, a cache line: cumulative share at its start and end, sin^2(theta / 2) at its start and the
  difference to its end, 1 / the row's share, the density of one step of a pixel, and the margin at both edges as a fraction.
- The guide to the rows, int32: the first row that a bucket of u[0] can reach.
- For each row W + 1 uint32, the cumulative shares of its pixels as multiples of 1 / COLUMN_STEPS.
- For each row the guide to its columns, int32: the first column that a bucket of u[1] can reach.

A guide makes the search one or two steps on average, for any picture (Chen1974). The shares are integers: the density is
computed from the same integers as the draws. Every pixel with a luminance above 0 has at least one step, all others none.
"""

from dataclasses import dataclass
from math import pi

import numpy as np

COLUMN_STEPS = 2**32 - 1
"""Number of steps into which the light of a row is divided."""

ROW_STEPS = 2**48
"""Number of steps into which the light of a picture is divided among its rows."""

HEADER, FRAME, ROW = 16, 8, 8
"""Number of float64 in the header of the table, before the frame in the header, and for each row."""

MARGIN = 3e-7
"""Angle in radians that draws keep from the edges of their pixel: the rounding of float32 directions."""

MOST_OF_POLAR_ROW = 0.02
"""Largest part of the row at a pole, as an angle, that draws keep from the pole."""

COLUMNS_PER_BUCKET = 2
"""Columns for each bucket of the guide to the columns."""


def row_edges(height: int) -> np.ndarray:
    """Return sin^2(theta / 2) at the upper edge of each row and at the lower edge of the last, (H + 1,) float64."""
    return np.square(np.sin(0.5 * pi * np.arange(height + 1) / height))


def solid_angles(height: int, width: int) -> np.ndarray:
    """Return the solid angle of a pixel of each row, (H,) float64: 2 sin(middle) sin(pi / (2 H)) 2 pi / W, without loss."""
    middle = (np.arange(height) + 0.5) * (pi / height)
    return 4.0 * pi / width * np.sin(middle) * np.sin(0.5 * pi / height)


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


def _guide(ends: np.ndarray, steps: float, buckets: int, margin: float) -> np.ndarray:
    """Return the first entry that each bucket of [0, 1) can reach, (buckets,) int32, less a margin for rounding.

    Args:
        ends: (N,) cumulative steps at the end of each entry, ascending.
        steps: number of steps at u = 1.
        buckets: number of buckets.
        margin: steps by which a bucket begins early.
    """
    first = np.arange(buckets) * (steps / buckets) - margin
    return np.minimum(np.searchsorted(ends, first, side="right"), len(ends) - 1).astype(np.int32)


@dataclass(frozen=True)
class Layout:
    """Sizes and positions in the table of a picture.

    Attributes:
        height, width: numbers of rows and columns.
        buckets: number of buckets of the guide to the columns of a row.
    """

    height: int
    width: int
    buckets: int

    @classmethod
    def of(cls, height: int, width: int) -> "Layout":
        """Return the layout for a picture of a height and a width."""
        return cls(height, width, max(width // COLUMNS_PER_BUCKET, 1))

    @property
    def row_bytes(self) -> int:
        """Size of the shares and of the guide of one row, in bytes."""
        return 4 * (self.width + 1 + self.buckets)

    @property
    def columns_at(self) -> int:
        """Bytes before the shares of the first row: the header, the rows and the guide to the rows."""
        return 8 * (HEADER + ROW * self.height) + 4 * self.height

    @property
    def bytes(self) -> int:
        """Size of the table in bytes."""
        return self.columns_at + self.row_bytes * self.height


def _fill_rows(rows: np.ndarray, sums: np.ndarray, width: int) -> None:
    """Write the (H, 8) float64 of the rows from the sum of the luminances of each row."""
    height = len(sums)
    edges = row_edges(height)
    share = divide_steps((sums * solid_angles(height, width))[None], ROW_STEPS)[0] / ROW_STEPS
    size, lit = np.diff(edges), share[1:] > share[:-1]
    sine = 2.0 * np.sqrt(edges * (1.0 - edges))
    rows[:, 0], rows[:, 1], rows[:, 2], rows[:, 3] = share[:-1], share[1:], edges[:-1], size
    rows[:, 4] = np.divide(1.0, np.diff(share), out=np.zeros(height), where=lit)
    rows[:, 5] = np.diff(share) * (width / (COLUMN_STEPS * 4.0 * pi)) / size
    rows[:, 6] = np.minimum(0.5 * MARGIN * np.maximum(sine[:-1], sine[1:]) / size, 0.5)
    # About a pole the azimuth of a float32 direction is lost: there draws keep off the pole, too.
    pole = np.square(np.sin(0.5 * min(MARGIN * width / pi, MOST_OF_POLAR_ROW * pi / height)))
    rows[[0, -1], 6] = np.minimum(np.maximum(rows[[0, -1], 6], pole / size[[0, -1]]), 0.5)


@dataclass(frozen=True)
class Views:
    """Parts of a table, as arrays that share its memory; see the top of this file.

    Attributes:
        header: (16,) float64, numbers.
        frame: (9,) float32, frame of the picture with its axes in columns.
        rows: (H, 8) float64.
        guide: (H,) int32, guide to the rows.
        columns: (H, W + 1 + buckets) uint32, the shares of pixels and the guides to them.
    """

    header: np.ndarray
    frame: np.ndarray
    rows: np.ndarray
    guide: np.ndarray
    columns: np.ndarray

    @classmethod
    def of(cls, table: np.ndarray, layout: Layout) -> "Views":
        """Return the parts of a table, given as bytes, as arrays that share its memory."""
        begin, end = 8 * HEADER, layout.columns_at
        return cls(
            table[:begin].view(np.float64),
            table[8 * FRAME : begin].view(np.float32)[:9],
            table[begin : end - 4 * layout.height].view(np.float64).reshape(layout.height, ROW),
            table[end - 4 * layout.height : end].view(np.int32),
            table[end : layout.bytes].view(np.uint32).reshape(layout.height, -1),
        )


def build_table(luminance: np.ndarray, frame: np.ndarray) -> np.ndarray:
    """Build the table of a picture, as bytes.

    Args:
        luminance: (H, W) float32, at least 0, with a number above 0.
        frame: (3, 3) float64, matrix from world coordinates to the picture's frame.
    """
    height, width = luminance.shape
    layout = Layout.of(height, width)
    table = np.zeros(layout.bytes // 8 + 1).view(np.uint8)
    views, sums = Views.of(table, layout), np.empty(height)
    views.header[:6] = height, width, layout.buckets, 1.0 / width, layout.columns_at, MARGIN * width / (2.0 * pi)
    views.frame[:] = frame.T.ravel()
    for row in range(height):  # one row at a time: a float64 copy of a large picture needs 300 MB
        line = luminance[row].astype(np.float64)
        steps = divide_steps(line[None], COLUMN_STEPS)[0]
        views.columns[row, : width + 1] = steps.astype(np.uint32)
        views.columns[row, width + 1 :] = _guide(steps[1:], COLUMN_STEPS, layout.buckets, 2.0)
        sums[row] = line.sum()
    _fill_rows(views.rows, sums, width)
    views.guide[:] = _guide(views.rows[:, 1], 1.0, height, 1e-12)
    return table


def read_shares(table: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return cumulative shares of the rows, (H + 1,) float64 from 0 to 1, and of each row's pixels, (H, W + 1)."""
    height, width = (int(size) for size in table[:16].view(np.float64))
    views = Views.of(table, Layout.of(height, width))
    return np.append(views.rows[:, 0], views.rows[-1, 1]), views.columns[:, : width + 1] / float(COLUMN_STEPS)
