"""Poisson-disk points of a surface: their distance, their number and density, their spectrum, and what they follow from."""

import numpy as np
import pytest
import trimesh
from scipy.spatial import cKDTree

import warpsample as ws
from warpsample.proof.laws import count_p_value


def square(size=1.0):
    return ws.as_mesh(([(0, 0, 0), (size, 0, 0), (size, size, 0), (0, size, 0)], [[0, 1, 2], [0, 2, 3]]))


def nearest(points, within=0.2):
    """The least distance of two points whose normals are less than 120 degrees apart."""
    i, j = cKDTree(points.position).query_pairs(within, output_type="ndarray").T
    alike = np.einsum("nx,nx->n", points.normal[i], points.normal[j]) > -0.5
    return np.linalg.norm(points.position[i] - points.position[j], axis=1)[alike].min()


@pytest.fixture(scope="module")
def blue():
    return ws.sample_surface(square(), 2000, spacing="blue", seed=1)


def test_a_radius_is_kept_and_leaves_little_room():
    mesh, radius = ws.as_mesh(trimesh.creation.icosphere(3)), 0.12
    points = ws.sample_surface(mesh, spacing="blue", radius=radius, seed=3)
    assert nearest(points) >= radius
    others = ws.sample_surface(mesh, 100_000, seed=4)
    gap = cKDTree(points.position).query(others.position)[0]
    # A further point would fit where the gap is wider than the radius: by sixteen darts for each point seldom.
    assert (gap > radius).mean() < 0.05
    assert gap.max() < 2.0 * radius


def test_a_count_is_met_by_the_distance_that_poisson_disks_have(blue):
    """0.65 to 0.85 of the distance of the densest pattern, sqrt(2 / (sqrt(3) N)), as Lagae and Dutre ask for."""
    assert len(blue) == 2000
    relative = nearest(blue) / np.sqrt(2.0 / (np.sqrt(3.0) * 2000))
    assert 0.65 < relative < 0.85
    for count in (1, 2, 63):
        assert len(ws.sample_surface(square(), count, spacing="blue")) == count


def test_the_density_is_even(blue, plausible):
    """Halves of a square, and of other shares than areas: fewer off than by chance, which the distance holds back."""
    inner = blue.position[((blue.position > 0.1) & (blue.position < 0.9))[:, :2].all(axis=1)]
    for axis in (0, 1):
        plausible(count_p_value(np.count_nonzero(inner[:, axis] < 0.5), len(inner), 0.5))
    mesh = ws.as_mesh(
        ([(0, 0, 0), (4, 0, 0), (4, 1, 0), (0, 1, 0), (0, 0, 3), (4, 0, 3)], [[0, 1, 2], [0, 2, 3], [0, 4, 5]])
    )
    points = ws.sample_surface(mesh, 3000, spacing="blue")
    plausible(count_p_value(np.count_nonzero(points.face == 2), 3000, 6.0 / 10.0))


def power(position, size=1.0):
    """The mean power of low frequencies, of waves longer than two distances, by a window that fades at the rim; white: 1."""
    x, y = position[:, 0] / size, position[:, 1] / size
    window = np.sin(np.pi * x) ** 2 * np.sin(np.pi * y) ** 2
    most = int(0.5 * np.sqrt(len(x)) * 0.6)
    waves = np.stack(np.meshgrid(np.arange(-most, most + 1), np.arange(-most, most + 1)), axis=-1).reshape(-1, 2)
    length = np.hypot(*waves.T)
    waves = waves[(length > 4.0) & (length < most)]  # longer ones show the window
    found = window @ np.exp(-2j * np.pi * (x[:, None] * waves[:, 0] + y[:, None] * waves[:, 1]))
    return (np.abs(found) ** 2).mean() / (window**2).sum()


def test_the_spectrum_is_blue(blue):
    """Disks thrown so densely have a fifth of white noise's power there; independent points have all of it."""
    assert power(blue.position) < 0.3
    assert 0.8 < power(ws.sample_surface(square(), 2000, seed=1).position) < 1.2


def test_they_follow_from_the_seed_alone(blue):
    again = ws.sample_surface(square(), 2000, spacing="blue", seed=1, workers=1)
    assert np.array_equal(again.position, blue.position)
    assert np.array_equal(again.face, blue.face)
    other = ws.sample_surface(square(), 2000, spacing="blue", seed=2)
    assert not np.array_equal(other.position, blue.position)
    weighted = ws.sample_surface(square(), 2000, spacing="blue", seed=1, barycentric=True)
    corners = square().vertices[square().faces[weighted.face]]
    assert np.allclose((weighted.barycentric[:, :, None] * corners).sum(axis=1), blue.position)


def test_each_stays_that_is_not_near_an_earlier_one():
    """The rounds give what one after the other gives."""
    mesh, radius = ws.as_mesh(trimesh.creation.box((1.0, 0.7, 0.2))), 0.2
    kept = ws.sample_surface(mesh, spacing="blue", radius=radius, seed=5, workers=3)
    darts = ws.sample_surface(mesh, int(16 * 0.585 * mesh.face_areas.sum() / radius**2), seed=5)
    stay = []
    for i, (place, normal) in enumerate(zip(darts.position, darts.normal, strict=True)):
        near = [j for j in stay if np.sum((darts.position[j] - place) ** 2) < radius**2 and darts.normal[j] @ normal > -0.5]
        if not near:
            stay.append(i)
    assert np.array_equal(kept.position, darts.position[stay])


def test_both_sides_of_a_sheet_have_points_of_their_own():
    vertices, faces = square().vertices, square().faces
    both = ws.as_mesh((vertices, np.concatenate([faces, faces[:, ::-1]])))
    points = ws.sample_surface(both, spacing="blue", radius=0.05)
    above = np.count_nonzero(points.normal[:, 2] > 0)
    assert abs(above / len(points) - 0.5) < 0.05
    assert nearest(points) >= 0.05
    assert cKDTree(points.position).query(points.position, 2)[0][:, 1].min() < 0.05


@pytest.mark.parametrize(
    ("given", "error", "match"),
    [
        ({"spacing": "green"}, ValueError, "spacing: got 'green', want one of random, blue"),
        ({"spacing": "blue"}, TypeError, "count: got None, want a whole number"),
        ({"radius": 0.1}, ValueError, "radius: got 0.1 with spacing='random', want no radius, or spacing='blue'"),
        ({"radius": 0.1, "spacing": "blue", "count": 3}, ValueError, "radius: got 0.1 with count=3, want only one"),
        ({"radius": 0.0, "spacing": "blue"}, ValueError, "radius: got 0.0, want a number from"),
        ({"radius": 1e-6, "spacing": "blue"}, MemoryError, "points to choose from need .* take fewer, or a larger radius"),
        ({"count": 3, "first_point": 1, "spacing": "blue"}, ValueError, "first_point: got 1 with spacing='blue', want 0"),
    ],
)
def test_arguments_without_sense_are_reported(given, error, match):
    with pytest.raises(error, match=match):
        ws.sample_surface(square(), **given)
