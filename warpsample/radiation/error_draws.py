"""Draws of the errors of shares: as large as their variances say, and such that those of a row add up to nothing."""

import numpy as np

from warpsample.radiation.closure import rows_of
from warpsample.radiation.row_shares import Shares

DRAWS = 32
"""They tell a bar to 1 / sqrt(2 * 32), an eighth, at worst; far better where an error is mostly its own."""

_SEED = 20  # of the signs, which must not be those of anyone's rays: these come from other generators
_PASSES = 3  # of what errors give way by: from the first on, a twentieth or so changes
_LOST = ("outside", "behind")


class ErrorDraws:
    """Draws of the errors of all shares of rows, and of what these lose.

    Those of a row are independent, less what they sum up to, in proportion to their own variances: as for counts of
    independent rays, where what one gains all others lose; but each with the design effect that it has.
    """

    def __init__(self, shares: Shares) -> None:
        """Finds the size of each error before the row's sum is taken off, and which part of that each takes."""
        self._row, everywhere = rows_of(shares.indptr), np.arange(len(shares.indptr) - 1)
        self._places = [self._row, *[everywhere] * len(_LOST)]
        variances = [shares.variance, *(shares.others[name][1] for name in _LOST)]
        parts = [np.zeros(len(variance)) for variance in variances]
        for _ in range(_PASSES):
            free = [_quotients(variance, 1.0 - part) for variance, part in zip(variances, parts, strict=True)]
            parts = [_quotients(one, whole) for one, whole in zip(free, self._of_rows(free), strict=True)]
        self._sizes, self._parts = [np.sqrt(one) for one in free], parts
        self._of_outside = {name: _split(shares, name) for name in ("sky", "ground") if name in shares.others}

    def draw(self, number: int) -> tuple[np.ndarray, dict[str, np.ndarray]]:
        """Errors of the (E,) shares, and name -> (N,) of what rows lose; the same whenever it is called."""
        rng = np.random.default_rng([_SEED, number])
        free = [size * _signs(rng, len(size)) for size in self._sizes]
        found = [one - part * sums for one, part, sums in zip(free, self._parts, self._of_rows(free), strict=True)]
        others = dict(zip(_LOST, found[1:], strict=True))
        for name, (part, size) in self._of_outside.items():
            others[name] = part * others["outside"] + size * _signs(rng, len(size))
        return found[0], others

    def _of_rows(self, parts: list[np.ndarray]) -> list[np.ndarray]:
        """The sum of its row for each."""
        sums = np.bincount(self._row, parts[0], len(parts[1])) + sum(parts[1:])
        return [sums[places] for places in self._places]


def _split(shares: Shares, name: str) -> tuple[np.ndarray, np.ndarray]:
    """By how much of the error of `outside` the sky or the ground errs, and how large what it errs by itself is."""
    (outside, whole), (value, variance) = shares.others["outside"], shares.others[name]
    part = np.minimum(_quotients(value, outside), np.sqrt(_quotients(variance, whole)))
    return part, np.sqrt(np.maximum(variance - np.square(part) * whole, 0.0))


def _quotients(above: np.ndarray, below: np.ndarray) -> np.ndarray:
    """above / below, 0 where that is 0."""
    return np.divide(above, below, out=np.zeros_like(above), where=below > 0.0)


def _signs(rng: np.random.Generator, number: int) -> np.ndarray:
    """(number,) of 1 and -1."""
    return 2.0 * rng.integers(0, 2, number, np.int8) - 1.0
