"""Lobes of each point: parameters of vertices or faces carried to points, and views from points to the camera."""

from collections.abc import Callable
from dataclasses import fields, replace
from typing import Any

import numpy as np

from warpsample.distributions.record import Distribution
from warpsample.mesh.mesh import Mesh
from warpsample.mesh.points.arrays import carry_to_points
from warpsample.mesh.surface import SurfacePoints
from warpsample.viewer.choice import Choice

VIEW = "view"
"""Name of the parameter that is the direction to the viewer."""


def has_view(distribution: Distribution) -> bool:
    """Return whether a distribution, or a lobe in it, depends on the direction to the viewer."""
    return hasattr(distribution, VIEW) or any(has_view(lobe) for lobe in distribution.nested.values())


def follows_camera(choice: Choice) -> bool:
    """Return whether the directions, or the densities in the comparison, depend on the camera."""
    return choice.camera and (has_view(choice.distribution) or has_view(choice.claim))


def check_rows(choice: Choice, mesh: Mesh) -> None:
    """Raise ValueError unless parameters by point have one row for each vertex or for each face of a mesh."""
    for argument, each in (("distribution", choice.distribution), ("density", choice.claim)):
        for name, table in each.by_point.items():
            if len(table) not in (len(mesh.vertices), len(mesh.faces)):
                wants = f"{len(mesh.vertices):,} (vertices) or {len(mesh.faces):,} (faces)"
                raise ValueError(f"{argument}: got {name} with {len(table):,} rows, want {wants}")


def lobes_at(choice: Choice, mesh: Mesh, points: SurfacePoints, eye: np.ndarray) -> Choice:
    """Return settings with the distributions of points: with one row of parameters for each point, where rows differ.

    Args:
        choice: settings whose distributions have constant parameters, or a row for each vertex or face.
        mesh: mesh of the rows.
        points: points on the mesh.
        eye: (3,) position of the camera, in the coordinates of the points.
    """
    if not (choice.distribution.by_point or choice.claim.by_point or follows_camera(choice)):
        return choice
    views = points.to_local(eye - points.position) if follows_camera(choice) else None

    def change(name: str, value: Any) -> Any:
        if name == VIEW and views is not None:
            return views
        return carry_to_points(value, name, mesh, points) if isinstance(value, np.ndarray) else value

    density = None if choice.density is None else _change_fields(choice.density, change)
    return replace(choice, distribution=_change_fields(choice.distribution, change), density=density)


def usable_rows(*distributions: Distribution) -> np.ndarray | slice:
    """Return the rows of points at which all parameters of some distributions are valid; all rows for constants.

    A view from below the surface is not valid.
    """
    tables = [table for each in distributions for table in each.by_point.values()]
    if not tables:
        return slice(None)
    return np.flatnonzero(np.all([np.isfinite(table).reshape(len(table), -1).all(axis=1) for table in tables], axis=0))


def constant_lobes(distribution: Distribution) -> list[Distribution]:
    """Return the distribution of each row of parameters by point; the distribution itself if all are constants."""
    count = len(next(iter(distribution.by_point.values()), ()))
    return [_change_fields(distribution, lambda _, v, i=i: _row(v, i)) for i in range(count)] or [distribution]


def _row(value: Any, row: int) -> Any:
    """Return one row of a parameter by point as a constant."""
    if not isinstance(value, np.ndarray):
        return value
    numbers = value[row].tolist()
    return tuple(map(tuple, numbers)) if value.ndim == 3 else tuple(numbers) if value.ndim == 2 else numbers


def _change_fields(distribution: Distribution, change: Callable[[str, Any], Any]) -> Distribution:
    """Return a distribution with `change(name, value)` in place of each field, also in lobes of lobes."""
    if not distribution.by_point and not has_view(distribution):
        return distribution

    def change_field(name: str, value: Any) -> Any:
        if isinstance(value, Distribution):
            return _change_fields(value, change)
        if isinstance(value, tuple) and any(isinstance(item, Distribution) for item in value):  # a mixture
            return tuple(_change_fields(lobe, change) for lobe in value)
        return change(name, value)

    values = {item.name: getattr(distribution, item.name) for item in fields(distribution)}
    return replace(distribution, **{name: change_field(name, value) for name, value in values.items()})
