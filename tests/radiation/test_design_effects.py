"""Variances of hits by their replicates and by those of numbers like them, against the formula in plain Python."""

from math import floor, log2
from statistics import mean, variance

import numpy as np
import pytest
from scipy.optimize import brentq

from warpsample.radiation.exchange.design_effects import factors_and_variances


def by_hand(hits, rays):
    """The variance of each share, number by number."""
    replicates, rows = len(hits[0]), [list(map(int, row)) for row in hits]
    alone = [sum(row) * (1.0 - sum(row) / rays) for row in rows]
    kinds = [max(0, floor(log2(a)) + 1) if a > 0.0 else 0 for a in alone]
    if replicates == 1:
        return [2.0 ** (-kind / 4) * a / rays**2 for kind, a in zip(kinds, alone, strict=True)]
    spread = [replicates * variance(row) for row in rows]
    ratios = [(kind, s / a) for kind, a, s in zip(kinds, alone, spread, strict=True) if a > 0.0]
    power = brentq(lambda x: mean(ratio * 2.0 ** (x * kind) for kind, ratio in ratios) - 1.0, 0.0, 1.0)
    found = []
    for kind, a, s in zip(kinds, alone, spread, strict=True):
        like = [ratio for other, ratio in ratios if other == kind]
        effect = (sum(like) + 2.0 ** (-power * kind)) / (len(like) + 1)
        found.append((4.0 * effect * a + (replicates - 1) * s) / (3.0 + replicates) / rays**2)
    return found


@pytest.mark.parametrize("replicates", [1, 2, 4, 16])
def test_variances_are_those_of_the_formula(replicates):
    """Of hits that vary less than independent ones where they are many; all and none hit are among them."""
    rng = np.random.default_rng(2)
    rays, each = 4096, 4096 // replicates
    share = np.exp2(-rng.uniform(0.5, 13.0, 300))
    steady = np.round(each * share[:, None] + 0.6 * rng.normal(size=(300, replicates)) * np.sqrt(each * share)[:, None])
    rare = rng.binomial(each, share[:, None], (300, replicates))
    hits = np.clip(np.where(share[:, None] > 0.01, steady, rare), 0, each).astype(np.int32)
    hits[0], hits[1] = 0, each
    value, found = factors_and_variances(hits, rays)
    assert np.array_equal(value, hits.sum(axis=1) / rays)
    # 20 halvings find the power to 1e-6, of which a class has 12 times that.
    assert found == pytest.approx(by_hand(hits, rays), rel=1e-4, abs=0.0)
    assert found[:2].tolist() == [0.0, 0.0]
