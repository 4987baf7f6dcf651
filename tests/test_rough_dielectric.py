"""Rough dielectrics: Snell's and Fresnel's laws as limits, shares, reciprocity, any side, and exact counts of bad rows."""

import numpy as np
import pytest
import warp as wp

import warpsample as ws
from warpsample import funcs
from warpsample.proof import laws
from warpsample.statistics.charts import SPHERE

U = ws.sample_square("sobol", 16, 4096, seed=14).reshape(-1, 2)
VIEW = (0.6, 0.0, 0.8)


def slanted(degrees):
    return np.sin(np.radians(degrees)), 0.0, np.cos(np.radians(degrees))


def glass(alpha, view, eta=1.5):
    """Return the lobe of glass with visible GGX normals, for a view from above or below."""
    v = np.array(view)
    return ws.RoughDielectric(ws.VisibleGGX(alpha, tuple(v if v[2] >= 0.0 else -v)), tuple(view), eta)


def exact_share(cosine, eta):
    """Return Fresnel's share in float64."""
    root = np.sqrt(np.maximum(cosine * cosine + (eta - 1.0) * (eta + 1.0), 0.0))
    across, along = (cosine - root) / (cosine + root), (eta**2 * cosine - root) / (eta**2 * cosine + root)
    return (across**2 + along**2) / 2.0


@wp.kernel
def shares(cosine: wp.array[wp.float32], eta: wp.float32, share: wp.array[wp.float32]):
    i = wp.tid()
    share[i] = funcs.fresnel_dielectric(cosine[i], eta)


def fresnel(degrees, eta):
    out = wp.zeros(len(degrees), wp.float32, device="cpu")
    cosines = wp.array(np.cos(np.radians(degrees)), dtype=wp.float32, device="cpu")
    wp.launch(shares, len(degrees), inputs=[cosines, eta, out], device="cpu")
    return out.numpy().astype(np.float64)


def test_fresnels_share_has_its_values():
    """At 0 degrees, at Brewster's angle and at 60 degrees for glass; total reflection from 41.8 degrees on in glass."""
    assert fresnel([0.0, 56.31, 60.0], 1.5) == pytest.approx([0.04, 0.07396, 0.08919], abs=1e-5)
    assert fresnel([0.0, 41.7], 1.0 / 1.5) == pytest.approx([0.04, 0.69], abs=5e-3)
    assert (fresnel([41.9, 60.0, 90.0], 1.0 / 1.5) == 1.0).all()


@pytest.mark.parametrize("eta", [1.5, 1.01, 1.001, 0.75, 100.0])
def test_fresnels_share_keeps_its_digits(eta):
    eta = float(np.float32(eta))
    c = np.cos(np.radians(np.linspace(0.0, 89.0, 200))).astype(np.float32).astype(np.float64)
    clear = c * c + (eta - 1.0) * (eta + 1.0) > 0.02  # close to the rim the share has an infinite derivative
    found = fresnel(np.degrees(np.arccos(c)), eta)
    assert laws.density_error(found[clear], exact_share(c, eta)[clear]) <= 2e-5  # of degrees in float32


@pytest.mark.parametrize("eta", [1.5, 1.1, 0.7])
@pytest.mark.parametrize("side", [1.0, -1.0])
def test_a_smooth_interface_obeys_snell_and_fresnel(eta, side):
    """At a roughness of 1e-4 the directions are within a few 1e-4 of the mirrored and of the refracted one."""
    view = np.array(slanted(30.0)) * side
    w = glass(1e-4, view, eta).sample(U).astype(np.float64)
    index = eta if side > 0.0 else 1.0 / eta
    reflected = w[:, 2] * side > 0.0
    sine = view[0] / index
    assert np.quantile(abs(w[reflected] - view * [-1.0, -1.0, 1.0]), 0.99) <= 5e-3
    assert np.quantile(abs(w[~reflected] - [-sine, 0.0, -side * np.sqrt(1.0 - sine * sine)]), 0.99) <= 5e-3
    share = fresnel([30.0], index)[0]
    assert reflected.mean() == pytest.approx(share, abs=6.0 * np.sqrt(share / len(U)))


@pytest.mark.parametrize(
    ("degrees", "alpha", "share"), [(44.0, 0.3, 0.520), (44.0, 0.05, 0.796), (46.0, 0.3, 0.567), (46.0, 0.05, 0.907)]
)
def test_from_inside_a_share_is_reflected_totally(degrees, alpha, share):
    """The share of normals with a Fresnel share of 1, and more directions than those return inside."""
    view = slanted(degrees)
    total = ws.VisibleGGX(alpha, view).sample(U) @ np.array(view) < np.sqrt(1.0 - 1.0 / 1.5**2)
    assert total.mean() == pytest.approx(share, abs=2e-3)
    lobe = glass(alpha, -np.array(view))
    w = lobe.sample(U).astype(np.float64)
    m = w - np.array(view)  # the half vector from below
    mirrored = np.abs(np.linalg.norm(m[total], axis=1) / 2.0 - ws.VisibleGGX(alpha, view).sample(U)[total] @ np.array(view))
    assert mirrored.max() <= 1e-5


@pytest.mark.parametrize("eta", [1.5, 1.2])
def test_refraction_is_reciprocal_up_to_the_square_of_eta(eta):
    """sigma(v) p_v(w) = eta^2 sigma(w) p_w(v) for the refracted parts; on the way back there is a reflected part, too."""
    alpha, up = 0.4, np.array([[0.0, 0.0, 1.0]])

    def projected_area(lobe):
        return ws.GGX(alpha).pdf(up)[0] * lobe.view[2] / lobe.pdf(up)[0]

    there = glass(alpha, VIEW, eta)
    w = there.sample(U[:300])
    refracted = w[w[:, 2] < -VIEW[2] - 0.01][:40].astype(np.float64)
    assert len(refracted) == 40
    for direction in refracted:
        back = glass(alpha, tuple(direction), eta)
        one = projected_area(there.lobe) * there.pdf(direction[None])[0]
        mirror = ws.Reflection(back.lobe, tuple(-direction)).pdf(-np.array([VIEW]))[0]
        cosine = np.linalg.norm(direction + VIEW) / 2.0
        refracted_back = back.pdf(np.array([VIEW]))[0] - mirror * exact_share(cosine, 1.0 / eta)
        assert one == pytest.approx(eta**2 * projected_area(back.lobe) * refracted_back, rel=5e-5)  # rounded directions


def test_reflections_above_are_those_of_reflection_times_fresnels_share():
    lobe, mirror = glass(0.3, VIEW), ws.Reflection(ws.VisibleGGX(0.3, VIEW), VIEW)
    w = mirror.sample(U)
    w = w[w[:, 2] > 0.1].astype(np.float64)
    cosine = np.linalg.norm(w + lobe.view_of_kernels, axis=1) / 2.0
    assert laws.density_error(lobe.pdf(w), mirror.pdf(w) * exact_share(cosine, 1.5)) <= 2e-6


def test_the_hash_of_u_is_uniform_and_independent_of_both_coordinates(plausible):
    """Also for Sobol' points, whose coordinates are not independent."""

    @wp.kernel
    def hashed(u: wp.array[wp.vec2], out: wp.array[wp.float32]):
        i = wp.tid()
        out[i] = funcs.third_uniform(u[i])

    for sequence in ("sobol", "fibonacci", "independent"):
        u = ws.sample_square(sequence, 1, 1 << 18, seed=3)[0]
        out = wp.zeros(len(u), wp.float32, device="cpu")
        wp.launch(hashed, len(u), inputs=[wp.array(u, dtype=wp.vec2, device="cpu"), out], device="cpu")
        chance = out.numpy().astype(np.float64)
        plausible(laws.uniform_p_value(chance))
        for k in (0, 1):
            plausible(laws.correlation_p_value(chance, u[:, k].astype(np.float64)))
            plausible(laws.correlation_p_value(chance, (u[:, k].astype(np.float64) * 4096.0) % 1.0))


P = 8


def by_point():
    rng = np.random.default_rng(3)
    view = rng.normal(size=(P, 3))  # from both sides
    return rng.uniform(0.05, 1.0, P), view, np.where(view[:, 2:] < 0.0, -view, view), rng.uniform(1.1, 3.0, P)


@pytest.mark.parametrize("index", ["by point", pytest.param(1.5, marks=pytest.mark.thorough)])
def test_parameters_by_point_have_the_bits_of_constants(index):
    alpha, view, seen, eta = by_point()
    index = eta if index == "by point" else index
    normals = np.random.default_rng(4).normal(size=(P, 3))
    assert (view[:, 2] < 0.0).any()
    lobe = ws.RoughDielectric(ws.VisibleGGX(alpha, view=seen), view, index)
    found = ws.sample_directions(normals, 30, distribution=lobe, pdf=True)
    for i in range(P):
        each = index if np.ndim(index) == 0 else float(index[i])
        one = ws.RoughDielectric(ws.VisibleGGX(float(alpha[i]), tuple(seen[i])), tuple(view[i]), each)
        alone = ws.sample_directions(normals[i : i + 1], 30, distribution=one, pdf=True, first_point=i)
        assert np.array_equal(alone.vectors[0], found.vectors[i])
        assert np.array_equal(alone.pdf[0], found.pdf[i])


def test_bad_rows_get_zeros_and_a_status():
    alpha, view, seen, eta = by_point()
    eta[:4] = 1.0, 1.0005, np.nan, 0.001
    alpha[5] = 0.0
    view[6] = 0.0
    lobe = ws.RoughDielectric(ws.VisibleGGX(alpha, view=seen), view, eta)
    d = ws.sample_directions(np.tile((0.0, 0.0, 1.0), (P, 1)), 9, distribution=lobe, pdf=True)
    bad = [0, 1, 2, 3, 5, 6]
    assert np.flatnonzero(d.status == ws.Status.INVALID_PARAMETER).tolist() == bad
    assert not d.vectors[bad].any()
    assert not d.pdf[bad].any()
    assert d.pdf[[4, 7]].all()


@pytest.mark.parametrize("eta", [1.0, 0.9995, 0.009, 101.0, float("nan"), "1.5"])
def test_a_bad_index_is_named(eta):
    with pytest.raises((ValueError, TypeError), match="^eta: got .*, want a number from 0.01 to 100"):
        ws.RoughDielectric(ws.GGX(0.3), VIEW, eta)


def test_a_view_from_below_is_for_the_dielectric_alone():
    below = (0.0, 0.6, -0.8)
    assert ws.RoughDielectric(ws.GGX(0.3), below, 1.5).view == below
    with pytest.raises(ValueError, match="view: got"):
        ws.VisibleGGX(0.3, below)
    with pytest.raises(NotImplementedError, match="this distribution has no inverse"):
        glass(0.3, VIEW).invert(np.array([[0.0, 0.0, 1.0]]))


def test_normals_that_face_away_refract_from_behind():
    """Any lobe of normals integrates to 1: a normal and its opposite are one interface."""
    lobe = ws.RoughDielectric(ws.HenyeyGreenstein(0.5), slanted(60.0), 1.4)
    d = ws.sample_directions(np.array([[0.0, 0.0, 1.0]]), 4096, distribution=lobe, pdf=True)
    a, turns = (np.arange(600) + 0.5) * np.pi / 600, (np.arange(900) + 0.5) / 900
    w = SPHERE.point(a[:, None], turns)
    total = (lobe.pdf(w).astype(np.float64) * np.sin(a)[:, None]).sum() * (np.pi / 600) * (2.0 * np.pi / 900)
    assert total == pytest.approx(1.0, abs=2e-3)  # the density is infinite at w = -v
    assert d.pdf[0] == pytest.approx(lobe.pdf(d.vectors[0]), rel=1e-3)


@wp.func
def clamped_cosine(w: wp.vec3, lobe: funcs.Lobe) -> float:
    """Return max(0, w.n) / p, whose mean over the lobe is pi."""
    return wp.max(wp.dot(w, lobe.normal), 0.0) / lobe.pdf


@pytest.mark.slow
def test_a_furnace_of_rough_dielectrics_has_closed_integrals():
    """Over 10^4 points of different roughness, view and index; the error bars are honest. High indices reflect enough."""
    rng, points = np.random.default_rng(8), 10_000
    normals, view = rng.normal(size=(2, points, 3))
    view[:, 2] = abs(view[:, 2]) + 0.3
    lobe = ws.RoughDielectric(ws.VisibleGGX(rng.uniform(0.5, 1.0, points), view=view), view, rng.uniform(3.0, 6.0, points))
    e = ws.integrate(normals, clamped_cosine, 256, distribution=lobe)
    error = e.value.astype(np.float64) - np.pi
    assert error.mean() == pytest.approx(0.0, abs=0.02)  # six standard errors
    assert 0.9 <= np.square(error).mean() / np.square(e.standard_error.astype(np.float64)).mean() <= 1.1
