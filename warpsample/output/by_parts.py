"""Means over the named parts of a mesh or over the surfaces of a city, and the files that hold the means."""

from collections.abc import Iterator

import numpy as np

from warpsample.city.cityjson.city import City, write_columns
from warpsample.city.cityjson.writing import add_totals
from warpsample.estimate.intervals import errors_for_means
from warpsample.host.files import complete_or_absent
from warpsample.host.tables import write_csv
from warpsample.mesh.mesh import Mesh
from warpsample.mesh.part_means import part_means
from warpsample.output.baked import Baked
from warpsample.output.pictured import draw_picture, get_picture_values


def write_parts(baked: Baked, city: City | None) -> None:
    """Write the means over the parts of a mesh as a .png, as a .csv with a row per part, or into a CityJSON file."""
    output = baked.run.output
    if output.suffix not in (".png", ".csv"):
        assert city is not None
        means = list(_means(baked, city))
        columns = {f"ws_{name}": column for name, column, _ in means}
        write_columns(city, output, columns, {f"ws_{name}": runs for name, _, runs in means if runs is not None})
        return
    with complete_or_absent(output) as file:
        if output.suffix == ".png":
            file.write(draw_picture(baked, _means_of_faces(baked)))
        else:
            write_csv(file, part_table(baked, city))


def part_table(baked: Baked, city: City | None) -> dict[str, np.ndarray]:
    """Return a table with a row for each part of the mesh: name, area, mean, standard error, and total."""
    rows = list_parts(baked.mesh) if city is None else city.surfaces.columns
    area = rows.pop("area")
    return rows | {"area_m2": area} | dict(add_totals({name: column for name, column, _ in _means(baked, city)}, area))


def list_parts(mesh: Mesh) -> dict[str, np.ndarray]:
    """Return the name, the number of faces and the area of each part of a mesh."""
    assert mesh.part is not None
    inside, count = mesh.part >= 0, len(mesh.parts)
    faces = np.bincount(mesh.part[inside], minlength=count)
    area = np.bincount(mesh.part[inside], mesh.face_areas[inside], count)
    return {"part": np.array(mesh.parts, object), "faces": faces, "area": area}


def _means_of_faces(baked: Baked) -> np.ndarray:
    """Return, for each face, the mean of the values over the part that contains the face, (F,); NaN without a part."""
    mesh = baked.mesh
    assert mesh.part is not None
    value = get_picture_values(baked)
    means = part_means(
        mesh.part, mesh.face_areas, baked.points.face, value, np.zeros(len(value)), count=len(mesh.parts)
    ).value
    return np.where(mesh.part >= 0, means[np.maximum(mesh.part, 0)], np.nan)


def _means(baked: Baked, city: City | None) -> Iterator[tuple[str, np.ndarray, np.ndarray | None]]:
    """Yield the columns of a table of N parts: means of the values, and their standard errors.

    Each is (header, array, runs). For values, `runs` is (R, N), means of R runs of the light that faces reflect, or None.
    """
    mesh, found = baked.mesh, baked.result
    assert mesh.part is not None
    good = (found.status == 0).reshape(-1, *[1] * (found.value.ndim - 1))
    value = np.where(good, found.value, np.nan)
    means = part_means(
        mesh.part,
        mesh.face_areas,
        baked.points.face,
        value,
        found.standard_error,
        count=len(mesh.parts),
        least=errors_for_means(found),
        runs=getattr(found, "reflected_runs", None),
        kind=None if city is None else city.surfaces.type,
    )
    for name in ("value", "standard_error"):
        array, header = getattr(means, name), baked.quantity.header
        letters = [f"_{letter}" for letter in baked.quantity.channels] if array.ndim == 2 else [""]
        runs = [None] * len(letters) if means.runs is None or name != "value" else means.runs
        for letter, column, run in zip(letters, np.atleast_2d(array.T), runs, strict=True):
            yield header(f"{name}{letter}"), column, run
