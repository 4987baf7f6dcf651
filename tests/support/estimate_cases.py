"""What the tests of estimates share: points anywhere, a street, a square, a sky, and whether two estimates are the same."""

import numpy as np

import warpsample as ws


def at(position, normal, copies=1):
    """SurfacePoints without a face, `copies` of each, with ids, and so rays, of their own."""
    position, normal = (np.repeat(np.atleast_2d(np.float64(a)), copies, axis=0) for a in (position, normal))
    return ws.SurfacePoints(position, np.broadcast_to(normal, position.shape).astype(np.float32))


def street(width, height):
    """An infinite street: ground and both walls, 10^4 widths long."""
    end = 5e3 * width
    corners = [(x, y, z) for x in (0.0, width) for y in (-end, end) for z in (0.0, height)]
    return ws.as_mesh((corners, [(0, 4, 6), (0, 6, 2), (0, 2, 3), (0, 3, 1), (4, 5, 7), (4, 7, 6)]))


def square(z=1.0):
    """The unit square at a height, facing down."""
    return ws.as_mesh(([(0, 0, z), (1, 0, z), (1, 1, z), (0, 1, z)], [(0, 2, 1), (0, 3, 2)]))


def lid(half, x=0.0, y=0.0):
    """A wide lid at height 1, facing down, with a square hole around (x, y) whose sides are 2 `half` long."""
    far = 2000.0
    columns = np.array([(-far, x - half), (x + half, far), (x - half, x + half), (x - half, x + half)])
    rows = np.array([(-far, far), (-far, far), (-far, y - half), (y + half, far)])
    corners = np.stack([columns[:, [0, 0, 1, 1]], rows[:, [0, 1, 1, 0]], np.ones((4, 4))], axis=2).reshape(-1, 3)
    return ws.as_mesh((corners, (4 * np.arange(4)[:, None, None] + np.array([[0, 1, 2], [0, 2, 3]])).reshape(-1, 3)))


def same(found, other):
    return np.array_equal(found.value, other.value) and np.array_equal(found.standard_error, other.standard_error)


def irradiance(mesh, points, count, **options):
    """Irradiance under a sky that is bright on top and dark below."""
    return ws.irradiance(mesh, points, np.linspace(2.0, 0.0, 32)[:, None].repeat(4, axis=1), count, **options)
