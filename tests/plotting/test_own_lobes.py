"""Lobes that differ from point to point: what is drawn of them, and what the map reports of right and wrong ones."""

from dataclasses import replace

import numpy as np
import pytest
from significance import ALPHA

import warpsample as ws
from warpsample.mesh.files.uv import find_uv
from warpsample.mesh.tangents import face_tangents
from warpsample.proof.twins import frames
from warpsample.viewer import clouds, controls, lobes, own_lobes, start, window
from warpsample.viewer.choice import Choice, format_distribution
from warpsample.viewer.counts import count_directions

ROUGH = np.linspace(0.05, 0.6, 60)
EYE = np.array([0.0, 0.0, 8.0])


def brushed(view=None):
    """A lobe of 60 points, each with its own roughness, anisotropy and, with a view, direction to the viewer."""
    return ws.GGX(ROUGH, ROUGH[::-1]) if view is None else ws.VisibleGGX(ROUGH, view, ROUGH[::-1])


@pytest.fixture(scope="module")
def facing(points):
    """60 points of the bunny that face the eye, whose view is at least 10 degrees above the surface."""
    rows = np.flatnonzero(points.to_local(EYE - points.position)[:, 2] > 0.17 * 8.0)
    return points.take(rows[:60])


def judged(right, wrong, facing, samples=1000, seed=3):
    """The counts of the directions of one lobe held against another."""
    choice = Choice(wrong, right, samples=samples, seed=seed)
    return clouds.count_clouds(choice, clouds.all_clouds(choice, facing, 1.0))


@pytest.mark.thorough
def test_right_lobes_agree_and_swapped_roughnesses_do_not(facing, plausible):
    """Also where points have the roughness of others, and where the view is mirrored at the normal.

    Whole lobes that are exchanged between points have the same sum, so the map cannot report them.
    """
    view = facing.to_local(EYE - facing.position)
    right = brushed(view)
    seen = judged(right, right, facing)
    for part in (seen.theta, seen.azimuth, seen.cells):
        plausible(part.test.p_value)
        assert part.verdict().startswith("agrees with visible_ggx")
    # 384 residuals of about standard normal size: the largest is above 6 once in 10^6 pictures.
    assert np.abs(seen.cells.residuals).max() < 6.0
    others = np.roll(ROUGH, 30)
    for wrong in (
        replace(right, alpha=right.alpha_y, alpha_y=right.alpha),
        replace(right, alpha=others, alpha_y=others[::-1]),
        brushed(view * np.array([-1.0, -1.0, 1.0])),
    ):
        seen = judged(right, wrong, facing)
        assert seen.cells.is_wrong
        assert seen.cells.verdict().startswith("does NOT agree")
        assert np.abs(seen.cells.residuals).max() > 6.0


def test_the_map_finds_what_both_histograms_miss():
    """Directions whose theta and phi are right, but independent of each other."""
    lobe, u = ws.GGX(0.1, 0.5), ws.sample_square("independent", 1, 60_000, seed=2)[0]
    right = lobe.sample(u).astype(np.float64)
    across, azimuth = np.hypot(right[:, 0], right[:, 1]), np.roll(np.arctan2(right[:, 1], right[:, 0]), 1)
    wrong = np.stack([across * np.cos(azimuth), across * np.sin(azimuth), right[:, 2]], axis=1)
    seen = count_directions(wrong, lobes.probabilities_of(lobe), independent=True)
    assert (seen.theta.is_wrong, seen.azimuth.is_wrong, seen.cells.is_wrong) == (False, False, True)


def test_an_azimuth_that_is_not_stretched_is_reported(plausible):
    """Slopes r (alpha cos phi, alpha_y sin phi): with the direction of (cos phi, sin phi) instead, as a renderer had it."""
    alpha, alpha_y = 0.1, 0.5
    u = ws.sample_square("independent", 1, 60_000, seed=2)[0].astype(np.float64)
    c, s = np.cos(2.0 * np.pi * u[:, 1]), np.sin(2.0 * np.pi * u[:, 1])
    length = np.sqrt(u[:, 0] / (1.0 - u[:, 0]))
    shapes = {True: np.stack([alpha * c, alpha_y * s]), False: np.hypot(alpha * c, alpha_y * s) * np.stack([c, s])}
    probabilities = lobes.probabilities_of(ws.GGX(alpha, alpha_y))
    for is_right, (x, y) in shapes.items():
        w = np.stack([length * x, length * y, np.ones_like(x)], axis=1)
        seen = count_directions(w / np.linalg.norm(w, axis=1, keepdims=True), probabilities, independent=True).cells
        assert seen.is_wrong != is_right
        if is_right:
            plausible(seen.test.p_value)


def test_symmetric_lobes_of_different_points_have_no_map(facing, plausible):
    seen = judged(ws.GGX(ROUGH), ws.GGX(ROUGH), facing)
    assert seen.cells is None
    plausible(seen.theta.test.p_value)
    assert judged(ws.GGX(ROUGH), ws.GGX(1.05 * ROUGH), facing).theta.is_wrong


def test_a_map_has_rows_of_almost_equal_solid_angle():
    probabilities = lobes.probabilities_of(ws.GGX(0.1, 0.5))
    u = ws.sample_square("sobol", 1, 4096)[0]
    seen = count_directions(ws.GGX(0.1, 0.5).sample(u), probabilities, independent=False).cells
    assert (seen.edges[0], seen.edges[-1]) == (1.0, pytest.approx(0.0, abs=1e-12))
    assert seen.observed.shape == (len(seen.edges) - 1, lobes.SECTORS)
    assert np.abs(-np.diff(seen.edges) * 16 - 1.0).max() < 0.6  # bins of theta are 2 degrees
    solid = -np.diff(seen.edges)[:, None] * 2.0 * np.pi / lobes.SECTORS
    assert (seen.observed * solid).sum() == pytest.approx(1.0)
    assert (seen.expected * solid).sum() == pytest.approx(1.0)


def test_views_point_to_the_camera_and_points_behind_have_no_directions(points, bunny):
    at = own_lobes.lobes_at(Choice(ws.VisibleGGX(0.3), samples=16), bunny, points, EYE)
    unit = (points.normal / np.linalg.norm(points.normal, axis=1, keepdims=True)).astype(np.float64)
    to_eye = EYE - points.position
    local = np.einsum("pij,pi->pj", frames(unit), to_eye / np.linalg.norm(to_eye, axis=1, keepdims=True))
    above = local[:, 2] > 1e-6
    assert np.abs(at.distribution.view[above] - local[above]).max() <= 1e-6
    drawn = clouds.all_clouds(at, points, 1.0)
    assert np.array_equal(drawn.rows, np.flatnonzero(at.distribution.view[:, 2] >= 0.0))
    assert 0 < len(drawn.rows) < len(points)
    assert len(drawn.position) == 16 * len(drawn.rows)
    # A choice whose view is given, and one without a view, stay as they are.
    fixed = Choice(ws.VisibleGGX(0.3, (0.6, 0.0, 0.8)), camera=False)
    assert own_lobes.lobes_at(fixed, bunny, points, EYE) is fixed
    assert own_lobes.lobes_at(Choice(ws.GGX(0.3)), bunny, points, EYE).distribution == ws.GGX(0.3)


def test_lobes_of_a_mixture_have_the_rows_and_views_of_points(points, bunny):
    rough = np.linspace(0.1, 0.9, len(bunny.vertices))
    mixed = ws.Mixture([ws.CosineHemisphere(), ws.Reflection(ws.VisibleGGX(rough), (0, 0, 1))], [0.5, 0.5])
    at = own_lobes.lobes_at(Choice(mixed), bunny, points, EYE).distribution.lobes[1]
    lone = own_lobes.lobes_at(Choice(ws.VisibleGGX(rough)), bunny, points, EYE).distribution
    assert at.lobe == lone
    assert np.array_equal(at.view, lone.view, equal_nan=True)
    kept = own_lobes.lobes_at(Choice(mixed, camera=False), bunny, points, EYE).distribution.lobes[1]
    assert (kept.view, len(kept.lobe.alpha)) == ((0.0, 0.0, 1.0), len(points))
    constant = own_lobes.constant_lobes(ws.Mixture([ws.GGX(np.array([0.25, 0.5]))], [1.0]))
    assert constant == [ws.Mixture([ws.GGX(alpha)], [1.0]) for alpha in (0.25, 0.5)]


def test_each_lobe_has_its_own_scale(facing):
    """A smooth point has a peak that is a hundred times as high, and a cloud of the same length."""
    choice = Choice(ws.GGX(ROUGH), samples=500)
    drawn = clouds.all_clouds(choice, facing, 2.0)
    length = np.linalg.norm(drawn.position.reshape(60, 500, 3) - facing.position[:, None], axis=-1)
    assert (length.max(axis=1) > 1.8).all()
    assert length.max() <= 2.0 * (1.0 + 1e-6)
    assert (drawn.color.reshape(60, 500) * 2.0).max(axis=1) == pytest.approx(length.max(axis=1), rel=0.02)


def test_clouds_lie_along_the_tangents(facing):
    """The directions of `sample_directions` at points with tangents, 25 times as wide along y as along x."""
    tangent = np.random.default_rng(5).normal(size=(60, 4))
    at, choice = facing.with_tangents(tangent), Choice(ws.GGX(0.02, 0.5), samples=256, seed=3)
    drawn = clouds.all_clouds(choice, at, 2.0)
    d = ws.sample_directions(at, 256, distribution=choice.distribution, sequence=choice.sequence, seed=3, pdf=True)
    assert np.array_equal(drawn.pdf, d.pdf.ravel())
    away = drawn.position.reshape(60, 256, 3) - at.position[:, None]
    assert np.abs(away - np.linalg.norm(away, axis=-1, keepdims=True) * d.vectors).max() <= 1e-5
    unit = at.normal / np.linalg.norm(at.normal, axis=1, keepdims=True)
    x = tangent[:, :3] - (tangent[:, :3] * unit).sum(axis=1, keepdims=True) * unit
    x /= np.linalg.norm(x, axis=1, keepdims=True)
    y = np.sign(tangent[:, 3:]) * np.cross(unit, x)
    local = np.stack([np.einsum("pnk,pk->pn", d.vectors, axis) for axis in (x, y, unit)], axis=-1)
    assert np.abs(drawn.local - local).max() <= 1e-6
    slopes = np.median(np.abs(local[..., :2] / local[..., 2:]), axis=1)
    assert (slopes[:, 1] > 15.0 * slopes[:, 0]).all()
    near = clouds.one_cloud(choice, at.take([7]), 7)
    assert np.array_equal(near.disk, drawn.local[7, :, :2])
    assert clouds.count_clouds(choice, drawn).cells.verdict().startswith("agrees with")


@pytest.fixture
def textured(tmp_path):
    """A file of three faces: u grows along (0, 1, 0) on the first; the second is mirrored, the third has no coordinates."""
    file = tmp_path / "faces.obj"
    corners = "v 0 0 0\nv 1 0 0\nv 0 1 0\n" * 3
    file.write_text(f"{corners}vt 0 0\nvt 1 0\nvt 0 1\nf 1/1 2/3 3/2\nf 4/1 5/2 6/3\nf 7 8 9\n")
    return file


def test_axes_of_a_file_follow_its_texture(textured):
    file, mesh = textured, ws.load_mesh(textured)
    uv = find_uv(file)
    found = ws.SurfacePoints(
        np.zeros((3, 3)), np.tile([0.0, 0.0, 1.0], (3, 1)), tangent=face_tangents(mesh, uv, np.arange(3))
    )
    assert found.to_local([0.0, 1.0, 0.0]).tolist()[:2] == [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]
    assert found.to_local([1.0, 0.0, 0.0]).tolist()[:2] == [[0.0, 1.0, 0.0], [1.0, 0.0, 0.0]]
    assert ws.sample_directions(found, 4).status.tolist() == [0, 0, ws.Status.INVALID_TANGENT]
    assert find_uv(start.bunny()) is None


def test_options_of_the_command_line():
    """The camera is the viewer unless a view is given; an array has rows of vertices or faces."""
    made = start.choice("visible_ggx(alpha=@r)", None, "sobol", 64, 0, arrays={"r": ROUGH}.get)
    assert made.camera
    assert format_distribution(made.distribution, made.camera) == "visible_ggx(alpha=0.05 to 0.6, view=camera)"
    assert start.choice("visible_ggx(alpha=@r, view=@camera)", None, "sobol", 64, 0, arrays={"r": ROUGH}.get) == made
    assert not start.choice("visible_ggx(alpha=0.3, view=(0, 0, 1))", None, "sobol", 64, 0).camera
    with pytest.raises(ValueError, match=r"^distribution: got alpha with 60 rows, want 1,089 \(vertices\) or 2,080"):
        own_lobes.check_rows(made, ws.load_mesh("courtyard"))


def test_the_menu_has_all_that_can_be_made_without_arrays():
    made = {name: controls.make_distribution(name) for name in controls.spatial_names()}
    assert {"reflection", "visible_ggx", "ggx", "uniform_sphere"} <= set(made)
    assert not {"environment_map", "spherical_triangle", "uniform_disk"} & set(made)
    with pytest.raises(ValueError, match=r"^distribution: got EnvironmentMap.*, which ignores the normals"):
        start.choice("environment_map(picture=@sky)", None, "sobol", 64, 0, arrays={"sky": np.ones((4, 8))}.get)


@pytest.fixture(scope="module")
def viewer(can_render, bunny):
    """A window whose camera is the viewer of lobes by vertex."""
    alpha = np.linspace(0.1, 0.5, len(bunny.vertices))
    made = window.Viewer(bunny, 30, Choice(ws.VisibleGGX(alpha), samples=200), size=(1200, 675), off_screen=True)
    made.plotter.show(auto_close=False, interactive=False)
    yield made
    made.plotter.close()


def look(viewer, position):
    viewer.plotter.renderers[1].camera.position = position
    viewer.plotter.render()


def test_clouds_follow_the_camera(viewer):
    start_at = viewer.plotter.renderers[1].camera.position
    before, near, counts = viewer.clouds, viewer.near, viewer.counts
    shown = np.array(viewer.cloud_actor.actor.mapper.dataset.points)
    viewer.plotter.render()
    assert viewer.clouds is before  # a frame of the same camera costs nothing
    look(viewer, (start_at[0] + 0.3 * start_at[2], start_at[1], start_at[2]))
    assert not np.array_equal(viewer.cloud_actor.actor.mapper.dataset.points, shown)
    assert not np.array_equal(viewer.near.lobe.view, near.lobe.view)
    assert viewer.counts is not counts
    assert viewer.counts.cells.verdict().startswith("agrees with its own density")
    assert viewer.counts.cells.test.p_value >= ALPHA
    assert f"{30 - len(viewer.clouds.rows)} points face away from the camera" in viewer.caption.input
    look(viewer, start_at)
    assert np.array_equal(viewer.cloud_actor.actor.mapper.dataset.points, shown)


def test_charts_wait_until_the_model_stands_still(viewer):
    start_at = viewer.plotter.renderers[1].camera.position
    style = viewer.plotter.iren.interactor.GetInteractorStyle()
    counts, drawn = viewer.counts, viewer.clouds
    style.StartRotate()
    look(viewer, (start_at[2], start_at[1], start_at[0]))
    assert viewer.clouds is not drawn
    assert viewer.counts is counts
    style.EndRotate()
    viewer.plotter.render()
    assert viewer.counts is not counts
    look(viewer, start_at)


def test_lobes_of_a_textured_mesh_lie_along_u(can_render, bunny):
    """Coordinates by projection along z: u grows along the part of x on each face; also at a point that is pinned later."""
    uv = bunny.vertices[bunny.faces][..., :2] * [1.0, -1.0]
    choice = Choice(ws.GGX(0.02, 0.5), samples=64)
    made = window.Viewer(bunny, 30, choice, size=(1200, 675), off_screen=True, uv=uv)
    made.show(Choice(ws.GGX(0.02), samples=64))
    assert "x of the lobes" not in made.caption.input
    bare = replace(made.points, tangent=None)
    d = ws.sample_directions(bare, 64, distribution=ws.GGX(0.02), sequence=choice.sequence)
    assert np.array_equal(made.clouds.local, bare.to_local(d.vectors))
    made.show(choice)
    made.pick(made.points.position[3], int(made.points.face[3]))
    made.plotter.close()
    assert "x of the lobes: along u of the texture coordinates" in made.caption.input
    normal, tangent = made.points.normal.astype(np.float64), made.points.tangent
    corners = bunny.vertices[bunny.faces[made.points.face]]
    along = np.cross(normal, [0.0, 1.0, 0.0])  # x grows along the face where y does not
    along *= np.sign(along[:, :1]) / np.linalg.norm(along, axis=1, keepdims=True)
    assert np.abs(np.einsum("pk,pk->p", corners[:, 1] - corners[:, 0], normal)).max() < 1e-6 * bunny.diagonal
    assert np.abs(tangent[:, :3] - along).max() < 1e-4
    assert np.array_equal(tangent[:, 3], np.where(normal[:, 2] > 0.0, 1.0, -1.0))
    d = ws.sample_directions(made.points, 64, distribution=choice.distribution, sequence=choice.sequence)
    assert np.array_equal(made.clouds.local, made.points.to_local(d.vectors))
    assert np.array_equal(made.chosen.tangent, tangent[3:4])


def test_a_pinned_point_that_faces_away_has_no_cloud(viewer):
    start_at = viewer.plotter.renderers[1].camera.position
    look(viewer, tuple(-np.array(start_at)))
    assert viewer.near is None
    assert not viewer.near_actor.actor.GetVisibility()
    viewer.plotter.screenshot(return_img=True)
    look(viewer, start_at)
    assert viewer.near_actor.actor.GetVisibility()


def test_the_command_draws_lobes_by_vertex(can_render, call, bunny, tmp_path):
    file, arrays = tmp_path / "own.png", tmp_path / "arrays.npz"
    np.savez(arrays, rough=np.linspace(0.1, 0.5, len(bunny.vertices)), short=ROUGH)
    options = ["--points", 10, "--samples", 100, "--size", 1200, 675, "--screenshot", file, "--arrays", arrays]
    status, out, err = call("view", "--distribution", "visible_ggx(alpha=@rough)", *options)
    assert (status, err) == (0, "")
    assert out.startswith(f"{file}: 10 points x 100 directions of visible_ggx(alpha=0.1 to 0.5, view=camera); θ agrees")
    assert "; (θ, φ) agrees with its own density" in out
    status, _, err = call("view", "--distribution", "ggx(alpha=@short)", *options)
    assert (status, err.split(",")[0]) == (2, "error: --distribution: got alpha with 60 rows")
    status, _, err = call("view", "--distribution", "ggx(alpha=@none)", *options)
    assert (status, err.split(",")[0]) == (2, "error: --distribution: got the array name @none")


def test_the_command_reads_texture_coordinates(can_render, call, textured, tmp_path, monkeypatch):
    def describe(*drawn, uv, **_):
        return f"{drawn[1]} {drawn[2].distribution}, {uv}"

    monkeypatch.setattr(start, "save", describe)
    options = ["--points", 7, "--screenshot", tmp_path / "own.png"]
    for lobe in (ws.GGX(0.02, 0.5), ws.GGX(0.02)):  # a menu may change the second one
        name = repr(lobe).replace("GGX", "ggx")
        said = f"{options[-1]}: 7 {lobe}, {ws.load_uv(textured)}\n"
        assert call("view", textured, "--distribution", name, *options) == (0, said, "")
