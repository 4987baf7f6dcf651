"""The scripts of viz/: what reaches their pictures, that a wrong sampler is another picture, and what they refuse."""

import re
from functools import partial

import matplotlib.image
import numpy as np
import pytest
import pyvista as pv
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.text import Text
from significance import ALPHA

import warpsample as ws
from warpsample.plotting import rendering
from warpsample.plotting.family_sheet import family_sheet
from warpsample.plotting.overlay_sheet import overlay
from warpsample.plotting.panels import Panel, fit_view
from warpsample.plotting.sequence_sheet import Convergence, sequence_sheet
from warpsample.plotting.sky_scene import map_patches, map_positions
from warpsample.proof.defects import WrongSampler

PNG_SCRIPTS = ("shirley_overlay", "offset_family", "sequences", "glossy_reflection", "direct_light")


def picture(path):
    return matplotlib.image.imread(path)[..., :3]


def differing(a, b):
    """Share of pixels that are clearly unlike."""
    return (np.abs(a - b).max(axis=-1) > 0.2).mean()


def test_light_adds_up():
    """Two points apart are red and green, the same point twice is yellow."""
    apart, share = overlay(np.array([[0.5, 0.0, 0.9]]), np.array([[-0.5, 0.0, 0.9]]), 200)
    assert share == 0.0
    assert apart[100, 150].tolist() == [1.0, 0.0, 0.0]
    assert apart[100, 50].tolist() == [0.0, 1.0, 0.0]
    both, share = overlay(np.array([[0.0, 0.5, 0.9]]), np.array([[0.0, 0.5, 0.9]]), 200)
    assert share == 1.0
    assert both[50, 100].tolist() == [1.0, 1.0, 0.0]  # +y is up


def test_the_overlay_turns_yellow_for_the_right_set_alone(script):
    """Keinert's identity: normalize(sphere + n) is the cosine set, point by point."""
    found = script("shirley_overlay").directions(1024, "fibonacci", seed=0)
    # Rounding of the float32 sphere is doubled near its far pole, where the sum is short.
    assert np.abs(found["sphere"] - found["cosine"]).max() <= 1e-5
    assert np.median(np.linalg.norm(found["ball"] - found["cosine"], axis=1)) > 0.05
    _, right = overlay(found["cosine"], found["sphere"], 700)
    _, wrong = overlay(found["cosine"], found["ball"], 700)
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
    wrong = family.panel(title, WrongSampler(ws.OffsetSphere(), sample=ws.OffsetBall().sample), *rest, 40_000, 1)
    assert wrong.test.p_value < ALPHA


def sheet_of_the_family(script):
    family = script("offset_family")
    panels = [family.panel(*row, 1000, 1) for row in family.SETS + family.SPHERES]
    return family_sheet(panels[:4], panels[4:], "the caption")


def sheet_of_the_sequences(script):
    square = {name: np.full((4, 2), 0.5) for name in ws.sequences.names()}
    lobe = {name: np.eye(3) for name in square}
    curve = Convergence("sky", np.array([16, 64]), {name: np.array([0.1, 0.01]) for name in square})
    return sequence_sheet(square, lobe, [curve, curve], "the caption")


@pytest.mark.slow
@pytest.mark.parametrize("sheet", [sheet_of_the_family, sheet_of_the_sequences])
def test_captions_are_as_large_as_the_labels_and_legends_hide_no_data(script, sheet):
    figure = sheet(script)
    FigureCanvasAgg(figure).draw()
    sizes = {text.get_text(): text.get_fontsize() for text in figure.findobj(Text)}
    labels = {axes.get_xlabel() for axes in figure.axes} - {""}
    assert len(labels) >= 1
    assert {sizes[label] for label in labels} == {sizes["the caption"]}
    for axes in figure.axes:
        if axes.get_legend() is not None and axes.get_xlabel():
            box = axes.get_legend().get_window_extent()
            for line in axes.lines:
                x, y = axes.transData.transform(line.get_xydata()).T
                assert ((x <= box.x0) | (x >= box.x1) | (y <= box.y0)).all()


@pytest.mark.thorough
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
        r".*overlay.png: 300 points per set, .* yellow: sphere (100.0|99.\d)%, ball \d.\d%\n$", capsys.readouterr().out
    )
    left, right = np.split(picture(file), 2, axis=1)
    yellow, red = ((half[..., 0] > 0.9) & (half[..., 1] > 0.9) for half in (left, right))
    assert yellow.sum() > 2 * red.sum()
    assert list(tmp_path.iterdir()) == [file]


def ball_for_sphere(module, monkeypatch):
    title, _, *rest = module.SETS[2]
    ball = (title, WrongSampler(ws.OffsetSphere(), sample=ws.OffsetBall().sample), *rest)
    monkeypatch.setattr(module, "SETS", (*module.SETS[:2], ball, module.SETS[3]))


def ball_for_cosine(module, monkeypatch):
    monkeypatch.setattr(module.ws, "sample_directions", partial(ws.sample_directions, distribution="offset_ball"))


def upside_down(module, monkeypatch):
    points = ws.vertex_points
    monkeypatch.setattr(module.ws, "vertex_points", lambda mesh: ws.SurfacePoints(mesh.vertices, -points(mesh).normal))


@pytest.mark.parametrize(
    ("name", "options", "spoil"),
    [
        pytest.param("offset_family", {"samples": 5000, "size": (800, 800)}, ball_for_sphere, marks=pytest.mark.thorough),
        pytest.param("sequences", {"randomisations": 16, "size": (800, 640)}, ball_for_cosine, marks=pytest.mark.thorough),
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


@pytest.mark.thorough
def test_a_baked_texture_is_drawn_by_its_own_images(can_render, script, bunny, tmp_path, capsys):
    """The colours of errors end at the requested number, and the picture is not blank."""
    module = script("baked_texture")
    pytest.importorskip("xatlas")
    assert module.color_image(np.array([[0.0, 0.5, 2.0]]), "viridis", 0.5)[0].tolist() == [
        [68, 1, 84],
        [253, 231, 37],
        [253, 231, 37],
    ]
    uv, occlusion, error = module.bake_images(bunny, 128, 32, 0)
    assert (uv.shape, occlusion.shape, error.shape) == ((len(bunny.faces), 3, 2), (128, 128), (128, 128))
    right = ws.ambient_occlusion(bunny, ws.face_centers(bunny), 256).value
    at = np.clip((128 * uv.mean(axis=1)).astype(int), 0, 127)
    assert np.sqrt(np.mean((occlusion[at[:, 1], at[:, 0]] - right) ** 2)) < 0.1  # 32 rays; another place is 0.2 off
    module.main(side=128, samples=16, screenshot=tmp_path / "a.png", size=(900, 340))
    assert capsys.readouterr().out.startswith(f"{tmp_path / 'a.png'}: 12,200 faces, 128 x 128 texels")
    shown = picture(tmp_path / "a.png")
    assert differing(shown, shown[:1, :1]) > 0.03


def test_occlusion_is_drawn_as_estimated(script, bunny):
    found = ws.ambient_occlusion(bunny, ws.vertex_points(bunny), 32)
    panels = script("occlusion").make_panels(found, 32)
    error = np.quantile(found.standard_error.astype(np.float64), 0.99)
    assert [panel.high for panel in panels] == [1.0, pytest.approx(panels[1].high), 32.0]
    assert error <= panels[1].high <= 2.5 * error
    assert f"{panels[1].high:.1g}" == f"{panels[1].high:g}"  # the last colour is a round number
    for panel, values in zip(panels, (found.value, found.standard_error, found.rays), strict=True):
        assert panel.value is values


def test_the_sky_is_mapped_with_north_up_and_every_patch_once():
    positions = map_positions(np.array([90.0, 0.0, 0.0, 45.0]), np.array([0.0, 0.0, 90.0, 180.0]))
    assert np.allclose(positions, [[0, 0, 0], [0, 1, 0], [1, 0, 0], [0, -0.5, 0]], atol=1e-12)
    patches = ws.sky_patches("tregenza")
    corners, quads = map_patches(patches.altitudes, patches.azimuths)
    x, y = np.moveaxis(corners[quads, :2], -1, 0)
    area = 0.5 * np.abs((x * np.roll(y, -1, axis=1) - y * np.roll(x, -1, axis=1)).sum(axis=1))
    assert area.sum() == pytest.approx(np.pi, rel=0.02)  # chords for arcs
    middle = corners[quads].mean(axis=1).reshape(145, -1, 3).mean(axis=1)[:-1]
    sine = np.arcsin(patches.directions[:-1, 2])
    assert (
        np.abs(middle - map_positions(np.degrees(sine), np.degrees(np.arctan2(*patches.directions[:-1, :2].T)))).max() < 0.02
    )


def test_the_sky_is_shown_of_the_ground_that_sees_least_of_it_and_the_slider_turns_the_hour(script, can_render, monkeypatch):
    module = script("sun_and_sky")
    mesh = ws.load_mesh("courtyard")
    points = ws.face_centers(mesh)
    matrix = ws.sky_matrix(mesh, points, 16)
    row = module.find_enclosed(points, matrix.value, np.array([0.0, 0.0, 1.0]))
    shares = matrix.value.sum(axis=1, dtype=np.float64)
    assert points.normal[row].tolist() == [0.0, 0.0, 1.0]
    assert shares[row] == shares[points.normal[:, 2] == 1.0].min() < 0.3
    sky = module.sky_map(matrix, row, "athens", "06-21")
    assert [len(path) for path in sky.paths.values()] == [9, 13, 15]
    assert sky.sun.shape == (24, 2)
    hours, turn = np.arange(24.0)[:, None] * np.ones(len(points)), []
    monkeypatch.setattr(pv.Plotter, "add_slider_widget", lambda _, show, *_rest, **_more: turn.append(show))
    unseen = pv.Plotter
    monkeypatch.setattr(pv, "Plotter", lambda **given: unseen(**given | {"off_screen": True}))
    left, captions = Panel(hours[5], "year", "gray", 25.0), ("below", lambda now: f"hour {now}")
    given = {"hours": hours, "hour": 9, "sky": sky, "point": points.position[row], "captions": captions, "up": "z"}
    drawn = module.sun_and_sky((mesh.vertices, mesh.faces), left, **given, off_screen=False, size=(900, 340))
    year, hour, shown = (next(iter(drawn.renderers[i].actors.values())).mapper.dataset for i in range(3))
    assert (set(year["year"]), set(hour["hour"])) == ({5.0}, {9.0})
    shares = np.repeat(matrix.value[row].astype(float), 8)
    assert np.array_equal(np.nan_to_num(shown.active_scalars), shares)  # patches that are hidden have no number
    before = drawn.screenshot(return_img=True)
    turn[0](14.8)
    assert (set(year["year"]), set(hour["hour"])) == ({5.0}, {15.0})
    assert differing(before / 255.0, drawn.screenshot(return_img=True) / 255.0) > 0.01


@pytest.mark.parametrize(
    "name",
    [
        *PNG_SCRIPTS,
        "baked_texture",
        "environment_map",
        "light_between",
        "maps",
        "occlusion",
        "own_lobes",
        "sun_and_sky",
        "view_factors",
        "baked_store",
    ],
)
def test_scripts_say_what_is_wrong(name, script, tmp_path, monkeypatch, capsys):
    monkeypatch.setattr(rendering, "has_screen", lambda: False)
    main = script(name).main
    for wrong in ({}, {"screenshot": tmp_path / "no" / "x.png"}, {"screenshot": tmp_path / "x.gif"}):
        with pytest.raises(SystemExit) as stop:
            main(**wrong)
        assert stop.value.code == 2
        assert re.match(
            r"error: (--screenshot: got .*|this machine has no screen for a window; .*)\n$", capsys.readouterr().err
        )
    with pytest.raises(SystemExit):
        main(screenshot=tmp_path / "x.png", size=(100, 2000))
    assert re.match("error: --size: got 100 x 2000, want at least [69]00 x [36][40]0", capsys.readouterr().err)
    with pytest.raises(SystemExit):
        main(screenshot=tmp_path / "x.png", size=(100_000, 100_000))
    assert capsys.readouterr().err.startswith("error: --size: got 100000 x 100000, want at most 16,384")
    assert list(tmp_path.iterdir()) == []


def test_a_fitted_view_shows_all_points_between_title_and_bar(can_render):
    """In each of the three directions, of a mesh that is wide, tall or far from the origin."""
    for up, above in (("y", 0.0), ("z", 0.0), ("z", 2.0), ("x", 0.5)):
        for points in (np.diag([30.0, 1.0, 2.0]), np.diag([1.0, 1.0, 50.0]) + 1e6):
            plotter = pv.Plotter(off_screen=True, window_size=(300, 340))
            fit_view(plotter, points, up, above)
            window = []
            for point in points:
                plotter.renderer.SetWorldPoint(*point, 1.0)
                plotter.renderer.WorldToDisplay()
                window.append(plotter.renderer.GetDisplayPoint()[:2])
            x, y = np.array(window).T / [[300], [340]]
            assert (x.min() > 0.02, x.max() < 0.98, y.min() > 0.16, y.max() < 0.90) == (True,) * 4
            assert max(np.ptp(x) / 0.94, np.ptp(y) / 0.72) == pytest.approx(1.0, abs=0.02)  # it fills the space
            plotter.close()
