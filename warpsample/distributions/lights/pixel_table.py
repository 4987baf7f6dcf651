"""Table from which kernels draw pixels of a picture of the sphere, each with the share of its luminance and solid angle.

The table is one block of memory, so that a kernel needs one address:

- 20 float64: the numbers of rows and columns, 1 / columns, the margin of the azimuth in pixels at the equator, the number
  of buckets of rows, the bytes before the shares, the guides and the luminances, the steps of a search, and the density of
  a luminance of 1; from number 10 on the frame of the picture (x and y: azimuth, z: row 0, in columns).
- For each row 8 float64, a cache line: cumulative share at its start and end, sin^2(theta / 2) at its start and the
  difference to its end, 1 / the row's share, the density of one step of a pixel, the margin at both edges as a fraction,
  and the place of its guide among the guides, plus the bits of a step below its bucket as a 64th.
- For each row W + 1 uint32, the cumulative shares of its pixels as multiples of 1 / COLUMN_STEPS.
- The guides, int32. The first is that to the rows: the first row that each bucket of u[0] can reach, and the last row of
  all. Then for each row that to its columns: the first that each bucket of u[1] can reach, and the last of all.
- For `PictureReading` the luminances of the picture's pixels relative to the brightest, float32.

A guide leaves few entries to search (Chen1974). Its number of buckets is a power of 2, so that a bucket is found without
rounding, and is doubled until at most 2^FEW_STEPS entries are left in each bucket, or until it is 2^16. The shares are
integers: the density is computed from the same integers as the draws. Every pixel with a luminance above 0 has at least one
step, all others none.

Kernels take no float32 from the table as such: a compiler that knows that the float32 that a loop stores do not overlap the
table can vectorise the loop.
"""

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

FEW_STEPS, MOST_STEPS = 5, 15
"""Steps of a search among the entries of a bucket: for pictures whose guides leave few, and for all pictures."""

MOST_PIXELS = 2**MOST_STEPS
"""Largest number of rows or columns of a table."""

_MOST_BITS, _SPARE = 16, 4  # of the number of a row's buckets; entries of all guides for each pixel, before they stay short


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


def _build_guide(ends: np.ndarray, last: float, most_bits: int = _MOST_BITS) -> np.ndarray:
    """Return the first entry that each bucket can reach, and the last entry that is reached at all, (buckets + 1,) int32.

    Args:
        ends: (N,) cumulative shares at the end of each entry, ascending, at most 1.
        last: largest share that is searched for.
        most_bits: largest base-2 logarithm of the number of buckets. Default: 16.
    """
    fewest = max(len(ends).bit_length() - 2, 1)
    for bits in range(fewest, max(fewest, most_bits) + 1):
        first = np.minimum(np.arange((1 << bits) + 1) / (1 << bits), last)
        guide = np.minimum(np.searchsorted(ends, first, side="right"), len(ends) - 1).astype(np.int32)
        if np.diff(guide).max() < 1 << FEW_STEPS:
            break
    return guide


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


def build_table(
    weights: np.ndarray, frame: np.ndarray, angles: np.ndarray, luminance: np.ndarray | None = None
) -> np.ndarray:
    """Build the table of a picture, as bytes.

    Args:
        weights: (H, W) float32, densities of the pixels in any unit, at least 0, with a number above 0.
        frame: (3, 3) float64, matrix from world coordinates to the picture's frame.
        angles: (H + 1,) float64, angles to the pole of row 0 at the edges of rows.
        luminance: float32 luminances to keep in the table. Default: None.
    """
    height, width = weights.shape
    rows, sums, guides = np.zeros((height, ROW)), np.empty(height), []
    shares, spare = np.empty((height, width + 1), np.uint32), _SPARE * weights.size
    for row in range(height):  # one row at a time: a float64 copy of a large picture needs 300 MB
        line = weights[row].astype(np.float64)
        steps = divide_steps(line[None], COLUMN_STEPS)[0]
        shares[row] = steps
        guides.append(_build_guide(steps[1:] / 2.0**32, (COLUMN_STEPS - 1) / 2.0**32, _MOST_BITS if spare > 0 else 0))
        spare -= len(guides[-1])
        sums[row] = line.sum()
    _fill_rows(rows, sums, angles, width)
    guides.insert(0, _build_guide(rows[:, 1], 1.0 - 0.5 / ROW_STEPS))
    lengths = np.array([len(guide) for guide in guides])
    bits = np.log2(lengths - 1)
    rows[:, 7] = np.cumsum(lengths)[:-1] + (32.0 - bits[1:]) / 64.0
    pixels = np.zeros(0, np.float32) if luminance is None else luminance
    parts = [np.zeros(HEADER), rows, shares, *guides, pixels]
    sizes = [part.nbytes for part in parts]
    starts = np.cumsum([0, *sizes])
    few = max(int(np.diff(guide).max()) for guide in guides) < 1 << FEW_STEPS
    parts[0][:4] = height, width, 1.0 / width, MARGIN * width / (2.0 * pi)
    parts[0][4:9] = lengths[0] - 1, starts[2], starts[3], starts[-2], FEW_STEPS if few else MOST_STEPS
    parts[0][9] = 1.0 / float(sums @ solid_angles(angles, width))
    parts[0][FRAME : FRAME + 9] = frame.T.ravel()
    table = np.empty(starts[-1] // 8 + 1).view(np.uint8)
    for start, part in zip(starts, parts, strict=False):
        table[start : start + part.nbytes] = part.reshape(-1).view(np.uint8)
    return table


def read_shares(table: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return cumulative shares of the rows, (H + 1,) float64 from 0 to 1, and of each row's pixels, (H, W + 1)."""
    height, width = (int(size) for size in table[:16].view(np.float64))
    first, end = 8 * HEADER, 8 * (HEADER + ROW * height)
    rows = table[first:end].view(np.float64).reshape(height, ROW)
    shares = table[end : end + 4 * height * (width + 1)].view(np.uint32).reshape(height, width + 1)
    return np.append(rows[:, 0], rows[-1, 1]), shares / float(COLUMN_STEPS)


def read_steps(table: np.ndarray) -> int:
    """Return the number of steps of a search in the table, `FEW_STEPS` or `MOST_STEPS`."""
    return int(table[: 8 * HEADER].view(np.float64)[8])


def read_density(table: np.ndarray) -> float:
    """Return the density of a luminance of 1, the unit of the weights from which the table was built."""
    return float(table[: 8 * HEADER].view(np.float64)[9])
