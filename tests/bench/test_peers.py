"""The benchmark of other tools: all have the same means, and one that had not would be seen."""

import re

import numpy as np
import pytest
from bench_output import draw_pictures, lines_of

from warpsample.bench import peers
from warpsample.bench.tools.directions import DIRECTIONS

CHOSEN = ["warpsample independent", "Warp built-ins", "NumPy"]


@pytest.fixture(scope="module")
def rows():
    """Those whose libraries the tests have."""
    return peers.compare(CHOSEN, 4096, 2)


@pytest.mark.thorough
def test_peers_have_the_same_means(rows):
    for row in rows:
        if row.failure is None:
            assert row.agrees, row
            assert row.ours.median > 0.0
            assert len(row.seconds) == 2
        else:
            assert re.match("not installed: pip install |[A-Za-z]+Error: ", row.failure)
    assert sum(row.failure is None for row in rows) == 3


def test_a_peer_with_another_mean_is_called_wrong():
    values = 2.0 / 3.0 + 0.1 * np.float32([1.0, -1.0] * 5000)  # a standard error of 1e-3

    def worst(off):
        return peers.find_worst_deviation([(values + off, 2.0 / 3.0), (values, 2.0 / 3.0)])

    assert worst(0.0) < 0.1
    assert worst(5e-3) == pytest.approx(5.0, rel=0.01)
    assert np.isnan(worst(np.nan))
    judged = [peers.judge(DIRECTIONS["NumPy"], 2, worst(off)) for off in (0.0, 5e-3, np.nan)]
    assert [row["agrees"] for row in judged] == [True, False, False]
    assert judged[0]["threads"] == 1


@pytest.mark.thorough
def test_peer_tables_and_pictures(rows, capsys, tmp_path):
    found = {"rows": rows}
    lines = lines_of("peers", {}, found, capsys)
    assert [line for line in lines if line.startswith(" NumPy")]
    assert draw_pictures("peers", found, tmp_path) == ["peers.png"]


def test_every_peer_names_the_package_to_install():
    assert all(tool.library for tool in DIRECTIONS.values())
