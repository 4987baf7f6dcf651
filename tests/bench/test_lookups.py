"""Errors of lookups in a texture: noise, overlap and resolution, against closed forms and estimated errors."""

import numpy as np
import pytest
from lookups import floor_by_a_wall, two_charts

import warpsample as ws
from warpsample.bench.textures.lookups import read_bilinear, sample_places

HEIGHT, DEPTH, SIDE = 1.0, 4.0, 16


def stacked():
    """Two floors by long walls, side by side in the image, and an open floor with the coordinates of the first one.

    In an image of 16 texels a side each is 7 texels wide, and 2 are between them. The first floor is seen on the open one.
    """
    mesh, uv = floor_by_a_wall(HEIGHT, 50.0, DEPTH)
    places = [mesh.vertices + np.array((x, 0.0, 0.0)) for x in (0.0, 1000.0)] + [
        mesh.vertices[:4] - np.array((1000.0, 0.0, 0.0))
    ]
    faces = [mesh.faces, mesh.faces + 8, mesh.faces[:2] + 16]
    first, second = uv * (7 / 16, 1.0), uv * (7 / 16, 1.0) + (9 / 16, 0.0)
    return ws.Mesh(np.concatenate(places), np.concatenate(faces)), np.concatenate([first, second, first[:2]])


def folded():
    """A square folded in the image along its diagonal, where both halves lie on the same corner."""
    square = ws.Mesh([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], [[0, 1, 2], [2, 3, 0]])
    place = np.array([(0.1, 0.1), (0.9, 0.1), (0.9, 0.9), (0.9, 0.1)])
    return square, place[square.faces]


@pytest.mark.parametrize(("made", "share"), [(two_charts, 0.0), (stacked, 2 / 3), (folded, 1.0)])
def test_places_are_shared_that_read_texels_of_others(made, share):
    """All or none, but for two floors of three, with a standard deviation of 0.007 of 4,000 places."""
    mesh, uv = made()
    places = sample_places(ws.texture_points(mesh, uv, SIDE, normals="smooth"), uv, 4000, 16, 0)
    assert places.shared.mean() == pytest.approx(share, abs=0.03 if share % 1.0 else 0.0)


@pytest.mark.thorough
def test_noise_overlap_and_resolution_are_the_whole_error():
    """Each is found in a second way: by the stated errors, by many rays, and overlap by a closed form.

    Their sum is the mean square error of images of other seeds, within 4 of its standard errors, at places that are shared
    and at the others.
    """
    mesh, uv = stacked()
    t = ws.texture_points(mesh, uv, SIDE, normals="smooth")
    places = sample_places(t, uv, 20_000, 16_384, 1 << 40)
    bakes = [ws.ambient_occlusion(mesh, t.points, 64, sequence="independent", seed=seed) for seed in range(40)]
    images = [t.image(bake.value) for bake in bakes]
    best = t.image(ws.ambient_occlusion(mesh, t.points, 65_536, seed=99).value)
    squares = [(read_bilinear(image, places.uv) - places.right) ** 2 for image in images]
    common = (read_bilinear(best, places.uv) - places.right) ** 2
    variances = [np.square(t.image_error(bake.standard_error)).ravel() for bake in bakes]
    noise = compute_lookup_variance(places.uv, np.mean(variances, axis=0))
    pairs = [places.compute_error(images[k : k + 2]) for k in range(0, len(images), 2)]

    for name, half in (("overlap", places.shared), ("resolution", ~places.shared)):
        part, whole = np.mean(common * half), np.array([np.mean(square * half) for square in squares])
        error = whole.std(ddof=1) / np.sqrt(len(whole))
        assert abs(whole.mean() - np.mean(noise * half) - part) < 4.0 * error
        assert 8.0 * error < part  # so that it cannot be missing
        assert_mean(part, [pair[name] ** 2 for pair in pairs])
    assert_mean(np.mean(noise), [pair["noise"] ** 2 for pair in pairs])
    a = DEPTH / HEIGHT  # the mean over the depth of (1 - V)^2, by V = (1 + d / sqrt(d^2 + h^2)) / 2
    closed = (2.0 * a - 2.0 * (np.sqrt(a * a + 1.0) - 1.0) - np.arctan(a)) / (4.0 * a) / 3.0
    assert np.mean(common * places.shared) == pytest.approx(closed, rel=0.1)  # a third of the places: 2 %; half a texel: 3 %


def assert_mean(right, found):
    """Check that the mean is within 4 standard errors."""
    assert abs(np.mean(found) - right) < 4.0 * np.std(found, ddof=1) / np.sqrt(len(found))


def compute_lookup_variance(uv, variance):
    """Return the variance of each lookup, from the variances (T,) of the texels, which are independent."""
    ways = (read_bilinear(np.eye(SIDE**2)[texel].reshape(SIDE, SIDE), uv) ** 2 * variance[texel] for texel in range(SIDE**2))
    return sum(ways)
