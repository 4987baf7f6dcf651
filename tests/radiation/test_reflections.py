"""What faces send back: closed forms, what must stay as it is, and wrong reflections that the tests must reject."""

from dataclasses import fields, replace
from math import pi

import glass_cases as cases
import numpy as np
import pytest
import reflection_cases as known
from irradiation_cases import DAY
from weather_files import write_epw

import warpsample as ws
from warpsample.radiation.reflection import lobe_shares, patches, reflections
from warpsample.radiation.sky import irradiance as by_pictures
from warpsample.radiation.sky.patches import patches_at

pytest.importorskip("pvlib")
pytest.importorskip("pyradiance")
pytestmark = pytest.mark.slow  # seconds each, and kernels to compile


def bits(found):
    return {item.name: getattr(found, item.name) for item in fields(found) if item.name not in ("skipped", "hours")}


def same(found, other):
    return all(np.array_equal(array, bits(other)[name]) for name, array in bits(found).items())


def check_spheres(spheres=((0.5, 0.3), (0.95, 0.05))):
    """Integrating spheres, E0 / (1 - rho): evenly lit, so that nothing is left to chance."""
    for rho, tau in spheres:
        found = ws.irradiance(known.shell(rho, tau), known.points_inside(20), known.EVERYWHERE, 64)
        np.testing.assert_allclose(found.value, pi * tau / (1.0 - rho), rtol=1e-5)  # of float32 weights
        assert found.standard_error.max() < 1e-4 * pi


def check_canyon(reflectances, count=1024):
    points = known.in_canyon(64)
    found = ws.irradiance(known.canyon(*reflectances), points, known.SKY, count)
    for rows, right in zip((slice(64), slice(64, 128)), known.CANYON[reflectances], strict=True):
        value, error = known.mean_of(found, rows)
        assert abs(value - right) < 4.0 * error + known.TABLE
        assert error < 5e-3


def test_integrating_spheres():
    check_spheres()


@pytest.mark.thorough
def test_further_integrating_spheres():
    check_spheres(((0.1, 0.3), (0.8, 0.2)))


@pytest.mark.parametrize(
    "reflectances",
    [pytest.param(r, marks=() if r in ((0.5, 0.5), (0.2, 0.4)) else pytest.mark.thorough) for r in known.CANYON],
)
def test_canyons(reflectances):
    check_canyon(reflectances)


@pytest.mark.parametrize("rho", known.THREE_SURFACES)
def test_the_system_of_three_surfaces(rho):
    """A floor and two walls that are even each; by the mesh's own reflectance."""
    v = ws.view_factors(known.canyon(rho, rho), 2**16, groups=[0, 0, 1, 1, 2, 2])
    floor, *walls = v.radiosity(rho * v.outside) / rho
    assert (floor, *walls) == pytest.approx((known.THREE_SURFACES[rho][0], *[known.THREE_SURFACES[rho][1]] * 2), abs=1e-3)


def one_sided(monkeypatch):
    find_hit = patches.Patches.find_hit

    def fronts(self, face, directions, *where):
        back = np.einsum("ij,ij->i", self.mesh.face_normals[face], directions) > 0.0
        return np.where(back, -1, find_hit(self, face, directions, *where))

    monkeypatch.setattr(patches.Patches, "find_hit", fronts)


def one_order(monkeypatch):
    monkeypatch.setattr(reflections, "followed", lambda _matrix, emitted, _share: emitted)


def a_factor_pi(monkeypatch):
    monkeypatch.setattr(by_pictures, "_add_reflected", _weaker(by_pictures._add_reflected))


def _weaker(add):
    return lambda found, more: add(found, replace(more, value=more.value / pi, error=more.error / pi))


def no_reflection(monkeypatch):
    monkeypatch.setattr(by_pictures, "_add_reflected", lambda found, _more: found)


@pytest.mark.parametrize(
    "wrong", [one_sided, one_order, a_factor_pi, pytest.param(no_reflection, marks=pytest.mark.thorough)]
)
def test_wrong_reflections_are_rejected(wrong, monkeypatch):
    wrong(monkeypatch)
    with pytest.raises(AssertionError):
        check_spheres()
    if wrong is not one_sided:  # a street shows its points fronts alone
        with pytest.raises(AssertionError):
            check_canyon((0.5, 0.5))


def test_under_even_light_from_all_around_faces_that_swallow_nothing_are_not_seen():
    mesh = ws.load_mesh("courtyard", transmittance=0.4, reflectance=0.6)
    found = ws.irradiance(mesh, ws.sample_surface(mesh, 100, seed=2), known.EVERYWHERE, 256)
    off = (found.value - pi) / np.maximum(found.standard_error, 1e-6)
    assert np.sqrt(np.mean(np.square(off))) < 2.0  # a t distribution of few degrees of freedom
    assert abs(found.value.mean() / pi - 1.0) < 4e-3
    assert found.standard_error.mean() < 0.02 * pi


def test_a_pit_sends_out_what_it_does_not_swallow():
    assert abs(known.balance(0.6, 512, 0) - 1.0) < 2e-3  # 5 of the 4e-4 that runs are apart
    assert known.balance(0.6, 512, 0, refine=np.inf) > 1.01  # faces that stay whole are too bright in the corners


def test_faces_that_send_nothing_back_are_black_in_every_bit(monkeypatch):
    black = ws.load_mesh("courtyard")
    points = ws.sample_surface(black, 50, seed=3)
    monkeypatch.setattr(reflections, "trace_lobes", None)  # would fail
    for call in (
        lambda mesh: ws.irradiance(mesh, points, known.SKY, 64),
        lambda mesh: ws.irradiation(mesh, points, "athens", period=DAY, patches="tregenza", count=64),
    ):
        found = call(ws.as_mesh(black, reflectance=0.0))
        assert same(found, call(black))
        assert found.reflected is None


def test_parts_of_a_result_add_up_and_other_points_change_no_bit():
    mesh = ws.load_mesh("courtyard", reflectance=0.4)
    points = ws.sample_surface(mesh, 60, seed=3)
    some = np.arange(60) % 3 == 0
    options = {"period": DAY, "patches": "tregenza", "count": 64}
    both = {series: ws.irradiation(mesh, points, "athens", series=series, **options) for series in (False, True)}
    for series, found in both.items():
        total = sum(getattr(found, name).astype(float) for name in ("direct", "diffuse", "ground", "reflected"))
        np.testing.assert_allclose(found.value, total, rtol=1e-6)
        assert (found.reflected_error <= found.standard_error).all()
        assert found.reflected.max() > 0.0
        active = ws.irradiation(mesh, points, "athens", series=series, active=some, workers=1, **options)
        assert np.array_equal(active.value, np.where(some.reshape(-1, *[1] * series), found.value, 0.0))
        assert (active.rays[~some] == 0).all()
        later = ws.irradiation(mesh, points.take(slice(40, 60)), "athens", series=series, first_point=40, **options)
        assert np.array_equal(later.reflected_error, found.reflected_error[40:])
    np.testing.assert_allclose(both[True].reflected.sum(axis=1) / 1000.0, both[False].reflected, rtol=1e-4, atol=1e-6)


@pytest.mark.parametrize(("sky", "hours"), [("overcast", ("12-21", "12-21")), ("clear", ("12-21T20", "12-21T23"))])
def test_reflected_light_of_hours_without_direct_sun_adds_up(sky, hours, tmp_path):
    """Overcast days and nights; where 256 hours of a year had no direct sun, the call ended in NumPy's words."""
    mesh = ws.load_mesh("courtyard", reflectance=0.4)
    points, weather = ws.sample_surface(mesh, 60, seed=3), write_epw(tmp_path / "dark.epw", sky)
    given = {"period": hours, "patches": "tregenza", "count": 64}
    whole, hourly = (ws.irradiation(mesh, points, weather, series=series, **given) for series in (False, True))
    assert (whole.reflected.max() > 0.0) == (sky == "overcast")
    assert not hourly.direct.any()
    np.testing.assert_allclose(hourly.reflected.sum(axis=1) / 1000.0, whole.reflected, rtol=1e-4, atol=1e-6)  # of float32


def test_points_with_ids_of_their_own_are_looked_at_in_blocks(monkeypatch):
    mesh = ws.load_mesh("courtyard", reflectance=0.4)
    points = ws.sample_surface(mesh, 60, seed=3)
    right = ws.irradiance(mesh, points, known.SKY, 64)
    monkeypatch.setattr(lobe_shares, "_BLOCK", 1 << 8)
    own = ws.SurfacePoints(points.position, points.normal, points.face, id=np.arange(60))
    assert np.array_equal(ws.irradiance(mesh, own, known.SKY, 64).reflected, right.reflected)


def test_a_floor_that_nothing_shades_sends_what_the_ground_sends():
    """Beside it, and instead of it: a wall point whose lower half of the lobe the floor fills."""
    floor = ws.as_mesh(cases.sheet(1e4, 0.0), reflectance=0.3)
    wall = ws.SurfacePoints(np.tile([[0.0, 0.0, 1.0]], (40, 1)), np.tile([[1.0, 0.0, 0.0]], (40, 1)))
    options = {"period": DAY, "ground_albedo": 0.3, "patches": "tregenza"}
    found = ws.irradiation(floor, wall, "athens", **options)
    black = ws.irradiation(ws.as_mesh(cases.sheet(1e-3, -1e3)), wall, "athens", **options)
    error = found.reflected_error.mean(dtype=float)  # all points share that of the floor
    assert abs((found.reflected + found.ground - black.ground).mean(dtype=float)) < 4.0 * error + 2e-4 * black.ground[0]
    assert error < 0.01 * black.ground[0]
    assert found.ground.max() < 0.01 * black.ground[0]


def test_colours_go_apart():
    mesh, points = known.canyon(0.5, 0.5), known.in_canyon(8)
    grey = ws.irradiance(mesh, points, known.SKY, 64)
    red = ws.irradiance(mesh, points, known.SKY[..., None] * [2.0, 0.0, 1.0], 64)
    np.testing.assert_allclose(red.value, grey.value[:, None] * [2.0, 0.0, 1.0], rtol=1e-5)
    np.testing.assert_allclose(red.reflected_error[:, 0], 2.0 * grey.reflected_error, rtol=1e-4)
    assert red.interval()[0].shape == (16, 3)


def test_rays_that_leave_a_point_behind_its_face_bring_nothing():
    """A point on a black sheet with a tilted normal, as texels have, above a sheet that is lit from below."""
    mesh = cases.made_of((cases.sheet(1.0, 0.0), 0.0), (cases.sheet(5.0, -1.0), 0.0))
    mesh = ws.as_mesh(mesh, reflectance=[0.0, 0.0, 0.9, 0.9])
    point = ws.SurfacePoints([[0.1, 0.2, 0.0]] * 4, [[0.9, 0.0, 0.1]] * 4, face=[0] * 4)
    free = ws.SurfacePoints(point.position - np.array([0.0, 0.0, 0.5]), point.normal)
    assert (ws.irradiance(mesh, free, known.EVERYWHERE, 256).reflected > 0.1).all()
    assert (ws.irradiance(mesh, point, known.EVERYWHERE, 256).reflected == 0.0).all()


def test_a_tolerance_is_refused_where_faces_reflect():
    with pytest.raises(ValueError, match="^tolerance: got 0.01 for a mesh with a reflectance, want None"):
        ws.irradiance(known.pit(0.5), known.points_inside(2), known.SKY, tolerance=0.01)


def test_a_message_says_that_the_parts_are_more_than_the_number():
    """An edge has at most 1,024 parts, and 1e-9 would need more."""
    many = ws.as_mesh((np.tile(np.eye(3), (40_000, 1)), np.arange(120_000).reshape(-1, 3)), reflectance=0.5)
    with pytest.raises(MemoryError, match=r"^refine: more than [\d,]+ parts of faces that reflect"):
        patches.patches_of(many, 1e-9)
    with pytest.raises(MemoryError, match=r"^refine: [\d,]+ parts of faces that reflect"):
        patches.patches_of(many, 2e-3)


def test_an_edge_that_would_need_too_many_parts_is_named():
    """Before, its parts were longer than `refine`, without a word, and half the `refine` changed nothing."""
    strip = ws.as_mesh(([[0.0, 0, 0], [3000, 0, 0], [3000, 8, 0]], [[0, 1, 2]]), reflectance=0.5)
    wants = r"^refine: got 1, want at least 2\.92\d+: the longest edge, of 3000\.01, is cut into at most 1,024 parts$"
    with pytest.raises(ValueError, match=wants):
        patches.patches_of(strip, 1.0)
    assert len(patches.patches_of(strip, 2.93)) == 2 * 1024**2


@pytest.mark.parametrize("refine", [None, np.inf, 0.3])
def test_rays_meet_the_patches_that_places_are_on(refine):
    mesh = known.pit(np.where(np.arange(10) == 4, 0.0, 0.5))
    made = patches.patches_of(mesh, refine)
    assert (len(np.unique(made.face)), made.back.sum()) == (9, len(made) / 2)
    at = made.places(5, 0)
    hits = ws.trace(mesh, at.position + 1e-3 * at.normal, -at.normal)
    patch = made.find_hit(hits.face, -at.normal, hits.distance, lambda rays: (at.position + 1e-3 * at.normal)[rays])
    assert np.array_equal(patch, np.repeat(np.arange(len(made)), 5))
    longest = np.sqrt(2.0) / np.maximum(made.cuts, 1)
    assert {None: len(made) > 4000, np.inf: len(made) == 18, 0.3: longest[made.cuts > 0].max() <= 0.3}[refine]
    centre = at.position.reshape(len(made), 5, 3).mean(axis=1)
    assert np.linalg.norm(at.position.reshape(len(made), 5, 3) - centre[:, None], axis=2).max() <= longest.max()


def test_patches_of_the_sky_are_found_by_direction():
    way = np.random.default_rng(0).normal(size=(200_000, 3))
    way /= np.linalg.norm(way, axis=1, keepdims=True)
    for name in ("tregenza", "reinhart4"):
        sky = ws.sky_patches(name, up=(0.1, 0.2, 1.0), north=(1.0, 0.0, 0.0))
        assert np.array_equal(patches_at(sky, sky.directions), np.arange(len(sky)))
        found = patches_at(sky, way)
        assert np.array_equal(found < 0, way @ sky.up < 0.0)
        number, expected = np.bincount(found[found >= 0], minlength=len(sky)), 2e5 * sky.solid_angles / (4.0 * pi)
        chi_square = (np.square(number - expected) / expected).sum()
        assert abs(chi_square - len(sky)) < 5.0 * np.sqrt(2.0 * len(sky))


def test_radiosity_takes_the_reflectance_of_the_mesh(tmp_path):
    """A cube room with one glowing side: shared/LIGHT.md's table, by groups of two triangles."""
    vertices, faces = cases.box([0.0] * 3, [1.0] * 3)
    room = ws.as_mesh((vertices, faces[:, ::-1]), reflectance=0.5)
    v = ws.view_factors(room, 2**16, groups=np.arange(12) // 2, reciprocal=True)
    J = v.radiosity([1.0, 0, 0, 0, 0, 0])
    np.testing.assert_allclose(J, [1.09091, 0.18175, *[0.18184] * 4], rtol=2e-3)
    assert np.array_equal(J, v.radiosity([1.0, 0, 0, 0, 0, 0], 0.5))
    v.save(tmp_path / "v.npz")
    assert np.array_equal(ws.ViewFactors.load(tmp_path / "v.npz").radiosity(1.0), v.radiosity(1.0))
    halves = ws.view_factors(ws.as_mesh(room, reflectance=np.arange(12) % 2), 16, groups=np.arange(12) // 2)
    np.testing.assert_allclose(halves.reflectance, 0.5)
    with pytest.raises(ValueError, match="^reflectance: got None for view factors of a mesh without a reflectance"):
        ws.view_factors((vertices, faces), 16).radiosity(1.0)
