"""Means over the named parts of a mesh, or over the surfaces of a city: what `warpsample bake` writes of them."""

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np

from warpsample.city import rasters
from warpsample.city.cityjson.city import City, load_city
from warpsample.city.cityjson.context import GROUND_PLANE
from warpsample.city.cityjson.placing import spread_points
from warpsample.city.cityjson.writing import add_totals
from warpsample.estimate.quantities.record import Quantity
from warpsample.host.files import complete_or_absent
from warpsample.host.tables import write_csv
from warpsample.mesh.files import SUFFIXES, load_mesh
from warpsample.mesh.mesh import Mesh
from warpsample.mesh.part_means import part_means
from warpsample.mesh.surface import SurfacePoints, face_centers
from warpsample.output.baked import Baked, BakeRun
from warpsample.output.pictured import picture_of, shown

CITY_SUFFIXES = (".json", ".jsonl")


def is_city(run: BakeRun) -> bool:
    """Whether a run is of CityJSON, by the names of its files."""
    return bool({run.mesh.suffix, run.output.suffix} & set(CITY_SUFFIXES))


def is_by_parts(run: BakeRun) -> bool:
    """Whether a run writes means over parts, not numbers at points; a picture of a city shows them, too."""
    suffixes = (*CITY_SUFFIXES, ".csv", *([".png"] if run.at is None else []))
    return run.by is not None or (is_city(run) and run.output.suffix in suffixes)


def check_parts(run: BakeRun, quantity: Quantity) -> None:
    """Refuses options and files that do not go with means over parts, or not with this input."""
    if not is_city(run):
        for option in ("lod", "split", "context"):
            if getattr(run, option):
                raise ValueError(f"--{option}: got {getattr(run, option)} for {run.mesh.name}; it applies only to CityJSON")
    name = run.output.name
    if is_city(run) and run.output.suffix == ".zarr":
        raise ValueError(f"--output: got {name!r} for CityJSON, want .city.json, .city.jsonl, .csv or a mesh file")
    if not is_by_parts(run):
        return
    if run.output.suffix not in ((*CITY_SUFFIXES, ".csv", ".png") if is_city(run) else (".csv",)):
        raise ValueError(f"--output: got {name!r} for --by {run.by}, want a file that ends in .csv")
    if quantity.is_matrix:
        raise ValueError(f"--quantity: got {quantity.name} for {name!r}, want one of a few numbers at each point")
    if run.at == "vertices":
        raise ValueError(f"--at: got {run.at} for means over parts, want faces, or --points")
    if run.output.suffix in CITY_SUFFIXES and run.mesh.suffix in CITY_SUFFIXES and run.output.suffix != run.mesh.suffix:
        raise ValueError(f"--output: got {name!r} for {run.mesh.name!r}, want a file that ends in {run.mesh.suffix}, too")


def city_of(run: BakeRun) -> City | None:
    """The city of a run of CityJSON, in its context."""
    if not is_city(run):
        return None
    return load_city(run.mesh, lod=run.lod, split=run.split, context=_context(run.context))


def _context(name: str | None) -> Any:
    """Read what stands around a city: nothing, a plane, a mesh file in the city's unit, or a raster of heights."""
    if name in (None, GROUND_PLANE):
        return name
    is_raster = Path(name).suffix.lower() not in (*SUFFIXES, "")
    return rasters.surface(name) if is_raster else load_mesh(name)


def points_of_parts(run: BakeRun, mesh: Mesh, city: City | None) -> SurfacePoints:
    """Points on all faces that have a mean: at their centres, or about so many spread over them."""
    if mesh.part is None:
        raise ValueError(f"--by: got {run.by} for {str(run.mesh)!r}, whose faces have no named parts")
    areas = np.where(mesh.part >= 0, mesh.face_areas, 0.0) if city is None else city.receiving
    if run.at != "faces":
        return spread_points(mesh, areas, run.points, run.options["seed"])
    return face_centers(mesh).take(areas > 0.0)


def write_parts(baked: Baked, city: City | None) -> None:
    """Writes the means as attributes of a city, a picture, or a .csv with a row for each part: name, area, means, errors."""
    output = baked.run.output
    if city is not None and output.suffix in CITY_SUFFIXES:
        city.write(output, {f"ws_{name}": column for name, column in _means(baked)})
        return
    with complete_or_absent(output) as file:
        if output.suffix == ".png":
            file.write(picture_of(baked, _of_faces(baked)))
        else:
            write_csv(file, part_table(baked, city))


def part_table(baked: Baked, city: City | None) -> dict[str, np.ndarray]:
    """A row for each part: its name, area, means and errors, and sums where the unit is per area."""
    rows = _rows(baked.mesh) if city is None else city.surfaces.columns
    area = rows.pop("area")
    return rows | {"area_m2": area} | dict(add_totals(dict(_means(baked)), area))


def _rows(mesh: Mesh) -> dict[str, np.ndarray]:
    """The parts of a mesh: their names, and how many faces and what area each has."""
    assert mesh.part is not None
    inside, count = mesh.part >= 0, len(mesh.parts)
    faces = np.bincount(mesh.part[inside], minlength=count)
    area = np.bincount(mesh.part[inside], mesh.face_areas[inside], count)
    return {"part": np.array(mesh.parts, object), "faces": faces, "area": area}


def _of_faces(baked: Baked) -> np.ndarray:
    """(F,) for each face the mean over its part of what is shown; NaN where it is of none, or has no number."""
    mesh = baked.mesh
    assert mesh.part is not None
    value = shown(baked)
    means = part_means(
        mesh.part, mesh.face_areas, baked.points.face, value, np.zeros(len(value)), count=len(mesh.parts)
    ).value
    return np.where(mesh.part >= 0, means[np.maximum(mesh.part, 0)], np.nan)


def _means(baked: Baked) -> Iterator[tuple[str, np.ndarray]]:
    """The means over the parts of a mesh and their errors, by the headers of their columns."""
    mesh, found = baked.mesh, baked.found
    assert mesh.part is not None
    good = (found.status == 0).reshape(-1, *[1] * (found.value.ndim - 1))
    value = np.where(good, found.value, np.nan)
    made = part_means(mesh.part, mesh.face_areas, baked.points.face, value, found.standard_error, count=len(mesh.parts))
    for name in ("value", "standard_error"):
        array, header = getattr(made, name), baked.quantity.header
        split = zip(baked.quantity.channels, array.T, strict=True) if array.ndim == 2 else ()
        yield from [(header(f"{name}_{letter}"), column) for letter, column in split] or [(header(name), array)]
