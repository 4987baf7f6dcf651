"""The benchmark of what comes before the work: new processes."""

from pathlib import Path

import pytest
from bench_output import draw_pictures, lines_of, untracked

from warpsample.bench import startup


@pytest.mark.thorough
def test_startup_compile_once(monkeypatch):
    run, built = startup._run, []

    def watched(script, folder):
        before = set(Path(folder).rglob("*.o"))
        seconds = run(script, folder)
        built.append(len(set(Path(folder).rglob("*.o")) - before))
        return seconds

    monkeypatch.setattr(startup, "_run", watched)
    found = startup.start_processes()
    assert set(found) == {(cache, step) for cache in startup.CACHES for step in startup.STEPS}
    assert min(found.values()) >= 0.0
    assert built[0] >= 2  # directions, and a further kernel
    assert built[2] >= 2  # points, and their occlusion
    assert built[1::2] == [0, 0]


def test_waits_are_shown(monkeypatch, capsys, tmp_path):
    times = iter(range(1, 100))
    fake = lambda: {(c, s): float(next(times)) for c in startup.CACHES for s in startup.STEPS}  # noqa: E731
    monkeypatch.setattr(startup, "start_processes", fake)
    found = startup.measure(untracked, repeats=3)
    assert [len(wait.seconds) for wait in found["waits"]] == [3] * len(found["waits"])
    lines = lines_of("startup", {}, found, capsys)
    assert [line for line in lines if line.startswith(" first points and their occlusion ")]
    assert draw_pictures("startup", found, tmp_path) == ["startup.png"]
