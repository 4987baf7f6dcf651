"""Random errors of view factors, with given variances and a sum of 0 over the factors of each surface."""

import numpy as np

from warpsample.radiation.exchange.closure import rows_of
from warpsample.radiation.exchange.row_factors import RowFactors
from warpsample.radiation.exchange.surfaces import quotients

_FEWEST, _MOST = 16, 128
"""Limits of the number of draws. 16 draws give an error bar within 1 / sqrt(2 * 16), a sixth, at worst.

More draws than errors give the exact bar: signs are balanced, and those of any two errors differ in half of the draws.
"""

_WORK = 2**20  # errors times draws: limit of the computing time
_SEED = 20
_PASSES = 3  # iterations for the sizes; the second changes about a twentieth
_LOST = ("outside", "behind")


class ErrorDraws:
    """Generator of random errors of all view factors, used to estimate the variances of derived numbers.

    Losses are radiation that goes outside or hits backs of faces. The errors of a row are independent, minus their sum in
    proportion to the variances. So are counts of independent rays, where one surface gains the rays that others lose; here
    each error has its own design effect.
    """

    def __init__(self, factors: RowFactors) -> None:
        """Prepare the draws: compute the standard deviation of each view factor's error, for rows that sum to 0."""
        self._row, everywhere = rows_of(factors.indptr), np.arange(len(factors.indptr) - 1)
        self._places = [self._row, *[everywhere] * len(_LOST)]
        variances = [factors.variance, *(factors.others[name][1] for name in _LOST)]
        parts = [np.zeros(len(variance)) for variance in variances]
        for _ in range(_PASSES):
            free = [quotients(variance, 1.0 - part) for variance, part in zip(variances, parts, strict=True)]
            parts = [quotients(one, whole) for one, whole in zip(free, self._sum_by_row(free), strict=True)]
        # Two or three errors cannot keep their variances and a sum of 0: scale to keep the row's total variance.
        left = self._sum_by_row([one * (1.0 - part) for one, part in zip(free, parts, strict=True)])
        more = [quotients(*sums) for sums in zip(self._sum_by_row(variances), left, strict=True)]
        self._sizes, self._parts = [np.sqrt(one * scale) for one, scale in zip(free, more, strict=True)], parts
        self._of_outside = {name: _split_error(factors, name) for name in ("sky", "ground") if name in factors.others}
        lengths = [len(part) for part in (*parts, *(size for _, size in self._of_outside.values()))]
        self._signs, codes = _choose_signs(sum(lengths))
        self._codes = np.split(codes, np.cumsum(lengths)[:-1])
        self.number: int = len(self._signs)

    def draw(self, number: int) -> tuple[np.ndarray, dict[str, np.ndarray]]:
        """Return random errors of all view factors, (E,), and of the radiation that hits no surface, (N,) arrays by name.

        Equal numbers give equal draws.
        """
        signs = self._signs[number]
        free = [signs[codes] for codes in self._codes[: len(self._sizes)]]
        for error, size in zip(free, self._sizes, strict=True):
            np.multiply(error, size, out=error)
        for error, part, sums in zip(free, self._parts, self._sum_by_row(free), strict=True):
            np.multiply(sums, part, out=sums)
            np.subtract(error, sums, out=error)
        others = dict(zip(_LOST, free[1:], strict=True))
        for (name, (part, size)), codes in zip(self._of_outside.items(), self._codes[len(free) :], strict=True):
            others[name] = part * others["outside"] + size * signs[codes]
        return free[0], others

    def _sum_by_row(self, parts: list[np.ndarray]) -> list[np.ndarray]:
        """Return, for each error, the sum of all errors in the same row of the view-factor matrix."""
        sums = np.bincount(self._row, parts[0], len(parts[1])) + sum(parts[1:])
        return [sums[places] for places in self._places]


def _split_error(factors: RowFactors, name: str) -> tuple[np.ndarray, np.ndarray]:
    """Split the error of the sky or ground share: the part that follows from the error of `outside`, and the rest."""
    (outside, whole), (value, variance) = factors.others["outside"], factors.others[name]
    part = np.minimum(quotients(value, outside), np.sqrt(quotients(variance, whole)))
    return part, np.sqrt(np.maximum(variance - np.square(part) * whole, 0.0))


def _choose_signs(errors: int) -> tuple[np.ndarray, np.ndarray]:
    """Return +1 or -1 for each draw of each error: a Hadamard matrix, and a column number for each error.

    In draw d, error e has the sign signs[d, columns[e]]. Any two columns are uncorrelated.
    Column numbers are random if there are more errors than columns.
    """
    signs = np.ones((1, 1))
    while len(signs) < _FEWEST or (len(signs) < _MOST and len(signs) * errors < _WORK):
        signs = np.block([[signs, signs], [signs, -signs]])
    few = errors < len(signs)
    columns = 1 + np.arange(errors) if few else np.random.default_rng(_SEED).integers(1, len(signs), errors)
    return signs, columns.astype(np.uint8)
