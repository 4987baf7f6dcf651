"""Types of the calls in this module; `calls.call_of` creates the calls of quantities."""

from typing import Any

from typing_extensions import Unpack
from xarray import Dataset

from warpsample.cluster.baking import bake as bake
from warpsample.cluster.calls import (
    ChunkKeywords,
    LazyKeywords,
    integrate as integrate,
    sample_directions as sample_directions,
    trace as trace,
)
from warpsample.radiation.sky.picture_light import Sampling

def ambient_occlusion(
    mesh: Any, points: Any, count: int = 256, *, falloff: float | None = None, **options: Unpack[LazyKeywords]
) -> Dataset:
    """Compute `warpsample.ambient_occlusion` lazily over Dask."""

def bent_normals(mesh: Any, points: Any, count: int = 256, **options: Unpack[LazyKeywords]) -> Dataset:
    """Compute `warpsample.bent_normals` lazily over Dask."""

def irradiance(
    mesh: Any,
    points: Any,
    radiance: Any,
    count: int = 256,
    *,
    up: Any = (0, 0, 1),
    refine: Any = None,
    sampling: Sampling | None = None,
    **options: Unpack[ChunkKeywords],
) -> Dataset:
    """Compute `warpsample.irradiance` lazily over Dask."""

def mean_distance(mesh: Any, points: Any, count: int = 256, **options: Unpack[LazyKeywords]) -> Dataset:
    """Compute `warpsample.mean_distance` lazily over Dask."""

def sky_view_factor(
    mesh: Any, points: Any, count: int = 256, *, up: Any = (0, 0, 1), **options: Unpack[LazyKeywords]
) -> Dataset:
    """Compute `warpsample.sky_view_factor` lazily over Dask."""

def visible_sky(
    mesh: Any, points: Any, count: int = 256, *, up: Any = (0, 0, 1), **options: Unpack[LazyKeywords]
) -> Dataset:
    """Compute `warpsample.visible_sky` lazily over Dask."""
