"""Each building block is compared with float64 over its whole range, and at its special values."""

import numpy as np
import pytest
import warp as wp

from warpsample.distributions.cosine_hemisphere import square_to_cosine_hemisphere
from warpsample.maths.angles import turns_of
from warpsample.maths.exponentials import exp_double, log1p, log1p_double
from warpsample.maths.frames import frame_about, to_local, to_world
from warpsample.maths.numerics import GRID, direction_to_unit, normalize, reverse_bits, sincos_turns, weyl

GOLDEN = 0x9E3779B97F4A7C15


@wp.kernel(enable_backward=False)
def _on_grid(out: wp.array2d[wp.float32]):
    i = wp.tid()
    u = wp.float32(i) / 16777216.0
    cs = sincos_turns(u)
    out[i, 0] = cs[0]
    out[i, 1] = cs[1]
    out[i, 2] = turns_of(cs[0], cs[1])
    out[i, 3] = log1p(-u)


@wp.kernel(enable_backward=False)
def _frames(v: wp.array[wp.vec3], unit: wp.array[wp.vec3], frame: wp.array[wp.mat33], back: wp.array[wp.vec3]):
    i = wp.tid()
    n = normalize(v[i])
    f = frame_about(n)
    unit[i] = n
    frame[i] = f
    back[i] = to_local(f, to_world(f, wp.vec3(0.36, 0.48, 0.8)))


@wp.kernel(enable_backward=False)
def _units(v: wp.array[wp.vec3], unit: wp.array[wp.vec4]):
    unit[wp.tid()] = direction_to_unit(v[wp.tid()])


@wp.kernel(enable_backward=False)
def _log1p(x: wp.array[wp.float32], out: wp.array[wp.float32]):
    i = wp.tid()
    out[i] = log1p(x[i])


@wp.kernel(enable_backward=False)
def _doubles(x: wp.array[wp.float64], log: wp.array[wp.float64], exponential: wp.array[wp.vec2d]):
    i = wp.tid()
    log[i] = log1p_double(x[i])
    exponential[i] = exp_double(x[i])


@wp.kernel(enable_backward=False)
def _integers(x: wp.array[wp.uint32], step: wp.uint64, phase: wp.array[wp.uint32], reverse: wp.array[wp.uint32]):
    i = wp.tid()
    phase[i] = weyl(x[i], step)
    reverse[i] = reverse_bits(x[i])


def framed(v):
    v = np.asarray(v, np.float32)
    outputs = [wp.zeros(len(v), dtype=kind, device="cpu") for kind in (wp.vec3, wp.mat33, wp.vec3)]
    wp.launch(_frames, len(v), inputs=[wp.array(v, dtype=wp.vec3, device="cpu")], outputs=outputs, device="cpu")
    return [a.numpy().astype(np.float64) for a in outputs]


@pytest.fixture(scope="module")
def grid():
    out = wp.zeros((GRID, 4), dtype=wp.float32, device="cpu")
    wp.launch(_on_grid, GRID, outputs=[out], device="cpu")
    return np.arange(GRID) / GRID, out.numpy().astype(np.float64)


@pytest.mark.slow
def test_sincos_of_turns_is_correct_at_every_variate(grid):
    u, out = grid
    # Rounding the result costs 3.0e-8; the polynomials and their evaluation as much again.
    assert np.abs(out[:, 0] - np.cos(2 * np.pi * u)).max() <= 6e-8
    assert np.abs(out[:, 1] - np.sin(2 * np.pi * u)).max() <= 6e-8


@pytest.mark.slow
def test_sincos_of_turns_is_exact_at_the_quarters(grid):
    _, out = grid
    quarters = out[:: GRID // 4, :2]
    assert quarters.tolist() == [[1, 0], [0, 1], [-1, 0], [0, -1]]


@pytest.mark.slow
def test_turns_come_back_at_every_variate(grid):
    u, out = grid
    difference = out[:, 2] - u
    # One cell of the grid: near u = 1 that is the spacing of float32.
    assert np.abs(difference - np.round(difference)).max() <= 2.0**-24
    assert out[:, 2].min() >= 0.0
    assert out[:, 2].max() < 1.0


@pytest.mark.slow
def test_log1p_is_correct_at_every_variate(grid):
    u, out = grid
    exact = np.log1p(-u[1:])
    assert np.abs(out[1:, 3] / exact - 1.0).max() <= 8.2e-8
    assert out[0, 3] == 0.0


def test_log1p_keeps_its_digits_from_the_smallest_to_the_largest_float():
    x = np.concatenate([np.geomspace(1e-45, 3e38, 100_001), -np.geomspace(1e-45, 0.999, 10_001)]).astype(np.float32)
    x = x[x != 0.0]
    out = wp.zeros(len(x), dtype=wp.float32, device="cpu")
    wp.launch(_log1p, len(x), inputs=[wp.array(x, device="cpu")], outputs=[out], device="cpu")
    exact = np.log1p(x.astype(np.float64))
    normal = np.abs(exact) >= 1.2e-38  # below that a float32 has fewer digits to keep
    assert np.abs(out.numpy()[normal] / exact[normal] - 1.0).max() <= 1.2e-7
    assert np.abs(out.numpy()[~normal] - exact[~normal]).max() <= 1.5e-45


def in_double(x):
    log, exponential = wp.zeros(len(x), dtype=wp.float64, device="cpu"), wp.zeros(len(x), dtype=wp.vec2d, device="cpu")
    wp.launch(_doubles, len(x), inputs=[wp.array(x, device="cpu")], outputs=[log, exponential], device="cpu")
    return log.numpy(), exponential.numpy()


def test_log1p_in_double():
    x = np.concatenate([np.geomspace(1e-300, 1e38, 100_001), -np.geomspace(1e-300, 1.0 - 1e-9, 100_001)])
    assert np.abs(in_double(x)[0] / np.log1p(x) - 1.0).max() <= 2e-15
    deep = np.geomspace(1e-37, 0.1, 10_001) - 1.0  # the sum 1 + x is then exact, x alone is not
    deep = deep[1.0 + deep > 1e-15]
    assert np.abs(in_double(deep)[0] / np.log1p(deep) - 1.0).max() <= 2e-15


def test_exponential_in_double():
    x = np.concatenate([np.geomspace(1e-300, 170.0, 100_001), -np.geomspace(1e-300, 170.0, 100_001), [0.0, -1e4, -np.inf]])
    less_one, exponential = in_double(x)[1].T
    assert np.abs(exponential / np.exp(np.maximum(x, -170.0)) - 1.0).max() <= 3e-14
    near = x != 0.0
    assert np.abs(less_one[near] / np.expm1(x[near]) - 1.0).max() <= 3e-14
    assert less_one[~near].tolist() == [0.0]


@pytest.mark.parametrize("scale", [1e-45, 1e-42, 1e-38, 1e-23, 1e-3, 1.0, 1e20, 1e38, 3.4e38])
def test_normalize_survives(scale):
    directions = [(1, 0, 0), (0, -1, 0), (0, 0, 1), (1, 1, 0), (-1, 1, 1), (1, -1, -1)]
    v = (np.array(directions, np.float64) * scale).astype(np.float32)
    unit, _, _ = framed(v)
    exact = np.sign(v.astype(np.float64)) / np.sqrt(np.count_nonzero(v, axis=1))[:, None]
    assert np.abs(unit - exact).max() <= 6e-8


@pytest.mark.parametrize(
    "v", [(0, 0, 0), (-0.0, 0, -0.0), (np.nan, 0, 1), (1, np.nan, 0), (np.inf, 0, 0), (1, -np.inf, np.nan)], ids=str
)
def test_normalize_gives_zero_for_what_has_no_direction(v):
    unit, _, _ = framed([v])
    assert unit.tolist() == [[0, 0, 0]]


def test_directions_of_rays_of_any_length_get_unit_length():
    """Also of those whose length is almost 1, on both sides of where one step is enough, and nothing is made a direction."""
    rng = np.random.default_rng(7)
    away = rng.normal(size=(400_000, 3))
    length = 1.0 + rng.choice([-1.0, 1.0], 400_000) * 10.0 ** -rng.uniform(2, 9, 400_000)
    length[::10] = 10.0 ** rng.uniform(-44, 38, 40_000)
    v = (away * (length / np.linalg.norm(away, axis=1))[:, None]).astype(np.float32)
    v[:4] = [(0, 0, 0), (np.nan, 0, 1), (np.inf, 0, 0), (0, -np.inf, np.nan)]
    unit = wp.zeros(len(v), wp.vec4, device="cpu")
    wp.launch(_units, len(v), [wp.array(v, wp.vec3, device="cpu")], [unit], device="cpu")
    found, error = np.split(unit.numpy().astype(np.float64)[4:], [3], axis=1)
    exact = v[4:].astype(np.float64)
    exact /= np.linalg.norm(exact, axis=1)[:, None]
    assert np.abs(found - exact).max() <= 2.0**-23  # two roundings of numbers below 1
    assert np.abs(error).max() < 0.1
    np.testing.assert_array_equal(unit.numpy()[:4, 3], [0.5, np.nan, np.nan, np.nan])  # as `scaled_to_unit` says


def test_frame_is_orthonormal_everywhere():
    rng = np.random.default_rng(2)
    v = rng.normal(size=(500_000, 3))
    v[:100_000, 2] *= 1e4  # near both poles
    v[100_000:200_000, 2] *= 10.0 ** -rng.uniform(0, 9, 100_000)  # near the sign's switch
    axes = [
        (1, 0, 0),
        (0, 1, 0),
        (0, 0, 1),
        (-1, 0, 0),
        (0, -1, 0),
        (0, 0, -1),
        (1, 0, -0.0),
        (1e-4, 0, -1),
        (0, 1e-8, -1),
    ]
    v[: len(axes)] = axes
    unit, frame, back = framed(v)
    product = np.einsum("nij,nik->njk", frame, frame)
    assert np.abs(product - np.eye(3)).max() <= 2.2e-7  # two unit vectors with errors of 8e-8 each, and their sum
    assert np.abs(np.linalg.det(frame) - 1.0).max() <= 2.2e-7
    assert np.array_equal(frame[:, :, 2], unit)
    assert np.abs(back - (0.36, 0.48, 0.8)).max() <= 4e-7


@wp.kernel
def _height_and_x(u: wp.array[wp.vec2], out: wp.array[wp.float32]):
    w = square_to_cosine_hemisphere(u[wp.tid()])
    out[wp.tid()] = w[0] + 2.0 * w[2]


def test_maps_can_be_differentiated():
    """Users may optimise through a kernel of their own, so the native fma has a gradient too."""
    points = np.random.default_rng(3).uniform(0.1, 0.9, size=(100, 2)).astype(np.float32)
    u = wp.array(points, dtype=wp.vec2, device="cpu", requires_grad=True)
    out = wp.zeros(100, dtype=wp.float32, device="cpu", requires_grad=True)
    tape = wp.Tape()
    with tape:
        wp.launch(_height_and_x, 100, inputs=[u], outputs=[out], device="cpu")
    tape.backward(grads={out: wp.ones(100, dtype=wp.float32, device="cpu")})
    height, turns = points.T.astype(np.float64)
    r, z, phi = np.sqrt(height), np.sqrt(1 - height), 2 * np.pi * turns
    exact = np.stack([np.cos(phi) / (2 * r) - 1 / z, -2 * np.pi * r * np.sin(phi)], axis=1)
    assert np.abs(u.grad.numpy() - exact).max() <= 2e-5


def test_integer_phase_and_reversal_are_exact():
    x = np.array([0, 1, 2, 63, 10**6, 2**24 - 1, 2**31, 2**32 - 1], np.uint32)
    phase, reverse = (wp.zeros(len(x), dtype=wp.uint32, device="cpu") for _ in range(2))
    wp.launch(_integers, len(x), inputs=[wp.array(x, device="cpu"), GOLDEN], outputs=[phase, reverse], device="cpu")
    exact = [(int(i) * GOLDEN % 2**64) >> 32 for i in x]
    assert phase.numpy().tolist() == exact
    assert reverse.numpy().tolist() == [int(f"{int(i):032b}"[::-1], 2) for i in x]
