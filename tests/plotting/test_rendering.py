"""Scenes: how much of them is drawn, what is saved, and what is said where there can be no picture."""

import re
import sys

import matplotlib.image
import pytest

import warpsample as ws
from warpsample.plotting import rendering, scenes


@pytest.mark.parametrize(
    ("points", "count", "shown"), [(10, 64, (10, 64)), (10_000, 1024, (10_000, 100)), (2_000_000, 4, (1_000_000, 1))]
)
def test_budget_bounds_what_is_drawn(points, count, shown):
    assert rendering.limit_counts(points, count) == shown
    said = rendering.describe_counts(shown, (points, count))
    assert ("requested" in said) == (shown != (points, count))


@pytest.mark.parametrize(
    ("high", "last", "step"), [(0.004475, 0.005, 0.001), (1.0, 1.0, 0.2), (1024.0, 1250.0, 250.0), (3e-7, 3e-7, 1e-7)]
)
def test_colour_bars_have_round_ticks(high, last, step):
    ticks = rendering.round_ticks(high, 5)
    assert (ticks[0], ticks[-1]) == (0.0, pytest.approx(last))
    assert ticks[1:] - ticks[:-1] == pytest.approx(step)


def test_the_readme_picture(can_render, call, tmp_path):
    """The README's command, smaller, in this process (.ci/run runs the script): each part holds a picture."""
    file = tmp_path / "clouds.png"
    status, out, err = call("view", "--points", 30, "--samples", 100, "--size", 1200, 675, "--screenshot", file)
    assert (status, err) == (0, "")
    assert out.startswith(
        f"{file}: 30 points x 100 directions of offset_sphere(rho=1); θ agrees with the cosine lobe: χ² = "
    )
    image = matplotlib.image.imread(file)[..., :3]
    assert image.shape == (675, 1200, 3)
    for part in (image[:, :200], image[:360, 204:640], image[370:, 204:640], image[:330, 660:], image[340:, 660:]):
        assert (part.min(axis=-1) < 0.9).mean() > 0.02
    assert list(tmp_path.iterdir()) == [file]


@pytest.mark.slow
def test_a_scene_to_turn_in_a_browser(can_render, call, tmp_path):
    file = tmp_path / "clouds.html"
    status, _, err = call("view", "--points", 10, "--samples", 64, "--distribution", "offset_ball", "--screenshot", file)
    assert (status, err) == (0, "")
    page = file.read_text()
    assert len(page) > 100_000
    assert 'content:"10 points x 64 directions of offset_ball; θ does NOT agree with the cosine lobe' in page
    elsewhere = re.compile(r"<(?:script|link|img)[^>]*(?:src|href)=.?(?:https?:)?//")
    assert elsewhere.findall(f'{page}<script src="https://x/y.js">') == ['<script src="https://']  # the planted one alone


def test_large_meshes_are_drawn_flat(can_render, monkeypatch):
    """Smoothing a million faces takes seconds."""
    import pyvista as pv

    monkeypatch.setattr(scenes, "MOST_SMOOTH_FACES", 3)
    mesh, plotter = ws.as_mesh(pv.Tetrahedron()), pv.Plotter(off_screen=True)
    assert scenes.draw_mesh(plotter, mesh.vertices, mesh.faces).prop.interpolation.name == "FLAT"
    monkeypatch.setattr(scenes, "MOST_SMOOTH_FACES", 4)
    assert scenes.draw_mesh(plotter, mesh.vertices, mesh.faces).prop.interpolation.name != "FLAT"
    plotter.close()


def test_a_picture_that_fails_leaves_no_file(can_render, tmp_path, monkeypatch):
    import pyvista as pv

    def half(self, path, **keywords):
        path.write(b"half")
        raise OSError("disk full")

    monkeypatch.setattr(pv.Plotter, "screenshot", half)
    with pytest.raises(OSError, match="disk full"):
        rendering.save_scene(pv.Plotter(off_screen=True), tmp_path / "x.png", "")
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ([], "error: this machine has no screen for a window; save a picture with --screenshot FILE"),
        (["--screenshot", "no/such/folder/x.png"], "error: --screenshot: got 'no/such/folder/x.png', whose folder"),
        (["--screenshot", "x.jpg"], "error: --screenshot: got 'x.jpg', want a file that ends in .png or .html"),
        (["nothing.ply", "--screenshot", "x.png"], "error: path: got 'nothing.ply', which is missing"),
        (["--size", "0", "9", "--screenshot", "x.png"], "error: --size: got 0 x 9, want at least 1200 x 675"),
        (["--size", "100000", "100000", "--screenshot", "x.png"], "error: --size: got 100000 x 100000, want at most 16,384"),
        (["--size", "16000", "16000", "--screenshot", "x.png"], "error: --size: got 16000 x 16000, want at most 16,384"),
        (["--distribution", "phong", "--screenshot", "x.png"], "error: --distribution: got 'phong'"),
        (
            ["--distribution", "offset_disk", "--screenshot", "x.png"],
            "error: --distribution: got OffsetDisk()",
        ),
        (["--density", "phong", "--screenshot", "x.png"], "error: --density: got 'phong'"),
        (["--sequence", "halton", "--screenshot", "x.png"], "error: --sequence: got 'halton'"),
        (
            ["--distribution", "beckmann(alpha=1e-6)", "--screenshot", "x.png"],
            "error: --distribution: got Beckmann(alpha=1e-06)",
        ),
    ],
)
def test_viewer_says_what_is_wrong(arguments, message, call, tmp_path, monkeypatch, can_render):
    for screen in ("DISPLAY", "WAYLAND_DISPLAY"):
        monkeypatch.delenv(screen, raising=False)
    monkeypatch.chdir(tmp_path)
    status, out, err = call("view", *arguments)
    assert (status, out) == (2, "")
    assert err.startswith(message)
    assert err.count("\n") == 1
    assert list(tmp_path.iterdir()) == []


def test_a_missing_gl_library_is_a_sentence_and_no_crash(monkeypatch):
    monkeypatch.setattr(rendering, "PROBE", "import os; os.abort()")
    with pytest.raises(RuntimeError, match="OpenGL library and none works here.*apt-get install libegl1 libgl1-mesa-dri"):
        rendering.check_rendering()


def test_a_missing_pyvista_says_what_to_install(monkeypatch, call, tmp_path):
    monkeypatch.setitem(sys.modules, "pyvista", None)
    said = call("view", "--screenshot", tmp_path / "x.png")
    assert said == (2, "", "error: pictures need pyvista: pip install '.[viz]'\n")
    assert list(tmp_path.iterdir()) == []
