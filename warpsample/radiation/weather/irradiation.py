"""The call `irradiation`: radiation from sun, sky, ground and reflections, with weather from a file."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any, ClassVar

import numpy as np
from numpy.typing import NDArray
from typing_extensions import Unpack

from warpsample.estimate.plan import Plan, plan_of
from warpsample.estimate.result import PointResult, PointStatus, has_status
from warpsample.host.arguments import check_flag
from warpsample.host.engine import check_memory
from warpsample.host.options import CastPointKeywords, with_options
from warpsample.mesh.surface import SurfacePoints
from warpsample.radiation.reflection.patches import patches_of
from warpsample.radiation.reflection.reflections import Reflected, Reflections, reflections_of
from warpsample.radiation.sky.result import SkySkipped
from warpsample.radiation.sky.sky_matrix import compute_sky_matrix
from warpsample.radiation.weather.distant import WeatherLight, direct_light, sum_hours
from warpsample.radiation.weather.light import Light, light_of
from warpsample.sequences.hashing import seed_for
from warpsample.tracing.placed_points import PlacedPoints

_BYTES = 5 * 4 + 5 * 8  # per point and hour: five results in float32, and their parts in float64


@dataclass(frozen=True, eq=False, repr=False)
class Irradiation(PointResult):
    """Radiation received at P points: in a period (P,), in kWh/m², or in each of T hours (P, T), in W/m².

    Attributes:
        value: float32, sum of all parts; 0 where the status is not 0.
        standard_error: Standard error of all parts except the sun's, which is exact for the sun's centre; in the shape and
            unit of `value`.
        direct: Part from the sun, in the shape and unit of `value`.
        diffuse: Part from the sky, in the shape and unit of `value`.
        ground: Part from the ground outside the mesh, in the shape and unit of `value`.
        hours: (T,) datetime64[m], begin of each hour of the period, in local standard time and in the order of the file:
            from January on, also if the period spans New Year.
        rays: (P,) int32, number of rays cast to the sky and the ground, without rays to the sun.
        status: (P,) uint8, a `PointStatus`.
        skipped: Counts of the work skipped for the sky.
        reflected: Part from faces, by all orders of reflection, in the shape and unit of `value`; None if all faces
            are black.
        reflected_error: Standard error of `reflected`; None if all faces are black.
        reflected_runs: (P, 1, 8) float32, `reflected` of each of its eight runs, for errors of means over points; None if
            all faces are black, or in each of T hours.
    """

    value: NDArray[np.float32]
    standard_error: NDArray[np.float32]
    direct: NDArray[np.float32]
    diffuse: NDArray[np.float32]
    ground: NDArray[np.float32]
    hours: NDArray[np.datetime64]
    rays: NDArray[np.int32]
    status: NDArray[np.uint8]
    skipped: SkySkipped
    reflected: np.ndarray | None = None
    reflected_error: np.ndarray | None = None
    reflected_runs: np.ndarray | None = None

    _axes: ClassVar[tuple[str, ...]] = ("hour",)

    def _coordinates(self) -> dict[str, np.ndarray]:
        return {"hour": self.hours} if self.value.ndim == 2 else {}


@with_options(CastPointKeywords)
def irradiation(
    mesh: Any,
    points: SurfacePoints,
    weather: Any,
    *,
    ground_albedo: float = 0.2,
    period: Sequence[str] | None = None,
    patches: str = "reinhart2",
    count: int = 1024,
    up: Any = (0.0, 0.0, 1.0),
    north: Any = (0.0, 1.0, 0.0),
    series: bool = False,
    refine: float | None = None,
    **options: Unpack[CastPointKeywords],
) -> Irradiation:
    """Compute the irradiation of each point by sun and sky over a year, or the irradiance in each hour, from a weather file.

    The sun adds its direct normal radiation, if its centre in the middle of the hour is above the horizon, with refraction,
    and not hidden. The sky adds the patches' shares of the lobe, times their radiance by Perez1993 (Radiance's gendaymtx),
    scaled to the file's diffuse horizontal radiation. Directions below the horizon that hit nothing add a plane that
    reflects `ground_albedo` of the light on open ground. A face with a transmittance (see `Mesh`) transmits that share.

    A face with a reflectance reflects that share of its light, from either side and evenly in all directions; other faces
    are black. The reflected part is the mean of eight runs, whose differences give its error. Each part of a face is taken
    to reflect evenly, see `refine`; error bars do not contain the error of that. Terrain outside the mesh is not changed.

    Args:
        mesh: Mesh or anything that `as_mesh` accepts.
        points: P SurfacePoints, as for `ambient_occlusion`.
        weather: Path of an EPW file of 8,760 hours, or "athens", an example: a cloudless year.
        ground_albedo: Albedo of the ground, a float from 0 to 1. Default: 0.2.
        period: First and last day, both included, as ("06-01", "08-31"); or with the hours of local standard time at which
            the period begins and ends, ("03-21T09", "03-21T15"). It may span New Year: ("07-01", "06-30") is the whole year.
            Default: None, the year.
        patches: Patches of the sky, "tregenza" (145), "reinhart2" (577) or "reinhart4" (2,305). Default: "reinhart2".
        count: Number of rays per point to the sky, and the same number to the ground, 2 to 2^24. Default: 1024.
        up: (3,) vector of any length towards the zenith. Default: (0.0, 0.0, 1.0).
        north: (3,) vector of any length, not along `up`; its part across `up` counts. Default: (0.0, 1.0, 0.0).
        series: Whether to return each hour of the period. Default: False.
        refine: Longest edge of the parts of faces that each reflect evenly, a float in mesh units, inf for whole faces. In a
            street, parts of a quarter of its width leave an error of 0.05 % under an even sky, and 1.7 % in its edges; with
            half of the floor in the sun 1 % and 17 % of the reflected part. No effect if no face reflects. Default: None,
            8,192 parts more than sides.
        seed: Random seed, an integer of 64 bits. Default: 0.
        first_point: Global id of row 0, an integer; 0 for points with an `id`. Default: 0.
        active: (P,) bool. Inactive points get 0 and a status, and cast no rays. Default: None, all points are active.
        skip: Whether to leave out rays whose answer is known. Changes no value. Default: True.
        workers: Number of CPU threads, an integer. Default: None, the value of WARPSAMPLE_WORKERS or all cores.
        progress: Whether to show a progress bar on a terminal or in a notebook. Default: False.

    Returns:
        value (P,) in kWh/m² for the period, or with `series` (P, T) in W/m²; the standard error, the parts of the value, and
        for each point the number of rays cast and a status.

    Raises:
        TypeError, ValueError, FileNotFoundError: an argument that cannot be used, or a file that is not the weather of a
            year.
        ModuleNotFoundError: pvlib or pyradiance is not installed.
        MemoryError: the result needs more memory than is free.

    Example:
        >>> mesh = ws.load_mesh("courtyard")
        >>> june = ws.irradiation(mesh, ws.face_centers(mesh), "athens", period=("06-01", "06-30"), patches="tregenza")
        >>> print(june.value.shape, f"{june.value.max():.0f} kWh/m2")
        (2080,) 270 kWh/m2
    """
    at = PlacedPoints.of(mesh, points)
    plan = plan_of(at, count, tracer="wide", **options)
    series = check_flag(series, "series")
    parts = patches_of(at.mesh, refine)
    light = light_of(weather, period=period, ground_albedo=ground_albedo, patches=patches, up=up, north=north)
    distant = WeatherLight(light, series)
    reflections = None if parts is None else reflections_of(parts, distant, plan.count, plan.options)
    return received(plan, light, series, reflections)


def received(plan: Plan, light: Light, series: bool, reflections: Reflections | None = None) -> Irradiation:
    """Compute the radiation that points receive from sun, sky, ground and faces, in kWh/m² or, for each hour, in W/m²."""
    hours = len(light.hours)
    if series:
        size = _BYTES * len(plan.at) * hours
        check_memory(size, f"{hours:,} hours of {len(plan.at):,} points", "pass fewer points, or a shorter period")
    sky = compute_sky_matrix(plan, light.sky, light.radiance if series else sum_hours(light.radiance))
    options = replace(plan.options, seed=seed_for("ground", plan.options.seed))
    ground = compute_sky_matrix(replace(plan, options=options), light.below, np.ones(len(light.below)))
    bright = light.ground if series else sum_hours(light.ground)
    found = {
        "direct": (direct_light(plan.at, plan.options, light, series), light.sun_rows),
        "diffuse": (np.pi * sky.value, light.sky_rows),
        "ground": (np.multiply.outer(np.float64(ground.value), bright), light.sky_rows),
        "standard_error": (
            np.hypot(np.pi * sky.standard_error, np.multiply.outer(np.float64(ground.standard_error), bright)),
            light.sky_rows,
        ),
    }
    arrays = {name: _expand_hours(part, rows, hours) if series else np.float32(part) for name, (part, rows) in found.items()}
    received_from_afar = Irradiation(
        value=arrays["direct"] + arrays["diffuse"] + arrays["ground"],
        **arrays,
        hours=light.hours,
        rays=sky.rays + ground.rays,
        status=sky.status,
        skipped=sky.skipped,
    )
    if reflections is None:
        return received_from_afar
    return _add_reflected(received_from_afar, reflections.at(plan.at.points, plan.count, plan.options), light)


def _add_reflected(found: Irradiation, reflected: Reflected, light: Light) -> Irradiation:
    """Add reflected light to the radiation from sun, sky and ground, and combine the errors."""
    good = has_status(found.status, PointStatus.OK)
    value, error = reflected.value, np.where(good[:, None], reflected.error, 0.0)
    if found.value.ndim == 2:
        value, error = (_expand_hours(part, light.sky_rows, len(light.hours)) for part in (value, error))
    value, error = (part.reshape(found.value.shape).astype(np.float32) for part in (value, error))
    return replace(
        found,
        value=found.value + value,
        standard_error=np.hypot(*np.float64([found.standard_error, error])).astype(np.float32),
        rays=found.rays + np.where(good, reflected.rays, 0).astype(np.int32),
        reflected=value,
        reflected_error=error,
        reflected_runs=reflected.runs if found.value.ndim == 1 else None,
    )


def _expand_hours(part: np.ndarray, rows: np.ndarray, hours: int) -> np.ndarray:
    """Copy columns for some hours into an array of all hours, (P, hours) float32, with 0 elsewhere."""
    made = np.zeros((len(part), hours), np.float32)
    made[:, rows] = part
    return made
