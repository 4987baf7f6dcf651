"""Mitsuba's own chi-square harness on our samplers: `pip install mitsuba`, then `python tests/support/mitsuba_chi2.py`.

Its LLVM must be version 17 or newer (DRJIT_LIBLLVM_PATH). Its grid of 101 x 202 cells of the whole sphere resolves neither
narrow lobes nor an infinite density; those are left to `warpsample verify`. Prints a p-value for each case; exit status 1 if
it rejects one at its own level, 0.01 shared by all.
"""

import sys
from collections import Counter

import mitsuba as mi
import numpy as np
import warp as wp

wp.config.log_level = wp.LOG_WARNING
mi.set_variant("llvm_ad_rgb")

from mitsuba import chi2  # noqa: E402  (after the variant)

import warpsample as ws  # noqa: E402
from warpsample.proof import verify  # noqa: E402
from warpsample.statistics.charts import PLANE, SPHERE  # noqa: E402

FINE = 64  # subintervals of a cell in its quadrature: at its default, 4, it rejects correct samplers
LEVEL = 0.01
NARROWEST = 0.05  # radians within which half of all directions must not lie


def domain(case):
    if case.measure == "per steradian":
        return chi2.SphericalDomain()
    if case.measure == "per unit area":
        return chi2.PlanarDomain(mi.ScalarBoundingBox2f([-1.0, -1.0], [1.0, 1.0]))
    return chi2.LineDomain([-np.pi, np.pi])


def sample(case, u):
    """Mitsuba's points of its domain from its variates."""
    w = case.sample(np.array(u).T.astype(np.float32))
    if case.measure == "per radian":
        return mi.Vector2f(np.stack([PLANE.polar(w), 0 * w[:, 0]]).astype(np.float32))
    return (mi.Vector3f if case.width == 3 else mi.Vector2f)(np.ascontiguousarray(w.T))


def pdf(case, p):
    w = PLANE.point(np.array(p, np.float64), 0.0) if case.measure == "per radian" else np.array(p).T
    return mi.Float(case.pdf(w.astype(np.float32)))


def resolved(case):
    w = case.sample(ws.sample_square("sobol", 1, 1024)[0])
    return case.width == 2 or np.median(SPHERE.polar(w)) > NARROWEST


def main():
    cases = [case for case in verify.cases() if resolved(case)]
    outcomes = []
    for case in cases:
        test = chi2.ChiSquareTest(
            domain(case), lambda u, case=case: sample(case, u), lambda p, case=case: pdf(case, p), ires=FINE
        )
        passed = test.run(LEVEL, test_count=len(cases), quiet=True)
        total = float(test.pdf_sum[0])
        outcomes.append("accepted" if passed else "REJECTED" if abs(total - 1.0) <= 1e-3 else "not resolved")
        print(f"{test.p_value:.3f} {outcomes[-1]} {case!r}, density sums to {total:.5f}", flush=True)
    print(f"Mitsuba {mi.__version__}, 10^6 draws each: {dict(Counter(outcomes))}")
    return int("REJECTED" in outcomes)


if __name__ == "__main__":
    sys.exit(main())
