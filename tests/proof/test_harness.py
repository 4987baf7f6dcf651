"""The laws must reject wrong samplers: the law named beside each planted defect catches it."""

import sys

import numpy as np
import pytest
import trimesh
from significance import ALPHA

import warpsample as ws
from warpsample.proof import defects, laws, rays, routes, run, stress, twins, verify
from warpsample.proof.twins.sequences import expected
from warpsample.proof.wrong_lights import WRONG_LIGHTS
from warpsample.proof.wrong_lobes import WRONG_LOBES
from warpsample.proof.wrong_microfacets import WRONG_MICROFACETS
from warpsample.proof.wrong_pictures import WRONG_PICTURES
from warpsample.proof.wrong_scattered import WRONG_SCATTERED
from warpsample.statistics.charts import SPHERE, chart_of
from warpsample.statistics.histogram import histogram_test, joined_test

RIGHT = ws.CosineHemisphere()
CAUGHT_BY = {
    "sphere scaled by 0.98": {"tails", "cells", "angle", "moments", "sine"},
    "sphere scaled by 0.99999": {"tails", "direction"},
    "normals of length 0.9": {"finite", "cells", "angle"},
    "azimuth gap of 1e-3 rad": {"azimuth gap", "mean stretch"},
    "cos θ as √(1 − x² − y²)": {"direction"},
    "ball for sphere": {"cells", "angle", "mean stretch"},
    "uniform for cosine": {"cells", "angle", "moments"},
    "sin and cos swapped in a quadrant": {"cells", "azimuth gap", "direction"},
    "x and y swapped": {"direction", "round trip"},
    "upside down": {"finite", "cells", "tails"},
    "one in 10⁵ below the surface": {"finite", "cells"},
    "NaN at the centre of the square": {"finite"},
    "length off by 4e-7": {"unit length"},
    "concentric map with a seam": {"azimuth gap", "mean stretch"},
    "Beckmann's sin θ as √(1 − cos²θ)": {"sine", "angle"},
    "Beckmann of α² for α": {"direction", "cells"},
    "pdf off by 1e-3": {"density", "mass", "mean stretch"},
    "pdf per radian, called per steradian": {"mass", "mean stretch"},
    "pdf not 0 below the surface": {"outside", "mass"},
    "inverse with a swapped pair": {"round trip"},
    "inverse that is NaN at the pole": {"round trip"},
    "Henyey-Greenstein of −g": {"direction", "cells", "mean stretch"},
    "Henyey-Greenstein uniform below 1e-3": {"direction", "sine", "density"},
    "Henyey-Greenstein uniform for g < 0": {"direction", "density", "angle"},
    "Henyey-Greenstein by the usual quotient": {"direction", "sine", "cells"},
    "Henyey-Greenstein of the power 1": {"density", "cells", "mean stretch"},
    "cosine transformed by the inverse": {"direction", "density", "cells", "mean stretch"},
    "cosine transformed by the transpose": {"direction", "density", "cells", "mean stretch"},
    "transformed cosine with a signed determinant": {"finite", "density", "mass"},
    "transformed cosine of the power 2": {"density", "mass", "mean stretch"},
    "transformed cosine not normalised": {"unit length"},
    "GGX with swapped roughnesses": {"direction", "cells", "mean stretch"},
    "GGX with the mean roughness in the norm": {"density", "mass", "mean stretch"},
    "GGX with an unstretched azimuth": {"direction", "cells", "mean stretch"},
    "anisotropic GGX density by 1 − z²": {"density", "mass", "mean stretch"},
    "GGX density without alpha_y": {"density", "cells", "mean stretch"},
    "Beckmann with swapped roughnesses": {"direction", "cells", "mean stretch"},
    "Beckmann with the mean roughness in the norm": {"density", "mass", "mean stretch"},
    "Beckmann density without alpha_y": {"density", "cells", "mean stretch"},
    "visible GGX with an unstretched view": {"direction", "cells", "mean stretch"},
    "visible GGX with a cap from 0": {"direction", "cells", "mean stretch"},
    "visible GGX with the area of the mean roughness": {"density", "mass", "mean stretch"},
    "visible GGX with the area of alpha": {"density", "mass", "mean stretch"},
    "visible GGX with alpha clamped at 1e-3": {"direction", "cells"},
    "visible Beckmann with swapped roughnesses": {"direction", "cells", "mean stretch"},
    "visible Beckmann with the density of alpha": {"density", "cells", "mean stretch"},
    "picture without solid angles": {"direction", "density"},
    "picture even in the angle": {"direction", "cells"},
    "picture half a pixel away": {"direction", "density", "cells"},
    "picture read clockwise": {"direction", "density", "cells"},
    "picture with shuffled strata": {"direction", "round trip"},
    "reflection by 1/(2 v·h)": {"density", "mass", "mean stretch"},
    "reflection with v·h by z": {"density", "mass", "mean stretch"},
    "reflection mirrored up": {"direction", "cells"},
    "reflection with a signed cosine": {"finite", "density", "mass"},
    "reflection without −h": {"density", "mass"},
    "mixture with u[0] not stretched": {"direction", "cells"},
    "mixture with the density of one lobe": {"density", "cells"},
    "mixture in reversed order": {"direction", "cells"},
    "glass with Fresnel's share at v·n": {"density", "cells"},
    "glass without η²": {"density", "mass"},
    "glass with η for 1/η from below": {"direction", "cells"},
    "glass mirrored at the plane": {"direction", "cells"},
    "glass with the choice by u[0]": {"direction", "cells"},
    "triangle sampled by area": {"direction", "cells", "mean stretch"},
    "triangle below 3e-4 sr sampled by area": {"direction", "cells", "mean stretch"},
    "solid angle of a triangle by Girard": {"density"},
    "triangle with corners not of unit length": {"direction", "cells", "mean stretch"},
    "triangle even in the angle of its arcs": {"direction", "cells"},
    "rectangle below 1e-3 sr sampled by area": {"direction", "cells"},
    "rectangle even along y": {"direction", "cells", "mean stretch"},
    "solid angle of a rectangle by four angles": {"density"},
    "rectangle behind the eye": {"finite", "direction", "cells"},
    "rectangle with swapped edges": {"direction", "round trip"},
    "u on 16 bits": {"tails", "repeats"},
    "u on 12 bits": {"tails", "repeats"},
    "Warp's own generator": {"repeats"},
    "one point in 10⁵ has another's stream": {"shared streams"},
    "the seed is ignored": {"correlation of seeds"},
    "u[1] is the next point's u[0]": {"correlation of points"},
    "raw words as a key": {"bits of seeds", "bits of ids", "bits of samples", "streams and purposes"},
    "ids of 32 bits": {"bits of ids"},
    "ids in one word of a hash": {"low bits of keys"},
    "samples in one word of a hash": {"low bits of far samples"},
}


def test_every_defect_is_expected_to_be_caught():
    assert set(CAUGHT_BY) == set(defects.names())
    assert len(CAUGHT_BY) >= 15


LONG = ("sphere scaled by 0.98", "sphere scaled by 0.99999", "u on 16 bits", "u on 12 bits")  # by 2^22 draws, as one more
LONG += (
    "one point in 10⁵ has another's stream",
    "the seed is ignored",
    "u[1] is the next point's u[0]",
    "Warp's own generator",
    "raw words as a key",
    "ids of 32 bits",
)  # of many points, as one more
QUICK = ("GGX with an unstretched azimuth", "cosine transformed by the inverse", "picture even in the angle")
LONG += tuple(  # of masses in cells of two dimensions; a few of them are quick enough
    name
    for name in (*WRONG_LOBES, *WRONG_MICROFACETS, *WRONG_PICTURES, *WRONG_SCATTERED, *WRONG_LIGHTS)
    if "Henyey" not in name and name not in QUICK
)


@pytest.mark.parametrize("name", [pytest.param(n, marks=pytest.mark.thorough) if n in LONG else n for n in CAUGHT_BY])
def test_planted_defects_are_caught(name):
    draws = 1 << (22 if "tails" in CAUGHT_BY[name] else 19)
    which = [law for law in verify.LAWS if law.name in CAUGHT_BY[name]]  # the others would take most of the time
    verdicts = defects.judge_defect(name, every=64, draws=draws, points=200_000, which=which)
    caught = {verdict.law for verdict in verdicts if not verdict.passed}
    assert caught >= CAUGHT_BY[name]


def test_the_correct_sampler_passes_where_the_defects_are_planted():
    """The seeds are those of the defects, so what rejects the defects is not the draw."""
    for name in ("sphere scaled by 0.99999", "azimuth gap of 1e-3 rad"):
        found = verify.judge(verify.Evidence(verify.Subject(name, RIGHT, RIGHT), every=64))
        assert all(verdict.passed for verdict in found)


def test_a_density_of_another_mass_is_an_error_and_not_a_chance_rejection():
    evidence = verify.Evidence(verify.Subject("right", RIGHT, RIGHT), every=64)
    wrong = defects.WrongSampler(RIGHT, pdf=lambda w: RIGHT.pdf(w) * np.float32(1.005))
    with pytest.raises(ValueError, match="pdf: got an integral of 1.00500, want 1"):
        laws.cells_p_value(wrong, evidence.first_directions, evidence.edges)


def test_an_integral_that_does_not_converge_is_an_error():
    noise = defects.WrongSampler(RIGHT, pdf=lambda w: np.sin(1e6 * w[..., 2].astype(np.float64)).astype(np.float32) ** 2)
    with pytest.raises(ValueError, match="pdf: got an integral that still changes by a relative .* at 256 nodes per cell"):
        laws.cell_masses(noise, np.array([0.0, 1.5, np.pi]), 4)


def test_pearsons_test_refuses_what_it_cannot_judge():
    with pytest.raises(ValueError, match="expected: got a count of 1, want at least 5"):
        histogram_test(np.array([1, 9]), np.array([1, 9]))
    with pytest.raises(ValueError, match="expected: got a sum of 20, want that of the observed counts, 18"):
        histogram_test(np.array([9, 9]), np.array([10, 10]))


def test_quadrature_knows_closed_integrals():
    """The means of theta and theta^2 over the cosine lobe are pi / 4 and (pi^2 - 4) / 8."""
    edges = np.array([0.0, 0.3, np.pi / 2, np.pi])
    for weight, exact in ((0, 1.0), (1, np.pi / 4), (2, (np.pi**2 - 4) / 8)):
        assert laws.cell_masses(RIGHT, edges, 4, weight).sum() == pytest.approx(exact, abs=1e-6)


@pytest.mark.parametrize("case", [ws.UniformSphere(), ws.UniformDisk(), ws.OffsetDisk()], ids=repr)
def test_charts_go_there_and_back(case):
    chart = chart_of(case)
    w = case.sample(ws.sample_square("sobol", 1, 1000)[0]).astype(np.float64)
    exact = w if case.measure == "per unit area" else routes.normalize(w)  # a chart of the sphere knows no length
    # Angles up to 2 pi and their sines, each within the 4 ulp (4 * 2^-50) that NumPy's loops keep on any processor. float32
    # in any step would leave 1e-7.
    assert np.abs(chart.point(chart.polar(w), chart.azimuth(w)) - exact).max() <= 1e-14


def test_viewer_histogram_rejects_the_wrong_lobe():
    u = ws.sample_square("independent", 1 << 14, 64, seed=1).reshape(-1, 2)
    angles = {law: SPHERE.polar(d.sample(u)) for law, d in (("right", RIGHT), ("ball", ws.OffsetBall()))}
    edges = np.linspace(0.0, np.pi / 2.0, 91)
    tests = {law: joined_test(np.histogram(a, edges)[0], len(a) * np.diff(RIGHT.cdf(edges))) for law, a in angles.items()}
    assert tests["right"].p_value >= ALPHA
    assert tests["ball"].p_value < ALPHA


def laws_broken(verdicts):
    return {verdict.law for verdict in verdicts if not verdict.passed}


def test_hostile_normals_reject_another_frame_and_a_lost_point(monkeypatch):
    assert laws_broken(stress.judge_normals(RIGHT)) == set()
    frames = twins.frames
    monkeypatch.setattr(twins, "frames", lambda n: frames(n) * np.array([1.0, 1.0 + 1e-6, 1.0]))
    assert laws_broken(stress.judge_normals(RIGHT)) == {"hostile normals, direction"}
    monkeypatch.setattr(stress, "hostile_normals", lambda: np.array([[0, 0, 1], [0, 0, 0]], np.float32))
    with np.errstate(invalid="ignore"):
        assert "hostile normals, lost" in laws_broken(stress.judge_normals(RIGHT))


@pytest.mark.parametrize("name", ws.sequences.names())
def test_indices_reject_a_neighbouring_sample(name, monkeypatch):
    monkeypatch.setattr(
        stress,
        "expected",
        lambda name, *, sample, **others: expected(name, sample=sample ^ 1, **others),
    )
    assert not stress.judge_indices(name).passed


def test_hostile_meshes_reject_float32_positions_and_a_heavy_last_face(monkeypatch):
    def in_float32(mesh, count):
        points = ws.sample_surface(mesh, count)
        points.face[: count // 60] = len(ws.as_mesh(mesh).faces) - 1  # what float32 sums do to 10^7 faces
        return ws.SurfacePoints(points.position.astype(np.float32).astype(np.float64), points.normal, points.face)

    monkeypatch.setattr(stress, "ten_million_faces", lambda: ws.as_mesh(trimesh.creation.icosphere(4)))
    monkeypatch.setattr(stress, "sample_surface", in_float32)
    assert laws_broken(stress.judge_meshes()) == {"points on their face", "shares of the area"}


def test_a_trial_without_trimesh_is_refused_before_any_work(monkeypatch):
    rays.closed_meshes.cache_clear()
    monkeypatch.setitem(sys.modules, "trimesh", None)
    with pytest.raises(ModuleNotFoundError, match=r"^the laws of rays need trimesh: pip install '\.\[test\]'$"):
        run.list_tasks()


def test_routes_reject_another_law(monkeypatch):
    wrong = routes.Route("ball for sphere", RIGHT, lambda u: routes.add_normal(routes.ball(u)), 3)
    monkeypatch.setattr(routes, "ROUTES", (wrong,))
    assert laws_broken(routes.judge_routes()) == {"route, cells", "route, angle"}
