"""Irradiation of points: splits, turns, points without a normal, every field, and bad input."""

import sys
from dataclasses import fields
from types import SimpleNamespace

import numpy as np
import pytest
import trimesh
from irradiation_cases import BEHIND, DAY, PARTS, points

import warpsample as ws
from warpsample.host.locks import imported
from warpsample.radiation.reflection.reflections import Reflections
from warpsample.tracing.options import RayOptions

pytestmark = pytest.mark.slow  # seconds each, and kernels to compile; .ci/run runs them too

pytest.importorskip("pvlib")
pyradiance = pytest.importorskip("pyradiance")


def test_a_run_can_be_split(yard, athens):
    mesh, where = yard
    given = {"weather": athens, "period": DAY, "patches": "tregenza", "count": 64, "seed": 5}
    whole = ws.irradiation(mesh, where, **given)
    active = np.arange(60) % 3 == 0
    some = ws.irradiation(mesh, where, **given, active=active, workers=1)
    rest = ws.SurfacePoints(where.position[40:], where.normal[40:], where.face[40:])
    last = ws.irradiation(mesh, rest, **given, first_point=40, skip=False)
    for name in ("value", "standard_error", *PARTS):
        assert np.array_equal(getattr(some, name)[active], getattr(whole, name)[active]), name
        assert np.array_equal(getattr(last, name), getattr(whole, name)[40:]), name
        assert not getattr(some, name)[~active].any(), name
    assert (some.status[~active] == ws.PointStatus.INACTIVE).all()


def test_points_without_a_normal_receive_nothing(athens):
    found = ws.irradiation(
        BEHIND, points([(0, 0, 1), (0, 0, 0), (0, np.nan, 1)]), athens, period=DAY, patches="tregenza", series=True
    )
    assert found.status.tolist() == [0, ws.PointStatus.ZERO_NORMAL, ws.PointStatus.NONFINITE_NORMAL]
    assert found.value[0].any()
    assert not found.value[1:].any()


def test_a_period_without_light_is_dark(athens):
    for series, shape in ((False, (1,)), (True, (1, 2))):
        found = ws.irradiation(BEHIND, points([(0, 0, 1)]), athens, period=("12-31T23", "01-01T01"), series=series)
        assert found.value.shape == shape
        assert not any(getattr(found, name).any() for name in ("value", "standard_error", *PARTS))


def test_a_turn_of_everything_changes_nothing(yard, athens):
    mesh, where = yard
    turn = trimesh.transformations.rotation_matrix(2.0, (1.0, 2.0, 3.0))[:3, :3]
    turned = ws.SurfacePoints(where.position @ turn.T, where.normal.astype(np.float64) @ turn.T, where.face)
    given = {"weather": athens, "period": DAY, "patches": "tregenza"}
    right = ws.irradiation(mesh, where, **given)
    found = ws.irradiation((mesh.vertices @ turn.T, mesh.faces), turned, **given, up=turn[:, 2], north=turn[:, 1])
    np.testing.assert_allclose(found.direct, right.direct, atol=2e-4 * right.direct.max())
    error = np.hypot(found.standard_error.astype(np.float64), right.standard_error)
    assert (np.abs(found.value.astype(np.float64) - right.value) < 6.0 * error + 2e-3).all()


def test_every_field_has_a_row_for_each_point(yard, athens):
    mesh, where = yard
    found = ws.irradiation(mesh, where, athens, period=DAY, patches="tregenza", count=64)
    of_no_point = ("skipped", "reflected", "reflected_error", "reflected_runs")
    shapes = {item.name: getattr(found, item.name).shape for item in fields(found) if item.name not in of_no_point}
    assert found.reflected is found.reflected_error is found.reflected_runs is None  # the mesh is black
    assert shapes.pop("hours") == (24,)
    assert set(shapes.values()) == {(60,)}
    assert found.value.dtype == np.float32


WRONG = {
    "ground_albedo": (1.5, ValueError, "got 1.5, want a number from 0 to 1"),
    "period": (("06-01", "06-31"), ValueError, "want two days"),
    "patches": ("klems", ValueError, "got 'klems', want one of tregenza, reinhart2, reinhart4"),
    "north": ((0, 0, 3), ValueError, "along up"),
    "up": ((0, 0, 0), ValueError, "got"),
    "series": ("yes", TypeError, "got 'yes', want True or False"),
    "count": (0, ValueError, "got 0"),
    "points": (3, TypeError, "want SurfacePoints"),
    "weather": ("gone.epw", FileNotFoundError, "got 'gone.epw', which is missing"),
}


@pytest.mark.parametrize("name", WRONG)
def test_bad_input_is_a_sentence_before_any_work(athens, name, monkeypatch):
    value, kind, message = WRONG[name]
    monkeypatch.setattr("warpsample.radiation.weather.light.perez_sky", None)  # what would start the work
    given = {"mesh": BEHIND, "points": points([(0, 0, 1)]), "weather": athens} | {name: value}
    with pytest.raises(kind, match=rf"^{name}: .*{message}"):
        ws.irradiation(**given)


def test_too_many_hours_are_reported(athens, monkeypatch):
    monkeypatch.setattr("psutil.virtual_memory", lambda: type("Memory", (), {"available": 1 << 20}))
    with pytest.raises(MemoryError, match="8,760 hours of 100 points need"):
        ws.irradiation(BEHIND, points(np.tile([0, 0, 1], (100, 1))), athens, patches="tregenza", series=True)


@pytest.mark.parametrize(("columns", "size"), [(1, 24 + 8 * 4), (3, 3 * (24 + 8 * 4)), (4, 4 * 24)])
def test_the_memory_of_reflected_light_is_checked(monkeypatch, columns, size):
    """Three arrays of float64, and eight runs of float32 for up to three columns."""
    light = Reflections(None, (np.ones((1, columns), np.float32),) * 8)
    many = points(np.tile([0, 0, 1], (10, 1)))
    monkeypatch.setattr("warpsample.host.engine._ALWAYS_FREE", 0)
    monkeypatch.setattr("psutil.virtual_memory", lambda: SimpleNamespace(available=10 * size - 1))
    with pytest.raises(MemoryError, match="the numbers of reflected light at 10 points need"):
        light.at(many, 8, RayOptions.of(10))
    monkeypatch.setattr("psutil.virtual_memory", lambda: SimpleNamespace(available=10 * size))
    with pytest.raises(AttributeError):  # of the patches, which are None
        light.at(many, 8, RayOptions.of(10))


def test_pyradiance_is_asked_for_by_the_extra(athens, monkeypatch):
    monkeypatch.setitem(sys.modules, "pyradiance", None)
    imported.cache_clear()
    with pytest.raises(ModuleNotFoundError, match=r"pip install '\.\[radiation\]'"):
        ws.irradiation(BEHIND, points([(0, 0, 1)]), athens)
