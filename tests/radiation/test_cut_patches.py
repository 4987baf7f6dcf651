"""Patches that a point's horizon cuts: tilted and downward points against quadrature, sky view factors, and more rays."""

import numpy as np
import pytest
from estimate_cases import at
from sky_cases import edges, form_factors

import warpsample as ws
from warpsample.bench import scenes

FAR = ws.as_mesh(([(0, 0, -2), (1, 0, -2), (0, 1, -2)], [(0, 1, 2)]))  # below all skies
NORMALS = {
    "up": (0.1, 0.2, 1.0),
    "tilted": (-0.3, 0.5, 0.6),
    "steep": (-0.8, -0.1, 0.25),
    "upright": (0.4, 0.6, 0.0),
    "a little down": (0.2, -0.9, -0.3),
    "down": (0.7, 0.1, -0.7),
}


def unit(n):
    return np.asarray(n, np.float64) / np.linalg.norm(n)


def slats(azimuth, pitch=0.3, number=20):
    """(mesh, whether a direction is seen from so far below) of level slats about the origin, a tower's, as wide as gaps."""
    ahead = np.array([np.sin(azimuth), np.cos(azimuth), 0.0])
    aside = 1.7 * np.array([ahead[1], -ahead[0], 0.0])  # so that no quarter of a turn is the same
    corners = np.array([ahead + aside, ahead - aside, -ahead - aside, -ahead + aside])
    rings = [corners + np.array([0.0, 0.0, 0.5 * pitch * k]) for k in range(2 * number)]
    four = np.arange(4)
    one = np.concatenate(
        [np.stack([four, (four + 1) % 4, four + 4]), np.stack([four + 4, (four + 1) % 4, (four + 1) % 4 + 4])], 1
    )
    faces = np.concatenate([one.T + 8 * k for k in range(number)])

    def is_sky(w, below=0.0):
        height = (w[:, 2] / np.maximum(np.abs(w @ ahead), np.abs(w @ aside) / 1.7**2) - below) / pitch
        return (height < 0.0) | (height >= number) | (height % 1.0 > 0.5)

    return ws.as_mesh((np.concatenate(rings), faces)), is_sky


@pytest.mark.parametrize("name", NORMALS)
def test_cut_patches_behind_slats_by_quadrature(name):
    """Slats cut every low patch in two or more: rays that miss a part of one would tell another share."""
    n = unit(NORMALS[name])
    mesh, is_sky = slats(np.arctan2(n[0], n[1]))
    exact = form_factors(n, is_sky, cells=150)[0]
    errors = []
    for count in (1024, 16384):
        found = ws.sky_matrix(mesh, at((0, 0, 0), n, 64), count)
        error, squares = found.value - exact, np.square(found.standard_error.astype(np.float64))
        errors.append(np.sqrt(np.mean(error**2)))
        # The quadrature is off by the cells that an edge cuts, 1 / 150 of a patch of 0.01 at most, and half of it cancels.
        assert 0.8 <= np.mean(error**2) / squares.mean() <= 1.3
        assert abs(error.sum(axis=1).mean()) <= 5.0 * np.sqrt(squares.sum()) / 64 + 5e-5
    bars = np.sqrt(squares.mean(axis=0) / 64)
    assert (np.abs(error.mean(axis=0)) <= 5.0 * bars + 3e-5).all()
    assert errors[1] <= errors[0] / 4.0  # independent rays': a fourth; these fall faster


def by_altitude(normals, multiple):
    """(N, K) integrals of max(0, n.w) / pi over patches: over the azimuth in closed form, over the altitude by Gauss."""
    x, weights = np.polynomial.legendre.leggauss(400)
    level, facing = np.hypot(normals[:, 0], normals[:, 1])[:, None], np.arctan2(normals[:, 0], normals[:, 1])[:, None]
    found = []
    for low, high, first, last in edges(multiple):
        altitude = 0.5 * (low + high) + 0.5 * (high - low) * x
        a, b = normals[:, 2:] * np.sin(altitude), level * np.cos(altitude)
        half = np.arccos(np.clip(-a / np.maximum(b, 1e-300), -1.0, 1.0))  # as far from there it is above the horizon
        total = np.zeros(a.shape)
        for turn in (-2.0 * np.pi, 0.0, 2.0 * np.pi):
            start, end = np.maximum(first, facing + turn - half), np.minimum(last, facing + turn + half)
            total += np.where(end > start, a * (end - start) + b * (np.sin(end - facing) - np.sin(start - facing)), 0.0)
        found.append(0.5 * (high - low) * (total * np.cos(altitude)) @ weights / np.pi)
    return np.array(found).T


@pytest.mark.parametrize("patches", ["tregenza", pytest.param("reinhart2", marks=pytest.mark.thorough)])
def test_cut_patches_in_the_open_are_exact(patches):
    """60 normals of all tilts, and 60 whose horizon runs by sides of patches and leaves slivers of them.

    Where the horizon leaves a patch the integrand bends, so that Gauss is off by 1e-7.
    """
    rng = np.random.default_rng(5)
    sides = np.radians(6.0 + 12.0 * np.arange(60)) + rng.uniform(-0.016, 0.016, 60)
    level = np.stack([np.cos(sides), -np.sin(sides), rng.uniform(-2e-3, 2e-3, 60)], axis=1)
    normals = np.concatenate([rng.normal(size=(60, 3)), level]).astype(np.float32)
    found = ws.sky_matrix(FAR, at(np.zeros((120, 3)), normals), 64, patches=patches)
    units = np.array([unit(n) for n in normals])
    exact = by_altitude(units, {"tregenza": 1, "reinhart2": 2}[patches])
    assert np.abs(found.value - exact).max() <= 3e-7
    assert np.abs(found.value.sum(axis=1, dtype=np.float64) - 0.5 * (1.0 + units[:, 2])).max() <= 1e-6


@pytest.mark.parametrize("name", ["city", "bunny"])
def test_rows_of_tilted_points_sum_to_the_sky_view_factor(bunny, name):
    mesh = bunny if name == "bunny" else scenes.city(8)
    points = ws.sample_surface(mesh, 1500, seed=3)
    up = unit((0.5, -0.4, 1.0))  # so that the city's walls and roofs are tilted, too
    tilt = points.normal @ up
    for first, last in ((-0.9, -0.1), (0.1, 0.6)):
        chosen = (tilt > first) & (tilt < last)
        some = ws.SurfacePoints(points.position[chosen], points.normal[chosen], points.face[chosen])
        view = ws.sky_view_factor(mesh, some, 2**15, up=up)
        apart = []
        for count in (256, 4096):
            found = ws.sky_matrix(mesh, some, count, up=up)
            sums = found.value.sum(axis=1, dtype=np.float64)
            bars = np.square(found.standard_error.astype(np.float64)).sum(axis=1)
            bars += np.square(view.standard_error.astype(np.float64))
            apart.append(np.sqrt(np.mean(np.square(sums - view.value))))
            assert abs((sums - view.value).mean()) <= 4.5 * np.sqrt(bars.sum()) / chosen.sum()
            assert apart[-1] ** 2 <= 1.5 * bars.mean()
        assert apart[1] <= apart[0] / 3.0  # of 16 times as many rays


def highest_of(patch, n):
    """The direction of a patch's rim that is farthest above the horizon of n."""
    low, high, first, last = patch
    share = np.linspace(0.0, 1.0, 2001)
    azimuth = np.concatenate([first + (last - first) * share] * 2 + [np.full(2001, first), np.full(2001, last)])
    altitude = np.concatenate([np.full(2001, low), np.full(2001, high), *[low + (high - low) * share] * 2])
    along = np.cos(altitude)
    w = np.stack([along * np.sin(azimuth), along * np.cos(azimuth), np.sin(altitude)], axis=1)
    return w[np.argmax(w @ n)]


@pytest.mark.parametrize("height", [-0.25, -0.1, -0.04, 0.04, 0.1, 0.2])
def test_a_sliver_of_a_patch_is_seen_where_it_is_highest(height):
    """The horizon runs along patches' sides at 90 degrees, but 2.5e-4 beyond: nine of ten times its two rays are too faint.

    What counts then is a ray to where the patch is farthest above the horizon.
    """
    n = np.array([np.sin(np.pi - 2.5e-4), np.cos(np.pi - 2.5e-4), 0.0])
    mesh, is_sky = slats(0.3)
    found = ws.sky_matrix(mesh, at((0, 0, -height), n, 64), 64, skip=False)
    open_ = ws.sky_matrix(FAR, at((0, 0, 0), n), 64).value[0]
    slivers = [k for k, patch in enumerate(edges(1)) if 0.0 < open_[k] < 1e-7 and patch[0] < 0.3]
    assert len(slivers) == 2
    for k in slivers:
        lit = found.value[:, k] > 0.5 * open_[k]
        w = highest_of(edges(1)[k], n)
        assert np.mean(lit == is_sky(w[None], height)[0]) >= 0.7, k


@pytest.mark.parametrize("low", [72.0, 60.0])
def test_both_sides_of_a_hill_of_the_horizon_are_looked_at(low):
    """Behind the point its horizon hides the middle of a wide patch, to above its upper edge, but neither side.

    A wall hides all that is in the east, so half of what is left.
    """
    n = np.array([0.0, -np.sin(np.radians(low + 12.02)), np.cos(np.radians(low + 12.02))])
    k = next(k for k, patch in enumerate(np.degrees(edges(1))) if abs(patch[0] - low) < 1e-9)
    wall = ws.as_mesh(([(1e-3, -9, -9), (1e-3, 9, -9), (1e-3, 9, 9), (1e-3, -9, 9)], [(0, 1, 2), (0, 2, 3)]))
    open_ = ws.sky_matrix(FAR, at((0, 0, 0), n), 64).value[0, k]
    assert open_ > 0.0
    found = ws.sky_matrix(wall, at((0, 0, 0), n, 400), 64).value[:, k].mean()
    assert 0.4 <= found / open_ <= 0.6  # of 800 rays, to 0.02, of which a few are too faint
