"""Conversion of the nested lists of a CityJSON geometry: polygons, and the surface types of the polygons."""

from collections.abc import Sequence
from itertools import chain
from typing import Any

import numpy as np

from warpsample.host.arguments import quote
from warpsample.host.json_tree import Part
from warpsample.mesh.holes import Outlines

DEPTHS = {"MultiSurface": 1, "CompositeSurface": 1, "Solid": 2, "MultiSolid": 3, "CompositeSolid": 3}
"""Depth of nested lists above a face in the boundaries, by type of geometry."""


def read_outlines(geometry: Part, vertices: int) -> Outlines:
    """Read the polygons of a CityJSON geometry from the nested lists of `boundaries`, as one flat `Outlines`.

    Args:
        geometry: JSON of the geometry.
        vertices: number of vertices that the corners refer to.

    Raises:
        TypeError, ValueError: the boundaries are not nested as the type requires, or a corner is not a vertex number.
    """
    at = geometry.at("boundaries")
    faces = [face or [[]] for face in _read_faces(geometry)]
    rings = [_check_list(ring, at, "a ring, a list of vertices") for face in faces for ring in face]
    corners = list(chain.from_iterable(rings))
    others = [corner for corner in corners if type(corner) is not int] if set(map(type, corners)) - {int} else []
    if others:
        raise TypeError(
            f"{at}: got the corner {quote(others[0])}, want whole numbers, nested as deep as in a {geometry.text('type')}"
        )
    if corners and not 0 <= min(corners) <= max(corners) < vertices:
        wrong = min(corners) if min(corners) < 0 else max(corners)
        raise ValueError(f"{at}: got the vertex {quote(wrong)}, want one of the {vertices:,} vertices, counted from 0")
    sizes = np.array([len(ring) - (len(ring) > 1 and ring[0] == ring[-1]) for ring in rings], np.int64)
    held = np.array(corners, np.int64)
    if sizes.sum() < len(held):  # some rings repeat their first corner, against the specification
        held = np.array(
            [corner for ring, size in zip(rings, sizes.tolist(), strict=True) for corner in ring[:size]], np.int64
        )
    return Outlines(held, sizes, np.array([len(face) for face in faces], np.int64))


def read_semantics(geometry: Part, surfaces: int) -> np.ndarray:
    """Return, for each face of a geometry, the index of its semantic object (roof, wall, ...), (N,) int32; -1 without.

    Args:
        geometry: JSON of the geometry.
        surfaces: number of semantic objects.

    Raises:
        ValueError: the values do not have the shape of the boundaries, or are not numbers of semantic objects.
    """
    semantics = geometry.part("semantics")
    depth, at = DEPTHS[geometry.text("type")], semantics.at("values")
    numbers = _flatten_values(semantics.content.get("values"), geometry.values("boundaries"), depth, at)
    wrong = [n for n in numbers if n is not None and not (type(n) is int and 0 <= n < surfaces)]
    if wrong:
        raise ValueError(f"{at}: got {quote(wrong[0])}, want null or the number of one of the {surfaces} surfaces")
    return np.array([-1 if n is None else n for n in numbers], np.int32)


def nest_values(numbers: Sequence[int | None], boundaries: list[Any], depth: int) -> list[Any]:
    """Nest a flat list of one number per face in the same way as the boundaries of a CityJSON geometry.

    The result is the member `values` of a semantics object.
    """
    left = iter(numbers)

    def nest(part: list[Any], levels: int) -> list[Any]:
        return [next(left) if levels == 1 else nest(item, levels - 1) for item in part]

    return nest(boundaries, depth)


def _read_faces(geometry: Part) -> list[list[Any]]:
    at, found = geometry.at("boundaries"), geometry.values("boundaries")
    for _ in range(DEPTHS[geometry.text("type")] - 1):
        found = [item for part in found for item in _check_list(part, at, "a list of faces")]
    return [_check_list(face, at, "a face, a list of rings") for face in found]


def _check_list(value: Any, at: str, wants: str) -> list[Any]:
    if type(value) is not list:
        raise TypeError(f"{at}: got {quote(value)}, want {wants}")
    return value


def _flatten_values(values: Any, boundaries: Sequence[Any], depth: int, at: str) -> list[Any]:
    """Flatten the nested `values` of CityJSON semantics: return one number or None for each face.

    None at an outer level stands for None at all faces below.
    """
    if values is None:
        values = [None] * len(boundaries)
    if type(values) is not list or len(values) != len(boundaries):
        raise ValueError(f"{at}: got {quote(values)}, want null or a list of {len(boundaries)}, as in the boundaries")
    if depth == 1:
        return values
    parts = zip(values, boundaries, strict=True)
    return list(chain.from_iterable(_flatten_values(value, part, depth - 1, at) for value, part in parts))
