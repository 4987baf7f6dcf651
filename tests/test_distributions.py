"""Every law, over every (distribution, case) of the registry."""

import numpy as np
import pytest
import warp as wp
from twins import TWINS, spherical

import warpsample as ws
from warpsample.distributions import as_distribution
from warpsample.proof import laws

CASES = [case for name in ws.distributions.names() for case in ws.distributions.get(name).cases()]
EACH = pytest.mark.parametrize("distribution", CASES, ids=repr)
COSINE = [case for case in CASES if isinstance(case, ws.CosineHemisphere)]


def independent_directions(distribution, count, seed=0):
    """Local directions of independent u; N = 64 * count."""
    return distribution.sample(ws.sample_square("independent", count, 64, seed).reshape(-1, 2))


def test_every_case_has_a_twin():
    assert set(CASES) == set(TWINS)


@EACH
def test_finite_and_unit_on_the_corner_grid(distribution):
    u = laws.corner_grid()
    w = distribution.sample(u)
    pdf = distribution.pdf(w)
    assert np.isfinite(w).all()
    assert np.isfinite(pdf).all()
    assert (pdf > 0.0).all()
    assert laws.length_error(w) <= distribution.worst_unit_length
    beside_the_pole = u[u[:, 0] > 0.0]  # at the pole itself the azimuth is lost
    assert laws.round_trip_error(distribution, beside_the_pole) <= distribution.worst_round_trip


@EACH
def test_right_at_every_variate(distribution):
    """All 2^24 values of both coordinates against the float64 twin."""
    twin, density = TWINS[distribution]
    for u in laws.all_variates():
        w = distribution.sample(u)
        exact = twin(u.astype(np.float64))
        assert laws.length_error(w) <= distribution.worst_unit_length
        assert laws.angle_error(w, exact) <= distribution.worst_angle
        pdf = distribution.pdf(w)
        assert pdf.min() > 0.0
        assert np.isfinite(pdf).all()
        # At the sampled direction itself: what a wrong density would be off by, not what the direction is off by.
        assert laws.pdf_error(pdf, density(w.astype(np.float64))) <= distribution.worst_pdf
        assert laws.round_trip_error(distribution, u) <= distribution.worst_round_trip
        if distribution.support == "hemisphere":
            assert w[:, 2].min() > 0.0


@EACH
def test_density_times_stretch_of_area_is_one(distribution):
    k = np.arange(4096)
    u = np.stack([(k + 0.5) / 4096, k * 0.618033988749895 % 1.0], axis=1) * (1 - 2**-6) + 2**-7
    # Away from the lines where the concentric map has its kinks.
    a, b = np.abs(u - 0.5).T
    u = u[(np.abs(a - b) > 2**-6) & (np.abs(u - 0.5).max(axis=1) > 2**-6)]
    worst, mean = laws.area_stretch_error(distribution, u)
    # float32 directions 6e-8 off at the ends of a side of 2^-10 leave 1e-4, and the concentric map's curvature as much;
    # both average out.
    assert worst <= 2.5e-4
    assert abs(mean) <= 1e-5


@EACH
def test_mass_is_one(distribution):
    assert laws.mass(distribution) == pytest.approx(1.0, abs=1e-5)


@EACH
def test_zero_outside_the_support_and_for_nan(distribution):
    k = np.arange(1000)
    below = spherical(np.pi / 2 + (k + 1) / 1001 * np.pi / 2, k * 0.618 % 1.0)
    pdf = distribution.pdf(below.astype(np.float32))
    assert ((pdf == 0.0) if distribution.support == "hemisphere" else (pdf > 0.0)).all()
    assert distribution.pdf(np.array([[np.nan, np.nan, np.nan]], np.float32)).tolist() == [0.0]


@EACH
def test_directions_follow_the_density(distribution, plausible):
    w = independent_directions(distribution, 1 << 14)
    plausible(laws.solid_angle_test(distribution, w).p_value)
    plausible(laws.azimuth_gap_p_value(w))


@EACH
def test_invert_gives_uniform_variates(distribution, plausible):
    """Of directions that another method of the same density drew: its inverse must make them uniform."""
    drawn = {"cosine_hemisphere": ws.CosineHemisphere("inversion")}.get(distribution.name, distribution)
    u = distribution.invert(independent_directions(drawn, 4000, seed=2))
    for axis in (0, 1):
        plausible(laws.uniform_p_value(u[:, axis]))


@pytest.mark.parametrize("distribution", COSINE, ids=repr)
def test_cosine_lobe_moments_and_tails(distribution, plausible):
    z = np.concatenate([independent_directions(distribution, 1 << 15, seed)[:, 2] for seed in range(5)]).astype(np.float64)
    assert len(z) >= 10**7
    assert laws.mean_error(z, 2.0 / 3.0) <= 5.3  # p = 1e-7, the suite's level
    assert laws.mean_error(z * z, 0.5) <= 5.3
    plausible(laws.uniform_p_value(z[: 1 << 20] ** 2))  # cos^2 of a cosine-weighted direction is uniform
    for limit in (0.01, 0.001):
        plausible(laws.count_p_value((z < limit).sum(), len(z), limit**2))
    plausible(laws.count_p_value((z > 0.9999).sum(), len(z), 1.0 - 0.9999**2))


def test_sphere_plus_normal_is_the_cosine_lobe_point_by_point():
    """Keinert's claim in source 003, on his Fibonacci sets, to float32 accuracy."""
    count = 1024
    i = np.arange(count)
    u = np.stack([(i + 0.5) / count, i * 0.6180339887498949 % 1.0], axis=1).astype(np.float32)
    sphere = ws.UniformSphere().sample(u).astype(np.float64) + np.array((0.0, 0.0, 1.0))
    projected = sphere / np.linalg.norm(sphere, axis=1, keepdims=True)
    assert np.abs(projected - ws.CosineHemisphere("polar").sample(u)).max() <= 2e-7
    assert np.abs(projected - ws.CosineHemisphere("offset").sample(u)).max() <= 2e-7
    # And his formula as printed, in float64.
    cos_theta = np.sqrt(1.0 - (i + 0.5) / count)
    printed = spherical(np.arccos(cos_theta), i * 0.6180339887498949)
    assert np.abs(projected - printed).max() <= 5e-7  # u in float32 moves the azimuth by 6e-8 of a turn


def test_half_angle_of_the_shirley_trick():
    """Theta of the sphere point is twice that of the sum: equation (3) of the proof."""
    u = ws.sample_square("sobol", 1, 4096)[0]
    z_sphere, z_sum = (d.sample(u)[:, 2].astype(np.float64) for d in (ws.UniformSphere(), ws.CosineHemisphere("offset")))
    assert np.abs(2.0 * z_sum**2 - 1.0 - z_sphere).max() <= 5e-7


@pytest.mark.parametrize("shape", [(2,), (0, 2), (5, 2), (3, 4, 2)])
def test_arrays_keep_their_shape(shape):
    u = np.full(shape, 0.25, np.float32)
    d = ws.UniformSphere()
    w = d.sample(u)
    assert w.shape == (*shape[:-1], 3)
    assert d.pdf(w).shape == shape[:-1]
    assert d.invert(w).shape == shape
    assert {a.dtype for a in (w, d.pdf(w), d.invert(w))} == {np.dtype(np.float32)}


def test_warp_arrays_in_warp_arrays_out():
    u = ws.sample_square("independent", 1, 100)[0]
    d = ws.CosineHemisphere("concentric")
    w = d.sample(wp.array(u, dtype=wp.vec2, device="cpu"))
    assert isinstance(w, wp.array)
    assert w.dtype == wp.vec3
    assert np.array_equal(w.numpy(), d.sample(u))
    assert np.array_equal(d.pdf(w).numpy(), d.pdf(d.sample(u)))


def test_variates_that_round_up_to_one_stay_below():
    w = ws.CosineHemisphere().sample([[1.0 - 1e-12, 0.0]])
    assert w[0, 2] == 2.0**-12


@pytest.mark.parametrize(
    ("value", "error", "message"),
    [
        ([[1.0, 0.5]], ValueError, r"u: got values from 0.5 to 1.0, want \[0, 1\)"),
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


def test_unknown_names_list_the_known_ones():
    with pytest.raises(ValueError, match="distribution: got 'cosin', want one of cosine_hemisphere, uniform_hemisphere"):
        as_distribution("cosin")
    with pytest.raises(ValueError, match="method: got 'malley', want one of polar, concentric, inversion, offset"):
        ws.CosineHemisphere("malley")
    with pytest.raises(TypeError, match="distribution: got 3, want a name or an instance"):
        as_distribution(3)


def test_a_name_is_the_distribution_with_its_defaults():
    assert as_distribution("cosine_hemisphere") == ws.CosineHemisphere()
    assert ws.distributions.get("uniform_sphere") is ws.UniformSphere
