"""Scenes whose view factors are known, from VIEW_FACTORS.md: catalogues of Howell, string rules, contour integrals."""

from math import cos, pi, radians, sin

import numpy as np

import warpsample as ws


def rectangle(corner, first, second):
    """Corners of a rectangle whose front is on the side of first x second."""
    corner, first, second = (np.asarray(v, float) for v in (corner, first, second))
    return [corner, corner + first, corner + first + second, corner + second]


def polygon(radius, height, up, sides=64):
    """A regular polygon about the z axis, looking up or down; it touches the circle from inside."""
    turns = 2.0 * pi * np.arange(sides) / sides * (1 if up else -1)
    return [(radius * cos(t), radius * sin(t), height) for t in turns]


def scene(*polygons):
    """(mesh of convex polygons, fans of triangles; the number of the polygon of each)."""
    vertices, faces, groups = [], [], []
    for number, corners in enumerate(polygons):
        first = len(vertices)
        vertices.extend(corners)
        faces.extend([first, first + k, first + k + 1] for k in range(1, len(corners) - 1))
        groups.extend([number] * (len(corners) - 2))
    return ws.Mesh(np.array(vertices), np.array(faces)), np.array(groups)


def box(size=1.0, centre=(0.0, 0.0, 0.0), inwards=True):
    """The six rectangles of a cube."""
    low, s = np.asarray(centre, float) - size / 2, size
    x, y, z = s * np.eye(3)
    sides = [(low, x, y), (low + z, y, x), (low, y, z), (low + x, z, y), (low, z, x), (low + y, x, z)]
    return [rectangle(corner, *(edges if inwards else edges[::-1])) for corner, *edges in sides]


def hinged(degrees, length=1.0):
    """A rectangle on the ground and one at that angle to it, both of width 1, with an edge in common."""
    a = radians(degrees)
    return [
        rectangle((0, -length / 2, 0), (1, 0, 0), (0, length, 0)),
        rectangle((0, -length / 2, 0), (0, length, 0), (cos(a), 0, sin(a))),
    ]


X, Y, Z = np.eye(3)
GROUND, LID = rectangle((0, 0, 0), X, Y), rectangle((0, 0, 1), Y, X)
SQUARES = [GROUND, LID]

STRIP = 200.0 * Y
"""As long as 200 gaps: a piece in its middle sees as much as in one without end, but for 4e-7."""


def strip(corner, first, second):
    """A rectangle along y, given at y = 0; `first` or `second` is STRIP."""
    return rectangle(np.asarray(corner, float) - STRIP / 2, first, second)


PIECE = rectangle((0, -0.5, 0), X, Y)

CASES = {
    "C-11 1x1x1": (SQUARES, 0.1998248957),
    "C-11 1x1.5x.5": ([rectangle((0, 0, 0), X, 1.5 * Y), rectangle((0, 0, 0.5), 1.5 * Y, X)], 0.4755764365),
    "C-14 cube": ([GROUND, rectangle((0, 0, 0), Y, Z)], 0.2000437761),
    "C-14 h2 w1 l3": ([rectangle((0, 0, 0), X, 3 * Y), rectangle((0, 0, 0), 3 * Y, 2 * Z)], 0.3189967015),
    "C-13": ([rectangle((0, 0, 0), X, 2 * Y), rectangle((0.5, -1, 1.3), 1.7 * Y, 2 * X)], 0.1388332070),
    "C-15": ([rectangle((0.3, 0, 0), 0.8 * X, Y), rectangle((0, 0.4, 0.2), 1.6 * Y, 0.7 * Z)], 0.0941302600),
    "C-41 64-gons": ([polygon(1, 0, True), polygon(1, 1, False)], 0.3816914386),
    "hinged 30": (hinged(30), 0.6190283231),
    "hinged 150": (hinged(150), 0.0213453254),
    "corner quarter": ([*SQUARES, rectangle((0, 0, 0.5), 0.5 * X, 0.5 * Y)], 0.1498686718),
    "central quarter": ([*SQUARES, rectangle((0.25, 0.25, 0.5), 0.5 * X, 0.5 * Y)], 0.0995062946),
    "strings": ([PIECE, strip((0, 0, 1), STRIP, X)], 0.4142135624),
    "strings screened": ([PIECE, strip((0, 0, 1), STRIP, X), strip((0.25, 0, 0.5), 0.5 * X, STRIP)], 0.1180339887),
    "wedge 60": ([PIECE, strip((0, 0, 0), STRIP, (0.5, 0, sin(pi / 3)))], 1.0 - sin(pi / 6)),
    "wedge 100": ([PIECE, strip((0, 0, 0), STRIP, (cos(radians(100)), 0, sin(radians(100))))], 1.0 - sin(radians(50))),
}
"""Name -> (polygons, factor from the first to the second)."""

TETRAHEDRON = [
    [(1, 1, 1), (1, -1, -1), (-1, 1, -1)],
    [(1, 1, 1), (-1, -1, 1), (1, -1, -1)],
    [(1, 1, 1), (-1, 1, -1), (-1, -1, 1)],
    [(-1, -1, 1), (-1, 1, -1), (1, -1, -1)],
]


CUBE, SIDES = scene(*box())
FIELDS = ("outside", "outside_error", "behind", "behind_error", "sky", "sky_error", "ground", "ground_error", "areas")


def alike(one, other):
    """Whether two results have equal bits, but for what was skipped."""
    for a, b in ((one.matrix, other.matrix), (one.standard_error, other.standard_error)):
        for name in ("data", "indices", "indptr"):
            assert np.array_equal(getattr(a, name), getattr(b, name))
    for name in FIELDS:
        assert np.array_equal(getattr(one, name), getattr(other, name)), name
    return True
