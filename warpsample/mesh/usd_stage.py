"""Program that reads a file with usd-core in a separate process, because damaged files crash usd-core.

See `warpsample.mesh.files.usd`.
"""

import os
import struct
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np

from warpsample.host.extras import REFUSED
from warpsample.mesh.polygons import corner_triangles, triangles
from warpsample.mesh.usd_layers import describe_error, open_stage

try:
    import resource
except ModuleNotFoundError:  # Windows
    resource = None  # type: ignore[assignment]

UP, NORMALS = "up", "normals"
_TEXTURE_TYPES = ("texCoord2", "float2[", "double2[", "half2[")


def main(path: str, what: str = "") -> None:
    """Write the meshes in a USD file to stdout: for each mesh three lengths, points, triangles, matrix and name.

    With `what` "0", "1" ..., texture coordinates of that set replace the points, and with "normals" the normals. With "up",
    write only the axis that points up.
    """
    found = os.fdopen(os.dup(1), "wb")
    os.dup2(2, 1)  # whatever usd-core prints
    _limit_memory()
    try:
        parts = _read(Path(path), what)
    except Exception as error:
        found.write((str(error) if isinstance(error, ValueError) else f"{error} ({type(error).__name__})").encode())
        found.close()
        sys.exit(REFUSED)
    if isinstance(parts, str):
        found.write(parts.encode())
        parts = []
    for points, faces, matrix, name in parts:
        found.write(struct.pack("<qqq", len(points), len(faces), len(name)))
        for array, kind in ((points, np.float64), (faces, np.int32), (matrix, np.float64)):
            found.write(np.ascontiguousarray(array, kind).data)
        found.write(name)
    found.close()


def _limit_memory() -> None:
    """Limit this process to half of the free memory, because the caller makes a copy, and disable core dumps."""
    if resource is None:
        return
    import psutil

    resource.setrlimit(resource.RLIMIT_DATA, (psutil.virtual_memory().available // 2,) * 2)
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))


def _read(path: Path, what: str) -> list[tuple[np.ndarray, np.ndarray, np.ndarray, bytes]] | str:
    """Read one kind of data from a USD file, see `main`: meshes, a set of texture coordinates, normals, or the up axis."""
    from pxr import Tf, UsdGeom

    try:
        stage = open_stage(path)
        return str(UsdGeom.GetStageUpAxis(stage)) if what == UP else list(_parts(stage, what))
    except Tf.ErrorException as error:
        raise ValueError(describe_error(error, path)) from None


def _parts(stage: Any, what: str) -> Iterator[tuple[np.ndarray, np.ndarray, np.ndarray, bytes]]:
    """Yield (points, texture coordinates or normals, triangles, matrix, name) of each visible mesh."""
    from pxr import Usd, UsdGeom

    first = Usd.TimeCode.EarliestTime()
    placements, predicate = UsdGeom.XformCache(first), Usd.PrimDefaultPredicate
    for prim, matrix, path in _surfaces(stage.GetPseudoRoot(), np.eye(4), placements, predicate):
        mesh = UsdGeom.Mesh(prim)
        points, counts, indices = (
            np.array(attribute.Get(first) or (), kind)
            for attribute, kind in (
                (mesh.GetPointsAttr(), np.float64),
                (mesh.GetFaceVertexCountsAttr(), np.int64),
                (mesh.GetFaceVertexIndicesAttr(), np.int32),
            )
        )
        if len(counts):
            points = points.reshape(-1, 3)
            if not what:
                faces = triangles(points, counts, indices)
            else:
                faces = corner_triangles(points, counts, indices)
                points = _normals(prim, counts, indices) if what == NORMALS else _uv(prim, int(what), counts, indices)
            holes = np.array(mesh.GetHoleIndicesAttr().Get(first) or (), np.int64)
            faces = faces[np.repeat(~np.isin(np.arange(len(counts)), holes), counts - 2)]
            is_left_handed = mesh.GetOrientationAttr().Get(first) == UsdGeom.Tokens.leftHanded
            yield points, faces[:, ::-1] if is_left_handed else faces, matrix, str(path).encode()


def _uv(prim: Any, number: int, counts: np.ndarray, indices: np.ndarray) -> np.ndarray:
    """Return (K, 3) texture coordinates u, v, 0 at the corners of a mesh's polygons; NaN if the mesh lacks the set.

    Sets are numbered from 0: "st" first, the others by name.
    """
    from pxr import UsdGeom

    primvars = UsdGeom.PrimvarsAPI(prim).FindPrimvarsWithInheritance()
    sets = [p for p in primvars if p.HasValue() and str(p.GetTypeName()).startswith(_TEXTURE_TYPES)]
    if number >= len(sets):
        return np.full((len(indices), 3), np.nan)
    found = sorted(sets, key=lambda primvar: (primvar.GetPrimvarName() != "st", primvar.GetPrimvarName()))[number]
    values = _flattened(found, "texture coordinates").reshape(-1, 2)
    if not len(values):  # some exporters write an empty array
        return np.full((len(indices), 3), np.nan)
    corners = _at_corners(
        values, found.GetInterpolation(), counts, indices, f"primvar {found.GetAttr().GetPath()}", "texture coordinates"
    )
    return np.pad(corners, ((0, 0), (0, 1)))


def _normals(prim: Any, counts: np.ndarray, indices: np.ndarray) -> np.ndarray:
    """Return (K, 3) normals at the corners of a mesh's polygons, NaN without any; the primvar comes before the attribute."""
    from pxr import Usd, UsdGeom

    first, mesh = Usd.TimeCode.EarliestTime(), UsdGeom.Mesh(prim)
    primvar = UsdGeom.PrimvarsAPI(prim).GetPrimvar("normals")
    has_primvar = bool(primvar) and primvar.HasValue()
    found = _flattened(primvar, "normals") if has_primvar else np.array(mesh.GetNormalsAttr().Get(first) or (), np.float64)
    how = primvar.GetInterpolation() if has_primvar else mesh.GetNormalsInterpolation()
    values = found.reshape(-1, 3)
    if not len(values):
        return np.full((len(indices), 3), np.nan)
    return _at_corners(values, how, counts, indices, f"prim {prim.GetPath()}", "normals")


def _flattened(primvar: Any, kind: str) -> np.ndarray:
    """Return the values of a primvar in the order of its indices; errors name the prim and the kind of values."""
    from pxr import Usd

    first = Usd.TimeCode.EarliestTime()
    values, indices = np.array(primvar.Get(first) or (), np.float64), np.array(primvar.GetIndices(first), np.int64)
    if not primvar.IsIndexed():
        return values
    if len(indices) and not 0 <= indices.min() <= indices.max() < len(values):
        span = f"indices {indices.min()} to {indices.max()}"
        raise ValueError(
            f"the prim {primvar.GetAttr().GetPrim().GetPath()} has {kind} with {span}, want 0 to {len(values) - 1}"
        )
    return values[indices]


def _at_corners(values: np.ndarray, how: Any, counts: np.ndarray, indices: np.ndarray, *names: str) -> np.ndarray:
    """Return values of the interpolation `how` at the corners of a mesh's polygons; errors name their owner and kind."""
    from pxr import UsdGeom

    each = {
        UsdGeom.Tokens.constant: np.zeros(len(indices), np.int64),
        UsdGeom.Tokens.uniform: np.repeat(np.arange(len(counts)), counts),
        UsdGeom.Tokens.faceVarying: np.arange(len(indices)),
    }.get(how, indices)
    if each.max(initial=0) >= len(values):
        raise ValueError(f"the {names[0]} has {len(values):,} {names[1]}, want {each.max() + 1:,}")
    return values[each]


def _surfaces(root: Any, above: np.ndarray, placements: Any, predicate: Any) -> Iterator[tuple[Any, np.ndarray, Any]]:
    """Yield the meshes at or below `root` that match `predicate`, each with its matrix and path.

    `above` is the matrix of the parent of `root`.
    """
    from pxr import Usd, UsdGeom

    prims = iter(Usd.PrimRange(root, Usd.TraverseInstanceProxies(predicate)))
    for prim in prims:
        shape = UsdGeom.Imageable(prim)
        if shape and shape.GetVisibilityAttr().Get(placements.GetTime()) == UsdGeom.Tokens.invisible:
            prims.PruneChildren()
            continue
        if not prim.IsA(UsdGeom.Boundable) or shape.ComputePurpose() in (UsdGeom.Tokens.guide, UsdGeom.Tokens.proxy):
            continue
        matrix = np.array(placements.ComputeRelativeTransform(prim, root)[0]) @ above
        if prim.IsA(UsdGeom.PointInstancer):
            prims.PruneChildren()
            yield from ((*placed, prim.GetPath()) for placed in _instances(prim, matrix, placements))
        elif prim.IsA(UsdGeom.Mesh):
            yield prim, matrix, prim.GetPath()
        elif prim.IsA(UsdGeom.Gprim) and not prim.IsA(UsdGeom.Curves) and not prim.IsA(UsdGeom.Points):
            raise ValueError(
                f"the prim {prim.GetPath()} is a {prim.GetTypeName()}, want only meshes; convert the shape to a mesh"
            )


def _instances(prim: Any, above: np.ndarray, placements: Any) -> Iterator[tuple[Any, np.ndarray]]:
    """Yield the meshes of a point instancer with their matrices: each prototype at each of its visible positions."""
    from pxr import Usd, UsdGeom

    are_drawn = Usd.PrimIsActive & Usd.PrimIsLoaded & ~Usd.PrimIsAbstract  # prototypes may be below an `over`
    instancer, time = UsdGeom.PointInstancer(prim), placements.GetTime()
    matrices = instancer.ComputeInstanceTransformsAtTime(time, time, applyMask=UsdGeom.PointInstancer.IgnoreMask)
    is_shown = instancer.ComputeMaskAtTime(time) or [True] * len(matrices)
    prototypes = [prim.GetStage().GetPrimAtPath(path) for path in instancer.GetPrototypesRel().GetForwardedTargets()]
    for matrix, number, shown in zip(matrices, instancer.GetProtoIndicesAttr().Get(time), is_shown, strict=True):
        if shown:
            found = _surfaces(prototypes[number], np.array(matrix) @ above, placements, are_drawn)
            yield from ((prim, placed) for prim, placed, _ in found)
