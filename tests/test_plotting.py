"""Pictures: the data handed to the plotter, one render that is not blank, and the message where none can be made."""

import importlib.util
import re
import subprocess
import sys

import numpy as np
import pytest

import warpsample as ws
from warpsample import plotting
from warpsample.proof.histogram import cosine_lobe_angles


@pytest.fixture(scope="module")
def viewer(repository):
    specification = importlib.util.spec_from_file_location("direction_clouds", repository / "viz" / "direction_clouds.py")
    module = importlib.util.module_from_spec(specification)
    specification.loader.exec_module(module)
    return module


@pytest.fixture(scope="module")
def can_render():
    try:
        plotting.check_rendering()
    except RuntimeError as error:
        pytest.skip(str(error))


def test_clouds_are_uniform_spheres_resting_on_the_surface(viewer, bunny_path):
    points = ws.sample_surface(ws.load_mesh(bunny_path), 20, seed=1)
    cloud = viewer.cloud_positions(points, ws.sample_directions(points, 4096).vectors, 0.1).reshape(20, 4096, 3)
    centre = points.position + 0.05 * points.normal
    from_centre = (cloud - centre[:, None]) / 0.05
    assert np.abs(np.linalg.norm(from_centre, axis=-1) - 1.0).max() <= 1e-6
    # Uniform on that sphere: mean 0, second moments 1/3; 4096 Owen-scrambled points are within 1/4096.
    assert np.abs(from_centre.mean(axis=1)).max() <= 1e-3
    assert np.abs(np.einsum("psi,psj->pij", from_centre, from_centre) / 4096 - np.eye(3) / 3).max() <= 1e-3


def test_histogram_is_of_the_projected_sphere(viewer, plausible):
    normals = np.random.default_rng(2).normal(size=(50, 3)).astype(np.float32)
    normals /= np.linalg.norm(normals, axis=1, keepdims=True)
    theta = viewer.projected_sphere_angles(normals, 200_000, seed=3)
    assert theta.shape == (200_000,)
    edges, test = cosine_lobe_angles(theta, 90)
    plausible(test.p_value)
    assert test.dof == 89
    assert edges[[0, -1]].tolist() == [0.0, np.pi / 2]
    figure = plotting.lobe_histogram(edges, test, "caption")
    above, below = figure.axes
    assert above.get_title() == f"χ² = {test.chi_square:.1f}, dof = 89, p = {test.p_value:.3f}"
    assert np.allclose(above.patches[0].get_data().values, test.observed / (200_000 * np.diff(edges)))
    assert np.allclose(below.patches[-1].get_data().values, test.residuals)
    assert below.get_xlabel().endswith("caption")


@pytest.mark.parametrize(
    ("points", "count", "shown"), [(10, 64, (10, 64)), (10_000, 1024, (10_000, 100)), (2_000_000, 4, (1_000_000, 1))]
)
def test_budget_bounds_what_is_drawn(points, count, shown):
    assert plotting.budgeted(points, count) == shown


def test_what_the_plotter_is_given(can_render, viewer):
    import pyvista as pv

    plotter = pv.Plotter(off_screen=True)
    clouds = plotting.Clouds(np.random.default_rng(0).normal(size=(50, 3)), np.arange(50.0), "pdf [1/sr]")
    position, normal = np.zeros((2, 3)), np.eye(3)[:2]
    plotting.draw_clouds(plotter, np.eye(3), np.array([[0, 1, 2]]), position, normal, 0.5, clouds)
    drawn = [actor.mapper.dataset for actor in plotter.actors.values() if getattr(actor, "mapper", None) is not None]
    assert 50 in [data.n_points for data in drawn]
    lines = next(data for data in drawn if data.n_lines)
    assert np.allclose(lines.points.reshape(2, 2, 3)[:, 1], 0.5 * normal)
    assert list(plotter.scalar_bars.keys()) == ["pdf [1/sr]"]
    plotter.close()


def test_screenshot_of_the_bunny(can_render, repository, tmp_path, child_environment):
    """The README's command, smaller: both halves hold a picture, and nothing else is left in the folder."""
    import matplotlib.image

    command = [sys.executable, repository / "viz" / "direction_clouds.py", "--screenshot", tmp_path / "clouds.png"]
    options = ["--points", "30", "--samples", "100", "--size", "800", "400"]
    done = subprocess.run([*command, *options], env=child_environment, capture_output=True, text=True, check=True)
    assert done.stdout.startswith(f"{tmp_path / 'clouds.png'}: 30 points x 100 directions; χ² ")
    assert [line for line in done.stderr.splitlines() if "CUDA" not in line] == []
    image = matplotlib.image.imread(tmp_path / "clouds.png")
    assert image.shape[:2] == (400, 800)
    for half in (image[:, :400], image[:, 400:]):
        assert (half.min(axis=-1) < 0.9).mean() > 0.05
    assert list(tmp_path.iterdir()) == [tmp_path / "clouds.png"]


def test_occlusion_is_drawn_side_by_side(can_render, repository, tmp_path, capsys):
    """The README's command, smaller: three pictures of the mesh, of what the estimate says."""
    import matplotlib.image

    specification = importlib.util.spec_from_file_location("occlusion", repository / "viz" / "occlusion.py")
    script = importlib.util.module_from_spec(specification)
    specification.loader.exec_module(script)
    script.main(samples=32, screenshot=tmp_path / "occlusion.png", size=(900, 340))
    assert re.match(r".*occlusion.png: 6,102 vertices, \d+% of 195,264 rays cast", capsys.readouterr().out)
    image = matplotlib.image.imread(tmp_path / "occlusion.png")[..., :3]
    for third in np.split(image, 3, axis=1):
        assert (np.abs(third - image[0, 0]).max(axis=-1) > 0.1).mean() > 0.1
    mesh = ws.load_mesh(script.BUNNY)
    found = ws.ambient_occlusion(mesh, ws.vertex_points(mesh), 32)
    panels = script.panels_of(found, 32)
    assert [panel.limits[0] for panel in panels] == [0.0, 0.0, 0.0]
    for panel, values in zip(panels, (found.value, found.standard_error, found.rays), strict=True):
        assert panel.value is values


def test_a_cloud_cut_by_the_budget_is_thinner_and_whole(can_render, viewer, monkeypatch, tmp_path, capsys):
    """The first part of a Fibonacci set would be a cap: every cloud's mean must stay at its sphere's centre."""
    kept = {}
    show = plotting.clouds_beside_histogram
    monkeypatch.setattr(plotting.budgeted, "__defaults__", (2000,))
    monkeypatch.setattr(plotting, "clouds_beside_histogram", lambda *a, **k: (kept.update(k, title=a[1]), show(*a, **k))[1])
    monkeypatch.setattr(viewer, "HISTOGRAM_DRAWS", 50_000)
    viewer.main(points=4, samples=4096, sequence="fibonacci", screenshot=tmp_path / "x.png", size=(800, 400))
    clouds = kept["clouds"].position.reshape(4, 500, 3)
    centres = kept["position"] + 0.5 * kept["scale"] * kept["normal"]
    # 500 lattice points are within 1/500 of the uniform sphere's mean; the first 500 of 4096 were off by 0.44.
    assert np.abs(clouds.mean(axis=1) - centres).max() <= 0.01 * kept["scale"]
    assert "4 points x 500 directions (of 4 x 4,096 asked for)" in kept["title"]
    assert "(of 4 x 4,096 asked for)" in capsys.readouterr().out


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ([], "error: there is no screen to open a window on: save a picture with --screenshot FILE"),
        (["--screenshot", "no/such/folder/x.png"], "error: --screenshot: got 'no/such/folder/x.png', whose folder"),
        (["nothing.ply", "--screenshot", "x.png"], "error: path: got 'nothing.ply', which is missing"),
        (["--size", "0", "9", "--screenshot", "x.png"], "error: --size: got 0 x 9, want at least 600 x 300"),
        (["--points", "0", "--screenshot", "x.png"], "error: count: got 0"),
        (["--distribution", "phong", "--screenshot", "x.png"], "error: distribution: got 'phong'"),
    ],
)
def test_viewer_says_what_is_wrong(arguments, message, repository, tmp_path, child_environment):
    command = [sys.executable, repository / "viz" / "direction_clouds.py", *arguments]
    done = subprocess.run(command, env=child_environment, capture_output=True, text=True, check=False, cwd=tmp_path)
    assert done.returncode == 2
    assert next(line for line in done.stderr.splitlines() if "CUDA" not in line).startswith(message)
    assert "Traceback" not in done.stderr
    assert list(tmp_path.iterdir()) == []


def test_a_missing_gl_library_is_a_sentence_and_no_crash(monkeypatch):
    monkeypatch.setattr(plotting, "_PROBE", "import os; os.abort()")
    with pytest.raises(RuntimeError, match="OpenGL library and none works here.*apt-get install libegl1 libgl1-mesa-dri"):
        plotting.check_rendering()


def test_a_missing_pyvista_says_what_to_install(monkeypatch):
    monkeypatch.setitem(sys.modules, "pyvista", None)
    with pytest.raises(ModuleNotFoundError, match=r"^pictures need pyvista: pip install 'warpsample\[viz\]'"):
        plotting.check_rendering()
