"""Lobes that differ from point to point: the bits of each point's own lobe, bad rows, cuts, and kernels for all values."""

import copy
import pickle

import numpy as np
import pytest
import warp as wp

import warpsample as ws
from warpsample import funcs
from warpsample.directions.plan import _build_kernel
from warpsample.distributions.by_point.tables import row_loader

P = 530  # more than a block of 256 and four tasks of 128 rows
WITH_PARAMETERS = sorted(name for name, kind in ws.distributions.classes().items() if kind.parameters)
# A picture is the same for all points.
IN_SPACE = [name for name in WITH_PARAMETERS if ws.distributions.classes()[name].width == 3 and name != "EnvironmentMap"]
# Mixtures by point are also in tests/test_mixture.py. Other tests compile the kernels of VisibleGGX, too.
EACH = pytest.mark.parametrize(
    "name", [pytest.param(n, marks=() if n == "VisibleGGX" else pytest.mark.thorough) for n in IN_SPACE]
)
COUNTS = (1, 3, 70)  # the loops of blocks of one sample, of blocks of several, and of rows


def case_of(name):
    """An instance with constants, in the middle of its range."""
    cases = ws.distributions.classes()[name].cases()
    return cases[len(cases) // 2]


def full_of(case, rows):
    """The same distribution with arrays full of its constants; UniformCone derives one attribute from the other."""
    values = {name: getattr(case, name) for name in case.parameters}
    arrays = {name: np.tile(np.array(value), (rows, *[1] * np.ndim(value))) for name, value in values.items()}
    if isinstance(case, ws.Mixture):
        return ws.Mixture([full_of(lobe, rows) for lobe in case.lobes], **arrays)
    return type(case)(**{name: full_of(lobe, rows) for name, lobe in case.nested.items()}, **arrays)


@pytest.fixture
def rng():
    return np.random.default_rng(20)


@pytest.fixture
def normals(rng):
    return rng.normal(size=(P, 3)).astype(np.float32)


@pytest.fixture
def alpha(rng):
    return rng.uniform(0.05, 1.0, P)


@pytest.fixture
def view(rng):
    v = rng.normal(size=(P, 3))
    v[:, 2] = abs(v[:, 2])
    return v


def same(one, other, rows=slice(None)):
    return all(
        np.array_equal(a[rows], b[rows])
        for a, b in ((one.vectors, other.vectors), (one.pdf, other.pdf), (one.status, other.status))
    )


@EACH
def test_a_constant_and_an_array_full_of_it_give_the_same_bits(name, normals):
    case = case_of(name)
    full = full_of(case, P)
    for count in COUNTS:
        assert same(*(ws.sample_directions(normals, count, distribution=d, pdf=True) for d in (case, full)))
    u = np.random.default_rng(3).random((P, 5, 2), np.float32)
    for square in (u, u[:, 0]):
        w = case.sample(square)
        assert np.array_equal(full.sample(square), w)
        assert np.array_equal(full.pdf(w), case.pdf(w))
        if case.maps.invert is not None:
            assert np.array_equal(full.invert(w), case.invert(w))


@pytest.mark.parametrize("count", COUNTS)
def test_each_point_has_its_own_lobe(count, normals, alpha, view):
    lobe = ws.VisibleGGX(alpha, view=view)
    found = ws.sample_directions(normals, count, distribution=lobe, pdf=True)
    for i in (0, 1, 127, 128, 255, 256, 257, 529):
        own = ws.VisibleGGX(float(alpha[i]), tuple(view[i]))
        alone = ws.sample_directions(normals[i : i + 1], count, distribution=own, pdf=True, first_point=i)
        assert np.array_equal(alone.vectors[0], found.vectors[i])
        assert np.array_equal(alone.pdf[0], found.pdf[i])


@pytest.mark.parametrize("count", COUNTS)
def test_cuts_threads_and_masks_change_no_bit(count, normals, alpha, view):
    lobe = ws.VisibleGGX(alpha, view=view)
    whole = ws.sample_directions(normals, count, distribution=lobe, pdf=True, workers=1)
    for start, end in ((0, 1), (1, 300), (300, P)):
        rows = slice(start, end)
        part = ws.sample_directions(normals[rows], count, distribution=lobe.take(rows), pdf=True, first_point=start)
        assert same(part, ws.Directions(whole.vectors[rows], whole.pdf[rows], whole.status[rows]))
        # The two usual mistakes are seen: rows that are not cut with the points, and row 0 for all.
        shifted = ws.sample_directions(
            normals[rows], count, distribution=lobe.take(np.arange(end - start)), pdf=True, first_point=start
        )
        assert start == 0 or not np.array_equal(shifted.vectors, whole.vectors[rows])
        first = ws.sample_directions(
            normals[rows], count, distribution=ws.VisibleGGX(alpha[0], tuple(view[0])), pdf=True, first_point=start
        )
        assert end == 1 or not np.array_equal(first.vectors, whole.vectors[rows])
    active = np.arange(P) % 3 > 0
    half = ws.sample_directions(normals, count, distribution=lobe, pdf=True, active=active)
    assert same(half, whole, active)
    assert not half.vectors[~active].any()


def test_rows_follow_ids_that_cross_a_word(normals, alpha):
    """A call is split where the upper word of the ids changes, and the tables with it."""
    lobe, first = ws.GGX(alpha), 2**32 - 200
    whole = ws.sample_directions(normals, 3, distribution=lobe, pdf=True, first_point=first)
    part = ws.sample_directions(normals[200:], 3, distribution=lobe.take(slice(200, None)), pdf=True, first_point=2**32)
    assert np.array_equal(whole.vectors[200:], part.vectors)


def test_threads_read_their_own_rows(rng):
    many = np.tile(np.float32([0.0, 0.6, 0.8]), (40_000, 1))
    lobe = ws.GGX(rng.uniform(0.01, 1.0, len(many)))
    one, four = (ws.sample_directions(many, 4, distribution=lobe, pdf=True, workers=n) for n in (1, 4))
    assert same(one, four)


def test_points_with_ids_and_device_arrays_keep_their_rows(normals, alpha):
    ids = np.arange(P)[::-1].astype(np.uint64)
    points = ws.SurfacePoints(np.zeros((P, 3)), normals, id=ids)
    lobe = ws.GGX(alpha)
    found = ws.sample_directions(points, 5, distribution=lobe, pdf=True)
    back = ws.sample_directions(normals[::-1], 5, distribution=lobe.take(ids.astype(int)), pdf=True)
    assert np.array_equal(found.vectors[::-1], back.vectors)
    on_device = ws.sample_directions(wp.array(normals, dtype=wp.vec3, device="cpu"), 5, distribution=lobe, pdf=True)
    assert np.array_equal(on_device.vectors.numpy(), ws.sample_directions(normals, 5, distribution=lobe).vectors)


@pytest.mark.parametrize("rows", [3, None, [[0, 1], [2, 3]]])
def test_rows_that_would_change_the_shape_of_a_parameter_are_refused(rows):
    lobe = ws.VisibleGGX(np.full(5, 0.3), view=np.ones((5, 3)))
    with pytest.raises(IndexError, match=r"^rows: got .*, want a slice, \(N,\) integers or a \(P,\) bool mask"):
        lobe.take(rows)


@pytest.mark.parametrize("count", COUNTS)
def test_bad_rows_get_zeros_a_status_and_nothing_else_changes(count, normals, alpha, view):
    good = ws.sample_directions(normals, count, distribution=ws.VisibleGGX(alpha, view=view), pdf=True)
    alpha, view, normals = alpha.copy(), view.copy(), normals.copy()
    bad = [3, 4, 5, 260, 300, 301, 302, 529]
    alpha[bad[:4]] = 0.0, np.nan, 1.5, -np.inf
    view[300], view[301], view[302, 2], view[529, 0] = 0.0, np.nan, -1e-6, np.inf
    normals[5], active = 0.0, np.arange(P) != 4
    found = ws.sample_directions(normals, count, distribution=ws.VisibleGGX(alpha, view=view), pdf=True, active=active)
    assert not found.vectors[bad].any()
    assert not found.pdf[bad].any()
    rest = np.setdiff1d(np.arange(P), bad)
    assert same(found, good, rest)
    names = {status.name: number for status, number in found.counts().items()}
    assert names == {"OK": P - 8, "INACTIVE": 1, "ZERO_NORMAL": 1, "INVALID_PARAMETER": 6}
    assert (ws.Status.INVALID_PARAMETER, ws.Status.INVALID_TANGENT) == (6, 7)


def test_bad_rows_of_sample_pdf_and_invert_are_zero(alpha, view):
    alpha[7] = 2.0
    lobe, u = ws.VisibleGGX(alpha, view=view), np.random.default_rng(3).random((P, 3, 2), np.float32)
    w = lobe.sample(u)
    assert not w[7].any()
    up = np.tile(np.float32([0.0, 0.0, 1.0]), (P, 3, 1))
    zero = (lobe.pdf(up) == 0.0).all(axis=1)
    assert np.flatnonzero(zero).tolist() == [7]
    assert not lobe.invert(up)[7].any()


@pytest.mark.parametrize(
    ("make", "message"),
    [
        (lambda: ws.GGX(np.ones((4, 1))), r"alpha: got shape \(4, 1\), want a number, or \(P,\) numbers"),
        (lambda: ws.VisibleGGX(0.3, np.ones((4, 2))), r"view: got shape \(4, 2\), want a vector, or \(P, 3\) vectors"),
        (lambda: ws.VisibleGGX(np.full(3, 0.3), np.ones((4, 3))), "view: got 4 rows, want 3, as alpha has"),
        (lambda: ws.GGX(np.array(["a"])), "alpha: got dtype"),
        (lambda: ws.GGX(np.ma.masked_array([0.3])), "alpha: got a masked array"),
        (lambda: ws.GGX(0.0), "alpha: got 0.0, want a number from"),
        (lambda: ws.UniformCone(np.full(2, 0.5), np.full(2, 0.5)), "cos_angle: got both cos_angle and one_minus_cos"),
    ],
)
def test_wrong_arrays_are_errors_that_name_the_parameter(make, message):
    with pytest.raises((TypeError, ValueError), match=message):
        make()


def test_another_number_of_points_is_an_error(normals, alpha):
    lobe = ws.GGX(alpha[:9])
    with pytest.raises(ValueError, match="distribution: got alpha with 9 rows, want 530"):
        ws.sample_directions(normals, 4, distribution=lobe)
    with pytest.raises(ValueError, match="distribution: got alpha with 9 rows, want 530"):
        ws.integrate(normals, funcs.square_to_cosine_hemisphere_pdf, 16, distribution=lobe)
    for shape in ((8, 2), (2,), (8, 9, 2)):
        with pytest.raises(ValueError, match=r"u: got shape .*want \(9, 2\) or \(9, n, 2\), as alpha has 9 rows"):
            lobe.sample(np.zeros(shape, np.float32))


def test_arrays_are_private_copies(normals, alpha):
    lobe = ws.GGX(alpha)
    before = ws.sample_directions(normals, 4, distribution=lobe).vectors
    alpha[:] = 0.5
    assert np.array_equal(ws.sample_directions(normals, 4, distribution=lobe).vectors, before)
    assert lobe.alpha.dtype == np.float32
    assert lobe.alpha.flags.c_contiguous
    with pytest.raises(ValueError, match="read-only"):
        lobe.alpha[0] = 0.1


def test_equality_pickles_and_texts_know_the_arrays(alpha, view):
    lobe = ws.VisibleGGX(alpha, view=view)
    for twin in (pickle.loads(pickle.dumps(lobe)), copy.deepcopy(lobe), ws.VisibleGGX(alpha.copy(), view=view.copy())):
        assert twin == lobe
        assert hash(twin) == hash(lobe)
    other = alpha.copy()
    other[-1] *= 1.0001
    assert ws.VisibleGGX(other, view=view) != lobe
    assert repr(lobe) == "VisibleGGX(alpha=array(530,), view=array(530, 3))"
    assert ws.GGX(0.3) == ws.GGX(alpha=0.3)
    assert repr(ws.GGX(0.3)) == "GGX(alpha=0.3)"
    assert ws.GGX(0.3).take(slice(5)) == ws.GGX(0.3)


def test_views_by_point_have_the_bits_of_constants():
    """Also for lengths that squares of float64 cannot hold."""
    rng = np.random.default_rng(8)
    views = rng.normal(size=(2000, 3)) * 10.0 ** rng.integers(-200, 200, (2000, 1))
    views[:, 2] = abs(views[:, 2])
    found = ws.VisibleGGX(0.3, view=views).view
    assert np.array_equal(found, np.float32([ws.VisibleGGX(0.3, tuple(v)).view for v in views]))


def test_kernels_are_keyed_by_layout_not_by_values(normals, alpha):
    """A thousand roughnesses compile one kernel, and keep none of their arrays alive in a cache."""
    ws.sample_directions(normals, 3, distribution=ws.GGX(alpha))
    kernels, loaders = _build_kernel.cache_info().currsize, len(row_loader.cache)
    for scale in (0.5, 0.7, 0.9):
        ws.sample_directions(normals, 3, distribution=ws.GGX(scale * alpha))
    assert (_build_kernel.cache_info().currsize, len(row_loader.cache)) == (kernels, loaders)
    assert ws.GGX(alpha).layout == ws.GGX(alpha[:3]).layout
    assert ws.VisibleGGX(alpha).layout != ws.VisibleGGX(0.5, view=np.ones((P, 3))).layout


def test_means_follow_the_roughness(normals):
    """The mean of tan^2 of a Beckmann lobe is alpha^2; its bars at 4096 Sobol' points are below 1 %."""
    alpha = np.linspace(0.05, 0.5, 40)
    up = np.tile(np.float32([0.0, 0.0, 1.0]), (40, 1))
    w = ws.sample_directions(up, 4096, distribution=ws.Beckmann(alpha)).vectors.astype(np.float64)
    tangent_squared = ((1.0 - w[..., 2] ** 2) / w[..., 2] ** 2).mean(axis=1)
    assert np.allclose(tangent_squared, alpha**2, rtol=0.02)
