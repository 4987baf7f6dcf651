"""`load_city`: a CityJSON file as a mesh whose faces know their surface."""

from collections.abc import Mapping
from contextlib import nullcontext
from dataclasses import dataclass
from os import PathLike
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from warpsample.city.cityjson.choosing import as_lod
from warpsample.city.cityjson.context import append_context
from warpsample.city.cityjson.documents import rewrite_content
from warpsample.city.cityjson.example import example_content
from warpsample.city.cityjson.gathering import Gathered, Geometry, gather
from warpsample.city.cityjson.kinds import GROUND
from warpsample.city.cityjson.placing import spread_points
from warpsample.city.cityjson.surfaces import CitySurfaces, Rows, tabulate_surfaces, warn_of_overlaps
from warpsample.city.cityjson.writing import ERROR, Editor
from warpsample.host.arguments import check_file, check_flag, check_seed, naming_file, told
from warpsample.host.arrays import as_real
from warpsample.host.files import check_output, write_bytes
from warpsample.host.locks import read_only
from warpsample.host.neighbours import kind_told
from warpsample.host.summary import Summary
from warpsample.mesh.holes import Outlines
from warpsample.mesh.mesh import Mesh
from warpsample.mesh.part_means import part_means
from warpsample.mesh.surface import SurfacePoints

_FILE = "a CityJSON file"


@dataclass(frozen=True, eq=False, repr=False)
class City(Summary):
    """The surfaces of a CityJSON file as a mesh.

    Attributes:
        mesh: in metres: the coordinates of the file, times the lengths of their units by its reference system.
        surface: (F,) int32, the row of each triangle's surface in `surfaces`; -1 for those of a context.
        surfaces: the table of the surfaces.
        split: whether each polygon is a surface of its own.
        geometries: what of the file is in the mesh.
        rows: where the surfaces stand in the file.
        path: of the file.
        content: of the file.
    """

    mesh: Mesh
    surface: NDArray[np.int32]
    surfaces: CitySurfaces
    split: bool
    geometries: list[Geometry]
    rows: Rows
    path: Path
    content: bytes

    @property
    def receiving(self) -> np.ndarray:
        """(F,) float64, m2: the areas of the triangles that have numbers; 0 of GroundSurfaces and a context."""
        kind = np.append(self.surfaces.type, GROUND)[self.surface]  # the last is for -1
        return np.where(kind == GROUND, 0.0, self.mesh.face_areas)

    def points(self, count: int | None = None, *, seed: int = 0) -> SurfacePoints:
        """Random points on each triangle, for means over surfaces; a GroundSurface, which lies on earth, has none.

        Args:
            count: about so many, shared out by area, but at least two on each triangle; by default four for each.
            seed: of the random numbers.

        Returns:
            the points in the order of the triangles, uniform on each.

        Raises:
            TypeError, ValueError: no such number.
            MemoryError: more than is free.

        Example:
            >>> city = ws.load_city("courtyard")
            >>> points = city.points()
            >>> print(len(points), np.bincount(points.face).min())
            8320 4
        """
        return spread_points(self.mesh, self.receiving, count, check_seed(seed))

    def surface_means(
        self, values: Any, error: Any = None, *, points: SurfacePoints | None = None
    ) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Means over the surfaces, weighted by area, of numbers at points of the mesh.

        Points have random numbers of their own, so their errors are independent: those of a triangle have the variance of
        its values over their number, which holds the rays' noise and where the points are; with one point on each, as
        without `points`, only the rays' noise is known. What all have in common, the weather, the sky's model and the mesh,
        is in no error, and makes those of two surfaces alike.

        Args:
            values: (P,) at the points; (F,) at the centres of the triangles if no points are given.
            error: of the same shape, the standard errors; by default 0. They count where a triangle has one point.
            points: that `values` are of, as `City.points` gives them, with their faces.

        Returns:
            values, standard errors and areas in m2, (N,) float64 each, a row for each of `surfaces`; values and errors are
            NaN of a GroundSurface, and where no point is.

        Raises:
            TypeError, ValueError: other shapes, or points without faces.

        Example:
            >>> city = ws.load_city("courtyard")
            >>> points = city.points()
            >>> sky = ws.sky_view_factor(city.mesh, points, 64)
            >>> values, errors, areas = city.surface_means(sky.value, sky.standard_error, points=points)
            >>> print(values.round(1), errors.max() < 0.01)
            [0.7 0.9 0.4] True
        """
        if not isinstance(points, SurfacePoints | None):
            raise TypeError(f"points: got {kind_told(points)}, want SurfacePoints")
        face = np.arange(len(self.surface)) if points is None else points.face
        value = as_real(values, "values")
        error = np.zeros(value.shape) if error is None else as_real(error, "error")
        for name, array in (("values", value), ("error", error)):
            if array.shape != (len(face),):
                raise ValueError(f"{name}: got shape {array.shape}, want ({len(face)},), one for each point")
        found = part_means(self.surface, self.mesh.face_areas, face, value, error, count=len(self.surfaces))
        earth = self.surfaces.type == GROUND
        values, errors = (np.where(earth, np.nan, array) for array in (found.value, found.standard_error))
        return values, errors, self.surfaces.area.copy()

    def write(self, path: str | PathLike[str], results: Mapping[str, Any]) -> None:
        """Writes the file with results as attributes: of the semantic objects of surfaces, and of the objects above them.

        All else is the same JSON: integers, order, spelling of numbers; a sequence stays one, line by line. Results of
        surfaces without a semantic object, and of templates, are in those of their object alone.

        Args:
            path: of the new file, complete or not at all; it ends as the one that was read, in .json or .jsonl.
            results: (N,) numbers, a row for each of `surfaces`, NaN where there is none, by the name of the attribute. A
                name and the same with "_error" are values and their errors. An object with roofs, its own or those of its
                children, gets their mean under the name and "_roof", and "ws_area_m2_roof", their m2; likewise "_wall"; and
                without an ending those of what has no type of surface, such as roads. Names that end in "_m2" are per m2:
                the sums over the area are written too, under the name without it.

        Raises:
            TypeError, ValueError: a path that cannot be written, or results of another shape or without a name.
            OSError: the file cannot be written.

        Example:
            >>> import pathlib, tempfile
            >>> city, path = ws.load_city("courtyard"), pathlib.Path(tempfile.mkdtemp(), "out.city.json")
            >>> city.write(path, {"ws_height": np.arange(len(city.surfaces))})
            >>> print(b'"ws_height":0.0' in path.read_bytes(), b'"ws_height_roof":' in path.read_bytes())
            True True
        """
        target = _check_target(path, self.path)
        columns = _check_results(results, len(self.surfaces))
        editor = Editor(self.geometries, self.surfaces, self.rows, columns, split=self.split)
        write_bytes(target, rewrite_content(self.content, editor.edit))


def load_city(path: str | PathLike[str], *, lod: Any = None, split: bool = False, context: Any = None) -> City:
    """The surfaces of a CityJSON file, version 1.0, 1.1 or 2.0, or of a sequence (CityJSONSeq, one object on each line).

    Of each object the geometries of one level of detail are taken: those with semantics, or else the solids, if it has the
    same surfaces twice. Templates are placed, surfaces with holes cut into triangles; points and lines are left out.
    "courtyard", where no file is called that, is an example.

    The mesh, its areas and all lengths are in metres: feet become metres by the file's metadata.referenceSystem, heights by
    a unit of their own (extra `city`). Without a reference system coordinates are taken as metres.

    Args:
        path: of the file.
        lod: the level of detail, as 2.2 or "2.2"; by default the highest that each object has, without footprints (LoD 0)
            and without buildings whose parts have a higher one.
        split: whether each polygon is a surface of its own, with results of its own.
        context: what stands around, and gets no results: a mesh in the coordinates and units of the file, such as the
            terrain; what `rasters.surface` returns, in a unit of its own on the same map; or "ground", a level plane through
            the lowest point, black as all of a mesh; by default nothing, as below the horizon no sky is.

    Returns:
        the mesh, the surface of each of its triangles, and the table of the surfaces.

    Raises:
        TypeError: not a path, or no level of detail.
        FileNotFoundError: no such file.
        ValueError: a file that is damaged, in degrees, or has no such surfaces; names the path. A raster as context of
            another map.
        MemoryError: templates are placed so often that the free memory does not hold them.

    Warns:
        UserWarning: some polygons cross themselves; says how many. Their triangles overlap and may face either way, so that
            what they hide, and the numbers of their surfaces, are not those of a polygon; areas are Newell's, and less.
            The reference system is not known, as without pyproj, or names no unit of heights beside a map in feet; or
            lengths on its map are wrong by a twentieth and more, as by Web Mercator.

    Example:
        >>> city = ws.load_city("courtyard")
        >>> print(city.surfaces.type, city.surfaces.area)
        ['' 'RoofSurface' 'WallSurface'] [3816. 1368. 4176.]
    """
    made = example_content(path)
    path = check_file(path, "path", _FILE) if made is None else Path(path)
    lod = None if lod is None else as_lod(lod, "lod")
    split = check_flag(split, "split")
    with naming_file("path", path, _FILE) if made is None else nullcontext():
        content = path.read_bytes() if made is None else made
        found = gather(content, lod)
        if not found.lods:
            raise ValueError("it has no surfaces")
        points = np.concatenate(found.vertices)
        found.units.check_lengths(points)
    if not found.geometries:
        there = ", ".join(f"{level:g}" for level in sorted(found.lods))
        got = "none" if lod is None else f"{lod:g}"
        raise ValueError(f"lod: got {got}, want one of those that {str(path)!r} has surfaces of: {there}")
    found.units.warn(path, points)
    return _build_city(found, points * found.units.metres, path, content, split=split, context=context)


def _check_target(path: Any, source: Path) -> Path:
    if not isinstance(path, str | PathLike):
        raise TypeError(f"path: got {told(path)}, want the path of {_FILE}")
    suffix = source.suffix or ".json"  # of the example
    if Path(path).suffix != suffix:
        raise ValueError(f"path: got {str(path)!r}, want a file that ends in {suffix}, as what was read")
    check_output(Path(path), "path", source)
    return Path(path)


def _check_results(results: Any, count: int) -> dict[str, np.ndarray]:
    if not isinstance(results, Mapping) or not all(isinstance(name, str) and name for name in results):
        raise TypeError(f"results: got {told(results)}, want numbers by the names of attributes")
    columns = {name: as_real(column, f"results[{name!r}]") for name, column in results.items()}
    for name, column in columns.items():
        if column.shape != (count,):
            raise ValueError(f"results[{name!r}]: got shape {column.shape}, want ({count},), one for each surface")
        if name.removesuffix(ERROR) not in columns:
            raise ValueError(f"results: got {name!r} without {name.removesuffix(ERROR)!r}, want values with their errors")
    return columns


def _build_city(found: Gathered, points: np.ndarray, path: Path, content: bytes, *, split: bool, context: Any) -> City:
    parts = ([getattr(each, name) for each in found.outlines] for name in ("corners", "sizes", "rings"))
    outlines = Outlines(*map(np.concatenate, parts))
    surfaces, rows = tabulate_surfaces(found, points, outlines, split)
    triangles, owner = outlines.triangles(points)
    vertices, faces = append_context(points, triangles, context, found.units)
    surface = np.full(len(faces), -1, np.int32)
    surface[: len(owner)] = rows.row[owner]
    mesh = Mesh(vertices, faces, surface, surfaces.names)
    covered = np.bincount(owner, mesh.face_areas[: len(owner)], len(rows.row))
    warn_of_overlaps(path, surfaces.object[rows.row], covered, outlines.areas(points))
    return City(mesh, read_only(surface), surfaces, split, found.geometries, rows, path, content)
