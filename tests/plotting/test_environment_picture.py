"""The picture of rays towards a sky with a sun: the sky, the rays, the view, and the errors of the three columns."""

import re

import matplotlib.image
import numpy as np
import pytest

import warpsample as ws
from warpsample.plotting.ray_sheet import map_degrees


@pytest.fixture
def small(script, monkeypatch):
    module = script("environment_map")
    for name, value in {"HEIGHT": 256, "PIXELS": 60, "REFERENCE": 1024}.items():
        monkeypatch.setattr(module, name, value)
    return module


@pytest.mark.thorough
def test_the_sun_is_where_it_is_and_as_bright(script):
    """A point that faces the sun gets the sun's light: its radiance times π sin² of half the angle of the disc."""
    module = script("environment_map")
    sky, points = module.environment(), ws.SurfacePoints(np.zeros((1, 3)), module.SUN[None])
    dark = np.minimum(sky, 2.0)
    far = ([[0.0, 0.0, -9.0], [1e-3, 0.0, -9.0], [0.0, 1e-3, -9.0]], [[0, 1, 2]])
    found, rest = (ws.irradiance(far, points, each, 4096, sampling="picture").value[0] for each in (sky, dark))
    expected = np.pi * np.sin(module.RADIUS) ** 2 * module.SUN_LIGHT
    assert found - rest == pytest.approx(expected, rel=0.03)  # 0.01: pixels at the edge of 0.18 degrees; another place has 0
    azimuth, altitude = map_degrees(module.SUN)
    height, width = sky.shape[:2]
    assert sky[int((90.0 - altitude) / 180.0 * height), int(azimuth / 360.0 * width)].max() > 1000.0
    assert np.allclose(map_degrees(np.array([[0.0, -(2.0**0.5), 2.0**0.5]]) / 2.0), [[270.0, 45.0]])


def test_rays_are_shared_between_the_normal_and_the_picture(small):
    sky = ws.EnvironmentMap(small.environment())
    points = ws.SurfacePoints(np.zeros((3, 3)), np.tile([0.0, 0.0, 1.0], (3, 1)))
    cosine, picture = small.sample_rays(points, 64, 0.75, sky, 0)
    assert (cosine.shape, picture.shape) == ((3, 16, 3), (3, 48, 3))
    assert (cosine[..., 2] > 0.0).all()
    assert small.count_to_sun([cosine[0]]) == 0
    assert small.count_to_sun(list(picture)) > 0.4 * picture[..., 0].size
    assert [part.shape[1] for part in small.sample_rays(points, 64, 0.0, sky, 0)] == [64, 0]


def test_the_camera_sees_the_points_at_their_pixels_and_no_ray_below_the_floor(small):
    mesh, positions = small.scene(), small.pixel_positions().reshape(-1, 2)
    points, axes = small.visible_points(mesh, positions), small.camera_axes()
    assert np.abs(axes @ axes.T - np.eye(3)).max() <= 1e-12
    assert np.abs(points.position @ axes[:2].T - positions).max() <= 1e-5
    assert (points.normal @ axes[2]).min() >= 0.0
    assert positions[0, 1] > positions[-1, 1]
    floor = points.take(np.flatnonzero(points.face >= len(mesh.faces) - 2)[-1:])
    directions = np.array([[[0.0, 0.0, 1.0], [0.0, 0.0, -1.0]]])
    (shown,) = small.project_rays(mesh, floor, directions)
    assert shown[1] - shown[0] == pytest.approx([0.0, small.LENGTH * axes[1, 2]], abs=1e-5)


def test_errors_are_relative_to_the_mean(small):
    assert small.relative_rmse(np.float32([[1.0, 2.0], [3.0, 6.0]]), np.array([[2.0, 2.0], [2.0, 2.0]])) == pytest.approx(
        np.sqrt(18.0 / 4.0) / 2.0
    )


@pytest.mark.thorough
def test_the_picture_has_three_columns_and_the_smallest_error_at_the_right(can_render, small, tmp_path, capsys):
    file = tmp_path / "sky.png"
    small.main(samples=64, screenshot=file, size=(900, 640))
    said = capsys.readouterr().out
    assert said.startswith(f"{file}: 64 rays per pixel; relative RMSE: cosine ")
    cosine, picture, both = (float(number) for number in re.findall(r"(?:cosine|picture|both) ([\d.e+]+)", said))
    assert cosine > 10.0 * picture  # 0.9 or more, even if no ray of the cosine lobe finds the sun
    assert picture > 1.3 * both  # twice
    drawn = matplotlib.image.imread(file)[..., :3]
    assert drawn.shape[:2] == (640, 900)
    red, green, blue = np.moveaxis(drawn, -1, 0)
    rays = {"yellow": (red > 0.9) & (green > 0.7) & (blue < 0.4), "red": (red > 0.9) & (green < 0.3) & (blue > 0.2)}
    # Right of the names of the rows.
    counts = {name: [third.sum() for third in np.split(mask[:, 30:], 3, axis=1)] for name, mask in rays.items()}
    assert (counts["yellow"][1], counts["red"][0]) == (0, 0)
    assert min(counts["yellow"][0], counts["red"][1], counts["yellow"][2], counts["red"][2]) > 20
