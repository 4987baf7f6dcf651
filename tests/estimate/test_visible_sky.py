"""The visible share of the sky's solid angle, against closed forms, whichever way a face looks."""

import numpy as np
import pytest

import warpsample as ws

TINY = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]
STREET = ([[10, -1e6, 0], [10, 1e6, 0], [10, 1e6, 20], [10, -1e6, 20], [-10, -1e6, 0], [-10, 1e6, 0], [-10, 1e6, 20],
           [-10, -1e6, 20]], [[0, 1, 2], [0, 2, 3], [4, 6, 5], [4, 7, 6]])  # fmt: skip


@pytest.mark.parametrize("angle", [0.0, 30.0, 90.0, 120.0, 180.0])
def test_a_plane_sees_the_sky_on_its_side(angle):
    """1 - angle / 180°, where the cosine-weighted share is (1 + cos(angle)) / 2."""
    normal = [np.sin(np.radians(angle)), 0.0, np.cos(np.radians(angle))]
    points = ws.SurfacePoints(position=[[5.0, 5.0, 9.0]], normal=[normal])
    found = ws.visible_sky((TINY, [[0, 1, 2]]), points, 4096, seed=2)
    assert found.value[0] == pytest.approx(1.0 - angle / 180.0, abs=4.0 * float(found.standard_error[0]) + 1e-6)
    assert found.standard_error[0] < 0.004


@pytest.mark.parametrize(("x", "right"), [(0.0, 1.0 - 2.0 * np.arctan(2.0) / np.pi), (-4.5, 0.28510), (-9.5, 0.25393)])
def test_a_street_shows_the_angle_between_its_eaves(x, right):
    points = ws.SurfacePoints(position=[[x, 0.0, 0.0]], normal=[[0.0, 0.0, 1.0]])
    found = ws.visible_sky(STREET, points, 4096, seed=3)
    assert found.value[0] == pytest.approx(right, abs=4.0 * float(found.standard_error[0]) + 1e-5)
    assert found.standard_error[0] < 0.004
    turned = ws.visible_sky(([[z, x, y] for x, y, z in STREET[0]], STREET[1]),
                            ws.SurfacePoints([[0.0, x, 0.0]], [[1.0, 0.0, 0.0]]), 4096, up=(1, 0, 0), seed=3)  # fmt: skip
    assert turned.value[0] == pytest.approx(right, abs=4.0 * float(turned.standard_error[0]) + 1e-5)
    every = ws.visible_sky(STREET, points, 4096, seed=3, skip=False)
    assert every.value[0] == found.value[0]
    cosine = ws.sky_view_factor(STREET, points, 4096, seed=3)
    assert cosine.value[0] > found.value[0] + 0.1
