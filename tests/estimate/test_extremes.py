"""Scale and shape: needles, far-apart parts, vertices that nothing uses, huge and tiny coordinates."""

import warnings

import numpy as np
import pytest
import trimesh
from estimate_cases import same
from meshes import turned
from trimesh import creation

import warpsample as ws
from warpsample.bench import scenes

# Needles: what a ray starts from is never met by it, with skipping or without


def pipe(radius, length, sections=32, turn=0):
    made = creation.cylinder(radius, length, sections=sections)
    return ws.as_mesh((made.vertices @ turned(turn).T, made.faces))


@pytest.mark.parametrize("turn", [0, 1])
@pytest.mark.parametrize("radius", [*(pytest.param(r, marks=pytest.mark.slow) for r in (5.0, 0.5)), 0.05])
def test_a_convex_needle_sees_only_sky(radius, turn):
    """The aspect ratios are from 10^4 to 10^6."""
    mesh = pipe(radius, 1e5, turn=turn)
    for points in (ws.sample_surface(mesh, 3000, seed=1), ws.vertex_points(mesh), ws.face_centers(mesh)):
        skipping, plain = (ws.ambient_occlusion(mesh, points, 128, skip=skip) for skip in (True, False))
        assert skipping.value.min() == 1.0
        assert same(skipping, plain)


NEEDLES = {
    "slivers": lambda: trimesh.Trimesh(
        np.random.default_rng(1).uniform(-1, 1, (100, 3)).repeat(3, axis=0)
        + np.random.default_rng(2).normal(size=(300, 3)) * np.tile([[1.0], [1.0], [1e-6]], (100, 1)),
        np.arange(300).reshape(-1, 3),
        process=False,
    ),
    "fan": lambda: creation.cylinder(1.0, 1e-6, sections=200),
    "nested pipes": lambda: creation.cylinder(0.05, 1e5, sections=12) + creation.annulus(0.06, 0.07, 1e5, sections=12),
    "grid of hairs": lambda: sum(
        creation.cylinder(
            1e-3, 1e3, sections=6, transform=trimesh.transformations.translation_matrix([0.01 * i, 0.01 * j, 0])
        )
        for i in range(4)
        for j in range(4)
    ),
    "stretched bunny": lambda: None,
}


@pytest.mark.parametrize("turn", [pytest.param(0, marks=pytest.mark.slow), 2])
@pytest.mark.parametrize("name", NEEDLES)
def test_skipping_changes_no_bit_of_needles(bunny, name, turn):
    made = NEEDLES[name]()
    vertices, faces = (bunny.vertices * [1.0, 1.0, 1e6], bunny.faces) if made is None else (made.vertices, made.faces)
    mesh = ws.as_mesh((np.asarray(vertices) @ turned(turn).T, np.asarray(faces)))
    reach = 0.1 * mesh.diagonal
    corners = ws.vertex_points(mesh)
    some = slice(None, None, -(-len(corners) // 50))
    for points in (ws.sample_surface(mesh, 50, seed=5), ws.SurfacePoints(corners.position[some], corners.normal[some])):
        for count, options in ((64, {}), (300, {"max_distance": reach}), (500, {"max_distance": reach, "falloff": 1.0})):
            results = (ws.ambient_occlusion(mesh, points, count, **options, skip=skip) for skip in (True, False))
            assert same(*results)


# Maps


def far_city():
    city = scenes.city(8)
    return city.vertices + np.array([500_000.0, 5_400_000.0, 0.0]), city.faces


def test_a_vertex_that_no_face_uses_changes_nothing():
    vertices, faces = far_city()
    plain = ws.Mesh(vertices, faces)
    points = ws.sample_surface(plain, 500, seed=2)
    right = ws.ambient_occlusion(plain, points, 128)
    for stray in ([0.0, 0.0, 0.0], [1e30, 0.0, -1e30]):
        mesh = ws.Mesh(np.concatenate([[stray], vertices]), faces + 1)
        assert same(ws.ambient_occlusion(mesh, points, 128), right)
        assert mesh.diagonal == plain.diagonal
        assert np.array_equal(mesh.report.lower, plain.report.lower)


@pytest.mark.parametrize("distance", [1e4, 1e6, 1e8])
def test_a_marker_far_away_leaves_the_city_its_precision(distance):
    vertices, faces = far_city()
    plain = ws.Mesh(vertices, faces)
    points = ws.sample_surface(plain, 500, seed=2)
    marker = creation.box((10.0, 10.0, 10.0))
    both = np.concatenate([vertices, marker.vertices + vertices[0] + [distance, 0.0, 0.0]])
    mesh = ws.Mesh(both, np.concatenate([faces, marker.faces + len(vertices)]))
    found, right = ws.ambient_occlusion(mesh, points, 256), ws.ambient_occlusion(plain, points, 256)
    # Both start their rays within a millimetre of the surface. An edge between may take or leave one ray.
    assert np.abs(found.value - right.value).max() <= 2.0 / 256.0
    assert same(found, ws.ambient_occlusion(mesh, points, 256, skip=False))
    on = ws.sample_surface(ws.Mesh(both[-8:], marker.faces), 50)
    for face in (None, on.face + np.int32(len(faces))):
        assert ws.ambient_occlusion(mesh, ws.SurfacePoints(on.position, on.normal, face), 64).value.min() == 1.0


def test_parts_too_far_apart_for_their_faces_are_reported():
    vertices, faces = far_city()
    two = ws.Mesh(
        np.concatenate([vertices, vertices + np.array([1e8, 0.0, 0.0])]), np.concatenate([faces, faces + len(vertices)])
    )
    with pytest.warns(UserWarning, match=r"^mesh: got faces of size 33.9 \(median\) within 5e\+07 of their centre"):
        ws.trace(two, vertices[:1], np.float32([[0.0, 0.0, 1.0]]))
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        ws.trace(ws.Mesh(vertices, faces), vertices[:1], np.float32([[0.0, 0.0, 1.0]]))


def test_a_stray_vertex_so_far_that_points_are_moved_off_beyond_the_mesh_is_reported():
    mesh = ws.load_mesh("courtyard")
    vertices = mesh.vertices.copy()
    vertices[0] = 1e12  # a point is moved off its face by 2^-35 of 2^40, 32 m among buildings of 24 m
    with pytest.warns(UserWarning, match=r"^mesh: got faces of size .* where points are moved off their faces by about 32;"):
        ws.ambient_occlusion(ws.Mesh(vertices, mesh.faces), ws.face_centers(mesh), 2)
    vertices[0] = 1e7
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        ws.ambient_occlusion(ws.Mesh(vertices, mesh.faces), ws.face_centers(mesh), 2)


@pytest.mark.parametrize(("share", "warned"), [(0.9, 1), (1.1, 0)])
def test_the_warning_begins_where_faces_are_lost_in_the_lift(share, warned):
    """The limit is a longest edge of 2^-16 of the mesh's half size, which is eight offsets of 2^-19."""
    face = 2.0**-16.5 * share * np.array([(0.0, 0.0, 0.0), (1.0, 0.0, 0.0), (0.0, 1.0, 0.0)])
    far = np.concatenate([face - np.eye(3)[0], face + np.eye(3)[0]])
    with warnings.catch_warnings(record=True) as found:
        warnings.simplefilter("always")
        ws.trace((far, [(0, 1, 2), (3, 4, 5)]), np.zeros((1, 3)), np.array([[0.0, 0.0, 1.0]]))
    assert len(found) == warned


# Huge and tiny


@pytest.mark.parametrize("scale", [1e-28, 1e-12, 1.0, 1e20, 2.0**118])
def test_estimates_and_rays_do_not_depend_on_the_scale(bunny, scale):
    mesh = ws.Mesh(bunny.vertices * scale, bunny.faces)
    points = ws.sample_surface(mesh, 200, seed=3)
    ways = ws.sample_directions(points, 8).vectors
    hits = ws.trace(mesh, points, ways)
    assert np.array_equal(hits.face >= 0, np.isfinite(hits.distance))
    assert 1e-7 * scale <= hits.distance.min()
    near = ws.ambient_occlusion(mesh, points, 64, max_distance=0.3 * scale, falloff=1.0)
    assert 0.9 <= near.value.mean() < 1.0
    far = ws.ambient_occlusion(mesh, points, 64, max_distance=1e300, falloff=1.0)
    # t / max_distance is 0 for all that is met: nothing is left of it.
    assert np.array_equal(far.value, ws.ambient_occlusion(mesh, points, 64).value)


@pytest.mark.parametrize("coordinate", [3e38, 1e39, 1.7e308])
@pytest.mark.parametrize("dtype", [np.float32, np.float64])
def test_coordinates_beyond_what_distances_can_tell_are_refused(coordinate, dtype):
    with np.errstate(over="ignore"):
        vertices = (np.eye(3) * coordinate).astype(dtype)
    with pytest.raises(ValueError, match=r"vertices: got coordinates that are .*want coordinates from -1e\+36 to 1e\+36"):
        ws.Mesh(vertices, [[0, 1, 2]])


def test_meshes_too_small_for_distances_are_refused_where_distances_are_asked_for():
    tiny = ws.Mesh(np.eye(3) * 1e-40, [[0, 1, 2]])
    assert abs(ws.sample_surface(tiny, 10).position.sum() / 1e-39 - 1.0) <= 1e-12
    with pytest.raises(ValueError, match="mesh: got a mesh of half size 5e-41, want at least 1e-30; scale the mesh up"):
        ws.trace(tiny, [0.0, 0.0, 0.0], [[1.0, 0.0, 0.0]])


def test_meshes_too_small_for_areas_are_refused():
    with pytest.raises(ValueError, match="mesh: got a mesh of size 1e-161, want at least 1e-140"):
        ws.sample_surface(ws.Mesh(np.eye(3) * 1e-161, [[0, 1, 2]]), 10)


@pytest.mark.parametrize("length", [1e-300, 1e-50, 1e50, 1e300])
def test_normals_of_any_length_are_normals(length):
    """Their length is computed in float64, and the results are those of float32 normals."""
    up = np.random.default_rng(6).normal(size=(50, 3))
    scaled = up * 2.0 ** np.round(np.log2(length))
    assert np.array_equal(ws.sample_directions(scaled, 3).vectors, ws.sample_directions(up, 3).vectors)
    mesh = ws.as_mesh(creation.icosphere(1))
    found, right = (ws.ambient_occlusion(mesh, ws.SurfacePoints(2.0 * up, n), 64) for n in (scaled, up))
    assert same(found, right)
    assert found.counts() == {ws.PointStatus.OK: 50}


def test_a_light_too_bright_to_be_summed_is_refused():
    mesh = ws.as_mesh(creation.box())
    with pytest.raises(ValueError, match=r"radiance: got numbers below 0, above 1e\+37"):
        ws.irradiance(mesh, ws.face_centers(mesh), np.full((2, 4), 3e38))


def test_a_mask_that_lies_where_results_go_is_read_before():
    normals = np.random.default_rng(7).normal(size=(200, 3)).astype(np.float32)
    right = ws.sample_directions(normals, 16).vectors
    out = np.ones_like(right)
    active = out.reshape(-1).view(np.uint8)[:200].view(np.bool_)
    active[:] = True
    found = ws.sample_directions(normals, 16, active=active, out=out)
    assert np.array_equal(found.vectors, right)


def test_areas_of_tiny_faces_keep_their_digits():
    rng = np.random.default_rng(4)
    vertices, faces = rng.normal(size=(30, 3)), rng.permutation(30).reshape(-1, 3)
    mesh, small = (ws.Mesh(scale * vertices, faces) for scale in (1.0, 2.0**-250))
    assert np.abs(small.face_areas * 2.0**500 / mesh.face_areas - 1.0).max() <= 1e-15
    assert np.array_equal(small.face_normals, mesh.face_normals)


@pytest.mark.parametrize("far", [1e7, 1e20, 1e37, 3e38, 1e39, 1e160, 1.7e308])
def test_a_hit_has_a_finite_distance(far):
    mesh = ws.as_mesh(creation.icosphere(2))
    origins = np.array([[far, 0.01, 0.02]] * 2)
    hits = ws.trace(mesh, origins, np.array([[-1.0, 0.0, 0.0], [1.0, 0.0, 0.0]]))
    assert hits.invalid == 0
    assert np.array_equal(hits.face >= 0, np.isfinite(hits.distance))
    assert hits.face[1] == -1
    assert (hits.face[0] >= 0) == (far == 1e7)  # float64 does not tell where rays from farther off go
