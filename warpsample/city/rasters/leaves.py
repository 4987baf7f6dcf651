"""What is seen through crowns: two runs by the same rays, one with opaque crowns and one without them.

Of what lies behind crowns a share is seen, the same however many of them a ray crosses: with B seen beside all crowns and A
seen without them, B + share * (A - B). Both are found by the same rays, so that their errors go together: their sum,
(1 - share) of B's and share of A's, is no less than that of the result, Lindberg2011.
"""

from collections.abc import Callable
from dataclasses import fields, replace
from typing import Any

import numpy as np

from warpsample.city.rasters.intervals import half_width_of
from warpsample.city.rasters.scenery import Scenery, Seen
from warpsample.estimate.plan import Plan
from warpsample.estimate.quantities.record import Quantity
from warpsample.host.arguments import told
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
"""The share of light that passes crowns with leaves: SOLWEIG's."""

_MONTHS, _DAYS = 12, 365
_WANTS = "a share from 0 to 1, or 12 of them, for each month, or 365, for each day"


def check_transmittance(value: Any) -> np.ndarray:
    """(1,), (12,) or (365,) float64, the share of light that passes crowns: always, in each month, or on each day.

    Raises:
        TypeError, ValueError: something else.
    """
    shares = np.atleast_1d(as_real(value, "transmittance", _WANTS)).astype(np.float64)
    if shares.shape not in ((1,), (_MONTHS,), (_DAYS,)) or not ((shares >= 0.0) & (shares <= 1.0)).all():
        raise ValueError(f"transmittance: got {told(value)}, want {_WANTS}")
    return shares


def shares_of_hours(transmittance: np.ndarray, hours: np.ndarray) -> np.ndarray:
    """(T,) the share that passes crowns in each of (T,) hours, datetime64 of a year without 29 February."""
    if len(transmittance) == _MONTHS:
        return transmittance[hours.astype("datetime64[M]").astype(int) % 12]
    if len(transmittance) == _DAYS:
        return transmittance[np.array([_day_of(day) for day in hours.astype("datetime64[D]")], int)]
    return np.broadcast_to(transmittance, hours.shape)


def _day_of(day: np.datetime64) -> int:
    """The number of a day in a year without 29 February, from 0 on: files of typical years join months of several years."""
    month = day.astype("datetime64[M]")
    first = np.datetime64("2021-01", "M") + month.astype(int) % 12
    return int((first.astype("datetime64[D]") - np.datetime64("2021-01-01")).astype(int) + (day - month).astype(int))


def seen_through(scenery: Scenery, transmittance: np.ndarray, call: Callable[[Mesh], Any]) -> Seen:
    """What points see of a sky that is the same at any time.

    Args:
        scenery: with crowns or without.
        transmittance: (1,).
        call: what they see with a mesh in the way, as an Estimate has it.
    """
    return _joined(Seen, [_dimmed(call(made()), share) for made, share in _views(scenery, transmittance)])


def seen_of(
    quantity: Quantity,
    scenery: Scenery,
    points: SurfacePoints,
    options: dict[str, Any],
    transmittance: np.ndarray,
) -> Seen:
    """A quantity at points of a surface, by its call, or by the hours of its light where what passes crowns has a date."""
    if len(transmittance) == 1 or scenery.wooded is None:
        return seen_through(scenery, transmittance[:1], lambda mesh: quantity.call(mesh, points, **options))
    given = {name: value for name, value in quantity.parameters.items() if name != "first_point"} | options
    if quantity.call is irradiation:
        names = ("weather", "period", "ground_albedo", "patches", "up", "north")
        light = light_of(**{name: given[name] for name in names})
        cast = RayOptions.of(len(points), seed=given["seed"], ids=points.id).by(workers=given["workers"])
        found = irradiation_through(scenery, points, light, transmittance, count=given["count"], options=cast)
        return _dimmed(found, np.ones(()))
    weather = read_weather(given["weather"], given["period"])
    weather = weather.chosen(weather.sun_altitude > 0.0)
    frame = sky_patches(up=given["up"], north=given["north"]).frame
    bare = quantity.call(scenery.bare(), points, **options)
    shares = shares_of_hours(transmittance, weather.hours)
    hours = sun_through(scenery, points, sun_directions(weather, frame), shares, workers=given["workers"])
    return replace(_dimmed(bare, np.ones(())), value=hours.astype(np.float32))


def check_dates(quantity: Quantity, transmittance: np.ndarray) -> None:
    """Refuses shares by date for a quantity that has none.

    Raises:
        ValueError: says how many there are.
    """
    if len(transmittance) != 1 and "weather" not in quantity.parameters:
        raise ValueError(
            f"transmittance: got {len(transmittance)} shares for the {quantity.title}, want one: it has no date"
        )


def irradiation_through(
    scenery: Scenery,
    points: SurfacePoints,
    light: Light,
    transmittance: np.ndarray,
    *,
    count: int,
    options: RayOptions,
) -> Irradiation:
    """What a period's light brings to points of a surface; arguments as of `irradiation` and `received`."""

    def through(mesh: Mesh, shares: np.ndarray) -> Irradiation:
        plan = Plan.of(PlacedPoints.of(mesh, points), count, options)
        return received(plan, light_through(light, shares), series=False)

    parts = [through(made(), shares) for made, shares in _views(scenery, shares_of_hours(transmittance, light.hours))]
    return _joined(Irradiation, parts)


def light_through(light: Light, shares: np.ndarray) -> Light:
    """A light of which a share is left in each of its hours, (T,)."""
    return replace(
        light,
        direct=light.direct * shares[light.sun_rows],
        radiance=light.radiance * shares[light.sky_rows],
        ground=light.ground * shares[light.sky_rows],
    )


def sun_through(scenery: Scenery, points: SurfacePoints, suns: np.ndarray, shares: np.ndarray, **options: Any) -> np.ndarray:
    """(P,) float64, the number of suns (T, 3) that points see, those behind crowns counted by the shares (T,) that pass."""
    views = _views(scenery, shares)
    return np.sum([direct_sun(made(), points, suns, weights=np.array(share), **options) for made, share in views], axis=0)


def _views(scenery: Scenery, shares: np.ndarray) -> tuple[tuple[Callable[[], Mesh], np.ndarray], ...]:
    """What makes the meshes to look at, one after the other, and how much what is seen there counts."""
    if scenery.wooded is None:
        return ((scenery.bare, np.ones_like(shares)),)
    return (scenery.wooded, 1.0 - shares), (scenery.bare, shares)


def _dimmed(found: Any, share: np.ndarray) -> Seen:
    """A share of an estimate."""
    numbers = found.value, found.standard_error, half_width_of(found)
    value, error, half = (np.float32(share * array.astype(np.float64)) for array in numbers)
    return Seen(value, error, half, found.rays, found.status)


def _joined(kind: type[Any], parts: list[Any]) -> Any:
    """The sum of results; what is no number of light is the first's."""
    summed = ("value", "standard_error", "half_width", "direct", "diffuse", "ground", "rays")
    names = [item.name for item in fields(kind) if item.name in summed]
    sums = {name: sum(getattr(part, name) for part in parts[1:]) for name in names}
    return replace(parts[0], **{name: getattr(parts[0], name) + more for name, more in sums.items()})
