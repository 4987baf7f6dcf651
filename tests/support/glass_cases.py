"""Bodies of faces that let light through, and values of theirs that are known."""

import numpy as np

import warpsample as ws

_BOX = [[0, 1, 3], [0, 3, 2], [4, 6, 7], [4, 7, 5], [0, 4, 5], [0, 5, 1], [2, 3, 7], [2, 7, 6], [0, 2, 6], [0, 6, 4]]
_BOX += [[1, 5, 7], [1, 7, 3]]
UP = (0.0, 0.0, 1.0)


def box(low, high):
    """(vertices, faces) of a closed box."""
    x, y, z = zip(low, high, strict=True)
    return np.array([[a, b, c] for a in x for b in y for c in z], float), np.array(_BOX)


def sheet(half, height):
    """(vertices, faces) of a square of 2 x half at a height."""
    corners = [(-half, -half, height), (half, -half, height), (half, half, height), (-half, half, height)]
    return np.array(corners, float), np.array([[0, 1, 2], [0, 2, 3]])


def made_of(*parts):
    """A mesh of ((vertices, faces), transmittance) each."""
    count = np.cumsum([0] + [len(vertices) for (vertices, _), _ in parts])
    faces = np.concatenate([faces + first for ((_, faces), _), first in zip(parts, count, strict=False)])
    tau = np.concatenate([np.full(len(faces), tau) for (_, faces), tau in parts])
    return ws.as_mesh((np.concatenate([vertices for (vertices, _), _ in parts]), faces), transmittance=tau)


def shells(*taus):
    """Closed boxes of glass, one around the other, about the origin."""
    return made_of(*((box([-size] * 3, [size] * 3), tau) for size, tau in enumerate(taus, start=1)))


def canyon(*more):
    """A street as wide as its walls are high, 1, and 10^4 long, with more parts."""
    end = 5e3
    corners = [(x, y, z) for x in (-0.5, 0.5) for y in (-end, end) for z in (0.0, 1.0)]
    walls = np.array(corners), np.array([(0, 4, 6), (0, 6, 2), (0, 2, 3), (0, 3, 1), (4, 5, 7), (4, 7, 6)])
    return made_of((walls, 0.0), *more)


def lid(height):
    """(vertices, faces) of a roof over that street."""
    corners = [(-0.5, -5e3, height), (0.5, -5e3, height), (0.5, 5e3, height), (-0.5, 5e3, height)]
    return np.array(corners), np.array([[0, 1, 2], [0, 2, 3]])


CASES = {  # shared/LIGHT.md, C: what a point at the origin that faces up sees of the sky
    "canopy over a canyon": (canyon((lid(1.0), 0.1)), 0.0447214),
    "dim sheet": (made_of((sheet(5.0, 3.0), 0.03)), 0.24932),
    "sheet": (made_of((sheet(5.0, 3.0), 0.2)), 0.38088),
    "two sheets": (made_of((sheet(5.0, 3.0), 0.5), (sheet(2.0, 6.0), 0.25)), 0.56681),
    "box crown": (made_of((box([-5, -5, 3], [5, 5, 6]), 0.2)), 0.25706),
    "box aside": (made_of((box([4, -2, 3], [8, 2, 7]), 0.2)), 0.91850),
    "coincident sheets": (made_of(*[(sheet(1e4, 3.0), 0.5)] * 3), 0.125),
}


def garden(crown=0.3, ground=0.0):
    """A ground with an opaque house, glass, and two crowns that overlap in no direction from the ground."""
    return made_of(
        (sheet(30.0, 0.0), ground),
        (box([10, -4, 0], [14, 4, 9]), 0.0),
        (sheet(4.0, 3.0), crown),
        (box([-12, -4, 4], [-7, 4, 9]), 0.3),
    )


def at_origin(copies):
    """Points at the origin that face up, with rays of their own."""
    return ws.SurfacePoints(np.zeros((copies, 3)), np.tile(np.float32(UP), (copies, 1)))


def same_bits(found, other, *names):
    """Whether two results have the same numbers."""
    return all(np.array_equal(getattr(found, name), getattr(other, name)) for name in ("value", "standard_error", *names))
