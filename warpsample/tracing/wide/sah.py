"""One split of a range of triangles by the binned surface-area heuristic (Wald2007).

Triangles are counted by the sixteen, since that many cost as much as one.
"""

import warp as wp

from warpsample.tracing.wide.layout import WIDTH

BINS = 16
ALL_BINS = 3 * BINS

LARGE: wp.float32 = wp.constant(wp.float32(1e30))
MOST_BINS: wp.float32 = wp.constant(wp.float32(0.9999 * BINS))
_MOST_COST = wp.constant(wp.float32(3e38))


@wp.func
def _xyz(v: wp.vec4) -> wp.vec3:
    return wp.vec3(v[0], v[1], v[2])


@wp.func
def _half_area(low: wp.vec3, high: wp.vec3) -> wp.float32:
    d = high - low
    return d[0] * d[1] + d[1] * d[2] + d[2] * d[0]


@wp.func
def _passes(triangles: wp.int32) -> wp.float32:
    """Leaves that many triangles fill."""
    return wp.float32((triangles + WIDTH - 1) / WIDTH)


@wp.func
def centres(lower: wp.array[wp.vec4], upper: wp.array[wp.vec4], begin: wp.int32, end: wp.int32):
    """The box of the boxes' centres, times two."""
    low = wp.vec3(LARGE)
    high = wp.vec3(-LARGE)
    for i in range(begin, end):
        centre = _xyz(lower[i]) + _xyz(upper[i])
        low = wp.min(low, centre)
        high = wp.max(high, centre)
    return low, high


@wp.func
def _put(
    k: wp.int32, low: wp.vec3, high: wp.vec3, lows: wp.array[wp.vec3], highs: wp.array[wp.vec3], counts: wp.array[wp.int32]
):
    lows[k] = wp.min(lows[k], low)
    highs[k] = wp.max(highs[k], high)
    counts[k] = counts[k] + 1


@wp.func
def fill_bins(
    lower: wp.array[wp.vec4],
    upper: wp.array[wp.vec4],
    begin: wp.int32,
    end: wp.int32,
    start: wp.vec3,
    scale: wp.vec3,
    lows: wp.array[wp.vec3],
    highs: wp.array[wp.vec3],
    counts: wp.array[wp.int32],
):
    """Boxes and counts of the triangles whose centres are in a bin, sixteen bins to an axis."""
    for k in range(ALL_BINS):
        lows[k] = wp.vec3(LARGE)
        highs[k] = wp.vec3(-LARGE)
        counts[k] = 0
    for i in range(begin, end):
        low = _xyz(lower[i])
        high = _xyz(upper[i])
        bin = wp.cw_mul(low + high - start, scale)
        _put(wp.int32(bin[0]), low, high, lows, highs, counts)
        _put(BINS + wp.int32(bin[1]), low, high, lows, highs, counts)
        _put(2 * BINS + wp.int32(bin[2]), low, high, lows, highs, counts)


@wp.func
def best_split(
    triangles: wp.int32,
    lows: wp.array[wp.vec3],
    highs: wp.array[wp.vec3],
    counts: wp.array[wp.int32],
    right: wp.array[wp.float32],
):
    """(last bin of the left part among all axes' bins or -1, half areas of the left and of the right part)."""
    best = wp.int32(-1)
    least = wp.float32(_MOST_COST)
    left_area = wp.float32(0.0)
    right_area = wp.float32(0.0)
    first = wp.int32(0)
    while first < ALL_BINS:  # `range` would be unrolled, and takes the compiler twice as long
        low = wp.vec3(LARGE)
        high = wp.vec3(-LARGE)
        k = first + BINS - 1
        while k > first:
            low = wp.min(low, lows[k])
            high = wp.max(high, highs[k])
            right[k] = _half_area(low, high)
            k -= 1
        low = wp.vec3(LARGE)
        high = wp.vec3(-LARGE)
        count = wp.int32(0)
        for k in range(first, first + BINS - 1):
            low = wp.min(low, lows[k])
            high = wp.max(high, highs[k])
            count += counts[k]
            if count > 0 and count < triangles:
                area = _half_area(low, high)
                cost = area * _passes(count) + right[k + 1] * _passes(triangles - count)
                if cost < least:
                    least = cost
                    best = k
                    left_area = area
                    right_area = right[k + 1]
        first += BINS
    return best, left_area, right_area


@wp.func
def partition(
    lower: wp.array[wp.vec4],
    upper: wp.array[wp.vec4],
    begin: wp.int32,
    end: wp.int32,
    axis: wp.int32,
    start: wp.float32,
    scale: wp.float32,
    last_bin: wp.int32,
) -> wp.int32:
    """Brings the triangles of the bins up to last_bin to the front; returns where the others begin."""
    low = begin
    high = end - 1
    while low <= high:
        a = lower[low]
        b = upper[low]
        if wp.int32((a[axis] + b[axis] - start) * scale) <= last_bin:
            low += 1
        else:
            lower[low] = lower[high]
            upper[low] = upper[high]
            lower[high] = a
            upper[high] = b
            high -= 1
    return low
