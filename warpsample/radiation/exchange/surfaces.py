"""Surfaces between which view factors are computed: single faces, or groups of faces."""

from dataclasses import dataclass
from typing import Any

import numpy as np

from warpsample.host.arguments import quote
from warpsample.host.engine import check_memory
from warpsample.host.neighbours import as_ndarray
from warpsample.mesh.mesh import Mesh

_LARGEST = 2**31 - 2  # largest group number: columns and their count are int32
_BYTES = 200  # per row


@dataclass(frozen=True, eq=False)
class Surfaces:
    """Surfaces between which view factors are computed: the F faces of a mesh, or N groups of faces.

    Attributes:
        groups: (F,) int32, group of each face; None if each face is a surface.
        areas: (N,) float64, square units.
        weights: (F,) float64, each face's share of its group's area with rays.
        densities: (N,) float64, effective number of rays per area for one ray per face, given the weights; 0 without rays.
    """

    groups: np.ndarray | None
    areas: np.ndarray
    weights: np.ndarray
    densities: np.ndarray

    def summed(self, values: np.ndarray) -> np.ndarray:
        """Sum integers per face, (F,), over the faces of each surface, and return the (N,) sums."""
        if self.groups is None:
            return values
        return np.bincount(self.groups, values, len(self.areas)).astype(values.dtype)

    def means(self, values: np.ndarray) -> np.ndarray:
        """Average (F,) numbers by area over the faces of each surface; return (N,) float64."""
        if self.groups is None:
            return values.astype(np.float64)
        return np.bincount(self.groups, self.weights * values, len(self.areas))


def surfaces_of(areas: np.ndarray, cast: np.ndarray, groups: np.ndarray | None) -> Surfaces:
    """Build the surfaces for view factors from the areas (F,) of faces.

    cast: (F,) bool, the faces with rays. groups: (F,) int32, group of each face, or None.
    """
    active = np.where(cast, areas, 0.0)
    if groups is None:
        return Surfaces(None, areas, cast.astype(np.float64), quotients(np.ones(len(areas)), active))
    size = int(groups.max()) + 1
    sums, squares = np.bincount(groups, active, size), np.bincount(groups, np.square(active), size)
    return Surfaces(groups, np.bincount(groups, areas, size), quotients(active, sums[groups]), quotients(sums, squares))


def quotients(above: np.ndarray, below: np.ndarray) -> np.ndarray:
    """Return the elementwise quotients above / below; 0 where `below` is 0."""
    return np.divide(above, below, out=np.zeros_like(above), where=below > 0.0)


def check_groups(groups: Any, mesh: Mesh) -> tuple[np.ndarray | None, tuple[str, ...] | None]:
    """Return the (F,) int32 group of each face as a copy, and the groups' names; None for absent groups or names.

    Raises:
        TypeError, ValueError: not one integer from 0 on, or one name, for each face.
        MemoryError: the rows up to the largest number need more memory than is free.
    """
    if groups is None:
        return None, None
    faces = len(mesh.faces)
    if isinstance(groups, str):
        return _group_by_part(mesh, groups)
    wants = f"({faces},) whole numbers from 0 to {_LARGEST} or names, one for each face, or 'part'"
    array = as_ndarray(groups, "groups", wants)
    if array.dtype.kind in "OT" and all(isinstance(name, str) for name in array.flat):  # as of pandas
        array = array.astype(object)
    elif array.dtype.kind not in "iuU":
        raise TypeError(f"groups: got dtype {array.dtype}, want {wants}")
    if array.shape != (faces,):
        raise ValueError(f"groups: got shape {array.shape}, want {wants}")
    if array.dtype.kind in "OU":  # a long name would lengthen all names of an array of texts
        names, rows = np.unique(array, return_inverse=True)
        return rows.astype(np.int32), tuple(names.tolist())
    if array.min() < 0 or array.max() > _LARGEST:
        raise ValueError(f"groups: got numbers from {array.min()} to {array.max()}, want {wants}")
    rows = int(array.max()) + 1
    check_memory(_BYTES * rows, f"groups: the rows of {rows:,} groups", "number the groups from 0 on without gaps")
    return array.astype(np.int32), None


def _group_by_part(mesh: Mesh, groups: str) -> tuple[np.ndarray, tuple[str, ...]]:
    """Group the faces by named part; return (number of each face's part, (F,) int32; names of the parts).

    Faces without a part get a group named "".
    """
    if groups != "part":
        raise ValueError(f"groups: got {quote(groups)}, want 'part', or an array with a number or a name for each face")
    if mesh.part is None:
        raise ValueError("groups: got 'part' for a mesh without named parts, want an array with a number for each face")
    apart = mesh.part < 0
    names = (*mesh.parts, "") if apart.any() else tuple(mesh.parts)
    return np.where(apart, len(mesh.parts), mesh.part).astype(np.int32), names
