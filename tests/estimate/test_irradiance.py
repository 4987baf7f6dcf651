"""Bent normals and irradiance agree with rays, each other and closed forms; pictures are oriented as documented."""

from math import pi

import numpy as np
import pytest
import warp as wp
from estimate_cases import at, square
from weights_of_tests import upward

import warpsample as ws


def test_bent_normals(bunny, points):
    found = ws.bent_normals(bunny, points, 4096)
    way = ws.sample_directions(points, 4096, sequence="sobol", seed=8).vectors
    free = ws.trace(bunny, points, way, any_hit=True).face < 0
    assert np.abs(found.value - (way * free[..., None]).mean(axis=1)).max() <= 6e-3  # 6 of 1e-3
    assert (np.abs(found.value - (way * free[..., None]).mean(axis=1)) <= 6.0 * found.standard_error + 2e-3).all()
    is_open = free.all(axis=1)
    assert np.abs(found.value[is_open] - 2.0 / 3.0 * points.normal[is_open]).max() <= 1e-3


@pytest.mark.slow
def test_irradiance_by_a_picture_and_by_a_function(bunny, points):
    by_function = ws.irradiance(bunny, points, upward, 1024)
    latitudes = np.cos((np.arange(512) + 0.5) / 512 * pi)
    picture = np.repeat((1.0 + latitudes)[:, None], 8, axis=1)
    by_picture = ws.irradiance(bunny, points, picture, 1024)
    assert np.abs(by_function.value - by_picture.value).max() <= 1e-4  # the same rays; bilinear in steps of 0.006 rad
    by_colours = ws.irradiance(bunny, points, np.stack([picture, 2.0 * picture, 0.0 * picture], axis=2), 1024)
    assert np.abs(by_colours.value - by_picture.value[:, None] * [1.0, 2.0, 0.0]).max() <= 1e-5
    uniform = ws.irradiance(bunny, points, np.ones((2, 2)), 1024).value
    assert np.abs(uniform - pi * ws.ambient_occlusion(bunny, points, 1024).value).max() <= 1e-5
    dark = ws.irradiance(bunny, points, np.zeros((2, 2)), 1024)
    assert dark.rays.sum() == 0
    assert dark.skipped.weightless_rays + dark.skipped.empty_rays == 600 * 1024


def test_pictures_lie_as_they_say(tmp_path):
    """A picture with one bright column, at azimuth pi/2 about up, is seen from a wall that faces it."""
    picture = np.zeros((16, 32, 3), np.uint8)
    picture[:8, 8] = 128
    header = b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 16 +X 32\n"
    path = tmp_path / "sky.hdr"
    content = header + np.dstack([picture, np.where(picture[..., :1] > 0, 129, 0)]).astype(np.uint8).tobytes()
    path.write_bytes(content)
    walls = at(np.tile([0.0, 0.0, 9.0], (4, 1)), [(1, 0, 0), (0, 1, 0), (-1, 0, 0), (0, -1, 0)])
    found = ws.irradiance(square(0.0), walls, path, 4096).value
    assert found[1].min() > 0.02
    assert found[3].max() == 0.0
    assert np.abs(found[0] - found[2]).max() < 0.5 * found[1].min()
    on_y = ws.irradiance(square(0.0), walls, path, 4096, up=(1, 0, 0)).value
    assert on_y[0].min() > 0.02 > 20 * on_y[2].max()  # its upper half is now about x, but for the rim that is blended


@wp.func
def _float32(d: wp.vec3):
    return wp.float32(2.0)


@wp.func
def _whole(d: wp.vec3):
    return 2


@wp.func
def _for_kernels_alone(d: wp.vec3) -> wp.float64:
    return wp.where(d[0] > 2.0, wp.float64(1.0), wp.float64(2.0))


def test_an_integrand_may_give_a_whole_number():
    """Radiances are wrapped like integrands; the test below compiles a kernel with rays for each of them."""
    assert ws.integrate([[0.0, 0.0, 1.0]], _whole, 64).value.tolist() == [2.0]


@pytest.mark.thorough
@pytest.mark.parametrize("radiance", [_float32, _whole, _for_kernels_alone], ids=lambda f: f.key)
def test_a_function_may_give_any_number(radiance):
    one = at([0.0, 0.0, 0.0], [0.0, 0.0, 1.0])
    found = ws.irradiance(square(), one, radiance, 64).value
    uniform = 2.0 * pi * ws.ambient_occlusion(square(), one, 64).value
    assert found.shape == (1,)
    assert np.abs(found - uniform).max() <= 2.0**-22 * 2.0 * pi  # the same rays; two roundings to float32


@wp.func
def _yes(d: wp.vec3):
    return d[2] > 0.0


@wp.func
def _not_annotated(d: wp.vec3):
    return wp.where(d[0] > 2.0, 1.0, 2.0)


@pytest.mark.parametrize(
    ("radiance", "message"),
    [
        (np.zeros((4, 4, 2)), r"radiance: got shape \(4, 4, 2\)"),
        (np.full((4, 4), -1.0), "radiance: got numbers below 0"),
        (np.full((4, 4), np.nan), "radiance: got numbers below 0, above"),
        ("sky.png", "radiance: got 'sky.png', which is missing, want an .hdr or .npy file"),
        (np.full((4, 4), 1e300), "radiance: got numbers below 0, above"),
        (np.ma.masked_less(np.ones((4, 4)), 2.0), "radiance: got a masked array, want an array of numbers"),
        ([[1.0, 2.0], [3.0]], "radiance: got .* which NumPy cannot convert to an array"),
        (_yes, "radiance: got a function that returns bool"),
        (_not_annotated, "radiance: got a function without a return type that cannot be called .* annotated"),
        ("text", "radiance: got 'text'"),
        (None, "radiance: got None, want an array of numbers, a path or a wp.func"),
    ],
)
def test_bad_light_is_named(bunny, points, radiance, message):
    with pytest.raises((TypeError, ValueError, FileNotFoundError), match=f"^{message}"):
        ws.irradiance(bunny, points, radiance, 32)
    with pytest.raises(ValueError, match=r"^up: got \(0, 0, 0\), want three finite numbers, not all 0"):
        ws.sky_view_factor(bunny, points, 32, up=(0, 0, 0))
