"""Texture coordinates of mesh files: `load_uv`, for the formats that hold some."""

from collections.abc import Callable
from os import PathLike
from pathlib import Path

import numpy as np

from warpsample.host.arguments import check_file, check_integer, naming_file
from warpsample.mesh.files import gltf, text, usd

LAST_SET = 255
"""The largest number of a set of texture coordinates that is asked for."""

_UPWARD = np.array((1.0, -1.0)), np.array((0.0, 1.0))


def _gltf(path: Path, number: int) -> np.ndarray:
    return gltf.read_corners(path, f"TEXCOORD_{number}")


def _obj(path: Path, number: int) -> np.ndarray:
    if number:
        raise ValueError(f"it has one set of texture coordinates, and set is {number}")
    return _downward(text.read_obj_uv(path))


def _usd(path: Path, number: int) -> np.ndarray:
    return _downward(usd.read_corners(path, number))


def _downward(uv: np.ndarray) -> np.ndarray:
    scale, shift = _UPWARD
    return uv * scale + shift


_READERS: dict[str, Callable[[Path, int], np.ndarray]] = {
    ".obj": _obj,
    **dict.fromkeys((".glb", ".gltf"), _gltf),
    **dict.fromkeys((".usd", ".usda", ".usdc", ".usdz"), _usd),
}

SUFFIXES = tuple(_READERS)
"""Suffixes of the files that hold texture coordinates."""


def load_uv(path: str | PathLike[str], *, set: int = 0) -> np.ndarray:
    r"""The texture coordinates of the faces that `load_mesh` reads from the same file.

    (0, 0) is the upper left corner of a picture and v points down, as glTF has it, whatever the format: those of .obj and
    USD, whose v points up, become 1 - v. They are as the file has them, from 0 to 1 or not: no KHR_texture_transform is in
    them.

    Args:
        path: of a .glb .gltf .obj or, with usd-core, a .usd .usda .usdc .usdz.
        set: which, from 0 on: TEXCOORD_0, TEXCOORD_1 ... of glTF; the one of .obj; of USD, set 0 is the primvar "st", and
            the others follow by name.

    Returns:
        (F, 3, 2) float64, u and v of the corners of each face; NaN of faces that have no such set.

    Raises:
        TypeError: not a path, or not a whole number.
        FileNotFoundError: no such file.
        ValueError: another suffix, a file that cannot be read, or in which no face has such a set; names the path.
        ModuleNotFoundError: a .usd file without usd-core; says how to install it.

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
            raise ValueError("it has no faces")
        if np.isnan(uv).all():
            raise ValueError(f"none of its faces has the set {set} of them")
        return uv
