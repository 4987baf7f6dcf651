"""What a device cannot do is refused, and where it fails nothing is left half-done or held."""

import numpy as np
import pytest
import warp as wp
from device_cases import CALLS, ESTIMATES, Data, data_of
from second_device import BUDGET, second_device

import warpsample as ws
from warpsample.funcs import Lobe
from warpsample.host import engine

pytestmark = pytest.mark.slow  # seconds each, and kernels to compile; .ci/run runs them too


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
    def interrupted(*_, **__):
        raise KeyboardInterrupt

    monkeypatch.setattr("warpsample.tracing.rays.run", interrupted)
    with second_device() as allocator, pytest.raises(KeyboardInterrupt) as caught:
        CALLS["rays"](bunny, some)
    del caught
    assert (allocator.live, allocator.asked > 0) == (0, True)


def test_an_interrupt_between_parts_fetches_nothing_more_and_gives_all_back(normals, monkeypatch):
    parts, run = [], engine.run

    def interrupted(*arguments, **how):
        parts.append(run(*arguments, **how))
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
    assert np.isin(ws.integrate(some, first_chosen, 2, data=data).value, (0.0, 5.0)).all()  # 0 without a normal
    with second_device(), pytest.raises(TypeError, match="^data: got .*indexedarray as numbers, want a wp.array for cpu$"):
        ws.integrate(some, first_chosen, 2, data=data)


def test_data_with_an_array_that_is_not_set_goes_to_a_device(some):
    data = data_of(300)
    data.weights.by_id = None
    with second_device():
        found = ws.integrate(some, without_weights, 2, data=data)
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
