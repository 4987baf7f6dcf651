"""Directions towards a picture: each class of pixels is drawn as often as its light says, and bad pictures are refused."""

import pickle

import numpy as np
import pytest
import warp as wp
from significance import ALPHA

import warpsample as ws
from warpsample import funcs
from warpsample.distributions.lights.pixel_table import FEW_STEPS, MOST_STEPS, divide_steps, read_steps
from warpsample.proof import laws
from warpsample.statistics.histogram import histogram_test

UP = np.tile(np.float32([0.0, 0.0, 1.0]), (1, 1))


def solid_angles(height, width):
    """The (H, 1) solid angles of pixels, by another formula than the package's: differences of cosines."""
    edges = np.cos(np.pi * np.arange(height + 1) / height)
    return (edges[:-1] - edges[1:])[:, None] * 2.0 * np.pi / width


def hostile(height=64, width=128):
    """A dim sky with a sun of contrast 1e6, black rows, black pixels beside the sun, and a row of one dim pixel."""
    picture = np.random.default_rng(3).random((height, width)) + 0.5
    picture[20, 30] = 1e6
    picture[20, 31] = picture[20, 29] = 0.0
    picture[40:44] = 0.0
    picture[50] = 0.0
    picture[50, 7] = 1e-3
    return picture


def pixels_of(picture, w):
    """The (row, column) of world directions in the default layout, by float64 angles."""
    height, width = picture.shape
    w = w.astype(np.float64)
    theta = np.arctan2(np.hypot(w[..., 0], w[..., 1]), w[..., 2])
    turns = np.arctan2(w[..., 1], w[..., 0]) / (2.0 * np.pi) % 1.0
    row, column = (theta * height / np.pi).astype(int), (turns * width).astype(int)
    return np.minimum(row, height - 1), np.minimum(column, width - 1)


def independent(picture, points, count=1024, seed=0, **orientation):
    """Vectors (N, 3) and densities (N,) of independent draws."""
    lobe = ws.EnvironmentMap(picture, **orientation)
    normals = np.tile(UP, (points, 1))
    d = ws.sample_directions(normals, count, distribution=lobe, sequence="independent", seed=seed, pdf=True)
    return d.vectors.reshape(-1, 3), d.pdf.ravel()


def judge_classes(points, sun):
    """Compare the draws of each class of pixels, and of each pixel with enough draws, with their share of the light."""
    picture = hostile()
    picture[20, 30] = sun
    height, width = picture.shape
    share = picture * solid_angles(height, width)
    share /= share.sum()
    kinds = np.ones(picture.shape, int)
    kinds[[0, -1]] = 2  # polar rows
    kinds[20] = 3  # dark pixels in the sun's row
    kinds[20, 30] = 4  # the sun
    kinds[picture == 0.0] = 0
    counts, drawn = np.zeros(5), np.zeros(picture.shape)
    step = 4096
    for first in range(0, points, step):
        w, pdf = independent(picture, min(step, points - first), seed=first)
        row, column = pixels_of(picture, w)
        counts += np.bincount(kinds[row, column], minlength=5)
        drawn += np.bincount(row * width + column, minlength=height * width).reshape(height, width)
        # Shares are multiples of 2^-32 of a row: 1e-3 of a dark pixel beside the sun, and 1e-6 of most others.
        exact = (share / solid_angles(height, width))[row, column]
        assert np.abs(pdf / exact - 1.0).max() <= 3e-3
        assert np.median(np.abs(pdf / exact - 1.0)) <= 1e-6
    total = counts.sum()
    assert counts[0] == 0
    for kind in range(1, 5):
        assert laws.count_p_value(counts[kind], total, share[kinds == kind].sum()) >= ALPHA
    full = share * total >= 10.0
    assert full.any()
    if full.sum() > 1:
        inside = share[full] * drawn[full].sum() / share[full].sum()
        assert histogram_test(drawn[full], inside).p_value >= ALPHA


@pytest.mark.parametrize("sun", [pytest.param(300.0, marks=pytest.mark.thorough), 1e6])
def test_each_class_of_pixels_is_drawn_by_its_light(sun):
    judge_classes(4096, sun)


@pytest.mark.thorough
@pytest.mark.parametrize("sun", [300.0, 1e6])
def test_each_class_of_pixels_is_drawn_by_its_light_in_1e8_draws(sun):
    judge_classes(100_000, sun)


def test_the_mean_of_1_over_the_density_is_the_solid_angle_of_the_support():
    """Without the sun, whose pixel would be drawn nearly always: 4e6 draws measure the support to 0.2 %."""
    picture = hostile()
    picture[20, 30] = 1.0
    _, pdf = independent(picture, 4096)
    support = float((solid_angles(*picture.shape) * (picture > 0.0)).sum())
    weights = 1.0 / pdf.astype(np.float64)
    error = weights.std() / np.sqrt(len(weights))
    assert abs(weights.mean() - support) <= 5.0 * error
    assert error < 0.003 * support


@pytest.mark.parametrize(("height", "width"), [(1, 1), (1, 7), (6, 1), (64, 128), (1024, 2048)])
def test_a_constant_picture_is_the_uniform_sphere(height, width):
    lobe = ws.EnvironmentMap(np.full((height, width), 0.37))
    u = ws.sample_square("sobol", 4, 4096).reshape(-1, 2)
    w = lobe.sample(u)
    # Shares are multiples of 2^-32: 2,048 columns leave 5e-7 of a share.
    assert np.abs(lobe.pdf(w) * 4.0 * np.pi - 1.0).max() <= 1e-6
    uniform = ws.UniformSphere().sample(u).astype(np.float64)
    inner = np.abs(uniform[:, 2]) < 0.99
    # The bits below 2^-24 move u by 6e-8, and a direction by that times the circumference; by more at the poles.
    assert laws.angle_error(w[inner].astype(np.float64), uniform[inner]) <= 2e-6
    assert laws.angle_error(w.astype(np.float64), uniform) <= 1e-3


def test_shares_of_rows_and_pixels_are_those_of_the_light():
    picture = hostile()
    rows, columns = ws.EnvironmentMap(picture).shares()
    light = (picture * solid_angles(*picture.shape)).sum(axis=1)
    assert np.diff(rows) == pytest.approx(light / light.sum(), rel=1e-6, abs=1e-14)
    lit = light > 0.0
    exact = picture[lit] / picture[lit].sum(axis=1, keepdims=True)
    # A step of 2^-32 for each of 128 pixels, which the sun gives, and the rounding of luminances to float32.
    assert np.abs(np.diff(columns[lit]) - exact).max() <= 130 * 2.0**-32 + 2.0**-24 * exact.max()
    assert np.array_equal(np.diff(columns) > 0.0, picture > 0.0)  # black pixels have no share, all others have one


@pytest.mark.parametrize("weights", [[1.0, 0.0, 1e-30, 1e30], [0.0, 0.0, 0.0], [5e-324, 0.0, 1.0], [3.0]])
def test_steps_are_whole_and_reach_every_weight_above_0(weights):
    ends = divide_steps(np.array([weights]), 2**32 - 1)[0]
    assert ends[0] == 0
    assert ends[-1] == (2**32 - 1 if any(weights) else 0)
    assert np.array_equal(np.diff(ends) >= 1, np.array(weights) > 0.0)
    assert np.array_equal(ends, np.rint(ends))


def test_a_single_bright_pixel_is_always_drawn():
    picture = np.zeros((1024, 2048))
    picture[700, 2047] = 1e-30
    w, pdf = independent(picture, 64)
    row, column = pixels_of(picture, w)
    assert (row == 700).all()
    assert (column == 2047).all()
    assert pdf == pytest.approx(1.0 / solid_angles(1024, 2048)[700, 0], rel=1e-6)


def test_strata_of_the_square_are_strata_of_the_light():
    """1,024 Sobol' points have one point in each of 32 x 32 cells, so 32 in each 32nd of the light, by rows."""
    picture = hostile()
    picture[20, 30] = 3.0
    lobe = ws.EnvironmentMap(picture)
    rows, _ = lobe.shares()
    back = lobe.invert(lobe.sample(ws.sample_square("sobol", 1, 1024)[0]))
    counts, _ = np.histogram(back[:, 0], np.arange(33) / 32.0)
    assert np.abs(counts - 32).max() <= 1  # rounding moves a point across an edge
    assert rows[0] == 0.0
    assert rows[-1] == 1.0


@pytest.mark.parametrize(("up", "north"), [((0, 0, 1), (0, 1, 0)), ((0, 2, 0), (0, 0, -3)), ((1, -2, 0.5), (0.3, 1, 1))])
def test_up_and_north_turn_the_picture(up, north):
    """Row 0 is about up; column 0 begins at north x up, and columns go round up counter-clockwise."""
    picture = np.zeros((8, 16))
    picture[1, 3] = 1.0
    z = np.array(up) / np.linalg.norm(up)
    x = np.cross(north, z)
    x /= np.linalg.norm(x)
    theta, phi = 1.5 * np.pi / 8, 3.5 * 2.0 * np.pi / 16
    middle = np.sin(theta) * (np.cos(phi) * x + np.sin(phi) * np.cross(z, x)) + np.cos(theta) * z
    lobe = ws.EnvironmentMap(picture, up=up, north=north)
    assert lobe.sample(np.array([[0.5, 0.5]]))[0] == pytest.approx(middle, abs=0.03)  # rows are even in solid angle
    assert lobe.pdf(middle[None])[0] == pytest.approx(1.0 / solid_angles(8, 16)[1, 0], rel=1e-6)
    assert lobe.pdf(-middle[None])[0] == 0.0
    edges = np.cos(np.pi * np.arange(1, 3) / 8)
    assert lobe.invert(middle[None])[0] == pytest.approx([(edges[0] - np.cos(theta)) / (edges[0] - edges[1]), 0.5], abs=1e-6)


def test_without_north_the_layout_is_that_of_irradiance():
    """irradiance reads bilinearly: at the middles of pixels the two agree."""
    picture = np.random.default_rng(1).random((4, 8)) + 0.1
    for up in ((0.0, 0.0, 1.0), (0.6, 0.0, -0.8), (0.0, 1.0, 0.0)):
        lobe = ws.EnvironmentMap(picture, up=up)
        w = lobe.sample(ws.sample_square("sobol", 1, 256)[0])
        density = picture / (picture * solid_angles(4, 8)).sum()
        far = ws.as_mesh((np.array([[0, 0, 99.0], [1, 0, 99.0], [0, 1, 99.0]]), np.array([[0, 1, 2]])))
        for d in w[:8]:  # a sky that is lit in the pixel drawn alone, seen from two boards that face it and turn away
            lit = np.zeros_like(picture)
            lit.flat[np.argmin(np.abs(lobe.pdf(d[None])[0] - density))] = 1.0
            boards = ws.SurfacePoints(position=np.zeros((2, 3), np.float32), normal=np.stack([d, -d]))
            facing, turned = ws.irradiance(far, boards, lit, 4096, up=up).value
            assert facing > 0.05 > 2.0 * turned


def test_directions_do_not_depend_on_the_normal_and_bad_normals_are_counted():
    lobe = ws.EnvironmentMap(hostile())
    normals = np.random.default_rng(0).normal(size=(64, 3)).astype(np.float32)
    for count in (5, 64):
        d = ws.sample_directions(normals, count, distribution=lobe, pdf=True)
        same = ws.sample_directions(np.tile(UP, (64, 1)), count, distribution=lobe, pdf=True)
        assert np.array_equal(d.vectors, same.vectors)
        assert np.array_equal(d.pdf, same.pdf)
        u = ws.sample_square("sobol", 64, count)
        assert np.array_equal(lobe.sample(u), d.vectors)
        assert np.array_equal(lobe.pdf(d.vectors), d.pdf)
    points = ws.SurfacePoints(np.zeros((64, 3), np.float32), normals).with_tangents(np.ones(3))
    turned = ws.sample_directions(points, 64, distribution=lobe, pdf=True)
    assert np.array_equal(turned.vectors, d.vectors)
    normals[3] = 0.0
    assert ws.sample_directions(normals, 4, distribution=lobe).counts()[ws.Status.ZERO_NORMAL] == 1


def test_the_density_of_a_turned_hostile_picture_is_that_of_the_pixel_drawn():
    """A direction is rounded, and may be looked up in the next pixel only about the poles of a picture of many columns."""
    picture = np.random.default_rng(5).random((1024, 2048)).astype(np.float32)
    picture[picture < 0.2] = 0.0
    picture[300, 77] = 1e6
    w, pdf = independent(picture, 1024, up=(0.3, -0.5, 0.8), north=(1.0, 0.2, 0.1))
    assert (ws.EnvironmentMap(picture, up=(0.3, -0.5, 0.8), north=(1.0, 0.2, 0.1)).pdf(w) != pdf).mean() <= 1e-5
    assert (pdf > 0.0).all()


@pytest.mark.slow
def test_the_largest_pictures_are_drawn_from():
    picture = np.ones((4096, 8192), np.float32)
    picture[1000, 4000] = 1e6
    lobe = ws.EnvironmentMap(picture)
    share = 1e6 * solid_angles(4096, 8192)[1000, 0]
    share /= share + 4.0 * np.pi - share * 1e-6
    d = ws.sample_directions(np.tile(UP, (1024, 1)), 1024, distribution=lobe, sequence="independent", pdf=True)
    row, column = pixels_of(picture, d.vectors)
    assert laws.count_p_value(int(((row == 1000) & (column == 4000)).sum()), row.size, share) >= ALPHA


def test_a_picture_is_copied_and_a_lobe_is_a_value():
    picture = hostile()
    lobe = ws.EnvironmentMap(picture, up=(0, 0, 2))
    before = lobe.sample(np.array([[0.3, 0.6]]))
    picture[:] = 1.0
    assert np.array_equal(lobe.sample(np.array([[0.3, 0.6]])), before)
    same = ws.EnvironmentMap(hostile())
    assert lobe == same
    assert hash(lobe) == hash(same)
    assert lobe != ws.EnvironmentMap(picture)
    assert lobe != ws.EnvironmentMap(hostile(), north=(0, 1, 0))
    assert len(repr(lobe)) < 100
    assert not lobe.picture.flags.writeable
    lobe.table  # noqa: B018  (the table is made)
    sent = pickle.dumps(lobe)
    assert len(sent) < 1.1 * lobe.picture.nbytes + 1000
    back = pickle.loads(sent)
    assert back == lobe
    assert np.array_equal(back.sample(np.array([[0.3, 0.6]])), before)


def test_new_pictures_compile_nothing(monkeypatch):
    u = np.array([[0.3, 0.6]])
    ws.EnvironmentMap(hostile()).sample(u)
    monkeypatch.setattr(wp, "load_module", None)
    monkeypatch.setattr("warpsample.host.kernel_cache._build", None)
    ws.EnvironmentMap(np.ones((3, 5)), up=(0, 1, 0)).sample(u)


def test_a_search_of_few_steps_draws_the_pixels_of_a_long_search():
    """`sample` always searches long. A sun leaves few entries in a bucket; a contrast of 1e12 leaves many."""
    for contrast, steps in ((1.0, FEW_STEPS), (1e6, FEW_STEPS), (1e12, MOST_STEPS)):
        picture = np.random.default_rng(7).random((128, 256)) + 0.5
        picture[30, 70] = contrast
        lobe = ws.EnvironmentMap(picture)
        assert read_steps(lobe.table_array) == steps
        found = ws.sample_directions(np.tile(UP, (256, 1)), 64, distribution=lobe, sequence="independent", pdf=True)
        square = ws.sample_square("independent", 256, 64)
        assert np.array_equal(found.vectors, lobe.sample(square))


def test_colours_count_by_luminance(tmp_path):
    colours = np.zeros((2, 3, 3))
    colours[0] = np.eye(3)
    colours[1, 2] = 1e-45  # the smallest float32: its luminance underflows, and yet the pixel is lit
    lobe = ws.EnvironmentMap(colours)
    assert lobe.picture[0] == pytest.approx([0.2126, 0.7152, 0.0722])
    assert lobe.picture[1, 2] > 0.0
    np.save(tmp_path / "sky.npy", colours)
    assert ws.EnvironmentMap(tmp_path / "sky.npy") == lobe
    named = ws.distributions.as_distribution(f"environment_map(picture={str(tmp_path / 'sky.npy')!r})")
    assert named == lobe


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ((np.zeros((4, 8)),), "^picture: got 4 x 8 zeros, want a number above 0"),
        ((np.full((4, 8), np.nan),), "^picture: got numbers below 0, above 1e.37 or not finite"),
        ((-np.ones((4, 8)),), "^picture: got numbers below 0"),
        ((np.full((4, 8), np.inf),), "^picture: got numbers below 0"),
        ((np.ones((4, 8, 4)),), "^picture: got shape .4, 8, 4., want .H, W. or .H, W, 3."),
        ((np.ones((0, 8)),), "^picture: got shape .0, 8."),
        ((np.ones((4, 8)), (0, 0, 0)), "^up: got"),
        ((np.ones((4, 8)), (0, 0, 1), (0, 0, -2)), "^north: got .*, want a vector that is not along up"),
        ((np.ones((4, 8)), (0, 0, 1), (np.nan, 0, 1)), "^north: got"),
        (("sky.png",), "^picture: got 'sky.png'"),
        ((np.ones((1, 1 << 15)),), "^picture: got shape .1, 32768., want fewer than 32,768 rows and columns"),
    ],
)
def test_bad_pictures_are_named(arguments, message, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "sky.png").write_bytes(b"x")
    with pytest.raises(ValueError, match=message):
        ws.EnvironmentMap(*arguments)


@wp.kernel
def draw(u: wp.array[wp.vec2], table: wp.uint64, w: wp.array[wp.vec3], p: wp.array[float], back: wp.array[wp.vec2]):
    i = wp.tid()
    w[i] = funcs.square_to_environment_map(u[i], table)
    p[i] = funcs.square_to_environment_map_pdf(w[i], table)
    back[i] = funcs.environment_map_to_square(w[i], table)


def test_own_kernels_draw_pixels_with_gradients():
    """The derivative of w by u has the area 1 / density, and that of the inverse is its inverse."""
    lobe = ws.EnvironmentMap(np.ones((8, 16)) + np.arange(16) % 3, up=(0.3, 0.1, 1.0))
    square = np.random.default_rng(2).random((256, 2)).astype(np.float32)
    u = wp.array(square, dtype=wp.vec2, device="cpu", requires_grad=True)
    w = wp.zeros(256, dtype=wp.vec3, device="cpu", requires_grad=True)
    p, back = wp.zeros(256, dtype=float, device="cpu"), wp.zeros(256, dtype=wp.vec2, device="cpu", requires_grad=True)
    tape = wp.Tape()
    with tape:
        wp.launch(draw, 256, inputs=[u, wp.uint64(lobe.table)], outputs=[w, p, back], device="cpu")
    assert np.array_equal(w.numpy(), lobe.sample(square))
    assert np.array_equal(p.numpy(), lobe.pdf(w.numpy()))
    jacobian = []
    for k in range(3):
        seed = np.zeros((256, 3), np.float32)
        seed[:, k] = 1.0
        tape.backward(grads={w: wp.array(seed, dtype=wp.vec3, device="cpu")})
        jacobian.append(u.grad.numpy().copy())
        tape.zero()
    by_x, by_y = np.stack(jacobian, axis=1).astype(np.float64).transpose(2, 0, 1)
    area = np.linalg.norm(np.cross(by_x, by_y), axis=1)
    inside = ~lobe.seam(square.astype(np.float64)) & (np.abs(area) > 0.0)
    assert inside.mean() > 0.8
    assert area[inside] * p.numpy()[inside] == pytest.approx(1.0, rel=1e-4)
    tape.backward(grads={back: wp.array(np.ones((256, 2), np.float32), dtype=wp.vec2, device="cpu")})
    assert u.grad.numpy()[inside] == pytest.approx(1.0, abs=1e-3)  # there and back


def test_a_picture_is_no_lobe_of_normals():
    with pytest.raises(
        ValueError, match="^lobe: got EnvironmentMap.*, whose directions are in world coordinates, want a lobe"
    ):
        ws.Reflection(ws.EnvironmentMap(np.ones((2, 4))), view=(0, 0, 1))
