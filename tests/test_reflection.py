"""Reflections at a lobe of normals: closed forms, shares, reciprocity, any view, nested parameters and kernels."""

import pickle
from itertools import pairwise

import dask
import numpy as np
import pytest
import warp as wp

import warpsample as ws
from warpsample import cluster, funcs
from warpsample.directions.plan import _build_kernel
from warpsample.proof import laws, verify
from warpsample.statistics.charts import SPHERE

U = ws.sample_square("sobol", 16, 4096, seed=13).reshape(-1, 2)
VIEW = (0.6, -0.64, 0.48)
NORMAL = (0.0, 0.0, 1.0)


def slanted(degrees):
    return np.sin(np.radians(degrees)), 0.0, np.cos(np.radians(degrees))


def reflection_of(kind, *values, view=VIEW, **named):
    """Return the reflection of a view at a lobe that has the view itself, if it has any."""
    named |= {"view": view} if "view" in kind.parameters else {}
    return ws.Reflection(kind(*values, **named), view)


@pytest.mark.parametrize("alpha", [1e-3, 0.1, 0.5, 1.0])
def test_ggx_seen_from_above_has_its_closed_form(alpha):
    """Of normals about the view, the reflected directions have a^2 / (4 pi (sin^2 + a^2 cos^2)^2) of half the angle."""
    lobe, a = reflection_of(ws.GGX, alpha, view=NORMAL), float(np.float32(alpha))
    w = lobe.sample(U).astype(np.float64)
    half = 0.5 * np.arctan2(np.hypot(w[:, 0], w[:, 1]), w[:, 2])
    w, half = w[half < 1.2], half[half < 1.2]  # beyond, the rounding of w turns the short half vector
    exact = a * a / (4.0 * np.pi * (np.sin(half) ** 2 + a * a * np.cos(half) ** 2) ** 2)
    assert laws.density_error(lobe.pdf(w), exact) <= 2e-6
    # Visible normals seen from above are those of the lobe itself.
    assert laws.density_error(reflection_of(ws.VisibleGGX, alpha, view=NORMAL).pdf(w), exact) <= 2e-6


@pytest.mark.parametrize("view", [VIEW, slanted(89.0), NORMAL])
def test_uniform_normals_have_their_closed_form(view):
    lobe = reflection_of(ws.UniformHemisphere, view=view)
    w = lobe.sample(U).astype(np.float64)
    half = np.linalg.norm(w + lobe.view_of_kernels, axis=1) / 2.0
    clear = half > 1e-3
    assert laws.density_error(lobe.pdf(w[clear]), 1.0 / (8.0 * np.pi * half[clear])) <= 1e-6
    both = ws.Reflection(ws.UniformSphere(), view)  # m and -m: the same density of directions
    assert laws.density_error(both.pdf(w[clear]), 1.0 / (8.0 * np.pi * half[clear])) <= 1e-6


SHARES = {
    0.1: (0.010, 0.012, 0.016, 0.029, 0.033, 0.005),
    0.3: (0.082, 0.088, 0.088, 0.072, 0.028, 0.005),
    0.6: (0.265, 0.234, 0.195, 0.125, 0.048, 0.010),
    1.0: (0.501, 0.415, 0.333, 0.207, 0.080, 0.017),
}


@pytest.mark.parametrize("alpha", SHARES)
def test_a_share_is_reflected_below_the_surface(alpha):
    """By 2^16 Sobol' points against values of LOBES.md, about three digits."""
    for degrees, share in zip((0, 45, 60, 75, 85, 89), SHARES[alpha], strict=True):
        w = reflection_of(ws.VisibleGGX, alpha, view=slanted(degrees)).sample(U)
        assert (w[:, 2] < 0.0).mean() == pytest.approx(share, abs=2e-3)


FLAT = {ws.VisibleGGX: ws.GGX, ws.VisibleBeckmann: ws.Beckmann}


def visible(kind, alphas, view):
    return ws.Reflection(kind(alphas[0], view, *alphas[1:]), view)


def projected_area(lobe, alphas):
    """Return the projected area of visible normals, D(z) v.z / p(z)."""
    up = np.array([NORMAL])
    return FLAT[type(lobe)](*alphas).pdf(up)[0] * lobe.view[2] / lobe.pdf(up)[0]


@pytest.mark.parametrize(
    ("alphas", "kind"),
    [
        ((0.3,), ws.VisibleGGX),
        ((0.3,), ws.VisibleBeckmann),
        ((0.4, 0.15), ws.VisibleGGX),
        pytest.param((0.4, 0.15), ws.VisibleBeckmann, marks=pytest.mark.thorough),
    ],
)
def test_reflections_are_reciprocal(kind, alphas):
    """sigma(v) p_v(w) = sigma(w) p_w(v) = D(h) / 4, for directions v and w above the surface."""
    there = visible(kind, alphas, VIEW)
    w = there.sample(U[:60])
    for direction in w[w[:, 2] > 0.05].astype(np.float64):
        back = visible(kind, alphas, tuple(direction))
        one = projected_area(there.lobe, alphas) * there.pdf(direction[None])[0]
        assert one == pytest.approx(projected_area(back.lobe, alphas) * back.pdf(np.array([VIEW]))[0], rel=2e-5)


WIDE = [
    reflection_of(ws.VisibleGGX, 0.4),
    reflection_of(ws.VisibleGGX, 0.5, alpha_y=0.3),
    reflection_of(ws.VisibleBeckmann, 0.5),
    ws.Reflection(ws.VisibleGGX(0.5, slanted(40.0)), VIEW),  # seen from elsewhere
]


def midpoint_masses(lobe, edges, fine=60):
    """Return the integrals of the density over rows of polar angles and 12 columns of azimuths.

    Midpoints suffice: near w = -v the density depends on the direction from which w comes, which Gauss's rules do not
    resolve; where v is not the lobe's own view, it is infinite there.
    """
    a = np.concatenate([low + (high - low) * (np.arange(fine) + 0.5) / fine for low, high in pairwise(edges)])
    turns = (np.arange(12 * fine) + 0.5) / (12 * fine)
    density = lobe.pdf(SPHERE.point(a[:, None], turns).astype(np.float32)).astype(np.float64)
    weight = np.sin(a) * np.repeat(np.diff(edges), fine) / fine * 2.0 * np.pi / len(turns)
    return (density * weight[:, None]).reshape(len(edges) - 1, fine, 12, fine).sum(axis=(1, 3))


@pytest.mark.slow
@pytest.mark.parametrize("lobe", WIDE, ids=repr)
def test_cells_of_directions_have_their_counts(lobe, plausible):
    """In cells of (cos theta, phi), which know nothing of normals. Normals jump at w.z = -v.z, where a row ends."""
    edges = np.sort(np.append(np.linspace(0.0, np.pi, 25), np.arccos(-lobe.view[2])))
    masses = midpoint_masses(lobe, edges)
    assert masses.sum() == pytest.approx(1.0, abs=5e-4)
    w = lobe.sample(ws.sample_square("independent", 1 << 14, 16, seed=5).reshape(-1, 2))
    counts, _, _ = np.histogram2d(SPHERE.polar(w), SPHERE.azimuth(w), bins=(edges, np.linspace(0.0, 1.0, 13)))
    full = masses * len(w) > 10.0
    from scipy.stats import chisquare

    expected = masses[full] * (counts[full].sum() / masses[full].sum())
    plausible(chisquare(counts[full], expected).pvalue)


def test_a_pair_of_opposite_normals_counts_twice():
    """A lobe over the whole sphere, HenyeyGreenstein, has both terms, and so no inverse."""
    lobe = ws.Reflection(ws.HenyeyGreenstein(0.3), VIEW)
    w = lobe.sample(U[:1000]).astype(np.float64)
    half = w + VIEW
    length = np.linalg.norm(half, axis=1)
    m = half / length[:, None]
    both = lobe.lobe.pdf(m).astype(np.float64) + lobe.lobe.pdf(-m)
    clear = length > 0.02
    assert laws.density_error(lobe.pdf(w)[clear], (both / (2.0 * length))[clear]) <= 2e-6
    with pytest.raises(NotImplementedError, match="several points u map to one direction"):
        lobe.invert(w)


def test_the_density_of_a_call_is_that_of_its_directions():
    """It comes from the normal; at the rounded direction it differs as the half vector's rounding over the roughness."""
    d = ws.sample_directions(np.array([NORMAL]), 4096, distribution=reflection_of(ws.VisibleGGX, 0.3), pdf=True)
    at = reflection_of(ws.VisibleGGX, 0.3).pdf(d.vectors[0])
    assert np.quantile(abs(d.pdf[0] / at - 1.0), 0.99) <= 1e-5
    assert (d.pdf > 0.0).all()


P = 7


def by_point():
    rng = np.random.default_rng(3)
    view = rng.normal(size=(P, 3))
    view[:, 2] = abs(view[:, 2])
    return rng.uniform(0.05, 1.0, P), view


def test_nested_parameters_by_point_have_the_bits_of_constants():
    alpha, view = by_point()
    normals = np.random.default_rng(4).normal(size=(P, 3))
    for own, seen in ((view, view), (view, VIEW), (VIEW, view)):
        lobe = ws.Reflection(ws.VisibleGGX(alpha, view=own), seen)
        found = ws.sample_directions(normals, 30, distribution=lobe, pdf=True)
        for i in range(P):
            first, second = (tuple(v[i]) if np.ndim(v) == 2 else v for v in (own, seen))
            one = ws.Reflection(ws.VisibleGGX(float(alpha[i]), first), second)
            alone = ws.sample_directions(normals[i : i + 1], 30, distribution=one, pdf=True, first_point=i)
            assert np.array_equal(alone.vectors[0], found.vectors[i])
            assert np.array_equal(alone.pdf[0], found.pdf[i])


def test_a_bad_row_of_a_nested_parameter_is_a_bad_row_of_the_lobe():
    alpha, view = by_point()
    alpha[1], view[3], view[5] = 2.0, np.nan, (0.0, 0.6, -0.8)
    lobe = ws.Reflection(ws.VisibleGGX(alpha, view=np.tile(VIEW, (P, 1))), view)
    d = ws.sample_directions(np.tile(NORMAL, (P, 1)), 9, distribution=lobe, pdf=True)
    assert np.flatnonzero(d.status == ws.Status.INVALID_PARAMETER).tolist() == [1, 3, 5]
    assert not d.vectors[[1, 3, 5]].any()
    assert not d.pdf[[1, 3, 5]].any()
    assert d.pdf[[0, 2, 4, 6]].all()


def test_kernels_are_keyed_by_types():
    alpha, view = by_point()
    normals = np.tile(NORMAL, (P, 1))
    ws.sample_directions(normals, 3, distribution=ws.Reflection(ws.VisibleGGX(alpha, view=view), view), pdf=True)
    built = _build_kernel.cache_info().currsize
    for scale in (0.3, 0.5):
        other = ws.Reflection(ws.VisibleGGX(scale * alpha, view=-view * [1, 1, -1]), view)
        ws.sample_directions(normals, 3, distribution=other, pdf=True)
    assert _build_kernel.cache_info().currsize == built
    ws.sample_directions(normals, 3, distribution=ws.Reflection(ws.GGX(alpha), view))
    assert _build_kernel.cache_info().currsize == built + 1


def test_equality_pickles_and_tokens_know_nested_arrays():
    alpha, view = by_point()
    lobe = ws.Reflection(ws.VisibleGGX(alpha, view=view), view)
    copied = pickle.loads(pickle.dumps(lobe))
    assert copied == lobe
    assert hash(copied) == hash(lobe)
    other = alpha.copy()
    other[-1] *= 1.0001
    changed = ws.Reflection(ws.VisibleGGX(other, view=view), view)
    assert changed != lobe
    assert len({dask.base.tokenize(each) for each in (lobe, copied, changed)}) == 2


def test_tasks_of_dask_cut_nested_parameters_with_the_points():
    alpha, view = by_point()
    normals = np.random.default_rng(4).normal(size=(P, 3))
    for lobe in (
        ws.Reflection(ws.VisibleGGX(alpha, view=view), view),
        ws.RoughDielectric(ws.VisibleGGX(alpha, view=view), -view, 1.0 + alpha),
    ):
        whole = ws.sample_directions(normals, 30, distribution=lobe, pdf=True)
        found = cluster.sample_directions(normals, 30, distribution=lobe, pdf=True, chunk=3)
        vectors, pdf = dask.compute(found.vectors, found.pdf)
        assert np.array_equal(vectors, whole.vectors)
        assert np.array_equal(pdf, whole.pdf)


def test_errors_name_the_nested_parameter():
    alpha, view = by_point()
    lobe = ws.Reflection(ws.VisibleGGX(alpha), VIEW)
    with pytest.raises(ValueError, match=r"distribution: got lobe.alpha with 7 rows, want 2, one for each point"):
        ws.sample_directions(np.tile(NORMAL, (2, 1)), 3, distribution=lobe)
    with pytest.raises(ValueError, match=r"view: got 6 rows, want 7, as lobe.alpha has"):
        ws.Reflection(ws.VisibleGGX(alpha), view[:6])
    with pytest.raises(ValueError, match="view: got .* the last at least 0"):
        ws.Reflection(ws.GGX(0.3), (0.0, 0.6, -0.8))
    with pytest.raises(TypeError, match=r"lobe: got UniformDisk\(.*want a distribution of normals in space"):
        ws.Reflection(ws.UniformDisk(), VIEW)
    deep = ws.LinearlyTransformedCosine()
    for _ in range(3):
        deep = ws.Reflection(deep, VIEW)
    with pytest.raises(ValueError, match="lobe: got 21 numbers with those of all nested lobes, want at most 20"):
        ws.Reflection(deep, VIEW)


def test_texts_make_nested_lobes():
    make, table = ws.distributions.as_distribution, {"rough": np.full(3, 0.2), "camera": np.ones((3, 3))}
    assert make("reflection(visible_ggx(alpha=0.3), view=(0.6, 0, 0.8))") == ws.Reflection(
        ws.VisibleGGX(0.3), (0.6, 0.0, 0.8)
    )
    text = "reflection(lobe=visible_ggx(alpha=@rough, view=@camera), view=@camera)"
    lobe = make(text, table.__getitem__)
    assert lobe == ws.Reflection(ws.VisibleGGX(table["rough"], view=table["camera"]), table["camera"])
    assert repr(lobe) == "Reflection(lobe=VisibleGGX(alpha=array(3,), view=array(3, 3)), view=array(3, 3))"
    assert repr(lobe.take([0, 2]).by_point.keys()) == "dict_keys(['lobe.alpha', 'lobe.view', 'view'])"
    for wrong in ("reflection(0.3, view=(0, 0, 1))", "reflection(ggx(alpha=0.3), lobe=ggx(alpha=0.3), view=(0, 0, 1))"):
        with pytest.raises(TypeError, match=r"want reflection\(lobe=..., view=...\)"):
            make(wrong)


def test_reflections_of_reflections_are_lobes():
    """Two mirrors: directions and densities of the law of `verify`, for a lobe over the whole sphere."""
    lobe = ws.Reflection(ws.Reflection(ws.VisibleGGX(0.5, VIEW), VIEW), slanted(50.0))
    found = verify.judge(verify.Evidence(verify.Subject(repr(lobe), lobe, lobe), every=64, draws=1 << 18), verify.LAWS[:3])
    assert [verdict for verdict in found if not verdict.passed] == []


@wp.func
def clamped_cosine(w: wp.vec3, lobe: funcs.Lobe) -> float:
    """Return max(0, w.n) / p, whose mean over the lobe is pi."""
    return wp.max(wp.dot(w, lobe.normal), 0.0) / lobe.pdf


@wp.func
def squared_cosine(w: wp.vec3, lobe: funcs.Lobe) -> float:
    """Return (w.n)^2 / p, whose mean over the lobe is 4 pi / 3."""
    z = wp.dot(w, lobe.normal)
    return z * z / lobe.pdf


@pytest.mark.slow
@pytest.mark.parametrize("function", [clamped_cosine, pytest.param(squared_cosine, marks=pytest.mark.thorough)])
def test_a_furnace_of_rough_reflections_has_closed_integrals(function):
    """Over 10^4 points of different roughness and view; the error bars are honest.

    Visible normals reflect the view to w.z > -v.z, where the integral of (w.n)^2 is 2 pi (1 + v.z^3) / 3.
    """
    rng = np.random.default_rng(8)
    points = 10_000
    normals, view = rng.normal(size=(2, points, 3))
    view[:, 2] = abs(view[:, 2]) + 0.3  # at grazing views 1 / p has no moments to speak of
    lobe = ws.Reflection(ws.VisibleGGX(rng.uniform(0.5, 1.0, points), view=view), view)
    e = ws.integrate(normals, function, 256, distribution=lobe)
    z = lobe.view[:, 2].astype(np.float64)
    exact = np.pi if function is clamped_cosine else 2.0 * np.pi * (1.0 + z * z * z) / 3.0
    error = e.value.astype(np.float64) - exact
    assert error.mean() == pytest.approx(0.0, abs=1e-3)
    assert 0.9 <= np.square(error).mean() / np.square(e.standard_error.astype(np.float64)).mean() <= 1.1
