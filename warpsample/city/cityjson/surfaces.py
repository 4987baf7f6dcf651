"""The table of a city's surfaces: what each is of, and its area."""

from dataclasses import dataclass, fields
from pathlib import Path
from typing import Any
from warnings import warn

import numpy as np
from numpy.typing import NDArray

from warpsample.city.cityjson.gathering import Gathered
from warpsample.city.cityjson.kinds import BY_NORMAL, classify_by_normal, is_built
from warpsample.host.arguments import told
from warpsample.host.tables import frame_of
from warpsample.mesh.holes import Outlines

_FOLDED = 0.1  # of a polygon's triangles: more beyond its area than this is no lack of flatness
_TINY = 1e-6  # m2, and what coordinates are rounded by


@dataclass(frozen=True, eq=False)
class CitySurfaces:
    """The N surfaces of a city, a row each: the faces of a geometry that have one semantic object, or one by one if split.

    Attributes:
        object: (N,) ids of the objects.
        type: (N,) as RoofSurface, by the semantics; without these, of what is built, by the normal (upright within 30
            degrees are walls); else "".
        lod: (N,) float64, the level of detail.
        faces: (N,) int32, how many polygons.
        area: (N,) float64, m2: by Newell's formula, less the holes.
    """

    object: NDArray[np.object_]
    type: NDArray[np.object_]
    lod: NDArray[np.float64]
    faces: NDArray[np.int32]
    area: NDArray[np.float64]

    def __len__(self) -> int:
        """How many surfaces."""
        return len(self.area)

    @property
    def names(self) -> list[str]:
        """The object and the type of each, as "house/RoofSurface"; what the parts of the mesh are called."""
        return [f"{name}/{kind}" if kind else name for name, kind in zip(self.object, self.type, strict=True)]

    @property
    def columns(self) -> dict[str, np.ndarray]:
        """The columns by name."""
        return {item.name: getattr(self, item.name) for item in fields(self)}

    def to_frame(self) -> Any:
        """The table as a pandas.DataFrame, or as arrays by name where pandas is not installed.

        Returns:
            a row for each surface.

        Example:
            >>> print(list(ws.load_city("courtyard").surfaces.to_frame()))
            ['object', 'type', 'lod', 'faces', 'area']
        """
        return frame_of(self.columns)


@dataclass(frozen=True, eq=False)
class Rows:
    """Where the surfaces stand in the file, and which of the polygons each has.

    Attributes:
        geometry: (N,) the number of the geometry.
        semantic: (N,) the number of the semantic object there, or -1.
        row: (P,) of each polygon, the surface that it belongs to.
    """

    geometry: np.ndarray
    semantic: np.ndarray
    row: np.ndarray


def tabulate_surfaces(found: Gathered, points: np.ndarray, outlines: Outlines, split: bool) -> tuple[CitySurfaces, Rows]:
    """The surfaces of what was gathered, in the order of the file; one for each polygon if they are to be split."""
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
    return table, Rows(geometry[first], semantic[first], row)


def warn_of_overlaps(path: Path, objects: np.ndarray, covered: np.ndarray, areas: np.ndarray) -> None:
    """Warns of polygons whose triangles cover more than their area: those that cross themselves, and bowls.

    What is not quite flat in files of cities, as by 18 mm, is a thousandth.

    Args:
        path: of the file.
        objects: (P,) whose polygons they are.
        covered: (P,) the areas of the triangles of each.
        areas: (P,) by Newell's formula.
    """
    bad = np.flatnonzero(covered - areas > _FOLDED * covered + _TINY)
    if len(bad):
        warn(
            f"path: got {str(path)!r} with {len(bad):,} of {len(areas):,} polygons that cross themselves or are far from "
            f"flat, the first of object {told(objects[bad[0]])}; their triangles overlap",
            stacklevel=4,
        )


def _classify_polygons(
    found: Gathered, geometry: np.ndarray, semantic: np.ndarray, facing: np.ndarray
) -> tuple[list[str], np.ndarray]:
    """The names of all types, and (P,) which of them each polygon has."""
    names = {name: number for number, name in enumerate((*BY_NORMAL, ""))}
    starts = np.cumsum([0, *(len(one.types) for one in found.geometries)])
    of_semantics = [names.setdefault(name, len(names)) for one in found.geometries for name in one.types]
    built = np.array([is_built(one.kind) for one in found.geometries])
    kind = np.where(built[geometry], facing, names[""])
    has = semantic >= 0
    kind[has] = np.array(of_semantics, np.int64)[starts[geometry[has]] + semantic[has]]
    return list(names), kind
