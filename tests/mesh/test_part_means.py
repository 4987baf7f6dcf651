"""Means over parts: the right weights, and errors that are as large as the means are wrong."""

import numpy as np
import pytest
from scipy.stats import chi2

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
    found = part_means(PART, AREAS, face, value, np.full(8, 0.5), count=3, kind=np.arange(3))
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


@pytest.mark.parametrize("each", [2, 3, 10])
@pytest.mark.parametrize("areas", [[1.0], [1.0, 1.0, 1.0, 1.0]])
def test_two_errors_of_few_points_contain_the_mean(areas, each):
    """Normal values at the points of 20,000 parts. Without pooled variances it is 71 to 95 % of the parts."""
    count, faces = 20_000, len(areas)
    value = np.random.default_rng(3).normal(size=count * faces * each)
    part, face = np.repeat(np.arange(count), faces), np.repeat(np.arange(count * faces), each)
    found = part_means(part, np.tile(areas, count), face, value, np.zeros(len(value)), count=count)
    # Of 20,000 parts, the share is known to 0.15 %, four of which are 0.6 %. Few degrees of freedom cost less than 1 %.
    assert -0.016 < np.mean(np.abs(found.value) <= 2.0 * found.standard_error) - 0.9545 < 0.03
    # The larger of a part's own variance s v, where s d is distributed as chi-squared with d degrees of freedom, and of the
    # combined one, (s d + 8) v / (d + 8): E max(0, 1 - s) = F(d; d) - F(d; d + 2). Known to 1 %, three of it.
    degrees = faces * (each - 1)
    below = chi2.cdf(degrees, degrees) - chi2.cdf(degrees, degrees + 2)
    variance = np.square(areas).sum() / np.square(np.sum(areas)) / each * (1.0 + 8.0 / (degrees + 8.0) * below)
    assert np.square(found.standard_error).mean() == pytest.approx(variance, rel=0.03)


def test_variances_are_pooled_over_parts_of_one_kind():
    """A part of equal values, one whose values vary, and one of another kind: 2 + 8 degrees of freedom, 8 of the others.

    A part keeps its own variance if this is larger, and open parts say nothing of others.
    """
    face = np.repeat([0, 1, 2], 3)
    value = np.array([1.0, 1.0, 1.0, 0.0, 1.0, 2.0, 7.0, 7.0, 7.0])
    given = (np.arange(3), np.ones(3), face, value, np.zeros(9))
    some = part_means(*given, count=3, least=np.full(9, 0.03), kind=np.array(["roof", "roof", "wall"]))
    assert some.standard_error == pytest.approx([np.sqrt((2 * 0.0 + 8 * 1.0) / (2 + 8) / 3), np.sqrt(1 / 3), 0.03 / 3])
    free = part_means(*given, count=3, kind=np.array(["roof", "roof", "wall"]))  # no point needs a ray
    assert free.standard_error == pytest.approx([0.0, np.sqrt(1 / 3), 0.0])
    value[:3] = [1.0, 1.0, 1.3]
    assert part_means(*given, count=3).standard_error[0] == pytest.approx(np.sqrt((0.06 + 8 * 1.0) / 10 / 3))


def test_parts_with_as_many_points_count_most():
    """A part with four times as many points counts 1 / 4,096, whichever of the two is the larger one."""
    varied, even = [0.0, 2.0, 0.0, 2.0], [1.0] * 16  # variance 4 / 3; no variation, but a shadow may have been missed
    for own in (even[:4], even):
        values = [own, *[varied] * 3, *[even] * 50]
        each = np.array([len(one) for one in values])
        face, value = np.repeat(np.arange(54), each), np.concatenate(values)
        found = part_means(np.arange(54), np.ones(54), face, value, np.full(len(value), 1e-9), count=54)
        ratio = np.minimum(each[1:] / len(own), len(own) / each[1:])
        weights = np.square(ratio * ratio * ratio)
        of_parts = np.repeat([4 / 3, 0.0], [3, 50])
        others = np.average(of_parts, weights=weights)
        ratio = each[1:] / (each[1:] - 1)  # values to degrees of freedom
        fourth = np.average(np.where(of_parts > 0.0, 4 / 3, 0.0), weights=weights)  # four deviations of 1, per degree
        worth = max(8.0, fourth * np.average(ratio, weights=weights) / others**2 - 1.0)
        right = np.sqrt(worth * others / (len(own) - 1 + worth) / len(own))
        assert found.standard_error[0] == pytest.approx(right)
        assert (others > 1.0) == (len(own) == 4)


def test_rare_large_deviations_count_for_less_than_the_pooled_variance():
    """Of 40 parts with 10 values each, one value in 50 is 1: two errors contain 0.02, also of parts without such a value."""
    value, face = np.zeros(400), np.repeat(np.arange(40), 10)
    value[25::50] = 1.0
    found = part_means(np.arange(40), np.ones(40), face, value, np.zeros(400), count=40, least=np.full(400, 1e-6))
    assert (np.abs(found.value - 0.02) <= 2.0 * found.standard_error)[found.value == 0.0].all()
    fourth, second = 8 * (0.9**4 + 9 * 0.1**4), 8 * (0.9**2 + 9 * 0.1**2)
    worth = 390 * fourth / second**2 - 1.0  # of the 39 other parts
    assert worth > 38.0
    others = second / (9 * 39)
    assert found.standard_error[0] == pytest.approx(np.sqrt(worth * others / 10 / (9 + worth)))


def test_errors_of_single_points_are_not_pooled():
    rng, part = np.random.default_rng(4), np.repeat([0, 1], [300, 3])
    face = np.append(np.repeat(np.arange(300), 4), [300, 301, 302])
    areas = rng.uniform(1.0, 2.0, 303)
    found = part_means(part, areas, face, rng.normal(size=len(face)), np.full(len(face), 0.1), count=2)
    share = areas[300:] / areas[300:].sum()
    assert found.standard_error[1] == pytest.approx(0.1 * np.sqrt(np.square(share).sum()))


def test_errors_that_points_share_do_not_average_out():
    """400 points with eight runs whose errors are common: by 500 seeds, the mean squares of errors and bars agree."""
    rng, face, common, own = np.random.default_rng(8), np.repeat([0, 1], 200), 0.2, 0.5
    squares = []
    for _ in range(500):
        runs = 3.0 + common * rng.normal(size=(1, 1, 8)) + own * rng.normal(size=(400, 1, 8))
        given = (np.zeros(2, int), np.ones(2), face, runs.mean(axis=(1, 2)), np.full(400, own / np.sqrt(8)))
        found, plain = part_means(*given, count=1, runs=runs), part_means(*given, count=1)
        assert np.array_equal(found.value, plain.value)
        squares.append((found.value[0] - 3.0, found.standard_error[0], plain.standard_error[0]))
    wrong, bar, too_small = np.square(squares).mean(axis=0)
    # 500 squares of normal errors: their mean is known to sqrt(2 / 500) = 6.3 %, three of which are 19 %. The points' own
    # errors count twice, which is 8 * 0.5^2 / (400 * 8^2) of 0.2^2 / 8: 2 %.
    assert bar == pytest.approx(wrong, rel=0.21)
    assert too_small < 0.1 * wrong


def test_numbers_of_several_components_have_their_own_shared_errors():
    runs = np.zeros((2, 3, 8))
    runs[:, 1] = np.arange(8.0)
    given = (np.zeros(2, int), np.ones(2), np.arange(2), np.ones((2, 3)), np.zeros((2, 3)))
    found = part_means(*given, count=2, runs=runs)
    assert found.standard_error[0] == pytest.approx([0.0, np.arange(8).std(ddof=1) / np.sqrt(8), 0.0])
    assert np.isnan(found.standard_error[1]).all()
