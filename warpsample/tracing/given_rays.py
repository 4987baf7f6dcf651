"""Checks of the origins and directions that a caller passes to `trace`."""

from dataclasses import dataclass
from math import prod
from typing import Any

import warp as wp

from warpsample.host.neighbours import address_of, describe_type
from warpsample.mesh.mesh import Mesh
from warpsample.mesh.surface import SurfacePoints
from warpsample.tracing.options import RayOptions
from warpsample.tracing.placed_points import PlacedPoints
from warpsample.tracing.placement import MOST_DISTANCE, PlacementArgs, make_placement
from warpsample.tracing.rays import RaysArgs
from warpsample.tracing.scene import scene_of
from warpsample.tracing.triples import Triples


@dataclass(frozen=True, eq=False)
class GivenRays:
    """Checked origins and directions of rays, with the mesh to trace against.

    The object keeps alive the arrays that kernels read.

    Attributes:
        mesh: mesh to trace against.
        points: surface points that the rays leave; None for free origins.
        origins: origins; of shape (3,) where all rays share one.
        directions: directions.
    """

    mesh: Mesh
    points: PlacedPoints | None
    origins: Triples
    directions: Triples

    @classmethod
    def of(cls, mesh: Mesh, origins: Any, directions: Any) -> "GivenRays":
        """Check a mesh and the origins and directions of rays that a caller passes, and return a `GivenRays`.

        Raises:
            TypeError, ValueError: an argument of a wrong type or shape; the message names it.
        """
        points = PlacedPoints(origins, mesh, "origins") if isinstance(origins, SurfacePoints) else None
        checked = Triples.of(origins, "origins", "(P, 3) or (3,)") if points is None else points.position
        way = Triples.of(directions, "directions", "(P, 3) or (P, n, 3)")
        _check_pair(checked, way)
        return cls(mesh, points, checked, way)

    @property
    def count(self) -> int:
        """Number of rays."""
        return prod(self.directions.shape)

    def place(self, options: RayOptions, reach: float, hits: Any = None) -> RaysArgs:
        """Return the kernel argument that describes the rays, their largest distance and the arrays for their hits.

        There must be at least one ray. `hits` is that of `rays_of`. `reach` is the largest distance of a hit, in the user's
        units.
        """
        reach = min(reach, MOST_DISTANCE)
        scene = scene_of(self.mesh, through=True)
        placement = (
            make_placement(scene, self.origins, reach) if self.points is None else self.points.two_sided(options, reach)
        )
        return rays_of(placement, self.directions, hits)


def rays_of(placement: PlacementArgs, directions: Triples, hits: Any = None) -> RaysArgs:
    """Return the kernel argument that describes rays from the origins in `placement` along `directions`.

    It has the addresses of `hits.distance` and `hits.face` if `hits` is not None. The result holds addresses: the caller
    must keep the arrays.
    """
    return RaysArgs(
        placement=placement,
        count=prod(directions.shape) // placement.points,
        double_directions=directions.double,
        directions=address_of(directions.owner),
        distance=0 if hits is None else address_of(hits.distance),
        face=0 if hits is None else address_of(hits.face),
    )


def _check_pair(start: Triples, way: Triples) -> None:
    """Raise ValueError if ray origins and directions differ in shape, in device, or in the kind of array."""
    if way.shape[: len(start.shape)] != start.shape or len(way.shape) - len(start.shape) > 1:
        rows = "".join(f"{size}, " for size in start.shape)
        raise ValueError(f"directions: got shape {(*way.shape, 3)}, want ({rows}3) or ({rows}n, 3) to match the origins")
    if start.device != way.device or isinstance(start.owner, wp.array) != isinstance(way.owner, wp.array):
        raise ValueError(
            f"directions: got {describe_type(way.owner)} on {way.device}, "
            f"want {describe_type(start.owner)} on {start.device}, like the origins"
        )
