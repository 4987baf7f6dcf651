"""The quantities of `warpsample bake` that know where the sun and the sky's patches are."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np

from warpsample.estimate.plan import Plan
from warpsample.estimate.result import PointStatus
from warpsample.host.engine import check_memory
from warpsample.host.vectors import as_directions
from warpsample.mesh.mesh import Mesh
from warpsample.mesh.surface import SurfacePoints
from warpsample.output.baked import Run
from warpsample.radiation.sky.patches import sky_patches
from warpsample.radiation.sky.sky_matrix import sky_matrix
from warpsample.radiation.sun.direct_sun import direct_sun
from warpsample.radiation.weather.irradiation import received
from warpsample.radiation.weather.light import light_of, sun_directions
from warpsample.radiation.weather.weather import read_weather

_AXES = {"patches": "reinhart2", "north": (0.0, 1.0, 0.0)}  # where the command line says nothing


@dataclass(frozen=True, eq=False)
class SunHours:
    """In how many hours P points see the sun.

    Attributes:
        value: (P,) float32, hours in whose middle the sun's centre is above the horizon, in front of the point and not
            hidden by the mesh; 0 where the status is not 0.
        standard_error: (P,) float32, 0: nothing is drawn at random.
        rays: (P,) int32, 0: those to the sun are not counted.
        status: (P,) uint8, a `PointStatus`.
    """

    value: np.ndarray
    standard_error: np.ndarray
    rays: np.ndarray
    status: np.ndarray


def irradiation_of(run: Run, mesh: Mesh) -> Callable[[SurfacePoints, int], Any]:
    """A function (points, id of the first) -> their irradiation."""
    given = {"period": None, "ground_albedo": 0.2, **_AXES, **run.options}
    seed, workers = given.pop("seed"), given.pop("workers")
    light = light_of(run.weather, up=run.up, **given)

    def estimate(points: SurfacePoints, first: int) -> Any:
        plan = Plan.of(mesh, points, run.samples, seed=seed, first_point=first, workers=workers)
        return received(plan, light, series=False)

    return estimate


def sun_hours_of(run: Run, mesh: Mesh) -> Callable[[SurfacePoints, int], SunHours]:
    """The same for the hours of sun."""
    options = _AXES | run.options
    weather = read_weather(run.weather, options.get("period"))
    suns = sun_directions(weather.chosen(weather.sun_altitude > 0.0), sky_patches(up=run.up, north=options["north"]).frame)

    def estimate(points: SurfacePoints, first: int) -> SunHours:
        hours = none = np.zeros(len(points), np.float32)
        if len(suns):
            given = {"seed": options["seed"], "first_point": first, "workers": options["workers"]}
            hours = direct_sun(mesh, points, suns, np.ones(len(suns)), **given)
        return SunHours(hours.astype(np.float32), none, none.astype(np.int32), _status(points))

    return estimate


def sky_matrix_of(run: Run, mesh: Mesh) -> Callable[[SurfacePoints, int], Any]:
    """The same for the sky matrix."""
    options = {**run.options, "patches": run.options.get("patches", "tregenza")}
    return lambda points, first: sky_matrix(mesh, points, run.samples, up=run.up, first_point=first, **options)


def check_matrix(run: Run, points: int) -> None:
    """Refuses a sky matrix that does not fit into memory, twice: in parts and as a whole.

    Raises:
        MemoryError: says how to take fewer points.
    """
    patches = len(sky_patches(run.options.get("patches", "tregenza")))
    what = f"{points:,} rows of {patches:,} patches and their errors"
    check_memory(2 * 8 * points * patches, what, "take fewer points, or coarser --patches")


def _status(points: SurfacePoints) -> np.ndarray:
    """(P,) uint8, a `PointStatus`, as the estimates have it."""
    normal = as_directions(points.normal)
    cases = {
        PointStatus.NONFINITE_NORMAL: ~np.isfinite(normal).all(axis=1),
        PointStatus.ZERO_NORMAL: ~normal.any(axis=1),
        PointStatus.NONFINITE_POSITION: ~np.isfinite(points.position).all(axis=1),
    }
    return np.select(list(cases.values()), [np.uint8(status) for status in cases], np.uint8(PointStatus.OK))


SUNLIGHT = {"irradiation": irradiation_of, "sun-hours": sun_hours_of, "sky-matrix": sky_matrix_of}
"""By the name of the quantity."""
