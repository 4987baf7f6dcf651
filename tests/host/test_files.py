"""Files are complete or absent: full disks, signals, killed processes, links, inputs, bad folders."""

import json
import os
import re
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from io import StringIO
from pathlib import Path

import numpy as np
import pytest
import trimesh

from warpsample.cli import commands
from warpsample.host import files
from warpsample.output import bake, export
from warpsample.plotting import rendering

OUTPUTS = [
    *(("directions", suffix, ["--samples", 8, "--count", 500]) for suffix in export.SUFFIXES),
    *(("bake", suffix, ["--samples", 32]) for suffix in bake.SUFFIXES),
    *(("bake", suffix, ["--samples", 32, "--at", "faces"]) for suffix in (".ply", ".glb", ".vtp")),
    ("bake", ".vtp", ["--samples", 32, "--at", "surface", "--points", 100]),
]
PICTURES = [*rendering.SCENE_SUFFIXES, *rendering.FIGURE_SUFFIXES]

# Each output whole, then under limits on the size of a file, the last of which lacks one byte. Python ignores SIGXFSZ.
LIMITED = """
import contextlib, io, json, os, resource, sys
from pathlib import Path
from warpsample import cli

def call(arguments):
    sys.argv, said = ["warpsample", *arguments], io.StringIO()
    with contextlib.redirect_stderr(said), contextlib.redirect_stdout(io.StringIO()):
        try:
            cli.main()
        except SystemExit as stop:
            return stop.code, said.getvalue()

for i, (command, suffix, options) in enumerate(json.loads(sys.argv[1])):
    folder = Path(f"{i}")
    folder.mkdir()
    output = folder / f"out{suffix}"
    arguments = [command, "ball.ply", "-o", str(output), *map(str, options)]
    assert call(arguments) == (0, ""), arguments
    whole = output.read_bytes()
    for limit in (1, 1000, len(whole) // 2, len(whole) - 1):
        resource.setrlimit(resource.RLIMIT_FSIZE, (limit, resource.RLIM_INFINITY))
        said = call(arguments)
        resource.setrlimit(resource.RLIMIT_FSIZE, (resource.RLIM_INFINITY, resource.RLIM_INFINITY))
        assert said == (1, f"error: {output} cannot be written: File too large\\n"), (arguments, limit, said)
        assert output.read_bytes() == whole, (arguments, limit)
        assert os.listdir(folder) == [output.name], (arguments, limit, os.listdir(folder))
    assert len(whole) > 2000
print("held")
"""

WRITING = """
import sys, time
from pathlib import Path
from warpsample.host import files
with files.complete_or_absent(Path("out.npz")) as file:
    file.write(bytes(3 << 20))
    print("writing", flush=True)
    sys.stdin.readline()
"""


class Ended(KeyboardInterrupt):
    """Raises as the command line does on a signal."""


@pytest.fixture
def ball(tmp_path):
    path = tmp_path / "ball.ply"
    trimesh.creation.icosphere(2).export(path)
    return path


def test_a_full_disk_leaves_the_old_file(ball, tmp_path, child_environment):
    """In a child, where VTK once ended in a segmentation fault."""
    command = [sys.executable, "-c", LIMITED, json.dumps(OUTPUTS)]
    done = subprocess.run(command, env=child_environment, cwd=tmp_path, capture_output=True, text=True, check=False)
    assert (done.returncode, done.stdout.splitlines()[-1:]) == (0, ["held"]), done.stderr


class FakePlotter:
    """With a picture and a page of 5,000 bytes."""

    trame = property(lambda self: self)

    def screenshot(self, stream, return_img):
        stream.write(bytes(5000))

    def export_html(self, name):
        return StringIO("<head></head>" + 5000 * "x")

    def close(self):
        pass


def save_picture(path):
    from matplotlib.figure import Figure

    if path.suffix in rendering.SCENE_SUFFIXES:
        rendering.save_scene(FakePlotter(), path, "caption")
    else:
        rendering.save_figure(Figure((3, 3)), path)


@pytest.mark.skipif(sys.platform == "win32", reason="no limits on a file's size")
@pytest.mark.parametrize("suffix", PICTURES)
def test_pictures_are_whole_or_absent(tmp_path, suffix):
    import resource

    path = tmp_path / f"picture{suffix}"
    save_picture(path)
    whole = path.read_bytes()
    limits = resource.getrlimit(resource.RLIMIT_FSIZE)
    for limit in (1, len(whole) // 2, len(whole) - 500):  # a .pdf knows the time
        resource.setrlimit(resource.RLIMIT_FSIZE, (limit, limits[1]))
        try:
            with pytest.raises(files.WriteError, match=re.escape(f"{path} cannot be written: File too large")):
                save_picture(path)
        finally:
            resource.setrlimit(resource.RLIMIT_FSIZE, limits)
        assert path.read_bytes() == whole
        assert list(tmp_path.iterdir()) == [path]


@pytest.mark.parametrize(("command", "suffix", "options"), OUTPUTS)
def test_a_signal_while_writing_leaves_the_old_file(call, ball, tmp_path, monkeypatch, command, suffix, options):
    output = tmp_path / f"out{suffix}"
    output.write_text("old")
    monkeypatch.setattr(files, "_BUFFER", 512)
    seen = []

    def ended(self, data):
        seen.append(sorted(path.name for path in tmp_path.glob(".*")))
        if len(seen) == 2:
            raise Ended
        return super(files._Part, self).write(data)

    monkeypatch.setattr(files._Part, "write", ended)
    status, out, _ = call(command, ball, "-o", output, *options)
    assert (status, out) == (130, "")
    assert len(seen[0]) == 1  # there was something to remove
    assert output.read_text() == "old"
    assert set(tmp_path.iterdir()) == {ball, output}


@pytest.mark.filterwarnings("ignore::pytest.PytestUnraisableExceptionWarning")  # of a file that is not closed in time
@pytest.mark.parametrize("work", ["check", "write"])
def test_no_moment_at_which_a_signal_leaves_a_part(tmp_path, work):
    """Raised at each line of files.py in turn, until there is none left to raise it at."""
    path = tmp_path / "out"
    source = files.__file__

    def run_until(line):
        passed = 0

        def trace(frame, event, argument):
            nonlocal passed
            if frame.f_code.co_filename != source:
                return None
            if event == "line":
                passed += 1
                if passed == line:
                    raise Ended
            return trace

        before = sys.gettrace()
        sys.settrace(trace)
        try:
            files.check_output(path, "output") if work == "check" else files.write_bytes(path, b"new")
        finally:
            sys.settrace(before)

    for line in range(1, 1000):
        path.write_bytes(b"old")
        try:
            run_until(line)
        except Ended:
            assert path.read_bytes() in ((b"old", b"new") if work == "write" else (b"old",)), line
            assert list(tmp_path.iterdir()) == [path], line
        else:
            break
    assert 20 < line < 999


@pytest.mark.skipif(files.fcntl is None, reason="Windows has no SIGKILL and no locks of this kind")
def test_the_next_run_removes_what_a_killed_one_left_and_nothing_else(tmp_path, child_environment):
    """The part of a dead process, also if its number is used again, but not of a living one or of another machine."""
    pipes = {"stdin": subprocess.PIPE, "stdout": subprocess.PIPE, "text": True}
    command, output = [sys.executable, "-c", WRITING], tmp_path / "out.npz"
    with (
        subprocess.Popen(command, env=child_environment, cwd=tmp_path, **pipes) as dead,
        subprocess.Popen(command, env=child_environment, cwd=tmp_path, **pipes) as living,
    ):
        for child in (dead, living):
            while child.stdout.readline() not in ("writing\n", ""):
                pass
        (kept,) = tmp_path.glob(f".*.{living.pid}.*")
        (left,) = tmp_path.glob(f".*.{dead.pid}.*")
        assert left.stat().st_size >= 2 << 20
        dead.kill()
        dead.wait()
        left.with_name(left.name.replace(f".{dead.pid}.", f".{os.getpid()}.")).touch()
        elsewhere = left.with_name(left.name.replace(f".{dead.pid}.", f"-elsewhere.{dead.pid}."))
        of_another_file = left.with_name(left.name.replace("out.npz", "out.ply"))
        for other in (elsewhere, of_another_file):
            other.touch()
        files.write_bytes(output, b"third")
        assert set(tmp_path.iterdir()) == {output, kept, elsewhere, of_another_file}
        living.communicate("\n")
        assert living.returncode == 0
    assert output.stat().st_size == 3 << 20
    assert set(tmp_path.iterdir()) == {output, elsewhere, of_another_file}


@pytest.fixture
def uncomputed(monkeypatch):
    """Fails a test that gets as far as reading its mesh."""

    def load(path):
        raise AssertionError(f"{path} was read")

    for module in (bake, export, commands):
        monkeypatch.setattr(module, "load_mesh", load)


@pytest.mark.parametrize("command", ["directions", "bake"])
@pytest.mark.parametrize("alias", ["itself", "another way", "symlink", "link"])
def test_an_input_is_no_output(call, ball, tmp_path, monkeypatch, uncomputed, command, alias):
    (tmp_path / "folder").mkdir()
    output = {
        "itself": ball,
        "another way": tmp_path / "folder" / ".." / "ball.ply",
        "symlink": tmp_path / "folder" / "other.ply",
        "link": tmp_path / "folder" / "other.ply",
    }[alias]
    if alias == "symlink":
        output.symlink_to(ball)
    if alias == "link":
        output.hardlink_to(ball)
    before = ball.read_bytes()
    status, out, err = call(command, ball, "-o", output)
    assert (status, out) == (2, "")
    assert err == f"error: --output: got {str(output)!r}, which is the input {str(ball)!r}, want another file\n"
    assert ball.read_bytes() == before


def test_nor_are_a_light_or_a_mesh_that_is_looked_at(call, ball, tmp_path, uncomputed, can_render, script, capsys):
    light, picture = tmp_path / "light.npy", tmp_path / "picture.png"
    np.save(light, np.ones((2, 4, 3)))
    npz = tmp_path / "light.npz"
    npz.hardlink_to(light)
    options = ["--quantity", "irradiance", "--environment", light]
    status, _, err = call("bake", ball, "-o", npz, *options)
    assert (status, err.partition(", which")[2]) == (2, f" is the input {str(light)!r}, want another file\n")
    picture.hardlink_to(ball)
    status, _, err = call("view", ball, "--screenshot", picture)
    assert (status, err.partition(", which")[2]) == (2, f" is the input {str(ball)!r}, want another file\n")
    with pytest.raises(SystemExit):
        script("occlusion").main(mesh=ball, screenshot=picture)
    assert "which is the input" in capsys.readouterr().err


UNWRITABLE = {  # what is said of each
    "missing": "whose folder does not exist",
    "file": "whose folder does not exist",
    "dangling": "whose folder does not exist",
    "folder": "which is a folder, want a file",
    "pipe": "which is no ordinary file",
    "circle": "which cannot be written: Too many levels of symbolic links",
    "long": "which cannot be written: File name too long",
    "read-only": "which cannot be written: ",
}


def unwritable(tmp_path, kind, name):
    """A path of that name that cannot be written."""
    path = tmp_path / name
    if kind == "folder":
        path.mkdir()
    elif kind == "pipe":
        os.mkfifo(path)
    elif kind == "dangling":
        path.symlink_to(tmp_path / "no" / "file")
    elif kind == "circle":
        path.symlink_to(path)
    elif kind == "file":
        (tmp_path / "file").touch()
    elif kind == "long":
        path = tmp_path / (300 * "o" + name)
    return {"missing": tmp_path / "no" / name, "file": tmp_path / "file" / name, "read-only": Path("/proc") / name}.get(
        kind, path
    )  # /proc is read-only for root, too


@pytest.mark.skipif(not sys.platform.startswith("linux"), reason="/proc, pipes and links")
@pytest.mark.parametrize("kind", UNWRITABLE)
def test_what_cannot_be_written_is_refused_before_anything_is_computed(call, ball, tmp_path, uncomputed, can_render, kind):
    for i, (command, suffix, option) in enumerate(
        [
            *((["directions", ball], suffix, "--output") for suffix in export.SUFFIXES),
            *((["bake", ball], suffix, "--output") for suffix in bake.SUFFIXES),
            *((["view", ball], suffix, "--screenshot") for suffix in rendering.SCENE_SUFFIXES),
            (["bench", "error"], ".json", "--json"),
        ]
    ):
        path = unwritable(tmp_path, kind, f"{i}{suffix}")
        before = set(tmp_path.iterdir())
        status, out, err = call(*command, option, path)
        assert (status, out) == (2, "")
        assert err.startswith(f"error: {option}: got {str(path)!r}, {UNWRITABLE[kind]}"), err
        assert err.count("\n") == 1
        assert set(tmp_path.iterdir()) == before


def test_a_file_that_may_not_be_written_is_left(tmp_path, monkeypatch):
    """Root may write everything, so the system's answer is simulated."""
    path = tmp_path / "out"
    path.write_text("old")
    monkeypatch.setattr(os, "access", lambda asked, mode: (asked, mode) != (path, os.W_OK))
    with pytest.raises(ValueError, match="^output: got .*, which may not be written$"):
        files.check_output(path, "output")


@pytest.mark.skipif(sys.platform != "linux", reason="/proc")
def test_folders_of_pictures(tmp_path):
    files.check_output_folder(tmp_path / "new" / "newer", "--plot")
    assert list(tmp_path.iterdir()) == []
    (tmp_path / "file").touch()
    for folder, said in (
        (tmp_path / "file", "which is a file, want a folder"),
        (tmp_path / "file" / "in", "whose folder does not exist"),
        (Path("/proc/new"), "which cannot be written: "),
    ):
        with pytest.raises(ValueError, match=f"^--plot: got '{folder}', {said}"):
            files.check_output_folder(folder, "--plot")


def test_links_and_permissions_stay(tmp_path):
    target, link = tmp_path / "target", tmp_path / "link"
    target.write_text("old")
    target.chmod(0o640)
    link.symlink_to(target)
    files.write_bytes(link, b"new")
    assert link.is_symlink()
    assert target.read_text() == "new"
    assert target.stat().st_mode & 0o777 == 0o640
    umask = os.umask(0o027)
    try:
        files.write_bytes(tmp_path / "fresh", b"")
    finally:
        os.umask(umask)
    assert (tmp_path / "fresh").stat().st_mode & 0o777 == 0o640
    long = tmp_path / ("ö" * 100 + ".npz")
    files.write_bytes(long, b"long")
    assert long.read_bytes() == b"long"


def test_two_threads_write_one_file(tmp_path):
    """One of the two stays, complete."""
    path, contents = tmp_path / "out", [bytes([i]) * 100_000 for i in range(8)]
    with ThreadPoolExecutor(8) as pool:
        list(pool.map(lambda content: files.write_bytes(path, content), contents))
    assert path.read_bytes() in contents
    assert list(tmp_path.iterdir()) == [path]


def test_a_part_that_is_taken_for_an_orphan_is_made_again(tmp_path, monkeypatch):
    """Another run removes it before it is locked."""
    lock, taken = files._lock, []

    def late(raw):
        if not taken:
            taken.append(Path(raw.name))
            taken[0].unlink()
        lock(raw)

    monkeypatch.setattr(files, "_lock", late)
    files.write_bytes(tmp_path / "out", b"new")
    assert len(taken) == 1
    assert (tmp_path / "out").read_bytes() == b"new"


def test_an_error_of_the_work_stays_what_it_is(tmp_path):
    """Only errors of the output's own file are reported as errors of the output."""
    with pytest.raises(FileNotFoundError, match="elsewhere"), files.complete_or_absent(tmp_path / "out"):
        (tmp_path / "elsewhere").read_bytes()
    with (
        pytest.raises(files.WriteError, match="out cannot be written: Is a directory"),
        files.complete_or_absent(tmp_path / "out"),
    ):
        (tmp_path / "out").mkdir()
    assert list(tmp_path.glob(".*")) == []
