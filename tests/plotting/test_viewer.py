"""The viewer: what its clouds and charts say of right and wrong samplers, and what its knobs change."""

from dataclasses import replace
from math import exp, log, log2

import numpy as np
import pytest
import trimesh
from scipy.integrate import trapezoid
from significance import ALPHA

import warpsample as ws
from warpsample.viewer import controls, lobes, window
from warpsample.viewer.lobes import Choice

COSINE = ws.CosineHemisphere()


def judged(distribution, claim, draws=60_000, seed=5):
    """The two histograms of independent local directions of one distribution held against another."""
    u = ws.sample_square("independent", 1, draws, seed)[0]
    return lobes.histograms(distribution.sample(u), lobes.lobe_of(claim))


def test_cosine_clouds_are_uniform_spheres_resting_on_the_surface(points):
    few = ws.SurfacePoints(points.position[:20], points.normal[:20])
    cloud = lobes.all_clouds(Choice(COSINE, samples=4096), few, 0.1).position.reshape(20, 4096, 3)
    from_centre = (cloud - (few.position + 0.05 * few.normal)[:, None]) / 0.05
    # Coordinates of a unit in float32, over a radius of 0.05.
    assert np.abs(np.linalg.norm(from_centre, axis=-1) - 1.0).max() <= 1e-5
    # Uniform on that sphere: mean 0, second moments 1/3; 4096 Owen-scrambled points are within 1/4096.
    assert np.abs(from_centre.mean(axis=1)).max() <= 1e-3
    assert np.abs(np.einsum("psi,psj->pij", from_centre, from_centre) / 4096 - np.eye(3) / 3).max() <= 1e-3


def test_the_cosine_lobe_is_drawn_as_a_sphere_of_diameter_one():
    surface = lobes.lobe_of(COSINE).surface
    assert np.abs(np.linalg.norm(surface - [0.0, 0.0, 0.5], axis=-1) - 0.5).max() <= 1e-6
    assert np.ptp(surface[..., 2]) == pytest.approx(1.0, abs=1e-6)


@pytest.mark.parametrize("name", controls.spatial())
def test_right_directions_agree_and_wrong_ones_do_not(name, plausible):
    """Those of the menu's entry with its own density; and with that of the next value of its slider, or the next entry."""
    right = controls.made(name)
    lobe = lobes.lobe_of(right)
    assert (lobe.theta.sum(), lobe.azimuth.sum()) == (pytest.approx(1.0), pytest.approx(1.0))
    # The chart's line has the mass of what it shows.
    assert trapezoid(lobe.line, lobe.angles) == pytest.approx(lobe.theta[:-1].sum(), abs=0.02)
    for histogram in judged(right, right):
        plausible(histogram.test.p_value)
        assert "agrees" in histogram.verdict()
    kind = type(right)
    wrong = controls.with_scalar(right, 1.1 * getattr(right, kind.parameters[0])) if kind.shown else ws.OffsetSphere(1.05)
    theta, _ = judged(wrong, right)
    assert theta.test.p_value < ALPHA
    assert theta.verdict().startswith("does NOT agree")


def test_azimuth_is_judged_about_the_tangent_that_the_kernels_take(points):
    """Visible normals lean towards their view: with another frame they would not."""
    leaning = controls.tilted(ws.VisibleGGX(0.5), 70.0)
    seen = lobes.all_clouds(Choice(leaning, sequence="independent", samples=100), points, 1.0)
    assert seen.azimuth.test.p_value >= ALPHA
    turned = replace(leaning, view=(leaning.view[1], leaning.view[0], leaning.view[2]))
    assert lobes.all_clouds(Choice(leaning, turned, "independent", 100), points, 1.0).azimuth.test.p_value < ALPHA


def test_what_is_outside_the_density_is_counted_and_drawn_apart(points):
    seen = lobes.all_clouds(Choice(ws.UniformSphere(), COSINE, samples=256), points, 1.0)
    # Half of every 256 points of Sobol's, but for those that rounding puts across the horizon.
    assert seen.outside == pytest.approx(0.5 * 256 * len(points), rel=1e-3)
    away = np.linalg.norm(seen.position - np.repeat(points.position, 256, axis=0), axis=1)[seen.pdf == 0.0]
    assert np.abs(away - lobes.OUTSIDE).max() <= 1e-5
    assert seen.theta.test.p_value == 0.0


def test_few_directions_are_not_judged(points):
    few = ws.SurfacePoints(points.position[:1], points.normal[:1])
    seen = lobes.all_clouds(Choice(COSINE, samples=8), few, 1.0)
    assert seen.theta.test is None
    assert seen.theta.verdict() == "too few directions to say\n"


def test_what_is_too_narrow_to_be_seen_is_refused():
    with pytest.raises(
        ValueError, match=r"^distribution: got Beckmann\(alpha=1e-06\), a lobe of 0.0001 degrees, want one of 0.01 at least"
    ):
        lobes.lobe_of(ws.Beckmann(1e-6))


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


def drawn(viewer):
    """The points that the plotter has been given: on the mesh, and of the chosen cloud."""
    mappers = [viewer._clouds.actor.mapper, viewer._near.actor.mapper]
    for mapper in mappers:
        mapper.update()  # as the next frame would
    return [np.array(mapper.dataset.points) for mapper in mappers]


def press(viewer, menu, entry):
    button = viewer.controls.menus[menu].buttons[entry]
    button.GetRepresentation().SetState(1)
    button.InvokeEvent("StateChangedEvent")


def turn(viewer, knob, value):
    slider = viewer.controls.knobs[knob].widget
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
    on_mesh, _ = drawn(fresh)
    assert len(on_mesh) == 20 * 256
    away = np.linalg.norm(on_mesh.reshape(20, 256, 3) - fresh.points.position[:, None], axis=-1)
    assert away.max() <= fresh.scale * (1.0 + 1e-5)
    mapper = fresh._clouds.actor.mapper
    assert mapper.scalar_range == (0.0, pytest.approx(1.0 / np.pi, rel=1e-5))
    assert 0.0 < mapper.dataset["pdf"].min() < mapper.dataset["pdf"].max() <= 1.0 / np.pi * (1.0 + 1e-6)
    # The chosen cloud lies on the translucent lobe: the sphere of diameter 1 on the tangent plane.
    for points in (drawn(fresh)[1], np.array(fresh._lobe.actor.mapper.dataset.points)):
        assert np.abs(np.linalg.norm(points - [0.0, 0.0, 0.5], axis=1) - 0.5).max() <= 1e-6


def test_turning_one_knob_makes_it_wrong_and_right_again(fresh):
    assert fresh.clouds.theta.verdict().startswith("agrees")
    right = fresh.plotter.screenshot(return_img=True)
    turn(fresh, "scalar", log(0.8))
    assert fresh.controls.choice.distribution.rho == pytest.approx(0.8)
    assert fresh.clouds.theta.verdict().startswith("does NOT agree")
    wrong = fresh.plotter.screenshot(return_img=True)
    assert (right.min(axis=-1) < 200).mean() > 0.1
    charts = np.s_[:, 660:]
    assert (np.abs(right[charts].astype(int) - wrong[charts]).max(axis=-1) > 50).mean() > 0.02
    # The sphere of radius 0.8 about the normal's tip: nothing beyond asin 0.8.
    near = drawn(fresh)[1].astype(np.float64)
    sine = np.hypot(near[:, 0], near[:, 1]) / np.linalg.norm(near, axis=1)
    assert sine.max() <= 0.8 + 1e-6
    turn(fresh, "scalar", 0.0)
    assert fresh.clouds.theta.verdict().startswith("agrees")


def test_menus_choose(fresh):
    press(fresh, "distribution", "cosine_hemisphere")
    assert fresh.controls.choice == Choice(COSINE, None, samples=256)
    assert (state(fresh, "distribution"), state(fresh, "density")) == (["cosine_hemisphere"], [controls.OWN])
    scalar = fresh.controls.knobs["scalar"].widget
    assert (scalar.GetRepresentation().GetVisibility(), scalar.GetProcessEvents()) == (0, 0)
    before = drawn(fresh)
    press(fresh, "method", "concentric")
    assert fresh.controls.choice.distribution == ws.CosineHemisphere("concentric")
    assert not any(np.array_equal(a, b) for a, b in zip(before, drawn(fresh), strict=True))
    press(fresh, "distribution", "offset_ball")
    assert state(fresh, "method") == []
    assert fresh.clouds.theta.verdict().startswith("agrees")
    press(fresh, "density", controls.COSINE)
    assert fresh.clouds.theta.verdict().startswith("does NOT agree")
    assert "of cosine_hemisphere" in fresh._says.input
    press(fresh, "sequence", "r2")
    assert fresh.controls.choice.sequence == "r2"
    assert "r2" in fresh._says.input


def test_sliders_turn(fresh):
    turn(fresh, "samples", log2(100.0))
    assert [len(p) for p in drawn(fresh)] == [2000, 100]
    assert "20 points x 100 directions" in fresh._says.input
    assert fresh.controls.knobs["samples"]._title.input == "100 directions a point"
    before = drawn(fresh)
    turn(fresh, "seed", 7.0)
    assert fresh.controls.choice.seed == 7
    assert not any(np.array_equal(a, b) for a, b in zip(before, drawn(fresh), strict=True))
    press(fresh, "distribution", "visible_ggx")
    lobe = np.array(fresh._lobe.actor.mapper.dataset.points)
    turn(fresh, "view", 80.0)
    assert fresh.controls.choice.distribution.view[0] == pytest.approx(np.sin(np.radians(80.0)))
    assert not np.array_equal(lobe, fresh._lobe.actor.mapper.dataset.points)
    for end in (-50.0, 50.0):  # beyond the slider's ends
        turn(fresh, "scalar", end)
        assert 0.05 <= fresh.controls.choice.distribution.alpha <= 1.0


def test_every_slider_goes_from_end_to_end(fresh):
    """Every distribution can be made, drawn and judged at both ends of what its slider shows."""
    for name in controls.spatial():
        kind = type(controls.made(name))
        for value in kind.shown or ():
            lobe = lobes.lobe_of(controls.with_scalar(controls.made(name), exp(log(value))))
            assert np.isfinite(lobe.surface).all()
            assert 0.5 < np.linalg.norm(lobe.surface, axis=-1).max() <= 1.0 + 1e-6


def test_a_double_click_chooses_the_point_under_the_mouse(fresh, bunny):
    """Its cloud becomes the enlarged one, in the same window; the clouds on the mesh stay."""
    on_mesh, near = drawn(fresh)
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
            assert weights.min() >= -1e-3  # the place is on the face
            assert fresh.chosen.normal[0] == pytest.approx(bunny.face_normals[fresh.chosen.face[0]])
    assert chosen > 5
    assert np.array_equal(drawn(fresh)[0], on_mesh)
    assert not np.array_equal(drawn(fresh)[1], near)
    before = fresh.chosen
    fresh.picker.click((1000, 300))  # on the charts
    assert fresh.chosen is before


def test_charts_follow_the_size_of_the_window(fresh):
    fresh.plotter.window_size = (1400, 800)
    fresh.show(fresh.controls.choice)
    assert fresh._charts.size == (round(0.46 * 1400), 800)
    fresh.plotter.window_size = (1200, 675)


def test_the_first_of_a_kind_says_that_it_compiles(fresh, monkeypatch):
    said = []
    monkeypatch.setattr(fresh.plotter, "render", lambda: said.append(fresh._says.input))
    press(fresh, "sequence", "philox")
    press(fresh, "sequence", "sobol")
    assert [words.startswith("compiling") for words in said] == [True, False, False]


def test_a_cloud_cut_by_the_budget_is_thinner_and_whole(can_render, bunny, monkeypatch):
    """The first part of a Fibonacci set would be a cap: every cloud's mean must stay at its sphere's centre."""
    monkeypatch.setattr(window.budgeted, "__defaults__", (2000,))
    choice = Choice(COSINE, sequence="fibonacci", samples=4096)
    made = window.Viewer(bunny, 4, choice, size=(1200, 675), off_screen=True)
    clouds = drawn(made)[0].reshape(4, 500, 3)
    centres = made.points.position + 0.5 * made.scale * made.points.normal
    # 500 lattice points are within 1/500 of the uniform sphere's mean; the first 500 of 4096 were off by 0.44.
    assert np.abs(clouds.mean(axis=1) - centres).max() <= 0.01 * made.scale
    assert "4 points x 500 directions (of 4 x 4,096 asked for)" in made._says.input
    made.plotter.close()


def test_ten_million_directions_are_a_bounded_picture(can_render, monkeypatch):
    """Of a mesh on a map of cities: drawn about its middle, where float32 keeps the clouds' shape."""
    box = trimesh.creation.box()
    mesh = ws.Mesh(box.vertices + np.array([5e6, 4e6, 100.0]), box.faces)
    made = window.Viewer(mesh, 10_000_000, Choice(COSINE, samples=1000), "z", (1200, 675), off_screen=True)
    on_mesh, near = drawn(made)
    assert (len(on_mesh), len(near)) == (1_000_000, 1000)
    assert "1,000,000 points x 1 directions (of 10,000,000 x 1,000 asked for)" in made._says.input
    assert "normals of 100,000 of them" in made._says.input
    assert np.abs(on_mesh).max() <= 0.5 + made.scale
    assert on_mesh.dtype == np.float32
    made.plotter.close()
