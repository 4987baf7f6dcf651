"""Reader of .usd, .usda, .usdc and .usdz files, by usd-core in a separate process.

A single damaged byte can crash usd-core or make it use all memory.
"""

from collections.abc import Iterator
from importlib.util import find_spec
from pathlib import Path

import numpy as np

from warpsample.host.extras import REFUSED, missing, run_program
from warpsample.mesh.files.gltf import turn_normals
from warpsample.mesh.joining import joined_corners, joined_parts
from warpsample.mesh.parts import Named
from warpsample.mesh.usd_stage import NORMALS, UP

_PROGRAM = "from warpsample.mesh import usd_stage; usd_stage.main({file!r}, {what!r})"
_ASSETS = "from warpsample.mesh import usd_layers; usd_layers.write_names({file!r})"
_LONGEST = 200  # characters of an error message, which may quote an array of the file


def read(path: Path) -> Named:
    """Read vertices, faces and parts of all visible meshes of a USD file, instances included, at their earliest time.

    A part is a prim, named by its path; all instances of a point instancer form one part.

    Points, curves, invisible prims, guides, proxies and the holes of meshes are left out. A subdivision surface gives its
    control cage. An animated mesh gives its first pose, without skeletons.

    Raises:
        ModuleNotFoundError: usd-core is not installed; the message explains how to install it.
        ValueError: usd-core cannot open the file or a file that it refers to, or a surface is not a mesh, such as a sphere.
    """
    return joined_parts(_parts(_run_usd_stage(path)))


def read_corners(path: Path, number: int) -> np.ndarray:
    """Read the texture coordinates of a USD file at all face corners, (F, 3, 2) float64, v upward.

    Prims without the set have NaN. Set 0 is the primvar "st", or the first primvar by name. Errors are those of `read`.
    """
    return joined_corners(part[:3] for part in _parts(_run_usd_stage(path, str(number))))[..., :2]


def find_faces_with(path: Path, number: int) -> np.ndarray:
    """Return the (F,) bool mask of the faces whose prim has a set of texture coordinates, whatever its values."""
    corners = joined_corners(part[:3] for part in _parts(_run_usd_stage(path, str(number))))
    return np.isfinite(corners[..., 2]).all(axis=1)


def read_normals(path: Path) -> np.ndarray:
    """Read the normals of a USD file at all face corners, (F, 3, 3) float64, placed in the scene; NaN for prims without any.

    Errors are those of `read`.
    """
    parts = _parts(_run_usd_stage(path, NORMALS))
    with np.errstate(invalid="ignore"):
        return joined_corners((turn_normals(normals, matrix), faces, matrix) for normals, faces, matrix, _ in parts)


def read_up_axis(path: Path) -> str:
    """Read the axis that points up in a USD file, "Y" or "Z", with the errors of `read`."""
    return _run_usd_stage(path, UP).decode()


def list_assets(path: Path) -> list[str]:
    """Return the paths of all pictures, layers and other files that a USD file needs; none if it cannot be read."""
    if find_spec("pxr") is None:
        return []
    status, found = run_program(_ASSETS.format(file=str(path)))
    return [] if status else [name for name in found.decode(errors="surrogateescape").split("\0") if name]


def _run_usd_stage(path: Path, what: str = "") -> bytes:
    """Read a USD file in a separate process, since damaged files crash usd-core; return the process' output."""
    if find_spec("pxr") is None:
        raise missing(f"path: got {path.name!r}, which needs usd-core", "pxr")
    status, found = run_program(_PROGRAM.format(file=str(path), what=what))
    if status == REFUSED:
        reason = found.decode()
        raise ValueError(reason if len(reason) <= _LONGEST else f"{reason[: _LONGEST - 3]}...")
    if status:
        raise ValueError(f"usd-core ended with {status}: the file is damaged, or needs more memory than is free")
    return found


def _parts(found: bytes) -> Iterator[tuple[np.ndarray, np.ndarray, np.ndarray, str]]:
    """Yield (points, triangles, matrix, name) of each mesh, parsed from the output of the reading process."""
    at = 0

    def read_array(kind: type, rows: int, columns: int) -> np.ndarray:
        """Return the next (rows, columns) array of the output."""
        nonlocal at
        array = np.frombuffer(found, kind, rows * columns, at).reshape(rows, columns)
        at += array.nbytes
        return array

    while at < len(found):
        points, faces, name = read_array(np.int64, 1, 3)[0]
        arrays = read_array(np.float64, points, 3), read_array(np.int32, faces, 3), read_array(np.float64, 4, 4)
        yield *arrays, read_array(np.uint8, 1, name).tobytes().decode()
