"""Table of a city's surfaces: object, type, level of detail and area."""

from dataclasses import dataclass, fields
from pathlib import Path
from typing import Any
from warnings import warn

import numpy as np
from numpy.typing import NDArray

from warpsample.city.cityjson.gathering import Gathered
from warpsample.city.cityjson.kinds import BY_NORMAL, classify_by_normal, is_built
from warpsample.host.arguments import quote
from warpsample.host.tables import frame_of
from warpsample.mesh.holes import Outlines

_FOLDED = 0.1  # share of the triangles' area; a larger excess over the polygon's area is not due to slight unevenness
_TINY = 1e-6  # m2, tolerance for rounded coordinates


@dataclass(frozen=True, eq=False)
class CitySurfaces:
    """Table of the N surfaces of a city: object, type, level of detail and area of each.

    A surface is the set of faces of a geometry with the same semantic object, or a single face in a split city.

    Attributes:
        object: (N,) ids of the city objects.
        type: (N,) types such as "RoofSurface", from the semantics. Without semantics, faces of built objects get a type from
            their normal, with walls within 30 degrees of upright; faces of other objects have "".
        lod: (N,) float64, levels of detail.
        faces: (N,) int32, numbers of polygons.
        area: (N,) float64, areas in m2 by Newell's formula, without holes.
    """

    object: NDArray[np.object_]
    type: NDArray[np.object_]
    lod: NDArray[np.float64]
    faces: NDArray[np.int32]
    area: NDArray[np.float64]

    def __len__(self) -> int:
        """Return the number of surfaces in the table."""
        return len(self.area)

    @property
    def names(self) -> list[str]:
        """Object and type of each surface, for example "house/RoofSurface"; the mesh's parts have the same names."""
        return [f"{name}/{kind}" if kind else name for name, kind in zip(self.object, self.type, strict=True)]

    @property
    def columns(self) -> dict[str, np.ndarray]:
        """Columns of the table as arrays, keyed by name."""
        return {item.name: getattr(self, item.name) for item in fields(self)}

    def to_frame(self) -> Any:
        """Return the table as a pandas.DataFrame, or as a dict of arrays if pandas is not installed.

        Returns:
            one row for each surface.

        Example:
            >>> print(list(ws.load_city("courtyard").surfaces.to_frame()))
            ['object', 'type', 'lod', 'faces', 'area']
        """
        return frame_of(self.columns)


@dataclass(frozen=True, eq=False)
class SurfaceLinks:
    """Links from the rows of the table of surfaces to the CityJSON file: geometry, semantic object and polygons.

    Attributes:
        geometry: (N,) number of each surface's geometry.
        semantic: (N,) number of the semantic object in the geometry, or -1.
        row: (P,) row of the surface of each polygon.
    """

    geometry: np.ndarray
    semantic: np.ndarray
    row: np.ndarray


def tabulate_surfaces(
    found: Gathered, points: np.ndarray, outlines: Outlines, split: bool
) -> tuple[CitySurfaces, SurfaceLinks]:
    """Build the table of a city's surfaces, and return (table, link of each row to the CityJSON file).

    With `split`, each polygon is a surface.
    """
    geometry = np.repeat(np.arange(len(found.geometries)), [len(each.rings) for each in found.outlines])
    semantic = np.concatenate(found.semantics)
    types, kind = _classify_polygons(found, geometry, semantic, classify_by_normal(outlines.crosses(points)[outlines.outer]))
    row, first = np.arange(len(kind)), np.arange(len(kind))
    if not split:
        _, first, row = np.unique(np.stack([geometry, semantic, kind]), axis=1, return_index=True, return_inverse=True)
        row = row.ravel()
    areas = np.bincount(row, outlines.areas(points), len(first))
    held = [found.geometries[number] for number in geometry[first].tolist()]
    table = CitySurfaces(
        object=np.array([one.object for one in held], object),
        type=np.array([types[number] for number in kind[first].tolist()], object),
        lod=np.array([one.lod for one in held]),
        faces=np.bincount(row, minlength=len(first)).astype(np.int32),
        area=areas,
    )
    return table, SurfaceLinks(geometry[first], semantic[first], row)


def warn_of_overlaps(path: Path, objects: np.ndarray, covered: np.ndarray, areas: np.ndarray) -> None:
    """Warn of polygons whose triangles overlap: polygons that cross themselves or are far from flat.

    Such triangles cover more than the polygon's area. Slight unevenness, such as 18 mm, adds about a thousandth.

    Args:
        path: path of the file.
        objects: (P,) ids of the polygons' objects.
        covered: (P,) sums of the areas of each polygon's triangles, in m2.
        areas: (P,) areas by Newell's formula, in m2.
    """
    bad = np.flatnonzero(covered - areas > _FOLDED * covered + _TINY)
    if len(bad):
        warn(
            f"path: got {str(path)!r} with {len(bad):,} of {len(areas):,} polygons that cross themselves or are far from "
            f"flat, the first of object {quote(objects[bad[0]])}; the triangles of these polygons overlap",
            stacklevel=4,
        )


def _classify_polygons(
    found: Gathered, geometry: np.ndarray, semantic: np.ndarray, facing: np.ndarray
) -> tuple[list[str], np.ndarray]:
    """Return the surface type of each polygon: (names of all types, (P,) index of the polygon's type)."""
    names = {name: number for number, name in enumerate((*BY_NORMAL, ""))}
    starts = np.cumsum([0, *(len(one.types) for one in found.geometries)])
    of_semantics = [names.setdefault(name, len(names)) for one in found.geometries for name in one.types]
    built = np.array([is_built(one.kind) for one in found.geometries])
    kind = np.where(built[geometry], facing, names[""])
    has = semantic >= 0
    kind[has] = np.array(of_semantics, np.int64)[starts[geometry[has]] + semantic[has]]
    return list(names), kind
