"""Kernel caches and what befalls them, run as a script by test_kernel_cache.py: what crashes, crashes alone.

Each task begins with an empty folder, that of WARP_CACHE_PATH. Exit status 1 means failure.
"""

import multiprocessing
import os
import resource
import shutil
import sys
import tempfile
import warnings
from functools import partial
from pathlib import Path

import numpy as np
import warp as wp

import warpsample as ws
from warpsample.host import kernel_cache
from warpsample.host.arrays import cpu


@wp.kernel(module="unique", enable_backward=False)
def triple(x: wp.array[wp.int32]):
    x[wp.tid()] *= 3


@wp.kernel(module="unique", enable_backward=False)
def double(x: wp.array[wp.int32]):
    x[wp.tid()] *= 2


@wp.kernel(module="unique", enable_backward=False)
def undefined(x: wp.array[wp.int32]):
    x[wp.tid()] = nowhere  # noqa: F821


def load_anew(kernel=triple):
    """Loads a kernel as a new process does; returns the warnings."""
    kernel.module.unload()
    kernel_cache.load.cache.clear()
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        kernel_cache.load(kernel, "cpu")
    x = wp.array([1, 2, 3], dtype=wp.int32, device="cpu")
    wp.launch(kernel, 3, inputs=[x], device="cpu")
    factor = 3 if kernel is triple else 2
    assert x.numpy().tolist() == [factor, 2 * factor, 3 * factor]
    return [str(warning.message) for warning in caught]


def error_of(call):
    try:
        call()
    except Exception as error:
        return str(error)
    raise AssertionError("no error")


def entry(kernel=triple):
    return Path(wp.config.kernel_cache_dir, kernel.module.get_module_identifier(1))


def built():
    """The module's files, which are others after it was built again."""
    return sorted((path.name, path.stat().st_ino) for path in entry().iterdir())


def cut(share, file):
    file.write_bytes(file.read_bytes()[: int(share * file.stat().st_size)])


def garble(share, file):
    """Changes a share of the file, or at least one byte, in its middle."""
    content = bytearray(file.read_bytes())
    middle = slice(len(content) // 3, len(content) // 3 + max(1, int(share * len(content))))
    content[middle] = bytes(255 - byte for byte in content[middle])
    file.write_bytes(content)


def folder_instead(file):
    file.unlink()
    file.mkdir()


DAMAGES = [partial(garble, 0.0), partial(cut, 0.7), Path.unlink, folder_instead]


def damages():
    """Whatever damages a file of a module, the module is built once more, and one warning says so."""
    cpu()
    assert load_anew() == []
    for suffix in (".o", ".meta", ".o.sha256", ".meta.sha256"):
        for damage in DAMAGES if suffix == ".o" else DAMAGES[1:3]:
            damage(next(entry().glob(f"*{suffix}")))
            said = load_anew()
            by_warp_alone = suffix.endswith(".sha256") and damage is Path.unlink  # as it seems then
            right = [] if by_warp_alone else [f"kernel cache: {entry()} was damaged; it was built anew"]
            assert said == right, (suffix, damage, said)
            assert load_anew() == [], (suffix, damage)
    assert list(entry().parent.iterdir()) == [entry()]


def folders():
    """Something else stands where a module's folder was."""
    cpu()
    load_anew()
    shutil.rmtree(entry())
    entry().write_text("a file")
    assert "was damaged; it was built anew" in load_anew()[0]
    shutil.rmtree(entry())
    entry().symlink_to("nowhere")
    assert "was damaged; it was built anew" in load_anew()[0]
    shutil.rmtree(entry())
    entry().mkdir()
    assert load_anew() == []
    shutil.rmtree(wp.config.kernel_cache_dir)
    assert load_anew() == []
    before = built()
    assert load_anew() == []
    assert built() == before


def unmarked():
    """A module that Warp alone built may be truncated: it is built again, without a warning. Another processor's stays."""
    cpu()
    wp.config.log_level = wp.LOG_WARNING
    triple.module.unload()
    wp.load_module(triple.module, "cpu", block_dim=1)
    for damage in (partial(cut, 0.5), partial(garble, 0.3)):
        damage(next(entry().glob("*.o")))
        for mark in entry().glob("*.sha256"):
            mark.unlink()
        assert load_anew() == []
    here = next(entry().glob("*.o"))
    there = here.with_name("of_another_processor.o")
    for file in (here, here.with_name(here.name + ".sha256")):
        file.rename(file.with_name(file.name.replace(here.name, there.name)))
    assert load_anew() == []
    before = built()
    assert load_anew() == []
    assert built() == before
    assert {path.name for path in entry().glob("*.o")} == {here.name, there.name}


def again():
    """A module that cannot be loaded after it was built is an error that names the folder; a wrong kernel has its own."""
    cpu()
    build = wp._src.build.build_cpu

    def build_damaged(path, *arguments, **options):
        build(path, *arguments, **options)
        cut(0.7, Path(path))

    wp._src.build.build_cpu = build_damaged
    error = error_of(load_anew)
    assert "cannot be loaded although it was just built" in error, error
    assert error.endswith(f"; delete {entry().parent} and try again"), error
    assert "\n" not in error, error
    wp._src.build.build_cpu = build
    assert load_anew() == []
    error = error_of(lambda: kernel_cache.load(undefined, "cpu"))
    assert "nowhere" in error, error
    assert "kernel cache" not in error, error
    assert list(entry().parent.iterdir()) == [entry()]


def unwritable():
    """If the cache cannot be written, its modules are used, and the others are built elsewhere, with one warning."""
    cpu()
    usual = wp.config.kernel_cache_dir
    load_anew()
    blocked = Path(usual, "blocked")
    blocked.write_text("a file")
    wp.config.kernel_cache_dir = str(blocked / "cache")
    (said,) = load_anew()
    assert f"kernel cache: {blocked / 'cache'} is not writable (Not a directory); kernels are built in" in said, said
    assert load_anew(double) == []
    assert wp.config.kernel_cache_dir == str(blocked / "cache")
    assert not [path for path in Path(tempfile.gettempdir()).iterdir() if path.name[:7] != "wp_pch_"]
    wp.config.kernel_cache_dir = usual
    limit = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (50_000, limit[1]))  # as on a full disk
    assert load_anew() == []
    error = error_of(lambda: load_anew(double))
    assert f"written in {usual} (File too large), nor in a temporary folder (File too large); " in error, error
    resource.setrlimit(resource.RLIMIT_FSIZE, limit)
    assert load_anew(double) == []


def homeless():
    """Some variables of the environment are missing, and another names a folder that cannot be made."""
    for name in sys.argv[2:]:
        os.environ.pop(name, None)
    cpu()
    assert Path(wp.config.kernel_cache_dir).parent.parent == Path(tempfile.gettempdir())


def use():
    """Makes a call of each kind that loads a kernel, and of those that load none."""
    mesh = ws.Mesh(np.eye(3), [[0, 1, 2]])
    points = ws.sample_surface(mesh, 10)
    directions = ws.sample_directions(points, 4, pdf=True)
    ws.CosineHemisphere().pdf(directions.vectors)
    ws.trace(mesh, points, directions.vectors)
    ws.trace(mesh, points, directions.vectors, tracer="warp")
    ws.ambient_occlusion(mesh, points, 64)


def respectful():
    """The user's own log level stays and is heard, and so are the user's own kernels."""
    level = wp.config.log_level = int(sys.argv[2])
    use()
    assert wp.config.log_level == level
    sys.stdout.write("now mine\n")
    wp.load_module(triple.module, "cpu", block_dim=1)


def mend(barrier):
    barrier.wait()
    load_anew(triple)
    load_anew(double)


def together():
    """Processes that find the same damage at the same moment all continue, and leave a complete module."""
    cpu()
    load_anew(triple)
    load_anew(double)
    processes = multiprocessing.get_context("fork")
    for _ in range(2):
        for kernel in (triple, double):
            cut(0.5, next(entry(kernel).glob("*.o")))
        barrier = processes.Barrier(3)
        children = [processes.Process(target=mend, args=(barrier,)) for _ in range(3)]
        for child in children:
            child.start()
        for child in children:
            child.join()
        assert [child.exitcode for child in children] == [0, 0, 0]
        assert set(entry().parent.iterdir()) == {entry(triple), entry(double)}
        assert load_anew(triple) == load_anew(double) == []


if __name__ == "__main__":
    for number, task in enumerate(sys.argv[1].split(",")):
        if number:  # the compiler's start, which takes a second, is for all of them
            shutil.rmtree(wp.config.kernel_cache_dir)
        globals()[task]()
