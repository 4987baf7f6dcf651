"""Split of a range of triangles in two by the binned surface-area heuristic (Wald2007).

The heuristic counts leaves instead of triangles, since testing sixteen triangles takes as long as testing one.
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
    """Return the first three components of a vector."""
    return wp.vec3(v[0], v[1], v[2])


@wp.func
def _half_area(low: wp.vec3, high: wp.vec3) -> wp.float32:
    """Return half the surface area of a box with the given corners."""
    d = high - low
    return d[0] * d[1] + d[1] * d[2] + d[2] * d[0]


@wp.func
def _leaf_count(triangles: wp.int32) -> wp.float32:
    """Return the number of tree leaves needed for a number of triangles, as float32."""
    return wp.float32((triangles + WIDTH - 1) / WIDTH)


@wp.func
def centres(lower: wp.array[wp.vec4], upper: wp.array[wp.vec4], begin: wp.int32, end: wp.int32):
    """Return the lower and upper corner of the bounding box of the triangles' box centres, multiplied by two."""
    low = wp.vec3(LARGE)
    high = wp.vec3(-LARGE)
    for i in range(begin, end):
        centre = _xyz(lower[i]) + _xyz(upper[i])
        low = wp.min(low, centre)
        high = wp.max(high, centre)
    return low, high


@wp.func
def _add_to_bin(
    k: wp.int32, low: wp.vec3, high: wp.vec3, lows: wp.array[wp.vec3], highs: wp.array[wp.vec3], counts: wp.array[wp.int32]
):
    """Extend the box of the k-th bin by a triangle's box, and count the triangle."""
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
    """Compute the box and the triangle count of each bin of the surface-area heuristic.

    A bin has the triangles whose box centres are inside. There are sixteen bins per axis: BINS times the axis plus the bin
    along the axis.
    """
    for k in range(ALL_BINS):
        lows[k] = wp.vec3(LARGE)
        highs[k] = wp.vec3(-LARGE)
        counts[k] = 0
    for i in range(begin, end):
        low = _xyz(lower[i])
        high = _xyz(upper[i])
        bin = wp.cw_mul(low + high - start, scale)
        _add_to_bin(wp.int32(bin[0]), low, high, lows, highs, counts)
        _add_to_bin(BINS + wp.int32(bin[1]), low, high, lows, highs, counts)
        _add_to_bin(2 * BINS + wp.int32(bin[2]), low, high, lows, highs, counts)


@wp.func
def best_split(
    triangles: wp.int32,
    lows: wp.array[wp.vec3],
    highs: wp.array[wp.vec3],
    counts: wp.array[wp.int32],
    right: wp.array[wp.float32],
):
    """Return the cheapest split of binned triangles: (last bin on the left, half areas of the left and right part).

    The bin is numbered among the bins of all axes; it is -1 if no split separates the triangles.
    """
    best = wp.int32(-1)
    least = wp.float32(_MOST_COST)
    left_area = wp.float32(0.0)
    right_area = wp.float32(0.0)
    first = wp.int32(0)
    while first < ALL_BINS:  # the compiler would unroll `range` and take twice as long
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
                cost = area * _leaf_count(count) + right[k + 1] * _leaf_count(triangles - count)
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
    """Move the triangles of bins up to `last_bin` to the front of a range; return the index after the last one."""
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
