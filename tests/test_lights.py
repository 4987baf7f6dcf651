"""Directions towards lights are uniform in solid angle, inside the light, and precise for any size."""

from decimal import Decimal, localcontext
from fractions import Fraction
from math import atan2, pi

import numpy as np
import pytest

import warpsample as ws
from warpsample.proof import laws, twins

U = np.concatenate([ws.sample_square("sobol", 4, 4096, seed=11).reshape(-1, 2), laws.corner_grid()])
SIZES = (2.0, 0.5, 0.1, 1e-2, 1e-3, 1e-4)
ROUNDING = 6e-8  # float32 directions of unit length, in radians
NAN = float("nan")


def exact_solid_angle(a, b, c):
    """The solid angle of a triangle by VanOosterom1983, in exact fractions but for roots of 50 digits."""
    a, b, c = ([Fraction(float(x)) for x in v] for v in (a, b, c))

    def dot(v, w):
        return sum(x * y for x, y in zip(v, w, strict=True))

    def length(v):
        with localcontext(prec=60):
            square = dot(v, v)
            return Fraction((Decimal(square.numerator) / Decimal(square.denominator)).sqrt())

    cross = [b[1] * c[2] - b[2] * c[1], b[2] * c[0] - b[0] * c[2], b[0] * c[1] - b[1] * c[0]]
    p, q, r = length(a), length(b), length(c)
    return 2.0 * atan2(float(abs(dot(a, cross))), float(p * q * r + dot(a, b) * r + dot(b, c) * p + dot(c, a) * q))


def poses(size, count, seed):
    """Triangles (count, 3, 3) of a size, about a distance of 1 away, some of them seen almost from the side."""
    rng = np.random.default_rng(seed)
    middle = rng.normal(size=(count, 1, 3))
    middle /= np.sqrt(np.square(middle).sum(axis=-1, keepdims=True))
    return (middle + size * rng.uniform(-0.5, 0.5, (count, 3, 3))).astype(np.float32)


def distances_to_edges(corners, w):
    """Distances (3, N) of directions from the planes of the edges; below 0 outside."""
    c = corners.astype(np.float64)
    normals = np.cross(c, np.roll(c, -1, axis=0))
    normals *= np.sign(np.linalg.det(c)) / np.sqrt(np.square(normals).sum(axis=1, keepdims=True))
    return normals @ w.astype(np.float64).T


@pytest.mark.parametrize("size", SIZES)
def test_triangles_of_any_size_are_met_and_have_their_density(size):
    """Directions are within 1e-6 of the size and the rounding of float32; the twin's inverse roots lose 1e-16 / size^2."""
    for corners in poses(size, 12, seed=1):
        exact = exact_solid_angle(*corners)
        if not 1e-12 <= exact <= 2.0 * pi - 0.1:
            continue
        lobe = ws.SphericalTriangle(corners)
        w = lobe.sample(U)
        assert distances_to_edges(corners, w).min() >= -1e-6 * size - ROUNDING
        assert lobe.pdf(w) == pytest.approx(1.0 / exact, rel=1e-7)
        assert laws.length_error(w) <= 1e-7


@pytest.mark.parametrize("size", SIZES[1:])
def test_small_triangles_have_the_map_of_their_twin(size):
    """Equilateral, because the angles of the twin lose digits in triangles that are seen from the side."""
    corners = np.array([[0.0, 0.6, 0.8]]) + size * np.array([[1.0, 0.0, 0.0], [-0.5, 0.7, -0.5], [-0.5, -0.7, 0.5]])
    lobe = ws.SphericalTriangle(corners)
    inner = U[(U > 0.0).all(axis=1)]
    w = lobe.sample(inner)
    assert laws.angle_error(w, twins.directions(lobe, inner.astype(np.float64))) <= ROUNDING + 1e-6 * size
    off_seam = ~lobe.seam(inner)
    # At 1 - cos of a hundredth the arc is a tenth as long as the triangle.
    assert laws.round_trip_error(lobe.invert(w)[off_seam], inner[off_seam]) <= 2e-7 + 10.0 * ROUNDING / size


def test_an_octant_has_an_eighth_of_the_sphere():
    lobe = ws.SphericalTriangle(np.eye(3))
    w = lobe.sample(U)
    assert (w >= 0.0).all()
    assert lobe.pdf(w) == pytest.approx(2.0 / pi, rel=1e-7)
    assert not lobe.pdf(-w).any()


def test_each_part_of_a_triangle_has_its_share():
    """Parts by lines through a corner, counted with Sobol' points: a stratum is 1 / 4096, and a line crosses 64 of them."""
    corners = poses(0.5, 1, seed=3)[0].astype(np.float64)
    u = ws.sample_square("sobol", 1, 4096, seed=2)[0]
    w = ws.SphericalTriangle(corners).sample(u)
    for i in range(3):
        a, b, c = np.roll(corners, i, axis=0)
        for share in (0.2, 0.5, 0.7):
            middle = b + share * (c - b)
            inside = (distances_to_edges(np.array([a, b, middle]), w) > 0.0).all(axis=0).mean()
            assert inside == pytest.approx(exact_solid_angle(a, b, middle) / exact_solid_angle(a, b, c), abs=5e-3)


def test_order_and_lengths_of_corners_do_not_change_the_density():
    corners = poses(0.5, 1, seed=4)[0]
    lobe = ws.SphericalTriangle(corners)
    w = lobe.sample(U)
    for other in (corners[[1, 0, 2]], corners[[2, 0, 1]], corners * np.float32([[4.0], [0.5], [2.0**60]])):
        assert ws.SphericalTriangle(other).pdf(w) == pytest.approx(lobe.pdf(w), rel=1e-6)


@pytest.mark.parametrize("height", [0.1, 1e-2, 1e-3, 1e-4])
def test_a_triangle_that_almost_surrounds_the_point_stays_precise(height):
    corners = np.array([[1.0, 0.0, height], [-0.5, 0.866, height], [-0.5, -0.866, height]])
    lobe = ws.SphericalTriangle(corners)
    w = lobe.sample(U)
    assert distances_to_edges(np.float32(corners), w).min() >= -ROUNDING
    assert lobe.pdf(w) == pytest.approx(1.0 / exact_solid_angle(*np.float32(corners)), rel=1e-7)


BAD = {
    "no area": [[0.0, 0.0, 1.0], [1.0, 0.0, 1.0], [2.0, 0.0, 1.0]],
    "too small": [[0.0, 0.0, 1.0], [1e-6, 0.0, 1.0], [0.0, 1e-6, 1.0]],
    "around the point": [[1.0, 0.0, 0.0], [-0.5, 0.866, 0.0], [-0.5, -0.866, 0.0]],
    "seen from its plane": [[1.0, 0.0, 0.0], [2.0, 0.866, 0.0], [2.0, -0.866, 0.0]],
    "NaN": [[1.0, 0.0, 0.0], [NAN, 1.0, 0.0], [0.0, 0.0, 1.0]],
    "infinite": [[1.0, 0.0, 0.0], [float("inf"), 1.0, 0.0], [0.0, 0.0, 1.0]],
    "a corner at the point": [[0.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
}


@pytest.mark.parametrize("corners", [*BAD.values(), np.eye(2), np.ones((2, 3))])
def test_a_triangle_without_a_solid_angle_is_named(corners):
    with pytest.raises(ValueError, match="^corners: got .*, want 3 corners of 3 finite numbers each"):
        ws.SphericalTriangle(np.array(corners))


def check_rows(build, rows, bad):
    """Rows by point have the bits of constants; bad rows get zeros, density 0 and a status that is counted."""
    points = np.tile(np.array([0.0, 0.6, 0.8], np.float32), (len(rows), 1))
    for count in (1, 3, 40):
        got = ws.sample_directions(points, count, distribution=build(rows), pdf=True)
        assert np.flatnonzero(got.status).tolist() == bad
        assert got.counts()[ws.Status.INVALID_PARAMETER] == len(bad)
        assert not got.vectors[bad].any()
        assert not got.pdf[bad].any()
        for i in set(range(len(rows))) - set(bad):
            alone = ws.sample_directions(points[:1], count, distribution=build(rows[i]), pdf=True, first_point=i)
            assert np.array_equal(got.vectors[i], alone.vectors[0])
            assert np.array_equal(got.pdf[i], alone.pdf[0])
    w = build(rows).sample(np.tile(U[:300], (len(rows), 1, 1)))
    for name in ("pdf", "invert"):
        got = getattr(build(rows), name)(w)
        assert not got[bad].any()
        for i in set(range(len(rows))) - set(bad):
            assert np.array_equal(got[i], getattr(build(rows[i]), name)(w[i]))


def test_triangles_by_point_have_the_bits_of_constants_and_bad_ones_are_counted():
    rows = np.array([*BAD.values(), *poses(0.5, 3, seed=5), *poses(1e-3, 2, seed=6)])
    check_rows(ws.SphericalTriangle, rows, list(range(len(BAD))))
