"""The calls of the package over Dask, lazily, and into Zarr stores that resume.

`from warpsample import cluster`, then `cluster.ambient_occlusion(mesh, points, 256)`: as in `warpsample`, and the same bits.
"""

from importlib import import_module

TYPE_CHECKING = False
if TYPE_CHECKING:
    from warpsample.cluster.baking import bake
    from warpsample.cluster.calls import (
        ambient_occlusion,
        bent_normals,
        integrate,
        irradiance,
        sample_directions,
        sky_view_factor,
        trace,
    )

__all__ = [
    "ambient_occlusion",
    "bake",
    "bent_normals",
    "integrate",
    "irradiance",
    "sample_directions",
    "sky_view_factor",
    "trace",
]


def __getattr__(name: str) -> object:
    """Imports a call, and with it Dask, when it is first used.

    Raises:
        ModuleNotFoundError: Dask or xarray is missing; names the extra.
    """
    if name not in __all__:
        raise AttributeError(f"module 'warpsample.cluster' has no attribute {name!r}")
    try:
        value = getattr(import_module(f"warpsample.cluster.{'baking' if name == 'bake' else 'calls'}"), name)
    except ModuleNotFoundError as error:
        raise ModuleNotFoundError(f"warpsample.cluster needs {error.name}: pip install 'warpsample[cluster]'") from error
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    """The calls, imported or not."""
    return sorted({*globals(), *__all__})
