"""Numbers at the points of a mesh, into a file: `warpsample bake`."""

import json
import zipfile
from collections.abc import Callable, Iterator
from dataclasses import dataclass, fields
from pathlib import Path
from time import perf_counter
from typing import Any, BinaryIO

import numpy as np

from warpsample.arguments import check_integer
from warpsample.estimate.irradiance import irradiance, read_hdr
from warpsample.estimate.result import Estimate, PointStatus, Skipped
from warpsample.estimate.visibility import ambient_occlusion, sky_view_factor
from warpsample.files import check_output, complete_or_absent, write_array
from warpsample.mesh import Mesh, load_mesh
from warpsample.mesh_writers import Lazy, write_glb, write_ply, write_vtp
from warpsample.surface import SurfacePoints, face_centers, sample_surface, vertex_points

QUANTITIES = {"ao": "ambient occlusion", "sky": "sky view factor", "irradiance": "irradiance"}
PLACEMENTS = {"vertices": vertex_points, "faces": face_centers, "surface": sample_surface}
SUFFIXES = (".ply", ".vtp", ".glb", ".npz", ".csv")

_RAYS_PER_PART = 1 << 22  # half a second, after which the progress moves
_KEPT = 0.01  # of its area a face may gain or lose by a .glb's float32
_BYTES_OF_CORNER = 12 + 4 + 8 * 4  # in a .glb, with all that is known of light


@dataclass(frozen=True)
class Run:
    """What was asked for.

    Attributes:
        mesh: the mesh file.
        output: the file to write, of SUFFIXES.
        quantity: of QUANTITIES.
        at: of PLACEMENTS.
        points: how many, of the placement "surface".
        samples: rays of each point.
        environment: the picture of the light, .hdr or .npy; for irradiance.
        up: the sky's axis.
        options: of `ambient_occlusion` and the others.
    """

    mesh: Path
    output: Path
    quantity: str
    at: str
    points: int
    samples: int
    environment: Path | None
    up: tuple[float, float, float]
    options: dict[str, Any]


@dataclass(frozen=True)
class Baked:
    """What is written: the mesh, the points and their numbers."""

    run: Run
    mesh: Mesh
    points: SurfacePoints
    found: Estimate


def bake(run: Run) -> str:
    """Runs and writes `run.output`, which appears when it is complete; an interrupted run leaves what was there before.

    Returns:
        what was done, in sentences.

    Raises:
        TypeError, ValueError, FileNotFoundError: an argument that cannot be used; before anything is computed.
        KeyboardInterrupt: with a sentence about what was done.
        WriteError: the file cannot be written.
    """
    _check(run)
    mesh = load_mesh(run.mesh)
    if run.output.suffix == ".glb":
        _check_glb(run, mesh)
    points = sample_surface(mesh, run.points, run.options["seed"]) if run.at == "surface" else PLACEMENTS[run.at](mesh)
    estimate = _quantity(run, mesh)
    estimate(_slice(points, 0, 1), 0)  # builds the tree and the kernel
    start = perf_counter()
    found = _join(list(_parts(points, run, estimate)))
    seconds = perf_counter() - start
    with complete_or_absent(run.output) as file:
        _WRITERS[run.output.suffix](file, Baked(run, mesh, points, found))
    return _summary(run, found, seconds)


def _check(run: Run) -> None:
    if run.output.suffix not in SUFFIXES:
        raise ValueError(f"--output: got {str(run.output)!r}, want a file that ends in one of {' '.join(SUFFIXES)}")
    check_output(run.output, "--output", run.mesh, run.environment)
    if run.at == "surface" and run.output.suffix in (".ply", ".glb"):
        raise ValueError(f"--output: got {run.output.name!r} for points, want .vtp, .npz or .csv: it holds faces")
    if (run.environment is None) == (run.quantity == "irradiance"):
        raise ValueError(f"--environment: got {run.environment} for {run.quantity}, want a picture for irradiance alone")
    check_integer(run.points, "--points", 1, 2**31 - 1)


def _check_glb(run: Run, mesh: Mesh) -> None:
    """Refuses what float32 about the middle of the mesh does not hold, or 32 bits of a file's length."""
    areas = mesh.face_areas
    change = np.abs(Mesh(_local(mesh)[0], mesh.faces).face_areas - areas)
    lost = np.count_nonzero((areas > 0.0) & (change > _KEPT * areas))
    if lost:
        raise ValueError(
            f"--output: got {run.output.name!r}, whose float32 would change the area of {lost:,} of {len(areas):,} faces by "
            f"more than {_KEPT:.0%}, want .ply or .vtp"
        )
    corners = mesh.faces.size if run.at == "faces" else len(mesh.vertices)
    if corners * _BYTES_OF_CORNER + mesh.faces.nbytes > 2**32 - 2**20:
        raise ValueError(f"--output: got {run.output.name!r} of {corners:,} corners, want .ply or .vtp: it holds 4 GiB")


def _local(mesh: Mesh) -> tuple[np.ndarray, np.ndarray]:
    """Vertices as float32, (V, 3), and the float64 translation from them to the mesh: 0 if it is not far from the origin."""
    single = mesh.vertices.astype(np.float32)
    middle = mesh.bounds.mean(axis=0)
    if np.abs(middle).max() <= mesh.diagonal or np.array_equal(single, mesh.vertices):
        return single, np.zeros(3)
    return (mesh.vertices - middle).astype(np.float32), middle


def _quantity(run: Run, mesh: Mesh) -> Callable[[SurfacePoints, int], Estimate]:
    """(points, id of the first) -> their numbers."""
    if run.quantity == "ao":
        return lambda points, first: ambient_occlusion(mesh, points, run.samples, first_point=first, **run.options)
    if run.quantity == "sky":
        return lambda points, first: sky_view_factor(mesh, points, run.samples, run.up, first_point=first, **run.options)
    path = run.environment
    picture = np.load(path) if path and path.suffix == ".npy" else read_hdr(path) if path else None
    return lambda points, first: irradiance(mesh, points, picture, run.samples, run.up, first_point=first, **run.options)


def _slice(points: SurfacePoints, first: int, count: int) -> SurfacePoints:
    rows = slice(first, first + count)
    return SurfacePoints(points.position[rows], points.normal[rows], points.face[rows])


def _parts(points: SurfacePoints, run: Run, estimate: Callable[[SurfacePoints, int], Estimate]) -> Iterator[Estimate]:
    """Part by part, with a progress bar where stderr is a terminal."""
    from rich.console import Console  # noqa: PLC0415
    from rich.progress import BarColumn, Progress, TextColumn, TimeRemainingColumn  # noqa: PLC0415

    console = Console(stderr=True)
    told = (TextColumn("{task.description}"), BarColumn(), TimeRemainingColumn(), TextColumn("{task.fields[told]}"))
    step = max(1, _RAYS_PER_PART // run.samples)
    cast, start, done = 0, perf_counter(), 0
    with Progress(*told, console=console, disable=not console.is_terminal, transient=True) as progress:
        task = progress.add_task(QUANTITIES[run.quantity], total=len(points), told="")
        try:
            for first in range(0, len(points), step):
                part = estimate(_slice(points, first, step), first)
                cast, done = cast + int(part.rays.sum()), min(first + step, len(points))
                error = float(np.sqrt(np.mean(np.square(part.standard_error))))
                speed = cast / (perf_counter() - start) / 1e6
                progress.update(task, completed=done, told=f"{speed:.1f} million rays/s, standard error {error:.2g}")
                yield part
        except KeyboardInterrupt as interrupt:  # raised again itself: it may stand for another signal
            interrupt.args = (f"interrupted after {done:,} of {len(points):,} points; {run.output} is as it was before",)
            raise


def _join(parts: list[Estimate]) -> Estimate:
    arrays = {
        item.name: np.concatenate([getattr(part, item.name) for part in parts])
        for item in fields(parts[0])
        if item.name != "skipped"
    }
    counts = {item.name: sum(getattr(part.skipped, item.name) for part in parts) for item in fields(Skipped)}
    return type(parts[0])(**arrays, skipped=Skipped(**counts))


def _summary(run: Run, found: Estimate, seconds: float) -> str:
    good = found.status == 0
    cast, skipped = int(found.rays.sum(dtype=np.int64)), found.skipped
    lines = [f"{run.output}: {QUANTITIES[run.quantity]} of {len(good):,} {'points' if run.at == 'surface' else run.at}"]
    if good.any():
        error = float(np.sqrt(np.mean(np.square(found.standard_error[good]))))
        lines.append(f"mean {found.value[good].mean():.4f}; standard error {error:.2g}, root mean square over the points")
    lines.append(f"{cast:,} rays cast in {seconds:.2f} s, {cast / max(seconds, 1e-9) / 1e6:.1f} million a second")
    told = {
        "where nothing is": skipped.empty_rays,
        "without weight": skipped.weightless_rays,
        "not needed for the tolerance": skipped.unneeded_rays,
    }
    lines.append("rays skipped: " + ", ".join(f"{n:,} {why}" for why, n in told.items() if n) if any(told.values()) else "")
    if skipped.open_points:
        lines.append(f"points that no ray was cast from: {skipped.open_points:,}")
    bad = {status: n for status, n in found.counts().items() if status != PointStatus.OK}
    if bad:
        lines.append("points without a number: " + ", ".join(f"{n:,} {status.name.lower()}" for status, n in bad.items()))
    return "\n  ".join(line for line in lines if line)


def _columns(found: Estimate) -> dict[str, np.ndarray]:
    """What is kept of each point, by name; three numbers as red, green and blue."""
    columns = {}
    for name in ("value", "standard_error"):
        array = getattr(found, name)
        split = {name: array} if array.ndim == 1 else {f"{name}_{c}": array[:, i] for i, c in enumerate("rgb")}
        columns.update(split)
    if hasattr(found, "below_horizon"):
        columns["below_horizon"] = found.below_horizon
    return {**columns, "rays": found.rays, "status": found.status}


def _colours(found: Estimate) -> np.ndarray:
    """(P, 4) uint8: black at 0, white at 1, or at the largest value if that is larger."""
    value = found.value if found.value.ndim == 2 else np.repeat(found.value[:, None], 3, axis=1)
    grey = np.clip(value / max(1.0, float(value.max(initial=0.0))), 0.0, 1.0)
    return np.column_stack([np.round(255.0 * grey), np.full(len(grey), 255.0)]).astype(np.uint8)


def _write_npz(file: BinaryIO, baked: Baked) -> None:
    points, found = baked.points, baked.found
    arrays = {"position": points.position, "normal": points.normal, "face": points.face, **_arrays(found)}
    told = {item.name: str(getattr(baked.run, item.name)) for item in fields(baked.run)}
    with zipfile.ZipFile(file, "w", allowZip64=True) as archive:
        for name, array in {**arrays, "run": np.array(json.dumps(told))}.items():
            write_array(archive, name, array)


def _arrays(found: Estimate) -> dict[str, np.ndarray]:
    return {item.name: getattr(found, item.name) for item in fields(found) if item.name != "skipped"}


def _write_csv(file: BinaryIO, baked: Baked) -> None:
    columns = _columns(baked.found)
    formats = ["%.17g"] * 3 + ["%d" if name in ("rays", "status") else "%.9g" for name in columns]
    table = np.column_stack([baked.points.position, *columns.values()])
    np.savetxt(file, table, formats, delimiter=",", header=",".join(["x", "y", "z", *columns]), comments="")


def _write_ply(file: BinaryIO, baked: Baked) -> None:
    """The numbers as properties of vertices or faces, and as colours; vertices as float32 if that is what they are."""
    vertices = baked.mesh.vertices
    single = Lazy(vertices.shape, np.dtype(np.float32), lambda i: vertices[i])
    exact = all(np.array_equal(single[i : i + 65536], vertices[i : i + 65536]) for i in range(0, len(vertices), 65536))
    elements = {"vertex": {"x y z": single if exact else vertices}, "face": {"vertex_indices": baked.mesh.faces}}
    elements["face" if baked.run.at == "faces" else "vertex"] |= {
        "red green blue alpha": _colours(baked.found),
        **_columns(baked.found),
    }
    write_ply(file, elements)


def _write_glb(file: BinaryIO, baked: Baked) -> None:
    """The numbers as attributes, which a .glb has of vertices only: of faces, each gets corners of its own."""
    local, middle = _local(baked.mesh)
    faces, times = baked.mesh.faces, 3 if baked.run.at == "faces" else 1
    corners = Lazy(faces.shape, np.dtype(np.uint32), lambda i: faces[i] if times == 1 else 3 * i[:, None] + np.arange(3))
    vertices = local if times == 1 else Lazy((faces.size, 3), local.dtype, lambda i: local[faces.ravel()[i]])
    attributes = {"COLOR_0": _repeated(_colours(baked.found), times, np.uint8)}  # others' names begin with an underscore
    attributes |= {f"_{name}": _repeated(array, times, np.float32) for name, array in _columns(baked.found).items()}
    write_glb(file, vertices, corners, attributes, tuple(middle.tolist()))


def _repeated(array: np.ndarray, times: int, dtype: type) -> Lazy:
    return Lazy((times * len(array), *array.shape[1:]), np.dtype(dtype), lambda i: array[i // times])


def _write_vtp(file: BinaryIO, baked: Baked) -> None:
    points, arrays = baked.points, _arrays(baked.found)
    if baked.run.at == "surface":
        write_vtp(file, points.position, None, {"Normals": points.normal, "face": points.face, **arrays}, {})
    else:
        data = ({}, arrays) if baked.run.at == "faces" else (arrays, {})
        write_vtp(file, baked.mesh.vertices, baked.mesh.faces, *data)


_WRITERS = {".npz": _write_npz, ".csv": _write_csv, ".ply": _write_ply, ".glb": _write_glb, ".vtp": _write_vtp}
