"""Comparison of the pictures of two places: whether their texels differ by more than standard errors and rounding."""

import numpy as np

from warpsample.output.textures.images import Filled
from warpsample.texture.pictures import WHITE

_BLOCK = 8  # texels along a side
_FEW = 16  # texels: the errors of fewer texels are too uncertain to be a block's only measure
_SIGMAS_OF_TEXEL = 5.0  # largest of 20 million differences between equal places: 4.2
_SIGMAS_OF_BLOCK = 6.0  # of the mean: by chance about one block of 10^9 differs by more
_SIGMAS_OF_WHOLE = 4.0  # of the mean over a whole picture, one number: by chance about 1 of 16,000 differs by more
_RARE = 20.7  # -log(1e-9): by chance the squares of one block of 10^9 add up to more than the bound
_UNSURE = 1.1  # factor on variances: measured squared differences of equal places are up to 1.02 of the variances


def do_pictures_differ(known: Filled, other: Filled, depth: int) -> bool:
    """Return whether two places need pictures of their own.

    They do if one of these is larger than standard errors and the rounding of the picture explain:

    1. the difference of a texel, beyond one level of the picture. The error of a texel is uncertain itself, so the mean
       variance of its block of 8 x 8 texels is added;
    2. the sum of squared differences in a block, or in the whole picture, compared with the sum of the variances;
    3. the difference of the means over a block, or over the whole picture.

    Rules 1 and 2 use errors that are above 0 where all rays agree. Rule 3 uses unbiased errors, whose squares may be added:
    raised errors would hide a small difference of all texels. All errors are those of the rays alone: the samples within a
    texel are at the same positions at all places. Texels that are filled in both pictures are copies and do not count.
    A texel that is filled in one picture counts with the value and the error of its source.

    The length of a vector's difference is compared with the sum of the variances along the axes, because the vectors of a
    picture and their errors have different axes.

    Args:
        known: Images of the place whose picture is shared.
        other: Images of the other place.
        depth: Bits per channel of the picture.
    """
    covered = known.job.points.covered & other.job.points.covered & (known.own | other.own)
    row, column = np.nonzero(covered)
    if not len(row):
        return False
    block = np.unique(row // _BLOCK * covered.shape[1] + column // _BLOCK, return_inverse=True)[1]

    def select(image: np.ndarray) -> np.ndarray:
        """Return an image at the compared texels, (C, n) float64."""
        return np.nan_to_num(image[covered].reshape(len(block), -1).T.astype(np.float64))

    level = _level_of(known.value, depth)
    gap = select(other.value) - select(known.value)
    pairs = zip(known.noise, other.noise, strict=True)
    raised, unbiased = (sum(np.square(select(one)).sum(axis=0) for one in pair) for pair in pairs)
    return _do_texels_differ(np.square(gap).sum(axis=0), raised, block, level) or any(
        _do_means_differ(one, unbiased, block, level) for one in gap
    )


def _level_of(value: np.ndarray, depth: int) -> float:
    """Return the difference between two levels of the picture of values (H, W), or of vectors (H, W, 3)."""
    span = 2.0 if value.ndim == 3 else float(np.abs(value).max(initial=0.0))
    return span / WHITE[depth][0]


def _do_texels_differ(squares: np.ndarray, variance: np.ndarray, block: np.ndarray, level: float) -> bool:
    """Return whether a texel differs, or whether the squared differences of a block or of all texels are too large.

    Args:
        squares: (n,) squared differences.
        variance: (n,) variances of the differences.
        block: (n,) number of each texel's block.
        level: difference between two levels of the picture.
    """
    count = np.bincount(block)
    lacking = np.maximum(_FEW - count, 0)
    pooled = ((np.bincount(block, variance) + lacking * variance.mean()) / (count + lacking))[block]
    if (np.sqrt(squares) > _SIGMAS_OF_TEXEL * np.sqrt(variance + pooled) + level).any():
        return True
    variance = _UNSURE * np.where(count[block] < _FEW, np.maximum(variance, pooled), variance) + (0.5 * level) ** 2
    return any(_are_squares_too_large(squares, variance, group) for group in (block, np.zeros_like(block)))


def _are_squares_too_large(squares: np.ndarray, variance: np.ndarray, group: np.ndarray) -> bool:
    """Return whether a group's sum of squared differences exceeds a bound on sums of squares of normal numbers.

    Source: Laurent and Massart, Adaptive estimation of a quadratic functional by model selection (2000), lemma 1.
    """
    largest = np.zeros(group.max() + 1)
    np.maximum.at(largest, group, variance)
    spread = 2.0 * np.sqrt(_RARE * np.bincount(group, np.square(variance))) + 2.0 * _RARE * largest
    return bool((np.bincount(group, squares) > np.bincount(group, variance) + spread).any())


def _do_means_differ(gap: np.ndarray, variance: np.ndarray, block: np.ndarray, level: float) -> bool:
    """Return whether the means over a block, or over all texels, differ; `gap` are the differences of one component."""
    count = np.bincount(block)
    spread = np.sqrt((np.bincount(block, variance) / count + variance.mean()) / count)
    if (np.abs(np.bincount(block, gap)) / count > _SIGMAS_OF_BLOCK * spread + level).any():
        return True
    return bool(abs(gap.sum()) > _SIGMAS_OF_WHOLE * np.sqrt(variance.sum()) + level * len(gap))
