"""Maps: their scale bars and arrows are true, and buildings stand where they are, with their walls to the south."""

from pathlib import Path

import matplotlib.image
import numpy as np
import pytest
import rasterio
from affine import Affine
from matplotlib.patches import Rectangle
from matplotlib.text import Annotation

import warpsample as ws
from warpsample import rasters
from warpsample.plotting.map_sheet import Map, map_sheet, scale_length, square_steps


@pytest.mark.parametrize(
    ("width", "bar"), [(400.0, 100.0), (170.0, 50.0), (60.0, 20.0), (59.0, 10.0), (3.0, 1.0), (0.7, 0.2)]
)
def test_a_scale_bar_is_round_and_a_third_of_the_map_at_most(width, bar):
    assert scale_length(width) == pytest.approx(bar)


def test_a_map_has_its_scale_its_north_and_its_first_row_on_top():
    value = np.full((30, 60), np.nan)
    value[0] = 7.0
    north = np.array([-0.6, 0.8])
    figure = map_sheet([Map(value, square_steps(2.5), "title", "label, m", "gray", (5.0, 10.0), tuple(north))], "caption")
    axes = figure.axes[0]
    (shown,) = axes.images
    assert (axes.get_xlim(), axes.get_ylim()) == ((0.0, 150.0), (0.0, 75.0))
    assert on_map(shown, [(0, 0), (60, 30)]) == pytest.approx(np.array([(0.0, 75.0), (150.0, 0.0)]))
    assert (shown.origin, shown.get_clim(), float(shown.get_array()[0, 0])) == ("upper", (5.0, 10.0), 7.0)
    assert scale_length(150.0) in [each.get_width() for each in axes.patches if isinstance(each, Rectangle)]
    assert "50 m" in [text.get_text() for text in axes.texts]
    (arrow,) = (text for text in axes.texts if isinstance(text, Annotation))
    along = np.subtract(arrow.xy, arrow.xyann)  # from its tail to its tip
    assert along / np.linalg.norm(along) == pytest.approx(north)


def on_map(shown, corners):
    """Return where corners of cells, (column, row), are on a map, in metres."""
    return (shown.get_transform() - shown.axes.transData).transform(corners)


@pytest.mark.parametrize("degrees", [0, 30, 90, 180, 270])
@pytest.mark.parametrize(("down", "crs", "metres"), [(-2.0, "EPSG:32633", 1.0), (6.0, "EPSG:2263+6360", 1200 / 3937)])
def test_the_cells_of_a_turned_raster_are_where_the_map_has_them(degrees, down, crs, metres):
    """Maps showed the first row on top, square cells, and feet as metres; of one turned by 90 degrees they were empty."""
    where = Affine.translation(300000.0, 60000.0) * Affine.rotation(degrees) * Affine.scale(2.0, down)
    grid = rasters.surface((np.zeros((5, 8)), where, crs)).grid
    picture = Map(grid.height, grid.steps, "title", "label", "gray", (0.0, 1.0))
    axes = map_sheet([picture], "caption").axes[0]
    cells = [(0, 0), (8, 0), (0, 5), (8, 5)]
    places = metres * np.array([where * cell for cell in cells])
    drawn = on_map(axes.images[0], cells)
    assert drawn == pytest.approx(places - places.min(axis=0), abs=1e-6)  # rounding of coordinates of 3e5
    assert (axes.get_xlim()[1], axes.get_ylim()[1]) == pytest.approx(tuple(drawn.max(axis=0)))


def test_buildings_are_seen_from_above_with_their_walls_to_the_south(script, monkeypatch):
    """Plan areas are kept; of a wall to the south LEAN of its area is seen, of one to the north nothing."""
    maps = script("maps")
    monkeypatch.setattr(maps, "PIXELS", 400)
    low, high = np.array([10.0, 20.0, 3.0]), np.array([18.0, 26.0, 8.0])
    corners = np.array([[x, y, z] for z in (low[2], high[2]) for y in (low[1], high[1]) for x in (low[0], high[0])])
    sides = {
        "ground": (0, 2, 3, 1),
        "roof": (4, 5, 7, 6),
        "south": (0, 1, 5, 4),
        "north": (3, 2, 6, 7),
        "west": (2, 0, 4, 6),
    }
    sides["east"] = (1, 3, 7, 5)
    faces = np.array([t for a, b, c, d in sides.values() for t in ((a, b, c), (a, c, d))])
    seen = maps.seen_from_above(ws.as_mesh((corners, faces)), np.repeat(np.arange(6), 2), 20.0)
    cell = 20.0 / 400
    area = np.bincount(seen[seen >= 0], minlength=6) * cell**2
    # A row of pixels more or less along each edge.
    assert area == pytest.approx([0.0, 48.0, 8.0 * 5.0 * maps.LEAN, 0.0, 0.0, 0.0], abs=2.0 * cell * 8.0)
    rows = [np.flatnonzero((seen == part).any(axis=1)) for part in (1, 2)]
    assert rows[0].max() < rows[1].min()  # north is up: the roof is above the wall to the south
    # The map's middle is that of the box, 14, 23, 5.5 on average over its triangles.
    assert np.flatnonzero((seen == 1).any(axis=0)).min() * cell == pytest.approx(6.0, abs=0.1)
    assert rows[0].min() * cell == pytest.approx(10.0 - 3.0 - 2.5 * maps.LEAN, abs=0.1)


@pytest.mark.slow
def test_the_picture_of_a_raster_and_of_a_city(can_render, script, tmp_path, capsys):
    height = np.where(np.arange(20) < 10, 0.0, 15.0) * np.ones((20, 1))
    path, file = tmp_path / "step.tif", tmp_path / "maps.png"
    with rasterio.open(
        path, "w", driver="GTiff", height=20, width=20, count=1, dtype="float32", crs="EPSG:3794",
        transform=Affine(1.0, 0.0, 564000.0, 0.0, -1.0, 146000.0),
    ) as raster:  # fmt: skip
        raster.write(height.astype(np.float32), 1)
    maps = script("maps")
    terrain, sky = maps.hills(path, 64, 0)
    assert np.array_equal(terrain.value, height)
    # Half of it next to the wall, which ends 10 m away: at most 0.53. Three standard errors of ten cells of 64 rays: 0.06.
    assert float(sky.value[5:15, 9].mean()) == pytest.approx(0.515, abs=0.075)
    assert sky.value[:, 10:].min() > 0.99
    assert sky.north[0] < 0.0 < sky.north[1]  # the place is east of the map's middle meridian
    maps.main(terrain=path, city=Path("courtyard"), samples=16, side=100.0, screenshot=file, size=(900, 340))
    assert capsys.readouterr().out == f"{file}: step.tif, 16 rays per cell; courtyard; seed 0\n"
    picture = matplotlib.image.imread(file)
    assert picture.shape[:2] == (340, 900)
    assert (np.ptp(picture[..., :3], axis=-1) > 0.3).mean() > 0.05  # viridis and inferno, which no text has


@pytest.mark.thorough
def test_the_picture_of_light_between_and_through_faces(can_render, script, tmp_path, capsys, monkeypatch):
    drawn = script("light_between")
    monkeypatch.setattr(drawn, "PIXELS", 40)
    black, grey = drawn.courtyards(ws.load_mesh("courtyard"), weather="athens", count=64, seed=0)
    assert np.array_equal(np.isnan(black.value), np.isnan(grey.value))
    assert 0.1 < np.isnan(black.value).mean() < 0.6
    more = np.nanmean(grey.value) - np.nanmean(black.value)
    assert 0.02 < more / np.nanmean(black.value) < 0.4
    tree = drawn.shade(weather="athens", count=64, seed=0)
    shadow, free = tree.value[14, 20], np.nanmax(tree.value)  # 4 m to the north of the trunk, and where nothing is
    assert 0.3 * free < shadow < 0.9 * free
    file = tmp_path / "light.png"
    drawn.main(samples=16, screenshot=file, size=(900, 340))
    picture = matplotlib.image.imread(file)
    assert picture.shape[:2] == (340, 900)
    assert (np.ptp(picture[..., :3], axis=-1) > 0.3).mean() > 0.05
