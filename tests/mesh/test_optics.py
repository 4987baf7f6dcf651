"""Transmittance and reflectance: kept with the mesh wherever it goes, and refused where no surface has them."""

import copy
import pickle

import numpy as np
import pytest
from meshes import BOX

import warpsample as ws
from warpsample.host import shared_values

TAU = np.linspace(0.0, 1.0, len(BOX.faces))


def box(**optics):
    return ws.as_mesh((BOX.vertices, BOX.faces), **optics)


@pytest.mark.parametrize("name", ["transmittance", "reflectance"])
def test_one_number_is_that_of_all_faces_and_none_is_none(name):
    made = getattr(box(**{name: 0.25}), name)
    assert (made.dtype, made.tolist()) == (np.float32, [0.25] * len(BOX.faces))
    assert getattr(box(), name) is None
    given = TAU.copy()
    mesh = box(**{name: given})
    given[:] = 0.5
    assert np.array_equal(getattr(mesh, name), TAU.astype(np.float32))
    with pytest.raises(ValueError, match="read-only"):
        getattr(mesh, name)[0] = 1.0


def test_shares_are_added_to_a_mesh_that_is_there():
    clear = box(transmittance=0.25)
    assert ws.as_mesh(clear) is clear
    both = ws.as_mesh(clear, reflectance=0.75)
    assert (both.transmittance[3], both.reflectance[3], clear.reflectance) == (0.25, 0.75, None)
    loaded = ws.load_mesh("courtyard", transmittance=0.5, reflectance=np.full(2080, 0.5))
    assert (loaded.transmittance.sum(), loaded.reflectance.sum()) == (1040.0, 1040.0)


@pytest.mark.parametrize(
    ("optics", "message"),
    [
        ({"transmittance": 1.5}, r"^transmittance: got 1\.5, want a number from 0 to 1, or \(12,\) numbers"),
        ({"reflectance": np.where(TAU == 1.0, -0.5, TAU)}, r"^reflectance: got -0\.5 in face 11, want a number from 0 to 1"),
        ({"transmittance": np.nan}, "^transmittance: got nan, want"),
        ({"transmittance": np.ones(11)}, r"^transmittance: got shape \(11,\), want"),
        ({"transmittance": 0.5, "reflectance": 0.75}, "^reflectance: got 0.75 in face 0, whose transmittance is 0.5, want"),
    ],
)
def test_what_no_surface_has_is_refused(optics, message):
    with pytest.raises(ValueError, match=message):
        box(**optics)


def test_shares_whose_sum_is_one_are_kept_though_their_float32_are_rounded():
    tau = np.arange(1, 1000) / 1000.0
    faces = np.repeat(BOX.faces[:1], len(tau), axis=0)
    mesh = ws.Mesh(BOX.vertices, faces, transmittance=tau, reflectance=1.0 - tau)
    again = ws.as_mesh((BOX.vertices, faces), transmittance=mesh.transmittance, reflectance=mesh.reflectance)
    assert (again.transmittance.astype(float) + again.reflectance).max() > 1.0  # so that this is a trial


def test_meshes_of_other_shares_are_other_meshes():
    """A worker that knows the shape must not answer with another transmittance."""
    made = [box(), box(transmittance=0.0), box(reflectance=0.0), box(transmittance=0.5), box(reflectance=0.5)]
    assert len({mesh.digest for mesh in made}) == len({mesh._content for mesh in made}) == len(made)
    parts = [ws.Mesh(BOX.vertices, BOX.faces, np.zeros(12, np.int32), ("a",), tau) for tau in (None, 0.5)]
    assert parts[0]._content != parts[1]._content


def test_shares_go_where_the_mesh_goes():
    mesh = box(transmittance=TAU, reflectance=1.0 - TAU)
    pickled = pickle.dumps(mesh)
    shared_values._values.pop(mesh.digest)
    moved = ws.refit(mesh, mesh.vertices + 1.0)
    for other in (pickle.loads(pickled), copy.copy(mesh), moved):
        assert np.array_equal(other.transmittance, mesh.transmittance)
        assert np.array_equal(other.reflectance, mesh.reflectance)
    assert mesh.__sizeof__() - box().__sizeof__() == 2 * 4 * len(mesh.faces)


def test_what_takes_no_transmission_refuses_it():
    with pytest.raises(ValueError, match="^mesh: got a mesh with a transmittance above 0, which reciprocal does not"):
        ws.view_factors(box(transmittance=0.5), reciprocal=True)
