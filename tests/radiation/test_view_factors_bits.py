"""What changes no bit of view factors; what makes them reciprocal; their files; and what is no input."""

import numpy as np
import pytest
from meshes import soup
from scipy import sparse
from view_factor_cases import GROUND, LID, TETRAHEDRON, X, Y, Z, box, rectangle, scene

import warpsample as ws
from warpsample.radiation import casting
from warpsample.radiation.reciprocity import reciprocal_shares
from warpsample.radiation.row_shares import Shares
from warpsample.radiation.surfaces import surfaces_of

COURTYARD = ws.load_mesh("courtyard")
CUBE, SIDES = scene(*box())
FIELDS = ("outside", "outside_error", "behind", "behind_error", "sky", "sky_error", "ground", "ground_error", "areas")


def alike(one, other):
    """The same bits, but for what was skipped."""
    for a, b in ((one.matrix, other.matrix), (one.standard_error, other.standard_error)):
        for name in ("data", "indices", "indptr"):
            assert np.array_equal(getattr(a, name), getattr(b, name))
    for name in FIELDS:
        assert np.array_equal(getattr(one, name), getattr(other, name)), name
    return True


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


def test_what_cannot_close_is_told():
    """Two surfaces that see each other alone, of unlike area: nothing is both reciprocal and closed."""
    nothing = (np.zeros(2), np.zeros(2))
    seen = Shares(np.arange(3), np.array([1, 0]), np.ones(2), np.zeros(2), {"outside": nothing, "behind": nothing})
    with pytest.warns(UserWarning, match="rows close to 0.3 only"):
        reciprocal_shares(seen, surfaces_of(np.array([1.0, 2.0]), np.ones(2, bool), None))


def test_radiosity_of_two_concentric_cubes():
    """Net exchange of two surfaces, one around the other: A1 s (T1^4 - T2^4) / (1/e1 + A1/A2 (1/e2 - 1))."""
    mesh, number = scene(*box(1.0, inwards=False), *box(2.0))
    v = ws.view_factors(mesh, 1024, groups=number // 6, reciprocal=True)
    black, emissivity = np.array([5.0, 2.0]), np.array([0.6, 0.3])
    leaving = v.radiosity(emissivity * black, 1.0 - emissivity)
    net = v.areas * (leaving - v.matrix @ leaving)
    right = v.areas[0] * 3.0 / (1.0 / 0.6 + v.areas[0] / v.areas[1] * (1.0 / 0.3 - 1.0))
    assert net == pytest.approx([right, -right], rel=1e-5)


def test_radiosity_of_three_surfaces():
    """A cube's floor and lid, and its walls as one that gives back all it gets: two surfaces and a bypass."""
    polygons = box()
    mesh, number = scene(*polygons)
    groups = np.where(number == 0, 0, np.where(number == 1, 1, 2))
    v = ws.view_factors(mesh, 2**16, groups=groups, reciprocal=True)
    emissivity, black = np.array([0.8, 0.4, 0.0]), np.array([10.0, 1.0, 0.0])
    leaving = v.radiosity(emissivity * black, 1.0 - emissivity)
    net = v.areas * (leaving - v.matrix @ leaving)
    direct, walled = 0.1998248957, 0.8001751043
    between = direct + 1.0 / (2.0 / walled)
    right = 9.0 / (0.2 / 0.8 + 1.0 / between + 0.6 / 0.4)
    assert net[:2] == pytest.approx([right, -right], rel=1e-3)
    assert abs(net[2]) < 1e-6


def test_radiosity_takes_several_emissions_and_says_what_it_wants():
    v = ws.view_factors(CUBE, 256)
    one = v.radiosity(np.arange(12.0), 0.5)
    several = v.radiosity(np.stack([np.arange(12.0), np.ones(12)], axis=1), np.full(12, 0.5))
    assert np.abs(several[:, 0] - one).max() < 1e-10
    assert several[:, 1] == pytest.approx(np.full(12, 2.0), rel=1e-11)  # 1 / (1 - 0.5), in an enclosure
    assert v.radiosity(1.0, 0.0).tolist() == [1.0] * 12
    for emission, reflectance, said in (
        (np.ones(3), 0.5, "emission: got shape"),
        (np.full(12, np.nan), 0.5, "emission: got"),
        ("bright", 0.5, "emission: got"),
        (np.ones(12), 1.5, "reflectance: got values from 1.5"),
        (np.ones(12), np.ones(3), "reflectance: got shape"),
        (np.ones(12), 1.0, "reflectance: got up to 1"),
    ):
        with pytest.raises((ValueError, TypeError), match=said):
            v.radiosity(emission, reflectance)


def test_an_archive_holds_all_and_scipy_reads_its_matrix(tmp_path):
    v = ws.view_factors(COURTYARD, 64, up=Z)
    v.save(tmp_path / "factors.npz")
    read = ws.ViewFactors.load(tmp_path / "factors.npz")
    assert alike(v, read)
    assert read.skipped == v.skipped
    assert np.array_equal(read.rays, v.rays)
    assert np.array_equal(read.status, v.status)
    assert (sparse.load_npz(tmp_path / "factors.npz") != v.matrix).nnz == 0
    plain = ws.view_factors(CUBE, 64)
    plain.save(tmp_path / "factors.npz")
    assert ws.ViewFactors.load(tmp_path / "factors.npz").sky is None


def test_files_of_udales(tmp_path):
    v = ws.view_factors(COURTYARD, 256)
    v.save(tmp_path / "vfsparse.inp.101")
    table = np.loadtxt(tmp_path / "vfsparse.inp.101")
    row, column = table[:, 0].astype(int) - 1, table[:, 1].astype(int) - 1
    assert (np.diff(row * len(COURTYARD.faces) + column) > 0).all()
    read = sparse.csr_array((table[:, 2], (row, column)), shape=v.matrix.shape)
    assert np.abs(read - v.matrix).max() < 1e-8
    lines = (tmp_path / "svf.inp.101").read_text().splitlines()
    assert lines[0] == "# sky view factors"
    assert np.array(lines[1:], float) == pytest.approx(1.0 - v.matrix.sum(axis=1), abs=1e-8)
    assert sorted(path.name for path in tmp_path.iterdir()) == ["svf.inp.101", "vfsparse.inp.101"]


def test_a_file_of_view3d(tmp_path):
    v = ws.view_factors(CUBE, 256)
    v.save(tmp_path / "cube.vf")
    header, areas, *rows, emittances = (tmp_path / "cube.vf").read_text().splitlines()
    assert header.split() == ["View3D", "3.5", "0", "0", "0", "12"]
    assert len(header) == 30
    assert np.array(areas.split(), float) == pytest.approx(v.areas)
    assert np.array([row.split() for row in rows], float) == pytest.approx(v.matrix.toarray(), abs=1e-8)
    assert emittances.split() == ["1.000"] * 12


def test_files_that_cannot_be_written_or_read(tmp_path):
    v = ws.view_factors(CUBE, 64)
    for path, said in (
        (tmp_path / "a.txt", "path: got .*want a name"),
        (tmp_path / "no" / "a.npz", "folder"),
        (3, "path: got 3"),
    ):
        with pytest.raises((ValueError, TypeError), match=said):
            v.save(path)
    (tmp_path / "svf.inp.1").mkdir()
    with pytest.raises(ValueError, match="svf.inp.1.*folder"):
        v.save(tmp_path / "vfsparse.inp.1")
    assert not (tmp_path / "vfsparse.inp.1").exists()
    np.savez(tmp_path / "other.npz", data=np.ones(3))
    (tmp_path / "broken.npz").write_bytes(b"PK nothing")
    np.savez(tmp_path / "pickled.npz", data=np.array([{}], object))
    for name, said in (("other", "has no"), ("broken", "cannot be read"), ("pickled", "cannot be read")):
        with pytest.raises(ValueError, match=said):
            ws.ViewFactors.load(tmp_path / f"{name}.npz")
    with pytest.raises(FileNotFoundError, match="missing"):
        ws.ViewFactors.load(tmp_path / "none.npz")


@pytest.mark.parametrize(
    ("options", "said"),
    [
        ({"count": 3}, "count: got 3, want a whole number from 4, the number of replicates"),
        ({"count": 2**24 + 1}, "count: got"),
        ({"count": 64.0}, "count: got 64.0"),
        ({"replicates": 0}, "replicates: got 0"),
        ({"groups": np.zeros(3, int)}, r"groups: got shape \(3,\), want \(12,\)"),
        ({"groups": np.full(12, -1)}, "groups: got numbers from -1"),
        ({"groups": np.full(12, 2**31 - 1)}, "groups: got numbers from 2147483647"),
        ({"groups": np.zeros(12)}, "groups: got dtype float64"),
        ({"groups": "roof"}, "groups: got"),
        ({"up": (0, 0, 0)}, "up: got"),
        ({"active": np.ones(3, bool)}, r"active: got shape \(3,\)"),
        ({"active": np.ones(12, bool), "reciprocal": True}, "active: got a mask with reciprocal"),
        ({"first_face": 2**62}, "first_face: got"),
        ({"seed": -1}, "seed: got -1"),
        ({"skip": 1}, "skip: got 1"),
        ({"reciprocal": "yes"}, "reciprocal: got 'yes'"),
        ({"workers": 0}, "workers: got 0"),
        ({"mesh": (np.zeros((3, 3)), np.zeros((0, 3), int))}, "faces: got"),
    ],
)
def test_bad_input_is_told(options, said):
    with pytest.raises((ValueError, TypeError), match=said):
        ws.view_factors(**{"mesh": CUBE} | options)


def test_what_does_not_fit_is_refused_before_it_is_made():
    with pytest.raises(MemoryError, match=r"2,147,483,647 groups need .* GB"):
        ws.view_factors(CUBE, 64, groups=np.full(12, 2**31 - 2))


def test_a_mesh_without_any_area_has_no_factors():
    v = ws.view_factors(([[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [2.0, 0.0, 0.0]], [[0, 1, 2]]), 64, up=Z)
    assert v.matrix.nnz == 0
    assert v.outside.tolist() == [0.0]
    v = ws.view_factors(scene(*TETRAHEDRON)[0], 64, active=np.zeros(4, bool))
    assert v.matrix.shape == (4, 4)
    assert v.matrix.nnz == 0
