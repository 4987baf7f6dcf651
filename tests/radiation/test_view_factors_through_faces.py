"""View factors of meshes that light goes through: what arrives, what is swallowed, and rows that close."""

import glass_cases as cases
import numpy as np
import pytest

import warpsample as ws

pytestmark = pytest.mark.slow  # kernels of their own
GROUPS = np.array([0, 0, 1, 1, 2, 2])
BETWEEN = 0.1998248957  # unit squares face to face at a distance of 1


def plates(tau, size=1e4):
    """Two squares that face each other, and a pane between them."""
    low, (corners, faces) = cases.sheet(0.5, 0.0), cases.sheet(0.5, 1.0)
    return cases.made_of((low, 0.0), ((corners, faces[:, ::-1]), 0.0), (cases.sheet(size, 0.5), tau))


def closure(v):
    return v.matrix.sum(axis=1) + v.outside + v.behind + v.absorbed


def alike(v, other):
    names = ("outside", "outside_error", "behind", "absorbed", "absorbed_error", "sky", "ground")
    same = all(np.array_equal(getattr(v, name), getattr(other, name)) for name in names)
    return same and (v.matrix != other.matrix).nnz == 0 == (v.standard_error != other.standard_error).nnz


def test_a_pane_dims_what_arrives_and_swallows_the_rest():
    """Rays are the same whatever the pane lets through: so are the factors, times that."""
    clear = ws.view_factors(plates(1.0), 4096, groups=GROUPS, up=cases.UP)
    assert (clear.absorbed == 0.0).all()
    assert clear.matrix[0, 1] == pytest.approx(BETWEEN, abs=4.0 * clear.standard_error[0, 1])
    dim = ws.view_factors(plates(0.25), 4096, groups=GROUPS, up=cases.UP)
    np.testing.assert_allclose(closure(dim), 1.0, rtol=1e-12)
    assert dim.matrix.shape == (3, 3)
    assert dim.matrix[:, [2]].sum() == 0.0  # no column
    for name in ("outside", "sky"):
        np.testing.assert_allclose(getattr(dim, name)[:2], 0.25 * getattr(clear, name)[:2], rtol=1e-12)
    np.testing.assert_allclose(dim.matrix[:2].toarray(), 0.25 * clear.matrix[:2].toarray(), rtol=1e-12)
    np.testing.assert_allclose(dim.absorbed, [0.75, 0.75, 0.0], atol=1e-12)
    np.testing.assert_allclose(dim.standard_error[0, 1], 0.25 * clear.standard_error[0, 1], rtol=0.5)
    J = dim.radiosity([1.0, 0.0, 0.0], [0.0, 1.0, 0.0])
    np.testing.assert_allclose(J, [1.0, dim.matrix[1, 0], 0.0])
    for pane in (clear, dim):
        with pytest.raises(ValueError, match="^mesh: got view factors of a mesh with a transmittance, want opaque faces"):
            pane.net_radiation(300.0, 0.9)


def test_skipping_threads_and_files_keep_every_bit(tmp_path):
    mesh = cases.garden()
    v = ws.view_factors(mesh, 256, up=cases.UP)
    assert alike(v, ws.view_factors(mesh, 256, up=cases.UP, skip=False, workers=1))
    np.testing.assert_allclose(closure(v), 1.0, rtol=1e-12)
    assert (v.absorbed > 0.05).any()
    assert v.skipped.open_points > 0
    v.save(tmp_path / "v.npz")
    assert alike(v, ws.ViewFactors.load(tmp_path / "v.npz"))
    opaque = ws.as_mesh((mesh.vertices, mesh.faces))
    dark = ws.view_factors(ws.as_mesh(opaque, transmittance=0.0), 256)
    assert (dark.matrix != ws.view_factors(opaque, 256).matrix).nnz == 0


@pytest.mark.thorough
def test_bars_are_as_wide_as_errors_behind_a_small_pane():
    found = [ws.view_factors(plates(0.25, 0.3), 1024, groups=GROUPS, seed=seed) for seed in range(300)]
    for values, errors in (
        ([v.matrix[0, 1] for v in found], [v.standard_error[0, 1] for v in found]),
        ([v.absorbed[0] for v in found], [v.absorbed_error[0] for v in found]),
        ([v.outside[0] for v in found], [v.outside_error[0] for v in found]),
    ):
        assert 0.7 < np.var(values) / np.mean(np.square(errors)) < 1.3
