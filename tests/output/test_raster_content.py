"""What rasters hold, block by block: other heights are noticed wherever they are read, and only there."""

import numpy as np
import pytest

pytest.importorskip("rioxarray")

from raster_cases import NORTH_UP

from warpsample.city.rasters.sources.reading import reader_of
from warpsample.output.rasters import content
from warpsample.output.rasters.content import digests_of, unchanging

ROWS, COLUMNS = 150, 600  # three blocks of 64 rows, three of 256 columns


@pytest.fixture
def heights():
    made = np.random.default_rng(3).normal(size=(ROWS, COLUMNS))
    made[5, 7] = np.nan
    return made


def test_a_part_is_what_it_was_or_an_error_says_where_not(heights):
    reader = reader_of((heights, NORTH_UP, None))
    checked = unchanging(reader, digests_of(reader), "far")
    rng = np.random.default_rng(4)
    for _ in range(30):
        row, column = np.sort(rng.integers(0, ROWS + 1, 2)), np.sort(rng.integers(0, COLUMNS + 1, 2))
        part = slice(*row.tolist()), slice(*column.tolist())
        if all(cut.start < cut.stop for cut in part):
            assert np.array_equal(checked.read(*part), heights[part], equal_nan=True)
    heights[70, 300] = np.nextafter(heights[70, 300], np.inf)
    with pytest.raises(ValueError, match="far: got heights that changed since the run began, from row 64 and column 256"):
        checked.read(slice(0, 65), slice(511, 512))
    for rows, columns in (((0, 64), (0, 600)), ((128, 150), (0, 600)), ((0, 150), (0, 256)), ((0, 150), (512, 600))):
        part = slice(*rows), slice(*columns)
        assert np.array_equal(checked.read(*part), heights[part], equal_nan=True)


@pytest.mark.parametrize("band", [1, 64 * 256 * 2, 64 * 256 * 3, 64 * 256 * 7])
def test_digests_do_not_depend_on_how_much_is_read_at_a_time(heights, band, monkeypatch):
    reader = reader_of((heights, NORTH_UP, None))
    right = digests_of(reader)
    assert right.shape == (3, 3, 32)
    assert len(np.unique(right.reshape(9, 32), axis=0)) == 9
    monkeypatch.setattr(content, "_BAND", band)
    assert np.array_equal(digests_of(reader), right)
