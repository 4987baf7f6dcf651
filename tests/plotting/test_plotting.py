"""Pictures: what reaches them, that they tell right from wrong, and what is said where there can be none."""

import re
import sys
from dataclasses import replace
from functools import partial

import matplotlib.image
import numpy as np
import pytest
from significance import ALPHA

import warpsample as ws
from warpsample.plotting import rendering, scenes, sheets
from warpsample.plotting.charts import AngleHistogram, LobeCharts
from warpsample.proof.defects import Wrong
from warpsample.statistics.histogram import HistogramTest, joined_test

PNG_SCRIPTS = ("shirley_overlay", "offset_family", "sequences")


def picture(path):
    return matplotlib.image.imread(path)[..., :3]


def differing(a, b):
    """Share of pixels that are clearly unlike."""
    return (np.abs(a - b).max(axis=-1) > 0.2).mean()


@pytest.mark.parametrize(
    ("points", "count", "shown"), [(10, 64, (10, 64)), (10_000, 1024, (10_000, 100)), (2_000_000, 4, (1_000_000, 1))]
)
def test_budget_bounds_what_is_drawn(points, count, shown):
    assert rendering.budgeted(points, count) == shown
    said = rendering.clouds_told(shown, (points, count))
    assert ("asked for" in said) == (shown != (points, count))


def test_cells_are_joined_until_each_expects_enough():
    expected = np.array([0.0, 2.0, 4.0, 100.0, 3.0, 0.0, 4.0])
    test = joined_test(np.array([1.0, 2.0, 3.0, 100.0, 3.0, 1.0, 3.0]), expected)
    assert test.expected.tolist() == [6.0, 100.0, 7.0]
    assert test.observed.tolist() == [6.0, 100.0, 7.0]
    assert joined_test(np.array([4.0, 5.0]), np.array([4.0, 5.0])) is None
    # A last cell too small to stand alone joins its neighbour.
    assert joined_test(np.full(3, 6.0), np.array([8.0, 8.0, 2.0])).expected.tolist() == [8.0, 10.0]


def histogram(p_value):
    edges, density = np.linspace(0.0, 90.0, 7), np.array([0.2, 0.7, 1.0, 1.0, 0.7, 0.2])
    residuals = np.array([0.5, -0.5, 30.0, 0.1, 0.0, -1.0])
    test = None if p_value is None else HistogramTest(density, density, residuals, 12.5, 5, p_value)
    middle = 0.5 * (edges[1:] + edges[:-1])
    return AngleHistogram(edges, 1.1 * density, density, middle, density, residuals, test)


@pytest.mark.parametrize(
    ("p_value", "words"),
    [
        (0.3, "agrees\nχ² = 12.5, dof = 5, p = 0.300"),
        (1e-9, "does NOT agree\nχ² = 12.5, dof = 5, p < 10⁻⁶"),
        (1.0, "agrees, more evenly than chance\nχ² = 12.5, dof = 5, p = 1.000"),
        (None, "too few directions to say\n"),
    ],
)
def test_charts_show_their_data(p_value, words):
    charts = LobeCharts((740, 900))
    seen, disk = histogram(p_value), np.array([[0.1, 0.2], [0.3, -0.4]])
    charts.draw(seen, seen, disk)
    bars, curve, says, residuals = (artist for _, artist in charts.theta.moving)
    assert np.array_equal(bars.get_data().values, seen.observed)
    assert np.array_equal(curve.get_ydata(), seen.density)
    assert says.get_text() == f"θ {words}"
    assert np.array_equal(residuals.get_data().values, np.clip(seen.residuals, -6.0, 6.0))
    assert np.array_equal(charts.disk.moving[0][1].get_xydata(), disk)


def test_blitting_draws_what_a_whole_drawing_would():
    """After any other histogram, also one with other axes."""
    reused, wide = LobeCharts((740, 900)), histogram(0.5)
    other = replace(wide, edges=2.0 * wide.edges, observed=3.0 * wide.observed, expected=3.0 * wide.expected, test=None)
    disk = np.random.default_rng(0).uniform(-0.7, 0.7, (100, 2))
    for theta, azimuth in ((wide, wide), (other, wide), (wide, other), (wide, wide)):
        drawn = reused.draw(theta, azimuth, disk)
        assert np.array_equal(drawn, LobeCharts((740, 900)).draw(theta, azimuth, disk))
    assert (drawn.min(axis=-1) < 200).mean() > 0.05


def test_light_adds_up():
    """Two points apart are red and green, the same point twice is yellow."""
    apart, share = sheets.overlay(np.array([[0.5, 0.0, 0.9]]), np.array([[-0.5, 0.0, 0.9]]), 200)
    assert share == 0.0
    assert apart[100, 150].tolist() == [1.0, 0.0, 0.0]
    assert apart[100, 50].tolist() == [0.0, 1.0, 0.0]
    both, share = sheets.overlay(np.array([[0.0, 0.5, 0.9]]), np.array([[0.0, 0.5, 0.9]]), 200)
    assert share == 1.0
    assert both[50, 100].tolist() == [1.0, 1.0, 0.0]  # +y is up


def test_the_overlay_turns_yellow_for_the_right_set_alone(script):
    """Keinert's identity: normalize(sphere + n) is the cosine set, point by point."""
    found = script("shirley_overlay").directions(1024, "fibonacci", seed=0)
    # Rounding of the float32 sphere is doubled near its far pole, where the sum is short.
    assert np.abs(found["sphere"] - found["cosine"]).max() <= 1e-5
    assert np.median(np.linalg.norm(found["ball"] - found["cosine"], axis=1)) > 0.05
    _, right = sheets.overlay(found["cosine"], found["sphere"], 700)
    _, wrong = sheets.overlay(found["cosine"], found["ball"], 700)
    assert right > 0.99
    assert wrong < 0.2


def test_the_offset_family_is_what_it_says(script, plausible):
    family = script("offset_family")
    panels = [family.panel(*row, 40_000, 1) for row in family.SETS + family.SPHERES]
    for panel, reach in zip(panels, (1.0, 1.0, 1.0, 1.0, 0.5, 0.9, 2.0), strict=True):
        plausible(panel.test.p_value)
        assert (panel.observed * np.radians(np.diff(panel.edges))).sum() == pytest.approx(1.0)
        # Seen from the side the set fills the circle about the normal's tip.
        assert 0.95 * reach < np.linalg.norm(panel.points - [0.0, 1.0], axis=1).max() <= reach * (1.0 + 1e-6)
    for planar in panels[:2]:
        assert np.abs(np.linalg.norm(planar.directions, axis=1) - 1.0).max() <= 1e-6
    title, _, *rest = family.SETS[2]
    wrong = family.panel(title, Wrong(ws.OffsetSphere(), sample=ws.OffsetBall().sample), *rest, 40_000, 1)
    assert wrong.test.p_value < ALPHA


@pytest.mark.slow
def test_errors_fall_as_they_should(script, monkeypatch):
    """As 1/sqrt(N) for independent points, faster for the others, and not at all for a wrong lobe."""
    module = script("sequences")
    (right,) = module.errors(("sky gradient",), 128, seed=0)
    ratio = right.rmse["independent"][0] / right.rmse["independent"][-1]
    assert ratio == pytest.approx(16.0, rel=0.3)  # a standard error of an RMSE over 128 is 6 %
    for name in ("sobol", "fibonacci", "r2", "stratified"):
        assert right.rmse[name][-1] < 0.1 * right.rmse["independent"][-1]
    monkeypatch.setattr(module.ws, "sample_directions", partial(ws.sample_directions, distribution="offset_ball"))
    (wrong,) = module.errors(("sky gradient",), 32, seed=0)
    assert wrong.rmse["sobol"][-1] > 0.5 * wrong.rmse["sobol"][1]  # its bias stays; the right error fell by 300


def test_the_overlay_is_drawn(can_render, script, tmp_path, capsys):
    file = tmp_path / "overlay.png"
    script("shirley_overlay").main(samples=300, screenshot=file, size=(800, 640))
    assert re.match(
        r".*overlay.png: 300 points each, .* yellow: sphere (100.0|99.\d)%, ball \d.\d%\n$", capsys.readouterr().out
    )
    left, right = np.split(picture(file), 2, axis=1)
    yellow, red = ((half[..., 0] > 0.9) & (half[..., 1] > 0.9) for half in (left, right))
    assert yellow.sum() > 2 * red.sum()
    assert list(tmp_path.iterdir()) == [file]


@pytest.mark.parametrize("name", ["occlusion", "offset_family", "shirley_overlay"])
def test_scripts_call_their_directions_samples(can_render, script, tmp_path, capsys, name):
    with pytest.raises(SystemExit):
        script(name).main(samples=0, screenshot=tmp_path / "a.png")
    assert capsys.readouterr().err.startswith("error: --samples: got 0, want a whole number from ")


def ball_for_sphere(module, monkeypatch):
    title, _, *rest = module.SETS[2]
    ball = (title, Wrong(ws.OffsetSphere(), sample=ws.OffsetBall().sample), *rest)
    monkeypatch.setattr(module, "SETS", (*module.SETS[:2], ball, module.SETS[3]))


def ball_for_cosine(module, monkeypatch):
    monkeypatch.setattr(module.ws, "sample_directions", partial(ws.sample_directions, distribution="offset_ball"))


def upside_down(module, monkeypatch):
    points = ws.vertex_points
    monkeypatch.setattr(module.ws, "vertex_points", lambda mesh: ws.SurfacePoints(mesh.vertices, -points(mesh).normal))


@pytest.mark.parametrize(
    ("name", "options", "spoil"),
    [
        ("offset_family", {"samples": 5000, "size": (800, 800)}, ball_for_sphere),
        ("sequences", {"randomisations": 16, "size": (800, 640)}, ball_for_cosine),
        ("occlusion", {"samples": 32, "size": (900, 340)}, upside_down),
    ],
)
@pytest.mark.slow
def test_a_wrong_sampler_is_another_picture(can_render, script, tmp_path, monkeypatch, capsys, name, options, spoil):
    """And neither is blank. The overlay has both on one picture, the viewer's are compared in test_viewer.py."""
    module, files = script(name), [tmp_path / "right.png", tmp_path / "wrong.png"]
    module.main(screenshot=files[0], **options)
    spoil(module, monkeypatch)
    module.main(screenshot=files[1], **options)
    right, wrong = (picture(file) for file in files)
    assert capsys.readouterr().out.startswith(f"{files[0]}: ")
    assert right.shape[:2] == options["size"][::-1]
    assert differing(right, right[:1, :1]) > 0.03
    assert 0.001 < differing(right, wrong) < 0.3  # the captions and frames are the same
    assert set(tmp_path.iterdir()) == set(files)


def test_the_readme_picture(can_render, call, tmp_path):
    """The README's command, smaller, in this process (.ci/run runs the script): each part holds a picture."""
    file = tmp_path / "clouds.png"
    status, out, err = call("view", "--points", 30, "--samples", 100, "--size", 1200, 675, "--screenshot", file)
    assert (status, err) == (0, "")
    assert out.startswith(f"{file}: 30 points x 100 directions of offset_sphere(rho=1); θ agrees")
    image = picture(file)
    assert image.shape == (675, 1200, 3)
    for part in (image[:, :200], image[:360, 204:640], image[370:, 204:640], image[:330, 660:], image[340:, 660:]):
        assert (part.min(axis=-1) < 0.9).mean() > 0.02
    assert list(tmp_path.iterdir()) == [file]


def test_a_scene_to_turn_in_a_browser(can_render, call, tmp_path):
    file = tmp_path / "clouds.html"
    status, _, err = call("view", "--points", 10, "--samples", 64, "--distribution", "offset_ball", "--screenshot", file)
    assert (status, err) == (0, "")
    page = file.read_text()
    assert len(page) > 100_000
    assert 'content:"10 points x 64 directions of offset_ball; θ agrees' in page
    elsewhere = re.compile(r"<(?:script|link|img)[^>]*(?:src|href)=.?(?:https?:)?//")
    assert elsewhere.findall(f'{page}<script src="https://x/y.js">') == ['<script src="https://']  # the planted one alone


def test_occlusion_is_drawn_as_estimated(script, bunny):
    found = ws.ambient_occlusion(bunny, ws.vertex_points(bunny), 32)
    panels = script("occlusion").panels_of(found, 32)
    assert [panel.limits[0] for panel in panels] == [0.0, 0.0, 0.0]
    for panel, values in zip(panels, (found.value, found.standard_error, found.rays), strict=True):
        assert panel.value is values


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
        ([], "error: there is no screen to open a window on: save a picture with --screenshot FILE"),
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


@pytest.mark.parametrize("name", [*PNG_SCRIPTS, "occlusion"])
def test_scripts_say_what_is_wrong(name, script, tmp_path, monkeypatch, capsys):
    monkeypatch.setattr(rendering, "has_screen", lambda: False)
    main = script(name).main
    for wrong in ({}, {"screenshot": tmp_path / "no" / "x.png"}, {"screenshot": tmp_path / "x.gif"}):
        with pytest.raises(SystemExit) as stop:
            main(**wrong)
        assert stop.value.code == 2
        assert re.match(
            r"error: (--screenshot: got .*|there is no screen to open a window on: .*)\n$", capsys.readouterr().err
        )
    with pytest.raises(SystemExit):
        main(screenshot=tmp_path / "x.png", size=(100, 2000))
    assert re.match("error: --size: got 100 x 2000, want at least [69]00 x [36][40]0", capsys.readouterr().err)
    with pytest.raises(SystemExit):
        main(screenshot=tmp_path / "x.png", size=(100_000, 100_000))
    assert capsys.readouterr().err.startswith("error: --size: got 100000 x 100000, want at most 16,384")
    assert list(tmp_path.iterdir()) == []


def test_a_missing_gl_library_is_a_sentence_and_no_crash(monkeypatch):
    monkeypatch.setattr(rendering, "_PROBE", "import os; os.abort()")
    with pytest.raises(RuntimeError, match="OpenGL library and none works here.*apt-get install libegl1 libgl1-mesa-dri"):
        rendering.check_rendering()


def test_a_missing_pyvista_says_what_to_install(monkeypatch, call, tmp_path):
    monkeypatch.setitem(sys.modules, "pyvista", None)
    said = call("view", "--screenshot", tmp_path / "x.png")
    assert said == (2, "", "error: pictures need pyvista: pip install pyvista\n")
    assert list(tmp_path.iterdir()) == []
