"""All calls on a device: arrays go there in parts and come back, no bit depends on them, and a failure leaves nothing.

There is no GPU here. The CPU stands for one, with the kernels and the tracer of CUDA; these kernels are also made PTX of.
"""

from dataclasses import fields

import numpy as np
import pytest
import warp as wp
from second_device import BUDGET, second_device

import warpsample as ws
from warpsample.funcs import Lobe
from warpsample.host import engine

ARCHITECTURES = [86, *(pytest.param(arch, marks=pytest.mark.slow) for arch in (75, 90))]
NUMBERS = ("value", "standard_error", "spread", "degrees_of_freedom", "rays", "status")
PICTURE = np.random.default_rng(5).uniform(0.0, 3.0, (8, 16, 3)).astype(np.float32)


@wp.struct
class Weights:
    by_id: wp.array[wp.float32]
    factor: wp.float32


@wp.struct
class Data:
    weights: Weights
    by_row: wp.array2d[wp.float32]


@wp.func
def weighed(w: wp.vec3, lobe: Lobe, data: Data) -> float:
    number = data.weights.by_id[wp.int32(lobe.point - wp.uint64(1000))] + data.by_row[1, lobe.row]
    return data.weights.factor * w[2] * number


@wp.func
def blue(w: wp.vec3) -> wp.vec3:
    return wp.vec3(0.0, wp.abs(w[0]), 1.0)


def data_of(points):
    """A number for each point by its id, and one by its row, in an array whose rows do not touch."""
    data = Data()
    data.weights = Weights()
    data.weights.by_id = wp.array(np.arange(points, dtype=np.float32), dtype=wp.float32, device="cpu")
    data.weights.factor = 0.5
    rows = np.float32([np.zeros(points), np.arange(points) % 7, np.zeros(points)])
    data.by_row = wp.array(rows.T.copy(), dtype=wp.float32, device="cpu").transpose()
    return data


@pytest.fixture(scope="module")
def some(points):
    """300 points, one of them nowhere and one without a normal."""
    position, normal = points.position[:300].copy(), points.normal[:300].copy()
    position[7], normal[250] = np.nan, 0.0
    return ws.SurfacePoints(position, normal, points.face[:300])


ACTIVE = np.arange(300) % 3 > 0
SLOW = pytest.mark.slow
ESTIMATES = {
    "occlusion": lambda mesh, at, **o: ws.ambient_occlusion(mesh, at, 64, active=ACTIVE, first_point=2**33, **o),
    "tolerance": lambda mesh, at, **o: ws.ambient_occlusion(mesh, at, 256, tolerance=0.05, **o),
    "data": lambda _, at, **o: ws.integrate(at, weighed, 64, data_of(300), first_point=1000, **o),
    "falloff": lambda mesh, at, **o: ws.ambient_occlusion(mesh, at, 32, max_distance=0.5, falloff=1.5, **o),
    "sky": lambda mesh, at, **o: ws.sky_view_factor(mesh, at, 64, up=(0, 1, 0), **o),
    "bent": lambda mesh, at, **o: ws.bent_normals(mesh, at, 64, **o),
    "picture": lambda mesh, at, **o: ws.irradiance(mesh, at, PICTURE, 64, **o),
    "function": lambda mesh, at, **o: ws.irradiance(mesh, at, blue, 64, **o),
    "glossy": lambda mesh, at, **o: ws.integrate(at, weighed, 64, data_of(300), ws.GGX(0.3), mesh, first_point=1000, **o),
}
EACH = [name if name in ("occlusion", "tolerance", "data") else pytest.param(name, marks=SLOW) for name in ESTIMATES]


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
        assert allocator.most <= BUDGET + bunny.vertices.nbytes + bunny.faces.nbytes + bunny.face_areas.nbytes
    assert allocator.live == 0
    for item in fields(here):
        assert np.array_equal(getattr(here, item.name), getattr(there, item.name)), item.name


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


def test_a_device_has_a_task_for_each_sample_or_ray(bunny, some, monkeypatch):
    """As CUDA wants it, whose neighbouring threads then read and write side by side."""
    tasks = []
    for module in ("warpsample.tracing.rays", "warpsample.directions.plan"):
        monkeypatch.setattr(f"{module}.run", lambda _, count, *__: tasks.append(count))
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


# Failures


CALLS = {
    "surface": lambda mesh, _: ws.sample_surface(mesh, 1000),
    "directions": lambda _, at: ws.sample_directions(at, 16).vectors,
    "rays": lambda mesh, at: ws.trace(mesh, at, at.normal).distance,
    "occlusion": lambda mesh, at: ws.ambient_occlusion(mesh, at, 64).value,
    "data": lambda mesh, at: ESTIMATES["data"](mesh, at).value,
}


@pytest.mark.parametrize("name", CALLS)
def test_a_full_device_is_an_error_and_gives_all_back(name, bunny, some):
    """Wherever the memory ends, at the first array or the last."""
    with second_device() as allocator:
        CALLS[name](bunny, some)
    assert allocator.asked >= 8
    for fails_at in (1, 2, 5, allocator.asked // 2, allocator.asked):
        with second_device(fails_at) as full, pytest.raises(MemoryError, match="^the second device is full$") as caught:
            CALLS[name](bunny, some)
        del caught
        assert (full.asked, full.live) == (fails_at, 0)


def test_an_interrupt_of_rays_gives_all_back(bunny, some, monkeypatch):
    def interrupted(*_):
        raise KeyboardInterrupt

    monkeypatch.setattr("warpsample.tracing.rays.run", interrupted)
    with second_device() as allocator, pytest.raises(KeyboardInterrupt) as caught:
        CALLS["rays"](bunny, some)
    del caught
    assert (allocator.live, allocator.asked > 0) == (0, True)


def test_an_interrupt_between_parts_fetches_nothing_more_and_gives_all_back(normals, monkeypatch):
    parts, run = [], engine.run

    def interrupted(*arguments):
        parts.append(run(*arguments))
        if len(parts) == 3:
            raise KeyboardInterrupt

    monkeypatch.setattr("warpsample.directions.plan.run", interrupted)
    out = np.full((1000, 16, 3), np.nan, np.float32)
    with second_device() as allocator, pytest.raises(KeyboardInterrupt) as caught:
        ws.sample_directions(normals, 16, out=out, device="cpu")
    del caught
    assert allocator.live == 0
    rows = BUDGET // (16 * 16 + 14)
    assert np.isfinite(out[: 2 * rows]).all()
    assert np.isnan(out[2 * rows :]).all()


# What cannot be


@pytest.mark.parametrize("name", ESTIMATES)
def test_an_unknown_device_is_named(name, bunny, some):
    with pytest.raises(ValueError, match="^device: got 'cuda:7', want one of cpu"):
        ESTIMATES[name](bunny, some, device="cuda:7")


def test_what_a_device_cannot_do_is_refused(bunny, some, normals):
    with second_device():
        for call in (
            lambda: ws.ambient_occlusion(bunny, some, 64, tracer="wide"),
            lambda: ws.trace(bunny, normals, normals, tracer="wide"),
        ):
            with pytest.raises(ValueError, match="^tracer: got 'wide' for rays on cpu, want 'warp' or 'auto'"):
                call()
    with pytest.raises(ValueError, match="^device: got 'cuda:7', want one of cpu"):
        ws.trace(bunny, normals, normals, device="cuda:7")
    with pytest.raises(ValueError, match="^device: got 'cuda:7', want one of cpu"):
        ws.sample_surface(bunny, 3, device="cuda:7")


@wp.struct
class Chosen:
    numbers: wp.indexedarray(dtype=wp.float32, ndim=1)
    unused: wp.array[wp.float32]


@wp.func
def first_chosen(w: wp.vec3, lobe: Lobe, data: Chosen) -> float:
    return data.numbers[0]


def test_data_that_cannot_go_to_a_device_is_refused(some):
    data = Chosen()
    numbers = wp.array([3.0, 5.0], dtype=wp.float32, device="cpu")
    data.numbers = wp.indexedarray(numbers, [wp.array([1], dtype=wp.int32, device="cpu")])
    assert np.isin(ws.integrate(some, first_chosen, 2, data).value, (0.0, 5.0)).all()  # 0 without a normal
    with second_device(), pytest.raises(TypeError, match="^data: got .*indexedarray as numbers, want a wp.array for cpu$"):
        ws.integrate(some, first_chosen, 2, data)


def test_data_with_an_array_that_is_not_set_goes_to_a_device(some):
    data = data_of(300)
    data.weights.by_id = None
    with second_device():
        found = ws.integrate(some, without_weights, 2, data)
    assert np.array_equal(found.value, np.where(found.status == 0, np.arange(300) % 7, 0.0))


@wp.func
def without_weights(w: wp.vec3, lobe: Lobe, data: Data) -> float:
    return data.by_row[1, lobe.row]


def test_bake_takes_a_device(call, cube, tmp_path):
    output = tmp_path / "cube.npz"
    status, out, err = call("bake", cube, "-o", output, "--device", "cuda:7")
    assert (status, out) == (2, "")
    assert err.startswith("error: --device: got 'cuda:7', want one of cpu")
    assert not output.exists()
    with second_device() as allocator:
        assert call("bake", cube, "-o", output, "--device", "cpu", "--samples", 16)[0] == 0
    assert allocator.asked > 0
    assert (np.load(output)["value"] > 0.9).all()


# The kernels


def launched(calls, monkeypatch):
    """The kernels that these calls launch."""
    kernels, take = [], engine._take

    def watched(kernel, *arguments):
        kernels.append(kernel)
        return take(kernel, *arguments)

    monkeypatch.setattr(engine, "_take", watched)
    with second_device():
        for each in calls:
            each()
    return list(dict.fromkeys(kernels))


@pytest.mark.parametrize("arch", ARCHITECTURES)
@pytest.mark.parametrize("name", [*CALLS, *(pytest.param(name, marks=SLOW) for name in ESTIMATES if name not in CALLS)])
def test_each_kernel_that_a_device_runs_compiles_for_cuda(name, arch, bunny, some, tmp_path, monkeypatch):
    one = CALLS.get(name) or ESTIMATES[name]
    kernels = launched([lambda: one(bunny, some)], monkeypatch)
    assert len(kernels) == 1
    (ptx,) = wp.compile_aot_module(kernels[0].module, device=None, arch=arch, use_ptx=True, module_dir=tmp_path)
    text = ptx.read_text()
    assert f".target sm_{arch}" in text
    assert f".visible .entry {kernels[0].get_mangled_name()}_cuda_kernel_forward" in text
