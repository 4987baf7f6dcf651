"""The worst errors of a distribution's directions against float64, of its local map and about normals."""

import numpy as np

from warpsample.directions.sample import sample_directions, sample_square
from warpsample.distributions.cosine_hemisphere import CosineHemisphere
from warpsample.distributions.record import Distribution
from warpsample.proof import laws, twins
from warpsample.proof.evidence import Evidence, Subject
from warpsample.proof.stress import exact_directions

_EVERY = 64  # the sweep's step through the 2^24 variates
_POINTS, _SAMPLES = 2048, 64


def worst_errors(case: Distribution) -> dict[str, float]:
    """The worst "length", "angle" and "pdf", over a grid of variates, and about random normals in world coordinates."""
    local = Evidence(Subject(repr(case), case, case), every=_EVERY).sweep
    if case.width == 2:
        return {name: local[name] for name in ("length", "angle", "pdf") if name in local}
    normals = np.random.default_rng(1).normal(size=(_POINTS, 3)).astype(np.float32)
    got = sample_directions(normals, _SAMPLES, distribution=case, sequence="independent", pdf=True)
    w = got.vectors.astype(np.float64)
    exact, in_frame = exact_directions(case, normals, sample_square("independent", len(normals), _SAMPLES))
    # Where the offset method draws its rim anew, by another hash, it has no twin.
    kept = 2.0 * np.pi * got.pdf > 2.0**-6 * 1.001 if case == CosineHemisphere("offset") else np.ones(w.shape[:2], bool)
    world = {
        "length": laws.length_error(w),
        "angle": laws.angle_error(w[kept], exact[kept]),
        "pdf": laws.density_error(got.pdf[kept], twins.density(case, in_frame)[kept]),
    }
    return {name: max(local[name], world[name]) for name in world}
