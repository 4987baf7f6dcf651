"""A new quantity is one record: `bake` of all sources, stores, Dask and the accessor offer it without more code."""

import shutil
import subprocess
import sys

import city_files
import numpy as np
import pytest
import raster_cases
import trimesh

pytestmark = pytest.mark.slow  # a process of its own, with a copy of the package

RECORD = '''"""Record of openness, a test of new quantities."""

from warpsample.estimate.quantities.record import Quantity
from warpsample.estimate.result import Share
from warpsample.estimate.visibility import ambient_occlusion


def openness(mesh, points, count=64, *, seed=0, first_point=0, workers=None):
    """Compute ambient occlusion under another name."""
    return ambient_occlusion(mesh, points, count, seed=seed, first_point=first_point, workers=workers)


RECORD = Quantity(
    name="openness",
    call=openness,
    title="openness",
    value="the open share",
    result=Share,
    on_rasters={"horizontal": "open share above {normal}"},
)
'''
SCRIPT = """
import numpy as np
import warpsample as ws
from warpsample import cluster

mesh = ws.load_mesh("in.ply")
right = ws.ambient_occlusion(mesh, ws.vertex_points(mesh), 64).value
lazy = cluster.openness(mesh, ws.vertex_points(mesh), 64).value.compute()
shown = mesh.to_polydata().warpsample.openness(64).point_data["openness"]
assert np.array_equal(lazy, right) and np.array_equal(shown, right)
"""
CALLS = [
    "in.ply out.vtp", "in.ply out.csv --at faces", "in.ply out.zarr", "in.city.json out.city.json",
    "in.city.json out.csv", "in.tif out.tif --tile 8", "in.tif raster.zarr", "in.obj out.npz --texture 64 --uv new",
]  # fmt: skip


@pytest.mark.thorough
def test_a_record_is_all_that_commands_stores_and_the_accessor_need(tmp_path, repository, child_environment):
    for library in ("dask", "zarr", "rioxarray", "pyvista", "xatlas"):
        pytest.importorskip(library)
    shutil.copytree(repository / "warpsample", tmp_path / "warpsample", ignore=shutil.ignore_patterns("__pycache__"))
    (tmp_path / "warpsample" / "estimate" / "quantities" / "openness.py").write_text(RECORD)
    public = tmp_path / "warpsample" / "__init__.py"
    public.write_text(public.read_text() + "\nfrom warpsample.estimate.quantities.openness import openness\n")
    box = trimesh.creation.box((2.0, 2.0, 2.0))
    box.export(tmp_path / "in.ply")
    box.export(tmp_path / "in.obj")
    city_files.written(tmp_path / "in.city.json", city_files.house())
    raster_cases.write_tif(tmp_path / "in.tif", np.zeros((12, 12), np.float32))
    environment = {**child_environment, "PYTHONPATH": str(tmp_path)}
    for line in CALLS:
        source, output, *more = line.split()
        command = [sys.executable, "-m", "warpsample", "bake", source, "-o", output, "--quantity", "openness", *more]
        done = subprocess.run(command, check=False, env=environment, cwd=tmp_path, capture_output=True, text=True)
        assert (done.returncode, done.stdout.startswith(f"{output}: openness")) == (0, True), done.stderr
    subprocess.run([sys.executable, "-c", SCRIPT], check=True, env=environment, cwd=tmp_path)
