"""Tree crowns over a raster of heights: one closed prism per cell, from the crown's base to its top."""

import warnings
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, replace
from numbers import Real
from typing import Any

import numpy as np

from warpsample.city.rasters.grid import Grid
from warpsample.city.rasters.sources.reader import RasterReader
from warpsample.city.rasters.sources.reading import reader_of
from warpsample.city.rasters.sources.reference import is_same_crs
from warpsample.host.arguments import check_flag, check_number, quote

_SIDES = (((0, 1), (1, 1), (1, 0)), ((-1, 0), (1, 0), (0, 0)), ((0, -1), (0, 0), (0, 1)), ((1, 0), (0, 1), (1, 1)))
"""Sides of a cell, in a raster with north at the top: offset of the neighbour, (rows, columns), and both ends of the edge,
(columns, rows). The first end is the left one, seen from the neighbour."""

_RING = ((0, 0), (0, 1), (1, 1), (1, 0))
"""Corners of a cell, (columns, rows), counter-clockwise seen from above in a raster with north at the top."""

TRUNK = 0.25
"""Default height of a crown's underside, as a fraction of the crown's height, as in SOLWEIG."""

_THINNEST = 0.01
"""Thickness of the thinnest crown in metres. Elevations of bare ground may differ from those of the raster by rounding."""

_ALL = slice(None)
_OFF = 0.01
"""Largest distance, in cells, between corners of two rasters on the same cells: some files round their transforms."""


@dataclass(frozen=True, eq=False)
class Crowns:
    """Bases and tops of tree crowns, at most one crown per cell.

    Attributes:
        base: (rows, columns) float64 elevations of the undersides; NaN without a crown.
        top: (rows, columns) float64 elevations of the tops, above `base`; NaN without a crown.
    """

    base: np.ndarray
    top: np.ndarray

    @property
    def any(self) -> bool:
        """True if there is at least one tree crown."""
        return bool((~np.isnan(self.top)).any())


@dataclass(frozen=True, eq=False)
class Canopy:
    """Input rasters of tree crowns (tops and trunk heights), checked but not read yet.

    Attributes:
        top: Raster of the crowns' tops, on the cells of the ground.
        trunk: Height of the undersides above the ground, as a fraction of the crown's height or as another raster.
        relative: True if both rasters are heights above the ground, False for elevations. With elevations, cells that are 0
            or not above the ground have no crown.
    """

    top: RasterReader
    trunk: float | RasterReader
    relative: bool

    @classmethod
    def of(cls, ground: RasterReader, canopy: Any, trunk: Any, relative: Any) -> "Canopy | None":
        """Check the rasters of tree crowns over a raster of the ground; return a Canopy, or None if `canopy` is None.

        The arguments `canopy`, `trunk` and `relative` are those of `surface`.

        Raises:
            TypeError, ValueError, FileNotFoundError: Invalid rasters, or rasters with other cells; the message names the
                argument.
        """
        relative = check_flag(relative, "relative")
        if canopy is None:
            check_for_crowns("trunk", trunk, TRUNK)
            check_for_crowns("relative", relative, True)
            return None
        share = (
            check_number(trunk, "trunk", 0.0, 1.0)
            if isinstance(trunk, Real)
            else _read_on_same_cells(ground, trunk, "trunk")
        )
        return cls(_read_on_same_cells(ground, canopy, "canopy"), share, relative)

    def crowns(self, grid: Grid, rows: slice = _ALL, columns: slice = _ALL) -> Crowns:
        """Read the bases and tops of the tree crowns in the given rows and columns.

        Raises:
            ValueError: Heights below 0.

        Warns:
            UserWarning: Crowns without an underside, which reach down to the ground, or with an underside not below the top,
                which are left out.
        """
        top = self.top.read(rows, columns)
        if self.relative and (top < 0.0).any():
            raise ValueError(
                f"canopy: got heights from {np.nanmin(top):g} to {np.nanmax(top):g}, want heights above the ground, 0 where "
                "there are no crowns; relative=False takes elevations"
            )
        ground = grid.height if self.relative else 0.0
        least = grid.height + _THINNEST / grid.metres
        top = np.where((top != 0.0) & (ground + top > least), ground + top, np.nan)
        if isinstance(self.trunk, RasterReader):
            trunk = self.trunk.read(rows, columns)
            if (bottomless := np.isnan(trunk) & ~np.isnan(top)).any():
                warnings.warn(
                    f"trunk: got no height for {bottomless.sum():,} crowns, which then reach down to the ground",
                    stacklevel=3,
                )
            base = np.fmax(ground + trunk, grid.height)
        else:
            base = grid.height + self.trunk * (top - grid.height)
        hollow = ~np.isnan(top) & ~(base < top)
        if hollow.any():
            warnings.warn(
                f"trunk: got undersides at or above the tops of {hollow.sum():,} crowns, which are left out", stacklevel=3
            )
        none = hollow | np.isnan(top)
        return Crowns(np.where(none, np.nan, base), np.where(none, np.nan, top))


def build_prisms(grid: Grid, crowns: Crowns) -> tuple[np.ndarray, np.ndarray]:
    """Build one closed prism per tree crown; return (V, 3) float64 vertices and (F, 3) int32 faces, facing outwards.

    There are no walls between neighbouring crowns, so that crowns of equal base and top form one prism.
    """
    cells = np.flatnonzero(~np.isnan(crowns.top))
    row, column = np.divmod(cells, crowns.top.shape[1])
    base, top = crowns.base.ravel()[cells], crowns.top.ravel()[cells]
    ring = [(column + i, row + j) for i, j in _RING]
    quads = [_place_quadrilaterals(grid, ring, [top] * 4), _place_quadrilaterals(grid, ring[::-1], [base] * 4)]
    padded = (np.pad(heights, 1, constant_values=np.nan) for heights in (crowns.base, crowns.top))
    around = [np.where(np.isnan(heights), np.inf, heights) for heights in padded]
    for (down, right), *ends in _SIDES:
        other_base, other_top = (heights[row + 1 + down, column + 1 + right] for heights in around)
        left, end = ((column + i, row + j) for i, j in ends)
        for low, high in ((base, np.minimum(top, other_base)), (np.maximum(base, other_top), top)):
            wall = low < high
            foot, head = low[wall], high[wall]
            corners = [(at[0][wall], at[1][wall]) for at in (left, end, end, left)]
            quads.append(_place_quadrilaterals(grid, corners, [foot, foot, head, head]))
    vertices = np.concatenate(quads).reshape(-1, 3)
    first = 4 * np.arange(len(vertices) // 4, dtype=np.int32)[:, None]
    faces = (first + np.array([[0, 1, 2, 0, 2, 3]], np.int32)).reshape(-1, 3)
    return vertices, faces[:, ::-1] if grid.mirrored else faces


def _place_quadrilaterals(grid: Grid, corners: list[tuple[np.ndarray, np.ndarray]], heights: list[np.ndarray]) -> np.ndarray:
    """Return the map positions of N quadrilaterals, (N, 4, 3), from the columns, rows and heights of their corners."""
    return np.stack([grid.places(*at, height) for at, height in zip(corners, heights, strict=True)], axis=1)


def _read_on_same_cells(ground: RasterReader, source: Any, argument: str) -> RasterReader:
    """Open a raster of tree crowns, after a check that it has the same cells as the raster of the ground.

    Raises:
        TypeError, ValueError, FileNotFoundError: An invalid raster, or other cells; the message names the argument.
    """
    with rename_argument(argument):
        found = reader_of(source)
    shape, wanted = found.shape, ground.shape
    if shape != wanted:
        raise ValueError(
            f"{argument}: got {shape[0]} x {shape[1]} cells, want {wanted[0]} x {wanted[1]}, as in the raster of heights"
        )
    rows, columns = (np.array(corners) for corners in zip((0, 0), (0, shape[1]), (shape[0], 0), strict=True))
    off = found.outline.places(columns, rows, 0.0 * rows) - ground.outline.places(columns, rows, 0.0 * rows)
    if np.abs(off).max() > _OFF * min(ground.outline.sides):
        raise ValueError(
            f"{argument}: got cells that are {np.abs(off).max():g} away from the cells of the heights, want the same cells"
        )
    return as_on_map(ground, found, argument)


def check_for_crowns(argument: str, value: Any, default: float) -> None:
    """Raise a ValueError if an option of tree crowns differs from its default although no raster of crowns is given."""
    if not isinstance(value, Real) or value != default:
        raise ValueError(f"{argument}: got {quote(value)} without canopy, want canopy, the raster of tree crowns, too")


def as_on_map(ground: RasterReader, other: RasterReader, argument: str) -> RasterReader:
    """Return another raster with heights in the unit of the ground's map; a raster without a CRS is taken to be on this map.

    Raises:
        ValueError: Two different horizontal coordinate reference systems (CRS), or a ground without one whose heights are in
            another unit; the message names the argument.
    """
    if other.crs and ground.crs and not is_same_crs(other.crs.to_2d(), ground.crs.to_2d()):
        raise ValueError(f"{argument}: got coordinates of {other.crs.name}, want {ground.crs.name}, as the heights have")
    if ground.crs is None and ground.has_unit and abs(other.metres - 1.0) > 1e-5:
        raise ValueError(
            f"{argument}: got coordinates of {other.crs.name}, in units of {other.metres:g} m, want metres, as the raster "
            "of heights has no CRS; set its CRS"
        )
    if other.crs is None and other.has_unit:  # else heights are in the unit of the map already
        return replace(other, metres=ground.metres, factor=other.factor * other.metres / ground.metres)
    return other


@contextmanager
def rename_argument(argument: str) -> Iterator[None]:
    """Context manager that replaces "source: " by the name of another argument in errors and warnings raised inside."""

    def rename(message: Warning | Exception | str) -> str:
        return str(message).replace("source: ", f"{argument}: ", 1)

    heard: list[warnings.WarningMessage] = []
    try:
        with warnings.catch_warnings(record=True) as heard:
            warnings.simplefilter("always")
            yield
    except (TypeError, ValueError, FileNotFoundError) as error:
        raise type(error)(rename(error)) from error
    finally:
        for one in heard:
            warnings.warn_explicit(rename(one.message), one.category, one.filename, one.lineno)
