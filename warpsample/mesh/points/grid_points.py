"""Points on regular grids, as sensors of radiation tools: above ground and floors, or on flat parts."""

from typing import Any

import numpy as np

from warpsample.host.arguments import check_choice, check_number, quote
from warpsample.host.arrays import as_unit
from warpsample.host.locks import multiply
from warpsample.host.neighbours import as_ndarray
from warpsample.mesh.flat_parts import axes_in_plane, flat_parts
from warpsample.mesh.mesh import Mesh, as_mesh
from warpsample.mesh.points.lattice import lattice_points
from warpsample.mesh.surface import SurfacePoints

_PLACES = ("ground", "faces")
_LEAST_UP = 0.17  # cosine of 80 degrees from up; steeper faces are walls
_CLOSE = 1e-9  # distance of crossings that count as one, relative to the mesh's diagonal


def grid_points(
    mesh: Any,
    spacing: float,
    *,
    height: float | None = None,
    on: str = "ground",
    faces: Any = None,
    up: Any = (0.0, 0.0, 1.0),
) -> SurfacePoints:
    """Return points on a regular grid at a height above ground, floors and roofs, or on every flat part of a mesh.

    On "ground", the grid is horizontal, at odd multiples of half the spacing, so that grids of neighbouring meshes fit
    together. Points lie above each surface that is inclined by less than 80 degrees. Left out are points with an obstacle
    between surface and point, and points inside bodies, where the next face above is seen from its back.
    On "faces", each flat part (neighbouring faces in one plane that share vertices) gets a grid in the middle of its
    bounding rectangle with a horizontal side. A flat part that the grid misses gets the centroid of its largest face.

    Args:
        mesh: Mesh or anything that `as_mesh` accepts.
        spacing: Distance of neighbouring grid points, a float in mesh units.
        height: Height above the ground or distance in front of the faces, a float in mesh units. Default: None, 1.5 above
            the ground and 0 in front of faces.
        on: "ground" or "faces". Default: "ground".
        faces: (F,) bool mask of the faces to put points above or on, such as `mesh.part == 2`. Default: None, all faces.
        up: (3,) vector that points up, of any length. Default: (0, 0, 1).

    Returns:
        SurfacePoints with position float64; normal, which is `up` or the normal of the face; and face, which is -1 unless
        the height is 0. Points are in order of rows.

    Raises:
        TypeError, ValueError: An argument that cannot be used; the message names the argument.
        MemoryError: The points do not fit into the free memory.

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
        raise ValueError("faces: got only faces without an area, want at least one face with an area")
    made = _above_ground if on == "ground" else _on_faces
    return made(mesh, spacing, height, chosen, upward)


def _check_faces(value: Any, faces: int) -> np.ndarray:
    """Return the (F,) bool mask of the selected faces; all faces for None."""
    if value is None:
        return np.ones(faces, bool)
    wants = f"({faces},) bool, one for each face"
    mask = as_ndarray(value, "faces", wants)
    if mask.dtype != bool:
        raise TypeError(f"faces: got {f'dtype {mask.dtype}' if mask.ndim else quote(value)}, want {wants}")
    if mask.shape != (faces,):
        raise ValueError(f"faces: got shape {mask.shape}, want {wants}")
    return mask


def _above_ground(mesh: Mesh, spacing: float, height: float, chosen: np.ndarray, upward: np.ndarray) -> SurfacePoints:
    """Return points at a height above the chosen faces, in a horizontal grid whose position does not depend on the mesh."""
    axes = np.stack(axes_in_plane(upward[None], upward))[:, 0]
    found = lattice_points((multiply(mesh.vertices, axes.T) / spacing - 0.5)[mesh.faces])
    corners = multiply(mesh.vertices, upward)[mesh.faces[found.triangle]]
    z = corners[:, 0] + (found.weights[:, 1:] * (corners[:, 1:] - corners[:, :1])).sum(axis=1)  # level faces stay level
    order = np.lexsort([found.triangle, z, found.place[:, 0], found.place[:, 1]])
    face, place, z = found.triangle[order], found.place[order], z[order]
    facing = multiply(mesh.face_normals[face].astype(np.float64), upward)
    kept = chosen[face] & (facing > _LEAST_UP)
    kept &= _is_free(place, z, facing, height, _CLOSE * mesh.diagonal)
    first = np.flatnonzero(kept)
    again = np.zeros(len(first), bool)  # the same crossing, found again by a face that shares an edge
    again[1:] = (place[first[1:]] == place[first[:-1]]).all(axis=1) & (np.diff(z[first]) <= _CLOSE * mesh.diagonal)
    rows = first[~again]
    position = multiply((place[rows] + 0.5) * spacing, axes) + (z[rows] + height)[:, None] * upward
    normal = np.tile(upward.astype(np.float32), (len(rows), 1))
    return SurfacePoints(position, normal, None if height else face[rows].astype(np.int32))


def _is_free(place: np.ndarray, z: np.ndarray, facing: np.ndarray, height: float, close: float) -> np.ndarray:
    """Return a mask of the grid points that are outside bodies and have free space above, (N,) bool.

    Crossings are sorted by column and height. A crossing is left out if another face is within `height` above, or if the
    next face above is seen from its back.
    """
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
    """Return points on a grid in the plane of each flat part of the chosen faces."""
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
