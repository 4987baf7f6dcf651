"""Global ids of points: the random numbers of a point depend on its id alone, in every call and any selection of points."""

from dataclasses import fields, is_dataclass
from inspect import signature

import numpy as np
import pytest
from weather_files import write_epw
from weights_of_tests import by_point

import warpsample as ws
from warpsample.output.quantities import quantities
from warpsample.radiation.quantities.sun_hours import sun_hours

FIRST, POINTS = 2**33 - 20, 60
"""The ids cross a multiple of 2^32, at which their upper half changes."""

SUNS = np.random.default_rng(3).normal(size=(40, 3)) + np.float64([0.0, 0.0, 1.0])
PICTURE = np.random.default_rng(0).random((8, 16, 3))
ESTIMATES = {
    "occlusion": lambda mesh, at, **o: ws.ambient_occlusion(mesh, at, 40, **o),
    "falloff": lambda mesh, at, **o: ws.ambient_occlusion(mesh, at, 40, max_distance=9.0, falloff=1.5, **o),
    "wp.Mesh": lambda mesh, at, **o: ws.ambient_occlusion(mesh, at, 40, tracer="warp", **o),
    "sky": lambda mesh, at, **o: ws.sky_view_factor(mesh, at, 40, sequence="sobol", **o),
    "bent": lambda mesh, at, **o: ws.bent_normals(mesh, at, 40, **o),
    "light": lambda mesh, at, **o: ws.irradiance(mesh, at, PICTURE, 40, **o),
    "function": lambda mesh, at, **o: ws.integrate(at, by_point, 40, mesh=mesh, distribution="ggx(alpha=0.3)", **o),
    "free": lambda _, at, **o: ws.integrate(at, by_point, 40, **o),
    "distance": lambda mesh, at, **o: ws.mean_distance(mesh, at, 40, **o),
    "visible": lambda mesh, at, **o: ws.visible_sky(mesh, at, 40, **o),
}
PATCHES_AND_SUNS = {
    "patches": lambda mesh, at, **o: ws.sky_matrix(mesh, at, 300, **o),
    "folded": lambda mesh, at, **o: ws.sky_matrix(mesh, at, 300, fold=np.ones(145), **o),
    "suns": lambda mesh, at, **o: ws.direct_sun(mesh, at, SUNS, **o),
    "discs": lambda mesh, at, **o: ws.direct_sun(mesh, at, SUNS, disc=20.0, **o),
    "weighed": lambda mesh, at, **o: ws.direct_sun(mesh, at, SUNS, disc=20.0, weights=np.ones(40), **o),
}
DIRECTIONS = {
    f"{count} by {sequence}": lambda _, at, c=count, s=sequence, **o: ws.sample_directions(at, c, sequence=s, pdf=True, **o)
    for count in (1, 7, 64)
    for sequence in ("sobol", "independent", "fibonacci")
}
QUICK = {"occlusion", "patches", "discs", "7 by sobol"}
"""The others compile kernels for seconds."""
LONG = {f"{rest} by {sequence}" for rest, sequence in ((1, "sobol"), (64, "sobol"), (7, "independent"), (64, "independent"))}
LONG |= {"1 by fibonacci", "7 by fibonacci", "function"}
"""Each sequence, each count and an integrand without a mesh are also in a test that is not thorough."""
CALLS = [
    pytest.param(call, id=name, marks=[] if name in QUICK else pytest.mark.thorough if name in LONG else pytest.mark.slow)
    for name, call in (ESTIMATES | PATCHES_AND_SUNS | DIRECTIONS).items()
]


@pytest.fixture(scope="module")
def scene():
    """Return a mesh and points; one point has no finite position and one has no normal."""
    mesh = ws.load_mesh("courtyard")
    points = ws.sample_surface(mesh, POINTS, seed=4)
    position, normal = points.position.copy(), points.normal.copy()
    position[7], normal[25] = np.nan, 0.0
    return mesh, ws.SurfacePoints(position, normal, points.face)


@pytest.fixture(scope="module")
def athens(tmp_path_factory):
    return write_epw(tmp_path_factory.mktemp("weather") / "athens.epw")


def with_ids(points, ids):
    return ws.SurfacePoints(points.position, points.normal, points.face, id=ids)


def rows_of(found):
    """Return by name all arrays of a result with one row per point."""
    if not is_dataclass(found):
        return {"answer": found}
    arrays = {item.name: getattr(found, item.name) for item in fields(found)}
    return {name: array for name, array in arrays.items() if isinstance(array, np.ndarray) and name != "hours"}


def assert_rows(found, right, rows=slice(None)):
    found, right = rows_of(found), rows_of(right)
    assert found.keys() == right.keys()
    for name, array in found.items():
        assert np.array_equal(array, right[name][rows], equal_nan=array.dtype.kind == "f"), name


def assert_laws(call, mesh, points):
    """Check that ids act like first_point, and stay with their points in any order, part, mask and number of threads."""
    ids = np.arange(FIRST, FIRST + POINTS, dtype=np.uint64)
    whole = call(mesh, points, seed=5, first_point=FIRST)
    owned = with_ids(points, ids)
    assert_rows(call(mesh, owned, seed=5), whole)
    order = np.random.default_rng(1).permutation(POINTS)
    turned = with_ids(points, ids[order][np.argsort(order)]).take(order)
    assert_rows(call(mesh, turned, seed=5, workers=2), whole, order)
    few = np.array([59, 3, 20, 19, 25, 7, 41])
    assert_rows(call(mesh, owned.take(few), seed=5), whole, few)
    active = np.arange(POINTS) % 3 == 0
    masked = call(mesh, turned, seed=5, active=active[order])
    chosen = active[order]
    assert_rows_where(masked, whole, chosen, order[chosen])
    with pytest.raises(ValueError, match=r"^first_point: got 3, want 0 for points that have their own ids, `id`$"):
        call(mesh, owned, seed=5, first_point=3)


def assert_rows_where(found, right, chosen, rows):
    found, right = rows_of(found), rows_of(right)
    for name, array in found.items():
        assert np.array_equal(array[chosen], right[name][rows], equal_nan=array.dtype.kind == "f"), name


@pytest.mark.parametrize("call", CALLS)
def test_what_is_drawn_follows_the_ids(call, scene):
    assert_laws(call, *scene)


@pytest.mark.slow
@pytest.mark.parametrize("name", quantities())
def test_every_quantity_follows_the_ids(name, scene, athens):
    """This includes quantities that are missing in the list of calls above."""
    pytest.importorskip("pvlib")
    pytest.importorskip("pyradiance")
    mesh, points = scene
    call = quantities()[name].call
    taken = signature(call).parameters
    given = {"radiance": PICTURE, "weather": athens, "period": ("06-21T09", "06-21T12"), "count": 40, "patches": "tregenza"}
    given = {key: value for key, value in given.items() if key in taken}
    ids = np.arange(FIRST, FIRST + POINTS)
    whole = call(mesh, points, **given, first_point=FIRST) if "first_point" in taken else call(mesh, points, **given)
    assert_rows(call(mesh, with_ids(points, ids).take(np.arange(POINTS)[::-1]), **given), whole, slice(None, None, -1))


@pytest.mark.slow
@pytest.mark.parametrize("series", [False, True])
def test_irradiation_follows_the_ids(series, scene, athens):
    pytest.importorskip("pvlib")
    pytest.importorskip("pyradiance")
    given = {"period": ("06-21T09", "06-21T12"), "patches": "tregenza", "count": 64, "series": series}
    assert_laws(lambda mesh, at, **o: ws.irradiation(mesh, at, athens, **given, **o), *scene)


@pytest.mark.slow
def test_quantities_take_points_with_ids(scene, athens):
    pytest.importorskip("pvlib")
    mesh, points = scene
    ids = np.arange(POINTS)[::-1]
    given = {"period": ("06-21T09", "06-21T12"), "seed": 5}
    whole = sun_hours(mesh, points, athens, **given)
    assert_rows(sun_hours(mesh, with_ids(points, ids), athens, **given), whole)


def test_some_calls_differ_by_the_ids(scene):
    """Otherwise the checks above would pass for calls that ignore ids."""
    mesh, points = scene
    one, other = (ws.ambient_occlusion(mesh, with_ids(points, np.arange(POINTS) + k), 40).value for k in (0, 2**32))
    assert not np.array_equal(one, other)
    alike = ws.sample_directions(with_ids(points, np.full(POINTS, 9)), 8).vectors
    assert np.array_equal(alike[0], ws.sample_directions(points.take([0]), 8, first_point=9).vectors[0])


@pytest.mark.slow
def test_integrands_get_the_ids(scene):
    _mesh, points = scene
    ids = np.arange(POINTS)[::-1] * 3
    whole = ws.integrate(points, by_point, 8, first_point=0)
    found = ws.integrate(with_ids(points, ids), by_point, 8)
    right = [ws.integrate(points.take([row]), by_point, 8, first_point=int(id)).value[0] for row, id in enumerate(ids)]
    assert np.array_equal(found.value, right)
    assert not np.array_equal(found.value, whole.value)


@pytest.mark.slow
def test_with_a_tolerance_ids_count_like_the_first(scene):
    """The number of rays follows from a trial at some rows; in another order the trial has other rows."""
    mesh, points = scene
    ids = np.arange(FIRST, FIRST + POINTS)
    right = ws.ambient_occlusion(mesh, points, 512, tolerance=0.05, first_point=FIRST)
    assert_rows(ws.ambient_occlusion(mesh, with_ids(points, ids), 512, tolerance=0.05), right)
