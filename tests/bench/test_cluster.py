"""The benchmark of the room `cluster`: what it counts, and that its plan follows from what it measured."""

import pytest
from bench_output import draw_pictures, lines_of, untracked

from warpsample.bench import cluster
from warpsample.bench.rows import Spread

SAME = Spread(1.0, 1.0, 1.0)
CASE = {
    "ways": [cluster.WayTime(way, 65_536, Spread(s, s, s), SAME) for way, s in (("one", 2.0), ("two", 1.0))],
    "overheads": [cluster.Overhead("computed", SAME), cluster.Overhead("into a store", Spread(4.0, 3.0, 5.0))],
}


def test_the_plan_follows_from_what_was_measured():
    """By hand: 15,259 chunks of 2 s each on one thread, which the scheduler hands out in 4 ms each."""
    hours = {row.threads: row.hours for row in cluster.plan_hours(CASE)}
    assert hours[1] == pytest.approx(15_259 * 2.0 / 3600)
    assert hours[128] == pytest.approx(120 * 2.0 / 3600)
    assert hours[8192] == pytest.approx(15_259 * 0.004 / 3600)


def test_the_bottleneck_is_named():
    bottlenecks = {row.threads: row.bottleneck for row in cluster.plan_hours(CASE)}
    assert bottlenecks[1] == bottlenecks[256] == "the work, up to 500 threads"
    assert bottlenecks[1024] == "the scheduler: take chunks of 3 times as many points"
    less = CASE | {"overheads": CASE["overheads"][:1]}
    assert cluster.plan_hours(less)[10].bottleneck == "the work, up to 2,000 threads"


@pytest.mark.thorough
def test_all_is_measured_and_shown(capsys, tmp_path):
    pytest.importorskip("distributed")
    pytest.importorskip("zarr")
    settings = {"points": 2000, "repeats": 2}
    found = cluster.measure(untracked, **settings)
    assert [(row.way, len(row.seconds)) for row in found["ways"]] == [(way, 2) for way in cluster.WAYS]
    assert all(row.duration.median > 0.0 and row.speed.median > 0.0 for row in found["ways"])
    assert [row.chunk for row in found["overheads"]] == ["computed", "into a store"]
    assert [
        line for line in lines_of("cluster", settings, found, capsys) if line.startswith(" two processes of one thread ")
    ]
    assert draw_pictures("cluster", found, tmp_path) == ["cluster.png"]
