"""The surfaces of a CityJSON file as a mesh with a table; means over the surfaces, and writing of results into a copy."""

from collections.abc import Mapping
from dataclasses import dataclass, replace
from os import PathLike
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from warpsample.city.cityjson.documents import rewrite_content
from warpsample.city.cityjson.gathering import Geometry
from warpsample.city.cityjson.kinds import GROUND
from warpsample.city.cityjson.placing import spread_points
from warpsample.city.cityjson.surfaces import CitySurfaces, SurfaceLinks
from warpsample.city.cityjson.writing import ERROR, MEMBERS, PER_AREA, Editor, Results, Runs, find_repeated_names
from warpsample.estimate.intervals import errors_for_means
from warpsample.estimate.result import PointResult, has_value
from warpsample.host.arguments import check_seed, quote
from warpsample.host.arrays import as_real
from warpsample.host.files import check_output, write_bytes
from warpsample.host.neighbours import describe_type
from warpsample.host.summary import Summary
from warpsample.mesh.mesh import Mesh
from warpsample.mesh.part_means import PartMeans, part_means
from warpsample.mesh.surface import SurfacePoints

CITY_FILE = "a CityJSON file"
"""Name of the input in messages."""


@dataclass(frozen=True, eq=False, repr=False)
class City(Summary):
    """City: the surfaces of a CityJSON file as a triangle mesh, with a table of the surfaces.

    Attributes:
        mesh: mesh in metres. Coordinates of the file are converted by its reference system.
        surface: (F,) int32, row in `surfaces` of each triangle's surface; -1 for triangles of a context.
        surfaces: table of the N surfaces.
        split: whether each polygon is a separate surface.
        geometries: geometries of the file that are in the mesh.
        rows: positions of the surfaces in the file.
        path: path of the file.
        content: bytes of the file.
    """

    mesh: Mesh
    surface: NDArray[np.int32]
    surfaces: CitySurfaces
    split: bool
    geometries: list[Geometry]
    rows: SurfaceLinks
    path: Path
    content: bytes

    @property
    def receiving(self) -> np.ndarray:
        """Areas of the triangles that get results, (F,) float64 in m2; 0 for GroundSurfaces and for the context."""
        kind = np.append(self.surfaces.type, GROUND)[self.surface]  # GROUND is appended for -1, the context
        return np.where(kind == GROUND, 0.0, self.mesh.face_areas)

    def points(self, count: int | None = None, *, seed: int = 0) -> SurfacePoints:
        """Sample random points on each triangle of the city, for means over its surfaces; a GroundSurface gets no points.

        Args:
            count: approximate number of points, shared among triangles by area, with at least two on each. Default: four
                times the number of triangles, or about 2,048 to 4,096 for fewer than 683 triangles.
            seed: seed of the random numbers.

        Returns:
            points in the order of the triangles, uniform on each triangle.

        Raises:
            TypeError, ValueError: `count` or `seed` is invalid.
            MemoryError: the points need more memory than is free.

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
        """Compute the area-weighted mean over each surface from values at points; return means and standard errors.

        Points have independent random numbers, so their errors are independent. With several points on a triangle, its error
        comes from the spread of the values, which includes the noise of rays and of point positions. With one point, as
        without `points`, only the noise of rays is included. Errors of the weather, the sky model and the mesh are not
        included; they are common to all surfaces.

        A few points may all miss the same shadow. So the variance of each surface is combined with that of other surfaces
        of its type and of a similar number of points, unless its own is larger. The errors of simple surfaces among varied
        ones are larger than they need to be.

        All points share the light that faces reflect. For a result with a `reflected` part, the differences between its
        eight runs add the shared error. The error is then up to 1.4 times too large.

        Pass the result of a call, such as `ws.sky_view_factor`, as `values`. Where all rays agree, the error then accounts
        for geometry that no ray has hit. An array of values does not contain the number of rays. The error of its mean is
        therefore 0 where all values are equal and their errors are 0, even if all rays missed a small opening.

        Args:
            values: a result with P values, or (P,) values at the points; (F,) values at the centres of triangles if `points`
                is None.
            error: standard errors of an array of values, of the same shape. Default: those of the result, or 0.
            points: the points of `values`, as from `City.points`, with their faces.

        Returns:
            values, standard errors and areas in m2, (N,) float64 each, in the order of `surfaces`. Values and errors are NaN
            for a GroundSurface and for a surface without points.

        Raises:
            TypeError, ValueError: an array has another shape, or no point has a face of the city's surfaces.

        Example:
            >>> city = ws.load_city("courtyard")
            >>> points = city.points()
            >>> sky = ws.sky_view_factor(city.mesh, points, 64)
            >>> values, errors, areas = city.surface_means(sky, points=points)
            >>> print(values.round(1), errors.max() < 0.01)
            [0.7 0.9 0.4] True
        """
        means = self._means(values, error, self._faces_of(points), "values")
        return means.value, means.standard_error, self.surfaces.area.copy()

    def _means(self, values: Any, error: Any, face: np.ndarray, argument: str) -> PartMeans:
        """Compute the means over surfaces of values on the given triangles. Messages name the values `argument`."""
        least = runs = None
        if isinstance(values, PointResult):
            if error is not None:
                raise TypeError("error: got errors for a result as values, want None, because the result has errors")
            found: Any = values
            error, least, runs = found.standard_error, errors_for_means(found), getattr(found, "reflected_runs", None)
            good = has_value(found.status).reshape(-1, *[1] * (found.value.ndim - 1))
            values = np.where(good, found.value, np.nan)
        value = as_real(values, argument)
        error = np.zeros(value.shape) if error is None else as_real(error, "error")
        for name, array in ((argument, value), ("error", error)):
            if array.shape != (len(face),):
                raise ValueError(f"{name}: got shape {array.shape}, want ({len(face)},), one for each point")
        more: Any = {"count": len(self.surfaces), "least": least, "runs": runs, "kind": self.surfaces.type}
        means = part_means(self.surface, self.mesh.face_areas, face, value, error, **more)
        earth = self.surfaces.type == GROUND
        values, errors = (np.where(earth, np.nan, array) for array in (means.value, means.standard_error))
        return replace(means, value=values, standard_error=errors)

    def _faces_of(self, points: SurfacePoints | None) -> np.ndarray:
        """Return the triangle of each point, after checking that points are on surfaces of the city; all without points."""
        if points is None:
            return np.arange(len(self.surface))
        if not isinstance(points, SurfacePoints):
            raise TypeError(f"points: got {describe_type(points)}, want SurfacePoints")
        wants = "points on the city's surfaces, with their faces, as from City.points"
        face = points.face
        if not (face >= 0).any():
            raise ValueError(f"points: got {len(face):,} points without faces, want {wants}")
        if face.max() >= len(self.surface):
            raise ValueError(f"points: got the face {face.max()} for {len(self.surface):,} triangles, want {wants}")
        if not (self.surface[face[face >= 0]] >= 0).any():
            raise ValueError(f"points: got {len(face):,} points on the context alone, want {wants}")
        return face

    def write(self, path: str | PathLike[str], results: Mapping[str, Any], *, points: SurfacePoints | None = None) -> None:
        """Write a copy of the file with results as attributes of semantic surfaces and of city objects.

        The rest of the JSON keeps its order, texts, integers and spelling of numbers, but escapes in texts may be spelled in
        another way; a sequence stays a sequence. Results of surfaces without a semantic object, and of templates, are
        written only into their city object.

        A city object gets area-weighted means over its own surfaces and those of its children:

        - of roofs, under the name with "_roof", with the area in m2 as "ws_area_m2_roof";
        - of walls, likewise with "_wall";
        - of surfaces without a type and of types of roads and water ("TrafficArea", "AuxiliaryTrafficArea", "WaterSurface"),
          under the plain name. Surfaces of other types, such as "OuterCeilingSurface", are not in these means.

        A name that ends in "_m2" is a value per m2. Its integral over the area is written as well, under the name without
        "_m2".

        Args:
            path: path of the new file, with the suffix of the input, .json or .jsonl. An interrupted write leaves no partial
                file.
            results: by name of the attribute, a result of a call with values at `points`, or (N,) numbers in the order of
                `surfaces`, NaN without a result. Of a result, the means of `surface_means` are written, and their standard
                errors under the name with "_error" appended. Standard errors of an array are another array of such a name.
                For city objects, errors of arrays are combined as if independent. So pass a result if faces reflect light,
                because surfaces share a part of its error.
            points: the points of the results, as for `surface_means`.

        Raises:
            TypeError, ValueError: the path cannot be written, or results have another shape, no name, or the name of a
                member of semantic surfaces ("type", "parent" or "children"), or two of them give attributes of one name.
            OSError: the file cannot be written.

        Example:
            >>> import pathlib, tempfile
            >>> city, path = ws.load_city("courtyard"), pathlib.Path(tempfile.mkdtemp(), "out.city.json")
            >>> points = city.points()
            >>> city.write(path, {"ws_sky": ws.sky_view_factor(city.mesh, points, 64)}, points=points)
            >>> print(b'"ws_sky":0.9' in path.read_bytes(), b'"ws_sky_error_roof":' in path.read_bytes())
            True True
        """
        _check_names(results)
        face = self._faces_of(points)
        columns, runs = {}, {}
        for name, item in results.items():
            if not isinstance(item, PointResult):
                columns[name] = item
                continue
            if name + ERROR in results:
                raise ValueError(f"results: got {name + ERROR!r} for a result, want {name!r} alone; a result has errors")
            means = self._means(item, None, face, f"results[{name!r}]")
            columns |= {name: means.value, name + ERROR: means.standard_error}
            if means.runs is not None:
                runs[name] = means.runs[0]
        write_columns(self, path, columns, runs)


def write_columns(city: City, path: str | PathLike[str], columns: Results, runs: Runs) -> None:
    """Write a copy of a city's file with numbers of the surfaces, as `City.write` does.

    Args:
        city: city.
        path: path of the new file.
        columns: as the `results` of `City.write`.
        runs: means of independent runs over surfaces, by name of the result, for errors that surfaces share.

    Raises:
        TypeError, ValueError, OSError: as for `City.write`.
    """
    target = _check_target(path, city.path)
    columns = _check_columns(columns, len(city.surfaces))
    editor = Editor(city.geometries, city.surfaces, city.rows, columns, runs, split=city.split)
    write_bytes(target, rewrite_content(city.content, editor.edit))


def _check_target(path: Any, source: Path) -> Path:
    if not isinstance(path, str | PathLike):
        raise TypeError(f"path: got {quote(path)}, want the path of {CITY_FILE}")
    suffix = source.suffix or ".json"  # of the example
    if Path(path).suffix != suffix:
        raise ValueError(f"path: got {str(path)!r}, want a file that ends in {suffix}, as the input does")
    check_output(Path(path), "path", source)
    return Path(path)


def _check_names(results: Any) -> None:
    if not isinstance(results, Mapping) or not all(isinstance(name, str) and name for name in results):
        raise TypeError(f"results: got {quote(results)}, want a dict of attribute names and arrays of numbers")
    for name in results:
        if name.removesuffix(PER_AREA) in MEMBERS:
            raise ValueError(
                f"results: got {name!r}, want names other than {', '.join(MEMBERS)}, the members of semantic surfaces"
            )


def _check_columns(results: Mapping[str, Any], count: int) -> dict[str, np.ndarray]:
    columns = {name: as_real(column, f"results[{name!r}]") for name, column in results.items()}
    for name, column in columns.items():
        if column.shape != (count,):
            raise ValueError(f"results[{name!r}]: got shape {column.shape}, want ({count},), one for each surface")
        if name.removesuffix(ERROR) not in columns:
            raise ValueError(
                f"results: got {name!r} without {name.removesuffix(ERROR)!r}, want both the errors and the values"
            )
        if name.endswith(ERROR + PER_AREA):
            wants = name.removesuffix(ERROR + PER_AREA) + PER_AREA + ERROR
            raise ValueError(f"results: got {name!r}, want {wants!r} as the name of errors")
    twice = find_repeated_names(columns)
    if twice:
        raise ValueError(f"results: got two results for the attribute {twice[0]!r}, want names that differ as totals, too")
    return columns
