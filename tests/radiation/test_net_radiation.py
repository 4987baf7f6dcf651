"""Net radiation between grey surfaces against closed forms, and what rows are called."""

from dataclasses import replace

import numpy as np
import pytest
import trimesh
from scipy.sparse import csr_array

import warpsample as ws
from warpsample.radiation.exchange.surfaces import check_groups

SIGMA = 5.670374419e-8


def factors(matrix, areas, outside=None):
    """View factors that are known."""
    matrix, zeros = csr_array(np.array(matrix, float)), np.zeros(len(areas))
    beyond = np.array(zeros if outside is None else outside, float)
    rays, status = np.ones(len(areas), np.int64), np.zeros(len(areas), np.uint8)
    return ws.ViewFactors(matrix, matrix, beyond, zeros, zeros, zeros, np.array(areas, float), rays, status, ws.Skipped())


def test_concentric_spheres_exchange_what_the_textbook_says():
    inner, outer = 1.0, 4.0
    v = factors([[0.0, 1.0], [inner / outer, 1.0 - inner / outer]], [inner, outer])
    found = v.net_radiation([500.0, 300.0], [0.8, 0.4])
    want = SIGMA * (500.0**4 - 300.0**4) / (1 / 0.8 + (1 - 0.4) / 0.4 * inner / outer) * inner
    assert np.allclose(found.power, [want, -want], rtol=1e-11)  # the radiosity has twelve digits
    assert np.allclose(found.flux, found.power / v.areas)


def test_surfaces_go_by_their_names():
    v = replace(factors([[0.0, 1.0], [0.25, 0.75]], [1.0, 4.0]), names=("inner", "outer"))
    want = v.net_radiation([[500.0, 400.0], [300.0, 300.0]], [0.8, 0.4])
    kelvin = {"outer": 300.0, "inner": [500.0, 400.0]}
    assert np.array_equal(v.net_radiation(kelvin, {"inner": 0.8, "outer": 0.4}).flux, want.flux)
    frame = v.net_radiation(kelvin, 0.9).to_frame()
    assert list(frame["names"]) == ["inner", "inner", "outer", "outer"]
    assert list(frame["time"]) == [0, 1, 0, 1]
    assert np.array_equal(frame["flux"], v.net_radiation(kelvin, 0.9).flux.ravel())
    assert list(v.net_radiation(300.0, 0.9).to_frame()) == ["names", "flux", "power", "leaving"]
    for wrong in ({"inner": 300.0}, {**kelvin, "roof": 300.0}):
        with pytest.raises(
            ValueError, match=r"temperature: got a dictionary with the names \[.*\], want all of \['inner', 'outer'\]"
        ):
            v.net_radiation(wrong, 0.9)
    with pytest.raises(
        ValueError, match=r"temperature: got arrays of different shapes, \(2,\), \(3,\), want one number for each"
    ):
        v.net_radiation({"inner": [300.0] * 2, "outer": [300.0] * 3}, 0.9)
    with pytest.raises(ValueError, match="emissivity: got a dictionary, but the surfaces have no names, want numbers"):
        replace(v, names=None).net_radiation(300.0, {"inner": 0.8, "outer": 0.4})


def test_degrees_celsius_are_reported():
    v = factors([[0.0, 1.0], [1.0, 0.0]], [1.0, 1.0])
    with pytest.warns(UserWarning, match="temperature: got at most 25 kelvin; if these are degrees Celsius, add 273.15"):
        v.net_radiation([20.0, 25.0], 0.9)
    v.net_radiation([0.0, 77.0], 0.9)


def test_a_plate_under_the_sky_loses_what_it_does_not_get():
    v = factors([[0.0]], [2.0], outside=[1.0])
    found = v.net_radiation(280.0, 0.9, outside=250.0)
    assert np.allclose(found.flux, 0.9 * SIGMA * (280.0**4 - 250.0**4), rtol=1e-12)
    assert np.allclose(found.power, 2.0 * found.flux)
    assert np.allclose(found.leaving, 0.9 * SIGMA * 280.0**4 + 0.1 * SIGMA * 250.0**4)


def test_an_open_room_wants_the_temperature_outside():
    for seen in (2e-3, 1.0):
        with pytest.raises(
            ValueError, match=f"outside: got None, but a surface has a view factor of {seen:.2g} to the outside"
        ):
            factors([[1.0 - seen]], [2.0], outside=[seen]).net_radiation(280.0, 0.9)
    leaking = factors([[0.9995]], [2.0], outside=[5e-4]).net_radiation(280.0, 1.0)
    assert np.allclose(leaking.flux, 5e-4 * SIGMA * 280.0**4)


@pytest.mark.slow
def test_equal_temperatures_exchange_nothing_and_each_hour_is_one_column():
    v = ws.view_factors(ws.load_mesh("courtyard"), 64)
    emissivity = np.linspace(0.5, 1.0, len(v.areas))
    still = v.net_radiation(290.0, emissivity, outside=290.0)
    assert np.abs(still.flux).max() < 1e-9 * SIGMA * 290.0**4
    hours = np.outer(np.ones(len(v.areas)), [270.0, 290.0])
    found = v.net_radiation(hours, emissivity, outside=[250.0, 290.0])
    assert found.flux.shape == hours.shape
    assert np.array_equal(found.flux[:, 1], still.flux) or np.abs(found.flux[:, 1] - still.flux).max() < 1e-9
    assert (found.flux[:, 0] > 0.0).all()


def test_arguments_without_sense_are_reported():
    v = factors([[0.0, 1.0], [1.0, 0.0]], [1.0, 1.0])
    for given, match in (
        ({"temperature": [1.0]}, r"temperature: got shape \(1,\), want \(2,\), a number for each surface, or \(2, k\)"),
        ({"temperature": -1.0}, "temperature: got -1.0, want finite numbers from 0"),
        ({"emissivity": 0.0}, "emissivity: got 0.0, want finite numbers above 0 to 1"),
        ({"emissivity": 1e-300}, "emissivity: got down to 1e-300, want larger numbers, so that reflections die out"),
        ({"emissivity": [0.5] * 3}, r"emissivity: got shape \(3,\), want one number, or \(2,\), a number"),
        ({"outside": [1.0, 2.0]}, r"outside: got shape \(2,\), want one number"),
    ):
        with pytest.raises(ValueError, match=match):
            v.net_radiation(**{"temperature": 300.0, "emissivity": 0.5, **given})


def test_names_of_groups_may_be_objects():
    """As in a column of pandas, or `city.surfaces.type`."""
    mesh = ws.as_mesh(([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]] * 3))
    names = ["wall", "roof", "wall"]
    of_numpy_2 = [np.array(names, np.dtypes.StringDType())] if hasattr(np.dtypes, "StringDType") else []
    for groups in (np.array(names, object), np.array(names), names, tuple(names), *of_numpy_2):
        rows, found = check_groups(groups, mesh)
        assert (rows.tolist(), rows.dtype, found) == ([1, 0, 1], np.int32, ("roof", "wall"))
    for groups in (np.array(["wall", None, "wall"], object), np.array([0, 1, "a"], object), np.array([0, 1, 2], object)):
        with pytest.raises(TypeError, match=r"groups: got dtype object, want \(3,\) whole numbers from 0 .* or names"):
            check_groups(groups, mesh)
    with pytest.raises(ValueError, match=r"groups: got shape \(4,\), want \(3,\) whole numbers"):
        check_groups(np.array(["wall"] * 4, object), mesh)


@pytest.mark.slow
def test_groups_go_by_name(tmp_path):
    box = trimesh.creation.box((2.0, 2.0, 2.0))
    part = np.repeat([1, -1, 0], 4)
    mesh = ws.Mesh(box.vertices, box.faces[:, ::-1], part, ["a", "b"])
    found = ws.view_factors(mesh, 64, groups="part")
    assert found.names == ("a", "b", "")
    numbers = ws.view_factors(mesh, 64, groups=np.where(part < 0, 2, part))
    assert numbers.names is None
    assert np.array_equal(found.matrix.toarray(), numbers.matrix.toarray())
    texts = ws.view_factors(mesh, 64, groups=np.array(["b", "none", "a"])[np.repeat([0, 1, 2], 4)])
    assert texts.names == ("a", "b", "none")
    assert np.array_equal(texts.matrix.toarray(), numbers.matrix.toarray())
    found.save(tmp_path / "factors.npz")
    assert ws.ViewFactors.load(tmp_path / "factors.npz").names == found.names
    numbers.save(tmp_path / "numbers.npz")
    assert ws.ViewFactors.load(tmp_path / "numbers.npz").names is None
    for groups, match in (("wall", "groups: got 'wall', want 'part'"), (["a"], r"groups: got .*, want \(12,\) whole")):
        with pytest.raises((TypeError, ValueError), match=match):
            ws.view_factors(mesh, 64, groups=groups)
    with pytest.raises(ValueError, match="groups: got 'part' for a mesh without named parts"):
        ws.view_factors((box.vertices, box.faces), 64, groups="part")
