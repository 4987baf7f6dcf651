"""The benchmark of directions: every map, sequence and count is measured."""

import pytest
from bench_output import draw_pictures, lines_of

import warpsample as ws
from warpsample.bench import directions
from warpsample.bench.running import timing


@pytest.fixture(scope="module")
def rows():
    groups = directions.list_groups(64)
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(timing, "WARM_UP", 0.0)
        return [row for group in (groups[0], groups[-6], groups[-2]) for row in directions.measure_group(*group, 2)]


def test_every_distribution_method_sequence_and_count_is_measured():
    names = {case.name for case in directions.list_maps()}
    assert names == set(ws.distributions.names())
    assert {case.method for case in directions.list_maps() if case.name == "cosine_hemisphere"} == {
        *("polar", "concentric", "inversion", "offset")
    }
    assert len(directions.list_groups(64)) == len(directions.list_maps()) + len(directions.COUNTS)


@pytest.mark.thorough
def test_rows_say_what_was_measured(rows):
    assert {row.points * row.samples for row in rows} == {4096}
    polar = [row for row in rows if row.distribution == "CosineHemisphere(method='polar')" and row.table == "maps"]
    assert {(row.workers, row.pdf) for row in polar} >= {(1, False), (1, True)}
    assert {row.sequence for row in rows if row.table == "sequences"} == {"", *ws.sequences.names()}
    assert {row.samples for row in rows} == {64}
    for row in rows:
        assert len(row.seconds) == 2
        assert min(row.seconds) > 0.0
        assert row.of_fill.low <= row.of_fill.median <= row.of_fill.high


@pytest.mark.thorough
def test_directions_tables_and_pictures(rows, capsys, tmp_path):
    found = {"rows": rows}
    lines = lines_of("directions", {}, found, capsys)
    assert [line for line in lines if line.startswith(" CosineHemisphere(polar)")]
    assert [line for line in lines if line.startswith(" independent")]
    assert len([line for line in lines if line.startswith(" fill ")]) == 3
    assert draw_pictures("directions", found, tmp_path) == ["directions.png"]
