"""The benchmark of other tools: all have the same means, and one that had not would be seen."""

import re

import numpy as np
import pytest
from bench_output import drawn, lines_of

from warpsample.bench import peers
from warpsample.bench.integrands import INTEGRANDS
from warpsample.bench.peers import TASKS

CHOSEN = {
    "directions": [
        "warpsample independent",
        "warpsample sobol",
        "Warp built-ins, polar",
        "NumPy",
        "SciPy Sobol'",
        "Numba",
        "fill",
    ],
    "surface": ["warpsample surface", "trimesh surface"],
}


@pytest.fixture(scope="module")
def rows():
    """Those whose libraries the tests have, and one that may be missing."""
    sizes = {"directions": 4096, "surface": 10_000}
    return [row for task, points in sizes.items() for row in peers.compare(task, points, 2, CHOSEN[task])]


@pytest.mark.slow
def test_peers_have_the_same_means(rows):
    for row in rows:
        if row.peer == "fill":
            assert row.agrees is None
        elif row.failure is None:
            assert row.agrees, row
            assert row.ours.median > 0.0
            assert len(row.seconds) == 2
        else:
            assert re.match("not installed: pip install numba|[A-Za-z]+Error: ", row.failure)
    assert sum(row.failure is None for row in rows) >= 7


def test_a_peer_with_another_mean_is_called_wrong():
    means = {i.name: [i.mean, 1e-3] for i in INTEGRANDS}
    seconds = {"NumPy": [1.0], "warpsample independent": [0.5]}

    def judged():
        return peers.judge("directions", "NumPy", 1, workers=2, seconds=seconds, report={"library": "", "means": means})

    right = judged()
    assert right.agrees is True
    assert right.ours.median == 2.0
    assert right.threads == 1
    means["cosine"][0] += 5e-3
    assert judged().agrees is False
    means["cosine"][0] = means["half-space"][0] = np.nan
    assert judged().agrees is False
    means["cosine"][0] = 2.0 / 3.0
    assert judged().agrees is False


@pytest.mark.slow
def test_peer_tables_targets_and_pictures(rows, capsys, tmp_path):
    targets = peers.time_to_error(rows, 1, randomisations=64, largest=1 << 12)
    assert [t.integrand for t in targets] == ["sky gradient", "half-space"]
    for t in targets:
        assert t.samples < t.independent_samples / 5
        assert t.ratio == t.peer_microseconds / t.microseconds.median
    found = {"rows": rows, "time_to_error": targets}
    lines = lines_of("peers", {}, found, capsys)
    assert [line for line in lines if line.startswith(" NumPy")]
    assert [line for line in lines if line.startswith(" half-space")]
    assert drawn("peers", found, tmp_path) == ["peers.png"]


def test_every_peer_names_the_package_to_install():
    for task in TASKS.values():
        assert task.ours in task.tools
        assert all(tool.library for tool in task.tools.values())
