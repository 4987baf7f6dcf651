"""Cells of model "tin" beside faces as steep as a wall see what a point just above their vertex sees.

Of the judges in float64 one looks from 1 µm above the vertex, the other from 100 µm: where they differ, a value hangs on how
far above the surface a point is.
"""

import numpy as np
import pytest
from affine import Affine
from steep_terrain import AZIMUTHS, SIDE, blocked, horizons, sky_of, steep_heights

pytest.importorskip("rasterio")
pytest.importorskip("rioxarray")

import warpsample as ws
from warpsample import rasters
from warpsample.radiation.sky.patches import patches_at, sky_patches
from warpsample.radiation.weather.light import light_of, sun_directions
from warpsample.radiation.weather.weather import read_weather

NEAR = Affine(1.0, 0.0, 500.0, 0.0, -1.0, 500.0)  # no longitudes and latitudes: a cliff of 5.7 km is taken for degrees
FAR = Affine(1.0, 0.0, 5000000.3, 0.0, -1.0, 5000000.7)
NAMES = ["cliff 85", "canyon 89", "spikes 89", "steps 85", "cliff 89.99"]
# By (far away, the steepest steps): as accurate far away, which one near place shows.
TIERS = {
    (True, True): (),
    (True, False): pytest.mark.slow,
    (False, True): pytest.mark.slow,
    (False, False): pytest.mark.thorough,
}
LIFTS = np.array([[0.0, 0.0, 1e-6], [0.0, 0.0, 1e-4]])
COUNT = 8192


def check(name, found, errors, low, high, lift=0.0):
    """Checks values where the judges agree to 0.01: to 0.003 and five standard errors, which one in 10^6 cells exceeds.

    `lift` is the height in cells at which rays start: a value may be off by that where neighbours are 0.3 cells high.
    """
    agree = np.abs(low - high) < 0.01
    off = np.abs(found - low)
    assert agree.mean() > 0.9
    assert (off <= 0.003 + lift + 5.0 * errors)[agree].all(), f"{name}: off by up to {off[agree].max():.4f}"


def numbers(made):
    return made.value.values.ravel(), made.standard_error.values.ravel()


@pytest.mark.parametrize(
    ("name", "transform"),
    [
        pytest.param(name, transform, marks=TIERS[transform is FAR, name == "steps 85"])
        for name in NAMES
        for transform in (NEAR, FAR)
    ],
)
def test_the_sky_above_steep_terrain_is_that_of_the_vertex(name, transform):
    source = steep_heights(name), transform, None
    made = rasters.surface(source, model="tin")
    position = made.points()[0].position
    lift = 2.0**-19 * 0.5 * np.ptp(position[:, 2])  # 5 mm beside a cliff of 5.7 km, else less than 0.2 mm
    slopes = [horizons(made.mesh, position + above) for above in LIFTS]
    for receiver in ("horizontal", "surface"):
        points, _ = made.points(receiver)
        sky, visible, ambient = zip(*(sky_of(points.normal, slope) for slope in slopes), strict=True)
        for how in ({}, {"sequence": "sobol"}, {"tile": 5, "margin": SIDE}):
            found = rasters.sky_view_factor(source, COUNT, model="tin", receiver=receiver, **how)
            check(f"sky {how}, {receiver}", *numbers(found), *sky, lift)
        found = ws.ambient_occlusion(made.mesh, points, COUNT)
        check(f"ao, {receiver}", found.value, found.standard_error, *ambient, lift)
    check("visible sky", *numbers(rasters.visible_sky(source, COUNT, model="tin")), *visible, lift)


def sun_seen(made, points, suns):
    """For both judges, (P, S) the cosines to the suns that each point sees, else 0."""
    cosines = np.maximum(points.normal.astype(np.float64) @ suns.T, 0.0)
    return [np.where(blocked(made.mesh, points.position + above, suns), 0.0, cosines) for above in LIFTS]


@pytest.mark.parametrize("receiver", ["horizontal", "surface"])
@pytest.mark.parametrize("name", [pytest.param(n, marks=() if n == "steps 85" else pytest.mark.slow) for n in NAMES])
def test_the_hours_of_sun_on_steep_terrain_are_those_of_the_vertex(name, receiver):
    pytest.importorskip("pvlib")
    source, period = (steep_heights(name), FAR, None), ("06-20", "06-21")
    made = rasters.surface(source, model="tin")
    points, _ = made.points(receiver)
    weather = read_weather("athens", period)
    suns = sun_directions(weather.chosen(weather.sun_altitude > 0.0), sky_patches().frame)
    low, high = ((cosines > 0.0).sum(axis=1) for cosines in sun_seen(made, points, suns))
    for tiles in ({}, {"tile": 5, "margin": SIDE}):
        found = rasters.sun_hours(source, "athens", model="tin", receiver=receiver, period=period, **tiles)
        check(f"sun hours {tiles}", *numbers(found), low, high)
    met = ws.trace(made.mesh, points, np.tile(suns, (len(points), 1, 1)), any_hit=True).face >= 0
    front = points.normal.astype(np.float64) @ suns.T > 0.0
    check("rays of trace", (front & ~met).sum(axis=1), np.zeros(len(points)), low, high)


@pytest.mark.slow
@pytest.mark.parametrize("receiver", ["horizontal", "surface"])
@pytest.mark.parametrize("name", [pytest.param(n, marks=() if n == "steps 85" else pytest.mark.thorough) for n in NAMES])
def test_the_irradiation_of_steep_terrain_is_that_of_the_vertex(name, receiver):
    """Shares of what a day brings to open level ground; directions of the sky are a degree apart, its patches twelve."""
    pytest.importorskip("pvlib")
    pytest.importorskip("pyradiance")
    source, period = (steep_heights(name), NEAR, None), ("06-21", "06-21")
    made = rasters.surface(source, model="tin")
    points, _ = made.points(receiver)
    options = {"period": period, "patches": "tregenza"}
    light = light_of("athens", ground_albedo=0.2, up=(0.0, 0.0, 1.0), north=(0.0, 1.0, 0.0), **options)
    height = np.radians(np.arange(-89.5, 90.0))
    level = np.stack([np.cos(AZIMUTHS), np.sin(AZIMUTHS), 0.0 * AZIMUTHS], axis=1)
    sky = np.cos(height)[:, None] * level[:, None] + np.sin(height)[:, None] * np.array([0.0, 0.0, 1.0])
    patch = patches_at(light.sky, sky.reshape(-1, 3)).reshape(sky.shape[:2])
    bright = np.where(patch < 0, light.ground.sum() / np.pi, light.radiance.sum(axis=1)[patch])
    bright *= np.cos(height) * np.radians(1.0) * (2.0 * np.pi / len(AZIMUTHS))
    judges = []
    for cosines, above in zip(sun_seen(made, points, light.sun), LIFTS, strict=True):
        horizon = np.arctan(horizons(made.mesh, points.position + above))
        total = cosines @ light.direct
        for point, normal in enumerate(points.normal):
            free = bright * (height > horizon[point, :, None])
            total[point] += (free * np.maximum(sky @ normal, 0.0)).sum()
        judges.append(total / 1000.0)
    open_ground = ((light.sun[:, 2] * light.direct).sum() + (bright * np.maximum(sky[..., 2], 0.0)).sum()) / 1000.0
    found = rasters.irradiation(source, "athens", model="tin", receiver=receiver, count=COUNT, **options)
    shares = [array / open_ground for array in (*numbers(found), *judges)]
    check("irradiation", *shares, 2.0**-19 * 0.5 * np.ptp(points.position[:, 2]))


@pytest.mark.parametrize(
    ("heights", "transform", "receiver", "cells", "tiles"),
    [
        pytest.param(
            "uniform",
            Affine(1.0, 0.4, 0.0, 0.2, -2.2, 0.0),
            "horizontal",
            [(21, 21), (52, 24), (7, 31)],
            ({}, {"tile": 30, "margin": 60}),
            marks=pytest.mark.thorough,
        ),
        ("normal", Affine(1.0, 0.0, 0.0, 0.0, -1.0, 0.0), "horizontal", [(53, 55)], ({},)),
        pytest.param(
            "normal",
            Affine(1.0, 0.0, 0.0, 0.0, -1.0, 0.0),
            "horizontal",
            [(27, 44), (0, 25)],
            ({},),
            marks=pytest.mark.thorough,
        ),
        pytest.param(
            "normal", NEAR, "surface", [(53, 55), (47, 46)], ({}, {"tile": 30, "margin": 60}), marks=pytest.mark.thorough
        ),
    ],
)
def test_joined_cells_of_four_facets_see_what_a_point_just_above_their_centre_sees(
    heights, transform, receiver, cells, tiles
):
    """Rays of these cells, the worst of 3,600, started aside, up to halfway to a facet's middle: off by 0.02 to 0.05."""
    rng = np.random.default_rng(3)
    source = rng.uniform(0.0, 10.0, (60, 60)) if heights == "uniform" else rng.normal(0.0, 1.0, (60, 60))
    source, cells = (source, transform, None), np.ravel_multi_index(np.transpose(cells), (60, 60))
    made = rasters.surface(source)
    points = made.points(receiver)[0].take(cells)
    low, high = (sky_of(points.normal, horizons(made.mesh, points.position + above))[0] for above in LIFTS)
    assert (np.abs(low - high) < 1e-3).all()
    for how in tiles:
        value, error = (array[cells] for array in numbers(rasters.sky_view_factor(source, 1024, receiver=receiver, **how)))
        assert (np.abs(value - low) <= 0.002 + 4.0 * error).all(), f"{how}: {value}, not {low}"


def test_the_sky_is_never_negative_beside_walls():
    """On faces as steep as 40 km over a cell, the sky of an azimuth is less than rounding, which made values of -9e-12."""
    heights = np.random.default_rng(0).uniform(0.0, 40e3, (30, 30))
    for count in (2, 16):
        found = rasters.sky_view_factor((heights, NEAR, None), count, model="tin", receiver="surface").value
        assert np.isfinite(found).all()
        assert (found.values == 0.0).any()
        assert found.min() == 0.0
