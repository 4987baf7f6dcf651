"""Arguments of a `warpsample bake` command, and writers of its output files: .ply, .vtp, .glb, .npz, .csv, .mtx and .png."""

import json
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, fields
from math import pi
from pathlib import Path
from typing import Any, BinaryIO

import numpy as np

from warpsample.estimate.quantities.record import Quantity
from warpsample.host.files import write_arrays
from warpsample.mesh.mesh import Mesh
from warpsample.mesh.surface import SurfacePoints
from warpsample.output.bake_table import OPTIONS, kind_of
from warpsample.output.kept_glb import keeps, write_kept_file
from warpsample.output.mesh_writers import Lazy, write_glb, write_ply, write_vtp
from warpsample.output.pictured import write_png
from warpsample.output.quantities import quantity_of
from warpsample.output.upward import compute_upright_placement, up_of
from warpsample.radiation.exchange.matrix_files import write_matrix

_KEPT = 0.01  # fraction of its area that a face may gain or lose by the float32 of a .glb

MOST_GLB_BYTES = 2**32 - 2**20
"""Bytes of all arrays of a .glb, whose length is stored in 32 bits and includes a text."""

_BYTES_OF_CORNER = 12 + 4 + 8 * 4  # in a .glb, with all attributes of light


@dataclass(frozen=True)
class BakeRun:
    """Arguments of `warpsample bake`; `bake_table` describes the options.

    Attributes:
        mesh: Path of the source: a mesh, CityJSON or a raster.
        output: Path of the file to write.
        quantity: Name of the quantity.
        at: "vertices" or "faces"; None for random points, texels or cells.
        points: Number of random points; None for those of `at`.
        options: Given options of the quantity, and the seed, keyed by option name.
        by: "part" for means over named parts, or None.
        lod, split, context: Options of CityJSON.
        report: Path of an .html report, or None.
        transmittance, reflectance: Options of the faces, as `faces_option.with_optics` takes them.
        more: Given options of rasters, textures and stores, keyed by option name.
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
    more: dict[str, Any] = field(default_factory=dict)

    @classmethod
    def of(cls, mesh: Path, output: Path, quantity: str, given: Mapping[str, Any]) -> "BakeRun":
        """Build the `BakeRun` of a command from its options, keyed by name."""
        left = {name: value for name, value in given.items() if value is not None and value is not False}
        own = {name: left.pop(name) for name in _OWN if name in left}
        own = {"at": None, "points": None, **own}
        options = {name: left.pop(name) for name in ("seed", "workers") if name in left}
        options |= {name: left.pop(name) for name in list(left) if OPTIONS[name].by_quantity}
        return cls(mesh, output, quantity, options=options, more=left, **own)

    @property
    def kind(self) -> str:
        """Kind of the input: mesh, city, raster or texture; one of `bake_table.SOURCES`."""
        return kind_of(self.mesh, self.output, self.more.get("texture"))

    @property
    def arguments(self) -> dict[str, Any]:
        """Options of the command line, without defaults, keyed by option name."""
        own = {name: getattr(self, name) for name in _OWN}
        given = {**own, **self.options, **self.more}
        return {name: value for name, value in given.items() if value is not None and value is not False}

    @property
    def optics(self) -> dict[str, str | None]:
        """Values of the options `--reflectance` and `--transmittance` that are given, keyed by name."""
        return {"transmittance": self.transmittance, "reflectance": self.reflectance}

    @property
    def recorded(self) -> dict[str, str]:
        """Arguments to record in an output file, without `options` and without default values."""
        names = (item.name for item in fields(self) if getattr(self, item.name) != item.default)
        return {name: str(getattr(self, name)) for name in names if name not in ("options", "report", "more")}


_OWN = ("at", "points", "by", "lod", "split", "context", "report", "transmittance", "reflectance")
"""Names of the options with a field of their own in `BakeRun`."""


@dataclass(frozen=True)
class Baked:
    """Content to write to an output file: arguments of the command, mesh, points, and the result at the points."""

    run: BakeRun
    mesh: Mesh
    points: SurfacePoints
    result: Any

    @property
    def quantity(self) -> Quantity:
        """Description of the computed quantity: its name, unit and options."""
        return quantity_of(self.run.quantity)

    @property
    def arrays(self) -> dict[str, np.ndarray]:
        """Result arrays with a row for each point, keyed by name."""
        return self.quantity.arrays_of(self.result)

    @property
    def columns(self) -> dict[str, np.ndarray]:
        """Results at the points as one-dimensional columns, keyed by name."""
        return self.quantity.columns(self.result)


def check_glb(run: BakeRun, mesh: Mesh) -> None:
    """Check that a .glb can hold a mesh: in float32 relative to its centre, and in a file of 4 GiB.

    Raises:
        ValueError: the mesh needs another format; the message names formats that can hold it.
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
        raise ValueError(
            f"--output: got {run.output.name!r} of {corners:,} corners, want .ply or .vtp; this format holds at most 4 GiB"
        )


def _local(mesh: Mesh) -> tuple[np.ndarray, np.ndarray]:
    """Return (vertices relative to a centre, (V, 3) float32; the centre, float64), for files that hold float32 only."""
    single = mesh.vertices.astype(np.float32)
    middle = mesh.bounds.mean(axis=0)
    if np.abs(middle).max() <= mesh.diagonal or np.array_equal(single, mesh.vertices):
        return single, np.zeros(3)
    return (mesh.vertices - middle).astype(np.float32), middle


def _write_npz(file: BinaryIO, baked: Baked, **more: np.ndarray) -> None:
    """Write an .npz file with points, results, and the command's arguments as JSON."""
    points = baked.points
    arrays = {"position": points.position, "normal": points.normal, "face": points.face, **baked.arrays, **more}
    options = baked.quantity.recorded_options(baked.run.options)
    record = baked.run.recorded | {name: str(value) for name, value in options.items()}
    write_arrays(file, {**arrays, "run": np.array(json.dumps(record))})


def _write_csv(file: BinaryIO, baked: Baked) -> None:
    """Write a .csv file with a row for each point: position and values."""
    columns = baked.columns
    formats = ["%.17g"] * 3 + ["%d" if name in ("rays", "status") else "%.9g" for name in columns]
    table = np.column_stack([baked.points.position, *columns.values()])
    header = ",".join(["x", "y", "z", *map(baked.quantity.header, columns)])
    np.savetxt(file, table, formats, delimiter=",", header=header, comments="")


def _write_ply(file: BinaryIO, baked: Baked) -> None:
    """Write a .ply file with the values as properties and colours of the vertices or faces."""
    vertices = baked.mesh.vertices
    single = Lazy(vertices.shape, np.dtype(np.float32), lambda i: vertices[i])
    exact = all(np.array_equal(single[i : i + 65536], vertices[i : i + 65536]) for i in range(0, len(vertices), 65536))
    elements = {"vertex": {"x y z": single if exact else vertices}, "face": {"vertex_indices": baked.mesh.faces}}
    elements["face" if baked.run.at == "faces" else "vertex"] |= {
        "red green blue alpha": baked.quantity.colours(baked.result),
        **baked.columns,
    }
    write_ply(file, elements)


def _write_glb(file: BinaryIO, baked: Baked) -> None:
    """Write a .glb file with the values as vertex attributes; values at faces are stored at the face's corners.

    Values at the vertices of a .glb are added to the content of that file.
    """
    if keeps(baked.run.mesh, baked.run.output, baked.run.at):
        columns = {f"_{name}": array.astype(np.float32) for name, array in baked.columns.items()}
        write_kept_file(file, baked.run.mesh, {"COLOR_0": baked.quantity.colours(baked.result), **columns})
        return
    local, middle = _local(baked.mesh)
    faces, times = baked.mesh.faces, 3 if baked.run.at == "faces" else 1
    corners = Lazy(faces.shape, np.dtype(np.uint32), lambda i: faces[i] if times == 1 else 3 * i[:, None] + np.arange(3))
    vertices = local if times == 1 else Lazy((faces.size, 3), local.dtype, lambda i: local[faces.ravel()[i]])
    attributes = {"COLOR_0": _repeated(baked.quantity.colours(baked.result), times, np.uint8)}
    # names of custom attributes begin with an underscore
    attributes |= {f"_{name}": _repeated(array, times, np.float32) for name, array in baked.columns.items()}
    write_glb(
        file, vertices, corners, attributes, compute_upright_placement(middle, up_of(baked.quantity, baked.run.options))
    )


def _repeated(array: np.ndarray, times: int, dtype: type) -> Lazy:
    """Return an array with each row repeated `times` times, which is computed only when it is written."""
    return Lazy((times * len(array), *array.shape[1:]), np.dtype(dtype), lambda i: array[i // times])


def _write_vtp(file: BinaryIO, baked: Baked) -> None:
    """Write a .vtp file: the points with their values, or the mesh with values at vertices or faces."""
    points, arrays = baked.points, baked.arrays
    if baked.run.at is None:
        write_vtp(file, points.position, None, {"Normals": points.normal, "face": points.face, **arrays}, {})
    else:
        data = ({}, arrays) if baked.run.at == "faces" else (arrays, {})
        write_vtp(file, baked.mesh.vertices, baked.mesh.faces, *data)


def _write_matrix_npz(file: BinaryIO, baked: Baked) -> None:
    """Write an .npz file of a sky matrix: a row of values per point, and directions and solid angles of the sky patches."""
    sky = baked.result.patches
    _write_npz(file, baked, directions=sky.directions, solid_angles=sky.solid_angles)


WRITERS: dict[str, Callable[..., None]] = {
    ".ply": _write_ply,
    ".vtp": _write_vtp,
    ".glb": _write_glb,
    ".npz": _write_npz,
    ".csv": _write_csv,
}

PICTURES = {".png": write_png}
"""Writers of pictures of the values, keyed by suffix."""

MATRIX_WRITERS: dict[str, Callable[..., None]] = {
    ".npz": _write_matrix_npz,
    ".mtx": lambda file, baked: write_matrix(file, baked.result.value, pi),
}
"""Writers of many values per point, keyed by suffix; the .mtx is in Radiance's form, like that of `SkyMatrix.save`."""


def writers_of(quantity: Quantity) -> dict[str, Callable[[BinaryIO, Baked], None]]:
    """Return the functions that write a quantity's output files, keyed by file suffix."""
    return MATRIX_WRITERS if quantity.is_matrix else WRITERS | PICTURES
