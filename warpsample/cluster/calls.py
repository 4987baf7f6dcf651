"""The calls of `warpsample`, lazily, over chunks of points."""

from collections.abc import Callable
from typing import Any

import xarray as xr

from warpsample.cluster.arrays import dataset_of
from warpsample.cluster.chunks import CALLS
from warpsample.cluster.job import CHUNK, job_of


def call_of(name: str) -> Callable[..., xr.Dataset]:
    """The call of a quantity over Dask.

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
"""What stands in a call's example, if not a number of points and one of rays."""

_DOCUMENTATION = """`warpsample.{name}` over Dask: the same arguments, and the same bits when it is computed.

    Each process builds one tree, and each task is done by one thread: Dask runs as many at once as it has threads. With a
    Client the mesh is sent now, once, and it is the one to compute with; it gives it again to workers that lost it. So is a
    picture; a file of one is read here. A wp.func is as for `integrate`.

    Args:
        mesh: a Mesh or whatever `as_mesh` takes.
        points: SurfacePoints; or so many, uniform by area, by the call's `seed`; or "faces" or "vertices" of the mesh. All
            but the first are made by the workers, and never stand in this process.
        *arguments: as there.
        chunk: points of a task, by which no bit changes.
        **options: as there, by name; `workers` are the threads of one task.

    Returns:
        lazy arrays by the names of an Estimate's; `position`, `normal` and `face` of the points as coordinates; and what
        repeats the run as attributes.

    Raises:
        TypeError, ValueError: an argument that cannot be used; names it, what it got and what it wants.
        MemoryError: all workers of the Client are too small; says what they want.

    Example:
        >>> from warpsample import cluster
        >>> lazy = cluster.{name}(ws.load_mesh("courtyard"), {given})
        >>> print(len(lazy.value), lazy.value.chunks[0][0])  # nothing is computed yet
        1000000 65536
    """


def integrate(points: Any, integrand: Any, *arguments: Any, chunk: int = CHUNK, **options: Any) -> xr.Dataset:
    """`warpsample.integrate` over Dask; points and chunk as for `ambient_occlusion`.

    A wp.func goes to other processes by its name: it must stand at the top of a module that they can import, and take no
    `data`. Dask's threads run any. `lobe.row` is the row in a chunk, `lobe.point` the id among all points.

    Args:
        points: as for `ambient_occlusion`.
        integrand: a `wp.func`, as `warpsample.integrate` takes it.
        *arguments: as there.
        chunk: points of a task.
        **options: as there, by name, `mesh` among them.

    Returns:
        lazy arrays, as of `ambient_occlusion`.

    Example:
        >>> from warpsample import cluster, funcs
        >>> mesh, upward = ws.load_mesh("courtyard"), funcs.square_to_cosine_hemisphere_pdf
        >>> print(cluster.integrate(ws.face_centers(mesh), upward, 64, mesh=mesh, chunk=1000).value.chunks)
        ((1000, 1000, 80),)
    """
    return dataset_of(job_of("integrate", (points, integrand, *arguments), options, chunk))


def trace(mesh: Any, origins: Any, directions: Any, *arguments: Any, chunk: int = CHUNK, **options: Any) -> xr.Dataset:
    """`warpsample.trace` over Dask; origins as the points of `ambient_occlusion`, or an array as there.

    Arrays may be Dask's or xarray's, such as the vectors of `sample_directions`.

    Args:
        mesh: a Mesh or whatever `as_mesh` takes.
        origins: as the points of `ambient_occlusion`, or (P, 3).
        directions: (P, 3) or (P, n, 3).
        *arguments: as there.
        chunk: points of a task.
        **options: as there, by name.

    Returns:
        lazy arrays `distance`, `face` and, of a mesh that light goes through, `transmitted`.

    Example:
        >>> from warpsample import cluster
        >>> rays = np.zeros((1000, 3)), np.tile([0.0, 0.0, 1.0], (1000, 1))
        >>> print(sorted(cluster.trace(ws.load_mesh("courtyard"), *rays, chunk=300).data_vars))
        ['distance', 'face']
    """
    return dataset_of(job_of("trace", (mesh, origins, directions, *arguments), options, chunk))


def sample_directions(
    normals: Any, count: int, *arguments: Any, mesh: Any = None, chunk: int = CHUNK, **options: Any
) -> xr.Dataset:
    """`warpsample.sample_directions` over Dask; normals as the points of `ambient_occlusion`, or an array as there.

    Args:
        normals: (P, 3), NumPy's or Dask's, or what `points` may be.
        count: directions per point.
        *arguments: as there.
        mesh: what points are on that the workers make.
        chunk: points of a task.
        **options: as there, by name, but `out`.

    Returns:
        lazy arrays `vectors`, `status` and, if asked for, `pdf`.

    Example:
        >>> from warpsample import cluster
        >>> print(cluster.sample_directions(np.ones((1000, 3)), 16, chunk=300).vectors.shape)
        (1000, 16, 3)
    """
    return dataset_of(job_of("sample_directions", (normals, count, *arguments), options, chunk, mesh))
