"""Texels: all that a bilinear lookup reads have a point, on the chart, whatever the order of the faces and the device."""

import pickle

import numpy as np
import pytest
import warp as wp
from lookups import two_charts
from second_device import second_device

import warpsample as ws
from warpsample.host.engine import MOST_WORK
from warpsample.host.progress import asking
from warpsample.texture.coverage import claim_texels, mark_overlaps, weigh_corners


def clipped(triangle, centre):
    """The area of what a triangle has within the square of half width 1 about a centre: by cutting it, edge by edge."""
    polygon = [tuple(p) for p in triangle - centre]
    for axis, sign in ((0, 1), (0, -1), (1, 1), (1, -1)):
        cut = []
        for p, q in zip(polygon, polygon[1:] + polygon[:1], strict=True):
            a, b = 1 - sign * p[axis], 1 - sign * q[axis]
            if a >= 0:
                cut.append(p)
            if a * b < 0:
                cut.append(tuple(np.add(p, np.subtract(q, p) * a / (a - b))))
        polygon = cut
    x, y = np.array(polygon or [(0, 0)]).T
    return 0.5 * abs(np.dot(x, np.roll(y, -1)) - np.dot(y, np.roll(x, -1)))


def random_charts(count, seed):
    """Triangles, many slivers or below a texel, the last one large, and a flat mesh whose positions are their places."""
    rng = np.random.default_rng(seed)
    size = 10 ** rng.uniform(-2.5, -0.3, (count, 1, 1))
    flat = 10 ** rng.uniform(-2.0, 0.0, (count, 1, 1))
    uv = rng.uniform(0.2, 0.8, (count, 1, 2)) + size * rng.uniform(-0.5, 0.5, (count, 3, 2)) * np.where(
        [True, False], 1.0, flat
    )
    uv[-1] = (0.3, 0.3), (0.3, 0.7), (0.7, 0.35)
    vertices = np.pad(uv.reshape(-1, 2), ((0, 0), (0, 1)))
    return ws.Mesh(vertices, np.arange(3 * count).reshape(-1, 3)), uv


def test_the_search_for_texels_can_be_interrupted_where_many_faces_fill_the_image():
    """All 600 faces were one batch, after which alone an interrupt counts: with 20,000 faces it took minutes."""
    mesh = ws.Mesh(np.eye(3), np.tile([[0, 1, 2]], (600, 1)))
    asked = []
    with asking(lambda: asked.append(1)):
        t = ws.texture_points(mesh, np.tile([[[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]]], (600, 1, 1)), 512)
    assert t.report.overlapped > 100_000
    assert len(asked) >= 2 * 600 * 512**2 // MOST_WORK


def test_covered_is_what_a_lookup_reads():
    """Against the areas of faces cut out by each texel's tent. 1e-9: areas of texels that are only touched are roundings."""
    width, height = 24, 17
    mesh, uv = random_charts(20, 1)
    t = ws.texture_points(mesh, uv, (width, height))
    centres = np.stack(np.meshgrid(np.arange(width) + 0.5, np.arange(height) + 0.5), axis=-1).reshape(-1, 2)
    areas = np.array([[clipped(face * (width, height), c) for face in uv] for c in centres])
    sure = (areas.max(axis=1) > 1e-9) | (areas.max(axis=1) == 0.0)
    covered = np.isin(np.arange(width * height), t.texel)
    assert sure.mean() > 0.99
    assert np.array_equal(covered[sure], (areas.max(axis=1) > 0.0)[sure])
    assert 50 < covered.sum() < 350
    assert t.report.covered == covered.sum() == len(t)
    assert np.array_equal(t.covered, covered.reshape(height, width))
    assert np.array_equal(t.points.id, t.texel)


def test_a_point_is_the_nearest_of_the_chart():
    """Within a face it is the centre itself; else no point of any face that the lookup reads is nearer, tried at random."""
    mesh, uv = random_charts(20, 2)
    t = ws.texture_points(mesh, uv, 24)
    centres = np.stack([t.texel % 24 + 0.5, t.texel // 24 + 0.5], axis=1)
    found = 24 * t.points.position[:, :2]
    distance = np.linalg.norm(found - centres, axis=1)
    rng = np.random.default_rng(3)
    weights = rng.dirichlet((0.3, 0.3, 0.3), 4000)
    assert (t.points.barycentric >= 0.0).all()
    assert np.abs(t.points.barycentric.sum(axis=1) - 1.0).max() <= 1e-15
    for face in 24 * uv:
        tried = weights @ face
        offset = np.abs(tried[None] - centres[:, None])
        read = offset.max(axis=2) < 1.0
        nearest = np.where(read, np.linalg.norm(offset, axis=2), np.inf).min(axis=1)
        assert (distance <= nearest + 1e-12).all()
    assert (distance < 1e-12).sum() > 20


def test_the_order_of_the_faces_does_not_matter():
    mesh, uv = two_charts()
    order = [3, 1, 0, 2]
    turned = ws.Mesh(mesh.vertices, mesh.faces[order])
    for samples in (1, 4):
        one = ws.texture_points(mesh, uv, 40, samples=samples)
        other = ws.texture_points(turned, uv[order], 40, samples=samples)
        assert np.array_equal(one.id, other.id)
        assert np.abs(one.points.position - other.points.position).max() <= 1e-14


def test_samples_are_stratified_and_outside_of_charts_there_are_none():
    """Of 16 in a texel within a chart one is in each of 4 x 4 cells; on its border only those within count."""
    square = ws.Mesh([[0, 0, 0], [8, 0, 0], [8, 8, 0], [0, 8, 0]], [[0, 1, 2], [0, 2, 3]])
    uv = np.array([[(0, 1), (1, 1), (1, 0)], [(0, 1), (1, 0), (0, 0)]]) * 0.5 + 0.25
    t = ws.texture_points(square, uv, 16, samples=16)
    place = t.points.position[:, :2] * (1, -1) + (4, 12)
    cells = np.floor(4 * (place - np.floor(place)))
    inside = ((place > 5) & (place < 11)).all(axis=1)
    number = (t.texel * 16 + 4 * cells[:, 1] + cells[:, 0])[inside].astype(int)
    assert len(np.unique(number)) == len(number) == 36 * 16
    counts = np.bincount(t.texel, minlength=256).reshape(16, 16)
    assert (counts[4:12, 4:12] == 16).all()
    ring = counts[3:13, 3:13].copy()
    ring[1:-1, 1:-1] = 1
    assert (ring == 1).all()  # what lookups read beyond the chart has its nearest point
    assert counts.sum() == 64 * 16 + 36


def test_slivers_between_centres_have_texels():
    """A strip of a fiftieth of a texel, far from all centres, is read from the two rows of texels beside it."""
    mesh = ws.Mesh([[0, 0, 0], [1, 0, 0], [1, 0.001, 0], [0, 0.001, 0]], [[0, 1, 2], [0, 2, 3]])
    strip = np.array([(0.2, 0.5), (0.8, 0.5), (0.8, 0.501), (0.2, 0.501)])
    for samples in (1, 4):
        t = ws.texture_points(mesh, strip[mesh.faces], 20, samples=samples)
        assert np.unique(t.texel // 20).tolist() == [9, 10]
        assert np.unique(t.texel % 20).tolist() == list(range(3, 17))


@pytest.mark.parametrize(
    ("height", "width", "count"),
    [(0.1, 0.9, 2), (3.9, 0.9, 2), (4.1, 0.9, 0), (100.0, 0.9, 0), (0.1, 1.1, 0), (0.1, 1e-7, 2)],
)
def test_faces_much_narrower_in_the_image_than_on_the_mesh_are_counted(height, width, count):
    """A quad of 1 m x `height`, in the image `width` x 32 texels; by the scale along its height it is 32 / height wide."""
    corners = np.array([[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]])
    for turn in (0, 1, 2):
        faces = np.roll([[0, 1, 2], [0, 2, 3]], turn, axis=1)
        mesh = ws.Mesh(np.column_stack([corners * [1.0, height], np.zeros(4)]), faces)
        assert ws.texture_points(mesh, (corners * [width / 64, 0.5])[faces], 64).report.squeezed == count


@pytest.mark.parametrize("density", [1.0, 0.01, None])
def test_squeezed_faces_are_counted_beside_parts_with_fewer_texels(density):
    """Four faces share a chart, and two of them are squeezed; a ground has `density` as many texels per length, or none."""
    column = np.array([[0.0, 0.0], [0.0, 1.0], [1.0, 0.0], [1.0, 1.0], [2.0, 0.0], [2.0, 1.0]])
    faces = np.array([[0, 2, 3], [0, 3, 1], [2, 4, 5], [2, 5, 3]])
    chart = (column * (0.1, 0.1))[faces]
    chart[2:, :, 0] = 0.1 + 1e-3 * (chart[2:, :, 0] - 0.1)
    ground = np.array([[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]])
    vertices = np.concatenate([column, ground / (density or 0.01) + (4.0, 0.0)])
    mesh = ws.Mesh(np.column_stack([vertices, np.zeros(9)]), np.concatenate([faces, [[6, 7, 8]]]))
    uv = np.concatenate([chart, [ground * 0.1 + (0.6, 0.5)]])
    if density is None:
        uv[-1] = np.nan
    assert ws.texture_points(mesh, uv, 128).report.squeezed == 2


@pytest.mark.parametrize("turn", [0, 1, 2])
@pytest.mark.parametrize("width", [0.0, 1e-30, 6.1e-17, 1e-15, 1e-14, 1e-3])
@pytest.mark.parametrize("size", [256, (32, 256), 300])
def test_each_face_without_a_width_in_the_image_is_counted(size, width, turn):
    """The cosine of 90 degrees is 6e-17. Right-angled faces of this width were neither without an area nor squeezed.

    Nor were faces of 1e-14 in images that are not square.
    """
    corners = np.array([[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]])
    faces = np.roll([[0, 1, 2], [2, 3, 0]], turn, axis=1)
    mesh = ws.Mesh(np.column_stack([corners, np.zeros(4)]), faces)
    report = ws.texture_points(mesh, (corners * (width, 1.0))[faces], size).report
    assert report.zero_area + report.squeezed == 2


def test_a_wrapped_face_of_a_thin_band_is_squeezed():
    """48 quads of a hoop lie in a row less than a texel high. The first goes from u = 0.93 back to 0.05, over all others."""
    angle = np.arange(48) * 2.0 * np.pi / 48
    circle = np.column_stack([np.cos(angle), np.sin(angle), 0.0 * angle])
    place = np.column_stack([0.05 + 0.9 * np.arange(48) / 48, np.full(48, 0.5)])
    before, after = np.roll(np.arange(48), 1), np.arange(48)
    faces = np.stack([before, before + 48, after + 48, before, after + 48, after], axis=1).reshape(-1, 3)
    mesh = ws.Mesh(np.concatenate([circle, 1.02 * circle]), faces)
    for size in (128, 256, 1024):
        uv = np.concatenate([place + np.array([0.0, height / size]) for height in (0.93, 0.2)])
        assert ws.texture_points(mesh, uv[faces], size).report.squeezed == 2


def test_a_face_that_is_thin_on_the_mesh_is_not_squeezed():
    """xatlas rounds the chart of a thin disc's rim up to one texel. Such faces were counted, by their shortest edges."""
    thin = ws.Mesh([[0, 0, 0], [0.245, 0, 0], [0, 0.01, 0]], [[0, 1, 2]])
    uv = np.array([[[0.0, 0.0], [1.5, 0.0], [0.0, 0.65]]])
    assert ws.texture_points(thin, uv / 16, 16).report.squeezed == 0
    uv[0, 0, 0] = np.inf
    with np.errstate(all="raise"):
        assert ws.texture_points(thin, uv / 16, 16).report.squeezed == 0


@pytest.mark.parametrize("layers", [1, 2])
def test_an_overlap_is_found_where_all_centres_lie_on_edges(layers):
    """Two sheets at one place of the image, with vertices at the centres of texels: they counted as free of overlaps."""
    i, j = np.divmod(np.arange(64), 8)
    place = np.column_stack([i, j]).astype(np.float64)
    corner = np.flatnonzero((i < 7) & (j < 7))
    faces = np.concatenate([corner[:, None] + (0, 8, 9), corner[:, None] + (0, 9, 1)])
    mesh = ws.Mesh(
        np.concatenate([np.column_stack([place, np.full(64, z)]) for z in range(layers)]),
        np.concatenate([faces + 64 * z for z in range(layers)]),
    )
    uv = np.concatenate([((place + 0.5) / 8)[faces]] * layers)
    report = ws.texture_points(mesh, uv, 8).report
    assert report.overlapped == (49 if layers == 2 else 0)


@pytest.mark.parametrize(
    ("width", "stacked", "texels"), [(0.3, 12, 1), (0.01, 4, 1), (1e-4, 12, 1), (0.3, 1, 0), (0.3, 2, 0)]
)
def test_faces_on_one_place_of_a_palette_overlap_however_small(width, stacked, texels):
    """Faces that contain no texel's centre counted as free of overlaps: `--uv auto` gave a body a single value."""
    faces = np.arange(3 * 24).reshape(-1, 3)
    mesh = ws.Mesh(np.random.default_rng(1).uniform(size=(72, 3)), faces)
    uv = np.full((24, 3, 2), np.nan)
    swatch = np.array([(0.0, 0.0), (1.0, 0.0), (0.0, 1.0)])
    uv[:stacked] = (np.array([5.1, 9.2]) + width * swatch) / 16
    if stacked == 2:  # two halves of a square
        uv[1] = (np.array([5.1, 9.2]) + width * (1.0 - swatch)) / 16
    t = ws.texture_points(mesh, uv, 16)
    assert t.report.overlapped == texels
    assert (t.report.covered, t.report.zero_area, t.report.squeezed) == (4, 0, 0)


@pytest.mark.parametrize("tangents", [False, True])
def test_faces_without_coordinates_have_no_points(tangents):
    triangle = ws.Mesh([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]])
    assert len(ws.texture_points(triangle, np.full((1, 3, 2), np.nan), 8, tangents=tangents)) == 0


def test_what_is_wrong_with_coordinates_is_counted_and_named():
    faces = np.arange(21).reshape(-1, 3)
    vertices = np.random.default_rng(1).uniform(size=(21, 3))
    mesh = ws.Mesh(vertices, faces, part=[0, 1, 2, 2, 1, -1, 3], parts=("left", "right", "rest", "rest"))
    big = np.array([(0.1, 0.1), (0.1, 0.4), (0.4, 0.1)])
    right, low = np.array([(0.5, 0.0), (0.0, 0.7)])
    uv = np.stack([big, big, big + 0.5, big[::-1] + right, big * 0 + 0.3, big + low, big])
    uv[6, 0, 0] = np.nan
    report = ws.texture_points(mesh, uv, 32).report
    inside = ws.texture_points(mesh, uv[[0, 4, 4, 4, 4, 4, 4]], 32)
    alone = ws.Mesh(vertices, faces[:1])
    centres = np.abs(ws.texture_points(alone, uv[:1], 32).points.barycentric - 0.5).max(axis=1)
    assert (report.outside, report.zero_area, report.mirrored, report.without_uv) == (1, 1, 1, 1)
    assert 0 < report.overlapped <= (centres < 0.5).sum()
    assert inside.report.zero_area == 6
    assert inside.report.overlapped == 0
    assert report.named["overlapped"] == ("left", "right")
    assert report.named["outside"] == ()
    assert report.named["zero_area"] == ("right",)
    assert report.named["mirrored"] == report.named["without_uv"] == ("rest",)
    assert pickle.loads(pickle.dumps(report)) == report


def test_neighbours_that_share_an_edge_do_not_overlap():
    """A fan about a point whose edges meet texel centres, of both windings."""
    ring = [(np.cos(a), np.sin(a)) for a in 2 * np.pi * np.arange(12) / 12]
    uv = np.array([[(0, 0), ring[k], ring[(k + 1) % 12]] for k in range(12)]) * 0.4 + (0.5 + 1 / 32)
    uv[::2] = uv[::2, ::-1]
    mesh = ws.Mesh(np.pad(uv.reshape(-1, 2), ((0, 0), (0, 1))), np.arange(36).reshape(-1, 3))
    report = ws.texture_points(mesh, uv, 16).report
    assert (report.overlapped, report.mirrored) == (0, 6)


def test_an_image_without_faces_has_no_texels():
    mesh, uv = two_charts()
    t = ws.texture_points(mesh, uv + 5.0, 16)
    assert (len(t), t.report.covered, t.report.outside) == (0, 0, 4)
    assert t.points.position.shape == (0, 3)


def test_a_second_device_gives_the_same_bits():
    mesh, uv = two_charts()
    for samples in (1, 4):
        here = ws.texture_points(mesh, np.concatenate([uv[:3], uv[:1]]), 64, samples=samples)
        with second_device():
            there = ws.texture_points(mesh, np.concatenate([uv[:3], uv[:1]]), 64, samples=samples, device="cpu")
            points = there.points
        assert here.report == there.report
        assert here.report.overlapped > 0
        assert np.array_equal(here.id, there.id)
        assert np.array_equal(here.face, there.face)
        assert np.array_equal(here.points.position, points.position)


@pytest.mark.slow
def test_the_kernels_compile_for_cuda(tmp_path):
    for kernel in (claim_texels(), mark_overlaps(), weigh_corners()):
        (ptx,) = wp.compile_aot_module(kernel.module, device=None, arch=86, use_ptx=True, module_dir=tmp_path)
        assert ".visible .entry" in ptx.read_text()
