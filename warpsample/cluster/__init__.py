"""The calls of the package over Dask, lazily, and into Zarr stores that resume.

`from warpsample import cluster`, then `cluster.ambient_occlusion(mesh, points, 256)`: as in `warpsample`, and the same bits.
Each quantity that has `in_stores` in its record has its call here.
"""

from typing import Any

from warpsample.host.extras import missing
from warpsample.host.locks import imported

__all__ = ["bake", "integrate", "sample_directions", "trace"]


def __getattr__(name: str) -> Any:
    """Imports a call, and with it Dask, when it is first used.

    Raises:
        AttributeError: there is no such call.
        ModuleNotFoundError: Dask or xarray is missing; names the extra.
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
    """The calls, imported or not."""
    quantities = imported("warpsample.output.quantities").quantities().values()
    return sorted({*globals(), *__all__, *(quantity.call.__name__ for quantity in quantities if quantity.in_stores)})
