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


@pytest.mark.parametrize("height", [1e-9, 1e-11])
def test_directions_from_a_point_that_almost_touches_a_triangle_have_length_1(height):
    rng = np.random.default_rng(3)
    corners = rng.normal(size=(2000, 3, 3))
    corners -= np.einsum("pk,pki->pi", rng.dirichlet([1.0, 1.0, 1.0], 2000), corners)[:, None]
    corners[:, :, 2] = height
    w = ws.SphericalTriangle(corners).sample(np.broadcast_to(U[:64], (2000, 64, 2)))
    assert laws.length_error(w) <= 1e-7


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


COUNTS = pytest.mark.parametrize("counts", [(3,), pytest.param((1, 40), marks=pytest.mark.thorough)], ids=str)
"""Numbers of directions, of the loops of several, of one and of many; each loop is a kernel of its own."""


def check_rows(build, rows, bad, counts):
    """Rows by point have the bits of constants; bad rows get zeros, density 0 and a status that is counted."""
    points = np.tile(np.array([0.0, 0.6, 0.8], np.float32), (len(rows), 1))
    for count in counts:
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


@pytest.mark.slow
@COUNTS
def test_triangles_by_point_have_the_bits_of_constants_and_bad_ones_are_counted(counts):
    rows = np.array([*BAD.values(), *poses(0.5, 3, seed=5), *poses(1e-3, 2, seed=6)])
    check_rows(ws.SphericalTriangle, rows, list(range(len(BAD))), counts)


def rectangles(size, count, seed):
    """Rectangles (count, 3, 3) of a size, as corner, edge_x and edge_y, about a distance of 1 away, some from the side."""
    rng = np.random.default_rng(seed)
    axes = np.linalg.qr(rng.normal(size=(count, 3, 3)))[0]
    middle = rng.normal(size=(count, 3))
    middle /= np.sqrt(np.square(middle).sum(axis=1, keepdims=True))
    x, y = (size * rng.uniform(0.3, 1.0, (count, 1)) * axes[:, :, i] for i in (0, 1))
    return np.stack([middle - 0.5 * (x + y), x, y], axis=1).astype(np.float32)


def corners_of(rectangle):
    """The four corners (4, 3) of a rectangle in order, with edge_y perpendicular to edge_x."""
    corner, x, y = rectangle.astype(np.float64)
    y = y - (x @ y) / (x @ x) * x
    return np.stack([corner, corner + x, corner + x + y, corner + y])


def exact_of_rectangle(rectangle):
    """The solid angle of a rectangle as the sum of two triangles."""
    a, b, c, d = corners_of(rectangle)
    return exact_solid_angle(a, b, c) + exact_solid_angle(a, c, d)


def outside_of(rectangle, w):
    """How far the farthest of directions w is outside of a rectangle, in radians; below 0 inside."""
    c = corners_of(rectangle)
    normals = np.cross(c, np.roll(c, -1, axis=0))
    normals *= np.sign(c[0] @ np.cross(c[1] - c[0], c[3] - c[0])) / np.sqrt(np.square(normals).sum(axis=1, keepdims=True))
    return -(normals @ w.astype(np.float64).T).min()


@pytest.mark.parametrize("size", SIZES)
def test_rectangles_of_any_size_are_met_and_have_their_density_and_map(size):
    """The twin's four angles lose 1e-16 / solid angle of u: 1e-8 at a size of 1e-4, more from the side."""
    inner = U[(U > 0.0).all(axis=1)]
    for rectangle in rectangles(size, 12, seed=1):
        exact = exact_of_rectangle(rectangle)
        lobe = ws.SphericalRectangle(*rectangle)
        w = lobe.sample(inner)
        assert outside_of(rectangle, w) <= 1e-6 * size + ROUNDING
        assert lobe.pdf(w) == pytest.approx(1.0 / exact, rel=1e-7)
        assert laws.length_error(w) <= 1e-7
        if exact > 0.1 * size * size:
            assert laws.angle_error(w, twins.directions(lobe, inner.astype(np.float64))) <= ROUNDING + 1e-6 * size
            assert laws.round_trip_error(lobe.invert(w), inner) <= 2e-7 + 10.0 * ROUNDING / size


def test_the_faces_of_a_cube_share_the_sphere():
    corner = -np.ones(3)
    w = np.random.default_rng(7).normal(size=(10_000, 3))
    w = (w / np.sqrt(np.square(w).sum(axis=1, keepdims=True))).astype(np.float32)
    total = np.zeros(len(w))
    for axis in range(3):
        x, y = 2.0 * np.eye(3)[[(axis + 1) % 3, (axis + 2) % 3]]
        for start in (corner, corner + 2.0 * np.eye(3)[axis]):
            total += ws.SphericalRectangle(start, x, y).pdf(w)
    assert total == pytest.approx(3.0 / (2.0 * pi), rel=2e-7)  # each direction is in one face: 6 faces, 4 pi
    quarter = ws.SphericalRectangle((0.0, 0.0, 1.0), (1.0, 0.0, 0.0), (0.0, 1.0, 0.0))
    assert quarter.pdf(quarter.sample(U)) == pytest.approx(6.0 / pi, rel=1e-7)


def test_each_part_of_a_rectangle_has_its_share():
    """u[0] is the share on one side of a line along edge_y, and the corners of parts of both edges are met as often."""
    rectangle = rectangles(0.7, 1, seed=3)[0].astype(np.float64)
    u = ws.sample_square("sobol", 1, 4096, seed=2)[0]
    lobe = ws.SphericalRectangle(*rectangle)
    whole = exact_of_rectangle(np.array(rectangle))
    for share_x, share_y in ((0.3, 1.0), (1.0, 0.6), (0.4, 0.7)):
        part = rectangle * np.array([1.0, share_x, share_y])[:, None]
        inside = (ws.SphericalRectangle(*part).pdf(lobe.sample(u)) > 0.0).mean()
        assert inside == pytest.approx(exact_of_rectangle(part) / whole, abs=5e-3)  # a line crosses 64 of 4096 strata


@pytest.mark.parametrize("height", [0.1, 1e-2, 1e-3])
def test_a_rectangle_that_almost_surrounds_the_point_stays_precise(height):
    rectangle = np.float32([[-1.0, -0.8, height], [2.0, 0.0, 0.0], [0.0, 2.0, 0.0]])
    lobe = ws.SphericalRectangle(*rectangle)
    w = lobe.sample(U)
    assert outside_of(rectangle, w) <= ROUNDING
    assert lobe.pdf(w) == pytest.approx(1.0 / exact_of_rectangle(rectangle), rel=1e-7)
    assert laws.round_trip_error(lobe.invert(w), U) <= 2e-5  # w.z, to which the distance in the plane is inverse, is rounded


def test_edges_that_are_almost_perpendicular_become_so():
    corner, x, y = np.float32([[0.1, 0.2, 1.0], [0.5, 0.0, 0.0], [4e-5, 0.5, 0.0]])
    lobe, right = ws.SphericalRectangle(corner, x, y), ws.SphericalRectangle(corner, x, np.float32([0.0, 0.5, 0.0]))
    assert np.array_equal(lobe.sample(U), right.sample(U))
    assert np.array_equal(lobe.pdf(right.sample(U)), right.pdf(right.sample(U)))


UP, X, Y = (0.0, 0.0, 1.0), (1.0, 0.0, 0.0), (0.0, 1.0, 0.0)
BAD_RECTANGLES = {
    "no length": (UP, (0.0, 0.0, 0.0), Y, "edge_x"),
    "no width": (UP, X, (0.0, 0.0, 0.0), "edge_y"),
    "not perpendicular": (UP, X, (0.01, 1.0, 0.0), "edge_y"),
    "around the point": ((-0.5, -0.5, 0.0), X, Y, "corner"),
    "seen from its plane": ((0.5, 0.5, 0.0), X, Y, "corner"),
    "too small": (UP, (1e-7, 0.0, 0.0), (0.0, 1e-7, 0.0), "corner"),
    "NaN": ((NAN, 0.0, 1.0), X, Y, "corner"),
    "infinite": (UP, (float("inf"), 0.0, 0.0), Y, "edge_x"),
    "beyond float32": (UP, (1e60, 0.0, 0.0), Y, "edge_x"),
}


@pytest.mark.parametrize(("corner", "x", "y", "name"), BAD_RECTANGLES.values(), ids=BAD_RECTANGLES)
def test_a_rectangle_without_a_solid_angle_is_named(corner, x, y, name):
    with pytest.raises(ValueError, match=f"^{name}: got .*, want "):
        ws.SphericalRectangle(corner, x, y)


def test_constant_edges_are_checked_beside_corners_by_point():
    with pytest.raises(ValueError, match=r"^edge_y: got .*, want three finite numbers, not all 0, perpendicular to edge_x$"):
        ws.SphericalRectangle(np.ones((4, 3)), X, (0.1, 1.0, 0.0))
    with pytest.raises(ValueError, match="^edge_x: got 3 rows, want 4, as corner has"):
        ws.SphericalRectangle(np.ones((4, 3)), np.ones((3, 3)), Y)


@pytest.mark.thorough
@COUNTS
def test_rectangles_by_point_have_the_bits_of_constants_and_bad_ones_are_counted(counts):
    bad = np.array([values[:3] for values in BAD_RECTANGLES.values()])
    rows = np.concatenate([bad, rectangles(0.5, 3, seed=5), rectangles(1e-3, 2, seed=6)])
    check_rows(lambda r: ws.SphericalRectangle(*np.moveaxis(r, -2, 0)), rows, list(range(len(bad))), counts)


def test_a_window_has_rows_for_some_of_its_vectors():
    """The bits are those of constants."""
    corner = np.array([[0.0, 0.0, 1.0], [0.2, 0.0, 1.0], [0.0, 0.0, 0.0]])
    u = np.tile(U[:100], (3, 1, 1))
    w = ws.SphericalRectangle(corner, X, Y).sample(u)
    for row in (0, 1):
        assert np.array_equal(w[row], ws.SphericalRectangle(corner[row], X, Y).sample(u[row]))
    assert not w[2].any()
    assert w[:2].any(axis=-1).all()
