"""One wrong part of a lobe or of its twin is named, and no other, whatever its error is."""

from itertools import combinations
from types import SimpleNamespace

import numpy as np
import pytest

import warpsample as ws
from warpsample.distributions.own import UserDistribution, user_distributions
from warpsample.proof import twins
from warpsample.proof.advice import advise
from warpsample.proof.defects import WrongSampler
from warpsample.proof.diagnosis import PARTS, Conflict, find_conflicts, find_smallest_sets
from warpsample.proof.evidence import Subject
from warpsample.proof.verify import Verdict

LOBES = {  # a lobe, and another lobe with the same support
    "hemisphere": (ws.CosineHemisphere(), ws.PowerCosine(2.0)),
    "sphere": (ws.UniformSphere(), ws.OffsetSphere(1.5)),
    "cone": (ws.UniformCone(0.5), None),
}


class Cone:
    """A lobe in the cone of UniformCone(0.5) whose density is proportional to cos theta - 0.5."""

    @staticmethod
    def sample(u):
        u = u.astype(np.float64)
        cosine = 0.5 + 0.5 * np.sqrt(1.0 - u[..., 0])
        return twins.spherical(np.arccos(cosine), u[..., 1])

    @staticmethod
    def pdf(w):
        cosine = w[..., 2].astype(np.float64)
        return np.where(cosine > 0.5, (cosine - 0.5) * 8.0 / (2.0 * np.pi), 0.0)

    @staticmethod
    def cdf(theta):
        return 1.0 - np.clip(2.0 * np.cos(theta) - 1.0, 0.0, 1.0) ** 2


def other_of(name):
    return LOBES[name][1] or Cone


def wrong_maps(name):
    """Wrong maps of u by the kind of error."""
    right, other = LOBES[name][0], other_of(name)
    return {
        "another lobe": other.sample,
        "mirrored at the surface": lambda u: right.sample(u.astype(np.float32)) * [1, 1, -1],
        "x and y swapped": lambda u: right.sample(u.astype(np.float32))[..., [1, 0, 2]],
        "swapped near the pole": lambda u: np.where(u[..., :1] < 0.01, other.sample(u)[..., [1, 0, 2]], right.sample(u)),
        "u[0] squared": lambda u: right.sample(np.float_power(u, [2, 1]).astype(np.float32)),
    }


def azimuth_of(w):
    return np.arctan2(w[..., 1], w[..., 0], dtype=np.float64)


def wrong_densities(name):
    """Wrong densities of w by the kind of error."""
    right, other = LOBES[name][0], other_of(name)
    return {
        "a factor of 2": lambda w: 2.0 * right.pdf(w),
        "a factor of 1.001": lambda w: 1.001 * right.pdf(w),
        "another lobe": other.pdf,
        "per radian": lambda w: right.pdf(w) * np.hypot(w[..., 0], w[..., 1], dtype=np.float64),
        "a small region": lambda w: right.pdf(w) * (1.0 + 0.5 * (np.arccos(np.float64(w[..., 2])) < 0.02)),
        "waves of the same integral": lambda w: right.pdf(w) * (1.0 + 0.1 * np.sin(2.0 * azimuth_of(w))),
    }


def wrong_inverses(name):
    """Wrong inverses by the kind of error."""
    right = LOBES[name][0]
    return {
        "a swapped pair": lambda w: right.invert(w)[..., ::-1],
        "the other sense of rotation": lambda w: (1.0 - right.invert(w) * [0, 1]) % 1.0 + right.invert(w) * [1, 0],
        "a small region": lambda w: np.where(w[..., 2:] > 0.995, 0.5, right.invert(w)),
    }


def wrong_cdfs(name):
    """Wrong distribution functions by the kind of error."""
    right, other = LOBES[name][0], other_of(name)
    return {
        "another lobe": other.cdf,
        "a factor of 0.9": lambda a: 0.9 * right.cdf(a),
        "the chance of a greater angle": lambda a: 1.0 - right.cdf(a),
        "off by one percent": lambda a: np.float_power(right.cdf(a), 1.01),
    }


KINDS = {
    "map": ("sample", wrong_maps),
    "density": ("pdf", wrong_densities),
    "inverse": ("invert", wrong_inverses),
    "cdf": ("cdf", wrong_cdfs),
    "twin's map": (0, wrong_maps),
    "twin's density": (1, wrong_densities),
}
MATRIX = [(lobe, part, kind) for lobe in LOBES for part, (_, of) in KINDS.items() for kind in of(lobe)]


@pytest.fixture
def subject_of():
    """A subject of a lobe with replaced functions: `of(lobe, part=function, ...)`."""

    def build(name, replaced, **members):
        right = LOBES[name][0]
        own, twin = dict(members), list(twins.check_twin(right))
        for part, function in replaced.items():
            where = KINDS[part][0]
            if isinstance(where, int):
                twin[where] = lambda _, x, function=function: function(x)
            else:
                own[where] = function
        twin = tuple(lambda _, x, f=f: f(right, x) for f in twin)
        user_distributions["on_trial"] = UserDistribution(type(right), twin)
        return Subject("OnTrial()", WrongSampler(right, **own), WrongSampler(right, name="on_trial"))

    yield build
    user_distributions.clear()


def named(subject):
    return {tuple(part for part in PARTS if part in parts) for parts in find_smallest_sets(find_conflicts(subject))}


def sentences(subject, *broken):
    """The advice, given laws that are broken."""
    return advise([Verdict.from_error(law, "OnTrial()", 1.0) for law in broken], [subject])


def test_the_fewest_parts_that_explain_all_conflicts_are_wrong():
    def sets(*conflicts):
        return [set(parts) for parts in find_smallest_sets(Conflict(frozenset(parts), "") for parts in conflicts)]

    pairs = {frozenset(pair) for pair in combinations(set(PARTS) - {"support"}, 2)}
    for part in PARTS[:4] + PARTS[5:]:
        assert sets(*(pair for pair in pairs if part in pair)) == [{part}]
    assert sets({"map", "twin's map"}) == [{"map"}, {"twin's map"}]
    assert sets({"density"}, {"twin's density"}, {"map", "density"}) == [{"density", "twin's density"}]
    assert sets() == [set()]


def test_a_uniform_map_with_a_density_that_goes_on_below_the_surface(subject_of):
    """Found by a user: the twin is right, and nothing is wrong of the density above the surface."""
    replaced = {"map": ws.UniformHemisphere().sample, "density": lambda w: w[..., 2] / np.pi}
    outside, wrong = sentences(subject_of("hemisphere", replaced), "direction", "outside", "mass", "cells")
    assert outside.startswith("OnTrial has a density beyond its support, or at NaN: return 0 there")
    assert wrong.startswith("OnTrial has a wrong map: the map and its twin differ by up to 0.27: at u = ")
    assert "(mean 57.3° of the map, 45° of the density)" in wrong
    assert wrong.endswith("The other parts agree. Mend `sample`, the first function of Maps.")


@pytest.mark.thorough  # the test above has a density beyond its support, too
@pytest.mark.parametrize("lobe", LOBES)
def test_only_the_support_is_named_of_a_density_beyond_it(lobe, subject_of):
    """The twin's density counts in the support alone, as documented, and may go on beyond it."""
    if lobe != "sphere":
        below = {"hemisphere": lambda w: w[..., 2] / np.pi, "cone": lambda w: np.full(w.shape[:-1], 1.0 / np.pi)}[lobe]
        assert named(subject_of(lobe, {"twin's density": below})) == {()}
        (said,) = sentences(subject_of(lobe, {"density": below}), "outside", "mass", "cells", "moments")
        assert said.startswith("OnTrial has a density beyond its support")
    for angle in {"hemisphere": (0.8, np.pi), "sphere": (np.pi / 2,), "cone": (0.8, np.pi / 2, np.pi)}[lobe]:
        assert named(subject_of(lobe, {}, largest_angle=angle)) == {("support",)}


@pytest.mark.slow
def test_what_the_checks_cannot_decide_is_a_choice(subject_of):
    alone = {"maps": SimpleNamespace(invert=None), "symmetric": False, "polar": False}  # no inverse, no cdf
    right, other = LOBES["hemisphere"][:2]
    cases = {
        "The maps belong to another lobe than the densities. Either of these is wrong: the map and the twin's map, or the "
        "density and the twin's density.": ("map", "twin's map"),
        "The class and its twin describe different lobes. Either of these is wrong: the map and the density, or the twin's "
        "map and the twin's density.": ("map", "density"),
    }
    for text, parts in cases.items():
        replaced = {part: other.pdf if "density" in part else other.sample for part in parts}
        (said,) = sentences(subject_of("hemisphere", replaced, **alone), "cells")
        assert text in said
        assert "Another part is a further check: `_cdf` with symmetric = True" in said
    (said,) = sentences(subject_of("hemisphere", {"map": lambda u: right.sample(u)[..., [1, 0, 2]]}, **alone), "direction")
    assert "Either of these is wrong: the map, or the twin's map." in said


@pytest.mark.thorough  # the test below has one error in both densities, too
@pytest.mark.parametrize("part", ["map", "density"])
def test_one_error_in_a_part_and_in_its_twin_is_said_of_both(part, subject_of):
    """The cdf and the inverse decide."""
    replaced = dict.fromkeys(
        [part, f"twin's {part}"], LOBES["hemisphere"][1].sample if part == "map" else ws.UniformHemisphere().pdf
    )
    (said,) = sentences(subject_of("hemisphere", replaced), "cells")
    assert said.startswith(f"OnTrial has a wrong {part} and a wrong twin's {part}: ")
    assert f"The two agree: both have the same error, and {part} and twin must be mended." in said


def test_a_wrong_factor_of_both_densities_is_said_of_both(subject_of):
    def twice(w):
        return 2.0 * LOBES["hemisphere"][0].pdf(w)

    (said,) = sentences(subject_of("hemisphere", {"density": twice, "twin's density": twice}), "mass", "cells")
    assert said.startswith("OnTrial has a wrong density and a wrong twin's density: the density integrates to 2 over the")
    assert "both have the same error" in said


def tier(number):
    return pytest.mark.slow if number % 66 == 0 else pytest.mark.thorough


@pytest.mark.parametrize(("lobe", "part", "kind"), [pytest.param(*case, marks=tier(i)) for i, case in enumerate(MATRIX)])
def test_one_wrong_part_is_named(lobe, part, kind, subject_of):
    assert named(subject_of(lobe, {part: KINDS[part][1](lobe)[kind]})) == {(part,)}


@pytest.mark.parametrize(
    "lobe", [pytest.param(n, marks=pytest.mark.slow if n == "cone" else pytest.mark.thorough) for n in LOBES]
)
def test_nothing_is_named_of_a_right_lobe(lobe, subject_of):
    assert named(subject_of(lobe, {})) == {()}
