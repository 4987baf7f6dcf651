"""How much sky, sun and light each place of a 3D model gets: rays of proven samplers, NVIDIA Warp's kernels, error bars."""

from importlib import import_module

TYPE_CHECKING = False  # importing it from `typing` takes as long as all else here
if TYPE_CHECKING:
    from warpsample import distributions, sequences
    from warpsample.city import rasters
    from warpsample.city.cityjson.city import City, load_city
    from warpsample.city.cityjson.surfaces import CitySurfaces
    from warpsample.directions.sample import Directions, Status, sample_directions, sample_square
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
    from warpsample.estimate.integrate import integrate
    from warpsample.estimate.intervals import Interval
    from warpsample.estimate.quantities.mean_distance import MeanDistance, mean_distance
    from warpsample.estimate.quantities.visible_sky import visible_sky
    from warpsample.estimate.result import Estimate, PointStatus, Skipped
    from warpsample.estimate.visibility import SkyView, ambient_occlusion, bent_normals, sky_view_factor
    from warpsample.mesh.files import load_mesh
    from warpsample.mesh.files.uv import load_uv
    from warpsample.mesh.mesh import Mesh, as_mesh
    from warpsample.mesh.points.grid_points import grid_points
    from warpsample.mesh.points.sampling import sample_surface
    from warpsample.mesh.report import MeshReport
    from warpsample.mesh.surface import SurfacePoints, face_centers, vertex_points
    from warpsample.output.frame import to_frame
    from warpsample.radiation.exchange.net_radiation import NetRadiation
    from warpsample.radiation.exchange.result import ViewFactors
    from warpsample.radiation.exchange.view_factors import view_factors
    from warpsample.radiation.quantities.sun_hours import SunHours, sun_hours
    from warpsample.radiation.sky.irradiance import Irradiance, irradiance
    from warpsample.radiation.sky.patches import SkyPatches, sky_patches
    from warpsample.radiation.sky.result import SkyMatrix, SkySkipped
    from warpsample.radiation.sky.sky_matrix import sky_matrix
    from warpsample.radiation.sun.direct_sun import direct_sun
    from warpsample.radiation.weather.irradiation import Irradiation, irradiation
    from warpsample.texture.report import TextureReport
    from warpsample.texture.texture_points import TexturePoints, texture_points
    from warpsample.texture.unwrapping import unwrap
    from warpsample.tracing.scene import refit
    from warpsample.tracing.trace import Hits, trace
    from warpsample.tracing.trace_all import AllHits, trace_all
    from warpsample.tracing.tree import tree

__all__ = [
    "GGX",
    "AllHits",
    "Beckmann",
    "City",
    "CitySurfaces",
    "CosineHemisphere",
    "Directions",
    "Estimate",
    "Hits",
    "Interval",
    "Irradiance",
    "Irradiation",
    "MeanDistance",
    "Mesh",
    "MeshReport",
    "NetRadiation",
    "OffsetBall",
    "OffsetCircle",
    "OffsetDisk",
    "OffsetSphere",
    "PointStatus",
    "PowerCosine",
    "Skipped",
    "SkyMatrix",
    "SkyPatches",
    "SkySkipped",
    "SkyView",
    "Status",
    "SunHours",
    "SurfacePoints",
    "TexturePoints",
    "TextureReport",
    "UniformCone",
    "UniformDisk",
    "UniformHemisphere",
    "UniformSphere",
    "ViewFactors",
    "VisibleBeckmann",
    "VisibleGGX",
    "VonMisesFisher",
    "ambient_occlusion",
    "as_mesh",
    "bent_normals",
    "direct_sun",
    "distributions",
    "face_centers",
    "grid_points",
    "integrate",
    "irradiance",
    "irradiation",
    "load_city",
    "load_mesh",
    "load_uv",
    "mean_distance",
    "rasters",
    "refit",
    "sample_directions",
    "sample_square",
    "sample_surface",
    "sequences",
    "sky_matrix",
    "sky_patches",
    "sky_view_factor",
    "sun_hours",
    "texture_points",
    "to_frame",
    "trace",
    "trace_all",
    "tree",
    "unwrap",
    "vertex_points",
    "view_factors",
    "visible_sky",
]

# Distributions are not listed: they are found by their records.
_HOMES = {
    "city.cityjson.city": ("City", "load_city"),
    "city.cityjson.surfaces": ("CitySurfaces",),
    "directions.sample": ("Directions", "Status", "sample_directions", "sample_square"),
    "estimate.integrate": ("integrate",),
    "estimate.intervals": ("Interval",),
    "estimate.quantities.mean_distance": ("MeanDistance", "mean_distance"),
    "estimate.quantities.visible_sky": ("visible_sky",),
    "estimate.result": ("Estimate", "PointStatus", "Skipped"),
    "estimate.visibility": ("SkyView", "ambient_occlusion", "bent_normals", "sky_view_factor"),
    "mesh.mesh": ("Mesh", "as_mesh"),
    "mesh.files": ("load_mesh",),
    "mesh.points.grid_points": ("grid_points",),
    "mesh.files.uv": ("load_uv",),
    "mesh.report": ("MeshReport",),
    "mesh.points.sampling": ("sample_surface",),
    "mesh.surface": ("SurfacePoints", "face_centers", "vertex_points"),
    "output.frame": ("to_frame",),
    "radiation.quantities.sun_hours": ("SunHours", "sun_hours"),
    "radiation.sun.direct_sun": ("direct_sun",),
    "radiation.weather.irradiation": ("Irradiation", "irradiation"),
    "radiation.sky.irradiance": ("Irradiance", "irradiance"),
    "radiation.sky.patches": ("SkyPatches", "sky_patches"),
    "radiation.sky.sky_matrix": ("sky_matrix",),
    "radiation.sky.result": ("SkyMatrix", "SkySkipped"),
    "radiation.exchange.net_radiation": ("NetRadiation",),
    "radiation.exchange.result": ("ViewFactors",),
    "radiation.exchange.view_factors": ("view_factors",),
    "texture.report": ("TextureReport",),
    "texture.texture_points": ("TexturePoints", "texture_points"),
    "texture.unwrapping": ("unwrap",),
    "tracing.scene": ("refit",),
    "tracing.trace": ("Hits", "trace"),
    "tracing.trace_all": ("AllHits", "trace_all"),
    "tracing.tree": ("tree",),
}
_HOME = {name: home for home, names in _HOMES.items() for name in names}


def __getattr__(name: str) -> object:
    """Imports a name when it is first used: Warp takes a second, in which the command line must react to Ctrl-C."""
    if name not in __all__ and name != "__version__":
        raise AttributeError(f"module 'warpsample' has no attribute {name!r}")
    from warpsample.host.interrupts import uninterrupted
    from warpsample.host.locks import imported

    if name in ("distributions", "sequences"):  # also by the package's own imports, which may not wait for another thread's
        return uninterrupted(lambda: import_module(f"warpsample.{name}"))
    if name == "rasters":
        return imported("warpsample.city.rasters")
    if name == "__version__":
        from importlib.metadata import version

        value: object = version("warpsample")
    elif name in _HOME:
        value = getattr(imported(f"warpsample.{_HOME[name]}"), name)
    else:
        value = imported("warpsample.distributions").classes()[name]
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    """The public names, imported or not."""
    return sorted({*globals(), *__all__})
