"""Bilinear lookups of images as viewers make them, and small meshes with texture coordinates."""

import numpy as np

import warpsample as ws


def lookup(image, uv):
    """(N, C) of an image (H, W, C) at (N, 2) coordinates, v down, clamped to the edge."""
    height, width = image.shape[:2]
    place = uv * (width, height) - 0.5
    low = np.floor(place).astype(int)
    s, t = (place - low).T[..., None]
    (x0, y0), (x1, y1) = low.T, low.T + 1
    columns, rows = (np.clip(x, 0, width - 1) for x in (x0, x1)), (np.clip(y, 0, height - 1) for y in (y0, y1))
    (left, right), (upper, lower) = columns, rows
    above = image[upper, left] * (1 - s) + image[upper, right] * s
    return above * (1 - t) + (image[lower, left] * (1 - s) + image[lower, right] * s) * t


def coarser(image):
    """The next level of an image of even sides: means of two by two texels."""
    height, width, channels = image.shape
    return image.reshape(height // 2, 2, width // 2, 2, channels).mean(axis=(1, 3))


def on_surface(mesh, uv, count, seed=0):
    """Points uniform by area, and their texture coordinates."""
    points = ws.sample_surface(mesh, count, seed=seed, barycentric=True)
    return points, np.einsum("pk,pkc->pc", points.barycentric, uv[points.face])


def two_charts():
    """A bent strip as two slanted charts, one of them mirrored, that do not touch in the image."""
    vertices = np.array([(0, 0, 0), (2, 0, 0), (2, 1, 0), (0, 1, 0), (0, 2, 1), (2, 2, 1)], float)
    mesh = ws.Mesh(vertices, [[0, 1, 2], [0, 2, 3], [3, 2, 5], [3, 5, 4]])
    place = {0: (0.1, 0.42), 1: (0.85, 0.33), 2: (0.8, 0.06), 3: (0.08, 0.11)}
    other = {3: (0.9, 0.55), 2: (0.13, 0.6), 5: (0.2, 0.95), 4: (0.93, 0.87)}
    uv = np.array([[(place if i < 2 else other)[corner] for corner in face] for i, face in enumerate(mesh.faces.tolist())])
    return mesh, uv


def floor_by_a_wall(height, length, depth):
    """A floor, its image as wide as `depth`, and a long wall along its left edge; the wall has no coordinates."""
    floor = [(0, -length, 0), (depth, -length, 0), (depth, length, 0), (0, length, 0)]
    wall = [(0, -length, 0), (0, length, 0), (0, length, height), (0, -length, height)]
    faces = [[0, 1, 2], [0, 2, 3], [4, 5, 6], [4, 6, 7]]
    uv = np.full((4, 3, 2), np.nan)
    square = np.array([(0, 1), (1, 1), (1, 0), (0, 0)], float)
    uv[:2] = square[np.array(faces[:2])]
    return ws.Mesh(np.array(floor + wall, float), faces), uv


def prism(sides):
    """The sides of a regular prism, an image for all of them side by side, and the radial normals of its corners."""
    angle = 2 * np.pi * np.arange(sides + 1) / sides
    ring = np.stack([np.cos(angle), np.sin(angle)], axis=1)
    corners, uv, normals = [], [], []
    for k in range(sides):
        quad = [(*ring[k], -50.0), (*ring[k + 1], -50.0), (*ring[k + 1], 50.0), (*ring[k], 50.0)]
        place = [((k + x) / sides, y) for x, y in ((0, 1), (1, 1), (1, 0), (0, 0))]
        radial = [(*ring[k + x], 0.0) for x in (0, 1, 1, 0)]
        for triangle in ((0, 1, 2), (0, 2, 3)):
            corners += [quad[i] for i in triangle]
            uv.append([place[i] for i in triangle])
            normals.append([radial[i] for i in triangle])
    return ws.Mesh(np.array(corners), np.arange(len(corners)).reshape(-1, 3)), np.array(uv), np.array(normals)
