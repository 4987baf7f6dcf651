"""`integrate`: means of functions over lobes, with and without a mesh, by closed forms and by the built-in quantities."""

from math import pi

import numpy as np
import pytest
import warp as wp
from integrands import Albedo, Sky, direction, one
from meshes import soup
from streams import fibonacci_stream
from weights_of_tests import upward

import warpsample as ws
from warpsample import funcs


@wp.func
def radiance(w: wp.vec3, lobe: funcs.Lobe, sky: Sky) -> float:
    return sky.horizon + (sky.zenith - sky.horizon) * w[2]


@wp.func
def smooth(w: wp.vec3) -> wp.vec3:
    along = 0.36 * w[0] + 0.48 * w[1] + 0.8 * w[2]
    return wp.vec3(1.0 + along, along * along * along * along, wp.exp(2.0 * along))


@wp.func
def edged(w: wp.vec3) -> wp.vec3:
    along = 0.36 * w[0] + 0.48 * w[1] + 0.8 * w[2]
    return wp.vec3(wp.where(w[0] > w[2], 1.0, 0.0), wp.where(along > 0.64, 1.0, 0.0), wp.where(along > 0.94, 1.0, 0.0))


@wp.func
def up(w: wp.vec3) -> float:
    return wp.where(w[2] > 0.0, 1.0, 0.0)


@wp.func
def cosine(w: wp.vec3, lobe: funcs.Lobe) -> float:
    return wp.dot(w, lobe.normal)


@wp.func
def who(w: wp.vec3, lobe: funcs.Lobe, albedo: Albedo) -> wp.vec3:
    return wp.vec3(albedo.by_id[lobe.row], float(lobe.row), float(lobe.point & wp.uint64(0xFFFF)))


@wp.func
def broken_at(w: wp.vec3, lobe: funcs.Lobe) -> float:
    return wp.where(lobe.row == 3, wp.sqrt(-1.0 - w[2] * w[2]), 1.0)


UP = np.array([[0.0, 0.0, 1.0], [0.0, 3.0, 0.0], [0.6, 0.0, -0.8], [-0.1, 0.2, 0.3]])
LOBES = [case for name in ws.distributions.names() for case in ws.distributions.get(name).cases()[:2] if case.width == 3]
# One whose strata are parts of cones, one whose strata are not, one that goes below the horizon, one that redraws.
FEW = [ws.GGX(0.5), ws.CosineHemisphere("concentric"), ws.UniformSphere(), ws.CosineHemisphere("offset")]


def folded(u):
    """To and fro instead of round."""
    return np.minimum(1.0 - np.abs(2.0 * u - 1.0), 1.0 - 2.0**-24)


@pytest.mark.parametrize("count", [2, 30, 64, 100, 136, 256, 288, 300, 2000, 2400, 5000])
def test_the_mean_is_that_of_the_directions_of_its_streams(count):
    """However many streams fit into a block of 256, and whether a stream fills whole rows of sixteen."""
    sectors, seed = 4 if count >= 32 else 1, 5
    each, up = count // (2 * sectors), np.tile(np.float32([0.0, 0.0, 1.0]), (3, 1))
    found = ws.integrate(up, direction, count, seed=seed)
    total = np.zeros((3, 3))
    for stream in range(2 * sectors):
        u = fibonacci_stream(up, each, seed, stream)[0].astype(np.float64)
        u[..., 0] = folded(u[..., 0])
        u[..., 1] = ((folded(u[..., 1]) if sectors > 1 else u[..., 1]) + stream // 2) / sectors
        total += ws.CosineHemisphere("polar").sample(u.astype(np.float32)).sum(axis=1, dtype=np.float64)
    # A variate that is rounded otherwise turns a direction by 2^-24 of a turn, 4e-7.
    assert np.abs(found.value - total / (2 * sectors * each)).max() <= 1e-6


@pytest.mark.parametrize("number", [float, np.float32, np.float64, np.int32, np.array], ids=lambda n: n.__name__)
def test_a_sky_of_the_users(number):
    """Over the cosine lobe the mean of z is 2/3 of the normal's z; the numbers of NumPy 2 say on which device they are."""
    sky = Sky()
    sky.zenith, sky.horizon = number(3.0), number(1.0)
    found = ws.integrate(UP, radiance, 4096, data=sky)
    unit = UP / np.linalg.norm(UP, axis=1, keepdims=True)
    assert np.abs(found.value - (1.0 + 2.0 * 2.0 / 3.0 * unit[:, 2])).max() <= 6.0 * found.standard_error.max()
    assert found.standard_error.max() < 1e-3
    assert (found.rays == 4096).all()


@pytest.mark.parametrize("distribution", [FEW[0], pytest.param(FEW[2], marks=pytest.mark.slow)], ids=repr)
def test_the_mean_of_each_lobe_is_that_of_its_directions(distribution):
    found = ws.integrate(UP, cosine, 4096, distribution=distribution)
    d = ws.sample_directions(UP, 1 << 16, distribution=distribution, sequence="sobol")
    unit = (UP / np.linalg.norm(UP, axis=1, keepdims=True))[:, None]
    exact = (d.vectors.astype(np.float64) * unit).sum(axis=2).mean(axis=1)
    assert np.abs(found.value - exact).max() <= 6.0 * found.standard_error.max() + 1e-4  # the second of 65,536 points
    # A dielectric jumps between reflected and transmitted directions.
    assert found.standard_error.max() < (1e-2 if distribution.name == "rough_dielectric" else 1e-3)


def test_the_error_bar_is_that_of_many_runs():
    """The mean of the squared standard errors is the variance of the values, within what 4,000 runs tell: 5 %, twice."""
    found = ws.integrate(np.tile(UP[2:3], (4000, 1)), up, 64, distribution="uniform_hemisphere")
    variance = found.value.astype(np.float64).var(ddof=1)
    assert abs(np.square(found.standard_error.astype(np.float64)).mean() / variance - 1.0) <= 0.1


def lobes(runs):
    """Normals of 32 lobes, each so many times, with rays of its own."""
    return np.tile(np.random.default_rng(7).normal(size=(32, 3)), (runs, 1))


def errors(means, integrand):
    """Less what 2^20 of Sobol' points give, which is closer to the truth than 4,096 of any other by more than ten times."""
    right = ws.integrate(lobes(1), integrand, 1 << 20, sequence="sobol", seed=1 << 40).value.astype(np.float64)
    return means - np.tile(right, (len(means) // len(right), 1))


def mean_squares(values):
    return np.square(np.asarray(values, np.float64)).mean(axis=0)


@pytest.mark.parametrize(
    "count", [pytest.param(n, marks=pytest.mark.slow if n == 64 else pytest.mark.thorough) for n in (64, 256, 1024)]
)
def test_what_the_error_bar_costs_a_smooth_integrand(count):
    """Eight streams, folded, are about as good as one set; without the fold their error is 2.4 to 3 times as large."""
    at = lobes(32)
    d = ws.sample_directions(at, count, sequence="fibonacci", seed=1).vectors.astype(np.float64)
    along = d @ [0.36, 0.48, 0.8]
    whole = np.stack([(1.0 + along).mean(1), ((along**2) ** 2).mean(1), np.exp(2.0 * along).mean(1)], axis=1)
    found = ws.integrate(at, smooth, count)
    ratio = np.sqrt(mean_squares(errors(found.value, smooth)) / mean_squares(errors(whole, smooth)))
    assert (ratio <= 1.4).all()


@pytest.mark.thorough
@pytest.mark.parametrize("integrand", [smooth, edged], ids=["smooth", "edged"])
@pytest.mark.parametrize("count", [16, 32, 64, 256, 1024, 4096, 65536])
@pytest.mark.parametrize("sequence", ws.sequences.names())
def test_error_bars_are_as_wide_as_the_errors(sequence, count, integrand):
    """The mean square error over the mean squared bar, of 8,000 runs, by which it is known to within 2 to 3 %.

    What float32 rounds, of directions and of values, is no part of the bar: up to half a step, and a third of the error by
    65,536 points of a lattice.
    """
    found = ws.integrate(lobes(250), integrand, count, sequence=sequence, seed=5)
    rounding = mean_squares(0.5 * np.spacing(found.value))
    ratio = mean_squares(errors(found.value, integrand)) / (mean_squares(found.standard_error) + rounding)
    assert (np.abs(ratio - 1.0) <= 0.1).all(), ratio


@pytest.mark.slow
def test_occlusion_and_bent_normals_add_up_to_an_integral(bunny, points):
    """An integrand that is not known to be 1 takes the general way; the rays are the same, and so is the value."""
    occlusion, bent = ws.ambient_occlusion(bunny, points, 300, seed=3), ws.bent_normals(bunny, points, 300, seed=3)
    found = ws.integrate(points, upward, 300, mesh=bunny, seed=3)  # 1 + z
    assert np.allclose(found.value, occlusion.value + bent.value[:, 2], rtol=0.0, atol=2e-6)  # sums of float32


@pytest.mark.thorough
def test_quantities_are_integrals(bunny, points):
    occlusion = ws.ambient_occlusion(bunny, points, 300, seed=3)
    assert np.allclose(ws.integrate(points, one, 300, mesh=bunny, seed=3).value, occlusion.value, rtol=0.0, atol=1e-6)
    bent = ws.bent_normals(bunny, points, 300, seed=3)
    assert np.array_equal(ws.integrate(points, direction, 300, mesh=bunny, seed=3).value, bent.value)
    light = ws.irradiance(bunny, points, up, 300, seed=3)
    assert np.allclose(pi * ws.integrate(points, up, 300, mesh=bunny, seed=3).value, light.value, rtol=1e-6, atol=0.0)


@pytest.mark.slow
@pytest.mark.parametrize("distribution", FEW[:1], ids=repr)
def test_skipping_changes_no_bit_of_any_lobe(distribution):
    """Seen from among triangles, and from outside, so that strata are found empty."""
    mesh = soup()
    points = ws.sample_surface(mesh, 150, seed=5)
    outside = ws.SurfacePoints(points.position * 3.0, -points.position.astype(np.float32))
    skipped = 0
    for where in (points, outside):
        for count in (16, 300, 600):
            found, plain = (
                ws.integrate(where, direction, count, distribution=distribution, mesh=mesh, skip=skip)
                for skip in (True, False)
            )
            assert np.array_equal(found.value, plain.value)
            assert np.array_equal(found.standard_error, plain.standard_error)
            skipped += plain.rays.sum() - found.rays.sum()
    assert skipped >= 0


@pytest.mark.thorough
@pytest.mark.parametrize("distribution", [*LOBES, *FEW], ids=repr)
def test_each_lobe_is_integrated_and_skipped_right(distribution):
    test_the_mean_of_each_lobe_is_that_of_its_directions(distribution)
    test_skipping_changes_no_bit_of_any_lobe(distribution)


@pytest.mark.thorough
def test_strata_of_cones_are_skipped():
    """A lobe whose strata are parts of cones casts few rays under a small roof; one whose strata are not casts all."""
    roof = ws.as_mesh(([(-1, -1, 2.0), (1, -1, 2.0), (0, 1, 2.0)], [(0, 2, 1)]))
    ground = ws.SurfacePoints(np.zeros((8, 3)), np.tile(np.float32([0, 0, 1]), (8, 1)))
    for distribution in (ws.GGX(0.5), ws.CosineHemisphere("inversion")):
        assert ws.integrate(ground, one, 600, distribution=distribution, mesh=roof).rays.sum() < 0.75 * 8 * 576
    assert ws.integrate(ground, one, 600, distribution=ws.CosineHemisphere("concentric"), mesh=roof).rays.sum() == 8 * 576


def test_data_may_hold_arrays_by_row_and_by_id():
    data = Albedo()
    data.by_id = wp.array(np.arange(4, dtype=np.float32) + 0.5, dtype=wp.float32, device="cpu")
    found = ws.integrate(UP, who, 64, data=data, first_point=2**40 + 7)
    assert np.allclose(found.value, np.column_stack([np.arange(4) + 0.5, np.arange(4), np.arange(4) + 7]), rtol=1e-6)


@pytest.mark.slow
def test_bits_depend_on_ids_alone(bunny, points, monkeypatch):
    whole = ws.integrate(points, direction, 40, distribution=ws.GGX(0.3), mesh=bunny)
    free = ws.integrate(points, direction, 40, distribution=ws.GGX(0.3))
    monkeypatch.setattr("warpsample.host.engine.LEAST_WORK", 1)
    some = ws.SurfacePoints(points.position[200:], points.normal[200:], points.face[200:])
    active = np.arange(400) % 2 == 0
    for known, mesh in ((whole, bunny), (free, None)):
        part = ws.integrate(
            some, direction, 40, distribution=ws.GGX(0.3), mesh=mesh, first_point=200, active=active, workers=3
        )
        assert np.array_equal(part.value, np.where(active[:, None], known.value[200:], 0.0))
        assert part.counts() == {ws.PointStatus.OK: 200, ws.PointStatus.INACTIVE: 200}


def test_a_point_without_a_number_is_counted():
    found = ws.integrate(np.vstack([UP, [[0.0, 0.0, 0.0]]]), broken_at, 32)
    assert found.status.tolist() == [0, 0, 0, ws.PointStatus.NONFINITE_VALUE, ws.PointStatus.ZERO_NORMAL]
    assert found.value.tolist() == [1.0, 1.0, 1.0, 0.0, 0.0]
    assert found.standard_error.tolist() == [0.0] * 5
