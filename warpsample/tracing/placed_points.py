"""Surface points prepared for ray tracing: faces, normals, and the exact positions where rays start."""

from math import inf
from typing import Any

import numpy as np

from warpsample.host.device_memory import Loan
from warpsample.host.neighbours import describe_type
from warpsample.host.vectors import as_directions
from warpsample.mesh.mesh import Mesh, as_mesh
from warpsample.mesh.surface import SurfacePoints
from warpsample.tracing.options import RayOptions
from warpsample.tracing.order import visiting_order
from warpsample.tracing.placement import PlacementArgs, make_placement
from warpsample.tracing.scene import Scene, scene_of
from warpsample.tracing.starts import faces_and_normals, set_starts
from warpsample.tracing.tracers import Tracer
from warpsample.tracing.triples import Triples


class PlacedPoints:
    """Surface points with all that is needed to cast rays: faces, normals, and positions where rays start.

    The object keeps alive the arrays that its kernel arguments point to.

    Attributes:
        points: points of the caller.
        id: (P,) ids of the points, or None.
        mesh: mesh to trace against; None if no ray is traced.
        face: (P,) int32, face of each point, -1 if unknown; None without a mesh.
        scene: scene of the mesh, or None.
        position: positions of the caller.
        normal: (P, 3) float32, normals of the caller, of any length.
        side: (P, 3) float32, unit or zero: the normals of the points' faces, else the points' own; None without a mesh.
    """

    points: SurfacePoints
    id: np.ndarray | None
    mesh: Mesh | None
    face: np.ndarray | None
    side: np.ndarray | None

    def __init__(self, points: SurfacePoints, mesh: Mesh | None, argument: str = "points") -> None:
        """Find the faces and normals of surface points; ray starts are computed on first use.

        Raises:
            ValueError: a face number that the mesh does not have; the message names the argument.
        """
        self.points, self.id, self.mesh = points, points.id, mesh
        self.scene: Scene | None = scene_of(mesh, through=True) if mesh else None
        self.position: Triples = Triples.of(points.position, f"{argument}.position")
        self.normal: np.ndarray = as_directions(Triples.of(points.normal, f"{argument}.normal").owner)
        self.face, self.side = faces_and_normals(mesh, points, argument) if mesh else (None, None)
        self._placements: dict[tuple[Tracer, bool], PlacementArgs] = {}
        self._starts: dict[int, np.ndarray] = {}  # by address

    @classmethod
    def of(cls, mesh: Any, points: Any) -> "PlacedPoints":
        """Check a mesh and surface points that a caller passes, and prepare the points for rays.

        Args:
            mesh: Mesh, or any argument of `as_mesh`.
            points: SurfacePoints.

        Raises:
            TypeError, ValueError: an argument of a wrong type or value; the message names it.
        """
        if not isinstance(points, SurfacePoints):
            raise TypeError(f"points: got {describe_type(points)}, want SurfacePoints, such as the result of sample_surface")
        return cls(points, as_mesh(mesh))

    def __len__(self) -> int:
        """Return the number of surface points."""
        return len(self.points)

    def facing(self, options: RayOptions, reach: float = inf) -> Any:
        """Return the kernel argument for rays that start at surface points, on the side to which the normals point.

        At least one point is required. `reach` is the largest distance of a hit, in the user's units.
        """
        return self._placement(options, reach, self.normal)

    def two_sided(self, options: RayOptions, reach: float) -> Any:
        """Return the kernel argument for rays that start at surface points, on either side of the points' faces.

        The rays of `trace` start this way. At least one point is required. `reach` is the largest distance of a hit, in the
        user's units.
        """
        return self._placement(options, reach, None)

    def lend(self, placement: Any, loan: Loan, rows: slice) -> None:
        """Change a kernel argument from `facing` or `two_sided` to describe some rows of the points on a device.

        `rows` is a slice of `Memory.parts`. In place, the addresses stay those of the whole arrays.
        """
        placement.points = rows.stop - rows.start
        placement.origins = loan.lend(self.position.owner, rows)
        placement.normals = loan.lend(self.side, rows)
        placement.starts = loan.lend(self._starts[placement.starts], rows)

    def order(self, placement: Any, count: int, workers: int) -> np.ndarray | None:
        """Return the fastest order of processing the points, (P,) int64; None for the order of the rows."""
        return visiting_order(self.scene, placement, count, workers)

    def _placement(self, options: RayOptions, reach: float, towards: np.ndarray | None) -> PlacementArgs:
        """Return the kernel argument that describes the start and the length of the points' rays.

        Starts of rays are computed once per tracer and set of sides.
        """
        key = options.tracer, towards is None
        if key not in self._placements:
            placement = make_placement(self.scene, self.position, inf)
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
            self._starts[placement.starts] = starts
            self._placements[key] = placement
        placement = PlacementArgs.from_buffer_copy(self._placements[key])
        placement.reach = reach * self.scene.scale
        return placement
