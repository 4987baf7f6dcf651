"""Loading of a CityJSON file: `load_city` reads the surfaces and builds the mesh and the table of surfaces."""

from contextlib import nullcontext
from os import PathLike
from pathlib import Path
from typing import Any

import numpy as np

from warpsample.city.cityjson.choosing import as_lod
from warpsample.city.cityjson.city import CITY_FILE, City
from warpsample.city.cityjson.context import append_context
from warpsample.city.cityjson.example import example_content
from warpsample.city.cityjson.gathering import Gathered, gather
from warpsample.city.cityjson.surfaces import tabulate_surfaces, warn_of_overlaps
from warpsample.host.arguments import check_file, check_flag, naming_file
from warpsample.host.locks import read_only
from warpsample.mesh.holes import Outlines
from warpsample.mesh.mesh import Mesh


def load_city(path: str | PathLike[str], *, lod: Any = None, split: bool = False, context: Any = None) -> City:
    """Load the surfaces of a CityJSON file (version 1.0, 1.1 or 2.0) or sequence (CityJSONSeq) as a mesh.

    Each object contributes the geometries of one level of detail. If an object has the same surfaces twice, those with
    semantics are taken, or else the solids. Templates are placed, surfaces with holes are triangulated, points and lines are
    left out.

    The mesh, its areas and all lengths are in metres. Feet are converted by the file's metadata.referenceSystem, and heights
    by their own unit (extra `city`). Without a reference system, coordinates are taken as metres.

    Args:
        path: path of the file, or "courtyard", an example, if no file has this name.
        lod: level of detail, as 2.2 or "2.2". Default: the highest of each object, without footprints (LoD 0) and without
            buildings whose parts have a higher one.
        split: whether each polygon is a separate surface with its own results.
        context: black surroundings without results. A mesh in the coordinates and units of the file, such as terrain; the
            result of `rasters.surface`, in any unit on the same map; or "ground", a level plane through the lowest point.
            Default: no surroundings, and no sky below the horizon.

    Returns:
        the mesh, the surface of each triangle, and the table of surfaces.

    Raises:
        TypeError: `path` is not a path.
        FileNotFoundError: the file does not exist.
        ValueError: the file is damaged, in degrees or has no surfaces of the level of detail; `lod` is invalid; or the
            raster of `context` is on another map or has tree crowns.
        MemoryError: the surfaces and placed templates need more memory than is free.

    Warns:
        UserWarning: some polygons cross themselves. Their triangles overlap and may face either way, so shadows and results
            of such surfaces are wrong; areas are by Newell's formula, and smaller than those of the triangles.
        UserWarning: the reference system is unknown, pyproj is missing, or a map in feet has no unit of heights.
        UserWarning: lengths on the map are wrong by 5 % or more, as in Web Mercator.

    Example:
        >>> city = ws.load_city("courtyard")
        >>> print(city.surfaces.type, city.surfaces.area)
        ['' 'RoofSurface' 'WallSurface'] [3816. 1368. 4176.]
    """
    made = example_content(path)
    path = check_file(path, "path", CITY_FILE) if made is None else Path(path)
    lod = None if lod is None else as_lod(lod, "lod")
    split = check_flag(split, "split")
    with naming_file("path", path, CITY_FILE) if made is None else nullcontext():
        content = path.read_bytes() if made is None else made
        found = gather(content, lod)
        if not found.lods:
            raise ValueError("the file has no city objects with surfaces")
        points, outlines = np.concatenate(found.vertices), found.all_outlines
        found.units.check_lengths(points, outlines)
    if not found.geometries:
        there = ", ".join(f"{level:g}" for level in sorted(found.lods))
        got = "none" if lod is None else f"{lod:g}"
        raise ValueError(f"lod: got {got}, want a level of detail with surfaces in {str(path)!r}: {there}")
    found.units.warn(path, points)
    return _build_city(found, points * found.units.metres, outlines, path, content, split=split, context=context)


def _build_city(
    found: Gathered, points: np.ndarray, outlines: Outlines, path: Path, content: bytes, *, split: bool, context: Any
) -> City:
    surfaces, rows = tabulate_surfaces(found, points, outlines, split)
    triangles, owner = outlines.triangles(points)
    if not len(triangles):
        raise ValueError(f"path: got {str(path)!r}, all of whose polygons have no area, want at least one with an area")
    vertices, faces = append_context(points, triangles, context, found.units)
    surface = np.full(len(faces), -1, np.int32)
    surface[: len(owner)] = rows.row[owner]
    mesh = Mesh(vertices, faces, surface, surfaces.names)
    covered = np.bincount(owner, mesh.face_areas[: len(owner)], len(rows.row))
    warn_of_overlaps(path, surfaces.object[rows.row], covered, outlines.areas(points))
    return City(mesh, read_only(surface), surfaces, split, found.geometries, rows, path, content)
