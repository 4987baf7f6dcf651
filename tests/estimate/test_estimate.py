"""Numbers per point: those of their rays, with error bars that hold, by both tracers, at any scale, on any mesh."""

from math import pi

import numpy as np
import pytest
import warp as wp
from estimate_cases import at, same, square
from meshes import CLOSED, soup
from streams import fibonacci_stream

import warpsample as ws
from warpsample.estimate.kernel import estimate_kernel
from warpsample.estimate.slots import Slots
from warpsample.estimate.strata import strata_of
from warpsample.estimate.weights import Weights, everywhere
from warpsample.tracing.builtin import builtin_any_query, prepare_builtin

RAYS = 65_536


# A twin: the rays are those that the other calls give


@pytest.mark.parametrize("tracer", ["wide", pytest.param("warp", marks=pytest.mark.slow)])
def test_the_estimate_is_that_of_its_rays(bunny, points, tracer):
    """Below 32 rays there is one stratum: each replicate's directions are those of a stream."""
    count, seed = 30, 5
    found = ws.ambient_occlusion(bunny, points, count, seed=seed, tracer=tracer)
    ways = [fibonacci_stream(points.normal, count // 2, seed, stream)[1] for stream in (0, 1)]
    free = np.array([(ws.trace(bunny, points, way, any_hit=True, tracer=tracer).face < 0).mean(axis=1) for way in ways])
    assert np.array_equal(found.value, free.mean(axis=0, dtype=np.float64).astype(np.float32))
    assert np.abs(found.standard_error - 0.5 * np.abs(free[0] - free[1])).max() <= 1e-7
    assert (found.rays == count).all()


CELLS = ((2, 2), (31, 2), (39, 8), (255, 8), (271, 16), (511, 64), (4223, 128), (20_000, 256))


def test_all_strata_have_as_many_rays():
    for count, multiple in CELLS:
        assert strata_of(count).rays == count - count % multiple


@pytest.mark.slow
def test_strata_share_the_lobe_evenly():
    theta, turn = (np.arange(256)[:, None] + 0.5) * pi / 256, (np.arange(512) + 0.5) * pi / 256
    x, y, z = np.broadcast_arrays(np.sin(theta) * np.cos(turn), np.sin(theta) * np.sin(turn), np.cos(theta))
    picture = np.stack([x * x, y * y, np.maximum(z, 0.0)], axis=2)  # its bilinear reading is off by 4e-5
    for count, _ in CELLS:
        lobe = at((0, 0, 5.0), (0, 0, 1), 4)
        # Open ground under L = d.x^2 and under L = d.z: pi/4 and 2 pi/3, whichever strata the rays fill.
        found = ws.irradiance(square(0.0), lobe, picture, count, sampling="cosine").value
        assert np.abs(found - [pi / 4, pi / 4, 2 * pi / 3]).max() <= 4.0 * np.float_power(count, -0.75) + 1e-4


# Error bars


@pytest.mark.parametrize(
    ("sequence", "count"),
    [("fibonacci", 64), ("fibonacci", 512), pytest.param("independent", 64, marks=pytest.mark.thorough)],
)
def test_the_standard_error_is_what_it_says(bunny, points, sequence, count):
    """Its mean square equals that of the error, over 32 runs of 600 points."""
    runs = [ws.ambient_occlusion(bunny, points, count, sequence=sequence, seed=2, first_point=600 * k) for k in range(32)]
    values = np.array([run.value for run in runs], np.float64)
    bars = np.mean([run.standard_error.astype(np.float64) ** 2 for run in runs], axis=0)
    ratio = bars.sum() / values.var(axis=0, ddof=1).sum()
    assert abs(ratio - 1.0) <= 0.08  # 18,600 degrees of freedom, of which a fifth carry the variance: 5 of 0.016
    if count == 512:
        # 32 strata: the bar of a single point is worth reading.
        mean = values.mean(axis=0)
        outside = [np.abs(run.value - mean) > 3.0 * np.maximum(run.standard_error, 1e-3) for run in runs]
        assert np.mean(outside) <= 0.03


# Both tracers, any scale, any mesh


def test_tracers_agree(bunny, points):
    wide, warp = (ws.ambient_occlusion(bunny, points, 512, tracer=tracer) for tracer in ("wide", "warp"))
    assert np.abs(wide.value - warp.value).max() <= 3 / 512  # the same rays; one in 10^5 passes an edge the other way
    assert abs(float(wide.value.mean() - warp.value.mean())) <= 2e-5
    assert warp.skipped == ws.Skipped()


@pytest.mark.parametrize(("scale", "offset"), [(1e-6, 0.0), (1e3, 5e6), (5e6, 0.0), (2.0**40, 0.0)])
def test_scale(bunny, points, scale, offset):
    mesh = ws.Mesh(bunny.vertices * scale + offset, bunny.faces)
    moved = ws.SurfacePoints(points.position * scale + offset, points.normal, points.face)
    right, found = ws.ambient_occlusion(bunny, points, 512), ws.ambient_occlusion(mesh, moved, 512)
    if offset == 0.0 and np.log2(scale) % 1 == 0:
        assert same(found, right)
    assert np.abs(found.value - right.value).max() <= 4 / 512  # rays that pass an edge on the other side
    assert abs(float(found.value.mean() - right.value.mean())) <= 5e-5


def test_any_mesh_gives_finite_numbers_and_a_report():
    box = CLOSED["box"][0]
    doubled = ws.Mesh(box.vertices, np.concatenate([box.faces, box.faces[:4]]))
    fins = ws.Mesh(np.vstack([box.vertices, [[3, 3, 3]]]), np.concatenate([box.faces, [[0, 1, 8], [0, 1, 8]]]))
    for mesh in (soup(300), doubled, fins, square(), ws.as_mesh(([(0, 0, 0), (1, 0, 0), (0, 1, 0)], [(0, 1, 2)]))):
        for where in (ws.face_centers(mesh), ws.vertex_points(mesh)):
            found = ws.ambient_occlusion(mesh, where, 128)
            assert np.isfinite(found.value).all()
            assert np.isfinite(found.standard_error).all()
            assert ((found.value >= 0.0) & (found.value <= 1.0)).all()
            assert (found.status == ws.PointStatus.ZERO_NORMAL).sum() == np.count_nonzero(~where.normal.any(axis=1))
    degenerate = ws.ambient_occlusion(soup(300), ws.face_centers(soup(300)), 128)
    assert degenerate.counts()[ws.PointStatus.ZERO_NORMAL] == degenerate.skipped.points == 10


@pytest.mark.slow
def test_a_million_faces():
    side = 708
    x, y = np.meshgrid(np.linspace(0, 1, side), np.linspace(0, 1, side))
    heights = 0.02 * np.sin(40 * x) * np.cos(31 * y)
    corner = (np.arange(side - 1)[:, None] * side + np.arange(side - 1)).ravel()
    halves = [(0, 1, side), (1, side + 1, side)]
    faces = np.concatenate([corner[:, None] + half for half in halves])
    mesh = ws.as_mesh((np.stack([x, y, heights], -1).reshape(-1, 3), faces))
    where = ws.sample_surface(mesh, 5000)
    with_skipping, without = (ws.sky_view_factor(mesh, where, 64, skip=skip) for skip in (True, False))
    assert len(mesh.faces) == 999_698
    assert same(with_skipping, without)
    assert 0.5 < with_skipping.value.mean() < 0.95


def test_points_far_away_and_invalid_points(bunny):
    lower, upper = bunny.report.lower, bunny.report.upper
    centre, radius = 0.5 * (lower + upper), 0.5 * np.ptp(np.stack([lower, upper]), axis=0).max()
    away = np.array([[0, 0, 1.0], [0.6, 0.0, -0.8]])
    for distance in (20.0, 1e5):
        far = at(centre + distance * radius * away, -away)
        found = ws.ambient_occlusion(bunny, far, 4096)
        assert np.all(found.value > 1.0 - 2.0 / distance)  # the bunny's share of the lobe is below (radius/distance)^2
        assert (found.status == 0).all()
    near = at(centre + 20.0 * radius * away, -away)
    hits = 1.0 - ws.ambient_occlusion(bunny, near, 1 << 20).value
    assert ((hits > 1e-4) & (hits < 3.0 / 400)).all()
    bad = ws.SurfacePoints(
        np.array([[0, 0, 0], [np.nan, 0, 0], [0, 0, np.inf], [0, 0, 0], [0, 0, 0]]),
        np.float32([[0, 0, 0], [0, 0, 1], [0, 0, 1], [np.nan, 0, 1], [0, 0, 1]]),
    )
    found = ws.ambient_occlusion(bunny, bad, 64)
    assert found.status.tolist() == [2, 4, 4, 3, 0]
    assert (found.value[:4] == 0.0).all()
    assert (found.rays[:4] == 0).all()


# What cannot be used


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"points": np.zeros((3, 3))}, "points: got a NumPy array, want SurfacePoints"),
        ({"mesh": 3}, "mesh: got a value of type int"),
        ({"count": 1}, "count: got 1, want a whole number from 2"),
        ({"count": 2.5}, "count: got 2.5"),
        ({"max_distance": -1.0}, "max_distance: got -1.0"),
        ({"falloff": 1.0}, "max_distance: got None, want a finite distance above 0"),
        ({"falloff": -1.0, "max_distance": 1.0}, "falloff: got -1.0"),
        ({"sequence": "halton"}, "sequence: got 'halton'"),
        ({"seed": -1}, "seed: got -1"),
        ({"active": [True]}, r"active: got shape \(1,\), want an array of bool of shape \(600,\)"),
        ({"active": np.zeros(600)}, "active: got dtype float64, want an array of bool"),
        ({"tolerance": 0.0}, "tolerance: got 0.0"),
        ({"tracer": "embree"}, "tracer: got 'embree'"),
        ({"workers": 0}, "workers: got 0"),
    ],
)
def test_bad_arguments_are_named(bunny, points, change, message):
    with pytest.raises((TypeError, ValueError), match=f"^{message}"):
        ws.ambient_occlusion(**{"mesh": bunny, "points": points, "count": 32, **change})


# Portable; that its loops are vectorised is in tracing/test_query_kernels.py, whose compiler it shares


# The kernel with a mesh is that of occlusion in test_devices.py.
@pytest.mark.parametrize(
    "query",
    [
        pytest.param((prepare_builtin, builtin_any_query), id="with a mesh", marks=pytest.mark.thorough),
        pytest.param((None, None), id="without", marks=pytest.mark.slow),
    ],
)
def test_the_kernel_compiles_for_cuda(query, tmp_path):
    rays = (ws.sequences.get("fibonacci"), ws.CosineHemisphere("polar").about(), None, 0.0, True)
    kernel = estimate_kernel(Slots(*rays, everywhere, Weights, True, True, 1, *query, True, False))
    (ptx,) = wp.compile_aot_module(kernel.module, device=None, arch=86, use_ptx=True, module_dir=tmp_path)
    assert ".visible .entry" in ptx.read_text()
