"""The record of a sequence."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
import warp as wp

from warpsample.sequences.hashing import mixed_key, run_key, run_words

STREAMS = 4
"""The number of the definition of all random streams: it grows when the same seed gives other numbers."""


@dataclass(frozen=True, eq=False)
class Sequence:
    """Points of the unit square, as a pure function of seed, surface point and sample.

    Attributes:
        name: the name that users give.
        sample: `wp.func` (key: vec4ui, sample: uint32, count: uint32) -> vec2 on the 2^-24 grid of [0, 1): the sample-th of
            count points under that key, most often that of the surface point with a global id. Averages over the count
            points are unbiased, and independent between keys; the sequences differ in how evenly the points under one key
            cover the square.
        run: `wp.func` (seed: uint64, high: uint32) -> vec4ui, what the keys of all surface points have in common whose ids
            have that upper half.
        run_words: the same four words on the host, a function (seed, high).
        key: `wp.func` (run: vec4ui, low: uint32) -> vec4ui, the key of a surface point, from the lower half of its id.
            Streams of a point have a `stream_key`.
        pair: `wp.func` (key, half: uint32, count) -> vec4, the points of samples 2 half and 2 half + 1, if one evaluation
            gives both.
        rate: the RMSE of n samples of a step function, such as visibility, falls about as n to the power of -rate.
        edge: if an edge crosses the square, the numbers of samples on one side of it, in two sets of n, differ with a
            variance of about half of n to the power of `edge`, for n from 4 to 64. Independent samples have 1.
        unseen: the variance, in samples squared, that is to be added where few samples are on one side of an edge, so that
            intervals hold what is expected there. Independent samples take 1.55, by the bounds of Clopper1934.
        progressive: whether the first m points are the same for every count.
        nets: whether sets of a power of two are so much more even than others that no other count should be chosen.
        wraps: whether its points go round the square, so that one that leaves at an end comes in at the other: lattices.
        random: whether the points of one surface point are independent of each other, too.
        cells_off: by how many cells of 2^-24 the integer twin may differ, because a quotient of float64s is rounded.
        colour: of its curves, as "#rrggbb".
        marker: of its points in matplotlib.
        summary: one line for tables.
        source: keys of SOURCES.md.
    """

    name: str
    sample: wp.Function
    progressive: bool
    colour: str
    marker: str
    summary: str
    source: str
    run: wp.Function = run_key
    run_words: Callable[[int, int], tuple[int, int, int, int]] = run_words
    key: wp.Function = mixed_key
    pair: wp.Function | None = None
    rate: float = 0.75
    edge: float = 0.25
    unseen: float = 0.6
    random: bool = False
    nets: bool = False
    wraps: bool = False
    cells_off: int = 0

    def edge_variance(self, count: int) -> float:
        """Variance of the difference described under `edge`, for sets of `count` samples."""
        return 0.5 * float(np.float_power(count, self.edge))
