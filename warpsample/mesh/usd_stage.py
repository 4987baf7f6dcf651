"""Program that reads a file with usd-core in a separate process, because damaged files crash usd-core.

See `warpsample.mesh.files.usd`.
"""

import os
import struct
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any
from zipfile import ZipFile

import numpy as np

from warpsample.host.extras import REFUSED
from warpsample.mesh.polygons import corner_triangles, triangles

try:
    import resource
except ModuleNotFoundError:  # Windows
    resource = None  # type: ignore[assignment]

UP, NORMALS = "up", "normals"
_TWO_COUNTS = ("TOKENS", "PATHS")
"""Sections of a binary file that begin with two counts, where others begin with one."""
_TEXTURE_TYPES = ("texCoord2", "float2[", "double2[", "half2[")
_MOST_OF_BYTE = 1020
"""Largest number of entries per byte of a section: LZ4 expands a byte to 255 bytes, each of which codes four numbers."""


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
        stage = _open(path)
        return str(UsdGeom.GetStageUpAxis(stage)) if what == UP else list(_parts(stage, what))
    except Tf.ErrorException as error:
        raise ValueError(_describe_error(error, path)) from None


def _open(path: Path) -> Any:
    """Open a file as a USD stage; raise a ValueError for damaged archives and missing references."""
    from pxr import Usd

    if path.suffix.lower() == ".usdz":
        with ZipFile(path) as archive:
            damaged = archive.testzip()  # by checksums that usd-core ignores
        if damaged:
            raise ValueError(f"the file {damaged} in the archive is damaged")
    layers = _layers(path)  # kept, so that each file is read once
    stage = Usd.Stage.Open(layers[0])
    lost = stage.GetCompositionErrors()
    if lost:
        raise ValueError(str(lost[0]))
    return stage


def _layers(path: Path) -> list[Any]:
    """Load and return the layers of a file and of all existing files that it refers to, directly or not.

    Missing files become composition errors of the stage.

    Raises:
        ValueError: A reference to a device or a pipe, for which usd-core would wait forever.
    """
    layers = {str(path): _layer(path)}
    left = [layers[str(path)]]
    while left:
        layer = left.pop()
        for name in map(layer.ComputeAbsolutePath, filter(None, layer.GetCompositionAssetDependencies())):
            file = Path(name)
            if file.exists() and not file.is_file():
                raise ValueError(f"the file refers to {name!r}, which is no ordinary file")
            if file.is_file() and name not in layers:
                layers[name] = _layer(file)
                left.append(layers[name])
    return list(layers.values())


def _layer(path: Path) -> Any:
    """Load one file as a layer, after a check of its sections."""
    from pxr import Sdf

    _check_sections(path)
    return Sdf.Layer.FindOrOpen(str(path))


def _check_sections(path: Path) -> None:
    """Raise a ValueError if a binary USD file is shorter than the sections that it declares.

    usd-core would allocate memory of the declared size.
    """
    size = path.stat().st_size
    with path.open("rb") as file:
        header = file.read(24)
        if header[:8] != b"PXR-USDC":
            return
        start = int.from_bytes(header[16:], "little")
        file.seek(min(start, size))
        sections = int.from_bytes(file.read(8), "little")
        if start + 8 + 32 * sections > size:
            raise ValueError(
                f"the header declares {sections:,} sections from byte {start:,} on, but the file has {size:,} bytes"
            )
        compressed = tuple(header[8:11]) >= (0, 4, 0)
        for padded, first, length in struct.iter_unpack("<16sQQ", file.read(32 * sections)):
            name = padded.rstrip(b"\0").decode("ascii", "replace")
            if first + length > size:
                raise ValueError(f"the section {name!r} ends beyond the {size:,} bytes of the file")
            file.seek(first)
            _check_counts(name, file.read(8 * (2 if compressed and name in _TWO_COUNTS else 1)), length)


def _check_counts(section: str, counts: bytes, length: int) -> None:
    """Raise a ValueError if a section of `length` bytes is too short for its declared entries.

    `counts` are the entry counts at its beginning, 8 bytes each.
    """
    for at in range(0, length and len(counts), 8):
        declared = int.from_bytes(counts[at : at + 8], "little")
        if declared > _MOST_OF_BYTE * length:
            raise ValueError(f"the section {section!r} declares {declared:,} entries, too many for {length:,} bytes")


def _describe_error(error: Any, path: Path) -> str:
    """Return the first line of a usd-core error, without the path and the name of its parser."""
    try:
        reason = error.args[0].commentary.strip().partition("\n")[0]
    except UnicodeDecodeError:  # it quotes the damaged bytes
        return "the file is damaged"
    for quoted, plain in ((f"{path}:", "line "), (f"<{path}>", "the file"), (f" @{path}@", "")):
        reason = reason.replace(quoted, plain)
    return reason.partition(" matching ")[0]


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
