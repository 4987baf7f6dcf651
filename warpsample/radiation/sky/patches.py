"""Patches of the sky as Radiance counts them: Tregenza's 145, and Reinhart's finer subdivisions.

A row of patches lies between two altitudes. Each patch is centred on an azimuth, clockwise from north, so that the first
patch of a row straddles north. The last patch is a cap around the zenith.
"""

from dataclasses import dataclass
from functools import lru_cache
from typing import Any, ClassVar

import numpy as np
from numpy.typing import NDArray

from warpsample.host.arguments import check_choice, quote
from warpsample.host.arrays import as_unit
from warpsample.host.locks import multiply, read_only
from warpsample.host.summary import Summary

MULTIPLES = {"tregenza": 1, "reinhart2": 2, "reinhart4": 4}
"""Radiance's subdivision factor MF by name: number of rows, and of columns, that replace one of Tregenza's."""

_COLUMNS = (30, 30, 24, 24, 18, 12, 6)  # of Tregenza's rows, from the horizon on
_PARALLEL = 1e-9  # least sine of the angle between up and north


@dataclass(frozen=True, eq=False, repr=False)
class SkyPatches(Summary):
    """Patches into which the sky is divided, row by row from the horizon to the zenith, each with direction and size.

    Patch k is Radiance's sky patch k + 1, row k + 1 of its matrices. Radiance's row 0, the ground, is not included.

    Attributes:
        name: "tregenza", "reinhart2" or "reinhart4".
        up: Unit vector towards the zenith.
        north: Unit vector towards north, perpendicular to `up`.
        directions: (K, 3) float64, unit vectors towards the centres, in the coordinates of `up` and `north`.
        solid_angles: (K,) float64, in steradians, with the sum 2 pi.
        rows: (K,) int64, row of each patch, 0 at the horizon.
        altitudes: (K, 2) float64, altitude of the lower and the upper edge, in degrees.
        azimuths: (K, 2) float64, azimuths of the two sides, in degrees clockwise from north; the first patch of a row begins
            below 0.
    """

    name: str
    up: tuple[float, float, float]
    north: tuple[float, float, float]
    directions: NDArray[np.float64]
    solid_angles: NDArray[np.float64]
    rows: NDArray[np.int64]
    altitudes: NDArray[np.float64]
    azimuths: NDArray[np.float64]

    _counted: ClassVar[str] = "patches"

    def __len__(self) -> int:
        """Return the number of sky patches."""
        return len(self.solid_angles)

    @property
    def frame(self) -> np.ndarray:
        """Unit vectors towards east, north and up, as a (3, 3) float64 array."""
        return np.array([np.cross(self.north, self.up), self.north, self.up])


def sky_patches(name: str = "tregenza", *, up: Any = (0.0, 0.0, 1.0), north: Any = (0.0, 1.0, 0.0)) -> SkyPatches:
    """Return the patches into which the sky is divided, with directions and solid angles.

    Args:
        name: Set of patches, "tregenza" (145), "reinhart2" (577) or "reinhart4" (2,305), whose rows do not nest. Default:
            "tregenza".
        up: (3,) vector of any length towards the zenith. Default: (0.0, 0.0, 1.0).
        north: (3,) vector of any length, not along `up`; its part across `up` counts. East is north x up. Default:
            (0.0, 1.0, 0.0).

    Returns:
        the patches' directions, solid angles, rows and edges.

    Raises:
        TypeError, ValueError: an unknown name, a vector that is no direction, or a north along up.

    Example:
        >>> patches = ws.sky_patches("tregenza")
        >>> print(len(patches), patches.directions[[0, 144]].round(3).tolist(), f"{patches.solid_angles.sum():.4f}")
        145 [[0.0, 0.995, 0.105], [0.0, 0.0, 1.0]] 6.2832
    """
    multiple = MULTIPLES[check_choice(name, "patches", tuple(MULTIPLES))]
    zenith = np.array(as_unit(up, "up"))
    towards = np.array(as_unit(north, "north"))
    towards -= (towards @ zenith) * zenith
    length = np.linalg.norm(towards)
    if length < _PARALLEL:
        wants = f"a direction not parallel to up {quote(up)}, such as (0, 0, -1) for up = (0, 1, 0)"
        raise ValueError(f"north: got {quote(north)}, which is along up, want {wants}")
    return _patches_of(name, multiple, zenith.tobytes(), (towards / length).tobytes())


def patches_at(sky: SkyPatches, directions: np.ndarray) -> np.ndarray:
    """Return the number of the sky patch that contains each of (M, 3) unit directions, (M,) int64; -1 below the horizon."""
    east, north, up = multiply(sky.frame, directions.T.astype(np.float64))
    number = np.bincount(sky.rows)
    first = np.cumsum(number) - number
    row = np.searchsorted(np.sin(np.radians(sky.altitudes[first[1:], 0])), up, side="right")
    turns = np.arctan2(east, north) / (2.0 * np.pi)
    column = np.floor(turns * number[row] + 0.5).astype(np.int64) % number[row]
    return np.where(up < 0.0, -1, first[row] + column)


@lru_cache(maxsize=8)
def _patches_of(name: str, multiple: int, up: bytes, north: bytes) -> SkyPatches:
    """Return the sky patches for checked arguments, from a cache if possible."""
    zenith, towards = np.frombuffer(up), np.frombuffer(north)
    rows, low, high, first, last = _compute_edges(multiple)
    middle, across = np.radians(0.5 * (low + high)), np.radians(0.5 * (first + last))
    middle[-1] = 0.5 * np.pi
    local = np.stack([np.cos(middle) * np.sin(across), np.cos(middle) * np.cos(across), np.sin(middle)], axis=1)
    local[-1] = (0.0, 0.0, 1.0)
    frame = np.array([np.cross(towards, zenith), towards, zenith])
    solid = np.radians(last - first) * (np.sin(np.radians(high)) - np.sin(np.radians(low)))
    solid[-1] = 4.0 * np.pi * np.square(np.sin(0.5 * np.radians(90.0 - low[-1])))
    arrays = local @ frame, solid, rows, np.stack([low, high], axis=1), np.stack([first, last], axis=1)
    return SkyPatches(name, tuple(zenith.tolist()), tuple(towards.tolist()), *(read_only(array) for array in arrays))


def _compute_edges(multiple: int) -> tuple[np.ndarray, ...]:
    """Return the edges of all sky patches in degrees: row, lower and upper altitude, first and last azimuth."""
    columns = np.array([*(np.repeat(_COLUMNS, multiple) * multiple), 1])
    step = 90.0 / (len(columns) - 0.5)
    rows = np.repeat(np.arange(len(columns)), columns)
    width = 360.0 / columns[rows]
    centre = width * (np.arange(len(rows)) - np.repeat(np.cumsum(columns) - columns, columns))
    return rows, rows * step, np.minimum((rows + 1) * step, 90.0), centre - 0.5 * width, centre + 0.5 * width
