"""Writing of results into a CityJSON file, as attributes of surfaces and city objects."""

from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from copy import deepcopy
from math import isfinite
from typing import Any

import numpy as np

from warpsample.city.cityjson.boundaries import DEPTHS, nest_values
from warpsample.city.cityjson.gathering import Geometry
from warpsample.city.cityjson.kinds import PLAIN, ROOF, WALL
from warpsample.city.cityjson.surfaces import CitySurfaces, SurfaceLinks
from warpsample.mesh.part_means import shared_variance

_SUFFIXES = {"_roof": (ROOF,), "_wall": (WALL,), "": PLAIN}
"""Types of surfaces, by suffix of the results of city objects. Surfaces of other types are not summarized on objects."""
_DIGITS = 7  # significant digits of a float32

PER_AREA = "_m2"
"""Suffix of the name of results per m2."""

MEMBERS = ("type", "parent", "children")
"""Members of a semantic surface in CityJSON; attributes cannot have these names."""

ERROR = "_error"
"""Suffix of the name of standard errors."""

Results = Mapping[str, np.ndarray]
"""Numbers of the surfaces by name of the attribute, NaN without a result. Errors have the suffix "_error"."""

Runs = Mapping[str, np.ndarray]
"""(R, N) means of R independent runs over the N surfaces, by name of the result, for errors that surfaces share."""


class Editor:
    """Editor of a CityJSON file that adds computed results to its surfaces and city objects."""

    geometries: Sequence[Geometry]
    surfaces: CitySurfaces
    rows: SurfaceLinks
    split: bool

    def __init__(
        self,
        geometries: Sequence[Geometry],
        surfaces: CitySurfaces,
        rows: SurfaceLinks,
        results: Results,
        runs: Runs,
        *,
        split: bool,
    ) -> None:
        """Store the results of all surfaces and their positions in the file, and add totals (integrals over the areas)."""
        self.geometries, self.surfaces, self.rows, self.split = geometries, surfaces, rows, split
        self.results: Results = dict(add_totals(results, surfaces.area))
        self.runs: Runs = dict(add_totals(runs, surfaces.area))
        self.numbers: dict[int, list[int]] = {}
        for number, geometry in enumerate(geometries):
            self.numbers.setdefault(geometry.document, []).append(number)
        self.starts: Any = np.searchsorted(rows.geometry, np.arange(len(geometries) + 1)).tolist()

    def edit(self, number: int, document: dict[str, Any]) -> None:
        """Write the results of the surfaces into one JSON document of the CityJSON file, in place."""
        below: dict[str, list[int]] = {}
        for at in self.numbers.get(number, ()):
            geometry, held = self.geometries[at], range(self.starts[at], self.starts[at + 1])
            for name in (geometry.object, *geometry.ancestors):
                below.setdefault(name, []).extend(held)
            if not geometry.is_instance:
                self._edit_geometry(document["CityObjects"][geometry.object]["geometry"][geometry.number], held)
        for name, held in below.items():
            found = dict(self._object_attributes(np.array(held, np.int64)))
            if found:
                thing = document["CityObjects"][name]
                thing["attributes"] = (thing.get("attributes") or {}) | found

    def _edit_geometry(self, geometry: dict[str, Any], held: range) -> None:
        numbers = self.rows.semantic[held.start : held.stop].tolist()
        if self.split:
            numbers = _split_semantics(geometry, numbers, self.surfaces.type[held.start : held.stop].tolist())
        for row, number in zip(held, numbers, strict=True):
            if number is not None and number >= 0:
                geometry["semantics"]["surfaces"][number].update(self._surface_attributes(row))

    def _surface_attributes(self, row: int) -> dict[str, float]:
        return dict(_format_finite({name: column[row] for name, column in self.results.items()}))

    def _object_attributes(self, held: np.ndarray) -> Iterator[tuple[str, float]]:
        """Yield the attributes of a city object: means and areas over the surfaces of the object and its descendants."""
        kinds = self.surfaces.type[held]
        for end, types in _SUFFIXES.items():
            chosen = np.isin(kinds, np.array(types, object))
            for name, column in self.results.items():
                has = held[chosen & np.isfinite(self.results[name.removesuffix(ERROR)][held])]
                areas = self.surfaces.area[has]
                if areas.sum() > 0.0:
                    weights = np.ones(len(areas)) if self._is_total(name) else areas / areas.sum()
                    terms = weights * column[has]
                    runs = self.runs.get(name.removesuffix(ERROR))
                    runs = None if runs is None else weights * runs[:, has]
                    mean = _combine_errors(terms, runs) if name.endswith(ERROR) else terms.sum()
                    yield from _format_finite({name + end: float(mean), f"ws_area{PER_AREA}{end}": float(areas.sum())})

    def _is_total(self, name: str) -> bool:
        return name.removesuffix(ERROR) + PER_AREA in self.results


def _combine_errors(errors: np.ndarray, runs: np.ndarray | None) -> float:
    """Return the error of a sum of n terms with the given errors, which are independent except for those of shared runs.

    Args:
        errors: (n,) errors of the terms, including those of the runs.
        runs: (R, n) the terms in each of R independent runs, whose errors all terms share; None for independent errors.
    """
    variance = np.square(errors).sum()
    if runs is not None:
        variance += shared_variance(runs.sum(axis=1), axis=0) - shared_variance(runs, axis=0).sum()
    return float(np.sqrt(max(variance, 0.0)))


def add_totals(results: Results, areas: np.ndarray) -> Iterator[tuple[str, np.ndarray]]:
    """Yield the name and the numbers of each result and, for a result per m2, also the total over each surface.

    The total is the result times the area of the surface, and its name lacks the suffix "_m2".
    """
    for name, column in results.items():
        yield name, column
        plain, end = (name.removesuffix(ERROR), ERROR) if name.endswith(ERROR) else (name, "")
        if plain.endswith(PER_AREA):
            yield plain.removesuffix(PER_AREA) + end, column * areas


def find_repeated_names(results: Results) -> list[str]:
    """Return names of attributes that the given results would write twice, as totals or as means over roofs and walls."""
    names = [f"ws_area{PER_AREA}", *(name for name, _ in add_totals(results, np.zeros(())))]
    counts = Counter(name + end for name in names for end in _SUFFIXES)
    return [name for name, count in counts.items() if count > 1]


def _format_finite(cells: Mapping[str, float]) -> Iterator[tuple[str, float]]:
    """Yield (name, value) of all finite results, rounded to 7 significant digits."""
    return ((name, float(f"{value:.{_DIGITS}g}")) for name, value in cells.items() if isfinite(value))


def _split_semantics(geometry: dict[str, Any], semantic: list[int], types: list[str]) -> list[int | None]:
    """Copy shared semantic objects of a geometry, in place, so that each face has one and can have separate results.

    Return the number of the semantic object of each face, None for faces without a type.
    """
    old = (geometry.get("semantics") or {}).get("surfaces", [])
    made: list[dict[str, Any]] = []
    renamed: dict[int, list[int]] = {}
    numbers: list[int | None] = []
    for was, kind in zip(semantic, types, strict=True):
        numbers.append(len(made) if kind else None)
        if kind:
            renamed.setdefault(was, []).append(len(made))
            made.append({"type": kind} if was < 0 else deepcopy(old[was]))
    for was in sorted(set(range(len(old))) - set(renamed)):  # semantic objects without a face, such as parents
        renamed[was] = [len(made)]
        made.append(old[was])
    for surface in made:
        if "parent" in surface:
            surface["parent"] = renamed[surface["parent"]][0]
        if "children" in surface:
            surface["children"] = [number for child in surface["children"] for number in renamed[child]]
    if made:
        values = nest_values(numbers, geometry["boundaries"], DEPTHS[geometry["type"]])
        geometry["semantics"] = (geometry.get("semantics") or {}) | {"surfaces": made, "values": values}
    return numbers
