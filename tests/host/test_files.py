"""A file is whole or not there, whatever ends its writing; links and permissions stay, and nothing is left beside it."""

import os
import signal
import subprocess
import sys
import zipfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import numpy as np
import pytest

from warpsample.host import files

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
    """What a signal raises at the command line."""


@pytest.mark.filterwarnings("ignore::pytest.PytestUnraisableExceptionWarning")  # of a file that is not closed in time
@pytest.mark.parametrize("work", ["check", "write"])
def test_no_moment_at_which_a_signal_leaves_a_part(tmp_path, work):
    """It is raised at each line of files.py in turn, until no line is left."""
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


def write_arrays(path):
    with files.complete_or_absent(path) as stream:
        files.write_arrays(stream, {"one": np.arange(3), "two": np.arange(3)})


WORKS = {
    "check": lambda path: files.check_output(path, "output", path.with_name("input")),
    "write": lambda path: files.write_bytes(path, b"new"),
    "arrays": write_arrays,
}


def interrupted_at(line, work, path):
    """Sends a signal at that line of files.py and zipfile; what the work raises, and whether there were as many lines."""
    left, came = line, None

    def trace(frame, event, _argument):
        nonlocal left
        if frame.f_code.co_filename not in (files.__file__, zipfile.__file__):
            return None
        if event == "line":
            left -= 1
            if not left:
                sys.settrace(None)
                signal.raise_signal(signal.SIGINT)
        return trace

    before = sys.gettrace()
    sys.settrace(trace)
    try:
        work(path)
    except BaseException as error:
        came = repr(error)
    finally:
        sys.settrace(before)
    return came, left <= 0


@pytest.mark.filterwarnings("ignore::pytest.PytestUnraisableExceptionWarning")  # of a file that is not closed in time
@pytest.mark.parametrize("work", WORKS)
def test_an_interrupt_is_no_error_of_the_file(tmp_path, work):
    """It comes out as it is, wherever it comes, and nothing is left."""
    path, line, reached = tmp_path / "out", 0, True

    def late(*_):
        raise KeyboardInterrupt("mine")

    before = signal.signal(signal.SIGINT, late)
    try:
        while reached:
            line += 1
            path.write_bytes(b"old")
            came, reached = interrupted_at(line, WORKS[work], path)
            assert came == (repr(KeyboardInterrupt("mine")) if reached else None), line
            assert list(tmp_path.iterdir()) == [path], line
    finally:
        signal.signal(signal.SIGINT, before)
    assert line > 40


@pytest.mark.skipif(files.fcntl is None, reason="Windows has no SIGKILL and no locks of this kind")
def test_the_next_run_removes_what_a_killed_one_left_and_nothing_else(tmp_path, child_environment):
    """Parts of dead processes go, also if their number is another's now; those of living ones and other machines stay."""
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


def test_a_file_that_may_not_be_written_is_left(tmp_path, monkeypatch):
    """Root may write everything, so the answer of the system is replaced."""
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


@pytest.mark.skipif(files.fcntl is None, reason="Windows has no locks of this kind")
def test_a_part_that_is_taken_for_an_orphan_is_made_again(tmp_path, monkeypatch):
    """Another run removes it before it is locked."""
    taken = []

    def late(file, operation):
        if not taken:
            taken.append(Path(file.name))
            taken[0].unlink()

    monkeypatch.setattr(files.fcntl, "flock", late)
    files.write_bytes(tmp_path / "out", b"new")
    assert len(taken) == 1
    assert (tmp_path / "out").read_bytes() == b"new"


def test_what_a_user_calls_a_part_is_none(tmp_path):
    prefix = files._prefix(tmp_path / "out")
    own, orphan = tmp_path / f"{prefix}notes.part", tmp_path / f"{prefix}4194304.0123abcd.part"
    for file in (own, orphan):
        file.write_text("mine")
    files.write_bytes(tmp_path / "out", b"new")
    assert sorted(tmp_path.iterdir()) == sorted([own, tmp_path / "out"])


def test_an_error_of_the_work_stays_what_it_is(tmp_path):
    """Only errors of the output's own file are about the output."""
    with pytest.raises(FileNotFoundError, match="elsewhere"), files.complete_or_absent(tmp_path / "out"):
        (tmp_path / "elsewhere").read_bytes()
    with (
        pytest.raises(files.WriteError, match="out cannot be written: Is a directory"),
        files.complete_or_absent(tmp_path / "out"),
    ):
        (tmp_path / "out").mkdir()
    assert list(tmp_path.glob(".*")) == []
