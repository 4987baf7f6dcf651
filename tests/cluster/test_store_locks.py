"""Locks of stores: one writer at a time, what killed writers leave, and files of others at the same names."""

import os
import subprocess
import sys
from functools import partial
from importlib import import_module

import pytest

pytest.importorskip("dask")
pytest.importorskip("zarr")

from store_cases import assert_whole, bake

# seconds each, and kernels to compile; .ci/run runs them too
pytestmark = [pytest.mark.slow, pytest.mark.usefixtures("in_this_thread")]

lock = import_module("warpsample.cluster.lock")


HOLD = """
import sys
from pathlib import Path
from warpsample.cluster.lock import locked
with locked(Path(sys.argv[1])):
    print("held", flush=True)
    sys.stdin.read()
"""


def test_a_second_writer_is_refused_until_the_first_is_gone(path, mesh, right, child_environment):
    pipes = {"stdin": subprocess.PIPE, "stdout": subprocess.PIPE, "text": True}
    first = subprocess.Popen([sys.executable, "-c", HOLD, path], env=child_environment, **pipes)
    assert first.stdout.readline() == "held\n"
    with pytest.raises(OSError, match="out.zarr cannot be written: another process is writing it$"):
        bake(path, mesh)
    assert not path.exists()
    first.kill()
    first.communicate()
    assert [file.name for file in path.parent.iterdir()] == [".out.zarr.lock"]
    bake(path, mesh)
    assert_whole(path, right)


def test_what_killed_writers_left_goes(path, mesh, right):
    bake(path, mesh)
    assert_whole(path, right)
    for folder in ("writing-" + "0123abcd" * 4, "ended-" + "0123abcd" * 4):
        (path / ".run" / folder).mkdir()
        (path / ".run" / folder / "half").write_bytes(b"half")
    bake(path, mesh, resume=True)
    assert list((path / ".run").glob("*-*")) == []


def test_a_store_by_another_name_has_the_same_lock(path, mesh, right, tmp_path):
    (tmp_path / "link.zarr").symlink_to(path)
    bake(tmp_path / "link.zarr", mesh)  # where there is nothing yet
    (tmp_path / "link.zarr").unlink()
    assert_whole(path, right)
    (tmp_path / "link.zarr").symlink_to(path)
    with lock.locked(path), pytest.raises(OSError, match=r"out.zarr cannot be written: another process is writing it$"):
        bake(tmp_path / "link.zarr", mesh, resume=True)


@pytest.mark.parametrize("kind", ["pipe", "folder", "link"])
def test_a_lock_that_is_no_ordinary_file_is_refused_at_once(kind, path, mesh, tmp_path):
    """A pipe would wait for who reads it, deaf to every signal; a link's target is somebody's."""
    file = tmp_path / lock.lock_name(path)
    {"pipe": os.mkfifo, "folder": os.mkdir, "link": partial(os.symlink, "thesis.txt")}[kind](file)
    with pytest.raises(OSError, match=r"out.zarr cannot be written: its lock file \.out\.zarr\.lock cannot be opened: "):
        bake(path, mesh)
    assert list(tmp_path.iterdir()) == [file]


def test_what_a_user_has_at_hidden_names_stays(path, tmp_path, mesh):
    own = tmp_path / f".{path.name}.part" / "thesis.txt"
    own.parent.mkdir()
    lock = tmp_path / f".{path.name}.lock"
    for file in (own, lock):
        file.write_text("thesis")
    bake(path, mesh)
    assert sorted(file.name for file in tmp_path.iterdir()) == [lock.name, own.parent.name, path.name]
    assert [file.read_text() for file in (own, lock)] == ["thesis", "thesis"]
    assert path.stat().st_mode & 0o777 == own.parent.stat().st_mode & 0o777  # of a folder like others
