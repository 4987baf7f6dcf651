"""Meshes that several tests share, and rays at them."""

import numpy as np
import trimesh

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


def planes(count, size=1.0):
    """Squares of two triangles across z, so many from -1 to 1, each with vertices of its own."""
    corners = size * np.array([[-1.0, -1.0, 0.0], [1.0, -1.0, 0.0], [1.0, 1.0, 0.0], [-1.0, 1.0, 0.0]])
    heights = np.linspace(-1.0, 1.0, count)
    vertices = (corners + heights[:, None, None] * [0.0, 0.0, 1.0]).reshape(-1, 3)
    faces = (4 * np.arange(count)[:, None, None] + np.array([[0, 1, 2], [0, 2, 3]])).reshape(-1, 3)
    return ws.as_mesh((vertices, faces))


def centred(mesh):
    return ws.Mesh(mesh.vertices - mesh.bounds.mean(axis=0), mesh.faces)


def loose(mesh):
    """A mesh of the triangles of another, none of which shares a vertex with the next."""
    return ws.Mesh(mesh.vertices[mesh.faces].reshape(-1, 3), np.arange(3 * len(mesh.faces)).reshape(-1, 3))


def aimed(mesh, count, seed=3):
    """Rays of which a tenth go at vertices and a tenth at points of edges, as exactly as float32 allows."""
    rng = np.random.default_rng(seed)
    origins, directions = random_rays(count, seed)
    rounded = 0.25 * np.round(4.0 * origins) + 0.125  # so that none is at a vertex, at distance 0 but for rounding
    origins = np.where(rng.random((count, 1)) < 0.5, 2.0 * origins, rounded).astype(np.float32)
    edges = mesh.vertices[mesh.faces[rng.integers(len(mesh.faces), size=count)]]
    share = np.where(rng.random((count, 1)) < 0.5, 0.5, rng.random((count, 1)))
    at = np.where(np.arange(count)[:, None] % 10 == 0, edges[:, 0], edges[:, 0] + share * (edges[:, 1] - edges[:, 0]))
    return origins, np.where(np.arange(count)[:, None] % 10 < 2, at - origins, directions).astype(np.float32)


def icosphere():
    made = trimesh.creation.icosphere(2)
    return centred(ws.Mesh(made.vertices, made.faces))


def quads(rows, columns):
    """Faces of a grid of vertices, row by row."""
    start = (columns * np.arange(rows - 1)[:, None] + np.arange(columns - 1)).reshape(-1, 1)
    return np.concatenate([np.add(start, [0, 1, columns]), np.add(start, [1, columns + 1, columns])])
