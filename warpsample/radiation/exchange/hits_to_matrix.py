"""Counting of ray hits into a sparse matrix, with a row for each casting face and a column for each surface.

Only columns with hits are stored.
"""

from dataclasses import dataclass

import numpy as np

from warpsample.host.engine import check_memory
from warpsample.radiation.exchange.face_rays import BACK, GROUND, SKY

SPECIAL = 3
"""Number of kinds of rays that hit no front: to the sky, to the ground, and to a back. A mesh with transmitting faces has
one kind more, the light that these faces absorb."""

_BYTES, _HIT_BYTES = 40, 8  # per entry, and per replicate of an entry, while blocks are joined


@dataclass(frozen=True, eq=False)
class HitCounts:
    """Sparse matrix of the numbers of rays of each face that hit each surface, for each independent set of rays.

    Attributes:
        indptr: (rows + 1,) int64, as in a CSR matrix.
        indices: (E,) int32, columns, ascending in each row.
        hits: (E, replicates) int32; for meshes with transmitting faces float64, sums of the transmitted shares.
        special: (rows, SPECIAL, replicates) of the type of `hits`, hits of no front; with transmitting faces one kind
            more.
    """

    indptr: np.ndarray
    indices: np.ndarray
    hits: np.ndarray
    special: np.ndarray


@dataclass(frozen=True, eq=False)
class Block:
    """Numbers of rays that hit each surface, for some of the casting faces.

    Attributes:
        rows: (B,) numbers of the rows, ascending.
        sizes: (B,) number of entries of each row.
        columns: Columns of the entries, row by row.
        hits: Hits of the entries, as in `HitCounts`.
        special: Hits of no front, as in `HitCounts`.
    """

    rows: np.ndarray
    sizes: np.ndarray
    columns: np.ndarray
    hits: np.ndarray
    special: np.ndarray


def block_of(rows: np.ndarray, codes: np.ndarray, groups: np.ndarray | None, weights: np.ndarray | None = None) -> Block:
    """Count the rays of some faces by the surface that each ray hits.

    Args:
        rows: (B,) int32.
        codes: (B, replicates, per_replicate) int32, see `face_rays.SKY`; overwritten.
        groups: (F,) int32, column of each face; None: one column per face.
        weights: (B, replicates, per_replicate) float32, transmitted share of each ray; None: 1.
    """
    if groups is not None:
        met = codes >= 0
        codes[met] = groups[codes[met]]
    np.maximum(codes, BACK, out=codes)
    row, column, hits = _count_codes(codes, weights)
    special = np.zeros((len(rows), SPECIAL if weights is None else SPECIAL + 1, codes.shape[1]), hits.dtype)
    if weights is not None:
        special[:, SPECIAL] = (1.0 - weights.astype(np.float64)).sum(axis=2)
    for kind, code in enumerate((SKY, GROUND, BACK)):
        of_kind = np.flatnonzero(column == code)
        special[row[of_kind], kind] = hits[of_kind]
    front = np.flatnonzero(column >= 0)
    return Block(rows, np.bincount(row[front], minlength=len(rows)), column[front], hits[front], special)


class Collector:
    """Builder of one sparse matrix from blocks of hit counts, which are added in the order of the rows."""

    def __init__(self, rows: int, replicates: int, weighs: bool = False) -> None:
        """Allocate the counts of hits; `weighs` states whether rays have weights.

        Raises:
            MemoryError: the rows need more memory than is free.
        """
        self._sizes = np.zeros(rows + 1, np.int64)
        kinds, kind = (SPECIAL + 1, np.float64) if weighs else (SPECIAL, np.int32)
        check_memory(_HIT_BYTES * kinds * rows * replicates, f"{rows:,} rows", "pass fewer replicates")
        self._special = np.zeros((rows, kinds, replicates), kind)
        self._blocks = [(np.empty(0, np.int32), np.empty((0, replicates), kind))]
        self._entries = 0
        self._bytes = _BYTES + _HIT_BYTES * replicates

    def all_open(self, rows: np.ndarray, per_replicate: int) -> None:
        """Record that all rays of the given faces hit nothing."""
        self._special[rows, 0] = per_replicate

    def take(self, block: Block) -> None:
        """Append the hit counts of the next faces to the matrix.

        Raises:
            MemoryError: the collected blocks need more memory than is free.
        """
        self._sizes[block.rows + 1] = block.sizes
        self._special[block.rows] = block.special
        self._blocks.append((block.columns, block.hits))
        self._entries += len(block.columns)
        wants = "pass a smaller count, fewer replicates, or groups"
        check_memory(self._bytes * self._entries, f"{self._entries:,} view factors and more", wants)

    def counts(self) -> HitCounts:
        """Return the complete matrix of hit counts, and free the blocks."""
        columns, hits = (np.concatenate(parts) for parts in zip(*self._blocks, strict=True))
        self._blocks.clear()
        return HitCounts(np.cumsum(self._sizes), columns, hits, self._special)


def _count_codes(codes: np.ndarray, weights: np.ndarray | None) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Count the rays from each face by the code of their hit; return (face, code of the hit, number of rays in each set).

    codes: (B, replicates, per_replicate). weights: the same shape; hits are then float64 sums of the weights.
    """
    rows, replicates, per_replicate = codes.shape
    wide = np.int32 if (int(codes.max()) + 1) * replicates < 2**31 else np.int64
    keys = codes * wide(replicates)  # one sort orders codes, and replicates within a code
    keys += np.arange(replicates, dtype=wide)[:, None]
    keys = keys.reshape(rows, replicates * per_replicate)
    if weights is None:
        keys.sort(axis=1)
    else:
        order = np.argsort(keys, axis=1, kind="stable")
        keys = np.take_along_axis(keys, order, axis=1)
        weights = np.take_along_axis(weights.reshape(keys.shape), order, axis=1).astype(np.float64)
    new = np.ones(keys.shape, np.bool_)
    np.not_equal(keys[:, 1:], keys[:, :-1], out=new[:, 1:])
    at = np.flatnonzero(new)
    key, length = keys.ravel()[at], np.diff(at, append=keys.size)
    if weights is not None:
        length = np.add.reduceat(weights.ravel(), at)
    code, row = key // wide(replicates), at // (replicates * per_replicate)
    first = np.ones(len(at), np.bool_)
    first[1:] = (code[1:] != code[:-1]) | (row[1:] != row[:-1])
    hits = np.zeros((np.count_nonzero(first), replicates), np.int32 if weights is None else np.float64)
    hits[np.cumsum(first) - 1, key - code * wide(replicates)] = length
    entry = np.flatnonzero(first)
    return row[entry], code[entry].astype(np.int32, copy=False), hits
