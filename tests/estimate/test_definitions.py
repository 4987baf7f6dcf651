"""What a user defines for `integrate`: functions, structs and data, as they are at the call; and what is wrong with them."""

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
    message = "^data: got a .*Data of another definition, want the .*Data that integrand takes; define the struct, the fun"
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
        (gives_a_matrix, None, TypeError, "^integrand: got a function that gives mat"),
        (says_nothing, None, TypeError, "^integrand: got a function that does not say what it returns"),
        (who, Albedo(), ValueError, "^data: got Albedo whose array by_id is not set, want one, or one of no elements$"),
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
