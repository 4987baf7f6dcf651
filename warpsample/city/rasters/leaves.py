"""Quantities with translucent tree crowns, computed as weighted sums of results with opaque and without crowns.

Crowns transmit a fixed fraction of light, however many crowns a ray crosses (Lindberg2011). With B the result with opaque
crowns and A the result without crowns, the result is B + share * (A - B). Both use the same rays, so their errors are
correlated. The sum of the weighted errors, (1 - share) of B's and share of A's, is at least the error of the result.
"""

from collections.abc import Callable
from dataclasses import fields, replace
from typing import Any

import numpy as np

from warpsample.city.rasters.intervals import errors_of
from warpsample.city.rasters.scenery import Scenery, Seen
from warpsample.estimate.plan import Plan
from warpsample.estimate.quantities.record import Quantity
from warpsample.host.arguments import quote
from warpsample.host.arrays import as_real
from warpsample.mesh.mesh import Mesh
from warpsample.mesh.surface import SurfacePoints
from warpsample.radiation.sky.patches import sky_patches
from warpsample.radiation.sun.direct_sun import direct_sun
from warpsample.radiation.weather.irradiation import Irradiation, irradiation, received
from warpsample.radiation.weather.light import Light, light_of, sun_directions
from warpsample.radiation.weather.weather import read_weather
from warpsample.tracing.options import RayOptions
from warpsample.tracing.placed_points import PlacedPoints

TRANSMITTANCE = 0.03
"""Default transmittance of crowns with leaves, as in SOLWEIG."""

_MONTHS, _DAYS = 12, 365
_WANTS = "a fraction from 0 to 1, or 12 fractions for the months, or 365 for the days"


def check_transmittance(value: Any) -> np.ndarray:
    """Check the transmittance of tree crowns; return (1,) float64 for a constant, (12,) for months, or (365,) for days.

    Raises:
        TypeError, ValueError: Values that are not numbers from 0 to 1, or another count.
    """
    shares = np.atleast_1d(as_real(value, "transmittance", _WANTS)).astype(np.float64)
    if shares.shape not in ((1,), (_MONTHS,), (_DAYS,)) or not ((shares >= 0.0) & (shares <= 1.0)).all():
        raise ValueError(f"transmittance: got {quote(value)}, want {_WANTS}")
    return shares


def shares_of_hours(transmittance: np.ndarray, hours: np.ndarray) -> np.ndarray:
    """Return the transmittance of tree crowns in each hour, (T,), from its values by month or by day.

    The hours are (T,) datetime64 of years without 29 February.
    """
    if len(transmittance) == _MONTHS:
        return transmittance[hours.astype("datetime64[M]").astype(int) % 12]
    if len(transmittance) == _DAYS:
        return transmittance[np.array([_day_of_year(day) for day in hours.astype("datetime64[D]")], int)]
    return np.broadcast_to(transmittance, hours.shape)


def _day_of_year(day: np.datetime64) -> int:
    """Return the index of a date in a year without 29 February, counted from 0.

    The year itself is ignored, because weather files of typical years join months of several years.
    """
    month = day.astype("datetime64[M]")
    first = np.datetime64("2021-01", "M") + month.astype(int) % 12
    return int((first.astype("datetime64[D]") - np.datetime64("2021-01-01")).astype(int) + (day - month).astype(int))


def estimate_through_crowns(scenery: Scenery, transmittance: np.ndarray, call: Callable[[Mesh], Any]) -> Seen:
    """Compute a quantity that does not depend on time, under tree crowns that transmit a fraction of the light.

    Args:
        scenery: Scenes with and without crowns.
        transmittance: (1,) transmittance of crowns.
        call: Function that computes the result for a mesh, as an Estimate.
    """
    return _add_results(Seen, [_scale_estimate(call(made()), share) for made, share in _list_views(scenery, transmittance)])


def compute_through_crowns(
    quantity: Quantity,
    scenery: Scenery,
    points: SurfacePoints,
    options: dict[str, Any],
    transmittance: np.ndarray,
) -> Seen:
    """Compute a quantity at points of a surface, under tree crowns that transmit a fraction of the light.

    The hours are separate if the transmittance depends on the date.
    """
    if len(transmittance) == 1 or scenery.with_crowns is None:
        return estimate_through_crowns(scenery, transmittance[:1], lambda mesh: quantity.call(mesh, points, **options))
    given = quantity.parameters | options
    if quantity.call is irradiation:
        names = ("weather", "period", "ground_albedo", "patches", "up", "north")
        light = light_of(**{name: given[name] for name in names})
        cast = RayOptions.of(len(points), seed=given["seed"], ids=points.id).replace(workers=given["workers"])
        found = compute_irradiation_through(scenery, points, light, transmittance, count=given["count"], options=cast)
        return _scale_estimate(found, np.ones(()))
    weather = read_weather(given["weather"], given["period"])
    weather = weather.chosen(weather.sun_altitude > 0.0)
    frame = sky_patches(up=given["up"], north=given["north"]).frame
    without_crowns = quantity.call(scenery.without_crowns(), points, **options)
    shares = shares_of_hours(transmittance, weather.hours)
    hours = count_suns_through(scenery, points, sun_directions(weather, frame), shares, workers=given["workers"])
    return replace(_scale_estimate(without_crowns, np.ones(())), value=hours.astype(np.float32))


def check_dates(quantity: Quantity, transmittance: np.ndarray) -> None:
    """Raise a ValueError for a transmittance by month or day if the quantity does not depend on time."""
    if len(transmittance) != 1 and "weather" not in quantity.parameters:
        raise ValueError(
            f"transmittance: got {len(transmittance)} fractions for the {quantity.title}, want one fraction, "
            "because this quantity does not depend on the date"
        )


def compute_irradiation_through(
    scenery: Scenery,
    points: SurfacePoints,
    light: Light,
    transmittance: np.ndarray,
    *,
    count: int,
    options: RayOptions,
) -> Irradiation:
    """Compute the irradiation at points of a surface, under tree crowns that transmit a fraction of the light.

    The arguments are those of `irradiation` and `received`.
    """

    def compute(mesh: Mesh, shares: np.ndarray) -> Irradiation:
        plan = Plan.of(PlacedPoints.of(mesh, points), count, options)
        return received(plan, dim_light(light, shares), series=False)

    parts = [compute(made(), shares) for made, shares in _list_views(scenery, shares_of_hours(transmittance, light.hours))]
    return _add_results(Irradiation, parts)


def dim_light(light: Light, shares: np.ndarray) -> Light:
    """Return the light of sun and sky with each of its T hours multiplied by a fraction, (T,)."""
    return replace(
        light,
        direct=light.direct * shares[light.sun_rows],
        radiance=light.radiance * shares[light.sky_rows],
        ground=light.ground * shares[light.sky_rows],
    )


def count_suns_through(
    scenery: Scenery, points: SurfacePoints, suns: np.ndarray, shares: np.ndarray, **options: Any
) -> np.ndarray:
    """Count the hours in which the sun is visible from each point, (P,) float64.

    An hour with the sun, (T, 3), behind a tree crown counts as the transmittance `shares`, (T,).
    """
    if not len(suns):  # a period of nights
        return np.zeros(len(points))
    views = _list_views(scenery, shares)
    return np.sum([direct_sun(made(), points, suns, weights=np.array(share), **options) for made, share in views], axis=0)


def _list_views(scenery: Scenery, shares: np.ndarray) -> tuple[tuple[Callable[[], Mesh], np.ndarray], ...]:
    """Return the scenes to average, with tree crowns and without: pairs of a function that builds the mesh, and a weight."""
    if scenery.with_crowns is None:
        return ((scenery.without_crowns, np.ones_like(shares)),)
    return (scenery.with_crowns, 1.0 - shares), (scenery.without_crowns, shares)


def _scale_estimate(found: Any, share: np.ndarray) -> Seen:
    """Multiply the value and the errors of an estimate by `share`."""
    value, error, half = (np.float32(share * array.astype(np.float64)) for array in (found.value, *errors_of(found)))
    return Seen(value, error, half, found.rays, found.status)


def _add_results(kind: type[Any], parts: list[Any]) -> Any:
    """Add the results of the scenes with and without crowns, field by field.

    Fields that are not amounts of light, such as the status, are those of the first result.
    """
    summed = ("value", "standard_error", "half_width", "direct", "diffuse", "ground", "rays")
    names = [item.name for item in fields(kind) if item.name in summed]
    sums = {name: sum(getattr(part, name) for part in parts[1:]) for name in names}
    return replace(parts[0], **{name: getattr(parts[0], name) + more for name, more in sums.items()})
