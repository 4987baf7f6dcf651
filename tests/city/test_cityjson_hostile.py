"""Damaged and hostile CityJSON is refused in one sentence, soon, or read and written; nothing crashes."""

import copy
import json
import re
import tracemalloc

import city_files as cases
import numpy as np
import pytest

import warpsample as ws

TREE = {"type": "GeometryInstance", "template": 0, "boundaries": [0]}
TEMPLATES = {"vertices-templates": cases.VERTICES, "templates": [cases.surfaces()]}


def refused(path, why):
    return pytest.raises(
        ValueError, match=f"^path: got '{re.escape(str(path))}', which cannot be read as a CityJSON file: {why}"
    )


def geometry(**changes):
    return cases.house(cases.SOLID | changes)


def with_parents(parents):
    document = cases.house()
    for name, above in parents.items():
        document["CityObjects"][name] = {"type": "Building", "parents": above, "geometry": [cases.SOLID]}
    return document


DAMAGED = {
    "a type": (
        cases.house(type="FeatureCollection"),
        "the JSON has the type 'FeatureCollection', want 'CityJSON'$",
    ),
    "a version": (cases.house(version="0.9"), "the CityJSON version is '0.9', want 1.0, 1.1 or 2.0$"),
    "a version that is a number": (cases.house(version=2), "version: got 2, want a text$"),
    "no transform": ({k: v for k, v in cases.house().items() if k != "transform"}, "the JSON member transform is missing$"),
    "a scale of 0": (
        cases.house(transform=cases.TRANSFORM | {"scale": [0, 1, 1]}),
        r"transform.scale: got \[0.0, 1.0, 1.0\]",
    ),
    "a scale of two": (cases.house(transform=cases.TRANSFORM | {"scale": [1, 1]}), "transform.scale: got .*, want lists of"),
    "no objects": (cases.house(CityObjects={}), "the file has no city objects with surfaces$"),
    "a list of objects": (cases.house(CityObjects=[]), r"CityObjects: got \[\], want an object$"),
    "an object that is none": (cases.house(CityObjects={"a": 3}), "CityObjects.a: got 3, want an object$"),
    "vertices that are none": (cases.house(vertices=7), "vertices: got 7, want a list$"),
    "vertices of two": (cases.house(vertices=[[1, 2]]), r"vertices: got \[\[1, 2\]\], want lists of three numbers$"),
    "vertices of texts": (cases.house(vertices=[["1", 2, 3]]), "vertices: got a number of type str, want"),
    "vertices of bools": (cases.house(vertices=[[True, 2, 3]]), "vertices: got a number of type bool, want"),
    "vertices beyond all": (cases.house(vertices=[[10**400, 2, 3]]), "int too large"),
    "vertices beyond float64": (
        cases.house(vertices=[[1e308, 2, 3]], transform={"scale": [1e9] * 3, "translate": [0] * 3}),
        r"the file has coordinates beyond 1e\+36$",
    ),
    "a corner beyond": (
        geometry(boundaries=[[[[0, 1, 99]]]]),
        r"CityObjects.house.geometry\[0\].boundaries: got the vertex 99",
    ),
    "a corner below": (
        geometry(boundaries=[[[[0, 1, -1]]]]),
        ".*: got the vertex -1, want one of the 16 vertices, counted from 0$",
    ),
    "a huge corner": (geometry(boundaries=[[[[0, 1, 10**30]]]]), ".*: got the vertex 10{30}, want"),
    "a corner of 1.5": (
        geometry(boundaries=[[[[0, 1, 1.5]]]]),
        ".*: got the corner 1.5, want whole numbers, nested as deep as in a Solid$",
    ),
    "a corner of null": (geometry(boundaries=[[[[0, 1, None]]]]), ".*: got the corner None, want"),
    "too deep": (geometry(boundaries=[cases.SOLID["boundaries"]]), r".*: got the corner \[.*, want whole numbers"),
    "not deep enough": (geometry(boundaries=cases.FACES), ".*boundaries: got .*, want a ring, a list of vertices$"),
    "boundaries of a number": (geometry(boundaries=3), ".*boundaries: got 3, want a list$"),
    "another geometry": (geometry(type="Sphere"), r".*geometry\[0\].type: got 'Sphere', want one of MultiSurface, "),
    "no type": (cases.house({"lod": 2}), r"the JSON member CityObjects.house.geometry\[0\].type is missing$"),
    "no level of detail": (geometry(lod=None), ".*lod: got None, want a level of detail, such as 2.2$"),
    "semantics of a text": (geometry(semantics="roof"), ".*semantics: got 'roof', want an object$"),
    "semantics without types": (
        geometry(semantics={"surfaces": [{}], "values": [[0] * 10]}),
        r".*surfaces\[0\].type is missing",
    ),
    "semantics beyond": (
        geometry(semantics={"surfaces": [], "values": [[0] * 10]}),
        ".*values: got 0, want null or the number",
    ),
    "semantics too short": (
        geometry(semantics=cases.SEMANTICS | {"values": [[0, 1]]}),
        r".*values: got \[0, 1\], want null or a list of 10",
    ),
    "semantics too flat": (
        geometry(semantics=cases.SEMANTICS | {"values": [0]}),
        r".*values: got 0, want null or a list of 10",
    ),
    "semantics too deep": (
        geometry(semantics=cases.SEMANTICS | {"values": [[[0]] * 10]}),
        r".*values: got \[0\], want null or the",
    ),
    "a parent beyond": (
        geometry(semantics={"surfaces": [{"type": "Door", "parent": 1}], "values": None}),
        r".*surfaces\[0\].parent: got 1, want a whole number below 1",
    ),
    "attributes of a list": (with_attributes := cases.house(), ""),
    "its own parent": (with_parents({"a": ["a"]}), "the city object 'a' is its own ancestor; correct the lists of parents$"),
    "a circle": (
        with_parents({"a": ["b"], "b": ["c"], "c": ["a"]}),
        "the city object 'a' is its own ancestor; correct the lists of parents$",
    ),
    "many parents": (
        with_parents({f"a{i}": [f"a{i + 1}"] for i in range(300)}),
        "the city object 'a0' has more than 100 ancestors$",
    ),
    "parents of numbers": (with_parents({"a": [3]}), r"CityObjects.a.parents\[0\]: got 3, want a text$"),
    "no templates": (cases.house(TREE), r"CityObjects.house.geometry\[0\].template: got 0, want a whole number below 0"),
    "a template of a template": (
        cases.house(TREE, **{"geometry-templates": TEMPLATES | {"templates": [TREE | {"lod": "2"}]}}),
        r"geometry-templates.templates\[0\].type: got 'GeometryInstance', want one of",
    ),
    "a template without place": (
        cases.house(TREE | {"boundaries": []}, **{"geometry-templates": TEMPLATES}),
        ".*got .*, want one",
    ),
    "a template beyond": (
        cases.house(TREE | {"boundaries": [16]}, **{"geometry-templates": TEMPLATES}),
        ".*boundaries.0.: got 16",
    ),
    "a matrix of nine": (
        cases.house(TREE | {"transformationMatrix": [1] * 9}, **{"geometry-templates": TEMPLATES}),
        ".*transformationMatrix: got .*, want 16 finite numbers$",
    ),
    "a perspective": (
        cases.house(TREE | {"transformationMatrix": [1.0] * 16}, **{"geometry-templates": TEMPLATES}),
        r".*transformationMatrix: got \[1.0, 1.0, 1.0, 1.0\] as the last row of the matrix, want \[0, 0, 0, 1\]$",
    ),
}
with_attributes["CityObjects"]["house"]["attributes"] = [1]
DAMAGED["attributes of a list"] = (with_attributes, r"CityObjects.house.attributes: got \[1\], want an object$")


def test_a_file_without_an_area_is_named(tmp_path):
    flat = cases.surfaces(boundaries=[[[0, 1, 0]]])
    path = cases.written(tmp_path / "a.json", cases.house(flat))
    with pytest.raises(ValueError, match=rf"^path: got '{re.escape(str(path))}', all of whose polygons have no area, want"):
        ws.load_city(path)


@pytest.mark.parametrize("name", DAMAGED)
def test_what_is_damaged_is_refused_in_a_sentence(tmp_path, name):
    document, why = DAMAGED[name]
    path = cases.written(tmp_path / "a.json", document)
    with refused(path, why) as caught:
        ws.load_city(path)
    assert "\n" not in str(caught.value)
    assert len(str(caught.value)) < 400


@pytest.mark.parametrize(
    ("text", "why"),
    [
        ("", "the file is empty$"),
        ("   \n ", "the file has no city objects with surfaces$"),
        ("[]", r"the JSON is \[\], want an object$"),
        ("hello", "Expecting value"),
        ('{"type":"CityJSON","type":"CityJSON"}', "the JSON has an object with two members 'type', want each name once$"),
        ('{"type":"CityJSON","version":"2.0","x":NaN}', "the JSON has the number NaN, want finite numbers$"),
        ("[" * 100_000, "the JSON is nested too deeply$"),
        ('{"a":' * 100_000, "the JSON is nested too deeply$"),
        ('{"type":"CityJSONFeature"}', "the JSON has the type 'CityJSONFeature', want 'CityJSON'$"),
        ('{"type":"CityJSON","version":"1.0","vertices":[],"CityObjects":{}}\n{"type":"CityJSON"', "line 2: Expecting"),
        (
            '{"type":"CityJSON","version":"1.0","vertices":[],"CityObjects":{}}\n{"type":"Feature"}',
            "line 2: the JSON has the type 'Feature', want 'CityJSONFeature'$",
        ),
        ('{"type":"CityJSON","version":"2.0","x":' + "9" * 5000 + "}", "the JSON has a number of more than 4,300 digits$"),
    ],
)
def test_what_is_no_cityjson_is_refused_in_a_sentence(tmp_path, text, why):
    path = tmp_path / "a.city.jsonl"
    path.write_text(text)
    with refused(path, why):
        ws.load_city(path)
    path.write_bytes(b'{"type":"\xff\xfe"}')
    with refused(path, "the JSON is not encoded in UTF-8$"):
        ws.load_city(path)


def test_polygons_that_cross_themselves_are_reported_and_read(tmp_path):
    """A square whose sides cross has no area by Newell's formula, and a square's in triangles; all else is as it was."""
    faces = [[[0, 2, 1, 3]], *cases.FACES[1:]]
    path = cases.written(tmp_path / "a.json", cases.house(cases.surfaces(boundaries=faces)))
    with pytest.warns(
        UserWarning, match=r"a\.json' with 1 of 10 polygons that cross themselves .* of object 'house'; the triangles"
    ) as warned:
        city = ws.load_city(path, split=True)
    assert warned[0].filename == __file__
    assert city.surfaces.area.tolist() == [0.0, 96.0, *[50.0] * 4, *[10.0] * 4]
    covered = np.bincount(city.surface, city.mesh.face_areas)
    assert covered.tolist() == [100.0, 96.0, *[50.0] * 4, *[10.0] * 4]
    city.write(tmp_path / "b.json", {"ws_x": city.surface_means(np.ones(len(city.surface)))[0]})
    house = json.loads((tmp_path / "b.json").read_text())["CityObjects"]["house"]
    assert {name: house["attributes"][name] for name in ("ws_x_wall", "ws_area_m2_wall")} == {
        "ws_x_wall": 1.0, "ws_area_m2_wall": 240.0,
    }  # fmt: skip


def test_wherever_a_file_ends_early_it_is_refused(tmp_path):
    content = json.dumps(cases.house()).encode()
    path = tmp_path / "a.json"
    for end in range(1, len(content), 7):
        path.write_bytes(content[:end])
        with refused(path, ""):
            ws.load_city(path)


ODD = [None, True, -1, 0, 1.5, 10**20, "", "x", [], {}, [[]], [None], {"type": "Solid"}]


def nodes(value, path=()):
    yield path
    items = value.items() if isinstance(value, dict) else enumerate(value) if isinstance(value, list) else ()
    for key, item in items:
        yield from nodes(item, (*path, key))


@pytest.mark.filterwarnings("ignore:path. got .* polygons that cross themselves:UserWarning")
def test_whatever_stands_in_its_place_is_refused_or_read_and_written(tmp_path):
    """Each node of a file with templates, parents and semantics becomes one of the odd values."""
    document = cases.house(cases.SOLID, TREE | {"transformationMatrix": np.eye(4).ravel().tolist()})
    document["geometry-templates"] = TEMPLATES
    document["CityObjects"]["part"] = {"type": "BuildingPart", "parents": ["house"], "geometry": [cases.surfaces()]}
    rng, places = np.random.default_rng(3), list(nodes(document))[1:]
    outcomes = {"read": 0, "refused in a line": 0}
    for where in rng.permutation(len(places))[:150]:
        changed = copy.deepcopy(document)
        *above, last = places[where]
        holder = changed
        for key in above:
            holder = holder[key]
        holder[last] = ODD[rng.integers(len(ODD))]
        outcomes[_outcome(tmp_path, changed)] += 1
    assert min(outcomes.values()) > 20


def _outcome(tmp_path, document):
    """What becomes of a file; if it is read, it can be written and read again."""
    path = cases.written(tmp_path / "a.json", document)
    try:
        city = ws.load_city(path, split=True)
    except ValueError as error:
        return f"refused in {'lines' if chr(10) in str(error) else 'a line'}"
    city.write(tmp_path / "b.json", {"ws_x": np.ones(len(city.surfaces))})
    again = ws.load_city(tmp_path / "b.json", split=True)
    assert again.surfaces.area.tolist() == city.surfaces.area.tolist()
    return "read"


def test_a_template_that_is_placed_without_end_takes_no_memory(tmp_path, monkeypatch):
    """A few bytes stand for 10^9 corners: refused as soon as the free memory would not hold them."""
    import psutil

    template = cases.surfaces(boundaries=cases.FACES * 100)
    objects = {f"t{i}": {"type": "CityFurniture", "geometry": [TREE]} for i in range(400)}
    document = cases.house(CityObjects=objects, **{"geometry-templates": TEMPLATES | {"templates": [template]}})
    path = cases.written(tmp_path / "a.json", document)

    class Free:
        available = 1 << 28

    monkeypatch.setattr(psutil, "virtual_memory", Free)
    tracemalloc.start()
    with pytest.raises(MemoryError, match="corners and more need .* GB are free; take a part of the city$"):
        ws.load_city(path)
    peak = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    assert peak < 1 << 27


def test_an_object_of_very_many_parents_is_refused_by_their_number(tmp_path):
    document = cases.house()
    document["CityObjects"] |= {f"g{i}": {"type": "CityObjectGroup"} for i in range(20_000)}
    document["CityObjects"]["house"]["parents"] = [f"g{i}" for i in range(20_000)]
    path = cases.written(tmp_path / "a.json", document)
    with refused(path, "the city object 'house' has more than 100 ancestors$"):
        ws.load_city(path)
