"""Comparison of the pictures of two places: whether their texels differ by more than standard errors and rounding."""

from dataclasses import dataclass

import numpy as np

from warpsample.output.textures.images import Images
from warpsample.texture.pictures import WHITE

_BLOCK = 8  # texels along a side
_HELD = 1 << 30  # bytes of images: those of about 18 pictures of 2048 x 2048 texels, or of 290 of 512 x 512
_LOOKED_AT = 4096  # texels of a digest
_FEW = 16  # texels: the errors of fewer texels are too uncertain to be a block's only measure
_SIGMAS_OF_TEXEL = 5.0  # largest of 20 million differences between equal places: 4.2
_SIGMAS_OF_BLOCK = 6.0  # of the mean: by chance about one block of 10^9 differs by more
_SIGMAS_OF_WHOLE = 4.0  # of the mean over a whole picture, one number: by chance about 1 of 16,000 differs by more
_RARE = 20.7  # -log(1e-9): by chance the squares of one block of 10^9 add up to more than the bound
_UNSURE = 1.1  # factor on variances: measured squared differences of equal places are up to 1.02 of the variances


@dataclass(frozen=True, eq=False)
class Compared:
    """Images of a texture at one place, as far as they are compared with others.

    Attributes:
        value: (H, W) or (H, W, C) values.
        noise: errors that come from rays: above 0 where all rays agree, and unbiased.
        own: (H, W) bool, texels with a value of their own.
        covered: (H, W) bool, texels with at least one point.
    """

    value: np.ndarray
    noise: tuple[np.ndarray, np.ndarray]
    own: np.ndarray
    covered: np.ndarray

    @property
    def nbytes(self) -> int:
        """Memory of the images, in bytes."""
        return sum(image.nbytes for image in (self.value, *self.noise, self.own, self.covered))


class KnownPictures:
    """Pictures of places that a new picture is compared with: those added or found last, as many as memory allows.

    A new picture that is equal to an older one counts as different, so it is stored once more.
    """

    def __init__(self, depth: int) -> None:
        """Start without pictures; `depth` is the number of bits per channel of a picture."""
        self._depth, self._count = depth, 0
        self._held: dict[int, tuple[Compared, Digest | None]] = {}  # by number, the one added or found last at the end

    def find_or_add(self, images: Images) -> int:
        """Return the number of the first picture that is equal, or the next number if none is, and hold the picture."""
        made = Compared(images.value, images.noise, images.own, images.points.covered)
        digest = Digest.of(made)
        equal = (number for number in sorted(self._held) if not self._differ(*self._held[number], made, digest))
        number = next(equal, self._count)
        self._held[number] = self._held.pop(number, (made, digest))
        self._count = max(self._count, number + 1)
        while len(self._held) > 1 and sum(one.nbytes for one, _ in self._held.values()) > _HELD:
            del self._held[next(iter(self._held))]
        return number

    def _differ(self, known: Compared, digest: "Digest | None", made: Compared, own: "Digest | None") -> bool:
        """Return whether two pictures differ; digests show most differences in a fraction of the time."""
        if digest is not None and own is not None and digest.differ(own, self._depth):
            return True
        return do_pictures_differ(known, made, self._depth)


@dataclass(frozen=True, eq=False)
class Digest:
    """Sums over blocks of 8 x 8 texels of a picture, and some of its texels, for a fast comparison of many pictures.

    Attributes:
        count: (B,) numbers of texels.
        is_own: (B,) bool, blocks whose texels all have values of their own.
        most: number of texels with values of their own.
        sums: (C, B) sums of values.
        unbiased: (B,) sums of unbiased variances.
        raised: (B,) sums of variances that are above 0 where all rays agree.
        texel: (n,) positions of some texels in the picture.
        block: (n,) number of the block of each.
        values: (C, n) their values.
        variance: (n,) their variances, above 0 where all rays agree.
        largest: largest absolute value, or None for vectors.
    """

    count: np.ndarray
    is_own: np.ndarray
    most: int
    sums: np.ndarray
    unbiased: np.ndarray
    raised: np.ndarray
    texel: np.ndarray
    block: np.ndarray
    values: np.ndarray
    variance: np.ndarray
    largest: float | None

    @classmethod
    def of(cls, made: Compared) -> "Digest | None":
        """Return the digest of a picture, or None if no texel has a value of its own."""
        covered, own = made.covered, made.own[made.covered]
        if not own.any():
            return None
        block = _number_blocks(covered)
        images = (made.value, *made.noise)
        value, *errors = (np.nan_to_num(image[covered].reshape(len(block), -1).T.astype(np.float64)) for image in images)
        raised, unbiased = (np.square(error).sum(axis=0) for error in errors)
        sums = np.stack([np.bincount(block, channel) for channel in value])
        some = slice(None, None, -(-len(block) // _LOOKED_AT))
        count, variances = np.bincount(block), [np.bincount(block, variance) for variance in (unbiased, raised)]
        texels = (array[..., some].copy() for array in (np.flatnonzero(covered), block, value, raised))
        is_own = np.bincount(block, own) == count
        return cls(count, is_own, int(own.sum()), sums, *variances, *texels, _find_largest(made.value))

    def differ(self, other: "Digest", depth: int) -> bool:
        """Return whether pictures differ by rule 1 or 3 of `do_pictures_differ`; False leaves the question open.

        Blocks with filled texels are left out, and mean variances are not below those of the rules.
        """
        if not (np.array_equal(self.count, other.count) and np.array_equal(self.texel, other.texel)):
            return False
        level, is_own, most = _level_of(self.largest, depth), self.is_own & other.is_own, max(self.most, other.most)
        raised, unbiased = self.raised + other.raised, self.unbiased + other.unbiased
        gap = np.where(is_own[self.block], np.square(other.values - self.values).sum(axis=0), 0.0)
        pooled = _pool(raised, self.count, raised.sum() / most)[self.block]
        if _is_any_texel_off(gap, self.variance + other.variance, pooled, level):
            return True
        gaps = np.where(is_own, other.sums - self.sums, 0.0)
        return any(_is_any_block_off(one, unbiased, self.count, unbiased.sum() / most, level) for one in gaps)


def do_pictures_differ(known: Compared, other: Compared, depth: int) -> bool:
    """Return whether two places need pictures of their own.

    They do if one of these is larger than standard errors and the rounding of the picture explain:

    1. the difference of a texel, beyond one level of the picture, for vectors times their length. The error of a texel is
       uncertain itself, so the mean variance of its block of 8 x 8 texels is added;
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
    covered = known.covered & other.covered & (known.own | other.own)
    if not covered.any():
        return False
    block = _number_blocks(covered)

    def select(image: np.ndarray) -> np.ndarray:
        """Return an image at the compared texels, (C, n) float64."""
        return np.nan_to_num(image[covered].reshape(len(block), -1).T.astype(np.float64))

    values = select(known.value), select(other.value)
    gap = values[1] - values[0]
    level = np.full(len(block), _level_of(_find_largest(known.value), depth))
    if known.value.ndim == 3:  # pictures store directions
        level *= np.linalg.norm(values, axis=1).max(axis=0).clip(max=1.0)
    pairs = zip(known.noise, other.noise, strict=True)
    raised, unbiased = (sum(np.square(select(one)).sum(axis=0) for one in pair) for pair in pairs)
    return _do_texels_differ(np.square(gap).sum(axis=0), raised, block, level) or any(
        _do_means_differ(one, unbiased, block, level) for one in gap
    )


def _number_blocks(covered: np.ndarray) -> np.ndarray:
    """Return the number of the block of each texel in a mask (H, W), counted from 0 without gaps."""
    row, column = np.nonzero(covered)
    return np.unique(row // _BLOCK * covered.shape[1] + column // _BLOCK, return_inverse=True)[1]


def _find_largest(value: np.ndarray) -> float | None:
    """Return the largest absolute value of a picture (H, W), or None for vectors (H, W, 3)."""
    return None if value.ndim == 3 else float(np.abs(value).max(initial=0.0))


def _level_of(largest: float | None, depth: int) -> float:
    """Return the difference between two levels of the picture of values up to `largest`, or of unit vectors."""
    return (2.0 if largest is None else largest) / WHITE[depth][0]


def _do_texels_differ(squares: np.ndarray, variance: np.ndarray, block: np.ndarray, level: np.ndarray) -> bool:
    """Return whether a texel differs, or whether the squared differences of a block or of all texels are too large.

    Args:
        squares: (n,) squared differences.
        variance: (n,) variances of the differences.
        block: (n,) number of each texel's block.
        level: (n,) differences between two levels of the picture.
    """
    count = np.bincount(block)
    pooled = _pool(np.bincount(block, variance), count, variance.mean())[block]
    if _is_any_texel_off(squares, variance, pooled, level):
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


def _do_means_differ(gap: np.ndarray, variance: np.ndarray, block: np.ndarray, level: np.ndarray) -> bool:
    """Return whether the means over a block, or over all texels, differ; `gap` are the differences of one component."""
    sums = np.bincount(block, gap), np.bincount(block, variance), np.bincount(block)
    if _is_any_block_off(*sums, variance.mean(), np.bincount(block, level) / sums[2]):
        return True
    return bool(abs(gap.sum()) > _SIGMAS_OF_WHOLE * np.sqrt(variance.sum()) + level.sum())


def _pool(variance: np.ndarray, count: np.ndarray, mean: float) -> np.ndarray:
    """Return the mean variance of each block, (B,), by sums over its texels; of few texels, with the mean of all."""
    lacking = np.maximum(_FEW - count, 0)
    return (variance + lacking * mean) / (count + lacking)


def _is_any_texel_off(squares: np.ndarray, variance: np.ndarray, pooled: np.ndarray, level: float | np.ndarray) -> bool:
    return bool((np.sqrt(squares) > _SIGMAS_OF_TEXEL * np.sqrt(variance + pooled) + level).any())


def _is_any_block_off(
    gap: np.ndarray, variance: np.ndarray, count: np.ndarray, mean: float, level: float | np.ndarray
) -> bool:
    """Return whether the mean of a block differs, by sums over blocks and the mean variance of all texels."""
    spread = np.sqrt((variance / count + mean) / count)
    return bool((np.abs(gap) / count > _SIGMAS_OF_BLOCK * spread + level).any())
