"""Every law holds for every case of the registry; the maps take arrays, parameters and bad input as documented."""

import numpy as np
import pytest
import warp as wp

import warpsample as ws
from warpsample.distributions import as_distribution
from warpsample.proof import laws, routes, stress, verify

CASES = verify.cases()
COSINE = [case for case in CASES if isinstance(case, ws.CosineHemisphere)]


def independent_directions(distribution, count, seed=0):
    """Return N = 64 * count local directions of independent u."""
    return distribution.sample(ws.sample_square("independent", count, 64, seed=seed).reshape(-1, 2))


def broken(verdicts):
    return [verdict for verdict in verdicts if not verdict.passed]


def test_ten_laws_or_more_judge_every_case():
    """A lobe of another lobe may have neither an inverse nor a symmetry, for which there are further laws."""
    for case in CASES:
        assert sum(law.applies(case) for law in verify.LAWS) >= (8 if case.nested else 10)


GENERAL = ("mixture", "spherical_rectangle", "spherical_triangle")
"""Distributions whose quick case is general: eight lobes, or no symmetry and in part below the horizon."""


def tiered(cases, quick):
    """Return the cases as parameters: the last of each kind is slow, without those of seconds, and others are thorough."""
    further = [case for case in cases if case not in quick and case.name not in GENERAL]
    last = {case.name: case for case in further if getattr(case, "view", (0.0, 0.0, 1.0))[2] != 0.0}.values()
    marks = [() if case in quick else pytest.mark.slow if case in last else pytest.mark.thorough for case in cases]
    return [pytest.param(case, marks=mark) for case, mark in zip(cases, marks, strict=True)]


def mostly_slow(cases):
    """Return the cases as parameters: one of each kind is quick; slanted views and VisibleBeckmann take seconds."""
    straight = [case for case in cases if getattr(case, "view", (0.0, 0.0, 1.0)) == (0.0, 0.0, 1.0)]
    quick = {(case.name, getattr(case, "method", "")): case for case in straight if case.name != "visible_beckmann"}.values()
    return tiered(cases, list(quick))


@pytest.mark.parametrize("case", mostly_slow(CASES), ids=repr)
def test_every_law_holds(case):
    """The test takes every 64th variate and 2^18 draws; `warpsample verify` takes 16 times that number."""
    assert broken(verify.judge_case(case, every=64, draws=1 << 18)) == []


IN_SPACE = [case for case in CASES if case.width == 3]
LAST = {case.name: case for case in IN_SPACE}
FRAMED = (LAST["visible_ggx"], LAST["reflection"])  # frames are those of all lobes, so that few do


@pytest.mark.parametrize(
    "case",
    [IN_SPACE[0], *(pytest.param(c, marks=pytest.mark.slow if c in FRAMED else pytest.mark.thorough) for c in IN_SPACE[1:])],
    ids=repr,
)
def test_hostile_normals_are_survived(case):
    assert broken(stress.judge_normals(case)) == []


@pytest.mark.parametrize(
    "method", [pytest.param("polar", marks=pytest.mark.slow), pytest.param("offset", marks=pytest.mark.thorough)]
)
def test_cosine_lobe_is_correct_at_every_variate(method):
    """The test takes all 2^24 values of both coordinates; `verify --thorough` does so for all distributions."""
    case = ws.CosineHemisphere(method)
    found = verify.judge(verify.Evidence(verify.Subject(repr(case), case, case)), verify.LAWS[:6])
    assert len(found) == 6
    assert broken(found) == []


def test_second_routes_give_the_same_laws_and_maps():
    found = routes.judge_routes()
    assert len(found) >= 50
    assert broken(found) == []


@pytest.mark.parametrize("case", mostly_slow([c for c in CASES if c.maps.invert is not None and c.variates == 2]), ids=repr)
def test_invert_gives_uniform_variates(case, plausible):
    """Another method of the same density drew the directions; the inverse must make them uniform."""
    other = {"cosine_hemisphere": ws.CosineHemisphere("inversion"), "uniform_disk": ws.UniformDisk("polar")}
    u = case.invert(independent_directions(other.get(case.name, case), 4000, seed=2))
    for axis in (0, 1):
        plausible(laws.uniform_p_value(u[:, axis]))


@pytest.mark.parametrize("distribution", COSINE, ids=repr)
def test_cosine_lobe_moments_and_tails(distribution, plausible):
    z = np.concatenate([independent_directions(distribution, 1 << 15, seed)[:, 2] for seed in range(5)]).astype(np.float64)
    assert len(z) >= 10**7
    for power, mean, variance in ((z, 2.0 / 3.0, 1.0 / 18.0), (z * z, 0.5, 1.0 / 12.0)):
        assert abs(power.mean() - mean) <= 5.3 * np.sqrt(variance / len(z))  # p = 1e-7, the suite's level
    plausible(laws.uniform_p_value(z[: 1 << 20] ** 2))  # cos^2 of a cosine-weighted direction is uniform
    for limit in (0.01, 0.001):
        plausible(laws.count_p_value((z < limit).sum(), len(z), limit**2))
    plausible(laws.count_p_value((z > 0.9999).sum(), len(z), 1.0 - 0.9999**2))


@pytest.mark.parametrize("alpha", [1e-6, 1e-3, 0.01, 0.1, 0.5, 1.0])
def test_beckmann_keeps_the_digits_of_its_sine(alpha):
    u = np.concatenate([laws.corner_grid(), *list(laws.all_variates(64))])
    case = ws.Beckmann(alpha)
    exact = np.sin(np.arctan(float(np.float32(alpha)) * np.sqrt(-np.log1p(-u[:, 0].astype(np.float64)))))
    w = case.sample(u).astype(np.float64)
    assert laws.worst((np.sqrt(w[:, 0] ** 2 + w[:, 1] ** 2) - exact)[exact > 0] / exact[exact > 0]) <= 1e-6


@pytest.mark.parametrize("case", [c for c in CASES if c.symmetric], ids=repr)
def test_cdf_is_the_integral_of_the_density(case):
    """It is compared at ten angles between quantiles, by the quadrature that the cells use."""
    evidence = verify.Evidence(verify.Subject(repr(case), case, case))
    masses = verify.laws.cell_masses(case, evidence.edges, 4).sum(axis=1).cumsum()
    assert np.abs(case.cdf(evidence.edges[1:]) - masses).max() <= 5e-4  # half a held edge of OffsetSphere


@pytest.mark.parametrize("case", [case for case in CASES if case.symmetric], ids=repr)
def test_chances_are_0_below_all_angles_and_1_above(case):
    """This holds where the formula itself is not monotonic, too. Probabilities are float64 for any type of angles."""
    assert case.cdf([-4.0, 4.0]).tolist() == pytest.approx([0.0, 1.0], abs=1e-15)  # a few roundings
    assert case.cdf(np.float32([0.5, 1.0])).dtype == np.float64


def test_cdf_that_is_not_closed_says_so():
    with pytest.raises(
        NotImplementedError,
        match=r"VisibleGGX\(alpha=0.5.*: this distribution has no cdf of the angle, because its density also depends on",
    ):
        ws.VisibleGGX(0.5).cdf(0.1)


@pytest.mark.parametrize("shape", [(2,), (0, 2), (5, 2), (3, 4, 2)])
@pytest.mark.parametrize("distribution", [ws.UniformSphere(), ws.OffsetCircle()], ids=repr)
def test_arrays_keep_their_shape(shape, distribution):
    u = np.full(shape, 0.25, np.float32)
    w = distribution.sample(u)
    assert w.shape == (*shape[:-1], distribution.width)
    assert distribution.pdf(w).shape == shape[:-1]
    assert distribution.invert(w).shape == shape
    assert {a.dtype for a in (w, distribution.pdf(w), distribution.invert(w))} == {np.dtype(np.float32)}


@pytest.mark.parametrize(("d", "kind"), [(ws.CosineHemisphere("concentric"), wp.vec3), (ws.UniformDisk(), wp.vec2)])
def test_warp_arrays_in_warp_arrays_out(d, kind):
    u = ws.sample_square("independent", 1, 100)[0]
    w = d.sample(wp.array(u, dtype=wp.vec2, device="cpu"))
    assert isinstance(w, wp.array)
    assert w.dtype == kind
    assert np.array_equal(w.numpy(), d.sample(u))
    assert np.array_equal(d.pdf(w).numpy(), d.pdf(d.sample(u)))


def test_variates_that_round_up_to_one_stay_below():
    w = ws.CosineHemisphere().sample([[1.0 - 1e-12, 0.0]])
    assert w[0, 2] == 2.0**-12


@pytest.mark.parametrize(
    ("value", "error", "message"),
    [
        ([[1.0, 0.5]], ValueError, r"u: got values from 0.5 to 1.0, want values in \[0, 1\)"),
        ([[-0.1, 0.5]], ValueError, r"u: got values from -0.1 to 0.5"),
        ([[np.nan, 0.5]], ValueError, r"u: got values from nan to nan"),
        ([[0.5, 0.5, 0.5]], ValueError, r"u: got shape \(1, 3\), want \(..., 2\)"),
        (0.5, ValueError, r"u: got shape \(\)"),
        ([[1, 0]], TypeError, "u: got dtype int64, want float32"),
        ([["a", "b"]], TypeError, "u: got dtype <U1"),
    ],
)
def test_bad_variates_are_named(value, error, message):
    with pytest.raises(error, match="^" + message):
        ws.UniformSphere().sample(value)


def test_bad_warp_arrays_are_named():
    d = ws.UniformSphere()
    with pytest.raises(TypeError, match=r"^u: got a wp.array of vec3f with shape \(4,\), want vec2"):
        d.sample(wp.zeros(4, dtype=wp.vec3, device="cpu"))
    with pytest.raises(ValueError, match="^w: got a wp.array that is not contiguous"):
        d.pdf(wp.zeros((4, 3, 2), dtype=wp.float32, device="cpu")[:, :, 0])


@pytest.mark.parametrize(
    ("make", "error", "message"),
    [
        (
            lambda: ws.CosineHemisphere("malley"),
            ValueError,
            "method: got 'malley', want one of polar, concentric, inversion",
        ),
        (lambda: ws.UniformDisk("square"), ValueError, "method: got 'square', want one of polar, concentric"),
        (lambda: ws.Beckmann(0.0), ValueError, "alpha: got 0.0, want a number from 1e-06 to 1"),
        (lambda: ws.Beckmann(float("nan")), ValueError, "alpha: got nan, want a number from 1e-06 to 1"),
        (lambda: ws.Beckmann("rough"), TypeError, "alpha: got 'rough', want a number from 1e-06 to 1"),
        (lambda: ws.GGX(True), TypeError, "alpha: got True, want a number from 1e-06 to 1"),
        (lambda: ws.PowerCosine(-1), ValueError, "exponent: got -1, want a number from 0 to 1e[+]09"),
        (lambda: ws.OffsetSphere(0), ValueError, "rho: got 0, want a number from 1e-15 to 1e[+]15"),
        (lambda: ws.VonMisesFisher(0.0), ValueError, "kappa: got 0.0, want a number from 1e-06 to 1e[+]12"),
        (lambda: ws.UniformCone(1.0), ValueError, "cos_angle: got 1.0, want a number from -1 to below 1"),
        (ws.UniformCone, TypeError, "cos_angle: got None, want a number from -1 to below 1, or one_minus_cos"),
        (
            lambda: ws.UniformCone(0.5, 0.1),
            TypeError,
            "cos_angle: got 0.5 together with one_minus_cos, want only one of the two",
        ),
        (lambda: ws.UniformCone(one_minus_cos=3), ValueError, "one_minus_cos: got 3, want a number from 1e-24 to 2"),
        (
            lambda: ws.VisibleGGX(0.1, (0, 0, -1)),
            ValueError,
            r"view: got \(0, 0, -1\), want three finite numbers, not all 0",
        ),
        (lambda: ws.VisibleGGX(0.1, (0, 0)), ValueError, r"view: got \(0, 0\), want three finite numbers"),
        (lambda: ws.VisibleBeckmann(0.1, (0, 0, 0)), ValueError, r"view: got \(0, 0, 0\), want three finite numbers"),
        (
            lambda: ws.OffsetDisk().invert([[0.0, 1.0]]),
            NotImplementedError,
            r"OffsetDisk\(\): this distribution has no inverse, because several points u map to one direction",
        ),
        (
            lambda: ws.OffsetSphere(0.5).invert([[0.0, 0.0, 1.0]]),
            NotImplementedError,
            r"OffsetSphere\(rho=0.5\): this distribution has no inverse",
        ),
        (lambda: as_distribution("cosin"), ValueError, "distribution: got 'cosin', want one of beckmann, cosine_hemisphere"),
        (lambda: as_distribution(3), TypeError, "distribution: got 3, want a name or an instance"),
        (lambda: as_distribution("beckmann"), TypeError, r"distribution: got 'beckmann', want beckmann\(alpha=...\)$"),
        (
            lambda: as_distribution("uniform_cone"),
            TypeError,
            "distribution: got 'uniform_cone', .*cos_angle: got None",
        ),
        (lambda: as_distribution("ggx(0.1)"), TypeError, r"distribution: got 'ggx\(0.1\)', want .*give parameters by name"),
        (lambda: as_distribution("ggx(alpha=x)"), TypeError, "distribution: got .*parameters must be plain numbers"),
        (lambda: as_distribution("ggx(alpha="), TypeError, r"distribution: got 'ggx\(alpha=', want ggx\(alpha=...\)"),
        (lambda: as_distribution("ggx(alpha=0.1"), TypeError, r"distribution: got 'ggx\(alpha=0.1', want ggx\(alpha=...\)$"),
        (lambda: as_distribution("ggx(beta=1)"), TypeError, r"distribution: got 'ggx\(beta=1\)', want ggx\(alpha=...\)$"),
        (lambda: as_distribution("ggx(alpha=2)"), ValueError, "alpha: got 2, want a number from 1e-06 to 1"),
        (
            lambda: ws.sample_directions(np.ones((1, 3), np.float32), 4, distribution=ws.OffsetDisk()),
            TypeError,
            r"distribution: got OffsetDisk\(\), which is planar, want a distribution of directions in space",
        ),
    ],
)
def test_bad_parameters_are_named(make, error, message):
    with pytest.raises(error, match="^" + message):
        make()


def test_a_name_is_the_distribution_with_its_defaults():
    assert as_distribution("cosine_hemisphere") == ws.CosineHemisphere()
    assert as_distribution("beckmann(alpha=0.1)") == ws.Beckmann(0.1)
    assert as_distribution("visible_ggx(alpha=0.1, view=(0, 3, 4))") == ws.VisibleGGX(0.1, (0, 3, 4))
    assert ws.distributions.get("uniform_sphere") is ws.UniformSphere


def test_a_narrow_cone_keeps_the_digits_of_one_minus_cos():
    assert ws.UniformCone(0.75) == ws.UniformCone(one_minus_cos=0.25)
    assert ws.UniformCone(one_minus_cos=5e-13).pdf([[0.0, 0.0, 1.0]]) == pytest.approx(1.0 / (2.0 * np.pi * 5e-13), rel=1e-6)
    assert ws.UniformCone(ws.UniformCone(one_minus_cos=0.1).cos_angle).one_minus_cos == pytest.approx(0.1)


def test_views_are_kept_as_unit_vectors():
    assert ws.VisibleGGX(0.5, (0.0, 3.0, 4.0)) == ws.VisibleGGX(0.5, np.array([0.0, 0.6, 0.8]))


def test_a_view_whose_square_underflows_is_one_from_above():
    u = ws.sample_square("sobol", 1, 64)[0]
    assert np.array_equal(ws.VisibleGGX(0.5, (0.0, 1e-25, 1.0)).sample(u), ws.VisibleGGX(0.5).sample(u))
