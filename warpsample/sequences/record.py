"""What a sequence says of itself."""

from dataclasses import dataclass

import numpy as np
import warp as wp


@dataclass(frozen=True)
class Sequence:
    """Points of the unit square as a pure function of who asks.

    Attributes:
        name: what users call it by.
        sample: `wp.func` (seed: uint64, point: uint64, sample: uint32, count: uint32) -> vec2 on the 2^-24 grid of [0, 1):
            the sample-th of count points at the surface point with that global id. Averages over the count points are
            unbiased, and those of different surface points or seeds independent; how the points of one share the square
            is what tells the sequences apart.
        pair: where one evaluation makes two points: `wp.func` (seed, point, half: uint32, count) -> vec4, those of samples
            2 half and 2 half + 1.
        rate: the RMSE of n samples of a step, such as visibility is, falls about as n to the power of -rate.
        edge: where an edge passes through a square, two sets of n samples differ in how many are on one side of it: with a
            variance of about half of n to the power of `edge`, from 4 samples to 64. 1: as independent samples do.
        progressive: the first m of n points are those of any other n; else count must be known.
        random: the points of one surface point are independent of each other, too.
        cells_off: by how many cells of 2^-24 the integer twin may differ, where a quotient of float64s is rounded.
        colour: of its curves, as "#rrggbb".
        marker: of its points in matplotlib.
        summary: one line for tables.
        source: where it comes from.
    """

    name: str
    sample: wp.Function
    progressive: bool
    colour: str
    marker: str
    summary: str
    source: str
    pair: wp.Function | None = None
    rate: float = 0.75
    edge: float = 0.25
    random: bool = False
    cells_off: int = 0

    def edge_variance(self, count: int) -> float:
        """That of the difference between two sets of `count` samples, in samples squared."""
        return 0.5 * float(np.float_power(count, self.edge))
