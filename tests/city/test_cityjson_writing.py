"""Results in CityJSON: in the right places, right in number, and nothing else changed."""

import json
import re

import city_files as cases
import numpy as np
import pytest

import warpsample as ws

NAME = "ws_irradiation_kwh_m2"


def of_rows(city, base=10.0):
    """Values and errors of the surfaces, each row its own."""
    rows = np.arange(len(city.surfaces), dtype=np.float64)
    return {NAME: base + rows, f"{NAME}_error": 0.1 * (1.0 + rows)}


def rewritten(tmp_path, document, results=of_rows, **options):
    """The file as text, as it was and with results."""
    city = ws.load_city(cases.written(tmp_path / "a.city.json", document), **options)
    city.write(tmp_path / "b.city.json", results(city))
    return city, (tmp_path / "b.city.json").read_text(encoding="utf-8")


def test_surfaces_and_objects_get_their_numbers(tmp_path):
    _, text = rewritten(tmp_path, cases.house())
    thing = json.loads(text)["CityObjects"]["house"]
    ground, roof, wall = thing["geometry"][0]["semantics"]["surfaces"]
    assert ground == {"type": "GroundSurface", NAME: 10.0, f"{NAME}_error": 0.1} | totals(10.0, 0.1, 96.0)
    assert roof == {"type": "RoofSurface", "slope": 0.5, NAME: 11.0, f"{NAME}_error": 0.2} | totals(11.0, 0.2, 96.0)
    assert wall == {"type": "WallSurface", "outside": True, NAME: 12.0, f"{NAME}_error": 0.3} | totals(12.0, 0.3, 240.0)
    right = {"h": 5, "ws_area_m2_roof": 96.0, "ws_area_m2_wall": 240.0}
    for end, value, error, area in (("_roof", 11.0, 0.2, 96.0), ("_wall", 12.0, 0.3, 240.0)):
        right |= {f"{NAME}{end}": value, f"{NAME}_error{end}": error}
        right |= {f"{name}{end}": total for name, total in totals(value, error, area).items()}
    assert thing["attributes"] == pytest.approx(right)


def totals(value, error, area):
    return {"ws_irradiation_kwh": pytest.approx(value * area), "ws_irradiation_kwh_error": pytest.approx(error * area)}


def test_an_object_has_the_mean_of_its_own_faces_and_its_childrens(tmp_path):
    """By area, with the errors of independent surfaces; a grandchild counts for all above it, once."""
    document = cases.house(cases.surfaces())
    objects = document["CityObjects"]
    half = [[[corner // 2 for corner in point] for point in cases.VERTICES]]
    document["vertices"] += half[0]
    small = [[[corner + 16 for corner in ring] for ring in face] for face in cases.FACES]
    objects["part"] = {"type": "BuildingPart", "parents": ["house", "block"], "geometry": [cases.surfaces(boundaries=small)]}
    objects["block"] = {"type": "CityObjectGroup", "parents": ["nowhere"], "children": ["house", "part"]}
    objects["house"]["parents"] = ["block"]
    _, text = rewritten(tmp_path, document)
    found = {name: thing.get("attributes", {}) for name, thing in json.loads(text)["CityObjects"].items()}
    big, little = 96.0, 24.0
    mean = (big * 10.0 + little * 13.0) / (big + little)  # rows: roof, wall, ground of the house, then of its part
    error = np.hypot(big * 0.1, little * 0.4) / (big + little)
    for name in ("house", "block"):
        assert found[name][f"{NAME}_roof"] == pytest.approx(mean)
        assert found[name][f"{NAME}_error_roof"] == pytest.approx(error)
        assert found[name]["ws_irradiation_kwh_roof"] == pytest.approx(big * 10.0 + little * 13.0)
        assert found[name]["ws_irradiation_kwh_error_roof"] == pytest.approx(error * (big + little))
        assert found[name]["ws_area_m2_roof"] == 120.0
    assert found["part"][f"{NAME}_roof"] == 13.0
    assert not any(re.search("ground|_kwh_m2$", key) for key in found["house"])


def test_what_has_no_number_gets_none(tmp_path):
    def results(city):
        rows = np.where(city.surfaces.type == "RoofSurface", np.nan, 1.0)
        return {"ws_height": rows}

    _, text = rewritten(tmp_path, cases.house(), results)
    thing = json.loads(text)["CityObjects"]["house"]
    assert [surface.get("ws_height") for surface in thing["geometry"][0]["semantics"]["surfaces"]] == [1.0, None, 1.0]
    assert thing["attributes"] == {"h": 5, "ws_height_wall": 1.0, "ws_area_m2_wall": 240.0}
    road = cases.house(cases.surfaces())
    road["CityObjects"]["house"] |= {"type": "Road", "attributes": None}
    _, text = rewritten(tmp_path, road, lambda _: {"ws_height": np.ones(1)})
    assert json.loads(text)["CityObjects"]["house"]["attributes"] == {"ws_height": 1.0, "ws_area_m2": 432.0}
    assert "semantics" not in json.loads(text)["CityObjects"]["house"]["geometry"][0]


def test_roads_and_water_get_means_of_their_surfaces(tmp_path):
    """CityJSON 2.0 has types of surfaces for both. The bottom of water is not in its mean."""
    document = cases.house()
    types = {"a": ["TrafficArea", "AuxiliaryTrafficArea"], "b": ["WaterSurface", "WaterGroundSurface"]}
    document["CityObjects"] = {}
    for name, kind in (("a", "Road"), ("b", "WaterBody")):
        semantics = {"surfaces": [{"type": each} for each in types[name]], "values": [0, 1]}
        shape = cases.surfaces(boundaries=[cases.FACES[2], cases.FACES[6]], semantics=semantics)  # of 50 and 10 m2
        document["CityObjects"][name] = {"type": kind, "geometry": [shape]}
    _, text = rewritten(tmp_path, document, lambda _: {"ws_height": np.arange(1.0, 5.0)})
    road, water = (json.loads(text)["CityObjects"][name]["attributes"] for name in "ab")
    assert road == {"ws_height": pytest.approx((50 * 1.0 + 10 * 2.0) / 60, rel=1e-6), "ws_area_m2": 60.0}
    assert water == {"ws_height": 3.0, "ws_area_m2": 50.0}


def test_an_index_of_minus_zero_is_an_index(tmp_path):
    document = cases.house()
    document["CityObjects"]["house"]["geometry"][0]["semantics"]["surfaces"][1]["parent"] = 7777
    path = tmp_path / "a.json"
    path.write_text(json.dumps(document).replace("7777", "-0"))
    city = ws.load_city(path, split=True)
    city.write(tmp_path / "b.json", {"ws_height": np.ones(len(city.surfaces))})
    surfaces = json.loads((tmp_path / "b.json").read_text())["CityObjects"]["house"]["geometry"][0]["semantics"]["surfaces"]
    assert [surface["parent"] for surface in surfaces if surface["type"] == "RoofSurface"] == [0]


ODD = (
    '{"z":1.50,"type":"CityJSON","version":"1.1","é\\u00e9":["\\ud83d\\ude00","\\ud800","a\\"\\\\b",-0,-0.0,1E5,1e-7,'
    '123456789012345678901234567890,0.1000000000000000055511151231257827,1e999],"transform":{"scale":[1e-3,0.0010,1.0e-3],'
    '"translate":[0.0,0,-0.5]},"CityObjects":{"a":{"attributes":{"k":null,"t":true,"x":[{}]},"type":"Building","geometry":'
    '[{"type":"MultiSurface","lod":2.20,"boundaries":[[[0,1,2]]]}]}},"vertices":[[0,0,0],[1000,0,0],[0,1000,0]],"last":{}}'
)
"""Numbers, texts and members that a JSON library would spell otherwise, sort or lose."""


@pytest.mark.parametrize("space", ["", "\n", "\r\n \t"])
def test_all_else_is_spelt_as_before(tmp_path, space):
    (tmp_path / "a.json").write_bytes((ODD + space).encode())
    ws.load_city(tmp_path / "a.json").write(tmp_path / "b.json", {"ws_height": np.ones(1)})
    added = '"ws_height_roof":1.0,"ws_area_m2_roof":0.5'
    expected = (
        ODD.replace('"x":[{}]}', f'"x":[{{}}],{added}}}').replace("\\u00e9", "é").replace("\\ud83d\\ude00", "\U0001f600")
    )
    assert (tmp_path / "b.json").read_bytes() == (expected + space).encode()
    plain = ODD.replace("é", "")  # what is ASCII stays ASCII
    (tmp_path / "a.json").write_text(plain)
    ws.load_city(tmp_path / "a.json").write(tmp_path / "b.json", {"ws_height": np.ones(1)})
    assert (tmp_path / "b.json").read_text() == plain.replace('"x":[{}]}', f'"x":[{{}}],{added}}}')


def test_a_sequence_stays_one_line_by_line(repository, tmp_path):
    path = repository / "tests/city/data/3dbag_901.city.jsonl"
    city = ws.load_city(path)
    city.write(tmp_path / "out.city.jsonl", of_rows(city))
    before, after = path.read_text().splitlines(), (tmp_path / "out.city.jsonl").read_text().splitlines()
    assert before[0] == after[0]
    assert [json.dumps(cases.unmarked(json.loads(line))) for line in after] == [
        json.dumps(cases.unmarked(json.loads(line))) for line in before
    ]
    found = [float(value) for value in re.findall(rf'"{NAME}":([^,}}]+)', "".join(after))]
    assert found == (10.0 + np.arange(len(city.surfaces))).tolist()
    assert "".join(after).count(f'"{NAME}_roof"') == 104  # of 52 buildings and their parts


def test_split_gives_each_face_an_object_of_its_own(tmp_path):
    surfaces = [*cases.SEMANTICS["surfaces"], {"type": "Window", "parent": 2}, {"type": "+Facade", "children": [2]}]
    surfaces[2] = surfaces[2] | {"children": [3], "parent": 4}
    values = [[0, 1, 2, 2, 2, 2, 3, 3, None, None]]
    solid = cases.SOLID | {"semantics": {"surfaces": surfaces, "values": values, "more": 1}}
    city, text = rewritten(tmp_path, cases.house(solid), split=True)
    assert len(city.surfaces) == 10
    made = json.loads(text)["CityObjects"]["house"]["geometry"][0]["semantics"]
    assert made["values"] == [list(range(10))]
    assert made["more"] == 1
    assert [surface["type"] for surface in made["surfaces"]] == [*city.surfaces.type, "+Facade"]
    assert [surface[NAME] for surface in made["surfaces"][:10]] == (10.0 + np.arange(10)).tolist()
    walls = made["surfaces"][2:6]
    assert all(wall["children"] == [6, 7] and wall["parent"] == 10 and wall["outside"] for wall in walls)
    assert [window["parent"] for window in made["surfaces"][6:8]] == [2, 2]
    assert made["surfaces"][10] == {"type": "+Facade", "children": [2, 3, 4, 5]}
    assert set(made["surfaces"][8]) == {"type", NAME, f"{NAME}_error", "ws_irradiation_kwh", "ws_irradiation_kwh_error"}
    again = ws.load_city(tmp_path / "b.city.json")
    assert list(again.surfaces.type) == list(city.surfaces.type)
    assert again.surfaces.area.tolist() == city.surfaces.area.tolist()


def test_split_without_semantics_makes_them_of_what_is_built(tmp_path):
    _, text = rewritten(tmp_path, cases.house(cases.surfaces()), split=True)
    (geometry,) = json.loads(text)["CityObjects"]["house"]["geometry"]
    assert geometry["semantics"]["values"] == list(range(10))
    road = cases.house(cases.surfaces())
    road["CityObjects"]["house"]["type"] = "Road"
    _, text = rewritten(tmp_path, road, split=True)
    assert "semantics" not in json.loads(text)["CityObjects"]["house"]["geometry"][0]


def test_templates_are_not_written_to(tmp_path):
    tree = {"type": "GeometryInstance", "template": 0, "boundaries": [0], "transformationMatrix": np.eye(4).ravel().tolist()}
    semantics = {"surfaces": [{"type": "RoofSurface"}], "values": [0] * 10}
    templates = {"vertices-templates": cases.VERTICES, "templates": [cases.surfaces(semantics=semantics)]}
    document = cases.house(tree, **{"geometry-templates": templates})
    for split in (False, True):
        _, text = rewritten(tmp_path, document, split=split)
        made = json.loads(text)
        assert made["geometry-templates"] == templates
        assert made["CityObjects"]["house"]["geometry"] == [tree]
        assert made["CityObjects"]["house"]["attributes"]["ws_area_m2_roof"] == 432e6


def test_bad_arguments_of_writing(tmp_path):
    city = ws.load_city(cases.written(tmp_path / "a.json", cases.house()))
    good, there = {"ws_x": np.zeros(3)}, set(tmp_path.iterdir())
    for path, results, message in (
        (tmp_path / "a.json", good, "path: got .*, which is the input"),
        (tmp_path / "no" / "b.json", good, "path: got .*, whose folder does not exist"),
        (3, good, "path: got 3, want the path of a CityJSON file"),
        (tmp_path / "b.jsonl", good, "path: got .*, want a file that ends in .json, as the input does"),
        (tmp_path / "b.json", [1.0], r"results: got \[1.0\], want a dict of attribute names and arrays"),
        (tmp_path / "b.json", {"": np.zeros(3)}, "results: got .*, want a dict of attribute names"),
        (
            tmp_path / "b.json",
            {"ws_x": np.zeros(4)},
            r"results\['ws_x'\]: got shape \(4,\), want \(3,\), one for each surface",
        ),
        (tmp_path / "b.json", {"ws_x": ["a"] * 3}, r"results\['ws_x'\]: got dtype <U1, want real numbers"),
        *(
            (tmp_path / "b.json", good | {name: np.zeros(3)}, f"results: got '{name}', want names other than type, parent, ")
            for name in ("type", "parent", "children", "type_m2")
        ),
        (tmp_path / "b.json", {"ws_x_error": np.zeros(3)}, "results: got 'ws_x_error' without 'ws_x', want both the err"),
        (
            tmp_path / "b.json",
            good | {"ws_x_error_m2": np.zeros(3)},
            "results: got 'ws_x_error_m2', want 'ws_x_m2_error' as",
        ),
        *(
            (tmp_path / "b.json", good | {more: np.zeros(3)}, f"results: got two results for the attribute '{name}', want")
            for more, name in (("ws_x_m2", "ws_x_roof"), ("ws_x_roof", "ws_x_roof"), ("ws_area_m2", "ws_area_m2_roof"))
        ),
    ):
        with pytest.raises((TypeError, ValueError), match=f"^{message}"):
            city.write(path, results)
    assert set(tmp_path.iterdir()) == there
