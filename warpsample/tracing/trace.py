"""The call `trace`: it checks, chooses the tracer, and gives back the kind of arrays it was given."""

from dataclasses import dataclass
from functools import cached_property
from math import inf, prod
from typing import Any

import numpy as np
import warp as wp

from warpsample.host.arguments import check_choice, check_flag, check_number
from warpsample.host.arrays import Array, address_of, as_ndarray, cpu, kind_told
from warpsample.host.engine import check_memory, check_workers, run
from warpsample.host.progress import bar
from warpsample.mesh.mesh import Mesh, as_mesh, unit_or_zero
from warpsample.mesh.surface import SurfacePoints
from warpsample.tracing.builtin import builtin_query, prepare_builtin
from warpsample.tracing.order import order_of
from warpsample.tracing.rays import Job, ray_kernel
from warpsample.tracing.scene import Scene, scene_of
from warpsample.tracing.starts import starts_of
from warpsample.tracing.wide.layout import CHUNK, AcceleratorJob
from warpsample.tracing.wide.prepare import prepare_wide
from warpsample.tracing.wide.query import wide_query

TRACERS = ("wide", "warp")
"""The 16-wide tree, on the CPU; wp.Mesh, anywhere."""

MANY_FACES = 1 << 18
"""From which on the order of points matters: smaller trees are in the cache wherever a ray is."""

RAY_WORK = 64
"""Directions that take as long to sample as a ray to trace."""

_MOST_DISTANCE = float(np.finfo(np.float32).max)  # what is farther is not met: its distance would not be finite

_DOUBLE = {np.float32: False, np.float64: True, wp.vec3: False, wp.vec3d: True, wp.float32: False, wp.float64: True}


@dataclass(frozen=True, eq=False)
class Hits:
    """What rays met; NumPy or Warp arrays, as the rays were.

    Attributes:
        distance: float32, one for each ray, in units of the mesh's coordinates: to the nearest face, or with any_hit to some
            face; inf where there is none; NaN where the ray is none (see `invalid`).
        face: int32, the number of that face, -1 where there is none.
        tracer: "wide" or "warp".
    """

    distance: Array
    face: Array
    tracer: str

    @cached_property
    def invalid(self) -> int:
        """How many rays have a zero direction, or an origin or a direction that is not finite."""
        distance = self.distance.numpy() if isinstance(self.distance, wp.array) else self.distance
        return int(np.count_nonzero(np.isnan(distance)))


def trace(
    mesh: Any,
    origins: Any,
    directions: Any,
    max_distance: float | None = None,
    any_hit: bool = False,
    tracer: str = "auto",
    workers: int | None = None,
    progress: bool = False,
) -> Hits:
    """The faces that rays meet, seen from either side.

    A ray on an edge meets at least one of the faces there. Which rays are together and how many threads there are changes no
    bit of the answers. The tree is built at the first call and kept while the Mesh lives: to trace again, pass a Mesh (see
    `as_mesh`), not vertices and faces. The first call ever compiles for about 6 s; compiled kernels are cached on disk.

    Args:
        mesh: a Mesh or whatever `as_mesh` takes.
        origins: (P, 3) float32 or float64, in the coordinates of the mesh; or (3,), one for all rays; or SurfacePoints,
            which are moved off their face, to the side of each direction, by two millionths of the mesh's extent that way,
            and at an edge or a corner towards the middle of their face, off the others (see `ambient_occlusion`). Others
            are taken as they are; a face at distance 0 is not met, but rounding may bring it in front. From farther than
            some 10^9 times the mesh's size, float64 does not tell where a ray goes: it meets nothing.
        directions: (P, 3), one for each origin, or (P, n, 3), n for each; of any length.
        max_distance: meets only what is nearer, in units of the coordinates; in any case than float32 has distances, 3e38.
        any_hit: whether some face is enough: up to twice as fast.
        tracer: "wide", "warp" (wp.Mesh) or "auto": wide on the CPU.
        workers: threads on the CPU, all cores by default.
        progress: whether to show a bar, on a terminal or in a notebook; changes no bit.

    Returns:
        distance, at least 0 and inf where nothing is met, and face, -1 there; of the directions' shape without the last
        axis.

    Raises:
        TypeError, ValueError: an argument that cannot be used; names it, what it got and what it wants.
        MemoryError: more than is free.

    Example:
        >>> mesh = ws.load_mesh("courtyard")
        >>> hits = ws.trace(mesh, np.array([36.0, 36.0, 100.0]), np.array([[0.0, 0.0, -1.0], [0.0, 0.0, 1.0]]))
        >>> print(hits.distance, hits.face >= 0)  # down into the yard, up into the sky
        [100.  inf] [ True False]
    """
    mesh, workers = as_mesh(mesh), check_workers(workers)
    any_hit, progress = check_flag(any_hit, "any_hit"), check_flag(progress, "progress")
    start = Triples.of(origins.position if isinstance(origins, SurfacePoints) else origins, "origins", "(P, 3) or (3,)")
    way = Triples.of(directions, "directions", "(P, 3) or (P, n, 3)")
    _check_pair(start, way)
    reach = inf if max_distance is None else check_number(max_distance, "max_distance", 0.0, inf)
    reach = min(reach, _MOST_DISTANCE)
    name = check_tracer(tracer, way.device)
    own, normals = faces_and_normals(mesh, origins) if isinstance(origins, SurfacePoints) else (None, None)
    rays = prod(way.shape)
    if way.device.is_cpu:
        check_memory(8 * rays, f"the hits of {rays:,} rays", "trace them in parts")
    distance, face = way.empty(np.float32), way.empty(np.int32)
    if rays == 0:
        return Hits(distance, face, name)
    with bar(progress, "tracing rays"):
        scene = scene_of(mesh)
        job = job_of(scene, start, way, reach, distance, face)
        if normals is not None:
            job.normals = normals.ctypes.data
            if name == "wide":
                starts = starts_of(scene, job, own, None, scene.tree(workers).accelerator(), workers)
                job.starts = starts.ctypes.data
        answer(scene, job, name, any_hit, way.device, workers)
    return Hits(distance, face, name)


def answer(scene: Scene, job: Job, tracer: str, any_hit: bool, device: wp.Device, workers: int) -> None:
    """Runs a job.

    Args:
        scene: what its rays are traced against.
        job: without order and block; counts what is visited if it says where.
        tracer: "wide" or "warp".
        any_hit: whether some face is enough.
        device: where the job's addresses are.
        workers: threads.
    """
    if tracer == "wide":
        tree = scene.tree(workers)
        kernel, accelerator = ray_kernel(prepare_wide, wide_query(any_hit)), tree.accelerator()
    else:
        kernel, accelerator = ray_kernel(prepare_builtin, builtin_query), scene.builtin(device)
        widen_lift(job)
    order = order_of(job, workers) if device.is_cpu and len(scene.faces) >= MANY_FACES else None
    job.order = 0 if order is None else order.ctypes.data
    run_rays(kernel, accelerator, job, device, workers)


def widen_lift(job: Job) -> None:
    """Moves points off as if the mesh were as large in all directions: wp.Mesh tells distances to needles that badly."""
    job.extent_x = job.extent_y = job.extent_z = 1.0


def run_rays(kernel: wp.Kernel, accelerator: AcceleratorJob, job: Job, device: wp.Device, workers: int) -> None:
    """Runs a job's rays through a kernel of `ray_kernel`."""
    rays = job.points * job.count
    job.block = CHUNK if device.is_cpu else 1  # so that neighbouring threads trace neighbouring rays
    run(kernel, -(-rays // job.block), [job, accelerator], device, workers, RAY_WORK * rays)


@dataclass(frozen=True, eq=False)
class Triples:
    """An array of points or directions, as it is given: float32 or float64."""

    owner: Array
    shape: tuple[int, ...]
    double: bool
    device: wp.Device

    @classmethod
    def of(cls, value: Any, argument: str, shape: str = "(..., 3)") -> "Triples":
        """`value`, copied only where it is not contiguous.

        Raises:
            TypeError, ValueError: not triples of floating-point numbers; names the argument.
        """
        if isinstance(value, wp.array):
            vectors = value.dtype in (wp.vec3, wp.vec3d)
            if value.dtype not in _DOUBLE or not (vectors or value.shape[-1] == 3):
                raise TypeError(
                    f"{argument}: got a wp.array of {value.dtype.__name__} with shape {value.shape}, "
                    "want vec3, vec3d, or float32 or float64 with a last axis of 3"
                )
            if not value.is_contiguous:
                raise ValueError(f"{argument}: got a wp.array that is not contiguous, want a contiguous one")
            return cls(value, value.shape if vectors else value.shape[:-1], _DOUBLE[value.dtype], value.device)
        array = as_ndarray(value, argument)
        if array.dtype not in (np.float32, np.float64):
            raise TypeError(f"{argument}: got dtype {array.dtype}, want float32 or float64")
        if array.ndim == 0 or array.shape[-1] != 3:
            raise ValueError(f"{argument}: got shape {array.shape}, want {shape}")
        return cls(np.ascontiguousarray(array), array.shape[:-1], _DOUBLE[array.dtype.type], cpu())

    def empty(self, dtype: Any) -> Array:
        """Uninitialised numbers, one for each vector, of the same kind and in the same place."""
        if isinstance(self.owner, wp.array):
            return wp.empty(self.shape, dtype=wp.dtype_from_numpy(dtype), device=self.device)
        return np.empty(self.shape, dtype)


def job_of(scene: Scene, start: Triples, way: Triples, reach: float, distance: Array, face: Array) -> Job:
    """A job for `answer`: rays from each of `start`, and where to write. It holds addresses: the caller keeps the arrays.

    Args:
        scene: what they are traced against.
        start: P origins, at least 1.
        way: P directions, or n for each.
        reach: in the user's units.
        distance: float32, one for each direction.
        face: int32.
    """
    points = prod(start.shape)
    return Job(
        points=points,
        count=prod(way.shape) // points,
        double_origins=start.double,
        double_directions=way.double,
        origins=address_of(start.owner),
        directions=address_of(way.owner),
        centre_x=scene.centre[0],
        centre_y=scene.centre[1],
        centre_z=scene.centre[2],
        scale=scene.scale,
        extent_x=scene.extent[0],
        extent_y=scene.extent[1],
        extent_z=scene.extent[2],
        coarseness=_coarseness(scene, start.double),
        unit=1.0 / scene.scale,
        reach=reach * scene.scale,
        distance=address_of(distance),
        face=address_of(face),
    )


def _coarseness(scene: Scene, double: bool) -> float:
    """Two spacings of the user's numbers at the mesh, in the scene's coordinates."""
    largest = np.max(np.abs(scene.centre)) + np.max(scene.spread) / scene.scale
    return 2.0 * float(np.spacing((np.float64 if double else np.float32)(largest))) * scene.scale


def _check_pair(start: Triples, way: Triples) -> None:
    if way.shape[: len(start.shape)] != start.shape or len(way.shape) - len(start.shape) > 1:
        raise ValueError(
            f"directions: got shape {(*way.shape, 3)}, want {(*start.shape, 3)} or {(*start.shape, 'n', 3)}, "
            "as there are origins"
        )
    if start.device != way.device or isinstance(start.owner, wp.array) != isinstance(way.owner, wp.array):
        raise ValueError(
            f"directions: got {kind_told(way.owner)} on {way.device}, "
            f"want {kind_told(start.owner)} on {start.device}, as the origins are"
        )


def check_tracer(tracer: Any, device: wp.Device) -> str:
    """The tracer to use on a device.

    Raises:
        TypeError, ValueError: no tracer, or none of that device's.
    """
    check_choice(tracer, "tracer", ("auto", *TRACERS))
    if tracer == "wide" and not device.is_cpu:
        raise ValueError(f"tracer: got 'wide' for rays on {device}, want 'warp' or 'auto': the wide tree is for the CPU")
    return tracer if tracer != "auto" else ("wide" if device.is_cpu else "warp")


def faces_and_normals(mesh: Mesh, points: SurfacePoints, argument: str = "origins") -> tuple[np.ndarray, np.ndarray]:
    """(P,) int32, a copy of the points' faces; and (P, 3) float32, unit or zero, the normals of these, else the points' own.

    Raises:
        ValueError: a face that the mesh has not; names the argument.
    """
    face = np.array(points.face, np.int32, order="C")
    if face.size and not (face.min() >= -1 and face.max() < len(mesh.faces)):
        raise ValueError(
            f"{argument}: got points on faces {face.min()} to {face.max()}, want -1 (none) to {len(mesh.faces) - 1}"
        )
    normals = mesh.face_normals[face]
    alone = np.flatnonzero(face < 0)
    if len(alone):
        own = np.asarray(points.normal, np.float64)[alone]
        normals[alone] = unit_or_zero(np.where(np.isfinite(own).all(axis=1, keepdims=True), own, 0.0))
    return face, normals
