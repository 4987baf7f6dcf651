"""View factors and their variances from counts of rays, for faces and for groups of faces."""

from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from warpsample.host.locks import imported
from warpsample.radiation.exchange.design_effects import factors_and_variances
from warpsample.radiation.exchange.hits_to_matrix import HitCounts
from warpsample.radiation.exchange.surfaces import Surfaces

if TYPE_CHECKING:
    from scipy.sparse import csr_array


@dataclass(frozen=True, eq=False)
class RowFactors:
    """View factors as a sparse CSR matrix, and the shares of each surface's rays that hit no front side of a face.

    Attributes:
        indptr: (N + 1,) int64, start of each row.
        indices: (E,) int32, column of each entry.
        value: (E,) float64, view factors.
        variance: (E,) float64, variance of each value.
        others: Dictionary from name to ((N,) value, (N,) variance): outside, behind, absorbed for meshes with transmitting
            faces, and sky and ground if `up` is given.
    """

    indptr: np.ndarray
    indices: np.ndarray
    value: np.ndarray
    variance: np.ndarray
    others: dict[str, tuple[np.ndarray, np.ndarray]]


def factors_of(counts: HitCounts, rays: int, upward: np.ndarray | None, surfaces: Surfaces) -> RowFactors:
    """Compute the view factors of all surfaces from the numbers of ray hits.

    rays: number of rays per face. upward: (F,) float64, share of each face's hemisphere above the horizon; None to omit sky
    and ground.
    """
    if surfaces.groups is not None:
        return _group_factors(counts, rays, upward, surfaces)
    others = {}
    for name, hits, exact in _iterate_lost_rays(counts, rays, upward):
        value, variance = factors_and_variances(hits, rays)
        others[name] = (np.where(np.isnan(exact), value, exact), np.where(np.isnan(exact), variance, 0.0))
    return RowFactors(counts.indptr, counts.indices, *factors_and_variances(counts.hits, rays), others)


def matrices_of(
    value: np.ndarray, error: np.ndarray, indices: np.ndarray, indptr: np.ndarray
) -> tuple["csr_array", "csr_array"]:
    """Return view factors and their errors as two square CSR matrices with separate index arrays.

    So changing one matrix in place keeps the other.
    """
    csr_array = imported("scipy.sparse").csr_array
    kind, shape = np.int32 if len(indices) < 2**31 else np.int64, (len(indptr) - 1, len(indptr) - 1)
    pattern = indices.astype(kind, copy=False), indptr.astype(kind, copy=False)
    errors = csr_array((error, *(part.copy() for part in pattern)), shape=shape)
    return csr_array((value, *pattern), shape=shape), errors


def _group_factors(counts: HitCounts, rays: int, upward: np.ndarray | None, surfaces: Surfaces) -> RowFactors:
    """Compute the view factors between groups of faces, as area-weighted means over each group's faces."""
    groups, weights, size = surfaces.groups, surfaces.weights, len(surfaces.areas)
    face = np.repeat(np.arange(len(weights)), np.diff(counts.indptr))
    keys, entry = np.unique(groups[face].astype(np.int64) * size + counts.indices, return_inverse=True)
    _, single = factors_and_variances(counts.hits, rays)
    value, variance = _sum_by_group(counts.hits / rays, single, weights[face], entry.ravel(), len(keys))
    others = {}
    for name, hits, exact in _iterate_lost_rays(counts, rays, upward):
        known, (_, single) = ~np.isnan(exact), factors_and_variances(hits, rays)
        parts = np.where(known[:, None], exact[:, None] / hits.shape[1], hits / rays)
        others[name] = _sum_by_group(parts, np.where(known, 0.0, single), weights, groups, size)
    indptr = np.searchsorted(keys, np.arange(size + 1, dtype=np.int64) * size)
    return RowFactors(indptr, (keys % size).astype(np.int32), value, variance, others)


def _iterate_lost_rays(
    counts: HitCounts, rays: int, upward: np.ndarray | None
) -> Iterator[tuple[str, np.ndarray, np.ndarray]]:
    """Yield the kinds of rays that hit no front of a face, as (name, (F, replicates) counts, (F,) exact share or NaN).

    Sky and ground have exact shares for faces all of whose rays hit nothing.
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


def _sum_by_group(
    parts: np.ndarray, variance: np.ndarray, weights: np.ndarray, into: np.ndarray, size: int
) -> tuple[np.ndarray, np.ndarray]:
    """Return weighted sums of the view factors and variances of each group's faces.

    Factors are also summed over the replicates.
    """
    # Sums are in the order of the faces: bits do not depend on blocks or threads. The type is for groups without entries:
    # `np.bincount` then returns integers, whatever the weights.
    sums = np.stack([np.bincount(into, weights * part, size) for part in parts.T], axis=1).astype(np.float64)
    return sums.sum(axis=1), np.bincount(into, np.square(weights) * variance, size).astype(np.float64)
