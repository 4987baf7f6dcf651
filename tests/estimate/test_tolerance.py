"""A tolerance is reached, by not many more rays than the best count for all points takes, and without a bias."""

import numpy as np
import pytest
import trimesh
import warp as wp
from estimate_cases import at, lid, square
from glass_cases import same_bits

import warpsample as ws
from warpsample.bench.scenes import bunny, city, hills

POINTS = 20_000
SCENES = {"bunny": lambda: bunny(1), "city": city, "hills": hills}
MOST = 1 << 14


@wp.func
def height_squared(w: wp.vec3) -> float:
    return w[2] * w[2]


def root_mean_square(values):
    return np.sqrt(np.mean(np.square(np.asarray(values, np.float64))))


def rectangle(x, y):
    """What a point sees of a rectangle, x by y, a unit above it, with a corner over the point."""
    a, b = np.hypot(1.0, x), np.hypot(1.0, y)
    return (x / a * np.arctan(y / a) + y / b * np.arctan(x / b)) / (2.0 * np.pi)


def below_the_square(points):
    """(P,) exact open shares of points below a unit square: it is cut into four rectangles above each of them."""
    x, y = np.asarray(points.position, np.float64)[:, :2].T
    return 1.0 - sum(rectangle(a, b) for a in (x, 1.0 - x) for b in (y, 1.0 - y))


def spread_below(seed):
    """Points below the unit square, which is a unit above them."""
    place = np.random.default_rng(seed).uniform(size=(POINTS, 2))
    return at(np.column_stack([place, np.zeros(POINTS)]), (0, 0, 1))


def fewest_rays(mesh, points, tolerance, near):
    """The fewest rays cast by which one count for all points has that standard error, root mean square."""
    counts = {int(near * share) for share in np.linspace(0.7, 1.0, 7)} | {30, 32, 255, 256, 447, 448, 4095, 4096}
    runs = [ws.ambient_occlusion(mesh, points, n, seed=3) for n in counts if near / 4 <= n <= 4 * near]
    return min(run.rays.sum() for run in runs if root_mean_square(run.standard_error) <= tolerance)


@pytest.mark.thorough
@pytest.mark.parametrize("scene", SCENES)
def test_it_is_reached_at_the_price_of_the_best_count(scene):
    """Judged by a reference of 16,384 rays, whose error is 3e-4; and 0.001, whose search would take minutes, by its bars."""
    mesh = SCENES[scene]()
    points = ws.sample_surface(mesh, POINTS, seed=1)
    right = ws.ambient_occlusion(mesh, points, MOST, seed=99).value
    for tolerance in (0.05, 0.02, 0.005):
        found = ws.ambient_occlusion(mesh, points, MOST, seed=2, tolerance=tolerance)
        error = found.value - right
        assert 0.8 <= root_mean_square(error) / tolerance <= 1.05
        assert 0.9 <= (root_mean_square(error) / root_mean_square(found.standard_error)) ** 2 <= 1.1
        count = (float(found.rays.sum()) + found.skipped.empty_rays) / POINTS
        assert found.rays.sum() <= 1.25 * fewest_rays(mesh, points, tolerance, count)
    fine = ws.ambient_occlusion(mesh, points, MOST, seed=2, tolerance=0.001)
    assert 0.8 <= root_mean_square(fine.standard_error) / 0.001 <= 1.05


@pytest.mark.slow
def test_it_is_without_bias_and_its_bars_are_right():
    """20 seeds, 20,000 points each, against the closed form; the limits are those of a normal law, and of the issue."""
    errors, bars = [], []
    for seed in range(20):
        points = spread_below(seed)
        found = ws.ambient_occlusion(square(), points, 1024, seed=seed, tolerance=0.02)
        errors.append(found.value - below_the_square(points))
        bars.append(found.standard_error)
        assert 0.8 <= root_mean_square(errors[-1]) / 0.02 <= 1.05
    assert abs(np.sum(errors)) <= 4.0 * np.sqrt(np.square(errors).sum())
    assert 0.9 <= (root_mean_square(errors) / root_mean_square(bars)) ** 2 <= 1.1


def test_it_changes_the_count_and_nothing_else(bunny, points):
    """All points take one count, at most that of the call; neither `skip` nor a chunk of memory sways it."""
    fixed = ws.ambient_occlusion(bunny, points, 512)
    with pytest.warns(UserWarning, match="tolerance: got 1e-09, which is not reached with 512 rays per point"):
        tight = ws.ambient_occlusion(bunny, points, 512, tolerance=1e-9)
    assert np.array_equal(tight.value, fixed.value)
    assert tight.skipped.unneeded_rays == 0
    easy = ws.ambient_occlusion(bunny, points, 512, tolerance=0.03)
    assert easy.skipped.unneeded_rays > 0
    assert easy.rays.sum() < fixed.rays.sum()
    assert np.array_equal(easy.value, ws.ambient_occlusion(bunny, points, 512, tolerance=0.03, skip=False).value)
    coarse = ws.ambient_occlusion(bunny, points, 512, tolerance=1e3, skip=False)
    assert np.isin(coarse.rays, [4, 12, 16]).all()  # the fewest, and the trials' 8 and 4


def test_a_result_that_misses_the_tolerance_by_far_warns():
    """Few points see a bright patch of the sky, and few rays meet it: the errors were 6 tolerances, without a word."""
    mesh = ws.load_mesh("courtyard")
    centers = ws.face_centers(mesh)
    points = centers.take(np.arange(0, len(centers), 5))
    picture = np.ones((64, 128))
    picture[24:27, 14:18] = 100.0
    missed = "tolerance: got 1.079, which is not reached with .* its rays met what the trial missed; without .* 65,536 rays"
    with pytest.warns(UserWarning, match=missed):
        found = ws.irradiance(mesh, points, picture, 1 << 16, tolerance=1.079, seed=205506)
    assert root_mean_square(found.standard_error) > 2.0 * 1.079


@pytest.mark.parametrize(
    ("sequence", "tolerance"),
    [
        ("fibonacci", 0.04),
        ("sobol", 0.08),
        ("stratified", 0.015),
        pytest.param("independent", 0.02, marks=pytest.mark.thorough),
        pytest.param("stratified", 0.06, marks=pytest.mark.thorough),
    ],
)
def test_walls_reach_the_tolerance(sequence, tolerance):
    """Strata of 32 rays end at the horizon and have no error, fewer have one: the search went to and fro, and took few.

    The error of 8 Sobol' points is less than that of 4 or 16, so that the search took 4.
    """
    box = ws.as_mesh(trimesh.creation.box((10, 10, 30)))
    points = ws.sample_surface(box, 3000, seed=1)
    found = ws.sky_view_factor(box, points, 1024, tolerance=tolerance, sequence=sequence)
    error = np.sqrt(np.mean(found.standard_error.astype(float) ** 2))
    assert error < 1.1 * tolerance  # a call may miss it by a tenth without a warning


@pytest.mark.parametrize("sequence", ["fibonacci", "sobol"])
def test_skipping_does_not_change_the_count(sequence):
    """A result was cast again if rays had been cast, so that intervals of open points were shorter without skipping."""
    sheet = ws.Mesh([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]])
    points = ws.sample_surface(sheet, 2, seed=0)
    for tolerance in np.geomspace(0.005, 0.1, 10):
        one, other = (
            ws.ambient_occlusion(sheet, points, 4096, tolerance=tolerance, sequence=sequence, skip=skip)
            for skip in (True, False)
        )
        assert same_bits(one, other, "spread", "degrees_of_freedom")


def test_the_search_ends_where_it_goes_to_and_fro():
    """Rounds of 8 and 176 rays took turns under a small hole, so that up to 1,176 rays were cast for a count of 256."""
    points = at(np.zeros((2, 3)), (0, 0, 1))
    for seed in range(1, 7919 * 4, 7919):
        found = ws.ambient_occlusion(lid(0.05), points, 256, tolerance=0.05, sequence="independent", seed=seed)
        assert found.rays.max() <= 3 * 256  # a trial, one of finer strata, and the result


@pytest.mark.thorough
def test_the_search_does_not_bias_a_point():
    """Results that missed the tolerance, those whose rays met a hole, were cast again: the mean was 20 % too low."""
    mesh, point = lid(0.1), at((0.0, 0.0, 0.0), (0, 0, 1))
    options = {"sequence": "independent", "tolerance": 0.05}
    seeds = range(1, 7919 * 1000, 7919)
    value = np.array([ws.ambient_occlusion(mesh, point, 1024, seed=seed, **options).value[0] for seed in seeds])
    side = 0.1 / np.hypot(1.0, 0.1)
    truth = 4.0 / np.pi * side * np.arctan(side)  # the form factor of a rectangle, four times that of its quarter
    assert abs(value.mean() - truth) <= 4.0 * value.std() / np.sqrt(len(value))


def test_no_warning_where_all_values_are_proven():
    """Warnings are errors here: open ground casts no ray, so that no more rays could make its values better."""
    ground = ws.as_mesh(([[0, 0, 0], [9, 0, 0], [9, 9, 0], [0, 9, 0]], [[0, 1, 2], [0, 2, 3]]))
    at = np.array([[2.0, 2.0, 0.0], [5.0, 6.0, 0.0]])
    points = ws.SurfacePoints(position=at, normal=np.tile(np.float32([0, 0, 1]), (2, 1)))
    found = ws.sky_view_factor(ground, points, 16, tolerance=1e-3)
    assert (found.value == 1.0).all()
    assert found.rays.sum() == 0
    with pytest.warns(UserWarning, match="tolerance: got 0.001, which is not reached with 16 rays per point"):
        ws.sky_view_factor(ground, points, 16, tolerance=1e-3, skip=False)
    with pytest.warns(UserWarning, match="tolerance: got 0.001, which is not reached with 16 rays per point"):
        ws.sky_view_factor(square(), spread_below(0).take(slice(0, 2)), 16, tolerance=1e-3)
    with pytest.warns(UserWarning, match="tolerance: got 0.001, which is not reached with 16 rays per point"):
        ws.sky_view_factor(ground, points, 16, tolerance=1e-3, up=(0, 1, 2))  # no rays, but values depend on them
    with pytest.warns(UserWarning, match="tolerance: got 0.001, which is not reached with 16 rays per point"):
        assert not ws.sky_view_factor(ground, points, 16, tolerance=1e-3, up=(0, 0.01, -1)).value.any()  # nor do they agree


def test_nothing_to_see_takes_few_rays(bunny, points):
    dark = ws.irradiance(bunny, points, np.zeros((2, 2)), tolerance=0.1)
    assert (dark.value == 0.0).all()
    none = ws.ambient_occlusion(bunny, points, 64, tolerance=0.1, active=np.zeros(len(points), bool))
    assert (none.rays == 0).all()
    assert none.counts() == {ws.PointStatus.INACTIVE: len(points)}


def test_one_point_reaches_it_too():
    """Few points tell little: what edges let expect stands in for the rest, so it is reached, if not by the fewest rays."""
    point = at((0.3, 0.4, 0.0), (0, 0, 1))
    errors = [
        (ws.ambient_occlusion(square(), point, 4096, seed=seed, tolerance=0.02).value - below_the_square(point))[0]
        for seed in range(200)
    ]
    assert 0.5 <= root_mean_square(errors) / 0.02 <= 1.1


@pytest.mark.parametrize("sequence", ["sobol", "fibonacci", pytest.param("independent", marks=pytest.mark.thorough)])
def test_smooth_integrands_take_what_they_need(sequence):
    """The trial sees by which power their error falls; of Sobol' points a power of two is taken, up to twice as many."""
    normals = np.random.default_rng(4).normal(size=(4000, 3))
    found = ws.integrate(normals, height_squared, 1 << 16, sequence=sequence, tolerance=0.001)
    unit = normals[:, 2] / np.linalg.norm(normals, axis=1)
    error = found.value - (0.25 + 0.25 * unit**2)  # the mean of z^2 over the cosine lobe about n
    assert (0.25 if sequence == "sobol" else 0.7) <= root_mean_square(error) / 0.001 <= 1.1


@pytest.mark.thorough
@pytest.mark.parametrize("sequence", sorted(set(ws.sequences.names()) - {"fibonacci"}))
@pytest.mark.parametrize("tolerance", [0.04, 0.02, 0.0175, 0.0135])
def test_other_sequences_reach_it_too(sequence, tolerance):
    """Where strata become finer, and where the error falls by no power: the last round is near what is needed."""
    points = spread_below(7)
    found = ws.ambient_occlusion(square(), points, MOST, sequence=sequence, seed=8, tolerance=tolerance)
    assert 0.5 <= root_mean_square(found.value - below_the_square(points)) / tolerance <= 1.1
