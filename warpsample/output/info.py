"""`warpsample info`: tables that describe a mesh, a CityJSON file or a raster of heights."""

from collections.abc import Iterator
from pathlib import Path

import numpy as np

from warpsample.city.cityjson.loading import load_city
from warpsample.host.extras import missing
from warpsample.host.locks import imported
from warpsample.mesh.files import load_mesh
from warpsample.mesh.files.gltf import describe_invisible
from warpsample.mesh.mesh import Mesh
from warpsample.output.bake_table import CITY, RASTER, kind_of
from warpsample.output.by_parts import list_parts

Row = tuple[str, str, str]
"""Name, value and remark."""

_MOST_PARTS = 20


def describe_source(path: Path) -> list[Row]:
    """Return the lines of `warpsample info` on a mesh, a CityJSON file or a raster, as pairs (property, value).

    Raises:
        TypeError, ValueError, FileNotFoundError: a file that cannot be read.
        ModuleNotFoundError: a package for rasters is not installed; the message names the extra.
    """
    kind = kind_of(path, path, None)
    if kind == RASTER:
        return list(_describe_raster(path))
    if kind == CITY:
        return list(_describe_city(path))
    mesh = load_mesh(path)
    rows = list(_describe_mesh(mesh))
    if path.suffix.lower() == ".stl":
        corners = 3 * len(mesh.faces) - len(mesh.vertices)
        rows.insert(1, ("merged corners", f"{corners:,}", "an .stl repeats them"))
    rows += [("left out", line, "") for line in describe_invisible(path)]
    return [*rows, *_describe_parts(mesh)]


def _describe_mesh(mesh: Mesh, unit: str = "square units") -> Iterator[Row]:
    """Yield the counts, the area, the extent and the defects of a mesh."""
    report = mesh.report
    yield "vertices", f"{report.vertices:,}", ""
    yield "faces", f"{report.faces:,}", "triangles"
    yield "area", f"{report.area:.6g}", unit
    for axis, low, high in zip("xyz", report.lower, report.upper, strict=True):
        digits = 6 + _count_shared_digits(low, high)
        yield f"{axis} from, to", f"{low:.{digits}g}, {high:.{digits}g}", ""
    yield "degenerate faces", f"{report.degenerate_faces:,}", "no area, no points on them"
    yield "duplicate faces", f"{report.duplicate_faces:,}", "same vertices as another face"
    yield "unused vertices", f"{report.unreferenced_vertices:,}", "in no face"
    yield "boundary edges", f"{report.boundary_edges:,}", "one face only"
    yield "non-manifold edges", f"{report.nonmanifold_edges:,}", "more than two faces"
    yield "inconsistent edges", f"{report.inconsistent_edges:,}", "faces with opposite orientation"


def _count_shared_digits(low: float, high: float) -> int:
    """Return how many more digits coordinates need than the extent between them, as map coordinates of a house do."""
    size, most = high - low, max(abs(low), abs(high))
    return int(np.clip(np.log10(most / size), 0, 9)) if size > 0.0 else 0


def _describe_parts(mesh: Mesh) -> Iterator[Row]:
    """Yield the named parts of a mesh, with the number of faces and the area of each."""
    if mesh.part is None:
        return
    parts = list_parts(mesh)
    yield "named parts", f"{len(mesh.parts):,}", "bake --by part gives a mean for each"
    rows = zip(parts["part"].tolist(), parts["faces"].tolist(), parts["area"].tolist(), strict=True)
    for name, faces, area in list(rows)[:_MOST_PARTS]:
        yield f"part {name}", f"{faces:,}", f"faces, {area:.6g} square units"
    if len(mesh.parts) > _MOST_PARTS:
        yield "further parts", f"{len(mesh.parts) - _MOST_PARTS:,}", "not listed"


def _describe_city(path: Path) -> Iterator[Row]:
    """Yield the surfaces of a CityJSON file by type, and the size of the mesh in metres."""
    city = load_city(path)
    columns = city.surfaces.columns
    kinds, area = columns["type"].astype(str), columns["area"]
    yield "surfaces", f"{len(kinds):,}", "at the highest level of detail of each object"
    for kind in np.unique(kinds):
        yield f"type {kind}", f"{np.count_nonzero(kinds == kind):,}", f"surfaces, {area[kinds == kind].sum():.6g} m2"
    yield from _describe_mesh(city.mesh, "m2")


def _describe_raster(path: Path) -> Iterator[Row]:
    """Yield the cells, the reference system and the heights of a raster."""
    try:
        reader = imported("warpsample.city.rasters.sources.reading").reader_of(path)
    except ModuleNotFoundError as error:
        raise missing(f"a raster needs {error.name}", error.name, "city") from error
    rows, columns = reader.shape
    outline = reader.outline
    corners = outline.places(np.array([0, columns, 0, columns]), np.array([0, 0, rows, rows]), np.zeros(4))
    yield "cells", f"{rows:,} x {columns:,}", "rows and columns"
    yield "cell size", "{:.6g} x {:.6g}".format(*outline.sides), "map units"
    for axis, along in zip("xy", corners.T, strict=False):
        yield f"{axis} from, to", f"{along.min():.10g}, {along.max():.10g}", "map units"
    yield "reference system", "none" if reader.crs is None else reader.crs.name, ""
    valid, low, high = 0, np.inf, -np.inf
    for first in range(0, rows, _ROWS):
        heights = reader.read(slice(first, first + _ROWS), slice(None))
        known = heights[np.isfinite(heights)]
        valid, low, high = valid + known.size, known.min(initial=low), known.max(initial=high)
    if valid:
        yield "heights from, to", f"{low:.6g}, {high:.6g}", "map units"
    yield "cells without data", f"{rows * columns - valid:,}", ""


_ROWS = 512  # rows of a raster that are read at a time
