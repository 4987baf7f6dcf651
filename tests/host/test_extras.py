"""What comes by extras: a call that misses it names the line of pip, and all else works without."""

import json
import re
import signal
import subprocess
import sys
import time

import psutil
import pytest

from warpsample.host.extras import EXTRAS, missing, run_program

CALLS = {
    "mesh.to_polydata()": "viz",
    "ws.load_mesh(bunny)": "viz",
    "rendering.check_rendering()": "viz",
    "pictures.check_matplotlib('--plot')": "viz",
    "ws.irradiation(mesh, points, 'athens')": "radiation",
    "perez._pyradiance()": "radiation",
    "ws.rasters.surface('dsm.tif')": "city",
    "bake._bake_raster(BakeRun.of(Path('a.tif'), Path('b.tif'), 'sky', {}))": "city",
    "bake._bake_raster(BakeRun.of(Path('a.tif'), Path('b.zarr'), 'sky', {}))": "city,cluster",
    "cluster.trace": "cluster",
    "stores.export_command(None, None, None)": "cluster",
    "sky.to_xarray(points)": "cluster",
    "ws.unwrap(mesh, 64)": "texture",
    "texture.check_library('.png')": "texture",
    "texture.check_library('.exr')": "texture",
    "closed_meshes()": "test",
}
SCRIPT = """
import json, sys
from pathlib import Path
for name in {hidden}:
    sys.modules[name] = None
import warp as wp
import warpsample as ws
from warpsample import cluster
from warpsample.bench.reporting import pictures
from warpsample.cli import bake, stores
from warpsample.output.baked import BakeRun
from warpsample.plotting import rendering
from warpsample.proof.rays import closed_meshes
from warpsample.radiation.weather import perez
from warpsample.texture import pictures as texture
bunny = Path(wp.__file__).parent / "examples/assets/bunny.usd"
mesh = ws.load_mesh("courtyard")
points = ws.sample_surface(mesh, 50)
sky = ws.sky_view_factor(mesh, points, 16)
found = {{"without": [len(ws.to_frame(sky, points)["value"]), ws.sample_directions(points, 4).vectors.shape[0]]}}
for call in {calls}:
    try:
        eval(call)
    except Exception as error:
        found[call] = f"{{type(error).__name__}}: {{error}}"
print("found", json.dumps(found))
"""


@pytest.mark.slow
def test_a_call_that_misses_an_extra_names_it(tmp_path, child_environment):
    hidden = [*(module for modules in EXTRAS.values() for module in modules), "pandas"]
    script = tmp_path / "script.py"
    script.write_text(SCRIPT.format(hidden=hidden, calls=list(CALLS)))
    done = subprocess.run([sys.executable, script], env=child_environment, capture_output=True, text=True, check=True)
    found = json.loads(done.stdout.partition("found ")[2])
    assert found.pop("without") == [50, 50]
    lines = {
        call: re.search(r"^ModuleNotFoundError: .* needs? .*: pip install '(.*)'$", said) for call, said in found.items()
    }
    assert {call: line and line[1] for call, line in lines.items()} == {call: f".[{extra}]" for call, extra in CALLS.items()}


def test_each_module_is_of_an_extra_that_there_is(repository):
    text = (repository / "pyproject.toml").read_text()
    extras = dict(re.findall(r"^(\w+) = \[(\"\w.*)\]$", text, flags=re.MULTILINE))
    distributions = {"pxr": "usd-core", "trame": "trame-pyvista", "nest_asyncio2": "nest-asyncio2", "PIL": "pillow"}
    distributions |= {"affine": "rasterio"}  # which needs it
    for extra, modules in EXTRAS.items():
        for module in modules:
            assert re.search(rf'"{distributions.get(module, module)}[\[><="]', extras[extra], flags=re.IGNORECASE), module


def test_what_is_of_no_extra_is_named_itself():
    assert str(missing("this needs that", "that.inner")) == "this needs that: pip install that"


def test_no_page_or_message_installs_the_package_from_an_index(repository):
    suffixes = {".py", ".md", ".ipynb", ".html", ".toml", ".yml"}
    folders = ("warpsample", "viz", "tests", ".github")
    files = [*repository.glob("*.*"), *(path for name in folders for path in (repository / name).rglob("*.*"))]
    by_name = re.compile(r"pip install [^`\n]*?(?<![\w/.:-])[\"']?warpsample\b(?![/.])")
    named = [path for path in files if path.suffix in suffixes and by_name.search(path.read_text(errors="replace"))]
    assert named == []


RUN = """
from warpsample.host.extras import run_program

run_program("import os, sys, time; print(os.getpid(), file=open({path!r}, 'w'), flush=True); time.sleep(600)")
"""


@pytest.mark.skipif(sys.platform != "linux", reason="only Linux tells a process that its parent has ended")
@pytest.mark.parametrize("sent", [signal.SIGTERM, signal.SIGKILL])
def test_a_program_ends_with_its_parent(tmp_path, sent):
    """xatlas went on for up to a minute after the parent was killed."""
    path = tmp_path / "child"
    parent = subprocess.Popen([sys.executable, "-c", RUN.format(path=str(path))])
    assert wait_for(lambda: path.exists() and path.read_text().endswith("\n"))
    child = psutil.Process(int(path.read_text()))
    parent.send_signal(sent)
    parent.wait()
    assert wait_for(lambda: not child.is_running() or child.status() == psutil.STATUS_ZOMBIE)


def test_a_program_takes_no_modules_from_the_working_folder(tmp_path, monkeypatch):
    """A file struct.py beside the meshes was run, and new coordinates were refused."""
    for name in ("struct", "types", "ctypes", "_ctypes", "json", "numpy"):
        (tmp_path / f"{name}.py").write_text("raise SystemExit(7)")
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(sys, "path", [tmp_path, *(each for each in sys.path if each not in ("", "."))])  # no text
    assert run_program("import struct, types, ctypes, json, numpy; print(1)") == (0, b"1\n")


def wait_for(is_done, seconds=60):
    """Return whether a condition holds before the time is over."""
    end = time.monotonic() + seconds
    while not is_done() and time.monotonic() < end:
        time.sleep(0.05)
    return is_done()
