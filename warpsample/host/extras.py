"""The extras of the package: which modules each of them brings, and the error for a module that is missing."""

EXTRAS: dict[str, tuple[str, ...]] = {
    "viz": ("pyvista", "matplotlib", "pxr", "trame", "nest_asyncio2", "ipywidgets"),
    "radiation": ("pvlib", "pyradiance"),
    "cluster": ("dask", "distributed", "zarr", "xarray"),
    "city": ("rasterio", "rioxarray", "pyproj", "affine"),
    "texture": ("xatlas", "PIL", "OpenEXR"),
    "test": ("trimesh",),
}
"""The modules that each extra brings, as pyproject.toml has them; one that several bring stands once."""


def missing(what: str, module: str | None, extra: str = "") -> ModuleNotFoundError:
    """Return the error that names the pip line for a missing module.

    The line installs from a checkout, `.`: the package is not on an index.

    Args:
        what: a clause that names the library, as "weather needs pvlib".
        module: the module that was not found, perhaps within its package.
        extra: another one than brings the module, or several, where a call needs more of it.
    """
    top = str(module).partition(".")[0]
    found = extra or next((name for name, modules in EXTRAS.items() if top in modules), "")
    return ModuleNotFoundError(f"{what}: pip install " + (f"'.[{found}]'" if found else top), name=top)
