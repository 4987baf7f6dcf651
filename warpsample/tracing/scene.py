"""A mesh in the coordinates of its tracers, and the tracers' own data, kept while the mesh lives."""

from typing import Any
from weakref import WeakKeyDictionary

import numpy as np
import warp as wp

from warpsample.arrays import as_real
from warpsample.engine import check_workers
from warpsample.mesh import Mesh, as_mesh
from warpsample.tracing.boxes import Tree, fill
from warpsample.tracing.build import Topology, build
from warpsample.tracing.layout import AcceleratorJob

_LEAST_EXPONENT = -900
_LEAST_EXTENT = 2.0**-16  # points of a plane across an axis are moved off it all the same


class Scene:
    """A mesh moved to the origin and scaled to within 1 of it, in float64 and then rounded to float32.

    Attributes:
        centre: (3,) float64, of the mesh's box.
        scale: a power of two, so that scaling a mesh by one changes no digit.
        extent: (3,), how far the mesh reaches from 0 on each axis, or a little more where that is next to nothing.
        vertices: (V, 3) float32, (vertices - centre) * scale.
        faces: (F, 3) int32.
    """

    def __init__(self, mesh: Mesh) -> None:
        """Builds nothing yet."""
        lower, upper = mesh.vertices.min(axis=0), mesh.vertices.max(axis=0)
        self.centre = 0.5 * lower + 0.5 * upper
        exponent = int(np.frexp(np.max(upper - self.centre))[1])
        self.scale = 2.0 ** -max(exponent, _LEAST_EXPONENT)
        self.extent = np.maximum((upper - self.centre) * self.scale, _LEAST_EXTENT)
        self.vertices = ((mesh.vertices - self.centre) * self.scale).astype(np.float32)
        self.faces = mesh.faces
        self._topology: Topology | None = None
        self._tree: Tree | None = None
        self._builtin: dict[str, wp.Mesh] = {}

    def tree(self, workers: int) -> Tree:
        """The 16-wide tree, built at the first call."""
        if self._tree is None:
            self._topology = self._topology or build(self.vertices, self.faces, workers)
            self._tree = fill(self._topology, self.vertices, self.faces, workers)
        return self._tree

    def moved(self, mesh: Mesh) -> "Scene":
        """That of a mesh with the same faces: which triangles are near to each other is taken over, if known."""
        scene = Scene(mesh)
        scene._topology = self._topology
        return scene

    def builtin(self, device: wp.Device) -> AcceleratorJob:
        """The wp.Mesh on a device, built at the first call."""
        if device.alias not in self._builtin:
            points = wp.array(self.vertices, dtype=wp.vec3, device=device)
            indices = wp.array(self.faces.ravel(), dtype=wp.int32, device=device)
            self._builtin[device.alias] = wp.Mesh(points, indices)
        return AcceleratorJob(mesh=self._builtin[device.alias].id, starts=1)


_scenes: WeakKeyDictionary[Mesh, Scene] = WeakKeyDictionary()


def scene_of(mesh: Mesh) -> Scene:
    """The scene of a mesh; the same one while the mesh lives."""
    if mesh not in _scenes:
        _scenes[mesh] = Scene(mesh)
    return _scenes[mesh]


def refit(mesh: Any, vertices: Any, workers: int | None = None) -> Mesh:
    """The mesh with its vertices moved, ready to be traced: several times as fast as building its tree anew.

    Rays get the same answers as from a new tree, and get them more slowly the further the vertices have moved: a tree keeps
    those triangles together that were near to each other when it was built.

    Args:
        mesh: a Mesh or whatever `as_mesh` takes; a tree that it has is used, one that it has not is built.
        vertices: (V, 3), as many as before.
        workers: threads, all cores by default.

    Raises:
        TypeError, ValueError: vertices that are not V finite points.
    """
    mesh, workers = as_mesh(mesh), check_workers(workers)
    vertices = as_real(vertices, "vertices")
    if vertices.shape != mesh.vertices.shape:
        raise ValueError(f"vertices: got shape {vertices.shape}, want {mesh.vertices.shape}, that of the mesh's own")
    moved = Mesh(vertices, mesh.faces)
    before = scene_of(mesh)
    before.tree(workers)
    _scenes[moved] = before.moved(moved)
    _scenes[moved].tree(workers)
    return moved
