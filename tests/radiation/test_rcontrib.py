"""Sky matrices against Radiance's `rcontrib`, patch by patch, within what both may err."""

import os
import subprocess
from pathlib import Path

import numpy as np
import pytest

import warpsample as ws
from warpsample.bench import scenes

SKY = "void glow sky 0 0 4 1 1 1 0\nsky source dome 0 0 4 0 0 1 180\n"
RUNS, RAYS = 6, 10_000


def polygons(mesh):
    """The mesh in black plastic; by obj2mesh it would be moved."""
    lines = ["void plastic black 0 0 5 0 0 0 0 0"]
    for i, corners in enumerate(mesh.vertices[mesh.faces]):
        lines.append(f"black polygon f{i} 0 0 9 " + " ".join(f"{x:.9g}" for x in corners.ravel()))
    return "\n".join(lines) + "\n"


def rcontrib(folder, mesh, points, multiple):
    """(RUNS, P, K) float64: one process each, since several repeat their random numbers."""
    pyradiance = pytest.importorskip("pyradiance")
    home = Path(pyradiance.__file__).parent
    environment = {**os.environ, "RAYPATH": str(home / "lib")}
    (folder / "scene.rad").write_text(polygons(mesh) + SKY)
    octree = subprocess.run([home / "bin" / "oconv", folder / "scene.rad"], capture_output=True, check=True, env=environment)
    (folder / "scene.oct").write_bytes(octree.stdout)
    sensors = np.hstack([points.position, points.normal]).astype(np.float64)
    options = f"-h -V+ -I+ -ab 1 -ad {RAYS} -lw 1e-8 -n 1 -fdf -e MF:{multiple} -f reinhart.cal -b rbin -bn Nrbins -m sky"
    command = [home / "bin" / "rcontrib", *options.split(), folder / "scene.oct"]
    repeated = np.tile(sensors, (RUNS, 1))
    done = subprocess.run(command, input=repeated.tobytes(), capture_output=True, check=True, env=environment)
    colours = np.frombuffer(done.stdout, np.float32).reshape(RUNS, len(sensors), -1, 3)
    return colours[:, :, 1:, 1].astype(np.float64) / np.pi  # the ground comes first


@pytest.mark.parametrize(
    ("scene", "patches", "multiple"),
    [
        pytest.param("city", "tregenza", 1, marks=pytest.mark.thorough),
        pytest.param("city", "reinhart2", 2, marks=pytest.mark.slow),
        pytest.param("bunny", "tregenza", 1, marks=pytest.mark.thorough),
    ],
)
def test_rcontrib_agrees_patch_by_patch(scene, patches, multiple, tmp_path):
    mesh = scenes.city(6) if scene == "city" else scenes.bunny(0)
    size = np.ptp(mesh.vertices, axis=0).max()
    mesh = ws.Mesh(100.0 / size * mesh.vertices, mesh.faces)  # sensors are lifted by 1e-4
    points = ws.sample_surface(mesh, 24, seed=5)
    runs = rcontrib(tmp_path, mesh, points, multiple)
    found = ws.sky_matrix(mesh, points, 16384, patches=patches)
    bars = np.var(runs, axis=0, ddof=1) / RUNS + np.square(found.standard_error.astype(np.float64))
    error = found.value - runs.mean(axis=0)
    known = bars > 0.0
    # Few runs tell a bar badly, so all patches are judged by those of their size.
    assert np.mean(error[known] ** 2) <= 1.3 * bars[known].mean()
    # Its rays are others in each second. That none of 60,000 meets a share v has the probability exp(-60,000 v): from this v
    # on it is below 1e-7 for all patches and points together.
    assert np.abs(error[~known]).max(initial=0.0) <= np.log(error.size * 1e7) / (RUNS * RAYS)
    # Six runs may agree at a patch by chance, and then give too small a bar. The variance of a binomial distribution is an
    # upper bound of that of stratified rays.
    binomial = runs.mean(axis=0) / (RUNS * RAYS) + np.square(found.standard_error.astype(np.float64))
    level = np.sqrt(np.maximum(binomial, bars[known].mean()))
    assert np.abs(error / level).max() <= 7.0
    for wrong in (found.value * np.pi, found.value / np.pi, np.roll(found.value, 1, axis=1)):
        assert np.mean((wrong - runs.mean(axis=0))[known] ** 2) > 20.0 * bars[known].mean()
