"""Mesh files: `load_mesh`, with one reader for each format.

A file is read whole or refused in one sentence, before memory is taken for what it declares and does not hold. No library
that we know keeps to that but usd-core; each reader says what others do. The tests are in `tests/mesh/test_mesh_files.py`.
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
    """The triangle mesh in a file: .ply .obj .stl .off .glb .gltf or, with usd-core, .usd .usda .usdc .usdz.

    Several meshes in one file become one, each where its scene places it, or its joints pose it (glTF); polygons are cut
    into triangles; of an .stl, whose faces share no corners, those of equal coordinates become one vertex. Coordinates keep
    all digits that the file holds.
    What it names is in `part` and `parts`: objects, groups and materials of an .obj, solids of an .stl, nodes, prims.
    A file that ends early is refused, but for what it does not tell: the end of an .obj between two of its lines, and of
    .obj, .off and .ply as text within the very last number; and numbers that were changed into others.
    "courtyard", where no file is called that, is an example: four buildings around a yard, in metres.

    Args:
        path: of the file, or "courtyard".
        transmittance: a number from 0 to 1, or (F,) of them, a face each: see `Mesh`.
        reflectance: likewise; with the transmittance at most 1.

    Returns:
        vertices in the file's coordinates and unit, float64, and faces, checked.

    Raises:
        TypeError: not a path, or shares that are no numbers.
        FileNotFoundError: no such file.
        ValueError: another suffix, no mesh in it, or a file that is truncated, damaged or of another format; names the path.
            Shares that no surface has.
        ModuleNotFoundError: a .usd file without usd-core; says how to install it.

    Example:
        >>> mesh = ws.load_mesh("courtyard")
        >>> print(mesh.vertices.shape, mesh.faces.shape, mesh.report.boundary_edges)
        (1089, 3) (2080, 3) 96
    """
    made = example(path)
    mesh = _read(path) if made is None else Mesh(*made)
    return as_mesh(mesh, transmittance=transmittance, reflectance=reflectance)


def _read(path: Any) -> Mesh:
    path = check_file(path, "path", "a mesh file")
    suffix = path.suffix.lower()
    if suffix not in _READERS:
        hint = "; warpsample.load_city reads CityJSON" if suffix in (".json", ".jsonl") else ""
        raise ValueError(f"path: got {path.name!r}, want a file that ends in one of {' '.join(SUFFIXES)}{hint}")
    with naming_file("path", path, "a mesh"):
        return Mesh(*_READERS[suffix](path))
