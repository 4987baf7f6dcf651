"""Record that describes one sequence: its functions for kernels and its statistical properties."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
import warp as wp

from warpsample.sequences.hashing import mixed_key, run_key, run_words

STREAMS = 4
"""Version number of all random streams; a release in which a seed gives different numbers increases it."""


@dataclass(frozen=True, eq=False)
class Sequence:
    """Sequence of sample points in the unit square, a pure function of seed, surface point and sample number.

    A key is four random words for one surface point. Means over the samples of one key are unbiased, and means of different
    keys are independent. Sequences differ in the evenness with which the samples of one key cover the square.

    Attributes:
        name: value for the argument `sequence`.
        sample: `wp.func` (key: vec4ui, sample: uint32, count: uint32) -> vec2 that returns point number `sample` of `count`
            points, with coordinates that are multiples of 2^-24 in [0, 1).
        run: `wp.func` (seed: uint64, high: uint32) -> vec4ui, random words shared by the keys of all surface points whose
            ids have the upper half `high`.
        run_words: function (seed, high) that computes the words of `run` on the host.
        key: `wp.func` (run: vec4ui, low: uint32) -> vec4ui, the key of the surface point whose id has the lower half `low`.
            `hashing.stream_key` derives keys of further streams of a point.
        pair: `wp.func` (key, half: uint32, count) -> vec4, the points of samples 2 * half and 2 * half + 1; None if
            computing both at once saves nothing.
        rate: rate of convergence: for a step function such as visibility, the root mean square error of n samples is about
            proportional to n^-rate.
        edge: exponent of the variance at an edge. Where an edge crosses the square, the numbers of samples on one side of
            the edge, in two sets of n samples, differ with a variance of about n^edge / 2, for n from 4 to 64. Independent
            samples have 1.
        unseen: variance, in samples squared, to add where few samples lie on one side of an edge, so that confidence
            intervals keep their nominal coverage. Independent samples need 1.55, by the bounds of Clopper1934.
        progressive: whether the first m points are the same for every count.
        nets: whether a power of two samples covers the square so much more evenly that callers should use no other count.
        wraps: whether the points are even on the torus, with opposite sides of the square joined, as lattices are.
        random: whether the samples of one surface point are independent of each other.
        cells_off: largest difference to the proof's implementation in exact integers, in steps of 2^-24; not 0 where a
            float64 quotient is rounded.
        colour: colour of the sequence's curves, as "#rrggbb".
        marker: matplotlib marker of the sequence's points.
        summary: description of one line, for tables.
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
        """Return how much two sets of `count` samples differ in the number of samples on one side of a straight edge.

        The result is the variance of the difference.

        It is n^edge / 2 for sets of n = `count` samples, with the attribute `edge`.
        """
        return 0.5 * float(np.float_power(count, self.edge))
