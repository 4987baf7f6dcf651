"""Maps between points of the unit square and directions towards a picture, by the table of its pixels."""

import warp as wp

from warpsample.distributions.lights.pixel_table import COLUMN_STEPS, FRAME, HEADER, MOST_STEPS, ROW
from warpsample.host.locks import once
from warpsample.maths.frames import to_world
from warpsample.maths.numerics import (
    GRID,
    HALF,
    INV_PI_DOUBLE,
    INV_TWO_PI_DOUBLE,
    ONE,
    TWO,
    ZERO,
    clamp_uniform,
    fma,
    polish,
    root_double,
    sincos_eighth,
)
from warpsample.sequences.hashing import finalise

_GRID_SIZE = wp.constant(wp.float32(GRID))
_FINE_STEP = wp.constant(wp.float64(2.0**-56))
_OTHER = wp.constant(wp.uint32(0x9E3779B9))
_STEPS = wp.constant(wp.float64(COLUMN_STEPS))
_PER_STEPS = wp.constant(wp.float64(1.0 / COLUMN_STEPS))
_QUARTER = wp.constant(wp.float64(0.25))
_FOUR = wp.constant(wp.float64(4.0))
_SIXTY_FOUR = wp.constant(wp.float64(64.0))
_HALF_ROOT = wp.constant(wp.float32(0.7071067811865476))


@wp.func
def _widened(u: wp.vec2) -> wp.vec2d:
    """Return a point of the square with 52 bits per coordinate: the 24 bits of u, and bits from a hash of both coordinates.

    The lower bits reach pixels whose share is below 2^-24, and move no point across a stratum of that size.
    """
    first = wp.uint32(wp.int32(u[0] * _GRID_SIZE))
    second = wp.uint32(wp.int32(u[1] * _GRID_SIZE))
    word = finalise(first ^ finalise(second + _OTHER))
    other = finalise(word + second)
    x = wp.float64(u[0]) + wp.float64(word) * _FINE_STEP
    y = wp.float64(u[1]) + wp.float64(other) * _FINE_STEP
    return wp.vec2d(x, y)


@wp.func
def _row_at(table: wp.uint64, row: wp.int32) -> wp.uint64:
    """Return the address of the float64 numbers of a row in the table of a picture."""
    return table + wp.uint64(8 * HEADER) + wp.uint64(row) * wp.uint64(8 * ROW)


@wp.func
def _shares_at(table: wp.uint64, row: wp.int32, width: wp.int32) -> wp.uint64:
    """Return the address of the cumulative shares of a row's pixels."""
    header = wp.array(ptr=table, shape=(HEADER,), dtype=wp.float64)
    return table + wp.uint64(header[5]) + wp.uint64(row) * wp.uint64(4 * (width + 1))


@wp.func
def _circle(turns: wp.float64) -> wp.vec2:
    """Return (cos, sin) of an angle of 0 to 1 turns; worst absolute error 2e-7, without rounding the turns to float32.

    The angle is that to the middle of its quarter, which is added by products, since a processor predicts no branch here.
    """
    quarter = wp.min(wp.int32(turns * _FOUR), 3)
    cs = sincos_eighth(wp.float32(turns - (wp.float64(quarter) + HALF) * _QUARTER))
    c = _HALF_ROOT * wp.float32(1 - ((quarter + 1) & 2))
    s = _HALF_ROOT * wp.float32(1 - (quarter & 2))
    return wp.vec2(fma(cs[0], c, -(cs[1] * s)), fma(cs[0], s, cs[1] * c))


@wp.func
def _frame_of(table: wp.uint64) -> wp.mat33:
    """Return the frame of the picture, with its axes in columns; +z is the direction of row 0."""
    m = wp.array(ptr=table + wp.uint64(8 * FRAME), shape=(9,), dtype=wp.float64)
    return wp.mat33(
        wp.float32(m[0]), wp.float32(m[1]), wp.float32(m[2]),
        wp.float32(m[3]), wp.float32(m[4]), wp.float32(m[5]),
        wp.float32(m[6]), wp.float32(m[7]), wp.float32(m[8]),
    )  # fmt: skip


@once
def pixel_finder(steps: int) -> wp.Function:
    """Build the wp.func that finds the pixel of a point of the unit square.

    The number of steps is constant, and nothing branches, so that several searches run side by side in a vectorised loop.

    Args:
        steps: steps of each search, `FEW_STEPS` or `MOST_STEPS`.
    """

    @wp.func
    def find_row(table: wp.uint64, x: wp.float64, height: wp.int32) -> wp.int32:
        """Return the row whose share contains x, a number in [0, 1), by a search between two entries of the guide."""
        header = wp.array(ptr=table, shape=(HEADER,), dtype=wp.float64)
        guide = wp.array(ptr=table + wp.uint64(header[6]), shape=(height,), dtype=wp.int32)
        ends = wp.array(ptr=table + wp.uint64(8 * (HEADER + 1)), shape=(ROW * height,), dtype=wp.float64)
        bucket = wp.int32(x * header[4])
        low = guide[bucket]
        high = guide[bucket + 1]
        for _step in range(steps):
            middle = (low + high) >> 1
            after = ends[ROW * middle] <= x
            low = wp.where(after, middle + 1, low)
            high = wp.where(after, high, middle)
        return low

    @wp.func
    def find_column(table: wp.uint64, shares: wp.uint64, step: wp.uint32, place: wp.float64, width: wp.int32) -> wp.int32:
        """Return the column whose share contains a step of its row, by the row's guide."""
        header = wp.array(ptr=table, shape=(HEADER,), dtype=wp.float64)
        guide = wp.array(ptr=table + wp.uint64(header[6]), shape=(width,), dtype=wp.int32)
        ends = wp.array(ptr=shares + wp.uint64(4), shape=(width,), dtype=wp.uint32)
        first = wp.int32(place)
        shift = wp.int32((place - wp.float64(first)) * _SIXTY_FOUR)
        bucket = first + wp.int32(step >> wp.uint32(shift))
        low = guide[bucket]
        high = guide[bucket + 1]
        for _step in range(steps):
            middle = (low + high) >> 1
            after = ends[middle] <= step
            low = wp.where(after, middle + 1, low)
            high = wp.where(after, high, middle)
        return low

    @wp.func
    def find_pixel(u: wp.vec2, table: wp.uint64):
        """Return (row, column, part of the row above u, part of the column before u, steps of the column) of a point u."""
        header = wp.array(ptr=table, shape=(HEADER,), dtype=wp.float64)
        width = wp.int32(header[1])
        wide = _widened(u)
        row = find_row(table, wide[0], wp.int32(header[0]))
        line = wp.array(ptr=_row_at(table, row), shape=(ROW,), dtype=wp.float64)
        shares = _shares_at(table, row, width)
        step = wide[1] * _STEPS
        column = find_column(table, shares, wp.uint32(step), line[7], width)
        ends = wp.array(ptr=shares, shape=(width + 1,), dtype=wp.uint32)
        start = ends[column]
        steps_of = ends[column + 1] - start
        across = wp.float32(step - wp.float64(start)) / wp.float32(steps_of)
        return row, column, (wide[0] - line[0]) * line[4], across, steps_of

    return find_pixel


@wp.func
def aim_at(row: wp.int32, column: wp.int32, down: wp.float64, across: wp.float32, table: wp.uint64):
    """Return (world direction, part of the row, part of the column) at a place in a pixel, kept off the pixel's edges."""
    header = wp.array(ptr=table, shape=(HEADER,), dtype=wp.float64)
    line = wp.array(ptr=_row_at(table, row), shape=(ROW,), dtype=wp.float64)
    # sin^2(theta / 2), even in solid angle within the row; the sine has no cancellation at either pole.
    below = wp.clamp(down, line[6], ONE - line[6])
    v = line[2] + line[3] * below
    r = 2.0 * wp.float32(root_double(v * (ONE - v)))
    edge = wp.min(wp.float32(header[3]) / r, 0.5)
    after = wp.clamp(across, edge, 1.0 - edge)
    cs = _circle((wp.float64(column) + wp.float64(after)) * header[2])
    d = polish(to_world(_frame_of(table), wp.vec3(r * cs[0], r * cs[1], wp.float32(ONE - TWO * v))))
    return d, below, after


@once
def pixel_drawer(steps: int) -> wp.Function:
    """Build the wp.func that maps a point of the unit square to (direction, density of the pixel that is drawn)."""
    find_pixel = pixel_finder(steps)

    @wp.func
    def draw_direction(u: wp.vec2, table: wp.uint64):
        row, column, down, across, steps_of = find_pixel(u, table)
        d, _below, _after = aim_at(row, column, down, across, table)
        line = wp.array(ptr=_row_at(table, row), shape=(ROW,), dtype=wp.float64)
        return wp.vec4(d[0], d[1], d[2], wp.float32(line[5] * wp.float64(steps_of)))

    return draw_direction


_draw_direction = pixel_drawer(MOST_STEPS)


@wp.func
def square_to_environment_map(u: wp.vec2, table: wp.uint64) -> wp.vec3:
    """Map a point of the unit square to a direction towards a picture, in world coordinates, by the picture's luminance.

    u[0] selects the row and the angle within the row, u[1] the column and the azimuth within the column.

    Args:
        u: point of the unit square; a hash of u gives further bits, which reach pixels with a share below 2^-24.
        table: address of the picture's table, `EnvironmentMap.table`.
    """
    d = _draw_direction(u, table)
    return wp.vec3(d[0], d[1], d[2])


@wp.func
def in_picture(w: wp.vec3, table: wp.uint64) -> wp.vec3d:
    """Convert a world direction w to the picture's frame, float64."""
    frame = _frame_of(table)
    x, y, z = wp.float64(w[0]), wp.float64(w[1]), wp.float64(w[2])
    return wp.vec3d(
        wp.float64(frame[0, 0]) * x + wp.float64(frame[1, 0]) * y + wp.float64(frame[2, 0]) * z,
        wp.float64(frame[0, 1]) * x + wp.float64(frame[1, 1]) * y + wp.float64(frame[2, 1]) * z,
        wp.float64(frame[0, 2]) * x + wp.float64(frame[1, 2]) * y + wp.float64(frame[2, 2]) * z,
    )


@wp.func
def azimuth_of(o: wp.vec3d) -> wp.float64:
    """Return the azimuth of a direction o as a fraction of 2 pi, in [0, 1]."""
    turns = wp.atan2(o[1], o[0]) * INV_TWO_PI_DOUBLE
    return wp.where(turns < ZERO, turns + ONE, turns)


@wp.func
def angle_of(o: wp.vec3d) -> wp.float64:
    """Return the angle between the direction o of the picture's frame and the direction of row 0, in units of pi."""
    return wp.atan2(wp.sqrt(o[0] * o[0] + o[1] * o[1]), o[2]) * INV_PI_DOUBLE


@wp.func
def cap_of(o: wp.vec3d) -> wp.float64:
    """Return the part of the sphere's area that is nearer to row 0 than the direction o of the picture's frame."""
    across = o[0] * o[0] + o[1] * o[1]
    length = wp.sqrt(across + o[2] * o[2])
    near = HALF * across / (length * (length + wp.abs(o[2])))
    return wp.where(o[2] > ZERO, near, ONE - near)


@wp.func
def _pixel_of(o: wp.vec3d, table: wp.uint64) -> wp.vec2i:
    """Return the (row, column) of the pixel in the direction o of the picture's frame."""
    header = wp.array(ptr=table, shape=(HEADER,), dtype=wp.float64)
    row = wp.min(wp.int32(angle_of(o) * header[0]), wp.int32(header[0]) - 1)
    return wp.vec2i(row, wp.min(wp.int32(azimuth_of(o) * header[1]), wp.int32(header[1]) - 1))


@wp.func
def square_to_environment_map_pdf(w: wp.vec3, table: wp.uint64) -> wp.float32:
    """Return the density of a picture's pixel at a world direction w, per steradian; 0 where the pixel is black or w is NaN.

    The density of a pixel is its luminance / (sum of luminance * solid angle of all pixels).
    """
    if not (w[0] == w[0] and w[1] == w[1] and w[2] == w[2]):
        return 0.0
    header = wp.array(ptr=table, shape=(HEADER,), dtype=wp.float64)
    width = wp.int32(header[1])
    pixel = _pixel_of(in_picture(w, table), table)
    shares = _shares_at(table, pixel[0], width)
    ends = wp.array(ptr=shares, shape=(width + 1,), dtype=wp.uint32)
    line = wp.array(ptr=_row_at(table, pixel[0]), shape=(ROW,), dtype=wp.float64)
    return wp.float32(line[5] * wp.float64(ends[pixel[1] + 1] - ends[pixel[1]]))


@wp.func
def environment_map_to_square(w: wp.vec3, table: wp.uint64) -> wp.vec2:
    """Return the point u of the unit square that `square_to_environment_map` maps to the world direction w.

    A direction in a black pixel gives the point where its neighbours meet.
    """
    header = wp.array(ptr=table, shape=(HEADER,), dtype=wp.float64)
    width = wp.int32(header[1])
    o = in_picture(w, table)
    pixel = _pixel_of(o, table)
    line = wp.array(ptr=_row_at(table, pixel[0]), shape=(ROW,), dtype=wp.float64)
    shares = _shares_at(table, pixel[0], width)
    ends = wp.array(ptr=shares, shape=(width + 1,), dtype=wp.uint32)
    start = wp.float64(ends[pixel[1]])
    steps = wp.float64(ends[pixel[1] + 1] - ends[pixel[1]])
    part = azimuth_of(o) * header[1] - wp.float64(pixel[1])
    x = line[0] + (line[1] - line[0]) * wp.clamp((cap_of(o) - line[2]) / line[3], ZERO, ONE)
    y = (start + steps * wp.clamp(part, ZERO, ONE)) * _PER_STEPS
    return wp.vec2(clamp_uniform(wp.float32(x)), clamp_uniform(wp.float32(y)))
