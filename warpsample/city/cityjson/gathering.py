"""Reading of the surfaces of all objects of a CityJSON file, in world coordinates."""

from dataclasses import dataclass, field
from functools import cached_property

import numpy as np

from warpsample.city.cityjson.boundaries import read_outlines, read_semantics
from warpsample.city.cityjson.choosing import (
    INSTANCE,
    Choice,
    choose_geometries,
    find_superseded,
    list_ancestors,
    list_surface_geometries,
)
from warpsample.city.cityjson.documents import read_each
from warpsample.city.cityjson.units import Units
from warpsample.host.arguments import quote
from warpsample.host.engine import check_memory
from warpsample.host.json_tree import Part
from warpsample.host.locks import multiply
from warpsample.mesh.holes import Outlines
from warpsample.mesh.indexed import LARGEST

_BYTES = 250  # memory per corner, for its triangles and the mesh computed from them


@dataclass(frozen=True)
class Geometry:
    """One CityJSON geometry to trace, with its city object and its position in the file.

    Attributes:
        document: number of the document in a sequence, without empty lines; 0 in other files.
        object: id of the city object.
        kind: type of the city object.
        ancestors: ids of the object's parents, grandparents and so on.
        number: number of the geometry in the object.
        lod: level of detail.
        types: types of the semantic objects.
        is_instance: whether the geometry is a template, which other objects use as well.
        faces: number of faces.
    """

    document: int
    object: str
    kind: str
    ancestors: list[str]
    number: int
    lod: float
    types: list[str]
    is_instance: bool
    faces: int


@dataclass
class Gathered:
    """Surfaces read from a CityJSON file so far: geometries, vertices and units.

    Attributes:
        units: units of the file.
        lods: all levels of detail in the file.
        geometries: geometries to trace.
        vertices: blocks (V, 3) of vertices, in world coordinates and in the file's units.
        outlines: outlines of each geometry, with corners counted among all vertices.
        semantics: (N,) semantic object of each face, or -1, for each geometry.
    """

    units: Units
    lods: set[float] = field(default_factory=set)
    geometries: list[Geometry] = field(default_factory=list)
    vertices: list[np.ndarray] = field(default_factory=list)
    outlines: list[Outlines] = field(default_factory=list)
    semantics: list[np.ndarray] = field(default_factory=list)
    _offset: int = 0
    _corners: int = 0
    _checked: int = 0

    @property
    def all_outlines(self) -> Outlines:
        """Polygons of all geometries, concatenated."""
        nothing = [Outlines(*[np.empty(0, np.int64)] * 3)]
        parts = ([getattr(each, name) for each in nothing + self.outlines] for name in ("corners", "sizes", "rings"))
        return Outlines(*map(np.concatenate, parts))

    def place(self, points: np.ndarray) -> int:
        """Append vertices to the vertices read so far, and return the index of the first appended vertex.

        Raises:
            ValueError: a vertex is too far from the origin to be traced.
        """
        if not (np.abs(points) <= LARGEST).all():
            raise ValueError(f"the file has coordinates beyond {LARGEST:g}")
        self.vertices.append(points)
        self._offset += len(points)
        return self._offset - len(points)

    def add(self, geometry: Geometry, outlines: Outlines, semantics: np.ndarray, first: int) -> None:
        """Append a geometry to the geometries read so far; `first` is the index of the geometry's first vertex.

        Raises:
            MemoryError: the triangles of all geometries would need more memory than is free.
        """
        self._corners += len(outlines.corners)
        if self._corners > self._checked:  # checks again when the number of corners has doubled
            self._checked = 2 * self._corners
            check_memory(_BYTES * self._checked, f"{self._corners:,} corners and more", "take a part of the city")
        self.geometries.append(geometry)
        self.outlines.append(Outlines(outlines.corners + first, outlines.sizes, outlines.rings))
        self.semantics.append(semantics)


@dataclass(frozen=True)
class Head:
    """Members of the first JSON document of a CityJSON file that apply to all documents: templates and transform."""

    tree: Part

    @cached_property
    def templates(self) -> list[Part]:
        """Template geometries, which several city objects place as copies."""
        return self.tree.part("geometry-templates").parts("templates") if "geometry-templates" in self.tree else []

    @cached_property
    def _outlines(self) -> dict[str, Outlines]:
        return {}

    def outlines(self, template: Part) -> Outlines:
        """Return the polygons of a template geometry, from a cache if possible."""
        if template.path not in self._outlines:
            self._outlines[template.path] = read_outlines(template, len(self.template_points))
        return self._outlines[template.path]

    @cached_property
    def template_points(self) -> np.ndarray:
        """Vertices of the geometries that several city objects share as templates, (V, 3) float64."""
        found = self.tree.part("geometry-templates")
        return _read_rows(found.content.get("vertices-templates"), found.at("vertices-templates"))

    @cached_property
    def transform(self) -> np.ndarray:
        """Scale and translation from stored vertices to world coordinates, (2, 3) float64.

        Only version 1.0 may lack a transform.
        """
        if "transform" not in self.tree and self.tree.text("version").startswith("1.0"):
            return np.float64([(1, 1, 1), (0, 0, 0)])
        found = self.tree.part("transform")
        scale, translate = (_read_rows([found.content.get(key)], found.at(key))[0] for key in ("scale", "translate"))
        if not (scale > 0.0).all():
            raise ValueError(f"{found.at('scale')}: got {scale.tolist()}, want numbers above 0")
        return np.stack([scale, translate])

    def points(self, tree: Part) -> np.ndarray:
        """Read the vertices of a JSON document in world coordinates, (V, 3) float64; its own transform has priority."""
        scale, translate = (Head(tree) if "transform" in tree else self).transform
        return _read_rows(tree.values("vertices"), tree.at("vertices")) * scale + translate


def gather(content: bytes, lod: float | None) -> Gathered:
    """Read the surfaces of all city objects of a CityJSON file.

    Of each object, the geometry of the given level of detail is read, or by default that of its highest one.
    """
    found: list[tuple[Gathered, Head]] = []

    def read(number: int, tree: Part) -> None:
        if not number:
            found.append((Gathered(Units.of(tree)), Head(tree)))
        _add_document(*found[0], tree, number, lod)

    with np.errstate(all="ignore"):  # numbers that are not finite raise errors later
        read_each(content, read)
    return found[0][0] if found else Gathered(Units.of(Part({})))


def _add_document(found: Gathered, head: Head, tree: Part, number: int, lod: float | None) -> None:
    points = head.points(tree)
    first = found.place(points)
    objects = tree.members("CityObjects")
    above = {name: list_ancestors(objects, name) for name in objects}
    choices = {name: list_surface_geometries(thing, head.templates) for name, thing in objects.items()}
    found.lods |= {own for each in choices.values() for _, _, own in each}
    taken = {name: choose_geometries(choices[name], thing, lod) for name, thing in objects.items()}
    left_out = find_superseded(objects, taken, above) if lod is None else set()
    for name, thing in objects.items():
        if thing.content.get("attributes") is not None:
            thing.part("attributes")
        chosen = taken[name] if name not in left_out else ()
        geometries = thing.parts("geometry") if chosen else []
        for choice in chosen:
            _add_geometry(found, head, _Place(number, name, thing, geometries, above[name], points, first), choice)


@dataclass(frozen=True)
class _Place:
    """City object that is being read, with its geometries and the vertices of its JSON document.

    The vertices are numbered from `first` in the mesh.
    """

    document: int
    name: str
    thing: Part
    geometries: list[Part]
    above: list[str]
    points: np.ndarray
    first: int


def _add_geometry(found: Gathered, head: Head, place: _Place, choice: Choice) -> None:
    number, geometry, lod = choice
    placed, first = place.geometries[number], place.first
    is_instance = placed.text("type") == INSTANCE
    if is_instance:
        outlines, copies = _place_template(placed, head.outlines(geometry), head.template_points, place.points)
        first = found.place(copies)
    else:
        outlines = read_outlines(geometry, len(place.points))
    kind, faces = place.thing.text("type"), len(outlines.rings)
    types, semantics = _read_types(geometry, faces)
    shape = Geometry(place.document, place.name, kind, place.above, number, lod, types, is_instance, faces)
    found.add(shape, outlines, semantics, first)


def _read_types(geometry: Part, faces: int) -> tuple[list[str], np.ndarray]:
    if geometry.content.get("semantics") is None:
        return [], np.full(faces, -1, np.int32)
    surfaces = geometry.part("semantics").parts("surfaces")
    for surface in surfaces:
        surface.indices("children", surfaces)
        if "parent" in surface:
            surface.index("parent", surfaces)
    return [surface.text("type") for surface in surfaces], read_semantics(geometry, len(surfaces))


def _place_template(
    placed: Part, outlines: Outlines, template: np.ndarray, points: np.ndarray
) -> tuple[Outlines, np.ndarray]:
    """Copy a template geometry to its place in the city; return the polygons and vertices of the copy.

    The order of corners is reversed if the transformation matrix mirrors.
    """
    matrix = _read_matrix(placed)
    anchors = placed.indices("boundaries", points)
    if len(anchors) != 1:
        raise ValueError(f"{placed.at('boundaries')}: got {quote(anchors)}, want one vertex")
    used, corners = np.unique(outlines.corners, return_inverse=True)
    if np.linalg.det(matrix[:3, :3]) < 0.0:
        corners = _reverse_rings(corners, outlines.sizes)
    copies = multiply(template[used], matrix[:3, :3].T) + matrix[:3, 3] + points[anchors[0]]
    return Outlines(corners, outlines.sizes, outlines.rings), copies


def _read_matrix(placed: Part) -> np.ndarray:
    key = "transformationMatrix"
    matrix = placed.reals(key, np.eye(4).ravel().tolist()).reshape(4, 4)
    if not np.array_equal(matrix[3], (0.0, 0.0, 0.0, 1.0)):
        raise ValueError(f"{placed.at(key)}: got {matrix[3].tolist()} as the last row of the matrix, want [0, 0, 0, 1]")
    return matrix


def _reverse_rings(corners: np.ndarray, sizes: np.ndarray) -> np.ndarray:
    """Reverse the order of the corners in each ring (closed outline) of a face."""
    ends = np.cumsum(sizes)
    return corners[np.repeat(2 * ends - sizes, sizes) - 1 - np.arange(len(corners))]


def _read_rows(rows: object, at: str) -> np.ndarray:
    """Convert a list of [x, y, z] lists of a JSON file to an (n, 3) float64 array, and check that all numbers are finite."""
    wants = "lists of three numbers"
    if type(rows) is not list or any(type(row) is not list or len(row) != 3 for row in rows):
        raise ValueError(f"{at}: got {quote(rows)}, want {wants}")
    others = {type(number) for row in rows for number in row} - {int, float}
    if others:
        raise TypeError(f"{at}: got a number of type {others.pop().__name__}, want {wants}")
    found = np.array(rows, np.float64).reshape(-1, 3)
    if not np.isfinite(found).all():
        raise ValueError(f"{at}: got a number that is not finite, want {wants}")
    return found
