"""Small CityJSON files: a house with a hole in its roof, in every version, and the object that each test changes."""

import copy
import json

SQUARE = [(0, 0), (10000, 0), (10000, 10000), (0, 10000)]
HOLE = [(4000, 4000), (4000, 6000), (6000, 6000), (6000, 4000)]
VERTICES = [[x, y, z] for z in (0, 5000) for x, y in SQUARE] + [[x, y, z] for z in (0, 5000) for x, y in HOLE]
"""A house of 10 x 10 x 5 m around a shaft of 2 x 2 m, in millimetres."""
FACES = [
    [[3, 2, 1, 0], [11, 10, 9, 8]],
    [[4, 5, 6, 7], [12, 13, 14, 15]],
    *([[i, (i + 1) % 4, 4 + (i + 1) % 4, 4 + i]] for i in range(4)),
    *([[8 + i, 8 + (i + 1) % 4, 12 + (i + 1) % 4, 12 + i]] for i in range(4)),
]
"""Floor and roof, four walls, and the four of the shaft; counter-clockwise seen from outside."""
AREAS = {"GroundSurface": 96.0, "RoofSurface": 96.0, "WallSurface": 200.0 + 40.0}
SEMANTICS = {
    "surfaces": [
        {"type": "GroundSurface"},
        {"type": "RoofSurface", "slope": 0.50},
        {"type": "WallSurface", "outside": True},
    ],
    "values": [[0, 1, *[2] * 8]],
}
SOLID = {"type": "Solid", "lod": "2.2", "boundaries": [FACES], "semantics": SEMANTICS}
TRANSFORM = {"scale": [0.001, 0.001, 0.001], "translate": [85000.5, 446000.25, -1.5]}


def house(*geometries, version="2.0", **members):
    """A file of one Building with these geometries, by default the solid; a copy, to be changed."""
    made = {"type": "CityJSON", "version": version, "transform": TRANSFORM, "CityObjects": {}, "vertices": VERTICES}
    made["CityObjects"]["house"] = {"type": "Building", "attributes": {"h": 5}, "geometry": list(geometries) or [SOLID]}
    return copy.deepcopy(made | members)


def surfaces(lod="2.2", **members):
    """These faces as a MultiSurface without semantics."""
    return copy.deepcopy({"type": "MultiSurface", "lod": lod, "boundaries": FACES} | members)


def written(path, *documents):
    """The path of a file of these objects, a line each."""
    path.write_text("".join(f"{json.dumps(document)}\n" for document in documents), encoding="utf-8")
    return path


def unmarked(value):
    """What is read of a JSON text, without the attributes that are ours and attributes that are empty without them."""
    if isinstance(value, dict):
        left = {key: unmarked(item) for key, item in value.items() if not key.startswith("ws_")}
        return {key: item for key, item in left.items() if not (key == "attributes" and item == {})}
    return [unmarked(item) for item in value] if isinstance(value, list) else value
