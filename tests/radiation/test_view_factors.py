"""View factors against what is known of them: catalogues, enclosures, and what must not change them."""

import numpy as np
import pytest
from meshes import CLOSED, turned
from view_factor_cases import CASES, GROUND, LID, PIECE, STRIP, TETRAHEDRON, X, Y, Z, box, rectangle, scene, strip

import warpsample as ws

COURTYARD = ws.load_mesh("courtyard")


def factors(polygons, count=4096, **options):
    mesh, groups = scene(*polygons)
    return ws.view_factors(mesh, count, groups=groups, **options)


def closure(v):
    return v.matrix.sum(axis=1) + v.outside + v.behind


def test_known_factors_are_within_the_error_bars():
    z, errors = [], []
    for name, (polygons, right) in CASES.items():
        v = factors(polygons, 16384)
        error = v.matrix[0, 1] - right
        assert abs(error) <= 4.0 * v.standard_error[0, 1], name
        z.append(error / v.standard_error[0, 1])
        errors.append(error)
    assert np.sqrt(np.mean(np.square(z))) < 1.6
    assert np.sqrt(np.mean(np.square(errors))) < 1e-3


@pytest.mark.parametrize(
    ("polygons", "right"),
    [
        ((PIECE, strip((0, 0, 0), STRIP, Z), strip((1, 0, 0), Z, STRIP)), 0.4142135624),
        ((rectangle((0, -0.5, 0), Y, Z), strip((1, 0, 0), Z, STRIP), strip((0, 0, 0), X, STRIP)), 0.2928932188),
    ],
    ids=["ground", "wall"],
)
def test_a_canyon_as_high_as_wide_sees_the_sky(polygons, right):
    """In the mean of sixteen runs: where three faces are all, a bar has few degrees of freedom, their mean eighty."""
    runs = [factors(polygons, up=Z, seed=seed) for seed in range(16)]
    error = np.mean([v.sky[0] for v in runs]) - right
    assert abs(error) <= 4.0 * np.sqrt(np.mean([v.sky_error[0] ** 2 for v in runs]) / 16)
    assert all(v.ground[0] == 0.0 for v in runs)


@pytest.mark.parametrize(("polygons", "share"), [(TETRAHEDRON, 1.0 / 3.0), (box(), 0.2)], ids=["tetrahedron", "cube"])
def test_an_enclosure_closes(polygons, share):
    v = factors([corners[::-1] for corners in polygons] if len(polygons) == 4 else polygons)
    assert (v.outside == 0.0).all()
    assert (v.behind == 0.0).all()
    assert (closure(v) == 1.0).all()
    others = ~np.eye(len(polygons), dtype=bool)
    right = np.where(others, share if len(polygons) == 4 else v.matrix.toarray(), 0.0)
    assert (np.abs(v.matrix.toarray() - right) <= 4.0 * v.standard_error.toarray()).all()
    assert np.abs(v.matrix.toarray()[others] - share).max() < 0.01


@pytest.mark.parametrize("name", CLOSED)
def test_nothing_leaks_from_a_closed_mesh(name):
    outer = CLOSED[name][0]
    mesh = ws.Mesh(outer.vertices, outer.faces[:, ::-1])
    v = ws.view_factors(mesh, 256)
    escaped = v.outside * v.rays
    assert escaped.sum() <= 1e-6 * v.rays.sum()
    assert (np.round(v.matrix.sum(axis=1) * 256) + np.round((v.outside + v.behind) * 256) == 256).all()


def test_nothing_leaks_from_an_acute_edge_where_faces_are_small():
    """A closed wedge of 20 degrees in a scene so large that rays start a tenth of its height above its faces."""
    tip, high = np.array([0.0, 0.0, 0.0]), np.array([0.2, 0.0, 0.2 * np.tan(np.radians(20.0))])
    end, depth = np.array([0.2, 0.0, 0.0]), 0.2 * Y
    wedge = [
        rectangle(tip, end, depth),
        rectangle(tip, depth, high),
        rectangle(end, high - end, depth),
        [tip, high, end],
        [end + depth, high + depth, tip + depth],
    ]
    far = [(4000.0, 0.0, 4000.0), (4000.0, 1.0, 4000.0), (4000.0, 0.0, 4001.0)]
    mesh, groups = scene(*wedge, far)
    v = ws.view_factors(mesh, 4096, groups=groups)
    assert v.outside[:5].tolist() == v.behind[:5].tolist() == [0.0] * 5


def test_a_convex_body_in_another():
    mesh, number = scene(*box(2.0), *box(1.0, (0.1, -0.2, 0.3), inwards=False))
    v = ws.view_factors(mesh, 4096, groups=number // 6)
    assert v.matrix[1, 0] == 1.0
    assert abs(v.matrix[0, 1] - v.areas[1] / v.areas[0]) <= 4.0 * v.standard_error[0, 1]
    assert v.matrix[1, 1] == 0.0
    reciprocal = ws.view_factors(mesh, 4096, groups=number // 6, reciprocal=True)
    assert abs(reciprocal.matrix[0, 1] - 0.25) < 1e-6


@pytest.mark.parametrize("scale", [1e-5, 1.0, 1e5])
def test_neither_size_nor_place_matters(scale):
    base = ws.view_factors(COURTYARD, 64).matrix.toarray()
    moved = ws.Mesh(scale * COURTYARD.vertices, COURTYARD.faces)
    same = ws.view_factors(moved, 64)
    assert np.abs(same.matrix.toarray() - base).sum() <= 1e-4 * base.sum()
    assert same.areas == pytest.approx(scale**2 * COURTYARD.face_areas, rel=1e-9)


def test_far_from_the_origin_all_bits_are_the_same():
    far = ws.Mesh(COURTYARD.vertices + np.array([5e6, 4e6, 0.0]), COURTYARD.faces)
    one, other = ws.view_factors(COURTYARD, 64), ws.view_factors(far, 64)
    assert (one.matrix != other.matrix).nnz == 0
    assert (one.outside == other.outside).all()


def test_a_turned_scene_has_the_same_factors():
    mesh, groups = scene(*CASES["C-13"][0])
    v = ws.view_factors(ws.Mesh(mesh.vertices @ turned(3).T, mesh.faces), 16384, groups=groups)
    assert abs(v.matrix[0, 1] - CASES["C-13"][1]) <= 4.0 * v.standard_error[0, 1]


def test_halves_of_a_face_add_up_to_it():
    whole, parts = (
        [[0, 0, 0], [1, 0, 0], [0, 1, 0]],
        [[[0, 0, 0], [0.5, 0.5, 0], [0, 1, 0]], [[0, 0, 0], [1, 0, 0], [0.5, 0.5, 0]]],
    )
    one, two = factors([whole, LID], 16384), factors([*parts, LID], 16384)
    mean = 0.5 * (two.matrix[0, 2] + two.matrix[1, 2])
    error = np.hypot(one.standard_error[0, 1], 0.5 * np.hypot(two.standard_error[0, 2], two.standard_error[1, 2]))
    assert abs(one.matrix[0, 1] - mean) <= 4.0 * error
    there = two.matrix[2, 0] + two.matrix[2, 1]
    assert abs(one.matrix[1, 0] - there) <= 4.0 * (
        one.standard_error[1, 0] + two.standard_error[2, 0] + two.standard_error[2, 1]
    )


def test_a_flipped_face_is_met_from_behind():
    v, flipped = factors([GROUND, LID]), factors([GROUND, LID[::-1]])
    assert flipped.matrix.nnz == 0
    assert flipped.behind[0] == v.matrix[0, 1] > 0.0
    assert flipped.outside[0] == v.outside[0]
    assert flipped.outside[1] == 1.0
    # The same hits; but half of what they are compared with is gone, as no ray of the lid meets the ground.
    assert 0.5 < flipped.behind_error[0] / v.standard_error[0, 1] < 2.0


@pytest.mark.parametrize("turn", [0, 1], ids=["cut alike", "cut across"])
@pytest.mark.parametrize("seed", [0, 5])
def test_of_two_faces_back_to_back_the_one_turned_to_the_ray_is_met(turn, seed):
    """A slab without thickness between two squares, as two houses that share a wall."""
    above, below = rectangle((-1, -1, 0.5), 3 * X, 3 * Y), rectangle((-1, -1, 0.5), 3 * Y, 3 * X)
    mesh, groups = scene(GROUND, LID, above, below[turn:] + below[:turn])
    v = ws.view_factors(ws.Mesh(mesh.vertices @ turned(seed).T, mesh.faces), 1024, groups=groups)
    assert (v.behind == 0.0).all()
    assert v.matrix[0, 2] == v.matrix[1, 3] == v.matrix[0, 1] == 0.0
    assert v.matrix[0, 3] > 0.5
    assert v.matrix[1, 2] > 0.5
    assert np.abs(closure(v) - 1.0).max() < 1e-15


def test_a_ray_in_front_of_a_back_still_counts_as_behind():
    """A wall seen from its back, with a front 0.01 behind it that is not in the same place."""
    v = factors([GROUND, LID[::-1], rectangle((0, 0, 1.01), Y, X)])
    assert v.behind[0] > 0.19
    assert v.matrix[0, 2] < 0.01


def test_faces_without_area_have_empty_rows_and_columns():
    mesh, _ = scene(GROUND, LID)
    faces = np.concatenate([mesh.faces, [[0, 1, 1], [2, 2, 2]]])
    v, plain = ws.view_factors(ws.Mesh(mesh.vertices, faces), 256, up=Z), ws.view_factors(mesh, 256, up=Z)
    assert (v.matrix[:4, :4] != plain.matrix).nnz == 0
    assert v.matrix[4:].nnz == v.matrix[:, 4:].nnz == 0
    assert v.status.tolist() == [0, 0, 0, 0, ws.PointStatus.ZERO_NORMAL, ws.PointStatus.ZERO_NORMAL]
    assert v.rays.tolist() == [256] * 4 + [0, 0]
    assert v.outside[4:].tolist() == v.behind[4:].tolist() == v.sky[4:].tolist() == v.ground[4:].tolist() == [0.0, 0.0]
    assert v.skipped.points == 2
    reciprocal = ws.view_factors(ws.Mesh(mesh.vertices, faces), 256, reciprocal=True)
    assert np.isfinite(reciprocal.matrix.data).all()


def test_duplicates_share_what_meets_them_and_needles_count():
    needle = [(0, 0, 0.2), (1, 0, 0.2), (1, 1e-6, 0.2)]
    mesh, groups = scene(GROUND, LID, LID, needle)
    v, single = ws.view_factors(mesh, 1024, groups=groups), factors([GROUND, LID], 1024)
    assert v.matrix[0, 1] + v.matrix[0, 2] == pytest.approx(single.matrix[0, 1], abs=0.01)
    assert v.matrix[[3]].sum() + v.outside[3] + v.behind[3] == 1.0
    assert v.rays[3] == 1024


def test_open_faces_cast_no_ray_and_their_sky_is_exact():
    slope = [(0, 0, 0), (1, 0, 1), (1, 1, 1), (0, 1, 0)]
    v = factors([slope], up=(0, 0, 2.0))
    assert v.rays[0] == 0
    assert v.skipped.open_points == 2
    assert v.skipped.empty_rays == 2 * 4096
    assert v.outside[0] == 1.0
    assert v.sky[0] == pytest.approx(0.5 + 0.5 * np.sqrt(0.5), abs=1e-7)
    assert v.sky[0] + v.ground[0] == pytest.approx(1.0, abs=1e-15)
    assert v.sky_error[0] == 0.0


@pytest.mark.slow
def test_the_sky_of_a_courtyard_is_that_of_its_points():
    v = ws.view_factors(COURTYARD, 1024, up=(0, 0, 1))
    inside = ws.sky_view_factor(COURTYARD, ws.face_centers(COURTYARD), 1024)
    assert np.corrcoef(v.sky, inside.value.astype(np.float64))[0, 1] > 0.99
    assert np.abs(v.sky + v.ground - v.outside).max() < 1e-12
    assert (v.behind == 0.0).all()


def test_half_as_many_independent_rays_again_are_not_as_good():
    """The lattice against three times as many independent rays, on all faces of a cube."""
    mesh, _ = scene(*box())
    right = ws.view_factors(mesh, 2**20, seed=99).matrix.toarray()
    ours = [ws.view_factors(mesh, 4096, seed=seed).matrix.toarray() - right for seed in range(4)]
    spread = np.sqrt(np.mean(np.square(ours)))
    independent = np.sqrt(np.mean(right * (1.0 - right) / 4096))
    assert spread < independent / np.sqrt(3.0)


def test_independent_rays_of_our_own_agree():
    """Points of sample_surface, directions and trace, counted by NumPy."""
    mesh, _ = scene(*box(2.0), *box(1.0, (0.1, -0.2, 0.3), inwards=False))
    points = ws.sample_surface(mesh, 60_000, seed=3)
    ways = ws.sample_directions(points.normal, 1, distribution="cosine_hemisphere", sequence="independent", seed=4).vectors
    met = ws.trace(mesh, points, ways[:, 0]).face
    counts = np.zeros((24, 24))
    np.add.at(counts, (points.face[met >= 0], met[met >= 0]), 1.0)
    rays = np.bincount(points.face, minlength=24)[:, None]
    v = ws.view_factors(mesh, 4096)
    share = v.matrix.toarray()
    error = np.sqrt(np.maximum(share, 1e-3) * (1.0 - share) / rays + v.standard_error.toarray() ** 2)
    assert (np.abs(counts / rays - share) <= 5.0 * error).all()
