"""Division of the reflecting faces of a mesh into patches with uniform radiosity, on both sides of each face."""

import warnings
from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property
from math import inf
from typing import Any

import numpy as np

from warpsample.directions.sample import sample_square
from warpsample.host.arguments import check_number
from warpsample.host.engine import check_memory
from warpsample.mesh.mesh import Mesh, lengths
from warpsample.mesh.surface import SurfacePoints
from warpsample.sequences.hashing import seed_for

_BYTES = 64  # per patch
_MOST_CUTS = 2**10  # parts per edge
_USUALLY_MORE = 2**13  # patches beyond the number of sides of reflecting faces


@dataclass(frozen=True, eq=False)
class Patches:
    """The N reflecting patches of a mesh: for each reflecting face the patches of its front, then of its back.

    Attributes:
        mesh: Mesh of the faces.
        cuts: (F,) int64, number of parts of each edge of a face; the face has the square of this number. 0 for faces that
            do not reflect.
        face: (N,) int64, face of each patch.
        back: (N,) bool, whether the patch is on the back of the face.
        part: (N,) int64, number of the part in the face, row by row away from the edge of the first and third corner.
    """

    mesh: Mesh
    cuts: np.ndarray
    face: np.ndarray
    back: np.ndarray
    part: np.ndarray

    def __len__(self) -> int:
        """Return the number of reflecting patches."""
        return len(self.face)

    @property
    def reflectance(self) -> np.ndarray:
        """Reflectance of each patch's face, (N,) float64."""
        return self.mesh.reflectance[self.face].astype(np.float64)

    def find_hit(
        self, face: np.ndarray, directions: np.ndarray, distance: np.ndarray, start: Callable[[np.ndarray], np.ndarray]
    ) -> np.ndarray:
        """Return the number of the patch that each of M rays hits, (M,) int32; -1 for no reflecting face.

        Args:
            face: (M,) face that each ray hits, -1 for none.
            directions: (M, 3) directions of the rays.
            distance: (M,) distance to the face.
            start: Function from the (K,) indices of rays to their (K, 3) float64 starts.
        """
        first, parts = (table[face] for table in self._tables)
        back = np.einsum("ij,ij->i", self.mesh.face_normals[face], directions) > 0.0
        found = first + back * parts
        cut = np.flatnonzero(parts > 1)
        if len(cut):
            places = start(cut) + distance[cut, None].astype(np.float64) * directions[cut]
            found[cut] += _part_at(self.mesh, face[cut], places, self.cuts[face[cut]])
        return found

    @cached_property
    def _tables(self) -> tuple[np.ndarray, np.ndarray]:
        """Number of each face's first patch, and number of patches on each side of the face, (F + 1,) int32 each.

        They are -1 and 0 for a face without patches, as in the last row.
        """
        parts = np.append(np.square(self.cuts), 0)
        first = np.cumsum(2 * parts) - 2 * parts
        return np.where(parts > 0, first, -1).astype(np.int32), parts.astype(np.int32)

    def places(self, count: int, seed: int) -> SurfacePoints:
        """Sample `count` random positions on each patch, patch by patch, uniform by area.

        Normals are those of the patch's side.
        """
        square = sample_square("fibonacci", len(self), count, seed=seed_for("places", seed)).astype(np.float64)
        square = np.where(square.sum(axis=2, keepdims=True) > 1.0, 1.0 - square, square).reshape(-1, 2)
        patch = np.repeat(np.arange(len(self)), count)
        face, cuts = self.face[patch], self.cuts[self.face[patch]]
        row, column, turned = _corner_of(self.part[patch], cuts)
        square = np.where(turned[:, None] == 1, 1.0 - square, square)
        along = (np.stack([row, column], axis=1) + square) / cuts[:, None]
        corner, first, second = (self.mesh.vertices[self.mesh.faces[face, k]] for k in range(3))
        position = corner + along[:, :1] * (first - corner) + along[:, 1:] * (second - corner)
        normal = np.where(self.back[patch, None], -1.0, 1.0).astype(np.float32) * self.mesh.face_normals[face]
        return SurfacePoints(position, normal, face.astype(np.int32))


def patches_of(mesh: Mesh, refine: Any) -> Patches | None:
    """Divide the reflecting faces of a mesh into patches with edges of at most `refine`; return None if no face reflects.

    Raises:
        TypeError, ValueError: `refine` is not a positive length, or divides an edge into too many parts.
        MemoryError: the patches need more memory than is free.

    Warns:
        UserWarning: faces at the same place have different reflectances.
    """
    longest = None if refine is None else check_number(refine, "refine", 1e-12, inf)
    if not mesh.reflects:
        return None
    _warn_of_layers(mesh)
    corners = mesh.vertices[mesh.faces]
    edges = np.max([lengths(corners[:, k] - corners[:, k - 1]) for k in range(3)], axis=0)
    edges = np.where((mesh.reflectance > 0.0) & (mesh.face_areas > 0.0), edges, 0.0)
    cuts = _count_cuts(edges, _choose_longest_edge(edges) if longest is None else longest)
    parts = np.square(cuts)
    total = 2 * int(parts.sum())
    largest = edges.max(initial=0.0)
    is_cut_short = longest is not None and largest > _MOST_CUTS * longest
    more = "more than " if is_cut_short else ""
    check_memory(_BYTES * total, f"refine: {more}{total:,} parts of faces that reflect", "pass a larger refine=")
    if is_cut_short:
        raise ValueError(
            f"refine: got {longest:g}, want at least {largest / _MOST_CUTS:.6g}: the longest edge, of {largest:.6g}, is cut "
            f"into at most {_MOST_CUTS:,} parts"
        )
    face = np.repeat(np.arange(len(cuts)), 2 * parts)
    rank = np.arange(total) - np.repeat(np.cumsum(2 * parts) - 2 * parts, 2 * parts)
    back = rank >= parts[face]
    return Patches(mesh, cuts, face, back, rank - back * parts[face])


def _warn_of_layers(mesh: Mesh) -> None:
    """Warn of faces at the same place with different reflectances, once for each mesh."""
    if "_layers" in vars(mesh):
        return
    layers = _count_layers(mesh)
    object.__setattr__(mesh, "_layers", layers)
    if layers:
        warnings.warn(
            f"mesh: {layers:,} pairs of faces are at the same place and have different reflectances; rays meet one face of "
            "each pair, from both sides: give both the same reflectance, or leave a gap",
            stacklevel=3,
        )


def _count_layers(mesh: Mesh) -> int:
    """Return the number of pairs of faces that have the same three corners and different reflectances."""
    share = mesh.reflectance
    if (share == share[0]).all():
        return 0
    corners = mesh.vertices[mesh.faces].astype(np.float64)
    weights = np.random.default_rng(0).random((3, 3))  # the sum over sorted corners is nearly unique
    key = (np.sort(corners, axis=1) * weights).sum(axis=(1, 2))
    order = np.argsort(key)
    one, other = order[:-1], order[1:]
    alike = (key[one] == key[other]) & (share[one] != share[other])
    one, other = corners[one[alike]], corners[other[alike]]
    return int((one[:, :, None] == other[:, None]).all(axis=3).any(axis=2).all(axis=1).sum())


def _count_cuts(edges: np.ndarray, longest: float) -> np.ndarray:
    """Return into how many parts each face's edges are cut so that no part is longer than `longest`, (F,) int64."""
    return np.where(edges > 0.0, np.clip(np.ceil(edges / longest), 1, _MOST_CUTS), 0).astype(np.int64)


def _choose_longest_edge(edges: np.ndarray) -> float:
    """Choose the longest edge of a patch so that dividing long faces adds about 8,192 patches.

    The faces with the longest edges are cut.
    """
    low, high = 0.0, float(edges.max(initial=1e-300))
    for _ in range(40):
        middle = 0.5 * (low + high)
        more = 2 * (np.square(_count_cuts(edges, max(middle, 1e-300))) - (edges > 0.0)).sum()
        low, high = (low, middle) if more <= _USUALLY_MORE else (middle, high)
    return high


def _part_at(mesh: Mesh, face: np.ndarray, places: np.ndarray, cuts: np.ndarray) -> np.ndarray:
    """Return the number of the part of a divided face that contains each position, (M,) int64."""
    corner, first, second = (mesh.vertices[mesh.faces[face, k]] for k in range(3))
    across, away = mesh.cross_products[face], places - corner
    area = np.einsum("ij,ij->i", across, across)
    u = cuts * np.einsum("ij,ij->i", np.cross(away, second - corner), across) / area
    v = cuts * np.einsum("ij,ij->i", np.cross(first - corner, away), across) / area
    row = np.clip(np.floor(u), 0, cuts - 1).astype(np.int64)
    column = np.clip(np.floor(v), 0, cuts - 1 - row).astype(np.int64)
    turned = (u - row + v - column > 1.0) & (row + column < cuts - 1)
    return row * (2 * cuts - row) + 2 * column + turned


def _corner_of(part: np.ndarray, cuts: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return the position of parts in a divided triangle: (row, column, 1 if the part points the other way)."""
    row = (cuts - np.ceil(np.sqrt(np.square(cuts) - part))).astype(np.int64)
    rest = part - row * (2 * cuts - row)
    return row, rest // 2, rest % 2
