"""Jobs: function calls that are computed in chunks of points, with checked arguments and known result shapes."""

import inspect
import json
from dataclasses import dataclass
from importlib.metadata import version
from os import PathLike
from typing import Any

import numpy as np
import warp as wp
from dask.array import Array
from dask.array.core import normalize_chunks
from dask.base import tokenize

from warpsample.cluster.chunks import BY_POINT, FUNCTIONS, Call, numbers
from warpsample.cluster.named import Named, named
from warpsample.distributions import as_distribution
from warpsample.distributions.lights.environment_map import list_picture_hashes
from warpsample.distributions.record import Distribution
from warpsample.estimate.source.content import WHAT, function_content
from warpsample.host.arguments import check_first_point, check_integer, check_seed, quote
from warpsample.host.arrays import check_active
from warpsample.host.neighbours import as_ndarray
from warpsample.host.picture import read_picture
from warpsample.host.shared_values import digest_of
from warpsample.mesh.mesh import Mesh, as_mesh
from warpsample.mesh.surface import SurfacePoints
from warpsample.sequences.record import STREAMS

CHUNK = 65_536
"""Default number of points per chunk: 1 to 2 s of work for one thread at 256 rays, so a task's overhead is negligible."""

MOST_CHUNKS = 1 << 20
"""Largest number of chunks: for more, the lists of chunks and tasks take gigabytes."""

VERSIONS = ("warpsample", "warp-lang")
"""Packages whose versions results may depend on, bit for bit."""

STREAMS_OF = "streams"
"""Attribute with the version of the random streams; stores without the attribute have version 1."""

SHAPE = "shape"
"""Attribute with the digest of vertices and faces alone, if the mesh also has optical properties."""

_POINTS = "SurfacePoints, a whole number (so many, uniform by area), 'faces' or 'vertices'"
_AT = {"trace": "origins", "sample_directions": "normals"}
_OF_THE_CLIENT = ("progress", "out")
_OF_THE_WORKERS = ("workers",)


@dataclass(frozen=True)
class Job:
    """Call of a `warpsample` function over chunks of points, with checked arguments.

    Attributes:
        call: Function name and small options, sent with every task.
        shared: Large arguments, by name.
        point_arrays: Dask arrays of the points' fields by name, split into the chunks; empty if workers make the points.
        rows: Dask arrays of the arguments with a row per point by name, split into the chunks.
        total: Number of rows of all chunks.
        chunk: Number of rows per chunk; the last chunk may have fewer.
        gives: (dtype, shape of a row) of each array of the result, by name.
        about: Attributes that identify the run, as texts and numbers by name.
    """

    call: Call
    shared: dict[str, Any]
    point_arrays: dict[str, Array]
    rows: dict[str, Array]
    total: int
    chunk: int
    gives: dict[str, tuple[np.dtype, tuple[int, ...]]]
    about: dict[str, Any]

    @property
    def count(self) -> int:
        """Number of chunks into which the points are divided, at least 1."""
        return max(1, -(-self.total // self.chunk))

    def rows_of(self, index: int) -> int:
        """Return the number of points in the chunk with the given index."""
        return min(self.chunk, self.total - index * self.chunk)

    def check_count(self) -> None:
        """Raise an error if the job has more than MOST_CHUNKS chunks.

        Raises:
            ValueError: if there are too many chunks. The message states the smallest `chunk` that is allowed.
        """
        if self.count > MOST_CHUNKS:
            raise ValueError(
                f"chunk: got {self.chunk:,} of {self.total:,} points, which makes {self.count:,} chunks, want at least "
                f"{-(-self.total // MOST_CHUNKS):,} points per chunk, for at most {MOST_CHUNKS:,} chunks"
            )

    @property
    def token(self) -> str:
        """Hash of the call, used in the names of the job's Dask tasks; equal calls have equal hashes."""
        return str(
            tokenize(self.call, self.about, [array.name for array in (*self.point_arrays.values(), *self.rows.values())])
        )


def job_of(name: str, arguments: tuple[Any, ...], options: dict[str, Any], chunk: Any, on: Any = None) -> Job:
    """Check the arguments of a function, and build the `Job` that computes the function in chunks of points.

    Args:
        name: Name of the call, a key of FUNCTIONS.
        arguments: Positional arguments of the call.
        options: Keyword arguments of the call.
        chunk: Number of points per chunk.
        on: Mesh of the points, for functions that have no argument `mesh`. Default: None.

    Raises:
        TypeError, ValueError: an argument that cannot be used; the message names the argument.
    """
    bound = inspect.signature(FUNCTIONS[name]).bind(*arguments, **options)
    bound.apply_defaults()
    taken, chunk = dict(bound.arguments), check_integer(chunk, "chunk", 1, 2**31 - 1)
    for unwanted in _OF_THE_CLIENT:
        if not isinstance(value := taken.pop(unwanted, None), bool | None) or value:
            raise ValueError(
                f"{unwanted}: got a value for a call over Dask, want none; Dask allocates the arrays and shows the progress"
            )
    shared = _pop_large_arguments(taken, on)
    at, seed = _AT.get(name, "points"), check_seed(taken.get("seed", 0))
    place, total, given = _find_placement(taken[at], at, shared.get("mesh"))
    rows = _pop_rows(taken, [*([] if place else [at]), "directions"])
    if not place and not rows:
        raise TypeError(f"{at}: got {quote(taken[at])}, want {_POINTS}, or an array (P, 3)")
    total = total if place else len(next(iter(rows.values())))
    if taken.pop("active", None) is not None:
        rows["active"] = check_active(bound.arguments["active"], total).view(np.bool_)
    rows |= _rows_of_parameters(taken)
    for argument, array in rows.items():
        if len(array) != total:
            raise ValueError(f"{argument}: got {len(array):,} rows, want {total:,}, one for each point")
    first = check_first_point(taken.get("first_point", 0), max(total, 1), given.get("id"))
    if place:
        taken.pop(at)
    taken |= _read_pictures(taken.get("distribution"))
    taken = {argument: named(argument, value, taken.get("integrand")) for argument, value in taken.items()}
    call = Call(name, taken, tuple(shared), tuple(rows), at if place else None, place or "", tuple(given), seed, first)
    about = _identify_run(call, {**shared, **given, **rows}, total, chunk)
    given, rows = ({key: _split_into_chunks(array, chunk, key) for key, array in arrays.items()} for arrays in (given, rows))
    return Job(call, shared, given, rows, total, min(chunk, max(total, 1)), _result_types(call, shared, rows), about)


def _pop_large_arguments(taken: dict[str, Any], on: Any) -> dict[str, Any]:
    """Move the large arguments, mesh and picture, from the arguments of a call to a new dictionary, and return it.

    A mesh is converted to a Mesh. A picture is read or copied, so that later changes of the caller's array have no effect.
    """
    shared, mesh = {}, taken.pop("mesh", on)
    if mesh is not None:
        shared["mesh"] = as_mesh(mesh)
    radiance = taken.get("radiance")
    if radiance is not None and not isinstance(radiance, wp.Function):
        path = isinstance(radiance, str | PathLike)
        shared["radiance"] = read_picture(radiance) if path else np.array(as_ndarray(radiance, "radiance"))
        taken.pop("radiance")
    return shared


def _read_pictures(distribution: Any) -> dict[str, Distribution]:
    """Convert a text that names a picture, "environment_map('sky.hdr')", to {"distribution": lobe}; other values to {}."""
    made = as_distribution(distribution) if isinstance(distribution, str) else None
    return {} if made is None or not list_picture_hashes(made) else {"distribution": made}


def _find_placement(points: Any, at: str, mesh: Mesh | None) -> tuple[str | None, int, dict[str, Any]]:
    """Return (how points are placed, number of points, arrays of given points) for the argument `points` of a call.

    The result is (None, 0, {}) if the argument is an array of rows and not one of the kinds of points.

    Raises:
        TypeError, ValueError: if the argument is none of the accepted kinds of points, or there is no mesh to place
            points on.
    """
    if isinstance(points, SurfacePoints):
        given = {name: getattr(points, name) for name in ("position", "normal", "face", "id", "raised", "tangent")}
        return "given", len(points), {name: array for name, array in given.items() if array is not None}
    named = isinstance(points, str)
    if at == "points" and not named and mesh is not None and not _is_integer(points):
        raise TypeError(f"{at}: got {quote(points)}, want {_POINTS}")
    if not named and not _is_integer(points):
        return None, 0, {}
    if named and points not in ("faces", "vertices"):
        raise ValueError(f"{at}: got {quote(points)}, want {_POINTS}")
    if mesh is None:
        raise ValueError(f"mesh: got None, want the mesh of {at}={quote(points)}")
    if named:
        return points, len(getattr(mesh, points)), {}
    return "area", check_integer(points, at, 1, 2**62), {}


def _is_integer(value: Any) -> bool:
    """Return whether a value is an integer, and neither a bool nor an array.

    Arrays of Dask, PyTorch and JAX have an `__index__` too, and are not accepted.
    """
    return hasattr(value, "__index__") and not isinstance(value, bool | np.ndarray) and not getattr(value, "ndim", 0)


def _pop_rows(taken: dict[str, Any], names: list[str]) -> dict[str, Any]:
    """Move the arrays with one row per point from the arguments of a call to a new dictionary, and return it.

    A one-dimensional array stays in the arguments: it is one origin for all rays.
    """
    rows = {}
    for name in names:
        if name in taken:
            value = getattr(taken[name], "data", None) if hasattr(taken[name], "dims") else taken[name]  # of xarray
            array = value if isinstance(value, Array) else as_ndarray(value, name, "an array of rows")
            if array.ndim > 1:
                taken.pop(name)
                rows[name] = array
    return rows


def _rows_of_parameters(taken: dict[str, Any]) -> dict[str, np.ndarray]:
    """Return the distribution parameters that have one row per point, keyed by name, and remove the rows from the call."""
    distribution = taken.get("distribution")
    if not isinstance(distribution, Distribution) or not distribution.by_point:
        return {}
    taken["distribution"] = distribution.take(slice(0, 0))
    return {f"{BY_POINT}{name}": table for name, table in distribution.by_point.items()}


def _split_into_chunks(array: Any, chunk: int, argument: str) -> Array:
    """Return a Dask array split into chunks of rows; a NumPy array is copied first, if the caller can change it.

    `dask.array.from_array` copies every array, also the read-only arrays of a distribution.
    """
    wanted = (chunk, *array.shape[1:])
    if isinstance(array, Array):
        return array.rechunk(wanted)
    name, chunks = _identify_content(array, chunk), normalize_chunks(wanted, array.shape)
    own = array if argument.startswith(BY_POINT) and not array.flags.writeable else array.copy()
    zeros = (0,) * (array.ndim - 1)
    parts = {(name, i, *zeros): own[i * chunk : (i + 1) * chunk] for i in range(len(chunks[0]))}
    return Array(parts, name, chunks, dtype=array.dtype)


def _identify_content(value: Any, *more: Any) -> str:
    """Return a text that identifies the content of a large argument.

    Args:
        value: Mesh, Dask array, or array. A Dask array is identified by its name.
        *more: Further values to include in the text.
    """
    if isinstance(value, Mesh):
        return value.digest
    if isinstance(value, Array):
        return value.name
    return f"{digest_of(value)}{''.join(f'-{tokenize(item)}' for item in more)}"


def _result_types(call: Call, shared: dict[str, Any], rows: dict[str, Array]) -> dict[str, tuple[np.dtype, tuple[int, ...]]]:
    """Return the dtype and row shape of each result array, keyed by name, by calling the function without points.

    The call checks all remaining arguments. A triangle replaces the mesh. `sample_directions` is called with one point.
    """
    points = int(call.name == "sample_directions")
    few = SurfacePoints(np.zeros((points, 3)), np.tile(np.float32([0.0, 0.0, 1.0]), (points, 1)))
    parts = [np.ones((points, *array.shape[1:]), array.dtype) for array in rows.values()]
    found = numbers(
        call, 0, few, [_one_triangle(value) if name == "mesh" else value for name, value in shared.items()], parts
    )
    return {name: (array.dtype, array.shape[1:]) for name, array in found.items() if isinstance(array, np.ndarray)}


def _one_triangle(mesh: Mesh) -> Mesh:
    """Return a mesh of one triangle with the same kinds of optical properties as `mesh`, for a trial call."""
    optics = {"transmittance": 0.5 * mesh.transmits, "reflectance": 0.5 * mesh.reflects}
    return Mesh(np.eye(3), [[0, 1, 2]], **{name: share for name, share in optics.items() if share})


def _identify_run(call: Call, large: dict[str, Any], total: int, chunk: int) -> dict[str, Any]:
    """Return the attributes that identify a computation: its arguments, with hashes in place of large ones."""
    options = {name: value for name, value in call.options.items() if name not in _OF_THE_WORKERS}
    mesh = large.get("mesh")
    shape = None if mesh is None else digest_of(mesh.vertices, mesh.faces)
    distribution = options.get("distribution")
    pictures = list_picture_hashes(distribution) if isinstance(distribution, Distribution) else []
    return {
        "call": call.name,
        **({} if mesh is None or shape == mesh.digest else {SHAPE: shape}),
        **{name: _convert_for_json(value) for name, value in options.items()},
        **{name: _identify_content(value) for name, value in large.items()},
        **({"pictures": pictures} if pictures else {}),
        "place": call.place,
        "points": total,
        "chunk": chunk,
        STREAMS_OF: STREAMS,
        **{name: version(name) for name in VERSIONS},
    }


def _identify_distribution(distribution: Distribution) -> dict[str, Any]:
    """Return the parameters and functions that identify a distribution with user-defined parts, by name."""
    maps = [lobe.maps for lobe in _user_lobes(distribution)]
    functions = (f for m in maps for f in (m.sample, m.pdf, m.about, m.redraw) if f is not None)
    contents = {name: content for function in functions for name, content in function_content(function).items()}
    return {**contents, WHAT: str(distribution)}


def _user_lobes(distribution: Any) -> list[Distribution]:
    """Return the user-defined distributions among a distribution and its nested lobes."""
    own = [] if type(distribution).__module__.startswith("warpsample.") else [distribution]
    return own + [found for lobe in distribution.nested.values() for found in _user_lobes(lobe)]


def _convert_for_json(value: Any) -> Any:
    """Convert a value to a form that JSON can store; a value of any other type becomes text."""
    if isinstance(value, Named):
        return value.content
    if isinstance(value, Distribution) and _user_lobes(value):
        return _identify_distribution(value)
    if isinstance(value, np.ndarray | np.generic | tuple | list):
        value = np.asarray(value).tolist()
    try:
        json.dumps(value)
    except (TypeError, ValueError):
        return str(value)
    return value
