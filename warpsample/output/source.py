"""Input of a `warpsample bake` command: the checked arguments, the mesh or city, and the points to compute at."""

from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from warpsample.city import rasters
from warpsample.city.cityjson.city import City
from warpsample.city.cityjson.context import GROUND_PLANE
from warpsample.city.cityjson.loading import load_city
from warpsample.city.cityjson.placing import find_receiving_faces, spread_points
from warpsample.estimate.quantities.record import Quantity
from warpsample.host.device_memory import Memory
from warpsample.host.files import check_output
from warpsample.host.locks import imported
from warpsample.mesh.files import SUFFIXES, load_mesh
from warpsample.mesh.files.linked_files import list_linked_files
from warpsample.mesh.mesh import Mesh
from warpsample.mesh.surface import SurfacePoints, face_centers
from warpsample.output.bake_rules import check_table, is_by_parts
from warpsample.output.bake_table import CITY
from warpsample.output.baked import BakeRun, check_glb
from warpsample.output.faces_option import with_optics
from warpsample.output.input_state import InputState
from warpsample.output.kept_glb import describe_kept_file, keeps
from warpsample.output.places import check_places, points_on
from warpsample.output.quantities import quantity_of
from warpsample.output.report import check_report
from warpsample.plotting.rendering import check_rendering


@dataclass(frozen=True, eq=False)
class Source:
    """Input of a `warpsample bake` command, checked and loaded: arguments, mesh or city, and points.

    Attributes:
        run: Arguments of the command.
        quantity: Quantity to compute.
        mesh: Mesh, with the transmittance and reflectance of its faces.
        city: City of which the mesh is the surface, or None.
        points: Points to compute at.
        state: State of the input file when it was read, if the output is a copy of it with values added.
        notes: Sentences on the parts of a .glb that the output replaces.
    """

    run: BakeRun
    quantity: Quantity
    mesh: Mesh
    city: City | None
    points: SurfacePoints
    state: InputState
    notes: tuple[str, ...] = ()


def read_source(run: BakeRun) -> Source:
    """Check the arguments of a `warpsample bake` command, read the mesh or the CityJSON file, and place the points.

    Raises:
        TypeError, ValueError, FileNotFoundError: a file or an option that cannot be used; the message names the option.
    """
    quantity = quantity_of(run.quantity)
    _check(run, quantity)
    city, state = None, InputState.of(run.mesh if _keeps_input(run) else None)
    if run.kind == CITY:
        city = load_city(run.mesh, lod=run.lod, split=run.split, context=_read_context(run.context))
    own = None if city is None or not run.context else city.surface >= 0  # terrain neither reflects nor transmits
    mesh = with_optics(load_mesh(run.mesh) if city is None else city.mesh, own, **run.optics)
    notes = _check_glb(run, mesh)
    return Source(run, quantity, mesh, city, _place_points(run, mesh, city), state, tuple(notes))


def _check(run: BakeRun, quantity: Quantity) -> None:
    """Check all arguments of a `warpsample bake` command before any file is read."""
    check_table(run)
    check_places(run.points, run.at)
    if run.output.suffix == ".png":
        check_rendering()
    files = input_files(run, quantity)
    check_report(run.report, run.output, *files)
    Memory.of(run.options.get("device"))
    check_output(run.output, "--output", *files)


def input_files(run: BakeRun, quantity: Quantity) -> list[Path]:
    """Return the paths of all files that a `warpsample bake` command reads."""
    files = [run.options.get(option) for option in quantity.files]
    context = Path(run.context) if run.context else None
    files += [text for text in run.optics.values() if text and text.endswith(".npy")]
    files += [context, *list_linked_files(context), *_raster_files(run.context)]
    return [Path(file) for file in (run.mesh, *list_linked_files(run.mesh), *files) if file is not None]


def _read_context(name: str | None) -> Any:
    """Read the terrain around a city: none, a plane, a mesh file in the city's unit, or a raster of heights."""
    if name in (None, GROUND_PLANE):
        return name
    if not _is_raster(name):
        return load_mesh(name)
    surface = rasters.surface  # first, because it names the extra if that is not installed
    with imported("warpsample.city.rasters.canopy").rename_argument("context"):
        return surface(name)


def _is_raster(name: str) -> bool:
    """Return whether the terrain around a city is a raster of heights, by its suffix."""
    return Path(name).suffix.lower() not in (*SUFFIXES, "")


def _raster_files(name: str | None) -> list[Path]:
    """Return the files of the raster around a city; none for other terrain, or without the extra, which reading names."""
    if name is not None and _is_raster(name):
        with suppress(ModuleNotFoundError):
            return imported("warpsample.city.rasters.sources.inputs").files_read(name)
    return []


def _keeps_input(run: BakeRun) -> bool:
    """Return whether the output is a copy of the input .glb with values added."""
    return run.kind != CITY and keeps(run.mesh, run.output, run.at)


def _check_glb(run: BakeRun, mesh: Mesh) -> list[str]:
    """Check that the output .glb can hold the values; return sentences on content of the input that is not kept."""
    if _keeps_input(run):
        return describe_kept_file(run.mesh, run.output)
    if run.output.suffix == ".glb":
        check_glb(run, mesh)
    return []


def _place_points(run: BakeRun, mesh: Mesh, city: City | None) -> SurfacePoints:
    """Return the points to compute at: vertices, face centres, or random points on the surface.

    Raises:
        ValueError: means over parts of a mesh without named parts.
    """
    if not is_by_parts(run):
        return points_on(mesh, run.points, run.at, run.options["seed"])
    if mesh.part is None or not mesh.face_areas[mesh.part >= 0].any():
        raise ValueError(
            f"--by: got {run.by} for {str(run.mesh)!r}, which has no named parts with an area; name the parts in the mesh "
            "file, or leave out --by"
        )
    areas = np.where(mesh.part >= 0, mesh.face_areas, 0.0) if city is None else city.receiving
    if run.at == "faces":
        return face_centers(mesh).take(find_receiving_faces(areas))
    return spread_points(mesh, areas, run.points, run.options["seed"])
