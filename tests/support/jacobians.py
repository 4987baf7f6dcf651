"""Derivatives of wp.funcs by a tape, of float64 functions by differences, and the cases at which they are compared."""

from functools import cache
from types import SimpleNamespace

import numpy as np
import warp as wp

import warpsample as ws
from warpsample.distributions.parameters import parameter_types
from warpsample.maths.frames import frame_about, to_local, to_world

# Without it this module takes twice as long to compile; the adjoints are the same arithmetic.
wp.set_module_options({"optimization_level": 0})

VECTORS = {1: wp.float32, 2: wp.vec2, 3: wp.vec3}
CELL = 2.0**-24
LAST = 1.0 - CELL

VIEWS = ((0.0, 0.0, 1.0), (0.6, -0.64, 0.48), (1.0, 0.0, 0.0), (-0.8, 0.0, 0.6), (1e-4, 0.0, 1.0))
CASES = [
    *(kind(alpha) for kind in (ws.GGX, ws.Beckmann) for alpha in (1e-3, 0.05, 0.3, 1.0)),
    *(kind(*alphas) for kind in (ws.GGX, ws.Beckmann) for alphas in ((0.3, 0.05), (1e-3, 1e-2), (1.0, 0.2))),
    *map(ws.PowerCosine, (0.0, 1.0, 2.5, 100.0, 1e6)),
    *map(ws.VonMisesFisher, (1e-6, 0.5, 8.0, 20.0, 1000.0, 1e6)),
    *map(ws.HenyeyGreenstein, (0.0, 1e-4, 0.7, -0.7, -0.99, 0.9999)),
    *map(ws.OffsetSphere, (1e-3, 0.5, 1.0, 1.5, 100.0)),
    *(ws.UniformCone(one_minus_cos=c) for c in (1.999, 1.0, 0.25, 1e-5)),
    *(kind(0.3, view, 0.1) for kind in (ws.VisibleGGX, ws.VisibleBeckmann) for view in VIEWS),
    *(kind(alpha, view) for kind in (ws.VisibleGGX, ws.VisibleBeckmann) for alpha in (1e-3, 0.3, 1.0) for view in VIEWS),
    *ws.LinearlyTransformedCosine.cases(),
    *ws.SphericalTriangle.cases(),
    *ws.SphericalRectangle.cases(),
    *map(ws.CosineHemisphere, ("polar", "concentric", "inversion", "offset")),
    *map(ws.UniformDisk, ("polar", "concentric")),
    *(ws.UniformSphere(), ws.UniformHemisphere(), ws.OffsetBall(), ws.OffsetDisk(), ws.OffsetCircle()),
]
"""Every distribution, from narrow to wide; a view from above, from the side, from the horizon."""


def square_points(count=200):
    """(N, 2) float64 on the grid: its corners, the pole u[0] = 0 and the horizon with them, and random ones."""
    edges = (0.0, CELL, 16777 * CELL, 0.25, 0.5, 0.75, LAST)
    corners = np.stack(np.meshgrid(edges, edges, indexing="ij"), axis=-1).reshape(-1, 2)
    return np.concatenate([corners, np.random.default_rng(5).integers(0, 2**24, (count, 2)) * CELL])


def all_cases():
    """The distributions, also at the bounds of their parameters; not lobes of lobes, whose functions are made of others."""
    more = [case for name in ws.distributions.names() for case in ws.distributions.get(name).cases()]
    every = dict.fromkeys([*CASES, *more])
    return [case for case in every if not case.in_world and not case.nested]  # pictures: test_environment_map.py


def make(func, argument, result):
    """A user's kernel: one call for each row, with every parameter an array."""
    kinds = [wp.float32 if kind is float else kind for kind in parameter_types(func)]
    first, second, third = (*kinds, wp.float32, wp.float32, wp.float32)[:3]
    if not kinds:

        @wp.kernel
        def call(x: wp.array[argument], out: wp.array[result]):
            i = wp.tid()
            out[i] = func(x[i])

    elif len(kinds) == 1:

        @wp.kernel
        def call(x: wp.array[argument], p: wp.array[first], out: wp.array[result]):
            i = wp.tid()
            out[i] = func(x[i], p[i])

    elif len(kinds) == 2:

        @wp.kernel
        def call(x: wp.array[argument], p: wp.array[first], q: wp.array[second], out: wp.array[result]):
            i = wp.tid()
            out[i] = func(x[i], p[i], q[i])

    else:

        @wp.kernel
        def call(
            x: wp.array[argument],
            p: wp.array[first],
            q: wp.array[second],
            r: wp.array[third],
            out: wp.array[result],
        ):
            i = wp.tid()
            out[i] = func(x[i], p[i], q[i], r[i])

    return call


@cache
def kernels():
    """{wp.func: its kernel}, all made before the first is compiled: they share one module."""
    made = {}
    for case in all_cases():
        funcs = (case.maps.sample, case.maps.pdf, case.maps.invert)
        widths = ((2, case.width), (case.width, 1), (case.width, 2))
        for func, (width, out_width) in zip(funcs, widths, strict=True):
            if func is not None and func not in made:
                made[func] = make(func, VECTORS[width], VECTORS[out_width])
    return made


@wp.kernel
def framed(n: wp.array[wp.vec3], w: wp.array[wp.vec3], out: wp.array[wp.vec3], back: wp.array[wp.vec3]):
    i = wp.tid()
    frame = frame_about(n[i])
    out[i] = to_world(frame, w[i])
    back[i] = to_local(frame, w[i])


def vectors(x):
    """An array on the CPU that asks for a gradient."""
    x = np.ascontiguousarray(x, np.float32)
    kind = wp.mat33 if x.ndim == 3 else VECTORS[x.shape[1] if x.ndim == 2 else 1]
    return wp.array(x, dtype=kind, device="cpu", requires_grad=True)


def by_tape(kernel, inputs, output):
    """The output's Jacobians by each input: (N, out, in) float64; `output` is (N, out) of any float, for its shape."""
    arrays = [vectors(x) for x in inputs]
    out = [vectors(np.zeros(y.shape[:1] if y.shape[1] == 1 else y.shape)) for y in output]
    tape = wp.Tape()
    with tape:
        wp.launch(kernel, len(inputs[0]), inputs=arrays, outputs=out, device="cpu")
    found = []
    for array, y in zip(out, output, strict=True):
        rows = []
        for component in range(y.shape[1]):
            ones = np.zeros(y.shape, np.float32)
            ones[:, component] = 1.0
            tape.backward(grads={array: wp.array(ones.reshape(array.numpy().shape), dtype=array.dtype, device="cpu")})
            rows.append([a.grad.numpy().astype(np.float64).reshape(len(a), -1) for a in arrays])
            tape.zero()
        found.append([np.stack(by_input, axis=1) for by_input in zip(*rows, strict=True)])
    return found


def of_case(case, func, x, out_width):
    """The Jacobians of a function of a case at the rows x: by x, and by each parameter, with its components in a row."""
    inputs = (x, *(np.repeat(value[None], len(x), axis=0) for value in parameters(case).values()))
    return by_tape(kernels()[func], inputs, [np.zeros((len(x), out_width))])[0]


def parameters(case):
    """The parameters of a case as a kernel takes them, in float64, by name."""
    return {name: np.array(getattr(case, name), np.float32).astype(np.float64) for name in case.parameters}


def like(case, **changed):
    """What the twins read of a case, with other parameters, also beyond their bounds."""
    return SimpleNamespace(name=case.name, method=getattr(case, "method", None), **parameters(case) | changed)


def slope(f, step):
    """df/dh at h = 0 of a float64 function, by central differences of fourth order."""
    return (8.0 * (f(step) - f(-step)) - (f(2.0 * step) - f(-2.0 * step))) / (12.0 * step)
