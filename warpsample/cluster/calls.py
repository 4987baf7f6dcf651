"""Lazy versions of the functions of `warpsample`, which Dask computes in chunks of points."""

from collections.abc import Callable
from typing import Any

import xarray as xr
from typing_extensions import Unpack

from warpsample.cluster.arrays import dataset_of
from warpsample.cluster.chunks import CALLS
from warpsample.cluster.job import CHUNK, job_of
from warpsample.distributions.cosine_hemisphere import CosineHemisphere
from warpsample.distributions.record import Distribution
from warpsample.host.options import PointKeywords, RayKeywords, SeedKeywords


class ChunkKeywords(RayKeywords, total=False):
    """Keyword options of all lazy functions, which Dask computes in chunks of points."""

    chunk: int
    """Number of points of a task, an integer; results do not depend on it. Default: 65536."""


class LazyKeywords(ChunkKeywords, total=False):
    """Keyword options of lazy functions that cast rays, with a largest distance."""

    max_distance: float | None
    """Distance from which on hits are ignored, a float in mesh units. Default: None, no limit."""


class DirectionKeywords(SeedKeywords, PointKeywords, total=False):
    """Keyword options of the lazy `sample_directions`."""

    sequence: str
    """Sequence of the points of the square, a name in `warpsample.sequences.names()`. Default: "sobol"."""
    device: Any
    """Warp device of the workers, such as "cuda:0". Default: None, the CPU."""


def call_of(name: str) -> Callable[..., xr.Dataset]:
    """Build the lazy version of a quantity's function, which returns Dask arrays.

    Raises:
        AttributeError: no quantity has a call of that name.
    """
    if name not in CALLS:
        raise AttributeError(f"module 'warpsample.cluster' has no attribute {name!r}")

    def call(mesh: Any, points: Any, *arguments: Any, chunk: int = CHUNK, **options: Any) -> xr.Dataset:
        return dataset_of(job_of(name, (mesh, points, *arguments), options, chunk))

    call.__name__ = call.__qualname__ = name
    call.__doc__ = _DOCUMENTATION.format(name=name, given=_GIVEN.get(name, "10**6, 64"))
    return call


_GIVEN = {"irradiance": "10**6, np.ones((16, 32, 3)), 64"}
"""Arguments in the example of a call after the mesh, where not a number of points and a number of rays."""

_DOCUMENTATION = """Compute `warpsample.{name}` lazily over Dask, with the same bits.

    Each process builds one tree for the mesh, and each task has one thread. The mesh and a picture are sent to the Client
    during the call, and again to workers that lose their copy. A wp.func must meet the conditions of `integrate`.

    Args:
        mesh: Mesh or anything that `as_mesh` accepts.
        points: SurfacePoints, or points that the workers make: a number of points, placed uniformly by area with `seed`,
            or "faces" or "vertices" of the mesh.
        *arguments: Other arguments of `warpsample.{name}` by position, such as `count`.
        chunk: Number of points of a task, an integer. Results without `tolerance` do not depend on it. Default: 65536.
        **options: Options of `warpsample.{name}`. `workers` is the number of threads per task, 1 by default.

    Returns:
        dataset of lazy arrays, named as the fields of the result of `warpsample.{name}`. `position`, `normal` and `face`
        of the points are coordinates. The attributes identify the run.

    Raises:
        TypeError, ValueError: an argument that cannot be used; the message names the argument.
        MemoryError: all workers of the Client are too small; the message states the memory that each needs.

    Example:
        >>> from warpsample import cluster
        >>> lazy = cluster.{name}(ws.load_mesh("courtyard"), {given})
        >>> print(len(lazy.value), lazy.value.chunks[0][0])  # nothing is computed yet
        1000000 65536
    """


def integrate(
    points: Any,
    integrand: Any,
    count: int = 256,
    *,
    data: Any = None,
    distribution: Distribution | str = CosineHemisphere(),
    mesh: Any = None,
    **options: Unpack[LazyKeywords],
) -> xr.Dataset:
    """Compute `warpsample.integrate` lazily with Dask, in chunks of points.

    Dask's threads run any function. Other processes import a wp.func by name: the function must be at the top level of a
    module that the workers can import, and `data` cannot be used. `lobe.row` is the row in a chunk, `lobe.point` the id
    among all points.

    Args:
        points: Points, as for `ambient_occlusion`.
        integrand: A `wp.func`, as for `warpsample.integrate`.
        count: Number of directions per point. Default: 256.
        data: Instance of a wp.struct, for Dask's threads. Default: None.
        distribution: Distribution of the directions, or its name. Default: CosineHemisphere(method="polar").
        mesh: Mesh, or anything that `as_mesh` accepts, that blocks directions. Default: None, nothing is blocked.
        **options: `chunk`, `max_distance` and the options from `sequence` to `workers`, as for `warpsample.integrate`.

    Returns:
        dataset of lazy arrays, as for `ambient_occlusion`.

    Example:
        >>> from warpsample import cluster, funcs
        >>> mesh, upward = ws.load_mesh("courtyard"), funcs.square_to_cosine_hemisphere_pdf
        >>> print(cluster.integrate(ws.face_centers(mesh), upward, 64, mesh=mesh, chunk=1000).value.chunks)
        ((1000, 1000, 80),)
    """
    chunk, own = options.pop("chunk", CHUNK), {"data": data, "distribution": distribution, "mesh": mesh}
    return dataset_of(job_of("integrate", (points, integrand, count), own | options, chunk))


def trace(
    mesh: Any,
    origins: Any,
    directions: Any,
    *,
    max_distance: float | None = None,
    any_hit: bool = False,
    tracer: str = "auto",
    device: Any = None,
    workers: int | None = None,
    chunk: int = CHUNK,
) -> xr.Dataset:
    """Compute `warpsample.trace` lazily over Dask; arrays may be from NumPy, Dask or xarray.

    Args:
        mesh: Mesh or anything that `as_mesh` accepts.
        origins: (P, 3) array of origins, or points as for `ambient_occlusion`.
        directions: (P, 3) or (P, n, 3) array of directions.
        max_distance: Distance from which on hits are ignored, a float in mesh units. Default: None, no limit.
        any_hit: Whether to find any face in place of the nearest. Default: False.
        tracer: Tracer, "wide", "warp" (`wp.Mesh`, skips no rays) or "auto": wide on the CPU, warp on CUDA. Default: "auto".
        device: Warp device of the workers, such as "cuda:0". Default: None, the CPU.
        workers: Number of threads of a task. Default: None, 1.
        chunk: Number of points of a task. Default: 65536.

    Returns:
        dataset of lazy arrays `distance`, `face` and, if the mesh transmits light, `transmitted`.

    Example:
        >>> from warpsample import cluster
        >>> rays = np.zeros((1000, 3)), np.tile([0.0, 0.0, 1.0], (1000, 1))
        >>> print(sorted(cluster.trace(ws.load_mesh("courtyard"), *rays, chunk=300).data_vars))
        ['distance', 'face']
    """
    how = {"max_distance": max_distance, "any_hit": any_hit, "tracer": tracer, "device": device, "workers": workers}
    return dataset_of(job_of("trace", (mesh, origins, directions), how, chunk))


def sample_directions(
    normals: Any,
    count: int,
    *,
    distribution: Distribution | str = CosineHemisphere(),
    pdf: bool = False,
    mesh: Any = None,
    chunk: int = CHUNK,
    **options: Unpack[DirectionKeywords],
) -> xr.Dataset:
    """Compute `warpsample.sample_directions` lazily over Dask.

    Args:
        normals: (P, 3) array from NumPy or Dask, or points as for `ambient_occlusion`.
        count: Number of directions per point.
        distribution: Distribution of the directions, or its name. Default: CosineHemisphere(method="polar").
        pdf: Whether to return the density of each direction. Default: False.
        mesh: Mesh on which the workers make points, if `normals` are not an array. Default: None.
        chunk: Number of points of a task. Default: 65536.
        **options: `sequence`, `seed`, `first_point`, `active`, `device`, `workers`, as for `warpsample.sample_directions`.

    Returns:
        dataset of lazy arrays `vectors`, `status` and, with `pdf=True`, `pdf`.

    Example:
        >>> from warpsample import cluster
        >>> print(cluster.sample_directions(np.ones((1000, 3)), 16, chunk=300).vectors.shape)
        (1000, 16, 3)
    """
    how = {"distribution": distribution, "pdf": pdf, **options}
    return dataset_of(job_of("sample_directions", (normals, count), how, chunk, mesh))
