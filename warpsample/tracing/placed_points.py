"""Points on a surface, placed in the scene of a mesh: once for all that a call casts from them."""

from math import inf
from typing import Any

import numpy as np

from warpsample.host.neighbours import kind_told
from warpsample.host.vectors import as_directions
from warpsample.mesh.mesh import Mesh, as_mesh
from warpsample.mesh.surface import SurfacePoints
from warpsample.tracing.options import RayOptions
from warpsample.tracing.order import order_of
from warpsample.tracing.placement import PlacementArgs, placed
from warpsample.tracing.scene import Scene, scene_of
from warpsample.tracing.starts import faces_and_normals, set_starts
from warpsample.tracing.tracers import Tracer
from warpsample.tracing.triples import Triples


class PlacedPoints:
    """Points and the scene that their rays are traced in. It keeps the arrays whose addresses its placements hold.

    Attributes:
        points: as they are given.
        id: of the points, or None.
        mesh: what they see; None where no ray is traced.
        scene: of the mesh, or None.
        position: of the points, as they are given.
        normal: (P, 3) float32, the points' own, of any length.
        side: (P, 3) float32, unit or zero, the normals of the faces that points lie on, else their own; None without a mesh.
    """

    points: SurfacePoints
    id: np.ndarray | None
    mesh: Mesh | None
    face: np.ndarray | None
    side: np.ndarray | None

    def __init__(self, points: SurfacePoints, mesh: Mesh | None, argument: str = "points") -> None:
        """Finds faces and normals; where rays start is found when a placement is asked for.

        Raises:
            ValueError: a face that the mesh has not; names the argument.
        """
        self.points, self.id, self.mesh = points, points.id, mesh
        self.scene: Scene | None = scene_of(mesh, through=True) if mesh else None
        self.position: Triples = Triples.of(points.position, f"{argument}.position")
        self.normal: np.ndarray = as_directions(Triples.of(points.normal, f"{argument}.normal").owner)
        self.face, self.side = faces_and_normals(mesh, points, argument) if mesh else (None, None)
        self._known: dict[tuple[Tracer, bool], tuple[PlacementArgs, np.ndarray | None]] = {}

    @classmethod
    def of(cls, mesh: Any, points: Any) -> "PlacedPoints":
        """The points of a call, SurfacePoints on a mesh or whatever `as_mesh` takes.

        Raises:
            TypeError, ValueError: one that cannot be used; names it, what it got and what it wants.
        """
        if not isinstance(points, SurfacePoints):
            raise TypeError(f"points: got {kind_told(points)}, want SurfacePoints, as sample_surface gives them")
        return cls(points, as_mesh(mesh))

    def __len__(self) -> int:
        """How many points."""
        return len(self.points)

    def facing(self, options: RayOptions, reach: float = inf) -> Any:
        """The placement for rays as far as `reach`, in the user's units, on the side of each normal; at least one point."""
        return self._placement(options, reach, self.normal)

    def two_sided(self, options: RayOptions, reach: float) -> Any:
        """The placement for rays that leave on either side of each point's face, as those of `trace`; at least one point."""
        return self._placement(options, reach, None)

    def order(self, placement: Any, count: int, workers: int) -> np.ndarray | None:
        """(P,) int64, the order in which points with so many rays each are best visited; None if that is their own."""
        return order_of(self.scene, placement, count, workers)

    def _placement(self, options: RayOptions, reach: float, towards: np.ndarray | None) -> PlacementArgs:
        key = options.tracer, towards is None
        if key not in self._known:
            placement = placed(self.scene, self.position, inf)
            placement.normals = self.side.ctypes.data
            placement.ids = 0 if self.id is None else self.id.ctypes.data
            starts = set_starts(
                self.scene,
                placement,
                self.face,
                towards=towards,
                raised=self.points.raised,
                tracer=options.tracer,
                workers=options.workers,
            )
            self._known[key] = placement, starts
        placement = PlacementArgs.from_buffer_copy(self._known[key][0])
        placement.reach = reach * self.scene.scale
        return placement
