"""Arrays that describe the sky patches to kernels, cached for the last eight skies."""

from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from warpsample.radiation.sky.form_factors import table_of
from warpsample.radiation.sky.patches import SkyPatches
from warpsample.radiation.sky.shafts import groups_of, shafts_of


@dataclass(frozen=True, eq=False)
class PreparedSky:
    """Arrays that describe a sky of K patches in G groups to a kernel.

    Attributes:
        table: (K, 20) float64, see `table_of`.
        frame: (3, 3) float64, the patches' frame.
        begins: (G + 1,) int32, first patch of each group, see `groups_of`.
        shafts: (K, 3, 16) float32, shafts of the patches.
        group_shafts: (G, 3, 16) float32, shafts of the groups.
    """

    table: np.ndarray
    frame: np.ndarray
    begins: np.ndarray
    shafts: np.ndarray
    group_shafts: np.ndarray


@lru_cache(maxsize=8)
def prepare_sky(sky: SkyPatches) -> PreparedSky:
    """Return the arrays that describe a sky's patches to a kernel, from a cache where possible.

    The arrays are cached by the object `sky`; `sky_patches` returns the same object for equal arguments.
    """
    begins = groups_of(sky)
    return PreparedSky(
        table=table_of(sky),
        frame=np.ascontiguousarray(sky.frame),
        begins=begins,
        shafts=shafts_of(sky, np.arange(len(sky) + 1)),
        group_shafts=shafts_of(sky, begins),
    )
