"""The first commands of a newcomer, on terminals and machines of all kinds."""

import os
import pty
import re
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
import trimesh
from hangs import HANGS

import warpsample as ws
from warpsample.mesh import examples


@pytest.fixture
def run(child_environment, tmp_path):
    """`python -m warpsample ...` in its own process and folder."""

    def run(*arguments, **environment):
        command = [sys.executable, "-m", "warpsample", *map(str, arguments)]
        variables = {**child_environment, **environment}
        done = subprocess.run(command, env=variables, capture_output=True, text=True, check=False, cwd=tmp_path)
        said = "".join(line for line in done.stderr.splitlines(keepends=True) if "Warp CUDA" not in line)
        return done.returncode, done.stdout, said

    return run


def test_a_call_leaves_the_environment_as_it_was(call):
    """PYTHONSAFEPATH, for child processes, stayed and broke scripts that the caller started."""
    before = dict(os.environ)
    call("--version")
    assert dict(os.environ) == before


@pytest.mark.slow
def test_the_version_is_said(run):
    assert re.fullmatch(r"\d+\.\d+\.\d+", ws.__version__)
    assert run("--version") == (0, f"warpsample {ws.__version__}\n", "")


@pytest.mark.parametrize("command", [[], ["info"], ["bench"], ["bench", "rays"]])
def test_h_is_help(call, command):
    status, out, err = call(*command, "-h")
    assert (status, err) == (0, "")
    assert "Usage: warpsample" in out
    assert out == call(*command, "--help")[1]


def test_a_file_name_is_shown_as_it_is(call, tmp_path):
    path = tmp_path / "scan[final].ply"
    trimesh.creation.box().export(path)
    out = call("info", path)[1]
    assert "scan[final].ply" in out.replace("\n", "")
    status, _, err = call("info", "scan[/b].ply")
    assert (status, "'scan[/b].ply'" in err) == (2, True)


@pytest.mark.thorough
def test_an_ascii_terminal_shows_all_texts(run, can_render, tmp_path):
    """The labels of a picture contain a theta, and a file may have any name."""
    ascii_only = {"PYTHONIOENCODING": "ascii", "PYTHONUTF8": "0", "PYTHONCOERCECLOCALE": "0"}
    status, out, err = run("view", "courtyard", "--points", 3, "--samples", 16, "--screenshot", "é.png", **ascii_only)
    assert (status, err) == (0, "")
    assert "\\xe9.png: 3 points x 16 directions" in out
    assert "; theta agrees" in out
    assert "; phi agrees" in out
    assert (tmp_path / "é.png").stat().st_size > 0
    for arguments in (["info", "courtyard"], ["view", "-h"], ["bench", "-h"]):
        status, out, err = run(*arguments, **ascii_only)
        assert (status, err, out.isascii()) == (0, "", True)


@pytest.mark.thorough
def test_an_html_is_made_without_a_network(child_environment, can_render, tmp_path):
    code = """
import socket, sys
def refuse(*asked, **more):
    print("asked for", asked, file=sys.stderr)
    raise OSError("no network")
for name in ("getaddrinfo", "gethostbyname", "gethostbyname_ex", "gethostbyaddr", "getfqdn", "create_connection"):
    setattr(socket, name, refuse)
sys.argv = ["warpsample", "view", "courtyard", "--points", "3", "--samples", "16", "--screenshot", "a.html"]
from warpsample.cli import main
main()
"""
    command = [sys.executable, "-c", code]
    done = subprocess.run(command, env=child_environment, capture_output=True, text=True, check=False, cwd=tmp_path)
    assert [line for line in done.stderr.splitlines() if "CUDA" not in line] == []
    assert done.stdout.startswith("a.html: 3 points")
    assert (tmp_path / "a.html").stat().st_size > 100_000


@pytest.mark.parametrize(
    ("arguments", "option"),
    [
        (["bake", "courtyard", "-o", "a.npz", "--samples", "1"], "--samples"),
        (["bake", "courtyard", "-o", "a.npz", "--tolerance", "0"], "--tolerance"),
        (["bake", "courtyard", "-o", "a.npz", "--max-distance", "-1"], "--max-distance"),
        (["bake", "courtyard", "-o", "a.npz", "--falloff", "-1", "--max-distance", "1"], "--falloff"),
        (["bake", "courtyard", "-o", "a.npz", "--quantity", "sky", "--up", "0", "0", "0"], "--up"),
        (["bake", "courtyard", "-o", "a.npz", "--sequence", "halton"], "--sequence"),
        (["bake", "courtyard", "-o", "a.npz", "--quantity", "irradiance", "--environment", "no.hdr"], "--environment"),
        (["directions", "courtyard", "-o", "a.npz", "--samples", "0"], "--samples"),
        (["verify", "--plant", "nothing"], "--plant"),
        (["bench", "rays", "--scene", "nowhere"], "--scene"),
    ],
)
def test_an_error_names_the_option(call, arguments, option, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    status, out, err = call(*arguments)
    assert (status, out, err.count("\n")) == (2, "", 1)
    assert err.startswith(f"error: {option}: got")
    assert list(tmp_path.iterdir()) == []


@pytest.mark.thorough
@pytest.mark.parametrize(
    "arguments",
    [
        ["info", "courtyard"],
        ["directions", "courtyard", "-o", "a.npz", "--points", "9"],
        ["--help"],
        ["--version"],
        ["info", "--help"],
        ["bench", "--help"],
        [],
    ],
)
def test_a_reader_that_has_gone_is_no_traceback(child_environment, tmp_path, arguments):
    """The pipe is closed before anything is written; the status is that of SIGPIPE."""
    reader, writer = os.pipe()
    os.close(reader)
    command = [sys.executable, "-m", "warpsample", *arguments]
    options = {"cwd": tmp_path, "env": child_environment, "stdout": writer, "stderr": subprocess.PIPE}
    done = subprocess.run(command, text=True, check=False, **options)
    os.close(writer)
    assert done.returncode == 141
    assert [line for line in done.stderr.splitlines() if "CUDA" not in line] == []


WORKING = """
import threading, time
from warpsample.cli import terminal
terminal._SILENCE = {0}
with terminal.working("reading it"):
    while {0} == 0.0 and any(isinstance(thread, threading.Timer) for thread in threading.enumerate()):
        time.sleep(0.01)
"""


@pytest.mark.slow
def test_a_slow_step_is_said_on_a_terminal_only(child_environment):
    for silence, said in ((0.0, "reading it ...\r\n"), (HANGS, "")):
        master, slave = pty.openpty()
        command = [sys.executable, "-c", WORKING.format(silence)]
        subprocess.run(command, env=child_environment, stderr=slave, check=True)
        os.write(slave, b"|")
        text = os.read(master, 1000)
        while not text.endswith(b"|"):
            text += os.read(master, 1000)
        assert text.decode() == f"{said}|"
        os.close(master)
        os.close(slave)
    done = subprocess.run(
        [sys.executable, "-c", WORKING.format(0.0)], env=child_environment, capture_output=True, check=True
    )
    assert (done.stdout, done.stderr) == (b"", b"")


# The example


def test_the_courtyard_is_a_mesh_without_flaws():
    mesh = ws.load_mesh("courtyard")
    report = mesh.report
    assert (report.degenerate_faces, report.duplicate_faces, report.unreferenced_vertices) == (0, 0, 0)
    assert (report.nonmanifold_edges, report.inconsistent_edges) == (0, 0)
    assert report.boundary_edges == 4 * 24  # of the ground
    assert mesh.bounds.tolist() == [[0.0, 0.0, 0.0], [72.0, 72.0, 24.0]]
    assert (np.ptp(mesh.vertices[mesh.faces], axis=1).max(axis=1) == 3.0).all()
    # Faces out: the volume over the ground, which is closed by it, is that of the buildings.
    a, b, c = (mesh.vertices[mesh.faces[:, k]] for k in range(3))
    volume = np.einsum("fk,fk->f", a, np.cross(b, c)).sum() / 6.0
    cells = 14 * 4 * 4 + 14 * 4 * 6 + 4 * 4 * 3 + 4 * 6 * 8
    assert volume == pytest.approx(27.0 * cells, rel=1e-12)


def test_in_the_yard_there_is_less_sky_than_on_the_roofs():
    mesh = ws.load_mesh("courtyard")
    position = np.array([[36.5, 36.5, 0.0], [5.5, 36.5, 0.0], [50.5, 36.5, 24.0]])
    points = ws.SurfacePoints(position, np.float32([[0.0, 0.0, 1.0]] * 3))
    yard, street, roof = ws.sky_view_factor(mesh, points, 1024).value
    assert yard < 0.5 < street < roof
    assert roof == 1.0  # the highest


def test_a_file_of_that_name_goes_first(tmp_path, monkeypatch, call):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "courtyard").write_text("no mesh")
    with pytest.raises(ValueError, match="want a file that ends in"):
        ws.load_mesh("courtyard")
    with pytest.raises(FileNotFoundError, match="which is missing"):
        ws.load_mesh("Courtyard.ply")


def test_the_digest_of_the_example_tells_it_from_files(tmp_path):
    path = tmp_path / "mesh.ply"
    path.write_bytes(b"bytes of a file")
    assert examples.content_of(path) == b"bytes of a file"
    vertices, faces = examples.courtyard()
    assert examples.content_of(Path("courtyard")) == vertices.tobytes() + faces.tobytes()


CLOSED = {"stdout": ">&-", "stderr": "2>&-", "all": "<&- >&- 2>&-"}


@pytest.mark.thorough
@pytest.mark.parametrize("streams", CLOSED)
def test_what_is_closed_is_nowhere(streams, child_environment, tmp_path):
    """Standard streams are closed, as a service's are; the output file does not get what is printed."""
    command = f"{sys.executable} -m warpsample"
    writes = f"{command} directions courtyard -o o.ply --points 9 --samples 2 {CLOSED[streams]}"
    lines = f"{writes} && {command} info o.off {CLOSED[streams]}"
    done = subprocess.run(
        ["sh", "-c", lines], env=child_environment, capture_output=True, text=True, check=False, cwd=tmp_path
    )
    missing = "error: path: got 'o.off', which is missing, want a mesh file\n"
    assert (done.returncode, done.stderr) == (2, missing if streams == "stdout" else "")
    assert (tmp_path / "o.ply").read_bytes().startswith(b"ply\n")


@pytest.mark.thorough
@pytest.mark.skipif(not Path("/dev/full").exists(), reason="a device of Linux")
@pytest.mark.parametrize(
    "arguments", ["--version", *(pytest.param(a, marks=pytest.mark.thorough) for a in ("--help", "info courtyard"))]
)
def test_a_full_disk_under_stdout_is_one_sentence(arguments, child_environment):
    variables = {name: value for name, value in child_environment.items() if name != "PYTHONUNBUFFERED"}
    command = f"{sys.executable} -m warpsample {arguments} > /dev/full"
    done = subprocess.run(["sh", "-c", command], env=variables, capture_output=True, text=True, check=False)
    assert (done.returncode, done.stderr) == (1, "error: standard output cannot be written: No space left on device\n")
