"""The errors of reciprocal factors take the way of the factors: in linear order, against differences of the whole."""

from dataclasses import replace

import numpy as np
import pytest

from warpsample.radiation.exchange import reciprocity
from warpsample.radiation.exchange.row_factors import RowFactors
from warpsample.radiation.exchange.surfaces import surfaces_of


def test_a_drawn_error_changes_factors_as_it_would_change_them_for_real(monkeypatch):
    """Six surfaces of unlike area whose factors are far from closing, so that every factor is far from 1."""
    rng = np.random.default_rng(4)
    there = ~np.eye(6, dtype=bool) & (rng.uniform(size=(6, 6)) < 0.8)
    indices, indptr = np.nonzero(there)[1].astype(np.int32), np.r_[0, np.cumsum(there.sum(axis=1))]
    others = {name: (rng.uniform(0.1, 0.5, 6), np.ones(6)) for name in ("outside", "behind", "sky", "ground")}
    factors = RowFactors(indptr, indices, rng.uniform(0.02, 0.3, len(indices)), np.ones(len(indices)), others)
    surfaces = surfaces_of(rng.uniform(0.5, 2.0, 6), np.ones(6, bool), None)
    error = rng.normal(size=len(indices)), {name: rng.normal(size=6) for name in others}

    class One:
        number = 1

        def __init__(self, of):
            pass

        def draw(self, number):
            return error

    monkeypatch.setattr(reciprocity, "ErrorDraws", One)
    found = reciprocity.reciprocal_factors(factors, surfaces)
    step = 1e-4
    moved = []
    for part in (step, -step):
        changed = {name: (value + part * error[1][name], one) for name, (value, one) in others.items()}
        moved.append(
            reciprocity.reciprocal_factors(replace(factors, value=factors.value + part * error[0], others=changed), surfaces)
        )
    # Rows close to 1e-8, which is 1e-4 of the step, and conjugate gradients to 1e-5.
    slopes = (moved[0].value - moved[1].value) / (2.0 * step)
    assert np.sqrt(found.variance) == pytest.approx(np.abs(slopes), rel=5e-3, abs=1e-3)
    for name in others:
        slopes = (moved[0].others[name][0] - moved[1].others[name][0]) / (2.0 * step)
        assert np.sqrt(found.others[name][1]) == pytest.approx(np.abs(slopes), rel=5e-3, abs=1e-3)
