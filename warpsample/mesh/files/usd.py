"""Mesh files: .usd, .usda, .usdc and .usdz, by usd-core in a process of its own.

A changed byte lets usd-core end the process that it is in, or take all its memory.
"""

import sys
from collections.abc import Iterator
from importlib.util import find_spec
from pathlib import Path

import numpy as np

from warpsample.host.extras import REFUSED, missing, run_program
from warpsample.mesh.joining import joined_corners, joined_parts
from warpsample.mesh.parts import Named
from warpsample.mesh.usd_stage import UP

_PROGRAM = "import sys; sys.path[:] = {path!r}; from warpsample.mesh import usd_stage; usd_stage.main({file!r}, {what!r})"
_LONGEST = 200  # characters of a reason, which may quote an array of the file


def read(path: Path) -> Named:
    """Vertices and faces of all meshes that a renderer would show, with instances, at their earliest time.

    A part is a prim, by its path; the instances of a point instancer are one.

    Points, curves, invisible prims, guides and proxies are left out. A subdivision surface gives its cage, an animated mesh
    its first pose, without skeletons.

    Raises:
        ModuleNotFoundError: usd-core is missing; says how to install it.
        ValueError: a file that usd-core cannot open, or that refers to one; a surface that is no mesh, such as a sphere.
    """
    return joined_parts(_parts(_found(path)))


def read_corners(path: Path, number: int) -> np.ndarray:
    """(F, 3, 2) float64: a set of texture coordinates of the corners of `read`'s faces, v upward; NaN of prims without it.

    Number 0 is the primvar "st", or the first by name; the errors are those of `read`.
    """
    return joined_corners(part[:3] for part in _parts(_found(path, str(number))))[..., :2]


def read_up_axis(path: Path) -> str:
    """What a file says is up, as Y or Z, with the errors of `read`."""
    return _found(path, UP).decode()


def _found(path: Path, what: str = "") -> bytes:
    """What a process of `usd_stage` writes of a file."""
    if find_spec("pxr") is None:
        raise missing(f"path: got {path.name!r}, which needs usd-core", "pxr")
    status, found = run_program(_PROGRAM.format(path=sys.path, file=str(path), what=what))
    if status == REFUSED:
        reason = found.decode()
        raise ValueError(reason if len(reason) <= _LONGEST else f"{reason[: _LONGEST - 3]}...")
    if status:
        raise ValueError(f"usd-core ended with {status}: it is damaged, or needs more memory than is free")
    return found


def _parts(found: bytes) -> Iterator[tuple[np.ndarray, np.ndarray, np.ndarray, str]]:
    """Points, triangles, matrix and name of each mesh."""
    at = 0

    def taken(kind: type, rows: int, columns: int) -> np.ndarray:
        nonlocal at
        array = np.frombuffer(found, kind, rows * columns, at).reshape(rows, columns)
        at += array.nbytes
        return array

    while at < len(found):
        points, faces, name = taken(np.int64, 1, 3)[0]
        arrays = taken(np.float64, points, 3), taken(np.int32, faces, 3), taken(np.float64, 4, 4)
        yield *arrays, taken(np.uint8, 1, name).tobytes().decode()
