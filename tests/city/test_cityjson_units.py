"""CityJSON in feet, or with heights in another unit, has the numbers of the same city in metres; degrees are refused."""

import json
from contextlib import nullcontext

import city_files as cases
import numpy as np
import pytest

pytest.importorskip("rioxarray")

from affine import Affine

import warpsample as ws
from warpsample import rasters
from warpsample.city.cityjson import units

FOOT = 1200.0 / 3937.0  # of US surveys, in metres
LONG_ISLAND = [(300000.5, 60000.25, -1.5)]  # m, on the map of EPSG:2263, whose origin is (300000, 0) m
BOTH_IN_FEET = "EPSG:2263+6360"
OGC = "https://www.opengis.net/def/crs/EPSG/0"


def house(system, across=FOOT, up=FOOT, **members):
    """The house of `city_files` on Long Island, in units of so many metres."""
    each = np.array([across, across, up])
    transform = {"scale": (0.001 / each).tolist(), "translate": (LONG_ISLAND / each)[0].tolist()}
    metadata = {} if system is None else {"metadata": {"referenceSystem": system}}
    return cases.house(transform=transform, **metadata, **members)


def load(folder, document, **options):
    return ws.load_city(cases.written(folder / "a.city.json", document), **options)


def check_metres(city, times=1.0):
    kinds = dict(zip(city.surfaces.type, city.surfaces.area, strict=True))
    assert kinds == pytest.approx({kind: times * area for kind, area in cases.AREAS.items()}, rel=1e-9)
    assert city.mesh.bounds[0] == pytest.approx(LONG_ISLAND[0], rel=1e-9)  # float64 has 16 digits, the transform 17


@pytest.mark.parametrize(
    ("system", "across", "up"),
    [
        (BOTH_IN_FEET, FOOT, FOOT),
        (f"https://www.opengis.net/def/crs-compound?1={OGC}/2263&2={OGC}/6360", FOOT, FOOT),
        (f"https://www.opengis.net/def/crs-compound?1={OGC}/2263&2={OGC}/5703".replace("https", "http"), FOOT, 1.0),
        ("urn:ogc:def:crs,crs:EPSG::2263,crs:EPSG::6360", FOOT, FOOT),
        ("EPSG:32118+6360", 1.0, FOOT),
        ("EPSG:32118", 1.0, 1.0),
        (f"{OGC}/32118", 1.0, 1.0),
        ("urn:ogc:def:crs:EPSG::7415", 1.0, 1.0),
        (None, 1.0, 1.0),
    ],
)
def test_every_spelling_of_a_reference_system_comes_to_metres(tmp_path, system, across, up):
    check_metres(load(tmp_path, house(system, across, up)))


@pytest.mark.parametrize("metadata", [None, {}, {"referenceSystem": None}])
def test_metadata_without_a_system_are_in_metres(tmp_path, metadata):
    check_metres(load(tmp_path, house(None, 1.0, 1.0, metadata=metadata)))


@pytest.mark.parametrize(
    ("system", "across", "said"),
    [
        ("EPSG:99999", 1.0, "in 'EPSG:99999', which pyproj does not know; its coordinates are taken as metres$"),
        ("Rijksdriehoek?", 1.0, "in 'Rijksdriehoek.', which pyproj does not know; its coordinates are taken as metres$"),
        (f"{OGC}/2263", FOOT, "without a unit of heights; they are taken to be in that of the map$"),
        ("EPSG:3857", 1.0, "Pseudo-Mercator, on which distances are 1.01 times"),
    ],
)
def test_one_warning_names_what_is_not_known(tmp_path, system, across, said):
    document = house(system, across, across)
    if system == "EPSG:3857":  # where ways are 1.3 times as long
        document["transform"]["translate"] = [-8.2e6, 5.0e6, 0.0]
        said = said.replace("1.01", "1.3.")
    with pytest.warns(UserWarning, match=said) as found:
        city = load(tmp_path, document)
    assert len(found) == 1
    assert city.surfaces.area.sum() == pytest.approx(sum(cases.AREAS.values()), rel=1e-9)


def test_without_pyproj_the_extra_is_named(tmp_path, monkeypatch):
    def lacking(_):
        raise ModuleNotFoundError("No module named 'pyproj'", name="pyproj")

    monkeypatch.setattr(units, "imported", lacking)
    with pytest.warns(
        UserWarning, match=r"EPSG:32118', .* needs pyproj: pip install '\.\[city\]'; its coordinates are taken as"
    ):
        check_metres(load(tmp_path, house("EPSG:32118", 1.0, 1.0)))
    check_metres(load(tmp_path, house(None, 1.0, 1.0)))


@pytest.mark.parametrize(
    ("system", "why"),
    [
        (
            "EPSG:4979",
            "metadata.referenceSystem: got coordinates in degree of WGS 84, want lengths, as heights are; transform",
        ),
        ("EPSG:4978", "metadata.referenceSystem: got coordinates of WGS 84, want a map with two horizontal axes"),
        (7415, "metadata.referenceSystem: got 7415, want a text"),
    ],
)
def test_what_is_not_in_lengths_is_refused(tmp_path, system, why):
    with pytest.raises(ValueError, match=f"^path: got '.*a.city.json', which cannot be read as a CityJSON file: {why}"):
        load(tmp_path, house(system))


def test_degrees_without_a_system_are_refused_and_small_models_are_not(tmp_path):
    document = cases.house(transform={"scale": [1e-8, 1e-8, 0.001], "translate": [8.5, 47.4, 400.0]})  # 1e-4 degrees, 11 m
    with pytest.raises(
        ValueError,
        match=r"the file has no known CRS in metadata.referenceSystem, and coordinates from \[8.5.*, which look like deg.*",
    ):
        load(tmp_path, document)
    for scale in ([1e-6] * 3, [1e-4, 1e-4, 0.01]):  # a house of 1 cm; a mast of 1 m x 1 m x 50 m
        small = cases.house(transform={"scale": scale, "translate": [0.0, 0.0, 0.0]})
        assert load(tmp_path, small).surfaces.area.sum() > 0.0


def placed(offsets, scale):
    """Houses of `city_files` at offsets in units of the file."""
    document = cases.house(transform={"scale": scale, "translate": [8.5, 47.4, 400.0]})
    corners, (name, thing) = np.array(document["vertices"]), next(iter(document["CityObjects"].items()))
    shifts = [np.rint(np.array([*offset, 0.0]) / scale).astype(int) for offset in offsets]
    document["vertices"] = np.concatenate([corners + shift for shift in shifts]).tolist()
    solids = [moved(thing["geometry"][0], number * len(corners)) for number in range(len(offsets))]
    document["CityObjects"] = {f"{name}{n}": thing | {"geometry": [solid]} for n, solid in enumerate(solids)}
    return document


def moved(geometry, first):
    """A geometry whose corners are vertices further on."""

    def deeper(item):
        return [deeper(part) for part in item] if isinstance(item, list) else item + first

    return geometry | {"boundaries": deeper(geometry["boundaries"])}


def test_a_wide_city_in_degrees_is_refused(tmp_path):
    """Two houses 4 km apart, and a hundred over the whole Earth: no width hides what single houses are."""
    rng = np.random.default_rng(0)
    for offsets in ([(0.0, 0.0), (0.05, 0.0)], rng.uniform((-170.0, -89.0), (160.0, 40.0), (100, 2))):
        with pytest.raises(ValueError, match=r"and coordinates from .*, which look like degrees; want lengths"):
            load(tmp_path, placed(offsets, [1e-8, 1e-8, 0.001]))


def test_terrain_in_degrees_is_refused_and_in_metres_is_not(tmp_path):
    """Triangles of 10 m with steps of decimetres, on 2 km: lower than 500 times its width in degrees."""
    rows, columns = np.divmod(np.arange(201 * 201), 201)
    heights = np.random.default_rng(0).integers(0, 1000, len(rows))  # mm
    first = (np.arange(200)[:, None] * 201 + np.arange(200)).ravel()
    faces = [[[int(a), int(a) + 1, int(a) + 202]] for a in first]
    vertices = np.column_stack([columns, rows, heights]).tolist()
    land = {"type": "TINRelief", "geometry": [{"type": "CompositeSurface", "lod": "1", "boundaries": faces}]}
    document = cases.house() | {"CityObjects": {"land": land}, "vertices": vertices}
    document["transform"] = {"scale": [1e-4, 1e-4, 0.001], "translate": [8.5, 47.4, 400.0]}
    with pytest.raises(ValueError, match="look like degrees"):
        load(tmp_path, document)
    document["transform"]["scale"] = [0.5, 0.5, 0.001]
    document["transform"]["translate"] = [-50.0, -50.0, 0.0]
    assert len(load(tmp_path, document).mesh.faces) == 40000


def test_no_town_in_metres_is_taken_for_degrees(tmp_path):
    """Houses on a map of its own about (8, 47); a silo of 20,000 flat facets; a spire beside a house."""
    assert load(tmp_path, placed([(0.0, 0.0), (40.0, 10.0)], [0.001] * 3)).surfaces.area.sum() > 0.0
    around = 2.0 * np.pi * np.arange(20000) / 20000
    ring = np.column_stack([np.cos(around), np.sin(around), 0.0 * around])
    vertices = np.rint(1e6 * np.concatenate([ring, ring + np.array([0.0, 0.0, 30.0])])).astype(int).tolist()
    walls = [[[a, (a + 1) % 20000, 20000 + (a + 1) % 20000, 20000 + a]] for a in range(20000)]
    silo = {"type": "Building", "geometry": [{"type": "MultiSurface", "lod": "2", "boundaries": walls}]}
    document = cases.house() | {"CityObjects": {"silo": silo}, "vertices": vertices}
    document["transform"] = {"scale": [1e-6] * 3, "translate": [8.0, 47.0, 0.0]}
    assert load(tmp_path, document).surfaces.area.sum() == pytest.approx(60.0 * np.pi, rel=1e-3)


def test_results_are_those_in_metres_and_the_geometry_stays(tmp_path):
    """Means, sums and areas of a city in feet are those of its twin in metres, in a file whose geometry is untouched."""
    made = {}
    for name, across in ((BOTH_IN_FEET, FOOT), ("EPSG:32118+5703", 1.0)):
        document = house(name, across, across)
        city, out = load(tmp_path, document), tmp_path / "out.json"
        sky = ws.sky_view_factor(city.mesh, city.points(200), 64, max_distance=3.0)  # metres
        value, error, area = city.surface_means(sky.value, sky.standard_error, points=city.points(200))
        city.write(tmp_path / "out.json", {"ws_sky_kwh_m2": value, "ws_sky_kwh_m2_error": error})
        written = json.loads(out.read_text())
        assert cases.unmarked(written) == cases.unmarked(json.loads(json.dumps(document)))
        surface = written["CityObjects"]["house"]["geometry"][0]["semantics"]["surfaces"][2]
        made[name] = [*value, *area, surface["ws_sky_kwh_m2"], surface["ws_sky_kwh"]]
    one, other = made.values()
    assert one == pytest.approx(other, rel=1e-3, nan_ok=True)  # float32 rounds otherwise where rays graze


def test_a_sequence_goes_by_its_first_line_and_templates_by_the_same_unit(tmp_path):
    tree = {"type": "GeometryInstance", "template": 0, "boundaries": [0], "transformationMatrix": np.eye(4).ravel().tolist()}
    vertices = (np.array(cases.VERTICES) * 0.001 / FOOT).tolist()
    template = {"templates": [cases.SOLID], "vertices-templates": vertices}
    head = house(BOTH_IN_FEET, **{"geometry-templates": template})
    head |= {"CityObjects": {}, "vertices": []}
    feature = {key: value for key, value in house(BOTH_IN_FEET).items() if key in ("CityObjects", "vertices")}
    planted = {"CityObjects": {"tree": {"type": "Building", "geometry": [tree]}}, "vertices": [[0, 0, 0]]}
    lines = [head, {"type": "CityJSONFeature", **feature}, {"type": "CityJSONFeature", **planted}]
    city = ws.load_city(cases.written(tmp_path / "a.city.jsonl", *lines))
    sums = {kind: city.surfaces.area[city.surfaces.type == kind].sum() for kind in cases.AREAS}
    assert sums == pytest.approx({kind: 2.0 * area for kind, area in cases.AREAS.items()}, rel=1e-9)
    ends = city.mesh.vertices[city.mesh.faces].reshape(2, -1, 3)
    assert ends[0].max(axis=0) == pytest.approx(ends[1].max(axis=0), rel=1e-12)


def raster(crs, across):
    """Terrain around the house, as a surface of cells of 30 m in units of so many metres."""
    heights = np.arange(16.0).reshape(4, 4) / across
    where = Affine(30.0 / across, 0, 299950.0 / across, 0, -30.0 / across, 60070.0 / across)
    return ws.rasters.surface((heights, where, crs), model="tin")


def test_terrain_stands_where_it_is_whatever_its_unit(tmp_path):
    """A raster in feet or metres beside a city in either has one place; a mesh is in the unit of the city's file."""
    in_metres, in_feet = raster("EPSG:32118", 1.0), raster(BOTH_IN_FEET, FOOT)
    expected = in_metres.mesh.vertices
    for system, across, up in (
        (BOTH_IN_FEET, FOOT, FOOT),
        ("EPSG:2263+5703", FOOT, 1.0),
        ("EPSG:32118", 1.0, 1.0),
        (None, 1.0, 1.0),
    ):
        document, each = house(system, across, up), np.array([across, across, up])
        for context in (in_metres, in_feet, ws.Mesh(expected / each, in_metres.mesh.faces)):
            guessed = system is None and not isinstance(context, ws.Mesh)
            with pytest.warns(match="the city is taken to be in metres on the same map") if guessed else nullcontext():
                city = load(tmp_path, document, context=context)
            assert city.mesh.vertices[-len(expected) :] == pytest.approx(expected, rel=1e-9)
            assert (city.surface >= 0).sum() == len(city.surface) - len(in_metres.mesh.faces)


def test_terrain_far_from_the_city_is_refused(tmp_path):
    """Of a city in feet without a system and terrain in metres: rays would start metres off the walls."""
    with (
        pytest.warns(match="the city is taken to be in metres on the same map"),
        pytest.raises(ValueError, match=r"^context: got terrain that is 698 km away from the city, want terrain around it"),
    ):
        load(tmp_path, house(None, FOOT, FOOT), context=raster("EPSG:32118", 1.0))
    near = np.add(raster("EPSG:32118", 1.0).mesh.vertices, (20_000.0, 0.0, 0.0))
    beside = ws.Mesh(near, raster(None, 1.0).mesh.faces)
    assert load(tmp_path, house(None, 1.0, 1.0), context=beside).mesh.faces.any()


def test_terrain_with_trees_is_refused(tmp_path):
    """The trees were left out without a word."""
    where = Affine(1.0, 0.0, 0.0, 0.0, -1.0, 3.0), None
    trees = rasters.surface((np.zeros((3, 3)), *where), canopy=(np.eye(3), *where))
    with pytest.raises(ValueError, match="^context: got a surface with tree crowns, .*pass its `canopy_mesh`"):
        load(tmp_path, house(None, 1.0, 1.0), context=trees)


def test_terrain_of_another_map_or_without_one_is_refused(tmp_path):
    with pytest.raises(
        ValueError, match=r"^context: got a raster in NAD83 / UTM zone 18N, want NAD83 / New York Long Island"
    ):
        load(tmp_path, house(BOTH_IN_FEET), context=raster("EPSG:26918", 1.0))
    with pytest.raises(
        ValueError, match=r"^context: got a raster without a CRS for a city in 'EPSG:2263\+6360', want a raster"
    ):
        load(tmp_path, house(BOTH_IN_FEET), context=raster(None, 1.0))
    assert load(tmp_path, house("EPSG:32118", 1.0, 1.0), context=raster(None, 1.0)).mesh.faces.any()


def test_the_command_line_counts_square_metres(call, tmp_path):
    path = cases.written(tmp_path / "a.city.json", house(BOTH_IN_FEET))
    status, _, err = call("bake", path, "-o", tmp_path / "a.csv", "--quantity", "sky", "--samples", 16)
    assert (status, err) == (0, "")
    table = np.genfromtxt(tmp_path / "a.csv", delimiter=",", names=True, dtype=None, encoding="utf-8")
    assert table["area_m2"].tolist() == pytest.approx(list(cases.AREAS.values()), rel=1e-8)
