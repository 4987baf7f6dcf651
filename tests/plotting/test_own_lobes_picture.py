"""The picture of a surface whose points reflect the camera, each in a lobe of its own."""

import matplotlib.image
import numpy as np
import pytest
from significance import ALPHA

import warpsample as ws
from warpsample.viewer.own_lobes import constant_lobes


def test_roughness_and_brush_lines_vary_over_the_surface(script, bunny):
    module = script("own_lobes")
    corners = np.stack([bunny.bounds[0], bunny.bounds[1]])
    mean, ratio = module.roughness(corners, bunny.bounds)
    assert (mean.tolist(), ratio.tolist()) == (pytest.approx(module.ROUGH), pytest.approx(module.BRUSHED))
    points = module.brushed(bunny, 40, 0)
    lobe = module.reflections(points, bunny.bounds, np.array([0.0, 0.0, 2.0]))
    mean, ratio = module.roughness(points.position, bunny.bounds)
    assert lobe.lobe.alpha_y / lobe.lobe.alpha == pytest.approx(ratio, rel=1e-5)
    assert np.sqrt(lobe.lobe.alpha_y * lobe.lobe.alpha) == pytest.approx(mean, rel=1e-5)
    # Brush lines, the first axis of each frame, are level; each point sees the camera along +z of the world.
    assert np.abs(points.to_world([1.0, 0.0, 0.0])[:, 1]).max() <= 1e-6 + np.abs(points.normal[:, 1]).max()
    facing = np.isfinite(lobe.view[:, 0])
    assert np.array_equal(facing, points.normal[:, 2] >= 0.0)
    world = points.to_world(lobe.view)
    assert np.abs(world[facing] - [0.0, 0.0, 1.0]).max() <= 1e-6


def test_the_map_of_the_enlarged_lobe_agrees_and_that_of_a_wrong_one_does_not(script, bunny):
    module = script("own_lobes")
    camera = np.array([0.3, 0.35, 1.0])
    points = module.brushed(bunny, 100, 0)
    lobes = module.reflections(points, bunny.bounds, camera)
    row = module.choose(points, np.flatnonzero(np.isfinite(lobes.view[:, 0])), bunny.bounds, camera)
    point, lobe = points.take([row]), lobes.take([row])
    seen = module.enlarge(point, lobe, 100, 0)
    assert seen.cells.test.p_value >= ALPHA
    assert len(seen.position) == 400
    assert np.linalg.norm(seen.position, axis=1) == pytest.approx(seen.share, rel=1e-5)
    # The mirror direction of the view, where the reflections are densest, is in the lobe's tip.
    view = np.array(constant_lobes(lobe)[0].view)
    mirrored = view * [-1.0, -1.0, 1.0]
    assert seen.position[seen.share > 0.5].mean(axis=0) @ mirrored > 0.3
    swapped = ws.VisibleGGX(alpha=lobe.lobe.alpha_y, alpha_y=lobe.lobe.alpha, view=lobe.view)
    wrong = ws.sample_directions(point, module.COUNTED, distribution=ws.Reflection(swapped, view=lobe.view), seed=1)
    probabilities = module.probabilities_of(constant_lobes(lobe)[0])
    found = module.count_directions(point.to_local(wrong.vectors)[0], probabilities, independent=False).cells
    assert found.is_wrong


@pytest.mark.slow
def test_the_picture_has_three_panels(can_render, script, tmp_path, capsys, monkeypatch):
    module, file = script("own_lobes"), tmp_path / "own.png"
    monkeypatch.setattr(module, "LINES", 200)
    module.main(points=40, samples=50, screenshot=file, size=(900, 340))
    said = capsys.readouterr().out
    assert said.startswith(f"{file}: ")
    assert " of 40 points face the camera, 50 directions each; " in said
    picture = matplotlib.image.imread(file)[..., :3]
    assert picture.shape[:2] == (340, 900)
    for panel in np.split(picture, 3, axis=1):
        assert (np.ptp(panel[:300], axis=-1) > 0.3).mean() > 0.01  # colours that no text has
