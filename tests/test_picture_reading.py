"""Directions by the bilinear reading of a picture: densities by a float64 twin, and counts in parts of each cell."""

import numpy as np
import pytest
from significance import ALPHA

import warpsample as ws
from warpsample.distributions.lights import picture_reading, pixel_table
from warpsample.distributions.lights.picture_reading import PictureReading
from warpsample.proof import laws
from warpsample.statistics.histogram import histogram_test

UP = np.float32([[0.0, 0.0, 1.0]])


def dotted(height=16, width=32):
    """A dim sky with a sun of contrast 300, a black row, and black pixels beside the sun and at a pole."""
    picture = np.random.default_rng(3).random((height, width)) + 0.5
    picture[5, 0] = 300.0
    picture[5, 1] = picture[5, -1] = picture[0, 3] = 0.0
    picture[12] = 0.0
    return picture


def edges_of(height):
    """The parts of the sphere's area above the edges of the rows of cells, (H + 2,)."""
    angles = np.concatenate([[0.0], np.arange(height) + 0.5, [height]]) * np.pi / height
    return np.square(np.sin(angles / 2.0))


def corners_of(picture):
    """The luminances at the four corners of each cell, (2, 2, H + 1, W): upper or lower, left or right."""
    rows = np.concatenate([picture[:1], picture, picture[-1:]])
    lines = np.stack([rows[:-1], rows[1:]])
    return np.stack([lines, np.roll(lines, -1, axis=2)], axis=1)


def place(picture, w):
    """The cell (row, column) of world directions, and the place (down, across) in it, by float64 angles."""
    height, width = picture.shape
    w = w.astype(np.float64)
    turns = np.arctan2(w[:, 1], w[:, 0]) / (2.0 * np.pi) % 1.0 * width - 0.5
    cap = 0.5 - 0.5 * w[:, 2] / np.linalg.norm(w, axis=1)
    edges = edges_of(height)
    row = np.clip(np.searchsorted(edges, cap, side="right") - 1, 0, height)
    column = np.floor(turns).astype(int)
    return row, column % width, (cap - edges[row]) / np.diff(edges)[row], turns - column


def twin(picture, w):
    """The density, per steradian."""
    row, column, down, across = place(picture, w)
    corners = corners_of(picture)
    upper, lower = ((1.0 - across) * line[0] + across * line[1] for line in corners[:, :, row, column])
    total = (corners.mean(axis=(0, 1)) * np.diff(edges_of(len(picture)))[:, None]).sum() * 4.0 * np.pi / picture.shape[1]
    return ((1.0 - down) * upper + down * lower) / total


def draws(picture, points, sequence="independent", **orientation):
    lobe = PictureReading(picture, **orientation)
    d = ws.sample_directions(np.tile(UP, (points, 1)), 1024, distribution=lobe, sequence=sequence, pdf=True)
    return d.vectors.reshape(-1, 3), d.pdf.ravel()


def judge(picture=None, points=1024, parts=3):
    """Return the p-value of counts in 3 x 3 parts of each cell, against the exact integral of the density."""
    picture = dotted() if picture is None else picture
    w, _ = draws(picture, points)
    row, column, down, across = place(picture, w)
    corners = corners_of(picture)
    middles = (np.arange(parts) + 0.5) / parts  # the integral of a bilinear function over a part is its middle's value
    weight = np.stack([1.0 - middles, middles])
    share = np.einsum("ijrc,ia,jb->rcab", corners, weight, weight) * np.diff(edges_of(len(picture)))[:, None, None, None]
    i, j = (np.minimum((x * parts).astype(int), parts - 1) for x in (down, across))
    counts = np.zeros(share.shape)
    np.add.at(counts, (row, column, i, j), 1.0)
    expected = share / share.sum() * counts.sum()
    assert counts[share == 0.0].sum() == 0
    full = expected >= 10.0
    rest = laws.count_p_value(int(counts[~full].sum()), counts.sum(), expected[~full].sum() / counts.sum())
    inside = expected[full] * counts[full].sum() / expected[full].sum()
    return min(histogram_test(counts[full], inside).p_value, rest)


@pytest.mark.parametrize("shape", [(1, 1), (1, 5), (6, 1), (16, 32)])
def test_parts_of_cells_are_drawn_by_the_integral_of_the_density(shape):
    picture = dotted() if shape == (16, 32) else np.random.default_rng(1).random(shape)
    assert judge(picture) >= ALPHA


@pytest.mark.parametrize("shape", [(1, 1), (1, 5), (6, 1), (16, 32), (1024, 2048)])
def test_densities_are_those_of_the_twin(shape):
    picture = np.float32(dotted(*shape) if shape[0] > 12 else np.random.default_rng(1).random(shape))
    w, pdf = draws(picture, 64)
    relative = np.abs(pdf / twin(picture.astype(np.float64), w) - 1.0)
    # A direction is rounded to 6e-8, so to 4e-5 of a pixel of 2,048, where the luminance may fall from 300 to 0.
    assert np.quantile(relative, 0.999) <= 5e-7 * max(shape)
    assert np.quantile(np.abs(PictureReading(picture).pdf(w) / pdf - 1.0), 0.999) <= 5e-7 * max(shape)
    assert np.median(relative) <= 1e-6 + 1e-9 * max(shape)  # four float32 operations, and that rounding in an ordinary cell


@pytest.mark.parametrize(("up", "north"), [((0.0, 2.0, 0.0), None), ((1.0, -2.0, 0.5), (0.3, 1.0, 1.0))])
def test_up_and_north_turn_the_reading_as_they_turn_the_pixels(up, north):
    """At the middles of pixels the densities of the reading and of the pixels have one ratio."""
    picture = dotted() + 0.1
    pixels, reading = ws.EnvironmentMap(picture, up, north), PictureReading(picture, up, north)
    angles = (np.arange(16) + 0.5) * np.pi / 16, (np.arange(32) + 0.5) * 2.0 * np.pi / 32
    theta, phi = (a.ravel() for a in np.meshgrid(*angles, indexing="ij"))
    local = np.stack([np.sin(theta) * np.cos(phi), np.sin(theta) * np.sin(phi), np.cos(theta)], axis=1)
    w = (local @ pixels.frame).astype(np.float32)
    ratio = reading.pdf(w) / pixels.pdf(w)
    # Rounding turns a direction by 6e-8, which matters only beside the sun.
    assert (np.abs(ratio / np.median(ratio) - 1.0) <= 2e-5).mean() > 0.98


def test_a_black_direction_and_nan_have_the_density_0():
    picture = np.zeros((8, 16))
    picture[3, 5] = 2.0
    lobe = PictureReading(picture)
    assert not lobe.pdf(np.array([[0.0, 0.0, 1.0], [0.0, 0.0, -1.0], [np.nan, 0.0, 1.0]])).any()
    w, pdf = draws(picture, 4)
    assert (pdf > 0.0).mean() > 0.999  # 0 at a corner of the tent, where u rounds to it
    assert (twin(picture, w) > 0.0).mean() > 0.999


@pytest.mark.parametrize("scale", [1e-44, 1e-30, 3e34])
def test_the_unit_of_a_picture_does_not_matter(scale):
    picture = dotted().astype(np.float32)
    w, pdf = draws(picture, 4)
    same, other = draws((picture * np.float32(scale)).astype(np.float32), 4)
    if scale == 1e-44:  # seven steps of the smallest float32
        assert np.isfinite(other).all()
    else:
        assert same == pytest.approx(w, abs=1e-5)  # luminances are rounded after they are scaled
        assert np.quantile(np.abs(other / pdf - 1.0), 0.99) < 1e-4


def columns_of_the_pixels(monkeypatch):
    """Cells begin half a column early."""
    right = picture_reading.build_table
    frame = PictureReading(dotted()).frame
    monkeypatch.setattr(picture_reading, "build_table", lambda cells, _, *rest: right(cells, frame, *rest))


def weights_of_the_pixels(monkeypatch):
    """A cell's weight is that of its upper left corner."""
    right = picture_reading.build_table

    def build(cells, *rest):
        return right(np.concatenate([PICTURE[:1], PICTURE]).astype(np.float32), *rest)

    monkeypatch.setattr(picture_reading, "build_table", build)


def rows_even_in_the_angle(monkeypatch):
    """Rows get their share by the angle, not by the solid angle."""
    monkeypatch.setattr(pixel_table, "solid_angles", lambda angles, width: np.diff(angles) / width)


PICTURE = dotted() + 0.1


@pytest.mark.parametrize("variant", [columns_of_the_pixels, weights_of_the_pixels, rows_even_in_the_angle])
def test_wrong_tables_are_rejected(variant, monkeypatch):
    monkeypatch.setattr("warpsample.distributions.lights.environment_map.find_or_make", lambda _, make: make())
    assert judge(PICTURE) >= ALPHA
    variant(monkeypatch)
    assert judge(PICTURE) < 1e-12
