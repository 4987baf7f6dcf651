"""Scenes for Mitsuba's CPU variant, with points on a mesh."""

from typing import Any, NamedTuple

import numpy as np

from warpsample.bench.tools.numpy_rays import lift_off_surface
from warpsample.mesh.mesh import Mesh
from warpsample.mesh.surface import SurfacePoints


class MitsubaScene(NamedTuple):
    """Mesh and points on the mesh, as Mitsuba objects.

    Attributes:
        dr: module drjit.
        mi: module mitsuba.
        scene: Mitsuba scene.
        origins: ray origins at the points.
        normals: normals at the points.
    """

    dr: Any
    mi: Any
    scene: Any
    origins: Any
    normals: Any

    def sample_cosine_ray(self, rng: Any, origin: Any, normal: Any) -> Any:
        """Sample an independent cosine-weighted ray from each point."""
        u = self.mi.Point2f(rng.next_float32(), rng.next_float32())
        return self.mi.Ray3f(origin, self.mi.Frame3f(normal).to_world(self.mi.warp.square_to_cosine_hemisphere(u)))

    def build_random(self, size: int, seed: int) -> Any:
        """Build Mitsuba's random generator with `size` independent streams."""
        return self.mi.PCG32(size, initstate=self.dr.opaque(self.mi.UInt64, seed))


def build_mitsuba_scene(mesh: Mesh, points: SurfacePoints, workers: int) -> MitsubaScene:
    """Build the Mitsuba scene of a mesh and points on the mesh, for `workers` threads."""
    import drjit as dr
    import mitsuba as mi

    mi.set_variant("llvm_ad_rgb")
    dr.set_thread_count(workers)
    shape = build_mitsuba_shape(mi, mesh, mesh.faces)
    origins = mi.Point3f(lift_off_surface(mesh, points.position, points.normal).T)
    normals = mi.Normal3f(np.ascontiguousarray(points.normal.T))
    return MitsubaScene(dr, mi, mi.load_dict({"type": "scene", "mesh": shape}), origins, normals)


def build_mitsuba_shape(mi: Any, mesh: Mesh, faces: np.ndarray, surface: dict[str, Any] | None = None) -> Any:
    """Build a Mitsuba shape from faces (F, 3) of a mesh, with an optional surface material."""
    properties = mi.Properties()
    if surface is not None:
        properties["surface"] = mi.load_dict(surface)
    mesh_shape = mi.Mesh("mesh", len(mesh.vertices), len(faces), props=properties)
    parameters = mi.traverse(mesh_shape)
    parameters["vertex_positions"] = mesh.vertices.astype(np.float32).ravel()
    parameters["faces"] = faces.astype(np.uint32).ravel()
    parameters.update()
    return mesh_shape
