"""What a process makes or imports once: to its end, and never half-made in a forked child; and what it lacks."""

import os
import threading
from collections.abc import Callable
from functools import cache
from importlib import import_module
from types import ModuleType
from typing import Any, TypeVar

from warpsample.host.interrupts import uninterrupted

T = TypeVar("T")

EXTRAS: dict[str, tuple[str, ...]] = {
    "viz": ("pyvista", "matplotlib", "pxr", "trame", "nest_asyncio2", "ipywidgets"),
    "radiation": ("pvlib", "pyradiance"),
    "cluster": ("dask", "distributed", "zarr", "xarray"),
    "city": ("rasterio", "rioxarray", "pyproj", "affine"),
    "texture": ("xatlas", "PIL", "OpenEXR"),
    "test": ("trimesh",),
}
"""The modules that each extra brings, as pyproject.toml has them; one that several bring stands once."""

making = threading.RLock()
"""Held while a kernel is built or loaded, a launch recorded, a tree or another cache made: Warp does not allow two threads
there. A fork waits for it, so that the child finds everything either complete or not begun."""

_importing = (
    threading.RLock()
)  # held while parts of this package are imported, which make things: always the first of the two


def _hold() -> None:
    _importing.acquire()
    making.acquire()


def _let_go() -> None:
    making.release()
    _importing.release()


import_module("logging")  # has a lock that a fork takes, too, and imports need: what is registered last is taken first
if hasattr(os, "register_at_fork"):
    os.register_at_fork(before=_hold, after_in_parent=_let_go, after_in_child=_let_go)


def make(work: Callable[[], T]) -> T:
    """Makes something while no other thread does, and to its end: Warp does not bear interrupts there, either."""
    return _alone(work, making)


@cache
def imported(name: str) -> ModuleType:
    """A module that is imported when it is first used, to its end: a torn import of NumPy or Warp cannot be repeated."""
    return _alone(lambda: import_module(name), _importing if name.startswith("warpsample.") else making)


def _alone(work: Callable[[], T], lock: Any) -> T:
    def alone() -> T:
        with lock:
            return work()

    return uninterrupted(alone)


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
