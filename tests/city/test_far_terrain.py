"""Terrain beyond the margin of a tile and beyond the raster: true values are between those of upper and lower columns."""

import numpy as np
import pytest
from affine import Affine
from raster_cases import NORTH_UP, run, town, whole
from scipy.ndimage import gaussian_filter

pytest.importorskip("rasterio")
pytest.importorskip("rioxarray")

import warpsample as ws
from warpsample import rasters
from warpsample.city.rasters import far, grid
from warpsample.city.rasters.far import FarField, window_of
from warpsample.city.rasters.sources.reading import reader_of
from warpsample.estimate.quantities.ambient_occlusion import RECORD as OCCLUSION
from warpsample.estimate.quantities.sky_view_factor import RECORD as SKY

FIRST = [(slice(row, row + 16), slice(0, 16)) for row in (0, 16, 32)]
"""Tiles in the first columns."""


@pytest.mark.parametrize("margin", [3, 8, 20])
@pytest.mark.parametrize("quantity", [SKY, OCCLUSION])
def test_what_is_beyond_the_margin_is_bounded(quantity, margin, monkeypatch):
    """Ray by ray, so in each cell: the same rays see no more with the upper columns, and no less with the lower ones.

    But for rays that graze edges, whose hits float32 decides, in few cells; and as the Earth is flat in the whole raster,
    by its curvature over 60 m, 3e-4 m.
    """
    monkeypatch.setattr(far, "_FINENESS", 4)  # else a raster so small is not pooled
    heights = town()
    right = whole(run(heights, quantity, model="block"))
    found = whole(run(heights, quantity, model="block", tile=16, margin=margin))
    off = np.abs(found["value"].astype(np.float64) - right["value"]) - found["far_error"]
    assert (off <= 1e-6).mean() >= 0.99
    assert off.max() <= 3.0 / 64.0
    assert 0.0 < found["far_error"].mean() < 0.05


def test_holes_beyond_the_margin_are_bounded_as_shafts_in_solid_ground(monkeypatch):
    """No column is where a cell has no height, so that the lower ones hide no more than the walls of a shaft would."""
    monkeypatch.setattr(far, "_FINENESS", 4)
    heights = town()
    gone = (np.random.default_rng(4).random(heights.shape) < 0.2) & (np.arange(44) > 24)
    shafts, holes = (np.where(gone, depth, heights) for depth in (-1e3, np.nan))
    right = whole(run(shafts, model="block"))
    found = run(holes, model="block", tile=16, margin=3)
    off = [np.abs(found.numbers(span)["value"] - right["value"][span]) - found.numbers(span)["far_error"] for span in FIRST]
    assert (np.array(off) <= 1e-6).mean() >= 0.99
    assert np.max(off) <= 3.0 / 64.0


@pytest.mark.parametrize("share", [0.03, 0.2])
def test_the_bound_holds_with_cells_without_data(share, monkeypatch):
    """Before, rays passed below the surface through such cells, and up to 4 % of the values missed the bound."""
    monkeypatch.setattr(far, "_FINENESS", 4)
    heights = town()
    heights[np.random.default_rng(4).random(heights.shape) < share] = np.nan
    right = whole(run(heights, model="block"))
    found = whole(run(heights, model="block", tile=16, margin=8))
    off = np.abs(found["value"].astype(np.float64) - right["value"]) - found["far_error"]
    assert (off[~np.isnan(heights)] <= 1e-6).mean() >= 0.999


def test_without_the_far_field_the_bound_would_not_hold():
    """So that the law above is not true of everything."""
    heights = town()
    right = whole(run(heights, model="block"))["value"]
    found = run(heights, model="block", tile=16, margin=3)
    found.far_field = None
    without_crowns = whole(found)["value"]
    assert (np.abs(without_crowns.astype(np.float64) - right) > 1e-3).mean() > 0.1


@pytest.mark.parametrize("transform", [NORTH_UP, Affine(2.0, 0.3, 5.0, 0.1, 1.5, 7.0)])
@pytest.mark.parametrize("model", ["joined", "block"])
def test_columns_are_above_and_below_the_terrain(model, transform):
    """By vertical rays from the middle of each cell beyond the window, on both sides."""
    heights = town()
    heights[50, 3] = np.nan
    reader = reader_of((heights, transform, None))
    field = FarField.of(reader, None, margin=120, model=model)  # cells of 2, then 4, ...
    assert field.size == 2
    tile = slice(10, 20), slice(12, 20)
    near = tuple(slice(part.start - 4, part.stop + 4) for part in tile)
    inside = np.zeros(heights.shape, bool)
    inside[near] = True
    upper, lower = (_height_of(ws.as_mesh(made()), reader, 100.0) for made in field.columns(tile, near, 0.0))
    assert np.isnan(upper[inside & ~np.isnan(heights)]).all()
    known = ~inside & ~np.isnan(heights)
    assert (upper[known] >= heights[known] - 5e-4).all()  # float32, and the Earth's curvature over 80 m
    covered = known & ~np.isnan(lower)
    assert covered.sum() > 0.9 * known.sum()
    assert (lower[covered] <= heights[covered] + 1e-4).all()
    assert not covered[50:52, 2:4].any()


def test_terrain_of_another_raster_is_fine_next_to_the_edge(monkeypatch):
    """It was pooled by the margin alone, also in the cell beside the edge: 0.38 with a bound of 0.25 in place of 0.19."""
    monkeypatch.setattr(far, "_FINENESS", 4)
    heights = town()
    rows, columns = slice(21, 34), slice(17, 28)
    whole, own = (
        reader_of((array, NORTH_UP @ Affine.translation(*at), None))
        for array, at in ((heights, (0, 0)), (heights[rows, columns], (columns.start, rows.start)))
    )
    field = FarField.of(own, whole, margin=40, model="block")
    assert field.size == 8
    tile = slice(0, 13), slice(0, 11)
    upper, lower = (_height_of(ws.as_mesh(made()), whole, 100.0) for made in field.columns(tile, window_of(tile, 40), 0.0))
    i, j = np.mgrid[:60, :44]
    apart = np.maximum(np.maximum(21 - i, i - 33), np.maximum(17 - j, j - 27))
    assert np.isnan(upper[apart <= 0]).all()
    assert (upper - heights)[apart > 0].min() > -5e-4  # float32, and the Earth's curvature
    assert (lower - heights)[(apart > 0) & ~np.isnan(lower)].max() < 1e-4
    fine = (apart > 0) & (apart <= 8)
    assert (upper - lower)[fine].max() < 1e-4
    assert np.nanmax((upper - lower)[apart > 8]) > 5.0


def test_coarse_cells_of_another_raster_are_laid_out_at_once():
    """Each of the passes was over one of (far cell / cell of the ring)^2 places: minutes, or without end."""
    rng = np.random.default_rng(8)
    heights, turned = rng.random((5, 6)), Affine.rotation(20.0)
    for scale, turn in ((3.0, turned), (9.5, Affine.identity()), (9.5, turned), (1e6, turned)):
        where = Affine.translation(-3.0, 2.0) @ turn @ Affine.scale(scale)
        bounds = grid.Bounds(heights, heights - 1.0, Affine.translation(7.0, 4.0) @ where)
        found = []
        for most in (0, 10**9)[: 1 if scale > 1e3 else 2]:
            with pytest.MonkeyPatch.context() as patch:
                patch.setattr(grid, "_MOST_PASSES", most)
                found.append(grid.resample_extremes(bounds, Affine.scale(2.0), (20, 25)))
        assert all(np.array_equal(*pair, equal_nan=True) for pair in zip(found[0], found[-1], strict=True))
        assert np.isfinite(found[0]).all(axis=0).any()


def _height_of(mesh, reader, top):
    """(rows, columns) where vertical rays from above meet a mesh first; NaN where they miss it."""
    rows, columns = reader.shape
    start = reader.outline.centres(np.arange(rows * columns)) + np.array([1e-3, 2e-3, 0.0])
    start[:, 2] = top
    hits = ws.trace(mesh, start, np.tile([0.0, 0.0, -1.0], (rows * columns, 1)))
    return np.where(np.isinf(hits.distance), np.nan, top - hits.distance).reshape(rows, columns)


@pytest.mark.thorough
def test_mountains_beyond_the_raster_are_seen():
    """A crest of 100 m all around, 1 km away, of a coarse raster that is turned: the whole by a closed form, cos² h."""
    flat = np.zeros((21, 21))
    coarse = np.zeros((201, 201))
    x, y = np.meshgrid(np.arange(201) - 100, np.arange(201) - 100)
    crest = np.hypot(x, y) * 20.0 > 1000.0
    coarse[crest] = 100.0
    turned = (
        Affine.translation(10.5, -10.5) @ Affine.rotation(30.0) @ Affine.scale(20.0) @ Affine.translation(-100.5, -100.5)
    )
    for tile in (None, 8):
        made = run(flat, count=1024, model="block", far=(coarse, turned, None), tile=tile)
        found = whole(made)
        lower, upper = (1.0 / (1.0 + (100.0 / distance) ** 2) for distance in (980.0, 1040.0))
        assert lower - 1e-3 <= found["value"].mean(dtype=np.float64) <= upper + 1e-3
        assert 0.0 < found["far_error"].max() < 0.002


@pytest.mark.parametrize("options", [{}, {"sequence": "sobol"}], ids=["horizons", "rays"])
def test_nothing_passes_below_what_is_far(options):
    """The floor of a pit lower than all that is beyond it: half of the columns hung in the air, and the pit was open."""
    deep = np.full((99, 99), 10.0)
    deep[40:59, 40:59] = 0.0
    beyond = (np.full((99, 99), 10.0), NORTH_UP @ Affine.translation(-40, -40), None)
    runs = run(deep, count=256, model="block"), run(np.zeros((19, 19)), count=256, model="block", far=beyond)
    for made in runs:
        made.options.update(options)
    right, found = whole(runs[0])["value"][40:59, 40:59], whole(runs[1])
    assert right.max() < 0.6
    # Both are 361 estimates that are 0.03 off: the means of their differences 0.003.
    assert abs((found["value"] - right).mean(dtype=np.float64)) < found["far_error"].mean() + 0.01


@pytest.mark.parametrize("model", ["joined", "tin"])
def test_the_bound_holds_beside_steep_terrain_of_another_raster(model):
    """25 to 39 % of the cells missed the bound by more than 3 standard errors, as if the other raster were blocks."""
    x, y = np.meshgrid(np.arange(36.0), np.arange(36.0))
    pit = 2.0 * np.hypot(x - 18.0, y - 18.0) + np.random.default_rng(3).random((36, 36))
    inner = slice(10, 26), slice(10, 26)
    there = Affine.translation(-10.0, 10.0) @ NORTH_UP
    right = whole(run((pit, there, None), model=model, count=256))
    found = whole(run(pit[inner], model=model, count=256, far=(pit, there, None), tile=8, margin=2))
    off = np.abs(found["value"] - right["value"][inner])
    noise = np.hypot(found["standard_error"].astype(np.float64), right["standard_error"][inner])
    assert (off <= found["far_error"] + 3.0 * noise + 1e-3).mean() > 0.99
    assert off.max() > 0.01


@pytest.mark.parametrize(("model", "relief", "share"), [("joined", 60.0, 0.0), ("tin", 60.0, 0.0), ("tin", 20.0, 0.3)])
def test_the_bound_holds_where_another_raster_has_no_data(model, relief, share):
    """Another raster without the cells of the raster itself, or with holes: a tenth and a fifth of the cells missed it."""
    random = np.random.default_rng(2)
    heights = gaussian_filter(random.normal(size=(96, 96)), 6.0) * relief
    for row, column in random.integers(0, 84, (25, 2)):
        size = random.integers(3, 12, 2)
        heights[row : row + size[0], column : column + size[1]] += random.uniform(1.5, 10.0)
    heights[random.random(heights.shape) < share] = np.nan
    inner = slice(32, 64), slice(32, 64)
    far = heights.copy()
    if not share:
        far[inner] = np.nan
    own = np.ascontiguousarray(heights[inner]), Affine(1.0, 0.0, 32.0, 0.0, -1.0, -32.0), None
    found = rasters.sky_view_factor(own, 512, model=model, far=(far, NORTH_UP, None))
    right = rasters.sky_view_factor((heights, NORTH_UP, None), 512, model=model)
    right, its_error = (getattr(right, name).values[inner].astype(np.float64) for name in ("value", "standard_error"))
    error = 4.0 * np.hypot(found.standard_error.values, its_error)  # of 1,024 cells, one in 15 runs exceeds it
    within = np.abs(found.value.values - right) <= found.far_error.values + error + 1e-4  # float32 rounding
    assert np.array_equal(within, np.isfinite(heights[inner]))


def test_far_terrain_sinks_with_the_distance():
    """A crest 1,000 m above at 50 km is 1.146° high on a flat Earth, and 0.950° on ours, by the facts of CITY.md."""
    reader = reader_of((np.zeros((3, 3)), Affine.scale(100.0, -100.0), None))
    coarse = np.zeros((100, 180))
    coarse[:, 145:] = 1000.0  # from 95 km on
    other = reader_of((coarse, Affine.translation(-50e3, 50e3) @ Affine.scale(1e3, -1e3), None))
    field = FarField.of(reader, other, margin=50, model="block")
    tile = slice(0, 3), slice(0, 3)
    (upper, _), (lower, _) = (made() for made in field.columns(tile, tile, 0.0))
    for vertices in (upper, lower):
        top = vertices[(vertices[:, 0] > 99e3) & (abs(vertices[:, 1]) < 2e3), 2].max()
        assert abs(top - (1000.0 - 0.87 * 100_000.0**2 / (2.0 * 6_371_000.0))) < 0.0137 * 3_200.0  # cells there are so long
    assert np.degrees(np.arctan2(1000.0 - 0.87 * 50e3**2 / (2 * 6371e3), 50e3)) == pytest.approx(0.950, abs=2e-3)


def scenes_of_pooled_cells():
    """Heights whose surface in a cell depends on neighbours, holes and cells that stand alone."""
    rng = np.random.default_rng(0)
    rough, alone = rng.uniform(0.0, 3.0, (32, 32)), np.full((24, 24), np.nan)
    alone[:, :10] = rng.uniform(0.0, 1.0, (24, 10))
    alone[4::3, 13], alone[5::4, 17] = 8.0, 12.0
    holes = np.where(rng.uniform(size=rough.shape) < 0.15, np.nan, rough)
    return {"rough": rough, "town": rng.choice([0.0, 6.0, 12.0], rough.shape), "holes": holes, "alone": alone}


@pytest.mark.parametrize("scene", ["rough", "town", "holes", "alone"])
@pytest.mark.parametrize("model", ["joined", "tin"])
def test_pooled_cells_of_each_model_are_within_far_error(model, scene):
    """The random numbers of a cell are the same, so the difference is due to the pooled cells, except for rounding."""
    heights = scenes_of_pooled_cells()[scene]
    exact, tiled = (whole(run(heights, model=model, count=256, **options)) for options in ({}, {"tile": 8, "margin": 2}))
    beyond = np.abs(exact["value"] - tiled["value"]) - tiled["far_error"]
    known = ~np.isnan(exact["value"])
    assert known.any()
    assert beyond[known].max() <= 1e-5  # float32 rounding in another mesh
