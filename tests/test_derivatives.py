"""Gradients of the kernel API's wp.funcs under wp.Tape: equal to those of the float64 twins, and finite everywhere."""

import numpy as np
import pytest
import warp as wp
from jacobians import CASES, LAST, all_cases, by_tape, framed, kernels, like, of_case, parameters, slope, square_points

import warpsample as ws
from warpsample import funcs
from warpsample.proof import twins
from warpsample.proof.twins import lights, microfacets, shapes
from warpsample.statistics.charts import chart_of

pytestmark = pytest.mark.slow  # the backward passes of all functions are compiled, for each worker
U = square_points()
WITH_PARAMETER = [case for case in CASES if case.parameters]
WITH_VIEW = [case for case in CASES if "view" in case.parameters]
INVERTIBLE = [case for case in CASES if case.maps.invert is not None]
SEAMED = ("visible_ggx", "linearly_transformed_cosine", "spherical_triangle")
"""Maps whose inverse is not precise at their seams."""
PLUS_Z = (0.0, 0.0, 1.0)
TOO_NARROW = (ws.OffsetSphere(1e-15), ws.UniformCone(one_minus_cos=1e-24))
"""The derivatives of these densities do not fit into float32."""


@pytest.fixture(autouse=True)
def _twins_of_any_parameter(monkeypatch):
    """Replace the twins' rounding of parameters to float32, because difference quotients need exact parameters."""
    for module in (shapes, microfacets):
        monkeypatch.setattr(module, "parameter", lambda d, name: float(getattr(d, name)))
    monkeypatch.setattr(microfacets, "_view_of", lambda d: d.view)
    monkeypatch.setattr(shapes, "_matrix", lambda d: d.matrix)
    monkeypatch.setattr(lights, "_values_of", lambda d, name: np.asarray(getattr(d, name), np.float64))


def norm(a, axis=-1):
    return np.sqrt((a * a).sum(axis=axis))


def sizes(case):
    """Return the scale on which a distribution varies with each parameter, by name.

    A Henyey-Greenstein lobe is as wide as 1 - abs(g). For exponents and concentrations below 1 the scale is
    1. For a view it depends on the angles to +z and to the horizon. For a matrix and for corners it is the smallest
    singular value.
    """
    known = parameters(case)
    found = {name: float(value) for name, value in known.items() if value.ndim == 0}
    if case.name in ("power_cosine", "von_mises_fisher"):
        found = {name: max(value, 1.0) for name, value in found.items()}
    if case.name == "henyey_greenstein":
        found["g"] = 1.0 - abs(found["g"])
    if "view" in known:
        across = np.hypot(*case.view[:2])
        alpha = min(case.alpha, case.alpha_y or case.alpha)
        found["view"] = min(across or 1.0, np.hypot(case.view[2], alpha * across))
    for name in {"corner", "edge_x", "edge_y"} & set(known):
        found[name] = np.linalg.svd(case.stretch, compute_uv=False).min()
    for name in {"matrix", "corners"} & set(known):
        found[name] = np.linalg.svd(known[name], compute_uv=False).min()
    return found


def by_parameter(case, f, name, fineness):
    """Return the derivative (..., k) of f(case) with respect to the k components of a parameter."""
    value = parameters(case)[name]
    axes = np.eye(value.size).reshape(-1, *value.shape)
    step = fineness * sizes(case)[name]
    return np.stack([slope(lambda h, axis=axis: f(like(case, **{name: value + h * axis})), step) for axis in axes], axis=-1)


def with_derivative(case):
    """Return the names of the parameters with a derivative of the map: the azimuth of a view along +z jumps."""
    return [name for name in case.parameters if name != "view" or case.view != PLUS_Z]


def fineness(case):
    """Return the relative step for a twin's directions; with a view, bisection or cancellation makes them less exact."""
    return 1e-2 if case in WITH_VIEW else 1e-5


def by_square(case, u):
    """Return the derivative (N, width, 2) of a twin's directions with respect to u, inside the square."""
    gap = np.minimum(u, 1.0 - u)
    step = 1e-2 if case.name == "visible_beckmann" else 1e-3
    columns = [
        slope(lambda h, k=k: twins.directions(case, u + h * gap * np.eye(2)[k]), step) / gap[:, k : k + 1] for k in (0, 1)
    ]
    return np.stack(columns, axis=-1)


def inside(case):
    """Return variates inside the square and off the stated seams, where an inverse is differentiable."""
    u = U[(U.min(axis=1) > 0.0) & (U.max(axis=1) < LAST)]
    if getattr(case, "method", "") == "concentric":
        return u[np.abs(np.abs(u[:, 0] - 0.5) - np.abs(u[:, 1] - 0.5)) > 1e-3]
    # Elsewhere the rounding of w alone changes their gradients by 1e-4, or moves w out of a light.
    if case in WITH_VIEW or case.support in ("triangle", "rectangle"):
        u = u[(u.min(axis=1) > 5e-4) & (u.max(axis=1) < 1.0 - 5e-4)]
    return u[~case.seam(u)] if case.name in SEAMED else u


def off_edges(case, w):
    """Return whether a density is differentiable at w: away from a clamped edge and from a blurred horizon."""
    if case.name == "offset_sphere":
        return min(case.rho, 1.0) ** 2 - norm(w[:, :2]) ** 2 > 1e-2 * min(case.rho, 1.0) ** 2
    if case.support in ("triangle", "rectangle"):
        o = w @ np.linalg.inv(case.stretch).T
        gap = o.min(axis=1) if case.support == "triangle" else o[:, 2] - np.abs(o[:, :2]).max(axis=1)
        return gap > 1e-3 * norm(o)
    if case.stretch is not None and case not in WITH_VIEW:
        return np.cos(chart_of(case).polar(w)) > 1e-3
    if case not in WITH_VIEW:
        return np.ones(len(w), bool)
    # Differences are of a direction along any axis, and so are less precise where the lobe is narrower along one.
    return w @ case.view > (1e-3 if case.alpha_y is None else 3e-3) * case.alpha + 2e-6


def tangents(w):
    """Return orthonormal vectors (N, 2 or 1, width) perpendicular to the directions w."""
    if w.shape[1] == 2:
        return np.stack([-w[:, 1], w[:, 0]], axis=1)[:, None]
    return twins.frames(w / norm(w)[:, None])[:, :, :2].swapaxes(1, 2)


def moved(w, by):
    """Return the unit vectors along w + by."""
    return (w + by) / norm(w + by)[:, None]


def test_every_smooth_function_is_tried():
    smooth = {name for name in funcs.__all__ if "square" in name and "environment" not in name}
    assert smooth == {func.key for func in kernels()}


@pytest.mark.parametrize("case", WITH_PARAMETER, ids=repr)
def test_maps_follow_their_parameters(case):
    """At each point the error is relative to the derivative there and, where that is small, to its median."""
    _, *found = of_case(case, case.maps.sample, U, case.width)
    # At 0 the twin of visible GGX normals takes the root of its rounding error.
    u = np.maximum(U, (1e-12 if case in WITH_VIEW else 0.0, 0.0))
    for name, a in zip(case.parameters, found, strict=True):
        if name in with_derivative(case):
            b = by_parameter(case, lambda d: twins.directions(d, u), name, fineness(case))
            size = norm(b, (1, 2))
            error = norm(a - b, (1, 2)) / (size + np.median(size))
            # As narrow as 1e-3, visible GGX normals leave float32 no more digits near the cap's pole.
            assert error.max() <= (3e-4 if case.name == "visible_ggx" else 1e-5)


@pytest.mark.parametrize("case", CASES, ids=repr)
def test_densities_follow_the_direction_and_the_parameters(case):
    """Derivatives are along the sphere; off the sphere a density depends on the form of its formula.

    The error is relative to the derivative and the density, this over the change of a parameter that changes it by itself.
    """
    w = twins.directions(like(case), U).astype(np.float32).astype(np.float64)
    w = w[off_edges(case, w)]
    by_w, *found = (jacobian[:, 0] for jacobian in of_case(case, case.maps.pdf, w, 1))
    value = twins.density(like(case), w)
    errors = []
    if case.width == 3 or case.measure == "per radian":
        size = min((size for name, size in sizes(case).items() if name != "view"), default=1.0)
        width = 1.0 / np.sqrt(size) if case.name in ("power_cosine", "von_mises_fisher") else size or 1.0
        gap = np.cos(chart_of(case).polar(w)) if case.support == "hemisphere" else 1.0  # to the horizon
        step = np.minimum(1e-5 * min(width, 1.0), 1e-2 * min(width, 1.0) * gap) * np.ones(len(w))
        for t in tangents(w).swapaxes(0, 1):
            exact = slope(lambda h, t=t: twins.density(like(case), moved(w, h[:, None] * t)), step)
            errors.append(np.abs(np.einsum("ni,ni->n", by_w, t) - exact) / (np.abs(exact) + value))
    for name, by_p in zip(case.parameters, found, strict=True):
        # At rho = 1 the second derivative jumps.
        fine = 1e-9 if case == ws.OffsetSphere(1.0) else 1e-5
        exact = by_parameter(case, lambda d: twins.density(d, w), name, fine)
        errors.append(norm(by_p - exact) / (norm(exact) + value / sizes(case)[name]))
    # A derivative with respect to one of two roughnesses is a sum over their mean and both quotients, which cancels in part.
    limit = 1e-5 if getattr(case, "alpha_y", None) is None else 2e-5
    assert max((e.max() for e in errors), default=0.0) <= limit


@pytest.mark.parametrize("case", INVERTIBLE, ids=repr)
def test_inverses_follow_the_direction_and_the_parameters(case):
    """By the implicit function theorem on the map's twin: map(inverse(w, p), p) = w."""
    u = inside(case)
    w = twins.directions(like(case), u)
    by_w, *found = of_case(case, case.maps.invert, w, 2)
    by_u = by_square(like(case), u)[..., : case.variates]
    back = np.linalg.pinv(by_u)
    count = case.variates
    if case.measure != "per unit area":
        by_w = by_w - (by_w @ w[:, :, None]) * w[:, None, :]
    errors = [norm(by_w[:, :count] - back) / norm(back)]
    for name, by_p in zip(case.parameters, found, strict=True):
        if name in with_derivative(case):
            exact = -(back @ by_parameter(case, lambda d: twins.directions(d, u), name, fineness(case)))
            errors.append(norm(by_p[:, :count] - exact, (1, 2)) / (norm(exact, (1, 2)) + 1.0 / sizes(case)[name]))
    assert max(e.max() for e in errors) <= 1e-4


@pytest.mark.parametrize("case", CASES, ids=repr)
def test_maps_follow_the_square(case):
    u = inside(case)
    found = of_case(case, case.maps.sample, u, case.width)[0]
    exact = by_square(like(case), u)
    size = norm(exact, 1)
    error = norm(found - exact, 1) / (size + np.median(size, axis=0) + 1e-30)
    assert error.max() <= 1e-4


NORMALS = np.array(
    [
        *np.eye(3),
        *-np.eye(3),
        *((0.6, 0.8, 0.0), (0.6, 0.8, -0.0), (1e-4, 0.0, -1.0), (0.0, -1e-4, -1.0), (1e-20, 1e-30, -1.0), (1.0, 0.0, -1e-7)),
        *np.random.default_rng(6).normal(size=(100, 3)),
    ]
)


def test_frames_follow_the_normal_and_the_direction():
    """The frame jumps where z changes sign, so z is moved away from 0."""
    n = (NORMALS / norm(NORMALS)[:, None]).astype(np.float32).astype(np.float64)
    w = np.random.default_rng(7).normal(size=n.shape).astype(np.float32).astype(np.float64)
    away = np.copysign(1.0, n[:, 2])[:, None]
    frames = twins.frames(n)
    for found, columns, transposed in zip(by_tape(framed, (n, w), (n, n)), ("nij", "nji"), (False, True), strict=True):

        def turned(m, columns=columns):
            return np.einsum(f"{columns},nj->ni", twins.frames(m), w)

        steps = [turned(n + k * 1e-3 * away * axis) for axis in np.eye(3) for k in range(5)]
        one_sided = np.array(steps).reshape(3, 5, *n.shape) * np.array([-25.0, 48.0, -36.0, 16.0, -3.0])[:, None, None]
        exact = np.moveaxis(one_sided.sum(axis=1) / 12e-3, 0, -1) * away[:, None]
        by_n, by_w = found
        assert np.abs(by_n - exact).max() <= 1e-5
        assert np.abs(by_w - (frames.swapaxes(1, 2) if transposed else frames)).max() <= 2e-7


@pytest.mark.parametrize("case", all_cases(), ids=repr)
def test_no_gradient_is_nan_or_infinite(case):
    """This includes the bounds of the parameters, directions outside the support, and points without a derivative."""
    up = np.eye(case.width)[-1]
    tiny = 10.0 ** -np.arange(1.0, 45.0, 4.0)[:, None] * np.eye(case.width)[0]
    w = np.random.default_rng(8).normal(size=(100, case.width))
    w = np.concatenate(
        [moved(w, 0.0 * w), *(sign * (x + y) for sign in (1.0, -1.0) for x, y in ((tiny, up), (np.eye(case.width), 0.0)))]
    )
    w = np.concatenate([w, -0.0 * w[:1] + up, twins.directions(like(case), U)])
    for func, x, width in ((case.maps.sample, U, case.width), (case.maps.pdf, w, 1), (case.maps.invert, w, 2)):
        for jacobian in of_case(case, func, x, width) if func is not None else ():
            assert not np.isnan(jacobian).any()
            if case not in TOO_NARROW:
                assert np.isfinite(jacobian).all()


def test_what_has_no_derivative_has_gradient_0():
    """The azimuth at the pole, the first and last cells of an inverse, the azimuth of a view from above."""
    pole = np.array([[0.0, 0.0, 1.0], [-0.0, 0.0, 1.0]])
    for case in (ws.UniformSphere(), ws.GGX(0.3), ws.VonMisesFisher(8.0), ws.CosineHemisphere("concentric")):
        assert not of_case(case, case.maps.invert, pole, 2)[0][:, 1].any()
    for method in ("polar", "concentric"):  # a zero of either sign is the same point
        zeros = np.array([[0.5, 0.0], [0.5, -0.0], [0.0, 0.5], [-0.0, 0.5]])
        found = of_case(ws.UniformDisk(method), ws.UniformDisk(method).maps.invert, zeros, 2)[0]
        assert np.array_equal(found[::2], found[1::2])
    edge = np.array([[1.0, 0.0, 0.0]])
    assert not of_case(ws.GGX(0.3), ws.GGX(0.3).maps.invert, edge, 2)[0][:, 0].any()
    for case in (ws.VisibleGGX(0.3), ws.VisibleBeckmann(0.3)):
        assert not of_case(case, case.maps.sample, U, 3)[-1][..., :2].any()
        assert of_case(case, case.maps.pdf, moved(U @ np.eye(2, 3), pole[:1]), 1)[-1][..., :2].any()  # its density has one


@pytest.mark.thorough
def test_gradients_compile_for_cuda(tmp_path, monkeypatch):
    kernels()
    monkeypatch.setitem(framed.module.options, "optimization_level", None)  # CUDA's own
    (ptx,) = wp.compile_aot_module(framed.module, device=None, arch=86, use_ptx=True, module_dir=tmp_path)
    assert ptx.read_text().count("_backward") >= len(kernels())
