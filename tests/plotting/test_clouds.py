"""Clouds and lobes: what is drawn of a choice, and what is said of right and wrong samplers."""

import inspect
from dataclasses import replace
from math import exp, log

import numpy as np
import pytest
from scipy.integrate import trapezoid
from significance import ALPHA

import warpsample as ws
from warpsample.cli import commands
from warpsample.viewer import clouds, controls, lobes, start
from warpsample.viewer.choice import Choice
from warpsample.viewer.counts import count_directions

COSINE = ws.CosineHemisphere()


def judged(distribution, claim, draws=60_000, seed=5):
    """The two histograms of independent local directions of one distribution held against another."""
    u = ws.sample_square("independent", 1, draws, seed=seed)[0]
    counts = count_directions(distribution.sample(u), lobes.probabilities_of(claim), independent=True)
    return counts.theta, counts.azimuth


def counted(choice, points):
    """The counts of the directions that the viewer draws at some points."""
    return clouds.count_clouds(choice, clouds.all_clouds(choice, points, 1.0))


def test_cosine_clouds_are_uniform_spheres_resting_on_the_surface(points):
    few = ws.SurfacePoints(points.position[:20], points.normal[:20])
    cloud = clouds.all_clouds(Choice(COSINE, sequence="sobol", samples=4096), few, 0.1).position.reshape(20, 4096, 3)
    from_centre = (cloud - (few.position + 0.05 * few.normal)[:, None]) / 0.05
    # Coordinates of a unit in float32, over a radius of 0.05.
    assert np.abs(np.linalg.norm(from_centre, axis=-1) - 1.0).max() <= 1e-5
    # Uniform on that sphere: mean 0, second moments 1/3; 4096 Owen-scrambled points are within 1/4096.
    assert np.abs(from_centre.mean(axis=1)).max() <= 1e-3
    assert np.abs(np.einsum("psi,psj->pij", from_centre, from_centre) / 4096 - np.eye(3) / 3).max() <= 1e-3


def mostly_slow(names):
    """The first four are quick; each of the others compiles two kernels of its own, and every second is thorough."""
    tiers = (pytest.mark.slow, pytest.mark.thorough)
    return [*names[:4], *(pytest.param(name, marks=tiers[i % 2]) for i, name in enumerate(names[4:]))]


def test_the_cosine_lobe_is_drawn_as_a_sphere_of_diameter_one():
    surface = lobes.shape_of(COSINE).surface
    assert np.abs(np.linalg.norm(surface - [0.0, 0.0, 0.5], axis=-1) - 0.5).max() <= 1e-6
    assert np.ptp(surface[..., 2]) == pytest.approx(1.0, abs=1e-6)


@pytest.mark.parametrize("name", mostly_slow(controls.spatial_names()))
def test_right_directions_agree_and_wrong_ones_do_not(name, plausible):
    """Those of the menu's entry with its own density; and with that of the next value of its slider, or the next entry."""
    right = controls.make_distribution(name)
    lobe = lobes.probabilities_of(right)
    assert (lobe.theta.sum(), lobe.azimuth.sum()) == (pytest.approx(1.0), pytest.approx(1.0))
    # The chart's line has the mass of what it shows, but for the last half cell, where glass has a peak straight down.
    assert trapezoid(lobe.line, lobe.angles) == pytest.approx(lobe.theta[0, :-1].sum(), abs=0.02 + lobe.theta[0, -2])
    for histogram in judged(right, right):
        plausible(histogram.test.p_value)
        assert histogram.verdict().startswith("agrees with the density\nχ² = ")
    kind = type(right)
    wrong = controls.with_scalar(right, 1.1 * getattr(right, kind.parameters[0])) if kind.shown else ws.OffsetSphere(1.05)
    theta, _ = judged(wrong, right)
    assert theta.test.p_value < ALPHA
    assert theta.verdict().startswith("does NOT agree")


@pytest.mark.thorough
@pytest.mark.parametrize(
    "sequence",
    ["fibonacci", "independent", "philox", "r2", "sobol", "stratified"],
)
def test_every_sequence_tells_right_from_wrong(sequence, points):
    """By chi-square where points are independent; where they are evenly spread, without a p-value that says nothing."""
    few = ws.SurfacePoints(points.position[:100], points.normal[:100])
    independent = ws.sequences.get(sequence).random
    right = counted(Choice(ws.OffsetSphere(), COSINE, sequence), few)
    for seen in (right.theta, right.azimuth):
        assert not seen.is_wrong
        assert seen.verdict().startswith("agrees")
        assert ("p = " in seen.verdict(), "χ²" in seen.verdict()) == (independent, independent)
        assert ("residuals up to " in seen.verdict()) == (not independent)
    if not independent:
        # Stratified points have 0.65 times those of independent ones: the largest of 45 is above 3 once in 10^4.
        assert right.theta.test.largest_residual < 3.0
    for wrong in (ws.OffsetSphere(0.9), ws.OffsetSphere(0.98), ws.OffsetSphere(1.02), ws.OffsetBall(), ws.PowerCosine(1.1)):
        seen = counted(Choice(wrong, COSINE, sequence), few).theta
        assert seen.is_wrong
        assert seen.verdict().startswith("does NOT agree")
        assert seen.test.largest_residual > 4.0


def test_the_first_picture_is_judged_on_independent_points():
    """Its chi-square would mean nothing otherwise."""
    assert ws.sequences.get(start.choice(None, None, Choice.sequence, 1024, 0).sequence).random
    assert inspect.signature(commands.view).parameters["sequence"].default == Choice.sequence


@pytest.mark.slow
def test_azimuth_is_judged_about_the_tangent_that_the_kernels_take(points):
    """Visible normals lean towards their view: with another frame they would not."""
    leaning = ws.VisibleGGX(0.5, (0.94, 0.0, 0.34))
    seen = counted(Choice(leaning, sequence="independent", samples=100), points)
    assert seen.azimuth.test.p_value >= ALPHA
    turned = replace(leaning, view=(leaning.view[1], leaning.view[0], leaning.view[2]))
    assert counted(Choice(leaning, turned, "independent", 100), points).azimuth.test.p_value < ALPHA


@pytest.mark.slow
def test_what_is_outside_the_density_is_counted_and_drawn_apart(points):
    choice = Choice(ws.UniformSphere(), COSINE, "sobol", 256)
    seen = clouds.all_clouds(choice, points, 1.0)
    # Half of every 256 points of Sobol's, but for those that rounding puts across the horizon.
    assert seen.outside == pytest.approx(0.5 * 256 * len(points), rel=1e-3)
    away = np.linalg.norm(seen.position - np.repeat(points.position, 256, axis=0), axis=1)[seen.pdf == 0.0]
    assert np.abs(away - clouds.OUTSIDE).max() <= 1e-5
    assert clouds.count_clouds(choice, seen).theta.test.p_value == 0.0


def test_few_directions_are_not_judged(points):
    few = ws.SurfacePoints(points.position[:1], points.normal[:1])
    seen = counted(Choice(COSINE, samples=8), few)
    assert seen.theta.test is None
    assert seen.theta.verdict() == "cannot be judged\ntoo few directions"


def test_what_is_too_narrow_to_be_seen_is_refused():
    with pytest.raises(
        ValueError, match=r"^distribution: got Beckmann\(alpha=1e-06\), a lobe of 0.0001 degrees, want one of at least 0.01"
    ):
        lobes.shape_of(ws.Beckmann(1e-6))


@pytest.mark.slow
def test_every_slider_goes_from_end_to_end():
    """Every distribution can be made, drawn and judged at both ends of what its slider shows."""
    for name in controls.spatial_names():
        kind = type(controls.make_distribution(name))
        for value in kind.shown or ():
            lobe = lobes.shape_of(controls.with_scalar(controls.make_distribution(name), exp(log(value))))
            assert np.isfinite(lobe.surface).all()
            assert 0.5 < np.linalg.norm(lobe.surface, axis=-1).max() <= 1.0 + 1e-6


@pytest.mark.parametrize(
    ("distribution", "density", "claim", "name"),
    [
        (None, None, COSINE, "the cosine lobe"),
        ("offset_sphere(rho=1.3)", None, COSINE, "the cosine lobe"),
        ("offset_ball", None, COSINE, "the cosine lobe"),
        ("offset_sphere(rho=1.3)", "offset_sphere(rho=1.3)", ws.OffsetSphere(1.3), "its own density"),
        ("cosine_hemisphere", None, COSINE, "its own density"),
        ("ggx(alpha=0.3)", None, ws.GGX(0.3), "its own density"),
        ("ggx(alpha=0.3)", "beckmann(alpha=0.3)", ws.Beckmann(0.3), "beckmann"),
    ],
)
def test_offset_sets_are_compared_with_the_cosine_lobe_and_others_with_themselves(distribution, density, claim, name):
    chosen = start.choice(distribution, density, "independent", 64, 0)
    assert (chosen.claim, chosen.claim_name) == (claim, name)


def test_the_start_agrees_and_another_radius_does_not(points):
    """What the README promises: a sphere of radius 1 gives the cosine lobe, another radius does not."""
    for distribution, agrees in ((None, True), ("offset_sphere(rho=1.3)", False), ("offset_sphere(rho=0.8)", False)):
        seen = counted(start.choice(distribution, None, "independent", 64, 0), points).theta
        assert seen.verdict().startswith("agrees with the cosine lobe" if agrees else "does NOT agree with the cosine lobe")
