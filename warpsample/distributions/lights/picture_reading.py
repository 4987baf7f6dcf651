"""Distribution of directions by the bilinear reading of a picture of the whole sphere, for rays towards distant light."""

from dataclasses import dataclass
from typing import Any, ClassVar

import numpy as np
import warp as wp

from warpsample.distributions.lights.environment_map import EnvironmentMap, build_about_world
from warpsample.distributions.lights.pixel_draws import aim_at, angle_of, azimuth_of, cap_of, in_picture, pixel_finder
from warpsample.distributions.lights.pixel_table import HEADER, MOST_STEPS, ROW, build_table, pixel_angles, read_density
from warpsample.distributions.record import Maps
from warpsample.host.locks import once
from warpsample.maths.numerics import HALF, ONE, ZERO

_LEAST = wp.constant(wp.float32(1e-30))


@wp.func
def _ramp(u: wp.float32, start: wp.float32, end: wp.float32) -> wp.float32:
    """Map u to [0, 1] with a density that runs linearly from `start` to `end`, two numbers in any unit (Pharr2023, A.4)."""
    slant = start + wp.sqrt(start * start + u * (end * end - start * start))
    return wp.min(u * (start + end) / wp.max(slant, _LEAST), 1.0)


@wp.func
def _luminance_at(table: wp.uint64, row: wp.int32, column: wp.int32, width: wp.int32) -> wp.float32:
    """Return the luminance of the pixel (row, column) relative to the brightest pixel of the picture."""
    header = wp.array(ptr=table, shape=(HEADER,), dtype=wp.float64)
    pixels = wp.array(ptr=table + wp.uint64(header[7]), shape=(width,), dtype=wp.uint32)
    return wp.cast(pixels[row * width + column], wp.float32)


@wp.func
def _corners_of(table: wp.uint64, row: wp.int32, column: wp.int32) -> wp.vec4:
    """Return the luminances at the corners of a cell between the middles of pixels: upper left, upper right, lower two."""
    header = wp.array(ptr=table, shape=(HEADER,), dtype=wp.float64)
    width = wp.int32(header[1])
    upper = wp.max(row - 1, 0)
    lower = wp.min(row, wp.int32(header[0]) - 2)
    right = wp.where(column + 1 < width, column + 1, 0)
    return wp.vec4(
        _luminance_at(table, upper, column, width),
        _luminance_at(table, upper, right, width),
        _luminance_at(table, lower, column, width),
        _luminance_at(table, lower, right, width),
    )


@wp.func
def _density_in(corners: wp.vec4, down: wp.float32, across: wp.float32, table: wp.uint64) -> wp.float32:
    """Return the density at a place in a cell, per steradian: bilinear between the luminances at the corners."""
    header = wp.array(ptr=table, shape=(HEADER,), dtype=wp.float64)
    upper = corners[0] + across * (corners[1] - corners[0])
    lower = corners[2] + across * (corners[3] - corners[2])
    return wp.float32(wp.float64(upper + down * (lower - upper)) * header[9])


@once
def reading_drawer(steps: int) -> wp.Function:
    """Build the wp.func that maps a point of the unit square to (world direction, density); see `pixel_finder`."""
    find_pixel = pixel_finder(steps)

    @wp.func
    def draw(u: wp.vec2, table: wp.uint64):
        row, column, down, across, _steps = find_pixel(u, table)
        c = _corners_of(table, row, column)
        below = _ramp(wp.float32(down), c[0] + c[1], c[2] + c[3])
        after = _ramp(across, c[0] + below * (c[2] - c[0]), c[1] + below * (c[3] - c[1]))
        d, lower, right = aim_at(row, column, wp.float64(below), after, table)
        return wp.vec4(d[0], d[1], d[2], _density_in(c, wp.float32(lower), right, table))

    return draw


_draw = reading_drawer(MOST_STEPS)


@wp.func
def square_to_reading(u: wp.vec2, table: wp.uint64) -> wp.vec3:
    """Map a point of the unit square to a direction towards a picture, in world coordinates, by the picture's reading."""
    d = _draw(u, table)
    return wp.vec3(d[0], d[1], d[2])


@wp.func
def square_to_reading_pdf(w: wp.vec3, table: wp.uint64) -> wp.float32:
    """Return the density of a picture's reading at a world direction w, per steradian; 0 where it is black or w is NaN."""
    if not (w[0] == w[0] and w[1] == w[1] and w[2] == w[2]):
        return 0.0
    header = wp.array(ptr=table, shape=(HEADER,), dtype=wp.float64)
    o = in_picture(w, table)
    rows = wp.int32(header[0])
    row = wp.min(wp.int32(angle_of(o) * (header[0] - ONE) + HALF), rows - 1)
    part = azimuth_of(o) * header[1]
    column = wp.min(wp.int32(part), wp.int32(header[1]) - 1)
    lines = wp.array(ptr=table + wp.uint64(8 * HEADER), shape=(ROW * rows,), dtype=wp.float64)
    down = wp.clamp((cap_of(o) - lines[ROW * row + 2]) / lines[ROW * row + 3], ZERO, ONE)
    across = wp.clamp(part - wp.float64(column), ZERO, ONE)
    return _density_in(_corners_of(table, row, column), wp.float32(down), wp.float32(across), table)


@dataclass(frozen=True)
class PictureReading(EnvironmentMap):
    """Directions towards a picture by its bilinear reading, as `irradiance` reads pictures: between the middles of pixels.

    The density is bilinear in the azimuth and in the cosine of the angle to `up`. The reading is bilinear in the angle
    itself, which differs most beside the poles. The density is above 0 where the reading is, and only there.

    Attributes:
        picture, up, north: as for `EnvironmentMap`.
    """

    name = "picture_reading"
    density = "bilinear in luminance / Σ luminance Ω"
    limits = ""
    maps: ClassVar[Maps] = Maps(square_to_reading, square_to_reading_pdf, draw=_draw, about=build_about_world(_draw))
    _drawer: ClassVar[Any] = staticmethod(reading_drawer)

    @property
    def jumps(self) -> tuple[float, ...]:
        """Angles in radians at which the density bends: the middles of rows."""
        return tuple(self._angles()[1:-1].tolist())

    @property
    def per_luminance(self) -> float:
        """Density at a luminance of 1, in the picture's unit."""
        return read_density(self.table_array) / float(self.picture.max())

    def _angles(self) -> np.ndarray:
        """Return the angles at the edges of the rows of cells: the poles, and the middles of the picture's rows."""
        edges = pixel_angles(2 * len(self.picture))
        return np.concatenate([edges[:1], edges[1::2], edges[-1:]])

    def _build_table(self) -> np.ndarray:
        """Build the table of the cells between the middles of pixels, with their mean luminances as weights."""
        pixels = self.picture / self.picture.max()
        rows = np.concatenate([pixels[:1], pixels, pixels[-1:]])
        cells = rows[:-1] + rows[1:]
        cells = 0.25 * (cells + np.roll(cells, -1, axis=1))
        # Where the mean underflows: a cell with a lit corner must be drawn.
        lit = rows > 0.0
        lit = lit[:-1] | lit[1:]
        cells[(lit | np.roll(lit, -1, axis=1)) & (cells == 0.0)] = np.finfo(np.float32).smallest_subnormal
        half = np.pi / pixels.shape[1]  # of a column, by which cells begin later than pixels
        turn = np.array([[np.cos(half), np.sin(half), 0.0], [-np.sin(half), np.cos(half), 0.0], [0.0, 0.0, 1.0]])
        return build_table(cells, turn @ self.frame, self._angles(), pixels)
