"""Public names for type checkers and editors; `__init__.py` imports each at its first use."""

from warpsample import distributions as distributions, sequences as sequences
from warpsample.city import rasters as rasters
from warpsample.city.cityjson.city import City as City
from warpsample.city.cityjson.loading import load_city as load_city
from warpsample.city.cityjson.surfaces import CitySurfaces as CitySurfaces
from warpsample.directions.sample import (
    Directions as Directions,
    Status as Status,
    sample_directions as sample_directions,
    sample_square as sample_square,
)
from warpsample.distributions.microfacets.beckmann import Beckmann as Beckmann
from warpsample.distributions.cosine_hemisphere import CosineHemisphere as CosineHemisphere
from warpsample.distributions.microfacets.ggx import GGX as GGX
from warpsample.distributions.mixture import Mixture as Mixture
from warpsample.distributions.offset_ball import OffsetBall as OffsetBall
from warpsample.distributions.offset_circle import OffsetCircle as OffsetCircle
from warpsample.distributions.offset_disk import OffsetDisk as OffsetDisk
from warpsample.distributions.offset_sphere import OffsetSphere as OffsetSphere
from warpsample.distributions.power_cosine import PowerCosine as PowerCosine
from warpsample.distributions.lights.environment_map import EnvironmentMap as EnvironmentMap
from warpsample.distributions.lights.spherical_rectangle import SphericalRectangle as SphericalRectangle
from warpsample.distributions.lights.spherical_triangle import SphericalTriangle as SphericalTriangle
from warpsample.distributions.scattering.henyey_greenstein import HenyeyGreenstein as HenyeyGreenstein
from warpsample.distributions.scattering.linearly_transformed_cosine import (
    LinearlyTransformedCosine as LinearlyTransformedCosine,
)
from warpsample.distributions.scattering.reflection import Reflection as Reflection
from warpsample.distributions.scattering.rough_dielectric import RoughDielectric as RoughDielectric
from warpsample.distributions.uniform_cone import UniformCone as UniformCone
from warpsample.distributions.uniform_disk import UniformDisk as UniformDisk
from warpsample.distributions.uniform_hemisphere import UniformHemisphere as UniformHemisphere
from warpsample.distributions.uniform_sphere import UniformSphere as UniformSphere
from warpsample.distributions.microfacets.visible_beckmann import VisibleBeckmann as VisibleBeckmann
from warpsample.distributions.microfacets.visible_ggx import VisibleGGX as VisibleGGX
from warpsample.distributions.von_mises_fisher import VonMisesFisher as VonMisesFisher
from warpsample.estimate.integrate import integrate as integrate
from warpsample.estimate.intervals import Interval as Interval
from warpsample.estimate.quantities.mean_distance import MeanDistance as MeanDistance, mean_distance as mean_distance
from warpsample.estimate.quantities.thickness import Thickness as Thickness, thickness as thickness
from warpsample.estimate.quantities.visible_sky import visible_sky as visible_sky
from warpsample.estimate.result import Estimate as Estimate, PointStatus as PointStatus, Skipped as Skipped
from warpsample.estimate.visibility import (
    SkyView as SkyView,
    ambient_occlusion as ambient_occlusion,
    bent_normals as bent_normals,
    sky_view_factor as sky_view_factor,
)
from warpsample.mesh.files import load_mesh as load_mesh
from warpsample.mesh.files.uv import load_uv as load_uv
from warpsample.mesh.mesh import Mesh as Mesh, as_mesh as as_mesh
from warpsample.mesh.points.grid_points import grid_points as grid_points
from warpsample.mesh.points.sampling import sample_surface as sample_surface
from warpsample.mesh.report import MeshReport as MeshReport
from warpsample.mesh.surface import (
    SurfacePoints as SurfacePoints,
    face_centers as face_centers,
    vertex_points as vertex_points,
)
from warpsample.output.frame import to_frame as to_frame
from warpsample.radiation.exchange.net_radiation import NetRadiation as NetRadiation
from warpsample.radiation.exchange.result import ViewFactors as ViewFactors
from warpsample.radiation.exchange.view_factors import view_factors as view_factors
from warpsample.radiation.quantities.sun_hours import SunHours as SunHours, sun_hours as sun_hours
from warpsample.radiation.sky.irradiance import Irradiance as Irradiance, irradiance as irradiance
from warpsample.radiation.sky.patches import SkyPatches as SkyPatches, sky_patches as sky_patches
from warpsample.radiation.sky.result import SkyMatrix as SkyMatrix, SkySkipped as SkySkipped
from warpsample.radiation.sky.sky_matrix import sky_matrix as sky_matrix
from warpsample.radiation.sun.direct_sun import direct_sun as direct_sun
from warpsample.radiation.weather.irradiation import Irradiation as Irradiation, irradiation as irradiation
from warpsample.texture.report import TextureReport as TextureReport
from warpsample.texture.texture_points import TexturePoints as TexturePoints, texture_points as texture_points
from warpsample.texture.uv.unwrapping import unwrap as unwrap
from warpsample.tracing.scene import refit as refit
from warpsample.tracing.trace import Hits as Hits, trace as trace
from warpsample.tracing.trace_all import AllHits as AllHits, trace_all as trace_all
from warpsample.tracing.tree import tree as tree

__version__: str
