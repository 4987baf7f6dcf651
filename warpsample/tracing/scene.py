"""A mesh in the coordinates of its tracers, with their search structures, kept while the mesh lives."""

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
"""Which faces are in a tree: all; those that stop all light; those that let some, but not all, through."""

_NOTHING, _PART = 0, 1
"""Of the light that falls on a face, what it lets through, among the numbers of `_kinds`."""

SMALLEST = 1e-30
"""Half size of a mesh that is traced: distances, which are float32, keep their digits."""

_LEAST_EXTENT = 2.0**-16  # points of a plane across an axis are moved off it all the same
_FAR = 16.0  # times as far as four fifths of the vertices: a part of its own, that the coordinates are not centred about
_BLOCK = 1 << 18  # vertices that are placed together
_LOOKED_AT = 4096  # vertices or faces that tell how a mesh is spread out
_COARSE = 2.0**-16  # of the scene: edges no longer than that are lost in the offset of a point off its face


class Scene:
    """A mesh moved to about the origin and scaled to within 1 of it, in float64 and then rounded to float32.

    Attributes:
        centre: (3,) float64, of the mesh's box; where a few faces are far from all others, of the others' box.
        scale: a power of two, so that scaling a mesh by one changes no digit.
        extent: (3,), how far the mesh reaches from 0 on each axis, or a little more where that is next to nothing.
        spread: (3,), the same without such far parts.
        vertices: (V, 3) float32, (vertices - centre) * scale; 0 where no face uses one.
        faces: (F, 3) int32.
        transmittance: (F,) float32 of the faces; None where all are opaque.
        has_glass: whether some face lets a part of the light through, and not all.

    Raises:
        ValueError: the mesh is so small that float32 distances lose their digits.

    Warns:
        UserWarning: most of the faces are too small for their distance from the centre.
    """

    def __init__(self, mesh: Mesh) -> None:
        """Moves and scales the vertices; builds no tree yet."""
        lower, upper = mesh.bounds
        middle = _main_part(mesh.vertices if mesh.used.all() else mesh.vertices[mesh.used])
        half = 0.5 * upper - 0.5 * lower
        apart = half.max() > _FAR * (0.5 * middle[1] - 0.5 * middle[0]).max() > 0.0
        near = middle if apart else mesh.bounds
        self.centre: Any = 0.5 * near[0] + 0.5 * near[1]
        reach = np.maximum(upper - self.centre, self.centre - lower)
        if 0.0 < reach.max() < SMALLEST:
            raise ValueError(f"mesh: got one of half size {reach.max():.3g}, want at least {SMALLEST:g}; scale it up")
        self.scale: float = 2.0 ** -int(np.frexp(reach.max())[1])
        self.extent: Any = np.maximum(reach * self.scale, _LEAST_EXTENT)
        spread = (near[1] - self.centre) * self.scale
        self.spread: Any = np.maximum(spread, _LEAST_EXTENT) if apart else self.extent
        self.vertices: np.ndarray = read_only(self._placed(mesh))
        self.faces: np.ndarray = mesh.faces
        self._take_light(mesh)
        self._topologies: dict[str, Topology] = {}
        self._trees: dict[str, WideTree] = {}
        self._builtin: dict[str, wp.Mesh] = {}
        self._warn_if_coarse(float(self.spread.max()))

    def _placed(self, mesh: Mesh) -> np.ndarray:
        """The vertices in float32, by blocks: what is between is float64."""
        placed = np.empty(mesh.vertices.shape, np.float32)
        for start in range(0, len(placed), _BLOCK):
            rows = slice(start, start + _BLOCK)
            own = np.where(mesh.used[rows, None], mesh.vertices[rows], self.centre)
            placed[rows] = (own - self.centre) * self.scale
        return placed

    def _warn_if_coarse(self, spread: float) -> None:
        some = self.vertices[self.faces[:: -(-len(self.faces) // _LOOKED_AT)]].astype(np.float64)
        edges = np.linalg.norm(some - np.roll(some, 1, axis=1), axis=2).max(axis=1)
        if 0.0 < np.median(edges) < _COARSE * spread:
            size, reach = float(np.median(edges)) / self.scale, spread / self.scale
            warnings.warn(
                f"mesh: got faces of size {size:.3g} (median) within {reach:.3g} of their centre, where points are moved "
                f"off their faces by about {reach * 2.0**-19:.2g}; trace parts that are far apart as meshes of their own",
                stacklevel=2,
            )

    def tree(self, workers: int, which: str = ALL) -> WideTree:
        """The 16-wide tree of all faces or of some, built at the first call, by whichever thread makes it."""
        if which not in self._trees:
            with making:
                if which not in self._trees:
                    topology = self._topologies.get(which) or self._topology(workers, which)
                    tree = fill(topology, self.vertices, self.faces, workers)
                    self._topologies[which], self._trees[which] = topology, tree
        return self._trees[which]

    def blockers(self, workers: int) -> WideTree:
        """The tree of the faces that stop all light."""
        return self.tree(workers, ALL if self.transmittance is None else OPAQUE)

    def _topology(self, workers: int, which: str) -> Topology:
        if which == ALL or self.transmittance is None:
            return build(self.vertices, self.faces, workers)
        chosen = np.flatnonzero(_kinds(self.transmittance) == (_NOTHING if which == OPAQUE else _PART))
        return build_some(self.vertices, self.faces, chosen, workers)

    def glass(self, workers: int) -> Any:
        """The faces of a mesh that transmits which let some light through, as rays ask them; valid while this lives."""
        tree = self.tree(workers, GLASS).accelerator()
        return GlassArgs(tree=tree, transmittance=self.transmittance.ctypes.data)

    def _take_light(self, mesh: Mesh) -> None:
        self.transmittance: np.ndarray | None = mesh.transmittance if mesh.transmits else None
        self.has_glass: bool = mesh.transmits and bool((_kinds(mesh.transmittance) == _PART).any())

    def dimmed(self, mesh: Mesh) -> "Scene":
        """The scene of a mesh of the same shape that lets other shares of light through; takes over the trees that stay."""
        scene = copy(self)
        scene._take_light(mesh)
        both = self.transmittance is not None and scene.transmittance is not None
        stays = both and np.array_equal(_kinds(self.transmittance), _kinds(scene.transmittance))
        scene._trees = {which: tree for which, tree in self._trees.items() if stays or which == ALL}
        scene._topologies = {which: tree.topology for which, tree in scene._trees.items()}
        return scene

    def moved(self, mesh: Mesh) -> "Scene":
        """The scene of a mesh with the same faces; takes over the trees' topologies, if there are any."""
        scene = Scene(mesh)
        scene._topologies = dict(self._topologies)
        return scene

    def builtin(self, device: wp.Device) -> Any:
        """The wp.Mesh on a device, built at the first call."""
        if device.alias not in self._builtin:
            make(partial(self._build_builtin, device))
        return AcceleratorArgs(mesh=self._builtin[device.alias].id, starts=1)

    def _build_builtin(self, device: wp.Device) -> None:
        if device.alias not in self._builtin:
            points = wp.array(self.vertices, dtype=wp.vec3, device=device)
            indices = wp.array(self.faces.ravel(), dtype=wp.int32, device=device)
            self._builtin[device.alias] = wp.Mesh(points, indices)


_scenes: WeakKeyDictionary[Mesh, Scene] = WeakKeyDictionary()


def _main_part(vertices: np.ndarray) -> np.ndarray:
    """(2, 3): the box of four fifths of the vertices, on each axis by itself; of a sample of them."""
    return np.quantile(vertices[:: -(-len(vertices) // _LOOKED_AT)], [0.1, 0.9], axis=0)


def _kinds(transmittance: np.ndarray) -> np.ndarray:
    """(F,) int8, what each face lets through: nothing, a part, or all."""
    return (transmittance > 0.0).astype(np.int8) + (transmittance == 1.0)


def check_opaque(mesh: Mesh, what: str) -> None:
    """Refuses a mesh that light goes through, by a ValueError, for what does not take one."""
    if mesh.transmits:
        raise ValueError(f"mesh: got one with a transmittance above 0, which {what} does not take; want opaque faces")


def scene_of(mesh: Mesh, *, through: bool = False) -> Scene:
    """The scene of a mesh; the same one while the mesh lives, whichever threads ask.

    Args:
        mesh: any.
        through: whether the caller takes care of faces that light goes through; else they are refused by a ValueError.
    """
    if not through:
        check_opaque(mesh, "this call")
    scene = _scenes.get(mesh)
    if scene is None:
        with making:
            scene = _scenes.get(mesh)
            if scene is None:
                known = None if mesh.like is None else _scenes.get(mesh.like)
                scene = _scenes[mesh] = Scene(mesh) if known is None else known.dimmed(mesh)
    return scene


def coarseness_of(scene: Scene, double: bool) -> float:
    """Two spacings of the user's numbers at the mesh, in the scene's coordinates."""
    largest = np.max(np.abs(scene.centre)) + np.max(scene.spread) / scene.scale
    return 2.0 * float(np.spacing((np.float64 if double else np.float32)(largest))) * scene.scale


def refit(mesh: Any, vertices: Any, *, workers: int | None = None) -> Mesh:
    """Return the mesh with moved vertices, several times as fast as a new tree takes.

    Rays get the same answers as from a new tree, except for the choice among faces at the same distance. They are slower the
    further the vertices have moved, since the tree keeps its groups of triangles.

    Args:
        mesh: Mesh or anything that `as_mesh` accepts; its tree is used, or built.
        vertices: (V, 3), the same number of vertices.
        workers: Number of CPU threads, an integer. Default: None, the value of WARPSAMPLE_WORKERS or all cores.

    Returns:
        the moved mesh; the one that was given stays as it is.

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
        raise ValueError(f"vertices: got shape {vertices.shape}, want {mesh.vertices.shape}, that of the mesh's own")
    moved = replace(mesh, vertices=vertices)
    before = scene_of(mesh, through=True)
    before.tree(workers)
    after = before.moved(moved)
    after.tree(workers)
    with making:
        _scenes[moved] = after
    return moved
