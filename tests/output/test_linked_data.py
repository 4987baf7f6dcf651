"""A file and its data beside it: one whole pair at every moment, and no file of another owner is replaced."""

import json
import os
import signal
import sys
from concurrent.futures import ThreadPoolExecutor
from contextlib import suppress
from functools import partial
from pathlib import Path

import pytest

from warpsample.host import files
from warpsample.output import linked_data


def names(path):
    """The files that a file names; none for a file that cannot be read."""
    try:
        return [path.parent / json.loads(path.read_text())["data"]]
    except (OSError, TypeError, ValueError):  # the data are no such file
        return []


def write(path, content, inputs=()):
    """A pair of `content`: the data hold it, and the file that names them too, so that a mixed pair shows."""
    return linked_data.write_with_data(
        path,
        ".bin",
        write_data=lambda stream: stream.write(content.encode()),
        text_naming=lambda name: json.dumps({"data": name, "for": content}).encode(),
        named_by=names,
        inputs=inputs,
    )


def read(path):
    """The content of a pair; an assertion fails for a mixed one."""
    (data,) = names(path)
    content = data.read_text()
    assert json.loads(path.read_text())["for"] == content
    return content


def listed(folder):
    return sorted(path.name for path in folder.iterdir())


def test_the_names_stay_the_same(tmp_path):
    path = tmp_path / "out.gltf"
    for content in ("one", "two", "three"):
        assert write(path, content) == tmp_path / "out.bin"
        assert (read(path), listed(tmp_path)) == (content, ["out.bin", "out.gltf"])


@pytest.mark.parametrize("old", [None, "{", '{"data": "other.bin"}', '{"data": "sub/../out.bin"}'])
def test_data_that_the_old_file_does_not_name_stay(tmp_path, old):
    """The second run keeps the name that the first one chose."""
    path, others = tmp_path / "out.gltf", tmp_path / "out.bin"
    (tmp_path / "sub").mkdir()
    others.write_text("of another scene")
    if old is not None:
        path.write_text(old)
    for content in ("one", "two"):
        assert write(path, content) == tmp_path / "out-1.bin"
        assert (read(path), others.read_text()) == (content, "of another scene")
    assert listed(tmp_path) == ["out-1.bin", "out.bin", "out.gltf", "sub"]


def test_an_input_stays_even_if_the_old_file_names_it(tmp_path):
    path = tmp_path / "out.gltf"
    read_too = write(path, "one")
    assert write(path, "two", inputs=[read_too]) == tmp_path / "out-1.bin"
    assert (read(path), read_too.read_text()) == ("two", "one")


@pytest.mark.parametrize("name", ["copy.GLTF", "copy.glb"])
def test_data_that_another_file_names_stay(tmp_path, name):
    """A copy of the first file names the same data; a link to the first file is the first file."""
    path, copy = tmp_path / "out.gltf", tmp_path / name
    shared = write(path, "one")
    copy.write_bytes(path.read_bytes())
    for content in ("two", "three"):
        assert write(path, content) == tmp_path / "out-1.bin"
        assert (read(path), read(copy), shared.read_text()) == (content, "one", "one")
    copy.unlink()
    if sys.platform != "win32":
        copy.symlink_to(path.name)
    assert write(path, "four") == tmp_path / "out-1.bin"


@pytest.mark.skipif(sys.platform == "win32", reason="links need rights there")
def test_links_and_folders_are_names_that_are_taken(tmp_path):
    (tmp_path / "out.bin").symlink_to("nothing")
    (tmp_path / "out-1.bin").mkdir()
    assert write(tmp_path / "out.gltf", "one").name == "out-2.bin"
    assert not (tmp_path / "nothing").exists()


@pytest.mark.skipif(sys.platform == "win32", reason="links need rights there")
def test_what_a_link_leads_to_stays(tmp_path):
    """Data that are a link, or have a second name: the name is replaced, not the file."""
    path, data, shared = tmp_path / "out.gltf", tmp_path / "out.bin", tmp_path / "shared"
    for link in (data.symlink_to, data.hardlink_to):
        shared.write_text("one")
        data.unlink(missing_ok=True)
        link(shared)
        path.write_text('{"data": "out.bin"}')
        assert write(path, "two") == data
        assert (read(path), shared.read_text()) == ("two", "one")
        assert not data.is_symlink()


@pytest.mark.skipif(sys.platform == "win32", reason="links need rights there")
def test_the_data_of_a_link_are_beside_its_target(tmp_path):
    """The file that the link leads to names its data relative to its own folder."""
    path, link = tmp_path / "sub/out.gltf", tmp_path / "latest.gltf"
    path.parent.mkdir()
    data = write(path, "one")
    link.symlink_to(path)
    assert write(link, "two") == data
    assert (read(path), link.is_symlink(), listed(tmp_path)) == ("two", True, ["latest.gltf", "sub"])
    assert listed(path.parent) == ["out.bin", "out.gltf"]


def test_a_file_system_without_hard_links(tmp_path, monkeypatch):
    """The data alternate between two names."""

    def refused(*_):
        raise PermissionError(1, "Operation not permitted")

    monkeypatch.setattr(os, "link", refused)
    path = tmp_path / "out.gltf"
    for content, name in (("one", "out.bin"), ("two", "out-1.bin"), ("three", "out.bin")):
        assert write(path, content) == tmp_path / name
        assert (read(path), listed(tmp_path)) == (content, [name, "out.gltf"])


@pytest.mark.skipif(sys.platform == "win32", reason="no permissions of that kind")
def test_permissions_stay(tmp_path):
    path = tmp_path / "out.gltf"
    write(path, "one").chmod(0o640)
    assert write(path, "two").stat().st_mode & 0o777 == 0o640


def failing_after(count, monkeypatch, error):
    """Lets so many steps on the disk pass; all others raise an error, those that tidy up too, as in a killed process."""
    left = [count]

    def of(step):
        def run(*arguments, **named):
            left[0] -= 1
            if left[0] < 0:
                raise error()
            return step(*arguments, **named)

        return run

    for owner, name in ((Path, "replace"), (Path, "unlink"), (Path, "chmod"), (Path, "open"), (os, "link"), (os, "fsync")):
        monkeypatch.setattr(owner, name, of(getattr(owner, name)))
    return left


@pytest.mark.filterwarnings("ignore::pytest.PytestUnraisableExceptionWarning")  # of a file that is not closed in time
@pytest.mark.parametrize(
    "error", [partial(OSError, 28, "No space left on device"), KeyboardInterrupt], ids=["disk", "killed"]
)
def test_a_pair_is_whole_at_every_step(tmp_path, monkeypatch, error):
    path = tmp_path / "out.gltf"
    for count in range(100):
        for left_behind in tmp_path.iterdir():
            left_behind.unlink()
        write(path, "old")
        with monkeypatch.context() as patch:
            left = failing_after(count, patch, error)
            with suppress(files.WriteError, KeyboardInterrupt):
                write(path, "new")
        assert read(path) in ("old", "new"), count
        if left[0] >= 0:
            break
    assert 8 < count < 99


@pytest.mark.filterwarnings("ignore::pytest.PytestUnraisableExceptionWarning")  # of a file that is not closed in time
def test_an_interrupt_leaves_one_pair_and_nothing_else(tmp_path, monkeypatch):
    monkeypatch.setattr(os, "fsync", lambda _: None)  # for speed
    path = tmp_path / "out.gltf"
    for line in range(1, 1000, 2):  # every other line, for speed
        write(path, "old")
        left = line

        def trace(frame, event, _):
            nonlocal left
            if frame.f_code.co_filename not in (linked_data.__file__, files.__file__):
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
            write(path, "new")
        except KeyboardInterrupt:
            pass
        finally:
            sys.settrace(before)
        assert (read(path) in ("old", "new"), listed(tmp_path)) == (True, ["out.bin", "out.gltf"]), line
        if left > 0:
            break
    assert 50 < line < 990


def test_many_runs_at_the_same_time(tmp_path):
    """Eight threads write one path, and eight others paths that want the same name of data."""
    path = tmp_path / "out.gltf"
    upper = [tmp_path / f"out.{number}" for number in range(8)]
    with ThreadPoolExecutor(16) as pool:
        done = [pool.submit(write, path, str(number)) for number in range(8) for _ in range(3)]
        done += [pool.submit(write, other, other.name) for other in upper]
        assert all(one.result() for one in done)
    assert read(path) in map(str, range(8))
    assert [read(other) for other in upper] == [other.name for other in upper]
    assert len(listed(tmp_path)) == 18
