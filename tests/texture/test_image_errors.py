"""Errors of texels whose rays all agree, although a small plate hides a part of the sky."""

import dataclasses
from types import SimpleNamespace

import numpy as np
import pytest

import warpsample as ws
from warpsample.estimate.intervals import half_width_of, least_errors, raised_errors

SIDE = 16


def floor_below_a_plate():
    """A floor of 4 x 4, which fills the image, and a plate of 0.4 x 0.4 at a height of 0.7 without coordinates."""
    square = np.array([(-1, -1), (1, -1), (1, 1), (-1, 1)], float)
    vertices = np.pad(np.concatenate([2.0 * square, 0.2 * square + 0.3]), ((0, 0), (0, 1)))
    vertices[4:, 2] = 0.7
    faces = np.array([[0, 1, 2], [0, 2, 3], [4, 6, 5], [4, 7, 6]])
    uv = np.full((4, 3, 2), np.nan)
    uv[:2] = (0.5 + 0.5 * square)[faces[:2]]
    return ws.Mesh(vertices, faces), uv


def floor():
    mesh, uv = floor_below_a_plate()
    return ws.Mesh(mesh.vertices[:4], mesh.faces[:2]), uv[:2]


def test_two_errors_contain_the_truth_where_all_rays_agree():
    """Before, the error was 0 in 195 of 256 texels, half of them with a wrong value. Other errors keep their size."""
    mesh, uv = floor_below_a_plate()
    t = ws.texture_points(mesh, uv, SIDE)
    truth = t.image(ws.ambient_occlusion(mesh, t.points, 1 << 13, seed=9).value)
    found = ws.ambient_occlusion(mesh, t.points, 64)
    own, error = t.image(found.standard_error), t.image_error(found)
    wrong = np.abs(t.image(found.value) - truth)
    assert ((own == 0.0) & (wrong > 0.002)).sum() > 80
    assert (error > 0.0).all()
    assert (wrong <= 2.0 * error).mean() > 0.97
    assert error.max() < 0.07  # at most 3.7 of 64 rays: a 95 % interval by the counts
    ordinary = own > 0.0
    assert np.sqrt(np.mean(error[ordinary] ** 2)) < 1.03 * np.sqrt(np.mean(own[ordinary] ** 2))
    assert np.array_equal(t.image_error(found.standard_error), own)  # nothing is known of rays


@pytest.mark.parametrize("samples", [2, 4])
def test_equal_samples_of_a_texel_have_an_error(samples):
    mesh, uv = floor_below_a_plate()
    t, fine = (ws.texture_points(mesh, uv, SIDE, samples=many) for many in (samples, 64))
    truth = fine.image(ws.ambient_occlusion(mesh, fine.points, 64, seed=9).value)
    found = ws.ambient_occlusion(mesh, t.points, 16)
    error = t.image_error(found)
    assert (error > 0.0).all()
    assert (np.abs(t.image(found.value) - truth) <= 2.0 * error + 0.004).mean() > 0.97  # error of the truth
    assert error.min() <= 1.01 * 1.64 / 16 / samples  # of one ray among all rays of the texel


def test_points_without_rays_keep_an_error_of_0():
    mesh, uv = floor_below_a_plate()
    t = ws.texture_points(mesh, uv, SIDE)
    found = ws.ambient_occlusion(mesh, t.points, 64)
    rays = np.where(np.arange(len(t)) % 2, found.rays, 0).astype(np.int32)
    some = dataclasses.replace(found, rays=rays)
    error = raised_errors(some)
    assert np.array_equal(error[rays == 0], found.standard_error[rays == 0])
    agree = (rays > 0) & (found.standard_error == 0.0)
    assert np.array_equal(error[agree], least_errors(half_width_of(found))[agree])
    vectors = raised_errors(ws.bent_normals(mesh, t.points, 64))
    assert vectors.shape == (len(t), 3)
    assert (vectors > 0.0).all()


@pytest.mark.parametrize("transmittance", [None, 0.3])
@pytest.mark.parametrize("tilt", [30, 90, 135, 160])
def test_slopes_below_an_open_sky_have_errors(tilt, transmittance):
    """No ray is cast, but rays below the horizon count as blocked. The error was 0 in 9 to 49 % of the texels, and wrong.

    Among leaves it was also 0 where all rays are below the horizon.
    """
    ground, uv = floor()
    ground = ground if transmittance is None else ws.as_mesh(ground, transmittance=transmittance)
    angle = np.radians(tilt)
    up = (0.0, np.sin(angle), np.cos(angle))
    t = ws.texture_points(ground, uv, 64)
    for count in (16, 64, 256):
        for call, truth in ((ws.sky_view_factor, 0.5 + 0.5 * np.cos(angle)), (ws.visible_sky, 1.0 - tilt / 180.0)):
            found = call(ground, t.points, count, up=up)
            error, wrong = t.image_error(found), np.abs(t.image(found.value) - truth)
            assert (error > 0.0).all()
            assert (wrong <= 2.0 * error + 1e-6).mean() > 0.83  # 1e-6 for float32; 0.84 at 30 degrees with 256 rays


def test_flat_ground_below_an_open_sky_has_no_error():
    ground, uv = floor()
    t = ws.texture_points(ground, uv, SIDE)
    for call in (ws.sky_view_factor, ws.ambient_occlusion, ws.mean_distance):
        assert not t.image_error(call(ground, t.points, 64)).any()
    down = t.image_error(ws.sky_view_factor(ground, t.points, 64, up=(0, 0, -1)))
    assert down.max() < 1e-7  # float32


def test_ground_a_little_out_of_level_has_a_small_error():
    """All rays go up, and what is below the horizon is known: 1e-6. The error was once that of a missed ray, 0.026."""
    ground, uv = floor()
    t = ws.texture_points(ground, uv, SIDE)
    found = ws.sky_view_factor(ground, t.points, 64, up=(0.002, 0, 1))
    assert (found.value == 1.0).all()
    assert np.array_equal(t.image_error(found), t.image(found.below_horizon))


def test_light_of_an_open_sky_has_the_errors_of_cast_rays():
    """A bright cap: with 16 rays 44 % of the texels of a wall had an error of 0 and a wrong value, here 6 %."""
    wall, uv = floor()
    t = ws.texture_points(wall, uv, SIDE)
    sky = np.zeros((64, 128))
    sky[:16] = 1.0
    for sampling in ("cosine", "both"):
        errors = [
            t.image_error(ws.irradiance(wall, t.points, sky, 16, up=(1, 0, 0), sampling=sampling, skip=skip))
            for skip in (True, False)
        ]
        assert np.array_equal(*errors)
        assert (errors[0] > 0.0).mean() > 0.9


def test_samples_of_a_texel_share_the_error_of_reflected_light():
    """The spread within a texel does not contain it: of 200 runs, two errors would contain the truth in 1 of 4."""
    mesh, uv = floor_below_a_plate()
    t = ws.texture_points(mesh, uv, 4, samples=16)
    sky = ws.irradiance(ws.as_mesh(mesh, reflectance=0.5), t.points, np.ones((2, 4)), 16)
    rng, within, without = np.random.default_rng(1), [], []
    for _ in range(200):
        own, shared = rng.normal(0.0, 0.1, len(t)), rng.normal(0.0, np.sqrt(8) * 0.2, 8)  # of one run
        runs = np.tile(shared.astype(np.float32), (len(t), 1, 1))
        found = dataclasses.replace(sky, value=own + shared.mean(), standard_error=np.full(len(t), 0.1), reflected_runs=runs)
        wrong = np.abs(t.image(found.value))
        within.append((wrong <= 2.0 * t.image_error(found)).mean())
        without.append((wrong <= 2.0 * t.image_error(dataclasses.replace(found, reflected=None))).mean())
    assert 0.88 < np.mean(within) < 0.95  # eight runs: 91.4 % by Student's t, uncertain by 0.02
    assert np.mean(without) < 0.3
    with pytest.raises(ValueError, match="^errors: got a series of light that faces reflect, want the light of the whole"):
        t.image_error(dataclasses.replace(found, reflected_runs=None))  # as with series=True


def test_sun_hours_of_a_texel_have_an_error_where_its_samples_agree():
    """A shadow may fall between them. The error was 0 in half of the texels, and wrong by up to 129 hours."""
    mesh, uv = floor_below_a_plate()
    options = {"period": ("06-01", "06-30"), "up": (0, 0, 1), "north": (0, 1, 0)}
    t = ws.texture_points(mesh, uv, SIDE, samples=4)
    found = ws.sun_hours(mesh, t.points, "athens", **options)
    needs = t.image(found.unseen_error) > 0.0
    assert needs.mean() > 0.1
    assert (t.image_error(found)[needs] >= 0.5 / 4).all()
    single = ws.texture_points(mesh, uv, SIDE)
    assert not single.image_error(ws.sun_hours(mesh, single.points, "athens", **options)).any()


def test_the_command_adds_the_shared_error_too(call, tmp_path):
    mesh, uv = floor_below_a_plate()
    corners = "".join(f"vt {u} {1.0 - v}\n" for u, v in np.nan_to_num(uv[:, :, :2].reshape(-1, 2), nan=5.0))
    faces = [" ".join(f"{v + 1}/{3 * i + k + 1}" for k, v in enumerate(face)) for i, face in enumerate(mesh.faces)]
    vertices = "".join(f"v {x} {y} {z}\n" for x, y, z in mesh.vertices)
    path, sky = tmp_path / "a.obj", tmp_path / "sky.npy"
    path.write_text(vertices + corners + "".join(f"f {face}\n" for face in faces))
    np.save(sky, np.ones((2, 4, 3)))
    options = ("--texture", 4, "--uv", "0", "--supersample", 4, "--samples", 64, "--reflectance", 0.9, "--environment", sky)
    status, _, err = call("bake", path, "-o", tmp_path / "a.npz", "--quantity", "irradiance", *options, "--up", 0, 0, 1)
    assert (status, err) == (0, "")
    bright = ws.as_mesh(ws.load_mesh(path), reflectance=0.9)
    t = ws.texture_points(bright, uv, 4, samples=4)
    found = ws.irradiance(bright, t.points, np.ones((2, 4, 3)), 16, up=(0, 0, 1))
    with np.load(tmp_path / "a.npz") as file:
        assert np.array_equal(file["value"], t.image(found.value))
        assert np.array_equal(file["standard_error"], t.image_error(found))


def test_errors_in_files_are_raised(call, tmp_path):
    vertices, faces = (getattr(floor_below_a_plate()[0], name) for name in ("vertices", "faces"))
    path, output = tmp_path / "a.obj", tmp_path / "a.npz"
    corners = "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvt 5 5\n"
    lines = [f"f {' '.join(f'{v + 1}/{v + 1 if v < 4 else 5}' for v in face)}\n" for face in faces]
    path.write_text("".join(f"v {x} {y} {z}\n" for x, y, z in vertices) + corners + "".join(lines))
    command = ("bake", path, "-o", output, "--texture", SIDE, "--uv", "0", "--samples", 32)
    for options in ((), ("--supersample", 2)):
        assert call(*command, *options)[0] == 0
        with np.load(output) as file:
            assert (file["standard_error"] > 0.0).all()


@pytest.mark.parametrize("samples", [1, 4])
def test_a_texel_without_a_value_has_the_error_of_the_texel_that_fills_it(samples):
    """One sample per texel kept its own error, 0 of faces without area."""
    mesh, uv = floor_below_a_plate()
    t = ws.texture_points(mesh, uv, SIDE, samples=samples)
    found = ws.ambient_occlusion(mesh, t.points, 16)
    lost = t.texel == t.texel[len(t) // 2]
    value, error = np.where(lost, np.nan, found.value), np.where(lost, 99.0, found.standard_error)
    filled = t.image_error(dataclasses.replace(found, value=value, standard_error=error))
    assert 0.0 < filled.max() < 0.3
    wants = r"^errors: got \(\d+, 3\) standard errors of \(\d+,\) values, want equal shapes$"
    with pytest.raises(ValueError, match=wants):
        t.image_error(dataclasses.replace(found, standard_error=np.ones((len(t), 3))))


@pytest.mark.parametrize("samples", [1, 4])
def test_infinite_errors_of_finite_values_stay_infinite(samples):
    """One sample per texel gave 0, or the error of a neighbour. NaN is a point without a value."""
    mesh, uv = floor_below_a_plate()
    t = ws.texture_points(mesh, uv, SIDE, samples=samples)
    column = t.texel % SIDE
    error = np.where(column < 4, np.inf, np.where(column < 6, np.nan, 0.25))
    value = np.where(column == 5, np.inf, 1.0)
    found = t.image_error(SimpleNamespace(value=value, standard_error=error))
    known = column[column >= 6]
    assert np.isinf(found[:, :4]).all()
    assert np.array_equal(found[:, known], np.full((SIDE, len(known)), np.float32(0.25 / samples)))
    assert np.isinf(t.image_error(SimpleNamespace(value=np.ones(len(t)), standard_error=np.full(len(t), np.inf)))).all()
    if samples == 1:
        assert np.array_equal(t.image_error(error), found)
        assert np.array_equal(found[:, 4:6], np.broadcast_to(np.float32([np.inf, 0.25]), (SIDE, 2)))
        errors = np.stack([error, np.where(column == 8, np.inf, 0.5)], axis=1)
        found = t.image_error(errors)
        assert np.array_equal(found[0, 8], np.float32([0.25, np.inf]))
        assert np.isinf(found[:, :4, 0]).all()
        assert (found[:, :4, 1] == 0.5).all()
