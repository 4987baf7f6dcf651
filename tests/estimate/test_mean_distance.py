"""The mean distance to the nearest hit: by closed forms, its error bars, its limit, and where it reaches by its record."""

import numpy as np
import pytest
import trimesh

import warpsample as ws

RADIUS, HEIGHT = 2.0, 1.5
BOX = (3.0, 1.0, 2.0)


def turned_in(body):
    body.invert()
    return ws.as_mesh(body)


@pytest.fixture(scope="module")
def ball():
    return turned_in(trimesh.creation.icosphere(5, RADIUS))


@pytest.fixture(scope="module")
def between_planes():
    """A ceiling, and points of a floor below its middle, from which rays of up to 20 cannot pass its edge."""
    square = 40.0 * np.array([[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]])
    ceiling = ws.as_mesh((np.column_stack([square, np.full(4, HEIGHT)]), [[0, 2, 1], [0, 3, 2]]))
    position = np.column_stack([np.random.default_rng(3).uniform(-15.0, 15.0, (2000, 2)), np.zeros(2000)])
    return ceiling, ws.SurfacePoints(position, np.tile(np.float32([0.0, 0.0, 1.0]), (2000, 1)))


def ratio(found, right):
    """The mean of the squared errors over the mean of the squared error bars."""
    return np.mean((found.value - right) ** 2) / np.mean(found.standard_error**2)


def test_in_a_ball_it_is_four_thirds_of_the_radius(ball):
    """The chord along a direction at an angle t from the normal is 2 R cos t."""
    right = 4.0 / 3.0 * RADIUS
    found = ws.mean_distance(ball, ws.face_centers(ball), 256, seed=1)
    assert found.max_distance == pytest.approx(2.0 * np.sqrt(3.0) * RADIUS, rel=1e-3)
    assert found.value.mean(dtype=np.float64) == pytest.approx(right, rel=3e-4)  # the faces lie within the ball
    assert 0.8 < ratio(found, right) < 1.25


@pytest.mark.parametrize("limit", [2.0, 5.0, 20.0])
def test_under_a_plane_it_is_cut_at_the_limit(between_planes, limit):
    """The integral of 2 c min(h / c, L) over the cosine c from 0 to 1 is 2 h - h^2 / L."""
    right = 2.0 * HEIGHT - HEIGHT**2 / limit
    found = ws.mean_distance(*between_planes, 64, max_distance=limit, seed=2)
    assert found.value.mean(dtype=np.float64) == pytest.approx(right, abs=4.0 * np.std(found.value) / np.sqrt(2000))
    assert 0.8 < ratio(found, right) < 1.25
    lower, upper = found.interval(0.95)
    assert np.mean((lower <= right) & (right <= upper)) >= 0.93
    assert upper.max() <= limit


def test_over_the_walls_of_a_box_it_is_four_volumes_over_the_surface():
    """Cauchy's mean chord of a convex body: cosine-weighted lines from points that are uniform by area."""
    a, b, c = BOX
    box = turned_in(trimesh.creation.box(BOX))
    found = ws.mean_distance(box, ws.sample_surface(box, 20_000, seed=5), 64)
    chord = 4.0 * a * b * c / (2.0 * (a * b + b * c + c * a))
    assert found.value.mean(dtype=np.float64) == pytest.approx(chord, abs=4.0 * found.value.std() / np.sqrt(20_000))


def test_it_is_the_limit_times_occlusion_with_a_straight_falloff(bunny):
    points = ws.sample_surface(bunny, 500, seed=6)
    occlusion = ws.ambient_occlusion(bunny, points, 64, max_distance=0.7, falloff=1.0, seed=1)
    found = ws.mean_distance(bunny, points, 64, max_distance=0.7, seed=1)
    for name in ("value", "standard_error", "spread"):
        assert np.array_equal(getattr(found, name), np.float32(0.7) * getattr(occlusion, name)), name
    without = ws.mean_distance(bunny, points, 64, max_distance=0.7, seed=1, skip=False)
    assert np.array_equal(found.value, without.value)
    assert without.rays.sum() > found.rays.sum()


def test_without_a_limit_what_meets_nothing_counts_as_the_diagonal(bunny):
    points = ws.sample_surface(bunny, 500, seed=6)
    found = ws.mean_distance(bunny, points, 64)
    assert found.max_distance == bunny.diagonal
    open_points = ws.ambient_occlusion(bunny, points, 64).value == 1.0
    assert open_points.any()
    assert np.array_equal(np.unique(found.value[open_points]), [np.float32(bunny.diagonal)])
    assert np.array_equal(found.value, ws.mean_distance(bunny, points, 64, max_distance=np.inf).value)


@pytest.mark.parametrize("limit", [0.0, 1e-40, 1e35])
def test_a_limit_without_a_float32_is_refused(bunny, limit):
    with pytest.raises(ValueError, match="^max_distance: got .*, want a number from 1e-30 to 1e\\+30"):
        ws.mean_distance(bunny, ws.sample_surface(bunny, 3), 64, max_distance=limit)


def test_its_record_brings_it_to_the_shell_and_to_meshes(call, tmp_path):
    mesh, output = ws.load_mesh("courtyard"), tmp_path / "free.ply"
    right = ws.mean_distance(mesh, ws.vertex_points(mesh), 32, max_distance=9.0)
    given = ["--quantity", "mean-distance", "--max-distance", 9, "--samples", 32]
    status, out, err = call("bake", "courtyard", "-o", output, *given)
    assert (status, err) == (0, "")
    low, mean = right.value.min(), right.value.mean()
    assert f"mean distance of 1,089 vertices\n  mean {mean:.4f} mesh units, from {low:.4g} to 9; standard error" in out
    columns = trimesh.load(output, process=False).metadata["_ply_raw"]["vertex"]["data"]
    assert np.array_equal(columns["value"].ravel(), right.value)
    assert columns["red"].max() == 255  # the largest
    shaded = mesh.to_polydata().warpsample.mean_distance(32, max_distance=9.0)
    assert np.array_equal(shaded.point_data["mean_distance"], right.value)


@pytest.mark.slow
def test_its_record_brings_it_into_stores(call, tmp_path):
    pytest.importorskip("zarr")
    from warpsample import cluster

    mesh = ws.load_mesh("courtyard")
    right = ws.mean_distance(mesh, ws.face_centers(mesh), 32, max_distance=9.0)
    lazy = cluster.mean_distance(mesh, "faces", 32, max_distance=9.0, chunk=700)
    assert np.array_equal(lazy.value.compute(scheduler="sync"), right.value)
    given = ["--quantity", "mean-distance", "--max-distance", 9, "--samples", 32, "--at", "faces"]
    assert call("bake", "courtyard", "-o", tmp_path / "a.zarr", *given, "--chunk", 700)[0] == 0
    assert call("export", tmp_path / "a.zarr", "courtyard", "-o", tmp_path / "a.csv")[0] == 0
    assert call("bake", "courtyard", "-o", tmp_path / "b.csv", *given)[0] == 0
    assert (tmp_path / "a.csv").read_bytes() == (tmp_path / "b.csv").read_bytes()
