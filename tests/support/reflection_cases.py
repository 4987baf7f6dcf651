"""Scenes of faces that reflect, and values of theirs that are known: shared/LIGHT.md, C."""

from math import pi

import glass_cases as cases
import numpy as np
import trimesh

import warpsample as ws
from warpsample.radiation.reflection.patches import patches_of

SKY = np.repeat([1.0, 0.0], 512)[:, None].repeat(4, axis=1)
"""A picture: 1 above, 0 below, but for a thousandth of a turn about the horizon, as pictures are read off bilinearly."""
EVERYWHERE = np.ones((4, 8))

CANYON = {  # H = W: rho of the floor and the walls -> E / pi in the middle of the floor and of a wall
    (0.3, 0.3): (0.50983, 0.36764),
    (0.5, 0.5): (0.57597, 0.45740),
    (0.8, 0.8): (0.75336, 0.68758),
    (0.2, 0.4): (0.53160, 0.37315),
}
THREE_SURFACES = {0.3: (0.48148, 0.38276), 0.5: (0.55228, 0.47140), 0.8: (0.74123, 0.69781)}
"""rho -> E / pi of the floor and of the walls, each taken to be even."""
TABLE = 1e-5  # its digits


def canyon(floor, walls):
    """A street as wide as its walls are high, 1, and 10^4 long."""
    return ws.as_mesh(cases.canyon(), transmittance=0.0, reflectance=np.repeat([floor, walls], [2, 4]))


def in_canyon(copies):
    """Points in the middle of the floor, then as many in the middle of a wall."""
    position = np.repeat([[0.0, 0.0, 0.0], [-0.5, 0.0, 0.5]], copies, axis=0)
    position[:, 1] = np.tile(np.linspace(-1.0, 1.0, copies), 2)
    return ws.SurfacePoints(position, np.repeat(np.float32([[0, 0, 1], [1, 0, 0]]), copies, axis=0))


def shell(rho, tau):
    """A sphere of glass that reflects: inside it is lit evenly, by pi tau."""
    ball = trimesh.creation.icosphere(subdivisions=1)
    return ws.as_mesh((ball.vertices, ball.faces), transmittance=tau, reflectance=rho)


def points_inside(copies):
    """Return points inside a unit sphere, with normals in random directions."""
    return ws.SurfacePoints(np.tile([[0.1, 0.2, 0.3]], (copies, 1)), np.random.default_rng(1).normal(size=(copies, 3)))


def pit(rho, times=0):
    """A cube of 1 that is open above, of ten triangles, each cut into four so many times; normals to the inside."""
    vertices, faces = cases.box([0.0, 0.0, 0.0], [1.0, 1.0, 1.0])
    open_ = (vertices[faces][:, :, 2] < 1.0).any(axis=1)
    made = trimesh.Trimesh(vertices, faces[open_][:, ::-1], process=False)
    for _ in range(times):
        made = made.subdivide()
    return ws.as_mesh((made.vertices, made.faces), reflectance=rho)


def spread_over(mesh, times, seed):
    """(points on the fronts of a mesh, the area of each): random ones on parts of its faces, all over it."""
    parts = patches_of(mesh, np.sqrt(2.0) / times)
    points = parts.places(2, seed).take(np.repeat(~parts.back, 2))
    return points, (mesh.face_areas / np.square(parts.cuts))[points.face] / 2.0


def balance(rho, count, seed, times=12, **options):
    """What a pit swallows and sends out by what comes in, E (1 - rho + rho SVF) over pi times its opening."""
    mesh = pit(rho)
    points, area = spread_over(mesh, times, seed)
    found = ws.irradiance(mesh, points, SKY, count, seed=seed, **options)
    sky = ws.sky_view_factor(mesh, points, count, seed=seed + 1)
    return (area * found.value.astype(float) * (1.0 - rho + rho * sky.value)).sum() / pi


def mean_of(found, rows, of="value"):
    """(mean of E / pi, its standard error): all points share the light of patches, so it is that of one point at most."""
    name = {"value": "standard_error", "reflected": "reflected_error"}[of]
    return getattr(found, of)[rows].mean(dtype=float) / pi, getattr(found, name)[rows].mean(dtype=float) / pi
