"""The benchmark of errors: its integrals are right, and so is what it makes of them."""

import numpy as np
import pytest
from bench_output import draw_pictures, lines_of, untracked
from scipy.stats import norm

import warpsample as ws
from warpsample.bench import error
from warpsample.bench.rows import Spread
from warpsample.bench.running import timing
from warpsample.bench.tools.integrands import INTEGRANDS, compute_estimates, evaluate


@pytest.mark.thorough
@pytest.mark.parametrize("integrand", INTEGRANDS, ids=lambda i: i.name)
def test_known_means_are_right(integrand, plausible):
    """By 2^22 independent directions and, to 1e-4, by Sobol'."""
    w = ws.CosineHemisphere().sample(ws.sample_square("independent", 1 << 16, 64, seed=5))
    values = evaluate(integrand, w).astype(np.float64)
    plausible(2.0 * norm.sf(abs(values.mean() - integrand.mean) / values.std() * np.sqrt(values.size)))
    w = ws.CosineHemisphere().sample(ws.sample_square("sobol", 4, 1 << 18, seed=5))
    assert abs(evaluate(integrand, w).astype(np.float64).mean() - integrand.mean) <= 1e-4


@pytest.mark.thorough
@pytest.mark.parametrize("sequence", ["sobol", "stratified"])
@pytest.mark.parametrize("count", [4, 100])
def test_fused_means_are_those_of_the_directions(sequence, count):
    sky = next(i for i in INTEGRANDS if i.name == "sky gradient")
    got = compute_estimates(sky, sequence, count, 50, seed=3, workers=2)
    w = ws.CosineHemisphere().sample(ws.sample_square(sequence, 50, count, seed=3))
    assert np.abs(got - evaluate(sky, w).astype(np.float64).mean(axis=1)).max() <= 2e-7  # the frame about +z rounds


@pytest.mark.thorough
def test_every_sequence_is_measured(monkeypatch, capsys, tmp_path):
    monkeypatch.setattr(error, "INTEGRANDS", INTEGRANDS[2:3])
    monkeypatch.setattr(timing, "WARM_UP", 0.0)
    settings = {"randomisations": 64, "largest": 64, "repeats": 1}
    found = error.measure(untracked, **settings)
    by_sequence = {name: [p for p in found["points"] if p.sequence == name] for name in ws.sequences.names()}
    for points in by_sequence.values():
        assert [p.count for p in points] == [4, 16, 64]
        assert all(p.randomisations * p.count >= 1 << 21 for p in points)
    assert abs(error.fit_slope(by_sequence["independent"]) + 0.5) <= 0.05  # of 32,768 estimates: within 0.4 % (one sigma)
    assert error.fit_slope(by_sequence["sobol"]) <= -1.0
    assert error.estimate_time(by_sequence["sobol"], 0.02)[1] is False
    assert error.estimate_time(by_sequence["independent"], 1e-3)[1] is True
    lines = lines_of("error", settings, found, capsys)
    assert [line for line in lines if line.startswith(" sky gradient") and " ~" in line]
    assert draw_pictures("error", found, tmp_path) == ["error.png"]


def test_a_time_to_an_error_lies_on_the_line_between_its_neighbours():
    data = ((4, 1e-1, 1.0), (16, 1e-2, 4.0), (64, 1e-3, 16.0))
    points = [error.ErrorPoint("f", "sobol", n, 64, e, Spread(t, t, t)) for n, e, t in data]
    assert error.estimate_time(points, 10**-2.5) == (pytest.approx(8.0), False)
    assert error.estimate_time(points, 1e-4) == (pytest.approx(64.0), True)
    assert error.estimate_time(points, 0.5) == (1.0, True)
    assert error.estimate_time(points[:2], 1e-4) is None  # one point alone has no slope
    times = [row.time for target in (10**-2.5, 1e-4, 0.5) for row in error.list_times(points, target)]
    assert times == ["8", "~64", "<1"]
    assert [row.time for row in error.list_times(points[:2], 1e-4)] == ["never"]
