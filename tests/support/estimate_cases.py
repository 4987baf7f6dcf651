"""Shared by the tests of estimates: points anywhere, a street, a square, and whether two estimates are equal."""

import numpy as np

import warpsample as ws


def at(position, normal, copies=1):
    """SurfacePoints without a face, each several times, with different ids and so different rays."""
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


def same(found, other):
    return np.array_equal(found.value, other.value) and np.array_equal(found.standard_error, other.standard_error)
