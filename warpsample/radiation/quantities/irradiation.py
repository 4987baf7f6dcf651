"""Irradiation of a year or a period as a quantity of the command line."""

from typing import Any

from warpsample.estimate.plan import plan_of
from warpsample.estimate.quantities.record import Numbers, Quantity
from warpsample.mesh.mesh import Mesh
from warpsample.mesh.surface import SurfacePoints
from warpsample.radiation.reflection.patches import patches_of
from warpsample.radiation.reflection.reflections import reflections_of
from warpsample.radiation.weather.distant import WeatherLight
from warpsample.radiation.weather.irradiation import Irradiation, irradiation, received
from warpsample.radiation.weather.light import light_of
from warpsample.tracing.options import RayOptions
from warpsample.tracing.placed_points import PlacedPoints

WEATHER = {"weather": "an EPW weather file, or athens for the example"}


_OF_THE_LIGHT = ("weather", "period", "ground_albedo", "patches", "up", "north")


def _prepare(mesh: Mesh, _total: int, *, count: int, seed: int, workers: int | None, refine: Any, **given: Any) -> Numbers:
    """Compute the light and its reflections once; return a function that computes the irradiation of points."""
    parts = patches_of(mesh, refine)
    light = light_of(**{name: given[name] for name in _OF_THE_LIGHT})
    distant = WeatherLight(light, series=False)
    how = RayOptions.of(0, seed=seed, workers=workers)
    reflections = None if parts is None else reflections_of(parts, distant, count, how)

    def numbers(points: SurfacePoints, first: int) -> Irradiation:
        at = PlacedPoints.of(mesh, points)
        plan = plan_of(at, count, seed=seed, first_point=first, workers=workers)
        return received(plan, light, series=False, reflections=reflections)

    return numbers


_ON_RASTERS = (
    "radiation from sun, sky and the ground outside the raster at the centre of each cell, summed over the hours of the "
    "period, per m2 of a receiver; the normal of the receiver is {normal}; other cells reflect nothing"
)

RECORD = Quantity(
    name="irradiation",
    call=irradiation,
    title="irradiation",
    value="radiation of a period from sun, sky, ground outside the mesh and reflections; also each of these parts",
    result=Irradiation,
    shared=("hours", "skipped"),
    unit="kWh/m2",
    files=WEATHER,
    prepare=_prepare,
    in_stores=False,
    on_rasters={"surface": _ON_RASTERS, "horizontal": _ON_RASTERS},
)
