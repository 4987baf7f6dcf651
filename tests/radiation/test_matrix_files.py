"""Sky matrices as files: .npz, and those that Radiance's programs read."""

import subprocess
from math import pi
from pathlib import Path

import numpy as np
import pytest

import warpsample as ws
from warpsample.radiation.exchange.matrix_files import read_matrix, write_matrix


@pytest.fixture(scope="module")
def matrix():
    mesh = ws.load_mesh("courtyard")
    return ws.sky_matrix(mesh, ws.sample_surface(mesh, 40, seed=1), 64)


def test_a_matrix_of_radiances_comes_back(matrix, tmp_path):
    matrix.save(tmp_path / "sky.mtx")
    content = (tmp_path / "sky.mtx").read_bytes()
    assert content.startswith(b"#?RADIANCE\nNROWS=40\nNCOLS=146\nNCOMP=3\nBigEndian=0\nFORMAT=float\n\n")
    back = read_matrix(content)
    assert back.shape == (40, 146, 3)
    assert not back[:, 0].any()  # the ground comes first
    exact = pi * matrix.value.astype(np.float64)  # as of rcontrib: irradiance, not its share
    assert np.abs(back[:, 1:] - exact[:, :, None]).max() <= 1e-7
    assert np.array_equal(read_matrix(content.replace(b"NCOMP=3", b" NCOMP = 3 ")), back)
    body = content.index(b"\n\n") + 2
    swapped = content[:body].replace(b"BigEndian=0", b"BigEndian=1") + back.astype(">f4").tobytes()
    assert np.array_equal(read_matrix(swapped), back)


def test_large_matrices_are_written_in_parts(tmp_path, monkeypatch):
    matrix = np.random.default_rng(1).uniform(size=(50, 7)).astype(np.float32)
    monkeypatch.setattr("warpsample.radiation.exchange.matrix_files._BLOCK", 100)
    with (tmp_path / "part.mtx").open("wb") as stream:
        write_matrix(stream, matrix, ground=False)
    assert np.array_equal(read_matrix((tmp_path / "part.mtx").read_bytes()), np.repeat(matrix[:, :, None], 3, axis=2))


def test_an_npz_has_the_arrays(matrix, tmp_path):
    matrix.save(str(tmp_path / "sky.npz"))
    with np.load(tmp_path / "sky.npz", allow_pickle=False) as file:
        assert np.array_equal(file["value"], matrix.value)
        assert np.array_equal(file["standard_error"], matrix.standard_error)
        assert np.array_equal(file["directions"], matrix.patches.directions)
        assert set(file) == {"value", "standard_error", "rays", "status", "directions", "solid_angles"}


@pytest.mark.parametrize(
    ("change", "message"),
    [
        (lambda c: c[:-1], r"matrix: got 70,079 bytes of numbers, want 4 x 40 x 146 x 3"),
        (lambda c: c + b"1234", r"matrix: got 70,084 bytes of numbers, want 4 x 40 x 146 x 3"),
        (lambda c: c.replace(b"FORMAT=float", b"FORMAT=ascii"), r"matrix: got .*, want a Radiance matrix"),
        (lambda c: c.replace(b"NROWS=40", b"NROWS=-4"), r"matrix: got .*, want a Radiance matrix"),
        (lambda c: c.replace(b"NCOMP=3\n", b""), r"matrix: got .*, want a Radiance matrix"),
        (lambda _: b"", r"matrix: got b'', want a Radiance matrix"),
    ],
)
def test_damaged_matrices_are_refused(matrix, tmp_path, change, message):
    matrix.save(tmp_path / "sky.mtx")
    with pytest.raises(ValueError, match=message):
        read_matrix(change((tmp_path / "sky.mtx").read_bytes()))


def test_what_cannot_be_saved_is_refused(matrix, tmp_path):
    with pytest.raises(ValueError, match=r"^path: got '.*sky.txt', want the path of a file of .npz or .mtx"):
        matrix.save(tmp_path / "sky.txt")
    with pytest.raises(ValueError, match=r"^path: got '.*', whose folder does not exist"):
        matrix.save(tmp_path / "none" / "sky.mtx")
    with pytest.raises(TypeError, match=r"^path: got 3, want the path"):
        matrix.save(3)
    mesh = ws.load_mesh("courtyard")
    folded = ws.sky_matrix(mesh, ws.sample_surface(mesh, 4), 64, fold=np.ones((145, 145)))
    with pytest.raises(
        ValueError, match=r"^path: got .* for a result of sky_matrix with fold=, want .npz, or a result without fold"
    ):
        folded.save(tmp_path / "sky.mtx")
    assert list(tmp_path.iterdir()) == []


@pytest.mark.slow
def test_rmtxop_and_dctimestep_read_it(matrix, tmp_path):
    pyradiance = pytest.importorskip("pyradiance")
    programs = Path(pyradiance.__file__).parent / "bin"
    matrix.save(tmp_path / "sky.mtx")
    done = subprocess.run([programs / "rmtxop", "-ff", tmp_path / "sky.mtx"], capture_output=True, check=True)
    assert np.array_equal(read_matrix(done.stdout), read_matrix((tmp_path / "sky.mtx").read_bytes()))
    radiance = np.random.default_rng(1).uniform(size=(146, 3)).astype(np.float32)
    sky = b"#?RADIANCE\nNROWS=146\nNCOLS=1\nNCOMP=3\nBigEndian=0\nFORMAT=float\n\n" + radiance.tobytes()
    (tmp_path / "one.mtx").write_bytes(sky)
    command = [programs / "dctimestep", "-of", tmp_path / "sky.mtx", tmp_path / "one.mtx"]
    done = subprocess.run(command, capture_output=True, check=True)
    exact = pi * matrix.value.astype(np.float64) @ radiance[1:].astype(np.float64)
    assert np.abs(read_matrix(done.stdout)[:, 0] - exact).max() <= 1e-5
