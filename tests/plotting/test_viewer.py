"""The viewer's window: what its knobs, its menus and the mouse change of what is drawn and said."""

from math import log, log2

import numpy as np
import pytest
import pyvista as pv
import trimesh
from vtkmodules.util.numpy_support import vtk_to_numpy

import warpsample as ws
from warpsample.plotting import rendering
from warpsample.viewer import controls, start, window
from warpsample.viewer.choice import Choice

COSINE = ws.CosineHemisphere()


@pytest.fixture(scope="module")
def viewer(can_render, bunny):
    made = window.Viewer(bunny, 20, Choice(ws.OffsetSphere(), COSINE, samples=256), size=(1200, 675), off_screen=True)
    made.plotter.show(auto_close=False, interactive=False)
    yield made
    made.plotter.close()


@pytest.fixture
def fresh(viewer):
    """The viewer as it starts."""
    viewer.controls.show(Choice(ws.OffsetSphere(), COSINE, samples=256))
    viewer.show(viewer.controls.choice)
    return viewer


def drawn_points(viewer):
    """Return the points that the plotter draws: on the mesh, and of the chosen cloud."""
    mappers = [viewer.cloud_actor.actor.mapper, viewer.near_actor.actor.mapper]
    for mapper in mappers:
        mapper.update()  # as the next frame would
    return [np.array(mapper.dataset.points) for mapper in mappers]


def press(viewer, menu, entry):
    button = viewer.controls.menus[menu].buttons[entry]
    button.GetRepresentation().SetState(1)
    button.InvokeEvent("StateChangedEvent")


def turn(viewer, knob, value):
    slider = viewer.controls.sliders[knob].widget
    slider.GetRepresentation().SetValue(value)
    slider.InvokeEvent("InteractionEvent")


def state(viewer, menu):
    return [name for name, b in viewer.controls.menus[menu].buttons.items() if b.GetRepresentation().GetState()]


def test_what_the_plotter_is_given(fresh, bunny):
    """Points on the faces, normals of the lobe's length, clouds within the lobe, and densities from 0 to the peak, 1/pi."""
    mappers = (getattr(actor, "mapper", None) for actor in fresh.plotter.renderers[1].actors.values())
    scene = [mapper.dataset for mapper in mappers if mapper is not None]
    ends = next(np.array(data.points) for data in scene if getattr(data, "n_lines", 0) == 20).reshape(20, 2, 3)
    assert np.abs(ends[:, 1] - ends[:, 0] - fresh.scale * fresh.points.normal).max() <= 1e-6
    corners = fresh.vertices[bunny.faces[fresh.points.face]]
    off = np.einsum("pk,pk->p", ends[:, 0] - corners[:, 0], bunny.face_normals[fresh.points.face])
    assert np.abs(off).max() <= 1e-6 * bunny.diagonal
    assert any(getattr(data, "n_cells", 0) == len(bunny.faces) for data in scene)
    on_mesh, _ = drawn_points(fresh)
    assert len(on_mesh) == 20 * 256
    away = np.linalg.norm(on_mesh.reshape(20, 256, 3) - fresh.points.position[:, None], axis=-1)
    assert away.max() <= fresh.scale * (1.0 + 1e-5)
    bar = fresh.plotter.scalar_bars["density [1/sr]"]
    assert vtk_to_numpy(bar.GetCustomLabels()) == pytest.approx([0.0, 0.1, 0.2, 0.3])
    mapper = fresh.cloud_actor.actor.mapper
    assert mapper.scalar_range == (0.0, pytest.approx(1.0 / np.pi, rel=1e-5))
    assert 0.0 < mapper.dataset["pdf"].min() < mapper.dataset["pdf"].max() <= 1.0 / np.pi * (1.0 + 1e-6)
    # The chosen cloud lies on the translucent lobe: the sphere of diameter 1 on the tangent plane.
    for points in (drawn_points(fresh)[1], np.array(fresh.lobe_actor.actor.mapper.dataset.points)):
        assert np.abs(np.linalg.norm(points - [0.0, 0.0, 0.5], axis=1) - 0.5).max() <= 1e-6


def test_turning_one_knob_makes_it_wrong_and_right_again(fresh):
    assert fresh.counts.theta.verdict().startswith("agrees")
    right = fresh.plotter.screenshot(return_img=True)
    turn(fresh, "scalar", log(0.8))
    assert fresh.controls.choice.distribution.rho == pytest.approx(0.8)
    assert fresh.counts.theta.is_wrong
    wrong = fresh.plotter.screenshot(return_img=True)
    assert (right.min(axis=-1) < 200).mean() > 0.1
    charts = np.s_[:, 660:]
    assert (np.abs(right[charts].astype(int) - wrong[charts]).max(axis=-1) > 50).mean() > 0.02
    # The sphere of radius 0.8 about the normal's tip: nothing beyond asin 0.8.
    near = drawn_points(fresh)[1].astype(np.float64)
    sine = np.hypot(near[:, 0], near[:, 1]) / np.linalg.norm(near, axis=1)
    assert sine.max() <= 0.8 + 1e-6
    turn(fresh, "scalar", 0.0)
    assert fresh.counts.theta.verdict().startswith("agrees")


@pytest.mark.slow
def test_menus_choose(fresh):
    press(fresh, "distribution", "cosine_hemisphere")
    assert fresh.controls.choice == Choice(COSINE, None, samples=256)
    assert (state(fresh, "distribution"), state(fresh, "density")) == (["cosine_hemisphere"], [controls.OWN])
    scalar = fresh.controls.sliders["scalar"].widget
    assert (scalar.GetRepresentation().GetVisibility(), scalar.GetProcessEvents()) == (0, 0)
    before = drawn_points(fresh)
    press(fresh, "method", "concentric")
    assert fresh.controls.choice.distribution == ws.CosineHemisphere("concentric")
    assert not any(np.array_equal(a, b) for a, b in zip(before, drawn_points(fresh), strict=True))
    press(fresh, "distribution", "offset_ball")
    assert (state(fresh, "method"), state(fresh, "density")) == ([], [controls.COSINE])
    assert fresh.counts.theta.verdict().startswith("does NOT agree with the cosine lobe")
    assert "compared with the cosine lobe" in fresh.caption.input
    press(fresh, "density", controls.OWN)
    assert fresh.counts.theta.verdict().startswith("agrees with its own density")
    assert "compared with its own density" in fresh.caption.input
    press(fresh, "sequence", "r2")
    assert fresh.controls.choice.sequence == "r2"
    assert "r2" in fresh.caption.input


@pytest.mark.slow
def test_sliders_turn(fresh):
    turn(fresh, "samples", log2(100.0))
    assert [len(p) for p in drawn_points(fresh)] == [2000, 100]
    assert "20 points x 100 directions" in fresh.caption.input
    assert fresh.controls.sliders["samples"].title.input == "100 directions per point"
    before = drawn_points(fresh)
    turn(fresh, "seed", 7.0)
    assert fresh.controls.choice.seed == 7
    assert not any(np.array_equal(a, b) for a, b in zip(before, drawn_points(fresh), strict=True))
    press(fresh, "distribution", "visible_ggx")
    for end in (-50.0, 50.0):  # beyond the slider's ends
        turn(fresh, "scalar", end)
        assert 0.05 <= fresh.controls.choice.distribution.alpha <= 1.0


def test_a_double_click_chooses_the_point_under_the_mouse(fresh, bunny):
    """Its cloud becomes the enlarged one, in the same window; the clouds on the mesh stay."""
    on_mesh, near = drawn_points(fresh)
    chosen = 0
    for at in [(x, y) for x in range(250, 600, 50) for y in range(350, 600, 50)]:
        before = fresh.chosen
        fresh.picker.click(at)
        if fresh.chosen is not before:
            chosen += 1
            corners = fresh.vertices[bunny.faces[fresh.chosen.face[0]]]
            weights = np.linalg.lstsq(
                np.vstack([corners.T, np.ones(3)]), np.append(fresh.chosen.position[0], 1.0), rcond=None
            )[0]
            assert weights.min() >= -1e-3  # the point is on the face
            assert fresh.chosen.normal[0] == pytest.approx(bunny.face_normals[fresh.chosen.face[0]])
    assert chosen > 5
    assert np.array_equal(drawn_points(fresh)[0], on_mesh)
    assert not np.array_equal(drawn_points(fresh)[1], near)
    before = fresh.chosen
    fresh.picker.click((1000, 300))  # on the charts
    assert fresh.chosen is before


@pytest.mark.slow
def test_texts_stay_within_their_panels(fresh):
    """In the smallest window, with the longest names."""
    assert fresh.plotter.window_size == list(start.LEAST_SIZE)
    long = ws.VisibleBeckmann(0.123, (0.707, 0.1, 0.7))
    fresh.show(Choice(long, ws.VisibleGGX(0.123, (0.707, 0.1, 0.7)), "independent", 4096, 99))
    shown = 0
    for renderer in fresh.plotter.renderers:
        for text in renderer.actors.values():
            if isinstance(text, pv.Text):
                size = [0.0, 0.0]
                text.GetSize(renderer, size)
                assert text.position[0] * renderer.GetSize()[0] + size[0] <= renderer.GetSize()[0], text.input
                shown += 1
    assert shown > 25


def test_charts_follow_the_size_of_the_window(fresh):
    fresh.plotter.window_size = (1400, 800)
    fresh.show(fresh.controls.choice)
    assert fresh.charts.size == (round(0.46 * 1400), 800)
    fresh.plotter.window_size = (1200, 675)


def test_the_first_of_a_kind_says_that_it_compiles(fresh, monkeypatch):
    said = []
    monkeypatch.setattr(fresh.plotter, "render", lambda: said.append(fresh.caption.input))
    press(fresh, "sequence", "philox")
    press(fresh, "sequence", "independent")
    assert [words.startswith("Compiling") for words in said] == [True, False, False]


@pytest.mark.slow
def test_a_cloud_cut_by_the_budget_is_thinner_and_whole(can_render, bunny, monkeypatch):
    """The first part of a Fibonacci set would be a cap: every cloud's mean must stay at its sphere's centre."""
    monkeypatch.setattr(rendering, "MOST_POINTS", 2000)
    choice = Choice(COSINE, sequence="fibonacci", samples=4096)
    made = window.Viewer(bunny, 4, choice, size=(1200, 675), off_screen=True)
    clouds = drawn_points(made)[0].reshape(4, 500, 3)
    centres = made.points.position + 0.5 * made.scale * made.points.normal
    # 500 lattice points are within 1/500 of the uniform sphere's mean; the first 500 of 4096 were off by 0.44.
    assert np.abs(clouds.mean(axis=1) - centres).max() <= 0.01 * made.scale
    assert "4 points x 500 directions (of 4 x 4,096 requested)" in made.caption.input
    made.plotter.close()


@pytest.mark.slow
def test_ten_million_directions_are_a_bounded_picture(can_render, monkeypatch):
    """Of a mesh on a map of cities: drawn about its middle, where float32 keeps the clouds' shape."""
    box = trimesh.creation.box()
    mesh = ws.Mesh(box.vertices + np.array([5e6, 4e6, 100.0]), box.faces)
    made = window.Viewer(mesh, 10_000_000, Choice(COSINE, samples=1000), up="z", size=(1200, 675), off_screen=True)
    on_mesh, near = drawn_points(made)
    assert (len(on_mesh), len(near)) == (1_000_000, 1000)
    caption = made.caption.input.replace("\n", " ")  # without line breaks
    assert "1,000,000 points x 1 directions (of 10,000,000 x 1,000 requested)" in caption
    assert "normals of the first 100,000 points only" in made.caption.input
    assert np.abs(on_mesh).max() <= 0.5 + made.scale
    assert on_mesh.dtype == np.float32
    made.plotter.close()
