"""What view factors are used for: radiosity, files of other programs; and bad input."""

import zipfile

import numpy as np
import pytest
from scipy import sparse
from view_factor_cases import CUBE, TETRAHEDRON, Z, alike, box, scene

import warpsample as ws

COURTYARD = ws.load_mesh("courtyard")


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


def test_groups_that_do_not_see_each_other_are_read_back(tmp_path):
    """Without a pair the factors were integers, which no archive may hold."""
    v = ws.view_factors(ws.as_mesh((CUBE.vertices, CUBE.faces[:, ::-1])), 64, groups=["a"] * 6 + ["b"] * 6)
    v.save(tmp_path / "factors.npz")
    read = ws.ViewFactors.load(tmp_path / "factors.npz")
    assert read.matrix.nnz == 0
    assert read.matrix.dtype == np.float64


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
    (tmp_path / "svf.inp.2").write_text("of another scene")
    with pytest.raises(ValueError, match=r"would replace svf\.inp\.2 in the same folder, want another name"):
        v.save(tmp_path / "vfsparse.inp.2")
    assert (tmp_path / "svf.inp.2").read_text() == "of another scene"
    np.savez(tmp_path / "other.npz", data=np.ones(3))
    (tmp_path / "broken.npz").write_bytes(b"PK nothing")
    np.savez(tmp_path / "pickled.npz", data=np.array([{}], object))
    for name, said in (("other", "lacks the arrays"), ("broken", "cannot be read"), ("pickled", "cannot be read")):
        with pytest.raises(ValueError, match=said):
            ws.ViewFactors.load(tmp_path / f"{name}.npz")
    with pytest.raises(FileNotFoundError, match="missing"):
        ws.ViewFactors.load(tmp_path / "none.npz")
    with zipfile.ZipFile(tmp_path / "huge.npz", "w") as archive, archive.open("data.npy", "w") as member:
        np.lib.format.write_array_header_1_0(member, {"descr": "<f8", "fortran_order": False, "shape": (10**12,)})
    with pytest.raises(
        ValueError, match=r"the header of data\.npy declares 8,000,000,000,000 bytes, but the file can hold at most .*$"
    ):
        ws.ViewFactors.load(tmp_path / "huge.npz")


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
def test_bad_input_is_reported(options, said):
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
