"""What the kernel needs of a sky besides its points, made once for each of the last few skies."""

from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from warpsample.radiation.sky.form_factors import table_of
from warpsample.radiation.sky.patches import SkyPatches
from warpsample.radiation.sky.shafts import groups_of, shafts_of


@dataclass(frozen=True, eq=False)
class PreparedSky:
    """Arrays of K patches in G groups.

    Attributes:
        table: (K, 20) float64, see `table_of`.
        frame: (3, 3) float64, that of the patches.
        begins: (G + 1,) int32, see `groups_of`.
        shafts: (K, 3, 16) float32, of the patches.
        group_shafts: (G, 3, 16) float32, of the groups.
    """

    table: np.ndarray
    frame: np.ndarray
    begins: np.ndarray
    shafts: np.ndarray
    group_shafts: np.ndarray


@lru_cache(maxsize=8)
def prepared(sky: SkyPatches) -> PreparedSky:
    """The arrays of a sky; `sky_patches` gives the same sky again for the same arguments."""
    begins = groups_of(sky)
    return PreparedSky(
        table=table_of(sky),
        frame=np.ascontiguousarray(sky.frame),
        begins=begins,
        shafts=shafts_of(sky, np.arange(len(sky) + 1)),
        group_shafts=shafts_of(sky, begins),
    )
