"""A raster without a CRS is taken to be in metres, with one warning, and refused if it can only be in degrees."""

import subprocess
import sys
import warnings

import numpy as np
import pytest
from affine import Affine
from raster_cases import NORTH_UP, write_tif

pytest.importorskip("rasterio")
pytest.importorskip("rioxarray")

import xarray as xr

import warpsample as ws
from warpsample.city.rasters.sources.transforms import check_lengths

HEIGHTS = np.arange(120.0).reshape(10, 12) % 7.0
WARNED = "without a CRS; its coordinates are taken as metres"

ASC = """ncols 12\nnrows 10\nxllcorner {0}\nyllcorner {1}\ncellsize {2}\nNODATA_value -9999\n"""


def grid_file(path, x=564000.0, y=146000.0, side=1.0, heights=HEIGHTS):
    """An .asc without a .prj beside it."""
    rows = "\n".join(" ".join(map(str, row)) for row in heights)
    path.write_text(ASC.format(x, y, side) + rows + "\n")
    return path


def warned(heard):
    return [str(one.message) for one in heard if "without a CRS" in str(one.message)]


@pytest.mark.parametrize("options", [{}, {"tile": 4, "margin": 2}, {"canopy": True, "far": True}])
def test_one_warning_a_call(tmp_path, options):
    path = grid_file(tmp_path / "dsm.asc")
    others = {name: path if value is True else value for name, value in options.items()}
    with warnings.catch_warnings(record=True) as heard:
        warnings.simplefilter("always", UserWarning)
        ws.rasters.sky_view_factor(path, 4, **others)
    assert len(warned(heard)) == 1
    assert f"source: got '{path}' {WARNED}" in warned(heard)[0]


@pytest.mark.parametrize("argument", ["canopy", "far"])
def test_a_warning_names_the_raster_that_it_is_about(argument):
    """Before, warnings about all rasters named "source"."""
    furlongs = xr.DataArray(HEIGHTS, dims=("y", "x"), attrs={"units": "furlong"}).rio.write_transform(NORTH_UP)
    with pytest.warns(UserWarning, match=f"^{argument}: got heights in 'furlong', a unit that is not known here"):
        ws.rasters.sky_view_factor((0.0 * HEIGHTS, NORTH_UP, None), 4, **{argument: np.abs(furlongs)})


def test_an_array_of_xarray_is_warned_of_and_a_tuple_is_not(tmp_path):
    array = xr.DataArray(HEIGHTS, dims=("y", "x")).rio.write_transform(NORTH_UP)
    with pytest.warns(UserWarning, match=f"got an xarray.DataArray {WARNED}"):
        ws.rasters.surface(array)
    ws.rasters.surface((HEIGHTS, NORTH_UP, None))  # warnings are errors
    ws.rasters.surface(array.rio.write_crs('LOCAL_CS["model",UNIT["metre",1]]'))
    ws.rasters.surface(write_tif(tmp_path / "dsm.tif", HEIGHTS))


@pytest.mark.parametrize("argument", ["canopy", "far"])
def test_maps_of_other_names_without_a_place_on_earth_are_other_maps(argument):
    """Before, all maps without a place on Earth counted as the same map."""
    plant, city, unnamed = (f'LOCAL_CS["{name}",UNIT["metre",1]]' for name in ("Plant", "City", "unnamed"))
    for other in (plant, unnamed, None):
        ws.rasters.sky_view_factor((HEIGHTS, NORTH_UP, plant), 4, **{argument: (HEIGHTS, NORTH_UP, other)})
    with pytest.raises(ValueError, match=f"^{argument}: got coordinates of City, want Plant, as the heights have$"):
        ws.rasters.sky_view_factor((HEIGHTS, NORTH_UP, plant), 4, **{argument: (HEIGHTS, NORTH_UP, city)})


def test_files_are_refused_if_gdal_cannot_look_up_their_maps(tmp_path, child_environment):
    """The first came without a place on Earth and without a warning, so without its north; the second without its feet."""
    code = (
        "import sys, warpsample as ws\n"
        "for path in sys.argv[1:]:\n"
        "    try: ws.rasters.surface(path)\n"
        "    except ValueError as error: print(error)"
    )
    spain = Affine(1.0, 0.0, 3e6, 0.0, -1.0, 1.9e6)
    paths = [
        write_tif(tmp_path / "0.tif", HEIGHTS, crs="EPSG:3035", transform=spain),
        write_tif(tmp_path / "1.tif", HEIGHTS, crs="EPSG:32618+6360"),
    ]
    for path in paths:
        ws.rasters.surface(path)
    nowhere = {"PROJ_DATA": str(tmp_path), "PROJ_LIB": str(tmp_path)}
    command = [sys.executable, "-c", code, *map(str, paths)]
    done = subprocess.run(command, env=child_environment | nowhere, capture_output=True, text=True, check=True, timeout=300)
    assert done.stdout.count("that GDAL has read without its database of maps") == 2, done.stdout


@pytest.mark.thorough
@pytest.mark.parametrize("processes", [None, 2])
def test_one_line_of_the_command(tmp_path, child_environment, processes):
    pytest.importorskip("dask")
    path, more = grid_file(tmp_path / "dsm.asc"), [] if processes is None else ["--processes", str(processes)]
    bake = ["bake", path, "-o", tmp_path / "sky.tif", "--quantity", "sky", "--samples", "4", "--tile", "5", *more]
    command = [sys.executable, "-m", "warpsample", *bake]
    done = subprocess.run(command, env=child_environment, capture_output=True, text=True, check=True, timeout=300)
    said = [line for line in done.stderr.splitlines() if "without a CRS" in line]
    assert len(said) == 1, done.stderr
    assert said[0].startswith("warning: ")


DEGREES = [
    (8.5, 47.4, 1.0 / 3600.0, 60.0),  # the Alps by seconds of arc
    (-74.0, 40.7, 1.0 / 108000.0, 3.0),  # a town by 1 m
    (300.0, -20.0, 1.0 / 1200.0, 600.0),  # longitudes from 0 to 360
    (179.99, 89.9, 1.0 / 120.0, 900.0),  # cells of 1 km
]


@pytest.mark.parametrize(("x", "y", "side", "relief"), DEGREES)
def test_what_can_only_be_in_degrees_is_refused(tmp_path, x, y, side, relief):
    heights = HEIGHTS / HEIGHTS.max() * relief
    path = grid_file(tmp_path / "dsm.asc", x, y, side, heights)
    for source in (path, (heights, Affine(side, 0.0, x, 0.0, -side, y), None)):
        with pytest.raises(
            ValueError,
            match="^source: got cells of .* without a CRS, which look like degrees, and heights .*; want lengths; ",
        ):
            ws.rasters.sky_view_factor(source, 4)


METRES = [
    (400, 0.001, 0.3),  # a part of a model 1 m wide, by millimetres
    (200, 0.02, 60.0),  # a patch of a tower's scan, by 2 cm
    (5, 0.01, 2.0),  # the edge of a shelf
    (3, 1.0, 200.0),  # beside a tower, by metres
    (40, 0.0001, 0.01),  # a coin
    (4, 0.5, 0.0),  # level
]


@pytest.mark.parametrize(("cells", "side", "relief"), METRES)
def test_models_in_metres_are_not_refused(cells, side, relief):
    heights = np.linspace(0.0, relief, cells * cells).reshape(cells, cells)
    for x, y in ((0.0, 0.0), (8.5, 47.4)):
        made = ws.rasters.surface((heights, Affine(side, 0.0, x, 0.0, -side, y), None), model="tin")
        assert len(made.mesh.faces) == 2 * (cells - 1) ** 2


def test_only_some_windows_of_a_raster_are_read_for_it():
    """And nothing of one whose cells cannot be in degrees."""
    shapes, level = [], np.zeros((3000, 200))

    def heights(rows, columns):
        shapes.append(level[rows, columns].shape)
        return level[rows, columns]

    for side, x, y in ((1e-4, 8.0, 47.0), (1.0, 8.0, 47.0), (1e-4, 5e5, 5e6)):
        check_lengths(Affine(side, 0.0, x, 0.0, -side, y), level.shape, heights)
    assert shapes == [(512, 200)] * 3


def lake():
    """Level in its middle, and mountains around it, by seconds of arc."""
    away = np.hypot(*(np.mgrid[:1200, :1200] - 600.0))
    return np.maximum(away - 500.0, 0.0) * 1.2


def peaks(cells, seed=0):
    """Mountains that differ from cell to cell, as by cells of kilometres."""
    return np.random.default_rng(seed).uniform(0.0, 3000.0, (cells, cells))


def highland(cells):
    """A plateau of 4,000 m in a corner, and the sea."""
    heights = np.zeros((cells, cells))
    heights[-cells // 4 :, -cells // 4 :] = peaks(cells // 4) + 2500.0
    return heights


@pytest.mark.parametrize(
    ("heights", "side"),
    [
        (lake(), 1.0 / 3600.0),
        (peaks(40), 0.025),
        (peaks(40), 0.1),
        (highland(320), 0.25),
        (np.random.default_rng(0).uniform(0.0, 1.0, (40, 40)), 1.0 / 3600.0),  # a plain
    ],
)
def test_degrees_are_found_in_any_part_and_by_any_cells(heights, side):
    with pytest.raises(
        ValueError, match="^source: got cells of .* without a CRS, which look like degrees, and heights .*; want lengths; "
    ):
        check_lengths(Affine(side, 0.0, 8.5, 0.0, -side, 47.4), heights.shape, lambda *part: heights[part])


def tower(cells, share, height):
    """A tower on a fraction of a square."""
    heights = np.zeros((cells, cells))
    heights[: round(cells * share), : round(cells * share)] = height
    return heights


@pytest.mark.parametrize(
    ("heights", "side"),
    [
        (tower(24, 0.2, 600.0), 0.25),  # a guyed mast on 6 m x 6 m
        (tower(300, 0.5, 828.0), 0.25),  # the highest building, on 75 m x 75 m
        (tower(64, 0.5, 60.0), 0.02),  # the edge of a facade, by a scanner
        (np.repeat(tower(100, 0.5, 1300.0)[:, :1], 100, axis=1), 1.0),  # the highest cliff of the Earth
        (tower(60, 0.1, -32000.0), 1.0),  # a few damaged cells
        (np.full((40, 40), np.nan), 0.5),
    ],
)
def test_no_lengths_are_taken_for_degrees(heights, side):
    check_lengths(Affine(side, 0.0, 8.5, 0.0, -side, 47.4), heights.shape, lambda *part: heights[part])


def test_units_of_heights_and_coordinates_that_an_array_states_are_used():
    """As `units` or `unit` of the heights; coordinates in another unit than that of the CRS are refused."""
    array = xr.DataArray(HEIGHTS, dims=("y", "x")).rio.write_transform(NORTH_UP).rio.write_crs("EPSG:32633")
    top = ws.rasters.surface(array).mesh.vertices[:, 2].max()
    for name in ("unit", "units"):
        in_feet = ws.rasters.surface(array.assign_attrs({name: "ft"})).mesh.vertices
        assert in_feet[:, 2].max() == pytest.approx(0.3048 * top)
    x = xr.Variable("x", np.arange(12.0) / 1000.0, {"units": "km"})
    with pytest.raises(
        ValueError,
        match=r"^source: got coordinates 'x' in 'km', want the unit of the CRS \(1 m\); convert the numbers to that unit$",
    ):
        ws.rasters.surface(array.assign_coords(x=x, y=np.arange(10.0)[::-1]))


def test_the_height_unit_of_an_arc_projection_is_used(tmp_path):
    path = grid_file(tmp_path / "dsm.asc")
    lines = ["Projection    UTM", "Zone          33", "Datum         WGS84", "Units         METERS", "Zunits        {}"]
    tops = {}
    for unit in ("NO", "METERS", "FEET"):
        path.with_suffix(".prj").write_text("\n".join([*lines, "Xshift        0.0", "Parameters", ""]).format(unit))
        tops[unit] = ws.rasters.surface(path).mesh.vertices[:, 2].max()
    assert tops["NO"] == tops["METERS"]
    assert tops["FEET"] == pytest.approx(0.3048 * tops["NO"])
