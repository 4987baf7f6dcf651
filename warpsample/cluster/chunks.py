"""Computation of one chunk of points on a Dask worker."""

from collections.abc import Callable
from dataclasses import dataclass, fields
from typing import Any

import numpy as np

from warpsample.cluster.named import Named
from warpsample.directions.sample import sample_directions
from warpsample.distributions.record import Distribution
from warpsample.estimate.integrate import integrate
from warpsample.estimate.quantities.record import OF_MEANS
from warpsample.mesh.points.sampling import sample_surface
from warpsample.mesh.surface import SurfacePoints
from warpsample.output.quantities import quantities
from warpsample.tracing.trace import trace

CALLS = {quantity.call.__name__: quantity for quantity in quantities().values() if quantity.in_stores}
"""Quantities that can be computed in chunks, by the name of the call."""

FUNCTIONS: dict[str, Callable[..., Any]] = {
    **{name: quantity.call for name, quantity in CALLS.items()},
    **{function.__name__: function for function in (integrate, sample_directions, trace)},
}
"""Functions that can be computed in chunks, by name."""


BY_POINT = "distribution."
"""Beginning of the names of rows that are parameters of the distribution, given by point."""


@dataclass(frozen=True)
class Call:
    """Description of a function call over chunks of points, small enough to send with every Dask task.

    Attributes:
        name: Name of the call, a key of FUNCTIONS.
        options: Small arguments, by name; of a distribution by point without the rows of its parameters.
        shared: Names of the large arguments; a worker keeps one copy of each for all tasks.
        rows: Names of the arguments that are arrays with a row per point.
        at: Name of the argument that is a SurfacePoints; None if no argument is.
        place: Placement of the points: "area" (uniform by area), "faces", "vertices", or "given" by the caller; "" if
            `at` is None.
        point_fields: Names of the SurfacePoints' fields that the caller gives.
        seed: Seed of points that are uniform by area.
        first_point: Global id of the first point of the first chunk.
    """

    name: str
    options: dict[str, Any]
    shared: tuple[str, ...]
    rows: tuple[str, ...]
    at: str | None
    place: str
    point_fields: tuple[str, ...]
    seed: int
    first_point: int


def points_in(call: Call, span: range, shared: list[Any], given: list[np.ndarray]) -> SurfacePoints | None:
    """Return the surface points of one chunk, sampled or given; None if the function takes arrays instead of points.

    Args:
        call: The call.
        span: Row numbers of the chunk.
        shared: Values of `call.shared`; the first is the mesh.
        given: Arrays of the points' fields in `call.point_fields`, for the chunk's rows. If empty, points are sampled here.
    """
    if given or not call.at:
        return SurfacePoints(**dict(zip(call.point_fields, given, strict=True))) if given else None
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
    """Compute the function for one chunk of points; return the result's arrays, keyed by name.

    The points are made in the same task: a task of their own takes longer.
    """
    return numbers(call, span.start, points_in(call, span, shared, given), shared, rows)


def numbers(call: Call, start: int, points: SurfacePoints | None, shared: list[Any], rows: list[Any]) -> dict[str, Any]:
    """Compute the function of a `Call` for the given points; return the result's arrays, keyed by name.

    One thread computes, unless the option `workers` is set: Dask runs one task on each thread of a worker.

    Args:
        call: The call.
        start: Number of the chunk's first row.
        points: Points of the chunk; None if the call takes no SurfacePoints.
        shared: Values of the arguments in `call.shared`.
        rows: Values of the arguments in `call.rows`, for the chunk's rows.
    """
    arguments = {name: value.unwrap() if isinstance(value, Named) else value for name, value in call.options.items()}
    arguments |= zip(call.shared, shared, strict=True)
    arguments |= _with_rows(arguments, dict(zip(call.rows, rows, strict=True)))
    if call.at:
        arguments[call.at] = points
    if call.name == "sample_directions":
        arguments.pop("mesh", None)  # only used to make the points
    arguments["workers"] = 1 if arguments.get("workers") is None else arguments["workers"]
    if "first_point" in arguments and "id" not in call.point_fields:
        arguments["first_point"] = call.first_point + start
    found = FUNCTIONS[call.name](**arguments)
    return {item.name: getattr(found, item.name) for item in fields(found) if item.name not in OF_MEANS}


def _with_rows(arguments: dict[str, Any], rows: dict[str, Any]) -> dict[str, Any]:
    """Return the chunk's arguments with one row per point; parameters of the distribution are put into a copy of it."""
    tables = {name.removeprefix(BY_POINT): array for name, array in rows.items() if name.startswith(BY_POINT)}
    found = {name: array for name, array in rows.items() if not name.startswith(BY_POINT)}
    distribution = arguments.get("distribution")
    if tables and isinstance(distribution, Distribution):
        found["distribution"] = distribution.with_tables(tables)
    return found
