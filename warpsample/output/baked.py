"""Baked numbers as files: .ply, .vtp, .glb, .npz, .csv and .png."""

import json
from collections.abc import Callable
from dataclasses import dataclass, fields
from math import pi
from pathlib import Path
from typing import Any, BinaryIO

import numpy as np

from warpsample.estimate.quantities.record import Quantity
from warpsample.host.files import write_arrays
from warpsample.mesh.mesh import Mesh
from warpsample.mesh.surface import SurfacePoints
from warpsample.output.kept_glb import keeps, write_kept
from warpsample.output.mesh_writers import Lazy, write_glb, write_ply, write_vtp
from warpsample.output.pictured import write_png
from warpsample.output.quantities import quantity_of
from warpsample.output.upward import placed_upright, up_of
from warpsample.radiation.exchange.matrix_files import write_matrix

_KEPT = 0.01  # of its area a face may gain or lose by a .glb's float32

MOST_GLB_BYTES = 2**32 - 2**20
"""Of its arrays: a .glb tells its length in 32 bits, and holds a text too."""

_BYTES_OF_CORNER = 12 + 4 + 8 * 4  # in a .glb, with all that is known of light


@dataclass(frozen=True)
class BakeRun:
    """The arguments of `warpsample bake`.

    The output's suffix is of WRITERS, and `at` of places.PLACES, or None: on the surface, uniform by area, so many `points`.
    The options are those that were given of what the quantity takes, by their names on the command line, and the seed. `by`
    is "part" for means over the named parts of the mesh; `lod`, `split` and `context`, "ground" or a path, are for CityJSON;
    `report` is a further file, an .html about the run; `transmittance` and `reflectance` are of
    the faces, as `faces_option.with_optics` takes them.
    """

    mesh: Path
    output: Path
    quantity: str
    at: str | None
    points: int | None
    options: dict[str, Any]
    by: str | None = None
    lod: str | None = None
    split: bool = False
    context: str | None = None
    report: Path | None = None
    transmittance: str | None = None
    reflectance: str | None = None

    @property
    def optics(self) -> dict[str, str | None]:
        """What is told of the light that faces let through and send back."""
        return {"transmittance": self.transmittance, "reflectance": self.reflectance}

    @property
    def told(self) -> dict[str, str]:
        """What a file tells of these, but for the options, and for what is as it mostly is."""
        kept = (
            item
            for item in fields(self)
            if item.name not in ("options", "report") and getattr(self, item.name) != item.default
        )
        return {item.name: str(getattr(self, item.name)) for item in kept}


@dataclass(frozen=True)
class Baked:
    """The content of a file: the mesh, the points and their numbers."""

    run: BakeRun
    mesh: Mesh
    points: SurfacePoints
    found: Any

    @property
    def quantity(self) -> Quantity:
        """What the numbers are."""
        return quantity_of(self.run.quantity)

    @property
    def arrays(self) -> dict[str, np.ndarray]:
        """The arrays with a row for each point, by name."""
        return self.quantity.arrays_of(self.found)

    @property
    def columns(self) -> dict[str, np.ndarray]:
        """The numbers of each point in columns, by name."""
        return self.quantity.columns(self.found)


def check_glb(run: BakeRun, mesh: Mesh) -> None:
    """Refuses a mesh that needs more than float32 about its middle, or more than a file of 4 GiB.

    The ValueError names the formats that can hold it.
    """
    areas = mesh.face_areas
    change = np.abs(Mesh(_local(mesh)[0], mesh.faces).face_areas - areas)
    lost = np.count_nonzero((areas > 0.0) & (change > _KEPT * areas))
    if lost:
        raise ValueError(
            f"--output: got {run.output.name!r}, whose float32 would change the area of {lost:,} of {len(areas):,} faces by "
            f"more than {_KEPT:.0%}, want .ply or .vtp"
        )
    corners = mesh.faces.size if run.at == "faces" else len(mesh.vertices)
    if corners * _BYTES_OF_CORNER + mesh.faces.nbytes > MOST_GLB_BYTES:
        raise ValueError(f"--output: got {run.output.name!r} of {corners:,} corners, want .ply or .vtp: it holds 4 GiB")


def _local(mesh: Mesh) -> tuple[np.ndarray, np.ndarray]:
    """Vertices as float32, (V, 3), and their float64 translation to the mesh: 0 if it is not far from the origin."""
    single = mesh.vertices.astype(np.float32)
    middle = mesh.bounds.mean(axis=0)
    if np.abs(middle).max() <= mesh.diagonal or np.array_equal(single, mesh.vertices):
        return single, np.zeros(3)
    return (mesh.vertices - middle).astype(np.float32), middle


def _write_npz(file: BinaryIO, baked: Baked, **more: np.ndarray) -> None:
    points = baked.points
    arrays = {"position": points.position, "normal": points.normal, "face": points.face, **baked.arrays, **more}
    options = baked.quantity.told(baked.run.options)
    told = baked.run.told | {name: str(value) for name, value in options.items()}
    write_arrays(file, {**arrays, "run": np.array(json.dumps(told))})


def _write_csv(file: BinaryIO, baked: Baked) -> None:
    columns = baked.columns
    formats = ["%.17g"] * 3 + ["%d" if name in ("rays", "status") else "%.9g" for name in columns]
    table = np.column_stack([baked.points.position, *columns.values()])
    header = ",".join(["x", "y", "z", *map(baked.quantity.header, columns)])
    np.savetxt(file, table, formats, delimiter=",", header=header, comments="")


def _write_ply(file: BinaryIO, baked: Baked) -> None:
    """Writes the numbers as properties of vertices or faces and as colours; vertices as float32 if that is exact."""
    vertices = baked.mesh.vertices
    single = Lazy(vertices.shape, np.dtype(np.float32), lambda i: vertices[i])
    exact = all(np.array_equal(single[i : i + 65536], vertices[i : i + 65536]) for i in range(0, len(vertices), 65536))
    elements = {"vertex": {"x y z": single if exact else vertices}, "face": {"vertex_indices": baked.mesh.faces}}
    elements["face" if baked.run.at == "faces" else "vertex"] |= {
        "red green blue alpha": baked.quantity.colours(baked.found),
        **baked.columns,
    }
    write_ply(file, elements)


def _write_glb(file: BinaryIO, baked: Baked) -> None:
    """Writes the numbers as attributes of vertices, as a .glb has no others: for faces, each gets its own corners.

    Those of the vertices of a .glb are written into that.
    """
    if keeps(baked.run.mesh, baked.run.output, baked.run.at):
        columns = {f"_{name}": array.astype(np.float32) for name, array in baked.columns.items()}
        write_kept(file, baked.run.mesh, {"COLOR_0": baked.quantity.colours(baked.found), **columns})
        return
    local, middle = _local(baked.mesh)
    faces, times = baked.mesh.faces, 3 if baked.run.at == "faces" else 1
    corners = Lazy(faces.shape, np.dtype(np.uint32), lambda i: faces[i] if times == 1 else 3 * i[:, None] + np.arange(3))
    vertices = local if times == 1 else Lazy((faces.size, 3), local.dtype, lambda i: local[faces.ravel()[i]])
    attributes = {
        "COLOR_0": _repeated(baked.quantity.colours(baked.found), times, np.uint8)
    }  # custom names begin with an underscore
    attributes |= {f"_{name}": _repeated(array, times, np.float32) for name, array in baked.columns.items()}
    write_glb(file, vertices, corners, attributes, placed_upright(middle, up_of(baked.quantity, baked.run.options)))


def _repeated(array: np.ndarray, times: int, dtype: type) -> Lazy:
    return Lazy((times * len(array), *array.shape[1:]), np.dtype(dtype), lambda i: array[i // times])


def _write_vtp(file: BinaryIO, baked: Baked) -> None:
    points, arrays = baked.points, baked.arrays
    if baked.run.at is None:
        write_vtp(file, points.position, None, {"Normals": points.normal, "face": points.face, **arrays}, {})
    else:
        data = ({}, arrays) if baked.run.at == "faces" else (arrays, {})
        write_vtp(file, baked.mesh.vertices, baked.mesh.faces, *data)


def _write_matrix_npz(file: BinaryIO, baked: Baked) -> None:
    sky = baked.found.patches
    _write_npz(file, baked, directions=sky.directions, solid_angles=sky.solid_angles)


WRITERS: dict[str, Callable[..., None]] = {
    ".ply": _write_ply,
    ".vtp": _write_vtp,
    ".glb": _write_glb,
    ".npz": _write_npz,
    ".csv": _write_csv,
}

PICTURES = {".png": write_png}
"""What shows the numbers, and holds none."""

MATRIX_WRITERS: dict[str, Callable[..., None]] = {
    ".npz": _write_matrix_npz,
    ".mtx": lambda file, baked: write_matrix(file, baked.found.value, pi),
}
"""For values that are too many for columns; the .mtx in Radiance's form, as `SkyMatrix.save` has it."""


def writers_of(quantity: Quantity) -> dict[str, Callable[[BinaryIO, Baked], None]]:
    """What writes the numbers of a quantity, by the suffix of the file."""
    return MATRIX_WRITERS if quantity.is_matrix else WRITERS | PICTURES
