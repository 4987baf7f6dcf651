"""What is proven of suns without rays: shafts hold their suns and discs, and what covers a shaft is met by all of it."""

import numpy as np
import pytest
import warp as wp
from margin_cases import N, bits, launch, leaves, on_cpu, rays_into_the_scene
from sun_cases import mixed, unit, year

from warpsample.radiation.sun.proofs import COVER_MARGIN, highest
from warpsample.radiation.sun.suns import GROUP, SunTree
from warpsample.tracing.sight.cover import covering_triangles
from warpsample.tracing.sight.shafts import CORNERS, PLANES, VECTORS_BYTES
from warpsample.tracing.wide.layout import LEAF_BYTES, WIDTH

TURNED = 2.0**-20.4  # by which rays of a disc are rounded
CASES = {
    "year": lambda: year(3),
    "mixed": lambda: mixed(np.random.default_rng(1)),
    "one": lambda: unit([[1.0, 2.0, 3.0]]),
    "few": lambda: unit(np.random.default_rng(2).normal(size=(18, 3))),
    "equal": lambda: np.tile(unit([0.3, 0.1, 0.9]), (40, 1)),
    "opposite": lambda: np.concatenate([np.eye(3), -np.eye(3)]),
}


def vectors_of(shafts):
    """(planes (..., 4, 3), corners (..., 4, 3)) in float64."""
    rows = np.swapaxes(shafts.astype(np.float64), -1, -2)
    return rows[..., 1:PLANES, :], rows[..., PLANES : PLANES + CORNERS, :]


def rim(directions, radius, steps=32):
    """(T, steps, 3) float64 directions at that angle from each."""
    d = directions.astype(np.float64)
    x = unit(np.cross(d, np.eye(3)[np.abs(d).argmin(axis=1)]))
    turn = 2.0 * np.pi * np.arange(steps) / steps
    across = np.cos(turn)[:, None] * x[:, None] + np.sin(turn)[:, None] * np.cross(d, x)[:, None]
    return np.cos(radius) * d[:, None] + np.sin(radius) * across


def closed(planes, corners):
    """Whether each plane goes through two of the corners, and each corner is on two planes: so they bound one shaft."""
    inwards = planes @ corners.T
    on = np.abs(inwards) < 2.0**-21
    return (inwards > -(2.0**-21)).all() and (on.sum(axis=0) >= 2).all() and (on.sum(axis=1) >= 2).all()


@pytest.mark.parametrize("disc", [0.0, 0.533, 45.0])
@pytest.mark.parametrize("name", CASES)
def test_a_shaft_holds_its_suns(name, disc):
    suns = unit(CASES[name]()).astype(np.float32)
    tree = SunTree.of(suns, disc)
    sizes = (np.abs(tree.groups).sum(axis=1) > 0.0).sum(axis=1)
    assert (tree.spans[:, 3] != 0).any() == (name not in ("few", "opposite"))
    for (first, last, _, of_use), shaft in zip(tree.spans, tree.shafts, strict=True):
        if of_use:
            own = np.concatenate([tree.columns[g, : sizes[g]] for g in range(first, last)])
            planes, corners = vectors_of(shaft)
            assert (rim(suns[own], np.radians(0.5 * disc)).reshape(-1, 3) @ planes.T).min() >= -(2.0**-22)
            assert closed(planes, corners)
    if disc:
        for group, column in np.ndindex(len(sizes), WIDTH):
            if column < sizes[group]:
                planes, corners = vectors_of(tree.disc_shafts[group, column])
                held = rim(tree.groups[group, :, column][None], np.radians(0.5 * disc))[0]
                assert (held @ planes.T).min() >= -(2.0**-22)
                assert (held @ planes.T).max(axis=0).max() <= 2.1 * np.sin(np.radians(0.5 * disc)) + 1e-6


@pytest.mark.parametrize("name", CASES)
def test_the_tree_has_every_sun_once_and_every_node_before_its_children(name):
    suns = unit(CASES[name]()).astype(np.float32)
    tree = SunTree.of(suns, 0.0)
    sizes = (np.abs(tree.groups).sum(axis=1) > 0.0).sum(axis=1)
    assert sizes.max() <= GROUP
    assert sizes.min() >= min(len(suns), GROUP // 2)
    columns = np.concatenate([row[:size] for row, size in zip(tree.columns, sizes, strict=True)])
    assert np.array_equal(np.sort(columns), np.arange(len(suns)))
    directions = np.concatenate([row[:, :size].T for row, size in zip(tree.groups, sizes, strict=True)])
    assert np.array_equal(directions, suns[columns])
    node, seen = 0, []
    while node < len(tree.spans):  # as the kernel walks if nothing is proven
        first, last, after, _ = tree.spans[node]
        below = tree.spans[node + 1 : after]
        assert len(below) == 2 * (last - first) - 2
        assert ((below[:, 0] >= first) & (below[:, 1] <= last)).all()
        if last == first + 1:
            seen.append(first)
        node += 1
    assert seen == list(range(len(sizes)))
    assert tree.spans[0, 2] == len(tree.spans)


def test_a_tree_is_made_once_for_the_same_suns():
    suns = year().astype(np.float32)
    tree = SunTree.of(suns, 0.0)
    assert SunTree.of(suns.copy(), 0.0) is tree
    assert SunTree.of(suns, 0.5) is not tree
    suns[0] = suns[1]
    assert np.array_equal(SunTree.of(suns, 0.0).groups, SunTree.built(suns, 0.0).groups)
    assert not np.array_equal(SunTree.of(suns, 0.0).groups, tree.groups)


def test_groups_of_a_year_are_narrow():
    tree = SunTree.of(year().astype(np.float32), 0.0)
    _, corners = vectors_of(tree.shafts[tree.spans[:, 1] == tree.spans[:, 0] + 1])
    radius = np.degrees(
        np.arccos(np.clip((corners * unit(corners.sum(axis=1))[:, None]).sum(axis=2).min(axis=1), -1.0, 1.0))
    )
    assert np.median(radius) < 2.0
    assert tree.spans[tree.spans[:, 1] == tree.spans[:, 0] + 1, 3].all()


@wp.kernel(enable_backward=False, module="unique")
def _cover(
    triangles: wp.array2d[wp.float32],
    shafts: wp.array2d[wp.float32],
    origins: wp.array[wp.vec3],
    normals: wp.array[wp.vec3],
    masks: wp.array[wp.int32],
    most: wp.array[wp.float32],
):
    i = wp.tid()
    shaft = shafts.ptr + wp.uint64(i) * VECTORS_BYTES
    masks[i] = covering_triangles(triangles.ptr + wp.uint64(i) * wp.uint64(LEAF_BYTES), shaft, origins[i], COVER_MARGIN)
    most[i] = highest(shaft, normals[i])


def shafts_at(ways, radius):
    """(N, 3, 16) float32 square shafts of those half-angles, and their corners (N, 4, 3)."""
    d = ways.astype(np.float64)
    x = unit(np.cross(d, np.eye(3)[np.abs(d).argmin(axis=1)]))
    y, r = np.cross(d, x), np.tan(radius)[:, None]
    corners = unit(np.stack([d + i * r * x + j * r * y for i in (-1, 1) for j in (-1, 1)], axis=1)).astype(np.float32)
    shafts = np.zeros((len(d), 3, WIDTH), np.float32)
    shafts[..., PLANES : PLANES + CORNERS] = np.swapaxes(corners, 1, 2)
    return shafts, corners.astype(np.float64)


def covered(origins, corners, triangles):
    """(N, 16) by how much, at least, a triangle's edges are beyond all corners of a shaft, as an angle; below 0: not."""
    a, b, c = (triangles[:, :, k].astype(np.longdouble) - origins[:, None] for k in range(3))
    volume = (a * np.cross(b, c)).sum(axis=2)
    edges = [np.cross(p, q) for p, q in ((a, b), (b, c), (c, a))]
    with np.errstate(all="ignore"):
        normals = np.stack([e / np.linalg.norm(e.astype(np.float64), axis=2, keepdims=True) for e in edges], axis=2)
        inner = np.einsum("nkei,nqi->nkeq", (np.sign(volume)[..., None, None] * normals).astype(np.float64), corners)
        return np.where(volume == 0.0, -1.0, inner.min(axis=(2, 3)))


@pytest.mark.parametrize("seed", range(3))
def test_a_triangle_that_covers_a_shaft_is_met_by_all_of_it(seed):
    rng, origins, ways = rays_into_the_scene(seed)
    radius = 10.0 ** rng.uniform(-7.0, -0.7, N)
    shafts, corners = shafts_at(ways, radius)
    d = ways.astype(np.float64)
    x = unit(np.cross(d, np.eye(3)[np.abs(d).argmin(axis=1)]))[:, None]
    y = np.cross(d[:, None], x)
    # Triangles across the shaft, whose edges pass beside its corners by 10^-9 to 1 of a radian, before or behind the point.
    turn = rng.uniform(0, 2 * np.pi, (N, WIDTH, 1, 1)) + 2.0 * np.pi / 3.0 * np.arange(3)[:, None]
    beside = 10.0 ** rng.uniform(-9.0, 0.0, (N, WIDTH, 1, 1)) * rng.choice([-1.0, 1.0, 1.0], (N, WIDTH, 1, 1))
    size = 2.0 * np.maximum(np.sqrt(2.0) * np.tan(radius)[:, None, None, None] + beside, 1e-9)
    distance = 10.0 ** rng.uniform(-5.0, 0.5, (N, WIDTH, 1, 1)) * rng.choice([-1.0, 1.0, 1.0, 1.0], (N, WIDTH, 1, 1))
    # And every fourth about the point: its plane next to nothing before or behind it.
    size[:, ::4] = 10.0 ** rng.uniform(0.0, 8.0, size[:, ::4].shape)
    distance[:, ::4] = np.copysign(np.minimum(1.0, np.abs(distance)), distance)[:, ::4] / size[:, ::4]
    tilt = 1.0 + 0.5 * rng.uniform(-1.0, 1.0, (N, WIDTH, 3, 1))
    way = d[:, None, None] + size * (np.cos(turn) * x[:, :, None] + np.sin(turn) * y[:, :, None])
    triangles = (origins[:, None, None] + distance * tilt * way).astype(np.float32)
    flip = rng.random((N, WIDTH)) < 0.5
    triangles[flip] = triangles[flip][:, ::-1]
    normals = unit(rng.normal(size=(N, 3))).astype(np.float32)
    masks, most = launch(
        _cover,
        N,
        [leaves(triangles), on_cpu(shafts.reshape(N, -1)), on_cpu(origins, wp.vec3), on_cpu(normals, wp.vec3)],
        wp.zeros(N, dtype=wp.int32, device="cpu"),
        wp.zeros(N, dtype=wp.float32, device="cpu"),
    )
    said, margin = bits(masks), covered(origins, corners, triangles)
    assert margin[said].min() > TURNED
    sides = np.linalg.norm(triangles.astype(np.float64) - origins[:, None, None], axis=3)
    clear = (
        (margin > 1e-4) & (sides.min(axis=2) > 1e-2 * sides.max(axis=2)) & (size[..., 0, 0] > 5e-3) & (size[..., 0, 0] < 1.0)
    )
    assert said[clear].mean() > 0.95
    assert clear.sum() > 0.05 * clear.size
    assert (~said & (margin > -1e-5) & (margin < 1e-7)).sum() > 1000  # close calls were among them
    exact = np.einsum("nqi,ni->nq", corners, normals.astype(np.float64)).max(axis=1)
    assert np.abs(most - exact).max() < 2.0**-21
