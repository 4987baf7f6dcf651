"""Numbers at the points of a mesh, into a file: `warpsample bake`."""

import json
import zipfile
from collections.abc import Callable, Iterator
from dataclasses import dataclass, fields
from pathlib import Path
from time import perf_counter
from typing import Any

import numpy as np

from warpsample.arguments import check_integer
from warpsample.estimate.irradiance import irradiance
from warpsample.estimate.picture import read_picture
from warpsample.estimate.result import Estimate, PointStatus, Skipped
from warpsample.estimate.visibility import ambient_occlusion, sky_view_factor
from warpsample.export import complete_or_absent, write_array
from warpsample.mesh import Mesh
from warpsample.mesh_files import load_mesh
from warpsample.polydata import pyvista
from warpsample.surface import SurfacePoints, face_centers, sample_surface, vertex_points

QUANTITIES = {"ao": "ambient occlusion", "sky": "sky view factor", "irradiance": "irradiance"}
PLACEMENTS = {"vertices": vertex_points, "faces": face_centers, "surface": sample_surface}
SUFFIXES = (".ply", ".vtp", ".glb", ".npz", ".csv")

_RAYS_PER_PART = 1 << 22  # half a second, after which the progress moves


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
        OSError: the file cannot be written.
    """
    _check(run)
    mesh = load_mesh(run.mesh)
    points = sample_surface(mesh, run.points, run.options["seed"]) if run.at == "surface" else PLACEMENTS[run.at](mesh)
    estimate = _quantity(run, mesh)
    estimate(_slice(points, 0, 1), 0)  # builds the tree and the kernel
    start = perf_counter()
    found = _join(list(_parts(points, run, estimate)))
    seconds = perf_counter() - start
    with complete_or_absent(run.output) as partial:
        _WRITERS[run.output.suffix](partial, Baked(run, mesh, points, found))
    return _summary(run, found, seconds)


def _check(run: Run) -> None:
    if run.output.suffix not in SUFFIXES:
        raise ValueError(f"--output: got {str(run.output)!r}, want a file that ends in one of {' '.join(SUFFIXES)}")
    if not run.output.resolve().parent.is_dir():
        raise ValueError(f"--output: got {str(run.output)!r}, whose folder does not exist")
    if run.at == "surface" and run.output.suffix in (".ply", ".glb"):
        raise ValueError(f"--output: got {run.output.name!r} for points, want .vtp, .npz or .csv: it holds faces")
    if run.output.suffix == ".vtp":
        pyvista()
    if (run.environment is None) == (run.quantity == "irradiance"):
        raise ValueError(f"--environment: got {run.environment} for {run.quantity}, want a picture for irradiance alone")
    check_integer(run.points, "--points", 1, 2**31 - 1)


def _quantity(run: Run, mesh: Mesh) -> Callable[[SurfacePoints, int], Estimate]:
    """(points, id of the first) -> their numbers."""
    if run.quantity == "ao":
        return lambda points, first: ambient_occlusion(mesh, points, run.samples, first_point=first, **run.options)
    if run.quantity == "sky":
        return lambda points, first: sky_view_factor(mesh, points, run.samples, run.up, first_point=first, **run.options)
    path = run.environment
    picture = read_picture(path) if path else None
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
        except KeyboardInterrupt:
            raise KeyboardInterrupt(
                f"interrupted after {done:,} of {len(points):,} points; {run.output} is as it was before"
            ) from None


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


def _write_npz(path: Path, baked: Baked) -> None:
    points, found = baked.points, baked.found
    arrays = {"position": points.position, "normal": points.normal, "face": points.face}
    arrays |= {item.name: getattr(found, item.name) for item in fields(found) if item.name != "skipped"}
    told = {item.name: str(getattr(baked.run, item.name)) for item in fields(baked.run)}
    with zipfile.ZipFile(path, "w", allowZip64=True) as archive:
        for name, array in {**arrays, "run": np.array(json.dumps(told))}.items():
            write_array(archive, name, array)


def _write_csv(path: Path, baked: Baked) -> None:
    columns = _columns(baked.found)
    formats = ["%.17g"] * 3 + ["%d" if name in ("rays", "status") else "%.9g" for name in columns]
    table = np.column_stack([baked.points.position, *columns.values()])
    np.savetxt(path, table, formats, delimiter=",", header=",".join(["x", "y", "z", *columns]), comments="")


def _write_mesh(path: Path, baked: Baked) -> None:
    """By trimesh: the numbers as attributes of vertices or faces, and as colours, to look at."""
    import trimesh  # noqa: PLC0415

    attributes, colours = _columns(baked.found), _colours(baked.found)
    vertices, faces, kind = baked.mesh.vertices, baked.mesh.faces, "face" if baked.run.at == "faces" else "vertex"
    if path.suffix == ".glb":  # of vertices only, as float32, and with an underscore where a name is not its own
        repeats = 3 if kind == "face" else 1
        attributes = {f"_{name}": np.repeat(array, repeats).astype(np.float32) for name, array in attributes.items()}
        if kind == "face":  # each gets corners of its own
            vertices, faces = vertices[faces].reshape(-1, 3), np.arange(faces.size).reshape(-1, 3)
            colours, kind = np.repeat(colours, 3, axis=0), "vertex"
    keywords = {f"{kind}_attributes": attributes, f"{kind}_colors": colours}
    path.write_bytes(trimesh.Trimesh(vertices, faces, process=False, **keywords).export(file_type=path.suffix[1:]))


def _write_vtp(path: Path, baked: Baked) -> None:
    at = baked.run.at
    made = baked.found.to_polydata(baked.points) if at == "surface" else baked.found.to_polydata(baked.mesh, at)
    made.save(path)


_WRITERS = {".npz": _write_npz, ".csv": _write_csv, ".ply": _write_mesh, ".glb": _write_mesh, ".vtp": _write_vtp}
