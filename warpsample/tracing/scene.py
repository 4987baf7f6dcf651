"""Meshes in normalised coordinates with their search trees, cached as long as the mesh exists."""

import warnings
from copy import copy
from dataclasses import replace
from functools import partial
from typing import Any
from weakref import WeakKeyDictionary

import numpy as np
import warp as wp

from warpsample.host.arrays import as_real
from warpsample.host.engine import check_workers
from warpsample.host.locks import make, making, read_only
from warpsample.mesh.mesh import Mesh, as_mesh
from warpsample.tracing.queries import AcceleratorArgs, GlassArgs
from warpsample.tracing.wide.boxes import WideTree, fill
from warpsample.tracing.wide.build import Topology, build, build_some

ALL, OPAQUE, GLASS = "all", "opaque", "glass"
"""Sets of faces for a tree: all faces; opaque faces (transmittance 0); translucent faces (transmittance between 0 and 1)."""

_NOTHING, _PART = 0, 1
"""Classes of faces in `_classify_faces`: opaque (transmittance 0), and translucent (between 0 and 1)."""

SMALLEST = 1e-30
"""Smallest half size of a mesh, in the user's units, for which float32 distances keep their digits."""

_LEAST_EXTENT = 2.0**-16  # above 0, so that points of a plane normal to an axis are moved off the plane, too
_FAR = 16.0  # if the mesh is this much larger than the box of four fifths of its vertices, that box is the centre
_BLOCK = 1 << 18  # vertices per block in `_scaled_vertices`
_LOOKED_AT = 4096  # number of sampled vertices or faces that represent the spread of a mesh
_COARSE = 2.0**-16  # relative to the scene: shorter edges are lost in the offset of points off their face


class Scene:
    """Mesh prepared for ray tracing: normalised float32 vertices, each coordinate from -1 to 1, and search trees.

    Attributes:
        centre: (3,) float64, centre of the mesh's box; if a few faces are distant, centre of the box of most vertices.
        scale: power of two, so that scaling the user's mesh by a power of two changes no digit.
        extent: (3,), distance that the mesh reaches from 0 on each axis, at least 2^-16.
        spread: (3,), the same distance without distant parts.
        vertices: (V, 3) float32, (vertices - centre) * scale; 0 for unused vertices.
        faces: (F, 3) int32.
        transmittance: (F,) float32, transmittance of each face; None if all faces are opaque.
        has_glass: whether some face is translucent, with a transmittance between 0 and 1.

    Raises:
        ValueError: the mesh is so small that float32 distances lose their digits.

    Warns:
        UserWarning: most faces are too small for their distance from the centre.
    """

    def __init__(self, mesh: Mesh) -> None:
        """Move and scale the vertices of a mesh; no search tree is built yet."""
        lower, upper = mesh.bounds
        middle = _main_part(mesh.vertices if mesh.used.all() else mesh.vertices[mesh.used])
        half = 0.5 * upper - 0.5 * lower
        apart = half.max() > _FAR * (0.5 * middle[1] - 0.5 * middle[0]).max() > 0.0
        near = middle if apart else mesh.bounds
        self.centre: Any = 0.5 * near[0] + 0.5 * near[1]
        reach = np.maximum(upper - self.centre, self.centre - lower)
        if 0.0 < reach.max() < SMALLEST:
            raise ValueError(
                f"mesh: got a mesh of half size {reach.max():.3g}, want at least {SMALLEST:g}; scale the mesh up"
            )
        self.scale: float = 2.0 ** -int(np.frexp(reach.max())[1])
        self.extent: Any = np.maximum(reach * self.scale, _LEAST_EXTENT)
        spread = (near[1] - self.centre) * self.scale
        self.spread: Any = np.maximum(spread, _LEAST_EXTENT) if apart else self.extent
        self.vertices: np.ndarray = read_only(self._scaled_vertices(mesh))
        self.faces: np.ndarray = mesh.faces
        self._set_transmittance(mesh)
        self._topologies: dict[str, Topology] = {}
        self._trees: dict[str, WideTree] = {}
        self._builtin: dict[str, wp.Mesh] = {}
        self._warn_if_coarse(float(self.spread.max()))

    def _scaled_vertices(self, mesh: Mesh) -> np.ndarray:
        """Return the vertices of the mesh, moved and scaled to coordinates from -1 to 1, (V, 3) float32.

        They are computed by blocks, since intermediate values are float64.
        """
        placed = np.empty(mesh.vertices.shape, np.float32)
        for start in range(0, len(placed), _BLOCK):
            rows = slice(start, start + _BLOCK)
            own = np.where(mesh.used[rows, None], mesh.vertices[rows], self.centre)
            placed[rows] = (own - self.centre) * self.scale
        return placed

    def _warn_if_coarse(self, spread: float) -> None:
        """Warn if the faces are too small, compared with the extent of the mesh, to be resolved by float32 rays."""
        some = self.vertices[self.faces[:: -(-len(self.faces) // _LOOKED_AT)]].astype(np.float64)
        edges = np.linalg.norm(some - np.roll(some, 1, axis=1), axis=2).max(axis=1)
        if 0.0 < np.median(edges) < _COARSE * spread:
            size, reach = float(np.median(edges)) / self.scale, spread / self.scale
            warnings.warn(
                f"mesh: got faces of size {size:.3g} (median) within {reach:.3g} of their centre, where points are moved "
                f"off their faces by about {reach * 2.0**-19:.2g}; trace parts that are far apart as separate meshes",
                stacklevel=2,
            )

    def tree(self, workers: int, which: str = ALL) -> WideTree:
        """Return the 16-wide search tree over a set of faces (ALL, OPAQUE or GLASS).

        The first call builds the tree, in any thread.
        """
        if which not in self._trees:
            with making:
                if which not in self._trees:
                    topology = self._topologies.get(which) or self._topology(workers, which)
                    tree = fill(topology, self.vertices, self.faces, workers)
                    self._topologies[which], self._trees[which] = topology, tree
        return self._trees[which]

    def blockers(self, workers: int) -> WideTree:
        """Return the search tree over the opaque faces, which block rays."""
        return self.tree(workers, ALL if self.transmittance is None else OPAQUE)

    def _topology(self, workers: int, which: str) -> Topology:
        """Build the structure of the search tree (nodes and leaves, without boxes) over a set of faces."""
        if which == ALL or self.transmittance is None:
            return build(self.vertices, self.faces, workers)
        chosen = np.flatnonzero(_classify_faces(self.transmittance) == (_NOTHING if which == OPAQUE else _PART))
        return build_some(self.vertices, self.faces, chosen, workers)

    def glass(self, workers: int) -> Any:
        """Return the kernel argument for rays through translucent faces: the faces' search tree and transmittances.

        It is valid while this object lives.
        """
        tree = self.tree(workers, GLASS).accelerator()
        return GlassArgs(tree=tree, transmittance=self.transmittance.ctypes.data)

    def _set_transmittance(self, mesh: Mesh) -> None:
        """Set the transmittances of all faces from a mesh with the same faces."""
        self.transmittance: np.ndarray | None = mesh.transmittance if mesh.transmits else None
        self.has_glass: bool = mesh.transmits and bool((_classify_faces(mesh.transmittance) == _PART).any())

    def with_transmittance(self, mesh: Mesh) -> "Scene":
        """Return a copy prepared for a mesh of the same shape with other transmittances; unchanged trees are shared."""
        scene = copy(self)
        scene._set_transmittance(mesh)
        both = self.transmittance is not None and scene.transmittance is not None
        stays = both and np.array_equal(_classify_faces(self.transmittance), _classify_faces(scene.transmittance))
        scene._trees = {which: tree for which, tree in self._trees.items() if stays or which == ALL}
        scene._topologies = {which: tree.topology for which, tree in scene._trees.items()}
        return scene

    def with_vertices(self, mesh: Mesh) -> "Scene":
        """Return a copy prepared for a mesh with moved vertices and the same faces; the structure of the trees is shared."""
        scene = Scene(mesh)
        scene._topologies = dict(self._topologies)
        return scene

    def builtin(self, device: wp.Device) -> Any:
        """Return the wp.Mesh of this mesh on a device as a kernel argument; the first call builds it."""
        if device.alias not in self._builtin:
            make(partial(self._build_builtin, device))
        return AcceleratorArgs(mesh=self._builtin[device.alias].id, starts=1)

    def _build_builtin(self, device: wp.Device) -> None:
        """Build the wp.Mesh of this mesh on a device, unless it exists already."""
        if device.alias not in self._builtin:
            points = wp.array(self.vertices, dtype=wp.vec3, device=device)
            indices = wp.array(self.faces.ravel(), dtype=wp.int32, device=device)
            self._builtin[device.alias] = wp.Mesh(points, indices)


_scenes: WeakKeyDictionary[Mesh, Scene] = WeakKeyDictionary()


def _main_part(vertices: np.ndarray) -> np.ndarray:
    """Return the box from the 10th to the 90th percentile of a mesh's vertices on each axis, (2, 3).

    It is estimated from a sample of vertices.
    """
    return np.quantile(vertices[:: -(-len(vertices) // _LOOKED_AT)], [0.1, 0.9], axis=0)


def _classify_faces(transmittance: np.ndarray) -> np.ndarray:
    """Return the class of each face, (F,) int8: 0 opaque, 1 translucent, 2 fully transparent."""
    return (transmittance > 0.0).astype(np.int8) + (transmittance == 1.0)


def check_opaque(mesh: Mesh, what: str) -> None:
    """Raise ValueError if a mesh has transmittances above 0; the message names the call by `what`."""
    if mesh.transmits:
        raise ValueError(f"mesh: got a mesh with a transmittance above 0, which {what} does not support, want opaque faces")


def scene_of(mesh: Mesh, *, through: bool = False) -> Scene:
    """Return the `Scene` of a mesh, the mesh prepared for ray tracing; built once and shared by all threads.

    It is kept while the mesh lives.

    Args:
        mesh: any.
        through: whether the caller handles faces that transmit light; otherwise a mesh with such faces raises a ValueError.
    """
    if not through:
        check_opaque(mesh, "this call")
    scene = _scenes.get(mesh)
    if scene is None:
        with making:
            scene = _scenes.get(mesh)
            if scene is None:
                known = None if mesh.like is None else _scenes.get(mesh.like)
                scene = _scenes[mesh] = Scene(mesh) if known is None else known.with_transmittance(mesh)
    return scene


def coarseness_of(scene: Scene, double: bool) -> float:
    """Return twice the floating-point spacing (ULP) of the user's coordinates at the mesh, in normalised units."""
    largest = np.max(np.abs(scene.centre)) + np.max(scene.spread) / scene.scale
    return 2.0 * float(np.spacing((np.float64 if double else np.float32)(largest))) * scene.scale


def refit(mesh: Any, vertices: Any, *, workers: int | None = None) -> Mesh:
    """Return the mesh with moved vertices and refitted search trees, several times as fast as building new trees.

    Rays get the same answers as from a new tree, except for the choice among faces at the same distance. They are slower the
    further the vertices have moved, since the tree keeps its groups of triangles.

    Args:
        mesh: Mesh or anything that `as_mesh` accepts; its tree is used, or built.
        vertices: (V, 3), the same number of vertices.
        workers: Number of CPU threads, an integer. Default: None, the value of WARPSAMPLE_WORKERS or all cores.

    Returns:
        the mesh with moved vertices; the given mesh does not change.

    Raises:
        TypeError, ValueError: vertices that are not V finite points.

    Example:
        >>> mesh = ws.load_mesh("courtyard")
        >>> raised = ws.refit(mesh, mesh.vertices + np.array([0.0, 0.0, 2.0]))
        >>> print(mesh.bounds[0], raised.bounds[0])
        [0. 0. 0.] [0. 0. 2.]
    """
    mesh, workers = as_mesh(mesh), check_workers(workers)
    vertices = as_real(vertices, "vertices")
    if vertices.shape != mesh.vertices.shape:
        raise ValueError(f"vertices: got shape {vertices.shape}, want {mesh.vertices.shape} as in the mesh")
    moved = replace(mesh, vertices=vertices)
    before = scene_of(mesh, through=True)
    before.tree(workers)
    after = before.with_vertices(moved)
    after.tree(workers)
    with making:
        _scenes[moved] = after
    return moved
