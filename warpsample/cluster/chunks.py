"""What a worker does: the points of a chunk, and the numbers at them."""

from collections.abc import Callable
from dataclasses import dataclass, fields
from typing import Any

import numpy as np

from warpsample.cluster.named import Named
from warpsample.directions.sample import sample_directions
from warpsample.estimate.integrate import integrate
from warpsample.mesh.points.sampling import sample_surface
from warpsample.mesh.surface import SurfacePoints
from warpsample.output.quantities import quantities
from warpsample.tracing.trace import trace

CALLS = {quantity.call.__name__: quantity for quantity in quantities().values() if quantity.in_stores}
"""The quantities that are computed in chunks, by the names of their calls."""

FUNCTIONS: dict[str, Callable[..., Any]] = {
    **{name: quantity.call for name, quantity in CALLS.items()},
    **{function.__name__: function for function in (integrate, sample_directions, trace)},
}
"""All calls over chunks, by name."""


@dataclass(frozen=True)
class Call:
    """What is alike for all chunks and small: it travels with every task.

    Attributes:
        name: of FUNCTIONS.
        options: arguments by name.
        shared: names of the arguments that are large: a worker has one copy for all tasks.
        rows: names of the arguments that are arrays with a row for each point.
        at: the argument that is SurfacePoints; None if there is none.
        place: where those are: "area" (uniform by it), "faces", "vertices" or "given".
        given: names of the fields of those that are given.
        seed: of points uniform by area.
        first_point: the global id of the first point of all.
    """

    name: str
    options: dict[str, Any]
    shared: tuple[str, ...]
    rows: tuple[str, ...]
    at: str | None
    place: str
    given: tuple[str, ...]
    seed: int
    first_point: int


def points_in(call: Call, span: range, shared: list[Any], given: list[np.ndarray]) -> SurfacePoints | None:
    """The points of a chunk, rows of that span: those given, or as the functions of `warpsample` make them."""
    if given or not call.at:
        return SurfacePoints(**dict(zip(call.given, given, strict=True))) if given else None
    mesh = shared[0]
    if call.place == "area":
        return sample_surface(mesh, len(span), seed=call.seed, first_point=call.first_point + span.start, workers=1)
    rows = slice(span.start, span.stop)
    if call.place == "vertices":
        return SurfacePoints(mesh.vertices[rows].copy(), mesh.vertex_normals[rows].copy())
    position = mesh.vertices[mesh.faces[rows]].mean(axis=1)
    return SurfacePoints(position, mesh.face_normals[rows].copy(), np.arange(span.start, span.stop, dtype=np.int32))


def numbers_in(
    call: Call, span: range, shared: list[Any], given: list[np.ndarray], rows: list[np.ndarray]
) -> dict[str, Any]:
    """The fields of a chunk's result; its points are made on the way, which is faster than a task for them."""
    return numbers(call, span.start, points_in(call, span, shared, given), shared, rows)


def numbers(call: Call, start: int, points: SurfacePoints | None, shared: list[Any], rows: list[Any]) -> dict[str, Any]:
    """The fields of a chunk's result, by name.

    One thread computes them, unless the call says otherwise: Dask runs as many tasks at once as a worker has threads.
    """
    arguments = {name: value.taken() if isinstance(value, Named) else value for name, value in call.options.items()}
    arguments |= zip(call.shared, shared, strict=True)
    arguments |= zip(call.rows, rows, strict=True)
    if call.at:
        arguments[call.at] = points
    if call.name == "sample_directions":
        arguments.pop("mesh", None)  # is what points are on
    arguments["workers"] = 1 if arguments.get("workers") is None else arguments["workers"]
    if "first_point" in arguments and "id" not in call.given:
        arguments["first_point"] = call.first_point + start
    found = FUNCTIONS[call.name](**arguments)
    return {item.name: getattr(found, item.name) for item in fields(found)}
