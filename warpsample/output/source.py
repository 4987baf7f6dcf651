"""Source of a run of `warpsample bake`: its mesh or city, read from the file, and the points to compute at."""

from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from warpsample.city import rasters
from warpsample.city.cityjson.city import City, load_city
from warpsample.city.cityjson.context import GROUND_PLANE
from warpsample.city.cityjson.placing import spread_points
from warpsample.mesh.files import SUFFIXES, load_mesh
from warpsample.mesh.mesh import Mesh
from warpsample.mesh.surface import SurfacePoints, face_centers
from warpsample.output.bake_rules import is_by_parts
from warpsample.output.bake_table import CITY
from warpsample.output.baked import BakeRun
from warpsample.output.faces_option import with_optics
from warpsample.output.places import points_on


@dataclass(frozen=True)
class Source:
    """Mesh of a run, and the city of which it is the surface, or None."""

    mesh: Mesh
    city: City | None = None


def read_source(run: BakeRun) -> Source:
    """Read the mesh or the CityJSON of a run, with the transmittance and reflectance of the faces.

    Raises:
        TypeError, ValueError, FileNotFoundError: a file or an option that cannot be used.
    """
    city = None
    if run.kind == CITY:
        city = load_city(run.mesh, lod=run.lod, split=run.split, context=_read_context(run.context))
    return Source(with_optics(load_mesh(run.mesh) if city is None else city.mesh, **run.optics), city)


def _read_context(name: str | None) -> Any:
    """Read the terrain around a city: none, a plane, a mesh file in the city's unit, or a raster of heights."""
    if name in (None, GROUND_PLANE):
        return name
    is_raster = Path(name).suffix.lower() not in (*SUFFIXES, "")
    return rasters.surface(name) if is_raster else load_mesh(name)


def place_points(run: BakeRun, source: Source) -> SurfacePoints:
    """Return the points of a run: vertices, face centres, random points, or points spread over all parts.

    Raises:
        ValueError: means over parts of a mesh without named parts.
    """
    mesh, city = source.mesh, source.city
    if not is_by_parts(run):
        return points_on(mesh, run.points, run.at, run.options["seed"])
    if mesh.part is None:
        raise ValueError(f"--by: got {run.by} for {str(run.mesh)!r}, whose faces have no named parts")
    areas = np.where(mesh.part >= 0, mesh.face_areas, 0.0) if city is None else city.receiving
    if run.at == "faces":
        return face_centers(mesh).take(areas > 0.0)
    return spread_points(mesh, areas, run.points, run.options["seed"])
