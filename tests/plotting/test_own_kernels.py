"""The scripts of viz/ that are kernels as users write them: their numbers agree with the package's and with closed forms."""

from math import pi

import matplotlib.image
import numpy as np
import pytest
from scipy.stats import norm

import warpsample as ws
from warpsample.plotting.light_sheet import light_sheet

pytestmark = pytest.mark.slow  # two scripts, whose kernels are compiled for them

BELOW = np.array([[0.0, 0.0, -9.0], [1e-3, 0.0, -9.0], [0.0, 1e-3, -9.0]])  # a face that nothing meets
FLOOR = np.stack([*np.meshgrid(np.linspace(-1.5, 1.5, 20), np.linspace(-1.5, 1.5, 20)), np.zeros((20, 20))], -1).reshape(
    -1, 3
)


@pytest.fixture(scope="module")
def glossy(script):
    return script("glossy_reflection")


@pytest.fixture(scope="module")
def direct(script):
    return script("direct_light")


def unit_normals(count):
    normals = np.random.default_rng(1).normal(size=(count, 3))
    return normals / np.linalg.norm(normals, axis=1, keepdims=True)


def smooth(w):
    """Three colours of light from the direction w, which tell all axes apart."""
    x, y, z = np.moveaxis(w, -1, 0)
    return np.stack([1.0 + x, 1.0 + y * z, 1.5 + z + 0.5 * y], axis=-1)


def test_the_roughest_surface_reflects_the_mean_irradiance(glossy):
    """For alpha = 1 the reflected directions fill the sphere evenly: the cosine-weighted mean is irradiance / pi."""
    picture, normals = smooth(glossy.map_directions(128)), unit_normals(50)
    found = glossy.compute_reflection(picture, normals, 1.0, 4096)
    points = ws.SurfacePoints(np.zeros((50, 3)), normals)
    expected = ws.irradiance((BELOW, [[0, 1, 2]]), points, picture, 4096).value / pi
    assert np.abs(found - expected).max() <= 3e-3


def test_a_polished_surface_is_a_mirror(glossy):
    w = glossy.map_directions(32)
    assert np.abs(glossy.compute_reflection(smooth(w), w, 1e-3, 256) - smooth(w)).max() <= 0.01


@pytest.mark.parametrize("alpha", [0.1, 0.3, 0.6])
def test_roughness_is_that_of_the_ggx_lobe(glossy, alpha):
    """About +z, of a light that depends on the height alone: an integral over one variable."""
    u = (np.arange(100_000) + 0.5) / 100_000
    weight = np.maximum(2.0 * (1.0 - u) / (1.0 + (alpha**2 - 1.0) * u) - 1.0, 0.0)  # the cosine of what a facet reflects
    expected = (weight * weight**2).sum() / weight.sum()
    height = glossy.map_directions(512)[..., 2:]
    found = glossy.compute_reflection(np.repeat(height**2, 3, axis=2), np.array([[0.0, 0.0, 1.0]]), alpha, 16384)
    assert found[0].tolist() == pytest.approx([expected] * 3, rel=2e-3)


def test_the_environment_is_light(glossy):
    made = glossy.environment()
    assert (made.shape, made.dtype) == ((256, 512, 3), np.float32)
    assert 0.0 < made.min() < 0.1
    for lamp in glossy.LAMPS:
        row, column = np.unravel_index(np.argmax(glossy.map_directions(256) @ lamp[:3]), (256, 512))
        assert made[row, column].tolist() == pytest.approx(lamp[3:])


def test_the_ball_reflects_as_a_mirror(glossy):
    """Its normal halves the angle between the reflected direction and the one to the eye."""
    side = 41
    ball = glossy.ball_directions(side)
    assert np.abs(np.linalg.norm(ball, axis=-1) - 1.0).max() <= 1e-12
    x, z = np.linspace(-1.0, 1.0, side), np.linspace(1.0, -1.0, side)
    row, column = 12, 25
    half = ball[row, column] + [0.0, -1.0, 0.0]
    assert half[[0, 2]] / np.linalg.norm(half) == pytest.approx([x[column], z[row]])
    assert ball[20, 20].tolist() == pytest.approx([0.0, -1.0, 0.0])  # back to the eye
    assert ball[0, 0].tolist() == [0.0, 1.0, 0.0]


def unshadowed():
    return ws.tree((BELOW, [[0, 1, 2]]))


@pytest.mark.parametrize("to_lamp", [False, True])
def test_the_lamp_without_a_shadow_has_a_closed_form(direct, plausible, to_lamp):
    found = direct.estimate(unshadowed(), FLOOR, to_lamp, 1024, 1).astype(np.float64)
    away = np.array(direct.LAMP, np.float64) - FLOOR
    squared = (away**2).sum(axis=1)
    expected = pi * direct.RADIUS**2 / squared * away[:, 2] / np.sqrt(squared)
    deviation = (found[:, 0] - expected).sum() / np.sqrt((found[:, 1] ** 2).sum())
    plausible(2.0 * norm.sf(abs(deviation)))


def test_both_ways_agree_in_the_shadow_and_one_is_far_better(direct, plausible):
    tree, points = direct.scene(24)
    lobe, cone = (direct.estimate(tree, points, to_lamp, 512, 2).astype(np.float64) for to_lamp in (False, True))
    assert 20 < np.count_nonzero(cone[:, 0] == 0.0) < 200  # of 576 points: what the bunny stands on or hides from the lamp
    deviation = (lobe[:, 0] - cone[:, 0]).sum() / np.sqrt((lobe[:, 1] ** 2 + cone[:, 1] ** 2).sum())
    plausible(2.0 * norm.sf(abs(deviation)))
    assert (lobe[:, 1] ** 2).mean() > 30.0**2 * (cone[:, 1] ** 2).mean()


@pytest.mark.parametrize("to_lamp", [False, True])
def test_the_errors_are_those_of_repeated_estimates(direct, to_lamp):
    found = direct.estimate(unshadowed(), np.tile([0.3, 0.2, 0.0], (40_000, 1)), to_lamp, 4, 3).astype(np.float64)
    assert found[:, 0].std() == pytest.approx(np.sqrt((found[:, 1] ** 2).mean()), rel=0.05)  # 0.87 if biased


def test_light_is_shown_as_screens_do():
    figure = light_sheet({"title": [np.array([[0.0, 0.5], [3.0, np.nan]])]}, ("row",), (1.0,), "the caption")
    shown = figure.axes[0].images[0].get_array()
    assert shown.tolist() == [[0.0, pytest.approx(0.5 ** (1.0 / 2.2))], [1.0, 1.0]]
    assert (figure.axes[0].get_title(), figure.get_supxlabel()) == ("title", "the caption")


def unlike(picture):
    """How unlike neighbouring pixels are."""
    return np.abs(np.diff(picture.mean(axis=-1), axis=1)).mean()


def test_both_are_drawn(can_render, glossy, direct, tmp_path, capsys):
    files = [tmp_path / "glossy.png", tmp_path / "direct.png"]
    glossy.main(samples=16, screenshot=files[0], size=(800, 340))
    direct.main(samples=16, screenshot=files[1], size=(800, 340))
    said = capsys.readouterr().out.splitlines()
    assert said[0] == f"{files[0]}: 16 directions for each pixel"
    assert said[1].startswith(f"{files[1]}: 16 rays per point; seed 0; Rays of the cosine lobe: RMS standard error 0.0")
    assert set(tmp_path.iterdir()) == set(files)
    balls, floors = (matplotlib.image.imread(file)[..., :3].astype(np.float64) for file in files)
    assert balls.shape == floors.shape == (340, 800, 3)
    floor = balls[200:280].reshape(8, 10, 80, 10, 3).mean(axis=(1, 3, 4))  # without the noise of few directions
    polished, *_, rough = (np.diff(part[:, 6:14], axis=1).std() for part in np.split(floor, 4, axis=1))
    assert polished > 3.0 * rough > 0.0
    noise, still = (unlike(part[60:280, 120:340]) for part in np.split(floors, 2, axis=1))
    assert noise > 4.0 * still > 0.0
