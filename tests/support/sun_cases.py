"""Suns of a year, what `trace` says of them, and meshes and points for them."""

import numpy as np
from meshes import CLOSED, soup

import warpsample as ws
from warpsample.bench import scenes
from warpsample.radiation.sun.direct_sun import SunCall
from warpsample.tracing.options import RayOptions
from warpsample.tracing.placed_points import PlacedPoints

GRAZING = 1e-6  # cosines whose sign float32 does not tell

MESHES = {
    "bunny": lambda: None,
    "city": lambda: scenes.city(12),
    "hostile": lambda: soup(300),
    "torus": lambda: CLOSED["torus"][0],
    "courtyard": lambda: ws.load_mesh("courtyard"),
}


def mesh_of(name, bunny):
    return bunny if name == "bunny" else MESHES[name]()


def call_of(mesh, points, suns, disc=0.0, skip=True):
    at = PlacedPoints.of(mesh, points)
    return SunCall(at, suns, None, RayOptions.of(len(at)).replace(skip=skip, tracer="wide", workers=1), disc)


def year(every=1, latitude=52.0):
    """(T, 3) float64 directions towards the suns above the horizon at mid-hour, z up, y north; of every n-th day."""
    day, hour = np.meshgrid(np.arange(0, 365, every), np.arange(24) + 0.5, indexing="ij")
    declination = -np.radians(23.44) * np.cos(2.0 * np.pi * (day + 10.0) / 365.0)
    turn, phi = np.radians(15.0 * (hour - 12.0)), np.radians(latitude)
    east = -np.cos(declination) * np.sin(turn)
    north = np.cos(phi) * np.sin(declination) - np.sin(phi) * np.cos(declination) * np.cos(turn)
    up = np.sin(phi) * np.sin(declination) + np.cos(phi) * np.cos(declination) * np.cos(turn)
    suns = np.stack([east, north, up], axis=-1)
    return suns[up > 0.0]


def mixed(rng, count=400):
    """Suns of all kinds in no order: near each other, equal, opposite, along axes, all over the sphere, of any length."""
    near = rng.normal(size=3) + 10.0 ** rng.uniform(-7.0, -1.0, (count, 1)) * rng.normal(size=(count, 3))
    suns = np.concatenate([near, rng.normal(size=(count, 3)), -near[:20], near[:30], np.eye(3), -np.eye(3)])
    return rng.permutation(suns) * 10.0 ** rng.uniform(-12.0, 12.0, (len(suns), 1))


def unit(vectors):
    """In float64, of any length; 0 where they are."""
    v = np.asarray(vectors, np.float64)
    largest = np.abs(v).max(axis=-1, keepdims=True)
    v = v / np.where(largest == 0.0, 1.0, largest)
    return v / np.where(largest == 0.0, 1.0, np.linalg.norm(v, axis=-1, keepdims=True))


def traced(mesh, points, suns):
    """(lit by `trace`, cosines) of all pairs, float64."""
    ways = np.ascontiguousarray(np.broadcast_to(suns, (len(points), *suns.shape)))
    cosine = unit(points.normal) @ unit(suns).T
    return (ws.trace(mesh, points, ways, any_hit=True).face < 0) & (cosine > 0.0), cosine


def plane_and(*others):
    """A square of 200 about 0, z up, and other (vertices, faces)."""
    parts = [(np.array([[-100, -100, 0], [100, -100, 0], [100, 100, 0], [-100, 100, 0.0]]), [[0, 1, 2], [0, 2, 3]]), *others]
    first = np.cumsum([0, *(len(v) for v, _ in parts)])
    return ws.as_mesh(
        (
            np.concatenate([v for v, _ in parts]),
            np.concatenate([np.array(f) + i for (_, f), i in zip(parts, first, strict=False)]),
        )
    )


def upright(low, high, x=0.0):
    """A rectangle at x, from low to high in (y, z)."""
    (a, b), (c, d) = low, high
    return np.array([[x, a, b], [x, c, b], [x, c, d], [x, a, d]], float), [[0, 1, 2], [0, 2, 3]]


def at(position, normal=(0.0, 0.0, 1.0)):
    position = np.atleast_2d(np.asarray(position, float))
    return ws.SurfacePoints(position, np.broadcast_to(np.asarray(normal, float), position.shape).copy())
