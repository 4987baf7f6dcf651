"""Intervals hold what hardly a ray meets: small openings in a ceiling, small things before the sky, and both at once."""

import numpy as np
import pytest
from estimate_cases import at
from scipy.stats import binom

import warpsample as ws

RUNS = 4000
LEAST = 0.93
FAR = 1e4
EXPECTED = (0.1, 0.5, 1.1, 1.5, 2.0, 2.5, 3.0, 3.6, 4.5, 6.0, 8.0, 10.0, 15.0, 20.0, 30.0)
CENTRES = {"overhead": (0.0, 0.0), "aside": (0.37, 0.21), "low": (1.3, -1.7)}


def corner(x, y):
    """The share of the lobe about z that a rectangle has, from over the point to (x, y, 1)."""
    a, b = np.hypot(1.0, x), np.hypot(1.0, y)
    return (x / a * np.arctan(y / a) + y / b * np.arctan(x / b)) / (2.0 * np.pi)


def share(box):
    """The share of the lobe about z that a rectangle (x0, x1, y0, y1) at a height of 1 has."""
    x0, x1, y0, y1 = box
    return corner(x1, y1) - corner(x0, y1) - corner(x1, y0) + corner(x0, y0)


def box_of(wanted, centre):
    """The square about a centre that has a share of the lobe, by bisection."""
    low, high = 0.0, 8.0
    for _ in range(60):
        side = 0.5 * (low + high)
        box = [c + s * side / 2.0 for c in centre for s in (-1, 1)]
        low, high = (side, high) if share(box) < wanted else (low, side)
    return box


def mesh_of(boxes):
    """Rectangles at a height of 1."""
    corners = [[(x0, y0, 1), (x1, y0, 1), (x1, y1, 1), (x0, y1, 1)] for x0, x1, y0, y1 in boxes]
    faces = [[(k, k + 2, k + 1), (k, k + 3, k + 2)] for k in range(0, 4 * len(boxes), 4)]
    return ws.as_mesh((np.reshape(corners, (-1, 3)).astype(float), np.reshape(faces, (-1, 3))))


def around(hole, right=FAR):
    """Four rectangles, a ceiling with a hole, as far as x = right."""
    x0, x1, y0, y1 = hole
    return [(-FAR, right, -FAR, y0), (-FAR, right, y1, FAR), (-FAR, x0, y0, y1), (x1, right, y0, y1)]


def scene(kind, expected, count):
    """(mesh, exact value) in which so many of `count` rays are expected to leave, to be blocked, or both."""
    if kind == "both":
        # A ceiling over x < 0 with a hole, and a thing before the open half.
        boxes = [*around(box_of(expected / count, (-0.6, 0.3)), 0.0), box_of(expected / count, (0.9, -0.5))]
        return mesh_of(boxes), 1.0 - sum(map(share, boxes))
    place, what = kind
    box = box_of(expected / count, CENTRES[place])
    boxes = around(box) if what == "hole" else [box]
    return mesh_of(boxes), 1.0 - sum(map(share, boxes))


def coverage(kind, expected, count, sequence="fibonacci"):
    """How many of RUNS intervals of 95 % hold the exact value."""
    mesh, right = scene(kind, expected, count)
    found = ws.ambient_occlusion(mesh, at((0, 0, 0), (0, 0, 1), RUNS), count, sequence=sequence, seed=11)
    lower, upper = found.interval(0.95)
    return int(((lower <= right + 1e-6) & (right - 1e-6 <= upper)).sum())


def enough(held, runs, least=LEAST):
    """A p-value of the claim that each of some cases holds often enough: the smallest of theirs, times their number."""
    return min(1.0, len(held) * float(binom.cdf(held, runs, least).min()))


KINDS = [(place, what) for place in CENTRES for what in ("hole", "thing")]


@pytest.mark.parametrize("count", [64, pytest.param(448, marks=pytest.mark.thorough)])
@pytest.mark.parametrize("kind", KINDS, ids="-".join)
def test_each_expected_count_is_covered(kind, count, plausible):
    plausible(enough([coverage(kind, expected, count) for expected in EXPECTED], RUNS))


@pytest.mark.parametrize("count", [64, pytest.param(448, marks=pytest.mark.thorough)])
def test_both_ends_at_once_are_covered(count, plausible):
    few = [n for n in EXPECTED if n <= 10]  # of 64 rays more would not fit beside each other
    plausible(enough([coverage("both", expected, count) for expected in few], RUNS))


@pytest.mark.thorough
@pytest.mark.parametrize("sequence", sorted(set(ws.sequences.names()) - {"fibonacci"}))
def test_other_sequences_cover_too(sequence, plausible):
    """Over the places together: at one of them, few values may be possible."""
    held = [sum(coverage(kind, n, count, sequence) for kind in KINDS) for count in (64, 448) for n in EXPECTED]
    plausible(enough(held, len(KINDS) * RUNS))


@pytest.mark.thorough
@pytest.mark.parametrize("sequence", ws.sequences.names())
def test_around_the_normal_too(sequence, plausible):
    """Where the edge runs along one axis of the square; `r2` takes few values there, as `interval` says."""
    least = 0.87 if sequence == "r2" else LEAST
    held = np.array(
        [coverage(("overhead", "hole"), n, count, sequence) for count in (64, 128, 256) for n in (6.0, 8.0, 15.0)]
    )
    plausible(min(1.0, len(held) * float(binom.cdf(held, RUNS, least).min())))


def test_half_a_ray_is_not_enough(plausible):
    """The same check rejects a rule that gives half a ray to what no ray has met."""
    mesh, right = scene(("overhead", "hole"), 1.5, 64)
    found = ws.ambient_occlusion(mesh, at((0, 0, 0), (0, 0, 1), RUNS), 64, seed=11)
    half = 2.12 * np.where(found.value == 0.0, 0.5 / 64, found.spread)  # by 16 degrees of freedom
    with pytest.raises(AssertionError):
        plausible(binom.cdf(int((np.abs(found.value - right) <= half).sum()), RUNS, LEAST))


def test_an_interval_stays_within_what_is_possible(bunny, points):
    for estimate in (ws.ambient_occlusion, ws.sky_view_factor):
        lower, upper = estimate(bunny, points, 64).interval()
        assert lower.min() >= 0.0
        assert upper.max() == 1.0
