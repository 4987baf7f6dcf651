"""The call `load_mesh`, with one reader for each format of mesh files.

A reader reads a file completely or raises an error of one sentence. It compares declared sizes with the size of the file
before it allocates memory. Of the libraries known to us only usd-core does so; each reader's page lists the failures of
others. Tests are in `tests/mesh/test_mesh_files.py`.
"""

from os import PathLike
from typing import Any

from warpsample.host.arguments import check_file, naming_file
from warpsample.mesh.examples import example
from warpsample.mesh.files import gltf, ply, stl, text, usd
from warpsample.mesh.mesh import Mesh, as_mesh

_READERS = {
    ".ply": ply.read,
    ".obj": text.read_obj,
    ".stl": stl.read,
    ".off": text.read_off,
    **dict.fromkeys((".glb", ".gltf"), gltf.read),
    **dict.fromkeys((".usd", ".usda", ".usdc", ".usdz"), usd.read),
}
SUFFIXES = tuple(_READERS)
"""Suffixes of the files that `load_mesh` reads."""


def load_mesh(path: str | PathLike[str], *, transmittance: Any = None, reflectance: Any = None) -> Mesh:
    """Read the triangle mesh in a file: .ply .obj .stl .off .glb .gltf or, with usd-core, .usd .usda .usdc .usdz.

    Several meshes in one file are joined into one, each as its scene places it, or as its joints pose it (glTF). Polygons
    are cut into triangles. Corners of an .stl with equal coordinates become one vertex. Coordinates keep all digits of the
    file. Names become `part` and `parts`: objects, groups and materials of an .obj, solids of an .stl, nodes of a glTF,
    prims of USD. "courtyard", if no file has that name, is an example: four buildings around a yard, in metres.

    A truncated file raises an error, with these exceptions, because the remaining text is valid:

    - an .obj that ends between two lines, or within its last line, such as after three of five corners of a face;
    - a text .stl that ends between two solids, or within the name after `endsolid`;
    - an .obj, .off or text .ply that ends within its very last number.

    Changed numbers are not detected, either.

    Args:
        path: Path of the file, or "courtyard".
        transmittance: A number from 0 to 1, or (F,) of them, one per face; see `Mesh`. Default: None, opaque faces.
        reflectance: A number from 0 to 1, or (F,) of them, one per face; see `Mesh`. The sum with the transmittance is at
            most 1. Default: None, black faces.

    Returns:
        A checked mesh with float64 vertices in the coordinates and unit of the file.

    Raises:
        TypeError: `path` is not a path, or optical properties are not numbers.
        FileNotFoundError: The file does not exist.
        ValueError: Another suffix, no mesh in the file, or a file that is truncated, damaged or of another format; the
            message names the path. Also optical properties outside 0 to 1 or with a sum above 1.
        ModuleNotFoundError: A .usd file without usd-core; the message explains how to install it.

    Example:
        >>> mesh = ws.load_mesh("courtyard")
        >>> print(mesh.vertices.shape, mesh.faces.shape, mesh.report.boundary_edges)
        (1089, 3) (2080, 3) 96
    """
    made = example(path)
    mesh = _read(path) if made is None else Mesh(*made)
    return as_mesh(mesh, transmittance=transmittance, reflectance=reflectance)


def _read(path: Any) -> Mesh:
    """Read a mesh file with the reader of its suffix."""
    path = check_file(path, "path", "a mesh file")
    suffix = path.suffix.lower()
    if suffix not in _READERS:
        hint = "; warpsample.load_city reads CityJSON" if suffix in (".json", ".jsonl") else ""
        raise ValueError(f"path: got {path.name!r}, want a file that ends in one of {' '.join(SUFFIXES)}{hint}")
    with naming_file("path", path, "a mesh"):
        return Mesh(*_READERS[suffix](path))
