"""Points on regular grids, as sensors of radiation tools have them: above ground and floors, or on flat parts."""

from typing import Any

import numpy as np

from warpsample.host.arguments import check_choice, check_number, told
from warpsample.host.arrays import as_unit
from warpsample.host.neighbours import as_ndarray
from warpsample.mesh.flat_parts import axes_in_plane, flat_parts
from warpsample.mesh.mesh import Mesh, as_mesh
from warpsample.mesh.points.lattice import lattice_points
from warpsample.mesh.surface import SurfacePoints

_PLACES = ("ground", "faces")
_LEAST_UP = 0.17  # cosine: 80 degrees from up; what is steeper is a wall, not a ground
_CLOSE = 1e-9  # of the mesh's extent: crossings that are one


def grid_points(
    mesh: Any,
    spacing: float,
    *,
    height: float | None = None,
    on: str = "ground",
    faces: Any = None,
    up: Any = (0.0, 0.0, 1.0),
) -> SurfacePoints:
    """Points on a regular grid: at a height above what can be walked on, or on every flat part.

    Args:
        mesh: a Mesh or whatever `as_mesh` takes.
        spacing: of the grid, in the mesh's units.
        height: above the ground, 1.5 by default; or in front of the faces, 0 by default.
        on: "ground": a horizontal grid at odd multiples of half the spacing, so that grids of neighbouring meshes fit
            together, above each surface that looks up by less than 80 degrees: ground, floors and roofs. Left out is what
            has something within the height above it, or the back of a face as the first thing above: what is in a body.
            "faces": a grid in each flat part (neighbouring faces in a plane, by shared vertices), in the middle of its
            rectangle, which has a level side; the centre of its largest face if the grid misses it.
        faces: (F,) bool, those that points are above or on, such as `mesh.part == 2`; all by default.
        up: (3,), of any length; what is walked on is below.

    Returns:
        position float64; normal: up, or that of the face; face: that of each point at height 0, else -1; row by row.

    Raises:
        TypeError, ValueError: an argument that cannot be used; names it.
        MemoryError: more than is free.

    Example:
        >>> mesh = ws.load_mesh("courtyard")
        >>> points = ws.grid_points(mesh, 2.0, height=1.5)
        >>> print(len(points), points.position[0])
        1296 [1.  1.  1.5]
    """
    mesh, upward = as_mesh(mesh), np.array(as_unit(up, "up"))
    spacing = check_number(spacing, "spacing", 1e-12 * mesh.diagonal, 1e300)
    check_choice(on, "on", _PLACES)
    least, default = (-1e300, 0.0) if on == "faces" else (0.0, 1.5)
    height = default if height is None else check_number(height, "height", least, 1e300)
    chosen = (mesh.face_areas > 0.0) & _check_faces(faces, len(mesh.faces))
    if not chosen.any():
        raise ValueError("faces: got none that has an area, want at least one")
    made = _above_ground if on == "ground" else _on_faces
    return made(mesh, spacing, height, chosen, upward)


def _check_faces(value: Any, faces: int) -> np.ndarray:
    """Which faces are meant, (F,) bool."""
    if value is None:
        return np.ones(faces, bool)
    wants = f"({faces},) bool, one for each face"
    mask = as_ndarray(value, "faces", wants)
    if mask.dtype != bool:
        raise TypeError(f"faces: got {f'dtype {mask.dtype}' if mask.ndim else told(value)}, want {wants}")
    if mask.shape != (faces,):
        raise ValueError(f"faces: got shape {mask.shape}, want {wants}")
    return mask


def _above_ground(mesh: Mesh, spacing: float, height: float, chosen: np.ndarray, upward: np.ndarray) -> SurfacePoints:
    """Points at a height above the chosen faces, in columns of a lattice that all meshes have in common."""
    axes = np.stack(axes_in_plane(upward[None], upward))[:, 0]
    found = lattice_points((mesh.vertices @ axes.T / spacing - 0.5)[mesh.faces])
    corners = (mesh.vertices @ upward)[mesh.faces[found.triangle]]
    z = corners[:, 0] + (found.weights[:, 1:] * (corners[:, 1:] - corners[:, :1])).sum(axis=1)  # level faces stay level
    order = np.lexsort([found.triangle, z, found.place[:, 0], found.place[:, 1]])
    face, place, z = found.triangle[order], found.place[order], z[order]
    facing = mesh.face_normals[face].astype(np.float64) @ upward
    kept = chosen[face] & (facing > _LEAST_UP)
    kept &= _is_free(place, z, facing, height, _CLOSE * mesh.diagonal)
    first = np.flatnonzero(kept)
    again = np.zeros(len(first), bool)  # the same crossing, by a face that shares an edge
    again[1:] = (place[first[1:]] == place[first[:-1]]).all(axis=1) & (np.diff(z[first]) <= _CLOSE * mesh.diagonal)
    rows = first[~again]
    position = (place[rows] + 0.5) * spacing @ axes + (z[rows] + height)[:, None] * upward
    normal = np.tile(upward.astype(np.float32), (len(rows), 1))
    return SurfacePoints(position, normal, None if height else face[rows].astype(np.int32))


def _is_free(place: np.ndarray, z: np.ndarray, facing: np.ndarray, height: float, close: float) -> np.ndarray:
    """(N,) bool, of crossings in order: nothing within the height above, and no back of a face as the first thing there."""
    count = len(z)
    above = np.arange(1, count + 1)
    last = np.arange(count)
    while True:  # once for each further face that lies on another one, or shares an edge with it
        same = (above < count) & (place[np.minimum(above, count - 1)] == place).all(axis=1)
        step = same & (z[np.minimum(above, count - 1)] <= z + close)
        if not step.any():
            break
        above = above + step
    met = np.where(same, above, last)
    return ~same | ((z[met] > z + height) & (facing[met] < 0.0))


def _on_faces(mesh: Mesh, spacing: float, height: float, chosen: np.ndarray, upward: np.ndarray) -> SurfacePoints:
    """Points in the planes of the flat parts of the chosen faces."""
    rows = np.flatnonzero(chosen)
    part, x, y = flat_parts(mesh, rows, upward)
    triangles = (mesh.vertices - mesh.bounds.mean(axis=0))[mesh.faces[rows]]
    flat = np.stack([np.einsum("ncx,nx->nc", triangles, axis[part]) for axis in (x, y)], axis=2)
    low, high = np.full((2, len(x), 2), np.inf) * np.array([1.0, -1.0])[:, None, None]
    np.minimum.at(low, part, flat.min(axis=1))
    np.maximum.at(high, part, flat.max(axis=1))
    cells = np.maximum(np.floor((high - low) / spacing * (1.0 + 1e-12)), 1.0)
    start = low + (high - low - cells * spacing) / 2.0
    found = lattice_points((flat - start[part][:, None]) / spacing - 0.5)
    places = np.stack([part[found.triangle], found.place[:, 1], found.place[:, 0]], axis=1)
    _, once = np.unique(places, axis=0, return_index=True)  # a point on an edge is in two faces
    face, weights = rows[found.triangle[once]], found.weights[once]
    missed = np.setdiff1d(np.arange(len(x)), places[once, 0])
    largest = np.lexsort([-mesh.face_areas[rows], part])
    largest = rows[largest[np.searchsorted(part[largest], missed)]]
    face = np.concatenate([face, largest])
    weights = np.concatenate([weights, np.full((len(missed), 3), 1.0 / 3.0)])
    corners = mesh.vertices[mesh.faces[face]]
    normal = mesh.face_normals[face]
    inside = corners[:, 0] + np.einsum("nk,nkx->nx", weights[:, 1:], corners[:, 1:] - corners[:, :1])
    return SurfacePoints(
        inside + height * normal.astype(np.float64),
        normal.copy(),
        None if height else face.astype(np.int32),
        None if height else weights,
    )
