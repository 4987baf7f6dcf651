"""Points on a mesh, uniform by area, by other tools and by this one."""

# ruff: noqa: PLC0415

from itertools import count as count_from
from typing import Any

from warpsample.bench.peers.tool import Built, Peer, keeping_last
from warpsample.mesh.mesh import as_mesh
from warpsample.mesh.surface import sample_surface


def _here(mesh: Any, points: int, workers: int) -> Built:
    ours, seeds = as_mesh(mesh), count_from()
    work, result = keeping_last(lambda: sample_surface(ours, points, seed=next(seeds), workers=workers))
    return work, lambda: result().position


def _trimesh(mesh: Any, points: int, workers: int) -> Built:
    import trimesh

    return keeping_last(lambda: trimesh.sample.sample_surface(mesh, points)[0])


def _open3d(mesh: Any, points: int, workers: int) -> Built:
    import open3d

    theirs = open3d.geometry.TriangleMesh(
        open3d.utility.Vector3dVector(mesh.vertices), open3d.utility.Vector3iVector(mesh.faces)
    )
    work, result = keeping_last(lambda: theirs.sample_points_uniformly(points))
    return work, lambda: result().points


SURFACE = {
    "warpsample surface": Peer("warpsample", _here),
    "trimesh surface": Peer("trimesh", _trimesh, threaded=False),
    "Open3D surface": Peer("open3d", _open3d, threaded=False),
}
"""By name; each builds of (a trimesh mesh, points, threads)."""
