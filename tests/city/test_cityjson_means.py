"""Means over the surfaces of a city: exact where they must be, with error bars that hold, and with what stands around."""

import city_files as cases
import numpy as np
import pytest

import warpsample as ws


@pytest.fixture
def path(tmp_path):
    return cases.written(tmp_path / "a.json", cases.house())


def row(city, kind):
    return list(city.surfaces.type).index(kind)


def test_points_are_on_their_triangles_by_area_and_none_on_the_ground(path):
    city = ws.load_city(path, context="ground")
    points = city.points(2000, seed=3)
    each = np.bincount(points.face, minlength=len(city.surface))
    ground = (city.surface == row(city, "GroundSurface")) | (city.surface < 0)
    assert (each[ground] == 0).all()
    share = city.mesh.face_areas / city.mesh.face_areas[~ground].sum()
    assert np.abs(each - 2000 * share)[~ground].max() <= 2.0
    assert (each[~ground] >= 2).all()
    corner = city.mesh.vertices[city.mesh.faces[points.face]]
    across = np.cross(corner[:, 1] - corner[:, 0], corner[:, 2] - corner[:, 0])
    sides = [np.cross(corner[:, (k + 1) % 3] - corner[:, k], points.position - corner[:, k]) for k in range(3)]
    assert min(np.einsum("pi,pi->p", side, across).min() for side in sides) >= -1e-6
    assert np.abs(np.einsum("pi,pi->p", points.position - corner[:, 0], points.normal)).max() < 1e-6
    roof = points.position[city.surface[points.face] == row(city, "RoofSurface")]
    # Uniform by area about the shaft in the middle: the mean of each axis to four standard errors, 10 / sqrt(12 N).
    assert roof.mean(axis=0)[:2] - cases.TRANSFORM["translate"][:2] == pytest.approx(
        5.0, abs=4 * 10 / np.sqrt(12 * len(roof))
    )


def test_the_mean_of_a_linear_value_is_that_of_the_surface(path):
    """By area over triangles of any size, within four of its error bars; the height of the walls is 2.5 m in the mean."""
    city = ws.load_city(path)
    points = city.points(400)
    height = points.position[:, 2] - city.mesh.bounds[0, 2]
    values, errors, areas = city.surface_means(height, points=points)
    wall, roof, ground = (row(city, kind) for kind in ("WallSurface", "RoofSurface", "GroundSurface"))
    assert values[wall] == pytest.approx(2.5, abs=4 * errors[wall])
    assert 0.0 < errors[wall] < 0.2
    assert (values[roof], errors[roof]) == (pytest.approx(5.0), pytest.approx(0.0, abs=1e-9))
    assert np.isnan([values[ground], errors[ground]]).all()
    assert areas.tolist() == city.surfaces.area.tolist()


@pytest.mark.parametrize("sequence", ["independent", "sobol"])
def test_places_and_the_directions_there_are_independent(path, sequence):
    """By the same seed they were the same numbers, sample 0 of `independent`."""
    city = ws.load_city(path)
    points = city.points(20_000, seed=5)
    drawn = ws.sample_square(sequence, len(points), 1, seed=5)[:, 0]
    corner = city.mesh.vertices[city.mesh.faces[points.face]]
    side = corner[:, 2] - corner[:, 0]
    part, whole = (np.cross(side, to - corner[:, 0]) for to in (points.position, corner[:, 1]))
    weight = np.linalg.norm(part, axis=1) / np.linalg.norm(whole, axis=1)  # of corner 1, barycentric
    score = np.abs(np.corrcoef(weight, drawn.T)[0, 1:]) * np.sqrt(len(points))
    assert score.max() < 5.0  # standard deviations of the correlation of independent numbers


def test_centres_of_triangles_do_without_points(path):
    city = ws.load_city(path)
    values, errors, _ = city.surface_means(
        city.mesh.vertices[city.mesh.faces][:, :, 2].mean(axis=1), np.full(len(city.surface), 0.3)
    )
    wall = city.surface == row(city, "WallSurface")
    share = city.mesh.face_areas[wall] / city.mesh.face_areas[wall].sum()
    assert errors[row(city, "WallSurface")] == pytest.approx(0.3 * np.sqrt(np.square(share).sum()))
    assert values[row(city, "RoofSurface")] == pytest.approx(3.5)


def test_what_stands_around_takes_the_view_and_gets_no_numbers(path):
    """Of a wall on open ground half of the lobe meets the ground; no ground, and it is open. The sky is above either."""
    found = {}
    for name, context in (
        ("none", None),
        ("plane", "ground"),
        ("far", ([[8e4, 4.4e5, 9e3], [8.1e4, 4.4e5, 9e3], [8e4, 4.41e5, 9e3]], [[0, 1, 2]])),  # 8 km away
    ):
        city = ws.load_city(path, context=context, split=True)
        points = city.points(300, seed=1)
        outer = 3  # the row of a wall that looks outward
        for quantity in (ws.ambient_occlusion, ws.sky_view_factor):
            compute_means = quantity(city.mesh, points, 64)
            values, _, _ = city.surface_means(compute_means, points=points)
            assert len(values) == len(city.surfaces) == 10
            found[name, quantity.__name__] = values[outer]
    assert found["none", "ambient_occlusion"] == found["far", "ambient_occlusion"] == 1.0
    # The plane ends 300 m away, 1 degree below the horizon: of the lobe sin(1 degree) / 2 at most; and some rays' noise.
    assert found["plane", "ambient_occlusion"] == pytest.approx(0.505, abs=0.02)
    for name in ("none", "plane", "far"):
        assert found[name, "sky_view_factor"] == pytest.approx(0.5, abs=0.01)


def boxes():
    """Six houses, 8 m apart and 4 to 16 m high: low roofs see the high walls a little."""
    rng, vertices, solids = np.random.default_rng(0), [], []
    for number in range(6):
        first, (x, y) = len(vertices), (18000 * (number % 3), 18000 * (number // 3))
        top = int(4000 + 12000 * rng.random())
        vertices += [[x + a, y + b, z] for z in (0, top) for a, b in cases.SQUARE]
        faces = [[[3, 2, 1, 0]], [[4, 5, 6, 7]], *([[i, (i + 1) % 4, 4 + (i + 1) % 4, 4 + i]] for i in range(4))]
        semantics = cases.SEMANTICS | {"values": [[0, 1, 2, 2, 2, 2]]}
        moved = [[[first + corner for corner in ring] for ring in face] for face in faces]
        solids.append({"type": "Solid", "lod": "2", "boundaries": [moved], "semantics": semantics})
    houses = {str(number): {"type": "Building", "geometry": [solid]} for number, solid in enumerate(solids)}
    return cases.house(CityObjects=houses, vertices=vertices)


def test_no_error_is_0_where_rays_may_have_missed_a_wall(tmp_path):
    """Of 240 means at 64 rays, 21 had an error of 0 and were wrong by 1e-3: 1.0 in place of 0.9988."""
    city = ws.load_city(cases.written(tmp_path / "a.json", boxes()))

    def compute_means(count, rays, seed):
        points = city.points(count, seed=seed)
        found = ws.sky_view_factor(city.mesh, points, rays, seed=seed)
        return [
            np.array(city.surface_means(*values, points=points)[:2])
            for values in ((found,), (found.value, found.standard_error))
        ]

    right = compute_means(40_000, 256, 99)[0][0]
    runs = [compute_means(240, 64, seed) for seed in range(8)]  # about four points per triangle
    raised, plain = (np.array([run[way] for run in runs]) for way in (0, 1))
    wrong = np.abs(raised[:, 0] - right) > 1e-3
    assert ((plain[:, 1] == 0.0) & wrong).any()
    assert not ((raised[:, 1] == 0.0) & wrong).any()
    assert np.array_equal(raised[:, 0], plain[:, 0], equal_nan=True)
    is_open = right == 1.0  # the tallest roof, above which nothing is
    assert is_open.sum() == 1
    assert (raised[:, 1][:, is_open] == 0.0).all()
    ordinary = plain[:, 1] > 0.0
    squares = [np.square(runs[:, 1][ordinary]).sum() for runs in (raised, plain)]
    # Zero errors of values do not tell that a roof may vary, so the variances are pooled over other roofs: 5 % either way.
    assert 0.95 < squares[0] / squares[1] < 1.05


@pytest.mark.slow
def test_the_error_bars_of_a_real_city_hold(repository):
    """Of 118 roofs and walls of 3DBAG: the mean squared error is that of the bars, and 95 % are within about two."""
    city = ws.load_city(repository / "tests/city/data/3dbag_901.city.jsonl")

    def compute_means(count, rays, seed):
        points = city.points(count, seed=seed)
        found = ws.sky_view_factor(city.mesh, points, rays, seed=seed)
        return np.array(city.surface_means(found.value, found.standard_error, points=points)[:2])

    right, rest = compute_means(200_000, 256, 99)
    known = np.isfinite(right)
    assert np.count_nonzero(known) == 118
    runs = np.array([compute_means(None, 32, seed) for seed in range(16)])[:, :, known]
    squares = np.square(runs[:, 0] - right[known])
    bars = np.square(runs[:, 1]) + np.square(rest[known])
    # The largest tenth of the surfaces makes most of the sum, of which 16 runs know it to about sqrt(2 / 200) = 10 %.
    assert squares.sum() / bars.sum() == pytest.approx(1.0, abs=0.4)
    # Some bars are of a few points whose values are alike by chance: 95 % of a normal one, less some.
    assert (squares <= 4.0 * bars).mean() > 0.9


def on_faces(faces):
    return ws.SurfacePoints(np.zeros((len(faces), 3)), np.ones((len(faces), 3)), np.array(faces, np.int32))


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda city: city.surface_means([1.0]), r"values: got shape \(1,\), want \(\d+,\), one for each point"),
        (lambda city: city.surface_means(np.zeros(len(city.surface)), [0.0]), r"error: got shape \(1,\), want"),
        (
            lambda city: city.surface_means(ws.sky_view_factor(city.mesh, city.points(9), 4), 0.1),
            "error: got errors for a result as values, want None",
        ),
        (
            lambda city: city.surface_means(ws.bent_normals(city.mesh, city.points(9), 4), points=city.points(9)),
            r"values: got shape \(\d+, 3\), want \(\d+,\), one for each point",
        ),
        (lambda city: city.surface_means("x"), "values: got 'x', want real numbers"),
        (
            lambda city: city.surface_means(np.ones(2), points=ws.SurfacePoints(np.zeros((2, 3)), np.ones((2, 3)))),
            "points: got 2 points without faces, want points on the city's surfaces, with their faces, as from City.points",
        ),
        (
            lambda city: city.surface_means(np.ones(2), points=on_faces([3, 99])),
            r"points: got the face 99 for \d+ triangles, want points on the city's surfaces",
        ),
        (
            lambda city: (around := ws.load_city(city.path, context="ground")).surface_means(
                np.ones(2), points=on_faces(np.flatnonzero(around.surface < 0)[[0, -1]])
            ),
            "points: got 2 points on the context alone, want points on the city's surfaces",
        ),
        (lambda city: city.points(0), "count: got 0, want a whole number from 1"),
        (lambda city: city.points(seed=-1), "seed: got -1, want"),
        (
            lambda city: ws.load_city(city.path, context="grond"),
            "context: got 'grond', want a mesh; warpsample.load_mesh reads",
        ),
        (
            lambda city: ws.load_city(city.path, context=3),
            "context: got a value of type int, want 'ground', a RasterSurface, a warpsample.Mesh",
        ),
        (lambda city: ws.load_city(city.path, split=1), "split: got 1, want True or False"),
        (lambda _: ws.load_city(7), "path: got 7, want the path of a CityJSON file"),
        (lambda _: ws.load_city("nowhere.json"), "path: got 'nowhere.json', which is missing, want a CityJSON file"),
    ],
)
def test_bad_arguments(path, call, message):
    with pytest.raises((TypeError, ValueError, FileNotFoundError), match=f"^{message}"):
        call(ws.load_city(path))
