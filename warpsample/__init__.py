"""Directions around surface normals, sampled by NVIDIA Warp kernels: exact densities, good sequences, many points."""

from warpsample import distributions, sequences
from warpsample.directions import Directions, Status, sample_directions, sample_square
from warpsample.distributions.cosine_hemisphere import CosineHemisphere
from warpsample.distributions.uniform_hemisphere import UniformHemisphere
from warpsample.distributions.uniform_sphere import UniformSphere
from warpsample.mesh import Mesh, MeshReport, as_mesh, load_mesh
from warpsample.surface import SurfacePoints, face_centers, sample_surface, vertex_points

__all__ = [
    "CosineHemisphere",
    "Directions",
    "Mesh",
    "MeshReport",
    "Status",
    "SurfacePoints",
    "UniformHemisphere",
    "UniformSphere",
    "as_mesh",
    "distributions",
    "face_centers",
    "load_mesh",
    "sample_directions",
    "sample_square",
    "sample_surface",
    "sequences",
    "vertex_points",
]
