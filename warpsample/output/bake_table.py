"""Table of all options of `warpsample bake`, with the inputs and output formats to which each option applies.

The checks, the error messages, the help page and the test of all combinations follow from this table.
"""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Literal

from warpsample import sequences
from warpsample.mesh.files import SUFFIXES

MESH, CITY, RASTER, TEXTURE = SOURCES = ("meshes", "CityJSON", "rasters", "textures (--texture)")
"""Kinds of sources; `TEXTURE` is a mesh with the option `--texture`."""

RASTER_SUFFIXES = (".tif", ".tiff", ".vrt", ".asc", ".nc", ".nc4", ".img", ".jp2", ".bil")
"""Suffixes of usual rasters of heights; others are known by an output that is a .tif."""

STORE = ".zarr"
_MESH_FILES = (".ply", ".vtp", ".glb", ".npz", ".csv", ".png", ".mtx")
_CITY_FILES, _GLTF, _TIFF = (".json", ".jsonl"), (".glb", ".gltf"), (".tif", ".tiff")

FILES: dict[str, tuple[str, ...]] = {
    MESH: (*_MESH_FILES, STORE),
    CITY: (*_CITY_FILES, *_MESH_FILES),
    RASTER: (*_TIFF, ".png", STORE),
    TEXTURE: (*_GLTF, ".png", ".exr", ".npz"),
}
"""Suffixes of the files that `bake` writes, by kind of source."""

MEAN_FILES: dict[str, tuple[str, ...]] = {MESH: (".csv",), CITY: (*_CITY_FILES, ".csv", ".png")}
"""Suffixes of the files that hold or show means over parts, by kind of source."""

MATRIX_FILES = (".npz", ".mtx")
"""Suffixes of the files that hold many values per point."""

COMPUTE, WHERE, LIGHT, RUN = "What to compute", "Where", "Light", "Run"
_CITY_PANEL, _RASTER_PANEL, _TEXTURE_PANEL, _STORE_PANEL = "CityJSON", "Rasters of heights", "Textures", "Zarr stores"
PANELS = (COMPUTE, WHERE, LIGHT, _CITY_PANEL, _RASTER_PANEL, _TEXTURE_PANEL, _STORE_PANEL, RUN)
"""Panels of the help page, in order."""


@dataclass(frozen=True)
class Option:
    """Description of one option of `warpsample bake`: type, help text, and where the option applies.

    Attributes:
        kind: Type of a given value.
        panel: Panel of the help page.
        words: Help text, without the sources, files and quantities to which the option applies.
        where: Suffixes of the outputs to which the option applies, by kind of source.
        by_quantity: Whether the records of the quantities state to which quantities the option applies.
        needs: Option that a quantity must have for this option to apply, or "".
    """

    kind: Any
    panel: str
    words: str
    where: Mapping[str, tuple[str, ...]] = field(default_factory=FILES.copy)
    by_quantity: bool = False
    needs: str = ""


def _on(*sources: str, only: tuple[str, ...] = (), but: tuple[str, ...] = ()) -> dict[str, tuple[str, ...]]:
    """Return the output suffixes to which an option applies, for each of the given kinds of input."""
    return {
        source: tuple(suffix for suffix in FILES[source] if suffix not in but and (not only or suffix in only))
        for source in sources
    }


def _of_quantities(kind: Any, panel: str, words: str, *sources: str) -> Option:
    """Build the table row of an option that applies only to some quantities."""
    return Option(kind, panel, words, _on(*(sources or SOURCES)), by_quantity=True)


_MESHES = (MESH, CITY, TEXTURE)

OPTIONS: dict[str, Option] = {
    "quantity": Option(str, COMPUTE, ""),
    "samples": _of_quantities(int, COMPUTE, "Number of rays per point"),
    "tolerance": _of_quantities(
        float,
        COMPUTE,
        "Standard error to reach (root mean square over the points), such as 0.01. --samples is then the largest number of "
        "rays per point",
    ),
    "max_distance": _of_quantities(
        float, COMPUTE, "Length of the rays, in units of the mesh; geometry further away is ignored. Default: no limit"
    ),
    "falloff": _of_quantities(
        float,
        COMPUTE,
        "Exponent that makes distant hits occlude less, such as 1: a hit at distance d occludes by "
        "(1 - d / max-distance)^falloff. Needs --max-distance. Default: every hit occludes fully",
    ),
    "sequence": _of_quantities(
        str, COMPUTE, f"Sequence of random or evenly spread sample points: {', '.join(sequences.names())}"
    ),
    "seed": Option(int, COMPUTE, "Seed of the random points and rays. Default: 0."),
    "points": Option(
        int,
        WHERE,
        "Number of points, placed uniformly by area. Default: the locations of --at.",
        _on(MESH, CITY, but=(".ply", ".glb")),
    ),
    "at": Option(
        Literal["vertices", "faces"],
        WHERE,
        "Compute at the vertices or at the centres of the faces. Default without --points: vertices; faces for a .png and "
        "for CityJSON written as a mesh; random points for means over parts and surfaces.",
        _on(MESH, CITY),
    ),
    "by": Option(
        Literal["part"],
        WHERE,
        "Write the mean over each named part of the mesh, one row per part.",
        MEAN_FILES,
    ),
    "weather": _of_quantities(Path, LIGHT, "Weather file of a year, .epw, or athens for the built-in example"),
    "period": _of_quantities(
        tuple[str, str],
        LIGHT,
        "First and last day of the period, such as 06-01 08-31, or with hours, 03-21T09 03-21T15. Default: the whole year",
    ),
    "environment": _of_quantities(
        Path,
        LIGHT,
        "Picture of the light from all directions, in equirectangular projection: .hdr or .npy. Row 0 is about --up",
    ),
    "sampling": _of_quantities(
        Literal["cosine", "picture", "both"],
        LIGHT,
        "Directions of the rays: of the cosine lobe, by the luminance of the picture, or of both. Default: both",
    ),
    "patches": _of_quantities(
        str, LIGHT, "Division of the sky into patches: tregenza (145), reinhart2 (577) or reinhart4 (2,305)"
    ),
    "up": _of_quantities(
        tuple[float, float, float],
        LIGHT,
        "Direction from the ground to the zenith; 0 1 0 for .glb, .gltf and USD files with +y up",
        *_MESHES,
    ),
    "north": _of_quantities(tuple[float, float, float], LIGHT, "Direction of north; 0 0 -1 for files with +y up", *_MESHES),
    "ground_albedo": _of_quantities(float, LIGHT, "Fraction of light that the ground around the mesh reflects, 0 to 1"),
    "reflectance": Option(
        str,
        LIGHT,
        "Fraction of light that faces reflect, 0 to 1: a number, NAME.npy with one number per face, or numbers by part, "
        "such as wall=0.3,roof=0.1. Default: 0.",
        _on(*_MESHES),
        needs="refine",
    ),
    "refine": _of_quantities(
        float,
        LIGHT,
        "Longest edge of the parts into which faces are divided for reflected light, in units of the mesh. Default: the "
        "longest edges are cut, into 8,192 more parts. Needs --reflectance",
        *_MESHES,
    ),
    "transmittance": Option(
        str,
        LIGHT,
        "Fraction of light that faces transmit, 0 to 1: a number, NAME.npy with one number per face, or numbers by part, "
        "such as leaf=0.2,glass=0.8. Default: 0. For a raster, the fraction that tree crowns transmit, or 12 for the months "
        "or 365 for the days, separated by commas or blanks. Default: 0.03.",
    ),
    "lod": Option(str, _CITY_PANEL, "Level of detail to read, such as 2.2. Default: the highest of each object.", _on(CITY)),
    "split": Option(bool, _CITY_PANEL, "Write one result per polygon, instead of one per semantic surface.", _on(CITY)),
    "context": Option(
        str,
        _CITY_PANEL,
        "Terrain around the model: ground for a level plane, or the path of a mesh or raster.",
        _on(CITY),
    ),
    "model": Option(
        Literal["joined", "block", "tin"],
        _RASTER_PANEL,
        "Surface through the heights: joined (walls at steps), block (flat cells) or tin (triangles). Default: joined.",
        _on(RASTER),
    ),
    "receiver": Option(
        Literal["horizontal", "surface"],
        _RASTER_PANEL,
        "Receiving plane in each cell: horizontal, or along the surface. "
        "Default: surface for irradiation and sun-hours, else horizontal.",
        _on(RASTER),
    ),
    "canopy": Option(
        Path, _RASTER_PANEL, "Raster with the heights of tree crowns above the ground, on the same cells.", _on(RASTER)
    ),
    "trunk": Option(
        str,
        _RASTER_PANEL,
        "Height of the undersides of crowns: a fraction of --canopy, or a raster. Default: 0.25.",
        _on(RASTER),
    ),
    "tile": Option(
        int,
        _RASTER_PANEL,
        "Compute in tiles with this number of cells along each side, such as 1024. Default: one tile for the whole raster.",
        _on(RASTER),
    ),
    "margin": Option(
        int,
        _RASTER_PANEL,
        "Width in cells of the full-resolution border around a tile. Default: 256. Needs --tile.",
        _on(RASTER),
    ),
    "far": Option(
        Path, _RASTER_PANEL, "Raster with the heights of the terrain around the source raster, on the same map.", _on(RASTER)
    ),
    "texture": Option(
        str, _TEXTURE_PANEL, "Write a texture of this size in texels, such as 1024 (square) or 1024x512.", _on(TEXTURE)
    ),
    "uv": Option(
        Literal["auto", "0", "1", "new"],
        _TEXTURE_PANEL,
        "Texture coordinates: set 0 or 1 of the file, or new ones. auto: a set that covers every face, else new ones. "
        "Default: auto.",
        _on(TEXTURE),
    ),
    "supersample": Option(
        int,
        _TEXTURE_PANEL,
        "Number of points per texel over which the value is averaged, such as 4. The points share the rays of --samples. "
        "Default: 1.",
        _on(TEXTURE),
    ),
    "normals": Option(
        Literal["face", "smooth", "lifted"],
        _TEXTURE_PANEL,
        "Normals at texels: face, smooth (interpolated), or lifted (smooth, with the points moved to the smooth surface). "
        "Default: face, or for --quantity normals those that viewers use: smooth, but flat for a .glb without NORMAL.",
        _on(TEXTURE),
    ),
    "gutter": Option(
        str,
        _TEXTURE_PANEL,
        "Number of empty texels to fill around each piece of the surface in the image, or all. Default: all.",
        _on(TEXTURE),
    ),
    "strength": Option(
        float, _TEXTURE_PANEL, "Strength of the occlusion in the material, 0 to 1. Default: 1.", _on(TEXTURE, only=_GLTF)
    ),
    "depth": Option(
        Literal["8", "16"],
        _TEXTURE_PANEL,
        "Bits per channel of a .png, also inside a .glb. Default: 8.",
        _on(TEXTURE, only=(*_GLTF, ".png")),
    ),
    "strict": Option(
        bool,
        _TEXTURE_PANEL,
        "Stop with an error for texture coordinates that overlap, leave the image or have no area, for texels too small "
        "for float32, and for --instances mean with a mesh in several places.",
        _on(TEXTURE),
    ),
    "high": Option(
        Path,
        _TEXTURE_PANEL,
        "Finer mesh on which to compute the values for the texels of the first mesh. Needs --cage.",
        _on(TEXTURE),
    ),
    "cage": Option(
        float,
        _TEXTURE_PANEL,
        "Largest distance between the first mesh and the mesh of --high, outside and inside, in units of the mesh.",
        _on(TEXTURE),
    ),
    "inside": Option(
        Literal["fill", "keep"],
        _TEXTURE_PANEL,
        "Value of texels inside closed bodies, such as a floor under a wall: fill copies the nearest visible texel, keep "
        "uses the computed value. Default: fill.",
        _on(TEXTURE),
    ),
    "instances": Option(
        Literal["split", "mean"],
        _TEXTURE_PANEL,
        "Texture of a mesh that the file places several times: split makes a copy for each place that differs by "
        "more than standard errors and the rounding to --depth bits, in a texel, in a block of 8 x 8 texels or in the whole "
        "picture; mean averages all places. Default: split.",
        _on(TEXTURE, only=_GLTF),
    ),
    "chunk": Option(
        int, _STORE_PANEL, "Number of points per task and per file of the store. Default: 65536.", _on(MESH, only=(STORE,))
    ),
    "cluster": Option(
        str, _STORE_PANEL, "Address of a running Dask scheduler, such as tcp://host:8786.", _on(MESH, only=(STORE,))
    ),
    "processes": Option(
        int,
        _STORE_PANEL,
        "Number of processes, each with one thread, such as 2. Default: the threads of one process.",
        _on(MESH, only=(STORE,)) | _on(RASTER),
    ),
    "resume": Option(
        bool,
        _STORE_PANEL,
        "Continue an interrupted run with the same arguments, and compute only the missing parts.",
        _on(MESH, only=(STORE,)) | _on(RASTER),
    ),
    "workers": Option(int, RUN, "Number of threads. Default: the environment variable WARPSAMPLE_WORKERS, or one per core."),
    "device": _of_quantities(str, RUN, "Device that computes, such as cuda:0. Default: the CPU"),
    "report": Option(
        Path,
        RUN,
        "Also write a report to this .html file, with picture, histogram, means by part and arguments.",
        _on(MESH, CITY, RASTER, but=(STORE, ".mtx")),
    ),
}
"""All options of the command, except the source and the output, keyed by name, in the order of the help page."""


def kind_of(source: Path, output: Path, texture: Any) -> str:
    """Return the kind of an input (mesh, city, raster or texture), from the suffixes of the input and the output.

    Args:
        source: Path of the source.
        output: Path of the output.
        texture: Value of `--texture`, or None.
    """
    given, written = source.suffix.lower(), output.suffix.lower()
    known = (*RASTER_SUFFIXES, *_CITY_FILES, *SUFFIXES)
    suffix = written if given not in known else given
    if suffix in RASTER_SUFFIXES:
        return RASTER
    if suffix in _CITY_FILES:
        return CITY
    return MESH if texture is None else TEXTURE


def describe_scope(name: str, source: str | None = None) -> str:
    """Return the inputs to which an option applies as text or, for one kind of input, the output suffixes; "" for all."""
    where = OPTIONS[name].where
    if source is not None:
        return "" if where[source] == FILES[source] else join_words(where[source])
    return "" if len(where) == len(SOURCES) else join_words(where)


def join_words(words: Iterable[str]) -> str:
    """Return words as an enumeration: "a, b and c"."""
    *others, last = words
    return f"{', '.join(others)} and {last}" if others else last
