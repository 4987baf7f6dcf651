"""Starting Warp and its kernel cache: nothing is printed, and damage to the cache does not affect a run."""

import os
import subprocess
import sys
from pathlib import Path

import pytest
import warp as wp
from hangs import HANGS

import warpsample as ws
from warpsample.directions.square import square_blocks
from warpsample.host import kernel_cache
from warpsample.host.kernel_cache import WIDE_VECTORS


@wp.kernel(enable_backward=False)
def triple(x: wp.array[wp.int32]):
    x[wp.tid()] *= 3


@pytest.fixture
def alone(tmp_path, child_environment):
    """Runs a task of caches.py, or another command, with its own cache; returns stdout and stderr."""

    def run(*command, **environment):
        if not command[0].startswith("-"):
            command = (Path(__file__).parents[1] / "support" / "caches.py", *command)
        environment = {**child_environment, "WARP_CACHE_PATH": str(tmp_path / "cache"), **environment}
        command = [sys.executable, *map(str, command)]
        done = subprocess.run(command, env=environment, capture_output=True, text=True, timeout=HANGS, check=False)
        assert done.returncode == 0, (done.stdout, done.stderr)
        return done.stdout, done.stderr

    return run


@pytest.mark.thorough
@pytest.mark.parametrize("tasks", ["damages", "folders,unmarked,again,unwritable,together"])
def test_a_cache_is_mended_or_done_without(tasks, alone, tmp_path):
    (tmp_path / "tmp").mkdir()
    assert alone(tasks, TMPDIR=str(tmp_path / "tmp"))[0] == ""


@pytest.mark.thorough
def test_the_command_line_says_it_in_a_line(alone, cube, tmp_path):
    command = ("-m", "warpsample.cli", "directions", cube, "-o", tmp_path / "d.npz", "--at", "faces")
    first = alone(*command)
    assert first == (f"{tmp_path / 'd.npz'}: 768 directions at 12 points\n", "")
    damaged = min((tmp_path / "cache").rglob("*.o"))
    damaged.write_bytes(damaged.read_bytes()[:1000])
    assert alone(*command) == (first[0], f"warning: kernel cache: {damaged.parent} was damaged; it was built anew\n")


def test_our_kernels_have_the_widest_vectors_and_other_modules_their_own_flags():
    ws.sample_square("sobol", 1, 1)
    wp.launch(triple, 1, inputs=[wp.ones(1, dtype=wp.int32, device="cpu")], device="cpu")
    ours = square_blocks(ws.sequences.get("sobol")).module
    assert ours.options["cpu_compiler_flags"] == f"{wp.config.cpu_compiler_flags} {WIDE_VECTORS}"
    assert WIDE_VECTORS not in wp.config.cpu_compiler_flags
    assert triple.module.options["cpu_compiler_flags"] is None


@pytest.mark.thorough
@pytest.mark.parametrize(("flags", "built"), [("", None), (None, f"-march=native {WIDE_VECTORS}")])
def test_what_the_user_says_of_compiling_holds(flags, built, alone):
    script = f"""import warp as wp
wp.config.cpu_compiler_flags = {flags!r}
import warpsample as ws
from warpsample.directions.square import square_blocks
assert ws.sample_square("sobol", 1, 1).shape == (1, 1, 2)
assert square_blocks(ws.sequences.get("sobol")).module.options["cpu_compiler_flags"] == {built!r}
"""
    assert alone("-c", script) == ("", "")


@pytest.mark.parametrize("variable", ["WARP_CACHE_PATH", "HOME"])
def test_a_cache_folder_that_cannot_be_made_is_replaced_by_a_temporary_one(variable, alone, tmp_path, cube):
    (tmp_path / "tmp").mkdir()
    unset = ["XDG_CACHE_HOME", "WARP_CACHE_PATH"][: 2 if variable == "HOME" else 1]
    out, err = alone("homeless", *unset, **{"TMPDIR": str(tmp_path / "tmp"), variable: str(cube / "below")})
    assert out == ""
    assert f"UserWarning: kernel cache: {cube / 'below'}" in err
    assert "is not writable (Not a directory); kernels are built in a temporary folder by each process\n" in err
    assert err.count("Warning") == 1
    assert list((tmp_path / "tmp").iterdir()) == []


@pytest.mark.slow
def test_importing_and_using_the_package_prints_nothing(alone, child_environment):
    assert alone("use", WARP_CACHE_PATH=child_environment.get("WARP_CACHE_PATH", "")) == ("", "")


@pytest.mark.thorough
@pytest.mark.parametrize("level", [wp.LOG_DEBUG, wp.LOG_INFO])
def test_the_users_own_log_level_is_kept(level, alone, child_environment):
    out, _ = alone("respectful", level, WARP_CACHE_PATH=child_environment.get("WARP_CACHE_PATH", ""))
    before, after = out.split("now mine\n")
    assert after.startswith("Module triple")
    assert (before == "") == (level == wp.LOG_INFO)
    assert before == "" or "Warp 1." in before


def test_other_lines_on_stderr_are_shown(capfd, monkeypatch):
    """Lines written while Warp starts are shown, and those after it, also if it fails."""

    def start(init):
        monkeypatch.setattr(wp, "init", init)
        kernel_cache.start.cache.clear()  # as in a process that has not started Warp
        kernel_cache.start()

    def fail():
        os.write(2, b"three\n")
        raise ValueError("no Warp")

    warning = b"Warp CUDA warning: Could not find or load the NVIDIA CUDA driver. And so on.\n"
    start(lambda: os.write(2, b"one\n" + warning + b"two\n"))
    with pytest.raises(ValueError, match="no Warp"):
        start(fail)
    os.write(2, b"four\n")
    assert capfd.readouterr().err == "one\ntwo\nthree\nfour\n"
