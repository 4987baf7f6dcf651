"""Choice of the geometries to trace: one level of detail (LoD) per object, and each surface once."""

import re
from typing import Any

from warpsample.city.cityjson.boundaries import DEPTHS
from warpsample.host.arguments import quote
from warpsample.host.json_tree import Part

INSTANCE = "GeometryInstance"
_NO_SURFACES = ("MultiPoint", "MultiLineString")
_LEAST = 1.0  # least LoD chosen by default; lower ones are footprints
_MOST_ANCESTORS = 100

Choice = tuple[int, Part, float]
"""Number of a geometry in its object, the geometry (for an instance, its template), and its LoD."""


def as_lod(value: Any, argument: str) -> float:
    """Convert a level of detail (LoD), 2.2 or "2.2" for example, to a float.

    Raises:
        ValueError: the value is no level of detail.
    """
    is_number = type(value) in (int, float) and 0 <= value < 100
    if not is_number and not (isinstance(value, str) and re.fullmatch(r"\d(\.\d+)?", value)):
        raise ValueError(f"{argument}: got {quote(value)}, want a level of detail, such as 2.2")
    return float(value)


def list_surface_geometries(thing: Part, templates: list[Part]) -> list[Choice]:
    """Return the geometries of a city object that consist of surfaces; points and lines are left out."""
    made = []
    for number, placed in enumerate(thing.parts("geometry")):
        is_instance = placed.text("type") == INSTANCE
        geometry = templates[placed.index("template", templates)] if is_instance else placed
        kind = geometry.text("type")
        if kind not in DEPTHS and kind not in _NO_SURFACES:
            raise ValueError(f"{geometry.at('type')}: got {quote(kind)}, want one of {', '.join((*DEPTHS, *_NO_SURFACES))}")
        if kind in DEPTHS:
            made.append((number, geometry, as_lod(geometry.content.get("lod"), geometry.at("lod"))))
    return made


def choose_geometries(found: list[Choice], thing: Part, lod: float | None) -> list[Choice]:
    """Return the geometries of a city object at one level of detail; by default the highest that is not a footprint.

    Many files have the same faces both as surfaces and as a solid. The form with semantics is taken, or else the solid.
    """
    level = max((choice[2] for choice in found if choice[2] >= _LEAST), default=None) if lod is None else lod
    kinds: dict[str, list[Choice]] = {"solids": [], "surfaces": [], INSTANCE: []}
    for number, geometry, own in found:
        is_instance = thing.values("geometry")[number]["type"] == INSTANCE
        name = INSTANCE if is_instance else "solids" if DEPTHS[geometry.text("type")] > 1 else "surfaces"
        if own == level:
            kinds[name].append((number, geometry, own))
    best = max(("solids", "surfaces"), key=lambda name: (any("semantics" in c[1] for c in kinds[name]), bool(kinds[name])))
    return kinds[best] + kinds[INSTANCE]


def find_superseded(objects: dict[str, Part], taken: dict[str, list[Choice]], above: dict[str, list[str]]) -> set[str]:
    """Return the ids of city objects to leave out because one of their parts has a more detailed geometry.

    These objects are left out, because tracing an object and its part would count the same surfaces twice.
    """
    levels = {name: found[0][2] for name, found in taken.items() if found}
    return {
        parent
        for name, level in levels.items()
        if objects[name].text("type").endswith("Part")
        for parent in above[name]
        if levels.get(parent, level) < level
    }


def list_ancestors(objects: dict[str, Part], name: str) -> list[str]:
    """Return the ids of a city object's parents, grandparents and further ancestors, each once.

    Parents missing from the document are left out.

    Raises:
        ValueError: an object is its own ancestor, or has more than 100 ancestors.
    """
    found: dict[str, None] = {}
    left = [name]
    while left:
        for parent in objects[left.pop()].texts("parents"):
            if parent == name:
                raise ValueError(f"the city object {quote(name)} is its own ancestor; correct the lists of parents")
            if parent in objects and parent not in found:
                found[parent] = None
                left.append(parent)
        if len(found) > _MOST_ANCESTORS:
            raise ValueError(f"the city object {quote(name)} has more than {_MOST_ANCESTORS} ancestors")
    return list(found)
