"""Meshes that several tests share, and rays at them."""

import numpy as np

import warpsample as ws
from warpsample.proof.rays import closed_meshes

CLOSED = closed_meshes()
SPHERE, TORUS, BOX = (CLOSED[name][0] for name in ("sphere", "torus", "box"))


def soup(count=400, seed=2):
    """Random triangles with duplicates, slivers, coplanar, degenerate and tiny ones among them."""
    rng = np.random.default_rng(seed)
    corners = rng.uniform(-1, 1, (count, 1, 3)) + rng.normal(0, 0.2, (count, 3, 3))
    corners[:20] = corners[20:40]
    corners[40:60, :, 2] = 0.25
    corners[60:70, 2] = corners[60:70, 0] + 1e-5 * rng.normal(size=(10, 3))
    corners[70:75, 2] = corners[70:75, 1]
    corners[75:80] = corners[75:80, :1]
    corners[80:90] = corners[80:90, :1] + 1e-4 * rng.normal(size=(10, 3, 3))
    return ws.as_mesh((corners.reshape(-1, 3), np.arange(3 * count).reshape(-1, 3)))


def random_rays(count, seed=1):
    rng = np.random.default_rng(seed)
    return rng.uniform(-1, 1, (count, 3)), rng.normal(size=(count, 3))


def turned(seed):
    """A rotation, so that no wall is along an axis; none for 0."""
    q = np.linalg.qr(np.random.default_rng(seed).normal(size=(3, 3)))[0]
    return np.eye(3) if seed == 0 else q * np.sign(np.linalg.det(q))
