"""An output file is whole, or the old one stays: on a full disk, and when a signal comes."""

import json
import re
import subprocess
import sys
from io import BufferedWriter, StringIO

import pytest
import trimesh

from warpsample.host import files
from warpsample.output import bake, export
from warpsample.plotting import rendering

OUTPUTS = [
    *(("directions", suffix, ["--samples", 8, "--points", 500]) for suffix in export.SUFFIXES),
    *(("bake", suffix, ["--samples", 32]) for suffix in bake.SUFFIXES),
    *(("bake", suffix, ["--samples", 32, "--at", "faces"]) for suffix in (".ply", ".glb", ".vtp")),
    ("bake", ".vtp", ["--samples", 32, "--points", 100]),
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


class Ended(KeyboardInterrupt):
    """What a signal raises at the command line."""


@pytest.fixture
def ball(tmp_path):
    path = tmp_path / "ball.ply"
    trimesh.creation.icosphere(2).export(path)
    return path


@pytest.mark.slow
def test_a_full_disk_leaves_the_old_file(ball, tmp_path, child_environment):
    """It runs in a child process, since VTK once ended in a segmentation fault there."""
    command = [sys.executable, "-c", LIMITED, json.dumps(OUTPUTS)]
    done = subprocess.run(command, env=child_environment, cwd=tmp_path, capture_output=True, text=True, check=False)
    assert (done.returncode, done.stdout.splitlines()[-1:]) == (0, ["held"]), done.stderr


class FakePlotter:
    """A plotter whose picture and page have 5,000 bytes."""

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
    seen = []

    class Ending(BufferedWriter):
        """A writer with a buffer so small that bytes reach the file at once."""

        def __init__(self, raw, _):
            super().__init__(raw, 512)

        def write(self, data):
            seen.append(sorted(path.name for path in tmp_path.glob(".*")))
            if len(seen) == 2:
                raise Ended
            return super().write(data)

    monkeypatch.setattr(files, "BufferedWriter", Ending)
    status, out, _ = call(command, ball, "-o", output, *options)
    assert (status, out) == (130, "")
    assert len(seen[0]) == 1  # there was something to remove
    assert output.read_text() == "old"
    assert set(tmp_path.iterdir()) == {ball, output}


def test_a_mesh_that_changes_while_its_rays_are_cast_ends_no_bake(call, tmp_path, monkeypatch):
    """The file was opened again after the output was written, and the command ended with 2."""
    path, output = tmp_path / "in.glb", tmp_path / "out.npz"
    path.write_bytes(trimesh.creation.box().export(file_type="glb"))
    cast = bake.bake

    def empty_the_file_after(*arguments):
        report = cast(*arguments)
        path.write_bytes(b"")
        return report

    monkeypatch.setattr(bake, "bake", empty_the_file_after)
    status, _, err = call("bake", path, "-o", output, "--samples", 16)
    assert (status, err, output.is_file()) == (0, "", True)
