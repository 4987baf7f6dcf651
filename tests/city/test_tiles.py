"""Tiles: the numbers of the whole raster where the margin reaches over it; options, memory and warnings."""

import tracemalloc
import weakref
from dataclasses import replace

import numpy as np
import pytest
from raster_cases import NORTH_UP, run, town, whole

pytest.importorskip("rasterio")
pytest.importorskip("rioxarray")

import warpsample as ws
from warpsample.city.rasters import far
from warpsample.city.rasters.horizons import sky_by_horizons
from warpsample.city.rasters.sources import reader
from warpsample.city.rasters.tiles import RasterRun
from warpsample.estimate.quantities.sky_view_factor import RECORD as SKY
from warpsample.estimate.quantities.visible_sky import RECORD as VISIBLE_SKY


@pytest.mark.parametrize("holes", [0, 2])
@pytest.mark.parametrize("model", ["joined", "block", "tin"])
def test_a_margin_of_the_whole_raster_changes_nothing(model, holes):
    """The law is 1e-6 in 99 of 100 cells; here the mesh is the same, and so are the bits, also with holes."""
    heights = town()
    heights[20 : 20 + holes, 7] = np.nan
    right = whole(run(heights, model=model))
    found = whole(run(heights, model=model, tile=17, margin=60))
    for name in ("value", "standard_error", "half_width"):
        assert np.array_equal(found[name], right[name], equal_nan=True), name
    assert np.nanmax(found["far_error"]) == 0.0
    assert np.array_equal(np.isnan(right["value"]), np.isnan(heights))
    points, cells = ws.rasters.surface((heights, NORTH_UP, None), model=model).points()
    mesh = ws.rasters.surface((heights, NORTH_UP, None), model=model).mesh
    plain = sky_by_horizons(SKY, mesh, points, {"count": 64})
    assert np.array_equal(right["value"].ravel()[cells], plain.value)


@pytest.mark.parametrize("receiver", ["horizontal", "surface"])
def test_a_tile_of_lone_cells_has_the_numbers_of_the_whole_raster(receiver):
    """Such a tile of "tin", with no 2 x 2 block in its window, was refused. A cell without a triangle has no slope."""
    heights = 10.0 * np.random.default_rng(3).random((40, 40))
    heights[:16, :16] = np.nan
    heights[3, 3] = 3.0
    right = whole(run(heights, model="tin", receiver=receiver))
    assert np.isnan(right["value"][3, 3]) == (receiver == "surface")
    exact = run(heights, model="tin", receiver=receiver, tile=8, margin=60)
    assert np.array_equal(whole(exact)["value"], right["value"], equal_nan=True)
    found = run(heights, model="tin", receiver=receiver, tile=8, margin=4).numbers((slice(0, 8), slice(0, 8)))
    off = np.abs(found["value"].astype(np.float64) - right["value"][:8, :8]) - found["far_error"]
    assert np.array_equal(np.isnan(found["value"]), np.isnan(right["value"][:8, :8]))
    assert np.nanmax(off, initial=0.0) <= 1e-6


def test_a_lone_cell_is_open_without_lower_columns():
    """Blocks of 2 x 2 cells beyond the margin all have cells without data: no lower column is anywhere."""
    heights = np.full((300, 300), np.nan)
    heights[3, 3], heights[251:253, 251:253] = 1.0, 5.0
    found = run(heights, model="tin", tile=8, margin=100).numbers((slice(0, 8), slice(0, 8)))
    assert found["value"][3, 3] + found["far_error"][3, 3] == 1.0
    assert np.isfinite(found["value"]).sum() == 1


@pytest.mark.parametrize("tile", [None, 8])
def test_a_raster_without_a_surface_is_refused_before_any_tile(tile, monkeypatch):
    """Whole and in tiles, which gave NaN. One band of rows is read at a time, and a block may lie across two bands."""
    monkeypatch.setattr(reader, "_BAND", 40)
    monkeypatch.setattr(RasterRun, "numbers", lambda *_: pytest.fail("a tile is computed"))
    nothing, lone = np.full((30, 20), np.nan), np.full((30, 20), np.nan)
    lone[4, 4] = lone[5, 5] = 1.0
    for heights, model, message in (
        (nothing, "joined", "source: got 30 x 20 cells without any height, want at least one"),
        (nothing, "tin", "source: got 30 x 20 cells without any height"),
        (lone, "tin", "source: got 30 x 20 cells without a block of 2 x 2 cells with heights"),
    ):
        with pytest.raises(ValueError, match=f"^{message}"):
            ws.rasters.sky_view_factor((heights, NORTH_UP, None), 16, model=model, tile=tile)
    for rows in (3, 4):
        across = np.full((30, 20), np.nan)
        across[rows : rows + 2, 4:6] = 1.0
        run(across).reader.check_heights("tin")
    run(lone).reader.check_heights("block")


def test_crowns_beyond_the_margin_are_bounded_too(monkeypatch):
    monkeypatch.setattr(far, "_FINENESS", 2)
    heights, rng = town(), np.random.default_rng(5)
    canopy = np.where(rng.random(heights.shape) < 0.2, 9.0, 0.0), NORTH_UP, None
    given = {"canopy": canopy, "transmittance": 0.2, "model": "block"}
    right = whole(run(heights, **given))
    exact = whole(run(heights, **given, tile=20, margin=60))
    assert np.array_equal(exact["value"], right["value"])
    found = whole(run(heights, **given, tile=20, margin=5))
    off = np.abs(found["value"].astype(np.float64) - right["value"]) - found["far_error"]
    assert (off <= 1e-6).mean() >= 0.99


def test_crowns_beyond_the_margin_are_seen_from_a_clearing():
    """No crown is in the tile or in its margin."""
    crowns = np.full((60, 60), 20.0)
    crowns[16:44, 16:44] = 0.0
    given = {"canopy": (crowns, NORTH_UP, None), "transmittance": 0.0, "model": "block"}
    right, found = (whole(run(np.zeros((60, 60)), **given, **tiles)) for tiles in ({}, {"tile": 20, "margin": 4}))
    inside = np.s_[20:40, 20:40]
    off = np.abs(found["value"].astype(np.float64) - right["value"])[inside]
    assert right["value"][inside].max() < 0.8  # a field without them is 1
    assert found["far_error"][inside].max() < 0.5
    assert (off <= found["far_error"][inside] + 4.0 * right["standard_error"][inside]).all()


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"tile": 0}, "tile: got 0, want a whole number of at least 1|tile: got 0, want a whole number from 1"),
        ({"tile": 8, "margin": 0}, "margin: got 0"),
        ({"margin": 8}, "margin: got 8 without tile, want tile, the number of cells"),
        ({"far": "missing.tif"}, "far: got 'missing.tif', which is missing"),
        ({"transmittance": [0.5] * 12}, "transmittance: got 12 fractions for the sky view factor, want one fraction"),
        ({"trunk": 0.5}, "trunk: got 0.5 without canopy, want canopy"),
        ({"transmittance": 0.5}, "transmittance: got 0.5 without canopy, want canopy"),
        ({"model": "mesh"}, "model: got 'mesh'"),
        ({"receiver": "wall"}, "receiver: got 'wall'"),
    ],
)
def test_bad_tiles_are_named(options, message):
    with pytest.raises((TypeError, ValueError, FileNotFoundError), match="^(" + message + ")"):
        run(np.zeros((4, 4)), **options)


def test_a_far_raster_of_another_map_is_refused():
    source = np.zeros((4, 4)), NORTH_UP, "EPSG:3794"
    with pytest.raises(ValueError, match="^far: got coordinates of WGS 84 / UTM zone 33N, want Slovenia"):
        run(source, far=(np.zeros((4, 4)), NORTH_UP, "EPSG:32633"))


def test_calls_take_trees_and_tiles():
    heights = town()
    canopy = np.where(np.random.default_rng(5).random(heights.shape) < 0.2, 9.0, 0.0), NORTH_UP, None
    given = {"canopy": canopy, "transmittance": 0.2, "trunk": 0.5}
    right = ws.rasters.sky_view_factor((heights, NORTH_UP, None), 32, **given)
    found = ws.rasters.sky_view_factor((heights, NORTH_UP, None), 32, **given, tile=20, margin=60)
    assert list(right) == ["value", "standard_error", "half_width"]
    assert list(found) == ["value", "standard_error", "half_width", "far_error"]
    assert np.array_equal(found.value, right.value)
    assert {name: found.attrs[name] for name in ("canopy", "trunk", "transmittance", "tile", "margin")} == {
        "canopy": "an array, tuple", "trunk": 0.5, "transmittance": 0.2, "tile": 20, "margin": 60,
    }  # fmt: skip
    assert "tile" not in right.attrs
    assert found.far_error.attrs["long_name"] == "error due to pooled distant terrain of the sky view factor"
    without_crowns = ws.rasters.sky_view_factor((heights, NORTH_UP, None), 32)
    assert (right.value < without_crowns.value).mean() > 0.5
    with pytest.raises(
        TypeError, match="^crowns: got an argument that sky_view_factor does not take, want one of .*canopy, trunk"
    ):
        ws.rasters.sky_view_factor((heights, NORTH_UP, None), 32, crowns=canopy)


@pytest.fixture
def looked_at(monkeypatch):
    """(faces of the mesh that is looked at, how many other meshes live then) at each look at a tile; and the quantity."""
    made, looks, make = [], [], ws.Mesh.__post_init__

    def counted(mesh):
        make(mesh)
        made.append(weakref.ref(mesh))

    def looking(mesh, points, count, **options):
        found = SKY.call(mesh, points, count, **options)
        looks.append((len(mesh.faces), sum(other() not in (None, mesh) for other in made)))
        assert not {"cross_products", "face_normals"} & set(vars(mesh))
        return found

    monkeypatch.setattr(ws.Mesh, "__post_init__", counted)
    return looks, replace(SKY, call=looking)


@pytest.mark.parametrize("trees", [False, True])
def test_a_tile_has_no_mesh_but_what_is_looked_at(looked_at, trees):
    """Neither the one without columns nor the one before; and no normals of faces, which its points are not on."""
    looks, quantity = looked_at
    heights = town(90, 90)
    canopy = (np.eye(90) * 5.0, NORTH_UP, None) if trees else None
    made = run(heights, quantity, canopy=canopy, tile=10, margin=8, receiver="surface")
    made.numbers((slice(40, 50), slice(40, 50)))
    assert [others for _, others in looks] == [0] * (2 + 2 * trees)


@pytest.mark.slow
def test_a_tile_takes_200_bytes_a_triangle(looked_at):
    """Vertices and faces take 24, and as float32 18, the tree 90 and 32 to be built: 170; with two meshes it was 224."""
    heights = np.random.default_rng(11).uniform(0.0, 3.0, (400, 400))
    looks, quantity = looked_at
    made = run(heights, quantity, count=2, tile=200, margin=60)
    assert made.far_field is not None  # which is read before
    tracemalloc.start()
    try:
        made.numbers((slice(100, 300), slice(100, 300)))
        most = tracemalloc.get_traced_memory()[1]
    finally:
        tracemalloc.stop()
    assert most < 200 * max(faces for faces, _ in looks)


@pytest.mark.parametrize(("tile", "canopy"), [(None, True), (8, False)])
def test_a_missed_tolerance_is_reported_once(tile, canopy):
    """A tile is computed twice, with too high and too low terrain; a raster with crowns is traced with and without them."""
    heights = np.zeros((20, 20))
    heights[3, 3] = 9.0
    options = {"tile": tile, "margin": tile and 2, "canopy": (np.eye(20) * 5.0, NORTH_UP, None) if canopy else None}
    with pytest.warns(UserWarning, match="tolerance: got 0.001, which is not reached with 64 rays per point") as heard:
        found = ws.rasters.visible_sky((heights, NORTH_UP, None), 64, tolerance=0.001, **options)
    assert len(heard) == 1
    assert heard[0].filename == __file__
    assert found.standard_error.max() > 0.001


def test_a_check_does_not_warn_of_a_missed_tolerance():
    """The check computes four cells of level ground, not the raster."""
    level = run(np.zeros((20, 20)), VISIBLE_SKY, tile=8, margin=2)
    level.options["tolerance"] = 1e-6
    level.check()
    with pytest.warns(UserWarning, match="tolerance: got 1e-06"):
        whole(level)
