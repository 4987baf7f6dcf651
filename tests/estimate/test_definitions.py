"""What a user defines for `integrate`: functions, structs and data, as they are at the call; and what is wrong with them."""

import subprocess
import sys
from types import MappingProxyType, SimpleNamespace
from typing import Any

import numpy as np
import pytest
import warp as wp
from integrands import Albedo, Sky, one
from meshes import soup

import warpsample as ws
from warpsample import funcs
from warpsample.estimate.integrand import integrand_of
from warpsample.host.device_memory import Memory


@wp.func
def who(w: wp.vec3, lobe: funcs.Lobe, albedo: Albedo) -> wp.vec3:
    return wp.vec3(albedo.by_id[lobe.row], float(lobe.row), float(lobe.point & wp.uint64(0xFFFF)))


@wp.func
def not_a_number(w: wp.vec3) -> float:
    return wp.sqrt(-1.0 - w[2] * w[2])


UP = np.array([[0.0, 0.0, 1.0], [0.0, 3.0, 0.0], [0.6, 0.0, -0.8], [-0.1, 0.2, 0.3]])


HEIGHT = 1.0


@wp.func
def helper(w: wp.vec3) -> float:
    return 2.0


@wp.func
def helper_again(w: wp.vec3) -> float:
    return 4.0


@wp.func
def tall(w: wp.vec3) -> float:
    return HEIGHT + helper(w)


def test_what_a_function_names_may_be_defined_again(monkeypatch):
    """As when another cell of a notebook runs again; a kernel that was built keeps what it found."""
    forms = [integrand_of(tall).function, integrand_of(tall).function]
    assert forms[0] is forms[1]
    monkeypatch.setitem(globals(), "HEIGHT", 10.0)
    forms.append(integrand_of(tall).function)
    monkeypatch.setitem(globals(), "helper", helper_again)
    forms.append(integrand_of(tall).function)
    assert len(set(forms)) == 3


@pytest.mark.slow
def test_numbers_are_those_of_what_is_defined_now(monkeypatch):
    assert ws.integrate(UP, tall, 2).value[0] == 3.0
    monkeypatch.setitem(globals(), "HEIGHT", 10.0)
    assert ws.integrate(UP, tall, 2).value[0] == 12.0
    monkeypatch.setitem(globals(), "helper", helper_again)
    assert ws.integrate(UP, tall, 2).value[0] == 14.0


def a_default(gain):
    @wp.func
    def inner(w: wp.vec3, k: float = gain):
        return k

    @wp.func
    def function(w: wp.vec3) -> float:
        return inner(w)

    return function


def in_a_loop(gain):
    settings = SimpleNamespace(gains=[gain, gain])

    @wp.func
    def function(w: wp.vec3) -> float:
        total = 0.0
        for i in range(2):
            total += 0.5 * wp.static(settings.gains[i])
        return total

    return function


def in_a_call(gain):
    def number(i):
        return gain * i

    @wp.func
    def inner(x: Any):
        total = 0.0
        for i in range(2):
            total += wp.static(number(i))
        return total

    @wp.func
    def between(w: wp.vec3):
        return inner(w[2])

    @wp.func
    def function(w: wp.vec3) -> float:
        return between(w)

    return function


def in_a_function(gain):
    @wp.func
    def inner(w: wp.vec3):
        return gain

    known = MappingProxyType({"a": (inner,)})

    @wp.func
    def function(w: wp.vec3) -> float:
        total = 0.0
        for i in range(1):
            total += wp.static(known["a"][i])(w)
        return total

    return function


def of_64_bits(gain):
    small, scale = 1.0 + 2.0**-40 * gain, 2.0**40

    @wp.func
    def function(w: wp.vec3) -> float:
        return float((wp.float64(small) - wp.float64(1.0)) * wp.float64(scale))

    return function


def of_a_long_integer(gain):
    large = 2**32 * int(gain)

    @wp.func
    def function(w: wp.vec3) -> float:
        return float(wp.uint64(large) >> wp.uint64(32))

    return function


UNSEEN = [a_default, in_a_loop, in_a_call, in_a_function, of_64_bits, of_a_long_integer]
"""Makers of functions that give a number; Warp's own hash of a kernel of ours does not see which."""


@pytest.mark.parametrize("make", UNSEEN)
def test_what_warp_does_not_see_is_in_the_name_that_it_sees(make):
    names = [integrand_of(make(gain)).function.key for gain in (1.0, 5.0, 1.0)]
    assert names[0] == names[2] != names[1]


@pytest.mark.slow
@pytest.mark.parametrize("make", [UNSEEN[0], *(pytest.param(make, marks=pytest.mark.thorough) for make in UNSEEN[1:])])
def test_numbers_are_those_that_warp_does_not_see(make):
    for gain in (1.0, 5.0, 1.0):
        assert ws.integrate(UP, make(gain), 2).value[0] == gain


@pytest.mark.thorough
def test_a_process_finds_no_kernel_of_another_number(child_environment, tmp_path):
    """Both with one cache of kernels."""
    file = tmp_path / "gains.py"
    file.write_text(
        "import sys\nimport warp as wp, warpsample as ws\n\nGAIN = float(sys.argv[1])\nGAINS = [GAIN, GAIN]\n\n\n"
        "def made(gain):\n    @wp.func\n"
        "    def inner(w: wp.vec3, k: float = gain) -> float:\n        return k\n\n    return inner\n\n\n"
        "inner = made(GAIN)\n\n\n"
        "@wp.func\ndef gains(w: wp.vec3) -> wp.vec3:\n    total = float(0.0)\n    for i in range(2):\n"
        "        total += wp.static(GAINS[i])\n    return wp.vec3(inner(w), total, 0.0)\n\n\n"
        "print(*ws.integrate([[0.0, 0.0, 1.0]], gains, 2).value[0], file=sys.stderr)\n"
    )
    for gain in (1.0, 5.0):
        done = subprocess.run(
            [sys.executable, file, str(gain)], env=child_environment, capture_output=True, text=True, check=True
        )
        assert done.stderr.splitlines()[-1] == f"{gain} {2 * gain} 0.0"


def test_the_last_definition_of_a_function_and_a_struct_counts():
    """Warp keeps a function of other arguments beside the first."""

    @wp.func
    def shade(w: wp.vec3) -> float:
        return 1.0

    @wp.struct
    class Data:
        a: float

    @wp.func
    def shade(w: wp.vec3, lobe: funcs.Lobe, data: Data) -> float:  # noqa: F811
        return data.a

    earlier = Data()

    @wp.struct
    class Data:
        b: float
        a: float

    data = Data()
    data.a, data.b = 20.0, 7.0
    message = (
        "^data: got a struct .*Data of another definition, want the .*Data that integrand takes; define the struct, the fun"
    )
    with pytest.raises(TypeError, match=message):
        ws.integrate(UP, shade, 2, data=data)

    @wp.func
    def shade(w: wp.vec3, lobe: funcs.Lobe, data: Data) -> float:
        return data.a

    assert ws.integrate(UP, shade, 2, data=data).value[0] == 20.0
    with pytest.raises(TypeError, match=message):
        ws.integrate(UP, shade, 2, data=earlier)


@wp.func
def strings(w: "wp.vec3") -> "float":
    return w[2] - w[2]


def test_annotations_may_be_strings():
    """As they all are in a module that has `from __future__ import annotations`."""
    assert integrand_of(strings).channels == 1


def test_data_are_those_of_the_call():
    """Fields may be set while it runs, and the arrays that they held be freed."""
    data = Albedo()
    held = data.by_id = wp.array(np.arange(4, dtype=np.float32), dtype=wp.float32, device="cpu")
    integrand = integrand_of(who, data)
    data.by_id = wp.zeros(4, dtype=wp.float32, device="cpu")
    assert integrand.data.by_id is held
    with Memory.of("cpu").loan() as loan:
        assert integrand.data_for(loan).by_id.data == held.ptr


@wp.func
def untyped(w) -> float:
    return 1.0


@wp.func
def of_another_struct(w: wp.vec3, lobe: funcs.Lobe, data: Albedo) -> float:
    return data.by_id[0]


@wp.func
def of_a_number(w: wp.vec3, lobe: float) -> float:
    return lobe


@wp.func
def gives_a_matrix(w: wp.vec3) -> wp.mat33:
    return wp.identity(3, float)


@wp.func
def gives_another(w: wp.vec3) -> float:
    return w


@wp.func
def says_nothing(w: wp.vec3, lobe: funcs.Lobe):
    return wp.dot(w, lobe.normal)


@pytest.mark.parametrize(
    ("function", "data", "error", "message"),
    [
        (untyped, None, TypeError, "^integrand: got a function whose w has no type, want a wp.func"),
        (of_another_struct, Sky(), TypeError, "^data: got Sky, want Albedo, which integrand takes$"),
        (of_another_struct, None, TypeError, "^data: got None, want Albedo, which integrand takes$"),
        (of_a_number, None, TypeError, r"^integrand: got a function of \(w: vec3, lobe: float"),
        (gives_a_matrix, None, TypeError, "^integrand: got a function that returns mat"),
        (says_nothing, None, TypeError, "^integrand: got a function without a return type"),
        (who, Albedo(), ValueError, "^data: got Albedo whose array by_id is not set, want an array, which may be empty$"),
        (
            gives_another,
            None,
            TypeError,
            r"^integrand: got a function that does not compile, in .gives_another. at .*py:\d+: ",
        ),
        (one, Sky(), TypeError, "^data: got Sky for a function that takes none"),
        (one, 3.0, TypeError, "^data: got 3.0, want an instance of a wp.struct, or None"),
        (len, None, TypeError, "^integrand: got .*, want a wp.func"),
        (not_a_number, None, ValueError, "^integrand: got NaN or infinity at each of the first 4 points, want finite"),
    ],
)
def test_a_wrong_function_is_named(function, data, error, message):
    with pytest.raises(error, match=message):
        ws.integrate(UP, function, 64, data=data)


def test_points_and_distance_belong_to_a_mesh():
    with pytest.raises(ValueError, match="^max_distance: got 3.0 without a mesh"):
        ws.integrate(UP, one, 64, max_distance=3.0)
    with pytest.raises(TypeError, match="^points: got a NumPy array, want SurfacePoints"):
        ws.integrate(UP, one, 64, mesh=soup())
