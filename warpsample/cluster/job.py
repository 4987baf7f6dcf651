"""A call over chunks, checked before anything runs: what each chunk takes, and the shapes of what it gives."""

import inspect
import json
from dataclasses import dataclass
from importlib.metadata import version
from os import PathLike
from typing import Any

import numpy as np
import warp as wp
from dask.array import Array, from_array
from dask.base import tokenize

from warpsample.cluster.chunks import FUNCTIONS, Call, numbers
from warpsample.cluster.named import Named, named
from warpsample.distributions.record import Distribution
from warpsample.estimate.source.content import WHAT, function_content
from warpsample.host.arguments import check_first_point, check_integer, check_seed, told
from warpsample.host.arrays import check_active
from warpsample.host.known import digest_of
from warpsample.host.neighbours import as_ndarray
from warpsample.host.picture import read_picture
from warpsample.mesh.mesh import Mesh, as_mesh
from warpsample.mesh.surface import SurfacePoints
from warpsample.sequences.record import STREAMS

CHUNK = 65_536
"""Points: a second or two of one thread's work by 256 rays, beside which a task's overhead is nothing."""

MOST_CHUNKS = 1 << 20
"""Beyond it the lists of chunks and tasks alone take gigabytes."""

VERSIONS = ("warpsample", "warp-lang")
"""Packages that the bits depend on."""

STREAMS_OF = "streams"
"""What the number of the streams' definition is called; stores without one are of definition 1."""

SHAPE = "shape"
"""What the digest of the vertices and faces is called, where that of the mesh has more in it."""

_POINTS = "SurfacePoints, a whole number (so many, uniform by area), 'faces' or 'vertices'"
_AT = {"trace": "origins", "sample_directions": "normals"}
_OF_THE_CLIENT = ("progress", "out")
_OF_THE_WORKERS = ("workers",)


@dataclass(frozen=True)
class Job:
    """A checked call over chunks.

    Attributes:
        call: what is alike for all chunks, and small.
        shared: the arguments that are large, by name.
        given: Dask arrays by the names of SurfacePoints' fields, cut into the chunks; empty if workers make the points.
        rows: Dask arrays by the names of arguments, cut into the chunks.
        total: how many rows all chunks have.
        chunk: how many rows each has, but the last.
        gives: (type, shape of a row) of the arrays of a result, by name.
        about: all that repeats the run, as texts and numbers.
    """

    call: Call
    shared: dict[str, Any]
    given: dict[str, Array]
    rows: dict[str, Array]
    total: int
    chunk: int
    gives: dict[str, tuple[np.dtype, tuple[int, ...]]]
    about: dict[str, Any]

    @property
    def count(self) -> int:
        """How many chunks there are; one of no row, if there is none."""
        return max(1, -(-self.total // self.chunk))

    def rows_of(self, index: int) -> int:
        """How many rows a chunk has."""
        return min(self.chunk, self.total - index * self.chunk)

    def check_count(self) -> None:
        """Refuses more chunks than Dask can keep in mind.

        Raises:
            ValueError: names the size that is enough.
        """
        if self.count > MOST_CHUNKS:
            raise ValueError(
                f"chunk: got {self.chunk:,} of {self.total:,} points, which makes {self.count:,} chunks, want at least "
                f"{-(-self.total // MOST_CHUNKS):,}: at most {MOST_CHUNKS:,} chunks"
            )

    @property
    def token(self) -> str:
        """Names the tasks: the same for the same call."""
        return str(tokenize(self.call, self.about, [array.name for array in (*self.given.values(), *self.rows.values())]))


def job_of(name: str, arguments: tuple[Any, ...], options: dict[str, Any], chunk: Any, on: Any = None) -> Job:
    """The job of a call.

    Args:
        name: of FUNCTIONS.
        arguments: as the function takes them.
        options: the same by name.
        chunk: points of a task.
        on: the mesh that points are on, for functions that take none.

    Raises:
        TypeError, ValueError: an argument that cannot be used; names it, what it got and what it wants.
    """
    bound = inspect.signature(FUNCTIONS[name]).bind(*arguments, **options)
    bound.apply_defaults()
    taken, chunk = dict(bound.arguments), check_integer(chunk, "chunk", 1, 2**31 - 1)
    for unwanted in _OF_THE_CLIENT:
        if not isinstance(value := taken.pop(unwanted, None), bool | None) or value:
            raise ValueError(f"{unwanted}: got a value for a call over Dask, want none: its arrays and bars are Dask's")
    shared = _shared(taken, on)
    at, seed = _AT.get(name, "points"), check_seed(taken.get("seed", 0))
    place, total, given = _place(taken[at], at, shared.get("mesh"))
    rows = _rows(taken, [*([] if place else [at]), "directions"])
    if not place and not rows:
        raise TypeError(f"{at}: got {told(taken[at])}, want {_POINTS}, or an array (P, 3)")
    total = total if place else len(next(iter(rows.values())))
    if taken.pop("active", None) is not None:
        rows["active"] = check_active(bound.arguments["active"], total).view(np.bool_)
    for argument, array in rows.items():
        if len(array) != total:
            raise ValueError(f"{argument}: got {len(array):,} rows, want {total:,}, one for each point")
    first = check_first_point(taken.get("first_point", 0), max(total, 1), given.get("id"))
    if place:
        taken.pop(at)
    taken = {argument: named(argument, value, taken.get("integrand")) for argument, value in taken.items()}
    call = Call(name, taken, tuple(shared), tuple(rows), at if place else None, place or "", tuple(given), seed, first)
    about = _about(call, {**shared, **given, **rows}, total, chunk)
    given, rows = ({key: _cut(array, chunk) for key, array in arrays.items()} for arrays in (given, rows))
    return Job(call, shared, given, rows, total, min(chunk, max(total, 1)), _gives(call, shared, rows), about)


def _shared(taken: dict[str, Any], on: Any) -> dict[str, Any]:
    """The mesh and the picture of a call, which are taken out; both are our own."""
    shared, mesh = {}, taken.pop("mesh", on)
    if mesh is not None:
        shared["mesh"] = as_mesh(mesh)
    radiance = taken.get("radiance")
    if radiance is not None and not isinstance(radiance, wp.Function):
        path = isinstance(radiance, str | PathLike)
        shared["radiance"] = read_picture(radiance) if path else np.array(as_ndarray(radiance, "radiance"))
        taken.pop("radiance")
    return shared


def _place(points: Any, at: str, mesh: Mesh | None) -> tuple[str | None, int, dict[str, Any]]:
    """Where SurfacePoints are, how many, and their arrays if they are given; None for what is no SurfacePoints."""
    if isinstance(points, SurfacePoints):
        given = {name: getattr(points, name) for name in ("position", "normal", "face", "id", "raised")}
        return "given", len(points), {name: array for name, array in given.items() if array is not None}
    named = isinstance(points, str)
    if at == "points" and not named and mesh is not None and not _whole(points):
        raise TypeError(f"{at}: got {told(points)}, want {_POINTS}")
    if not named and not _whole(points):
        return None, 0, {}
    if named and points not in ("faces", "vertices"):
        raise ValueError(f"{at}: got {told(points)}, want {_POINTS}")
    if mesh is None:
        raise ValueError(f"mesh: got None, want the mesh of {at}={told(points)}")
    if named:
        return points, len(getattr(mesh, points)), {}
    return "area", check_integer(points, at, 1, 2**62), {}


def _whole(value: Any) -> bool:
    """Whether a value is a whole number; arrays of Dask, PyTorch and JAX have an `__index__` too."""
    return hasattr(value, "__index__") and not isinstance(value, bool | np.ndarray) and not getattr(value, "ndim", 0)


def _rows(taken: dict[str, Any], names: list[str]) -> dict[str, Any]:
    """The arrays of a row for each point, which are taken out; but not the one origin of all rays."""
    rows = {}
    for name in names:
        if name in taken:
            value = getattr(taken[name], "data", None) if hasattr(taken[name], "dims") else taken[name]  # of xarray
            array = value if isinstance(value, Array) else as_ndarray(value, name, "an array of rows")
            if array.ndim > 1:
                taken.pop(name)
                rows[name] = array
    return rows


def _cut(array: Any, chunk: int) -> Array:
    """An array of Dask's, or a copy of one of NumPy's, in the chunks of a job."""
    wanted = (chunk, *array.shape[1:])
    if isinstance(array, Array):
        return array.rechunk(wanted)
    return from_array(array.copy(), wanted, name=_content(array, chunk))


def _content(value: Any, *more: Any) -> str:
    """What tells the content of a large argument apart from others."""
    if isinstance(value, Mesh):
        return value.digest
    if isinstance(value, Array):
        return value.name
    return f"{digest_of(value)}{''.join(f'-{tokenize(item)}' for item in more)}"


def _gives(call: Call, shared: dict[str, Any], rows: dict[str, Array]) -> dict[str, tuple[np.dtype, tuple[int, ...]]]:
    """Runs the call at no point, on a mesh of one such triangle, which checks all other arguments.

    Directions are asked for at one point, since there are none at none.
    """
    points = int(call.name == "sample_directions")
    few = SurfacePoints(np.zeros((points, 3)), np.tile(np.float32([0.0, 0.0, 1.0]), (points, 1)))
    parts = [np.ones((points, *array.shape[1:]), array.dtype) for array in rows.values()]
    found = numbers(call, 0, few, [_small(value) if name == "mesh" else value for name, value in shared.items()], parts)
    return {name: (array.dtype, array.shape[1:]) for name, array in found.items() if isinstance(array, np.ndarray)}


def _small(mesh: Mesh) -> Mesh:
    """A triangle that lets light through and sends it back if some face of a mesh does."""
    optics = {"transmittance": 0.5 * mesh.transmits, "reflectance": 0.5 * mesh.reflects}
    return Mesh(np.eye(3), [[0, 1, 2]], **{name: share for name, share in optics.items() if share})


def _about(call: Call, large: dict[str, Any], total: int, chunk: int) -> dict[str, Any]:
    """All that repeats the run; large arguments by their content."""
    options = {name: value for name, value in call.options.items() if name not in _OF_THE_WORKERS}
    mesh = large.get("mesh")
    shape = None if mesh is None else digest_of(mesh.vertices, mesh.faces)
    return {
        "call": call.name,
        **({} if mesh is None or shape == mesh.digest else {SHAPE: shape}),
        **{name: _plain(value) for name, value in options.items()},
        **{name: _content(value) for name, value in large.items()},
        "place": call.place,
        "points": total,
        "chunk": chunk,
        STREAMS_OF: STREAMS,
        **{name: version(name) for name in VERSIONS},
    }


def _content_of_own(distribution: Distribution) -> dict[str, Any]:
    """What tells a distribution of a user's own apart from others: its parameters, and the functions of its maps."""
    maps = distribution.maps
    functions = (function for function in (maps.sample, maps.pdf, maps.about, maps.redraw) if function is not None)
    contents = {name: content for function in functions for name, content in function_content(function).items()}
    return {**contents, WHAT: str(distribution)}


def _plain(value: Any) -> Any:
    """`value` as JSON has it, or a text."""
    if isinstance(value, Named):
        return value.content
    if isinstance(value, Distribution) and not type(value).__module__.startswith("warpsample."):
        return _content_of_own(value)
    if isinstance(value, np.ndarray | np.generic | tuple | list):
        value = np.asarray(value).tolist()
    try:
        json.dumps(value)
    except (TypeError, ValueError):
        return str(value)
    return value
