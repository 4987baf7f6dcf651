"""Integrals over lobes that differ from point to point, and integrands that divide by the density."""

import numpy as np
import pytest
import warp as wp
from integrands import direction

import warpsample as ws
from warpsample import funcs

P = 200


@wp.func
def slanted(w: wp.vec3) -> float:
    return w[0] + 0.5 * w[2] + 2.0


@wp.func
def cosine_by_density(w: wp.vec3, lobe: funcs.Lobe) -> float:
    return wp.max(wp.dot(w, lobe.normal), 0.0) / lobe.pdf


@wp.func
def inverse_density(w: wp.vec3, lobe: funcs.Lobe) -> float:
    return 1.0 / lobe.pdf


@wp.func
def not_finite_at_row_0(w: wp.vec3, lobe: funcs.Lobe) -> float:
    return 1.0 / float(lobe.row)


@pytest.fixture(scope="module")
def mesh():
    return ws.load_mesh("courtyard")


@pytest.fixture(scope="module")
def points(mesh):
    return ws.sample_surface(mesh, P, seed=4)


@pytest.fixture(scope="module")
def alpha():
    return np.random.default_rng(5).uniform(0.2, 1.0, P)


def same(one, other, rows=slice(None)):
    return all(np.array_equal(getattr(one, n)[rows], getattr(other, n)[rows]) for n in ("value", "standard_error", "status"))


@pytest.mark.parametrize(
    ("count", "blocked"),
    [(300, False), (16, True), *(pytest.param(*case, marks=pytest.mark.thorough) for case in ((16, False), (300, True)))],
)
def test_arrays_full_of_a_constant_give_its_bits(blocked, count, points, mesh):
    by = {"mesh": mesh} if blocked else {}
    one = ws.integrate(points, direction, count, distribution=ws.GGX(0.4), **by)
    other = ws.integrate(points, direction, count, distribution=ws.GGX(np.full(P, 0.4)), **by)
    assert same(one, other)
    assert other.skipped.empty_rays <= one.skipped.empty_rays


@pytest.mark.parametrize("blocked", [False, True])
def test_each_point_has_its_own_lobe_and_bad_rows_a_status(blocked, points, mesh, alpha):
    by = {"mesh": mesh} if blocked else {}
    whole = ws.integrate(points, direction, 64, distribution=ws.GGX(alpha), **by)
    for i in (0, 77, 199):
        alone = ws.integrate(points.take([i]), direction, 64, distribution=ws.GGX(float(alpha[i])), first_point=i, **by)
        assert np.array_equal(alone.value[0], whole.value[i])
    bad = alpha.copy()
    bad[[3, 9]] = 0.0, np.nan
    found = ws.integrate(points, direction, 64, distribution=ws.GGX(bad), **by)
    assert np.flatnonzero(found.status).tolist() == [3, 9]
    assert found.counts() == {ws.PointStatus.OK: P - 2, ws.PointStatus.INVALID_PARAMETER: 2}
    assert not found.value[[3, 9]].any()
    assert same(found, whole, np.setdiff1d(np.arange(P), [3, 9]))


@pytest.mark.parametrize("blocked", [False, pytest.param(True, marks=pytest.mark.thorough)])
def test_a_quotient_by_the_density_is_an_integral_over_solid_angle(blocked, points, mesh, alpha):
    """pi, for lobes of any roughness; with a mesh what no other face covers: the same as by the cosine lobe."""
    by = {"mesh": mesh} if blocked else {}
    found = ws.integrate(points, cosine_by_density, 1024, distribution=ws.GGX(alpha), **by)
    want = np.pi * ws.ambient_occlusion(mesh, points, 1024).value if blocked else np.full(P, np.pi)
    # 200 points, 6 standard errors of either: the chance of one beyond is below 1e-6.
    assert (abs(found.value - want) <= 6.0 * found.standard_error + (0.06 if blocked else 1e-4)).all()
    assert abs(found.value - want).mean() < 0.02
    # A density of row 0 for all would be seen, since alpha differs.
    other = ws.integrate(points, cosine_by_density, 1024, distribution=ws.GGX(np.full(P, alpha[0])), **by)
    assert not np.array_equal(other.value[1:], found.value[1:])


def test_the_density_is_that_of_the_direction(points):
    """The mean of 1/p is the solid angle of the support: 2 pi, and exactly so for a uniform lobe."""
    found = ws.integrate(points, inverse_density, 64, distribution=ws.UniformHemisphere())
    assert np.allclose(found.value, 2.0 * np.pi, rtol=1e-6)
    cone = np.linspace(0.1, 1.0, P)
    found = ws.integrate(points, inverse_density, 64, distribution=ws.UniformCone(one_minus_cos=cone))
    assert np.allclose(found.value, 2.0 * np.pi * cone, rtol=1e-6)


@pytest.mark.parametrize("blocked", [False, pytest.param(True, marks=pytest.mark.thorough)])
def test_tangents_orient_lobes_and_unusable_ones_keep_their_values(blocked, points, mesh):
    by = {"mesh": mesh} if blocked else {}
    lobe = ws.VisibleGGX(0.5, view=(1.0, 0.0, 0.3))
    t = np.random.default_rng(6).normal(size=(P, 4))
    t[5] = 0.0
    framed = points.with_tangents(t)
    plain = ws.integrate(points, slanted, 64, distribution=lobe, **by)
    found = ws.integrate(framed, slanted, 64, distribution=lobe, **by)
    assert found.value[5] == plain.value[5]
    assert found.counts() == {ws.PointStatus.OK: P - 1, ws.PointStatus.INVALID_TANGENT: 1}
    assert found.skipped.points == 0
    away = found.value != plain.value
    assert away.sum() > 0.9 * P
    if not blocked:  # the mean direction turns with the frame
        mean = ws.sample_directions(framed, 4096, distribution=lobe).vectors.mean(axis=1, dtype=np.float64)
        want = mean[:, 0] + 0.5 * mean[:, 2] + 2.0
        assert abs(found.value - want).max() < 0.05


def test_quantities_do_not_depend_on_tangents(points, mesh):
    framed = points.with_tangents(np.random.default_rng(6).normal(size=(P, 4)))
    one, other = (ws.ambient_occlusion(mesh, p, 256) for p in (points, framed))
    assert same(one, other)


def test_a_tolerance_is_reached_with_lobes_by_point(points, alpha):
    found = ws.integrate(points, slanted, 4096, distribution=ws.GGX(alpha), tolerance=1e-3)
    assert np.sqrt((found.standard_error.astype(np.float64) ** 2).mean()) < 1.2e-3
    assert found.rays.mean() < 4096


def test_a_point_without_a_finite_value_beside_points_without_a_tangent_stops_no_call(points):
    found = ws.integrate(points.with_tangents(np.zeros(3)), not_finite_at_row_0, 8)
    assert found.counts() == {ws.PointStatus.NONFINITE_VALUE: 1, ws.PointStatus.INVALID_TANGENT: P - 1}
    assert (found.value[1:] > 0.0).all()
