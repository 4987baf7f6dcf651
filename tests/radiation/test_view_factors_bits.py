"""What changes no bit of view factors; what makes them reciprocal; their files; and what is no input."""

import numpy as np
import pytest
from meshes import soup
from view_factor_cases import CUBE, GROUND, LID, X, Y, Z, alike, rectangle, scene

import warpsample as ws
from warpsample.radiation.exchange import casting
from warpsample.radiation.exchange.reciprocity import reciprocal_factors
from warpsample.radiation.exchange.row_factors import RowFactors
from warpsample.radiation.exchange.surfaces import surfaces_of

COURTYARD = ws.load_mesh("courtyard")


@pytest.mark.parametrize("options", [{}, {"groups": True}, {"reciprocal": True}], ids=["raw", "groups", "reciprocal"])
def test_threads_blocks_and_skipping_change_no_bit(options, monkeypatch):
    mesh = soup(150)
    if options.get("groups"):
        options = {"groups": np.arange(150) % 7}
    base = ws.view_factors(mesh, 64, up=Z, workers=1, **options)
    assert base.behind.max() > 0.0
    assert alike(base, ws.view_factors(mesh, 64, up=Z, workers=2, **options))
    assert alike(base, ws.view_factors(mesh, 64, up=Z, skip=False, **options))
    monkeypatch.setattr(casting, "_BLOCK", 1)
    assert alike(base, ws.view_factors(mesh, 64, up=Z, workers=1, **options))
    assert alike(base, ws.view_factors(mesh, 64, up=Z, workers=3, **options))


def test_skipping_changes_no_bit_of_open_faces():
    v, cast = ws.view_factors(COURTYARD, 64, up=Z), ws.view_factors(COURTYARD, 64, up=Z, skip=False)
    assert alike(v, cast)
    assert v.skipped.open_points == 48  # the highest roofs, and it is all that is cast less
    assert v.rays.sum() + v.skipped.empty_rays == cast.rays.sum() == 64 * len(COURTYARD.faces)


def test_rows_of_some_faces_are_the_same_rows():
    v = ws.view_factors(COURTYARD, 64, up=Z)
    chosen = np.arange(len(COURTYARD.faces)) % 5 == 0
    some = ws.view_factors(COURTYARD, 64, up=Z, active=chosen)
    assert (some.matrix[chosen] != v.matrix[chosen]).nnz == 0
    assert some.matrix[~chosen].nnz == 0
    assert np.array_equal(some.outside, np.where(chosen, v.outside, 0.0))
    assert (some.status[~chosen] == ws.PointStatus.INACTIVE).all()
    assert some.rays[~chosen].sum() == 0


def test_a_face_takes_its_global_number_with_it():
    """The same scene behind ten other faces, far below: rows and columns shift by ten."""
    below = [rectangle((0, 0, -1e-3 * (k + 1)), Y, X) for k in range(5)]
    one, other = scene(*below, GROUND, LID)[0], scene(GROUND, LID, *below)[0]
    first = ws.view_factors(one, 256).matrix.toarray()[10:, 10:]
    assert np.array_equal(ws.view_factors(other, 256, first_face=10).matrix.toarray()[:4, :4], first)
    assert not np.array_equal(ws.view_factors(other, 256).matrix.toarray()[:4, :4], first)


def test_seeds_differ_and_the_count_is_rounded_down():
    assert (ws.view_factors(CUBE, 64, seed=1).matrix != ws.view_factors(CUBE, 64).matrix).nnz > 0
    v = ws.view_factors(CUBE, 4099)
    assert alike_matrix(v, ws.view_factors(CUBE, 4096))
    odd = ws.view_factors(CUBE, 999, replicates=3)
    assert (odd.rays == 999).all()
    counts = odd.matrix.toarray() * 999
    assert np.abs(counts - np.round(counts)).max() < 1e-9
    assert (np.round(counts).sum(axis=1) == 999).all()


def alike_matrix(one, other):
    return (one.matrix != other.matrix).nnz == 0


def test_groups_are_sums_of_faces():
    v, grouped = ws.view_factors(COURTYARD, 64), None
    groups = (COURTYARD.face_normals[:, 2] > 0.5).astype(int) + 2
    grouped = ws.view_factors(COURTYARD, 64, groups=groups)
    areas = COURTYARD.face_areas
    right = [[areas[groups == a] @ v.matrix[groups == a][:, groups == b].sum(axis=1) for b in range(4)] for a in range(4)]
    total = np.array([areas[groups == a].sum() for a in range(4)])
    assert grouped.areas == pytest.approx(total)
    assert grouped.matrix.toarray() == pytest.approx(np.array(right) / np.maximum(total, 1.0)[:, None], abs=1e-12)
    assert grouped.outside[2] == pytest.approx((areas * v.outside)[groups == 2].sum() / total[2], abs=1e-12)
    assert grouped.matrix[:2].nnz == 0  # numbers that no face has
    assert grouped.rays.tolist() == [0, 0, *(v.rays[groups == g].sum() for g in (2, 3))]
    parts = (v.standard_error.multiply(areas[:, None]).toarray() ** 2).sum()
    assert 0.0 < grouped.standard_error[3, 2] * total[3] < 3.0 * np.sqrt(parts)


def test_pooled_factors_are_reciprocal_and_close():
    v = ws.view_factors(COURTYARD, 256, reciprocal=True, up=Z)
    exchange = v.matrix.multiply(v.areas[:, None]).tocsr()
    assert np.abs(exchange - exchange.T).max() <= 1e-12 * exchange.max()
    lost = v.outside + v.behind
    assert np.abs(v.matrix.sum(axis=1) + lost - 1.0).max() < 1e-7
    assert v.matrix.data.min() > 0.0
    assert np.abs(v.sky + v.ground - v.outside).max() < 1e-12
    assert v.standard_error.data.min() > 0.0
    raw = ws.view_factors(COURTYARD, 256)
    assert v.matrix.nnz > raw.matrix.nnz


@pytest.mark.parametrize("groups", [None, np.zeros(12, int)], ids=["faces", "groups"])
def test_a_room_that_is_inside_out_has_no_pairs(groups):
    v = ws.view_factors(ws.Mesh(CUBE.vertices, CUBE.faces[:, ::-1]), 64, groups=groups, reciprocal=True)
    assert v.matrix.nnz == 0
    assert (v.outside == 1.0).all()
    assert not v.outside_error.any()


def test_what_cannot_close_is_reported():
    """Two surfaces that see each other alone, of unlike area: nothing is both reciprocal and closed."""
    nothing = (np.zeros(2), np.zeros(2))
    seen = RowFactors(np.arange(3), np.array([1, 0]), np.ones(2), np.zeros(2), {"outside": nothing, "behind": nothing})
    with pytest.warns(UserWarning, match="rows add up to 1 only within 0.3"):
        reciprocal_factors(seen, surfaces_of(np.array([1.0, 2.0]), np.ones(2, bool), None))


def test_a_warning_names_the_line_that_calls():
    """One ray of each face of a cube: by some seed they say that a face is seen by more than it can see."""

    def by_twenty_seeds():
        for seed in range(20):
            ws.view_factors(CUBE, 1, replicates=1, reciprocal=True, seed=seed)

    with pytest.warns(UserWarning, match="^view_factors: rows add up to 1 only within .*; pass a larger count of ") as found:
        by_twenty_seeds()
    assert {warning.filename for warning in found} == {__file__}
