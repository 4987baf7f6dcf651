"""Invalid rays are counted, and arguments that `trace` cannot use are named before any work."""

from types import SimpleNamespace

import numpy as np
import pytest
import warp as wp

import warpsample as ws

TRIANGLE = ws.as_mesh(([(0, 0, 0), (2, 0, 0), (0, 2, 0)], [(0, 1, 2)]))
tracers = pytest.mark.parametrize("tracer", ["wide", "warp"])
queries = pytest.mark.parametrize("any_hit", [False, True], ids=["nearest", "any"])


@tracers
@queries
def test_invalid_rays_are_counted(tracer, any_hit):
    origins, directions = np.tile([[0.5, 0.5, 3.0]], (7, 1)), np.tile([[0.0, 0.0, -1.0]], (7, 1))
    directions[1], directions[2, 1], directions[3, 0] = 0.0, np.nan, np.inf
    origins[4, 2], origins[5, 0] = np.nan, -np.inf
    for dtype in (np.float32, np.float64):
        hits = ws.trace(TRIANGLE, origins.astype(dtype), directions.astype(dtype), any_hit=any_hit, tracer=tracer)
        assert hits.face.tolist() == [0, -1, -1, -1, -1, -1, 0]
        assert np.isnan(hits.distance).tolist() == [False, True, True, True, True, True, False]
        assert hits.invalid == 5


SHORT_AND_LONG = [0.0, -0.0, 5e-324, 1e-300, 1e-45, 1e-40, 1e-30, 1.0, 3e38, 1e300, np.inf, np.nan]
"""Lengths of directions: float32 has those from 1e-45 to 3e38."""


@pytest.mark.parametrize("away", [3.0, 1e8], ids=["near", "far off"])
@pytest.mark.parametrize("dtype", [np.float32, np.float64])
def test_a_direction_of_no_length_or_an_infinite_one_is_invalid_and_others_are_not(dtype, away):
    with np.errstate(over="ignore", under="ignore"):
        length = np.array(SHORT_AND_LONG).astype(dtype)
    directions = np.stack([0.0 * np.nan_to_num(length), 0.0 * np.nan_to_num(length), -length], axis=1).astype(dtype)
    invalid = ~(np.isfinite(length) & (length != 0.0))
    origins = np.tile(np.array([0.5, 0.5, away], dtype), (len(length), 1))
    kind = {np.float32: wp.vec3, np.float64: wp.vec3d}[dtype]
    on_warp = [wp.array(array, dtype=kind, device="cpu") for array in (origins, directions)]
    for any_hit in (False, True):
        for given in ((origins, directions), (origins[0], directions), on_warp):
            hits = ws.trace(TRIANGLE, *given, any_hit=any_hit)
            distance, face = (array.numpy() if given is on_warp else array for array in (hits.distance, hits.face))
            assert np.array_equal(np.isnan(distance), invalid)
            assert np.array_equal(face, np.where(invalid, -1, 0))
            assert hits.invalid == invalid.sum()
    found = ws.trace_all(TRIANGLE, origins, directions)
    assert np.array_equal(np.diff(found.first), np.where(invalid, 0, 1))
    assert found.invalid == invalid.sum()
    foot = ws.SurfacePoints(origins * [1.0, 1.0, 0.0], np.tile(np.float32([0.0, 0.0, 1.0]), (len(length), 1)))
    hits = ws.trace(TRIANGLE, foot, directions)
    assert np.array_equal(np.isnan(hits.distance), invalid)


def test_no_rays_at_all():
    hits = ws.trace(TRIANGLE, np.empty((0, 3)), np.empty((0, 3)))
    assert (hits.distance.shape, hits.face.shape, hits.invalid) == ((0,), (0,), 0)
    assert ws.trace(TRIANGLE, np.empty((5, 3)), np.empty((5, 0, 3))).face.shape == (5, 0)


@pytest.mark.parametrize(
    ("arguments", "error", "message"),
    [
        ({"mesh": 3}, TypeError, "mesh: got a value of type int"),
        ({"mesh": (np.eye(3), np.empty((0, 3), int))}, ValueError, "faces: got shape"),
        (
            {"mesh": (np.eye(3) * np.nan, [[0, 1, 2]])},
            ValueError,
            "vertices: got coordinates that are not finite, the first in row 0",
        ),
        ({"mesh": (np.eye(3), [[0, 1, 3]])}, ValueError, "faces: got indices from 0 to 3, the first wrong one in face 0"),
        ({"origins": [[0, 0, 1]]}, TypeError, "origins: got dtype int64, want float32 or float64"),
        ({"origins": np.zeros((1, 2))}, ValueError, r"origins: got shape \(1, 2\), want \(P, 3\) or \(3,\)"),
        ({"directions": 0.5}, ValueError, r"directions: got shape \(\), want \(P, 3\) or \(P, n, 3\)"),
        (
            {"directions": np.ones((2, 3))},
            ValueError,
            r"directions: got shape \(2, 3\), want \(1, 3\) or \(1, n, 3\) to",
        ),
        ({"directions": np.ones((1, 2, 2, 3))}, ValueError, r"directions: got shape \(1, 2, 2, 3\), want"),
        (
            {"directions": wp.zeros(1, dtype=wp.vec3, device="cpu")},
            ValueError,
            "directions: got a wp.array on cpu, want a NumPy array",
        ),
        ({"directions": wp.zeros(3, dtype=wp.int32, device="cpu")}, TypeError, "directions: got a wp.array of int32"),
        ({"directions": wp.zeros((2, 2), dtype=wp.vec3, device="cpu")[:, 0]}, ValueError, "directions: .* not contiguous"),
        ({"max_distance": -1.0}, ValueError, "max_distance: got -1.0, want a number from 0 to inf"),
        ({"max_distance": np.nan}, ValueError, "max_distance: got nan, want"),
        ({"max_distance": "far"}, TypeError, "max_distance: got 'far', want"),
        ({"tracer": "embree"}, ValueError, "tracer: got 'embree', want one of auto, wide, warp"),
        ({"workers": 0}, ValueError, "workers: got 0, want"),
    ],
)
def test_bad_input_is_named(arguments, error, message):
    good = {"mesh": TRIANGLE, "origins": np.zeros((1, 3)), "directions": np.ones((1, 3))}
    with pytest.raises(error, match=message):
        ws.trace(**{**good, **arguments})


@pytest.mark.parametrize("face", [1, 2**31 - 1])
def test_points_of_another_mesh_are_refused(face):
    point = ws.SurfacePoints(np.zeros((1, 3)), np.float32([[0.0, 0.0, 1.0]]), np.int32([face]))
    with pytest.raises(ValueError, match=f"origins: got points on faces {face} to {face}, want -1 .none. to 0"):
        ws.trace(TRIANGLE, point, np.ones((1, 3)))


def test_too_many_hits_for_the_memory(monkeypatch):
    directions = np.zeros((1 << 22, 3), np.float32)
    monkeypatch.setattr("psutil.virtual_memory", lambda: SimpleNamespace(available=10**7))
    with pytest.raises(
        MemoryError, match=r"the hits of 4,194,304 rays need 0.0 GB and 0.0 GB are free; trace them in parts"
    ):
        ws.trace(TRIANGLE, [0.0, 0.0, 0.0], directions)
