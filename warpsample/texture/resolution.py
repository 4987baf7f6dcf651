"""Texels that are too small for the float32 coordinates in which their rays are traced."""

import numpy as np

from warpsample.mesh.mesh import Mesh
from warpsample.texture.texture_points import TexturePoints
from warpsample.tracing.placement import OFFSET
from warpsample.tracing.scene import scene_of

_COARSE = 0.25  # of a texel: geometry that near counts as touching; 0.6 of one moved single texels beside a crate by 0.8

_FEW = 0.01  # of the points: a face that is all but flat in space has small texels anywhere


def describe_coarse_texels(points: TexturePoints, traced: Mesh) -> str | None:
    """Return a sentence on texels smaller than 4 times the resolution of their rays, or None without such texels.

    Rays are float32 relative to the centre of most of the mesh, so that a few faces at a great distance make all coarse.

    Args:
        points: the texels.
        traced: the mesh whose faces the rays meet.
    """
    scene = scene_of(traced, through=True)
    corners, mesh = points.corners, points.mesh
    faces = np.unique(points.face)
    reach = np.abs(mesh.vertices[mesh.faces[faces]] - scene.centre).max(axis=(1, 2))
    resolution = OFFSET * np.maximum(reach, scene.spread.max() / scene.scale)
    first, second = (corners[faces, corner] - corners[faces, 0] for corner in (1, 2))
    texels = 0.5 * np.abs(first[:, 0] * second[:, 1] - first[:, 1] * second[:, 0])
    size = np.sqrt(mesh.face_areas[faces] / np.maximum(texels, 1e-300))
    coarse = (resolution > _COARSE * size) & (size > 0.0)
    count = np.bincount(np.searchsorted(faces, points.face), minlength=len(faces)) * coarse
    if count.sum() <= _FEW * len(points):
        return None
    face = int(np.argmax(count))
    return (
        f"rays resolve lengths from {resolution[face]:.2g} on, and {count.sum():,} points have texels less than 4 times as "
        f"wide, such as {size[face]:.2g}: leave out faces at a great distance"
    )
