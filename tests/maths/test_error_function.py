"""The error function and its inverse against SciPy's, and the slopes that the view sees against bisection."""

import numpy as np
import pytest
import warp as wp
from scipy import special

import warpsample as ws
from warpsample.distributions.microfacets.visible_beckmann import gaussian_slope, slope_along_view
from warpsample.maths.error_function import erfc_double, erfc_inverse_roughly
from warpsample.maths.exponentials import logarithm


@wp.kernel(enable_backward=False)
def _error_function(x: wp.array[wp.float64], tail: wp.array[wp.vec2d]):
    tail[wp.tid()] = erfc_double(x[wp.tid()])


@wp.kernel(enable_backward=False)
def _inverse(share: wp.array[wp.float64], x: wp.array[wp.float64]):
    x[wp.tid()] = wp.float64(erfc_inverse_roughly(share[wp.tid()]))


@wp.kernel(enable_backward=False)
def _logarithm(x: wp.array[wp.float64], y: wp.array[wp.float64]):
    y[wp.tid()] = wp.float64(logarithm(wp.float32(x[wp.tid()])))


@wp.kernel(enable_backward=False)
def _gaussian(v: wp.array[wp.float64], slope: wp.array[wp.float64]):
    slope[wp.tid()] = gaussian_slope(wp.float32(v[wp.tid()]))


@wp.kernel(enable_backward=False)
def _along(rest: wp.array[wp.float64], slope: wp.array[wp.float64], a: wp.float64):
    slope[wp.tid()] = slope_along_view(rest[wp.tid()], a)


def launched(kernel, x, *parameters, dtype=wp.float64):
    out = wp.zeros(len(x), dtype=dtype, device="cpu")
    wp.launch(kernel, len(x), inputs=[wp.array(x, dtype=wp.float64, device="cpu"), out, *parameters], device="cpu")
    return out.numpy()


@pytest.fixture(scope="module")
def variates():
    """Of the grid: the first and the last, and some between."""
    cells = np.unique(np.geomspace(1, 2**23, 3000).astype(np.int64))
    return np.concatenate([[0], cells, 2**24 - cells[::-1]]) / 2**24


def visible_share(x, a):
    return 0.5 * a * special.erfc(x) + np.exp(-x * x) / (2.0 * np.sqrt(np.pi))


def test_the_error_function_keeps_its_digits_in_both_tails():
    x = np.concatenate([np.linspace(-6.5, 6.5, 100_001), np.geomspace(1e-300, 1.0, 1001)])
    tail = launched(_error_function, x, dtype=wp.vec2d)
    assert np.abs(tail[:, 0] / special.erfc(x) - 1.0).max() <= 2e-14
    assert np.abs(tail[:, 1] / np.exp(-x * x) - 1.0).max() <= 2e-14


def test_the_error_function_is_at_its_limit_far_out():
    tail = launched(_error_function, np.array([-np.inf, -1e18, 1e18, np.inf]), dtype=wp.vec2d)
    assert tail[:2, 0].tolist() == [2.0, 2.0]
    assert np.all((tail[2:, 0] > 0.0) & (tail[2:, 0] < 1e-19))


def test_the_rough_inverse_is_within_what_it_says():
    share = np.concatenate([np.geomspace(2.0**-25, 1.0, 10_001), 2.0 - np.geomspace(2.0**-25, 1.0, 10_001)])
    exact = special.erfcinv(share)
    # 3e-4: near erfc(x) = 1 the square of x is the difference of numbers near 1 in float32.
    assert np.all(np.abs(launched(_inverse, share) - exact) <= 0.003 * np.abs(exact) + 3e-4)


def test_the_logarithm_of_every_exponent():
    x = np.geomspace(1.2e-38, 3e38, 100_001).astype(np.float32).astype(np.float64)
    x = x[x != 1.0]
    assert np.abs(launched(_logarithm, x) / np.log(x) - 1.0).max() <= 1.2e-7
    assert launched(_logarithm, np.array([1.0])).tolist() == [0.0]


def test_gaussian_slopes_are_quantiles(variates):
    exact = special.ndtri(variates + 2.0**-25) / np.sqrt(2.0)
    assert np.abs(launched(_gaussian, variates) - exact).max() <= 1e-9


@pytest.mark.parametrize(
    "a", [0.0, 1e-9, 1e-3, 0.1, 0.3, 0.7, 1.0, 1.5, 2.0, 2.5, 3.0, 3.5, 4.0, 4.5, 5.0, 6.0, 6.1, 20.0, 1e6, 1e18]
)
def test_slopes_along_the_view_are_those_that_bisection_finds(variates, a):
    """To 2e-8 of what the view sees above the lowest slope: a quarter of float32's rounding, whatever alpha."""
    rest = 1.0 - variates - 2.0**-25
    low, high = np.full_like(rest, -min(a, 6.0)), np.full_like(rest, 6.0)
    target = rest * visible_share(low, a)
    for _ in range(100):
        middle = 0.5 * (low + high)
        above = visible_share(middle, a) > target
        low, high = np.where(above, middle, low), np.where(above, high, middle)
    found = launched(_along, rest, a)
    assert np.all(np.abs(found - low) <= 2e-8 * np.minimum(a + low, 1.0))


def test_slopes_of_the_smallest_and_largest_shares_are_finite():
    views = [(0.0, 0.0, 1.0), (1e-30, 0.0, 1.0), (1e-3, 0.0, 1.0), (1.0, 0.0, 1e-3), (1.0, 0.0, 0.0)]
    corners = np.array([(u, v) for u in (0.0, 0.5, 1.0 - 2.0**-24) for v in (0.0, 0.5, 1.0 - 2.0**-24)])
    for alpha in (1e-6, 1e-3, 1.0):
        for view in views:
            w = ws.VisibleBeckmann(alpha, view).sample(corners).astype(np.float64)
            assert np.all(np.abs(np.linalg.norm(w, axis=-1) - 1.0) < 2e-7)
            assert np.all(w @ (np.array(view) / np.linalg.norm(view)) > -2e-7)
