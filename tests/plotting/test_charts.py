"""Charts: what they say of their data, that they tell right from wrong, and that they are redrawn as a whole would be."""

from dataclasses import replace

import numpy as np
import pytest

from warpsample.plotting.angle_histogram import AngleHistogram
from warpsample.plotting.cell_map import CellMap
from warpsample.plotting.charts import LobeCharts
from warpsample.plotting.style import LOBE
from warpsample.statistics.histogram import HistogramTest, joined_test


def test_cells_are_joined_until_each_expects_enough():
    expected = np.array([0.0, 2.0, 4.0, 100.0, 3.0, 0.0, 4.0])
    test = joined_test(np.array([1.0, 2.0, 3.0, 100.0, 3.0, 1.0, 3.0]), expected)
    assert test.expected.tolist() == [6.0, 100.0, 7.0]
    assert test.observed.tolist() == [6.0, 100.0, 7.0]
    assert joined_test(np.array([4.0, 5.0]), np.array([4.0, 5.0])) is None
    # A last cell too small to stand alone joins its neighbour.
    assert joined_test(np.full(3, 6.0), np.array([8.0, 8.0, 2.0])).expected.tolist() == [8.0, 10.0]


def histogram(p_value, independent=True):
    edges, density = np.linspace(0.0, 90.0, 7), np.array([0.2, 0.7, 1.0, 1.0, 0.7, 0.2])
    residuals = np.array([0.5, -0.5, 30.0, 0.1, 0.0, -1.0])
    test = None if p_value is None else HistogramTest(density, density, residuals, 12.5, 5, p_value)
    middle = 0.5 * (edges[1:] + edges[:-1])
    return AngleHistogram(edges, 1.1 * density, density, middle, density, residuals, test, independent)


@pytest.mark.parametrize(
    ("p_value", "independent", "words"),
    [
        (0.3, True, "agrees with the density\nχ² = 12.5, dof = 5, p = 0.300"),
        (1e-9, True, "does NOT agree with the density\nχ² = 12.5, dof = 5, p < 10⁻⁶"),
        (1.0, True, "agrees with the density\nχ² = 12.5, dof = 5, p = 1.000 (too even)"),
        (0.3, False, "agrees with the density\nevenly spread: residuals up to 30.0 σ"),
        (1.0, False, "agrees with the density\nevenly spread: residuals up to 30.0 σ"),
        (1e-9, False, "does NOT agree with the density\nevenly spread: residuals up to 30.0 σ"),
        (None, True, "cannot be judged\ntoo few directions"),
        (None, False, "cannot be judged\ntoo few directions"),
    ],
)
def test_charts_show_their_data(p_value, independent, words):
    charts = LobeCharts((740, 900))
    seen, disk = histogram(p_value, independent), np.array([[0.1, 0.2], [0.3, -0.4]])
    charts.draw(seen, seen, disk)
    bars, curve, verdict, residuals = (artist for _, artist in charts.theta.moving)
    assert np.array_equal(bars.get_data().values, seen.observed)
    assert np.array_equal(curve.get_ydata(), seen.density)
    assert verdict.get_text() == f"θ {words}"
    assert (verdict.get_color() == LOBE) == ("NOT" in words)
    assert np.array_equal(residuals.get_data().values, np.clip(seen.residuals, -6.0, 6.0))
    assert np.array_equal(charts.disk.moving[0][1].get_xydata(), disk)


@pytest.mark.slow
def test_blitting_draws_what_a_whole_drawing_would():
    """After any other histogram, also one with other axes."""
    reused, wide = LobeCharts((740, 900)), histogram(0.5)
    other = replace(wide, edges=2.0 * wide.edges, observed=3.0 * wide.observed, expected=3.0 * wide.expected, test=None)
    disk = np.random.default_rng(0).uniform(-0.7, 0.7, (100, 2))
    for theta, azimuth in ((wide, wide), (other, wide), (wide, other), (wide, wide)):
        drawn = reused.draw(theta, azimuth, disk)
        assert np.array_equal(drawn, LobeCharts((740, 900)).draw(theta, azimuth, disk))
    assert (drawn.min(axis=-1) < 200).mean() > 0.05


@pytest.mark.parametrize("p_value", [1e-9, 0.5])
def test_the_longest_verdict_stays_clear_of_the_disk(p_value):
    """A chart of the azimuth is narrow, and the words above it must end before those above the disk begin."""
    charts = LobeCharts((740, 900))
    for independent in (True, False):
        test = replace(histogram(p_value).test, chi_square=22_326_467.8, residuals=np.full(6, 12_345.6))
        seen = replace(histogram(p_value, independent), test=test, claim="its own density")
        charts.draw(seen, seen, np.zeros((4096, 2)))
        verdict, words = charts.azimuth.moving[2][1], charts.disk.moving[2][1]
        assert verdict.get_window_extent().x1 < words.get_window_extent().x0


def cell_map(p_value, low=0.0, scale=1.0):
    edges = np.array([1.0, 0.7 + 0.3 * low, 0.6 + 0.4 * low, low])
    values = scale * np.arange(72.0).reshape(3, 24)
    return CellMap(edges, values, values[::-1], values / 9.0 - 4.0, replace(histogram(0.5).test, p_value=p_value), True)


def test_a_map_shows_each_row_at_its_cosines():
    charts, seen = LobeCharts((740, 900), with_map=True), cell_map(1e-9)
    charts.draw(histogram(0.5), histogram(0.5), np.zeros((1, 2)), seen)
    images = [artist for _, artist in charts.map.moving[:3]]
    for image, values in zip(images, (seen.observed, seen.expected, seen.residuals), strict=True):
        assert image.get_extent() == [0.0, 360.0, 0.0, 1.0]
        pixels = np.asarray(image.get_array())
        for cosine, row in ((0.99, 0), (0.71, 0), (0.69, 1), (0.61, 1), (0.59, 2), (0.01, 2)):
            assert np.array_equal(pixels[int((1.0 - cosine) * len(pixels))], values[row])
    assert images[0].get_clim() == images[1].get_clim() == (0.0, 80.0)  # 71, rounded up
    assert images[2].get_clim() == (-4.0, 4.0)
    verdict = charts.map.moving[3][1]
    assert verdict.get_text() == "(θ, φ) does NOT agree with the density\nχ² = 12.5, dof = 5, p < 10⁻⁶"
    assert verdict.get_color() == LOBE


@pytest.mark.slow
def test_blitting_draws_the_map_that_a_whole_drawing_would():
    reused, seen, disk = LobeCharts((740, 900), with_map=True), histogram(0.5), np.zeros((1, 2))
    for keywords in ({}, {"low": -1.0}, {"scale": 30.0}, {}):
        cells = cell_map(0.5, **keywords)
        drawn = reused.draw(seen, seen, disk, cells)
        assert np.array_equal(drawn, LobeCharts((740, 900), with_map=True).draw(seen, seen, disk, cells))
    assert (drawn.min(axis=-1) < 200).mean() > 0.05


def test_texts_of_a_sheet_with_a_map_do_not_overlap():
    """With the longest verdicts, in the smallest window."""
    charts, wide = LobeCharts((552, 675), with_map=True), histogram(1e-9)
    test = replace(wide.test, chi_square=22_326_467.8, dof=380)
    seen = replace(wide, test=test, claim="its own density")
    charts.draw(seen, seen, np.zeros((4096, 2)), replace(cell_map(1e-9), test=test, claim="its own density"))
    renderer = charts.figure.canvas.get_renderer()
    boxes = {}
    for axes in charts.figure.axes:
        labels = (axes.xaxis.label, axes.yaxis.label, axes._left_title, *axes.texts)
        boxes |= {(axes, text.get_text()): text.get_window_extent(renderer) for text in labels if text.get_text()}
    assert len(boxes) > 15
    places = list(boxes.items())
    for i, ((_, words), box) in enumerate(places):
        assert box.x0 >= 0.0, words
        assert box.x1 <= 552.0, words
        for (_, other), place in places[i + 1 :]:
            assert not box.overlaps(place), (words, other)
