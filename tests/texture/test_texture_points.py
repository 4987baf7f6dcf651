"""Images of numbers at texels: closed forms, seams, gutters, mips, errors, and the same bits by parts."""

import pickle
from types import SimpleNamespace

import numpy as np
import pytest
from lookups import coarser, floor_by_a_wall, lookup, on_surface, prism, two_charts

import warpsample as ws

QUAD = np.array([(0, 1), (1, 1), (1, 0), (0, 0)], float)


def test_positions_come_back_from_a_lookup():
    """Everywhere within a texel's extent; to float32 where all four texels are of centres in one face."""
    mesh, uv = two_charts()
    t = ws.texture_points(mesh, uv, (96, 64))
    image = t.image(t.points.position)
    points, at = on_surface(mesh, uv, 4000)
    error = np.abs(lookup(image, at) - points.position).max(axis=1)
    centre = np.stack([t.texel % 96 + 0.5, t.texel // 96 + 0.5], axis=1)
    place = np.einsum("pk,pkc->pc", t.points.barycentric, t.corners[t.face])
    within = np.zeros(96 * 64, bool)
    within[t.texel] = np.abs(place - centre).max(axis=1) < 1e-9
    face = np.where(within, t.image(t.face).ravel(), np.nan)
    mean, square = (lookup(np.float_power(face, power).reshape(64, 96, 1), at)[:, 0] for power in (1, 2))
    inner = np.abs(square - mean**2) < 1e-6
    assert 0.5 < inner.mean() < 1.0
    assert error[inner].max() <= 1e-6 * mesh.diagonal
    extent = np.linalg.norm(mesh.vertices[2] - mesh.vertices[0]) / 40  # a chart is at least 40 texels across
    assert error.max() <= extent


@pytest.mark.parametrize("samples", [1, 4])
def test_a_constant_is_read_at_every_level_that_the_gutter_serves(samples):
    """Level k reads up to 1.5 x 2^k texels beyond a chart; what is farther is 0, and so is the background."""
    mesh, uv = two_charts()
    t = ws.texture_points(mesh, uv, 128, samples=samples)
    _, at = on_surface(mesh, uv, 4000)
    narrow, wide = (t.image(np.ones((len(t), 1)), gutter=gutter) for gutter in (0, 6))
    assert np.array_equal(lookup(narrow, at), np.ones((4000, 1)))
    level = wide
    for _ in range(2):
        level = coarser(level)
        assert np.array_equal(lookup(level, at), np.ones((4000, 1)))
    assert lookup(coarser(coarser(narrow)), at).min() < 1.0
    assert narrow.mean() < wide.mean() < 1.0
    assert (t.image(np.ones(len(t))) == 1.0).all()
    assert narrow.sum() == t.report.covered


def test_rows_of_the_image_go_down():
    """The asymmetric quad: u to the right, v down, width before height."""
    square = ws.Mesh([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], [[0, 1, 2], [0, 2, 3]])
    t = ws.texture_points(square, QUAD[square.faces], (4, 2))
    image = t.image(t.points.position[:, :2])
    assert image.shape == (2, 4, 2)
    assert np.allclose(image[0, :, 0], [0.125, 0.375, 0.625, 0.875])
    assert np.allclose(image[:, 0, 1], [0.75, 0.25])


def test_point_and_mean_beside_a_wall():
    """V = (1 + d / sqrt(d^2 + h^2)) / 2 at the centre of the texel that is 0.125 wide, and its integral as the mean."""
    mesh, uv = floor_by_a_wall(0.05, 50.0, 0.25)
    centre = (1.0 + 0.0625 / np.hypot(0.0625, 0.05)) / 2
    mean = (1.0 + (np.hypot(0.125, 0.05) - 0.05) / 0.125) / 2
    assert (centre, mean) == pytest.approx((0.890434, 0.838516), abs=1e-6)
    point = ws.texture_points(mesh, uv, (2, 1))
    found = ws.ambient_occlusion(mesh, point.points, 4096)
    assert point.image(found.value)[0, 0] == pytest.approx(centre, abs=0.002)
    many = ws.texture_points(mesh, uv, (2, 1), samples=256)
    found = ws.ambient_occlusion(mesh, many.points, 64)
    value, error = float(many.image(found.value)[0, 0]), float(many.image_error(found)[0, 0])
    assert 0.0 < error < 0.02
    assert value == pytest.approx(mean, abs=4 * error)
    assert value < centre - 4 * error


def test_shading_of_a_convex_prism():
    """Face normals see all; smooth ones lose up to (1 - cos(pi / n)) / 2 to their own face; lifted ones see all again."""
    mesh, uv, radial = prism(8)
    found = {}
    for normals in ("face", "smooth", "lifted"):
        t = ws.texture_points(mesh, uv, (128, 1), normals=normals, corner_normals=radial)
        found[normals] = ws.ambient_occlusion(mesh, t.points, 4096).value
        lengths = np.linalg.norm(t.points.normal, axis=1)
        assert np.abs(lengths - 1.0).max() <= 1e-6
    assert (found["face"] == 1.0).all()
    slope = np.tan(np.pi / 8) * (1.0 - 1.0 / 16)  # at the first of the 16 centres of a side
    assert found["smooth"].min() == pytest.approx((1.0 + 1.0 / np.hypot(1.0, slope)) / 2, abs=0.003)  # by 4,096 rays
    assert found["smooth"].mean() == pytest.approx(0.986705, abs=0.002)
    assert (found["lifted"] >= found["smooth"] - 1e-6).all()
    assert found["lifted"].mean() > 0.999


def test_a_lift_follows_the_planes_of_the_corners():
    """Hanika's formula at the middle of a prism's side: out of it, nowhere below; and none where normals are the face's."""
    mesh, uv, radial = prism(8)
    t = ws.texture_points(mesh, uv, (24, 1), normals="lifted", corner_normals=radial)
    flat = ws.texture_points(mesh, uv, (24, 1))
    lift = np.einsum("pk,pk->p", t.points.position - flat.points.position, flat.points.normal)
    half = np.sin(np.pi / 8)
    # At weights 1/2: 2 x 1/2 of (half width x sine) along each normal, whose cosine to the face's is cos(pi / 8).
    assert lift[1] == pytest.approx(half * half * np.cos(np.pi / 8), rel=1e-6)
    assert (lift >= 0.0).all()
    assert (t.points.face[lift > 1e-6] == -1).all()
    own = np.repeat(mesh.face_normals[:, None], 3, axis=1)
    still = ws.texture_points(mesh, uv, (24, 1), normals="lifted", corner_normals=own)
    assert np.array_equal(still.points.position, flat.points.position)
    assert np.array_equal(still.points.face, flat.points.face)


def test_a_distant_face_drops_no_lift():
    """Lifts were dropped below 1e-9 of the whole mesh, which is the largest lift here."""
    mesh, uv, radial = prism(8)
    far = np.concatenate([mesh.vertices, [(1e9, 0, 0), (1e9, 1, 0), (1e9, 0, 1)]])
    larger = ws.Mesh(far, np.concatenate([mesh.faces, [len(mesh.vertices) + np.arange(3)]]))
    without, zero = np.full((1, 3, 2), np.nan), np.zeros((1, 3, 3))
    found = [
        ws.texture_points(one, coordinates, (24, 1), normals="lifted", corner_normals=normals).points
        for one, coordinates, normals in (
            (mesh, uv, radial),
            (larger, np.concatenate([uv, without]), np.concatenate([radial, zero])),
        )
    ]
    assert np.array_equal(found[0].position, found[1].position)
    assert np.array_equal(found[0].face, found[1].face)


def test_parts_strips_and_other_meshes_change_no_bit():
    """By 7 points at a time, of one chart alone, and by any number of threads: a texel's numbers are its own."""
    mesh, uv = two_charts()
    t = ws.texture_points(mesh, uv, 40, samples=4)
    whole = ws.ambient_occlusion(mesh, t.points, 16)
    rows = [slice(start, start + 7) for start in range(0, 70, 7)]
    parts = [ws.ambient_occlusion(mesh, t.take(part), 16, workers=1).value for part in rows]
    assert np.array_equal(np.concatenate(parts), whole.value[:70])
    alone = uv.copy()
    alone[2:] = np.nan
    one = ws.texture_points(mesh, alone, 40, samples=4)
    shared = np.isin(t.id, one.id)
    assert 0 < shared.sum() == len(one) < len(t)
    assert np.array_equal(ws.ambient_occlusion(mesh, one.points, 16).value, whole.value[shared])


def test_errors_of_samples_hold_what_values_vary():
    """The mean of x^2 over each texel of a square is known: the estimated error is 1 to 2 times the true one.

    Stratification makes it smaller than independent samples would be, by which it is told: 16 of them on a slope.
    """
    square = ws.Mesh([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], [[0, 1, 2], [0, 2, 3]])
    t = ws.texture_points(square, QUAD[square.faces], 32, samples=16)
    value = np.square(t.points.position[:, 0])
    found = ws.Estimate(value, *(0.0 * value for _ in range(3)), value.astype(int), value.astype(np.uint8), ws.Skipped())
    edges = np.arange(33) / 32
    truth = np.diff(np.float_power(edges, 3) / 3) * 32
    error = t.image(value) - truth
    estimated = t.image_error(found)
    assert np.sqrt(np.mean(error**2)) <= np.sqrt(np.mean(estimated**2))
    exact = np.sqrt((np.diff(np.float_power(edges, 5) / 5) * 32 - truth**2) / 16)  # of 16 independent samples
    assert np.sqrt((estimated**2).mean(axis=0)) == pytest.approx(exact, rel=0.1)


def test_a_texel_of_one_sample_has_the_error_of_its_point():
    mesh, uv = two_charts()
    t = ws.texture_points(mesh, uv, 16)
    errors = np.random.default_rng(1).uniform(size=len(t))
    image = t.image_error(errors, gutter=0)
    assert np.array_equal(image.ravel()[t.texel], errors.astype(np.float32))
    for wrong in (np.where(np.arange(len(t)) == 3, -0.5, np.nan), np.full((len(t), 3), -0.5)):
        with pytest.raises(ValueError, match="^errors: got -0.5, want standard errors of at least 0, or NaN for points"):
            t.image_error(wrong)
    more = ws.texture_points(mesh, uv, 16, samples=4)
    with pytest.raises(TypeError, match="errors: got .*, want the whole Estimate, because errors of 4 samples"):
        more.image_error(np.ones(len(more)))


@pytest.mark.parametrize("samples", [1, 4])
def test_a_filled_texel_has_the_error_of_its_source(samples):
    """Before, it was 0 with several samples."""
    mesh, uv = two_charts()
    t = ws.texture_points(mesh, uv, 16, samples=samples)
    value = np.random.default_rng(2).uniform(size=len(t))
    middle = np.isin(t.texel, np.unique(t.texel)[10:20])
    value[middle] = np.nan
    found = SimpleNamespace(value=value, standard_error=np.where(middle, np.nan, 0.1 + value))
    image, error = t.image(value), t.image_error(found)
    filled = np.unique(t.texel[middle])
    pairs = list(zip(image.ravel().tolist(), error.ravel().tolist(), strict=True))
    assert all(error.ravel()[filled] > 0.0)
    assert {pairs[texel] for texel in filled} <= {pairs[texel] for texel in np.unique(t.texel[~middle])}


def test_a_texel_with_one_of_several_samples_has_an_error_of_its_place_too():
    """At the rim of a slanted square, where values without any noise differ within a texel: the error is that of neighbours.

    The truth is the mean of 400 samples: their error is a fifth of that of 16, and less of one. By how much the spread of
    whole texels is too large for the parts at the rim, half of one in the mean, is within a factor of 3.
    """
    square = ws.Mesh([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], [[0, 1, 2], [0, 2, 3]])
    uv = np.array([(0.137, 0.05), (0.91, 0.153), (0.83, 0.94), (0.043, 0.842)])[square.faces]
    t, fine = (ws.texture_points(square, uv, 32, samples=samples) for samples in (4, 400))
    value, exact = (np.square(some.points.position[:, 0]) for some in (t, fine))
    found = ws.Estimate(value, *(0.0 * value for _ in range(3)), value.astype(int), value.astype(np.uint8), ws.Skipped())
    error, truth = t.image_error(found).ravel(), fine.image(exact).ravel()
    covered = np.bincount(fine.texel, (fine.points.barycentric > 0.0).all(axis=1), 32 * 32) > 0
    single = (np.bincount(t.texel, minlength=32 * 32) == 1) & covered
    assert single.sum() > 20
    true, estimated = (np.sqrt(np.mean(array[single] ** 2)) for array in (t.image(value).ravel() - truth, error))
    assert true <= estimated <= 3.0 * true


def test_what_has_no_number_is_filled_from_its_own_chart():
    """Two charts half a texel apart, one 1 and one 2: a texel that has lost its own number never takes the other's."""
    quads = [(0.0, 0.0, 0.48, 1.0), (0.52, 0.0, 1.0, 1.0)]
    uv = np.array([[(a, b), (c, b), (c, d)] for a, b, c, d in quads] + [[(a, b), (c, d), (a, d)] for a, b, c, d in quads])
    mesh = ws.Mesh(np.random.default_rng(1).uniform(size=(12, 3)), np.arange(12).reshape(-1, 3))
    t = ws.texture_points(mesh, uv, 25)
    chart = 1.0 + t.face % 2
    lost = chart.copy()
    lost[(t.texel % 25 > 3) & (chart == 1.0)] = np.nan  # the nearest numbers of the other chart are much nearer
    assert np.array_equal(t.image(lost), t.image(chart))
    lost[chart == 1.0] = np.nan  # then there is nothing but the other
    assert (t.image(lost) == 2.0).all()
    assert (t.image(np.full(len(t), np.nan)) == 0.0).all()


def test_the_mean_over_the_image_is_the_mean_over_the_surface():
    """Weighted by the area that each texel has of the surface, counted in samples: within 4 standard errors of either."""
    mesh, uv = floor_by_a_wall(1.0, 4.0, 3.0)
    t = ws.texture_points(mesh, uv, 16, samples=64)
    value = ws.ambient_occlusion(mesh, t.points, 16).value
    inside = (t.points.barycentric > 0.0).all(axis=1)  # others stand for what lookups read beyond the chart
    floor = ws.Mesh(mesh.vertices, mesh.faces[:2])
    points = ws.sample_surface(floor, 20_000, seed=1)
    other = ws.ambient_occlusion(mesh, points, 16).value
    assert value[inside].mean() == pytest.approx(other.mean(), abs=4 * other.std() / np.sqrt(len(other)))


@pytest.mark.parametrize(
    ("arguments", "options", "why"),
    [
        (([[0.0, 0.0]], 8), {}, "uv: got shape (1, 2), want (4, 3, 2) real numbers"),
        ((None, 8), {}, "uv: got None"),
        ((0, 0), {}, "size: got 0, want a whole number from 1"),
        ((0, (8, 8, 8)), {}, "size: got (8, 8, 8), want"),
        (
            (0, (60_000, 60_000)),
            {},
            "size: got (60000, 60000) with 1 samples per texel, want at most 2,147,483,647 samples in all",
        ),
        ((0, 8), {"samples": 0}, "samples: got 0"),
        ((0, 8), {"normals": "flat"}, "normals: got 'flat', want one of face, smooth, lifted"),
        ((0, 8), {"corner_normals": np.ones((4, 3))}, "corner_normals: got shape (4, 3), want (4, 3, 3)"),
    ],
)
def test_wrong_arguments_are_named(arguments, options, why):
    mesh, uv = two_charts()
    given = uv if isinstance(arguments[0], int) else arguments[0]
    with pytest.raises((TypeError, ValueError)) as caught:
        ws.texture_points(mesh, given, arguments[1], **options)
    assert str(caught.value).startswith(why)


def test_the_image_of_no_points_is_0():
    mesh = ws.Mesh([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]])
    for samples in (1, 4):
        t = ws.texture_points(mesh, np.full((1, 3, 2), np.nan), 8, samples=samples)
        assert np.array_equal(t.image(np.zeros(0)), np.zeros((8, 8)))
        assert np.array_equal(t.image(np.zeros((0, 3))), np.zeros((8, 8, 3)))


def test_points_of_texels_travel_to_other_processes():
    mesh, uv = two_charts()
    t = ws.texture_points(mesh, uv, 16)
    found = pickle.loads(pickle.dumps(t))
    assert found.options.memory == t.options.memory
    assert np.array_equal(found.image(found.points.position), t.image(t.points.position))
