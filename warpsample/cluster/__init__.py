"""Calls of `warpsample` computed by Dask: lazily, or into Zarr stores that can be resumed.

`cluster.ambient_occlusion(mesh, points, 256)` takes the arguments of `warpsample.ambient_occlusion` and gives the same bits.
Every quantity whose record has `in_stores` has a call in this module.
"""

from typing import Any

from warpsample.host.extras import missing
from warpsample.host.locks import imported

__all__ = ["bake", "integrate", "sample_directions", "trace"]


def __getattr__(name: str) -> Any:
    """Import a call at its first use, and Dask with the call.

    Raises:
        AttributeError: if no call has the name.
        ModuleNotFoundError: if Dask or xarray is missing. The message names the extra to install.
    """
    if name.startswith("_"):
        raise AttributeError(f"module 'warpsample.cluster' has no attribute {name!r}")
    try:
        home = imported(f"warpsample.cluster.{'baking' if name == 'bake' else 'calls'}")
    except ModuleNotFoundError as error:
        raise missing(f"warpsample.cluster needs {error.name}", error.name, "cluster") from error
    globals()[name] = value = getattr(home, name) if name in __all__ else home.call_of(name)
    return value


def __dir__() -> list[str]:
    """Return the sorted names of the module, including calls that are not imported yet."""
    quantities = imported("warpsample.output.quantities").quantities().values()
    return sorted({*globals(), *__all__, *(quantity.call.__name__ for quantity in quantities if quantity.in_stores)})
