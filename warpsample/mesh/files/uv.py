"""Reader of texture coordinates, `load_uv`, for mesh formats that have some."""

from collections.abc import Callable
from os import PathLike
from pathlib import Path

import numpy as np

from warpsample.host.arguments import check_file, check_integer, naming_file
from warpsample.mesh.files import gltf, ply, text, usd

LAST_SET = 255
"""Largest index of a set of texture coordinates."""


class MissingSetError(ValueError):
    """Error for a set of texture coordinates that no face of a file has, or that is NaN at all faces."""


_UPWARD = np.array((1.0, -1.0)), np.array((0.0, 1.0))


def _gltf(path: Path, number: int) -> np.ndarray:
    """Read one set of texture coordinates, TEXCOORD_n, of a glTF file."""
    return gltf.read_corners(path, f"TEXCOORD_{number}")


def _obj(path: Path, number: int) -> np.ndarray:
    """Read the texture coordinates of an .obj, with v downward."""
    if number:
        raise MissingSetError(f"an .obj file has only set 0 of texture coordinates, but set={number}")
    return _downward(text.read_obj_uv(path))


def _ply(path: Path, number: int) -> np.ndarray:
    """Read the texture coordinates of a .ply's vertices, with v downward."""
    names = find_ply_names(path, number)
    found = None if names is None else ply.read_corners(path, names)
    if found is None:
        raise MissingSetError(f"no vertex of the file has set {number} of texture coordinates, such as s and t")
    return _downward(found)


def find_ply_names(path: Path, number: int) -> tuple[str, str] | None:
    """Return the names of the vertex properties of a .ply file that hold set `number`, or None without the set."""
    known = set() if number else ply.read_names(path)
    return next((names for names in (("s", "t"), ("u", "v"), ("texture_u", "texture_v")) if set(names) <= known), None)


def _usd(path: Path, number: int) -> np.ndarray:
    """Read a set of texture coordinates of a USD file, with v downward."""
    return _downward(usd.read_corners(path, number))


def _downward(uv: np.ndarray) -> np.ndarray:
    """Return texture coordinates with v replaced by 1 - v, to convert between v upward and v downward."""
    scale, shift = _UPWARD
    return uv * scale + shift


_READERS: dict[str, Callable[[Path, int], np.ndarray]] = {
    ".obj": _obj,
    ".ply": _ply,
    **dict.fromkeys((".glb", ".gltf"), _gltf),
    **dict.fromkeys((".usd", ".usda", ".usdc", ".usdz"), _usd),
}

SUFFIXES = tuple(_READERS)
"""Suffixes of the files that `load_uv` reads."""


def load_uv(path: str | PathLike[str], *, set: int = 0) -> np.ndarray:
    r"""Read the texture coordinates of the faces that `load_mesh` reads from the same file.

    (0, 0) is the upper left corner of a picture and v points down, as in glTF, for all formats: v of .obj, .ply and USD
    files, which points up, becomes 1 - v. Coordinates may be outside 0 to 1. KHR_texture_transform is not applied.

    Args:
        path: Path of a .glb, .gltf, .obj or .ply or, with usd-core, a .usd, .usda, .usdc or .usdz.
        set: Index of the set of coordinates, an integer from 0: TEXCOORD_0, TEXCOORD_1 ... in glTF; an .obj or .ply has only
            set 0; in USD, set 0 is the primvar "st" and the others follow by name. In a .ply, set 0 consists of the vertex
            properties s and t, u and v, or texture_u and texture_v. Default: 0.

    Returns:
        (F, 3, 2) float64, u and v at the corners of each face; NaN for faces without the set.

    Raises:
        TypeError: `path` is not a path, or `set` not an integer.
        FileNotFoundError: The file does not exist.
        ValueError: Another suffix, a file that cannot be read, or no face with the set; the message names the path.
        ModuleNotFoundError: A .usd file without usd-core; the message explains how to install it.

    Example:
        >>> import pathlib, tempfile
        >>> path = pathlib.Path(tempfile.mkdtemp(), "triangle.obj")
        >>> _ = path.write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nf 1/1 2/2 3/3\n")
        >>> print(ws.load_uv(path).tolist())
        [[[0.0, 1.0], [1.0, 1.0], [0.0, 0.0]]]
    """
    set = check_integer(set, "set", 0, LAST_SET)
    path = check_file(path, "path", "a mesh file")
    reader = _READERS.get(path.suffix.lower())
    if reader is None:
        raise ValueError(
            f"path: got {path.name!r}, want a file that ends in one of {' '.join(_READERS)}, which hold textures"
        )
    with naming_file("path", path, "a mesh with texture coordinates"):
        uv = reader(path, set)
        if not len(uv):
            raise ValueError("the file has no faces")
        if np.isnan(uv).all():
            raise MissingSetError(f"no face of the file has set {set} of texture coordinates")
        return uv


def find_uv(path: Path) -> np.ndarray | None:
    """Return the texture coordinates of a mesh file, set 0, as `load_uv` does; None for a file without coordinates.

    Raises:
        ValueError: the coordinates cannot be read.
    """
    if path.suffix.lower() not in SUFFIXES:
        return None
    try:
        return load_uv(path)
    except ValueError as error:
        if isinstance(error.__cause__, MissingSetError):
            return None
        raise
