"""Work is counted, since a margin that is too wide, or a bad order of visits, costs time and changes no answer."""

import pytest

import warpsample as ws
from warpsample.bench import scenes
from warpsample.bench.tools.tracers import count_visits

# (rays cast, points that none is cast from) of 1,000 points, as it was on 2026-11-21.
WORK = {
    ("bunny", 64): (52256, 29),
    ("bunny", 300): (170316, 29),
    ("bunny", 500): (147840, 30),
    ("city", 64): (52672, 109),
    ("city", 300): (224028, 109),
    ("city", 500): (308056, 109),
}

# Nodes and leaves visited by a ray, on average, on that day; renewed on 2026-11-23, as often as the random numbers changed.
VISITS = {
    ("camera", True): (2.3738, 0.8186),
    ("camera", False): (2.4106, 0.9753),
    ("outward", True): (3.7256, 1.9666),
    ("outward", False): (3.8843, 2.1594),
    ("inward", True): (4.0872, 2.1934),
    ("inward", False): (6.5081, 4.3665),
    ("random", True): (2.6484, 0.9849),
    ("random", False): (2.9392, 1.2021),
}


@pytest.mark.parametrize(("name", "count"), WORK)
def test_no_more_rays_are_cast_than_it_takes(bunny, name, count):
    mesh = bunny if name == "bunny" else scenes.city(12)
    found = ws.ambient_occlusion(mesh, ws.sample_surface(mesh, 1000, seed=9), count)
    rays, open_points = WORK[name, count]
    assert found.rays.sum() <= 1.001 * rays  # the mesh's own normals may be rounded otherwise elsewhere
    assert found.skipped.open_points >= open_points - 1


@pytest.mark.parametrize(("kind", "any_hit"), VISITS)
def test_no_more_is_visited_than_it_takes(bunny, kind, any_hit):
    visits = count_visits(bunny, kind, 1 << 12, any_hit)
    assert max(seen / known for seen, known in zip(visits, VISITS[kind, any_hit], strict=True)) <= 1.001
