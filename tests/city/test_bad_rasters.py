"""Bad rasters are refused in a sentence, before anything is computed."""

from types import SimpleNamespace

import numpy as np
import pytest
from affine import Affine
from raster_cases import ON_A_MAP as UTM
from raster_cases import write_tif

from warpsample import rasters

rasterio = pytest.importorskip("rasterio")
pytest.importorskip("rioxarray")
xr = pytest.importorskip("xarray")

HEIGHTS = np.arange(12.0).reshape(3, 4)

VRT = """<VRTDataset rasterXSize="4" rasterYSize="3"><GeoTransform>5e5, 2.5, 0, 5e6, 0, -2.5</GeoTransform>
<VRTRasterBand dataType="Float64" band="1"><NoDataValue>x</NoDataValue><SimpleSource><SourceFilename
relativeToVRT="1">heights.tif</SourceFilename></SimpleSource></VRTRasterBand></VRTDataset>"""
"""Of whose nodata value GDAL makes 0, which is a height."""


def array_of(values=HEIGHTS, **coordinates):
    return xr.DataArray(values, dims=("y", "x"), coords=coordinates)


@pytest.mark.parametrize(
    ("source", "kind", "message"),
    [
        (
            None,
            TypeError,
            r"source: got a value of type NoneType, want the path of a raster, an xarray\.DataArray, or a tuple",
        ),
        (HEIGHTS, TypeError, r"source: got a NumPy array, want the path of a raster"),
        ((HEIGHTS, UTM), TypeError, r"source: got a value of type tuple, want the path of a raster"),
        (array_of().to_dataset(name="dsm"), TypeError, "source: got .*Dataset.*want the path of a raster"),
        ("missing.tif", FileNotFoundError, r"source: got 'missing\.tif', which is missing, want the path"),
        (f"{'x' * 300}.tif", FileNotFoundError, r"source: got 'x*\.tif', which is out of reach, want the path"),
        ("text.tif", ValueError, r"source: got 'text\.tif', which cannot be read as a raster: .*not recognized"),
        ("cut.tif", ValueError, r"source: got 'cut\.tif', which cannot be read as a raster: "),
        ("rgb.tif", ValueError, r"source: got 'rgb\.tif' with 3 bands, want one band of heights"),
        ("nowhere.tif", ValueError, r"source: got 'nowhere\.tif', which has no place on a map"),
        ("degrees.tif", ValueError, r"source: got coordinates in degree of WGS 84, want lengths"),
        ((HEIGHTS, UTM, "EPSG:4979"), ValueError, "source: got coordinates in degree"),
        ((HEIGHTS, UTM, "EPSG:4978"), ValueError, "source: got coordinates of WGS 84, want a map with two horizontal axes"),
        (
            array_of().assign_attrs(positive="Down"),
            ValueError,
            r"source: got positive='down', want heights .*negate the numbers",
        ),
        (
            array_of().assign_attrs(standard_name="sea_floor_depth_below_geoid"),
            ValueError,
            "source: got standard_name='sea_floor_depth_below_geoid', want heights",
        ),
        ("depths.tif", ValueError, r"source: got positive='down', want heights \(positive up\)"),
        (
            (HEIGHTS, UTM, "EPSG:5703"),
            ValueError,
            "source: got coordinates of NAVD88 height, want a map with two horizontal axes",
        ),
        ((HEIGHTS, UTM, "EPSG:32633+5715"), ValueError, "source: got depths .CRS WGS 84 / UTM zone 33N [+] MSL depth"),
        ((HEIGHTS, UTM, "nothing"), ValueError, "source: got 'nothing' for its CRS, want a CRS that pyproj knows"),
        ("text.vrt", ValueError, r"source: got 'text\.vrt' with the NoDataValue 'x', want a number$"),
        ("latin.vrt", ValueError, r"source: got 'latin\.vrt', which is not in UTF-8 .*; write its file names in UTF-8$"),
        ("h\udcf6he.tif", ValueError, r"source: got 'h\\udcf6he\.tif', whose name is not in UTF-8, as GDAL needs; rename"),
        ((HEIGHTS[0], UTM, None), ValueError, r"source: got an array of shape \(4,\), want \(rows, columns\)"),
        ((np.stack([HEIGHTS, HEIGHTS]), UTM, None), ValueError, r"shape \(2, 3, 4\), want \(rows, columns\)"),
        ((HEIGHTS > 3, UTM, None), TypeError, "source: got dtype bool, want an array of real numbers"),
        ((HEIGHTS * 1j, UTM, None), TypeError, "source: got dtype complex128, want an array of real numbers"),
        ((np.full((3, 4), np.nan), UTM, None), ValueError, "source: got 3 x 4 cells without any height, want at least one"),
        (
            (np.empty((0, 5)), UTM, None),
            ValueError,
            r"source: got an array of shape \(0, 5\), want .*, at least one of each",
        ),
        ((HEIGHTS, None, None), TypeError, "source: got None for its transform, want an affine"),
        ((HEIGHTS, (1.0, 0.0, 0.0), None), TypeError, r"source: got \(1\.0, 0\.0, 0\.0\) for its transform"),
        ((HEIGHTS, Affine(1.0, 2.0, 0.0, 2.0, 4.0, 0.0), None), ValueError, "want a transform whose cells have an area"),
        ((HEIGHTS, Affine(np.nan, 0.0, 0.0, 0.0, -1.0, 0.0), None), ValueError, "want a transform whose cells have an area"),
        ((HEIGHTS, Affine(0.0, 0.0, 5.0, 0.0, 0.0, 7.0), None), ValueError, "an area; for a raster turned by 90 degrees"),
        ((HEIGHTS, (1.0, 0.0, "x", 0.0, 1.0, 0.0), None), TypeError, r"source: got \(1\.0, 0\.0, 'x', .* for its transform"),
        (
            (HEIGHTS, Affine(1.0, 0.0, 2e15, 0.0, -1.0, 0.0), None),
            ValueError,
            r"up to 2e\+15 of cells 1 long, want",
        ),
        (xr.DataArray(HEIGHTS, dims=("lat", "lon")), ValueError, r"dimensions \('lat', 'lon'\), want y and x"),
        (xr.DataArray(np.zeros((2, 3, 4)), dims=("time", "y", "x")), ValueError, "want y and x alone; select one band"),
        (array_of(x=[0.0, 1.0, 2.0, 4.0], y=[2.0, 1.0, 0.0]), ValueError, "coordinates 'x' that are not evenly spaced"),
        (
            array_of(x=[0.0, 0.5, 1.0, 1.5], y=np.float32([4900001.0, 4900000.5, 4900000.0])),
            ValueError,
            "coordinates 'y' rounded to 0.5, too coarse for cells of about 0.5; want float64",
        ),
        (array_of(x=list("abcd"), y=[2.0, 1.0, 0.0]), TypeError, "coordinates 'x' of dtype <U1, want real numbers"),
        (
            array_of(HEIGHTS > 3, x=[0, 1, 2, 3], y=[2, 1, 0]).rio.write_crs("EPSG:3794"),
            TypeError,
            "heights of dtype bool, want real numbers",
        ),
        (array_of(), ValueError, "which has no place on a map"),
        (array_of().rio.write_crs("EPSG:3794"), ValueError, "which has no place on a map"),
        (array_of(x=np.arange(4) + 0.5, y=np.arange(3) + 0.5).rio.write_crs("EPSG:3794"), ValueError, "no place on a map"),
        ("placeless.tif", ValueError, r"source: got 'placeless\.tif', which has no place on a map"),
        (array_of().assign_attrs(_FillValue="x"), ValueError, r"attributes \{'_FillValue': 'x'\}, want numbers$"),
        (array_of().assign_attrs(scale_factor="x"), ValueError, r"attributes \{'scale_factor': 'x'\}, want numbers$"),
        (
            array_of().assign_attrs(scale_factor=0),
            ValueError,
            "heights of scale 0 and offset 0, want finite numbers, and a scale",
        ),
    ],
)
def test_bad_rasters_are_refused_in_a_sentence(tmp_path, monkeypatch, source, kind, message):
    monkeypatch.chdir(tmp_path)
    name = source if isinstance(source, str) else ""
    if name == "text.tif":
        (tmp_path / source).write_text("heights")
    if name == "text.vrt":
        write_tif("heights.tif", HEIGHTS)
        (tmp_path / source).write_text(VRT)
    if name == "latin.vrt":  # rasterio cannot say that the file is missing: its heights were 0
        (tmp_path / source).write_text(VRT.replace(">x<", ">-9<").replace("heights", "h\xf6hen"), encoding="latin-1")
    if name == "cut.tif":
        write_tif(source, np.random.default_rng(0).random((300, 300)))
        (tmp_path / source).write_bytes((tmp_path / source).read_bytes()[:200_000])
    if name == "rgb.tif":
        write_tif(source, np.stack([HEIGHTS] * 3))
    if name == "depths.tif":
        with rasterio.open(write_tif(source, HEIGHTS), "r+") as file:
            file.update_tags(1, positive="down")
    if name == "degrees.tif":
        write_tif(source, HEIGHTS, crs="EPSG:4326", transform=Affine(1e-4, 0.0, 15.0, 0.0, -1e-4, 46.0))
    if name in ("nowhere.tif", "placeless.tif"):
        with pytest.warns(rasterio.errors.NotGeoreferencedWarning):
            write_tif(source, HEIGHTS, crs=None if name == "nowhere.tif" else "EPSG:3794", transform=Affine.identity())
    with pytest.raises(kind, match=message) as caught:
        rasters.surface(source)
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize(
    "attributes", [{"positive": "up"}, {"standard_name": "height"}, {"standard_name": "depth", "positive": "up"}]
)
def test_heights_whose_attributes_state_the_direction_are_read(attributes):
    array = array_of(y=[7.5, 5.0, 2.5], x=[0.0, 2.5, 5.0, 7.5]).rio.write_crs("EPSG:3794").assign_attrs(attributes)
    assert np.array_equal(rasters.surface(array).grid.height, HEIGHTS)


@pytest.mark.parametrize(
    ("call", "options"),
    [
        (rasters.sky_view_factor, {"max_distance": np.array([1.0, 2.0])}),
        (rasters.irradiation, {"weather": "athens", "period": np.array([1, 2])}),
    ],
)
def test_an_array_in_place_of_an_option_is_refused_by_its_name(call, options):
    """NumPy said that the truth value of an array is ambiguous."""
    with pytest.raises((TypeError, ValueError), match=f"^{list(options)[-1]}: got "):
        call((HEIGHTS, UTM, "EPSG:32633"), **options)


def test_a_model_and_a_receiver_that_are_none_are_refused():
    with pytest.raises(ValueError, match="model: got 'mesh', want one of joined, block, tin"):
        rasters.surface((HEIGHTS, UTM, None), model="mesh")
    with pytest.raises(ValueError, match="receiver: got 'tilted', want one of horizontal, surface"):
        rasters.surface((HEIGHTS, UTM, None)).points("tilted")
    with pytest.raises(ValueError, match="source: got 1 x 4 cells without a block of 2 x 2 cells with heights"):
        rasters.surface((HEIGHTS[:1], UTM, None), model="tin")
    with pytest.raises(ValueError, match=r"values: got shape \(3,\), want \(12,\), one value for each cell"):
        rasters.surface((HEIGHTS, UTM, None)).to_raster(np.zeros(3), np.arange(12))
    cells = np.arange(12)
    wrong = (cells - 1, ValueError, "-1 to 10"), (cells + 1, ValueError, "1 to 12"), (cells / 1.0, TypeError, "float64")
    for cell, error, said in wrong:
        with pytest.raises(error, match=f"^cell: got .*{said}, want "):
            rasters.surface((HEIGHTS, UTM, None)).to_raster(np.zeros(12), cell)


def test_what_is_too_large_is_refused_before_it_is_read(tmp_path, monkeypatch):
    monkeypatch.setattr("psutil.virtual_memory", lambda: SimpleNamespace(available=10**9))
    huge = np.broadcast_to(np.float32(0.0), (4096, 4096))  # 4 bytes in all
    with pytest.raises(
        MemoryError, match=r"surfaces of 4,096 x 4,096 cells need 16\.8 GB and 1\.0 GB are free; split the raster"
    ):
        rasters.surface((huge, UTM, None))
    path = tmp_path / "sparse.tif"
    size = {"count": 1, "height": 17_000, "width": 17_000, "dtype": "float32"}
    with rasterio.open(
        path, "w", "GTiff", **size, transform=UTM, crs="EPSG:3794", sparse_ok=True, tiled=True, compress="deflate"
    ):
        pass
    with pytest.raises(
        ValueError,
        match="source: got 17,000 x 17,000 cells, want 1 to 268,435,456; split the raster into tiles",
    ):
        rasters.surface(path)


def test_the_reason_of_gdal_names_a_missing_source_of_a_vrt(tmp_path):
    """The message of rasterio only refers to its cause."""
    source = '<SourceFilename relativeToVRT="1">gone.tif</SourceFilename>'
    (tmp_path / "dsm.vrt").write_text(
        f'<VRTDataset rasterXSize="4" rasterYSize="4"><GeoTransform>0, 1, 0, 4, 0, -1</GeoTransform>'
        f'<VRTRasterBand dataType="Float32" band="1"><SimpleSource>{source}'
        "<SourceBand>1</SourceBand></SimpleSource></VRTRasterBand></VRTDataset>"
    )
    with pytest.raises(ValueError, match=r"^source: got '.*dsm\.vrt', which cannot be read as a raster: .*gone\.tif"):
        rasters.surface(tmp_path / "dsm.vrt")
