"""CityJSON in all its versions and shapes: the right surfaces, once each, with the right areas and names."""

import json

import city_files as cases
import numpy as np
import pytest

import warpsample as ws


def areas(city):
    """{type: m2} of a city's surfaces."""
    kinds = city.surfaces.type
    return {kind: float(city.surfaces.area[kinds == kind].sum()) for kind in sorted(set(kinds))}


def load(tmp_path, document, **options):
    return ws.load_city(cases.written(tmp_path / "a.city.json", document), **options)


def test_a_tile_of_3dbag(repository):
    city = ws.load_city(repository / "tests/city/data/3dbag_901.city.jsonl")
    assert [geometry.lod for geometry in city.geometries] == [2.2] * 52
    assert city.surfaces.faces.sum() == 1316
    found = areas(city)
    right = {"RoofSurface": 5340.10, "WallSurface": 17013.21, "GroundSurface": 4601.59}  # shared/CITY.md, section 8
    assert {kind: round(area, 2) for kind, area in found.items()} == right
    # Faces that are not quite in a plane have more area as triangles than by Newell's formula.
    assert city.mesh.face_areas.sum() == pytest.approx(sum(right.values()), rel=1e-5)
    by_mesh = np.bincount(city.surface, city.mesh.face_areas)
    assert by_mesh == pytest.approx(city.surfaces.area, rel=1e-3)
    assert np.abs(city.mesh.bounds[0] - [81800, 447200, 0]).max() < 500.0
    below = ws.load_city(repository / "tests/city/data/3dbag_901.city.jsonl", lod=0)
    assert {round(z, 3) for z in below.mesh.vertices[below.mesh.used][:, 2].tolist()} == {0.0}
    assert len(ws.load_city(repository / "tests/city/data/3dbag_901.city.jsonl", split=True).surfaces) == 1316


def test_faces_turn_outward_and_holes_stay_open(tmp_path):
    city = load(tmp_path, cases.house())
    assert areas(city) == cases.AREAS
    assert city.mesh.face_areas.sum() == pytest.approx(432.0)
    volume = (
        np.einsum("fi,fi->", city.mesh.vertices[city.mesh.faces[:, 0]] - city.mesh.bounds[0], city.mesh.cross_products) / 6
    )
    assert volume == pytest.approx(480.0)
    assert city.mesh.bounds.tolist() == [[85000.5, 446000.25, -1.5], [85010.5, 446010.25, 3.5]]
    roof = city.mesh.face_normals[city.surface == list(city.surfaces.type).index("RoofSurface")]
    assert roof.tolist() == [[0.0, 0.0, 1.0]] * len(roof)


def test_versions_and_the_lack_of_a_transform(tmp_path):
    for version in ("1.0", "1.1", "2.0", "2.0.1"):
        assert areas(load(tmp_path, cases.house(version=version))) == cases.AREAS
    plain = cases.house(version="1.0", vertices=[[x / 1000.0, y / 1000.0, z / 1000.0] for x, y, z in cases.VERTICES])
    del plain["transform"]
    assert areas(load(tmp_path, plain)) == cases.AREAS


def test_a_sequence_has_vertices_of_its_own_on_each_line(tmp_path):
    head = cases.house(CityObjects={}, vertices=[])
    feature = {key: value for key, value in cases.house().items() if key in ("CityObjects", "vertices")}
    other = json.loads(json.dumps(feature).replace("house", "other"))
    other["vertices"] = [[x + 50000, y, z] for x, y, z in other["vertices"]]
    lines = [head, {"type": "CityJSONFeature", "id": "a", **feature}, {"type": "CityJSONFeature", "id": "b", **other}]
    path = cases.written(tmp_path / "a.city.jsonl", *lines)
    path.write_text(path.read_text().replace("\n", "\r\n\n"))  # as some programs end lines, and with empty ones
    city = ws.load_city(path)
    assert areas(city) == {kind: 2 * area for kind, area in cases.AREAS.items()}
    assert list(city.surfaces.object) == ["house"] * 3 + ["other"] * 3
    assert city.mesh.bounds[1, 0] == pytest.approx(85060.5)


def test_a_line_with_a_transform_of_its_own_is_read_by_it(tmp_path):
    """Another tile's line, joined to a sequence without a conversion of its vertices."""
    head = cases.house(CityObjects={}, vertices=[])
    moved = {"scale": [0.002, 0.001, 0.001], "translate": [7.0, 8.0, 9.0]}
    feature = cases.house(type="CityJSONFeature", id="a", transform=moved)
    city = ws.load_city(cases.written(tmp_path / "a.city.jsonl", head, feature))
    stored = np.array(cases.VERTICES)
    assert np.allclose(city.mesh.bounds, [stored.min(axis=0), stored.max(axis=0)] * np.array(moved["scale"]) + [7, 8, 9])


def test_a_city_of_ground_surfaces_alone_gets_no_points(tmp_path):
    ground = {"surfaces": [{"type": "GroundSurface"}], "values": [0] * len(cases.FACES)}
    city = load(tmp_path, cases.house({"type": "MultiSurface", "lod": 2, "boundaries": cases.FACES, "semantics": ground}))
    with pytest.raises(ValueError, match="^mesh: got a city of GroundSurfaces alone, which get no points, want"):
        city.points()


def test_faces_of_a_city_of_ground_surfaces_alone_are_refused(call, tmp_path):
    ground = {"surfaces": [{"type": "GroundSurface"}], "values": [0] * len(cases.FACES)}
    made = cases.house({"type": "MultiSurface", "lod": 2, "boundaries": cases.FACES, "semantics": ground})
    path = cases.written(tmp_path / "ground.city.json", made)
    status, _, err = call("bake", path, "-o", tmp_path / "out.csv", "--at", "faces", "--samples", "16")
    assert (status, "error: mesh: got a city of GroundSurfaces alone" in err) == (2, True)


def test_every_depth_of_boundaries_and_of_semantics(tmp_path):
    flat = [0, 1, *[2] * 8]
    surfaces = cases.SEMANTICS["surfaces"]
    for kind, boundaries, values in (
        ("MultiSurface", cases.FACES, flat),
        ("CompositeSurface", cases.FACES, flat),
        ("Solid", [cases.FACES[:2], cases.FACES[2:]], [flat[:2], flat[2:]]),
        ("MultiSolid", [[cases.FACES]], [[flat]]),
        ("CompositeSolid", [[cases.FACES[:5]], [cases.FACES[5:]]], [[flat[:5]], [flat[5:]]]),
    ):
        semantics = {"surfaces": surfaces, "values": values}
        shape = {"type": kind, "lod": 2, "boundaries": boundaries, "semantics": semantics}
        city = load(tmp_path, cases.house(shape))
        assert areas(city) == cases.AREAS, kind
        assert city.surfaces.lod.tolist() == [2.0] * 3


@pytest.mark.parametrize(
    ("values", "left"),
    [(None, 0), ([None], 0), ([[0, 1, *[None] * 8]], 2), ([[None, 1, *[2] * 8]], 2), ([[None] * 10], 0)],
)
def test_null_at_any_level_is_a_face_without_semantics(tmp_path, values, left):
    """Which is named by its normal, so that the areas stay the same."""
    solid = cases.SOLID | {"semantics": cases.SEMANTICS | {"values": values}}
    city = load(tmp_path, cases.house(solid))
    assert areas(city) == cases.AREAS
    assert np.count_nonzero(city.rows.semantic >= 0) == left


def test_one_level_of_detail_of_each_object(tmp_path):
    low = {"type": "Solid", "lod": 1.2, "boundaries": [cases.FACES[:6]]}
    foot = cases.surfaces(0, boundaries=cases.FACES[:1])
    document = cases.house(foot, low, cases.SOLID)
    document["CityObjects"]["shed"] = {"type": "Building", "geometry": [low]}
    city = load(tmp_path, document)
    assert {(name, lod) for name, lod in zip(city.surfaces.object, city.surfaces.lod, strict=True)} == {
        ("house", 2.2),
        ("shed", 1.2),
    }
    for lod in (1.2, "1.2"):
        assert set(load(tmp_path, document, lod=lod).surfaces.lod) == {1.2}
    assert set(load(tmp_path, document, lod=0).surfaces.object) == {"house"}
    with pytest.raises(ValueError, match=r"^lod: got 3, want a level of detail with surfaces in .*: 0, 1\.2, 2\.2$"):
        load(tmp_path, document, lod=3)
    with pytest.raises(ValueError, match=r"^lod: got none, want a level of detail with surfaces in .*: 0$"):
        load(tmp_path, cases.house(foot))
    for lod in ("high", True, -1, float("nan"), "1.", [2]):
        with pytest.raises(ValueError, match=r"^lod: got .*, want a level of detail, such as 2\.2$"):
            load(tmp_path, document, lod=lod)


def test_a_building_is_left_out_where_its_parts_have_more_detail(tmp_path):
    """Else all that is finer would be within it. Furniture of more detail takes nothing away."""
    block = {"type": "Solid", "lod": "1", "boundaries": [cases.FACES[:6]]}
    for kind, found in (("BuildingPart", {"part"}), ("BuildingInstallation", {"house", "part"})):
        document = cases.house(block)
        document["CityObjects"]["part"] = {"type": kind, "parents": ["house"], "geometry": [cases.SOLID]}
        assert set(load(tmp_path, document).surfaces.object) == found
        assert set(load(tmp_path, document, lod=1).surfaces.object) == {"house"}


def test_what_a_file_has_twice_is_traced_once(tmp_path):
    with_names = cases.surfaces(semantics={"surfaces": cases.SEMANTICS["surfaces"], "values": [0, 1, *[2] * 8]})
    plain = cases.SOLID | {"semantics": None}
    del plain["semantics"]
    for geometries, kind in (
        ((with_names, plain), "MultiSurface"),
        ((plain, with_names), "MultiSurface"),
        ((cases.surfaces(), cases.SOLID), "Solid"),
        ((cases.surfaces(), plain), "Solid"),
        ((with_names, cases.SOLID), "Solid"),
    ):
        document = cases.house(*geometries)
        city = load(tmp_path, document)
        assert areas(city) == cases.AREAS
        (taken,) = city.geometries
        assert geometries[taken.number]["type"] == kind


def test_parts_of_one_kind_are_all_taken(tmp_path):
    city = load(
        tmp_path, cases.house(cases.surfaces(boundaries=cases.FACES[:4]), cases.surfaces(boundaries=cases.FACES[4:]))
    )
    assert areas(city) == cases.AREAS


@pytest.mark.parametrize("mirrored", [False, True])
def test_templates_stand_where_they_are_placed(tmp_path, mirrored):
    points = [[x / 1000.0, y / 1000.0, z / 1000.0] for x, y, z in cases.VERTICES]
    matrix = [0, -2, 0, 1, 2, 0, 0, 2, 0, 0, 2, 3, 0, 0, 0, 1]  # turned to the left, twice as large, moved by 1, 2, 3
    if mirrored:
        matrix[10] = -2
    tree = {"type": "GeometryInstance", "template": 1, "boundaries": [6], "transformationMatrix": matrix}
    templates = {"vertices-templates": points, "templates": [cases.surfaces(3), cases.surfaces("2")]}
    document = cases.house(tree, **{"geometry-templates": templates})
    document["CityObjects"]["again"] = {"type": "SolitaryVegetationObject", "geometry": [tree]}
    city = load(tmp_path, document)
    assert areas(city) == {kind: 4 * area for kind, area in (cases.AREAS | {"": 432.0}).items()}
    low, high = city.mesh.bounds - [85010.5, 446010.25, 3.5]
    assert low.tolist() == pytest.approx([-20 + 1, 2, 3 - 10 * mirrored], abs=1e-9)
    assert high.tolist() == pytest.approx([1, 22, 13 - 10 * mirrored], abs=1e-9)
    one = city.mesh.cross_products[city.surface < np.argmax(city.surfaces.object == "again")]
    at = city.mesh.vertices[city.mesh.faces[: len(one), 0]] - city.mesh.bounds[0]
    assert np.einsum("fi,fi->", at, one) / 6 == pytest.approx(8 * 480.0)  # inside out, it were negative


def test_types_of_objects_and_of_surfaces(tmp_path):
    """What is not known is built, and what is not built has no roof; points and lines are left out."""
    for kind, types in (("BuildingZ", set(cases.AREAS)), ("+Pavilion", set(cases.AREAS)), ("Road", {""})):
        document = cases.house(cases.surfaces(), {"type": "MultiPoint", "lod": "2.2", "boundaries": [0, 1]})
        document["CityObjects"]["house"]["type"] = kind
        assert set(load(tmp_path, document).surfaces.type) == types
    own = cases.SEMANTICS | {"surfaces": [{"type": "+Floor"}, {"type": "Window"}, {"type": "Door"}]}
    assert set(load(tmp_path, cases.house(cases.SOLID | {"semantics": own})).surfaces.type) == {"+Floor", "Window", "Door"}


def test_a_closed_ring_and_faces_without_area(tmp_path):
    """Against the specification, and in real files: they change nothing."""
    faces = [[[*ring, ring[0]] for ring in face] for face in cases.FACES]
    flaws = [[[0, 1]], [[]], [], [[0, 0, 0]], [[0, 1, 2, 3], [8, 9]], [[0, 1, 2, 3], []]]
    city = load(tmp_path, cases.house(cases.surfaces(boundaries=[*faces, *flaws])))
    assert areas(city) == cases.AREAS | {"RoofSurface": 96.0 + 200.0}
    assert np.isfinite(city.mesh.vertices).all()


def test_the_table_as_a_frame(tmp_path):
    frame = load(tmp_path, cases.house()).surfaces.to_frame()
    assert list(frame) == ["object", "type", "lod", "faces", "area"]
    assert frame["area"].tolist() == [96.0, 96.0, 240.0]
    assert frame["faces"].tolist() == [1, 1, 8]
