"""Gradients of the kernel API's functions of reflection and refraction under wp.Tape, against differences in float64."""

import numpy as np
import pytest
import warp as wp
from jacobians import by_tape, slope

import warpsample as ws
from warpsample import funcs
from warpsample.distributions.parameters import Parameters

wp.set_module_options({"optimization_level": 0})
pytestmark = pytest.mark.slow  # the backward passes are compiled

COUNT = 200
ETAS = (1.5, 1.01, 0.75)


@wp.kernel
def reflect(m: wp.array[wp.vec3], view: wp.array[wp.vec3], w: wp.array[wp.vec3]):
    i = wp.tid()
    w[i] = funcs.normal_to_reflection(m[i], view[i])


@wp.kernel
def halve(w: wp.array[wp.vec3], view: wp.array[wp.vec3], m: wp.array[wp.vec3], ratio: wp.array[wp.float32]):
    i = wp.tid()
    m[i] = funcs.reflection_to_normal(w[i], view[i])
    ratio[i] = funcs.normal_per_reflection(w[i], view[i])


@wp.kernel
def refract(
    m: wp.array[wp.vec3],
    view: wp.array[wp.vec3],
    eta: wp.array[wp.float32],
    w: wp.array[wp.vec3],
    share: wp.array[wp.float32],
):
    i = wp.tid()
    w[i] = funcs.normal_to_refraction(m[i], view[i], eta[i])
    share[i] = funcs.fresnel_dielectric(wp.dot(m[i], view[i]), eta[i])


@wp.kernel
def unrefract(
    w: wp.array[wp.vec3],
    view: wp.array[wp.vec3],
    eta: wp.array[wp.float32],
    m: wp.array[wp.vec3],
    ratio: wp.array[wp.float32],
):
    i = wp.tid()
    m[i] = funcs.refraction_to_normal(w[i], view[i], eta[i])
    ratio[i] = funcs.normal_per_refraction(w[i], view[i], eta[i])


@wp.kernel
def reflect_visible(
    u: wp.array[wp.vec2],
    alpha: wp.array[wp.float32],
    view: wp.array[wp.vec3],
    w: wp.array[wp.vec3],
    density: wp.array[wp.float32],
):
    i = wp.tid()
    m = funcs.square_to_visible_ggx(u[i], alpha[i], view[i])
    w[i] = funcs.normal_to_reflection(m, view[i])
    density[i] = 0.25 * funcs.visible_ggx_per_cosine(m, alpha[i], view[i])


def dot(a, b):
    return np.einsum("ni,ni->n", a, b)


def unit(a):
    return a / np.sqrt(dot(a, a))[:, None]


def reflected(m, v):
    return (unit(2.0 * dot(m, v)[:, None] * m - v),)


def halved(w, v):
    h = w + v
    length = np.sqrt(dot(h, h))
    return h / length[:, None], 0.5 / length


def refracted(m, v, eta):
    c = dot(m, v)
    g = np.sqrt((eta - 1.0) * (eta + 1.0) + c * c)
    share = (((c - g) / (c + g)) ** 2 + ((eta**2 * c - g) / (eta**2 * c + g)) ** 2) / 2.0
    return unit(((c - g) / eta)[:, None] * m - v / eta[:, None]), share


def unrefracted(w, v, eta):
    along = v + eta[:, None] * w
    size = np.sqrt(dot(along, along))
    t = -np.sign(eta - 1.0)[:, None] * along / size[:, None]
    return t, np.abs(dot(w, t)) * eta**2 / size**2


def rounded(*arrays):
    return [a.astype(np.float32).astype(np.float64) for a in arrays]


def directions(seed):
    """Return normals about +z and views, of angles up to 60 degrees between them."""
    rng = np.random.default_rng(seed)
    m, v = (unit(rng.normal(size=(COUNT, 3)) * 0.4 + [0.0, 0.0, 1.0]) for _ in range(2))
    keep = dot(m, v) > 0.5
    return rounded(m[keep], v[keep])


def check(kernel, twin, inputs, limit=2e-5):
    """Compare each Jacobian with central differences, relative to its norm at the point and to the median norm."""
    exact = twin(*inputs)
    found = by_tape(kernel, inputs, [y if y.ndim == 2 else y[:, None] for y in exact])
    for k, x in enumerate(inputs):
        axes = np.eye(3) if x.ndim == 2 else [1.0]
        moves = [slope(lambda h, e=e, k=k: _joined(twin, inputs, k, h * e), 1e-4) for e in axes]
        for rows, columns in zip((f[k] for f in found), zip(*moves, strict=True), strict=True):
            want = np.stack(columns, axis=-1).reshape(rows.shape)
            size = np.sqrt(np.square(want).sum(axis=(1, 2)))
            assert (np.sqrt(np.square(rows - want).sum(axis=(1, 2))) / (size + np.median(size))).max() <= limit


class _Outputs(tuple):
    """Outputs of a twin as one value, which can be added and scaled."""

    __slots__ = ()

    def __add__(self, other):
        return _Outputs(a + b for a, b in zip(self, other, strict=True))

    def __sub__(self, other):
        return _Outputs(a - b for a, b in zip(self, other, strict=True))

    def __rmul__(self, factor):
        return _Outputs(factor * a for a in self)

    def __truediv__(self, divisor):
        return _Outputs(a / divisor for a in self)


def _joined(twin, inputs, k, move):
    return _Outputs(twin(*(x + move if i == k else x for i, x in enumerate(inputs))))


def test_reflections_have_their_derivatives():
    m, v = directions(1)
    check(reflect, reflected, [m, v])
    check(halve, halved, [*rounded(reflected(m, v)[0]), v])


@pytest.mark.parametrize("eta", ETAS)
def test_refractions_have_their_derivatives(eta):
    m, v = directions(2)
    clear = dot(m, v) ** 2 + (eta - 1.0) * (eta + 1.0) > 0.05
    m, v = m[clear], v[clear]
    index = np.full(len(m), np.float32(eta), np.float64)
    check(refract, refracted, [m, v, index], 1e-4)  # the share of an index close to 1 is a small difference
    check(unrefract, unrefracted, [*rounded(refracted(m, v, index)[0]), v, index], 1e-3 if abs(eta - 1.0) < 0.1 else 2e-5)


def test_a_reflection_of_visible_normals_has_finite_derivatives_everywhere():
    grid = np.array([0.0, 2.0**-24, 0.25, 0.5, 1.0 - 2.0**-24])
    u = np.stack(np.meshgrid(grid, grid), axis=-1).reshape(-1, 2)
    for view in ((0.0, 0.0, 1.0), (0.6, -0.64, 0.48), (1.0, 0.0, 0.0)):
        inputs = [u, np.full(len(u), 0.3), np.tile(np.array(view), (len(u), 1))]
        for by_inputs in by_tape(reflect_visible, inputs, [np.zeros((len(u), 3)), np.zeros((len(u), 1))]):
            assert all(np.isfinite(jacobian).all() for jacobian in by_inputs)
    v = np.array([[0.6, 0.0, 0.8], [0.0, 0.0, 1.0]])
    for w in (-v, v, v[::-1]):
        for kernel, given in ((halve, [w, v]), (unrefract, [w, v, np.full(2, 1.5)]), (refract, [w, v, np.full(2, 0.5)])):
            for by_inputs in by_tape(kernel, given, [np.zeros((2, 3)), np.zeros((2, 1))]):
                assert all(np.isfinite(jacobian).all() for jacobian in by_inputs)


def test_a_lobe_of_a_lobe_has_gradients_by_its_kernel_parameters():
    """By the function of a Reflection, of (normal, u, Parameters), as a user's kernel calls it."""
    lobe = ws.Reflection(ws.VisibleGGX(0.3, (0.6, 0.0, 0.8)), (0.6, 0.0, 0.8))
    about = lobe.about()

    @wp.kernel
    def draw(n: wp.vec3, u: wp.array[wp.vec2], parameters: Parameters, out: wp.array[wp.vec4]):
        i = wp.tid()
        out[i] = about(n, u[i], parameters)

    u = wp.array(np.array([[0.3, 0.7], [0.6, 0.1]]), dtype=wp.vec2, device="cpu", requires_grad=True)
    out = wp.zeros(2, wp.vec4, device="cpu", requires_grad=True)
    tape = wp.Tape()
    with tape:
        wp.launch(draw, 2, inputs=[wp.vec3(0.0, 0.0, 1.0), u, lobe.kernel_parameters()], outputs=[out], device="cpu")
    tape.backward(grads={out: wp.array(np.ones((2, 4), np.float32), dtype=wp.vec4, device="cpu")})
    found = u.grad.numpy().astype(np.float64)

    def total(points):
        w = lobe.sample(points.astype(np.float32)).astype(np.float64)
        return w.sum(axis=1) + lobe.pdf(w)

    step = 2.0**-10
    exact = [(total(u.numpy() + step * e) - total(u.numpy() - step * e)) / (2.0 * step) for e in np.eye(2)]
    assert found == pytest.approx(np.stack(exact, axis=1), rel=2e-2)  # differences of float32
