"""Statuses of points are compared with ints, so that no interrupt is lost in NumPy."""

import numpy as np
import pytest
from weights_of_tests import upward

import warpsample as ws

CALLS = {
    "integrate": lambda mesh: ws.integrate(ws.face_centers(mesh), upward, 16),
    "view_factors": lambda mesh: ws.view_factors(mesh, 16, active=np.arange(len(mesh.faces)) % 2 > 0),
    "sky_matrix": lambda mesh: ws.sky_matrix(mesh, ws.face_centers(mesh), 16, fold=np.ones(145)),
}


@pytest.mark.parametrize("call", CALLS)
def test_numpy_sees_no_enum(call, monkeypatch):
    """It would look its protocols up on the class, by Python code, and drop what a signal's handler raises there."""
    looked_up = []

    def heard(cls, name):
        if cls is ws.PointStatus:
            looked_up.append(name)
        raise AttributeError(name)

    monkeypatch.setattr(type(ws.PointStatus), "__getattr__", heard, raising=False)
    CALLS[call](ws.load_mesh("courtyard"))
    assert looked_up == []
    assert (np.zeros(3) == ws.PointStatus.OK).all()
    assert looked_up
