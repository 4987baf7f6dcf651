"""View factors in use: radiosity where little is absorbed, matrices that are changed in place, files that are damaged."""

import numpy as np
import pytest
from view_factor_cases import CUBE

import warpsample as ws
from warpsample.radiation.exchange import hits_to_matrix

pytestmark = pytest.mark.slow  # seconds each, and kernels to compile; .ci/run runs them too


@pytest.fixture(scope="module")
def room():
    return ws.view_factors(CUBE, 256)


def solved(v, emission, reflectance):
    """By dense equations."""
    return np.linalg.solve(np.eye(len(v.areas)) - np.diag(reflectance) @ v.matrix.toarray(), emission)


@pytest.mark.parametrize("reflectance", [0.99, 0.999, 0.9999, 0.99999])
def test_little_is_absorbed_in_an_integrating_sphere(room, reflectance):
    emission = np.arange(12.0)
    right = solved(room, emission, np.full(12, reflectance))
    assert room.radiosity(emission, reflectance) == pytest.approx(right, rel=1e-11)


def test_one_wall_absorbs_all_that_the_others_give_back(room):
    reflectance = np.where(np.arange(12) == 3, 0.999, 1.0)
    emission = np.arange(12.0)
    assert room.radiosity(emission, reflectance) == pytest.approx(solved(room, emission, reflectance), rel=1e-10)


def test_each_column_has_its_digits(room):
    emission = np.stack([np.ones(12), np.where(np.arange(12) == 0, 1e-15, 0.0), np.full(12, 1e-310)], axis=1)
    both = room.radiosity(emission, 0.9)
    for column in range(2):
        assert both[:, column] == pytest.approx(solved(room, emission[:, column], np.full(12, 0.9)), rel=1e-11, abs=0.0)
    assert both[:, 2] == pytest.approx(np.full(12, 1e-309), rel=1e-9, abs=0.0)


def test_a_table_has_a_row_for_each_surface():
    mesh = ws.load_mesh("courtyard")
    named = ws.view_factors(mesh, 16, groups=np.repeat(["yard", "rest"], [848, 1232]), up=(0, 0, 1))
    table = named.to_frame()
    assert list(table["names"]) == ["rest", "yard"]
    assert {"areas", "sky", "sky_error", "ground", "rays"} <= set(table)
    assert "status" not in set(table)  # which is of faces
    assert np.array_equal(table["sky"], named.sky)


def test_what_has_no_solution_is_refused(room):
    with pytest.raises(ValueError, match="reflectance: got up to 1, with which 1 of the radiation remains"):
        room.radiosity(np.arange(12.0), 1.0)
    with pytest.raises(ValueError, match=r"emission: got 1e\+308, want smaller numbers"):
        room.radiosity(1e308, 0.9)
    assert room.radiosity(0.0, 1.0).tolist() == [0.0] * 12


@pytest.mark.parametrize("wrong", [np.nan, np.inf])
def test_one_number_that_is_none_is_refused(room, wrong):
    numbers = np.where(np.arange(12) == 7, wrong, 0.5)
    for given, name in (((numbers, 0.5), "emission"), ((1.0, numbers), "reflectance")):
        with pytest.raises(ValueError, match=rf"^{name}: got .*, want finite numbers"):
            room.radiosity(*given)


def test_rows_that_were_left_out_are_not_taken_for_black_or_open(tmp_path):
    v = ws.view_factors(CUBE, 64, active=np.arange(12) < 6)
    said = "active: got 6 rows without rays, want view factors of all faces"
    for use in (
        lambda: v.radiosity(1.0, 0.5),
        *(lambda name=name: v.save(tmp_path / name) for name in ("vfsparse.inp", "a.vf")),
    ):
        with pytest.raises(ValueError, match=said):
            use()
    assert list(tmp_path.iterdir()) == []
    v.save(tmp_path / "a.npz")
    assert (ws.ViewFactors.load(tmp_path / "a.npz").matrix != v.matrix).nnz == 0


@pytest.mark.parametrize("loaded", [False, True], ids=["made", "loaded"])
def test_who_drops_factors_keeps_the_errors_of_the_others(loaded, tmp_path):
    v = ws.view_factors(CUBE, 256)
    if loaded:
        v.save(tmp_path / "a.npz")
        v = ws.ViewFactors.load(tmp_path / "a.npz")
    before = v.standard_error.toarray()
    v.matrix.data[v.matrix.data < 0.1] = 0.0
    v.matrix.eliminate_zeros()
    assert np.array_equal(v.standard_error.toarray(), before)


def test_a_damaged_archive_is_refused(tmp_path):
    v = ws.view_factors(CUBE, 64, up=(0, 0, 1))
    v.save(tmp_path / "good.npz")
    with np.load(tmp_path / "good.npz") as archive:
        good = dict(archive)
    damaged = {
        "data": (
            good["data"][:-1],
            good["data"].astype("f4"),
            good["data"].astype(str),
            good["data"] + 1j,
            good["data"] * np.nan,
        ),
        "standard_error": (-good["standard_error"] - 1.0, good["standard_error"][:, None]),
        "indices": (
            good["indices"].astype(int) + 2**32,
            good["indices"][::-1].copy(),
            good["indices"] * 0,
            good["indices"] + 12,
        ),
        "indptr": (good["indptr"][:-1], good["indptr"][::-1].copy(), good["indptr"] * 1.0),
        "shape": (np.array([12, 13]), np.array(12), np.array([12, 12, 12])),
        "outside": (good["outside"][:3], np.array(1.0), good["outside"].astype(str)),
        "areas": (good["areas"] * np.inf,),
        "rays": (good["rays"] * 1.0,),
        "status": (good["status"].astype(int), good["status"][None]),
        "skipped": (good["skipped"][:1], good["skipped"] * 1.0),
        "sky": (good["sky"][:2], None),
    }
    file = tmp_path / "bad.npz"
    for name, values in damaged.items():
        for value in values:
            held = {key: array for key, array in (good | {name: value}).items() if array is not None}
            np.savez(file, **held)
            with pytest.raises(ValueError, match="path: got .*bad.npz', which cannot be read as view factors"):
                ws.ViewFactors.load(file)
    content = (tmp_path / "good.npz").read_bytes()
    for length in range(0, len(content), 97):  # no file is left open, either: that would be a ResourceWarning
        file.write_bytes(content[:length])
        with pytest.raises(ValueError, match="cannot be read as view factors"):
            ws.ViewFactors.load(file)
    np.save(tmp_path / "bad.npy", good["data"])
    with pytest.raises(ValueError, match=r"the file is not an \.npz file"):
        ws.ViewFactors.load(tmp_path / "bad.npy")


def test_a_list_without_its_sky_is_not_left(room, tmp_path, monkeypatch):
    """uDALES reads both files: of two runs they must not be."""
    from warpsample.radiation.exchange import files as view_factor_files

    for name in ("vfsparse.inp", "svf.inp"):
        (tmp_path / name).write_text("old")

    def full(*_):
        raise OSError("no space left")

    monkeypatch.setattr(view_factor_files, "_write_sky", full)
    with pytest.raises(OSError, match="no space"):
        room.save(tmp_path / "vfsparse.inp")
    assert {path.name: path.read_text() for path in tmp_path.iterdir()} == {"vfsparse.inp": "old", "svf.inp": "old"}


def test_memory_of_replicates_is_counted(monkeypatch):
    asked = []
    monkeypatch.setattr(hits_to_matrix, "check_memory", lambda needed, *_: asked.append(needed))
    v = ws.view_factors(CUBE, 64, replicates=64)
    assert max(asked) >= 8 * 64 * v.matrix.nnz
