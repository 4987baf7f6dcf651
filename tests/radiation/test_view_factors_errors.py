"""Are the error bars of view factors honest: squared error over squared bar, over many seeds."""

import numpy as np
import pytest
import trimesh
from view_factor_cases import CASES, GROUND, LID, X, Y, Z, box, rectangle, scene

import warpsample as ws

pytestmark = pytest.mark.slow  # seconds each, and kernels to compile; .ci/run runs them too

SCENE, POLYGON = scene(
    GROUND,
    LID,
    rectangle((0.25, 0.25, 0.5), 0.5 * X, 0.5 * Y),
    rectangle((0, 0, 0), Y, 0.3 * Z),
    *box(0.2, (0.8, 0.8, 0.2), False),
)


def runs(seeds, **options):
    return [ws.view_factors(SCENE, 256, seed=seed, up=Z, **options) for seed in range(seeds)]


def ratios(values, bars, right):
    """Mean squared error over mean squared bar of each number that occurs."""
    errors = np.mean(np.square(np.array(values) - right), axis=0)
    squares = np.mean(np.square(bars), axis=0)
    return errors[squares > 0.0] / squares[squares > 0.0], errors[squares == 0.0]


def all_ratios(options, seeds):
    """Of all entries and of what meets no front."""
    right = ws.view_factors(SCENE, 2**18, seed=10**6, up=Z, **options)
    found = runs(seeds, **options)
    yield (
        "matrix",
        *ratios([v.matrix.toarray() for v in found], [v.standard_error.toarray() for v in found], right.matrix.toarray()),
    )
    for name in ("outside", "behind", "sky", "ground"):
        values, bars = ([getattr(v, name + end) for v in found] for end in ("", "_error"))
        yield name, *ratios(values, bars, getattr(right, name))


def check_all(options, seeds, tightest):
    for name, ratio, unseen in all_ratios(options, seeds):
        assert ratio.mean() <= 1.3, name
        assert ratio.mean() >= tightest, name
        assert ratio.max() < 4.0, name
        assert unseen.max(initial=0.0) < 1e-6, name


KINDS = {
    "raw": ({}, 0.6),
    "one replicate": ({"replicates": 1}, 0.3),  # nothing tells how much better than independent rays they are
    "two replicates": ({"replicates": 2}, 0.6),
    "groups": ({"groups": POLYGON}, 0.6),
    "reciprocal": ({"reciprocal": True}, 0.6),
    "reciprocal groups": ({"groups": POLYGON, "reciprocal": True}, 0.6),
}


@pytest.mark.parametrize(
    "kind", [pytest.param(n, marks=pytest.mark.thorough if n in ("two replicates", "groups") else ()) for n in KINDS]
)
def test_errors_are_as_large_as_said(kind):
    options, tightest = KINDS[kind]
    check_all(options, 40, tightest)


@pytest.mark.thorough
@pytest.mark.parametrize("kind", KINDS)
def test_errors_are_as_large_as_said_over_200_seeds(kind):
    options, tightest = KINDS[kind]
    check_all(options, 200, tightest)


@pytest.mark.parametrize(
    "kind", ["raw", *(pytest.param(n, marks=pytest.mark.thorough) for n in ("groups", "reciprocal", "reciprocal groups"))]
)
def test_where_hits_are_few_the_bar_is_not_too_wide(kind):
    """A small face far away gets less than one of 256 rays; when pooled, its own rays to the ground tell more: 20, or 40.

    What the ground loses is then known as well as what it does not.
    """
    mesh, groups = scene(GROUND, rectangle((0, 0, 1), 0.1 * Y, 0.1 * X))
    options = {"groups": groups} if "groups" in kind else {}
    options |= {"reciprocal": True} if "reciprocal" in kind else {}
    right = ws.view_factors(mesh, 2**18, seed=10**6, **options)
    found = [ws.view_factors(mesh, 256, seed=seed, **options) for seed in range(200)]
    few = (right.matrix.toarray() > 0.0) & (right.matrix.toarray() * 512 < 4.0)
    values, bars = ([getattr(v, name).toarray()[few] for v in found] for name in ("matrix", "standard_error"))
    grounds = slice(0, len(right.outside) // 2)
    lost = [v.outside[grounds] for v in found], [v.outside_error[grounds] for v in found], right.outside[grounds]
    for ratio, _ in (ratios(values, bars, right.matrix.toarray()[few]), ratios(*lost)):
        assert 0.6 <= ratio.mean() <= 1.3


def of_box(height):
    """(6, 6) view factors of a box of base 1 x 1, exactly: rows and columns by the axis of their normal, twice."""

    def facing(x, y):
        """Of parallel rectangles, x and y gaps wide (Howell's C-11)."""
        a, b = np.hypot(1.0, x), np.hypot(1.0, y)
        total = np.log(a * b / np.sqrt(1.0 + x * x + y * y)) + x * b * np.arctan(x / b) + y * a * np.arctan(y / a)
        return 2.0 / (np.pi * x * y) * (total - x * np.arctan(x) - y * np.arctan(y))

    floor, wall = facing(1.0 / height, 1.0 / height), facing(1.0, height)
    to_wall = 0.25 * (1.0 - floor)
    to_floor = to_wall / height
    beside = 0.5 * (1.0 - wall - 2.0 * to_floor)
    three = np.array([[0, beside, to_floor], [beside, 0, to_floor], [to_wall, to_wall, 0]])
    return np.block([[three, three], [three, three]]) + np.roll(np.diag([wall, wall, floor] * 2), 3, axis=1)


@pytest.mark.thorough
@pytest.mark.parametrize("reciprocal", [False, True], ids=["raw", "reciprocal"])
@pytest.mark.parametrize("height", [1.0, 0.1, 0.01, 0.001])
def test_errors_in_rooms_are_as_large_as_said(height, reciprocal):
    """A cube, and rooms so flat that floor and ceiling see little else, group by group against the closed form.

    The bars of a room are alike, so few numbers tell them: of 120 seeds, to a tenth or so.
    """
    mesh = trimesh.creation.box((1.0, 1.0, height))
    mesh = ws.Mesh(mesh.vertices, mesh.faces[:, ::-1])
    groups = np.argmax(np.hstack([mesh.face_normals, -mesh.face_normals]), axis=1)
    found = [ws.view_factors(mesh, 4096, groups=groups, reciprocal=reciprocal, seed=seed) for seed in range(120)]
    values, bars = ([getattr(v, name).toarray() for v in found] for name in ("matrix", "standard_error"))
    ratio, _ = ratios(values, bars, of_box(height))
    assert 0.6 <= ratio.mean() <= 1.3
    seen = np.mean(np.array(bars) > 0.0, axis=0) == 1.0
    squares = np.square((np.array(values) - of_box(height))[:, seen] / np.array(bars)[:, seen])
    assert 0.6 <= squares.mean() <= 1.3


@pytest.mark.parametrize("reciprocal", [False, pytest.param(True, marks=pytest.mark.thorough)], ids=["raw", "reciprocal"])
def test_errors_of_known_factors_are_as_large_as_said(reciprocal):
    """Of scenes of two or three surfaces; one alone is told to 0.2 by its 40 seeds, and its faces are few."""
    found = []
    for polygons, right in CASES.values():
        mesh, groups = scene(*polygons)
        runs = [ws.view_factors(mesh, 1024, groups=groups, reciprocal=reciprocal, seed=seed) for seed in range(40)]
        ratio, _ = ratios([[v.matrix[0, 1]] for v in runs], [[v.standard_error[0, 1]] for v in runs], right)
        found.append(ratio[0])
    assert 0.6 <= np.mean(found) <= 1.3
    assert np.min(found) >= 0.3
    assert np.max(found) <= 2.5


@pytest.mark.thorough
def test_pooling_is_more_precise_than_one_side():
    """In a box of 192 faces, against 2^15 rays of each."""
    mesh = trimesh.creation.box().subdivide().subdivide()
    mesh = ws.Mesh(mesh.vertices, mesh.faces[:, ::-1])
    right = ws.view_factors(mesh, 2**15, seed=10**6, reciprocal=True).matrix.toarray()

    def rmse(**options):
        found = [ws.view_factors(mesh, 1024, seed=seed, **options).matrix.toarray() for seed in range(3)]
        return np.sqrt(np.mean([np.square(one - right) for one in found]))

    assert rmse(reciprocal=True) < 0.8 * rmse()


def narrow(kind):
    """(mesh, longest row) of a closed room all of whose rows are nearly settled by two large faces that see each other."""
    mesh, _ = scene(*box())
    if kind == "flat":
        return ws.Mesh(mesh.vertices * [1.0, 1.0, 0.001], mesh.faces)
    high = np.array([1.0, 0.0, np.tan(np.radians(0.1))])
    sides = [rectangle(0 * X, X, Y), rectangle(0 * X, Y, high), rectangle(X, high - X, Y)]
    return scene(*sides, [0 * X, high, X], [X + Y, high + Y, Y])[0]


@pytest.mark.parametrize("kind", ["flat", "wedge"])
def test_closing_a_narrow_room_spoils_no_factor(kind):
    """One factor for each row did: ten times as large errors as without, and rows that did not close to 1e-5."""
    mesh = narrow(kind)
    right = ws.view_factors(mesh, 2**16, seed=10**6).matrix.toarray()

    def rmse(**options):
        found = [ws.view_factors(mesh, 1024, seed=seed, **options) for seed in range(10)]
        for v in found:
            assert np.abs(v.matrix.sum(axis=1) + v.outside + v.behind - 1.0).max() < 1e-7
        return np.sqrt(np.mean([np.square(v.matrix.toarray() - right) for v in found]))

    # Ten times sixteen errors tell their root mean square to 6 percent, and a ratio of two to 8: three of these.
    assert rmse(reciprocal=True) < 1.25 * rmse()
