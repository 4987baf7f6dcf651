"""Directions at surface points of triangle meshes, with proven densities, and numbers with error bars from their rays."""

from importlib import import_module

_HOMES = {
    "city.cityjson.city": ("City",),
    "city.cityjson.loading": ("load_city",),
    "city.cityjson.surfaces": ("CitySurfaces",),
    "directions.sample": ("Directions", "Status", "sample_directions", "sample_square"),
    "estimate.integrate": ("integrate",),
    "estimate.intervals": ("Interval",),
    "estimate.quantities.mean_distance": ("MeanDistance", "mean_distance"),
    "estimate.quantities.thickness": ("Thickness", "thickness"),
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
    "texture.uv.unwrapping": ("unwrap",),
    "tracing.scene": ("refit",),
    "tracing.trace": ("Hits", "trace"),
    "tracing.trace_all": ("AllHits", "trace_all"),
    "tracing.tree": ("tree",),
}
_HOME = {name: home for home, names in _HOMES.items() for name in names}
_LOBES = (
    "Beckmann",
    "CosineHemisphere",
    "EnvironmentMap",
    "GGX",
    "HenyeyGreenstein",
    "LinearlyTransformedCosine",
    "Mixture",
    "OffsetBall",
    "OffsetCircle",
    "OffsetDisk",
    "OffsetSphere",
    "PowerCosine",
    "Reflection",
    "RoughDielectric",
    "SphericalRectangle",
    "SphericalTriangle",
    "UniformCone",
    "UniformDisk",
    "UniformHemisphere",
    "UniformSphere",
    "VisibleBeckmann",
    "VisibleGGX",
    "VonMisesFisher",
)
__all__ = ["distributions", "rasters", "sequences"]
__all__.extend((*_HOME, *_LOBES))


def __getattr__(name: str) -> object:
    """Import a name when it is first used: Warp takes a second, during which the command line must react to Ctrl-C."""
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
    """Return the public names, imported or not."""
    return sorted({*globals(), *__all__})
