"""All calls on a device: arrays go there in parts and come back, and no bit depends on them.

Machines of CI have no GPU. A second CPU device is used in its place, with the kernels and the tracer of CUDA; these
kernels are also compiled to PTX.
"""

from dataclasses import fields

import numpy as np
import pytest
import warp as wp
from device_cases import CALLS, ESTIMATES, PICTURE
from second_device import BUDGET, second_device

import warpsample as ws
from warpsample.host import engine
from warpsample.tracing.starts import _start_kernel

ARCHITECTURES = (86, 75, 90)
NUMBERS = ("value", "standard_error", "spread", "degrees_of_freedom", "rays", "status")
FEW = ("occlusion", "tolerance", "data", "picture")
EACH = [name if name in FEW else pytest.param(name, marks=pytest.mark.thorough) for name in ESTIMATES]


@pytest.mark.slow
@pytest.mark.parametrize("name", EACH)
def test_estimates_on_a_device_have_the_same_bits(name, bunny, some):
    """As by the same tree here, where the points are not taken apart: each number of each point, and what was skipped."""
    call = ESTIMATES[name]
    here = call(bunny, some, tracer="warp")
    with second_device() as allocator:
        there = call(bunny, some, device="cpu")
        assert allocator.asked >= 3 * 9  # parts, with that many arrays each
        assert allocator.most <= BUDGET + PICTURE.nbytes + 4 * 4 * 300
    assert allocator.live == 0
    for number in NUMBERS:
        assert np.array_equal(getattr(here, number), getattr(there, number)), number
    assert there.skipped == here.skipped
    assert there.counts()[ws.PointStatus.ZERO_NORMAL] == 1


def test_a_device_agrees_with_the_wide_tree(bunny, points):
    here = ws.ambient_occlusion(bunny, points, 512)
    with second_device():
        there = ws.ambient_occlusion(bunny, points, 512)
    assert np.abs(here.value - there.value).max() <= 3 / 512
    assert abs(float(here.value.mean(dtype=np.float64) - there.value.mean(dtype=np.float64))) <= 2e-5
    assert here.skipped.empty_rays > there.skipped.empty_rays == 0


@pytest.mark.parametrize("any_hit", [False, True])
def test_rays_on_a_device_have_the_same_answers(any_hit, bunny, some):
    ways = np.random.default_rng(2).normal(size=(300, 5, 3))
    ways[11, 3] = 0.0
    cases = [
        (some, ways.astype(np.float32)),
        (some.position, ways),
        (some.position.astype(np.float32), ways[:, 0]),
        (some.position[0], ways.reshape(-1, 3)),
        (some.position[0], ways[0, 0]),
        (some.position[:2], np.tile(ways[:2], (1, 200, 1))),  # one point's rays are more than a part
    ]
    for origins, directions in cases:
        here = ws.trace(bunny, origins, directions, any_hit=any_hit, tracer="warp")
        with second_device() as allocator:
            there = ws.trace(bunny, origins, directions, any_hit=any_hit, device="cpu")
            assert 0 < allocator.most <= BUDGET
        assert (there.tracer, allocator.live) == ("warp", 0)
        assert np.array_equal(here.distance, there.distance, equal_nan=True)
        assert np.array_equal(here.face, there.face)
        assert there.distance.shape == directions.shape[:-1]


def test_points_of_a_surface_on_a_device_have_the_same_bits(bunny):
    here = ws.sample_surface(bunny, 2000, seed=3, first_point=2**40, barycentric=True)
    with second_device() as allocator:
        there = ws.sample_surface(bunny, 2000, seed=3, first_point=2**40, barycentric=True, device="cpu")
        assert allocator.asked > 3 + 2 * 3
        whole = (bunny.vertices, bunny.faces, bunny.area_sums, bunny.face_normals)
        assert allocator.most <= BUDGET + sum(array.nbytes for array in whole) + 4 * 257  # and the guide
    assert allocator.live == 0
    for item in fields(here):
        assert np.array_equal(getattr(here, item.name), getattr(there, item.name)), item.name


@pytest.mark.slow
@pytest.mark.parametrize("count", [1, 5, 100])
def test_directions_on_a_device_have_the_same_bits(count, normals):
    """By one sample a task, as CUDA has it; ids pass a multiple of 2^32 within a part."""
    normals[[3, 500]] = 0.0
    active, out = np.arange(1000) % 5 > 0, np.full((1000, count, 3), np.nan, np.float32)
    options = {"distribution": ws.CosineHemisphere("offset"), "pdf": True, "active": active, "first_point": 2**32 - 333}
    here = ws.sample_directions(normals, count, **options)
    with second_device() as allocator:
        there = ws.sample_directions(normals, count, out=out, device="cpu", **options)
        assert 0 < allocator.most <= BUDGET
    assert there.vectors is out
    assert allocator.live == 0
    for name in ("vectors", "pdf", "status"):
        assert np.array_equal(getattr(here, name), getattr(there, name)), name
    ids = np.arange(2**32 + 999, 2**32 - 1, -1)
    points = ws.SurfacePoints(np.zeros((1000, 3)), normals, id=ids)
    here = ws.sample_directions(points, count, **options | {"first_point": 0})
    with second_device():
        there = ws.sample_directions(points, count, device="cpu", **options | {"first_point": 0})
    assert np.array_equal(here.vectors, there.vectors)
    assert np.array_equal(here.pdf, there.pdf)


def test_a_device_has_a_task_for_each_sample_or_ray(bunny, some, monkeypatch):
    """As CUDA wants it, whose neighbouring threads then read and write side by side."""
    tasks = []
    for module in ("warpsample.tracing.rays", "warpsample.directions.plan"):
        monkeypatch.setattr(f"{module}.run", lambda _, count, *__, **___: tasks.append(count))
    with second_device(budget=1 << 28):
        ws.trace(bunny, some, np.ones((300, 5, 3)))
        ws.sample_directions(some, 7)
    assert tasks == [300 * 5, 300 * 7]


def test_warp_arrays_are_used_where_they_are(bunny, normals):
    origins, ways = (wp.array(a, dtype=wp.vec3, device="cpu") for a in (normals + np.float32(9.0), normals))
    here = ws.trace(bunny, origins, ways, tracer="warp"), ws.sample_directions(ways, 3)
    with second_device() as allocator:
        there = ws.trace(bunny, origins, ways, device="cpu"), ws.sample_directions(ways, 3, device="cpu")
        assert allocator.asked == 0
    assert np.array_equal(here[0].distance.numpy(), there[0].distance.numpy())
    assert np.array_equal(here[1].vectors.numpy(), there[1].vectors.numpy())


# On a GPU, where there is one; its roundings are others, so a ray may pass an edge on the other side


@pytest.mark.skipif(not wp.is_cuda_available(), reason="no CUDA device")
@pytest.mark.parametrize("name", ESTIMATES)
def test_estimates_on_cuda_agree_with_the_cpu(name, bunny, some):
    call = ESTIMATES[name]
    here, there = call(bunny, some, tracer="warp"), call(bunny, some, device="cuda")
    assert np.array_equal(here.status, there.status)
    largest = np.abs(here.value).max()
    assert np.abs(here.value - there.value).max() <= 4 / 64 * largest
    assert (
        np.abs(here.value.mean(axis=0, dtype=np.float64) - there.value.mean(axis=0, dtype=np.float64)).max()
        <= 1e-3 * largest
    )


@pytest.mark.skipif(not wp.is_cuda_available(), reason="no CUDA device")
def test_rays_on_cuda_agree_with_the_cpu(bunny, some):
    ways = np.random.default_rng(2).normal(size=(300, 5, 3))
    here, there = (ws.trace(bunny, some, ways, tracer="warp", device=device) for device in ("cpu", "cuda"))
    same = here.face == there.face
    assert np.count_nonzero(~same) <= 2
    assert np.allclose(here.distance[same], there.distance[same], rtol=1e-5, atol=1e-6, equal_nan=True)


@pytest.mark.skipif(not wp.is_cuda_available(), reason="no CUDA device")
def test_points_of_a_surface_on_cuda_agree_with_the_cpu(bunny):
    here, there = (ws.sample_surface(bunny, 2000, device=device) for device in ("cpu", "cuda"))
    assert np.array_equal(here.face, there.face)
    assert np.allclose(here.position, there.position, rtol=1e-12, atol=1e-14)


# The kernels


def launched(calls, monkeypatch):
    """The kernels that these calls launch on the device; the CPU finds the starts of rays in any case."""
    kernels, take = [], engine._take

    def watched(kernel, *arguments):
        if kernel is not _start_kernel():
            kernels.append(kernel)
        return take(kernel, *arguments)

    monkeypatch.setattr(engine, "_take", watched)
    with second_device():
        for each in calls:
            each()
    return list(dict.fromkeys(kernels))


@pytest.mark.parametrize(
    "arch", [pytest.param(a, marks=(pytest.mark.thorough if i else pytest.mark.slow)) for i, a in enumerate(ARCHITECTURES)]
)
@pytest.mark.parametrize(
    "name", [*CALLS, *(pytest.param(name, marks=pytest.mark.thorough) for name in ESTIMATES if name not in CALLS)]
)
def test_each_kernel_that_a_device_runs_compiles_for_cuda(name, arch, bunny, some, tmp_path, monkeypatch):
    one = CALLS.get(name) or ESTIMATES[name]
    ws.tree(bunny)  # built on the CPU
    kernels = launched([lambda: one(bunny, some)], monkeypatch)
    assert len(kernels) == 1
    (ptx,) = wp.compile_aot_module(kernels[0].module, device=None, arch=arch, use_ptx=True, module_dir=tmp_path)
    text = ptx.read_text()
    assert f".target sm_{arch}" in text
    assert f".visible .entry {kernels[0].get_mangled_name()}_cuda_kernel_forward" in text
