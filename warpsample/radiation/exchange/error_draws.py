"""Draws of the errors of factors: as large as their variances say, and such that those of a row add up to nothing."""

import numpy as np

from warpsample.radiation.exchange.closure import rows_of
from warpsample.radiation.exchange.row_factors import RowFactors
from warpsample.radiation.exchange.surfaces import quotients

_FEWEST, _MOST = 16, 128
"""Draws. 16 tell a bar to 1 / sqrt(2 * 16), a sixth, at worst, and far better where an error is mostly its own.

More of them than errors tell it exactly: signs are balanced, any two errors' differ in half of the draws.
"""

_WORK = 2**20  # errors times draws, from which on more draws would take long
_SEED = 20
_PASSES = 3  # of what errors give way by: from the first on, a twentieth or so changes
_LOST = ("outside", "behind")


class ErrorDraws:
    """Draws of the errors of all factors of rows, and of what these lose; `number` of them.

    Those of a row are independent, less what they sum up to, in proportion to their own variances: as for counts of
    independent rays, where what one gains all others lose; but each with the design effect that it has.
    """

    def __init__(self, factors: RowFactors) -> None:
        """Finds the size of each error before the row's sum is taken off, and which part of that each takes."""
        self._row, everywhere = rows_of(factors.indptr), np.arange(len(factors.indptr) - 1)
        self._places = [self._row, *[everywhere] * len(_LOST)]
        variances = [factors.variance, *(factors.others[name][1] for name in _LOST)]
        parts = [np.zeros(len(variance)) for variance in variances]
        for _ in range(_PASSES):
            free = [quotients(variance, 1.0 - part) for variance, part in zip(variances, parts, strict=True)]
            parts = [quotients(one, whole) for one, whole in zip(free, self._of_rows(free), strict=True)]
        # Where a few cannot add up to nothing as they are, as two that must be alike, all of a row are as large as said.
        left = self._of_rows([one * (1.0 - part) for one, part in zip(free, parts, strict=True)])
        more = [quotients(*sums) for sums in zip(self._of_rows(variances), left, strict=True)]
        self._sizes, self._parts = [np.sqrt(one * scale) for one, scale in zip(free, more, strict=True)], parts
        self._of_outside = {name: _split(factors, name) for name in ("sky", "ground") if name in factors.others}
        lengths = [len(part) for part in (*parts, *(size for _, size in self._of_outside.values()))]
        self._signs, codes = _balanced(sum(lengths))
        self._codes = np.split(codes, np.cumsum(lengths)[:-1])
        self.number: int = len(self._signs)

    def draw(self, number: int) -> tuple[np.ndarray, dict[str, np.ndarray]]:
        """Errors of the (E,) factors, and name -> (N,) of what rows lose; the same whenever it is called."""
        signs = self._signs[number]
        free = [signs[codes] for codes in self._codes[: len(self._sizes)]]
        for error, size in zip(free, self._sizes, strict=True):
            np.multiply(error, size, out=error)
        for error, part, sums in zip(free, self._parts, self._of_rows(free), strict=True):
            np.multiply(sums, part, out=sums)
            np.subtract(error, sums, out=error)
        others = dict(zip(_LOST, free[1:], strict=True))
        for (name, (part, size)), codes in zip(self._of_outside.items(), self._codes[len(free) :], strict=True):
            others[name] = part * others["outside"] + size * signs[codes]
        return free[0], others

    def _of_rows(self, parts: list[np.ndarray]) -> list[np.ndarray]:
        """The sum of its row for each."""
        sums = np.bincount(self._row, parts[0], len(parts[1])) + sum(parts[1:])
        return [sums[places] for places in self._places]


def _split(factors: RowFactors, name: str) -> tuple[np.ndarray, np.ndarray]:
    """By how much of the error of `outside` the sky or the ground errs, and how large what it errs by itself is."""
    (outside, whole), (value, variance) = factors.others["outside"], factors.others[name]
    part = np.minimum(quotients(value, outside), np.sqrt(quotients(variance, whole)))
    return part, np.sqrt(np.maximum(variance - np.square(part) * whole, 0.0))


def _balanced(errors: int) -> tuple[np.ndarray, np.ndarray]:
    """(draws, draws) signs, Hadamard's, and which column of them each error has; by chance where they are too many."""
    signs = np.ones((1, 1))
    while len(signs) < _FEWEST or (len(signs) < _MOST and len(signs) * errors < _WORK):
        signs = np.block([[signs, signs], [signs, -signs]])
    few = errors < len(signs)
    columns = 1 + np.arange(errors) if few else np.random.default_rng(_SEED).integers(1, len(signs), errors)
    return signs, columns.astype(np.uint8)
