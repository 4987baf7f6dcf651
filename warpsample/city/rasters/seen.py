"""What the cells of a raster see."""

from dataclasses import dataclass

import numpy as np


@dataclass(frozen=True, eq=False)
class Seen:
    """What P points see, crowns in its way.

    Attributes:
        value: (P,) float32.
        standard_error: (P,) float32, at most so much.
        rays: (P,) int32, in all runs.
        status: (P,) uint8, a `PointStatus`.
    """

    value: np.ndarray
    standard_error: np.ndarray
    rays: np.ndarray
    status: np.ndarray
