"""Directions around surface normals, sampled by NVIDIA Warp kernels: exact densities, good sequences, many points."""

from warpsample import distributions, sequences
from warpsample.directions import Directions, Status, sample_directions, sample_square
from warpsample.distributions.beckmann import Beckmann
from warpsample.distributions.cosine_hemisphere import CosineHemisphere
from warpsample.distributions.ggx import GGX
from warpsample.distributions.offset_ball import OffsetBall
from warpsample.distributions.offset_circle import OffsetCircle
from warpsample.distributions.offset_disk import OffsetDisk
from warpsample.distributions.offset_sphere import OffsetSphere
from warpsample.distributions.power_cosine import PowerCosine
from warpsample.distributions.uniform_cone import UniformCone
from warpsample.distributions.uniform_disk import UniformDisk
from warpsample.distributions.uniform_hemisphere import UniformHemisphere
from warpsample.distributions.uniform_sphere import UniformSphere
from warpsample.distributions.visible_beckmann import VisibleBeckmann
from warpsample.distributions.visible_ggx import VisibleGGX
from warpsample.distributions.von_mises_fisher import VonMisesFisher
from warpsample.estimate.intervals import Interval
from warpsample.estimate.irradiance import irradiance
from warpsample.estimate.result import Estimate, PointStatus, Skipped
from warpsample.estimate.visibility import SkyView, ambient_occlusion, bent_normals, sky_view_factor
from warpsample.mesh import Mesh, MeshReport, as_mesh
from warpsample.mesh_files import load_mesh
from warpsample.surface import SurfacePoints, face_centers, sample_surface, vertex_points
from warpsample.tracing.scene import refit
from warpsample.tracing.trace import Hits, trace

__all__ = [
    "GGX",
    "Beckmann",
    "CosineHemisphere",
    "Directions",
    "Estimate",
    "Hits",
    "Interval",
    "Mesh",
    "MeshReport",
    "OffsetBall",
    "OffsetCircle",
    "OffsetDisk",
    "OffsetSphere",
    "PointStatus",
    "PowerCosine",
    "Skipped",
    "SkyView",
    "Status",
    "SurfacePoints",
    "UniformCone",
    "UniformDisk",
    "UniformHemisphere",
    "UniformSphere",
    "VisibleBeckmann",
    "VisibleGGX",
    "VonMisesFisher",
    "ambient_occlusion",
    "as_mesh",
    "bent_normals",
    "distributions",
    "face_centers",
    "irradiance",
    "load_mesh",
    "refit",
    "sample_directions",
    "sample_square",
    "sample_surface",
    "sequences",
    "sky_view_factor",
    "trace",
    "vertex_points",
]
