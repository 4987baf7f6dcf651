"""Frames with tangents: axes, signs, points whose tangent cannot be used, and tangents from texture coordinates."""

import numpy as np
import pytest

import warpsample as ws

P = 530
COUNTS = (1, 3, 70)
LOBE = ws.VisibleGGX(0.3, view=(0.5, 0.2, 0.6))


@pytest.fixture
def points():
    return ws.SurfacePoints(np.zeros((P, 3)), np.random.default_rng(1).normal(size=(P, 3)).astype(np.float32))


@pytest.fixture
def tangents():
    rng = np.random.default_rng(2)
    t = rng.normal(size=(P, 4)) * 10.0 ** rng.integers(-30, 30, (P, 1))
    t[:, 3] = np.where(rng.random(P) < 0.5, -1.0, 1.0)
    return t


def frames_in_float64(normal, tangent):
    """x, y and z of the frames, (P, 3) each."""
    z = normal.astype(np.float64)
    z /= np.linalg.norm(z, axis=1, keepdims=True)
    t = tangent[:, :3] / np.linalg.norm(tangent[:, :3], axis=1, keepdims=True)
    x = t - (t * z).sum(axis=1, keepdims=True) * z
    x /= np.linalg.norm(x, axis=1, keepdims=True)
    return x, np.sign(tangent[:, 3:]) * np.cross(z, x), z


def test_axes_are_those_of_a_float64_frame(points, tangents):
    """The direction of x keeps the rounding of its tangent, 1e-7 divided by the sine to the normal, here above 0.02."""
    axes = frames_in_float64(points.normal, tangents)
    framed = points.with_tangents(tangents)
    for unit, axis in zip(np.eye(3), axes, strict=True):
        assert abs(framed.to_world(unit) - axis).max() < 1e-5
        assert abs(framed.to_local(axis) - unit).max() < 1e-5
    x, y, z = (framed.to_world(unit).astype(np.float64) for unit in np.eye(3))
    assert max(abs((a * b).sum(axis=1)).max() for a, b in ((x, y), (y, z), (z, x))) < 4e-7


def test_small_angles_to_the_normal_keep_x_perpendicular():
    """With one projection, x.n would be wrong by 5e-5 at a sine of 2e-3."""
    normal = np.tile(np.float32([0.36, 0.48, 0.8]), (1000, 1))
    side = np.random.default_rng(3).normal(size=(1000, 3))
    framed = ws.SurfacePoints(np.zeros((1000, 3)), normal).with_tangents(normal + 4e-3 * side)
    x = framed.to_world([1.0, 0.0, 0.0]).astype(np.float64)
    assert abs((x * normal).sum(axis=1)).max() < 3e-7
    assert abs(np.linalg.norm(x, axis=1) - 1.0).max() < 2e-7


@pytest.mark.parametrize("count", COUNTS)
def test_directions_are_the_local_ones_in_the_frames(count, points, tangents):
    framed = points.with_tangents(tangents)
    w = LOBE.sample(ws.sample_square("sobol", P, count))
    found = ws.sample_directions(framed, count, distribution=LOBE, pdf=True)
    assert np.array_equal(found.vectors, framed.to_world(w))
    assert np.array_equal(found.pdf, LOBE.pdf(w))
    assert set(found.status) == {0}
    # A sign that is ignored, and a frame that ignores the tangent, are seen.
    unsigned = points.with_tangents(tangents[:, :3]).to_world(w)
    mirrored = tangents[:, 3] < 0.0
    assert np.array_equal(unsigned[~mirrored], found.vectors[~mirrored])
    assert not np.array_equal(unsigned[mirrored], found.vectors[mirrored])
    assert not np.array_equal(points.to_world(w), found.vectors)


@pytest.mark.parametrize("count", COUNTS)
def test_without_tangents_to_world_is_what_directions_are(count, points):
    w = LOBE.sample(ws.sample_square("sobol", P, count))
    found = ws.sample_directions(points, count, distribution=LOBE, pdf=True)  # the kernels of the test below
    assert np.array_equal(found.vectors, points.to_world(w))
    assert abs(points.to_local(found.vectors) - w).max() < 4e-7


@pytest.mark.parametrize("count", COUNTS)
def test_unusable_tangents_give_the_frame_without_and_are_counted(count, points, tangents):
    bad = [4, 5, 6, 7, 300]
    tangents[4, :3], tangents[5, :3], tangents[6, 3] = 0.0, np.nan, 0.0
    tangents[7, :3] = -3.0 * points.normal[7]
    tangents[300, :3] = points.normal[300] + 5e-4 * np.cross(points.normal[300], [0.0, 0.0, 1.0])  # a sine below 5e-4
    found = ws.sample_directions(points.with_tangents(tangents), count, distribution=LOBE, pdf=True)
    plain = ws.sample_directions(points, count, distribution=LOBE, pdf=True)
    assert np.array_equal(found.vectors[bad], plain.vectors[bad])
    assert np.flatnonzero(found.status).tolist() == bad
    assert found.counts() == {ws.Status.OK: P - 5, ws.Status.INVALID_TANGENT: 5}
    assert np.array_equal(found.pdf, plain.pdf)
    assert found.to_polydata(points).n_points == P * count


@pytest.mark.parametrize("count", [COUNTS[1], *(pytest.param(n, marks=pytest.mark.thorough) for n in COUNTS[::2])])
def test_bad_normals_and_parameters_come_before_bad_tangents(points, count):
    alpha = np.full(P, 0.3)
    alpha[[1, 2]] = 0.0
    normal = points.normal.copy()
    normal[[2, 3]] = 0.0
    framed = ws.SurfacePoints(points.position, normal).with_tangents([0.0, 0.0, 0.0])
    status = ws.sample_directions(framed, count, distribution=ws.GGX(alpha)).status
    assert status[:5].tolist() == [7, 6, 2, 2, 7]


def test_the_offset_method_has_no_frame_and_keeps_its_bits(points, tangents):
    lobe = ws.CosineHemisphere("offset")
    framed, plain = (
        ws.sample_directions(p, 3, distribution=lobe, pdf=True) for p in (points.with_tangents(tangents), points)
    )
    assert np.array_equal(framed.vectors, plain.vectors)


def test_vectors_of_all_shapes_are_turned(points, tangents):
    framed = points.with_tangents(tangents)
    many = np.random.default_rng(4).normal(size=(P, 5, 3))
    each = np.stack([framed.to_local(many[:, i]) for i in range(5)], axis=1)
    assert np.array_equal(framed.to_local(many), each)
    assert framed.to_local(many).dtype == np.float32
    assert abs(framed.to_world(framed.to_local(many)) - many).max() < 4e-6  # vectors of length up to 5
    zero = ws.SurfacePoints(np.zeros((1, 3)), [[0, 0, 0]])
    assert not zero.to_local([1.0, 2.0, 3.0]).any()
    assert zero.take([]).to_world([1.0, 0.0, 0.0]).shape == (0, 3)


def test_tangents_are_taken_and_given_in_several_forms(points, tangents):
    framed = points.with_tangents(tangents)
    assert framed.take(slice(3, 9)).tangent.shape == (6, 4)
    assert np.array_equal(points.with_tangents([0.0, 1.0, 0.0]).tangent, np.tile(np.float32([0, 1, 0, 1]), (P, 1)))
    assert points.tangent is None
    for wrong in (np.ones((P, 2)), np.ones((P + 1, 3)), np.ones(4), 3.0):
        with pytest.raises(ValueError, match="tangent: got shape"):
            points.with_tangents(wrong)
    with pytest.raises(TypeError, match="tangent: got dtype"):
        points.with_tangents(np.full((P, 3), "x"))
    with pytest.raises(ValueError, match="vectors: got shape"):
        points.to_local(np.ones((P, 4)))


SQUARE = ws.Mesh([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], [[0, 1, 2], [0, 2, 3]])


@pytest.mark.parametrize(("turn", "mirrored"), [(0, False), (1, False), (0, True)])
def test_coordinates_give_tangents_along_u_and_bitangents_up(turn, mirrored):
    """x grows with u, y against v, which points down in an image; mirrored coordinates make left-handed frames."""
    corner = np.array([[0, 0], [1, 0], [1, 1], [0, 1]], float)
    u, v = corner[:, 0], 1.0 - corner[:, 1]
    for _ in range(turn):
        u, v = v, 1.0 - u
    uv = np.stack([1.0 - u if mirrored else u, v], axis=1)[SQUARE.faces]
    along = np.linalg.lstsq(corner, (1.0 - u if mirrored else u) - (1.0 - u if mirrored else u)[0], rcond=None)[0]
    up = -np.linalg.lstsq(corner, v - v[0], rcond=None)[0]
    texels = ws.texture_points(SQUARE, uv, 4, tangents=True).points
    for points in (texels, ws.vertex_points(SQUARE, uv=uv)):
        assert np.allclose(points.to_world([1.0, 0.0, 0.0])[:, :2], along, atol=1e-6)
        assert np.allclose(points.to_world([0.0, 1.0, 0.0])[:, :2], up, atol=1e-6)
        assert (points.tangent[:, 3] == (-1.0 if mirrored else 1.0)).all()


def test_faces_without_coordinates_have_unusable_tangents():
    uv = np.array([[[0, 1], [1, 1], [1, 0]], [[np.nan] * 2] * 3])
    points = ws.vertex_points(SQUARE, uv=uv)
    found = ws.sample_directions(points, 4)
    assert found.status.tolist() == [0, 0, 0, 7]
    assert ws.texture_points(SQUARE, np.nan_to_num(uv), 4).points.tangent is None
