"""Means over parts: the right weights, and errors that are as large as the means are wrong."""

import numpy as np
import pytest

from warpsample.mesh.part_means import part_means

PART = np.array([0, 0, 1, 2, -1])
AREAS = np.array([3.0, 1.0, 2.0, 5.0, 7.0])


def test_a_point_on_each_face_counts_by_area_and_has_its_rays_error():
    value, error = np.array([1.0, 5.0, 2.0, np.nan, 9.0]), np.array([0.4, 0.8, 0.1, 1.0, 1.0])
    found = part_means(PART, AREAS, np.arange(5), value, error, count=4)
    assert found.value == pytest.approx([(3 * 1 + 1 * 5) / 4, 2.0, np.nan, np.nan], nan_ok=True)
    assert found.standard_error == pytest.approx([np.hypot(3 * 0.4, 1 * 0.8) / 4, 0.1, np.nan, np.nan], nan_ok=True)
    assert found.points.tolist() == [2, 1, 0, 0]


def test_several_points_on_a_face_have_the_error_of_how_they_vary():
    face = np.array([0, 0, 0, 1, 2, 2, -1, 4])
    value = np.array([1.0, 2.0, 6.0, 5.0, 2.0, 2.0, 100.0, 100.0])
    found = part_means(PART, AREAS, face, value, np.full(8, 0.5), count=3)
    assert found.value[:2] == pytest.approx([(3 * 3 + 1 * 5) / 4, 2.0])
    variance = ((1 - 3) ** 2 + (2 - 3) ** 2 + (6 - 3) ** 2) / 2 / 3
    assert found.standard_error[:2] == pytest.approx([np.sqrt(9 * variance + 1 * 0.25) / 4, 0.25])  # 0.5 / 2 of equal values


def test_numbers_of_several_components():
    value = np.array([[1.0, 0.0], [5.0, 3.0], [2.0, 1.0], [np.nan, 1.0], [0.0, 0.0]])
    found = part_means(PART, AREAS, np.arange(5), value, np.ones((5, 2)), count=3)
    assert found.value == pytest.approx(np.array([[2.0, 0.75], [2.0, 1.0], [np.nan, np.nan]]), nan_ok=True)
    assert found.standard_error[:2] == pytest.approx(np.array([[np.sqrt(10) / 4] * 2, [1.0] * 2]))


def test_the_error_bars_are_as_wide_as_the_errors():
    """Noisy values that vary over a part of two faces, by 2,000 seeds: their mean squares agree."""
    rng, areas = np.random.default_rng(7), np.array([3.0, 1.0])
    right = (3.0 * 1.0 + 1.0 * 5.0) / 4.0  # of values with the means 1 and 5 on the two faces
    squares = []
    for _ in range(2000):
        face = np.repeat([0, 1], [4, 2])
        value = np.array([1.0, 5.0])[face] + rng.uniform(-1.0, 1.0, 6) + 0.3 * rng.normal(size=6)
        found = part_means(np.zeros(2, int), areas, face, value, np.full(6, 0.3), count=1)
        squares.append((found.value[0] - right, found.standard_error[0]))
    wrong, bar = np.square(squares).mean(axis=0)
    # 2,000 squares of nearly normal errors: their mean is known to sqrt(2 / 2000) = 3.2 %, four of which are 13 %.
    assert wrong == pytest.approx(bar, rel=0.13)
