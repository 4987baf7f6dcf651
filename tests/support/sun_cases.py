"""Suns of a year, and what `trace` says of them."""

import numpy as np

import warpsample as ws


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
