"""From counts of rays to factors of a row with their variances: of faces, and of groups of faces."""

from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from warpsample.host.locks import imported
from warpsample.radiation.exchange.design_effects import factors_and_variances
from warpsample.radiation.exchange.hits_to_matrix import Counts
from warpsample.radiation.exchange.surfaces import Surfaces

if TYPE_CHECKING:
    from scipy.sparse import csr_array


@dataclass(frozen=True, eq=False)
class RowFactors:
    """Factors of rows of a matrix, as CSR has them, and of what meets no front.

    Attributes:
        indptr: (N + 1,) int64.
        indices: (E,) int32.
        value: (E,) float64.
        variance: (E,) float64, of the value.
        others: name -> ((N,) value, (N,) variance): outside, behind, absorbed where faces let a part of the light through,
            and sky and ground where there is an up.
    """

    indptr: np.ndarray
    indices: np.ndarray
    value: np.ndarray
    variance: np.ndarray
    others: dict[str, tuple[np.ndarray, np.ndarray]]


def factors_of(counts: Counts, rays: int, upward: np.ndarray | None, surfaces: Surfaces) -> RowFactors:
    """The factors of each surface, by counts of all faces with so many rays each.

    `upward` is (F,) float64, the share of each face's hemisphere above the horizon; None: not asked for.
    """
    if surfaces.groups is not None:
        return _group_factors(counts, rays, upward, surfaces)
    others = {}
    for name, hits, exact in _kinds(counts, rays, upward):
        value, variance = factors_and_variances(hits, rays)
        others[name] = (np.where(np.isnan(exact), value, exact), np.where(np.isnan(exact), variance, 0.0))
    return RowFactors(counts.indptr, counts.indices, *factors_and_variances(counts.hits, rays), others)


def matrices_of(
    value: np.ndarray, error: np.ndarray, indices: np.ndarray, indptr: np.ndarray
) -> tuple["csr_array", "csr_array"]:
    """Two square matrices, each with a pattern of its own: who drops entries of one in place leaves the other as it is."""
    csr_array = imported("scipy.sparse").csr_array
    kind, shape = np.int32 if len(indices) < 2**31 else np.int64, (len(indptr) - 1, len(indptr) - 1)
    pattern = indices.astype(kind, copy=False), indptr.astype(kind, copy=False)
    errors = csr_array((error, *(part.copy() for part in pattern)), shape=shape)
    return csr_array((value, *pattern), shape=shape), errors


def _group_factors(counts: Counts, rays: int, upward: np.ndarray | None, surfaces: Surfaces) -> RowFactors:
    """Those of groups: means of their faces' by area, whose errors are independent."""
    groups, weights, size = surfaces.groups, surfaces.weights, len(surfaces.areas)
    face = np.repeat(np.arange(len(weights)), np.diff(counts.indptr))
    keys, entry = np.unique(groups[face].astype(np.int64) * size + counts.indices, return_inverse=True)
    _, single = factors_and_variances(counts.hits, rays)
    value, variance = _folded(counts.hits / rays, single, weights[face], entry.ravel(), len(keys))
    others = {}
    for name, hits, exact in _kinds(counts, rays, upward):
        known, (_, single) = ~np.isnan(exact), factors_and_variances(hits, rays)
        parts = np.where(known[:, None], exact[:, None] / hits.shape[1], hits / rays)
        others[name] = _folded(parts, np.where(known, 0.0, single), weights, groups, size)
    indptr = np.searchsorted(keys, np.arange(size + 1, dtype=np.int64) * size)
    return RowFactors(indptr, (keys % size).astype(np.int32), value, variance, others)


def _kinds(counts: Counts, rays: int, upward: np.ndarray | None) -> Iterator[tuple[str, np.ndarray, np.ndarray]]:
    """(name, (F, replicates) hits, (F,) the share where it is known exactly, else NaN) of what meets no front.

    Where all rays meet nothing, the horizon alone parts the sky from the ground.
    """
    sky, ground, back, *absorbed = np.moveaxis(counts.special, 1, 0)
    nowhere = np.full(len(sky), np.nan)
    yield "outside", sky + ground, nowhere
    yield "behind", back, nowhere
    for hits in absorbed:
        yield "absorbed", hits, nowhere
    if upward is not None:
        open_ = (sky + ground).sum(axis=1) == rays
        yield "sky", sky, np.where(open_, upward, np.nan)
        yield "ground", ground, np.where(open_, 1.0 - upward, np.nan)


def _folded(
    parts: np.ndarray, variance: np.ndarray, weights: np.ndarray, into: np.ndarray, size: int
) -> tuple[np.ndarray, np.ndarray]:
    """Weighted sums of factors (E, replicates), which add up to a face's, and of their variances (E,)."""
    # One after the other in the order of the faces: no block or thread changes a bit.
    sums = np.stack([np.bincount(into, weights * part, size) for part in parts.T], axis=1)
    return sums.sum(axis=1), np.bincount(into, np.square(weights) * variance, size)
