"""Accessor `mesh.warpsample` of pyvista.PolyData; PyVista finds this file by the entry point `pyvista.accessors`."""

from collections.abc import Callable
from typing import Any, Literal, get_args

import numpy as np
import pyvista as pv

from warpsample.directions.sample import sample_directions
from warpsample.distributions import as_spatial
from warpsample.distributions.cosine_hemisphere import CosineHemisphere
from warpsample.distributions.record import Distribution
from warpsample.estimate.quantities.record import Quantity
from warpsample.estimate.result import Estimate
from warpsample.host.arguments import check_choice, check_integer, check_scale, quote
from warpsample.mesh.mesh import Mesh, as_mesh
from warpsample.mesh.points.arrays import arrays_of, carry_to_points
from warpsample.mesh.points.sampling import sample_surface
from warpsample.mesh.surface import SurfacePoints, vertex_points
from warpsample.output.export import CLOUD_SCALE
from warpsample.output.places import PLACES
from warpsample.output.quantities import quantities

At = Literal["vertices", "faces"]


@pv.register_dataset_accessor("warpsample", pv.PolyData)
class WarpsampleAccessor:
    """Accessor of a pyvista.PolyData that samples directions and computes ambient occlusion and other quantities.

    The dataset itself does not change. Polygons are split into triangles.

    The accessor has a method for each quantity with `in_stores` in its record.
    """

    def __init__(self, dataset: pv.PolyData):
        self._dataset, self._mesh, self._time = dataset, None, -1

    @property
    def mesh(self) -> Mesh:
        """Dataset as a warpsample.Mesh of triangles, cached with its search tree until the dataset changes."""
        if self._mesh is None or self._dataset.GetMTime() != self._time:
            self._mesh, self._time = as_mesh(self._dataset), self._dataset.GetMTime()
        return self._mesh

    def sample_directions(
        self,
        count: int,
        *,
        distribution: Distribution | str = CosineHemisphere(),
        points: int | None = None,
        scale: float | None = None,
        seed: int = 0,
        **options: Any,
    ) -> pv.PolyData:
        """Sample `count` directions about each normal, and return the directions' end points as a point cloud.

        Args:
            count: Number of directions per point.
            distribution: Distribution of the directions, or its name. "ggx(alpha=@roughness)" takes the parameter of each
                point from the point array "roughness". Default: CosineHemisphere(method="polar").
            points: Number of points, uniform by area. Default: None, the dataset's points with area-weighted normals.
            scale: Length of a direction in the cloud, in the dataset's unit. Default: None, 5 % of its diagonal.
            seed: Random seed of points and directions. Default: 0.
            **options: `sequence`, `pdf`, `active`, `workers` and `progress`, as for `warpsample.sample_directions`.

        Returns:
            points at position + scale * direction, with "Normals" (the direction), "point" (the row) and with `pdf` "pdf".

        Raises:
            TypeError, ValueError: an argument is invalid; the message names the argument.

        Example:
            >>> surface = ws.load_mesh("courtyard").to_polydata()
            >>> cloud = surface.warpsample.sample_directions(16, points=10, pdf=True)
            >>> print(cloud.n_points, sorted(cloud.point_data))
            160 ['Normals', 'pdf', 'point']
        """
        length = CLOUD_SCALE * self.mesh.diagonal if scale is None else check_scale(scale)
        if points is None:
            at = vertex_points(self.mesh)
        else:
            at = sample_surface(self.mesh, check_integer(points, "points", 1, 2**31 - 1), seed=seed)
        lobe = as_spatial(distribution, lambda name: self._array_at(name, at))
        return sample_directions(at, count, distribution=lobe, seed=seed, **options).to_polydata(at, length)

    def _array_at(self, name: str, points: SurfacePoints) -> np.ndarray:
        """Return the dataset's array with the given name, interpolated to points on the surface."""
        arrays = arrays_of(self._dataset)
        if name not in arrays:
            raise ValueError(
                f"distribution: got the array name @{name}, want an array of the dataset: {quote(', '.join(sorted(arrays)))}"
            )
        return carry_to_points(arrays[name].array, name, self.mesh, points, arrays[name].at)

    def _points(self, at: At) -> SurfacePoints:
        """Return the vertices or the face centres of the mesh as surface points."""
        return PLACES[check_choice(at, "at", get_args(At))](self.mesh)

    def _copy_with(self, name: str, at: At, found: Estimate) -> pv.PolyData:
        """Return a copy of the dataset with the arrays of an estimate; for numbers at faces, polygons become triangles."""
        numbers = found.to_polydata(self.mesh, at)
        copy = self._dataset.copy() if at == "vertices" or self._dataset.is_all_triangles else self._dataset.triangulate()
        source, target = (d.cell_data if at == "faces" else d.point_data for d in (numbers, copy))
        for key in source:
            target[name if key == "value" else key] = source[key]
        return copy


_DOCUMENTATION = """Compute the {title} at the vertices or the faces, and return a copy of the dataset with the numbers.

        Args:
            count: number of rays per point.
            at: "vertices" for point data, "faces" for cell data at the faces of `mesh`.
            **options: further arguments of `warpsample.{name}`.

        Returns:
            copy of the dataset with "{name}" ({value}), "standard_error", "rays", "status" and the other fields of the
            function's result as point or cell data.

        Raises:
            TypeError, ValueError: an argument is invalid; the message names the argument.

        Example:
            >>> made = ws.load_mesh("courtyard").to_polydata().warpsample.{name}(64, at="faces"{example})
            >>> print(made.n_cells, len(made.cell_data["{name}"]))
            2080 2080
        """


def _build_method(quantity: Quantity) -> Callable[..., pv.PolyData]:
    """Build the method of the accessor that computes one quantity."""
    name = quantity.call.__name__

    def method(self: WarpsampleAccessor, count: int = 256, *, at: At = "vertices", **options: Any) -> pv.PolyData:
        return self._copy_with(name, at, quantity.call(self.mesh, self._points(at), count=count, **options))

    words = {"title": quantity.title, "value": quantity.value, "name": name}
    example = f", {quantity.example}" if quantity.example else ""
    method.__name__, method.__qualname__ = name, f"{WarpsampleAccessor.__qualname__}.{name}"
    method.__doc__ = _DOCUMENTATION.format(**words, example=example)
    return method


for _quantity in quantities().values():
    if _quantity.in_stores:
        setattr(WarpsampleAccessor, _quantity.call.__name__, _build_method(_quantity))
