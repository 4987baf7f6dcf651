"""`warpsample directions`: write directions at points of a mesh into an .npz, or as a cloud of points into .vtp or .ply."""

import hashlib
import json
from collections.abc import Iterator
from dataclasses import asdict, dataclass
from importlib.metadata import version
from pathlib import Path
from typing import Any, BinaryIO

import numpy as np

from warpsample.directions.sample import Directions, Status, sample_directions
from warpsample.distributions import as_spatial
from warpsample.distributions.lights.environment_map import list_picture_hashes
from warpsample.distributions.record import Distribution
from warpsample.host.arguments import check_integer, check_seed
from warpsample.host.arrays import cpu
from warpsample.host.engine import check_memory, check_space, check_workers
from warpsample.host.files import check_output, complete_or_absent, new_archive, write_array
from warpsample.mesh.examples import content_of
from warpsample.mesh.files import load_mesh
from warpsample.mesh.files.gltf import describe_invisible
from warpsample.mesh.files.linked_files import list_linked_files
from warpsample.mesh.files.uv import find_uv
from warpsample.mesh.points.arrays import Rows, carry_to_points, read_array
from warpsample.mesh.surface import SurfacePoints
from warpsample.mesh.tangents import face_tangents, vertex_tangents
from warpsample.output.input_state import InputState
from warpsample.output.mesh_writers import Lazy, write_ply, write_vtp
from warpsample.output.places import check_places, points_on
from warpsample.output.run_record import RunRecord
from warpsample.sequences import get as get_sequence
from warpsample.sequences.record import STREAMS

SUFFIXES = (".npz", ".vtp", ".ply")
CLOUD_SCALE = 0.05
"""Length of a direction in a cloud, relative to the diagonal of the mesh's box."""

DIRECTIONS_PER_PART = 1 << 22
"""Number of directions of an .npz in memory at a time, 50 MB."""

_BYTES_IN_FILE = 12  # of a direction, at least
_BYTES_IN_CLOUD = 24  # of a direction: once as sampled, once without the points that have none


@dataclass(frozen=True)
class DirectionsRun:
    """Arguments of a `warpsample directions` command, which the output file records.

    Attributes:
        mesh: Path of the mesh.
        output: Path of the file to write.
        points: Number of random points, uniform by area, or None.
        samples: Number of directions per point.
        distribution: Name of the distribution.
        sequence: Name of the sequence.
        seed: Random seed.
        at: "vertices" or "faces" for points there, or None.
        arrays: File of the arrays that the distribution names, or None for the mesh.
    """

    mesh: Path
    output: Path
    points: int | None
    samples: int
    distribution: str
    sequence: str
    seed: int
    at: str | None
    arrays: Path | None = None


def export(run: DirectionsRun, workers: int | None = None) -> str:
    """Sample directions as a `warpsample directions` command asks, write the file, and return a sentence about it.

    An .npz file holds position, normal, face, vectors, status and `run`, a JSON text; the points and one part of the
    directions are in memory at a time. Lobes that are not symmetric about the normal lie along u of the texture coordinates,
    if the mesh file has some; the .npz then holds the tangents, too. In .vtp and .ply each direction w is a point at
    position + CLOUD_SCALE * diagonal * w, with w as its normal; .vtp also has the row of its surface point. Positions are
    float64, since float32 would displace a small cloud far from the origin. A cloud that is larger than the free memory is a
    MemoryError. An argument that cannot be used is refused before anything is written. The file appears when it is complete;
    an interrupted run, and one whose file cannot be written (WriteError), leaves the old one, or none.
    """
    _check(run)
    check_workers(workers)
    state = InputState.of(run.mesh, run.arrays)
    mesh = load_mesh(run.mesh)
    if run.points is not None and run.output.suffix == ".npz":  # a cloud is held by memory, below
        ways = run.points * run.samples
        check_space(run.output, ways * _BYTES_IN_FILE, f"{ways:,} directions")
    points = points_on(mesh, run.points, run.at, run.seed)

    def carry(name: str) -> np.ndarray:
        array, at = _array(run, name)
        return carry_to_points(array, name, mesh, points, at)

    lobe = as_spatial(run.distribution, carry)
    if not lobe.symmetric and not lobe.in_world and (uv := find_uv(run.mesh)) is not None:
        tangent = vertex_tangents(mesh, uv) if run.at == "vertices" else face_tangents(mesh, uv, points.face)
        points = points.with_tangents(tangent)
    invisible = describe_invisible(run.mesh)
    with complete_or_absent(run.output) as file:
        if run.output.suffix == ".npz":
            status = _write_archive(file, points, lobe, run, workers)
        else:
            status = _write_cloud(file, points, lobe, run, workers, scale=CLOUD_SCALE * mesh.diagonal)
        state.check()  # texture coordinates, arrays and hashes are read after the mesh
    skipped = {Status(code): int(n) for code, n in enumerate(np.bincount(status)) if code and n}
    total, which = len(points) * run.samples, {Status.INVALID_PARAMETER: _name_invalid(lobe)}
    counts = [f"{n:,} {code.name.lower()}{which.get(code, '')}" for code, n in skipped.items()]
    return ", ".join([f"{total:,} directions at {len(points):,} points", *counts, *invisible])


def _name_invalid(lobe: Distribution) -> str:
    """Return the names of the parameters with invalid rows in brackets, for example " (alpha, view)"."""
    return f" ({', '.join(name for name, rows in lobe.by_point.items() if np.isnan(rows).any())})"


def _array(run: DirectionsRun, name: str) -> Rows:
    """Read the array of distribution parameters that the command names, for example "@roughness"."""
    return read_array(run.mesh if run.arrays is None else run.arrays, name, "--arrays")


def _write_archive(
    file: BinaryIO, points: SurfacePoints, lobe: Distribution, run: DirectionsRun, workers: int | None
) -> np.ndarray:
    record, status = _record(run, lobe), np.empty(len(points), np.uint8)
    with new_archive(file) as archive:
        write_array(archive, "position", points.position)
        write_array(archive, "normal", points.normal)
        write_array(archive, "face", points.face)
        if points.tangent is not None:
            write_array(archive, "tangent", points.tangent)
        header = {"descr": "<f4", "fortran_order": False, "shape": (len(points), run.samples, 3)}
        with archive.open("vectors.npy", "w", force_zip64=True) as member:
            np.lib.format.write_array_header_2_0(member, header)
            for start, directions in _parts(points, lobe, run, workers):
                member.write(directions.vectors.data)
                status[start : start + len(directions.status)] = directions.status
        write_array(archive, "status", status)
        write_array(archive, "run", np.array(json.dumps(record)))
    return status


def _write_cloud(
    file: BinaryIO, points: SurfacePoints, lobe: Distribution, run: DirectionsRun, workers: int | None, *, scale: float
) -> np.ndarray:
    size = len(points) * run.samples * _BYTES_IN_CLOUD
    check_memory(
        size, f"the {len(points) * run.samples:,} directions of the cloud", "take fewer, or write .npz, which is streamed"
    )
    found = _sampled(points, lobe, run, workers)
    rows = np.flatnonzero(found.status == 0)
    ways = (found.vectors if len(rows) == len(points) else found.vectors[rows]).reshape(-1, 3)
    position = Lazy(
        ways.shape,
        np.dtype(np.float64),
        lambda i: points.position[rows[i // run.samples]] + scale * ways[i].astype(np.float64),
    )
    if run.output.suffix == ".ply":
        write_ply(file, {"vertex": {"x y z": position, "nx ny nz": ways}})
    else:
        row = Lazy(ways.shape[:1], np.dtype(np.int32), lambda i: rows[i // run.samples])
        write_vtp(file, position, None, {"Normals": ways, "point": row}, {})
    return found.status


def _check(run: DirectionsRun) -> None:
    if run.output.suffix not in SUFFIXES:
        raise ValueError(f"--output: got {str(run.output)!r}, want a file that ends in one of {' '.join(SUFFIXES)}")
    check_output(run.output, "--output", run.mesh, run.arrays, *list_linked_files(run.mesh))
    check_places(run.points, run.at)
    check_integer(run.samples, "--samples", 1, 2**31 - 1)
    check_seed(run.seed)
    as_spatial(run.distribution, lambda name: np.atleast_1d(_array(run, name).array)[:1])
    get_sequence(run.sequence)


def _parts(
    points: SurfacePoints, lobe: Distribution, run: DirectionsRun, workers: int | None
) -> Iterator[tuple[int, Directions]]:
    """Sample the directions in parts of points that fit into memory; yield (first row, directions) for each part."""
    step, record = max(1, DIRECTIONS_PER_PART // run.samples), RunRecord("directions")
    with record.show("sampling"), record.count(len(points), f"{run.output} is as it was before"):
        for start in range(0, len(points), step):
            rows = slice(start, start + step)
            part = points.take(rows)
            yield start, _sampled(part, lobe.take(rows), run, workers, start)
            record.advance(len(part))


def _sampled(points: Any, lobe: Distribution, run: DirectionsRun, workers: int | None, first_point: int = 0) -> Directions:
    options: dict[str, Any] = {"seed": run.seed, "first_point": first_point, "workers": workers}
    return sample_directions(points, run.samples, distribution=lobe, sequence=run.sequence, **options)


def _record(run: DirectionsRun, lobe: Distribution) -> dict[str, object]:
    """Return the record for repeating a command bit for bit: arguments, hashes of files, versions of libraries."""
    digest = hashlib.sha256(content_of(run.mesh)).hexdigest()
    arguments = {key: str(value) if isinstance(value, Path) else value for key, value in asdict(run).items()}
    if run.arrays is None:
        arguments.pop("arrays")
    else:
        arguments["arrays_sha256"] = hashlib.sha256(run.arrays.read_bytes()).hexdigest()
    if pictures := list_picture_hashes(lobe):
        arguments["pictures_sha256"] = pictures
    versions = {name: version(name) for name in ("warpsample", "warp-lang", "numpy")} | {"streams": STREAMS}
    return {**arguments, "mesh_sha256": digest, "versions": versions, "cpu": cpu().name}
